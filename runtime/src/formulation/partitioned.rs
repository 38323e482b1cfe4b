//! Coordinate partitioning: dependent positions and velocities follow from independent ones.

use super::onto_constraints::{Ask, Bounds, onto_constraints};
use super::{Evaluation, Formulation, Settled, positive};
use crate::error::{AssemblyError, SettingError};
use crate::mechanism::Assemble;
use crate::partition::{Partition, PartitionOf};
use crate::real::Real;
use crate::state::StateOf;
use crate::vector::Vector;

/// Generalised coordinate partitioning: at every stage and at the end of a step the dependent positions are brought to the
/// constraints by Newton's iteration with the independent ones held, D_d δ_d = −Φ, δ_i = 0, and the dependent velocities
/// follow from D v = ν; accelerations are those of Lagrange's equations there. Only independent coordinates are
/// integrated, whatever the integrator; the error of the constraints is that of the iteration.
///
/// The independent set is kept while its pivots are good, and chosen anew by pivoting where they degrade; always by tables, entry by
/// entry: where positions follow at every stage, a set that is kept for longer costs digits near singular positions.
/// Source: Wehage, Haug, Journal of Mechanical Design 104 (1982) 247–255.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Partitioned<R = f64> {
    /// max |Φ| at which positions are good, m, rad or the row's own unit.
    pub tolerance: R,
    /// The most iterations made.
    pub iterations: u32,
}

impl<R: Real> Default for Partitioned<R> {
    /// To rounding: 10⁻¹⁴ in double precision, at most ten iterations.
    fn default() -> Self {
        let tolerance = R::from_f64(1e-14).max(R::from_f64(16.0) * R::EPSILON);
        Partitioned { tolerance, iterations: 10 }
    }
}

impl<R: Real> Partitioned<R> {
    /// Brings the dependent positions and velocities after the independent ones; returns the pivot of the partition too.
    fn bring<M: Assemble<R>>(
        &self,
        partition: &mut PartitionOf<R, M>,
        model: &M,
        time: R,
        state: &mut StateOf<M, R>,
    ) -> (R, Result<Settled<R>, AssemblyError>) {
        let mut factors = model.zero_dense();
        let mut pivot = partition.factor(model, time, &state.q, &mut factors);
        let bounds = Bounds { tolerance: self.tolerance, iterations: self.iterations };
        let before = state.q.clone();
        let outcome = onto_constraints(model, time, &mut state.q, &bounds, |ask, q, phi| {
            let mut delta = model.zero_v();
            match ask {
                Ask::Factor => pivot = partition.factor(model, time, q, &mut factors).min(pivot),
                Ask::Step => partition.dependent(model, &factors, &phi.scaled(-R::ONE), &mut delta),
            }
            delta
        });
        if state.q != before {
            pivot = partition.factor(model, time, &state.q, &mut factors).min(pivot);
        }
        let mut nu = model.zero_lambda();
        model.nu(time, &state.q, &mut nu);
        partition.dependent(model, &factors, &nu, &mut state.v);
        (pivot, outcome)
    }
}

impl<R: Real, M: Assemble<R>> Formulation<R, M> for Partitioned<R> {
    /// The independent set.
    type Memory = PartitionOf<R, M>;

    fn memory(&self, model: &M) -> Self::Memory {
        Partition::new(model)
    }

    #[inline]
    fn acceleration(
        &self,
        partition: &mut Self::Memory,
        model: &M,
        time: R,
        state: &mut StateOf<M, R>,
        u: &M::Inputs,
        a: &mut M::V,
        lambda: &mut M::Lambda,
    ) -> Evaluation<R> {
        // A stage that was not brought to the constraints entirely still has accelerations; the end of the step tells.
        let (_, outcome) = self.bring(partition, model, time, state);
        let iterations = outcome.map_or(self.iterations, |settled| settled.iterations);
        let pivot = model.acceleration(time, state, u, a, lambda);
        Evaluation { pivot, iterations, residual: R::ZERO }
    }

    fn settle(
        &self,
        partition: &mut Self::Memory,
        model: &M,
        time: R,
        state: &mut StateOf<M, R>,
    ) -> Result<Settled<R>, AssemblyError> {
        self.bring(partition, model, time, state).1
    }

    fn check(&self) -> Result<(), SettingError> {
        positive("the partitioning's tolerance", self.tolerance, "positive and finite (m), such as 1e-14")?;
        if self.iterations == 0 {
            let must_be = "at least 1";
            return Err(SettingError { what: "the partitioning's iterations", value: 0.0, must_be });
        }
        Ok(())
    }
}
