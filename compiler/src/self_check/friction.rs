//! Friction that follows from reactions, where other checks have to know of it: M v̇ + Dᵀ λ = Q + Q_f(v̇, λ); and that it takes energy out.

use super::machine::Machine;
use super::quantity::{Quantity, dot};
use super::{Check, Report};
use crate::functions::{Function, solution};
use crate::model::{Expr, Load};
use crate::schedule::{Inputs, sources};
use crate::symbolic::{Node, evaluate_reachable};

/// How often what the iteration leaves open is allowed for.
const SAFETY: f64 = 4.0;

/// What the passes must at least gain where sizes depend little on each other: a Newton's method that is none does not.
const GAIN: f64 = 0.02;

/// Dependence up to this part counts as little.
const LITTLE: f64 = 0.3;

fn values(of: &[Quantity]) -> Vec<f64> {
    of.iter().map(|quantity| quantity.value).collect()
}

fn is_none(machine: &Machine) -> bool {
    machine.compiled.complete.equations.friction.is_none()
}

/// Q_f at these inputs, v̇ and λ among them.
fn forces(machine: &Machine, inputs: &Inputs) -> Vec<Quantity> {
    machine.run(Function::FrictionForces, inputs)
}

/// The power of each friction, with reactions as they are, is not positive.
pub fn check(machine: &Machine, report: &mut Report) {
    if machine.compiled.mechanism.loads.iter().all(|load| !load.form.rubs) {
        return;
    }
    let powers = machine.run(Function::Powers, &pushing(machine, report.inputs));
    let loads = machine.compiled.mechanism.loads.iter().zip(powers);
    // What has states of its own gives back what it stored; that of dry friction is what the run finds; what is given from outside may be
    // drawn below zero.
    let given = |load: &Load| load.arguments().any(|(_, values)| values.iter().any(Expr::is_given));
    let takes = |load: &Load| load.form.rubs && load.form.owns.is_none() && !load.form.holds && !given(load);
    for (load, power) in loads.filter(|(load, _)| takes(load)) {
        let gained = Quantity { value: power.value.max(0.0), ..power };
        report.compare(Check::Friction, || format!("\"{}\"", load.name.text), gained, Quantity::exact(0.0));
    }
}

/// The gates that are held closed where the law of their contact pushes: what pulls is let go, and would press surfaces apart.
fn pushing(machine: &Machine, inputs: &Inputs) -> Inputs {
    if inputs.gates.is_empty() {
        return inputs.clone();
    }
    let guards = machine.plain(Function::Guards, inputs);
    let [_gaps, forces] = machine.groups(Function::Guards, &guards);
    Inputs { gates: forces.iter().map(|force| f64::from(u8::from(*force > 0.0))).collect(), ..inputs.clone() }
}

/// + Q_f.
pub fn add(machine: &Machine, inputs: &Inputs, to: &mut [Quantity]) {
    if !is_none(machine) {
        let friction = forces(machine, inputs);
        to.iter_mut().zip(friction).for_each(|(to, force)| *to = *to + force);
    }
}

/// Powers are those with the reactions that there are; inverse dynamics has friction by the given v̇, or, where there are rows, none.
pub fn power_beside(machine: &Machine, inputs: &Inputs) -> Quantity {
    if is_none(machine) {
        return Quantity::exact(0.0);
    }
    let solved = machine.run(Function::Acceleration, inputs);
    let [acceleration, lambda, _pivot] = machine.groups(Function::Acceleration, &solved);
    let there = Inputs { acceleration: values(acceleration), lambda: values(lambda), ..inputs.clone() };
    let own = dot(&forces(machine, &there), &inputs.v);
    if machine.compiled.complete.equations.rows.is_empty() {
        return dot(&forces(machine, inputs), &inputs.v) - own;
    }
    -own
}

/// + Q_f of a solution, within what its iteration leaves open.
pub fn rub(
    machine: &Machine,
    inputs: &Inputs,
    function: Function,
    [acceleration, lambda]: [&[Quantity]; 2],
    to: &mut [Quantity],
) {
    let complete = &machine.compiled.complete;
    let equations = &complete.equations;
    let (false, Some((written, _))) = (is_none(machine), solution(complete, function)) else { return };
    let there = Inputs { acceleration: values(acceleration), lambda: values(lambda), ..inputs.clone() };
    for (to, force) in to.iter_mut().zip(forces(machine, &there)) {
        *to = *to + force;
    }
    let entries = equations.friction.columns.iter().flat_map(|column| column.values().copied());
    let nodes: Vec<Node> = written.left.iter().flatten().copied().chain(entries).collect();
    let order = equations.graph.read().reachable(nodes.iter().copied());
    let symbols: Vec<f64> = sources(complete).iter().map(|source| inputs.get(*source)).collect();
    let mut found = Vec::new();
    evaluate_reachable(&equations.graph.read(), &order, &symbols, &mut found);
    let value = |node: &Node| found[node.index()].abs();
    let left: Vec<[f64; 3]> =
        written.left.iter().map(|left| [0, 1, 2].map(|which| value(&left[which]))).collect();
    let depends_little = left.iter().all(|[size, first, _]| first < &(LITTLE * size));
    let most = left.iter().fold(0.0, |most: f64, [_, first, _]| most.max(*first));
    for (column, [_, _, last]) in equations.friction.columns.iter().zip(left) {
        let allowed = if depends_little { last.min(GAIN * most) } else { last };
        for (velocity, entry) in column {
            to[*velocity].margin += SAFETY * allowed * value(entry);
        }
    }
}
