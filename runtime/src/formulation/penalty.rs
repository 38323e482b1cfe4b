//! The penalty formulation: constraints as stiff spring-dampers in the directions of their rows.

use super::friction::with_friction;
use super::{Evaluation, Formulation, PivotOf, not_negative, positive};
use crate::error::SettingError;
use crate::mechanism::{Assemble, Mechanism};
use crate::real::Real;
use crate::state::StateOf;
use crate::vector::Vector;

/// The penalty formulation, (M + Dᵀ α D) v̇ = Q + Dᵀ α (γ − 2 μ Ω (D v − ν) − Ω² Φ).
///
/// The multipliers are λ = α (D v̇ − γ + 2 μ Ω (D v − ν) + Ω² Φ), so that the equation is the first of
///
/// ```text
/// ⎡ M   Dᵀ  ⎤ ⎡ v̇ ⎤   ⎡ Q                              ⎤
/// ⎣ D  −1/α ⎦ ⎣ λ ⎦ = ⎣ γ − 2 μ Ω (D v − ν) − Ω² Φ     ⎦
/// ```
/// after elimination of λ, and this is what is factored, in the order of Lagrange's equations: no digits are lost to a
/// large α, and there is a solution at singular positions and with redundant rows as well.
///
/// - α, kg (kg m² for rows in rad): what an error of the acceleration costs. The constraints carry less than they should
///   by the part 1/(1 + α σ), σ an eigenvalue of D M⁻¹ Dᵀ; near a singular position, where σ is small, they give way. Where
///   M + Dᵀ α D itself is factored, α loses digits, and 10⁷ times the largest entry of M is customary; here it may be as large as
///   it needs to be.
/// - Ω, rad/s: the frequency with which errors of position are brought back; Ω h must stay well below one.
/// - μ: the damping ratio of that; 1 is critical.
///
/// Source: Bayo, García de Jalón, Serna, Computer Methods in Applied Mechanics and Engineering 71 (1988) 183–195;
/// García de Jalón, Bayo, *Kinematic and Dynamic Simulation of Multibody Systems*, 5.1.4; S. Bai, lecture *Dynamics*, equation
/// (2.18).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Penalty<R = f64> {
    /// α, kg.
    pub alpha: R,
    /// Ω, rad/s.
    pub omega: R,
    /// μ.
    pub mu: R,
}

impl<R: Real> Penalty<R> {
    /// α with Ω = 10 rad/s and μ = 1.
    pub fn new(alpha: R) -> Self {
        Penalty { alpha, omega: R::from_f64(10.0), mu: R::ONE }
    }

    /// Settings that suit a mechanism and a step of `h` seconds: α is the largest entry of M at `q` times ε^(−3/4), 5.5·10¹¹
    /// in double and 1.6·10⁵ in single precision; Ω = 10 rad/s or, for steps above a hundredth of a second, 1/(10 h); μ = 1.
    pub fn for_model<M: Mechanism<R>>(model: &M, time: R, q: &M::Q, h: R) -> Self {
        let root = R::EPSILON.sqrt();
        Self::weighted(model, time, q, h, R::ONE / (root * root.sqrt()))
    }

    /// As [`for_model`](Penalty::for_model), with the customary α of 10⁷ times the largest entry of M.
    pub fn customary<M: Mechanism<R>>(model: &M, time: R, q: &M::Q, h: R) -> Self {
        Self::weighted(model, time, q, h, R::from_f64(1e7))
    }

    /// α = `weight` times the largest entry of M; Ω and μ as in [`for_model`](Penalty::for_model).
    fn weighted<M: Mechanism<R>>(model: &M, time: R, q: &M::Q, h: R, weight: R) -> Self {
        let ten = R::from_f64(10.0);
        let omega = (R::ONE / (ten * h)).min(ten);
        Penalty { alpha: weight * largest_mass(model, time, q), omega, mu: R::ONE }
    }

    pub(super) fn checked(&self) -> Result<(), SettingError> {
        positive(
            "the penalty's alpha",
            self.alpha,
            "positive and finite (kg), customarily 1e7 times the largest mass",
        )?;
        not_negative("the penalty's omega", self.omega, "zero or positive, and finite (rad/s)")?;
        not_negative("the penalty's mu", self.mu, "zero or positive, and finite")
    }

    /// Factors the matrix and gives its right-hand sides; returns the smallest relative pivot.
    #[inline]
    #[allow(clippy::too_many_arguments)]
    pub(super) fn system<M: Assemble<R>>(
        &self,
        model: &M,
        time: R,
        state: &StateOf<M, R>,
        u: &M::Inputs,
        store: &mut M::Store,
        forces: &mut M::V,
        rows: &mut M::Lambda,
    ) -> R {
        let two_mu_omega = (self.mu + self.mu) * self.omega;
        let omega_squared = self.omega * self.omega;
        let compliance = R::ONE / self.alpha;
        model.system(time, state, u, two_mu_omega, omega_squared, compliance, store, forces, rows)
    }
}

impl<R: Real, M: Assemble<R>> Formulation<R, M> for Penalty<R> {
    type Memory = ();

    #[inline(always)]
    fn pivot_of(_model: &M) -> PivotOf {
        PivotOf::Velocities
    }

    fn memory(&self, _model: &M) {}

    #[inline]
    fn acceleration(
        &self,
        _memory: &mut (),
        model: &M,
        time: R,
        state: &mut StateOf<M, R>,
        u: &M::Inputs,
        a: &mut M::V,
        lambda: &mut M::Lambda,
    ) -> Evaluation<R> {
        let (mut store, mut forces, mut rows) = (model.store(), model.zero_v(), model.zero_lambda());
        let pivot = self.system(model, time, state, u, &mut store, &mut forces, &mut rows);
        with_friction(model, time, state, u, &forces, a, lambda, |forces, a, lambda| {
            model.solve(&store, forces, &rows, a, lambda);
            Evaluation::direct(pivot)
        })
    }

    fn check(&self) -> Result<(), SettingError> {
        self.checked()
    }
}

/// The largest diagonal entry of M, or one if there is none.
pub(crate) fn largest_mass<R: Real, M: Mechanism<R>>(model: &M, time: R, q: &M::Q) -> R {
    let mut mass = model.zero_mass();
    model.mass_matrix(time, q, &mut mass);
    let diagonal = mass.as_slice().iter().zip(model.mass_pattern()).filter(|(_, (i, j))| i == j);
    let largest = diagonal.fold(R::ZERO, |largest, (&entry, _)| largest.max(entry));
    if largest > R::ZERO { largest } else { R::ONE }
}
