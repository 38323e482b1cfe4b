//! The mechanism as an implicit integrator sees it: residuals and exact tangents of the equations of motion.

use super::dynamics::{MechanismDynamics, Stage, is_locked};
use super::held_rows::HeldRows;
use crate::assembly::system::subtract_product;
use crate::formulation::Formulation;
use crate::input::InputSource;
use crate::integrator::{ImplicitDynamics, Level, Weights};
use crate::layout::differential;
use crate::real::Real;
use crate::state::{State, StateOf};
use crate::tangent::Tangent;
use crate::vector::{Vector, at, put};

impl<M, R, F, S> ImplicitDynamics<R> for MechanismDynamics<'_, M, R, F, S>
where
    M: Tangent<R>,
    R: Real,
    F: Formulation<R, M>,
    S: InputSource<R, M>,
{
    type Unknowns = M::Unknowns;
    type Bordered = M::Bordered;
    type Order = M::Order;

    fn order(&self) -> M::Order {
        self.model.order()
    }

    fn residual(
        &mut self,
        time: R,
        state: &StateOf<M, R>,
        a: &M::V,
        lambda: &M::Lambda,
        rates: &M::Z,
        level: Level,
    ) -> M::Unknowns {
        let model = self.model;
        self.watch.by_positions = level == Level::Position;
        let inputs = self.inputs_at(time, state);
        let at_rest = self.at_rest(time, state, &inputs);
        self.watch.locked |=
            model.sticks() && at_rest.as_ref().is_some_and(|it| is_locked::<M, R>(&it.q, &it.v, &it.gates));
        let state = at_rest.as_ref().unwrap_or(state);
        let State { q, v, .. } = state;
        let (mut forces, mut rows) = (model.zero_v(), model.zero_lambda());
        self.model.residual(time, state, &inputs, a, lambda, &mut forces);
        match level {
            Level::Position => self.model.constraints(time, q, &mut rows),
            Level::Velocity => {
                let mut jacobian = model.zero_jacobian();
                self.model.constraint_jacobian(time, q, &mut jacobian);
                self.model.nu(time, q, &mut rows);
                subtract_product(
                    model.jacobian_pattern(),
                    jacobian.as_slice(),
                    v.as_slice(),
                    rows.as_mut_slice(),
                );
                rows = rows.scaled(-R::ONE);
            }
        }
        // Rows that repeat others have the multiplier zero.
        for &row in model.idle() {
            put(rows.as_mut_slice(), row as usize, at(lambda.as_slice(), row as usize));
        }
        let mut residual = model.zero_unknowns();
        let mut internal = model.zero_z();
        model.internal_rates(time, state, &inputs, a, lambda, &mut internal);
        let internal = rates.plus(-R::ONE, &internal);
        let parts = forces.as_slice().iter().chain(rows.as_slice()).chain(internal.as_slice());
        residual.as_mut_slice().iter_mut().zip(parts).for_each(|(entry, &value)| *entry = value);
        residual
    }

    fn matrix(
        &mut self,
        time: R,
        state: &StateOf<M, R>,
        a: &M::V,
        lambda: &M::Lambda,
        u: &M::V,
        weights: &Weights<R>,
        matrix: &mut M::Bordered,
    ) {
        let inputs = self.inputs_at(time, state);
        // What is closed is so at the beginning of the step, whatever forces are on the way.
        let (closed, at_rest) = (state, self.at_rest(time, state, &inputs));
        let state = at_rest.as_ref().unwrap_or(state);
        let (model, State { q, v, .. }) = (self.model, state);
        let (mut stiffness, mut damping) = (model.zero_stiffness(), model.zero_damping());
        model.tangent(time, state, &inputs, a, lambda, &mut stiffness, &mut damping);
        let (mut mass, mut jacobian) = (model.zero_mass(), model.zero_jacobian());
        model.mass_matrix(time, q, &mut mass);
        model.constraint_jacobian(time, q, &mut jacobian);
        let (n, size) = (model.velocity_count(), model.unknown_count());
        let entries = matrix.as_mut_slice();
        entries.fill(R::ZERO);
        let mut add = |row: usize, column: usize, value: R| {
            let place = row * size + column;
            put(entries, place, at(entries, place) + value);
        };
        let idle = |row: u16| model.idle().contains(&row);
        let rows =
            || jacobian.as_slice().iter().zip(model.jacobian_pattern()).filter(|(_, (row, _))| !idle(*row));

        // What depends on positions, by increments of positions.
        for (&entry, &(row, column)) in stiffness.as_slice().iter().zip(model.stiffness_pattern()) {
            add(row as usize, column as usize, weights.stiffness * entry);
        }
        match weights.level {
            Level::Position => {
                for (&entry, &(row, column)) in rows() {
                    add(n + row as usize, column as usize, entry);
                }
            }
            Level::Velocity => {
                let mut rate = model.zero_rate_tangent();
                model.rate_tangent(time, q, v, &mut rate);
                let rates = rate.as_slice().iter().zip(model.rate_pattern());
                for (&entry, &(row, column)) in rates.filter(|(_, (row, _))| !idle(*row)) {
                    add(n + row as usize, column as usize, weights.stiffness * entry);
                }
            }
        }
        let first = n + model.row_count();
        let internal = Internal::at(model, weights, (time, state, &inputs), a, lambda);
        internal.by_positions(first, &mut add);
        turn_columns(model.layout(), u, entries, size);

        let mut add = |row: usize, column: usize, value: R| {
            let place = row * size + column;
            put(entries, place, at(entries, place) + value);
        };
        for (&entry, &(row, column)) in damping.as_slice().iter().zip(model.damping_pattern()) {
            add(row as usize, column as usize, weights.damping * entry);
        }
        for (&entry, &(row, column)) in rows().filter(|_| weights.level == Level::Velocity) {
            add(n + row as usize, column as usize, weights.damping * entry);
        }
        internal.by_others(weights, first, &mut add);
        let mut friction = model.zero_friction_tangent();
        model.friction_tangent(time, state, &inputs, a, lambda, &mut friction);
        // Columns of u, λ, z, v̇.
        let to_rows = model.input_names().len();
        let [to_internal, to_accelerations] =
            [model.row_count(), model.row_count() + model.internal_count()].map(|it| to_rows + it);
        let rubbing = || friction.as_slice().iter().zip(model.friction_pattern());
        for (&entry, &(row, column)) in rubbing() {
            let (row, column) = (usize::from(row), usize::from(column));
            if (to_internal..to_accelerations).contains(&column) && weights.internal.is_some() {
                add(row, first + column - to_internal, entry);
            }
        }
        // Forces of rigid contacts, and of what sticks, follow what the others become by positions, velocities and states; they are those of the accelerations
        // and multipliers that belong to these, and not of the unknown ones.
        if at_rest.is_some() {
            follow(model, &HeldRows::of(model, time, closed, &inputs, &self.held), entries, size);
        }
        let mut add = |row: usize, column: usize, value: R| {
            let place = row * size + column;
            put(entries, place, at(entries, place) + value);
        };
        for (&entry, &(row, column)) in rubbing() {
            let (row, column) = (usize::from(row), usize::from(column));
            if column >= to_accelerations {
                add(row, column - to_accelerations, weights.mass * entry);
            } else if (to_rows..to_internal).contains(&column) {
                add(row, n + column - to_rows, entry);
            }
        }
        for (&entry, &(row, column)) in mass.as_slice().iter().zip(model.mass_pattern()) {
            let (row, column) = (row as usize, column as usize);
            add(row, column, weights.mass * entry);
            if row != column {
                add(column, row, weights.mass * entry);
            }
        }
        for (&entry, &(row, column)) in rows() {
            add(column as usize, n + row as usize, entry);
        }
        for row in 0..model.row_count() {
            let own = if idle(row as u16) { R::ONE } else { -weights.compliance };
            add(n + row, n + row, own);
        }
    }

    fn rates(&mut self, time: R, State { q, v, .. }: &StateOf<M, R>) -> (M::Lambda, M::Lambda) {
        let model = self.model;
        let (mut nu, mut gamma) = (model.zero_lambda(), model.zero_lambda());
        self.model.nu(time, q, &mut nu);
        self.model.gamma(time, q, v, &mut gamma);
        for &row in model.idle() {
            put(nu.as_mut_slice(), row as usize, R::ZERO);
            put(gamma.as_mut_slice(), row as usize, R::ZERO);
        }
        (nu, gamma)
    }

    fn observe(&mut self, time: R, state: &StateOf<M, R>) {
        let model = self.model;
        if model.row_count() == 0 {
            return;
        }
        let pivot = self.model.factor(time, &state.q, R::ZERO, &mut model.store());
        (self.watch.first_pivot, self.watch.smallest_pivot) = (pivot, pivot);
        self.watch.observed = true;
        self.watch.worst = (!R::any(pivot.greater_equal(R::NEAR_SINGULAR))).then(|| Stage {
            time,
            pivot,
            state: state.clone(),
        });
    }
}

impl<M, R, F, S> MechanismDynamics<'_, M, R, F, S>
where
    M: Tangent<R>,
    R: Real,
    F: Formulation<R, M>,
    S: InputSource<R, M>,
{
    /// The state with the forces that rigid contacts, or what rubs dry in joints, have there; nothing where there are none.
    fn at_rest(&self, time: R, state: &StateOf<M, R>, inputs: &M::Inputs) -> Option<StateOf<M, R>> {
        let is_rigid = M::HOLDS && self.model.is_rigid();
        is_rigid.then(|| State { gates: self.forces_at_rest(time, state, inputs), ..state.clone() })
    }
}

/// Adds to the rows of the forces r what contacts do where these change, −F G⁻¹ Wᵀ r.
fn follow<R: Real, M: Tangent<R>>(model: &M, held: &HeldRows<R, M::V>, entries: &mut [R], size: usize) {
    let n = model.velocity_count();
    for column in 0..size {
        let of = |row: usize, entries: &[R]| at(entries, row * size + column);
        let moved = held.forces_against(|row| of(row, entries));
        for (force, along) in moved.iter().zip(&held.forces).take(held.count) {
            for (row, along) in along.as_slice().iter().enumerate().take(n) {
                let value = of(row, entries) + *force * *along;
                put(entries, row * size + column, value);
            }
        }
    }
}

/// Columns by increments of positions become columns by increments of u: for a quaternion turned by u, times dexp₋ᵤ.
fn turn_columns<R: Real, V: Vector<R>>(layout: &crate::Layout<'_>, u: &V, entries: &mut [R], size: usize) {
    let first = layout.linear + layout.rotations;
    for ball in 0..layout.quaternions {
        let place = first + 3 * ball;
        let three = |entries: &[R]| [0, 1, 2].map(|k| at(entries, place + k));
        let turn = differential(three(u.as_slice()));
        for row in entries.chunks_exact_mut(size.max(1)) {
            let old = three(row);
            for (k, [x, y, z]) in [0, 1, 2].map(|k| (k, turn.map(|row| row[k]))) {
                put(row, place + k, old[0] * x + old[1] * y + old[2] * z);
            }
        }
    }
}

/// The rows and columns of internal states.
struct Internal<'m, R: Real, M: Tangent<R>> {
    model: &'m M,
    /// Where they move.
    derivatives: Option<(M::InternalTangent, M::InternalRateTangent)>,
    stiffness: R,
}

impl<'m, R: Real, M: Tangent<R>> Internal<'m, R, M> {
    fn at(
        model: &'m M,
        weights: &Weights<R>,
        (time, state, u): (R, &StateOf<M, R>, &M::Inputs),
        a: &M::V,
        lambda: &M::Lambda,
    ) -> Self {
        let derivatives = weights.internal.map(|_| {
            let (mut forces, mut rates) = (model.zero_internal_tangent(), model.zero_internal_rate_tangent());
            model.internal_tangent(time, state, u, &mut forces);
            model.internal_rate_tangent(time, state, u, a, lambda, &mut rates);
            (forces, rates)
        });
        Internal { model, derivatives, stiffness: weights.stiffness }
    }

    /// −∂ż/∂q; the first row of theirs is `first`.
    fn by_positions(&self, first: usize, add: &mut impl FnMut(usize, usize, R)) {
        let Some((_, rates)) = &self.derivatives else { return };
        let n = self.model.velocity_count();
        for (&entry, &(row, column)) in rates.as_slice().iter().zip(self.model.internal_rate_pattern()) {
            if usize::from(column) < n {
                add(first + usize::from(row), usize::from(column), -(self.stiffness * entry));
            }
        }
    }

    /// ∂r/∂z, and all others of theirs.
    fn by_others(&self, weights: &Weights<R>, first: usize, add: &mut impl FnMut(usize, usize, R)) {
        let model = self.model;
        let own = weights.internal.unwrap_or(R::ONE);
        for row in 0..model.internal_count() {
            add(first + row, first + row, own);
        }
        let Some((forces, rates)) = &self.derivatives else { return };
        for (&entry, &(row, column)) in forces.as_slice().iter().zip(model.internal_pattern()) {
            add(usize::from(row), first + usize::from(column), entry);
        }
        // Columns of q, v, u, λ, z, v̇.
        let (n, inputs, rows) = (model.velocity_count(), model.input_names().len(), model.row_count());
        let [to_inputs, to_rows] = [2 * n, 2 * n + inputs];
        let [to_internal, to_accelerations] = [to_rows + rows, to_rows + rows + model.internal_count()];
        for (&entry, &(row, column)) in rates.as_slice().iter().zip(model.internal_rate_pattern()) {
            let (row, column) = (first + usize::from(row), usize::from(column));
            if (n..to_inputs).contains(&column) {
                add(row, column - n, -(weights.damping * entry));
            } else if (to_rows..to_internal).contains(&column) {
                add(row, n + column - to_rows, -entry);
            } else if (to_internal..to_accelerations).contains(&column) {
                add(row, first + column - to_internal, -entry);
            } else if column >= to_accelerations {
                add(row, column - to_accelerations, -(weights.mass * entry));
            }
        }
    }
}
