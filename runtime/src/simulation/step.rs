//! One step of a simulation: its checks, what happened in it, and the name of what went wrong.
//!
//! The methods themselves are in `integrator` and `formulation`; which steps a run takes is `course.rs`, the clock `clock.rs`,
//! samples are `sample.rs`, the stages `dynamics.rs`.

use super::dynamics::Stage;
use super::{MechanismDynamics, NearSingular, Residual, Simulation};
use crate::assembly::{singular_velocity, smallest_pivot};
use crate::clock::Clock;
use crate::condition::{far, watched};
use crate::error::SimulationError;
use crate::formulation::{Formulation, PivotOf};
use crate::input::InputSource;
use crate::integrator::{Integrator, Method, Rejections, StepFailure};
use crate::layout::first_not_unit;
use crate::mechanism::{Assemble, Mechanism, name_row};
use crate::real::Real;
use crate::state::StateOf;
use crate::tabled;
use crate::vector::Vector;

/// A start further off the constraints than this, relative to its coordinates, or with an orientation whose squared
/// length is further from one, is a mistake and not rounding.
const INCONSISTENT: f64 = 1e-6;

/// A relative pivot of D Dᵀ above which the constraints are not to blame for a breakdown.
const WELL_POSED: f64 = 1e-8;

/// What happened in a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step<R = f64> {
    /// The time at its end, s: the exact sum of the steps, rounded once.
    pub time: R,
    /// Its size, s: what was integrated.
    pub size: R,
    /// The smallest estimate of the reciprocal condition of D M⁻¹ Dᵀ, its rows brought to length one
    /// ([`reciprocal_condition`](crate::reciprocal_condition)), one is well posed, zero is a breakdown: at the step's beginning, or where the formulation softens the constraints at
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
    /// What friction by reactions left open at the step's beginning: the largest entry of M v̇ + Dᵀ λ − Q − Q_f(v̇, λ) beyond rounding, relative
    /// to the largest of Q_f. Small, or there is no one solution: the mechanism locks. Implicit methods leave nothing, and say zero.
    pub friction_residual: R,
    /// Stages that broke down and were stepped over.
    pub stepped_over: u32,
    /// Gates that opened or closed in it, where a mechanism holds them.
    pub gates_changed: u32,
    /// Events of the definition that occurred in it, ticks too.
    pub events: u32,
    /// Touches of rigid contacts, each with an impulse.
    pub impacts: u32,
    /// Rigid contacts that came to rest on each other.
    pub rested: u32,
    /// The kinetic energy that impulses took, J: ½ Σ P (−ġ⁺ − ġ⁻), and where dry friction acts the same of what slides.
    pub lost: R,
    /// What those gave that did not take any, J: Newton's law of restitution may beside friction; Poisson's does not.
    pub gained: R,
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
        if !M::HOLDS || self.run.state.gates.as_slice().is_empty() {
            self.step_by(h, clock)
        } else {
            self.advance_held(h, clock)
        }
    }

    /// The same with the gates of the state throughout.
    #[inline]
    pub(super) fn step_by(&mut self, h: R, clock: Clock<R>) -> Result<Step<R>, SimulationError> {
        let model = self.model();
        if !self.run.start_checked {
            if let Some(what) = not_finite(model, &self.run.state) {
                return Err(SimulationError::NonFinite { time: self.time().to_f64(), what });
            }
            self.check_orientations()?;
            if !self.run.start_accepted {
                self.check_start()?;
            }
            self.begin_proportion();
            self.run.start_checked = true;
        }
        let time = self.time();
        let inputs = self.dynamics.present_inputs(time, &self.run.state);
        let kept = (self.dynamics.memory.clone(), self.dynamics.last_pivot, self.run.passage);
        let memory = self.memory.clone();
        let (step, next, clock) = match self.attempt(h, clock, &inputs) {
            Ok(taken) => taken,
            Err(error) => {
                (self.dynamics.memory, self.dynamics.last_pivot, self.run.passage) = kept;
                self.memory = memory;
                return Err(error);
            }
        };
        let run = &mut self.run;
        run.reciprocal_condition = step.reciprocal_condition.min(run.reciprocal_condition);
        if let Some(found) = step.near_singular
            && run.near_singular.is_none_or(|known| found.reciprocal_condition < known.reciprocal_condition)
        {
            run.near_singular = Some(found);
        }
        run.state = next;
        run.clock = clock;
        self.dynamics.inputs = None;
        self.dynamics.begun_with = Some(inputs);
        Ok(step)
    }

    /// The step, its end and the clock there; what methods and watch remember is changed even where it fails.
    #[inline]
    #[allow(clippy::type_complexity)]
    fn attempt(
        &mut self,
        h: R,
        clock: Clock<R>,
        inputs: &M::Inputs,
    ) -> Result<(Step<R>, StateOf<M, R>, Clock<R>), SimulationError> {
        let model = self.model();
        let time = self.time();
        self.dynamics.begin(h);
        let stepped = self.integrator.step(&mut self.memory, &mut self.dynamics, time, h, &self.run.state);
        if self.dynamics.watch.locked {
            return Err(SimulationError::Locked { friction: self.contact(0), time: time.to_f64() });
        }
        let stepped = match stepped {
            Ok(stepped) => stepped,
            Err(failure) => return Err(self.diagnose_failure(time, failure, inputs)),
        };
        if let Some(failure) = &self.dynamics.watch.failure {
            return Err(self.diagnose(failure, inputs));
        }
        let clock = match stepped.size {
            size if size == h => clock,
            size if size > R::ZERO && size < h => self.run.clock.after(size),
            // No method may stand still, or go farther than it was asked to: no run would end, or end where it should.
            size => {
                let (time, step, rejections) = (time.to_f64(), size.to_f64(), stepped.rejections);
                return Err(SimulationError::StepUnderflow { time, step, rejections });
            }
        };
        let mut next = stepped.state.clone();
        let settled = match self.dynamics.settle(clock.time(), &mut next) {
            Ok(settled) => settled,
            Err(error) => {
                return Err(match not_finite(model, &stepped.state) {
                    Some(what) => self.diagnose_not_finite(time, clock.time(), what),
                    None => SimulationError::Projection { time: clock.time().to_f64(), error },
                });
            }
        };
        // Once for both: what brings a state to the constraints divides, too.
        if let Some(what) = not_finite(model, &next) {
            return Err(self.diagnose_not_finite(time, clock.time(), what));
        }
        let (reciprocal_condition, near_singular) =
            self.near_singularity((time, stepped.size), (clock.time(), &next), inputs);
        self.check_proportion(
            (time, stepped.size),
            (clock.time(), &next),
            inputs,
            (reciprocal_condition, near_singular),
        )?;
        let watch = &self.dynamics.watch;
        let step = Step {
            time: clock.time(),
            size: stepped.size,
            reciprocal_condition,
            near_singular,
            iterations: watch.iterations + stepped.iterations + settled.iterations,
            residual: watch.residual.max(stepped.residual),
            moved: settled.moved,
            rejections: stepped.rejections,
            friction_residual: watch.friction,
            stepped_over: watch.stepped_over,
            gates_changed: 0,
            events: 0,
            impacts: 0,
            rested: 0,
            lost: R::ZERO,
            gained: R::ZERO,
        };
        Ok((step, next, clock))
    }

    /// The estimate of the reciprocal condition in the step of this size from `begin` to `next`, and what it says if it is small.
    #[inline]
    fn near_singularity(
        &mut self,
        (begin, size): (R, R),
        (time, next): (R, &StateOf<M, R>),
        inputs: &M::Inputs,
    ) -> (R, Option<NearSingular<R>>) {
        let model = self.model();
        if model.row_count() == 0 {
            return (R::ONE, None);
        }
        let watch = &self.dynamics.watch;
        let of = F::pivot_of(model);
        let estimates = of == PivotOf::Rows;
        let of_jacobian = matches!(of, PivotOf::Jacobian | PivotOf::JacobianOrRows);
        let is_far = of_jacobian && self.run.passage.is_far(watch.smallest_pivot);
        if is_far && self.run.passage.is_new() {
            return (watch.smallest_pivot, None);
        }
        let (into, condition, smallest) = if estimates {
            let smallest = watch.smallest_pivot;
            let (into, at, q) =
                if watch.observed { (size, time, &next.q) } else { (R::ZERO, begin, &self.run.state.q) };
            let mut least = smallest;
            if !R::any(watch.first_pivot.greater_equal(far())) {
                least = self.condition(at, q).min(smallest);
            }
            (into, watch.first_pivot, least)
        } else {
            let condition = self.condition_at(of, time, next, inputs);
            (size, condition, condition)
        };
        // Independent velocities serve where their pivot is larger than that.
        let worst = watch.worst.as_ref().filter(|_| estimates || of == PivotOf::JacobianOrRows);
        let mut began = None;
        if !estimates && self.run.passage.is_new() {
            // Of the steps that are near a parabola takes also the one before.
            let before = self.condition_at(of, begin, &self.run.state, inputs);
            self.run.passage.see(R::ZERO, before);
            began = Some(before).filter(|before| !R::any(before.greater_equal(R::NEAR_SINGULAR)));
        }
        let passed = self.run.passage.see(into, condition);
        self.run.passage.end_step(size);
        if is_far {
            self.run.passage.forget();
        }
        // Written so that a NaN is seen.
        if let Some(stage) = worst {
            (smallest, Some(name_singularity(self.model(), stage.time, stage.pivot, &stage.state.q)))
        } else if let Some(before) = began.filter(|before| !R::any(smallest.less(*before))) {
            (before, Some(name_singularity(self.model(), begin, before, &self.run.state.q)))
        } else if !R::any(smallest.greater_equal(R::NEAR_SINGULAR)) {
            (smallest, Some(name_singularity(self.model(), time, smallest, &next.q)))
        } else if let Some((into, least)) = passed {
            (least, Some(name_singularity(self.model(), begin + into, least, &next.q)))
        } else {
            (smallest, None)
        }
    }

    /// The same at a state, by a pivot of the accelerations where that is large.
    #[cold]
    fn condition_at(&self, of: PivotOf, time: R, state: &StateOf<M, R>, inputs: &M::Inputs) -> R {
        let model = self.model();
        let pivot = if of == PivotOf::JacobianOrRows {
            model.acceleration(time, state, inputs, &mut model.zero_v(), &mut model.zero_lambda())
        } else {
            R::ZERO
        };
        if R::any(pivot.greater_equal(far())) { pivot } else { self.condition(time, &state.q) }
    }

    /// The estimate of the reciprocal condition of D M⁻¹ Dᵀ at a position.
    #[cold]
    fn condition(&self, time: R, q: &M::Q) -> R {
        watched(self.model(), time, q)
    }

    /// Why the integrator took no step.
    #[cold]
    fn diagnose_failure(&self, begin: R, failure: StepFailure<R>, inputs: &M::Inputs) -> SimulationError {
        let model = self.model();
        let time = begin.to_f64();
        match failure {
            StepFailure::Breakdown => {
                // Without a failure on record the pivots were good and the accelerations not finite.
                let unknown =
                    Stage { time: begin, pivot: R::from_f64(f64::NAN), state: self.run.state.clone() };
                self.diagnose(self.dynamics.watch.failure.as_ref().unwrap_or(&unknown), inputs)
            }
            StepFailure::Underflow { size, rejections } => {
                SimulationError::StepUnderflow { time, step: size.to_f64(), rejections }
            }
            StepFailure::Singular { .. } => {
                let row = tabled::weakest_row(self.model(), self.time(), &self.run.state.q);
                SimulationError::Breakdown { time, pivot: 0.0, row: name_row(model, row) }
            }
            StepFailure::NoConvergence { iterations, residual } => {
                SimulationError::NoConvergence { time, iterations, residual: residual.to_f64() }
            }
        }
    }

    /// The start's pairs and quaternions must have length 1: equations take it for granted, and motion only keeps it.
    #[cold]
    fn check_orientations(&self) -> Result<(), SimulationError> {
        let model = self.model();
        let tolerance = R::from_f64(INCONSISTENT).max(R::EPSILON.sqrt());
        match first_not_unit(model.layout(), &self.run.state.q, tolerance) {
            None => Ok(()),
            Some((first, length)) => Err(SimulationError::NotNormalised {
                time: self.time().to_f64(),
                what: position_name(model, first),
                length: length.to_f64(),
            }),
        }
    }

    /// The start must satisfy the constraints: by position to [`INCONSISTENT`] of the size of the coordinates, by
    /// velocity to the root of that.
    #[cold]
    fn check_start(&self) -> Result<(), SimulationError> {
        let (model, time, state) = (self.model(), self.time(), &self.run.state);
        let mut phi = model.zero_lambda();
        model.constraints(time, &state.q, &mut phi);
        let residual = Residual::of(model, time, state);
        let counted = state.q.as_slice().len() - 2 * model.layout().angles.len();
        let plain = state.q.as_slice()[..counted].iter().fold(R::ONE, |largest, x| largest.max(x.abs()));
        let tolerance = R::from_f64(INCONSISTENT).max(R::EPSILON.sqrt());
        let off = residual.position > tolerance * plain * plain;
        let fast = residual.velocity > tolerance.sqrt() * plain * (R::ONE + state.v.max_abs());
        if !off && !fast {
            return Ok(());
        }
        let rows = phi.as_slice().iter().zip(model.rows());
        let worst = rows.fold((R::ZERO, None), |worst, (value, row)| {
            if value.abs() > worst.0 || worst.1.is_none() { (value.abs(), Some(*row)) } else { worst }
        });
        Err(SimulationError::Inconsistent {
            time: time.to_f64(),
            row: worst.1.unwrap_or_else(|| name_row(model, None)),
            position: residual.position.to_f64(),
            velocity: residual.velocity.to_f64(),
        })
    }
}

/// Names of what went wrong.
impl<'m, R: Real, M: Assemble<R>, F: Formulation<R, M>, S, I: Method<R>> Simulation<'m, M, R, F, S, I> {
    /// v̇ and λ at the present state, if they mean something.
    pub(super) fn solved(&mut self) -> Result<(M::V, M::Lambda), SimulationError>
    where
        S: InputSource<R, M>,
    {
        self.dynamics.formulation.check()?;
        let (time, state) = (self.time(), self.run.state.clone());
        let inputs = self.dynamics.present_inputs(time, &state);
        let (a, lambda, pivot) = self.dynamics.evaluate(time, &state, &inputs);
        let finite = a.first_not_finite().is_none() && lambda.first_not_finite().is_none();
        // Written so that a NaN fails.
        if finite && R::any(pivot.greater_equal(R::BREAKDOWN)) {
            return Ok((a, lambda));
        }
        let lost = R::any(pivot.less(R::BREAKDOWN));
        let pivot = if lost { pivot } else { R::from_f64(f64::NAN) };
        Err(self.diagnose(&Stage { time, pivot, state }, &inputs))
    }

    /// A state without numbers: the joint, if the step began where the constraints lose rank, else the coordinate.
    #[cold]
    fn diagnose_not_finite(&self, begin: R, end: R, what: &'static str) -> SimulationError {
        let model = self.model();
        let (pivot, row) = smallest_pivot(self.model(), begin, &self.run.state.q);
        match row {
            Some(_) if pivot < R::BREAKDOWN => {
                let (time, pivot) = (begin.to_f64(), pivot.to_f64());
                SimulationError::Breakdown { time, pivot, row: name_row(model, row) }
            }
            _ => SimulationError::NonFinite { time: end.to_f64(), what },
        }
    }

    /// The error that names what failed: the joint whose row depends on others, the body without mass, or the
    /// coordinate that is no number.
    #[cold]
    fn diagnose(&self, failure: &Stage<R, StateOf<M, R>>, inputs: &M::Inputs) -> SimulationError {
        let model = self.model();
        let Stage { time: stage, pivot, state } = failure;
        let (time, pivot) = (stage.to_f64(), pivot.to_f64());
        if let Some(what) = not_finite(model, state) {
            return SimulationError::NonFinite { time, what };
        }
        if pivot.is_nan() {
            let (a, lambda, _) = self.dynamics.evaluate(*stage, state, inputs);
            let velocity = a.first_not_finite().and_then(|i| model.velocity_names().get(i)).copied();
            let row = || lambda.first_not_finite().and_then(|i| model.rows().get(i)).map(|row| row.of);
            return SimulationError::NonFinite { time, what: velocity.or_else(row).unwrap_or(model.name()) };
        }
        let (constraints, row) = smallest_pivot(model, *stage, &state.q);
        if constraints > R::from_f64(WELL_POSED)
            && let Some(velocity) = singular_velocity(model, *stage, &state.q)
        {
            let velocity = model.velocity_names().get(velocity).copied().unwrap_or(model.name());
            return SimulationError::SingularMass { time, pivot, velocity };
        }
        SimulationError::Breakdown { time, pivot, row: name_row(model, row) }
    }
}

/// A position near a singular one, with the name of the row that depends most on the others.
#[cold]
pub(crate) fn name_singularity<R: Real, M: Assemble<R>>(
    model: &M,
    time: R,
    reciprocal_condition: R,
    q: &M::Q,
) -> NearSingular<R> {
    let row = tabled::weakest_row(model, time, q);
    NearSingular { time, row: name_row(model, row), reciprocal_condition }
}

/// The name of the first coordinate, velocity or internal state that is infinite or NaN.
#[inline]
fn not_finite<R: Real, M: Mechanism<R>>(model: &M, state: &StateOf<M, R>) -> Option<&'static str> {
    let name = |names: &[&'static str], i: usize| names.get(i).copied().unwrap_or(model.name());
    let in_q = state.q.first_not_finite().map(|i| position_name(model, i));
    let in_v = || state.v.first_not_finite().map(|i| name(model.velocity_names(), i));
    let in_z = || state.z.first_not_finite().map(|i| name(model.internal_names(), i));
    in_q.or_else(in_v).or_else(in_z)
}

fn position_name<R: Real, M: Mechanism<R>>(model: &M, index: usize) -> &'static str {
    model.position_names().get(index).copied().unwrap_or(model.name())
}
