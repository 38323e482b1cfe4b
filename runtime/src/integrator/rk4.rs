//! The classical Runge–Kutta method of order four, on the group of positions.

use super::{Dynamics, Integrator, Method, StepFailure, Stepped};
use crate::layout::{inverse_differential, retract_counting};
use crate::real::Real;
use crate::state::State;
use crate::vector::Vector;

/// The classical method of order 4 (Kutta 1901; Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*,
/// II.1), four evaluations a step.
///
/// On the group every stage starts from the step's own beginning: q_i = q ⊕ u_i, u_i = h Σ a_ij k_j, where k_j is the rate
/// of u that belongs to the stage's velocities, k_j = dexp⁻¹(u_j) v_j ([`inverse_differential`]); the result is
/// q ⊕ h Σ b_j k_j (Munthe-Kaas 1999; Hairer, Lubich, Wanner, *Geometric Numerical Integration*, IV.8). Without the
/// correction rotations in space would be followed to order 2. Rotations of the plane commute, so there k_j = v_j. A
/// uniform rotation is exact. Counted angles have rates linear in v and take Σ a_ij v_j.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rk4;

impl<R: Real> Method<R> for Rk4 {
    type Memory<Q: Vector<R>, V: Vector<R>, Lambda: Vector<R>> = ();

    fn memory<Q: Vector<R>, V: Vector<R>, Lambda: Vector<R>>(&self) {}
}

impl<R: Real, D: Dynamics<R>> Integrator<R, D> for Rk4 {
    #[inline]
    fn step(
        &self,
        _memory: &mut (),
        dynamics: &mut D,
        time: R,
        h: R,
        state: &State<D::Q, D::V>,
    ) -> Result<Stepped<R, D::Q, D::V>, StepFailure<R>> {
        let half = h * R::from_f64(0.5);
        // The state after `h` with the slopes k of u, v of counted angles, a of velocities, and the increment u.
        let stage = |h: R, k: &D::V, v: &D::V, a: &D::V| {
            let mut q = D::Q::zero();
            let u = k.scaled(h);
            let integral = if D::LAYOUT.quaternions == 0 { u } else { v.scaled(h) };
            retract_counting(&D::LAYOUT, &state.q, &u, &integral, &mut q);
            (State { q, v: state.v.plus(h, a) }, u)
        };
        let slope = |u: &D::V, v: &D::V| inverse_differential(&D::LAYOUT, u, v);
        let mut first = *state;
        let a1 = dynamics.acceleration(time, &mut first);
        let v1 = &first.v;
        let (mut second, u2) = stage(half, v1, v1, &a1);
        let a2 = dynamics.acceleration(time + half, &mut second);
        let (v2, k2) = (&second.v, slope(&u2, &second.v));
        let (mut third, u3) = stage(half, &k2, v2, &a2);
        let a3 = dynamics.acceleration(time + half, &mut third);
        let (v3, k3) = (&third.v, slope(&u3, &third.v));
        let (mut fourth, u4) = stage(h, &k3, v3, &a3);
        let a4 = dynamics.acceleration(time + h, &mut fourth);
        let (v4, k4) = (&fourth.v, slope(&u4, &fourth.v));
        let v = mean(v1, v2, v3, v4);
        let k = if D::LAYOUT.quaternions == 0 { v } else { mean(v1, &k2, &k3, &k4) };
        Ok(Stepped::explicit(h, stage(h, &k, &v, &mean(&a1, &a2, &a3, &a4)).0))
    }
}

/// (k₁ + 2 k₂ + 2 k₃ + k₄)/6, written about k₁ so that four equal slopes give that slope back to the bit.
#[inline]
fn mean<R: Real, V: Vector<R>>(k1: &V, k2: &V, k3: &V, k4: &V) -> V {
    let (two, sixth) = (R::from_f64(2.0), R::from_f64(1.0 / 6.0));
    let mut mean = *k1;
    let others = k2.as_slice().iter().zip(k3.as_slice()).zip(k4.as_slice());
    for (k, ((&k2, &k3), &k4)) in mean.as_mut_slice().iter_mut().zip(others) {
        *k = *k + ((k2 - *k) * two + (k3 - *k) * two + (k4 - *k)) * sixth;
    }
    mean
}
