//! A mechanism in a control loop: owned, plain data, one call a tick.
//!
//! A [`Stepper`] has a model, a state and a method, and takes the inputs as values. It is `'static` and `Send`, borrows nothing and knows
//! no closure, so that it can stand in a `static`, in a struct, behind a C interface. What a step does is `method.rs`, its stages are
//! `stages.rs`, states that outlive the program `saved.rs`, errors `error/stepper.rs`. Runs, events, samples and the diagnosis of what
//! goes wrong are [`Simulation`](crate::Simulation)'s.

mod method;
mod saved;
#[cfg(feature = "serde")]
mod saved_serde;
mod stages;

pub use method::StepMethod;
pub use saved::{Saved, SavedOf};

use crate::assembly::AssembleExt;
use crate::clock::{Clock, least_step};
use crate::condition::watched;
use crate::error::{AssemblyError, SettingError, StepError};
use crate::fields::{Fields, Parametric};
use crate::formulation::Formulation;
use crate::integrator::{FixedStep, Rk4};
use crate::layout::{first_not_unit, normalised};
use crate::mechanism::{Assemble, Mechanism};
use crate::real::Real;
use crate::simulation::{NearSingular, Residual, name_singularity};
use crate::state::{State, StateOf};
use crate::vector::Vector;
use core::fmt::{self, Debug, Formatter};
use stages::Stages;

/// How far a row may be off at the end of a step, as a turn (rad) or as what makes as much of a length.
const OFF: f64 = 0.1;

/// A state that was given may have orientations whose squared length is this far from one; they are brought to one.
const UNIT: f64 = 1e-3;

/// A mechanism that is moved by the inputs of each tick.
///
/// ```text
/// let model = Arm::default();
/// let mut plant = model.stepper(model.start(), Rk4);       // or (Rk4, NullSpace), (SemiImplicitEuler, Baumgarte { … })
/// loop {
///     let inputs = ArmInputs { torque: controller(plant.state()) };
///     if let Err(error) = plant.step(&inputs, 1e-3) { … }    // the state stays the last good one
/// }
/// ```
/// The inputs are held over the step. Positions and velocities are brought towards the constraints by the method, whatever they are
/// off, and a stage at a singular position takes the accelerations of a position further along, so that nothing stops a
/// running plant but what [`StepError`] says. A step allocates nothing, does not recurse, and links no text; only what is called is
/// linked.
pub struct Stepper<M, S = Rk4, R = f64>
where
    R: Real,
    M: Mechanism<R>,
    S: StepMethod<R, M>,
{
    model: M,
    method: S,
    clock: Clock<R>,
    state: StateOf<M, R>,
    /// What the formulation remembers, from the first step on.
    memory: Option<MemoryOf<M, S, R>>,
    /// The outputs last asked for, whose angles the next ones continue.
    outputs: Option<M::Outputs>,
}

type MemoryOf<M, S, R> = <<S as StepMethod<R, M>>::Formulation as Formulation<R, M>>::Memory;

/// What happened in a step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Tick<R = f64> {
    /// The time at its end, s: the exact sum of the steps, rounded once.
    pub time: R,
    /// The smallest relative pivot of its stages: one is well posed, zero a breakdown that was stepped over. Small ones say that a
    /// singular position is near; [`near_singular`](Stepper::near_singular) says which.
    pub pivot: R,
    /// How far the correction moved a coordinate at most, m or rad.
    pub moved: R,
    /// Stages that broke down and were stepped over.
    pub stepped_over: u32,
}

impl<M, S, R> Stepper<M, S, R>
where
    R: Real,
    M: Mechanism<R>,
    S: StepMethod<R, M>,
{
    /// The mechanism `model` at `start` and time zero. The start is taken as it is; what is off the constraints is brought back by the
    /// first steps, or at once by [`assemble`](Stepper::assemble).
    pub const fn new(model: M, start: StateOf<M, R>, method: S) -> Self {
        Stepper::at(model, Clock::at(R::ZERO), start, method)
    }

    /// One that goes on from a clock, which is checked, and a state, which is not.
    pub(crate) fn resumed(
        model: M,
        time: [R; 3],
        state: StateOf<M, R>,
        method: S,
    ) -> Result<Self, StepError> {
        let clock = Clock::of_terms(time).ok_or(StepError::State)?;
        Ok(Stepper::at(model, clock, state, method))
    }

    /// One that goes on from a clock and a state.
    pub(crate) const fn at(model: M, clock: Clock<R>, state: StateOf<M, R>, method: S) -> Self {
        Stepper { model, method, clock, state, memory: None, outputs: None }
    }

    /// The exact time.
    pub(crate) fn clock(&self) -> &Clock<R> {
        &self.clock
    }

    /// The model that moves.
    #[inline]
    pub fn model(&self) -> &M {
        &self.model
    }

    /// What its steps are made by.
    #[inline]
    pub fn method(&self) -> &S {
        &self.method
    }

    /// The present time, s: the exact sum of the steps, rounded once.
    #[inline]
    pub fn time(&self) -> R {
        self.clock.time()
    }

    /// The present state.
    #[inline]
    pub fn state(&self) -> &StateOf<M, R> {
        &self.state
    }

    /// Kinetic and potential energy, J.
    pub fn energy(&self) -> R {
        let State { q, v, .. } = &self.state;
        self.model.kinetic_energy(self.time(), q, v) + self.model.potential_energy(self.time(), &self.state)
    }

    /// How far positions and velocities are off the constraints.
    pub fn constraint_residual(&self) -> Residual<R> {
        Residual::of(&self.model, self.time(), &self.state)
    }

    /// The outputs at the present state with these inputs; angles among them continue those last asked for.
    pub fn outputs(&mut self, inputs: &M::Inputs) -> M::Outputs {
        let mut outputs = self.model.outputs(self.time(), &self.state, inputs);
        match &self.outputs {
            Some(previous) => self.model.unwrap(&mut outputs, previous),
            None => self.model.unwrap_start(&mut outputs),
        }
        self.outputs.insert(outputs).clone()
    }

    /// Goes on from another state and time (s). Orientations are brought to length one.
    ///
    /// # Errors
    /// [`StepError::State`] where it is not finite, or an orientation is far from length one; nothing has changed then.
    pub fn set_state(&mut self, time: R, state: StateOf<M, R>) -> Result<(), StepError> {
        self.check(&state)?;
        if !time.is_finite() {
            return Err(StepError::State);
        }
        let q = normalised(self.model.layout(), &state.q).map_err(|_| StepError::State)?;
        self.go_on(Clock::at(time), State { q, ..state });
        Ok(())
    }

    pub(crate) fn check(&self, state: &StateOf<M, R>) -> Result<(), StepError> {
        let unit = || first_not_unit(self.model.layout(), &state.q, R::from_f64(UNIT)).is_none();
        if R::any(is_finite_state(state)) && unit() { Ok(()) } else { Err(StepError::State) }
    }

    fn go_on(&mut self, clock: Clock<R>, state: StateOf<M, R>) {
        (self.clock, self.state) = (clock, state);
        (self.memory, self.outputs) = (None, None);
    }

    /// What is to be kept of the present state; see [`restore`](Stepper::restore).
    pub fn save(&self) -> SavedOf<M, R> {
        Saved::new(self.model.fingerprint(), &self.clock, &self.state)
    }

    /// Goes on from a saved state, to the bit.
    ///
    /// # Errors
    /// [`StepError::OtherModel`] where it is of another definition or version, [`StepError::State`] where it is damaged; nothing
    /// has changed then.
    pub fn restore(&mut self, saved: &SavedOf<M, R>) -> Result<(), StepError> {
        if !saved.is_of(self.model.fingerprint()) {
            return Err(StepError::OtherModel);
        }
        let (clock, state) = (saved.clock().ok_or(StepError::State)?, saved.state());
        self.check(&state)?;
        self.go_on(clock, state);
        Ok(())
    }
}

impl<M, S, R> Stepper<M, S, R>
where
    R: Real,
    M: Assemble<R>,
    S: StepMethod<R, M>,
{
    /// One step of `h` seconds with these inputs.
    ///
    /// # Errors
    /// [`StepError`]; state and time then stay what they were.
    #[inline]
    pub fn step(&mut self, inputs: &M::Inputs, h: R) -> Result<Tick<R>, StepError>
    where
        M::Inputs: Fields<R>,
    {
        // Written so that a NaN fails.
        if !(h > least_step(self.time()) && h.is_finite()) {
            return Err(StepError::StepSize);
        }
        if !R::any(is_finite(&inputs.to_array())) {
            return Err(StepError::Input);
        }
        self.advance(inputs, h)
    }

    /// As [`step`](Stepper::step), in so many steps of equal size; what happened is that of all of them together.
    ///
    /// # Errors
    /// [`StepError`]; state and time are then those of the last good step. [`StepError::StepSize`] for no steps.
    pub fn substeps(&mut self, inputs: &M::Inputs, h: R, count: u16) -> Result<Tick<R>, StepError>
    where
        M::Inputs: Fields<R>,
    {
        let size = h / count_of(count);
        let mut all: Option<Tick<R>> = None;
        for _ in 0..count {
            let tick = self.step(inputs, size)?;
            all = Some(match all {
                None => tick,
                Some(before) => Tick {
                    pivot: tick.pivot.min(before.pivot),
                    moved: tick.moved.max(before.moved),
                    stepped_over: tick.stepped_over + before.stepped_over,
                    ..tick
                },
            });
        }
        all.ok_or(StepError::StepSize)
    }

    #[inline(always)]
    fn advance(&mut self, inputs: &M::Inputs, h: R) -> Result<Tick<R>, StepError> {
        if !self.state.gates.as_slice().is_empty() {
            return Err(StepError::HeldGates);
        }
        let Self { model, method, clock, state, memory, .. } = self;
        let (begin, end) = (clock.time(), clock.after(h));
        let formulation = method.formulation(h);
        let memory = memory.get_or_insert_with(|| formulation.memory(model));
        let mut stages = Stages {
            model: &*model,
            formulation: formulation.clone(),
            memory,
            inputs,
            h,
            pivot: R::ONE,
            stepped_over: 0,
            broke_down: false,
        };
        let stepped = method.integrator().take(&mut stages, begin, h, state);
        let (pivot, stepped_over, broke_down) = (stages.pivot, stages.stepped_over, stages.broke_down);
        let Ok(mut next) = stepped else { return Err(StepError::Breakdown) };
        if broke_down {
            return Err(StepError::Breakdown);
        }
        let moved = match formulation.settle(memory, model, end.time(), &mut next) {
            Ok(settled) => settled.moved,
            Err(_) => return Err(StepError::Diverged),
        };
        if !R::any(is_finite_state(&next)) {
            return Err(StepError::NotFinite);
        }
        if !R::any(is_on(model, end.time(), &next.q)) {
            return Err(StepError::Diverged);
        }
        (*state, *clock) = (next, end);
        Ok(Tick { time: end.time(), pivot, moved, stepped_over })
    }

    /// Goes on with other parameters. What other lengths put off the constraints is brought back as after [`new`](Stepper::new), by
    /// steps or by [`assemble`](Stepper::assemble); phases of gears and racks that state none are those of the present positions.
    ///
    /// # Errors
    /// A parameter that is not finite or out of its bounds, or a mass that is not positive; nothing has changed then.
    pub fn set_parameters(&mut self, parameters: M::Parameters) -> Result<(), SettingError>
    where
        M: Parametric<R>,
    {
        let mut model = M::prepare(parameters)?;
        model.fix_phases(&self.state.q);
        self.model = model;
        Ok(())
    }

    /// v̇ and λ at the present state with these inputs, as the method finds them in a step of `h` seconds.
    ///
    /// # Errors
    /// [`StepError::Input`], [`StepError::StepSize`] and [`StepError::Breakdown`].
    pub fn accelerations(&self, inputs: &M::Inputs, h: R) -> Result<(M::V, M::Lambda), StepError>
    where
        M::Inputs: Fields<R>,
    {
        if !(h > R::ZERO && h.is_finite()) {
            return Err(StepError::StepSize);
        }
        if !R::any(is_finite(&inputs.to_array())) {
            return Err(StepError::Input);
        }
        let formulation = self.method.formulation(h);
        let mut memory = self.memory.clone().unwrap_or_else(|| formulation.memory(&self.model));
        let (mut a, mut lambda) = (self.model.zero_v(), self.model.zero_lambda());
        let mut state = self.state.clone();
        let (model, time) = (&self.model, self.time());
        let found =
            formulation.acceleration(&mut memory, model, time, &mut state, inputs, &mut a, &mut lambda);
        // Written so that a NaN fails.
        if R::any(found.pivot.greater_equal(R::BREAKDOWN) & is_finite(&a) & is_finite(&lambda)) {
            Ok((a, lambda))
        } else {
            Err(StepError::Breakdown)
        }
    }

    /// Brings the present state to the constraints, on the shortest way, by iteration: after other parameters, or for a state that was
    /// measured.
    ///
    /// # Errors
    /// [`AssemblyError`]; the state then stays what it was.
    pub fn assemble(&mut self) -> Result<(), AssemblyError> {
        self.state = self.model.project(self.time(), &self.state)?;
        Ok(())
    }

    /// The constraint row that is about to depend on others, if the present position is near a singular one. A search of its own:
    /// a step says by its pivot when to ask.
    #[cold]
    pub fn near_singular(&self) -> Option<NearSingular<R>> {
        let (model, time, q) = (&self.model, self.time(), &self.state.q);
        if model.row_count() == 0 {
            return None;
        }
        let condition = watched(model, time, q);
        // Written so that a NaN is told.
        let is_far = R::any(condition.greater_equal(R::NEAR_SINGULAR));
        (!is_far).then(|| name_singularity(model, time, condition, q))
    }
}

impl<M: Mechanism<R> + Clone, S: StepMethod<R, M>, R: Real> Clone for Stepper<M, S, R> {
    fn clone(&self) -> Self {
        let Self { model, method, clock, state, memory, outputs } = self;
        Stepper {
            model: model.clone(),
            method: method.clone(),
            clock: *clock,
            state: state.clone(),
            memory: memory.clone(),
            outputs: outputs.clone(),
        }
    }
}

impl<M: Mechanism<R>, S: StepMethod<R, M>, R: Real> Debug for Stepper<M, S, R> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let mut text = f.debug_struct("Stepper");
        text.field("model", &self.model.name()).field("time", &self.time());
        text.field("state", &self.state).finish_non_exhaustive()
    }
}

/// Zero, unless an entry is infinite or NaN: nothing else times zero is not zero.
#[inline(always)]
fn zero_if_finite<R: Real, V: Vector<R>>(sum: R, values: &V) -> R {
    values.as_slice().iter().fold(sum, |sum, &value| value.mul_add(R::ZERO, sum))
}

#[inline(always)]
pub(crate) fn is_finite<R: Real, V: Vector<R>>(values: &V) -> R::Mask {
    zero_if_finite(R::ZERO, values).equal(R::ZERO)
}

#[inline(always)]
pub(crate) fn is_finite_state<R: Real, Q: Vector<R>, V: Vector<R>, Z: Vector<R>, G>(
    state: &State<Q, V, Z, G>,
) -> R::Mask {
    let sum = zero_if_finite(zero_if_finite(zero_if_finite(R::ZERO, &state.q), &state.v), &state.z);
    sum.equal(R::ZERO)
}

/// Whether no row is off by more than [`OFF`]. Written so that a NaN is off.
#[inline(always)]
pub(crate) fn is_on<R: Real, M: Assemble<R>>(model: &M, time: R, q: &M::Q) -> R::Mask {
    let mut phi = model.zero_lambda();
    model.constraints(time, q, &mut phi);
    let sizes = model.row_sizes();
    let mut on = R::ZERO.equal(R::ZERO);
    for (&phi, &size) in phi.as_slice().iter().zip(sizes.as_slice()) {
        on = on & phi.abs().less_equal(size * R::from_f64(OFF));
        if !R::any(on) {
            break;
        }
    }
    on
}

/// The number in the scalars, without a conversion from double precision.
fn count_of<R: Real>(count: u16) -> R {
    (0..16).rev().fold(R::ZERO, |sum, bit| {
        let twice = sum + sum;
        if count >> bit & 1 == 1 { twice + R::ONE } else { twice }
    })
}
