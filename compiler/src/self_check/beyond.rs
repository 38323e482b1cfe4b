//! The thorough check: what an expansion has no time for at every keystroke, and what definitions ask for beyond the default.

use super::dynamics::{self, stands_still, velocity};
use super::machine::Machine;
use super::quantity::{Along, Quantity, dot};
use super::{Check, Report, beams, rows};
use crate::equations::tangent::Matrix;
use crate::schedule::{Function, Inputs, sources};
use crate::symbolic::{Node, evaluate_reachable};
use std::collections::BTreeMap;

/// Step of differences along velocities of order one.
const STEP: f64 = 1e-3;

pub fn check(machine: &Machine, report: &mut Report) {
    motions(machine, report);
    if stands_still(machine) {
        springs(machine, report);
    }
    beams::kinetic_energy(machine, report);
    beams::gyroscopic_forces(machine, report);
    factorisation(machine, report);
    null_space(machine, report);
    tangent(machine, report);
}

/// Velocities of bodies are the derivatives of their positions and orientations, accelerations those of velocities.
fn motions(machine: &Machine, report: &mut Report) {
    let inputs = report.inputs;
    let along =
        Along::of(STEP, |h| machine.run(Function::Motions, &machine.moved(inputs, h, &inputs.acceleration)));
    let (here, rates) = (&along.at[2], along.derivatives());
    let bodies = machine.compiled.mechanism.bodies.iter();
    for ((body, here), rates) in bodies.zip(machine.motions(here)).zip(machine.motions(&rates)) {
        let name = &body.name.text;
        let [_, orientation, velocity, rate, acceleration, angular_acceleration] = here;
        let [of_position, of_orientation, of_velocity, of_rate, ..]: [&[Quantity]; 6] = rates;
        let pairs = [
            ("the velocity", velocity, of_position),
            ("the turning", &turning(orientation, rate), of_orientation),
            ("the acceleration", acceleration, of_velocity),
            ("the angular acceleration", angular_acceleration, of_rate),
        ];
        for (what, stated, difference) in pairs {
            for (stated, difference) in stated.iter().zip(difference) {
                report.compare(Check::Motions, || format!("{what} of \"{name}\""), *stated, *difference);
            }
        }
    }
}

/// (c, s)˙ = ω (−s, c) in the plane, Ȧ = A ω̃ in space, ω in body axes.
fn turning(orientation: &[Quantity], rate: &[Quantity]) -> Vec<Quantity> {
    match (orientation, rate) {
        ([c, s], [omega]) => vec![-*s * *omega, *c * *omega],
        (axes, [x, y, z]) => axes
            .chunks(3)
            .flat_map(|a| [a[1] * *z - a[2] * *y, a[2] * *x - a[0] * *z, a[0] * *y - a[1] * *x])
            .collect(),
        _ => Vec::new(),
    }
}

/// What a spring takes, the part of its power that is odd in v, is what it stores.
fn springs(machine: &Machine, report: &mut Report) {
    let (compiled, inputs) = (machine.compiled, report.inputs);
    let equations = &compiled.complete.equations;
    let potentials = &equations.contributions.potentials;
    let order = equations.graph.read().reachable(potentials.iter().copied());
    let sources = sources(&compiled.complete);
    let rest = vec![0.0; inputs.v.len()];
    let stored = Along::of(STEP, |h| {
        let moved = machine.moved(inputs, h, &rest);
        let symbols: Vec<f64> = sources.iter().map(|source| moved.get(*source)).collect();
        let mut values = Vec::new();
        evaluate_reachable(&equations.graph.read(), &order, &symbols, &mut values);
        // Squares of sums of a few terms.
        let rounded = |value: f64| Quantity { value, margin: 1e-9 * value.abs().max(1e-9) };
        potentials.iter().map(|node| rounded(values[node.index()])).collect()
    });
    let stored = stored.derivatives();
    let back = Inputs { v: inputs.v.iter().map(|v| -v).collect(), ..inputs.clone() };
    let powers = [inputs, &back].map(|inputs| machine.run(Function::Powers, inputs));
    for (index, load) in compiled.mechanism.loads.iter().enumerate() {
        if load.stores() {
            let taken = (powers[0][index] - powers[1][index]) * 0.5;
            report.compare(Check::Springs, || format!("\"{}\"", load.name.text), taken, -stored[index]);
        }
    }
}

/// M a + Dᵀ λ = forces, D a − c λ = rows.
fn factorisation(machine: &Machine, report: &mut Report) {
    let compiled = machine.compiled;
    if compiled.complete.further.stored.is_none() {
        return;
    }
    let (machine, inputs) = machine.factored(report.inputs);
    let solution = machine.run(Function::Solve, &inputs);
    let right = [&inputs.given_forces, &inputs.given_rows]
        .map(|given| given.iter().map(|value| Quantity::exact(*value)).collect::<Vec<_>>());
    dynamics::residuals(
        &machine,
        report,
        Check::Factorisation,
        &inputs,
        machine.groups(Function::Solve, &solution),
        &right,
        inputs.compliance,
    );
}

/// The equations of motion, and D v = rows with the factors of D.
fn null_space(machine: &Machine, report: &mut Report) {
    let compiled = machine.compiled;
    let Some(written) = &compiled.complete.further.null_space else { return };
    dynamics::solution(machine, report, Function::NullSpace, Check::NullSpace);
    if compiled.complete.further.leads {
        dynamics::solution(machine, report, Function::NullSpaceBaumgarte, Check::NullSpace);
    }
    if !compiled.complete.further.emits_factors {
        return;
    }
    let (machine, inputs) = machine.factored(report.inputs);
    let dependent = machine.run(Function::DependentVelocities, &inputs);
    debug_assert_eq!(dependent.len(), written.dependent.len());
    for (row, columns) in machine.jacobian(&inputs).iter().enumerate() {
        let sum = columns.iter().fold(Quantity::default(), |sum, (k, entry)| sum + *entry * dependent[*k]);
        let right = Quantity::exact(inputs.given_rows[row]);
        if !machine.compiled.complete.equations.idle.contains(&row) {
            report.compare(Check::NullSpace, || rows::name(&machine, row), sum, right);
        }
    }
}

/// Derivatives of r = M a + Dᵀ λ − Q and of D a − γ along one increment, of q and of v.
fn tangent(machine: &Machine, report: &mut Report) {
    let inputs = report.inputs;
    let Some(tangents) = &machine.compiled.complete.tangents else { return };
    // Any direction.
    let direction = &inputs.acceleration;
    let by_position = |f: &dyn Fn(&Inputs) -> Vec<Quantity>| {
        Along::of(STEP, |h| f(&machine.displaced(inputs, h, direction))).derivatives()
    };
    let by_velocity = |f: &dyn Fn(&Inputs) -> Vec<Quantity>| {
        let faster = |h: f64| inputs.v.iter().zip(direction).map(|(v, x)| v + h * x).collect();
        Along::of(STEP, |h| f(&Inputs { v: faster(h), ..inputs.clone() })).derivatives()
    };
    let residual = |at: &Inputs| machine.run(Function::Residual, at);
    let row_residual = |at: &Inputs| {
        let gamma = machine.run(Function::Gamma, at);
        let rows = machine.jacobian(at).into_iter().zip(gamma);
        let sum = |(row, gamma): (Vec<(usize, Quantity)>, Quantity)| {
            row.iter().fold(-gamma, |sum, (k, entry)| sum + *entry * at.acceleration[*k])
        };
        rows.map(sum).collect::<Vec<_>>()
    };
    let entries = machine.run(Function::Tangent, inputs);
    let [stiffness, damping] = machine.groups(Function::Tangent, &entries);
    let entries = machine.run(Function::RowTangent, inputs);
    let [row_stiffness, row_damping] = machine.groups(Function::RowTangent, &entries);
    let of_velocity = |k: usize| velocity(machine, k);
    let of_row = |row: usize| rows::name(machine, row);
    let mut judge = |stated: Vec<Quantity>, expected: Vec<Quantity>, name: &dyn Fn(usize) -> String| {
        for (index, (stated, expected)) in stated.into_iter().zip(expected).enumerate() {
            report.compare(Check::Tangent, || name(index), stated, expected);
        }
    };
    let times = |entries: &[Quantity], matrix: &Matrix| product(entries, matrix, direction);
    judge(times(stiffness, &tangents.stiffness), by_position(&residual), &of_velocity);
    judge(times(damping, &tangents.damping), by_velocity(&residual), &of_velocity);
    judge(times(row_stiffness, &tangents.row_stiffness), by_position(&row_residual), &of_row);
    judge(times(row_damping, &tangents.row_damping), by_velocity(&row_residual), &of_row);
}

/// A sparse matrix by its stored entries, times a vector.
fn product(entries: &[Quantity], matrix: &Matrix, direction: &[f64]) -> Vec<Quantity> {
    let mut entries = entries.iter();
    let row = |row: &BTreeMap<usize, Node>| {
        let (own, x): (Vec<Quantity>, Vec<f64>) =
            row.keys().filter_map(|k| Some((*entries.next()?, direction[*k]))).unzip();
        dot(&own, &x)
    };
    matrix.iter().map(row).collect()
}
