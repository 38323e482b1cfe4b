//! Baumgarte's stabilisation.

use super::{Evaluation, Formulation, PivotOf, leading, not_negative};
use crate::error::SettingError;
use crate::mechanism::Mechanism;
use crate::real::Real;
use crate::state::StateOf;

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

    /// 2α and β².
    #[inline(always)]
    pub(crate) fn coefficients(&self) -> [R; 2] {
        [self.alpha + self.alpha, self.beta * self.beta]
    }
}

impl<R: Real, M: Mechanism<R>> Formulation<R, M> for Baumgarte<R> {
    type Memory = ();

    #[inline(always)]
    fn pivot_of(model: &M) -> PivotOf {
        leading::pivot_of(model)
    }

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
        Evaluation::direct(leading::stabilised(model, time, state, u, self.coefficients(), a, lambda))
    }

    fn check(&self) -> Result<(), SettingError> {
        let must_be = "zero or positive, and finite (1/s)";
        not_negative("Baumgarte's alpha", self.alpha, must_be)?;
        not_negative("Baumgarte's beta", self.beta, must_be)
    }
}
