//! Beams: what their modal damping takes, and their kinetic energy slice by slice, which knows nothing of shape integrals.

use super::machine::Machine;
use super::quantity::Quantity;
use super::{Check, Report};
use crate::beams::Rule;
use crate::equations::{Laws, plane};
use crate::functions::Function;
use crate::schedule::{Inputs, sources};
use crate::symbolic::{Scalar, evaluate_reachable};

/// Slices of a beam: products of any two of its shapes are integrated to rounding.
const SLICES: usize = 48;

/// T against ∫ ½ μ |ṙ|².
pub fn kinetic_energy(machine: &Machine, report: &mut Report) {
    if !has_beams(machine) {
        return;
    }
    let inputs = report.inputs;
    let sum = value(machine, inputs, |laws| plane::kinetic_energy_of_slices(laws, &Rule::new(SLICES)));
    // A sum of squares.
    let expected = Quantity { value: sum, margin: 1e-11 * sum };
    let found = machine.run(Function::KineticEnergy, inputs)[0];
    report.compare(Check::Beams, || "the kinetic energy".to_string(), found, expected);
}

/// What modal damping takes, W.
pub fn dissipated(machine: &Machine, inputs: &Inputs) -> Quantity {
    if !has_beams(machine) {
        return Quantity::default();
    }
    let value = value(machine, inputs, |laws| plane::dissipated(laws));
    Quantity { value, margin: 1e-11 * value }
}

fn has_beams(machine: &Machine) -> bool {
    machine.compiled.mechanism.bodies.iter().any(|body| body.beam.is_some())
}

fn value(machine: &Machine, inputs: &Inputs, of: impl for<'g> Fn(&Laws<'g>) -> Scalar<'g>) -> f64 {
    let complete = &machine.compiled.complete;
    let node = complete.equations.built(&machine.compiled.mechanism, of);
    let order = complete.equations.graph.read().reachable([node]);
    let symbols: Vec<f64> = sources(complete).iter().map(|source| inputs.get(*source)).collect();
    let mut values = Vec::new();
    evaluate_reachable(&complete.equations.graph.read(), &order, &symbols, &mut values);
    values[node.index()]
}
