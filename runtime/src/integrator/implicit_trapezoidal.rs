//! The implicit trapezoidal rule, for stiff systems.

use super::generalised_alpha::checked;
use super::newmark::{Carried, CarriedOf, ImplicitDynamics, Level, Scheme};
use super::{Integrator, Method, StepFailure, SteppedOf};
use crate::error::SettingError;
use crate::real::Real;
use crate::state::{StateOf, Variables};

/// The implicit trapezoidal rule: order 2, stable for all frequencies and without damping of its own.
///
/// ```text
/// M v̇₁ + Dᵀ λ₁ = Q(t₁, q₁, v₁),   D v₁ = ν
/// v₁ = v₀ + h/2 (v̇₀ + v̇₁),   q₁ = q₀ ⊕ h/2 (v₀ + v₁)
/// ```
/// solved by Newton's iteration on the exact tangent. Constraints are held at the level of velocities (index 2), because at
/// that of positions the rule is only marginally stable; positions then drift by O(h²), unless the formulation is
/// [`Projected`](crate::Projected). With the increment h/2 (ω₀ + ω₁) the order asks for no correction of orientations.
///
/// Source: Hairer, Wanner, *Solving Ordinary Differential Equations II*, IV.3 and VII.4; García de Jalón, Bayo, *Kinematic and
/// Dynamic Simulation of Multibody Systems*, 7.3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImplicitTrapezoidal<R = f64> {
    /// The change of a coordinate at which Newton's iteration ends, relative to 1 + the largest coordinate.
    pub tolerance: R,
    /// The most iterations a step.
    pub iterations: u32,
}

impl<R: Real> Default for ImplicitTrapezoidal<R> {
    /// Iterated to 10⁻¹⁰ (single precision: 32 roundings), at most 20 times.
    fn default() -> Self {
        let tolerance = R::from_f64(1e-10).max(R::from_f64(32.0) * R::EPSILON);
        ImplicitTrapezoidal { tolerance, iterations: 20 }
    }
}

impl<R: Real> Method<R> for ImplicitTrapezoidal<R> {
    type Memory<X: Variables<R>> = CarriedOf<X, R>;

    fn memory<X: Variables<R>>(&self) -> CarriedOf<X, R> {
        Carried { known: None }
    }

    fn check(&self) -> Result<(), SettingError> {
        checked(
            "the implicit trapezoidal rule's tolerance",
            "the implicit trapezoidal rule's iterations",
            self.tolerance,
            self.iterations,
        )
    }
}

impl<R: Real, X: Variables<R>, D: ImplicitDynamics<R, Variables = X>> Integrator<R, D>
    for ImplicitTrapezoidal<R>
{
    fn step(
        &self,
        memory: &mut CarriedOf<X, R>,
        dynamics: &mut D,
        time: R,
        h: R,
        state: &StateOf<X, R>,
    ) -> Result<SteppedOf<X, R>, StepFailure<R>> {
        let scheme = Scheme {
            alpha_m: R::ZERO,
            alpha_f: R::ZERO,
            beta: R::from_f64(0.25),
            gamma: R::from_f64(0.5),
            level: Level::Velocity,
            compliance: R::ZERO,
            tolerance: self.tolerance,
            iterations: self.iterations,
        };
        scheme.step(memory, dynamics, time, h, state)
    }
}
