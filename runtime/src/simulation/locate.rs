//! The search for events: steps, and the step that crossed a level repeated from its beginning.

use super::event::Watched;
use super::rigid::Held;
use super::{Event, MechanismDynamics, Occurrence, Run, Sample, Simulation};
use crate::error::SimulationError;
use crate::fields::Fields;
use crate::formulation::Formulation;
use crate::input::InputSource;
use crate::integrator::{Integrator, Method};
use crate::mechanism::Assemble;
use crate::real::Real;
use crate::state::Variables;

/// The most trials of one search: those of the ITP method are at most 54 in double precision; the others are for methods that
/// shorten the repeated steps.
pub(super) const TRIALS: u32 = 1000;

/// All of a simulation that a step changes.
#[derive(Clone)]
pub(super) struct Standing<Real, Run, Memory, Formulation, Inputs, Gates> {
    pub run: Run,
    memory: Memory,
    formulation: Formulation,
    inputs: Option<Inputs>,
    begun_with: Option<Inputs>,
    last_pivot: Real,
    held: Held<Gates>,
}

/// [`Standing`] of a simulation with these methods.
pub(super) type StandingOf<M, R, F, D, I> = Standing<
    R,
    Run<R, M>,
    <I as Method<R>>::Memory<M>,
    <F as Formulation<R, M>>::Memory,
    D,
    <M as Variables<R>>::Gates,
>;

/// Moving, until something happens.
impl<'m, R, M, F, S, I> Simulation<'m, M, R, F, S, I>
where
    R: Real,
    M: Assemble<R>,
    M::Outputs: Fields<R>,
    F: Formulation<R, M>,
    S: InputSource<R, M>,
    I: Integrator<R, MechanismDynamics<'m, M, R, F, S>>,
{
    /// Steps until the first of the `events`, or until `end` (s) if none happens; shows a sample now, after each step, and at
    /// the event. The simulation then stands at the event and can go on.
    ///
    /// Outputs are compared at the ends of the steps: a step must be shorter than the time in which an output crosses its
    /// level twice. The step in which one crossed is repeated from its beginning with shorter sizes, which serves every
    /// integrator and keeps its order, until the crossing is known to the least of the tolerances, or to four roundings of the step:
    /// the ITP method (Oliveira, Takahashi, ACM Trans. Math. Softw. 47 (2021) 5), which asks for at most one step more than
    /// bisection, log₂(h/tolerance) + 1; at most 1000 where a method shortens the repeated steps, and then
    /// [`EventNotLocated`](SimulationError::EventNotLocated). The earliest of several events in a step is found. One whose output is exactly at its level
    /// where the run begins has happened before: going on from an event does not find it again.
    ///
    /// Held inputs are kept while a step is repeated, and asked for again at the event; sampled ones are asked for in every
    /// repetition. Angles among the outputs are continued without jumps, so that a whole turn crosses nothing.
    ///
    /// # Errors
    /// [`SimulationError`]; the simulation then stands at the last good state. An output that does not exist, a tolerance that
    /// is not positive, a level that is not finite.
    pub fn run_until_event(
        &mut self,
        end: R,
        events: &[Event<R>],
        mut show: impl FnMut(&Sample<'m, R, M>),
    ) -> Result<Option<Occurrence<R>>, SimulationError> {
        let mut course = self.course_until(end)?;
        let watched = Watched::new(events, self.model().output_names())?;
        let sample = self.sample();
        show(&sample);
        let mut before = sample.outputs;
        while self.is_under_way(&course) {
            let begin = self.standing();
            let size = self.advance_along(&mut course)?.size;
            let after = self.outputs_after(&before);
            let found = match watched.any(&before, &after) {
                true => self.locate(&watched, begin, size, before, after.clone())?,
                false => None,
            };
            // After a search that found nothing the simulation stands at the step's end again.
            show(&self.sample());
            if found.is_some() {
                return Ok(found);
            }
            before = after;
        }
        Ok(None)
    }

    /// The first event between two ends of a step of size `size` that have one between them; the simulation is left standing there.
    ///
    /// Times are counted from the beginning of the step, so that what the clock cannot name is found too.
    #[cold]
    fn locate(
        &mut self,
        watched: &Watched<'_, R>,
        begin: StandingOf<M, R, F, M::Inputs, I>,
        size: R,
        before: M::Outputs,
        after: M::Outputs,
    ) -> Result<Option<Occurrence<R>>, SimulationError> {
        let mut base = (R::ZERO, before.clone(), begin.clone());
        let (mut low, mut high) = ((R::ZERO, before.clone()), (size, after));
        let mut found = self.standing();
        let tolerance = watched.tolerance.max(R::from_f64(4.0) * R::EPSILON * size);
        let mut search = Search::new(size, tolerance);
        let mut trials = 0;
        while high.0 - low.0 > tolerance {
            let Some(part) = watched.expected(&low.1, &high.1) else { break };
            if trials == TRIALS {
                self.stand(begin);
                let (time, width) = (self.time().to_f64(), (high.0 - low.0).to_f64());
                return Err(SimulationError::EventNotLocated { time, width, trials });
            }
            trials += 1;
            let at = search.next(low.0, high.0, part);
            self.stand(base.2.clone());
            let step = at - base.0;
            let stepped = match self.advance_by(step, self.run.clock.after(step)) {
                Ok(stepped) => stepped.size,
                Err(error) => {
                    self.stand(begin);
                    return Err(error);
                }
            };
            // A method that chooses its steps may have stopped before.
            let stopped = stepped != step;
            let reached = (if stopped { base.0 + stepped } else { at }, self.outputs_after(&before));
            if reached.0 <= low.0 {
                low = (base.0, base.1.clone());
            }
            if watched.any(&low.1, &reached.1) {
                high = reached;
                found = self.standing();
            } else {
                if stopped {
                    base = (reached.0, reached.1.clone(), self.standing());
                }
                low = reached;
            }
        }
        self.stand(found);
        Ok(watched.occurrence(self.time(), &low.1, &high.1))
    }

    /// The outputs at the end of the last step, with the inputs held over it, continued from `previous`.
    fn outputs_after(&mut self, previous: &M::Outputs) -> M::Outputs {
        let model = self.model();
        let (time, state) = (self.time(), self.run.state.clone());
        let inputs = self.dynamics.inputs_within(time, &state);
        let mut outputs = self.model().outputs(time, &state, &inputs);
        model.unwrap(&mut outputs, previous);
        outputs
    }
}

/// Back to where a simulation stood.
impl<'m, R, M, F, S, I> Simulation<'m, M, R, F, S, I>
where
    R: Real,
    M: Assemble<R>,
    F: Formulation<R, M>,
    I: Method<R>,
{
    pub(super) fn standing(&self) -> StandingOf<M, R, F, M::Inputs, I> {
        Standing {
            run: self.run.clone(),
            memory: self.memory.clone(),
            formulation: self.dynamics.memory.clone(),
            inputs: self.dynamics.inputs.clone(),
            begun_with: self.dynamics.begun_with.clone(),
            last_pivot: self.dynamics.last_pivot,
            held: self.dynamics.held.clone(),
        }
    }

    pub(super) fn stand(&mut self, standing: StandingOf<M, R, F, M::Inputs, I>) {
        self.run = standing.run;
        self.memory = standing.memory;
        self.dynamics.memory = standing.formulation;
        self.dynamics.inputs = standing.inputs;
        self.dynamics.begun_with = standing.begun_with;
        self.dynamics.last_pivot = standing.last_pivot;
        self.dynamics.held = standing.held;
    }
}

/// The choice of the next time in a bracket: regula falsi, held to the bracket that bisection would have by now.
pub(super) struct Search<R> {
    /// ε 2ⁿ⁻ʲ, half the widest bracket that is allowed after the next trial.
    radius: R,
    /// κ₁ of the truncation κ₁ (b − a)², 1/s.
    truncation: R,
    margin: R,
}

impl<R: Real> Search<R> {
    /// For a bracket at most 1/4ε times as wide as the tolerance: as many doublings as that takes, 51 in double precision.
    pub fn new(width: R, tolerance: R) -> Self {
        let two = R::from_f64(2.0);
        // ε 2ⁿ with n one more than bisection needs.
        let mut radius = tolerance;
        while radius < width {
            radius = radius * two;
        }
        Search { radius, truncation: R::from_f64(0.2) / width, margin: tolerance * R::from_f64(0.25) }
    }

    /// A time between `low` and `high`, near the part of it that is given.
    pub fn next(&mut self, low: R, high: R, part: R) -> R {
        let half = R::from_f64(0.5);
        let width = high - low;
        let middle = low + half * width;
        let off = (part - half) * width;
        // Towards the middle, so that the bracket shrinks from both sides.
        let truncation = self.truncation * width * width;
        let off = off.sign() * (off.abs() - truncation).max(R::ZERO);
        let radius = (self.radius - half * width).max(R::ZERO).min(half * width - self.margin);
        self.radius = self.radius * half;
        middle + off.max(-radius).min(radius)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trials until the bracket of a root is shorter than `tolerance`, and the bracket.
    fn trials(value: impl Fn(f64) -> f64, tolerance: f64) -> (u32, f64, f64) {
        let (mut low, mut high) = (0.0, 1.0);
        let mut search = Search::new(high - low, tolerance);
        let mut count = 0;
        while high - low > tolerance {
            let (a, b) = (value(low), value(high));
            let time = search.next(low, high, a / (a - b));
            assert!(low < time && time < high, "{low} {time} {high}");
            if value(time) >= 0.0 {
                high = time
            } else {
                low = time
            }
            count += 1;
        }
        (count, low, high)
    }

    #[test]
    fn a_smooth_root_takes_few_trials_and_a_jump_those_of_bisection() {
        let (count, low, high) = trials(|x| x * x * x - 0.2, 1e-12);
        assert!(count <= 10 && low < 0.2_f64.cbrt() && 0.2_f64.cbrt() <= high, "{count}");
        let (count, ..) = trials(|x| if x < 0.7123 { -1.0 } else { 1e6 }, 1e-12);
        assert!(count <= 41, "{count}");
        let (count, ..) = trials(|x| libm::pow(x, 25.0) - 1e-9, 1e-12);
        assert!(count <= 41, "{count}");
    }
}
