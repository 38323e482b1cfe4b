//! The classical Runge–Kutta method of order four.

use super::runge_kutta::{Slopes, Tableau};
use super::{Dynamics, Integrator, Method, StepFailure, Stepped, SteppedOf};
use crate::real::Real;
use crate::state::{StateOf, Variables};

/// The classical method of order 4 (Kutta 1901; Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*,
/// II.1), four evaluations a step.
///
/// On the group every stage starts from the step's own beginning: q_i = q ⊕ u_i, u_i = h Σ a_ij k_j, with
/// k_j = dexp⁻¹(u_j) v_j ([`inverse_differential`](crate::inverse_differential)); the result is q ⊕ h Σ b_j k_j (Munthe-Kaas 1999;
/// Hairer, Lubich, Wanner, *Geometric Numerical Integration*, IV.8). A uniform rotation is exact. Counted angles have rates linear
/// in v and take Σ a_ij v_j.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rk4;

/// The coefficients, from the same.
pub(super) const CLASSICAL: Tableau<4> = Tableau {
    a: [[0.0; 4], [0.5, 0.0, 0.0, 0.0], [0.0, 0.5, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]],
    b: [1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0],
    c: [0.0, 0.5, 0.5, 1.0],
};

impl<R: Real> Method<R> for Rk4 {
    type Memory<X: Variables<R>> = ();

    fn memory<X: Variables<R>>(&self) {}
}

impl<R: Real, X: Variables<R>, D: Dynamics<R, Variables = X>> Integrator<R, D> for Rk4 {
    #[inline]
    fn step(
        &self,
        _memory: &mut (),
        dynamics: &mut D,
        time: R,
        h: R,
        state: &StateOf<X, R>,
    ) -> Result<SteppedOf<X, R>, StepFailure<R>> {
        let first = dynamics.derivative(time, &mut state.clone());
        let mut slopes = Slopes::new(first);
        let (method, over) = (&CLASSICAL, (time, h));
        slopes.stage(method, 1, dynamics, over, state).ok_or(StepFailure::Breakdown)?;
        slopes.stage(method, 2, dynamics, over, state).ok_or(StepFailure::Breakdown)?;
        slopes.stage(method, 3, dynamics, over, state).ok_or(StepFailure::Breakdown)?;
        let layout = dynamics.variables().layout();
        let increment = slopes.increment(layout, h, 1.0, &CLASSICAL.b);
        Ok(Stepped::explicit(h, increment.from(layout, state)))
    }
}
