//! Elimination orders for the symmetric system K = [M Dᵀ; D 0], unknowns 0..n velocities, then rows.
//!
//! A row is eliminated only when no velocity is left in it: its pivot is then one of −D M⁻¹ Dᵀ, which vanishes only
//! where D loses rank. Eliminating it after one neighbour instead breaks down at ordinary dead centres.

use std::collections::BTreeSet;

/// Structure of K: neighbours of each unknown.
#[derive(Clone, Debug)]
pub struct Pattern {
    pub velocities: usize,
    pub neighbours: Vec<BTreeSet<usize>>,
}

/// How ties and choices are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Strategy {
    /// Least degree; ties by least depth, so that chains are eliminated from both ends at once.
    MinimumDegree,
    /// Least fill, ties by degree and depth.
    MinimumFill,
    /// Least degree, all velocities before any row: the Schur complement of the mass matrix.
    Schur,
}

pub const STRATEGIES: [Strategy; 3] = [Strategy::MinimumDegree, Strategy::MinimumFill, Strategy::Schur];

/// An order and what it costs.
#[derive(Clone, Debug)]
pub struct Order {
    pub strategy: Strategy,
    pub sequence: Vec<usize>,
    /// Operations of factorisation and solution, by structure.
    pub operations: usize,
    /// Longest chain of dependent pivots.
    pub depth: usize,
}

impl Pattern {
    pub fn new(velocities: usize, rows: usize, entries: impl IntoIterator<Item = (usize, usize)>) -> Self {
        let mut neighbours = vec![BTreeSet::new(); velocities + rows];
        for (a, b) in entries {
            if a != b {
                neighbours[a].insert(b);
                neighbours[b].insert(a);
            }
        }
        Pattern { velocities, neighbours }
    }
}

/// The cheapest of all strategies.
pub fn best(pattern: &Pattern) -> Order {
    let orders = STRATEGIES.map(|strategy| order(pattern, strategy));
    // A level of depth costs about as much as two independent operations.
    let score = |order: &Order| order.operations + 2 * order.depth;
    let [first, rest @ ..] = orders;
    rest.into_iter().fold(first, |best, order| if score(&order) < score(&best) { order } else { best })
}

pub fn order(pattern: &Pattern, strategy: Strategy) -> Order {
    let n = pattern.neighbours.len();
    let mut neighbours: Vec<BTreeSet<usize>> = pattern.neighbours.clone();
    let mut depth = vec![0usize; n];
    let mut left: BTreeSet<usize> = (0..n).collect();
    let mut result = Order { strategy, sequence: Vec::with_capacity(n), operations: 0, depth: 0 };
    while !left.is_empty() {
        let velocities_left = left.first().is_some_and(|first| *first < pattern.velocities);
        let eligible = left.iter().copied().filter(|unknown| {
            *unknown < pattern.velocities
                || (neighbours[*unknown].first().is_none_or(|first| *first >= pattern.velocities)
                    && !(strategy == Strategy::Schur && velocities_left))
        });
        let key = |unknown: usize| {
            let degree = neighbours[unknown].len();
            match strategy {
                Strategy::MinimumFill => (fill(&neighbours, unknown), degree, depth[unknown], unknown),
                _ => (degree, depth[unknown], 0, unknown),
            }
        };
        let Some(pivot) = eligible.min_by_key(|unknown| key(*unknown)) else { break };
        left.remove(&pivot);
        let around = std::mem::take(&mut neighbours[pivot]);
        for a in &around {
            neighbours[*a].remove(&pivot);
            neighbours[*a].extend(around.iter().filter(|b| *b != a));
            depth[*a] = depth[*a].max(depth[pivot] + 1);
        }
        let degree = around.len();
        // reciprocal, L, updates, forward, diagonal, backward
        result.operations += 1 + degree + degree * (degree + 1) / 2 + degree + 1 + degree;
        result.depth = result.depth.max(depth[pivot] + 1);
        result.sequence.push(pivot);
    }
    result
}

/// Pairs of neighbours that are not neighbours of each other.
fn fill(neighbours: &[BTreeSet<usize>], unknown: usize) -> usize {
    let around: Vec<usize> = neighbours[unknown].iter().copied().collect();
    let mut missing = 0;
    for (index, a) in around.iter().enumerate() {
        missing += around[index + 1..].iter().filter(|b| !neighbours[*a].contains(b)).count();
    }
    missing
}
