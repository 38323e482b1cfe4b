//! The teeth of wheels meet at the start: a tooth of the one faces a space of the other.
//!
//! The wheels are first put together as if they were smooth, then turned until the teeth meet, each by less than a pitch. Where the
//! teeth of a constraint cannot, `start` says too much; those of a load then only begin with a deflection.

use super::attempts;
use super::messages;
use super::{Attempt, Point, Problem};
use crate::diagnostics::Diagnostics;
use crate::equations::{Condition, Equations};
use crate::model::gears::reach;
use crate::model::{ConstraintKind, Mechanism};
use std::f64::consts::TAU;

/// The position where all teeth meet next to one that is assembled.
pub fn meet(
    mechanism: &Mechanism,
    problem: &Problem,
    point: &mut Point,
    assembled: Attempt,
    errors: &mut Diagnostics,
) -> Option<Attempt> {
    if mechanism.pairs.is_empty() {
        return Some(assembled);
    }
    let constrained = |pair: usize| {
        let own =
            |kind: &ConstraintKind| matches!(kind, ConstraintKind::Teeth { pair: own, .. } if *own == pair);
        mechanism.constraints.iter().any(|constraint| own(&constraint.kind))
    };
    for all in [true, false] {
        let meets = |at: &usize| mechanism.pairs[*at].follows.is_none() && (all || constrained(*at));
        let teeth = (0..mechanism.pairs.len()).filter(meets);
        let teeth: Vec<(Condition, f64)> =
            teeth.map(|at| (problem.equations.teeth[at].clone(), mechanism.pairs[at].constant)).collect();
        let meshed = problem.with(teeth);
        let attempt = meshed.solve(point, assembled.q.clone());
        if attempt.closed {
            let settled = attempts::settle_turns(&meshed, point, attempt);
            in_reach(mechanism, problem.equations, point, &settled.q, errors)?;
            return Some(settled);
        }
    }
    let pair =
        mechanism.pairs.iter().enumerate().filter(|(at, pair)| pair.follows.is_none() && constrained(*at));
    let apart =
        pair.map(|(at, pair)| (pair, turns(problem.equations, point, &assembled.q, at, pair.constant)));
    if let Some((pair, apart)) = apart.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())) {
        errors.error(pair.name.span, messages::teeth_do_not_meet(&pair.name.text, apart));
    }
    None
}

/// Teeth whose axes move reach each other at the start: the tip circles cross, and the base circles do not reach over the centres.
fn in_reach(
    mechanism: &Mechanism,
    equations: &Equations,
    point: &mut Point,
    q: &[f64],
    errors: &mut Diagnostics,
) -> Option<()> {
    let mut all = Some(());
    for (pair, distance) in mechanism.pairs.iter().zip(&equations.distances) {
        let Some(distance) = *distance else { continue };
        point.set_q(q);
        point.evaluate(&super::Ancestry::of(equations, [distance]));
        let found = point.get(distance);
        let (toothings, mesh) = mechanism.mesh_of(pair);
        let [near, far] = reach(toothings);
        if !(near < found && found < far) {
            let names = toothings.map(|toothing| toothing.text.as_str());
            let message = messages::teeth_out_of_reach(names, found, [near, mesh.nominal, far]);
            errors.error(pair.name.span, message);
            all = None;
        }
    }
    all
}

/// How far the teeth of a pair, in pitches.
fn turns(equations: &Equations, point: &mut Point, q: &[f64], pair: usize, constant: f64) -> f64 {
    let turns = (sum(equations, point, q, pair) - constant) / TAU;
    turns - turns.round()
}

fn sum(equations: &Equations, point: &mut Point, q: &[f64], pair: usize) -> f64 {
    let value = equations.teeth[pair].jet.value;
    point.set_q(q);
    point.evaluate(&super::Ancestry::of(equations, [value]));
    point.get(value)
}

/// Of loads between teeth what their sums of angles are where the teeth meet nearest to the start.
pub fn phases(mechanism: &Mechanism, equations: &Equations, point: &mut Point, q: &[f64]) -> Vec<f64> {
    let counted = mechanism.loads.iter().filter(|load| mechanism.has_phase(load));
    let pairs = counted.filter_map(|load| Some(load.teeth.as_ref()?.pair));
    pairs
        .map(|pair| {
            let constant = mechanism.pairs[pair].constant;
            constant + TAU * ((sum(equations, point, q, pair) - constant) / TAU).round()
        })
        .collect()
}
