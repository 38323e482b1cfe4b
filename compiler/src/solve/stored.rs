//! One factorisation, many right-hand sides: K(c) = [M Dᵀ; D −c] factored by one function and solved by another.
//!
//! The solution is written for right-hand sides that are symbols. The part that does not depend on these is computed with
//! the factorisation and kept; the rest is the other function. So nothing has to be said about what a factor consists of.

use super::elimination::{self, Entries, Kind};
use super::stabilised::{Damping, stabilised};
use super::{Massless, add_square};
use crate::equations::Equations;
use crate::order::{self, Pattern};
use crate::symbolic::{Class, Compare, Graph, Node, Scalar, Sheet, all_bare};
use std::collections::{BTreeMap, BTreeSet};

/// K(c) factored, and its solution for any right-hand side.
#[derive(Clone, Debug)]
pub struct Stored {
    /// The values of a factorisation that are kept.
    pub kept: Vec<Node>,
    /// The smallest relative pivot, and that of the velocities alone.
    pub pivot: Node,
    pub velocity_pivot: Node,
    /// −γ + 2α (D v − ν) + β² Φ with the other sign: the rows of `system`.
    pub rows: Vec<Node>,
    /// a, then λ, in symbols for what is kept and for the right-hand sides.
    pub solution: Vec<Node>,
    /// These symbols.
    pub given: StandIns,
}

/// Symbols for what a solution is given.
#[derive(Clone, Debug)]
pub struct StandIns {
    /// The right-hand sides of K(c).
    pub forces: Vec<Node>,
    pub rows: Vec<Node>,
    /// What is kept of the factorisation.
    pub kept: Vec<Node>,
}

/// Writes K(c) out. Where M alone is singular, ρ′ Dᵀ D of the rows that hold the massless velocities is added to M,
/// ρ′ = ρ/(1 + ρ c), ρ′ Dᵀ γ to Q, c of these rows becomes c (1 + ρ c) and their multipliers are multiplied by 1 + ρ c: the
/// solution is the same, because D v̇ = γ + c λ.
pub fn store(equations: &Equations, massless: &Massless, row_scales: &[Node]) -> Stored {
    let g = equations.graph.sheet();
    let n = equations.symbols.v.len();
    let columns: Vec<&BTreeMap<usize, Node>> = equations.rows.iter().map(|row| &row.jet.columns).collect();
    let idle = &equations.idle;
    let compliance = g.on(equations.symbols.compliance);
    // 1 + ρ c and ρ′.
    let held: BTreeMap<usize, (Scalar, Scalar)> =
        massless.rows.iter().map(|(row, rho)| (*row, softened(*rho, compliance))).collect();

    let mut entries: Entries = equations.mass.clone();
    for (row, (_, weight)) in &held {
        add_square(&mut entries, columns[*row], *weight);
    }
    for (row, columns) in columns.iter().enumerate().filter(|(row, _)| !idle.contains(row)) {
        entries.extend(columns.iter().map(|(velocity, column)| ((n + row, *velocity), *column)));
    }
    let own: Vec<Node> = (0..columns.len())
        .map(|row| held.get(&row).map_or(compliance, |(stiffening, _)| compliance * *stiffening).bare)
        .collect();
    let pattern = Pattern::new(n, columns.len(), entries.keys().copied());
    let mut order = order::best(&pattern);
    order.sequence.retain(|unknown| unknown.checked_sub(n).is_none_or(|row| !idle.contains(&row)));
    let watch_velocities = !massless.rows.is_empty();
    let kind = Kind { velocities: n, watch_velocities, scales: row_scales, compliance: Some(&own) };
    let factor = elimination::factor(g, &entries, &order, &kind);

    // Right-hand sides as symbols; the elimination takes rows with the other sign.
    let (forces, rows) = (symbols(g, "force", n), symbols(g, "row", columns.len()));
    let mut right = g.all(&forces);
    for (row, (_, weight)) in &held {
        let weighted = *weight * rows[*row];
        for (velocity, column) in columns[*row] {
            right[*velocity] += *column * weighted;
        }
    }
    right.extend(rows.iter().map(|row| -g.on(*row)));
    let mut solution = factor.solve(g, &right);
    for (row, lambda) in solution[n..].iter_mut().enumerate() {
        if idle.contains(&row) {
            *lambda = g.zero();
        } else if let Some((stiffening, _)) = held.get(&row) {
            *lambda = *lambda * *stiffening;
        }
    }

    let solution = all_bare(&solution);
    let late = forces.iter().chain(&rows).copied().collect();
    let kept = frontier(&g.graph(), &solution, &late);
    let stand_ins = symbols(g, "kept", kept.len());
    let replaced = kept.iter().copied().zip(stand_ins.iter().copied()).collect();
    let solution = g.graph().substitute(&solution, &replaced);
    let asked = stabilised(equations, Damping::InRows, &[]).rows;
    let stabilised = asked.into_iter().map(|row| (-g.on(row)).bare).collect();
    let velocity_pivot = factor.velocity_pivot;
    let pivot = not_nan(g.on(factor.pivot)).bare;
    let given = StandIns { forces, rows, kept: stand_ins };
    Stored { kept, given, pivot, velocity_pivot, rows: stabilised, solution }
}

/// 1 + ρ c and ρ/(1 + ρ c).
fn softened(rho: f64, compliance: Scalar) -> (Scalar, Scalar) {
    let stiffening = 1.0 + rho * compliance;
    (stiffening, rho * stiffening.reciprocal())
}

/// Zero where a pivot was zero and left 0 · ∞ behind.
fn not_nan(pivot: Scalar) -> Scalar {
    if pivot.value().is_some() {
        return pivot;
    }
    let zero = pivot.g.zero();
    zero.compare(Compare::LessEqual, pivot).select(pivot, zero)
}

/// New symbols for what is given with a call.
pub(super) fn symbols(g: Sheet, name: &str, count: usize) -> Vec<Node> {
    (0..count).map(|index| g.symbol(format!("{name}_{index}"), Class::Input).bare).collect()
}

/// The nodes at which what depends on `late` symbols meets what does not, in order; what parameters alone decide is at hand
/// anyway.
pub(super) fn frontier(g: &Graph, roots: &[Node], late: &BTreeSet<Node>) -> Vec<Node> {
    let mut depends = BTreeSet::new();
    let mut kept = BTreeSet::new();
    for node in g.reachable(roots.iter().copied()) {
        if late.contains(&node) || g.op(node).operands().any(|operand| depends.contains(&operand)) {
            depends.insert(node);
        }
    }
    let early = |node: &Node| !depends.contains(node) && g.class(*node) > Class::Parameter;
    for node in &depends {
        kept.extend(g.op(*node).operands().filter(early));
    }
    kept.extend(roots.iter().copied().filter(early));
    kept.into_iter().collect()
}
