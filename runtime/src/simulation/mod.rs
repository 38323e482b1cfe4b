//! Time stepping of one mechanism: the builder, what is known at a sample, the calls that move.
//!
//! Joins a model, a formulation, an input source and an integrator, each a type of its own. What happens inside one
//! step, and how its failure is named, is `step.rs`, whether its result is in proportion `proportion.rs`; the clock is
//! the `clock.rs` of the crate, runs and their bounds `course.rs`, dense output `between.rs`, events are `event.rs` and `locate.rs`, gates that
//! are held within a step `held.rs`, rigid contacts `rigid.rs`. Nothing here allocates.

mod along_several;
mod between;
mod complementarity;
mod course;
mod dynamics;
mod event;
mod held;
mod held_rows;
mod implicit;
mod jump;
mod locate;
mod occur;
mod proportion;
mod resting;
mod rigid;
mod sample;
mod singularity;
mod step;
mod sticking;
mod strike;
mod ties;
mod which_way;

pub use complementarity::RIGID_TOUCHING;
pub use dynamics::MechanismDynamics;
pub use event::{Direction, Event, Occurrence};
pub use held::EVENTS_PER_STEP;
pub use sample::{Residual, Sample, Samples, Solution, SolutionOf};
pub use singularity::NearSingular;
pub use step::Step;
pub(crate) use step::name_singularity;
pub use strike::IMPACTS_PER_STEP;

use crate::assembly::held;
use crate::clock::Clock;
use crate::error::SimulationError;
use crate::formulation::{Formulation, LagrangeIndex1};
use crate::input::{
    AtStages, Constant, Held, HeldOrSampled, InputSource, NoInputs, OnceAStep, Sampled, When,
};
use crate::integrator::{Integrator, Method, Rk4};
use crate::mechanism::{Assemble, Mechanism};
use crate::real::Real;
use crate::state::StateOf;

use course::{Course, MOST_STEPS, check_count};
use proportion::Proportion;
use singularity::Passage;

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
/// # Time
/// The clock is the exact sum of the steps that were taken; what is integrated is what it shows, in single precision too, for days
/// of ticks. [`time`](Simulation::time) is that sum rounded once, and so is what laws of time, drivers and inputs see at the ends
/// of a step; at a stage they see it plus the stage's part of the step, rounded again. A step may thus be shorter than the distance
/// of neighbouring times, 8 ms for `f32` after a day: motion goes on, and laws of time see it in steps of 8 ms. A step
/// below 2⁻²⁰ of that distance is refused, because time would stand.
///
/// Where `end` cannot name the next tick, [`advance_for`](Simulation::advance_for) advances by a duration and
/// [`advance_steps`](Simulation::advance_steps) by a number of steps.
///
/// A run (`advance_until`, `run_until`, `samples`, `run_every`, `run_until_event`, `advance_for`) takes steps of the given size and a
/// last one of what is left, a hundredth longer rather than a sliver after it: at most (end − time)/h + 1 steps, and one that would
/// need more than 2⁵³ is refused at once. A method that chooses its steps takes more, as many as
/// [`DormandPrince::most_steps`](crate::DormandPrince::most_steps) says.
///
/// # Errors
/// After an error the simulation still stands at its last good state, and can go on from it.
pub struct Simulation<'m, M, R = f64, F = LagrangeIndex1, S = NoInputs, I = Rk4>
where
    R: Real,
    M: Mechanism<R>,
    F: Formulation<R, M>,
    I: Method<R>,
{
    dynamics: MechanismDynamics<'m, M, R, F, S>,
    integrator: I,
    memory: I::Memory<M>,
    run: Run<R, M>,
}

/// The part of a simulation that the choice of methods leaves alone.
struct Run<R: Real, M: Mechanism<R>> {
    step: Option<R>,
    clock: Clock<R>,
    state: StateOf<M, R>,
    /// The outputs last sampled, which the next ones continue.
    outputs: Option<M::Outputs>,
    reciprocal_condition: R,
    near_singular: Option<NearSingular<R>>,
    passage: Passage<R>,
    proportion: Proportion<R>,
    /// Whether the start need not satisfy the constraints.
    start_accepted: bool,
    /// Whether the start has been checked.
    start_checked: bool,
}

// A derived implementation would ask that the mechanism be `Clone`.
impl<R: Real, M: Mechanism<R>> Clone for Run<R, M> {
    fn clone(&self) -> Self {
        Run { state: self.state.clone(), outputs: self.outputs.clone(), ..*self }
    }
}

impl<'m, R: Real, M: Mechanism<R>> Simulation<'m, M, R> {
    /// A simulation of `model` from `start` at time zero, with [`LagrangeIndex1`] and [`Rk4`]; the step size is still
    /// to be given, and the inputs where the mechanism has any.
    pub fn new(model: &'m M, start: StateOf<M, R>) -> Self {
        let run = Run {
            step: None,
            clock: Clock::at(R::ZERO),
            state: held(model, R::ZERO, start),
            outputs: None,
            reciprocal_condition: R::ONE,
            near_singular: None,
            passage: Passage::new(),
            proportion: Proportion::new(),
            start_accepted: false,
            start_checked: false,
        };
        let dynamics = MechanismDynamics::new(model, LagrangeIndex1, NoInputs);
        Simulation { dynamics, integrator: Rk4, memory: (), run }
    }
}

/// Building.
impl<'m, R: Real, M: Mechanism<R>, F: Formulation<R, M>, S, I: Method<R>> Simulation<'m, M, R, F, S, I> {
    /// Replaces the formulation.
    pub fn formulation<G: Formulation<R, M>>(self, formulation: G) -> Simulation<'m, M, R, G, S, I> {
        let Simulation { dynamics, integrator, run, .. } = self;
        let memory = integrator.memory();
        Simulation { dynamics: dynamics.with_formulation(formulation), integrator, memory, run }
    }

    /// Gives the inputs: [`Held`] once a step or [`Sampled`] at the stages.
    pub fn inputs<W: When, C>(
        self,
        source: HeldOrSampled<W, C>,
    ) -> Simulation<'m, M, R, F, HeldOrSampled<W, C>, I>
    where
        C: FnMut(R, &StateOf<M, R>) -> M::Inputs,
    {
        self.input_source(source)
    }

    /// Gives the inputs by a function that is called once a step: `.inputs(Held(function))`, with the types of its
    /// arguments known.
    pub fn held<C>(self, function: C) -> Simulation<'m, M, R, F, HeldOrSampled<OnceAStep, C>, I>
    where
        C: FnMut(R, &StateOf<M, R>) -> M::Inputs,
    {
        self.input_source(Held(function))
    }

    /// Gives the inputs by a function that is called at every stage: `.inputs(Sampled(function))`, with the types of
    /// its arguments known.
    pub fn sampled<C>(self, function: C) -> Simulation<'m, M, R, F, HeldOrSampled<AtStages, C>, I>
    where
        C: FnMut(R, &StateOf<M, R>) -> M::Inputs,
    {
        self.input_source(Sampled(function))
    }

    /// Gives inputs that stay what they are.
    pub fn constant(self, inputs: M::Inputs) -> Simulation<'m, M, R, F, Constant<M::Inputs>, I> {
        self.input_source(Constant(inputs))
    }

    /// Gives the inputs by a source of one's own type.
    pub fn input_source<T: InputSource<R, M>>(self, source: T) -> Simulation<'m, M, R, F, T, I> {
        let Simulation { dynamics, integrator, run, .. } = self;
        let memory = integrator.memory();
        Simulation { dynamics: dynamics.with_source(source), integrator, memory, run }
    }

    /// Replaces the integrator.
    pub fn integrator<J: Method<R>>(self, integrator: J) -> Simulation<'m, M, R, F, S, J> {
        let memory = integrator.memory();
        Simulation { dynamics: self.dynamics, integrator, memory, run: self.run }
    }

    /// The step size, s; of methods that choose their own, the largest. Checked when the simulation is advanced.
    #[must_use = "`step` says how long steps are; `advance` takes one"]
    pub fn step(mut self, seconds: R) -> Self {
        self.run.step = Some(seconds);
        self
    }

    /// Takes a start that does not satisfy the constraints, which is otherwise an error of the first step. Orientations
    /// must be of length 1 all the same.
    pub fn accept_inconsistent_start(mut self) -> Self {
        self.run.start_accepted = true;
        self
    }

    /// Steps over stages at which the factorisation breaks down, in place of stopping: such a stage takes the accelerations
    /// of a position a ten-thousandth of the step further along its velocities (or a thousandth, or a hundredth). A
    /// mechanism that meets a singular position keeps to the branch it came along. [`Step::stepped_over`] counts them.
    pub fn step_over_breakdowns(mut self) -> Self {
        self.dynamics.steps_over = true;
        self
    }

    /// The time at which the simulation starts, s; zero if not given. Where drivers or moving places depend on time, the
    /// start has to be consistent at this time: `model.project(seconds, &state)`. Checked when the simulation is advanced: it must be
    /// finite, and not so large that a step would leave it standing.
    pub fn start_time(mut self, seconds: R) -> Self {
        self.run.clock = Clock::at(seconds);
        self.run.state = held(self.model(), seconds, self.run.state.clone());
        self.run.passage = Passage::new();
        // Forgets a step that ended at another time.
        self.memory = self.integrator.memory();
        self.dynamics.inputs = None;
        self
    }

    /// The outputs that the first sample continues: its angles are unwrapped from these values on.
    pub fn unwrap_from(mut self, outputs: M::Outputs) -> Self {
        self.run.outputs = Some(outputs);
        self
    }
}

/// Looking.
impl<'m, R: Real, M: Mechanism<R>, F: Formulation<R, M>, S, I: Method<R>> Simulation<'m, M, R, F, S, I> {
    /// The model that moves.
    pub fn model(&self) -> &'m M {
        self.dynamics.model
    }

    /// The present time, s: the exact sum of the steps, rounded once.
    pub fn time(&self) -> R {
        self.run.clock.time()
    }

    /// The present state.
    pub fn state(&self) -> &StateOf<M, R> {
        &self.run.state
    }

    /// Kinetic and potential energy, J.
    pub fn energy(&self) -> R {
        let (model, time, state) = (self.model(), self.time(), &self.run.state);
        model.kinetic_energy(time, &state.q, &state.v) + model.potential_energy(time, state)
    }

    /// How far positions and velocities are off the constraints.
    pub fn constraint_residual(&self) -> Residual<R> {
        Residual::of(self.model(), self.time(), &self.run.state)
    }

    /// The smallest [`Step::reciprocal_condition`] of all steps so far: one is well posed, zero is a breakdown.
    pub fn reciprocal_condition(&self) -> R {
        self.run.reciprocal_condition
    }

    /// The position nearest to a singular one that was met so far, if any was nearly singular.
    pub fn near_singular(&self) -> Option<NearSingular<R>> {
        self.run.near_singular
    }

    /// The sample of now, outputs continued from the sample before.
    pub fn sample(&mut self) -> Sample<'m, R, M>
    where
        S: InputSource<R, M>,
    {
        let (time, state) = (self.time(), self.run.state.clone());
        let inputs = self.dynamics.present_inputs(time, &state);
        self.sample_at(time, state, inputs)
    }

    /// The sample of a state, outputs continued from the sample before.
    fn sample_at(&mut self, time: R, state: StateOf<M, R>, inputs: M::Inputs) -> Sample<'m, R, M> {
        let model = self.model();
        let mut outputs = model.outputs(time, &state, &inputs);
        match &self.run.outputs {
            Some(previous) => model.unwrap(&mut outputs, previous),
            None => model.unwrap_start(&mut outputs),
        }
        self.run.outputs = Some(outputs.clone());
        Sample { time, state, inputs, outputs, model }
    }
}

/// Solving.
impl<'m, R, M, F, S, I> Simulation<'m, M, R, F, S, I>
where
    R: Real,
    M: Assemble<R>,
    F: Formulation<R, M>,
    S: InputSource<R, M>,
    I: Method<R>,
{
    /// Accelerations v̇ at the present state, m/s² and rad/s², with the inputs of the present time.
    ///
    /// # Errors
    /// As those of a step: a parameter of the formulation that makes no sense, a singular position, a number that is not finite.
    pub fn acceleration(&mut self) -> Result<M::V, SimulationError> {
        self.solved().map(|(a, _)| a)
    }

    /// Multipliers λ at the present state; the force of the constraints on the mechanism is −Dᵀ λ.
    ///
    /// # Errors
    /// As [`acceleration`](Simulation::acceleration).
    pub fn multipliers(&mut self) -> Result<M::Lambda, SimulationError> {
        self.solved().map(|(_, lambda)| lambda)
    }
}

/// Moving.
impl<'m, R, M, F, S, I> Simulation<'m, M, R, F, S, I>
where
    R: Real,
    M: Assemble<R>,
    F: Formulation<R, M>,
    I: Method<R>,
{
    /// One step of the given size, and what happened in it.
    ///
    /// # Errors
    /// [`SimulationError`]; the state then stays what it was.
    pub fn advance(&mut self) -> Result<Step<R>, SimulationError>
    where
        S: InputSource<R, M>,
        I: Integrator<R, MechanismDynamics<'m, M, R, F, S>>,
    {
        let h = self.checked_step()?;
        self.advance_by(h, self.run.clock.after(h))
    }

    /// So many steps of the given size, as by [`advance`](Simulation::advance). Returns the state there.
    ///
    /// # Errors
    /// [`SimulationError`]; the simulation then stands at the last good state. More than 2⁵³ steps are refused.
    pub fn advance_steps(&mut self, count: u64) -> Result<StateOf<M, R>, SimulationError>
    where
        S: InputSource<R, M>,
        I: Integrator<R, MechanismDynamics<'m, M, R, F, S>>,
    {
        check_count("steps", count as f64, MOST_STEPS)?;
        for _ in 0..count {
            self.advance()?;
        }
        Ok(self.run.state.clone())
    }

    /// Steps for a duration (s), without samples; the last step is what is left of it. Returns the state there.
    ///
    /// The clock then stands at the exact sum of the durations, however many there were and whether or not a number of this
    /// precision can name it.
    ///
    /// # Errors
    /// [`SimulationError`]; the simulation then stands at the last good state. A duration that is negative, not finite, or so short
    /// that time would stand.
    pub fn advance_for(&mut self, seconds: R) -> Result<StateOf<M, R>, SimulationError>
    where
        S: InputSource<R, M>,
        I: Integrator<R, MechanismDynamics<'m, M, R, F, S>>,
    {
        let course = self.course_for(seconds)?;
        self.advance_to_the_end(course)
    }

    /// Steps until `end` (s), without samples; the last step is what is left, so that the clock shows `end` exactly. Returns the
    /// state there.
    ///
    /// # Errors
    /// [`SimulationError`]; the simulation then stands at the last good state.
    pub fn advance_until(&mut self, end: R) -> Result<StateOf<M, R>, SimulationError>
    where
        S: InputSource<R, M>,
        I: Integrator<R, MechanismDynamics<'m, M, R, F, S>>,
    {
        let course = self.course_until(end)?;
        self.advance_to_the_end(course)
    }

    fn advance_to_the_end(&mut self, mut course: Course<R>) -> Result<StateOf<M, R>, SimulationError>
    where
        S: InputSource<R, M>,
        I: Integrator<R, MechanismDynamics<'m, M, R, F, S>>,
    {
        while self.is_under_way(&course) {
            self.advance_along(&mut course)?;
        }
        Ok(self.run.state.clone())
    }

    /// Steps until `end` (s) and shows a sample at the start and after each step; the last step is what is left
    /// to `end`. Returns the state there.
    ///
    /// # Errors
    /// [`SimulationError`]; the simulation then stands at the last good state, whose sample was shown.
    pub fn run_until(
        &mut self,
        end: R,
        mut show: impl FnMut(&Sample<'m, R, M>),
    ) -> Result<StateOf<M, R>, SimulationError>
    where
        S: InputSource<R, M>,
        I: Integrator<R, MechanismDynamics<'m, M, R, F, S>>,
    {
        let mut course = self.course_until(end)?;
        show(&self.sample());
        while self.is_under_way(&course) {
            self.advance_along(&mut course)?;
            show(&self.sample());
        }
        Ok(self.run.state.clone())
    }

    /// As [`run_until`](Simulation::run_until), as an iterator; it ends at `end` or after the first error.
    pub fn samples(&mut self, end: R) -> Samples<'_, 'm, M, R, F, S, I>
    where
        S: InputSource<R, M>,
        I: Integrator<R, MechanismDynamics<'m, M, R, F, S>>,
    {
        Samples::new(self, end)
    }
}
