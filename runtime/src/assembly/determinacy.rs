//! Whether the constraints and what is held determine the motion: the rank of D̂, by a scale that does not vanish with its rows.
//!
//! With the velocities scaled so that the largest entry of each column of D̂ is one, and each row divided by the largest norm that
//! it has at this position and at a few that are turned from it, the last pivots of D̂ D̂ᵀ go like the square of the distance from
//! a singular position. An error of rounding in the position is divided by that distance, and so is what it makes of the velocities:
//! of these about ε/pivot is noise.

use super::system::{System, rank_deficient};
use crate::error::AssemblyError;
use crate::layout::retract;
use crate::ldl::Pivot;
use crate::mechanism::Assemble;
use crate::real::Real;
use crate::vector::Vector;

/// An error where the rates of the conditions `active` do not determine the velocities, or accelerations, to half of their digits.
/// Where nothing moves (`largest` is zero), or nothing is held, that is no matter.
pub(super) fn check_determined<R: Real, M: Assemble<R>>(
    model: &M,
    time: R,
    q: &M::Q,
    active: &[u16],
    largest: R,
) -> Result<(), AssemblyError> {
    if active.is_empty() || largest == R::ZERO {
        return Ok(());
    }
    let mut system = System::new(model, active)?;
    let smallest = smallest_pivot(&mut system, time, q);
    // Written so that a NaN fails.
    if R::any(smallest.value.greater_equal(R::EPSILON.sqrt())) {
        return Ok(());
    }
    Err(rank_deficient(model, smallest))
}

/// The smallest pivot of the rows of D̂, each scaled by its largest norm.
fn smallest_pivot<R: Real, M: Assemble<R>>(system: &mut System<'_, R, M>, time: R, q: &M::Q) -> Pivot<R> {
    let model = system.model;
    // W, the squares of the largest entries of the columns; then the squared norms of the rows by it.
    let (mut weights, mut norms) = (model.zero_v(), model.zero_system());
    for part in (0..3).rev() {
        system.evaluate(time, &turned(model, q, part), None);
        system.each_entry(|_, column, entry| {
            if let Some(weight) = weights.as_mut_slice().get_mut(column) {
                *weight = weight.max(entry * entry);
            }
        });
    }
    for weight in weights.as_mut_slice() {
        *weight = if *weight > R::ZERO { *weight } else { R::ONE };
    }
    for part in (0..3).rev() {
        let mut own = model.zero_system();
        system.evaluate(time, &turned(model, q, part), None);
        system.each_entry(|row, column, entry| {
            let weight = weights.as_slice().get(column).copied().unwrap_or(R::ONE);
            if let Some(norm) = own.as_mut_slice().get_mut(row) {
                *norm = *norm + entry * entry / weight;
            }
        });
        for (norm, &own) in norms.as_mut_slice().iter_mut().zip(own.as_slice()) {
            *norm = norm.max(own);
        }
    }
    // The last evaluation was at q itself.
    let mut pivots = model.zero_system();
    system.factor_weighted(&weights, &mut pivots);
    let mut smallest = Pivot { value: R::ONE, unknown: model.velocity_count() };
    let rows = pivots.as_slice().iter().enumerate().skip(model.velocity_count()).zip(norms.as_slice());
    for ((unknown, pivot), &norm) in rows {
        // Rows that take no part have no entries; behind a pivot of zero nothing is a number.
        let relative = pivot.abs() / norm;
        let relative = if relative.is_finite() { relative } else { R::ZERO };
        if norm > R::ZERO && relative < smallest.value {
            smallest = Pivot { value: relative, unknown };
        }
    }
    smallest
}

/// `q` with every orientation turned a little, about no axis in particular; for `part` = 0 as it is.
pub(crate) fn turned<R: Real, M: Assemble<R>>(model: &M, q: &M::Q, part: u8) -> M::Q {
    let mut delta = model.zero_v();
    for (k, entry) in delta.as_mut_slice().iter_mut().enumerate().skip(model.layout().linear) {
        *entry = R::from_f64(f64::from(part) * (0.4 + 0.1 * (k % 4) as f64));
    }
    let mut turned = q.clone();
    retract(model.layout(), q, &delta, &mut turned);
    turned
}
