//! Positions that satisfy the constraints: a damped Newton iteration on the group.
//!
//! Moves by [`retract`], so orientations stay on the circle; the linear algebra is `system.rs`. Velocities and
//! accelerations, which are linear, are `rates.rs`.

use super::system::{System, name_unknown, rank_deficient};
use crate::error::AssemblyError;
use crate::layout::retract;
use crate::mechanism::{Assemble, ConditionKind, Mechanism};
use crate::real::Real;
use crate::vector::Vector;

/// Iterations before the search is given up.
const ITERATIONS: u32 = 50;
/// Iterations at the largest turn besides, where counted angles have far to go: some thirty turns.
const FAR: u32 = 400;
/// The largest turn of one iteration, rad: Newton's linear picture of a rotation holds no further.
const LARGEST_TURN: f64 = 0.5;
/// Halvings of a step that does not bring the residual down.
const HALVINGS: u32 = 20;

/// The position near `near` that satisfies the constraints and the conditions `active` (indices into
/// [`Assemble::CONDITIONS`]) at their `targets`.
///
/// Newton's iteration: each step is the least δ (½ δᵀ δ, metres and radians alike) with D̂ δ = −r, at most half a
/// radian, halved until the residual's norm falls. Angles enter r as atan2(sin, cos), so a target may be far away and
/// a joint assembled half a turn off is turned back; angles whose turns the dynamics count enter with their turns. Done at 32 roundings of the coordinates' magnitude.
///
/// # Errors
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
    let mut q = *near;
    let mut residual = Residual::at(model, time, &q, targets, &system.active);
    let (mut iteration, mut far) = (0, 0);
    while iteration < ITERATIONS && far < FAR {
        residual.check_finite::<M>()?;
        if residual.norm <= tolerance::<R, M>(&q) {
            return residual.check_flips::<M>().map(|()| q);
        }
        system.evaluate(time, &q, Some(&residual.divisors));
        let pivot = system.factor_unit();
        if pivot.value < R::BREAKDOWN {
            return Err(rank_deficient::<R, M>(pivot));
        }
        let step = system.least(&M::V::zero(), &residual.rows, &residual.conditions).scaled(-R::ONE);
        let delta = limited::<R, M>(step);
        if delta == step || M::LAYOUT.angles.is_empty() {
            iteration += 1;
        } else {
            far += 1;
        }
        match shorten(model, time, &q, &delta, targets, &system.active, residual.norm) {
            Some((next, next_residual)) => (q, residual) = (next, next_residual),
            None if residual.norm <= R::from_f64(64.0) * tolerance::<R, M>(&q) => {
                return residual.check_flips::<M>().map(|()| q);
            }
            None => return Err(residual.no_convergence::<M>(iteration)),
        }
    }
    if residual.norm <= tolerance::<R, M>(&q) {
        return residual.check_flips::<M>().map(|()| q);
    }
    Err(residual.no_convergence::<M>(iteration + far))
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
    assemble_position(model, time, near, &M::Conditions::zero(), &[])
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
    let mut delta = *delta;
    for _ in 0..=HALVINGS {
        let mut trial = *q;
        retract(&M::LAYOUT, q, &delta, &mut trial);
        let residual = Residual::at(model, time, &trial, targets, active);
        if residual.norm < norm {
            return Some((trial, residual));
        }
        delta = delta.scaled(R::from_f64(0.5));
    }
    None
}

/// δ, shortened so that nothing turns further than [`LARGEST_TURN`].
fn limited<R: Real, M: Assemble<R>>(delta: M::V) -> M::V {
    let turns = &delta.as_slice()[M::LAYOUT.linear..];
    let largest = turns.iter().fold(R::ZERO, |largest, turn| largest.max(turn.abs()));
    let limit = R::from_f64(LARGEST_TURN);
    if largest > limit { delta.scaled(limit / largest) } else { delta }
}

/// What the residual's norm may be from rounding alone: constraints are products of at most two coordinates, and
/// couplings sums of counted angles, which may have made many turns.
fn tolerance<R: Real, M: Assemble<R>>(q: &M::Q) -> R {
    let counted = q.as_slice().len() - 2 * M::LAYOUT.angles.len();
    let (plain, angles) = q.as_slice().split_at(counted);
    let largest = |values: &[R]| values.iter().fold(R::ZERO, |largest, x| largest.max(x.abs()));
    let magnitude = R::ONE + largest(plain);
    let turned = R::from_f64(core::f64::consts::TAU) * largest(angles);
    R::from_f64(32.0) * R::EPSILON * (magnitude * magnitude + turned)
}

/// The residual of the mechanism `M`.
type ResidualOf<R, M> = Residual<R, <M as Mechanism<R>>::Lambda, <M as Assemble<R>>::Conditions>;

/// The residual of all rows at one position.
struct Residual<R, L, C> {
    rows: L,
    conditions: C,
    /// What the rows of D must be divided by: cos Δθ where the residual is Δθ in place of sin Δθ.
    divisors: L,
    norm: R,
}

impl<R: Real, L: Vector<R>, C: Vector<R>> Residual<R, L, C> {
    fn at<M>(model: &M, time: R, q: &M::Q, targets: &C, active: &C) -> Self
    where
        M: Assemble<R, Lambda = L, Conditions = C>,
    {
        let (mut rows, mut cosines, mut divisors) = (L::zero(), L::zero(), L::zero());
        model.constraints(time, q, &mut rows);
        model.row_cosines(time, q, &mut cosines);
        divisors.as_mut_slice().fill(R::ONE);
        for &row in M::FLIPS {
            let (row, cosine) = (row as usize, cosines.as_slice()[row as usize]);
            rows.as_mut_slice()[row] = rows.as_slice()[row].atan2(cosine);
            // At a right angle the derivative of the sine vanishes; a small divisor lets the other rows move on.
            let nonzero = R::from_f64(1e-3);
            divisors.as_mut_slice()[row] = if cosine.abs() < nonzero { nonzero } else { cosine };
        }

        let (mut conditions, mut flipped) = (C::zero(), C::zero());
        model.condition_residual(time, q, targets, &mut conditions);
        model.condition_cosines(time, q, targets, &mut flipped);
        for (i, entry) in conditions.as_mut_slice().iter_mut().enumerate() {
            let held = active.as_slice()[i] != R::ZERO;
            *entry = match M::CONDITIONS[i].kind {
                _ if !held => R::ZERO,
                ConditionKind::Angle => entry.atan2(flipped.as_slice()[i]),
                ConditionKind::Linear => *entry,
            };
        }
        let norm = (rows.norm_squared() + conditions.norm_squared()).sqrt();
        Residual { rows, conditions, divisors, norm }
    }

    fn check_finite<M: Assemble<R>>(&self) -> Result<(), AssemblyError> {
        let in_rows = self.rows.first_not_finite();
        let unknown = in_rows.or_else(|| self.conditions.first_not_finite().map(|i| L::LEN + i));
        match unknown {
            Some(row) => Err(AssemblyError::NonFinite { row: name_unknown::<R, M>(M::V::LEN + row) }),
            None => Ok(()),
        }
    }

    fn check_flips<M: Assemble<R>>(&self) -> Result<(), AssemblyError> {
        match M::FLIPS.iter().find(|&&row| self.divisors.as_slice()[row as usize] < R::ZERO) {
            Some(&row) => Err(AssemblyError::Flipped { row: M::ROWS[row as usize] }),
            None => Ok(()),
        }
    }

    /// The error that names the worst row; a joint stuck on its flipped root is said to be that.
    fn no_convergence<M: Assemble<R>>(&self, iterations: u32) -> AssemblyError {
        let all = self.rows.as_slice().iter().chain(self.conditions.as_slice());
        let (worst, residual) = all.enumerate().fold((0, R::ZERO), |(at, largest), (i, entry)| {
            if entry.abs() > largest { (i, entry.abs()) } else { (at, largest) }
        });
        if M::FLIPS.contains(&(worst as u16)) && self.divisors.as_slice()[worst] < R::ZERO {
            return AssemblyError::Flipped { row: M::ROWS[worst] };
        }
        let row = name_unknown::<R, M>(M::V::LEN + worst);
        AssemblyError::NoConvergence { row, residual: residual.to_f64(), iterations }
    }
}
