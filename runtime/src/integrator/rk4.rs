//! The classical Runge–Kutta method of order four.

use super::{Dynamics, Integrator};
use crate::layout::retract;
use crate::real::Real;
use crate::state::State;
use crate::vector::Vector;

/// The classical method of order 4 (Kutta 1901; Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*,
/// II.1), four evaluations a step.
///
/// On the group every stage starts from the step's own beginning: q_i = q ⊕ h Σ a_ij v_j. Rotations of the plane
/// commute, so the Munthe-Kaas corrections vanish and the order is kept; a uniform rotation is exact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rk4;

impl<R: Real> Integrator<R> for Rk4 {
    #[inline]
    fn step<D: Dynamics<R>>(
        &self,
        dynamics: &mut D,
        time: R,
        h: R,
        state: &State<D::Q, D::V>,
    ) -> State<D::Q, D::V> {
        let half = h * R::from_f64(0.5);
        let stage = |h: R, v: &D::V, a: &D::V| {
            let mut q = D::Q::zero();
            retract(&D::LAYOUT, &state.q, &v.scaled(h), &mut q);
            State { q, v: state.v.plus(h, a) }
        };
        let a1 = dynamics.acceleration(time, state);
        let second = stage(half, &state.v, &a1);
        let a2 = dynamics.acceleration(time + half, &second);
        let third = stage(half, &second.v, &a2);
        let a3 = dynamics.acceleration(time + half, &third);
        let fourth = stage(h, &third.v, &a3);
        let a4 = dynamics.acceleration(time + h, &fourth);
        let v = mean(&state.v, &second.v, &third.v, &fourth.v);
        stage(h, &v, &mean(&a1, &a2, &a3, &a4))
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
