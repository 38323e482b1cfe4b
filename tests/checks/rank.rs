//! Rank along the motion: what the runtime reports of singular positions, against eigenvalues computed apart.
//!
//! A = D M⁻¹ Dᵀ with each row divided by its largest M⁻¹-norm over the cycle. The estimate must lie within a factor of
//! [`FACTOR`] of λ_min(A)/max(1, λ_max(A)): the one in the divisor, because of a single row the least eigenvalue is the largest, and yet
//! it is singular where it vanishes.

use crate::registry::{Model, for_each, vector};
use linkwright::{State, Vector, project_position, project_velocity, reciprocal_condition, retract};

/// How far the estimate may be off.
const FACTOR: f64 = 30.0;

/// Reported as nearly singular below this.
const LIMIT: f64 = 1e-6;

for_each!(rank_along_the_motion);

fn rank_along_the_motion<M: Model>() {
    let model = M::standard();
    if model.row_count() == 0 {
        return;
    }
    let model = M::standard();
    let cycle = cycle(&model);
    let off = compare(&model, &cycle);
    println!(
        "{}: {} positions, estimate / exact {:.2} to {:.2}, down to {:.1e}",
        model.name(),
        cycle.len(),
        off.least,
        off.most,
        off.smallest
    );
    assert!(off.least > 1.0 / FACTOR && off.most < FACTOR, "{}: {} to {}", model.name(), off.least, off.most);
}

/// Estimates over exact values.
pub struct Off {
    pub least: f64,
    pub most: f64,
    /// The smallest exact value.
    pub smallest: f64,
}

/// What is found at one position.
struct Found {
    time: f64,
    gram: Matrix,
    /// The estimate.
    condition: f64,
    /// The least of `factor`.
    pivot: f64,
}

/// Compares at all positions; below the limit both must be.
pub fn compare<M: Model>(model: &M, positions: &[(f64, M::Q)]) -> Off {
    let mut found = Vec::new();
    for (time, q) in positions {
        let condition = reciprocal_condition(model, *time, q);
        let pivot = model.factor(*time, q, 0.0, &mut model.store());
        found.push(Found { time: *time, gram: gram(model, *time, q), condition, pivot });
    }
    compare_all(model.name(), model.row_count(), model.idle(), &found)
}

fn compare_all(name: &str, rows: usize, idle: &[u16], positions: &[Found]) -> Off {
    let live: Vec<usize> = (0..rows).filter(|row| !idle.contains(&(*row as u16))).collect();
    let sizes: Vec<f64> =
        live.iter().map(|i| positions.iter().map(|at| at.gram[*i][*i]).fold(0.0, f64::max).sqrt()).collect();
    let mut off = Off { least: f64::INFINITY, most: 0.0, smallest: 1.0 };
    for Found { time, gram, condition, pivot } in positions {
        let row = |(i, own): (&usize, &f64)| {
            live.iter().zip(&sizes).map(|(j, other)| gram[*i][*j] / (own * other)).collect::<Vec<f64>>()
        };
        let (least, most) = extreme_eigenvalues(live.iter().zip(&sizes).map(row).collect());
        let exact = least / most.max(1.0);
        // A step asks for the condition where a pivot is below 3·10⁻³: no position that is nearly singular may be missed by that.
        assert!(*pivot < 3e-3 || exact > LIMIT, "{name} at {time} s: pivot {pivot:e}, exactly {exact:e}");
        off.smallest = off.smallest.min(exact);
        // What is left of an eigenvalue below this is rounding.
        if exact < 1e-11 {
            assert!(*condition < LIMIT, "{name} at {time} s: {condition:e}, exactly {exact:e}");
            continue;
        }
        (off.least, off.most) = (off.least.min(condition / exact), off.most.max(condition / exact));
    }
    off
}

type Matrix = Vec<Vec<f64>>;

/// D M⁻¹ Dᵀ by dense matrices; M + ρ Dᵀ D of the rows that hold massless velocities where there are any.
fn gram<M: Model>(model: &M, time: f64, q: &M::Q) -> Matrix {
    let (n, m) = (model.velocity_count(), model.row_count());
    let (mut mass, mut jacobian) = (model.zero_mass(), model.zero_jacobian());
    model.mass_matrix(time, q, &mut mass);
    model.constraint_jacobian(time, q, &mut jacobian);
    let d = dense((m, n), model.jacobian_pattern(), jacobian.as_slice());
    let mut a = dense((n, n), model.mass_pattern(), mass.as_slice());
    mirror(&mut a, model.mass_pattern());
    gram_of(a, d, model.massless_rows(), model.massless_weights())
}

/// Of that many rows and columns, zero but for the entries that are stored.
fn dense((rows, columns): (usize, usize), pattern: &[(u16, u16)], values: &[f64]) -> Matrix {
    let mut matrix = vec![vec![0.0; columns]; rows];
    for (&(row, column), entry) in pattern.iter().zip(values) {
        matrix[usize::from(row)][usize::from(column)] = *entry;
    }
    matrix
}

/// Of a symmetric matrix one triangle is stored.
fn mirror(matrix: &mut Matrix, pattern: &[(u16, u16)]) {
    for &(row, column) in pattern {
        matrix[usize::from(column)][usize::from(row)] = matrix[usize::from(row)][usize::from(column)];
    }
}

/// D A⁻¹ Dᵀ, with A = M + ρ dᵀ d over the massless rows d of D.
fn gram_of(mut a: Matrix, d: Matrix, massless: &[u16], weights: &[f64]) -> Matrix {
    for (&row, rho) in massless.iter().zip(weights) {
        let d = &d[usize::from(row)];
        for (i, entries) in a.iter_mut().enumerate() {
            entries.iter_mut().zip(d).for_each(|(entry, x)| *entry += rho * d[i] * x);
        }
    }
    let l = cholesky(&a);
    let y: Matrix = d.iter().map(|row| substitute(&l, row)).collect();
    let inner = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    y.iter().map(|a| y.iter().map(|b| inner(a, b)).collect()).collect()
}

/// A = L Lᵀ.
fn cholesky(a: &Matrix) -> Matrix {
    let n = a.len();
    let mut l = vec![vec![0.0; n]; n];
    for i in 0..n {
        for j in 0..=i {
            let rest = a[i][j] - (0..j).map(|k| l[i][k] * l[j][k]).sum::<f64>();
            l[i][j] = if i == j { rest.sqrt() } else { rest / l[j][j] };
        }
        assert!(l[i][i] > 0.0, "M is positive definite");
    }
    l
}

/// L⁻¹ x.
fn substitute(l: &Matrix, x: &[f64]) -> Vec<f64> {
    let mut y: Vec<f64> = Vec::new();
    for (row, x) in l.iter().zip(x) {
        let rest = x - row.iter().zip(&y).map(|(l, y)| l * y).sum::<f64>();
        y.push(rest / row[y.len()]);
    }
    y
}

/// The smallest and largest eigenvalue of a symmetric matrix, by Jacobi's rotations.
fn extreme_eigenvalues(mut a: Matrix) -> (f64, f64) {
    let n = a.len();
    for _ in 0..30 {
        let mut off = 0.0;
        for p in 0..n {
            for q in p + 1..n {
                off += a[p][q] * a[p][q];
                if a[p][q].abs() < 1e-300 {
                    continue;
                }
                let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
                let t = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
                let t = if theta == 0.0 { 1.0 } else { t };
                let c = 1.0 / (t * t + 1.0).sqrt();
                let s = t * c;
                for row in a.iter_mut() {
                    (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
                }
                let (above, below) = a.split_at_mut(q);
                for (x, y) in above[p].iter_mut().zip(below[0].iter_mut()) {
                    (*x, *y) = (c * *x - s * *y, s * *x + c * *y);
                }
            }
        }
        if off < 1e-28 {
            break;
        }
    }
    let diagonal = (0..n).map(|i| a[i][i]);
    (diagonal.clone().fold(f64::INFINITY, f64::min), diagonal.fold(0.0, f64::max))
}

/// A cycle of a mechanism with one degree of freedom, a long way of one with more: along a velocity that keeps its direction, as far
/// as positions are found, from both sides of the start.
pub fn cycle<M: Model>(model: &M) -> Vec<(f64, M::Q)> {
    let rows = model.row_count();
    let (count, stride) = if rows > 40 { (12, 0.12) } else { (140, 0.05) };
    let mut found = Vec::new();
    for side in [1.0, -1.0] {
        let (mut time, mut state) = (0.0, State::new(model.start_q(), model.zero_v()));
        let mut wish: Vec<f64> =
            (0..model.velocity_count()).map(|k| side * (1.3 * k as f64 + 0.7).cos()).collect();
        for number in 0..count {
            let Ok(v) = project_velocity(model, time, &state.q, &vector::<M::V>(&wish)) else { break };
            let largest = v.max_abs();
            if largest < 1e-9 {
                break;
            }
            found.push((time, state.q));
            let h = stride / largest;
            let mut ahead = state.q;
            retract(model.layout(), &state.q, &v.scaled(h), &mut ahead);
            time += h;
            let Ok(q) = project_position(model, time, &ahead) else { break };
            state.q = q;
            wish = v.scaled(1.0 / largest).as_slice().to_vec();
            wish.iter_mut()
                .enumerate()
                .for_each(|(k, x)| *x += 0.03 * (0.9 * (number * (k + 1)) as f64).sin());
        }
    }
    found
}
