//! What lies between the steps: states and samples by dense output.

use super::{MechanismDynamics, Sample, Simulation};
use crate::error::SimulationError;
use crate::formulation::{Formulation, positive};
use crate::input::InputSource;
use crate::integrator::{Integrator, Interpolate, Method};
use crate::mechanism::{Assemble, Mechanism};
use crate::real::Real;
use crate::state::State;

/// A time closer to another than this part of the distance between samples is the same.
const SAME: f64 = 1e-6;

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
    pub fn interpolate(&self, time: R) -> Result<State<M::Q, M::V>, SimulationError>
    where
        I: Interpolate<R>,
    {
        let now = self.time();
        if time == now {
            return Ok(self.run.state);
        }
        let rounding = |from: R| R::from_f64(8.0) * R::EPSILON * (from.abs() + now.abs());
        // A step that ended elsewhere is of another start time.
        let from = match I::covers(&self.memory) {
            Some((from, to)) if (to - now).abs() <= rounding(from) => from,
            _ => now,
        };
        if time >= from
            && time < now
            && let Some(state) = I::at(&self.memory, &M::LAYOUT, time)
        {
            return Ok(state);
        }
        Err(SimulationError::NotCovered { time: time.to_f64(), from: from.to_f64(), to: now.to_f64() })
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
    /// # Errors
    /// [`SimulationError`]; the simulation then stands at the last good state. An interval that is not positive and finite
    /// is a [`SettingError`](crate::SettingError).
    pub fn run_every(
        &mut self,
        interval: R,
        end: R,
        mut show: impl FnMut(&Sample<'m, R, M>),
    ) -> Result<State<M::Q, M::V>, SimulationError>
    where
        I: Interpolate<R>,
    {
        let h = self.checked_run(end)?;
        positive("the interval of the samples", interval, "positive and finite (s)")?;
        let begin = self.time();
        let mut count = 0_u64;
        // The next time, counted from the beginning; what rounding puts beside the end is the end.
        let mut next = || {
            count += 1;
            let time = begin + R::from_f64(count as f64) * interval;
            if (time - end).abs() <= R::from_f64(SAME) * interval { end } else { time }
        };
        show(&self.sample());
        let mut due = next();
        while self.time() < end {
            self.advance_towards(end, h)?;
            while due < self.time() {
                let state = self.interpolate(due)?;
                let inputs = self.dynamics.inputs_within(due, &state);
                show(&self.sample_at(due, state, inputs));
                due = next();
            }
            let sample = self.sample();
            if due == sample.time {
                show(&sample);
                due = next();
            }
        }
        Ok(self.run.state)
    }
}
