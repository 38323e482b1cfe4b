//! The semi-implicit (symplectic) Euler method.

use super::{Dynamics, Integrator};
use crate::layout::retract;
use crate::real::Real;
use crate::state::State;
use crate::vector::Vector;

/// v₁ = v₀ + h v̇(t₀, q₀, v₀), then q₁ = q₀ ⊕ h v₁: order 1, one evaluation a step, symplectic where M is constant
/// and forces do not depend on velocities (Hairer, Lubich, Wanner, *Geometric Numerical Integration*, I.1.2). The order
/// asks for no correction of the increments of orientations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SemiImplicitEuler;

impl<R: Real> Integrator<R> for SemiImplicitEuler {
    #[inline]
    fn step<D: Dynamics<R>>(
        &self,
        dynamics: &mut D,
        time: R,
        h: R,
        state: &State<D::Q, D::V>,
    ) -> State<D::Q, D::V> {
        let a = dynamics.acceleration(time, state);
        let v = state.v.plus(h, &a);
        let mut q = D::Q::zero();
        retract(&D::LAYOUT, &state.q, &v.scaled(h), &mut q);
        State { q, v }
    }
}
