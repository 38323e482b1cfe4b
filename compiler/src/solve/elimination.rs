//! Sparse LDLᵀ of the symmetric system, written into the graph.

use super::order::Order;
use crate::symbolic::{Graph, Node, Unary};
use std::collections::BTreeMap;

/// A symmetric matrix by its non-zero entries (row ≥ column).
pub type Entries = BTreeMap<(usize, usize), Node>;

/// The factors of K as nodes.
#[derive(Clone, Debug)]
pub struct Factor {
    velocities: usize,
    steps: Vec<Step>,
    /// Smallest relative pivot: min over the watched pivots of |d| / Σ |terms of d|; 1 if none needs watching.
    pub pivot: Node,
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
#[derive(Clone, Debug, Default)]
struct Diagonal {
    /// M's own entry and, for rows, the terms −D M⁻¹ Dᵀ: all of one sign.
    own: Vec<Node>,
    /// What elimination takes away again.
    taken: Vec<Node>,
}

/// Factors K in the given order. Velocity pivots are those of M, positive with it, and are watched only on request;
/// a row's pivot is the difference of two sums of squares, P − N, and is watched wherever there is an N:
/// (P − N)/(P + N) = 1/(2 P/d − 1), so a product, its magnitude and a maximum watch it.
pub fn factor(
    g: &mut Graph,
    entries: &Entries,
    velocities: usize,
    order: &Order,
    watch_velocities: bool,
) -> Factor {
    let unknowns = order.sequence.iter().map(|unknown| unknown + 1).max().unwrap_or(0);
    let mut diagonals: Vec<Diagonal> = vec![Diagonal::default(); unknowns];
    let mut rows: Vec<BTreeMap<usize, Node>> = vec![BTreeMap::new(); unknowns];
    for ((i, j), entry) in entries {
        if i == j {
            diagonals[*i].own.push(*entry);
        } else {
            rows[*i].insert(*j, *entry);
            rows[*j].insert(*i, *entry);
        }
    }
    let mut steps = Vec::new();
    let mut watched: Option<Node> = None;
    for pivot in &order.sequence {
        let is_row = *pivot >= velocities;
        let Diagonal { own, taken } = std::mem::take(&mut diagonals[*pivot]);
        let positive = g.sum(own);
        let magnitude = taken.iter().fold(positive, |sum, term| g.sub(sum, *term));
        let inverse = g.unary(Unary::Reciprocal, magnitude);
        if (is_row || watch_velocities) && !taken.is_empty() {
            // Where a pivot has broken down its sign is that of rounding.
            let ratio = g.mul(positive, inverse);
            let ratio = g.unary(Unary::Abs, ratio);
            watched = Some(watched.map_or(ratio, |worst| g.max(worst, ratio)));
        }
        let reciprocal = if is_row { g.neg(inverse) } else { inverse };
        let around = std::mem::take(&mut rows[*pivot]);
        let column: Vec<(usize, Node)> =
            around.iter().map(|(unknown, entry)| (*unknown, g.mul(*entry, reciprocal))).collect();
        for (at, (i, l)) in column.iter().enumerate() {
            rows[*i].remove(pivot);
            let update = {
                let product = g.mul(*l, around[i]);
                // −K_ip K_ip / d adds to a row's magnitude if d > 0 and takes from it if d < 0; the reverse for a velocity.
                if is_row { g.neg(product) } else { product }
            };
            let diagonal = &mut diagonals[*i];
            if (*i >= velocities) != is_row {
                diagonal.own.push(update)
            } else {
                diagonal.taken.push(update)
            }
            for (j, _) in &column[at + 1..] {
                let product = g.mul(*l, around[j]);
                let zero = g.constant(0.0);
                let entry = rows[*i].get(j).copied().unwrap_or(zero);
                let updated = g.sub(entry, product);
                rows[*i].insert(*j, updated);
                rows[*j].insert(*i, updated);
            }
        }
        steps.push(Step { unknown: *pivot, is_row, inverse, column });
    }
    let one = g.constant(1.0);
    let pivot = match watched {
        None => one,
        Some(worst) => {
            let two = g.constant(2.0);
            let twice = g.mul(two, worst);
            let sum = g.sub(twice, one);
            g.unary(Unary::Reciprocal, sum)
        }
    };
    Factor { velocities, steps, pivot }
}

impl Factor {
    /// K x = [Q; γ], given Q and, for the rows, −γ: with that sign no multiplier has to be negated at the end.
    pub fn solve(&self, g: &mut Graph, forces_and_minus_gamma: &[Node]) -> Vec<Node> {
        let mut x = forces_and_minus_gamma.to_vec();
        for step in &self.steps {
            for (unknown, l) in &step.column {
                let product = g.mul(*l, x[step.unknown]);
                let same_sign = step.is_row == (*unknown >= self.velocities);
                x[*unknown] =
                    if same_sign { g.sub(x[*unknown], product) } else { g.add(x[*unknown], product) };
            }
        }
        for step in self.steps.iter().rev() {
            let mut value = g.mul(x[step.unknown], step.inverse);
            for (unknown, l) in &step.column {
                let product = g.mul(*l, x[*unknown]);
                value = g.sub(value, product);
            }
            x[step.unknown] = value;
        }
        x
    }
}
