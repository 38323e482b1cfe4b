//! Accelerations by multipliers at every position.

use super::{Evaluation, Formulation, Stabilisation};
use crate::error::SettingError;
use crate::mechanism::Mechanism;
use crate::real::Real;
use crate::state::StateOf;

/// A formulation that solves for v̇ and λ together at every position, by the factors of \[M, Dᵀ; D, 0\], where the one within asks
/// independent velocities first if these take fewer operations: `WithMultipliers(Baumgarte::time_constant(0.01))`.
///
/// It never changes from one way to the other, so that an evaluation takes the same number of instructions everywhere, and a position
/// where it breaks down is one where the constraints are dependent. For control loops, and for measurements of one way beside the other.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WithMultipliers<F>(
    /// The formulation: [`LagrangeIndex1`](super::LagrangeIndex1) or [`Baumgarte`](super::Baumgarte).
    pub F,
);

impl<R: Real, M: Mechanism<R>, F: Formulation<R, M> + Stabilisation<R>> Formulation<R, M>
    for WithMultipliers<F>
{
    type Memory = ();

    fn memory(&self, _model: &M) {}

    #[inline(always)]
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
        let pivot = match self.0.terms() {
            None => model.acceleration(time, state, u, a, lambda),
            Some(terms) => {
                let [two_alpha, beta_squared] = terms.coefficients();
                model.acceleration_baumgarte(time, state, u, two_alpha, beta_squared, a, lambda)
            }
        };
        Evaluation::direct(pivot)
    }

    fn check(&self) -> Result<(), SettingError> {
        self.0.check()
    }
}
