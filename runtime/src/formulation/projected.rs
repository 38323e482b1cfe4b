//! Projection onto the constraints at the end of each step, after any formulation.

use super::null_space::by_tables;
use super::onto_constraints::{Ask, Bounds, onto_constraints};
use super::{Evaluation, Formulation, PivotOf, Settled, largest_mass, positive};
use crate::assembly::system::subtract_product;
use crate::error::{AssemblyError, SettingError};
use crate::mechanism::Assemble;
use crate::partition::Partition;
use crate::real::Real;
use crate::state::StateOf;
use crate::vector::Vector;

/// A formulation whose positions and velocities are brought to the constraints at the end of each step, on the shortest way
/// in the norm of the mass matrix:
///
/// ```text
/// ⎡ M  Dᵀ ⎤ ⎡ δ ⎤   ⎡  0 ⎤                    ⎡ M  Dᵀ ⎤ ⎡ Δv ⎤   ⎡    0    ⎤
/// ⎣ D  −c ⎦ ⎣ μ ⎦ = ⎣ −Φ ⎦,  q ← q ⊕ δ, …     ⎣ D  −c ⎦ ⎣ σ  ⎦ = ⎣ ν − D v ⎦,  v ← v + Δv
/// ```
/// δ is repeated until it vanishes; one factorisation serves all of it. c = 1/α is so small that at regular positions it
/// only takes part in the speed of convergence, and so large that at singular ones the direction without a constraint is
/// left alone.
///
/// Where a stage is so near a singular position that pivots of D M⁻¹ Dᵀ have lost half of their digits, its accelerations are computed in
/// independent velocities: pivots of D vanish with the distance from the singular position, not with its square, and lose half as many.
/// Source: Bayo, Ledesma, Nonlinear Dynamics 9 (1996) 113–130; García de Jalón, Bayo, *Kinematic and Dynamic Simulation of
/// Multibody Systems*, 5.3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projected<F, R = f64> {
    /// The formulation that gives the accelerations.
    pub formulation: F,
    /// α = 1/c as a multiple of the largest entry of M.
    pub weight: R,
    /// max |Φ| at which positions are good, m, rad or the row's own unit.
    pub tolerance: R,
    /// The most iterations made for positions.
    pub iterations: u32,
}

impl<F, R: Real> Projected<F, R> {
    /// Projection after `formulation`, to rounding: 10⁻¹⁴ in double precision.
    pub fn after(formulation: F) -> Self {
        let tolerance = R::from_f64(1e-14).max(R::from_f64(16.0) * R::EPSILON);
        Projected { formulation, weight: weight(), tolerance, iterations: 10 }
    }

    /// Positions; returns the iterations made and how far a coordinate moved.
    fn position<M: Assemble<R>>(
        &self,
        model: &M,
        store: &mut M::Store,
        compliance: R,
        time: R,
        q: &mut M::Q,
    ) -> Result<Settled<R>, AssemblyError> {
        let bounds = Bounds { tolerance: self.tolerance, iterations: self.iterations };
        onto_constraints(model, time, q, &bounds, |ask, q, phi| {
            let mut delta = model.zero_v();
            match ask {
                Ask::Factor => _ = model.factor(time, q, compliance, store),
                Ask::Step => {
                    let rows = phi.scaled(-R::ONE);
                    model.solve(store, &model.zero_v(), &rows, &mut delta, &mut model.zero_lambda());
                }
            }
            delta
        })
    }
}

/// c at a position, and the factor with it.
fn factored<R: Real, M: Assemble<R>>(model: &M, weight: R, time: R, q: &M::Q) -> (R, M::Store) {
    let compliance = R::ONE / (weight * largest_mass(model, time, q));
    let mut store = model.store();
    model.factor(time, q, compliance, &mut store);
    (compliance, store)
}

/// Velocities, with the factor of a position that is the same but for what was corrected.
fn velocity<R: Real, M: Assemble<R>>(model: &M, store: &M::Store, time: R, state: &mut StateOf<M, R>) {
    let (mut nu, mut jacobian) = (model.zero_lambda(), model.zero_jacobian());
    model.nu(time, &state.q, &mut nu);
    model.constraint_jacobian(time, &state.q, &mut jacobian);
    for _ in 0..2 {
        let mut rest = nu.clone();
        let columns = jacobian.as_slice();
        subtract_product(model.jacobian_pattern(), columns, state.v.as_slice(), rest.as_mut_slice());
        let (mut delta, mut multipliers) = (model.zero_v(), model.zero_lambda());
        model.solve(store, &model.zero_v(), &rest, &mut delta, &mut multipliers);
        state.v.axpy(R::ONE, &delta);
    }
}

/// Brings velocities to the constraints on the shortest way in the norm of the mass matrix, as [`Projected`] does.
pub(crate) fn velocities_onto_constraints<R: Real, M: Assemble<R>>(
    model: &M,
    time: R,
    state: &mut StateOf<M, R>,
) {
    if model.row_count() > 0 {
        let (_, store) = factored(model, weight(), time, &state.q);
        velocity(model, &store, time, state);
    }
}

/// α as a multiple of the largest entry of M where nothing else is asked for.
fn weight<R: Real>() -> R {
    R::from_f64(1e10).min(R::ONE / (R::from_f64(100.0) * R::EPSILON))
}

impl<R: Real, M: Assemble<R>, F: Formulation<R, M>> Formulation<R, M> for Projected<F, R> {
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
        let evaluation = self.formulation.acceleration(memory, model, time, state, u, a, lambda);
        // Written so that a NaN is seen.
        if matches!(F::pivot_of(model), PivotOf::Rows | PivotOf::JacobianOrRows)
            && !R::any(evaluation.pivot.greater_equal(R::from_f64(10.0) * R::NEAR_SINGULAR))
        {
            return near_singular(model, time, state, u, a, lambda, evaluation);
        }
        evaluation
    }

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
        let (compliance, mut store) = factored(model, self.weight, time, &state.q);
        let own = self.position(model, &mut store, compliance, time, &mut state.q)?;
        velocity(model, &store, time, state);
        Ok(Settled { iterations: inner.iterations + own.iterations, moved: inner.moved.max(own.moved) })
    }

    fn check(&self) -> Result<(), SettingError> {
        self.formulation.check()?;
        positive("the projection's weight", self.weight, "positive and finite, such as 1e10")?;
        positive("the projection's tolerance", self.tolerance, "positive and finite (m), such as 1e-14")?;
        if self.iterations == 0 {
            let must_be = "at least 1";
            return Err(SettingError { what: "the projection's iterations", value: 0.0, must_be });
        }
        Ok(())
    }
}

/// The accelerations of Lagrange's equations by way of independent velocities, where they can be had; the pivot stays that of the rows,
/// which says how near the singular position is.
#[cold]
fn near_singular<R: Real, M: Assemble<R>>(
    model: &M,
    time: R,
    state: &StateOf<M, R>,
    u: &M::Inputs,
    a: &mut M::V,
    lambda: &mut M::Lambda,
    evaluation: Evaluation<R>,
) -> Evaluation<R> {
    let (mut better, mut multipliers) = (model.zero_v(), model.zero_lambda());
    let mut partition = Partition::new(model);
    by_tables(&mut partition, model, time, state, u, &mut better, &mut multipliers);
    if better.first_not_finite().is_none() {
        (*a, *lambda) = (better, multipliers);
    }
    evaluation
}
