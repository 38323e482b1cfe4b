//! Consistent states: positions, velocities and accelerations that satisfy the constraints and given conditions.
//!
//! The numerical work of one `assemble` is here, allocation-free and fit for a microcontroller; which quantities
//! `start` states and in which order the unknowns are eliminated was decided at expansion ([`Assemble`]).

pub(crate) mod determinacy;
mod given;
mod position;
mod rates;
mod residual;
pub(crate) mod system;

pub use position::{assemble_position, project_position};
pub(crate) use rates::nearest_velocity;
pub use rates::{assemble_acceleration, assemble_velocity, project_velocity};

use crate::error::AssemblyError;
use crate::ldl::Pivot;
use crate::mechanism::{Assemble, Mechanism};
use crate::real::Real;
use crate::simulation::Simulation;
use crate::state::{Kinematics, Motion, State, StateOf};
use crate::stepper::{StepMethod, Stepper};
use crate::trigger::align;
use crate::vector::Vector;
use system::System;

/// Assembly as methods of the model.
pub trait AssembleExt<R: Real>: Assemble<R> + Sized {
    /// The state assembled at expansion, for the default parameters, in the model's own scalars.
    fn start(&self) -> StateOf<Self, R> {
        let gates = self.start_gates();
        held(self, R::ZERO, State { q: self.start_q(), v: self.start_v(), z: self.start_internal(), gates })
    }

    /// The state near `near` that fulfils what `start` states, with this model's parameters, at time zero.
    ///
    /// # Errors
    /// As [`assemble_position`] and [`assemble_velocity`].
    fn assemble(&self, near: &StateOf<Self, R>) -> Result<StateOf<Self, R>, AssemblyError> {
        let (mut positions, mut rates) = (self.zero_conditions(), self.zero_conditions());
        self.start_targets(&mut positions, &mut rates);
        let q = assemble_position(self, R::ZERO, &near.q, &positions, self.start_conditions())?;
        let v = assemble_velocity(self, R::ZERO, &q, &rates, self.start_rates())?;
        let gates = self.start_gates();
        Ok(held(self, R::ZERO, State { q, v, z: self.start_internal(), gates }))
    }

    /// The motion of the whole mechanism from that of its independent coordinates, given in the order of
    /// [`independent`](Assemble::independent); of several ways to assemble, the one near `near`. Angles whose turns the
    /// dynamics count (of gears, racks, drivers, torsion springs, laws) are given with their turns.
    ///
    /// At a dead centre of an independent coordinate, or so near to one that less than half of the digits of the velocities would
    /// mean anything (in a simple one within some 10⁻⁴ rad, in single precision 10⁻² rad), the motion of the others is not determined
    /// by it: that is [`RankDeficient`](AssemblyError::RankDeficient), unless all rests.
    ///
    /// # Errors
    /// [`WrongLength`](AssemblyError::WrongLength); otherwise as [`assemble_position`] and [`assemble_velocity`].
    fn kinematics(
        &self,
        time: R,
        near: &Self::Q,
        given: &[Motion<R>],
    ) -> Result<Kinematics<Self::Q, Self::V>, AssemblyError> {
        let needed = self.independent().len();
        if given.len() != needed {
            return Err(AssemblyError::WrongLength { needed, given: given.len() });
        }
        let targets = |part: fn(&Motion<R>) -> R| {
            let mut targets = self.zero_conditions();
            for (&index, motion) in self.independent().iter().zip(given) {
                targets.as_mut_slice()[index as usize] = part(motion);
            }
            targets
        };
        let held = self.independent();
        let q = assemble_position(self, time, near, &targets(|motion| motion.position), held)?;
        let (rates, accelerations) = (targets(|motion| motion.rate), targets(|motion| motion.acceleration));
        let (v, a) = rates::assemble_rates(self, time, &q, &rates, &accelerations, held)?;
        Ok(Kinematics { q, v, a })
    }

    /// A simulation of this model from `start` at time zero: [`Simulation::new`].
    fn simulation(&self, start: StateOf<Self, R>) -> Simulation<'_, Self, R> {
        Simulation::new(self, start)
    }

    /// A stepper that owns a copy of this model, at time zero: [`Stepper::new`]. `method` is an integrator, such as
    /// [`Rk4`](crate::Rk4), or a pair of an integrator and a formulation.
    fn stepper<S: StepMethod<R, Self>>(&self, start: StateOf<Self, R>, method: S) -> Stepper<Self, S, R>
    where
        Self: Clone,
    {
        Stepper::new(self.clone(), start, method)
    }

    /// The consistent state nearest to `state`: positions as by [`project_position`], velocities as by
    /// [`project_velocity`], gates as they are there, and the rest as it is.
    ///
    /// # Errors
    /// As [`assemble_position`] and [`assemble_velocity`].
    fn project(&self, time: R, state: &StateOf<Self, R>) -> Result<StateOf<Self, R>, AssemblyError> {
        let q = project_position(self, time, &state.q)?;
        let v = project_velocity(self, time, &q, &state.v)?;
        Ok(held(self, time, State { q, v, z: state.z.clone(), gates: state.gates.clone() }))
    }
}

impl<R: Real, M: Assemble<R>> AssembleExt<R> for M {}

/// The state with its gates as they are at it, and the ticks that are next at this time.
#[inline(always)]
pub(crate) fn held<R: Real, M: Mechanism<R>>(model: &M, time: R, mut state: StateOf<M, R>) -> StateOf<M, R> {
    if M::HOLDS && !state.gates.as_slice().is_empty() {
        state.gates = model.live_gates(time, &state);
        align(model, time, &mut state);
    }
    state
}

/// The smallest relative pivot of D Dᵀ and the index of its row: near zero at a position where that row depends on
/// those eliminated before it. `None` for a mechanism without constraint rows, or where all pivots are one.
pub fn smallest_pivot<R: Real, M: Assemble<R>>(model: &M, time: R, q: &M::Q) -> (R, Option<usize>) {
    match unit_pivot(model, time, q) {
        Some(pivot) => {
            let row =
                pivot.unknown.checked_sub(model.velocity_count()).filter(|&row| row < model.row_count());
            (pivot.value, row)
        }
        None => (R::ONE, None),
    }
}

fn unit_pivot<R: Real, M: Assemble<R>>(model: &M, time: R, q: &M::Q) -> Option<Pivot<R>> {
    let mut system = System::new(model, &[]).ok()?;
    system.evaluate(time, q, None);
    Some(system.factor_unit())
}

/// The velocity at which the mass matrix, with the constraints, is singular: `None` where it is not, or where it is
/// the constraints that are.
pub(crate) fn singular_velocity<R: Real, M: Assemble<R>>(model: &M, time: R, q: &M::Q) -> Option<usize> {
    let mut system = System::new(model, &[]).ok()?;
    system.evaluate(time, q, None);
    let pivot = system.factor_mass(time, q, R::ZERO);
    (pivot.value < R::BREAKDOWN && pivot.unknown < model.velocity_count()).then_some(pivot.unknown)
}
