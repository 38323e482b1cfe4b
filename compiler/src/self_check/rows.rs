//! Constraint rows: D is the derivative of Φ, γ that of D v − ν with the other sign.

use super::machine::{self, Machine};
use super::quantity::{Along, Quantity};
use super::{Check, Report};
use crate::schedule::{Function, Inputs};

/// Step of differences, s along velocities of order one.
const STEP: f64 = 1e-3;

/// What an assembled start may be off by, in sizes of the mechanism.
const CLOSED: f64 = 1e-7;

/// Φ = 0 where the mechanism was assembled, by other expressions if these are absolute coordinates.
pub fn at_the_start(machine: &Machine, report: &mut Report) {
    let closed = Quantity { value: 0.0, margin: CLOSED * (1.0 + machine::size(machine.compiled)) };
    for (row, phi) in machine.run(Function::Constraints, report.inputs).into_iter().enumerate() {
        report.compare(Check::Start, || name(machine, row), phi, closed);
    }
}

pub fn check(machine: &Machine, report: &mut Report) {
    let rows = &machine.compiled.complete.equations.rows;
    if rows.is_empty() {
        return;
    }
    let inputs = report.inputs;
    let rest = vec![0.0; inputs.v.len()];
    let states = |f: &dyn Fn(&Inputs) -> Vec<Quantity>| {
        Along::of(STEP, |h| f(&machine.moved(inputs, h, &rest))).derivatives()
    };
    let of_phi = states(&|at| machine.run(Function::Constraints, at));
    let rates = rates(machine, inputs);
    let before = report.found.len();
    for (row, (rate, difference)) in rates.iter().zip(&of_phi).enumerate() {
        let at = || column_of(machine, inputs, row);
        report.compare(Check::Jacobian, at, *rate, *difference);
    }
    if report.found.len() > before {
        // γ would be compared with rates that are wrong.
        return;
    }
    let of_rates = states(&|at| self::rates(machine, at));
    let gamma = machine.run(Function::Gamma, inputs);
    for (row, (gamma, difference)) in gamma.iter().zip(&of_rates).enumerate() {
        report.compare(Check::Gamma, || name(machine, row), *gamma, -*difference);
    }
}

/// D v − ν.
pub fn rates(machine: &Machine, inputs: &Inputs) -> Vec<Quantity> {
    let nu = machine.run(Function::Nu, inputs);
    let rows = machine.jacobian(inputs).into_iter().zip(nu);
    rows.map(|(row, nu)| row.iter().fold(-nu, |sum, (column, entry)| sum + *entry * inputs.v[*column]))
        .collect()
}

/// The row's name, as its joint and what it holds.
pub fn name(machine: &Machine, row: usize) -> String {
    let row = &machine.compiled.complete.equations.rows[row];
    format!("row `{}` of \"{}\"", row.form.name, row.of)
}

/// The row's name, and the velocity whose entry of D is wrong, if it is one of D.
fn column_of(machine: &Machine, inputs: &Inputs, row: usize) -> String {
    let n = inputs.v.len();
    let along = |v: Vec<f64>| {
        let inputs = Inputs { v, ..inputs.clone() };
        let rest = vec![0.0; n];
        let phi = |h: f64| machine.run(Function::Constraints, &machine.moved(&inputs, h, &rest));
        Along::of(STEP, phi).derivatives()[row]
    };
    let (standing, entries) = (along(vec![0.0; n]), &machine.jacobian(inputs)[row]);
    let names = machine.compiled.complete.equations.layout.velocity_names(&machine.compiled.mechanism);
    for (column, name_of_velocity) in names.iter().enumerate() {
        let unit = (0..n).map(|k| if k == column { 1.0 } else { 0.0 }).collect();
        let difference = along(unit) - standing;
        let stored = entries.iter().find(|(known, _)| *known == column).map(|(_, entry)| *entry);
        if stored.unwrap_or_default().contradicts(difference) {
            return format!("{} along {name_of_velocity}", name(machine, row));
        }
    }
    name(machine, row)
}
