//! Inverse dynamics of closed loops by the joints that are driven: forces are evaluated, not differentiated.
//!
//! With derivatives at hand (`options { emit = (tangent); }`) the same is `linearisation::actuation`, also for inputs that enter the loads
//! with curvature.

use super::basis::{Basis, inertia};
use crate::error::LinearisationError;
use crate::fields::Fields;
use crate::linearisation::{Actuation, check_accelerations, check_finite, check_given};
use crate::mechanism::{Assemble, Mechanism};
use crate::real::Real;
use crate::state::StateOf;
use crate::vector::{Vector, at, dot, put};
use core::array::from_fn;

/// K inputs of a mechanism that drive it, looked up once by their names.
///
/// ```text
/// let motors = Actuators::named(&model, ["torque[0]", "torque[1]", "torque[2]"])?;
/// loop {
///     let wanted = model.kinematics(time, &state.q, &motion)?.a;
///     let inputs = motors.inputs_for(&model, (time, &state), &wanted, &others)?.inputs;
/// }
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Actuators<const K: usize> {
    indices: [usize; K],
}

/// The equations G u = Nᵀ (M a − Q), f rows for K inputs, as G = L W with orthonormal rows W.
struct Driven<R: Real, M: Assemble<R>, const K: usize> {
    /// Wᵀ: f entries of each input.
    units: [M::V; K],
    /// L, row by row, f × f.
    lower: M::Reduced,
}

impl<const K: usize> Actuators<K> {
    /// The inputs of these names.
    ///
    /// # Errors
    /// [`NoSuchInput`](LinearisationError::NoSuchInput).
    pub fn named<R: Real, M: Mechanism<R>>(
        model: &M,
        names: [&'static str; K],
    ) -> Result<Self, LinearisationError> {
        let inputs = model.input_names();
        let mut indices = [0; K];
        for (index, name) in indices.iter_mut().zip(names) {
            let found = inputs.iter().position(|input| *input == name);
            *index = found.ok_or(LinearisationError::NoSuchInput { name, inputs })?;
        }
        Ok(Actuators { indices })
    }

    /// The values of these inputs with which the mechanism has the accelerations `a` (shape n_v, m/s² and rad/s²) at a time (s) and a state, the
    /// other inputs being those of `u`, and the multipliers λ that go with them: M a + Dᵀ λ = Q(u).
    ///
    /// On the motions N that the constraints admit (D N = 0) the multipliers do not work. With Q affine in the inputs, as forces,
    /// torques and signals times gains are, its columns are differences of values, and nothing has to be differentiated:
    ///
    /// ```text
    /// G u = Nᵀ (M a − Q(0)),   G eᵢ = Nᵀ (Q(eᵢ) − Q(0))      f equations, one for each degree of freedom
    /// ```
    /// Of several solutions it is the one of least Σ u² (N and N·m alike), by orthogonalising the rows of G one after the other
    /// (Gram–Schmidt, twice: Giraud, Langou, Rozložník, *The loss of orthogonality in the Gram–Schmidt orthogonalization process*, 2005).
    /// What the differences lose beside large loads a second solution with the same G brings back; the forces of its result are evaluated,
    /// and where they miss `a` the inputs enter with curvature. K + 3 evaluations of Q, one of M and D. `a` must satisfy D a = γ:
    /// [`Reduced::acceleration`](super::Reduced::acceleration) and [`kinematics`](crate::AssembleExt::kinematics) give such.
    ///
    /// # Errors
    /// [`Inconsistent`](LinearisationError::Inconsistent) for accelerations that the constraints do not admit,
    /// [`Unactuated`](LinearisationError::Unactuated) where the actuators are too few, [`Curved`](LinearisationError::Curved) where Q is
    /// not affine in them; [`Breakdown`](LinearisationError::Breakdown), [`NonFinite`](LinearisationError::NonFinite).
    pub fn inputs_for<R: Real, M: Assemble<R, Inputs: Fields<R>>>(
        &self,
        model: &M,
        (time, state): (R, &StateOf<M, R>),
        a: &M::V,
        u: &M::Inputs,
    ) -> Result<Actuation<M::Inputs, M::Lambda>, LinearisationError> {
        check_given(model, time, state, u)?;
        check_finite(time, a.as_slice(), |index| model.velocity_names().get(index).copied())?;
        check_accelerations(model, time, state, a)?;
        let basis = Basis::at(model, time, &state.q)?;
        let inertia = inertia(model, time, state, a);
        let mut values = u.to_array();
        self.indices.iter().for_each(|&index| put(values.as_mut_slice(), index, R::ZERO));
        let mut forces = forces(model, time, state, &values);
        let driven = self.driven(model, &basis, (time, state), &values, &forces);
        let missing = driven.missing(&basis, &inertia, &forces);
        driven.check_actuated(model, &basis, &missing)?;
        let sizes = missing.1.plus(R::ONE, &driven.sizes(model, &missing.0));
        let mut missing = missing.0;
        for _ in 0..2 {
            for (&index, added) in self.indices.iter().zip(driven.solve(model, &missing)) {
                let value = at(values.as_slice(), index) + added;
                put(values.as_mut_slice(), index, value);
            }
            forces = self::forces(model, time, state, &values);
            missing = driven.missing(&basis, &inertia, &forces).0;
        }
        check_finite(time, values.as_slice(), |index| model.input_names().get(index).copied())?;
        driven.check_affine(&basis, &missing, &sizes)?;
        let lambda = basis.multipliers(&forces.plus(-R::ONE, &inertia));
        check_finite(time, lambda.as_slice(), |row| model.rows().get(row).map(|row| row.of))?;
        Ok(Actuation { inputs: M::Inputs::from_array(values), lambda })
    }

    fn driven<R: Real, M: Assemble<R, Inputs: Fields<R>>>(
        &self,
        model: &M,
        basis: &Basis<'_, R, M>,
        (time, state): (R, &StateOf<M, R>),
        values: &<M::Inputs as Fields<R>>::Array,
        forces: &M::V,
    ) -> Driven<R, M, K> {
        let mut units = from_fn(|_| model.zero_v());
        for (&index, unit) in self.indices.iter().zip(&mut units) {
            let mut one = values.clone();
            put(one.as_mut_slice(), index, R::ONE);
            let difference = self::forces(model, time, state, &one).plus(-R::ONE, forces);
            for (entry, column) in unit.as_mut_slice().iter_mut().zip(basis.columns()) {
                *entry = dot(column, difference.as_slice());
            }
        }
        let mut driven = Driven { units, lower: model.zero_reduced() };
        driven.orthogonalise(model.freedoms());
        driven
    }
}

impl<R: Real, M: Assemble<R>, const K: usize> Driven<R, M, K> {
    fn row(&self, index: usize) -> [R; K] {
        from_fn(|input| self.units.get(input).map_or(R::ZERO, |unit| at(unit.as_slice(), index)))
    }

    /// G, in the place of W, to L and W. The row of W of an equation that depends on those before is zero.
    fn orthogonalise(&mut self, freedoms: usize) {
        for index in 0..freedoms {
            let mut row = self.row(index);
            let size = dot(&row, &row).sqrt();
            // Twice, so that what is left is orthogonal to rounding.
            for _ in 0..2 {
                for before in 0..index {
                    let unit = self.row(before);
                    let along = dot(&unit, &row);
                    let place = index * freedoms + before;
                    let sum = at(self.lower.as_slice(), place) + along;
                    put(self.lower.as_mut_slice(), place, sum);
                    row.iter_mut().zip(unit).for_each(|(entry, unit)| *entry = *entry - along * unit);
                }
            }
            let length = dot(&row, &row).sqrt();
            let depends = !R::any(length.greater(R::EPSILON.sqrt() * size));
            let (length, scale) = if depends { (R::ZERO, R::ZERO) } else { (length, R::ONE / length) };
            put(self.lower.as_mut_slice(), index * freedoms + index, length);
            for (unit, entry) in self.units.iter_mut().zip(row) {
                put(unit.as_mut_slice(), index, entry * scale);
            }
        }
    }

    /// Nᵀ (M a − Q), and the magnitudes of its terms; f entries each.
    fn missing(&self, basis: &Basis<'_, R, M>, inertia: &M::V, forces: &M::V) -> (M::V, M::V) {
        let (mut missing, mut magnitudes) = (inertia.scaled(R::ZERO), inertia.scaled(R::ZERO));
        let places = missing.as_mut_slice().iter_mut().zip(magnitudes.as_mut_slice());
        for ((missing, magnitude), column) in places.zip(basis.columns()) {
            for ((&n, &inertia), &force) in column.iter().zip(inertia.as_slice()).zip(forces.as_slice()) {
                *missing = n.mul_add(inertia - force, *missing);
                *magnitude = *magnitude + (n * inertia).abs() + (n * force).abs();
            }
        }
        (missing, magnitudes)
    }

    /// y of L y = `right`, zero where an equation depends on those before; what is then left of it, and the terms that this is made of.
    fn forward(&self, model: &M, index: usize, right: &M::V, y: &M::V) -> (R, R) {
        let row = self.lower.as_slice().get(index * model.freedoms()..).unwrap_or_default();
        let start = at(right.as_slice(), index);
        let terms = row.iter().zip(y.as_slice()).take(index);
        terms.fold((start, start.abs()), |(rest, size), (&l, &y)| (rest - l * y, size + (l * y).abs()))
    }

    fn lowered(&self, model: &M, right: &M::V) -> M::V {
        let mut y = model.zero_v();
        for index in 0..model.freedoms() {
            let (rest, _) = self.forward(model, index, right, &y);
            let pivot = at(self.lower.as_slice(), index * model.freedoms() + index);
            put(y.as_mut_slice(), index, if pivot > R::ZERO { rest / pivot } else { R::ZERO });
        }
        y
    }

    /// The least inputs with G u = `right`, as far as there are any: Wᵀ L⁻¹ `right`.
    fn solve(&self, model: &M, right: &M::V) -> [R; K] {
        let y = self.lowered(model, right);
        from_fn(|input| self.units.get(input).map_or(R::ZERO, |unit| dot(unit.as_slice(), y.as_slice())))
    }

    /// Equations that no actuator can change must hold by themselves.
    fn check_actuated(
        &self,
        model: &M,
        basis: &Basis<'_, R, M>,
        (missing, magnitudes): &(M::V, M::V),
    ) -> Result<(), LinearisationError> {
        let (f, y) = (model.freedoms(), self.lowered(model, missing));
        let depends = |index: &usize| at(self.lower.as_slice(), index * f + index) == R::ZERO;
        for index in (0..f).filter(depends) {
            let (rest, size) = self.forward(model, index, missing, &y);
            let bound = R::EPSILON.sqrt() * (size + at(magnitudes.as_slice(), index));
            if !R::any(rest.abs().less_equal(bound)) {
                let coordinate = basis.name(index);
                return Err(LinearisationError::Unactuated {
                    coordinate,
                    missing: rest.to_f64(),
                    actuators: K,
                });
            }
        }
        Ok(())
    }

    /// The magnitudes of the terms of G u.
    fn sizes(&self, model: &M, right: &M::V) -> M::V {
        let (f, y, mut sizes) = (model.freedoms(), self.lowered(model, right), model.zero_v());
        for (row, size) in self.lower.as_slice().chunks_exact(f.max(1)).zip(sizes.as_mut_slice()) {
            *size = row.iter().zip(y.as_slice()).fold(R::ZERO, |sum, (&l, &y)| sum + (l * y).abs());
        }
        sizes
    }

    /// Forces of the result must be those asked for, to half of the digits.
    fn check_affine(
        &self,
        basis: &Basis<'_, R, M>,
        missing: &M::V,
        sizes: &M::V,
    ) -> Result<(), LinearisationError> {
        let mut places = missing.as_slice().iter().zip(sizes.as_slice());
        let off = |(missing, size): (&R, &R)| !R::any(missing.abs().less_equal(R::EPSILON.sqrt() * *size));
        places.position(off).map_or(Ok(()), |index| {
            let missing = at(missing.as_slice(), index).to_f64();
            Err(LinearisationError::Curved { coordinate: basis.name(index), missing })
        })
    }
}

/// Q with these inputs.
fn forces<R: Real, M: Assemble<R, Inputs: Fields<R>>>(
    model: &M,
    time: R,
    state: &StateOf<M, R>,
    values: &<M::Inputs as Fields<R>>::Array,
) -> M::V {
    let mut forces = model.zero_v();
    model.forces(time, state, &M::Inputs::from_array(values.clone()), &mut forces);
    forces
}
