//! Inverse dynamics with loops: the inputs that give the accelerations asked for.

use super::admissible::Admissible;
use super::{broken_down, check_finite, check_given};
use crate::assembly::system::subtract_product;
use crate::error::LinearisationError;
use crate::fields::Fields;
use crate::mechanism::{Assemble, name_row};
use crate::real::Real;
use crate::state::StateOf;
use crate::tangent::Tangent;
use crate::vector::{Vector, dot};

/// Solutions of the linearised equation before an input that enters with curvature is given up; where inputs are forces the
/// second finds nothing to do.
const ITERATIONS: u32 = 30;

/// Inputs and the multipliers that go with them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Actuation<U, L> {
    /// Those of the actuators as found, the others as given.
    pub inputs: U,
    /// λ, shape m.
    pub lambda: L,
}

/// The numbers of inputs.
type Values<R, M> = <<M as crate::Mechanism<R>>::Inputs as Fields<R>>::Array;

/// The inputs named `actuators` with which the mechanism has the accelerations `a` at a state, the other inputs being those
/// of `u`: M a + Dᵀ λ = Q(u).
///
/// On the motions N that the constraints admit (D N = 0) the multipliers do not work, so that with Q linear in u
///
/// ```text
/// Nᵀ ∂Q/∂u u = Nᵀ (M a − Q₀)      f equations, one for each degree of freedom
/// ```
/// Where there are several solutions it is the one of least Σ u² (N and N·m alike), by orthogonalising the equations one
/// after the other (Gram–Schmidt, twice: Giraud, Langou, Rozložník, *The loss of orthogonality in the Gram–Schmidt orthogonalization process*,
/// 2005). Inputs that enter with curvature are found by at most 30 iterations from zero. `a` must satisfy D a = γ: the motion of the whole
/// from that of the independent coordinates, which [`kinematics`](crate::AssembleExt::kinematics) gives, does.
///
/// # Errors
/// [`NoSuchInput`](LinearisationError::NoSuchInput), [`Inconsistent`](LinearisationError::Inconsistent) for accelerations that
/// the constraints do not admit, [`Unactuated`](LinearisationError::Unactuated) where the actuators are too few;
/// [`Breakdown`](LinearisationError::Breakdown), [`SingularMass`](LinearisationError::SingularMass),
/// [`Assembly`](LinearisationError::Assembly), [`Incomplete`](LinearisationError::Incomplete),
/// [`NoActuation`](LinearisationError::NoActuation).
pub fn actuation<R: Real, M: Tangent<R>>(
    model: &M,
    time: R,
    state: &StateOf<M, R>,
    a: &M::V,
    u: &M::Inputs,
    actuators: &[&'static str],
) -> Result<Actuation<M::Inputs, M::Lambda>, LinearisationError> {
    let acting = acting(model, actuators)?;
    check_given(model, time, state, u)?;
    check_finite(time, a.as_slice(), |index| model.velocity_names().get(index).copied())?;
    check_accelerations(model, time, state, a)?;
    let admissible = Admissible::at(model, time, &state.q)?;
    let mut values = u.to_array();
    for (value, &acts) in values.as_mut_slice().iter_mut().zip(acting.as_slice()) {
        *value = *value * (R::ONE - acts);
    }
    // Friction by reactions follows by steps of the same size.
    let tolerance = if model.rubs() { R::from_f64(8.0) * R::EPSILON } else { R::EPSILON.sqrt() };
    let mut lambda = model.zero_lambda();
    let mut left = R::ZERO;
    for _ in 0..ITERATIONS {
        let next = improved(model, &admissible, (time, state, a), &acting, &values, &lambda)?;
        left = next.plus(-R::ONE, &values).max_abs();
        let done = left <= tolerance * next.max_abs();
        values = next;
        if done || model.rubs() {
            let inputs = M::Inputs::from_array(values.clone());
            lambda = multipliers(model, time, state, a, &inputs, lambda)?;
        }
        if done {
            let inputs = M::Inputs::from_array(values.clone());
            check_finite(time, values.as_slice(), |index| model.input_names().get(index).copied())?;
            check_finite(time, lambda.as_slice(), |row| model.rows().get(row).map(|row| row.of))?;
            return Ok(Actuation { inputs, lambda });
        }
    }
    Err(LinearisationError::NoActuation { left: left.to_f64(), iterations: ITERATIONS })
}

/// 1 for the inputs named, 0 for the others.
fn acting<R: Real, M: Tangent<R>>(
    model: &M,
    actuators: &[&'static str],
) -> Result<Values<R, M>, LinearisationError> {
    let mut acting = Values::<R, M>::zeros(model.input_names().len());
    for &name in actuators {
        let inputs = model.input_names();
        match inputs.iter().position(|input| *input == name) {
            Some(index) => acting.as_mut_slice()[index] = R::ONE,
            None => return Err(LinearisationError::NoSuchInput { name, inputs }),
        }
    }
    Ok(acting)
}

/// D a = γ, to half of the digits.
pub(crate) fn check_accelerations<R: Real, M: Assemble<R>>(
    model: &M,
    time: R,
    state: &StateOf<M, R>,
    a: &M::V,
) -> Result<(), LinearisationError> {
    let (mut jacobian, mut left) = (model.zero_jacobian(), model.zero_lambda());
    model.constraint_jacobian(time, &state.q, &mut jacobian);
    model.gamma(time, &state.q, &state.v, &mut left);
    let mut magnitudes = left.clone();
    for entry in magnitudes.as_mut_slice() {
        *entry = entry.abs();
    }
    for (&entry, &(row, column)) in jacobian.as_slice().iter().zip(model.jacobian_pattern()) {
        let term = (entry * a.as_slice()[column as usize]).abs();
        let magnitude = &mut magnitudes.as_mut_slice()[row as usize];
        *magnitude = *magnitude + term;
    }
    subtract_product(model.jacobian_pattern(), jacobian.as_slice(), a.as_slice(), left.as_mut_slice());
    let largest = magnitudes.max_abs();
    let bound = R::EPSILON.sqrt() * if largest > R::ONE { largest } else { R::ONE };
    let off = left.as_slice().iter().position(|entry| !R::any(entry.abs().less_equal(bound)));
    off.map_or(Ok(()), |row| {
        let residual = left.as_slice()[row].to_f64();
        Err(LinearisationError::Inconsistent { row: name_row(model, Some(row)), residual })
    })
}

/// The inputs by the equations linearised at `values`: of those that act the least ones, the others as they are.
fn improved<R: Real, M: Tangent<R>>(
    model: &M,
    admissible: &Admissible<'_, R, M>,
    (time, state, a): (R, &StateOf<M, R>, &M::V),
    acting: &Values<R, M>,
    values: &Values<R, M>,
    lambda: &M::Lambda,
) -> Result<Values<R, M>, LinearisationError> {
    let inputs = M::Inputs::from_array(values.clone());
    let (mut residual, mut forces, mut input) = (model.zero_v(), model.zero_v(), model.zero_input_tangent());
    model.residual(time, state, &inputs, a, lambda, &mut residual);
    model.forces(time, state, &inputs, &mut forces);
    model.input_tangent(time, state, &inputs, &mut input);
    let count = model.input_names().len();
    // The rows fit where B of ẋ = A x + B u does: one of them for each degree of freedom.
    let order = 2 * model.states().len() + model.internal_count();
    let (mut found, mut rows) = (Values::<R, M>::zeros(count), M::InputMatrix::zeros(order * count));
    let mut solved = model.zero_conditions();
    for index in 0..model.states().len() {
        let basis = admissible.basis(index);
        // G = −Nᵀ ∂r/∂u of what acts, G u = Nᵀ r + G u₀.
        let mut row = Values::<R, M>::zeros(count);
        for (&entry, &(velocity, column)) in input.as_slice().iter().zip(model.input_pattern()) {
            let (own, acts) = (&mut row.as_mut_slice()[column as usize], acting.as_slice()[column as usize]);
            *own = *own - basis.as_slice()[velocity as usize] * entry * acts;
        }
        let size = row.norm_squared().sqrt();
        let terms = basis.as_slice().iter().zip(residual.as_slice()).zip(forces.as_slice());
        let (mut right, mut magnitude) = (dot(row.as_slice(), values.as_slice()), R::ZERO);
        for ((&n, &r), &force) in terms {
            right = right + n * r;
            magnitude = magnitude + (n * r).abs() + (n * force).abs();
        }
        // Twice, so that what is left is orthogonal to rounding.
        let (before, rest) = rows.as_mut_slice().split_at_mut(index * count);
        for _ in 0..2 {
            for (done, &value) in before.chunks_exact(count.max(1)).zip(solved.as_slice()) {
                let along = dot(done, row.as_slice());
                right = right - along * value;
                magnitude = magnitude + (along * value).abs();
                for (entry, &other) in row.as_mut_slice().iter_mut().zip(done) {
                    *entry = *entry - along * other;
                }
            }
        }
        let length = row.norm_squared().sqrt();
        if length > R::EPSILON.sqrt() * size {
            let (unit, value) = (row.scaled(R::ONE / length), right / length);
            rest[..count].copy_from_slice(unit.as_slice());
            solved.as_mut_slice()[index] = value;
            found.axpy(value, &unit);
        } else if !R::any(right.abs().less_equal(R::EPSILON.sqrt() * magnitude)) {
            let coordinate = model.conditions()[model.states()[index] as usize].of;
            let actuators = acting.as_slice().iter().filter(|&&acts| acts > R::ZERO).count();
            return Err(LinearisationError::Unactuated { coordinate, missing: right.to_f64(), actuators });
        }
    }
    for ((found, &acts), &value) in
        found.as_mut_slice().iter_mut().zip(acting.as_slice()).zip(values.as_slice())
    {
        *found = *found + (R::ONE - acts) * value;
    }
    Ok(found)
}

/// λ of Dᵀ (λ − λ₀) = −r(λ₀), which lies in the range of Dᵀ.
fn multipliers<R: Real, M: Tangent<R>>(
    model: &M,
    time: R,
    state: &StateOf<M, R>,
    a: &M::V,
    inputs: &M::Inputs,
    known: M::Lambda,
) -> Result<M::Lambda, LinearisationError> {
    let (mut residual, mut lambda) = (model.zero_v(), model.zero_lambda());
    let mut store = model.store();
    let pivot = model.factor(time, &state.q, R::ZERO, &mut store);
    if !R::any(pivot.greater_equal(R::BREAKDOWN)) {
        return Err(broken_down(model, time, &state.q, pivot));
    }
    model.residual(time, state, inputs, a, &known, &mut residual);
    let none = model.zero_lambda();
    let mut rest = model.zero_v();
    model.solve(&store, &residual.scaled(-R::ONE), &none, &mut rest, &mut lambda);
    Ok(known.plus(R::ONE, &lambda))
}
