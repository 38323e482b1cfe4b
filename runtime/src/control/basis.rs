//! Motions that the constraints admit, of any mechanism: N with D N = 0, a column for each degree of freedom.
//!
//! N is found by [`Partition`], from the factors of D = L U, and so holds the rows to rounding, dead centres of coordinates included. Which
//! velocities are independent is of no matter here; columns that belong to coordinates are `reduced.rs`.

use crate::assembly::system::{mass_times, subtract_product};
use crate::error::LinearisationError;
use crate::linearisation::broken_down;
use crate::mechanism::Assemble;
use crate::partition::{Partition, PartitionOf};
use crate::real::Real;
use crate::state::StateOf;
use crate::vector::Vector;

/// N at one position, and the factors that it comes from.
pub(super) struct Basis<'m, R: Real, M: Assemble<R>> {
    model: &'m M,
    partition: PartitionOf<R, M>,
    factors: M::Dense,
    /// Column by column.
    columns: M::Basis,
}

impl<'m, R: Real, M: Assemble<R>> Basis<'m, R, M> {
    pub(super) fn at(model: &'m M, time: R, q: &M::Q) -> Result<Self, LinearisationError> {
        let (mut partition, mut factors) = (Partition::new(model), model.zero_dense());
        let pivot = partition.factor(model, time, q, &mut factors);
        // Written so that a NaN fails.
        if !R::any(pivot.greater_equal(R::BREAKDOWN)) {
            return Err(broken_down(model, time, q, pivot));
        }
        let mut columns = model.zero_basis();
        partition.basis(model, &factors, &mut columns);
        Ok(Basis { model, partition, factors, columns })
    }

    /// Its columns, n_v entries each.
    pub(super) fn columns(&self) -> impl Iterator<Item = &[R]> {
        let n = self.model.velocity_count();
        self.columns.as_slice().chunks_exact(n.max(1)).take(self.model.freedoms())
    }

    /// p with D p = `rows`, of which the independent velocities are zero.
    pub(super) fn particular(&self, rows: &M::Lambda) -> M::V {
        let mut p = self.model.zero_v();
        self.partition.dependent(self.model, &self.factors, rows, &mut p);
        p
    }

    /// λ of D_dᵀ λ = `forces` in the dependent velocities.
    pub(super) fn multipliers(&self, forces: &M::V) -> M::Lambda {
        let mut lambda = self.model.zero_lambda();
        self.partition.multipliers(self.model, &self.factors, forces, &mut lambda);
        lambda
    }

    /// The independent velocity that a column belongs to, by its name.
    pub(super) fn name(&self, place: usize) -> &'static str {
        let velocity = self.partition.independent().nth(place);
        let name = velocity.and_then(|velocity| self.model.velocity_names().get(velocity));
        name.copied().unwrap_or(self.model.name())
    }
}

/// M a at a state.
pub(super) fn inertia<R: Real, M: Assemble<R>>(model: &M, time: R, state: &StateOf<M, R>, a: &M::V) -> M::V {
    let mut mass = model.zero_mass();
    model.mass_matrix(time, &state.q, &mut mass);
    mass_times(model, &mass, a)
}

/// B x of all conditions, with B from `model.condition_jacobian(…)`.
pub(super) fn condition_product<R: Real, M: Assemble<R>>(
    model: &M,
    jacobian: &M::ConditionJacobian,
    x: &[R],
) -> M::Conditions {
    let mut product = model.zero_conditions();
    subtract_product(model.condition_pattern(), jacobian.as_slice(), x, product.as_mut_slice());
    product.scaled(-R::ONE)
}
