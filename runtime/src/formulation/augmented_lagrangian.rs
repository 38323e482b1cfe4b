//! The augmented Lagrangian formulation of index 1: penalties that iterate until the constraints hold.

use super::friction::with_friction;
use super::{Evaluation, Formulation, Penalty, PivotOf, positive};
use crate::error::SettingError;
use crate::mechanism::Assemble;
use crate::real::Real;
use crate::state::StateOf;
use crate::vector::Vector;

/// The augmented Lagrangian formulation of index 1:
///
/// ```text
/// (M + Dᵀ α D) v̇ᵢ₊₁ = Q + Dᵀ α (γ − 2 μ Ω (D v − ν) − Ω² Φ) − Dᵀ λᵢ
/// λᵢ₊₁ = λᵢ + α (D v̇ᵢ₊₁ − γ + 2 μ Ω (D v − ν) + Ω² Φ)
/// ```
/// until the accelerations change by less than `tolerance`, relative to the largest of them, or `iterations` are made. The
/// limit is that of Lagrange's equations with Baumgarte's α = μ Ω, β = Ω, whatever the penalty; where these have no or
/// no single solution, at singular positions and with redundant rows, the iteration stays regular. The matrix is
/// factored once: an iteration is a substitution. It begins with the multipliers of the evaluation before.
///
/// α, Ω and μ as in [`Penalty`]; an iteration divides the error by 1 + α σ, σ an eigenvalue of D M⁻¹ Dᵀ.
/// Source: Bayo, García de Jalón, Serna, Computer Methods in Applied Mechanics and Engineering 71 (1988) 183–195;
/// García de Jalón, Bayo, *Kinematic and Dynamic Simulation of Multibody Systems*, 5.1.5.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AugmentedLagrangian<R = f64> {
    /// α, Ω and μ.
    pub penalty: Penalty<R>,
    /// The change of an acceleration at which the iteration ends, relative to the largest acceleration.
    pub tolerance: R,
    /// The most iterations made.
    pub iterations: u32,
}

impl<R: Real> AugmentedLagrangian<R> {
    /// The iteration with this penalty to 10⁻¹² (in single precision to a few roundings), at most ten times.
    pub fn new(penalty: Penalty<R>) -> Self {
        let tolerance = R::from_f64(1e-12).max(R::from_f64(8.0) * R::EPSILON);
        AugmentedLagrangian { penalty, tolerance, iterations: 10 }
    }
}

impl<R: Real, M: Assemble<R>> Formulation<R, M> for AugmentedLagrangian<R> {
    /// λ of the evaluation before.
    type Memory = M::Lambda;

    #[inline(always)]
    fn pivot_of(_model: &M) -> PivotOf {
        PivotOf::Velocities
    }

    fn memory(&self, model: &M) -> M::Lambda {
        model.zero_lambda()
    }

    #[inline]
    fn acceleration(
        &self,
        memory: &mut M::Lambda,
        model: &M,
        time: R,
        state: &mut StateOf<M, R>,
        u: &M::Inputs,
        a: &mut M::V,
        lambda: &mut M::Lambda,
    ) -> Evaluation<R> {
        let (mut store, mut forces, mut rows) = (model.store(), model.zero_v(), model.zero_lambda());
        let pivot = self.penalty.system(model, time, state, u, &mut store, &mut forces, &mut rows);
        let compliance = R::ONE / self.penalty.alpha;
        // D v̇ − λ/α = γ' − λᵢ/α: the row of the penalty, moved by the multipliers known.
        let mut known = memory.clone();
        let evaluation = with_friction(model, time, state, u, &forces, a, lambda, |forces, a, lambda| {
            model.solve(&store, forces, &rows.plus(-compliance, &known), a, lambda);
            let mut evaluation = Evaluation::direct(pivot);
            while evaluation.iterations < self.iterations {
                let before = a.clone();
                known.clone_from(lambda);
                model.solve(&store, forces, &rows.plus(-compliance, &known), a, lambda);
                let (change, size) = (a.plus(-R::ONE, &before).max_abs(), a.max_abs());
                evaluation.iterations += 1;
                evaluation.residual = if size > R::ZERO { change / size } else { R::ZERO };
                if evaluation.residual <= self.tolerance {
                    break;
                }
            }
            known.clone_from(lambda);
            evaluation
        });
        // A multiplier that is not finite is no beginning for the next iteration.
        if lambda.first_not_finite().is_none() {
            memory.clone_from(lambda);
        }
        evaluation
    }

    fn check(&self) -> Result<(), SettingError> {
        self.penalty.checked()?;
        positive(
            "the augmented Lagrangian's tolerance",
            self.tolerance,
            "positive and finite, such as 1e-12",
        )?;
        if self.iterations == 0 {
            let must_be = "at least 1; without iteration take `Penalty`";
            return Err(SettingError { what: "the augmented Lagrangian's iterations", value: 0.0, must_be });
        }
        Ok(())
    }
}
