//! Formulations: how the accelerations are made to follow the constraints.
//!
//! A formulation is a Rust type, so only the one in use is compiled. It chooses among the evaluations that the
//! mechanism offers; the equations themselves are emitted, time stepping is `integrator`.

use crate::error::SettingError;
use crate::mechanism::Mechanism;
use crate::real::Real;

/// A way to obtain v̇ and λ from (t, q, v, u).
pub trait Formulation<R: Real> {
    /// Writes v̇ (shape n_v) and λ (shape m); returns the smallest relative pivot of the factorisation.
    #[allow(clippy::too_many_arguments)]
    fn acceleration<M: Mechanism<R>>(
        &self,
        model: &M,
        time: R,
        q: &M::Q,
        v: &M::V,
        u: &M::Inputs,
        a: &mut M::V,
        lambda: &mut M::Lambda,
    ) -> R;

    /// Whether the formulation's parameters make sense.
    ///
    /// # Errors
    /// The parameter that does not.
    fn check(&self) -> Result<(), SettingError>;
}

/// The constraints at the level of accelerations: M v̇ + Dᵀ λ = Q, D v̇ = γ.
///
/// Exact as written; over a long run the truncation error of the integrator lets positions and velocities drift from
/// the constraints (Hairer, Wanner, *Solving Ordinary Differential Equations II*, VII.2).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LagrangeIndex1;

impl<R: Real> Formulation<R> for LagrangeIndex1 {
    #[inline]
    fn acceleration<M: Mechanism<R>>(
        &self,
        model: &M,
        time: R,
        q: &M::Q,
        v: &M::V,
        u: &M::Inputs,
        a: &mut M::V,
        lambda: &mut M::Lambda,
    ) -> R {
        model.acceleration(time, q, v, u, a, lambda)
    }

    fn check(&self) -> Result<(), SettingError> {
        Ok(())
    }
}

/// Baumgarte's stabilisation: D v̇ = γ − 2α (D v − ν) − β² Φ.
///
/// Errors of the constraints then decay like those of a damped oscillator; α = β is critical damping. α and β must
/// stay well below the inverse of the step size. Source: J. Baumgarte, Computer Methods in Applied Mechanics and
/// Engineering 1 (1972) 1–16.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Baumgarte<R = f64> {
    /// Damping of the constraint errors, 1/s.
    pub alpha: R,
    /// Their natural frequency, rad/s.
    pub beta: R,
}

impl<R: Real> Baumgarte<R> {
    /// Critical damping with the time constant `seconds`: α = β = 1/T.
    pub fn time_constant(seconds: R) -> Self {
        let rate = R::ONE / seconds;
        Baumgarte { alpha: rate, beta: rate }
    }
}

impl<R: Real> Formulation<R> for Baumgarte<R> {
    #[inline]
    fn acceleration<M: Mechanism<R>>(
        &self,
        model: &M,
        time: R,
        q: &M::Q,
        v: &M::V,
        u: &M::Inputs,
        a: &mut M::V,
        lambda: &mut M::Lambda,
    ) -> R {
        let (two_alpha, beta_squared) = (self.alpha + self.alpha, self.beta * self.beta);
        model.acceleration_baumgarte(time, q, v, u, two_alpha, beta_squared, a, lambda)
    }

    fn check(&self) -> Result<(), SettingError> {
        for (what, value) in [("Baumgarte's alpha", self.alpha), ("Baumgarte's beta", self.beta)] {
            if !(value >= R::ZERO && value.is_finite()) {
                let must_be = "zero or positive, and finite (1/s)";
                return Err(SettingError { what, value: value.to_f64(), must_be });
            }
        }
        Ok(())
    }
}
