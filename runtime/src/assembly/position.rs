//! Positions that satisfy the constraints: a damped Newton iteration on the group.
//!
//! Moves by [`retract`], so orientations keep their length; what has to vanish is `residual.rs`, the linear algebra
//! `system.rs`. Velocities and accelerations, which are linear, are `rates.rs`.

use super::given::{given_finite, given_targets, given_time};
use super::residual::{Residual, ResidualOf};
use super::system::{System, rank_deficient};
use crate::error::AssemblyError;
use crate::layout::{normalised, retract};
use crate::mechanism::{Assemble, Row};
use crate::real::Real;
use crate::vector::Vector;

/// Iterations before the search is given up.
const ITERATIONS: u32 = 50;
/// Iterations at the largest turn besides, where counted angles have far to go: some thirty turns.
const FAR: u32 = 400;
/// The largest turn of one orientation in one iteration, rad: Newton's linear picture of a rotation holds no further.
const LARGEST_TURN: f64 = 0.5;
/// Halvings of a step that does not bring the residual down.
const HALVINGS: u32 = 20;

/// The position near `near` that satisfies the constraints and the conditions `active` (indices into
/// [`Assemble::conditions`]) at their `targets`.
///
/// Newton's iteration: each step is the least δ (½ δᵀ δ, metres and radians alike) with D̂ δ = −r, at most half a
/// radian, halved until the residual's norm falls. Angles enter r as atan2(sin, cos), so a target may be far away and
/// a joint assembled half a turn off is turned back; angles whose turns the dynamics count enter with their turns. Done at 32 roundings of the coordinates' magnitude.
/// Pairs and quaternions of `near` need not have length 1: they are normalised first.
///
/// # Errors
/// [`GivenNotFinite`](AssemblyError::GivenNotFinite), [`NoOrientation`](AssemblyError::NoOrientation),
/// [`NoConvergence`](AssemblyError::NoConvergence), [`RankDeficient`](AssemblyError::RankDeficient),
/// [`NonFinite`](AssemblyError::NonFinite), [`Flipped`](AssemblyError::Flipped),
/// [`NoSuchCondition`](AssemblyError::NoSuchCondition).
pub fn assemble_position<R: Real, M: Assemble<R>>(
    model: &M,
    time: R,
    near: &M::Q,
    targets: &M::Conditions,
    active: &[u16],
) -> Result<M::Q, AssemblyError> {
    let mut system = System::new(model, active)?;
    given_time(time)?;
    given_finite(near, model.position_names(), model.name())?;
    given_targets(model, targets, active)?;
    let mut q = normalised(model.layout(), near).map_err(|(first, length)| AssemblyError::NoOrientation {
        what: model.position_names().get(first).copied().unwrap_or(model.name()),
        length: length.to_f64(),
    })?;
    let mut residual = Residual::at(model, time, &q, targets, &system.active);
    let (mut iteration, mut far) = (0, 0);
    while iteration < ITERATIONS && far < FAR {
        residual.check_finite(model)?;
        if residual.norm <= tolerance(model, &q) {
            return residual.check_flips(model).and_then(|()| found(model, q));
        }
        system.evaluate(time, &q, Some(&residual.divisors));
        let pivot = system.factor_unit();
        if pivot.value < R::BREAKDOWN {
            if !residual.at_right_angle(model) {
                return Err(rank_deficient(model, pivot));
            }
            let from = q.clone();
            retract(model.layout(), &from, &nudge(model), &mut q);
            residual = Residual::at(model, time, &q, targets, &system.active);
            iteration += 1;
            continue;
        }
        let step = system.least(&model.zero_v(), &residual.rows, &residual.conditions).scaled(-R::ONE);
        let delta = limited(model, step.clone());
        if delta == step || model.layout().angles.is_empty() {
            iteration += 1;
        } else {
            far += 1;
        }
        match shorten(model, time, &q, &delta, targets, &system.active, residual.norm) {
            Some((next, next_residual)) => (q, residual) = (next, next_residual),
            None if residual.norm <= R::from_f64(64.0) * tolerance(model, &q) => {
                return residual.check_flips(model).and_then(|()| found(model, q));
            }
            None => return Err(residual.no_convergence(model, iteration)),
        }
    }
    if residual.norm <= tolerance(model, &q) {
        return residual.check_flips(model).and_then(|()| found(model, q));
    }
    Err(residual.no_convergence(model, iteration + far))
}

/// The position, if no coordinate overflowed on the way, nor what is left to rounding.
fn found<R: Real, M: Assemble<R>>(model: &M, q: M::Q) -> Result<M::Q, AssemblyError> {
    let largest = || q.as_slice().iter().position(|entry| entry.abs() == q.max_abs());
    let unbounded = if tolerance(model, &q).is_finite() { None } else { largest() };
    match q.first_not_finite().or(unbounded) {
        None => Ok(q),
        Some(index) => {
            let of = model.position_names().get(index).copied().unwrap_or(model.name());
            Err(AssemblyError::NonFinite { row: Row { of, what: "position" } })
        }
    }
}

/// The position nearest to `near` that satisfies the constraints; nothing else is held.
///
/// # Errors
/// As [`assemble_position`].
pub fn project_position<R: Real, M: Assemble<R>>(
    model: &M,
    time: R,
    near: &M::Q,
) -> Result<M::Q, AssemblyError> {
    assemble_position(model, time, near, &model.zero_conditions(), &[])
}

/// The first of the steps δ, δ/2, δ/4 … that brings the residual's norm below `norm`.
fn shorten<R: Real, M: Assemble<R>>(
    model: &M,
    time: R,
    q: &M::Q,
    delta: &M::V,
    targets: &M::Conditions,
    active: &M::Conditions,
    norm: R,
) -> Option<(M::Q, ResidualOf<R, M>)> {
    let mut delta = delta.clone();
    for _ in 0..=HALVINGS {
        let mut trial = q.clone();
        retract(model.layout(), q, &delta, &mut trial);
        let residual = Residual::at(model, time, &trial, targets, active);
        if residual.norm < norm {
            return Some((trial, residual));
        }
        delta = delta.scaled(R::from_f64(0.5));
    }
    None
}

/// δ, shortened so that no orientation turns further than [`LARGEST_TURN`].
fn limited<R: Real, M: Assemble<R>>(model: &M, delta: M::V) -> M::V {
    let (planar, spatial) = delta.as_slice()[model.layout().linear..].split_at(model.layout().rotations);
    let largest = planar.iter().fold(R::ZERO, |largest, turn| largest.max(turn.abs()));
    let length = |turn: &[R; 3]| turn.iter().fold(R::ZERO, |sum, &entry| sum + entry * entry).sqrt();
    let largest = spatial.as_chunks().0.iter().fold(largest, |largest, turn| largest.max(length(turn)));
    let limit = R::from_f64(LARGEST_TURN);
    if largest > limit { delta.scaled(limit / largest) } else { delta }
}

/// A small turn of every orientation, about no axis in particular: off a right angle, where a sine has no derivative.
fn nudge<R: Real, M: Assemble<R>>(model: &M) -> M::V {
    let mut delta = model.zero_v();
    for (k, entry) in delta.as_mut_slice()[model.layout().linear..].iter_mut().enumerate() {
        *entry = R::from_f64(0.01 + 0.003 * (k % 5) as f64);
    }
    delta
}

/// The norm that a residual may have from rounding alone: constraints are products of at most two coordinates, and
/// couplings sums of counted angles, which may have made many turns.
fn tolerance<R: Real, M: Assemble<R>>(model: &M, q: &M::Q) -> R {
    let counted = q.as_slice().len() - 2 * model.layout().angles.len();
    let (plain, angles) = q.as_slice().split_at(counted);
    let largest = |values: &[R]| values.iter().fold(R::ZERO, |largest, x| largest.max(x.abs()));
    let magnitude = R::ONE + largest(plain);
    let turned = R::from_f64(core::f64::consts::TAU) * largest(angles);
    R::from_f64(32.0) * R::EPSILON * (magnitude * magnitude + turned)
}
