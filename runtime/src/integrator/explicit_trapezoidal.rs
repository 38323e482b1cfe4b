//! The explicit trapezoidal predictor–corrector of tracked-vehicle simulation.

use super::{Dynamics, Integrator, Method, StepFailure, Stepped};
use crate::layout::retract;
use crate::real::Real;
use crate::state::State;
use crate::vector::Vector;

/// The trapezoidal rule with one predictor and one corrector, order 2, two evaluations a step:
///
/// ```text
/// predictor  v* = v₀ + h a₀,                q* = q₀ ⊕ h/2 (v₀ + v*),   a* = v̇(t + h, q*, v*)
/// corrector  v₁ = v₀ + h/2 (a₀ + a*),       q₁ = q₀ ⊕ h/2 (v₀ + v₁)
/// ```
/// Orientations turn by the incremental rotation Δθ = h/2 (ω₀ + ω₁), R₁ = R₀ R(Δθ); with the mean of the rates at both
/// ends the order asks for no correction of it. a* damps stiff springs less than they need: h must stay below
/// √2/ω of the fastest vibration.
/// Source: equations (3)–(5) of the tracked-vehicle suspension model validated on an N-post motion simulator, listed in
/// the models' sources; Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*, III.1 (PECE mode).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ExplicitTrapezoidal;

impl<R: Real> Method<R> for ExplicitTrapezoidal {
    type Memory<Q: Vector<R>, V: Vector<R>, Lambda: Vector<R>> = ();

    fn memory<Q: Vector<R>, V: Vector<R>, Lambda: Vector<R>>(&self) {}
}

impl<R: Real, D: Dynamics<R>> Integrator<R, D> for ExplicitTrapezoidal {
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
        let mut begin = *state;
        let a0 = dynamics.acceleration(time, &mut begin);
        let after = |v: D::V| {
            let mut q = D::Q::zero();
            retract(&D::LAYOUT, &begin.q, &begin.v.plus(R::ONE, &v).scaled(half), &mut q);
            State { q, v }
        };
        let mut predicted = after(begin.v.plus(h, &a0));
        let a1 = dynamics.acceleration(time + h, &mut predicted);
        Ok(Stepped::explicit(h, after(begin.v.plus(half, &a0.plus(R::ONE, &a1)))))
    }
}
