//! The same mechanism in other scalars, and how models and states are put into lanes and taken out of them.

use super::Lanes;
use crate::fields::{Fields, Parametric};
use crate::mechanism::{Assemble, Mechanism};
use crate::real::Real;
use crate::state::{State, StateOf};
use crate::vector::{Vector, at, put};
use core::array::from_fn;

/// A mechanism that can be had in any scalars; implemented by every emitted one, in whichever it is named.
///
/// ```text
/// FourBar: InScalars,   <FourBar as InScalars>::In<F64x8> = FourBar<F64x8>
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no mechanism",
    label = "name the type that `mechanism!` made, as in `Batch::<FourBar, _>`"
)]
pub trait InScalars {
    /// The mechanism in the scalars `R`.
    type In<R: Real>: Mechanism<
            R,
            Q: Send + Sync,
            V: Send + Sync,
            Z: Send + Sync,
            Gates: Send + Sync,
            Lambda: Send + Sync,
            Inputs: Fields<R, Array: Send + Sync> + Send + Sync,
            Outputs: Fields<R, Array: Send + Sync> + Send + Sync,
        > + Assemble<R>
        + Parametric<R, Parameters: Send + Sync>
        + Default
        + Clone
        + Send
        + Sync
        + 'static;

    /// The mechanism all of whose numbers are f(a, b).
    fn zip<A: Real, B: Real, C: Real>(
        a: &Self::In<A>,
        b: &Self::In<B>,
        f: &mut impl FnMut(A, B) -> C,
    ) -> Self::In<C>;
}

/// The state of a mechanism in these scalars.
pub type StateIn<M, R> = StateOf<<M as InScalars>::In<R>, R>;
/// The inputs of a mechanism in these scalars.
pub type InputsIn<M, R> = <<M as InScalars>::In<R> as Mechanism<R>>::Inputs;
/// The outputs of a mechanism in these scalars.
pub type OutputsIn<M, R> = <<M as InScalars>::In<R> as Mechanism<R>>::Outputs;
/// The parameters of a mechanism in these scalars.
pub type ParametersIn<M, R> = <<M as InScalars>::In<R> as Parametric<R>>::Parameters;

/// The array of f(a, b).
#[inline(always)]
pub fn zip_arrays<A: Real, B: Real, C: Real, const N: usize>(
    a: &[A; N],
    b: &[B; N],
    f: &mut impl FnMut(A, B) -> C,
) -> [C; N] {
    from_fn(|index| f(at(a, index), at(b, index)))
}

/// The struct whose fields are f(a, b).
pub fn zip_fields<A: Real, B: Real, C: Real, X: Fields<A>, Y: Fields<B>, Z: Fields<C>>(
    a: &X,
    b: &Y,
    f: &mut impl FnMut(A, B) -> C,
) -> Z {
    let (a, b) = (a.to_array(), b.to_array());
    let mut both = Z::Array::zeros(a.as_slice().len());
    for ((to, &a), &b) in both.as_mut_slice().iter_mut().zip(a.as_slice()).zip(b.as_slice()) {
        *to = f(a, b);
    }
    Z::from_array(both)
}

/// The model with these numbers in every lane.
pub(super) fn splat_model<M: InScalars, L: Lanes>(model: &M::In<L::Scalar>) -> M::In<L> {
    M::zip(model, model, &mut |value, _| L::splat(value))
}

/// The model in one lane.
pub(super) fn model_in_lane<M: InScalars, L: Lanes>(models: &M::In<L>, lane: usize) -> M::In<L::Scalar> {
    M::zip(models, models, &mut |values: L, _| values.lane(lane))
}

/// The models with another one in one lane.
pub(super) fn with_model<M: InScalars, L: Lanes>(
    models: &M::In<L>,
    lane: usize,
    model: &M::In<L::Scalar>,
) -> M::In<L> {
    M::zip(models, model, &mut |mut values: L, value| {
        values.set_lane(lane, value);
        values
    })
}

/// Writes a vector into one lane.
pub(super) fn set_vector<L: Lanes, V: Vector<L>, W: Vector<L::Scalar>>(into: &mut V, lane: usize, from: &W) {
    for (into, &from) in into.as_mut_slice().iter_mut().zip(from.as_slice()) {
        into.set_lane(lane, from);
    }
}

/// The vector in one lane.
pub(super) fn vector_in_lane<L: Lanes, V: Vector<L>, W: Vector<L::Scalar>>(of: &V, lane: usize) -> W {
    let mut found = W::zeros(of.as_slice().len());
    for (index, values) in of.as_slice().iter().enumerate() {
        put(found.as_mut_slice(), index, values.lane(lane));
    }
    found
}

/// A state of the mechanism with zeros for all numbers.
pub(super) fn no_state<M: InScalars, L: Lanes>(like: &StateIn<M, L::Scalar>) -> StateIn<M, L> {
    State {
        q: Vector::zeros(like.q.as_slice().len()),
        v: Vector::zeros(like.v.as_slice().len()),
        z: Vector::zeros(like.z.as_slice().len()),
        gates: Vector::zeros(like.gates.as_slice().len()),
    }
}

/// Writes a state into one lane.
pub(super) fn set_state<M: InScalars, L: Lanes>(
    states: &mut StateIn<M, L>,
    lane: usize,
    state: &StateIn<M, L::Scalar>,
) {
    set_vector(&mut states.q, lane, &state.q);
    set_vector(&mut states.v, lane, &state.v);
    set_vector(&mut states.z, lane, &state.z);
    set_vector(&mut states.gates, lane, &state.gates);
}

/// The state in one lane.
pub fn state_in_lane<M: InScalars, L: Lanes>(states: &StateIn<M, L>, lane: usize) -> StateIn<M, L::Scalar> {
    State {
        q: vector_in_lane(&states.q, lane),
        v: vector_in_lane(&states.v, lane),
        z: vector_in_lane(&states.z, lane),
        gates: vector_in_lane(&states.gates, lane),
    }
}

/// The struct with those of this function in its lanes, such as the inputs of each mechanism.
pub fn gather_fields<L: Lanes, X: Fields<L>, Y: Fields<L::Scalar>>(mut of: impl FnMut(usize) -> Y) -> X {
    let first = of(0).to_array();
    let mut all = X::Array::zeros(first.as_slice().len());
    set_vector(&mut all, 0, &first);
    for lane in 1..L::LANES {
        set_vector(&mut all, lane, &of(lane).to_array());
    }
    X::from_array(all)
}

/// The struct in one lane.
pub fn fields_in_lane<L: Lanes, X: Fields<L>, Y: Fields<L::Scalar>>(of: &X, lane: usize) -> Y {
    Y::from_array(vector_in_lane(&of.to_array(), lane))
}
