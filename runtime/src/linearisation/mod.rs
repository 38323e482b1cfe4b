//! Results that follow from the derivatives of the equations: derivatives of the motion, state matrices, equilibria, actuation.
//!
//! The derivatives themselves are emitted ([`Tangent`]); here they are solved with, without allocation. The solution of the
//! equations of motion is differentiated implicitly, not through its elimination: one factor, then one solve for each column.
//!
//! | | file |
//! |---|---|
//! | ∂v̇ and ∂λ by anything; with Baumgarte's terms | this one; `stabilised.rs` |
//! | motions that the constraints admit; those of coordinates | `admissible.rs`; `coordinates.rs` |
//! | what parameters change in a mechanism that stays assembled | `assembled.rs` |
//! | ẋ = A x + B u, y = C x + D u | `state_space.rs` |
//! | static positions | `equilibrium.rs`, over the dense factorisation `lu.rs` |
//! | inputs for given accelerations | `actuation.rs` |

mod actuation;
mod admissible;
mod assembled;
mod coordinates;
mod equilibrium;
pub(crate) mod lu;
mod stabilised;
mod state_space;

pub(crate) use actuation::check_accelerations;
pub use actuation::{Actuation, actuation};
pub use assembled::{Assembled, Moved, MovedOf};
pub(crate) use coordinates::Coordinates;
pub use equilibrium::{Equilibrium, EquilibriumOf, equilibrium};
pub use state_space::{StateSpace, StateSpaceOf};

use crate::assembly::{singular_velocity, smallest_pivot};
use crate::error::LinearisationError;
use crate::fields::Fields;
use crate::formulation::leading;
use crate::mechanism::{Assemble, name_row};
use crate::real::Real;
use crate::state::{State, StateOf};
use crate::tangent::Tangent;
use crate::vector::Vector;
use stabilised::Stabilised;

/// A relative pivot of D Dᵀ above which the constraints are not to blame for a breakdown.
const WELL_POSED: f64 = 1e-8;

/// The derivative of the motion in one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Response<V, L> {
    /// ∂v̇, shape n_v.
    pub acceleration: V,
    /// ∂λ, shape m.
    pub multipliers: L,
}

/// [`Response`] of a mechanism.
pub type ResponseOf<R, M> = Response<<M as crate::Variables<R>>::V, <M as crate::Variables<R>>::Lambda>;

/// The equations of motion at one state with all that is needed to differentiate their solution:
///
/// ```text
/// ⎡ M  Dᵀ ⎤ ⎡ ∂v̇ ⎤     ⎡ ∂r         ⎤
/// ⎣ D  0  ⎦ ⎣ ∂λ ⎦ = − ⎣ ∂(D a − γ) ⎦    at a = v̇, r = M a + Dᵀ λ − Q
/// ```
/// v̇ and λ are those of index 1, without stabilisation; at consistent states Baumgarte's are the same, their derivatives are
/// not. Source: Brüls, Eberhard, *Sensitivity analysis for dynamic mechanical systems with finite rotations*, Int. J. Numer.
/// Meth. Engng 74 (2008), for the derivatives along increments; the rest is the implicit function theorem.
pub struct Linearisation<'m, R: Real, M: Tangent<R>> {
    model: &'m M,
    time: R,
    state: StateOf<M, R>,
    u: M::Inputs,
    a: M::V,
    lambda: M::Lambda,
    store: M::Store,
    stiffness: M::Stiffness,
    damping: M::Damping,
    row_stiffness: M::RowStiffness,
    row_damping: M::RowDamping,
    input: M::InputTangent,
    internal: M::InternalTangent,
    friction: M::FrictionTangent,
    internal_rates: M::InternalRateTangent,
    /// Where rows are brought back to the constraints.
    stabilised: Option<Stabilised<R, M>>,
}

impl<'m, R: Real, M: Tangent<R>> Linearisation<'m, R, M> {
    /// Solves the equations of motion at a state, evaluates their derivatives and factors K(0). All arguments must be finite, and so
    /// must v̇, λ and all derivatives of the equations; a solution with K(0) may still overflow.
    ///
    /// # Errors
    /// [`Breakdown`](LinearisationError::Breakdown), [`SingularMass`](LinearisationError::SingularMass),
    /// [`NonFinite`](LinearisationError::NonFinite).
    pub fn at(
        model: &'m M,
        time: R,
        state: &StateOf<M, R>,
        u: &M::Inputs,
    ) -> Result<Self, LinearisationError> {
        Self::solved(model, time, state, u, |a, lambda| {
            leading::acceleration(model, time, state, u, a, lambda)
        })
    }

    fn solved(
        model: &'m M,
        time: R,
        state: &StateOf<M, R>,
        u: &M::Inputs,
        solve: impl FnOnce(&mut M::V, &mut M::Lambda) -> R,
    ) -> Result<Self, LinearisationError> {
        let State { q, v, .. } = state;
        check_given(model, time, state, u)?;
        let (mut a, mut lambda, mut store) = (model.zero_v(), model.zero_lambda(), model.store());
        let pivot = solve(&mut a, &mut lambda);
        let pivot = pivot.min(model.factor(time, q, R::ZERO, &mut store));
        // Written so that a NaN fails.
        if !R::any(pivot.greater_equal(R::BREAKDOWN)) {
            return Err(broken_down(model, time, q, pivot));
        }
        check_finite(time, a.as_slice(), |velocity| model.velocity_names().get(velocity).copied())?;
        check_finite(time, lambda.as_slice(), |row| model.rows().get(row).map(|row| row.of))?;
        let (mut stiffness, mut damping) = (model.zero_stiffness(), model.zero_damping());
        let (mut row_stiffness, mut row_damping) = (model.zero_row_stiffness(), model.zero_row_damping());
        let mut input = model.zero_input_tangent();
        model.tangent(time, state, u, &a, &lambda, &mut stiffness, &mut damping);
        model.row_tangent(time, q, v, &a, &mut row_stiffness, &mut row_damping);
        model.input_tangent(time, state, u, &mut input);
        let (mut internal, mut internal_rates) =
            (model.zero_internal_tangent(), model.zero_internal_rate_tangent());
        model.internal_tangent(time, state, u, &mut internal);
        model.internal_rate_tangent(time, state, u, &a, &lambda, &mut internal_rates);
        let mut friction = model.zero_friction_tangent();
        model.friction_tangent(time, state, u, &a, &lambda, &mut friction);
        let forces = |row: u16| model.velocity_names().get(usize::from(row)).copied();
        let rows = |row: u16| model.rows().get(usize::from(row)).map(|row| row.of);
        check_entries(time, stiffness.as_slice(), model.stiffness_pattern(), forces)?;
        check_entries(time, damping.as_slice(), model.damping_pattern(), forces)?;
        check_entries(time, input.as_slice(), model.input_pattern(), forces)?;
        let states = |row: u16| model.internal_names().get(usize::from(row)).copied();
        check_entries(time, internal.as_slice(), model.internal_pattern(), forces)?;
        check_entries(time, friction.as_slice(), model.friction_pattern(), forces)?;
        check_entries(time, internal_rates.as_slice(), model.internal_rate_pattern(), states)?;
        check_entries(time, row_stiffness.as_slice(), model.row_stiffness_pattern(), rows)?;
        check_entries(time, row_damping.as_slice(), model.row_damping_pattern(), rows)?;
        Ok(Linearisation {
            model,
            time,
            state: state.clone(),
            u: u.clone(),
            a,
            lambda,
            store,
            stiffness,
            damping,
            row_stiffness,
            row_damping,
            input,
            internal,
            friction,
            internal_rates,
            stabilised: None,
        })
    }

    /// The mechanism.
    pub fn model(&self) -> &'m M {
        self.model
    }

    /// The state.
    pub fn state(&self) -> &StateOf<M, R> {
        &self.state
    }

    /// v̇ at the state, shape n_v.
    pub fn acceleration(&self) -> &M::V {
        &self.a
    }

    /// λ at the state, shape m.
    pub fn multipliers(&self) -> &M::Lambda {
        &self.lambda
    }

    /// ∂v̇ and ∂λ along an increment δq of the positions (shape n_v, q ⊕ δq) and δv of the velocities:
    /// (∂v̇/∂q) δq + (∂v̇/∂v) δv.
    pub fn along(&self, dq: &M::V, dv: &M::V) -> ResponseOf<R, M> {
        self.along_state(dq, dv, &self.model.zero_z())
    }

    /// The same along an increment δz of the internal states as well.
    pub fn along_state(&self, dq: &M::V, dv: &M::V, dz: &M::Z) -> ResponseOf<R, M> {
        let model = self.model;
        let (mut forces, mut rows) = (model.zero_v(), model.zero_lambda());
        let (to_forces, to_rows) = (forces.as_mut_slice(), rows.as_mut_slice());
        let (dq, dv) = (dq.as_slice(), dv.as_slice());
        add_block(model.stiffness_pattern(), self.stiffness.as_slice(), (0, 0), dq, to_forces);
        add_block(model.damping_pattern(), self.damping.as_slice(), (0, 0), dv, to_forces);
        add_block(model.internal_pattern(), self.internal.as_slice(), (0, 0), dz.as_slice(), to_forces);
        let internal = model.input_names().len() + model.row_count();
        add_block(
            model.friction_pattern(),
            self.friction.as_slice(),
            (0, internal),
            dz.as_slice(),
            to_forces,
        );
        add_block(model.row_stiffness_pattern(), self.row_stiffness.as_slice(), (0, 0), dq, to_rows);
        add_block(model.row_damping_pattern(), self.row_damping.as_slice(), (0, 0), dv, to_rows);
        if let Some(stabilised) = &self.stabilised {
            stabilised.add(model, dq, dv, &mut rows);
        }
        self.response(&forces, &rows)
    }

    /// Column `index` of ∂v̇/∂q and ∂λ/∂q: by the increment of the coordinate with that velocity. Zero beyond n_v.
    pub fn by_position(&self, index: usize) -> ResponseOf<R, M> {
        let model = self.model;
        self.along(&unit(model.zero_v(), index), &model.zero_v())
    }

    /// Column `index` of ∂v̇/∂v and ∂λ/∂v. Zero beyond n_v.
    pub fn by_velocity(&self, index: usize) -> ResponseOf<R, M> {
        let model = self.model;
        self.along(&model.zero_v(), &unit(model.zero_v(), index))
    }

    /// Column `index` of ∂v̇/∂z and ∂λ/∂z, in the order of the internal states. Zero beyond n_z.
    pub fn by_internal(&self, index: usize) -> ResponseOf<R, M> {
        let model = self.model;
        self.along_state(&model.zero_v(), &model.zero_v(), &unit(model.zero_z(), index))
    }

    /// δż of the internal states along δq, δv, δz and the δv̇ and δλ that go with them:
    /// (∂ż/∂q) δq + (∂ż/∂v) δv + (∂ż/∂z) δz + (∂ż/∂v̇) δv̇ + (∂ż/∂λ) δλ.
    pub fn internal_rates(&self, dq: &M::V, dv: &M::V, dz: &M::Z, response: &ResponseOf<R, M>) -> M::Z {
        let model = self.model;
        let mut rates = model.zero_z();
        let columns = ColumnsOf::of(model);
        let parts = [
            (0, dq.as_slice()),
            (columns.velocities, dv.as_slice()),
            (columns.multipliers, response.multipliers.as_slice()),
            (columns.internal, dz.as_slice()),
            (columns.accelerations, response.acceleration.as_slice()),
        ];
        for (column, x) in parts {
            let (pattern, entries) = (model.internal_rate_pattern(), self.internal_rates.as_slice());
            add_block(pattern, entries, (0, column), x, rates.as_mut_slice());
        }
        rates
    }

    /// The same by an input alone.
    pub(crate) fn internal_rates_by_input(&self, input: usize, response: &ResponseOf<R, M>) -> M::Z {
        let model = self.model;
        let (none, still) = (model.zero_v(), model.zero_z());
        let mut rates = self.internal_rates(&none, &none, &still, response);
        let column = ColumnsOf::of(model).inputs + input;
        let (pattern, entries) = (model.internal_rate_pattern(), self.internal_rates.as_slice());
        add_column(pattern, entries, (0, column), rates.as_mut_slice());
        rates
    }

    /// Column `index` of ∂v̇/∂u and ∂λ/∂u, in the order of the inputs. Zero beyond n_u.
    pub fn by_input(&self, index: usize) -> ResponseOf<R, M> {
        let model = self.model;
        let mut forces = model.zero_v();
        add_column(model.input_pattern(), self.input.as_slice(), (0, index), forces.as_mut_slice());
        if index < model.input_names().len() {
            add_column(model.friction_pattern(), self.friction.as_slice(), (0, index), forces.as_mut_slice());
        }
        self.response(&forces, &model.zero_lambda())
    }

    /// ∂v̇/∂p and ∂λ/∂p, column by column; the derivatives by parameters are evaluated here.
    pub fn by_parameters(&self) -> ByParameters<'_, 'm, R, M> {
        let model = self.model;
        let mut entries = model.zero_parameter_tangent();
        let Linearisation { model, time, state, u, a, lambda, .. } = self;
        model.parameter_tangent(*time, state, u, a, lambda, &mut entries);
        ByParameters { at: self, entries }
    }

    /// −K(0)⁻¹ (∂r, ∂(D a − γ)).
    fn response(&self, forces: &M::V, rows: &M::Lambda) -> ResponseOf<R, M> {
        let model = self.model;
        let (mut acceleration, mut multipliers) = (model.zero_v(), model.zero_lambda());
        let (forces, rows) = (forces.scaled(-R::ONE), rows.scaled(-R::ONE));
        model.solve_rubbing(&self.store, &self.friction, &forces, &rows, &mut acceleration, &mut multipliers);
        Response { acceleration, multipliers }
    }
}

/// Derivatives by the parameters at one state, in the order of [`Tangent::Parameters`]. Positions and the phases of couplings
/// are held.
pub struct ByParameters<'l, 'm, R: Real, M: Tangent<R>> {
    at: &'l Linearisation<'m, R, M>,
    entries: M::ParameterTangent,
}

impl<R: Real, M: Tangent<R>> ByParameters<'_, '_, R, M> {
    /// Column `index` of ∂v̇/∂p and ∂λ/∂p. Zero beyond n_p.
    pub fn column(&self, index: usize) -> ResponseOf<R, M> {
        let model = self.at.model;
        let (mut forces, mut rows) = (model.zero_v(), model.zero_lambda());
        self.add(index, 0, forces.as_mut_slice());
        self.add(index, model.velocity_count(), rows.as_mut_slice());
        self.at.response(&forces, &rows)
    }

    /// Column `index` of ∂(D v − ν)/∂p.
    pub fn rates(&self, index: usize) -> M::Lambda {
        let model = self.at.model;
        self.of_rows(index, model.velocity_count() + model.row_count())
    }

    /// Column `index` of ∂Φ/∂p.
    pub fn constraints(&self, index: usize) -> M::Lambda {
        let model = self.at.model;
        self.of_rows(index, model.velocity_count() + 2 * model.row_count())
    }

    /// Column `index` of ∂ż/∂p of the internal states, with the δv̇ and δλ that go with them.
    pub fn internal_rates(&self, index: usize) -> M::Z {
        let model = self.at.model;
        let (none, still) = (model.zero_v(), model.zero_z());
        let mut rates = self.at.internal_rates(&none, &none, &still, &self.column(index));
        let first = model.velocity_count() + 3 * model.row_count() + model.output_names().len();
        self.add(index, first, rates.as_mut_slice());
        rates
    }

    fn of_rows(&self, index: usize, first: usize) -> M::Lambda {
        let model = self.at.model;
        let mut rows = model.zero_lambda();
        self.add(index, first, rows.as_mut_slice());
        rows
    }

    fn add(&self, column: usize, first: usize, to: &mut [R]) {
        let model = self.at.model;
        add_column(model.parameter_pattern(), self.entries.as_slice(), (first, column), to);
    }
}

/// Where the columns of the derivatives of outputs and of ż begin, behind those of q.
struct ColumnsOf {
    velocities: usize,
    inputs: usize,
    multipliers: usize,
    internal: usize,
    accelerations: usize,
}

impl ColumnsOf {
    fn of<R: Real, M: Tangent<R>>(model: &M) -> Self {
        let velocities = model.velocity_count();
        let inputs = 2 * velocities;
        let multipliers = inputs + model.input_names().len();
        let internal = multipliers + model.row_count();
        let accelerations = internal + model.internal_count();
        ColumnsOf { velocities, inputs, multipliers, internal, accelerations }
    }
}

/// e_index in the place of zeros; zero beyond the end.
pub(crate) fn unit<R: Real, V: Vector<R>>(zero: V, index: usize) -> V {
    let mut unit = zero;
    if let Some(entry) = unit.as_mut_slice().get_mut(index) {
        *entry = R::ONE;
    }
    unit
}

/// y ← y + A x for the block A of a sparse matrix that begins at `from` = (row, column) and is as large as y and x say.
fn add_block<R: Real>(pattern: &[(u16, u16)], entries: &[R], from: (usize, usize), x: &[R], y: &mut [R]) {
    for (&entry, &(row, column)) in entries.iter().zip(pattern) {
        let row = (row as usize).checked_sub(from.0).and_then(|row| y.get_mut(row));
        let factor = (column as usize).checked_sub(from.1).and_then(|column| x.get(column));
        if let (Some(to), Some(&factor)) = (row, factor) {
            *to = *to + entry * factor;
        }
    }
}

/// y ← y + A e for the column of a sparse matrix that begins at `from`.
fn add_column<R: Real>(pattern: &[(u16, u16)], entries: &[R], from: (usize, usize), y: &mut [R]) {
    add_block(pattern, entries, from, &[R::ONE], y);
}

/// An error that names the first entry that is infinite or NaN.
pub(crate) fn check_finite<R: Real>(
    time: R,
    entries: &[R],
    name: impl Fn(usize) -> Option<&'static str>,
) -> Result<(), LinearisationError> {
    match entries.iter().position(|entry| !entry.is_finite()) {
        None => Ok(()),
        Some(index) => {
            let what = name(index).unwrap_or("the mechanism");
            Err(LinearisationError::NonFinite { time: time.to_f64(), what })
        }
    }
}

/// The same for the entries of a sparse matrix, whose rows are named.
fn check_entries<R: Real>(
    time: R,
    entries: &[R],
    pattern: &[(u16, u16)],
    name: impl Fn(u16) -> Option<&'static str>,
) -> Result<(), LinearisationError> {
    check_finite(time, entries, |index| pattern.get(index).and_then(|&(row, _)| name(row)))
}

/// Time, state and inputs must be finite: where nothing depends on them, nothing else would tell.
pub(crate) fn check_given<R: Real, M: Assemble<R, Inputs: Fields<R>>>(
    model: &M,
    time: R,
    state: &StateOf<M, R>,
    u: &M::Inputs,
) -> Result<(), LinearisationError> {
    if model.is_rigid() {
        // The gate of a friction is named by the friction.
        let is_gap = |gate: &usize| model.pressed_by().get(*gate).is_none_or(Option::is_none);
        let first = (0..model.gate_names().len()).find(is_gap);
        let contact = first.and_then(|gate| model.gate_names().get(gate)).copied().unwrap_or(model.name());
        return Err(match model.sticks() {
            true => LinearisationError::Sticks { friction: contact },
            false => LinearisationError::Rigid { contact },
        });
    }
    check_finite(time, &[time], |_| Some("time"))?;
    check_finite(time, state.q.as_slice(), |index| model.position_names().get(index).copied())?;
    check_finite(time, state.v.as_slice(), |index| model.velocity_names().get(index).copied())?;
    check_finite(time, state.z.as_slice(), |index| model.internal_names().get(index).copied())?;
    check_finite(time, u.to_array().as_slice(), |index| model.input_names().get(index).copied())
}

/// Why K(0) could not be factored.
#[cold]
pub(crate) fn broken_down<R: Real, M: Assemble<R>>(
    model: &M,
    time: R,
    q: &M::Q,
    pivot: R,
) -> LinearisationError {
    let (constraints, row) = smallest_pivot(model, time, q);
    let (at, pivot) = (time.to_f64(), pivot.to_f64());
    if constraints > R::from_f64(WELL_POSED)
        && let Some(velocity) = singular_velocity(model, time, q)
    {
        let velocity = model.velocity_names().get(velocity).copied().unwrap_or(model.name());
        return LinearisationError::SingularMass { time: at, pivot, velocity };
    }
    LinearisationError::Breakdown { time: at, pivot, row: name_row(model, row) }
}
