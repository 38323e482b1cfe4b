//! The equations of motion in independent coordinates, at one state.

use super::basis::{Basis, condition_product, inertia};
use crate::assembly::system::mass_times;
use crate::error::{AssemblyError, LinearisationError};
use crate::fields::Fields;
use crate::formulation::friction::applied;
use crate::linearisation::lu::Lu;
use crate::linearisation::{check_finite, check_given};
use crate::mechanism::{Assemble, Row};
use crate::real::Real;
use crate::state::{State, StateOf};
use crate::vector::{Vector, at, dot, put};

/// M_r s̈ + h = τ in the independent coordinates s, f numbers (m and rad), at one time, state and input:
///
/// ```text
/// v = N ṡ + v₀,   v̇ = N s̈ + a₀             D N = 0, B N = 1;   D a₀ = γ, B a₀ + b = 0
/// M_r = Nᵀ M N,    h = Nᵀ (M a₀ − Q)        g = −Nᵀ Q(v = 0, u = 0)
/// ```
/// with ṡ = B v (and more where places move with time) and s̈ = B v̇ + b. τ are further forces along the coordinates (N, N·m): those that the
/// inputs given do not hold already. With all inputs zero τ = Nᵀ ∂Q/∂u u. Coordinates are those of
/// [`independent`](Assemble::independent), in its order, or others by [`Reduced::along`]. Needs no derivatives.
///
/// Source: García de Jalón, Bayo, *Kinematic and Dynamic Simulation of Multibody Systems*, 5.2.3 (matrix R); the names are those of
/// Featherstone, *Rigid Body Dynamics Algorithms*, 8.
#[derive(Clone, Debug)]
pub struct Reduced<'m, R: Real, M: Assemble<R>> {
    model: &'m M,
    /// N, column by column.
    columns: M::Basis,
    mass: M::Reduced,
    bias: M::V,
    gravity: M::V,
    velocity: M::V,
    acceleration: M::V,
}

impl<'m, R: Real, M: Assemble<R, Inputs: Fields<R>>> Reduced<'m, R, M> {
    /// The equations in the coordinates of [`independent`](Assemble::independent). The state must satisfy the constraints.
    ///
    /// # Errors
    /// [`Incomplete`](LinearisationError::Incomplete) where these are fewer than the degrees of freedom (bodies on balls),
    /// [`Assembly`](LinearisationError::Assembly) at their dead centres, to half of the digits;
    /// [`Breakdown`](LinearisationError::Breakdown), [`NonFinite`](LinearisationError::NonFinite).
    pub fn at(
        model: &'m M,
        time: R,
        state: &StateOf<M, R>,
        u: &M::Inputs,
    ) -> Result<Self, LinearisationError> {
        Self::along(model, time, state, u, model.independent())
    }

    /// The same in other coordinates, indices into [`conditions`](Assemble::conditions): those of
    /// [`Tangent::states`](crate::Tangent::states), or any that [`coordinate`](super::coordinate) finds by name.
    ///
    /// # Errors
    /// As [`Reduced::at`]; [`Assembly`](LinearisationError::Assembly) also for an index beyond the conditions.
    pub fn along(
        model: &'m M,
        time: R,
        state: &StateOf<M, R>,
        u: &M::Inputs,
        coordinates: &[u16],
    ) -> Result<Self, LinearisationError> {
        check_given(model, time, state, u)?;
        let State { q, v, .. } = state;
        let basis = Basis::at(model, time, q)?;
        let mut jacobian = model.zero_condition_jacobian();
        model.condition_jacobian(time, q, &mut jacobian);
        let columns = normalised(model, &basis, &jacobian, coordinates)?;
        let mut found = Reduced {
            model,
            columns,
            mass: model.zero_reduced(),
            bias: model.zero_v(),
            gravity: model.zero_v(),
            velocity: model.zero_v(),
            acceleration: model.zero_v(),
        };
        // v₀ and a₀: what is there with the rows alone, less what of it moves the coordinates.
        let (mut nu, mut drift) = (model.zero_lambda(), model.zero_conditions());
        model.nu(time, q, &mut nu);
        model.condition_drift(time, q, &mut drift);
        let (mut gamma, mut bias) = (model.zero_lambda(), model.zero_conditions());
        model.gamma(time, q, v, &mut gamma);
        model.condition_bias(time, q, v, &mut bias);
        let rest = |rows: &M::Lambda, more: &M::Conditions| {
            let particular = basis.particular(rows);
            let moved = condition_product(model, &jacobian, particular.as_slice()).plus(R::ONE, more);
            let moved = coordinates.iter().map(|&index| at(moved.as_slice(), index.into()));
            found.moved(moved.map(|rate| -rate), particular)
        };
        let (velocity, acceleration) = (rest(&nu, &drift), rest(&gamma, &bias));
        found.fill(time, state, u, velocity, acceleration);
        check_finite(time, found.mass.as_slice(), |_| Some("mass matrix"))?;
        check_finite(time, found.bias.as_slice(), |_| Some("bias"))?;
        check_finite(time, found.gravity.as_slice(), |_| Some("gravity"))?;
        Ok(found)
    }

    fn fill(&mut self, time: R, state: &StateOf<M, R>, u: &M::Inputs, velocity: M::V, acceleration: M::V) {
        let model = self.model;
        let f = model.freedoms();
        let mut mass = model.zero_mass();
        model.mass_matrix(time, &state.q, &mut mass);
        for k in 0..f {
            let product = mass_times(model, &mass, &self.motion(k));
            for other in 0..f {
                let entry = self.component(other, &product);
                put(self.mass.as_mut_slice(), k * f + other, entry);
            }
        }
        let (mut forces, mut still) = (model.zero_v(), model.zero_v());
        applied(model, time, state, u, &mut forces);
        let rest = State { v: model.zero_v(), ..state.clone() };
        let none = M::Inputs::from_array(Vector::zeros(model.input_names().len()));
        model.forces(time, &rest, &none, &mut still);
        let missing = inertia(model, time, state, &acceleration).plus(-R::ONE, &forces);
        for k in 0..f {
            let (bias, gravity) = (self.component(k, &missing), -self.component(k, &still));
            put(self.bias.as_mut_slice(), k, bias);
            put(self.gravity.as_mut_slice(), k, gravity);
        }
        (self.velocity, self.acceleration) = (velocity, acceleration);
    }
}

impl<R: Real, M: Assemble<R>> Reduced<'_, R, M> {
    /// M_r, `[R; f·f]`, row by row, symmetric to rounding; kg, kg·m, kg·m².
    pub fn mass_matrix(&self) -> &M::Reduced {
        &self.mass
    }

    /// h, f numbers, N and N·m: inertia forces without s̈, less all loads with the inputs given.
    pub fn bias(&self) -> &[R] {
        self.bias.as_slice().get(..self.model.freedoms()).unwrap_or_default()
    }

    /// g, f numbers, N and N·m: what must act along the coordinates to hold the mechanism at rest here. Weights, springs and whatever else acts
    /// without motion and without inputs, internal states as they are.
    pub fn gravity(&self) -> &[R] {
        self.gravity.as_slice().get(..self.model.freedoms()).unwrap_or_default()
    }

    /// Column `index` of N: the velocities of the whole (shape n_v) with ṡ_index = 1 alone. Zero beyond f.
    pub fn motion(&self, index: usize) -> M::V {
        let mut motion = self.model.zero_v();
        for (entry, &value) in motion.as_mut_slice().iter_mut().zip(self.column(index)) {
            *entry = value;
        }
        motion
    }

    /// N ṡ + v₀, shape n_v: the velocities of the whole with these rates, f numbers; missing ones are zero.
    pub fn velocity(&self, rates: &[R]) -> M::V {
        self.moved(rates.iter().copied(), self.velocity.clone())
    }

    /// N s̈ + a₀, shape n_v: the accelerations of the whole at the state with these of the coordinates, f numbers; missing ones are zero. They
    /// satisfy the constraints.
    pub fn acceleration(&self, accelerations: &[R]) -> M::V {
        self.moved(accelerations.iter().copied(), self.acceleration.clone())
    }

    /// (Nᵀ `forces`)_index: what forces on the velocities (shape n_v, N and N·m) do along a coordinate. Zero beyond f.
    pub fn component(&self, index: usize, forces: &M::V) -> R {
        dot(self.column(index), forces.as_slice())
    }

    fn column(&self, index: usize) -> &[R] {
        let n = self.model.velocity_count();
        self.columns
            .as_slice()
            .chunks_exact(n.max(1))
            .take(self.model.freedoms())
            .nth(index)
            .unwrap_or_default()
    }

    /// `rest` + N x.
    fn moved(&self, x: impl Iterator<Item = R>, rest: M::V) -> M::V {
        let mut sum = rest;
        for (index, x) in x.enumerate() {
            for (entry, &n) in sum.as_mut_slice().iter_mut().zip(self.column(index)) {
                *entry = n.mul_add(x, *entry);
            }
        }
        sum
    }
}

/// N (B N)⁻¹ of the coordinates' rows B.
fn normalised<R: Real, M: Assemble<R>>(
    model: &M,
    basis: &Basis<'_, R, M>,
    jacobian: &M::ConditionJacobian,
    coordinates: &[u16],
) -> Result<M::Basis, LinearisationError> {
    let (f, n) = (model.freedoms(), model.velocity_count());
    if coordinates.len() != f {
        return Err(LinearisationError::Incomplete { needed: f, given: coordinates.len() });
    }
    let count = model.conditions().len();
    if let Some(&index) = coordinates.iter().find(|&&index| usize::from(index) >= count) {
        let index = index.into();
        return Err(LinearisationError::Assembly(AssemblyError::NoSuchCondition { index, count }));
    }
    let mut square = model.zero_reduced();
    for (k, column) in basis.columns().enumerate() {
        let rates = condition_product(model, jacobian, column);
        for (row, &index) in coordinates.iter().enumerate() {
            put(square.as_mut_slice(), row * f + k, at(rates.as_slice(), index.into()));
        }
    }
    check_coordinates(model, basis, jacobian, coordinates, &square)?;
    let (mut rows, mut scales, mut order) = (model.zero_v(), model.zero_v(), model.choice());
    let rows = rows.as_mut_slice().get_mut(..f).unwrap_or_default();
    let scales = scales.as_mut_slice().get_mut(..f).unwrap_or_default();
    let order = order.as_mut().get_mut(..f).unwrap_or_default();
    let mut lu = Lu { entries: square.as_mut_slice(), rows, columns: scales, order };
    lu.factor_above(R::EPSILON.sqrt()).map_err(|none| {
        let row = Row { of: basis.name(none.unknown), what: "velocity" };
        LinearisationError::Assembly(AssemblyError::RankDeficient { row, pivot: none.pivot.to_f64() })
    })?;
    let mut normalised = model.zero_basis();
    for (k, own) in normalised.as_mut_slice().chunks_exact_mut(n.max(1)).enumerate().take(f) {
        let mut weights = model.zero_v();
        put(weights.as_mut_slice(), k, R::ONE);
        lu.solve(weights.as_mut_slice().get_mut(..f).unwrap_or_default());
        for (column, &weight) in basis.columns().zip(weights.as_slice()) {
            own.iter_mut().zip(column).for_each(|(entry, &n)| *entry = n.mul_add(weight, *entry));
        }
    }
    Ok(normalised)
}

/// A coordinate that no motion of the whole changes is at a dead centre: its row of B N beside what B and N alone would make of it, with
/// velocities of different units brought to one by [`Assemble::scales`].
fn check_coordinates<R: Real, M: Assemble<R>>(
    model: &M,
    basis: &Basis<'_, R, M>,
    jacobian: &M::ConditionJacobian,
    coordinates: &[u16],
    square: &M::Reduced,
) -> Result<(), LinearisationError> {
    let scale = |velocity: usize| model.scales().get(velocity).map_or(R::ONE, |&scale| R::from_f64(scale));
    let largest = basis.columns().flat_map(|column| column.iter().enumerate());
    let largest = largest.fold(R::ZERO, |most, (velocity, &n)| most.max(n.abs() / scale(velocity)));
    for (row, &index) in coordinates.iter().enumerate() {
        let own = jacobian.as_slice().iter().zip(model.condition_pattern());
        let own = own.filter(|(_, place)| place.0 == index);
        let size = own.fold(R::ZERO, |most, (&entry, place)| most.max(entry.abs() * scale(place.1.into())));
        let entries = square.as_slice().iter().skip(row * model.freedoms()).take(model.freedoms());
        let pivot = entries.fold(R::ZERO, |most, entry| most.max(entry.abs())) / (size * largest);
        // Written so that a NaN fails.
        if !R::any(pivot.greater_equal(R::EPSILON.sqrt())) {
            let of =
                model.conditions().get(usize::from(index)).map_or(model.name(), |condition| condition.of);
            let (row, pivot) = (Row { of, what: "held" }, pivot.to_f64());
            return Err(LinearisationError::Assembly(AssemblyError::RankDeficient { row, pivot }));
        }
    }
    Ok(())
}
