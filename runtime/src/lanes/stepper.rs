//! A stepper of as many mechanisms as there are lanes. What goes straight ahead is computed for all of them at once; a lane in which
//! anything else happens is stepped alone, by a [`Stepper`](crate::Stepper) of its own, and the others do not notice.

use super::in_scalars::{
    fields_in_lane, model_in_lane, no_state, set_state, splat_model, state_in_lane, with_model,
};
use super::stages::LaneStages;
use super::{InScalars, InputsIn, LaneMethod, Lanes, MOST_LANES, OutputsIn, StateIn};
use crate::clock::{Clock, least_step};
use crate::error::StepError;
use crate::fields::Fields;
use crate::formulation::Formulation;
use crate::integrator::FixedStep;
use crate::mechanism::Mechanism;
use crate::stepper::{StepMethod, Stepper, is_finite, is_finite_state, is_on};
use crate::vector::{Vector, blend};
use core::fmt::{self, Debug, Formatter};

/// Mechanisms of one definition, one in each lane, that are moved together: each with its own parameters, time, state, inputs and
/// size of steps, and each to the bit as a [`Stepper`] moves it alone, as far as both are compiled for the same processor.
///
/// ```text
/// let mut plants = LaneStepper::<CartPole, _, F64x8>::new(&model, &start, Rk4);
/// plants.set(3, &heavier, 0.0, &pushed)?;
/// let ticks = plants.step(&inputs, F64x8::splat(1e-3));
/// for lane in ticks.failed() { … plants.error(lane) … }      // it stays where it was; the others go on
/// ```
pub struct LaneStepper<M: InScalars, S: LaneMethod<M, L>, L: Lanes> {
    models: M::In<L>,
    method: S,
    in_lanes: S::In,
    clock: Clock<L>,
    states: StateIn<M, L>,
    /// The lanes that move, one bit each.
    moving: u32,
    errors: [Option<StepError>; MOST_LANES],
}

/// What happened in a step of each lane; numbers of lanes that do not move mean nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ticks<L> {
    /// The times at its end, s.
    pub time: L,
    /// The smallest relative pivot of the stages; zero a breakdown that was stepped over.
    pub pivot: L,
    /// How far the correction moved a coordinate at most, m or rad.
    pub moved: L,
    alone: u32,
    failed: u32,
}

impl<L: Lanes> Ticks<L> {
    /// The lanes that had to be stepped alone.
    pub fn alone(&self) -> impl Iterator<Item = usize> + use<L> {
        lanes_of(self.alone)
    }

    /// The lanes in which the step failed, and which will not move on.
    pub fn failed(&self) -> impl Iterator<Item = usize> + use<L> {
        lanes_of(self.failed)
    }
}

fn lanes_of(bits: u32) -> impl Iterator<Item = usize> {
    (0..MOST_LANES).filter(move |lane| bits >> lane & 1 == 1)
}

impl<M: InScalars, S: LaneMethod<M, L>, L: Lanes> LaneStepper<M, S, L> {
    /// All lanes.
    const ALL: u32 = {
        assert!(L::LANES <= MOST_LANES, "there are at most MOST_LANES lanes");
        (1 << L::LANES) - 1
    };

    /// The same mechanism at the same start and time zero in every lane.
    pub fn new(model: &M::In<L::Scalar>, start: &StateIn<M, L::Scalar>, method: S) -> Self {
        let mut states = no_state::<M, L>(start);
        for lane in 0..L::LANES {
            set_state::<M, L>(&mut states, lane, start);
        }
        LaneStepper {
            models: splat_model::<M, L>(model),
            in_lanes: method.in_lanes(),
            method,
            clock: Clock::at(L::ZERO),
            states,
            moving: Self::ALL,
            errors: [const { None }; MOST_LANES],
        }
    }

    /// Another mechanism in one lane, at this time (s) and state; it moves, also where the one before had stopped.
    ///
    /// # Errors
    /// [`StepError::State`] where the state or time is not finite, or an orientation is far from length one, or there is no such lane;
    /// nothing has changed then.
    pub fn set(
        &mut self,
        lane: usize,
        model: &M::In<L::Scalar>,
        time: L::Scalar,
        state: &StateIn<M, L::Scalar>,
    ) -> Result<(), StepError> {
        if lane >= L::LANES {
            return Err(StepError::State);
        }
        let mut alone = Stepper::new(model.clone(), state.clone(), self.method.clone());
        alone.set_state(time, state.clone())?;
        self.models = with_model::<M, L>(&self.models, lane, model);
        self.put(lane, &alone);
        self.moving |= 1 << lane;
        if let Some(error) = self.errors.get_mut(lane) {
            *error = None;
        }
        Ok(())
    }

    /// Stops a lane, such as one for which there is no mechanism.
    pub fn stop(&mut self, lane: usize) {
        self.moving &= !1_u32.checked_shl(lane as u32).unwrap_or(0);
    }

    /// Whether a lane moves with the next step.
    pub fn is_moving(&self, lane: usize) -> bool {
        lane < L::LANES && self.moving >> lane & 1 == 1
    }

    /// How many lanes move with the next step.
    pub fn moving(&self) -> usize {
        self.moving.count_ones() as usize
    }

    /// Why a lane stopped.
    pub fn error(&self, lane: usize) -> Option<StepError> {
        self.errors.get(lane).copied().flatten()
    }

    /// The model in a lane.
    pub fn model(&self, lane: usize) -> M::In<L::Scalar> {
        model_in_lane::<M, L>(&self.models, lane)
    }

    /// The state in a lane.
    pub fn state(&self, lane: usize) -> StateIn<M, L::Scalar> {
        state_in_lane::<M, L>(&self.states, lane)
    }

    /// The time in a lane, s.
    pub fn time(&self, lane: usize) -> L::Scalar {
        self.clock.time().lane(lane)
    }

    /// The models of all lanes.
    pub fn models(&self) -> &M::In<L> {
        &self.models
    }

    /// The states of all lanes.
    pub fn states(&self) -> &StateIn<M, L> {
        &self.states
    }

    /// The times of all lanes, s.
    pub fn times(&self) -> L {
        self.clock.time()
    }

    /// The outputs of all lanes at the present states with these inputs; angles among them are those nearest to what the start says.
    pub fn outputs(&self, inputs: &InputsIn<M, L>) -> OutputsIn<M, L> {
        let mut outputs = self.models.outputs(self.times(), &self.states, inputs);
        self.models.unwrap_start(&mut outputs);
        outputs
    }

    /// One step of `h` seconds, with these inputs, of every lane that moves. A lane whose step fails, by any [`StepError`], stays what
    /// it was and stops; the others take theirs.
    #[inline]
    pub fn step(&mut self, inputs: &InputsIn<M, L>, h: L) -> Ticks<L> {
        let Self { models, in_lanes, clock, states, moving, .. } = self;
        let end = clock.after(h);
        let formulation = in_lanes.formulation(h);
        let mut memory = formulation.memory(models);
        let mut stages = LaneStages {
            model: &*models,
            formulation: formulation.clone(),
            memory: memory.clone(),
            inputs,
            pivot: L::ONE,
            // Written so that a NaN is not sound. Gates that are held are refused by the lanes' own steppers.
            sound: h.greater(least_step(clock.time())) & is_finite(&[h]) & is_finite(&inputs.to_array()),
        };
        if !states.gates.as_slice().is_empty() {
            stages.sound = L::mask(0);
        }
        let stepped = in_lanes.integrator().take(&mut stages, clock.time(), h, states);
        let (pivot, mut sound) = (stages.pivot, stages.sound);
        let mut moved = L::ZERO;
        let done = match stepped {
            Ok(mut next) => {
                match formulation.settle(&mut memory, models, end.time(), &mut next) {
                    Ok(settled) => moved = settled.moved,
                    Err(_) => sound = L::mask(0),
                }
                sound = sound & is_finite_state(&next) & is_on(models, end.time(), &next.q);
                let done = L::bits(sound) & *moving;
                if done == Self::ALL {
                    (*states, *clock) = (next, end);
                } else {
                    let mask = L::mask(done);
                    blend(mask, &next.q, &mut states.q);
                    blend(mask, &next.v, &mut states.v);
                    blend(mask, &next.z, &mut states.z);
                    *clock = Clock::select(mask, end, *clock);
                }
                done
            }
            Err(_) => 0,
        };
        let mut ticks = Ticks { time: end.time(), pivot, moved, alone: *moving & !done, failed: 0 };
        if ticks.alone != 0 {
            self.step_alone(inputs, h, &mut ticks);
        }
        ticks
    }

    /// The lanes that did not go straight ahead, one by one.
    #[cold]
    #[inline(never)]
    fn step_alone(&mut self, inputs: &InputsIn<M, L>, h: L, ticks: &mut Ticks<L>) {
        for lane in lanes_of(ticks.alone) {
            let mut stepper = self.alone(lane);
            let inputs = fields_in_lane::<L, _, InputsIn<M, L::Scalar>>(inputs, lane);
            match stepper.step(&inputs, h.lane(lane)) {
                Ok(tick) => {
                    ticks.time.set_lane(lane, tick.time);
                    ticks.pivot.set_lane(lane, tick.pivot);
                    ticks.moved.set_lane(lane, tick.moved);
                    self.put(lane, &stepper);
                }
                Err(error) => {
                    ticks.failed |= 1 << lane;
                    self.stop(lane);
                    if let Some(of_lane) = self.errors.get_mut(lane) {
                        *of_lane = Some(error);
                    }
                }
            }
        }
    }

    /// A stepper of the mechanism in one lane, which goes on from there.
    pub fn alone(&self, lane: usize) -> Stepper<M::In<L::Scalar>, S, L::Scalar> {
        let clock = self.clock.map(|term| term.lane(lane));
        Stepper::at(self.model(lane), clock, self.state(lane), self.method.clone())
    }

    /// Writes the time and the state of a stepper into one lane.
    fn put(&mut self, lane: usize, of: &Stepper<M::In<L::Scalar>, S, L::Scalar>) {
        self.clock.set(of.clock(), |all, term| all.set_lane(lane, term));
        set_state::<M, L>(&mut self.states, lane, of.state());
    }
}

impl<M: InScalars, S: LaneMethod<M, L>, L: Lanes> Clone for LaneStepper<M, S, L> {
    fn clone(&self) -> Self {
        LaneStepper {
            models: self.models.clone(),
            method: self.method.clone(),
            in_lanes: self.in_lanes.clone(),
            clock: self.clock,
            states: self.states.clone(),
            moving: self.moving,
            errors: self.errors,
        }
    }
}

impl<M: InScalars, S: LaneMethod<M, L>, L: Lanes> Debug for LaneStepper<M, S, L> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let mut text = f.debug_struct("LaneStepper");
        text.field("model", &self.models.name()).field("times", &self.times());
        text.field("states", &self.states).finish_non_exhaustive()
    }
}
