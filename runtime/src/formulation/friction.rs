//! Friction that follows from reactions, where it is not written out: M v̇ + Dᵀ λ = Q + Q_f(v̇, λ) by linear solutions, one after the other.
//!
//! Each takes the friction of the one before. What is left shrinks by the contraction that the compiler estimates, a tenth to a third in
//! usual pins; where that is above one there may be no solution, and the evaluation says so by its residual.

use super::Evaluation;
use crate::mechanism::Mechanism;
use crate::real::Real;
use crate::state::StateOf;
use crate::vector::{Vector, at, put};

/// The most linear solutions.
const MOST: u32 = 64;

/// Solves by `solve`, which is given right-hand sides of the velocities; what `evaluation` says of a linear solution is kept.
#[allow(clippy::too_many_arguments)]
pub(crate) fn with_friction<R: Real, M: Mechanism<R>>(
    model: &M,
    time: R,
    state: &StateOf<M, R>,
    u: &M::Inputs,
    forces: &M::V,
    a: &mut M::V,
    lambda: &mut M::Lambda,
    mut solve: impl FnMut(&M::V, &mut M::V, &mut M::Lambda) -> Evaluation<R>,
) -> Evaluation<R> {
    let mut evaluation = solve(forces, a, lambda);
    if !model.rubs() {
        return evaluation;
    }
    let tolerance = R::from_f64(4.0) * R::EPSILON;
    for _ in 0..MOST {
        let mut friction = model.zero_v();
        model.friction_forces(time, state, u, a, lambda, &mut friction);
        let before = a.clone();
        let found = solve(&forces.plus(R::ONE, &friction), a, lambda);
        let (change, size) = (a.plus(-R::ONE, &before).max_abs(), a.max_abs());
        evaluation.iterations += 1 + found.iterations;
        evaluation.pivot = found.pivot;
        evaluation.residual = if size > R::ZERO { change / size } else { R::ZERO };
        // Written so that a NaN ends it.
        if !R::any(evaluation.residual.greater(tolerance)) {
            break;
        }
    }
    evaluation
}

/// Q, and Q_f of the accelerations that belong to the state.
pub(crate) fn applied<R: Real, M: Mechanism<R>>(
    model: &M,
    time: R,
    state: &StateOf<M, R>,
    u: &M::Inputs,
    forces: &mut M::V,
) {
    model.forces(time, state, u, forces);
    if model.rubs() {
        let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
        let mut friction = model.zero_v();
        model.acceleration(time, state, u, &mut a, &mut lambda);
        model.friction_forces(time, state, u, &a, &lambda, &mut friction);
        forces.axpy(R::ONE, &friction);
    }
}

/// How far v̇ and λ are from what friction asks: the largest entry of M v̇ + Dᵀ λ − Q − Q_f(v̇, λ) beyond rounding, relative to the largest
/// of Q_f. Zero where nothing rubs.
#[cold]
#[inline(never)]
pub(crate) fn unexplained<R: Real, M: Mechanism<R>>(
    model: &M,
    time: R,
    state: &StateOf<M, R>,
    u: &M::Inputs,
    a: &M::V,
    lambda: &M::Lambda,
) -> R {
    let (mut rest, mut friction) = (model.zero_v(), model.zero_v());
    model.forces(time, state, u, &mut rest);
    model.friction_forces(time, state, u, a, lambda, &mut friction);
    let size = friction.max_abs();
    rest.axpy(R::ONE, &friction);
    let mut terms = rest.clone();
    terms.as_mut_slice().iter_mut().for_each(|entry| *entry = entry.abs());
    let mut take = |k: usize, product: R| {
        let (r, t) = (rest.as_mut_slice(), terms.as_mut_slice());
        put(r, k, at(r, k) - product);
        put(t, k, at(t, k) + product.abs());
    };
    let (mut mass, mut jacobian) = (model.zero_mass(), model.zero_jacobian());
    model.mass_matrix(time, &state.q, &mut mass);
    model.constraint_jacobian(time, &state.q, &mut jacobian);
    for (&entry, &(i, j)) in mass.as_slice().iter().zip(model.mass_pattern()) {
        let (i, j) = (usize::from(i), usize::from(j));
        take(i, entry * at(a.as_slice(), j));
        if i != j {
            take(j, entry * at(a.as_slice(), i));
        }
    }
    for (&entry, &(row, column)) in jacobian.as_slice().iter().zip(model.jacobian_pattern()) {
        take(usize::from(column), entry * at(lambda.as_slice(), usize::from(row)));
    }
    let rounding = R::from_f64(64.0) * R::EPSILON;
    let off = rest
        .as_slice()
        .iter()
        .zip(terms.as_slice())
        .fold(R::ZERO, |most, (rest, terms)| most.max((rest.abs() - rounding * *terms).max(R::ZERO)));
    if size > R::ZERO { off / size } else { R::ZERO }
}
