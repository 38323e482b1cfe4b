//! Where inputs come from: nowhere, held over a step, or sampled at every stage.
//!
//! The type of the source says which, so a step never asks. When a source is called is decided in `simulation.rs`.

use crate::mechanism::Mechanism;
use crate::real::Real;
use crate::state::{State, StateOf};
use core::marker::PhantomData;

/// A source of a mechanism's inputs.
pub trait InputSource<R: Real, M: Mechanism<R>> {
    /// Whether the value at a step's start is kept for all its stages.
    const HELD: bool;

    /// The inputs at `time` (s) and `state`.
    fn sample(&mut self, time: R, state: &StateOf<M, R>) -> M::Inputs;
}

/// Inputs that can be left out: only `()`, those of a mechanism without inputs.
#[diagnostic::on_unimplemented(
    message = "this mechanism has inputs that were not given",
    label = "its inputs are `{Self}`",
    note = "add `.inputs(Sampled(|time, state| …))` for values at every stage, or `.inputs(Held(|time, state| …))` \
            for one value a step, or `.constant(inputs)`, before stepping the simulation"
)]
pub trait NoneNeeded {
    /// The value that says nothing.
    const NONE: Self;
}

impl NoneNeeded for () {
    const NONE: Self = ();
}

/// The source for mechanisms without inputs, and what every simulation starts with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NoInputs;

impl<R: Real, M: Mechanism<R>> InputSource<R, M> for NoInputs
where
    M::Inputs: NoneNeeded,
{
    const HELD: bool = true;

    #[inline]
    fn sample(&mut self, _time: R, _state: &StateOf<M, R>) -> M::Inputs {
        M::Inputs::NONE
    }
}

/// When a [`HeldOrSampled`] is asked.
pub trait When {
    /// Whether the value at a step's start is kept for all its stages.
    const HELD: bool;
}

/// Once a step: see [`Held`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OnceAStep;

/// At every stage: see [`Sampled`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AtStages;

impl When for OnceAStep {
    const HELD: bool = true;
}

impl When for AtStages {
    const HELD: bool = false;
}

/// A function of time and state as the source of inputs; made by [`Held`] or [`Sampled`].
#[derive(Clone, Copy, Debug)]
pub struct HeldOrSampled<W, F> {
    function: F,
    when: PhantomData<W>,
}

/// Inputs that never change; made by [`Simulation::constant`](crate::simulation::Simulation::constant).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constant<U>(pub U);

impl<R: Real, M: Mechanism<R>> InputSource<R, M> for Constant<M::Inputs> {
    const HELD: bool = true;

    #[inline]
    fn sample(&mut self, _time: R, _state: &StateOf<M, R>) -> M::Inputs {
        self.0.clone()
    }
}

/// Inputs from a function that is called once a step, at its start, as a digital controller does.
///
/// The bound makes the closure valid for every lifetime of the state. Where its body needs to know a type at once
/// (a method of `time`, a field of `state`), write `|time: f64, state: &…|`, or use
/// [`Simulation::held`](crate::simulation::Simulation::held), which knows them.
// Spelled like the type it stands for.
#[allow(non_snake_case)]
pub fn Held<R, Q, V, Z, G, U, F: FnMut(R, &State<Q, V, Z, G>) -> U>(
    function: F,
) -> HeldOrSampled<OnceAStep, F> {
    HeldOrSampled { function, when: PhantomData }
}

/// Inputs from a function that is called at every stage of the integrator, as a physical law acts.
///
/// Types are inferred as said at [`Held`]; [`Simulation::sampled`](crate::simulation::Simulation::sampled) knows them.
#[allow(non_snake_case)]
pub fn Sampled<R, Q, V, Z, G, U, F: FnMut(R, &State<Q, V, Z, G>) -> U>(
    function: F,
) -> HeldOrSampled<AtStages, F> {
    HeldOrSampled { function, when: PhantomData }
}

impl<R: Real, M: Mechanism<R>, W: When, F> InputSource<R, M> for HeldOrSampled<W, F>
where
    F: FnMut(R, &StateOf<M, R>) -> M::Inputs,
{
    const HELD: bool = W::HELD;

    #[inline]
    fn sample(&mut self, time: R, state: &StateOf<M, R>) -> M::Inputs {
        (self.function)(time, state)
    }
}
