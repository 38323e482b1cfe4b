//! Runs: how far they go, in which steps, and what is refused before anything moves.
//!
//! One step is `step.rs`, the clock `clock.rs`.

use super::{MechanismDynamics, Simulation, Step};
use crate::clock::{Clock, least_step};
use crate::error::SimulationError;
use crate::formulation::{Formulation, not_negative};
use crate::input::InputSource;
use crate::integrator::{Integrator, Method};
use crate::mechanism::{Assemble, Mechanism};
use crate::real::Real;

/// More steps than this cannot be counted by anybody: 2⁵³.
pub(super) const MOST_STEPS: f64 = 9_007_199_254_740_992.0;

/// The part of a step, or of the distance between samples, that is no step or sample of its own.
pub(super) const SLIVER: f64 = 0.01;

/// A run under way.
#[derive(Clone, Copy, Debug)]
pub(super) struct Course<R> {
    pub goal: Clock<R>,
    /// The size of the steps, s.
    h: R,
    /// Steps that may still be taken.
    steps: u64,
}

impl<R: Real, M: Mechanism<R>, F: Formulation<R, M>, S, I: Method<R>> Simulation<'_, M, R, F, S, I> {
    /// Whether the run goes on.
    #[inline]
    pub(super) fn is_under_way(&self, course: &Course<R>) -> bool {
        self.run.clock.is_before(&course.goal)
    }

    /// The step size, if it, the time, the formulation and the integrator make sense.
    pub(super) fn checked_step(&self) -> Result<R, SimulationError> {
        let given = self.run.step.or_else(|| self.integrator.largest_step());
        let h = given.ok_or(SimulationError::StepMissing)?;
        if !(h > R::ZERO && h.is_finite()) {
            return Err(SimulationError::Step { step: h.to_f64() });
        }
        let time = self.time();
        if !(time + h).is_finite() {
            let time = if time.is_finite() { time + h } else { time };
            return Err(SimulationError::TimeNotFinite { time: time.to_f64() });
        }
        check_moves(time, h)?;
        self.dynamics.formulation.check()?;
        self.integrator.check()?;
        Ok(h)
    }

    /// The run to `end`, if that and all else makes sense.
    pub(super) fn course_until(&self, end: R) -> Result<Course<R>, SimulationError> {
        let h = self.checked_step()?;
        let (time, clock) = (self.time(), &self.run.clock);
        if !(end >= time && end.is_finite()) {
            return Err(SimulationError::End { time: time.to_f64(), end: end.to_f64() });
        }
        let goal = Clock::at(end);
        // The clock shows the end already, and what is left to it is no step of its own.
        let is_there = end == time && clock.until(&goal) <= h * R::from_f64(SLIVER);
        self.course(if is_there { *clock } else { goal }, h)
    }

    /// The run of so many seconds, if that and all else makes sense.
    pub(super) fn course_for(&self, seconds: R) -> Result<Course<R>, SimulationError> {
        let h = self.checked_step()?;
        not_negative("the time to advance for", seconds, "zero or positive, and finite (s)")?;
        let goal = self.run.clock.after(seconds);
        if !goal.time().is_finite() {
            return Err(SimulationError::TimeNotFinite { time: goal.time().to_f64() });
        }
        if seconds > R::ZERO {
            check_moves(self.time(), seconds)?;
        }
        self.course(goal, h)
    }

    fn course(&self, goal: Clock<R>, h: R) -> Result<Course<R>, SimulationError> {
        check_count("steps", (self.run.clock.until(&goal) / h).to_f64(), MOST_STEPS)?;
        check_moves(goal.time(), h)?;
        Ok(Course { goal, h, steps: self.integrator.most_steps() })
    }
}

impl<'m, R, M, F, S, I> Simulation<'m, M, R, F, S, I>
where
    R: Real,
    M: Assemble<R>,
    F: Formulation<R, M>,
    S: InputSource<R, M>,
    I: Integrator<R, MechanismDynamics<'m, M, R, F, S>>,
{
    /// One step of the run: of its size, or what is left. A step may be longer by a hundredth rather than leave a sliver, so that
    /// of a time that is a multiple of the step size but for rounding no step is left over and none is lost.
    #[inline]
    pub(super) fn advance_along(&mut self, course: &mut Course<R>) -> Result<Step<R>, SimulationError> {
        let (h, end) = self.next_along(course)?;
        self.advance_by(h, end)
    }

    /// Its size, and the clock at its end.
    #[inline]
    pub(super) fn next_along(&self, course: &mut Course<R>) -> Result<(R, Clock<R>), SimulationError> {
        if course.steps == 0 {
            let (time, steps) = (self.time().to_f64(), self.integrator.most_steps());
            return Err(SimulationError::TooManySteps { time, end: course.goal.time().to_f64(), steps });
        }
        course.steps -= 1;
        let clock = self.run.clock;
        let (left, there) = clock.step_to(&course.goal);
        let h = course.h;
        if left > h * R::from_f64(1.0 + SLIVER) {
            return Ok((h, clock.after(h)));
        }
        Ok((left, there))
    }
}

/// An error if a step of this size would leave the clock standing.
fn check_moves<R: Real>(time: R, step: R) -> Result<(), SimulationError> {
    let least = least_step(time);
    if step >= least {
        return Ok(());
    }
    let (time, step, least) = (time.to_f64(), step.to_f64(), least.to_f64());
    Err(SimulationError::TimeStands { time, step, least })
}

/// An error if a count is too large. Written so that a NaN fails.
pub(super) fn check_count(what: &'static str, count: f64, most: f64) -> Result<(), SimulationError> {
    if count <= most { Ok(()) } else { Err(SimulationError::TooMany { what, count, most }) }
}
