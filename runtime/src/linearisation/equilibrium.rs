//! Static positions under loads: Newton's iteration on the exact tangent, on the group.

use super::lu::Lu;
use crate::error::{AssemblyError, LinearisationError};
use crate::layout::{normalised, retract};
use crate::mechanism::Row;
use crate::real::Real;
use crate::tangent::Tangent;
use crate::vector::Vector;

/// Iterations before the search is given up.
const ITERATIONS: u32 = 100;
/// The largest turn of one orientation in one iteration, rad: Newton's linear picture of a rotation holds no further.
const LARGEST_TURN: f64 = 0.5;
/// Halvings of a step that does not bring the next one down.
const HALVINGS: u32 = 30;

/// A static position and what holds it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Equilibrium<Q, L> {
    /// Positions, shape n_q.
    pub q: Q,
    /// Multipliers, shape m; the force of the constraints is −Dᵀ λ.
    pub lambda: L,
    /// Newton's iterations made.
    pub iterations: u32,
}

/// The static position near `near`, stable or not, under the inputs `u` and the loads at `time`: r = 0 and Φ = 0 at v = 0 and
/// a = 0, unknown q and λ.
///
/// ```text
/// ⎡ ∂r/∂q  Dᵀ ⎤ ⎡ δq ⎤     ⎡ r ⎤
/// ⎣ D      0  ⎦ ⎣ δλ ⎦ = − ⎣ Φ ⎦ ,   q ← q ⊕ t δq, λ ← λ + t δλ
/// ```
/// with the largest t of 1, ½, ¼ … for which the step that the same matrix would make next is shorter (Deuflhard, *Newton Methods
/// for Nonlinear Problems*, 3.3, the natural monotonicity test: it does not depend on how rows are scaled), and no orientation
/// turning further than half a radian. λ begins with that of the motion from rest. Rows that depend on time are taken at
/// `time`; in tree coordinates the inertia of bodies on places that move with time is among the loads. Pairs and quaternions of
/// `near` need not have length 1.
///
/// The dense matrix has (n_v + m)² entries, which lie on the stack.
///
/// # Errors
/// [`Indifferent`](LinearisationError::Indifferent) where the matrix is singular: nothing decides about a coordinate, or rows
/// repeat each other; [`NoEquilibrium`](LinearisationError::NoEquilibrium),
/// [`NonFinite`](LinearisationError::NonFinite), [`Assembly`](LinearisationError::Assembly) for an orientation without
/// direction.
pub fn equilibrium<R: Real, M: Tangent<R>>(
    model: &M,
    time: R,
    near: &M::Q,
    u: &M::Inputs,
) -> Result<Equilibrium<M::Q, M::Lambda>, LinearisationError> {
    let mut q = normalised(&M::LAYOUT, near).map_err(|(first, length)| {
        let what = M::POSITION_NAMES.get(first).copied().unwrap_or(M::NAME);
        LinearisationError::Assembly(AssemblyError::NoOrientation { what, length: length.to_f64() })
    })?;
    let mut lambda = multipliers_at_rest(model, time, &q, u);
    let (mut entries, mut order) = (M::Bordered::zero(), M::order());
    let (mut rows, mut columns) = (M::Unknowns::zero(), M::Unknowns::zero());
    for iteration in 0..ITERATIONS {
        let residual = residual(model, time, &q, u, &lambda);
        if let Some(unknown) = residual.first_not_finite() {
            let what = name::<R, M>(unknown).of;
            return Err(LinearisationError::NonFinite { time: time.to_f64(), what });
        }
        fill(model, time, &q, u, &lambda, entries.as_mut_slice());
        let mut lu = Lu {
            entries: entries.as_mut_slice(),
            rows: rows.as_mut_slice(),
            columns: columns.as_mut_slice(),
            order: order.as_mut(),
        };
        lu.factor().map_err(|found| LinearisationError::Indifferent {
            time: time.to_f64(),
            row: name::<R, M>(found.unknown),
            pivot: found.pivot.to_f64(),
            iterations: iteration,
        })?;
        let mut step = residual.scaled(-R::ONE);
        let norm = lu.solve(step.as_mut_slice());
        let (dq, dl) = parts::<R, M>(&step);
        let moved = dq.max_abs();
        if moved <= R::from_f64(64.0) * R::EPSILON * (R::ONE + q.max_abs()) {
            let (q, lambda) = further::<R, M>(&q, &lambda, &dq, &dl, R::ONE);
            return Ok(Equilibrium { q, lambda, iterations: iteration + 1 });
        }
        let next = shorten(model, time, u, (&q, &lambda), (&dq, &dl), |residual: &mut M::Unknowns, t| {
            // Written so that a NaN fails.
            lu.solve(residual.as_mut_slice()) <= (R::ONE - R::from_f64(0.25) * t) * norm
        });
        match next {
            Some(next) => (q, lambda) = next,
            // What is left is rounding.
            None if moved <= R::from_f64(0.01) * R::EPSILON.sqrt() * (R::ONE + q.max_abs()) => {
                return Ok(Equilibrium { q, lambda, iterations: iteration + 1 });
            }
            None => return Err(no_equilibrium::<R, M>(time, &residual, iteration + 1)),
        }
    }
    Err(no_equilibrium::<R, M>(time, &residual(model, time, &q, u, &lambda), ITERATIONS))
}

/// λ of the motion from rest, zero where there is none.
fn multipliers_at_rest<R: Real, M: Tangent<R>>(model: &M, time: R, q: &M::Q, u: &M::Inputs) -> M::Lambda {
    let (mut a, mut lambda) = (M::V::zero(), M::Lambda::zero());
    let pivot = model.acceleration(time, q, &M::V::zero(), u, &mut a, &mut lambda);
    let sound = R::any(pivot.greater_equal(R::BREAKDOWN)) && lambda.first_not_finite().is_none();
    if sound { lambda } else { M::Lambda::zero() }
}

/// (r, Φ) at rest; of a row that repeats others its multiplier, which is to be zero.
fn residual<R: Real, M: Tangent<R>>(
    model: &M,
    time: R,
    q: &M::Q,
    u: &M::Inputs,
    lambda: &M::Lambda,
) -> M::Unknowns {
    let rest = M::V::zero();
    let (mut forces, mut phi) = (M::V::zero(), M::Lambda::zero());
    model.residual(time, q, &rest, u, &rest, lambda, &mut forces);
    model.constraints(time, q, &mut phi);
    for &row in M::IDLE {
        phi.as_mut_slice()[row as usize] = lambda.as_slice()[row as usize];
    }
    let mut residual = M::Unknowns::zero();
    let (to_forces, to_rows) = residual.as_mut_slice().split_at_mut(M::V::LEN);
    to_forces.copy_from_slice(forces.as_slice());
    to_rows.copy_from_slice(phi.as_slice());
    residual
}

/// \[∂r/∂q, Dᵀ; D, 0\], row by row.
fn fill<R: Real, M: Tangent<R>>(
    model: &M,
    time: R,
    q: &M::Q,
    u: &M::Inputs,
    lambda: &M::Lambda,
    entries: &mut [R],
) {
    let rest = M::V::zero();
    let (mut stiffness, mut damping) = (M::Stiffness::zero(), M::Damping::zero());
    let mut jacobian = M::Jacobian::zero();
    model.tangent(time, q, &rest, u, &rest, lambda, &mut stiffness, &mut damping);
    model.constraint_jacobian(time, q, &mut jacobian);
    let (n, size) = (M::V::LEN, M::Unknowns::LEN);
    entries.fill(R::ZERO);
    for (&entry, &(row, column)) in stiffness.as_slice().iter().zip(M::STIFFNESS_PATTERN) {
        entries[row as usize * size + column as usize] = entry;
    }
    for (&entry, &(row, column)) in jacobian.as_slice().iter().zip(M::JACOBIAN_PATTERN) {
        let (unknown, column, idle) = (n + row as usize, column as usize, M::IDLE.contains(&row));
        entries[column * size + unknown] = entry;
        entries[unknown * size + column] = if idle { R::ZERO } else { entry };
    }
    for &row in M::IDLE {
        let unknown = n + row as usize;
        entries[unknown * size + unknown] = R::ONE;
    }
}

/// δq and δλ.
fn parts<R: Real, M: Tangent<R>>(step: &M::Unknowns) -> (M::V, M::Lambda) {
    let (mut dq, mut dl) = (M::V::zero(), M::Lambda::zero());
    let (positions, multipliers) = step.as_slice().split_at(M::V::LEN);
    dq.as_mut_slice().copy_from_slice(positions);
    dl.as_mut_slice().copy_from_slice(multipliers);
    (dq, dl)
}

/// (q ⊕ t δq, λ + t δλ).
fn further<R: Real, M: Tangent<R>>(
    q: &M::Q,
    lambda: &M::Lambda,
    dq: &M::V,
    dl: &M::Lambda,
    t: R,
) -> (M::Q, M::Lambda) {
    let mut moved = *q;
    retract(&M::LAYOUT, q, &dq.scaled(t), &mut moved);
    (moved, lambda.plus(t, dl))
}

/// The first of the steps t, t/2, t/4 … that is accepted; t turns nothing further than [`LARGEST_TURN`].
fn shorten<R: Real, M: Tangent<R>>(
    model: &M,
    time: R,
    u: &M::Inputs,
    (q, lambda): (&M::Q, &M::Lambda),
    (dq, dl): (&M::V, &M::Lambda),
    mut accepted: impl FnMut(&mut M::Unknowns, R) -> bool,
) -> Option<(M::Q, M::Lambda)> {
    let turns = &dq.as_slice()[M::LAYOUT.linear..];
    let largest = turns.iter().fold(R::ZERO, |largest, turn| largest.max(turn.abs()));
    let limit = R::from_f64(LARGEST_TURN);
    let mut t = if largest > limit { limit / largest } else { R::ONE };
    for _ in 0..=HALVINGS {
        let (q, lambda) = further::<R, M>(q, lambda, dq, dl, t);
        let mut residual = residual(model, time, &q, u, &lambda);
        if accepted(&mut residual, t) {
            return Some((q, lambda));
        }
        t = t * R::from_f64(0.5);
    }
    None
}

/// The name of an unknown, or of the equation of the same number.
fn name<R: Real, M: Tangent<R>>(unknown: usize) -> Row {
    match M::VELOCITY_NAMES.get(unknown) {
        Some(&of) => Row { of, what: "coordinate" },
        None => M::ROWS.get(unknown - M::V::LEN).copied().unwrap_or(Row { of: M::NAME, what: "unknown" }),
    }
}

/// The largest force, or where forces balance the largest residual of a row.
#[cold]
fn no_equilibrium<R: Real, M: Tangent<R>>(
    time: R,
    residual: &M::Unknowns,
    iterations: u32,
) -> LinearisationError {
    let (forces, rows) = residual.as_slice().split_at(M::V::LEN);
    let largest = |values: &[R]| {
        let entries = values.iter().enumerate();
        entries.fold(
            (0, R::ZERO),
            |best, (at, entry)| if entry.abs() > best.1 { (at, entry.abs()) } else { best },
        )
    };
    let (force, row) = (largest(forces), largest(rows));
    let (unknown, residual) = if force.1 >= row.1 { force } else { (M::V::LEN + row.0, row.1) };
    LinearisationError::NoEquilibrium {
        time: time.to_f64(),
        row: name::<R, M>(unknown),
        residual: residual.to_f64(),
        iterations,
    }
}
