//! The sample of a simulation at one time, and the iterator over it.

use super::course::Course;
use super::{MechanismDynamics, Simulation};
use crate::assembly::smallest_pivot;
use crate::assembly::system::subtract_product;
use crate::error::SimulationError;
use crate::formulation::Formulation;
use crate::input::InputSource;
use crate::integrator::{Integrator, Method};
use crate::mechanism::{Assemble, Mechanism, name_row};
use crate::real::Real;
use crate::report::Report;
use crate::state::{StateOf, Variables};
use crate::vector::Vector;

/// A simulation at one time. What costs an evaluation is a method.
pub struct Sample<'m, R: Real, M: Mechanism<R>> {
    /// The time, s: the exact one, rounded once.
    pub time: R,
    /// Positions and velocities.
    pub state: StateOf<M, R>,
    /// The inputs at this time.
    pub inputs: M::Inputs,
    /// The named outputs; angles continue those of the sample before without jumps.
    pub outputs: M::Outputs,
    pub(super) model: &'m M,
}

impl<R: Real, M: Mechanism<R>> Sample<'_, R, M> {
    /// ½ vᵀ M v, J.
    pub fn kinetic_energy(&self) -> R {
        self.model.kinetic_energy(self.time, &self.state.q, &self.state.v)
    }

    /// The energy of gravity and springs, J.
    pub fn potential_energy(&self) -> R {
        self.model.potential_energy(self.time, &self.state)
    }

    /// Kinetic and potential energy, J.
    pub fn energy(&self) -> R {
        self.kinetic_energy() + self.potential_energy()
    }

    /// How far positions and velocities are off the constraints.
    pub fn constraint_residual(&self) -> Residual<R> {
        Residual::of(self.model, self.time, &self.state)
    }
}

/// v̇ and λ of one state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solution<V, L> {
    /// v̇, shape n_v, m/s² and rad/s².
    pub acceleration: V,
    /// λ, shape m; the force of the constraints on the mechanism is −Dᵀ λ.
    pub multipliers: L,
}

/// [`Solution`] of a mechanism.
pub type SolutionOf<R, M> = Solution<<M as Variables<R>>::V, <M as Variables<R>>::Lambda>;

impl<R: Real, M: Assemble<R>> Sample<'_, R, M> {
    /// v̇ and λ of M v̇ + Dᵀ λ = Q, D v̇ = γ with the inputs of this time: what outputs that name efforts or reactions are made of.
    /// [`Simulation::acceleration`] asks the formulation instead.
    ///
    /// # Errors
    /// [`Breakdown`](SimulationError::Breakdown), [`NonFinite`](SimulationError::NonFinite).
    pub fn solution(&self) -> Result<SolutionOf<R, M>, SimulationError> {
        let (model, time) = (self.model, self.time);
        let (mut acceleration, mut multipliers) = (model.zero_v(), model.zero_lambda());
        let pivot = model.acceleration(time, &self.state, &self.inputs, &mut acceleration, &mut multipliers);
        // Written so that a NaN fails.
        if !R::any(pivot.greater_equal(R::BREAKDOWN)) {
            let (_, row) = smallest_pivot(model, time, &self.state.q);
            let (time, pivot, row) = (time.to_f64(), pivot.to_f64(), name_row(model, row));
            return Err(SimulationError::Breakdown { time, pivot, row });
        }
        let lost =
            acceleration.first_not_finite().and_then(|entry| model.velocity_names().get(entry).copied());
        let lost = lost.or(multipliers.first_not_finite().map(|row| name_row(model, Some(row)).of));
        match lost {
            Some(what) => Err(SimulationError::NonFinite { time: time.to_f64(), what }),
            None => Ok(Solution { acceleration, multipliers }),
        }
    }
}

impl<R: Real, M: Assemble<R> + Report<R>> Sample<'_, R, M> {
    /// Force (N, world axes) and torque (N m) that each joint exerts on the body of its second place, in the order of
    /// [`Report::joints`].
    ///
    /// # Errors
    /// As [`solution`](Sample::solution).
    pub fn reactions(&self) -> Result<M::Reactions, SimulationError> {
        let Solution { acceleration, multipliers } = self.solution()?;
        Ok(self.model.reactions(self.time, &self.state, &self.inputs, &acceleration, &multipliers))
    }

    /// Position, velocity and acceleration of every body's centre of mass, in the order of [`Report::bodies`].
    ///
    /// # Errors
    /// As [`solution`](Sample::solution).
    pub fn motions(&self) -> Result<M::Motions, SimulationError> {
        let Solution { acceleration, .. } = self.solution()?;
        Ok(self.model.motions(self.time, &self.state.q, &self.state.v, &acceleration))
    }

    /// Effort of each driver along its quantity (N m or N) and its power (W).
    ///
    /// # Errors
    /// As [`solution`](Sample::solution).
    pub fn driver_efforts(&self) -> Result<M::Efforts, SimulationError> {
        let Solution { multipliers, .. } = self.solution()?;
        Ok(self.model.driver_efforts(self.time, &self.state.q, &self.state.v, &multipliers))
    }

    /// Power of each load, W, in the order of [`Report::loads`].
    pub fn powers(&self) -> M::Powers {
        self.model.powers(self.time, &self.state, &self.inputs)
    }
}

/// How far a state is off the constraints; rows of different units (m, rad, m²) are taken together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Residual<R = f64> {
    /// max |Φ|.
    pub position: R,
    /// max |D v − ν|.
    pub velocity: R,
    /// √(Σ Φ²/m).
    pub position_rms: R,
    /// √(Σ (D v − ν)²/m).
    pub velocity_rms: R,
}

impl<R: Real> Residual<R> {
    /// The residual of `state` at `time`; zero for a mechanism without constraints.
    pub fn of<M: Mechanism<R>>(model: &M, time: R, state: &StateOf<M, R>) -> Self {
        let (mut phi, mut rate) = (model.zero_lambda(), model.zero_lambda());
        let mut jacobian = model.zero_jacobian();
        model.constraints(time, &state.q, &mut phi);
        model.constraint_jacobian(time, &state.q, &mut jacobian);
        model.nu(time, &state.q, &mut rate);
        subtract_product(
            model.jacobian_pattern(),
            jacobian.as_slice(),
            state.v.as_slice(),
            rate.as_mut_slice(),
        );
        let rows = R::from_f64(model.row_count().max(1) as f64);
        let rms = |rows_of: &M::Lambda| (rows_of.norm_squared() / rows).sqrt();
        Residual {
            position: phi.max_abs(),
            velocity: rate.max_abs(),
            position_rms: rms(&phi),
            velocity_rms: rms(&rate),
        }
    }
}

/// The samples of a run, from its start to its end; made by [`Simulation::samples`].
pub struct Samples<'s, 'm, M: Mechanism<R>, R: Real, F: Formulation<R, M>, S, I: Method<R>> {
    simulation: &'s mut Simulation<'m, M, R, F, S, I>,
    end: R,
    stage: Stage<R>,
}

/// Where the iterator stands; holds the run once it has been checked.
enum Stage<R> {
    New,
    Running(Course<R>),
    Done,
}

impl<'s, 'm, M: Mechanism<R>, R: Real, F: Formulation<R, M>, S, I: Method<R>> Samples<'s, 'm, M, R, F, S, I> {
    pub(super) fn new(simulation: &'s mut Simulation<'m, M, R, F, S, I>, end: R) -> Self {
        Samples { simulation, end, stage: Stage::New }
    }
}

impl<'m, M, R, F, S, I> Iterator for Samples<'_, 'm, M, R, F, S, I>
where
    R: Real,
    M: Assemble<R>,
    F: Formulation<R, M>,
    S: InputSource<R, M>,
    I: Integrator<R, MechanismDynamics<'m, M, R, F, S>>,
{
    type Item = Result<Sample<'m, R, M>, SimulationError>;

    fn next(&mut self) -> Option<Self::Item> {
        let outcome = match &mut self.stage {
            Stage::Done => return None,
            Stage::New => {
                self.simulation.course_until(self.end).map(|course| self.stage = Stage::Running(course))
            }
            Stage::Running(course) if !self.simulation.is_under_way(course) => return None,
            Stage::Running(course) => self.simulation.advance_along(course).map(|_| ()),
        };
        if outcome.is_err() {
            self.stage = Stage::Done;
        }
        Some(outcome.map(|()| self.simulation.sample()))
    }
}
