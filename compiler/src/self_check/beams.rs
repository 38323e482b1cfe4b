//! Bodies that deform: what their modal damping takes, and their kinetic energy slice by slice, which knows nothing of shape integrals.

use super::dynamics::{stands_still, velocity};
use super::machine::Machine;
use super::quantity::{Along, Quantity};
use super::{Check, Report};
use crate::beams::Rule;
use crate::equations::{Laws, Linear, plane, space};
use crate::functions::Function;
use crate::modal::{Reduced, cholesky, eigen, reduced_by};
use crate::model::{BodyId, Deforms, Expr, Load, Quantity as Quantity_, Space, value_at};
use crate::schedule::{Inputs, sources};
use crate::symbolic::{Scalar, evaluate_reachable};

/// Step of differences along velocities of order one.
const STEP: f64 = 1e-3;
/// Slices of a beam: products of any two of its shapes are integrated to rounding.
const SLICES: usize = 48;

/// T against ∫ ½ μ |ṙ|².
pub fn kinetic_energy(machine: &Machine, report: &mut Report) {
    if !has_beams(machine) {
        return;
    }
    let inputs = report.inputs;
    let rule = Rule::new(SLICES);
    let sum = match machine.compiled.mechanism.space {
        Space::Planar => value(machine, inputs, |laws| plane::kinetic_energy_of_slices(laws, &rule)),
        Space::Spatial => value(machine, inputs, |laws| space::kinetic_energy_of_slices(laws, &rule)),
    };
    // A sum of squares.
    let expected = Quantity { value: sum, margin: 1e-11 * sum };
    let found = machine.run(Function::KineticEnergy, inputs)[0];
    report.compare(Check::Beams, || "the kinetic energy".to_string(), found, expected);
}

/// What of Q is quadratic in v against Lagrange's equations, d(M v)/dt − ∂T/∂q at v̇ = 0. Modes that ride on one frame exert gyroscopic
/// forces on one another that do no work, so that no balance of energies sees them. Velocities of what turns on a ball are no derivatives of
/// coordinates, for which Lagrange's equations would have further terms; in the coordinates of a tree the same laws stand without.
pub fn gyroscopic_forces(machine: &Machine, report: &mut Report) {
    let mechanism = &machine.compiled.mechanism;
    let holonomic = machine.compiled.complete.equations.layout.quaternions.is_empty();
    if !has_beams(machine)
        || !holonomic
        || !stands_still(machine)
        || mechanism.loads.iter().any(may_be_quadratic)
    {
        return;
    }
    let rest = vec![0.0; report.inputs.v.len()];
    let inputs = &Inputs { acceleration: rest.clone(), ..report.inputs.clone() };
    let inverse = |factor: f64| {
        let v = inputs.v.iter().map(|v| factor * v).collect();
        machine.run(Function::InverseDynamics, &Inputs { v, ..inputs.clone() })
    };
    let [ahead, back, still] = [1.0, -1.0, 0.0].map(inverse);
    let exact: Vec<Quantity> = inputs.v.iter().map(|v| Quantity::exact(*v)).collect();
    let momentum = Along::of(STEP, |h| machine.mass_times(&machine.moved(inputs, h, &rest), &exact));
    for (k, rate) in momentum.derivatives().into_iter().enumerate() {
        let mut way = rest.clone();
        way[k] = 1.0;
        let energy =
            Along::of(STEP, |h| machine.run(Function::KineticEnergy, &machine.displaced(inputs, h, &way)));
        let found = (ahead[k] + back[k]) * 0.5 - still[k];
        report.compare(Check::Beams, || velocity(machine, k), found, rate - energy.derivatives()[0]);
    }
}

/// Whether the law of a load may have squares of velocities.
fn may_be_quadratic(load: &Load) -> bool {
    let mut moves = false;
    load.law
        .iter()
        .for_each(|law| law.quantities(&mut |quantity| moves |= matches!(quantity, Quantity_::Rate(_))));
    moves || load.form.effort.is_some() || !load.states.is_empty()
}

/// What modal damping takes, W: Σ 2 ζ M ω ṗ² with M ω = K/ω, in numbers and not on the graph.
pub fn dissipated(machine: &Machine, inputs: &Inputs) -> Quantity {
    let (mechanism, parameters) = (&machine.compiled.mechanism, &inputs.parameters);
    let mut power = 0.0;
    let layout = &machine.compiled.complete.equations.layout.linear;
    for (index, body) in mechanism.bodies.iter().enumerate() {
        let Some(Deforms::Modal(modal)) = &body.deforms else { continue };
        let first = layout.iter().position(|it| *it == Linear::Mode(BodyId(index), 0)).unwrap_or(0);
        let ratio = value_at(&modal.damping_ratio, parameters).unwrap_or(f64::NAN);
        power += ratio * natural_losses(&modal.reduced, &inputs.v[first..]);
    }
    for (index, linear) in layout.iter().enumerate() {
        let Linear::Mode(body, mode) = linear else { continue };
        let body = &mechanism.bodies[body.0];
        let Some(beam) = body.beam() else { continue };
        let number = |expr: &Expr| value_at(expr, parameters).unwrap_or(f64::NAN);
        let shape = &beam.slender.modes[*mode];
        let stiffness = shape.stiffness * number(beam.rigidity(shape.way));
        let damping =
            2.0 * number(&beam.damping_ratio) * stiffness / beam.rates(&body.mass, parameters)[*mode];
        power += damping * inputs.v[index] * inputs.v[index];
    }
    Quantity { value: power, margin: 1e-11 * power }
}

/// Σ 2 ω η̇² over the natural modes of M = L Lᵀ and K, η = Qᵀ Lᵀ p.
fn natural_losses(reduced: &Reduced, rates: &[f64]) -> f64 {
    let Some(l) = cholesky(&reduced.generalised_mass) else { return f64::NAN };
    let (squares, q) = eigen(&reduced_by(&l, &reduced.stiffness));
    let n = squares.len();
    let scaled = |m: usize| -> f64 { (0..n).map(|i| l[i][m] * rates[i]).sum() };
    let natural = |k: usize| -> f64 { (0..n).map(|m| q[m][k] * scaled(m)).sum() };
    (0..n).map(|k| 2.0 * squares[k].max(0.0).sqrt() * natural(k).powi(2)).sum()
}

fn has_beams(machine: &Machine) -> bool {
    machine.compiled.mechanism.bodies.iter().any(|body| body.deforms.is_some())
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
