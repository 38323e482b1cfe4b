//! The explicit trapezoidal predictor–corrector of tracked-vehicle simulation.

use super::{Dynamics, Integrator, Method, StepFailure, Stepped, SteppedOf};
use crate::real::Real;
use crate::state::{StateOf, Variables};
use crate::vector::Vector;

/// The trapezoidal rule with one predictor and one corrector, order 2, two evaluations a step:
///
/// ```text
/// predictor  v* = v₀ + h a₀,                q* = q₀ ⊕ h/2 (v₀ + v*),   a* = v̇(t + h, q*, v*)
/// corrector  v₁ = v₀ + h/2 (a₀ + a*),       q₁ = q₀ ⊕ h/2 (v₀ + v₁)
/// ```
/// Internal states take the rule as velocities do: z* = z₀ + h ż₀, z₁ = z₀ + h/2 (ż₀ + ż*).
/// Orientations turn by the incremental rotation Δθ = h/2 (ω₀ + ω₁), R₁ = R₀ R(Δθ); with the mean of the rates at both
/// ends the order asks for no correction of it.
///
/// A vibration with ω and the damping ratio ζ is stable while z² + 4 ζ z < 4 with z = ω h (Jury's conditions on the trace and the determinant of a
/// step, which without damping are 2 − z² + z⁴/8 and 1 − z⁴/8): h < 2 (√(1 + ζ²) − ζ)/ω. Damping of stiff springs shortens it. Below that
/// amplitudes of undamped vibrations shrink by z⁴/16 a step. `linkwright explain` names the limit of joints that yield.
/// Source: equations (3)–(5) of the tracked-vehicle suspension model validated on an N-post motion simulator, listed in
/// the models' sources; Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*, III.1 (PECE mode).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ExplicitTrapezoidal;

impl<R: Real> Method<R> for ExplicitTrapezoidal {
    type Memory<X: Variables<R>> = ();

    fn memory<X: Variables<R>>(&self) {}
}

impl<R: Real, X: Variables<R>, D: Dynamics<R, Variables = X>> Integrator<R, D> for ExplicitTrapezoidal {
    #[inline]
    fn step(
        &self,
        _memory: &mut (),
        dynamics: &mut D,
        time: R,
        h: R,
        state: &StateOf<X, R>,
    ) -> Result<SteppedOf<X, R>, StepFailure<R>> {
        let half = h * R::from_f64(0.5);
        let mut begin = state.clone();
        let first = dynamics.derivative(time, &mut begin);
        let after = |dynamics: &D, v: X::V, z: X::Z| {
            begin.moved(dynamics.variables().layout(), &begin.v.plus(R::ONE, &v).scaled(half), v, z)
        };
        let mut predicted = after(dynamics, begin.v.plus(h, &first.a), begin.z.plus(h, &first.z));
        let last = dynamics.derivative(time + h, &mut predicted);
        let (a, z) = (first.a.plus(R::ONE, &last.a), first.z.plus(R::ONE, &last.z));
        Ok(Stepped::explicit(h, after(dynamics, begin.v.plus(half, &a), begin.z.plus(half, &z))))
    }
}
