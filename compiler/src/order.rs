//! Elimination orders for the symmetric system K = [M Dᵀ; D 0], unknowns 0..n velocities, then rows.
//!
//! A row is eliminated only when no velocity is left in it: its pivot is then one of −D M⁻¹ Dᵀ, which vanishes only
//! where D loses rank. Eliminating it after one neighbour instead breaks down at ordinary dead centres.

use std::collections::BTreeSet;

/// Structure of K: for each unknown its neighbours, ascending.
#[derive(Clone, Debug)]
pub struct Pattern {
    pub velocities: usize,
    rows: Vec<Vec<u32>>,
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
    /// By articulated bodies, without M; the order is that of the least degree for whoever eliminates all the same.
    ArticulatedBodies,
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
        let mut pattern = Pattern { velocities, rows: vec![Vec::new(); velocities + rows] };
        for (a, b) in entries.into_iter().filter(|(a, b)| a != b) {
            pattern.rows[a].push(b as u32);
            pattern.rows[b].push(a as u32);
        }
        for row in &mut pattern.rows {
            row.sort_unstable();
            row.dedup();
        }
        pattern
    }

    fn degree(&self, unknown: usize) -> usize {
        self.rows[unknown].len()
    }

    /// Whether a velocity is among the neighbours.
    fn touches_velocity(&self, unknown: usize) -> bool {
        self.rows[unknown].first().is_some_and(|first| (*first as usize) < self.velocities)
    }

    /// Removes an unknown and joins its neighbours; gives them, ascending.
    pub(super) fn eliminate(&mut self, pivot: usize) -> Vec<usize> {
        let clique = std::mem::take(&mut self.rows[pivot]);
        for a in &clique {
            let own = &mut self.rows[*a as usize];
            *own = joined(own, &clique, [*a, pivot as u32]);
        }
        clique.into_iter().map(|a| a as usize).collect()
    }

    /// Removes an unknown that is known otherwise.
    pub(super) fn remove(&mut self, unknown: usize) {
        for a in std::mem::take(&mut self.rows[unknown]) {
            self.rows[a as usize].retain(|other| *other as usize != unknown);
        }
    }

    /// Pairs of neighbours that are not neighbours of each other.
    fn fill(&self, unknown: usize) -> usize {
        let around = &self.rows[unknown];
        let missing: usize = around.iter().map(|a| missing(around, &self.rows[*a as usize])).sum();
        // Each pair was met twice, and each neighbour misses itself.
        (missing - around.len()) / 2
    }
}

/// What is in either, ascending, without these two. Loops over indices: this runs unoptimised in compilers of user crates.
fn joined(one: &[u32], other: &[u32], without: [u32; 2]) -> Vec<u32> {
    let mut all = Vec::with_capacity(one.len() + other.len());
    let (mut i, mut j) = (0, 0);
    while i < one.len() || j < other.len() {
        let next = match (one.get(i), other.get(j)) {
            (Some(a), Some(b)) if a == b => {
                j += 1;
                i += 1;
                *a
            }
            (Some(a), b) if b.is_none_or(|b| a < b) => {
                i += 1;
                *a
            }
            _ => {
                j += 1;
                other[j - 1]
            }
        };
        if next != without[0] && next != without[1] {
            all.push(next);
        }
    }
    all
}

/// How many of the one are not in the other, both ascending.
fn missing(one: &[u32], other: &[u32]) -> usize {
    let (mut j, mut missing) = (0, 0);
    for a in one {
        while j < other.len() && other[j] < *a {
            j += 1;
        }
        if other.get(j) != Some(a) {
            missing += 1;
        }
    }
    missing
}

/// The cheapest of all strategies.
pub fn best(pattern: &Pattern) -> Order {
    let orders = STRATEGIES.map(|strategy| order(pattern, strategy));
    // A level of depth costs about as much as two independent operations.
    let score = |order: &Order| order.operations + 2 * order.depth;
    let [first, rest @ ..] = orders;
    rest.into_iter().fold(first, |best, order| if score(&order) < score(&best) { order } else { best })
}

/// The measure by which the next pivot is chosen, least first; rows that still touch a velocity wait.
type Key = (bool, usize, usize, usize, usize);

pub fn order(pattern: &Pattern, strategy: Strategy) -> Order {
    let n = pattern.rows.len();
    let mut pattern = pattern.clone();
    let mut depth = vec![0usize; n];
    let key = |pattern: &Pattern, depth: &[usize], unknown: usize| -> Key {
        let is_row = unknown >= pattern.velocities;
        let waits = is_row && (strategy == Strategy::Schur || pattern.touches_velocity(unknown));
        let degree = pattern.degree(unknown);
        match strategy {
            Strategy::MinimumFill => (waits, pattern.fill(unknown), degree, depth[unknown], unknown),
            _ => (waits, degree, depth[unknown], 0, unknown),
        }
    };
    let mut keys: Vec<Key> = (0..n).map(|unknown| key(&pattern, &depth, unknown)).collect();
    let mut queue: BTreeSet<Key> = keys.iter().copied().collect();
    let mut result = Order { strategy, sequence: Vec::with_capacity(n), operations: 0, depth: 0 };
    while let Some((.., pivot)) = queue.pop_first() {
        let around = pattern.eliminate(pivot);
        for a in &around {
            depth[*a] = depth[*a].max(depth[pivot] + 1);
        }
        for a in &around {
            let fresh = key(&pattern, &depth, *a);
            if fresh != keys[*a] {
                queue.remove(&keys[*a]);
                queue.insert(fresh);
                keys[*a] = fresh;
            }
        }
        let degree = around.len();
        // reciprocal, L, updates, forward, diagonal, backward
        result.operations += 1 + degree + degree * (degree + 1) / 2 + degree + 1 + degree;
        result.depth = result.depth.max(depth[pivot] + 1);
        result.sequence.push(pivot);
    }
    result
}

#[cfg(test)]
mod tests {
    use super::{Pattern, joined, missing};
    use std::collections::BTreeSet;

    #[test]
    fn neighbours_are_joined_and_counted_as_sets_are() {
        let lists: [&[u32]; 5] = [&[], &[0, 2, 5], &[2, 3, 5, 9], &[1], &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9]];
        for one in lists {
            for other in lists {
                let [a, b] = [one, other].map(|list| list.iter().copied().collect::<BTreeSet<u32>>());
                let all: Vec<u32> = a.union(&b).copied().filter(|k| *k != 2 && *k != 9).collect();
                assert_eq!(joined(one, other, [9, 2]), all, "{one:?} and {other:?}");
                assert_eq!(missing(one, other), a.difference(&b).count(), "{one:?} without {other:?}");
            }
        }
    }

    /// A square of four: the first pivot joins its neighbours, which are then neighbours of each other.
    #[test]
    fn a_pivot_joins_its_neighbours() {
        let mut square = Pattern::new(4, 0, [(0, 1), (1, 2), (2, 3), (3, 0), (0, 0), (1, 0)]);
        assert_eq!((square.fill(0), square.degree(0)), (1, 2));
        assert_eq!(square.eliminate(0), [1, 3]);
        assert_eq!((square.fill(1), square.eliminate(1)), (0, vec![2, 3]));
        square.remove(2);
        assert_eq!((square.degree(3), square.eliminate(3)), (0, vec![]));
    }
}
