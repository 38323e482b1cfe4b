//! The semi-implicit (symplectic) Euler method.

use super::{Dynamics, Integrator, Method, StepFailure, Stepped};
use crate::layout::retract;
use crate::real::Real;
use crate::state::State;
use crate::vector::Vector;

/// v₁ = v₀ + h v̇(t₀, q₀, v₀), then q₁ = q₀ ⊕ h v₁: order 1, one evaluation a step, symplectic where M is constant
/// and forces do not depend on velocities (Hairer, Lubich, Wanner, *Geometric Numerical Integration*, I.1.2). The order
/// asks for no correction of the increments of orientations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SemiImplicitEuler;

impl<R: Real> Method<R> for SemiImplicitEuler {
    type Memory<Q: Vector<R>, V: Vector<R>, Lambda: Vector<R>> = ();

    fn memory<Q: Vector<R>, V: Vector<R>, Lambda: Vector<R>>(&self) {}
}

impl<R: Real, D: Dynamics<R>> Integrator<R, D> for SemiImplicitEuler {
    #[inline]
    fn step(
        &self,
        _memory: &mut (),
        dynamics: &mut D,
        time: R,
        h: R,
        state: &State<D::Q, D::V>,
    ) -> Result<Stepped<R, D::Q, D::V>, StepFailure<R>> {
        let mut begin = *state;
        let a = dynamics.acceleration(time, &mut begin);
        let v = begin.v.plus(h, &a);
        let mut q = D::Q::zero();
        retract(&D::LAYOUT, &begin.q, &v.scaled(h), &mut q);
        Ok(Stepped::explicit(h, State { q, v }))
    }
}
