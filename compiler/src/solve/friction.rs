//! Accelerations and multipliers where friction follows from reactions: M v̇ + Dᵀ λ = Q + Σ_k N_k b_k, N_k of v̇ and λ.
//!
//! A linear solution for Q and one for each b_k, by the one factorisation, make v̇ and λ affine in N; what N is then, and in how many passes, is
//! `equations::friction`.

use super::Solution;
use crate::equations::{Equations, Friction, closed};
use crate::symbolic::{Node, Scalar, Sheet, all_bare};

/// Right-hand sides of the velocities: one for each N.
pub(super) fn columns<'g>(g: Sheet<'g>, friction: &Friction, velocities: usize) -> Vec<Vec<Scalar<'g>>> {
    let column = |entries: &std::collections::BTreeMap<usize, Node>| {
        (0..velocities).map(|at| entries.get(&at).map_or_else(|| g.zero(), |entry| g.on(*entry))).collect()
    };
    friction.columns.iter().map(column).collect()
}

/// The solution with friction, from that without and those of the columns.
pub(super) fn rubbed(g: Sheet, equations: &Equations, without: Solution, columns: &[Solution]) -> Solution {
    if equations.friction.is_none() {
        return without;
    }
    let flat = |solution: &Solution| {
        let all: Vec<Node> = solution.acceleration.iter().chain(&solution.lambda).copied().collect();
        g.all(&all)
    };
    let results: Vec<Node> = equations.results().collect();
    let columns: Vec<Vec<Scalar>> = columns.iter().map(flat).collect();
    let found = closed(g, &equations.friction, &results, &flat(&without), &columns);
    let mut acceleration = all_bare(&found.results);
    let lambda = acceleration.split_off(without.acceleration.len());
    Solution { acceleration, lambda, pivot: without.pivot, left: found.left }
}
