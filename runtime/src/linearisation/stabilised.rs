//! Derivatives of the motion under Baumgarte's stabilisation, on the constraints and off them.

use super::{Linearisation, add_block};
use crate::error::LinearisationError;
use crate::formulation::{Baumgarte, leading};
use crate::real::Real;
use crate::state::StateOf;
use crate::tangent::Tangent;
use crate::vector::Vector;

/// What Baumgarte's terms 2α (D v − ν) + β² Φ are differentiated with.
pub(super) struct Stabilised<R: Real, M: Tangent<R>> {
    two_alpha: R,
    beta_squared: R,
    jacobian: M::Jacobian,
    rate: M::RateTangent,
}

impl<R: Real, M: Tangent<R>> Stabilised<R, M> {
    /// `rows` += their derivatives along δq and δv: ∂Φ = D δq, ∂(D v − ν) = (∂(D v − ν)/∂q) δq + D δv.
    pub(super) fn add(&self, model: &M, dq: &[R], dv: &[R], rows: &mut M::Lambda) {
        let (mut position, mut velocity) = (model.zero_lambda(), model.zero_lambda());
        let jacobian = self.jacobian.as_slice();
        add_block(model.jacobian_pattern(), jacobian, (0, 0), dq, position.as_mut_slice());
        add_block(model.jacobian_pattern(), jacobian, (0, 0), dv, velocity.as_mut_slice());
        add_block(model.rate_pattern(), self.rate.as_slice(), (0, 0), dq, velocity.as_mut_slice());
        rows.axpy(self.beta_squared, &position);
        rows.axpy(self.two_alpha, &velocity);
    }
}

impl<'m, R: Real, M: Tangent<R>> Linearisation<'m, R, M> {
    /// As [`Linearisation::at`] under Baumgarte's stabilisation, D v̇ = γ − 2α (D v − ν) − β² Φ, also off the constraints: v̇ and λ and their derivatives by
    /// q, v, z and u are those of the formulation. Derivatives by parameters are those
    /// without the stabilisation.
    ///
    /// # Errors
    /// As [`Linearisation::at`].
    pub fn stabilised(
        model: &'m M,
        time: R,
        state: &StateOf<M, R>,
        u: &M::Inputs,
        terms: Baumgarte<R>,
    ) -> Result<Self, LinearisationError> {
        let [two_alpha, beta_squared] = terms.coefficients();
        let mut found = Self::solved(model, time, state, u, |a, lambda| {
            leading::stabilised(model, time, state, u, terms.coefficients(), a, lambda)
        })?;
        let (mut jacobian, mut rate) = (model.zero_jacobian(), model.zero_rate_tangent());
        model.constraint_jacobian(time, &state.q, &mut jacobian);
        model.rate_tangent(time, &state.q, &state.v, &mut rate);
        found.stabilised = Some(Stabilised { two_alpha, beta_squared, jacobian, rate });
        Ok(found)
    }
}
