//! What rows are measured by, against the rows themselves along the motion: part of the thorough check.
//!
//! No identity of mechanics speaks of these sizes. They are computed once more here from what the programs give for M and D, by a dense
//! factorisation, and not from the graph.

use super::machine::Machine;
use super::quantity::Quantity;
use super::{Check, Report, rows};
use crate::schedule::{Function, Inputs};

/// A size is the power of two nearest to twice the largest square: off by a factor of √2 at most.
const ROUNDED: f64 = std::f64::consts::SQRT_2 - 1.0;
/// Squares of rounded numbers, from ill-conditioned mass matrices.
const DIGITS: f64 = 1e-3;

/// Sᵢ = 2 max Dᵢ W⁻¹ Dᵢᵀ along the motion, W = M + ρ Dᵀ D of the rows that hold massless bodies; at the default parameters.
pub fn check(machine: &Machine, report: &mut Report) {
    let compiled = machine.compiled;
    let mut largest = vec![0.0_f64; compiled.complete.equations.rows.len()];
    for q in &compiled.assembly.along {
        let at = Inputs { q: q.clone(), ..report.inputs.clone() };
        let rows = plain_rows(machine, &at);
        let factor = cholesky(inertia(machine, &at, &rows));
        for (largest, row) in largest.iter_mut().zip(&rows) {
            let square = inverse_square(&factor, row);
            if square.is_finite() {
                *largest = largest.max(square);
            }
        }
    }
    let scales = machine.run(Function::RowScales, report.inputs);
    for (row, (scale, largest)) in scales.into_iter().zip(largest).enumerate() {
        if largest > 0.0 && !compiled.complete.equations.idle.contains(&row) {
            let expected = 2.0 * largest;
            let expected = Quantity { value: expected, margin: (ROUNDED + DIGITS) * expected };
            report.compare(Check::Scales, || rows::name(machine, row), scale, expected);
        }
    }
}

/// D, full.
fn plain_rows(machine: &Machine, at: &Inputs) -> Vec<Vec<f64>> {
    let full = |row: Vec<(usize, Quantity)>| {
        let mut full = vec![0.0; at.v.len()];
        row.into_iter().for_each(|(column, entry)| full[column] = entry.value);
        full
    };
    machine.jacobian(at).into_iter().map(full).collect()
}

/// W, its lower triangle.
fn inertia(machine: &Machine, at: &Inputs, rows: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let compiled = machine.compiled;
    let mut w = vec![vec![0.0; at.v.len()]; at.v.len()];
    let entries = machine.plain(Function::MassMatrix, at);
    for ((i, j), entry) in compiled.complete.equations.mass.keys().zip(entries) {
        w[*i.max(j)][*i.min(j)] = entry;
    }
    for (row, rho) in &compiled.complete.solved.massless.rows {
        let d = &rows[*row];
        for (i, own) in w.iter_mut().enumerate() {
            own.iter_mut().zip(d).take(i + 1).for_each(|(entry, other)| *entry += rho * d[i] * other);
        }
    }
    w
}

/// L of L Lᵀ (Golub, Van Loan, *Matrix Computations*, 4.2); not a number where the matrix is not positive.
fn cholesky(mut a: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    for i in 0..a.len() {
        for j in 0..=i {
            let known: f64 = a[i][..j].iter().zip(&a[j][..j]).map(|(x, y)| x * y).sum();
            let entry = a[i][j] - known;
            a[i][j] = if i == j { entry.sqrt() } else { entry / a[j][j] };
        }
    }
    a
}

/// d W⁻¹ dᵀ = |L⁻¹ d|².
fn inverse_square(factor: &[Vec<f64>], d: &[f64]) -> f64 {
    let mut y: Vec<f64> = Vec::new();
    for (own, d) in factor.iter().zip(d) {
        let known: f64 = own.iter().zip(&y).map(|(l, y)| l * y).sum();
        y.push((d - known) / own[y.len()]);
    }
    y.iter().map(|y| y * y).sum()
}
