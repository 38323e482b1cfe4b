//! The semi-implicit (symplectic) Euler method.

use super::{Dynamics, Integrator, Method, StepFailure, Stepped, SteppedOf};
use crate::real::Real;
use crate::state::{StateOf, Variables};
use crate::vector::Vector;

/// v₁ = v₀ + h v̇(t₀, q₀, v₀), z₁ = z₀ + h ż(t₀, …), then q₁ = q₀ ⊕ h v₁: order 1, one evaluation a step, symplectic where M is constant
/// and forces do not depend on velocities (Hairer, Lubich, Wanner, *Geometric Numerical Integration*, I.1.2). The order
/// asks for no correction of the increments of orientations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SemiImplicitEuler;

impl<R: Real> Method<R> for SemiImplicitEuler {
    type Memory<X: Variables<R>> = ();

    fn memory<X: Variables<R>>(&self) {}
}

impl<R: Real, X: Variables<R>, D: Dynamics<R, Variables = X>> Integrator<R, D> for SemiImplicitEuler {
    #[inline]
    fn step(
        &self,
        _memory: &mut (),
        dynamics: &mut D,
        time: R,
        h: R,
        state: &StateOf<X, R>,
    ) -> Result<SteppedOf<X, R>, StepFailure<R>> {
        let mut begin = state.clone();
        let first = dynamics.derivative(time, &mut begin);
        let v = begin.v.plus(h, &first.a);
        let z = begin.z.plus(h, &first.z);
        let layout = dynamics.variables().layout();
        Ok(Stepped::explicit(h, begin.moved(layout, &v.scaled(h), v, z)))
    }
}
