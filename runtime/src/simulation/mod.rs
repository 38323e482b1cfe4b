//! Time stepping of one mechanism: the builder, the clock, what is known at a sample.
//!
//! Joins a model, a formulation, an input source and an integrator, each a type of its own. What happens inside one
//! step, and how its failure is named, is `step.rs`. Nothing here allocates.

mod sample;
mod step;

pub use sample::{Residual, Sample, Samples};

use crate::error::SimulationError;
use crate::formulation::{Formulation, LagrangeIndex1};
use crate::input::{AtStages, Held, InputSource, NoInputs, OnceAStep, Sampled, Source, When};
use crate::integrator::{Integrator, Rk4};
use crate::mechanism::{Assemble, Mechanism};
use crate::real::Real;
use crate::state::State;
use crate::vector::Vector;

/// A mechanism in motion.
///
/// ```text
/// let mut simulation = Simulation::new(&model, start)
///     .formulation(Baumgarte { alpha: 10.0, beta: 10.0 })   // default: LagrangeIndex1
///     .sampled(|time, state| Inputs { drive: -0.1 * state.v[0] + time.sin() })   // or `held`: once a step
///     .integrator(Rk4)                                      // the default
///     .step(1e-3);
/// let end = simulation.run_until(10.0, |sample| record(sample.time, sample.outputs))?;
/// ```
/// Steps are counted, time = start + k·h, so that the clock does not drift. After an error the simulation still
/// stands at its last good state.
pub struct Simulation<'m, M, R = f64, F = LagrangeIndex1, S = NoInputs, I = Rk4>
where
    R: Real,
    M: Mechanism<R>,
{
    formulation: F,
    source: S,
    integrator: I,
    run: Run<'m, R, M>,
}

/// The part of a simulation that the choice of methods leaves alone.
struct Run<'m, R: Real, M: Mechanism<R>> {
    model: &'m M,
    step: Option<R>,
    clock: Clock<R>,
    state: State<M::Q, M::V>,
    /// The inputs at the present time and state, once they have been asked for.
    inputs: Option<M::Inputs>,
    /// The outputs last sampled, which the next ones continue.
    outputs: Option<M::Outputs>,
    smallest_pivot: R,
    /// Whether the start need not satisfy the constraints.
    start_accepted: bool,
    /// Whether the start has been checked.
    start_checked: bool,
}

/// Time as a beginning and a number of steps.
#[derive(Clone, Copy, Debug)]
struct Clock<R> {
    origin: R,
    count: u64,
    time: R,
}

impl<R: Real> Clock<R> {
    fn at(time: R) -> Self {
        Clock { origin: time, count: 0, time }
    }

    fn after(self, h: R) -> Self {
        let count = self.count + 1;
        Clock { origin: self.origin, count, time: self.origin + R::from_f64(count as f64) * h }
    }
}

impl<'m, R: Real, M: Mechanism<R>> Simulation<'m, M, R> {
    /// A simulation of `model` from `start` at time zero, with [`LagrangeIndex1`] and [`Rk4`]; the step size is still
    /// to be given, and the inputs where the mechanism has any.
    pub fn new(model: &'m M, start: State<M::Q, M::V>) -> Self {
        let run = Run {
            model,
            step: None,
            clock: Clock::at(R::ZERO),
            state: start,
            inputs: None,
            outputs: None,
            smallest_pivot: R::ONE,
            start_accepted: false,
            start_checked: false,
        };
        Simulation { formulation: LagrangeIndex1, source: NoInputs, integrator: Rk4, run }
    }
}

/// Building.
impl<'m, R: Real, M: Mechanism<R>, F, S, I> Simulation<'m, M, R, F, S, I> {
    /// Replaces the formulation.
    pub fn formulation<G: Formulation<R>>(self, formulation: G) -> Simulation<'m, M, R, G, S, I> {
        Simulation { formulation, source: self.source, integrator: self.integrator, run: self.run }
    }

    /// Gives the inputs: [`Held`] once a step or [`Sampled`] at the stages.
    pub fn inputs<W: When, C>(self, source: Source<W, C>) -> Simulation<'m, M, R, F, Source<W, C>, I>
    where
        C: FnMut(R, &State<M::Q, M::V>) -> M::Inputs,
    {
        self.input_source(source)
    }

    /// Gives the inputs by a function that is called once a step: `.inputs(Held(function))`, with the types of its
    /// arguments known.
    pub fn held<C>(self, function: C) -> Simulation<'m, M, R, F, Source<OnceAStep, C>, I>
    where
        C: FnMut(R, &State<M::Q, M::V>) -> M::Inputs,
    {
        self.input_source(Held(function))
    }

    /// Gives the inputs by a function that is called at every stage: `.inputs(Sampled(function))`, with the types of
    /// its arguments known.
    pub fn sampled<C>(self, function: C) -> Simulation<'m, M, R, F, Source<AtStages, C>, I>
    where
        C: FnMut(R, &State<M::Q, M::V>) -> M::Inputs,
    {
        self.input_source(Sampled(function))
    }

    /// Gives the inputs by a source of one's own type.
    pub fn input_source<T: InputSource<R, M>>(self, source: T) -> Simulation<'m, M, R, F, T, I> {
        let run = Run { inputs: None, ..self.run };
        Simulation { formulation: self.formulation, source, integrator: self.integrator, run }
    }

    /// Replaces the integrator.
    pub fn integrator<J: Integrator<R>>(self, integrator: J) -> Simulation<'m, M, R, F, S, J> {
        Simulation { formulation: self.formulation, source: self.source, integrator, run: self.run }
    }

    /// The step size, s. Checked when the simulation is advanced.
    pub fn step(mut self, seconds: R) -> Self {
        self.run.step = Some(seconds);
        self.run.clock = Clock::at(self.run.clock.time);
        self
    }

    /// Takes a start that does not satisfy the constraints, which is otherwise an error of the first step. Orientations
    /// must be of length 1 all the same.
    pub fn accept_inconsistent_start(mut self) -> Self {
        self.run.start_accepted = true;
        self
    }

    /// The time at which the simulation starts, s; zero if not given. Where drivers or moving places depend on time, the
    /// start has to be consistent at this time: `model.project(seconds, &state)`.
    pub fn start_time(mut self, seconds: R) -> Self {
        self.run.clock = Clock::at(seconds);
        self.run.inputs = None;
        self
    }

    /// The outputs that the first sample continues: its angles are unwrapped from these values on.
    pub fn unwrap_from(mut self, outputs: M::Outputs) -> Self {
        self.run.outputs = Some(outputs);
        self
    }
}

/// Looking.
impl<'m, R: Real, M: Mechanism<R>, F, S, I> Simulation<'m, M, R, F, S, I> {
    /// The model that moves.
    pub fn model(&self) -> &'m M {
        self.run.model
    }

    /// The present time, s.
    pub fn time(&self) -> R {
        self.run.clock.time
    }

    /// The present state.
    pub fn state(&self) -> &State<M::Q, M::V> {
        &self.run.state
    }

    /// Kinetic and potential energy, J.
    pub fn energy(&self) -> R {
        let (time, State { q, v }) = (self.time(), &self.run.state);
        self.run.model.kinetic_energy(time, q, v) + self.run.model.potential_energy(time, q)
    }

    /// How far positions and velocities are off the constraints.
    pub fn constraint_residual(&self) -> Residual<R> {
        Residual::of(self.run.model, self.time(), &self.run.state)
    }

    /// The smallest relative pivot of all accelerations evaluated so far: one is well posed, zero is a breakdown.
    pub fn status(&self) -> R {
        self.run.smallest_pivot
    }

    /// Accelerations v̇ at the present state, m/s² and rad/s², with the inputs of the present time.
    pub fn acceleration(&mut self) -> M::V
    where
        F: Formulation<R>,
        S: InputSource<R, M>,
    {
        self.evaluate().0
    }

    /// Multipliers λ at the present state; the force of the constraints on the mechanism is −Dᵀ λ.
    pub fn multipliers(&mut self) -> M::Lambda
    where
        F: Formulation<R>,
        S: InputSource<R, M>,
    {
        self.evaluate().1
    }

    /// What is known now, outputs continued from the sample before.
    pub fn sample(&mut self) -> Sample<'m, R, M>
    where
        S: InputSource<R, M>,
    {
        let inputs = self.present_inputs();
        let Run { model, clock, state, .. } = self.run;
        let mut outputs = model.outputs(clock.time, &state.q, &state.v, &inputs);
        match &self.run.outputs {
            Some(previous) => M::unwrap(&mut outputs, previous),
            None => model.unwrap_start(&mut outputs),
        }
        self.run.outputs = Some(outputs);
        Sample { time: clock.time, state, inputs, outputs, model }
    }

    fn evaluate(&mut self) -> (M::V, M::Lambda)
    where
        F: Formulation<R>,
        S: InputSource<R, M>,
    {
        let inputs = self.present_inputs();
        let (mut a, mut lambda) = (M::V::zero(), M::Lambda::zero());
        let Run { model, clock, state, .. } = self.run;
        self.formulation.acceleration(model, clock.time, &state.q, &state.v, &inputs, &mut a, &mut lambda);
        (a, lambda)
    }

    /// The inputs at the present time and state; the source is asked once, for the sample and the step that follows.
    fn present_inputs(&mut self) -> M::Inputs
    where
        S: InputSource<R, M>,
    {
        let (time, state) = (self.run.clock.time, &self.run.state);
        *self.run.inputs.get_or_insert_with(|| self.source.sample(time, state))
    }
}

/// Moving.
impl<'m, R: Real, M: Assemble<R>, F: Formulation<R>, S, I: Integrator<R>> Simulation<'m, M, R, F, S, I> {
    /// One step of the given size; returns the new time, s.
    ///
    /// # Errors
    /// [`SimulationError`]; the state then stays what it was.
    pub fn advance(&mut self) -> Result<R, SimulationError>
    where
        S: InputSource<R, M>,
    {
        let h = self.checked_step()?;
        self.advance_by(h, self.run.clock.after(h))?;
        Ok(self.time())
    }

    /// Steps until `end` (s), without samples; the last step is shortened to land on it. Returns the state there.
    ///
    /// # Errors
    /// [`SimulationError`]; the simulation then stands at the last good state.
    pub fn advance_until(&mut self, end: R) -> Result<State<M::Q, M::V>, SimulationError>
    where
        S: InputSource<R, M>,
    {
        let h = self.checked_run(end)?;
        while self.time() < end {
            self.advance_towards(end, h)?;
        }
        Ok(self.run.state)
    }

    /// Steps until `end` (s) and shows a sample at the start and after each step; the last step is shortened to land
    /// on `end`. Returns the state there.
    ///
    /// # Errors
    /// [`SimulationError`]; the simulation then stands at the last good state, whose sample was shown.
    pub fn run_until(
        &mut self,
        end: R,
        mut show: impl FnMut(&Sample<'m, R, M>),
    ) -> Result<State<M::Q, M::V>, SimulationError>
    where
        S: InputSource<R, M>,
    {
        let h = self.checked_run(end)?;
        show(&self.sample());
        while self.time() < end {
            self.advance_towards(end, h)?;
            show(&self.sample());
        }
        Ok(self.run.state)
    }

    /// As [`run_until`](Simulation::run_until), as an iterator; it ends at `end` or after the first error.
    pub fn samples(&mut self, end: R) -> Samples<'_, 'm, M, R, F, S, I>
    where
        S: InputSource<R, M>,
    {
        Samples::new(self, end)
    }
}
