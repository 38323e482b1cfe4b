//! Elimination orders for the symmetric system K = [M Dᵀ; D 0], unknowns 0..n velocities, then rows.
//!
//! A row is eliminated only when no velocity is left in it: its pivot is then one of −D M⁻¹ Dᵀ, which vanishes only
//! where D loses rank. Eliminating it after one neighbour instead breaks down at ordinary dead centres.

use std::collections::BTreeSet;

/// Structure of K: for each unknown the set of its neighbours, one bit each.
#[derive(Clone, Debug)]
pub struct Pattern {
    pub velocities: usize,
    unknowns: usize,
    words: usize,
    bits: Vec<u64>,
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
        let unknowns = velocities + rows;
        let words = unknowns.div_ceil(64);
        let mut pattern = Pattern { velocities, unknowns, words, bits: vec![0; words * unknowns] };
        for (a, b) in entries {
            if a != b {
                pattern.bits[a * words + b / 64] |= 1 << (b % 64);
                pattern.bits[b * words + a / 64] |= 1 << (a % 64);
            }
        }
        pattern
    }

    fn row(&self, unknown: usize) -> &[u64] {
        &self.bits[unknown * self.words..(unknown + 1) * self.words]
    }

    fn degree(&self, unknown: usize) -> usize {
        self.row(unknown).iter().map(|word| word.count_ones() as usize).sum()
    }

    /// Whether a velocity is among the neighbours.
    fn touches_velocity(&self, unknown: usize) -> bool {
        let first = self.row(unknown).iter().enumerate().find(|(_, word)| **word != 0);
        first.is_some_and(|(at, word)| at * 64 + (word.trailing_zeros() as usize) < self.velocities)
    }

    /// Removes an unknown and joins its neighbours; gives them, ascending.
    pub(super) fn eliminate(&mut self, pivot: usize) -> Vec<usize> {
        let clique = self.row(pivot).to_vec();
        let around = members(&clique);
        for a in &around {
            let start = a * self.words;
            for (own, word) in self.bits[start..start + self.words].iter_mut().zip(&clique) {
                *own |= word;
            }
            self.bits[start + a / 64] &= !(1 << (a % 64));
            self.bits[start + pivot / 64] &= !(1 << (pivot % 64));
        }
        around
    }

    /// Removes an unknown that is known otherwise.
    pub(super) fn remove(&mut self, unknown: usize) {
        for a in members(self.row(unknown)) {
            self.bits[a * self.words + unknown / 64] &= !(1 << (unknown % 64));
        }
        self.bits[unknown * self.words..(unknown + 1) * self.words].fill(0);
    }

    /// Pairs of neighbours that are not neighbours of each other.
    fn fill(&self, unknown: usize) -> usize {
        let own = self.row(unknown);
        let around = members(own);
        let mut missing = 0;
        for a in &around {
            let row = self.row(*a);
            missing +=
                own.iter().zip(row).map(|(own, row)| (own & !row).count_ones() as usize).sum::<usize>();
        }
        // Each pair was met twice, and each neighbour misses itself.
        (missing - around.len()) / 2
    }
}

fn members(row: &[u64]) -> Vec<usize> {
    let mut members = Vec::new();
    for (at, word) in row.iter().enumerate() {
        let mut rest = *word;
        while rest != 0 {
            members.push(at * 64 + rest.trailing_zeros() as usize);
            rest &= rest - 1;
        }
    }
    members
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
    let n = pattern.unknowns;
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
