//! ALI3-P: the index-3 augmented Lagrangian with projections of velocities and accelerations.

use super::generalised_alpha::checked;
use super::newmark::{Carried, CarriedOf, Factored, ImplicitDynamics, Level, Scheme, Weights};
use super::{Integrator, Method, StepFailure, SteppedOf};
use crate::error::SettingError;
use crate::real::Real;
use crate::state::{StateOf, Variables};
use crate::vector::Vector;

/// The index-3 augmented Lagrangian formulation with mass-damping-stiffness-orthogonal projections (ALI3-P): the trapezoidal rule
/// with penalties and iterated multipliers at the level of positions,
///
/// ```text
/// M v̇₁ + Dᵀ (α Φ + λ*) = Q,   λ* ← λ* + α Φ,   v₁ = v₀ + h/2 (v̇₀ + v̇₁),   q₁ = q₀ ⊕ h/2 (v₀ + v₁)
/// ```
/// then velocities and accelerations brought to the constraints with the matrix of that iteration, P = M + h/2 C + h²/4 K:
///
/// ```text
/// ⎡ P        Dᵀ   ⎤ ⎡ v₁ ⎤   ⎡ P v₁* ⎤        ⎡ P        Dᵀ   ⎤ ⎡ v̇₁ ⎤   ⎡ P v̇₁* ⎤
/// ⎣ D  −4/(h² α) ⎦ ⎣ σ  ⎦ = ⎣ ν     ⎦,       ⎣ D  −4/(h² α) ⎦ ⎣ κ  ⎦ = ⎣ γ      ⎦
/// ```
/// It stays regular at singular positions, where the multipliers are no longer determined and the iteration ends at its bound as soon
/// as it moves nothing by more than the root of the tolerance, and with redundant rows. Internal states that a multiplier moves ask for
/// its convergence: a small α is refused there. Projections take energy away, about h² of it. The method
/// uses nothing of the formulation but the accelerations at the start.
///
/// Source: Bayo, Ledesma, Nonlinear Dynamics 9 (1996) 113–130; Cuadrado, Cardenal, Morer, Bayo, Multibody System Dynamics 4
/// (2000) 55–73; Dopico, González, Cuadrado, Kövecses, Journal of Computational and Nonlinear Dynamics 9 (2014) 041006.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ali3p<R = f64> {
    /// α, N/m (N m/rad for rows in rad), customarily 10⁷ to 10⁹ times the largest entry of M.
    pub alpha: R,
    /// The change of a coordinate at which the iteration ends, relative to 1 + the largest coordinate.
    pub tolerance: R,
    /// The most iterations a step.
    pub iterations: u32,
}

impl<R: Real> Ali3p<R> {
    /// The method with this α, iterated to 10⁻¹⁰ (single precision: 32 roundings), at most 40 times.
    pub fn new(alpha: R) -> Self {
        let tolerance = R::from_f64(1e-10).max(R::from_f64(32.0) * R::EPSILON);
        Ali3p { alpha, tolerance, iterations: 40 }
    }
}

impl<R: Real> Method<R> for Ali3p<R> {
    type Memory<X: Variables<R>> = CarriedOf<X, R>;

    fn memory<X: Variables<R>>(&self) -> CarriedOf<X, R> {
        Carried { known: None }
    }

    fn check(&self) -> Result<(), SettingError> {
        if !(self.alpha > R::ZERO && self.alpha.is_finite()) {
            let must_be = "positive and finite (N/m), customarily 1e7 times the largest mass";
            return Err(SettingError { what: "ALI3-P's alpha", value: self.alpha.to_f64(), must_be });
        }
        checked("ALI3-P's tolerance", "ALI3-P's iterations", self.tolerance, self.iterations)
    }
}

impl<R: Real, X: Variables<R>, D: ImplicitDynamics<R, Variables = X>> Integrator<R, D> for Ali3p<R> {
    fn step(
        &self,
        memory: &mut CarriedOf<X, R>,
        dynamics: &mut D,
        time: R,
        h: R,
        state: &StateOf<X, R>,
    ) -> Result<SteppedOf<X, R>, StepFailure<R>> {
        let (half, quarter) = (R::from_f64(0.5), R::from_f64(0.25));
        let scheme = Scheme {
            alpha_m: R::ZERO,
            alpha_f: R::ZERO,
            beta: quarter,
            gamma: half,
            level: Level::Position,
            compliance: R::ONE / self.alpha,
            tolerance: self.tolerance,
            iterations: self.iterations,
        };
        let mut stepped = scheme.step(memory, dynamics, time, h, state)?;
        let Some(known) = &mut memory.known else { return Ok(stepped) };

        // P = m (M + …)/m: the matrix of the step times h²/4.
        let scale = quarter * h * h;
        let weights = Weights {
            mass: R::ONE,
            damping: half * h,
            stiffness: scale,
            compliance: R::ONE / (scale * self.alpha),
            internal: None,
            level: Level::Position,
        };
        let end = time + h;
        let mut factored = Factored::new(dynamics);
        let n = state.v.as_slice().len();
        let u = X::V::zeros(n);
        dynamics.matrix(
            end,
            &stepped.state,
            &known.v_dot,
            &known.lambda,
            &u,
            &weights,
            &mut factored.entries,
        );
        let plain = factored.entries.clone();
        let size = factored.size();
        if factored.lu().factor_above(R::ZERO).is_err() {
            return Err(StepFailure::Singular { time: end });
        }
        let mut project = |x: &mut X::V, rows: &X::Lambda| {
            // Δx of P Δx + Dᵀ σ = 0, D (x + Δx) − c σ = rows.
            let mut right = D::Unknowns::zeros(size);
            let entries = right.as_mut_slice().iter_mut().skip(n).zip(rows.as_slice());
            let plain = plain.as_slice().chunks_exact(size.max(1)).skip(n);
            for ((entry, &asked), d) in entries.zip(plain) {
                let found = d.iter().zip(x.as_slice()).fold(R::ZERO, |sum, (&d, &x)| d.mul_add(x, sum));
                *entry = asked - found;
            }
            factored.lu().solve(right.as_mut_slice());
            for (x, &change) in x.as_mut_slice().iter_mut().zip(right.as_slice()) {
                *x = *x + change;
            }
        };
        let (nu, _) = dynamics.rates(end, &stepped.state);
        project(&mut stepped.state.v, &nu);
        let (_, gamma) = dynamics.rates(end, &stepped.state);
        project(&mut known.v_dot, &gamma);
        known.a = known.v_dot.clone();
        Ok(stepped)
    }
}
