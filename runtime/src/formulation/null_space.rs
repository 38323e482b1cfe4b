//! The equations of motion in independent velocities: the null space of D, or matrix R.

use super::friction::with_friction;
use super::{Evaluation, Formulation, PivotOf, Settled};
use crate::assembly::system::mass_times;
use crate::error::{AssemblyError, SettingError};
use crate::layout::retract;
use crate::mechanism::Assemble;
use crate::partition::{Partition, PartitionOf, is_good, serves, written_out};
use crate::real::Real;
use crate::state::StateOf;
use crate::vector::{Vector, at, dot, put};

/// The null-space formulation (matrix R): v = R ż + S ν, with ż the independent velocities and D R = 0, so that
///
/// ```text
/// (Rᵀ M R) z̈ = Rᵀ (Q − M S γ),    v̇ = R z̈ + S γ,    D_dᵀ λ = (Q − M v̇)_d
/// ```
/// without multipliers in what is solved. At the end of a step dependent positions and velocities go a tenth of the way back to the
/// constraints, by the factors of D: these then hold to some ten times the error of one step, without drift and without a
/// coefficient that must suit the machine. They hold to rounding if it is [`Projected`](super::Projected). The independent set is kept
/// while its pivots are good, and chosen anew by pivoting where they degrade (a dead centre of the coordinate taken as
/// independent); M may be singular where the constraints make up for it.
///
/// All velocities are integrated, not the independent ones alone: near a dead centre R is large, z̈ steep, and a method that sees z
/// only loses its order there (a slider-crank led by its slider at 0.1 ms: an energy error of 5·10⁻⁶ against 10⁻⁹).
///
/// Source: García de Jalón, Bayo, *Kinematic and Dynamic Simulation of Multibody Systems*, 5.2.3 (matrix R) and 3.5 (choice by
/// pivoting); Liang, Lance, Journal of Mechanisms, Transmissions and Automation in Design 109 (1987) 398–405.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NullSpace;

impl<R: Real, M: Assemble<R>> Formulation<R, M> for NullSpace {
    /// The independent set.
    type Memory = PartitionOf<R, M>;

    #[inline(always)]
    fn pivot_of(_model: &M) -> PivotOf {
        PivotOf::Jacobian
    }

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
        let pivot = model.null_space(time, state, u, a, lambda);
        if serves(pivot) {
            return Evaluation::direct(pivot);
        }
        by_tables(partition, model, time, state, u, a, lambda)
    }

    fn settle(
        &self,
        partition: &mut Self::Memory,
        model: &M,
        time: R,
        state: &mut StateOf<M, R>,
    ) -> Result<Settled<R>, AssemblyError> {
        let moved = match written_out(model, time, &state.q) {
            Some(lu) => {
                partition.reset(model);
                let dependent = |right: &M::Lambda, v: &mut M::V| {
                    let given = v.clone();
                    model.dependent_velocities(&lu, right, &given, v);
                };
                approach(model, time, state, dependent)
            }
            None => approach_by_tables(partition, model, time, state),
        };
        Ok(Settled { iterations: 0, moved })
    }

    fn check(&self) -> Result<(), SettingError> {
        Ok(())
    }
}

/// Where the solution is not written out, or one of its pivots is too small.
#[inline(never)]
pub(super) fn by_tables<R: Real, M: Assemble<R>>(
    partition: &mut PartitionOf<R, M>,
    model: &M,
    time: R,
    state: &StateOf<M, R>,
    u: &M::Inputs,
    a: &mut M::V,
    lambda: &mut M::Lambda,
) -> Evaluation<R> {
    let mut factors = model.zero_dense();
    let pivot = partition.factor(model, time, &state.q, &mut factors);
    let mut gamma = model.zero_lambda();
    model.gamma(time, &state.q, &state.v, &mut gamma);
    let mut forces = model.zero_v();
    model.forces(time, state, u, &mut forces);
    let mut mass = model.zero_mass();
    model.mass_matrix(time, &state.q, &mut mass);

    with_friction(model, time, state, u, &forces, a, lambda, |forces, a, lambda| {
        // Sγ: accelerations that satisfy the rows with z̈ = 0.
        a.as_mut_slice().fill(R::ZERO);
        partition.dependent(model, &factors, &gamma, a);
        let rest = forces.plus(-R::ONE, &mass_times(model, &mass, a));

        // R, column by column, and Rᵀ M R, Rᵀ (Q − M S γ).
        let (n, freedoms) = (model.velocity_count(), model.freedoms());
        let mut basis = model.zero_basis();
        partition.basis(model, &factors, &mut basis);
        let columns = || basis.as_slice().chunks_exact(n.max(1)).take(freedoms);
        let mut reduced = model.zero_reduced();
        let mut right = model.zero_v();
        for (place, own) in columns().enumerate() {
            let mut column = model.zero_v();
            column.as_mut_slice().iter_mut().zip(own).for_each(|(entry, &value)| *entry = value);
            let product = mass_times(model, &mass, &column);
            for (other, known) in columns().enumerate().take(place + 1) {
                put(reduced.as_mut_slice(), place * freedoms + other, dot(known, product.as_slice()));
            }
            put(right.as_mut_slice(), place, dot(own, rest.as_slice()));
        }
        let regular = cholesky(reduced.as_mut_slice(), freedoms, right.as_mut_slice());
        for (column, &rate) in columns().zip(right.as_slice()) {
            for (entry, &r) in a.as_mut_slice().iter_mut().zip(column) {
                *entry = r.mul_add(rate, *entry);
            }
        }
        let rest = forces.plus(-R::ONE, &mass_times(model, &mass, a));
        partition.multipliers(model, &factors, &rest, lambda);
        Evaluation::direct(regular.min(pivot))
    })
}

/// The part of the way to the constraints that is taken at the end of each step. With the whole of it what the passage of a
/// singular position is off goes into the motion at once, and so do errors of the independent velocities, enlarged by R (A02 with
/// forty windows at 1 ms: 10⁻⁵ m in place of 2·10⁻⁸); with a fiftieth drift grows faster than it is taken back where steps are
/// coarse (two windows leave their branch at 10 ms).
const PART: f64 = 0.1;

/// q ← q ⊕ δ/10 with D_d δ_d = −Φ, δ_i = 0, and v ← v + (v′ − v)/10 with D v′ = ν, v′_i = v_i. `dependent` solves D x = right for
/// the dependent entries of x, given the others. Returns how far a coordinate moved.
#[inline]
fn approach<R: Real, M: Assemble<R>>(
    model: &M,
    time: R,
    state: &mut StateOf<M, R>,
    dependent: impl Fn(&M::Lambda, &mut M::V),
) -> R {
    let part = R::from_f64(PART);
    let (mut phi, mut nu) = (model.zero_lambda(), model.zero_lambda());
    model.constraints(time, &state.q, &mut phi);
    model.nu(time, &state.q, &mut nu);

    let mut delta = model.zero_v();
    dependent(&phi.scaled(-part), &mut delta);
    let from = state.q.clone();
    retract(model.layout(), &from, &delta, &mut state.q);

    let mut v = state.v.clone();
    dependent(&nu, &mut v);
    let to = v.plus(-R::ONE, &state.v);
    state.v.axpy(part, &to);
    delta.max_abs()
}

/// The same where nothing is written out or its pivots are bad. Where no choice has good ones, near singular positions, errors would
/// be divided by them: nothing moves.
#[inline(never)]
fn approach_by_tables<R: Real, M: Assemble<R>>(
    partition: &mut PartitionOf<R, M>,
    model: &M,
    time: R,
    state: &mut StateOf<M, R>,
) -> R {
    let mut factors = model.zero_dense();
    let pivot = partition.factor(model, time, &state.q, &mut factors);
    if !is_good(pivot) {
        return R::ZERO;
    }
    approach(model, time, state, |right, v| partition.dependent(model, &factors, right, v))
}

/// Solves A x = b in place, A symmetric and positive definite by its lower triangle, row by row (Golub, Van Loan, *Matrix
/// Computations*, 4.2); returns the smallest pivot relative to its diagonal entry.
fn cholesky<R: Real>(matrix: &mut [R], size: usize, b: &mut [R]) -> R {
    let mut smallest = R::ONE;
    for i in 0..size {
        let own = at(matrix, i * size + i);
        for j in 0..=i {
            let mut entry = at(matrix, i * size + j);
            for k in 0..j {
                entry = entry - at(matrix, i * size + k) * at(matrix, j * size + k);
            }
            let factor = if i == j {
                let relative = if own > R::ZERO { entry / own } else { R::ZERO };
                smallest = relative.min(smallest);
                entry.max(R::ZERO).sqrt()
            } else {
                entry / at(matrix, j * size + j)
            };
            put(matrix, i * size + j, factor);
        }
        let mut rest = at(b, i);
        for k in 0..i {
            rest = rest - at(matrix, i * size + k) * at(b, k);
        }
        put(b, i, rest / at(matrix, i * size + i));
    }
    for i in (0..size).rev() {
        let mut rest = at(b, i);
        for k in i + 1..size {
            rest = rest - at(matrix, k * size + i) * at(b, k);
        }
        put(b, i, rest / at(matrix, i * size + i));
    }
    smallest
}
