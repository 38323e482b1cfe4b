//! v̇ and λ by independent velocities where these are written out and serve, by multipliers elsewhere.
//!
//! Both solve the same equations, so that accelerations do not jump where one gives way to the other: they differ by rounding, divided
//! by a hundredth.

use super::PivotOf;
use crate::mechanism::Mechanism;
use crate::partition::{serves, serving};
use crate::real::Real;
use crate::state::StateOf;
use crate::vector::{Vector, blend};

#[inline(always)]
pub(super) fn pivot_of<R: Real, M: Mechanism<R>>(model: &M) -> PivotOf {
    if model.null_space_first() { PivotOf::JacobianOrRows } else { PivotOf::Rows }
}

/// Without stabilisation; returns the pivot of the way that was taken.
#[inline(always)]
pub(crate) fn acceleration<R: Real, M: Mechanism<R>>(
    model: &M,
    time: R,
    state: &StateOf<M, R>,
    u: &M::Inputs,
    a: &mut M::V,
    lambda: &mut M::Lambda,
) -> R {
    if !model.null_space_first() {
        return model.acceleration(time, state, u, a, lambda);
    }
    let pivot = model.null_space(time, state, u, a, lambda);
    if serves(pivot) { pivot } else { elsewhere(model, time, state, u, pivot, a, lambda) }
}

/// With Baumgarte's terms.
#[inline(always)]
pub(crate) fn stabilised<R: Real, M: Mechanism<R>>(
    model: &M,
    time: R,
    state: &StateOf<M, R>,
    u: &M::Inputs,
    terms: [R; 2],
    a: &mut M::V,
    lambda: &mut M::Lambda,
) -> R {
    let [two_alpha, beta_squared] = terms;
    if !model.null_space_first() {
        return model.acceleration_baumgarte(time, state, u, two_alpha, beta_squared, a, lambda);
    }
    let pivot = model.null_space_baumgarte(time, state, u, two_alpha, beta_squared, a, lambda);
    if serves(pivot) { pivot } else { stabilised_elsewhere(model, time, state, u, terms, pivot, a, lambda) }
}

// Functions of their own with plain arguments: where they are called from, nothing is gathered for what is rare.

#[cold]
#[inline(never)]
fn elsewhere<R: Real, M: Mechanism<R>>(
    model: &M,
    time: R,
    state: &StateOf<M, R>,
    u: &M::Inputs,
    pivot: R,
    a: &mut M::V,
    lambda: &mut M::Lambda,
) -> R {
    where_others_fail(pivot, a, lambda, |a, lambda| model.acceleration(time, state, u, a, lambda))
}

#[cold]
#[inline(never)]
#[allow(clippy::too_many_arguments)]
fn stabilised_elsewhere<R: Real, M: Mechanism<R>>(
    model: &M,
    time: R,
    state: &StateOf<M, R>,
    u: &M::Inputs,
    [two_alpha, beta_squared]: [R; 2],
    pivot: R,
    a: &mut M::V,
    lambda: &mut M::Lambda,
) -> R {
    where_others_fail(pivot, a, lambda, |a, lambda| {
        model.acceleration_baumgarte(time, state, u, two_alpha, beta_squared, a, lambda)
    })
}

/// By multipliers, in the lanes where independent velocities, of which this is the pivot, do not serve.
#[inline(always)]
fn where_others_fail<R: Real, V: Vector<R>, L: Vector<R>>(
    pivot: R,
    a: &mut V,
    lambda: &mut L,
    by_multipliers: impl FnOnce(&mut V, &mut L) -> R,
) -> R {
    if R::LANES == 1 {
        return by_multipliers(a, lambda);
    }
    let (kept, found) = ((a.clone(), lambda.clone()), serving(pivot));
    let other = by_multipliers(a, lambda);
    blend(found, &kept.0, a);
    blend(found, &kept.1, lambda);
    R::select(found, pivot, other)
}
