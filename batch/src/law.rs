//! The inputs of the members in each step.

use linkwright::lanes::{InScalars, InputsIn, StateIn, gather_fields};
use linkwright::{Fields, Lanes, Mechanism, Real, Vector};
use std::marker::PhantomData;

/// The members that stand in one register, before a step.
#[derive(Clone, Copy, Debug)]
pub struct Group<'g, M: InScalars, L: Lanes> {
    /// The index of the member in the first lane.
    pub first: usize,
    /// How many members the batch has: lanes beyond the last are empty.
    pub len: usize,
    /// The models.
    pub models: &'g M::In<L>,
    /// The times, s.
    pub times: L,
    /// The states.
    pub states: &'g StateIn<M, L>,
}

impl<M: InScalars, L: Lanes> Group<'_, M, L> {
    /// The member in a lane; that of an empty lane is the last one.
    pub fn member(&self, lane: usize) -> usize {
        (self.first + lane).min(self.len - 1)
    }
}

/// The inputs of each member, held over a step, as a function of what stands in the group before it.
///
/// `()` for mechanisms without inputs, [`Constant`], [`PerMember`], [`Each`], and, without leaving the lanes, [`InLanesOf`].
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not say what the inputs are",
    label = "write `&()` for a mechanism without inputs, `&Constant(inputs)`, `&PerMember(&inputs)` or `&Each(|member, time, state| inputs)`"
)]
pub trait Law<M: InScalars, L: Lanes>: Sync {
    /// The inputs in each lane.
    fn inputs(&self, group: &Group<'_, M, L>) -> InputsIn<M, L>;
}

impl<M: InScalars<In<L>: Mechanism<L, Inputs = ()>>, L: Lanes> Law<M, L> for () {
    fn inputs(&self, _group: &Group<'_, M, L>) -> InputsIn<M, L> {}
}

/// The same inputs for all members at all times.
#[derive(Clone, Copy, Debug)]
pub struct Constant<U>(
    /// The inputs.
    pub U,
);

impl<M: InScalars, L: Lanes> Law<M, L> for Constant<InputsIn<M, L::Scalar>> {
    fn inputs(&self, _group: &Group<'_, M, L>) -> InputsIn<M, L> {
        gather_fields(|_| self.0.clone())
    }
}

/// Inputs of its own for each member, at all times.
#[derive(Clone, Copy, Debug)]
pub struct PerMember<'u, U>(
    /// One for each member. Members beyond the end have none, and fail.
    pub &'u [U],
);

impl<M: InScalars, L: Lanes> Law<M, L> for PerMember<'_, InputsIn<M, L::Scalar>> {
    fn inputs(&self, group: &Group<'_, M, L>) -> InputsIn<M, L> {
        gather_fields(|lane| {
            let given = self.0.get(group.member(lane)).cloned();
            given.unwrap_or_else(none::<InputsIn<M, L::Scalar>, L::Scalar>)
        })
    }
}

/// Inputs that are no numbers, which a step refuses.
fn none<U: Fields<R>, R: Real>() -> U {
    let mut values = U::Array::zeros(U::NAMES.len());
    values.as_mut_slice().fill(R::from_f64(f64::NAN));
    U::from_array(values)
}

/// A function of member, time (s) and state.
#[derive(Clone, Copy, Debug)]
pub struct Each<F>(
    /// The function.
    pub F,
);

impl<M: InScalars, L: Lanes, F> Law<M, L> for Each<F>
where
    F: Fn(usize, L::Scalar, &StateIn<M, L::Scalar>) -> InputsIn<M, L::Scalar> + Sync,
{
    fn inputs(&self, group: &Group<'_, M, L>) -> InputsIn<M, L> {
        gather_fields(|lane| {
            let state = linkwright::lanes::state_in_lane::<M, L>(group.states, lane);
            (self.0)(group.member(lane), group.times.lane(lane), &state)
        })
    }
}

/// A function of the group that computes in lanes.
#[derive(Clone, Copy, Debug)]
pub struct InLanesOf<L, F>(F, PhantomData<fn() -> L>);

impl<L: Real, F> InLanesOf<L, F> {
    /// The law of this function.
    pub const fn new(function: F) -> Self {
        InLanesOf(function, PhantomData)
    }
}

impl<M: InScalars, L: Lanes, F> Law<M, L> for InLanesOf<L, F>
where
    F: Fn(&Group<'_, M, L>) -> InputsIn<M, L> + Sync,
{
    fn inputs(&self, group: &Group<'_, M, L>) -> InputsIn<M, L> {
        (self.0)(group)
    }
}
