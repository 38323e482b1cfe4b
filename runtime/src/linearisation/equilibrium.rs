//! Static positions under loads: Newton's iteration on the exact tangent, on the group, damped; from afar behind a motion
//! without inertia.

use super::lu::{Lu, NoPivot};
use super::{ColumnsOf, check_finite, check_given};
use crate::assembly::held;
use crate::error::{AssemblyError, LinearisationError};
use crate::integrator::relative;
use crate::layout::{normalised, retract};
use crate::mechanism::Row;
use crate::real::Real;
use crate::state::{State, StateOf, Variables};
use crate::tangent::Tangent;
use crate::vector::Vector;

/// Newton's iterations before the search is given up.
const ITERATIONS: u32 = 100;
/// Steps of the motion without inertia that may come before.
const STEPS: u32 = 300;
/// The largest turn of one orientation in one iteration, rad: Newton's linear picture of a rotation holds no further.
const LARGEST_TURN: f64 = 0.5;
/// The largest increment of the first step of the motion without inertia, m and rad.
const FIRST_STEP: f64 = 0.1;
/// The part of the forces that may be left behind it.
const SETTLED: f64 = 1e-6;
/// Halvings of a step that does not bring the next one down.
const HALVINGS: u32 = 30;

/// A static position and what holds it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Equilibrium<Q, L, Z = ()> {
    /// Positions, shape n_q.
    pub q: Q,
    /// Internal states, shape n_z.
    pub z: Z,
    /// Multipliers, shape m; the force of the constraints is −Dᵀ λ.
    pub lambda: L,
    /// Iterations made.
    pub iterations: u32,
}

/// [`Equilibrium`] of a mechanism.
pub type EquilibriumOf<R, M> =
    Equilibrium<<M as Variables<R>>::Q, <M as Variables<R>>::Lambda, <M as Variables<R>>::Z>;

/// The static position near `near`, stable or not, under the inputs `u` and the loads at `time`: r = 0, Φ = 0 and ż = 0 at v = 0
/// and a = 0, unknown q, λ and the internal states z.
///
/// ```text
/// ⎡  ∂r/∂q   Dᵀ      ∂r/∂z ⎤ ⎡ δq ⎤     ⎡  r ⎤
/// ⎢  D       0       0     ⎥ ⎢ δλ ⎥ = − ⎢  Φ ⎥ ,   q ← q ⊕ t δq, λ ← λ + t δλ, z ← z + t δz
/// ⎣ −∂ż/∂q  −∂ż/∂λ  −∂ż/∂z ⎦ ⎣ δz ⎦     ⎣ −ż ⎦
/// ```
/// with the largest t of 1, ½, ¼ … for which the step that the same matrix would make next is shorter (Deuflhard, *Newton Methods
/// for Nonlinear Problems*, 3.3, the natural monotonicity test: it does not depend on how rows are scaled), and no orientation
/// turning further than half a radian. Where that ends nowhere it begins anew behind a motion in which the mechanism is brought
/// to rest again and again, with ∂r/∂q + M/h² in place of ∂r/∂q and h growing as the forces fall (pseudo-transient continuation:
/// Kelley, Keyes, SIAM J. Numer. Anal. 35, 1998); it falls towards a stable position, which then is not the nearest.
/// There are at most 100 iterations, of 31 trials each, before that motion and behind it, and 300 steps of it.
///
/// λ begins with that of the motion from rest, z with what `state` gives as its start. Rows that depend on time are taken at `time`; in tree coordinates the inertia of
/// bodies on places that move with time is among the loads. Pairs and quaternions of `near` need not have length 1. Rows that
/// repeat others ([`idle`](crate::Assemble::idle)) are left to these. The dense matrix has (n_v + m + n_z)² entries, which lie on the
/// stack.
///
/// # Errors
/// [`Indifferent`](LinearisationError::Indifferent) where the matrix is singular: nothing decides about a coordinate, or rows
/// repeat each other; [`NoEquilibrium`](LinearisationError::NoEquilibrium),
/// [`NonFinite`](LinearisationError::NonFinite), [`Assembly`](LinearisationError::Assembly) for an orientation without
/// direction.
pub fn equilibrium<R: Real, M: Tangent<R>>(
    model: &M,
    time: R,
    near: &M::Q,
    u: &M::Inputs,
) -> Result<EquilibriumOf<R, M>, LinearisationError> {
    let z = model.start_internal();
    check_given(model, time, &at_rest(model, time, near, &z), u)?;
    let q = normalised(model.layout(), near).map_err(|(first, length)| {
        let what = model.position_names().get(first).copied().unwrap_or(model.name());
        LinearisationError::Assembly(AssemblyError::NoOrientation { what, length: length.to_f64() })
    })?;
    let mut search = Search::new(model, time, u);
    let lambda = multipliers_at_rest(model, time, &q, &z, u);
    let from = Place { q, lambda, z };
    let error = match search.newton(from.clone()) {
        Ok(found) => return finite(model, time, found),
        Err(error @ LinearisationError::NonFinite { .. }) => return Err(error),
        Err(error) => error,
    };
    let Some((place, steps)) = search.settle(from) else { return Err(error) };
    let found = search.newton(place)?;
    finite(model, time, Equilibrium { iterations: found.iterations + steps, ..found })
}

/// An equilibrium, if no step overflowed.
fn finite<R: Real, M: Tangent<R>>(
    model: &M,
    time: R,
    found: EquilibriumOf<R, M>,
) -> Result<EquilibriumOf<R, M>, LinearisationError> {
    check_finite(time, found.q.as_slice(), |index| model.position_names().get(index).copied())?;
    check_finite(time, found.lambda.as_slice(), |row| model.rows().get(row).map(|row| row.of))?;
    check_finite(time, found.z.as_slice(), |index| model.internal_names().get(index).copied())?;
    Ok(found)
}

/// q, λ and z.
#[derive(Clone)]
struct Place<Q, L, Z> {
    q: Q,
    lambda: L,
    z: Z,
}

type PlaceOf<R, M> = Place<<M as Variables<R>>::Q, <M as Variables<R>>::Lambda, <M as Variables<R>>::Z>;

/// δq, δλ and δz.
type Step<R, M> = (<M as Variables<R>>::V, <M as Variables<R>>::Lambda, <M as Variables<R>>::Z);

/// The loads, and the matrix of one iteration after the other.
struct Search<'m, R: Real, M: Tangent<R>> {
    model: &'m M,
    time: R,
    u: &'m M::Inputs,
    entries: M::Bordered,
    rows: M::Unknowns,
    columns: M::Unknowns,
    order: M::Order,
}

impl<'m, R: Real, M: Tangent<R>> Search<'m, R, M> {
    fn new(model: &'m M, time: R, u: &'m M::Inputs) -> Self {
        let (rows, columns) = (model.zero_unknowns(), model.zero_unknowns());
        Search { model, time, u, entries: model.zero_bordered(), rows, columns, order: model.order() }
    }

    fn newton(&mut self, from: PlaceOf<R, M>) -> Result<EquilibriumOf<R, M>, LinearisationError> {
        let model = self.model;
        let mut at = from;
        let mut residual = self.residual(&at);
        for iteration in 0..ITERATIONS {
            if let Some(unknown) = residual.first_not_finite() {
                let what = name(model, unknown).of;
                return Err(LinearisationError::NonFinite { time: self.time.to_f64(), what });
            }
            self.factor(&at, R::ZERO).map_err(|found| LinearisationError::Indifferent {
                time: self.time.to_f64(),
                row: name(model, found.unknown),
                pivot: found.pivot.to_f64(),
                iterations: iteration,
            })?;
            let mut step = residual.scaled(-R::ONE);
            let norm = self.lu().solve(step.as_mut_slice());
            let step = parts(model, &step);
            let internal = relative(model.internal_scales(), &step.2, &at.z);
            let moved = (step.0.max_abs() / (R::ONE + at.q.max_abs())).max(internal);
            let iterations = iteration + 1;
            if moved <= R::from_f64(64.0) * R::EPSILON {
                let Place { q, lambda, z } = further(model, &at, &step, R::ONE);
                return Ok(Equilibrium { q, lambda, z, iterations });
            }
            match self.shorten(&at, &step, norm) {
                Some(next) => (at, residual) = next,
                // The rest is rounding.
                None if moved <= R::from_f64(0.01) * R::EPSILON.sqrt() => {
                    return Ok(Equilibrium { q: at.q, lambda: at.lambda, z: at.z, iterations });
                }
                None => return Err(no_equilibrium(model, self.time, &residual, iterations)),
            }
        }
        Err(no_equilibrium(model, self.time, &residual, ITERATIONS))
    }

    /// The first of the steps t, t/2, t/4 … that makes the next one shorter; t turns nothing further than [`LARGEST_TURN`].
    fn shorten(
        &mut self,
        from: &PlaceOf<R, M>,
        step: &Step<R, M>,
        norm: R,
    ) -> Option<(PlaceOf<R, M>, M::Unknowns)> {
        let model = self.model;
        let (largest, limit) = (largest_turn(model, &step.0), R::from_f64(LARGEST_TURN));
        let mut t = if largest > limit { limit / largest } else { R::ONE };
        for _ in 0..=HALVINGS {
            let at = further(model, from, step, t);
            let residual = self.residual(&at);
            let mut next = residual.clone();
            // Written so that a NaN fails.
            if self.lu().solve(next.as_mut_slice()) <= (R::ONE - R::from_f64(0.25) * t) * norm {
                return Some((at, residual));
            }
            t = t * R::from_f64(0.5);
        }
        None
    }

    /// Moves with forces but without momentum until they are almost gone; `None` where nothing moves.
    fn settle(&mut self, from: PlaceOf<R, M>) -> Option<(PlaceOf<R, M>, u32)> {
        let model = self.model;
        let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
        let rest = at_rest(self.model, self.time, &from.q, &from.z);
        self.model.acceleration(self.time, &rest, self.u, &mut a, &mut lambda);
        // M/h², the first h such that the step h² a is small.
        let first = a.max_abs() / R::from_f64(FIRST_STEP);
        if !(first > R::ZERO && first.is_finite()) || self.factor(&from, first).is_err() {
            return None;
        }
        let scale = self.rows.clone();
        let mut residual = self.residual(&from);
        let (mut at, mut caution) = (from, R::ONE);
        let start = weighed(&residual, &scale);
        for step in 1..=STEPS {
            let left = weighed(&residual, &scale) / start;
            // Written so that a NaN fails.
            if !R::any(left.greater_equal(R::from_f64(SETTLED))) {
                return Some((at, step));
            }
            let mut next = residual.scaled(-R::ONE);
            let regular = self.factor(&at, first * left * caution).is_ok();
            if regular {
                self.lu().solve(next.as_mut_slice());
            }
            let parts = parts(model, &next);
            // Written so that a NaN fails.
            let little = R::any(largest_turn(model, &parts.0).less_equal(R::from_f64(LARGEST_TURN)));
            if regular && little {
                at = further(model, &at, &parts, R::ONE);
                residual = self.residual(&at);
                caution = (R::from_f64(0.5) * caution).max(R::ONE);
            } else {
                caution = R::from_f64(4.0) * caution;
            }
        }
        Some((at, STEPS))
    }

    fn lu(&mut self) -> Lu<'_, R> {
        Lu {
            entries: self.entries.as_mut_slice(),
            rows: self.rows.as_mut_slice(),
            columns: self.columns.as_mut_slice(),
            order: self.order.as_mut(),
        }
    }

    /// Factors \[∂r/∂q + w M, Dᵀ, ∂r/∂z; D, 0, 0; −∂ż/∂q, −∂ż/∂λ, √w − ∂ż/∂z\].
    fn factor(&mut self, at: &PlaceOf<R, M>, weight: R) -> Result<(), NoPivot<R>> {
        let model = self.model;
        let (model, time, still) = (self.model, self.time, model.zero_v());
        let rest = at_rest(model, self.time, &at.q, &at.z);
        let (mut stiffness, mut damping) = (model.zero_stiffness(), model.zero_damping());
        let (mut jacobian, mut mass) = (model.zero_jacobian(), model.zero_mass());
        model.tangent(time, &rest, self.u, &still, &at.lambda, &mut stiffness, &mut damping);
        model.constraint_jacobian(time, &at.q, &mut jacobian);
        let (n, size, entries) = (model.velocity_count(), model.unknown_count(), self.entries.as_mut_slice());
        entries.fill(R::ZERO);
        for (&entry, &(row, column)) in stiffness.as_slice().iter().zip(model.stiffness_pattern()) {
            entries[row as usize * size + column as usize] = entry;
        }
        if weight > R::ZERO {
            model.mass_matrix(time, &at.q, &mut mass);
            for (&entry, &(row, column)) in mass.as_slice().iter().zip(model.mass_pattern()) {
                let (row, column) = (row as usize, column as usize);
                entries[row * size + column] = entries[row * size + column] + weight * entry;
                if row != column {
                    entries[column * size + row] = entries[column * size + row] + weight * entry;
                }
            }
        }
        for (&entry, &(row, column)) in jacobian.as_slice().iter().zip(model.jacobian_pattern()) {
            let (unknown, column, idle) = (n + row as usize, column as usize, model.idle().contains(&row));
            entries[column * size + unknown] = entry;
            entries[unknown * size + column] = if idle { R::ZERO } else { entry };
        }
        for &row in model.idle() {
            let unknown = n + row as usize;
            entries[unknown * size + unknown] = R::ONE;
        }
        self.add_internal(at, &rest, weight);
        self.lu().factor()
    }

    /// The rows and columns of internal states.
    fn add_internal(&mut self, at: &PlaceOf<R, M>, rest: &StateOf<M, R>, weight: R) {
        let (model, time, still) = (self.model, self.time, self.model.zero_v());
        let size = model.unknown_count();
        let first = model.velocity_count() + model.row_count();
        let (mut forces, mut rates) = (model.zero_internal_tangent(), model.zero_internal_rate_tangent());
        model.internal_tangent(time, rest, self.u, &mut forces);
        model.internal_rate_tangent(time, rest, self.u, &still, &at.lambda, &mut rates);
        let mut friction = model.zero_friction_tangent();
        model.friction_tangent(time, rest, self.u, &still, &at.lambda, &mut friction);
        let columns = ColumnsOf::of(model);
        let entries = self.entries.as_mut_slice();
        for state in 0..model.internal_count() {
            entries[(first + state) * size + first + state] = weight.sqrt();
        }
        for (&entry, &(row, column)) in forces.as_slice().iter().zip(model.internal_pattern()) {
            entries[usize::from(row) * size + first + usize::from(column)] = entry;
        }
        // Columns of u, λ, z, a, of which λ and z are unknowns.
        let inputs = model.input_names().len();
        for (&entry, &(row, column)) in friction.as_slice().iter().zip(model.friction_pattern()) {
            let Some(unknown) = usize::from(column).checked_sub(inputs) else { continue };
            if unknown < model.row_count() + model.internal_count() {
                let place = usize::from(row) * size + model.velocity_count() + unknown;
                entries[place] = entries[place] + entry;
            }
        }
        for (&entry, &(row, column)) in rates.as_slice().iter().zip(model.internal_rate_pattern()) {
            let (row, column) = ((first + usize::from(row)) * size, usize::from(column));
            let to = if column < columns.velocities {
                column
            } else if (columns.multipliers..columns.accelerations).contains(&column) {
                columns.velocities + column - columns.multipliers
            } else {
                // Nothing moves, and inputs are given.
                continue;
            };
            entries[row + to] = entries[row + to] - entry;
        }
    }

    /// (r, Φ, −ż) at rest; of a row that repeats others its multiplier, which is to be zero.
    fn residual(&self, at: &PlaceOf<R, M>) -> M::Unknowns {
        let model = self.model;
        let (rest, still) = (at_rest(self.model, self.time, &at.q, &at.z), model.zero_v());
        let (mut forces, mut phi) = (model.zero_v(), model.zero_lambda());
        self.model.residual(self.time, &rest, self.u, &still, &at.lambda, &mut forces);
        self.model.constraints(self.time, &at.q, &mut phi);
        for &row in model.idle() {
            phi.as_mut_slice()[row as usize] = at.lambda.as_slice()[row as usize];
        }
        let mut rates = model.zero_z();
        model.internal_rates(self.time, &rest, self.u, &still, &at.lambda, &mut rates);
        let rates = rates.scaled(-R::ONE);
        let mut residual = model.zero_unknowns();
        let parts = forces.as_slice().iter().chain(phi.as_slice()).chain(rates.as_slice());
        residual.as_mut_slice().iter_mut().zip(parts).for_each(|(entry, &value)| *entry = value);
        residual
    }
}

/// The state at rest at a position.
fn at_rest<R: Real, M: Tangent<R>>(model: &M, time: R, q: &M::Q, z: &M::Z) -> StateOf<M, R> {
    held(model, time, State { q: q.clone(), v: model.zero_v(), z: z.clone(), gates: model.start_gates() })
}

/// λ of the motion from rest, zero where there is none.
fn multipliers_at_rest<R: Real, M: Tangent<R>>(
    model: &M,
    time: R,
    q: &M::Q,
    z: &M::Z,
    u: &M::Inputs,
) -> M::Lambda {
    let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
    let pivot = model.acceleration(time, &at_rest(model, time, q, z), u, &mut a, &mut lambda);
    let sound = R::any(pivot.greater_equal(R::BREAKDOWN)) && lambda.first_not_finite().is_none();
    if sound { lambda } else { model.zero_lambda() }
}

/// The parts of a step.
fn parts<R: Real, M: Tangent<R>>(model: &M, step: &M::Unknowns) -> Step<R, M> {
    let (mut dq, mut dl, mut dz) = (model.zero_v(), model.zero_lambda(), model.zero_z());
    let (positions, rest) = step.as_slice().split_at(model.velocity_count());
    let (multipliers, internal) = rest.split_at(model.row_count());
    dq.as_mut_slice().copy_from_slice(positions);
    dl.as_mut_slice().copy_from_slice(multipliers);
    dz.as_mut_slice().copy_from_slice(internal);
    (dq, dl, dz)
}

/// (q ⊕ t δq, λ + t δλ, z + t δz).
fn further<R: Real, M: Tangent<R>>(
    model: &M,
    from: &PlaceOf<R, M>,
    (dq, dl, dz): &Step<R, M>,
    t: R,
) -> PlaceOf<R, M> {
    let mut q = from.q.clone();
    retract(model.layout(), &from.q, &dq.scaled(t), &mut q);
    Place { q, lambda: from.lambda.plus(t, dl), z: from.z.plus(t, dz) }
}

/// The norm of a residual with its rows scaled.
fn weighed<R: Real, V: Vector<R>>(residual: &V, scale: &V) -> R {
    let scaled = residual.as_slice().iter().zip(scale.as_slice());
    scaled.fold(R::ZERO, |sum, (&entry, &scale)| sum + entry * scale * (entry * scale)).sqrt()
}

fn largest_turn<R: Real, M: Tangent<R>>(model: &M, dq: &M::V) -> R {
    let turns = &dq.as_slice()[model.layout().linear..];
    turns.iter().fold(R::ZERO, |largest, turn| largest.max(turn.abs()))
}

/// The name of an unknown, or of the equation of the same number.
fn name<R: Real, M: Tangent<R>>(model: &M, unknown: usize) -> Row {
    match model.velocity_names().get(unknown) {
        Some(&of) => Row { of, what: "coordinate" },
        None => {
            let row = unknown - model.velocity_count();
            let internal = row.checked_sub(model.row_count()).and_then(|at| model.internal_names().get(at));
            let state = internal.map(|of| Row { of, what: "state" });
            model.rows().get(row).copied().or(state).unwrap_or(Row { of: model.name(), what: "unknown" })
        }
    }
}

/// The largest force, or where forces balance the largest residual of a row or the largest rate.
#[cold]
fn no_equilibrium<R: Real, M: Tangent<R>>(
    model: &M,
    time: R,
    residual: &M::Unknowns,
    iterations: u32,
) -> LinearisationError {
    let (forces, rows) = residual.as_slice().split_at(model.velocity_count());
    let largest = |values: &[R]| {
        let entries = values.iter().enumerate();
        entries.fold(
            (0, R::ZERO),
            |best, (at, entry)| if entry.abs() > best.1 { (at, entry.abs()) } else { best },
        )
    };
    let (force, row) = (largest(forces), largest(rows));
    let (unknown, residual) = if force.1 >= row.1 { force } else { (model.velocity_count() + row.0, row.1) };
    LinearisationError::NoEquilibrium {
        time: time.to_f64(),
        row: name(model, unknown),
        residual: residual.to_f64(),
        iterations,
    }
}
