//! One step towards the constraints at the end of each step, after any formulation.

use super::{Evaluation, Formulation, PivotOf, Settled};
use crate::assembly::system::subtract_product;
use crate::error::{AssemblyError, SettingError};
use crate::layout::retract;
use crate::mechanism::Assemble;
use crate::real::Real;
use crate::state::StateOf;
use crate::vector::Vector;

/// A formulation whose positions and velocities are moved towards the constraints by one step of Newton's iteration at the end of each
/// step, on the shortest way in the norm of the mass matrix:
///
/// ```text
/// ⎡ M  Dᵀ ⎤ ⎡ δ ⎤   ⎡  0 ⎤                    ⎡ M  Dᵀ ⎤ ⎡ Δv ⎤   ⎡    0    ⎤
/// ⎣ D  −c ⎦ ⎣ μ ⎦ = ⎣ −Φ ⎦,  q ← q ⊕ δ,       ⎣ D  −c ⎦ ⎣ σ  ⎦ = ⎣ ν − D v ⎦,  v ← v + Δv
/// ```
/// with one factorisation, at the position before. What is left of Φ is the square of what a step brings, rounding at the sizes of
/// steps that controllers take: [`Projected`](super::Projected) in a time that is always the same. c is so small that at regular
/// positions it changes nothing, and so large that at singular ones the direction without a constraint is left alone. With
/// `options { emit = (projection); }` the factorisation is written out, otherwise it goes by tables, three times as slow.
/// Source: Bayo, Ledesma, Nonlinear Dynamics 9 (1996) 113–130, here without iteration.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Corrected<F> {
    /// The formulation that gives the accelerations.
    pub formulation: F,
}

impl<F> Corrected<F> {
    /// The correction after `formulation`.
    pub const fn after(formulation: F) -> Self {
        Corrected { formulation }
    }
}

impl<R: Real, M: Assemble<R>, F: Formulation<R, M>> Formulation<R, M> for Corrected<F> {
    type Memory = F::Memory;

    #[inline(always)]
    fn pivot_of(model: &M) -> PivotOf {
        F::pivot_of(model)
    }

    fn memory(&self, model: &M) -> F::Memory {
        self.formulation.memory(model)
    }

    #[inline]
    fn acceleration(
        &self,
        memory: &mut F::Memory,
        model: &M,
        time: R,
        state: &mut StateOf<M, R>,
        u: &M::Inputs,
        a: &mut M::V,
        lambda: &mut M::Lambda,
    ) -> Evaluation<R> {
        self.formulation.acceleration(memory, model, time, state, u, a, lambda)
    }

    #[inline]
    fn settle(
        &self,
        memory: &mut F::Memory,
        model: &M,
        time: R,
        state: &mut StateOf<M, R>,
    ) -> Result<Settled<R>, AssemblyError> {
        let inner = self.formulation.settle(memory, model, time, state)?;
        if model.row_count() == 0 {
            return Ok(inner);
        }
        let mut store = model.store();
        model.factor(time, &state.q, compliance(model), &mut store);

        let (mut phi, mut rest) = (model.zero_lambda(), model.zero_lambda());
        model.constraints(time, &state.q, &mut phi);
        model.nu(time, &state.q, &mut rest);
        let mut jacobian = model.zero_jacobian();
        model.constraint_jacobian(time, &state.q, &mut jacobian);
        let columns = jacobian.as_slice();
        subtract_product(model.jacobian_pattern(), columns, state.v.as_slice(), rest.as_mut_slice());

        let (forces, mut multipliers) = (model.zero_v(), model.zero_lambda());
        let (mut delta, mut change) = (model.zero_v(), model.zero_v());
        model.solve(&store, &forces, &phi.scaled(-R::ONE), &mut delta, &mut multipliers);
        model.solve(&store, &forces, &rest, &mut change, &mut multipliers);
        let from = state.q.clone();
        retract(model.layout(), &from, &delta, &mut state.q);
        state.v.axpy(R::ONE, &change);
        Ok(Settled { iterations: inner.iterations, moved: inner.moved.max(delta.max_abs()) })
    }

    fn check(&self) -> Result<(), SettingError> {
        self.formulation.check()
    }
}

/// A hundred roundings of the largest entry of D M⁻¹ Dᵀ, 1/kg.
#[inline]
fn compliance<R: Real, M: Assemble<R>>(model: &M) -> R {
    let mut scales = model.zero_lambda();
    model.row_scales(&mut scales);
    let rounding = R::EPSILON * R::from_f64(100.0);
    scales.max_abs() * rounding
}
