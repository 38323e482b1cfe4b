//! Times between the steps: states and samples by dense output.

use super::course::{SLIVER, check_count};
use super::{MechanismDynamics, Sample, Simulation};
use crate::clock::Clock;
use crate::error::{SettingError, SimulationError};
use crate::formulation::{Formulation, positive};
use crate::input::InputSource;
use crate::integrator::{Integrator, Interpolate, Method};
use crate::mechanism::{Assemble, Mechanism};
use crate::real::Real;
use crate::state::StateOf;
use crate::vector::Vector;

/// The most samples of a run at even times: 2³².
const MOST_SAMPLES: f64 = 4_294_967_296.0;

/// Looking back.
// The extension is asked for at the methods, not at the implementation, so that the compiler says what to do without it.
impl<'m, R: Real, M: Mechanism<R>, F: Formulation<R, M>, S, I: Method<R>> Simulation<'m, M, R, F, S, I> {
    /// The state at `time` (s) within the last step, by the continuous extension of the integrator; at the present time the
    /// present state.
    ///
    /// Where the formulation projects, the extension ends before the projection and the present state after it; see
    /// [`Interpolate`].
    ///
    /// # Errors
    /// [`SimulationError::NotCovered`] outside the last step, and before the first.
    pub fn interpolate(&self, time: R) -> Result<StateOf<M, R>, SimulationError>
    where
        I: Interpolate<R>,
    {
        let now = self.time();
        if time == now {
            return Ok(self.run.state.clone());
        }
        let from = I::size(&self.memory).map_or(now, |size| self.run.clock.after(-size).time());
        if time >= from
            && time < now
            && let Some(state) = self.within(&Clock::at(time))
        {
            return Ok(state);
        }
        Err(SimulationError::NotCovered { time: time.to_f64(), from: from.to_f64(), to: now.to_f64() })
    }

    /// The state at a time within the last step.
    fn within(&self, time: &Clock<R>) -> Option<StateOf<M, R>>
    where
        I: Interpolate<R>,
    {
        let elapsed = I::size(&self.memory)? - time.until(&self.run.clock);
        I::at(&self.memory, self.model(), elapsed.max(R::ZERO))
    }
}

/// Moving, with samples at even times.
impl<'m, R, M, F, S, I> Simulation<'m, M, R, F, S, I>
where
    R: Real,
    M: Assemble<R>,
    F: Formulation<R, M>,
    S: InputSource<R, M>,
    I: Integrator<R, MechanismDynamics<'m, M, R, F, S>>,
{
    /// Steps until `end` (s) and shows a sample now and every `interval` seconds, up to `end`, by
    /// [`interpolate`](Simulation::interpolate): the integrator's steps are as long as without samples. Returns the state at
    /// `end`.
    ///
    /// A sample within a step has the inputs that were held over it, or those of its own time. Angles among the outputs are
    /// continued over the steps, so that they may turn by more than half a turn from sample to sample.
    ///
    /// A sample that is due within a hundredth of the interval of `end` is the one at `end`.
    ///
    /// # Errors
    /// [`SimulationError`]; the simulation then stands at the last good state. An interval that is not positive and finite, or so
    /// short that samples would have the same time, is a [`SettingError`]; more than 2³² samples are refused.
    pub fn run_every(
        &mut self,
        interval: R,
        end: R,
        mut show: impl FnMut(&Sample<'m, R, M>),
    ) -> Result<StateOf<M, R>, SimulationError>
    where
        I: Interpolate<R>,
    {
        let mut course = self.course_until(end)?;
        positive("the interval of the samples", interval, "positive and finite (s)")?;
        let begin = self.run.clock;
        if interval < R::EPSILON * begin.time().abs().max(end.abs()) {
            let (what, value) = ("the interval of the samples", interval.to_f64());
            let must_be = "at least a rounding of the times, or samples coincide";
            return Err(SettingError { what, value, must_be }.into());
        }
        check_count("samples", (begin.until(&course.goal) / interval).to_f64(), MOST_SAMPLES)?;
        // A time that rounding puts beside the end is the end.
        let goal = course.goal;
        let after = |due: Clock<R>| {
            let due = due.after(interval);
            if due.until(&goal).abs() <= R::from_f64(SLIVER) * interval { goal } else { due }
        };
        show(&self.sample());
        let mut due = after(begin);
        let mut events = 0;
        while self.is_under_way(&course) {
            if M::HOLDS && !self.run.state.gates.as_slice().is_empty() {
                // Up to a touch or release, beyond which no extension leads.
                self.advance_piece(&mut course, &mut events)?;
            } else {
                self.advance_along(&mut course)?;
            }
            while due.is_before(&self.run.clock) {
                let mut state = self.within(&due).unwrap_or_else(|| self.run.state.clone());
                let inputs = self.dynamics.inputs_within(due.time(), &state);
                if self.model().is_rigid() {
                    state.gates = self.dynamics.forces_at_rest(due.time(), &state, &inputs);
                }
                show(&self.sample_at(due.time(), state, inputs));
                due = after(due);
            }
            self.hold()?;
            let sample = self.sample();
            if !self.run.clock.is_before(&due) {
                show(&sample);
                due = after(due);
            }
        }
        Ok(self.run.state.clone())
    }
}
