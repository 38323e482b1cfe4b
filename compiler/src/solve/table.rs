//! The factorisation as a table, for the cold paths: assembly, kinematics, projection, the search for a lost rank.
//!
//! K = [W D̂ᵀ; D̂ 0] with D̂ = constraint rows, then condition rows. The table holds the elimination order and the rows of
//! L in that order; the numbers are filled in by a short loop, here at expansion and in the runtime on the target.

use crate::order::{Pattern, Strategy, order};

/// Elimination order and structure of L.
#[derive(Clone, Debug, Default)]
pub struct Table {
    /// Unknown eliminated k-th.
    pub order: Vec<usize>,
    /// Inverse of `order`.
    pub position: Vec<usize>,
    /// Columns of row k: `columns[row_start[k]..row_start[k + 1]]`, ascending, below k.
    pub row_start: Vec<usize>,
    pub columns: Vec<usize>,
}

impl Table {
    /// `entries` are pairs of unknowns: velocities, then rows, then conditions.
    pub fn new(velocities: usize, rows: usize, entries: impl IntoIterator<Item = (usize, usize)>) -> Self {
        let pattern = Pattern::new(velocities, rows, entries);
        let sequence = order(&pattern, Strategy::MinimumDegree).sequence;
        Table::with_order(&pattern, sequence)
    }

    pub fn with_order(pattern: &Pattern, sequence: Vec<usize>) -> Self {
        let n = sequence.len();
        let mut position = vec![0; n];
        for (at, unknown) in sequence.iter().enumerate() {
            position[*unknown] = at;
        }
        let mut rows: Vec<Vec<usize>> = vec![Vec::new(); n];
        let mut pattern = pattern.clone();
        for (k, pivot) in sequence.iter().enumerate() {
            for a in pattern.eliminate(*pivot) {
                rows[position[a]].push(k);
            }
        }
        let mut table = Table { order: sequence, position, row_start: vec![0], columns: Vec::new() };
        for row in rows {
            table.columns.extend(row);
            table.row_start.push(table.columns.len());
        }
        table
    }

    pub fn row(&self, k: usize) -> &[usize] {
        &self.columns[self.row_start[k]..self.row_start[k + 1]]
    }
}

/// K = L D Lᵀ in numbers.
#[derive(Clone, Debug)]
pub struct Numeric<'a> {
    table: &'a Table,
    lower: Vec<f64>,
    diagonal: Vec<f64>,
    /// The next of each in the elimination's tree: the first row of L that has it.
    next: Vec<Option<usize>>,
    /// d, by unknown.
    pub pivots: Vec<f64>,
    /// |d| / Σ |terms of d|, by unknown.
    pub relative_pivots: Vec<f64>,
}

/// Relative pivots below this are taken as zero: a dependent row leaves rounding, about 1e-16; a row at an angle φ
/// to the others leaves φ².
pub const DEPENDENT: f64 = 1e-11;

impl<'a> Numeric<'a> {
    /// Factors the matrix given by its entries (any triangle, duplicates added). Zero pivots are skipped: the unknown
    /// gets the value 0, which drops a dependent row.
    pub fn factor(table: &'a Table, entries: impl IntoIterator<Item = (usize, usize, f64)>) -> Self {
        let n = table.order.len();
        let mut lower = vec![0.0; table.columns.len()];
        let mut diagonal = vec![0.0; n];
        let mut pivots = vec![0.0; n];
        let mut relative_pivots = vec![1.0; n];
        for (a, b, value) in entries {
            let (i, j) = (table.position[a].max(table.position[b]), table.position[a].min(table.position[b]));
            if i == j {
                diagonal[i] += value;
            } else if let Ok(at) = table.row(i).binary_search(&j) {
                lower[table.row_start[i] + at] += value;
            }
        }
        let mut work = vec![0.0; n];
        let mut next = vec![None; n];
        for k in 0..n {
            let start = table.row_start[k];
            let row = table.row(k);
            row.iter().for_each(|j| _ = next[*j].get_or_insert(k));
            for (at, j) in row.iter().enumerate() {
                work[*j] = lower[start + at];
            }
            let mut pivot = diagonal[k];
            let mut magnitude = pivot.abs();
            for (at, j) in row.iter().enumerate() {
                let inner = table.row_start[*j];
                let mut sum = work[*j];
                for (at, i) in table.row(*j).iter().enumerate() {
                    sum -= lower[inner + at] * work[*i];
                }
                work[*j] = sum;
                let l = if diagonal[*j] == 0.0 { 0.0 } else { sum / diagonal[*j] };
                lower[start + at] = l;
                pivot -= l * sum;
                magnitude += (l * sum).abs();
            }
            for j in row {
                work[*j] = 0.0;
            }
            let relative = if magnitude > 0.0 { pivot.abs() / magnitude } else { 0.0 };
            pivots[table.order[k]] = pivot;
            relative_pivots[table.order[k]] = relative;
            diagonal[k] = if relative < DEPENDENT { 0.0 } else { pivot };
        }
        Numeric { table, lower, diagonal, next, pivots, relative_pivots }
    }

    /// xᵀ K⁻¹ x, of the entries of x that are not zero.
    pub fn inverse_square(&self, x: impl IntoIterator<Item = (usize, f64)>) -> f64 {
        let table = self.table;
        let mut y = vec![0.0; table.order.len()];
        // What these reach in the tree; all else of y is zero.
        let (mut reached, mut known) = (Vec::new(), vec![false; y.len()]);
        for (unknown, value) in x {
            y[table.position[unknown]] = value;
            let mut at = Some(table.position[unknown]);
            while let Some(k) = at.filter(|k| !known[*k]) {
                known[k] = true;
                reached.push(k);
                at = self.next[k];
            }
        }
        reached.sort_unstable();
        let mut sum = 0.0;
        for k in reached {
            for (at, j) in table.row(k).iter().enumerate() {
                y[k] -= self.lower[table.row_start[k] + at] * y[*j];
            }
            if self.diagonal[k] != 0.0 {
                sum += y[k] * y[k] / self.diagonal[k];
            }
        }
        sum
    }

    pub fn solve(&self, rhs: &[f64]) -> Vec<f64> {
        let table = self.table;
        let n = table.order.len();
        let mut x: Vec<f64> = table.order.iter().map(|unknown| rhs[*unknown]).collect();
        for k in 0..n {
            for (at, j) in table.row(k).iter().enumerate() {
                x[k] -= self.lower[table.row_start[k] + at] * x[*j];
            }
        }
        for (x, diagonal) in x.iter_mut().zip(&self.diagonal) {
            *x = if *diagonal == 0.0 { 0.0 } else { *x / diagonal };
        }
        for k in (0..n).rev() {
            for (at, j) in table.row(k).iter().enumerate() {
                x[*j] -= self.lower[table.row_start[k] + at] * x[k];
            }
        }
        let mut solution = vec![0.0; n];
        for (k, unknown) in table.order.iter().enumerate() {
            solution[*unknown] = x[k];
        }
        solution
    }
}

#[cfg(test)]
mod tests {
    use super::{Numeric, Table};

    /// Two trees of unknowns, and right-hand sides that reach a part of them.
    #[test]
    fn a_square_is_the_product_with_the_solution() {
        let parents = [1, 4, 4, 4, 6, 6, 9, 8, 9];
        let links: Vec<(usize, usize)> = parents.into_iter().enumerate().collect();
        let table = Table::new(10, 0, links.iter().copied());
        let diagonal = (0..10).map(|k| (k, k, 4.0 + k as f64));
        let entries = links.iter().map(|(a, b)| (*a, *b, 0.3 + 0.1 * *a as f64));
        let factor = Numeric::factor(&table, diagonal.chain(entries));
        let sides: [&[(usize, f64)]; 5] =
            [&[], &[(7, 2.0)], &[(0, 1.0), (3, -2.0)], &[(9, 0.5)], &[(2, 1.0), (5, 3.0), (8, -1.0)]];
        for side in sides {
            let mut full = vec![0.0; 10];
            side.iter().for_each(|(at, value)| full[*at] = *value);
            let expected: f64 = full.iter().zip(factor.solve(&full)).map(|(x, y)| x * y).sum();
            let found = factor.inverse_square(side.iter().copied());
            assert!((found - expected).abs() <= 1e-15 * (1.0 + expected), "{side:?}: {found}, {expected}");
        }
    }
}
