//! One step of a simulation: its checks, its stages, and the name of what went wrong.
//!
//! The methods themselves are in `integrator` and `formulation`; clock and samples are in `mod.rs` and `sample.rs`.

use super::{Clock, Residual, Simulation};
use crate::assembly::{singular_velocity, smallest_pivot};
use crate::error::SimulationError;
use crate::formulation::Formulation;
use crate::input::InputSource;
use crate::integrator::{Dynamics, Integrator};
use crate::layout::{Layout, first_not_unit};
use crate::mechanism::{Assemble, Mechanism, Row};
use crate::real::Real;
use crate::state::State;
use crate::vector::Vector;

/// A start further off the constraints than this, relative to its coordinates, or with an orientation whose squared
/// length is further from one, is a mistake and not rounding.
const INCONSISTENT: f64 = 1e-6;

/// A relative pivot of D Dᵀ above which the constraints are not to blame for a breakdown.
const WELL_POSED: f64 = 1e-8;

impl<'m, R: Real, M: Assemble<R>, F: Formulation<R>, S, I: Integrator<R>> Simulation<'m, M, R, F, S, I> {
    /// The step size, if it and the formulation make sense.
    pub(super) fn checked_step(&self) -> Result<R, SimulationError> {
        let h = self.run.step.ok_or(SimulationError::StepMissing)?;
        if !(h > R::ZERO && h.is_finite()) {
            return Err(SimulationError::Step { step: h.to_f64() });
        }
        self.formulation.check()?;
        Ok(h)
    }

    /// The step size, if it, the formulation and `end` make sense.
    pub(super) fn checked_run(&self, end: R) -> Result<R, SimulationError> {
        let h = self.checked_step()?;
        let time = self.time();
        if !(end >= time && end.is_finite()) {
            return Err(SimulationError::End { time: time.to_f64(), end: end.to_f64() });
        }
        Ok(h)
    }

    /// One step of size `h`, or the shorter one that is left before `end`.
    #[inline]
    pub(super) fn advance_towards(&mut self, end: R, h: R) -> Result<(), SimulationError>
    where
        S: InputSource<R, M>,
    {
        let time = self.time();
        let left = end - time;
        // A step may be longer by a millionth, or by the rounding of the clock, rather than leave a sliver.
        let slack = h * R::from_f64(1e-6) + (time.abs() + end.abs()) * (R::EPSILON + R::EPSILON);
        if left > h + slack {
            return self.advance_by(h, self.run.clock.after(h));
        }
        let h = if (left - h).abs() <= slack { h } else { left };
        self.advance_by(h, Clock::at(end))
    }

    /// One step of size `h`, after which the clock shows `clock`; an error leaves everything as it was.
    #[inline]
    pub(super) fn advance_by(&mut self, h: R, clock: Clock<R>) -> Result<(), SimulationError>
    where
        S: InputSource<R, M>,
    {
        if !self.run.start_checked {
            self.check_orientations()?;
            if !self.run.start_accepted {
                self.check_start()?;
            }
            self.run.start_checked = true;
        }
        let inputs = self.present_inputs();
        let time = self.time();
        let mut stages = Stages {
            model: self.run.model,
            formulation: &self.formulation,
            source: &mut self.source,
            inputs,
            started: false,
            smallest_pivot: self.run.smallest_pivot,
            failure: None,
        };
        let next = self.integrator.step(&mut stages, time, h, &self.run.state);
        let (smallest_pivot, failure) = (stages.smallest_pivot, stages.failure);
        if let Some(failure) = failure {
            return Err(self.diagnose(&failure, &inputs));
        }
        if let Some(what) = not_finite::<R, M>(&next) {
            return Err(self.diagnose_not_finite(time, clock.time, what));
        }
        self.run.smallest_pivot = smallest_pivot;
        self.run.state = next;
        self.run.clock = clock;
        self.run.inputs = None;
        Ok(())
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
        let (model, time, state) = (self.run.model, self.time(), &self.run.state);
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
        let (pivot, row) = smallest_pivot(self.run.model, begin, &self.run.state.q);
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
    fn diagnose(&self, failure: &Failure<R, M::Q, M::V>, inputs: &M::Inputs) -> SimulationError {
        let model = self.run.model;
        let Failure { time: stage, pivot, state } = failure;
        let (time, pivot) = (stage.to_f64(), pivot.to_f64());
        if let Some(what) = not_finite::<R, M>(state) {
            return SimulationError::NonFinite { time, what };
        }
        if pivot.is_nan() {
            let (mut a, mut lambda) = (M::V::zero(), M::Lambda::zero());
            self.formulation.acceleration(model, *stage, &state.q, &state.v, inputs, &mut a, &mut lambda);
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

/// The first stage whose relative pivot was below the breakdown.
struct Failure<R, Q, V> {
    time: R,
    pivot: R,
    state: State<Q, V>,
}

/// The mechanism as an integrator sees it during one step.
struct Stages<'s, R: Real, M: Mechanism<R>, F, S> {
    model: &'s M,
    formulation: &'s F,
    source: &'s mut S,
    inputs: M::Inputs,
    started: bool,
    smallest_pivot: R,
    failure: Option<Failure<R, M::Q, M::V>>,
}

impl<R: Real, M: Mechanism<R>, F: Formulation<R>, S: InputSource<R, M>> Dynamics<R>
    for Stages<'_, R, M, F, S>
{
    const LAYOUT: Layout = M::LAYOUT;
    type Q = M::Q;
    type V = M::V;

    #[inline]
    fn acceleration(&mut self, time: R, state: &State<M::Q, M::V>) -> M::V {
        // The inputs at the step's start were sampled when the step before ended.
        if self.started && !S::HELD {
            self.inputs = self.source.sample(time, state);
        }
        self.started = true;
        let (mut a, mut lambda) = (M::V::zero(), M::Lambda::zero());
        let State { q, v } = state;
        let pivot = self.formulation.acceleration(self.model, time, q, v, &self.inputs, &mut a, &mut lambda);
        self.smallest_pivot = pivot.min(self.smallest_pivot);
        // Written so that a NaN fails.
        if !R::any(pivot.greater_equal(R::BREAKDOWN)) && self.failure.is_none() {
            self.failure = Some(Failure { time, pivot, state: *state });
        }
        a
    }
}
