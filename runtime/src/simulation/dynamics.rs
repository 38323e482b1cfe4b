//! The mechanism as an integrator sees it: a model under a formulation, with its inputs, watched.

use super::rigid::Held;
use crate::error::AssemblyError;
use crate::formulation::friction::unexplained;
use crate::formulation::{Evaluation, Formulation, Settled, past_breakdown};
use crate::input::InputSource;
use crate::integrator::Dynamics;
use crate::mechanism::Mechanism;
use crate::real::Real;
use crate::state::{Derivative, DerivativeOf, StateOf};
use crate::vector::Vector;

/// Positions that are tried past a breakdown: to a hundredth of the step.
const OVER: u32 = 3;

/// A model under a formulation, with its inputs: what an [`Integrator`](crate::Integrator) moves.
pub struct MechanismDynamics<'m, M: Mechanism<R>, R: Real, F: Formulation<R, M>, S> {
    pub(super) model: &'m M,
    pub(super) formulation: F,
    pub(super) memory: F::Memory,
    pub(super) source: S,
    /// The inputs at the present time and state, once they have been asked for.
    pub(super) inputs: Option<M::Inputs>,
    /// Whether a stage that breaks down is stepped over.
    pub(super) steps_over: bool,
    /// The inputs that the last step began with.
    pub(super) begun_with: Option<M::Inputs>,
    pub(super) watch: Watch<R, StateOf<M, R>>,
    /// The pivot of the last evaluation: that of the next step's beginning where it is not evaluated again.
    pub(super) last_pivot: R,
    pub(super) held: Held<M::Gates>,
    /// What was seen before the first trial of the step, once there was one.
    before_trials: Option<Watch<R, StateOf<M, R>>>,
    /// What the formulation remembered then.
    memory_before_trials: F::Memory,
}

/// What was seen during one step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Watch<R, S> {
    /// The size of the step.
    h: R,
    started: bool,
    /// The pivot at the step's beginning, or at its end if an implicit method looked there.
    pub first_pivot: R,
    /// Whether that was at the end.
    pub observed: bool,
    pub smallest_pivot: R,
    pub iterations: u32,
    pub residual: R,
    /// What friction left at the step's beginning.
    pub friction: R,
    /// Whether a method holds constraints by positions, which leaves velocities off them by what it errs.
    pub by_positions: bool,
    /// Whether dry friction in joints had no forces that go with its ways.
    pub locked: bool,
    pub stepped_over: u32,
    /// The worst stage below [`Real::NEAR_SINGULAR`].
    pub worst: Option<Stage<R, S>>,
    /// The first stage below [`Real::BREAKDOWN`].
    pub failure: Option<Stage<R, S>>,
}

/// A stage and the pivot found there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stage<R, S> {
    pub time: R,
    pub pivot: R,
    pub state: S,
}

impl<R: Real, S> Watch<R, S> {
    pub fn new(h: R) -> Self {
        Watch {
            h,
            started: false,
            first_pivot: R::ONE,
            observed: false,
            smallest_pivot: R::ONE,
            iterations: 0,
            residual: R::ZERO,
            friction: R::ZERO,
            by_positions: false,
            locked: false,
            stepped_over: 0,
            worst: None,
            failure: None,
        }
    }
}

impl<'m, M: Mechanism<R>, R: Real, F: Formulation<R, M>, S> MechanismDynamics<'m, M, R, F, S> {
    pub(super) fn new(model: &'m M, formulation: F, source: S) -> Self {
        let memory = formulation.memory(model);
        MechanismDynamics {
            model,
            formulation,
            memory_before_trials: memory.clone(),
            memory,
            source,
            inputs: None,
            steps_over: false,
            begun_with: None,
            watch: Watch::new(R::ZERO),
            last_pivot: R::ONE,
            held: Held::none(model),
            before_trials: None,
        }
    }

    /// A step of size `h` begins.
    pub(super) fn begin(&mut self, h: R) {
        self.watch = Watch::new(h);
        self.before_trials = None;
    }

    /// The inputs at a time and state within the last step, or at its end.
    pub(super) fn inputs_within(&mut self, time: R, state: &StateOf<M, R>) -> M::Inputs
    where
        S: InputSource<R, M>,
    {
        match &self.begun_with {
            Some(inputs) if S::HELD => inputs.clone(),
            _ => self.source.sample(time, state),
        }
    }

    /// The same with another formulation.
    pub(super) fn with_formulation<G: Formulation<R, M>>(
        self,
        formulation: G,
    ) -> MechanismDynamics<'m, M, R, G, S> {
        let MechanismDynamics { model, source, inputs, steps_over, .. } = self;
        MechanismDynamics { inputs, steps_over, ..MechanismDynamics::new(model, formulation, source) }
    }

    /// The same with other inputs.
    pub(super) fn with_source<T>(self, source: T) -> MechanismDynamics<'m, M, R, F, T> {
        let MechanismDynamics { model, formulation, steps_over, .. } = self;
        MechanismDynamics { steps_over, ..MechanismDynamics::new(model, formulation, source) }
    }

    /// The inputs at the present time and state; the source is asked once, for the sample and the step that follows.
    pub(super) fn present_inputs(&mut self, time: R, state: &StateOf<M, R>) -> M::Inputs
    where
        S: InputSource<R, M>,
    {
        self.inputs.get_or_insert_with(|| self.source.sample(time, state)).clone()
    }

    /// The inputs at a stage: held ones are those of the step's beginning.
    pub(super) fn inputs_at(&mut self, time: R, state: &StateOf<M, R>) -> M::Inputs
    where
        S: InputSource<R, M>,
    {
        match &self.inputs {
            Some(inputs) if S::HELD => inputs.clone(),
            _ => self.source.sample(time, state),
        }
    }

    /// v̇ and λ with these inputs, and their pivot; what the formulation remembers stays as it is.
    pub(super) fn evaluate(
        &self,
        time: R,
        state: &StateOf<M, R>,
        inputs: &M::Inputs,
    ) -> (M::V, M::Lambda, R) {
        if !M::HOLDS || !self.model.is_rigid() {
            return self.free(time, state, inputs);
        }
        let (mut a, mut lambda, pivot) = self.free(time, &self.opened(state), inputs);
        self.pressed(time, state, inputs, &mut a, &mut lambda);
        (a, lambda, pivot)
    }

    /// The same with the gates as numbers, those of rigid contacts too.
    pub(super) fn free(&self, time: R, state: &StateOf<M, R>, inputs: &M::Inputs) -> (M::V, M::Lambda, R) {
        let model = self.model;
        let (mut memory, mut state) = (self.memory.clone(), state.clone());
        let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
        let formulation = &self.formulation;
        let found =
            formulation.acceleration(&mut memory, model, time, &mut state, inputs, &mut a, &mut lambda);
        (a, lambda, found.pivot)
    }

    /// The end of a step.
    pub(super) fn settle(&mut self, time: R, state: &mut StateOf<M, R>) -> Result<Settled<R>, AssemblyError> {
        self.formulation.settle(&mut self.memory, self.model, time, state)
    }

    /// The stage once more, a little further along its velocities.
    #[cold]
    fn step_over(
        &mut self,
        time: R,
        state: &StateOf<M, R>,
        inputs: &M::Inputs,
        a: &mut M::V,
        lambda: &mut M::Lambda,
    ) -> Option<Evaluation<R>> {
        let (formulation, at) = (&self.formulation, (time, self.watch.h, OVER));
        let found = past_breakdown(formulation, &mut self.memory, self.model, at, state, inputs, a, lambda);
        self.watch.stepped_over += u32::from(found.is_some());
        found
    }
}

impl<M, R, F, S> Dynamics<R> for MechanismDynamics<'_, M, R, F, S>
where
    M: Mechanism<R>,
    R: Real,
    F: Formulation<R, M>,
    S: InputSource<R, M>,
{
    type Variables = M;

    #[inline(always)]
    fn variables(&self) -> &M {
        self.model
    }

    #[inline]
    fn derivative(&mut self, time: R, state: &mut StateOf<M, R>) -> DerivativeOf<M, R> {
        let model = self.model;
        // The inputs at the step's start were sampled when the step before ended.
        let inputs = match &self.inputs {
            Some(inputs) if S::HELD || !self.watch.started => inputs.clone(),
            _ => self.source.sample(time, state),
        };
        let first = !self.watch.started;
        self.watch.started = true;
        let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
        let held = model.is_rigid().then(|| {
            let opened = self.opened(state);
            core::mem::replace(&mut state.gates, opened.gates)
        });
        let memory = &mut self.memory;
        let mut evaluation =
            self.formulation.acceleration(memory, model, time, state, &inputs, &mut a, &mut lambda);
        let forces = held.map(|held| {
            state.gates = held;
            let forces = self.pressed(time, state, &inputs, &mut a, &mut lambda);
            self.watch.locked |= model.sticks() && is_locked::<M, R>(&state.q, &state.v, &forces);
            forces
        });
        // Written so that a NaN is seen.
        if !R::any(evaluation.pivot.greater_equal(R::NEAR_SINGULAR)) {
            self.see(time, state, &inputs, &mut evaluation, &mut a, &mut lambda);
        }
        let watch = &mut self.watch;
        if first {
            watch.first_pivot = evaluation.pivot;
        }
        self.last_pivot = evaluation.pivot;
        watch.smallest_pivot = evaluation.pivot.min(watch.smallest_pivot);
        watch.iterations += evaluation.iterations;
        watch.residual = watch.residual.max(evaluation.residual);
        let mut z = M::Z::zeros(state.z.as_slice().len());
        // They may name what rigid contacts exert now.
        let held = forces.map(|forces| core::mem::replace(&mut state.gates, forces));
        model.internal_rates(time, state, &inputs, &a, &lambda, &mut z);
        if first && model.rubs() {
            watch.friction = unexplained(model, time, state, &inputs, &a, &lambda);
        }
        if let Some(held) = held {
            state.gates = held;
        }
        Derivative { v: state.v.clone(), a, z }
    }

    fn resume(&mut self) -> bool {
        let holds = !S::HELD || self.model.input_names().is_empty();
        if holds {
            self.watch.started = true;
            self.watch.first_pivot = self.last_pivot;
        }
        holds
    }

    fn begin_trial(&mut self, size: R) {
        if let Some(before) = &self.before_trials {
            // The work of trials given up is counted; what they saw is not part of the motion.
            let iterations = self.watch.iterations;
            self.watch.clone_from(before);
            self.watch.iterations = iterations;
            self.memory.clone_from(&self.memory_before_trials);
        } else {
            self.before_trials = Some(self.watch.clone());
            self.memory_before_trials.clone_from(&self.memory);
        }
        self.watch.h = size;
    }

    fn broke_down(&self) -> bool {
        self.watch.failure.is_some()
    }
}

impl<M, R, F, S> MechanismDynamics<'_, M, R, F, S>
where
    M: Mechanism<R>,
    R: Real,
    F: Formulation<R, M>,
{
    /// A stage where the pivot is small: remembered, and stepped over if that is asked for.
    #[cold]
    fn see(
        &mut self,
        time: R,
        state: &StateOf<M, R>,
        inputs: &M::Inputs,
        evaluation: &mut Evaluation<R>,
        a: &mut M::V,
        lambda: &mut M::Lambda,
    ) {
        // A pivot that is exactly zero leaves 0 · ∞ behind.
        if !evaluation.pivot.is_finite() && state.q.first_not_finite().is_none() {
            evaluation.pivot = R::ZERO;
        }
        let stage = Stage { time, pivot: evaluation.pivot, state: state.clone() };
        if self.watch.worst.as_ref().is_none_or(|worst| !R::any(stage.pivot.greater_equal(worst.pivot))) {
            self.watch.worst = Some(stage.clone());
        }
        if R::any(stage.pivot.greater_equal(R::BREAKDOWN)) {
            return;
        }
        if self.steps_over
            && let Some(further) = self.step_over(time, state, inputs, a, lambda)
        {
            *evaluation = further;
        } else if self.watch.failure.is_none() {
            self.watch.failure = Some(stage);
        }
    }
}

/// Whether there are no forces with which joints stick or slide, though the state is one.
pub(super) fn is_locked<M: Mechanism<R>, R: Real>(q: &M::Q, v: &M::V, forces: &M::Gates) -> bool {
    forces.first_not_finite().is_some() && q.first_not_finite().or(v.first_not_finite()).is_none()
}
