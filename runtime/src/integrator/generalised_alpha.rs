//! The generalised-α method on Lie groups, for stiff systems and constraints of index 3.

use super::newmark::{Carried, CarriedOf, ImplicitDynamics, Level, Scheme};
use super::{Integrator, Method, StepFailure, SteppedOf};
use crate::error::SettingError;
use crate::real::Real;
use crate::state::{StateOf, Variables};

/// The generalised-α method: order 2, unconditionally stable for linear systems, with the spectral radius ρ∞ at infinite
/// frequency chosen between 1 (no damping) and 0 (what is faster than the step is gone after one).
///
/// ```text
/// M v̇₁ + Dᵀ λ₁ = Q(t₁, q₁, v₁),   Φ(t₁, q₁) = 0
/// (1 − α_m) a₁ + α_m a₀ = (1 − α_f) v̇₁ + α_f v̇₀
/// q₁ = q₀ ⊕ (h v₀ + h² (½ − β) a₀ + h² β a₁),   v₁ = v₀ + h (1 − γ) a₀ + h γ a₁
/// α_m = (2ρ − 1)/(ρ + 1),  α_f = ρ/(ρ + 1),  γ = ½ + α_f − α_m,  β = ¼ (γ + ½)²
/// ```
/// solved by Newton's iteration on the exact tangent, with dexp of the increment for orientations in space. Constraints hold by
/// position to the tolerance, velocities violate them by O(h²), unless the formulation is
/// [`Projected`](crate::Projected); of the formulation nothing else is used but the accelerations at the start.
/// With ρ = 1 multipliers oscillate: constrained systems need ρ < 1, 0.8 or so.
///
/// Source: Chung, Hulbert, Journal of Applied Mechanics 60 (1993) 371–375; Arnold, Brüls, Multibody System Dynamics 18 (2007)
/// 185–202; Brüls, Cardona, Journal of Computational and Nonlinear Dynamics 5 (2010) 031002 (on Lie groups).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GeneralisedAlpha<R = f64> {
    /// ρ∞, in [0, 1].
    pub rho: R,
    /// The change of a coordinate at which Newton's iteration ends, relative to 1 + the largest coordinate.
    pub tolerance: R,
    /// The most iterations a step.
    pub iterations: u32,
}

impl<R: Real> GeneralisedAlpha<R> {
    /// The method with this ρ∞, iterated to 10⁻¹⁰ (single precision: 32 roundings) at most 20 times.
    pub fn new(rho: R) -> Self {
        let tolerance = R::from_f64(1e-10).max(R::from_f64(32.0) * R::EPSILON);
        GeneralisedAlpha { rho, tolerance, iterations: 20 }
    }
}

impl<R: Real> Method<R> for GeneralisedAlpha<R> {
    type Memory<X: Variables<R>> = CarriedOf<X, R>;

    fn memory<X: Variables<R>>(&self) -> CarriedOf<X, R> {
        Carried { known: None }
    }

    fn check(&self) -> Result<(), SettingError> {
        if !(self.rho >= R::ZERO && self.rho <= R::ONE) {
            let (what, must_be) = ("generalised-alpha's rho", "from 0 (all damping) to 1 (none)");
            return Err(SettingError { what, value: self.rho.to_f64(), must_be });
        }
        checked(
            "generalised-alpha's tolerance",
            "generalised-alpha's iterations",
            self.tolerance,
            self.iterations,
        )
    }
}

impl<R: Real, X: Variables<R>, D: ImplicitDynamics<R, Variables = X>> Integrator<R, D>
    for GeneralisedAlpha<R>
{
    fn step(
        &self,
        memory: &mut CarriedOf<X, R>,
        dynamics: &mut D,
        time: R,
        h: R,
        state: &StateOf<X, R>,
    ) -> Result<SteppedOf<X, R>, StepFailure<R>> {
        let (rho, half) = (self.rho, R::from_f64(0.5));
        let alpha_m = (rho + rho - R::ONE) / (rho + R::ONE);
        let alpha_f = rho / (rho + R::ONE);
        let gamma = half + alpha_f - alpha_m;
        let beta = R::from_f64(0.25) * (gamma + half) * (gamma + half);
        let (tolerance, iterations) = (self.tolerance, self.iterations);
        let (level, compliance) = (Level::Position, R::ZERO);
        let scheme = Scheme { alpha_m, alpha_f, beta, gamma, level, compliance, tolerance, iterations };
        scheme.step(memory, dynamics, time, h, state)
    }
}

/// Tolerance and bound of an iteration.
pub(super) fn checked<R: Real>(
    tolerance_of: &'static str,
    iterations_of: &'static str,
    tolerance: R,
    iterations: u32,
) -> Result<(), SettingError> {
    if !(tolerance > R::ZERO && tolerance.is_finite()) {
        let must_be = "positive and finite, such as 1e-10";
        return Err(SettingError { what: tolerance_of, value: tolerance.to_f64(), must_be });
    }
    if iterations == 0 {
        return Err(SettingError { what: iterations_of, value: 0.0, must_be: "at least 1" });
    }
    Ok(())
}
