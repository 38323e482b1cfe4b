//! D = L U by blocks, written into the graph, for the dependent velocities chosen at the start.
//!
//! U has unit blocks on its diagonal (Crout), so that a right-hand side costs one product for each entry of L and of U and a small
//! square for each block.

use super::symmetric::Sparse;
use super::{Partition, Pivot};
use crate::symbolic::{Node, Op, Scalar, Sheet};
use std::collections::BTreeSet;

/// D = L U by blocks.
pub struct Lu<'g> {
    steps: Vec<Step<'g>>,
    pub is_dependent: Vec<bool>,
    /// The square of the smallest pivot, relative to the sizes of its rows, each determinant's to a power of two.
    pub pivot: Scalar<'g>,
}

/// A pivot: one entry of D, or the square block of two or three rows and their velocities, with its inverse. Entries of such a
/// block vanish one by one where the mechanism is regular, as a rod turns past an axis; its determinant does not.
struct Step<'g> {
    rows: Vec<usize>,
    velocities: Vec<usize>,
    /// The inverse of the block: `inverse[velocity][row]`.
    inverse: Vec<Vec<Scalar<'g>>>,
    /// Columns of U beside the unit block.
    upper: Vec<(usize, Vec<Scalar<'g>>)>,
    /// Rows of L below the block.
    lower: Vec<(usize, Vec<Scalar<'g>>)>,
}

/// Factors D (m × n_v, by its rows) in the order of the partition: for each block of pivots P with the columns U and the rows A
/// beside it, U ← P⁻¹ U and D ← D − A U. Rows that the partition leaves out (kept though redundant) take no part.
pub fn factor<'g>(
    g: Sheet<'g>,
    mut rows: Vec<Sparse<'g>>,
    velocities: usize,
    partition: &Partition,
) -> Lu<'g> {
    let mut is_dependent = vec![false; velocities];
    let mut left: Vec<usize> = partition.pivots().map(|pivot| pivot.row).collect();
    let (mut steps, mut watched) = (Vec::new(), Vec::new());
    for block in &partition.blocks {
        let mut block = block.clone();
        while !block.is_empty() {
            let taken = next(&mut block, &rows);
            left.retain(|other| taken.iter().all(|pivot| pivot.row != *other));
            taken.iter().for_each(|pivot| is_dependent[pivot.velocity] = true);
            let step = eliminate(g, &mut rows, &left, &taken, partition, &mut watched);
            steps.push(step);
        }
    }
    Lu { steps, is_dependent, pivot: smallest(g, &watched) }
}

/// A determinant, its reciprocal and its size along the motion, to a power of two.
type Watched<'g> = (Scalar<'g>, Scalar<'g>, f64);

/// So many determinants are watched themselves; of more their reciprocals, which are alive until the end anyway.
const FEW: usize = 3;

/// The square of the smallest determinant relative to its size; one if there is none.
fn smallest<'g>(g: Sheet<'g>, watched: &[Watched<'g>]) -> Scalar<'g> {
    if watched.len() <= FEW {
        let squares = watched.iter().map(|(determinant, _, size)| (*determinant * size.recip()).square());
        return squares.reduce(|least, square| square.min(least)).unwrap_or_else(|| g.one());
    }
    let squares = watched.iter().map(|(_, inverse, size)| (*size * *inverse).square());
    squares.reduce(|most, square| most.max(square)).unwrap_or_else(|| g.one()).reciprocal()
}

/// The next pivots of a block: an entry that is alone in its row or column of the block, a factor of the determinant;
/// else all.
fn next(block: &mut Vec<Pivot>, rows: &[Sparse]) -> Vec<Pivot> {
    let has = |row: usize, velocity: usize| rows[row].contains_key(&velocity);
    for (at, row) in block.iter().enumerate() {
        for (other, column) in block.iter().enumerate().filter(|(_, column)| has(row.row, column.velocity)) {
            let in_row = block.iter().filter(|pivot| has(row.row, pivot.velocity)).count();
            let in_column = block.iter().filter(|pivot| has(pivot.row, column.velocity)).count();
            if in_row > 1 && in_column > 1 {
                continue;
            }
            // The rest keeps its rows and velocities, paired anew.
            let alone = Pivot { velocity: column.velocity, ..*row };
            block[other].velocity = row.velocity;
            block.remove(at);
            return vec![alone];
        }
    }
    std::mem::take(block)
}

/// Takes a block of pivots out of the rows that are left.
fn eliminate<'g>(
    g: Sheet<'g>,
    rows: &mut [Sparse<'g>],
    left: &[usize],
    pivots: &[Pivot],
    partition: &Partition,
    watched: &mut Vec<Watched<'g>>,
) -> Step<'g> {
    let velocities: Vec<usize> = pivots.iter().map(|pivot| pivot.velocity).collect();
    let zero = g.zero();
    let take = |row: &mut Sparse<'g>| -> Option<Vec<Scalar<'g>>> {
        let entries: Vec<Option<Scalar>> = velocities.iter().map(|velocity| row.remove(velocity)).collect();
        let some = entries.iter().any(Option::is_some);
        some.then(|| entries.into_iter().map(|entry| entry.unwrap_or(zero)).collect())
    };
    let mut own: Vec<Sparse> = pivots.iter().map(|pivot| std::mem::take(&mut rows[pivot.row])).collect();
    let square: Vec<Vec<Scalar>> =
        own.iter_mut().map(|row| take(row).unwrap_or_else(|| vec![zero; pivots.len()])).collect();
    let Inverted { determinant, reciprocal, adjugate, inverse } = invert(g, &square);
    if determinant.value().is_none() {
        let size: f64 = pivots
            .iter()
            .map(|pivot| partition.row_sizes[pivot.row] / partition.scales[pivot.velocity])
            .product();
        // A power of two, so that measuring rounds nothing.
        watched.push((determinant, reciprocal, libm::exp2(libm::round(libm::log2(size)))));
    }
    let columns: BTreeSet<usize> = own.iter().flat_map(|row| row.keys().copied()).collect();
    let upper: Vec<(usize, Vec<Scalar>)> = columns
        .into_iter()
        .map(|column| {
            let entries: Vec<Scalar> =
                own.iter().map(|row| row.get(&column).copied().unwrap_or(zero)).collect();
            let of_rows = adjugate.iter().zip(&inverse);
            let taken = of_rows.map(|(adjugate, inverse)| {
                known(g, || product(g, adjugate, &entries))
                    .map_or_else(|| product(g, inverse, &entries), |known| known * reciprocal)
            });
            (column, taken.collect())
        })
        .collect();
    let mut lower = Vec::new();
    for other in left {
        let Some(below) = take(&mut rows[*other]) else { continue };
        for (column, entries) in &upper {
            let taken = product(g, &below, entries);
            let updated = rows[*other].get(column).copied().unwrap_or(zero) - taken;
            if updated.value() == Some(0.0) {
                rows[*other].remove(column);
            } else {
                rows[*other].insert(*column, updated);
            }
        }
        lower.push((*other, below));
    }
    Step { rows: pivots.iter().map(|pivot| pivot.row).collect(), velocities, inverse, upper, lower }
}

/// The inverse of a matrix, and what it is made of: a⁻¹ = adj(a)/det(a).
struct Inverted<'g> {
    determinant: Scalar<'g>,
    reciprocal: Scalar<'g>,
    adjugate: Vec<Vec<Scalar<'g>>>,
    inverse: Vec<Vec<Scalar<'g>>>,
}

/// Of a matrix of one, two or three rows.
fn invert<'g>(g: Sheet<'g>, a: &[Vec<Scalar<'g>>]) -> Inverted<'g> {
    let size = a.len();
    let cofactor = |row: usize, column: usize| match size {
        1 => g.one(),
        2 => {
            let entry = a[1 - row][1 - column];
            if row == column { entry } else { -entry }
        }
        _ => {
            // Cyclic, so that the sign is that of the determinant.
            let ((r, s), (c, d)) = (((row + 1) % 3, (row + 2) % 3), ((column + 1) % 3, (column + 2) % 3));
            a[r][c] * a[s][d] - a[r][d] * a[s][c]
        }
    };
    let adjugate: Vec<Vec<Scalar>> =
        (0..size).map(|column| (0..size).map(|row| cofactor(row, column)).collect()).collect();
    let first: Vec<Scalar> = adjugate.iter().map(|row| row[0]).collect();
    let determinant = product(g, &a[0], &first);
    let reciprocal = determinant.reciprocal();
    let inverse = adjugate.iter().map(|row| row.iter().map(|entry| *entry * reciprocal).collect()).collect();
    Inverted { determinant, reciprocal, adjugate, inverse }
}

/// What is on the graph already, but for a sign.
fn known<'g>(g: Sheet<'g>, make: impl FnOnce() -> Scalar<'g>) -> Option<Scalar<'g>> {
    let before = g.graph().len();
    let made = make();
    let signs = g.graph().since(before).iter().all(|op| matches!(op, Op::Neg(_)));
    signs.then_some(made)
}

/// Σ aᵢ bᵢ.
fn product<'g>(g: Sheet<'g>, a: &[Scalar<'g>], b: &[Scalar<'g>]) -> Scalar<'g> {
    g.sum(a.iter().zip(b).map(|(a, b)| *a * *b))
}

fn pick<'g>(values: &[Scalar<'g>], places: &[usize]) -> Vec<Scalar<'g>> {
    places.iter().map(|place| values[*place]).collect()
}

impl<'g> Lu<'g> {
    /// All that was computed.
    pub fn nodes(&self) -> impl Iterator<Item = Node> {
        let of_step = |step: &Step<'g>| -> Vec<Node> {
            let sides = step.upper.iter().chain(&step.lower).flat_map(|(_, entries)| entries);
            step.inverse.iter().flatten().chain(sides).map(|entry| entry.bare).collect()
        };
        self.steps.iter().flat_map(of_step)
    }

    /// `v` with its dependent entries such that D v = `rows`.
    pub fn dependent(&self, g: Sheet<'g>, rows: &[Scalar<'g>], v: &[Scalar<'g>]) -> Vec<Scalar<'g>> {
        let (mut y, mut v) = (rows.to_vec(), v.to_vec());
        for step in &self.steps {
            let given = pick(&y, &step.rows);
            // From here on y has, at the rows of a step, what belongs to its velocities.
            let own: Vec<Scalar> = step.inverse.iter().map(|row| product(g, row, &given)).collect();
            for (row, value) in step.rows.iter().zip(&own) {
                y[*row] = *value;
            }
            for (other, below) in &step.lower {
                y[*other] -= product(g, below, &own);
            }
        }
        for step in self.steps.iter().rev() {
            for (k, velocity) in step.velocities.iter().enumerate() {
                let upper = step.upper.iter();
                v[*velocity] =
                    upper.fold(y[step.rows[k]], |rest, (column, entries)| rest - entries[k] * v[*column]);
            }
        }
        v
    }

    /// The column of R that belongs to an independent velocity: 1 there, dependent entries with D R = 0.
    pub fn column(&self, g: Sheet<'g>, independent: usize) -> Sparse<'g> {
        let mut column = Sparse::from([(independent, g.one())]);
        for step in self.steps.iter().rev() {
            for (k, velocity) in step.velocities.iter().enumerate() {
                let mut rest = g.zero();
                for (other, entries) in &step.upper {
                    if let Some(known) = column.get(other) {
                        rest -= entries[k] * *known;
                    }
                }
                if rest.value() != Some(0.0) {
                    column.insert(*velocity, rest);
                }
            }
        }
        column
    }

    /// R z + S rows − shift, by R or by U, whichever takes less; the independent entries of `z` count.
    pub fn combine(
        &self,
        g: Sheet<'g>,
        basis: &[Sparse<'g>],
        rows: &[Scalar<'g>],
        shift: &[Scalar<'g>],
        independent: &[usize],
        z: &[Scalar<'g>],
    ) -> Vec<Scalar<'g>> {
        let less = |x: Vec<Scalar<'g>>| x.into_iter().zip(shift).map(|(x, shift)| x - *shift).collect();
        let in_basis: usize = basis.iter().map(|column| column.len() - 1).sum();
        let in_upper: usize = self.steps.iter().map(|step| step.upper.len() * step.rows.len()).sum();
        // S rows − shift is there already.
        let shifted = shift.iter().zip(&self.is_dependent).filter(|(x, own)| **own && !x.is_zero()).count();
        if in_upper + shifted < in_basis {
            return less(self.dependent(g, rows, z));
        }
        let mut sum: Vec<Scalar> = less(self.dependent(g, rows, &vec![g.zero(); z.len()]));
        for (velocity, column) in independent.iter().zip(basis) {
            for (at, entry) in column {
                sum[*at] += *entry * z[*velocity];
            }
        }
        sum
    }

    /// λ of D_dᵀ λ = `forces` in the dependent velocities: Uᵀ, then Lᵀ.
    pub fn multipliers(
        &self,
        g: Sheet<'g>,
        mut forces: Vec<Scalar<'g>>,
        mut lambda: Vec<Scalar<'g>>,
    ) -> Vec<Scalar<'g>> {
        for step in &self.steps {
            let own = pick(&forces, &step.velocities);
            for (column, entries) in step.upper.iter().filter(|(column, _)| self.is_dependent[*column]) {
                forces[*column] -= product(g, entries, &own);
            }
        }
        for step in self.steps.iter().rev() {
            let mut rest = pick(&forces, &step.velocities);
            for (other, below) in &step.lower {
                for (rest, entry) in rest.iter_mut().zip(below) {
                    *rest -= *entry * lambda[*other];
                }
            }
            for (k, row) in step.rows.iter().enumerate() {
                let column: Vec<Scalar> = step.inverse.iter().map(|inverse| inverse[k]).collect();
                lambda[*row] = product(g, &column, &rest);
            }
        }
        lambda
    }
}
