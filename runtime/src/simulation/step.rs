//! One step of a simulation: its checks, what happened in it, and the name of what went wrong.
//!
//! The methods themselves are in `integrator` and `formulation`; which steps a run takes is `course.rs`, the clock `clock.rs`,
//! samples are `sample.rs`, the stages `dynamics.rs`.

use super::clock::Clock;
use super::dynamics::Stage;
use super::singularity::Passage;
use super::{MechanismDynamics, NearSingular, Residual, Simulation};
use crate::assembly::{singular_velocity, smallest_pivot};
use crate::condition::{far, reciprocal_condition};
use crate::error::SimulationError;
use crate::formulation::{Formulation, PivotOf};
use crate::input::InputSource;
use crate::integrator::{Integrator, Rejections, StepFailure};
use crate::layout::first_not_unit;
use crate::mechanism::{Assemble, Mechanism, Row};
use crate::real::Real;
use crate::state::State;
use crate::tabled;
use crate::vector::Vector;

/// A start further off the constraints than this, relative to its coordinates, or with an orientation whose squared
/// length is further from one, is a mistake and not rounding.
const INCONSISTENT: f64 = 1e-6;

/// A relative pivot of D Dᵀ above which the constraints are not to blame for a breakdown.
const WELL_POSED: f64 = 1e-8;

/// D whose pivots have squares above this, relative to their rows, is far from losing rank.
const FAR_FROM_SINGULAR: f64 = 1e-2;

/// What happened in a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step<R = f64> {
    /// The time at its end, s: the exact sum of the steps, rounded once.
    pub time: R,
    /// Its size, s: what was integrated.
    pub size: R,
    /// The smallest relative pivot of the factorisations made: one is well posed, zero is a breakdown.
    pub smallest_pivot: R,
    /// The smallest estimate of the reciprocal condition of D M⁻¹ Dᵀ, its rows brought to length one
    /// ([`reciprocal_condition`](crate::reciprocal_condition)): at the step's beginning, or where the formulation softens the constraints at
    /// its end; or a smaller pivot of a stage; or what a parabola through the last steps has between them. Where a pivot is large it
    /// stands for the condition: in independent velocities the pivot of D, squared.
    pub reciprocal_condition: R,
    /// The position nearest to a singular one, if one was nearly singular or was passed within the last two steps.
    pub near_singular: Option<NearSingular<R>>,
    /// Iterations of formulation, integrator and projection together.
    pub iterations: u32,
    /// What the last iterations changed: of an acceleration relative to the largest, or relative to what may remain.
    pub residual: R,
    /// How far a projection moved a coordinate at most, m or rad.
    pub moved: R,
    /// Trials that were given up, by reason.
    pub rejections: Rejections,
    /// Stages that broke down and were stepped over.
    pub stepped_over: u32,
}

impl<'m, R, M, F, S, I> Simulation<'m, M, R, F, S, I>
where
    R: Real,
    M: Assemble<R>,
    F: Formulation<R, M>,
    S: InputSource<R, M>,
    I: Integrator<R, MechanismDynamics<'m, M, R, F, S>>,
{
    /// One step of size `h`, after which the clock shows `clock`; an error leaves everything as it was.
    #[inline]
    pub(super) fn advance_by(&mut self, h: R, clock: Clock<R>) -> Result<Step<R>, SimulationError> {
        if !self.run.start_checked {
            self.check_orientations()?;
            if !self.run.start_accepted {
                self.check_start()?;
            }
            self.run.start_checked = true;
        }
        let (time, begin) = (self.time(), self.run.state);
        let inputs = self.dynamics.present_inputs(time, &begin);
        self.dynamics.begin(h);
        let (before, mut memory) = (self.dynamics.memory, self.memory);
        let outcome = self.integrator.step(&mut memory, &mut self.dynamics, time, h, &begin);
        let failed = |simulation: &mut Self, error| {
            simulation.dynamics.memory = before;
            Err(error)
        };
        let stepped = match outcome {
            Ok(stepped) => stepped,
            Err(failure) => {
                let error = self.diagnose_failure(time, failure, &inputs);
                return failed(self, error);
            }
        };
        if let Some(failure) = self.dynamics.watch.failure {
            let error = self.diagnose(&failure, &inputs);
            return failed(self, error);
        }
        let clock = match stepped.size {
            size if size == h => clock,
            size if size > R::ZERO && size < h => self.run.clock.after(size),
            // No method may stand still, or go farther than it was asked to: no run would end, or end where it should.
            size => {
                let (time, step, rejections) = (time.to_f64(), size.to_f64(), stepped.rejections);
                return failed(self, SimulationError::StepUnderflow { time, step, rejections });
            }
        };
        let mut next = stepped.state;
        if let Some(what) = not_finite::<R, M>(&next) {
            let error = self.diagnose_not_finite(time, clock.time(), what);
            return failed(self, error);
        }
        let settled = match self.dynamics.settle(clock.time(), &mut next) {
            Ok(settled) => settled,
            Err(error) => {
                let error = SimulationError::Projection { time: clock.time().to_f64(), error };
                return failed(self, error);
            }
        };
        let near_singular = self.near_singularity(time, (clock.time(), &next));
        let watch = &self.dynamics.watch;
        let step = Step {
            time: clock.time(),
            size: stepped.size,
            smallest_pivot: watch.smallest_pivot,
            reciprocal_condition: near_singular.0,
            near_singular: near_singular.1,
            iterations: watch.iterations + stepped.iterations + settled.iterations,
            residual: watch.residual.max(stepped.residual),
            moved: settled.moved,
            rejections: stepped.rejections,
            stepped_over: watch.stepped_over,
        };
        let run = &mut self.run;
        run.smallest_pivot = step.smallest_pivot.min(run.smallest_pivot);
        if let Some(found) = step.near_singular
            && run.near_singular.is_none_or(|known| found.reciprocal_condition < known.reciprocal_condition)
        {
            run.near_singular = Some(found);
        }
        run.state = next;
        run.clock = clock;
        self.memory = memory;
        self.dynamics.inputs = None;
        self.dynamics.begun_with = Some(inputs);
        Ok(step)
    }

    /// The estimate of the reciprocal condition in the step from `begin` to `next`, and what it says if it is small.
    #[inline]
    fn near_singularity(
        &mut self,
        begin: R,
        (time, next): (R, &State<M::Q, M::V>),
    ) -> (R, Option<NearSingular<R>>) {
        if M::Lambda::LEN == 0 {
            return (R::ONE, None);
        }
        let watch = &self.dynamics.watch;
        let estimates = F::PIVOT == PivotOf::Rows;
        let is_far = F::PIVOT == PivotOf::Jacobian
            && R::any(watch.smallest_pivot.greater_equal(R::from_f64(FAR_FROM_SINGULAR)));
        if is_far && self.run.passage.is_new() {
            return (watch.smallest_pivot, None);
        }
        let (at, condition, smallest) = if estimates {
            let (observed, smallest) = (watch.observed, watch.smallest_pivot);
            let mut least = smallest;
            if !R::any(watch.first_pivot.greater_equal(far())) {
                let q = if observed.is_some() { &next.q } else { &self.run.state.q };
                least = self.condition(observed.unwrap_or(begin), q).min(smallest);
            }
            (observed.unwrap_or(begin), watch.first_pivot, least)
        } else {
            let condition = self.condition(time, &next.q);
            (time, condition, condition)
        };
        let worst = watch.worst.filter(|_| estimates);
        if !estimates && self.run.passage.is_new() {
            // Of the steps that are near a parabola takes also the one before.
            let before = self.condition(begin, &self.run.state.q);
            self.run.passage.see(begin, before);
        }
        let passed = self.run.passage.see(at, condition);
        if is_far {
            self.run.passage = Passage::new();
        }
        // Written so that a NaN is seen.
        if let Some(stage) = worst {
            (smallest, Some(self.name_singularity(stage.time, stage.pivot, &stage.state.q)))
        } else if !R::any(smallest.greater_equal(R::NEAR_SINGULAR)) {
            (smallest, Some(self.name_singularity(time, smallest, &next.q)))
        } else if let Some((time, least)) = passed {
            (least, Some(self.name_singularity(time, least, &next.q)))
        } else {
            (smallest, None)
        }
    }

    /// The estimate of the reciprocal condition of D M⁻¹ Dᵀ at a position.
    #[cold]
    fn condition(&self, time: R, q: &M::Q) -> R {
        reciprocal_condition(self.model(), time, q)
    }

    #[cold]
    fn name_singularity(&self, time: R, reciprocal_condition: R, q: &M::Q) -> NearSingular<R> {
        let row = tabled::weakest_row(self.model(), time, q);
        let row = row.map_or(Row { of: M::NAME, what: "constraints" }, |row| M::ROWS[row]);
        NearSingular { time, row, reciprocal_condition }
    }

    /// Why the integrator took no step.
    #[cold]
    fn diagnose_failure(&self, begin: R, failure: StepFailure<R>, inputs: &M::Inputs) -> SimulationError {
        let time = begin.to_f64();
        match failure {
            StepFailure::Breakdown => {
                // Without a failure on record the pivots were good and the accelerations not finite.
                let unknown = Stage { time: begin, pivot: R::from_f64(f64::NAN), state: self.run.state };
                self.diagnose(self.dynamics.watch.failure.as_ref().unwrap_or(&unknown), inputs)
            }
            StepFailure::Underflow { size, rejections } => {
                SimulationError::StepUnderflow { time, step: size.to_f64(), rejections }
            }
            StepFailure::Singular { .. } => {
                let row = tabled::weakest_row(self.model(), self.time(), &self.run.state.q);
                let row = row.map_or(Row { of: M::NAME, what: "constraints" }, |row| M::ROWS[row]);
                SimulationError::Breakdown { time, pivot: 0.0, row }
            }
            StepFailure::NoConvergence { iterations, residual } => {
                SimulationError::NoConvergence { time, iterations, residual: residual.to_f64() }
            }
        }
    }

    /// The start's pairs and quaternions must have length 1: equations take it for granted, and motion only keeps it.
    #[cold]
    fn check_orientations(&self) -> Result<(), SimulationError> {
        let tolerance = R::from_f64(INCONSISTENT).max(R::EPSILON.sqrt());
        match first_not_unit(&M::LAYOUT, &self.run.state.q, tolerance) {
            None => Ok(()),
            Some((first, length)) => Err(SimulationError::NotNormalised {
                time: self.time().to_f64(),
                what: position_name::<R, M>(first),
                length: length.to_f64(),
            }),
        }
    }

    /// The start must satisfy the constraints: by position to [`INCONSISTENT`] of the size of the coordinates, by
    /// velocity to the root of that.
    #[cold]
    fn check_start(&self) -> Result<(), SimulationError> {
        let (model, time, state) = (self.model(), self.time(), &self.run.state);
        let mut phi = M::Lambda::zero();
        model.constraints(time, &state.q, &mut phi);
        let residual = Residual::of(model, time, state);
        let counted = state.q.as_slice().len() - 2 * M::LAYOUT.angles.len();
        let plain = state.q.as_slice()[..counted].iter().fold(R::ONE, |largest, x| largest.max(x.abs()));
        let tolerance = R::from_f64(INCONSISTENT).max(R::EPSILON.sqrt());
        let off = residual.position > tolerance * plain * plain;
        let fast = residual.velocity > tolerance.sqrt() * plain * (R::ONE + state.v.max_abs());
        if !off && !fast {
            return Ok(());
        }
        let rows = phi.as_slice().iter().zip(M::ROWS);
        let worst = rows.fold((R::ZERO, None), |worst, (value, row)| {
            if value.abs() > worst.0 || worst.1.is_none() { (value.abs(), Some(*row)) } else { worst }
        });
        Err(SimulationError::Inconsistent {
            time: time.to_f64(),
            row: worst.1.unwrap_or(Row { of: M::NAME, what: "constraints" }),
            position: residual.position.to_f64(),
            velocity: residual.velocity.to_f64(),
        })
    }

    /// A state without numbers: the joint, if the step began where the constraints lose rank, else the coordinate.
    #[cold]
    fn diagnose_not_finite(&self, begin: R, end: R, what: &'static str) -> SimulationError {
        let (pivot, row) = smallest_pivot(self.model(), begin, &self.run.state.q);
        match row {
            Some(row) if pivot < R::BREAKDOWN => {
                SimulationError::Breakdown { time: begin.to_f64(), pivot: pivot.to_f64(), row: M::ROWS[row] }
            }
            _ => SimulationError::NonFinite { time: end.to_f64(), what },
        }
    }

    /// The error that names what failed: the joint whose row depends on others, the body without mass, or the
    /// coordinate that is no number.
    #[cold]
    fn diagnose(&self, failure: &Stage<R, M::Q, M::V>, inputs: &M::Inputs) -> SimulationError {
        let model = self.model();
        let Stage { time: stage, pivot, state } = failure;
        let (time, pivot) = (stage.to_f64(), pivot.to_f64());
        if let Some(what) = not_finite::<R, M>(state) {
            return SimulationError::NonFinite { time, what };
        }
        if pivot.is_nan() {
            let (mut a, mut lambda) = (M::V::zero(), M::Lambda::zero());
            let (mut memory, mut state) = (self.dynamics.memory, *state);
            let formulation = &self.dynamics.formulation;
            formulation.acceleration(&mut memory, model, *stage, &mut state, inputs, &mut a, &mut lambda);
            let velocity = a.first_not_finite().and_then(|i| M::VELOCITY_NAMES.get(i));
            return SimulationError::NonFinite { time, what: velocity.copied().unwrap_or(M::NAME) };
        }
        let (constraints, row) = smallest_pivot(model, *stage, &state.q);
        if constraints > R::from_f64(WELL_POSED)
            && let Some(velocity) = singular_velocity(model, *stage, &state.q)
        {
            return SimulationError::SingularMass { time, pivot, velocity: M::VELOCITY_NAMES[velocity] };
        }
        let row = row.map_or(Row { of: M::NAME, what: "constraints" }, |row| M::ROWS[row]);
        SimulationError::Breakdown { time, pivot, row }
    }
}

/// The name of the first coordinate or velocity that is infinite or NaN.
#[inline]
fn not_finite<R: Real, M: Mechanism<R>>(state: &State<M::Q, M::V>) -> Option<&'static str> {
    let velocity_name = |i: usize| M::VELOCITY_NAMES.get(i).copied().unwrap_or(M::NAME);
    let in_q = state.q.first_not_finite().map(position_name::<R, M>);
    in_q.or_else(|| state.v.first_not_finite().map(velocity_name))
}

fn position_name<R: Real, M: Mechanism<R>>(index: usize) -> &'static str {
    M::POSITION_NAMES.get(index).copied().unwrap_or(M::NAME)
}
