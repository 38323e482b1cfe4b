//! Sparse LDLᵀ of the symmetric system, written into the graph.

use crate::order::Order;
use crate::symbolic::{Node, Scalar, Sheet};
use std::collections::BTreeMap;

/// A symmetric matrix by its non-zero entries (row ≥ column).
pub type Entries = BTreeMap<(usize, usize), Node>;

/// The factors of K as nodes.
#[derive(Clone, Debug)]
pub struct Factor {
    velocities: usize,
    steps: Vec<Step>,
    /// Smallest relative pivot: of rows d/S, of velocities d/P with P the sum of its positive terms; 1 if none needs watching.
    pub pivot: Node,
    /// The same of the velocities alone.
    pub velocity_pivot: Node,
}

#[derive(Clone, Debug)]
struct Step {
    unknown: usize,
    is_row: bool,
    /// 1/d of a velocity, −1/d of a row: positive, except where a pivot has broken down.
    inverse: Node,
    /// Column of L below the pivot.
    column: Vec<(usize, Node)>,
}

/// The diagonal entry of an unknown while it is being formed.
#[derive(Clone, Default)]
struct Diagonal<'g> {
    /// M's own entry and, for rows, the terms −D M⁻¹ Dᵀ: all of one sign.
    own: Vec<Scalar<'g>>,
    /// The terms that elimination takes away again.
    taken: Vec<Scalar<'g>>,
}

/// The properties of K that the factorisation has to know besides its entries.
pub struct Kind<'a> {
    pub velocities: usize,
    /// Whether velocity pivots are watched: those of M alone are positive with it.
    pub watch_velocities: bool,
    /// Sᵢ of each row: what its pivot is measured by, the same all along the motion.
    pub scales: &'a [Node],
    /// c, of each row, where K has −c on the diagonal.
    pub compliance: Option<&'a [Node]>,
}

/// Factors K in the given order.
///
/// A row's pivot is the difference of two sums of squares, d = P − N (+ c), and may vanish by cancellation, as in a flat
/// parallelogram, or as a whole, as along a distance that nothing can change. Relative to Sᵢ, the largest it can be along the motion, it
/// is a pivot of D M⁻¹ Dᵀ with its rows brought to length one: a product, its magnitude and a maximum watch it.
pub fn factor(g: Sheet, entries: &Entries, order: &Order, kind: &Kind) -> Factor {
    let velocities = kind.velocities;
    let zero = g.zero();
    let unknowns = order.sequence.iter().map(|unknown| unknown + 1).max().unwrap_or(0);
    let mut diagonals: Vec<Diagonal> = vec![Diagonal::default(); unknowns];
    let mut rows: Vec<BTreeMap<usize, Scalar>> = vec![BTreeMap::new(); unknowns];
    for ((i, j), entry) in entries {
        let entry = g.on(*entry);
        if i == j {
            diagonals[*i].own.push(entry);
        } else {
            rows[*i].insert(*j, entry);
            rows[*j].insert(*i, entry);
        }
    }
    let mut steps = Vec::new();
    let mut watched: Vec<Watched> = Vec::new();
    for pivot in &order.sequence {
        let is_row = *pivot >= velocities;
        let Diagonal { own, taken } = std::mem::take(&mut diagonals[*pivot]);
        let positive = g.sum(own);
        let mut magnitude = taken.iter().fold(positive, |sum, term| sum - *term);
        if let (true, Some(compliance)) = (is_row, kind.compliance) {
            magnitude += compliance[*pivot - velocities];
        }
        let inverse = magnitude.reciprocal();
        let is_difference = !taken.is_empty();
        if is_row || kind.watch_velocities && is_difference {
            let scale = if is_row { g.on(kind.scales[*pivot - velocities]) } else { positive };
            watched.push(Watched { unknown: *pivot, scale, inverse, is_row, is_difference });
        }
        let reciprocal = if is_row { -inverse } else { inverse };
        let around = std::mem::take(&mut rows[*pivot]);
        let column: Vec<(usize, Scalar)> =
            around.iter().map(|(unknown, entry)| (*unknown, *entry * reciprocal)).collect();
        for (at, (i, l)) in column.iter().enumerate() {
            rows[*i].remove(pivot);
            // −K_ip K_ip / d adds to a row's magnitude if d > 0 and takes from it if d < 0; the reverse for a velocity.
            let product = *l * around[i];
            let update = if is_row { -product } else { product };
            let diagonal = &mut diagonals[*i];
            if (*i >= velocities) != is_row {
                diagonal.own.push(update)
            } else {
                diagonal.taken.push(update)
            }
            for (j, _) in &column[at + 1..] {
                let product = *l * around[j];
                let updated = rows[*i].get(j).copied().unwrap_or(zero) - product;
                rows[*i].insert(*j, updated);
                rows[*j].insert(*i, updated);
            }
        }
        let column = column.into_iter().map(|(unknown, l)| (unknown, l.bare)).collect();
        steps.push(Step { unknown: *pivot, is_row, inverse: inverse.bare, column });
    }
    let of_velocities = watched.iter().filter(|watched| !watched.is_row);
    let velocity_pivot = smallest_pivot(g, &steps, of_velocities.copied().collect()).bare;
    let pivot = smallest_pivot(g, &steps, watched).bare;
    Factor { velocities, steps, pivot, velocity_pivot }
}

/// A pivot to be watched.
#[derive(Clone, Copy)]
struct Watched<'g> {
    unknown: usize,
    /// The size that d is divided by.
    scale: Scalar<'g>,
    /// 1/d.
    inverse: Scalar<'g>,
    is_row: bool,
    /// Whether d is a difference: where it has broken down its sign is that of rounding.
    is_difference: bool,
}

/// min d/S, as 1/max(S/d); rows of the same S are compared before they are measured, along the tree of the elimination: what one
/// row does repeats with the elimination along a chain of them.
fn smallest_pivot<'g>(g: Sheet<'g>, steps: &[Step], watched: Vec<Watched<'g>>) -> Scalar<'g> {
    let mut worst: Option<Scalar> = None;
    for (at, first) in watched.iter().enumerate() {
        let alike = |other: &&Watched| other.scale.bare == first.scale.bare;
        if watched[..at].iter().any(|earlier| alike(&earlier)) {
            continue;
        }
        let inverse = along_tree(steps, watched[at..].iter().filter(alike));
        let ratio = inverse.map(|inverse| first.scale * inverse);
        worst = match (worst, ratio) {
            (Some(worst), Some(ratio)) => Some(worst.max(ratio)),
            (worst, ratio) => worst.or(ratio),
        };
    }
    worst.map_or_else(|| g.one(), Scalar::reciprocal)
}

/// The largest of |1/d|: of each with what was found before it, handed on to the next unknown that it acts on.
fn along_tree<'a, 'g: 'a>(
    steps: &[Step],
    watched: impl Iterator<Item = &'a Watched<'g>>,
) -> Option<Scalar<'g>> {
    let mut found: BTreeMap<usize, Scalar> =
        watched.map(|known| (known.unknown, known.magnitude())).collect();
    let mut position = BTreeMap::new();
    position.extend(steps.iter().enumerate().map(|(at, step)| (step.unknown, at)));
    let mut most: Option<Scalar> = None;
    let larger = |one: Option<Scalar<'g>>, other: Scalar<'g>| one.map_or(other, |one| one.max(other));
    for step in steps {
        let Some(own) = found.remove(&step.unknown) else { continue };
        match step.column.iter().map(|(unknown, _)| *unknown).min_by_key(|unknown| position.get(unknown)) {
            Some(next) => {
                let other = found.remove(&next);
                found.insert(next, larger(other, own));
            }
            None => most = Some(larger(most, own)),
        }
    }
    most
}

impl<'g> Watched<'g> {
    /// |1/d|.
    fn magnitude(&self) -> Scalar<'g> {
        if self.is_difference { self.inverse.abs() } else { self.inverse }
    }
}

impl Factor {
    /// All that was computed for it.
    pub fn nodes(&self) -> Vec<Node> {
        let columns = self.steps.iter().flat_map(|step| step.column.iter().map(|(_, l)| *l));
        columns.chain(self.steps.iter().map(|step| step.inverse)).collect()
    }

    /// K x = [Q; γ], given Q and, for the rows, −γ: with that sign no multiplier has to be negated at the end.
    pub fn solve<'g>(&self, g: Sheet<'g>, forces_and_minus_gamma: &[Scalar<'g>]) -> Vec<Scalar<'g>> {
        let mut x = forces_and_minus_gamma.to_vec();
        for step in &self.steps {
            for (unknown, l) in &step.column {
                let product = g.on(*l) * x[step.unknown];
                if step.is_row == (*unknown >= self.velocities) {
                    x[*unknown] -= product;
                } else {
                    x[*unknown] += product;
                }
            }
        }
        for step in self.steps.iter().rev() {
            let value = x[step.unknown] * step.inverse;
            x[step.unknown] = step.column.iter().fold(value, |value, (unknown, l)| value - *l * x[*unknown]);
        }
        x
    }
}
