//! Formulations: how the accelerations are made to follow the constraints.
//!
//! A formulation is a Rust type, so only the one in use is compiled. It chooses among the evaluations that the
//! mechanism offers; the equations themselves are emitted, time stepping is `integrator`. What each of them is for, with
//! measurements, is in `docs/formulations.md`.

mod augmented_lagrangian;
mod baumgarte;
mod corrected;
pub(crate) mod friction;
mod index1;
pub(crate) mod leading;
mod null_space;
mod onto_constraints;
mod partitioned;
mod past;
mod penalty;
mod projected;
mod stabilisation;
mod with_multipliers;

pub use augmented_lagrangian::AugmentedLagrangian;
pub use baumgarte::Baumgarte;
pub use corrected::Corrected;
pub use index1::LagrangeIndex1;
pub use null_space::NullSpace;
pub use partitioned::Partitioned;
pub(crate) use past::past_breakdown;
pub use penalty::Penalty;
pub(crate) use penalty::largest_mass;
pub use projected::Projected;
pub(crate) use projected::velocities_onto_constraints;
pub use stabilisation::Stabilisation;
pub use with_multipliers::WithMultipliers;

use crate::error::{AssemblyError, SettingError};
use crate::mechanism::Mechanism;
use crate::real::Real;
use crate::state::StateOf;
use core::fmt::Debug;

/// A way to obtain v̇ and λ from (t, q, v, u).
pub trait Formulation<R: Real, M: Mechanism<R>> {
    /// The values carried from one evaluation to the next, such as multipliers to begin an iteration with.
    type Memory: Clone + Debug;

    /// The matrix whose pivot an evaluation of this mechanism returns.
    #[inline(always)]
    fn pivot_of(model: &M) -> PivotOf {
        let _ = model;
        PivotOf::Rows
    }

    /// The values to carry before the first evaluation of this mechanism.
    fn memory(&self, model: &M) -> Self::Memory;

    /// Writes v̇ (shape n_v) and λ (shape m) at the state, which may be corrected on the way.
    #[allow(clippy::too_many_arguments)]
    fn acceleration(
        &self,
        memory: &mut Self::Memory,
        model: &M,
        time: R,
        state: &mut StateOf<M, R>,
        u: &M::Inputs,
        a: &mut M::V,
        lambda: &mut M::Lambda,
    ) -> Evaluation<R>;

    /// Brings the state back to the constraints at the end of a step; most formulations do nothing.
    ///
    /// # Errors
    /// Why the state could not be brought to the constraints.
    #[inline]
    fn settle(
        &self,
        memory: &mut Self::Memory,
        model: &M,
        time: R,
        state: &mut StateOf<M, R>,
    ) -> Result<Settled<R>, AssemblyError> {
        let _ = (memory, model, time, state);
        Ok(Settled { iterations: 0, moved: R::ZERO })
    }

    /// Whether the formulation's parameters make sense.
    ///
    /// # Errors
    /// The parameter that does not.
    fn check(&self) -> Result<(), SettingError>;
}

/// The matrix that the pivot of an evaluation belongs to. Where it does not estimate the reciprocal condition of
/// D M⁻¹ Dᵀ, the mechanism is asked for that once a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PivotOf {
    /// A pivot of D M⁻¹ Dᵀ: it estimates the reciprocal condition.
    Rows,
    /// A pivot of D = L U, squared. Where it is large the constraints are far from losing rank; where it is small they may be, or
    /// only the independent velocities serve badly.
    Jacobian,
    /// The one while independent velocities serve, and it is large; else the other.
    JacobianOrRows,
    /// A pivot of the velocities; the constraints are softened and lose nothing.
    Velocities,
}

/// How sound an evaluation was.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Evaluation<R = f64> {
    /// The smallest relative pivot of the factorisation; below [`Real::BREAKDOWN`] the accelerations mean nothing.
    pub pivot: R,
    /// Iterations made beyond the first solution.
    pub iterations: u32,
    /// The largest change of an acceleration in the last of them, relative to the largest acceleration.
    pub residual: R,
}

impl<R: Real> Evaluation<R> {
    /// An evaluation without iteration.
    #[inline]
    pub fn direct(pivot: R) -> Self {
        Evaluation { pivot, iterations: 0, residual: R::ZERO }
    }
}

/// How the state was changed at the end of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settled<R = f64> {
    /// Iterations made.
    pub iterations: u32,
    /// The largest change of a coordinate, m or rad.
    pub moved: R,
}

/// An error unless `value` is positive and finite.
pub(crate) fn positive<R: Real>(
    what: &'static str,
    value: R,
    must_be: &'static str,
) -> Result<(), SettingError> {
    if value > R::ZERO && value.is_finite() {
        return Ok(());
    }
    Err(SettingError { what, value: value.to_f64(), must_be })
}

/// An error unless `value` is zero or positive, and finite.
pub(crate) fn not_negative<R: Real>(
    what: &'static str,
    value: R,
    must_be: &'static str,
) -> Result<(), SettingError> {
    if value >= R::ZERO && value.is_finite() {
        return Ok(());
    }
    Err(SettingError { what, value: value.to_f64(), must_be })
}
