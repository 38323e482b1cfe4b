//! The constraints at the level of accelerations, as they are.

use super::{Evaluation, Formulation, PivotOf, leading};
use crate::error::SettingError;
use crate::mechanism::Mechanism;
use crate::real::Real;
use crate::state::StateOf;

/// The constraints at the level of accelerations: M v̇ + Dᵀ λ = Q, D v̇ = γ.
///
/// Exact as written; over a long run the truncation error of the integrator lets positions and velocities drift from
/// the constraints (Hairer, Wanner, *Solving Ordinary Differential Equations II*, VII.2).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LagrangeIndex1;

impl<R: Real, M: Mechanism<R>> Formulation<R, M> for LagrangeIndex1 {
    type Memory = ();

    #[inline(always)]
    fn pivot_of(model: &M) -> PivotOf {
        leading::pivot_of(model)
    }

    fn memory(&self, _model: &M) {}

    #[inline]
    fn acceleration(
        &self,
        _memory: &mut (),
        model: &M,
        time: R,
        state: &mut StateOf<M, R>,
        u: &M::Inputs,
        a: &mut M::V,
        lambda: &mut M::Lambda,
    ) -> Evaluation<R> {
        Evaluation::direct(leading::acceleration(model, time, state, u, a, lambda))
    }

    fn check(&self) -> Result<(), SettingError> {
        Ok(())
    }
}
