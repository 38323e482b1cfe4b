//! Coordinates by name: their values and rates at a state, and the state that belongs to measured ones.

use super::basis::condition_product;
use crate::assembly::{assemble_position, held as held_gates, nearest_velocity};
use crate::error::{AssemblyError, LinearisationError};
use crate::mechanism::{Assemble, ConditionKind};
use crate::real::Real;
use crate::state::{State, StateOf};
use crate::vector::Vector;

/// What an encoder says of one coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading<R = f64> {
    /// The coordinate, an index into [`conditions`](Assemble::conditions): see [`coordinate`].
    pub coordinate: u16,
    /// Its value, rad or m.
    pub position: R,
    /// Its rate, rad/s or m/s.
    pub rate: R,
}

/// The index of a coordinate by its name, such as `"crank_pin.angle"`: a joint's angle or travel, or whatever else `start` and
/// `options { independent = (…); }` may name and do.
///
/// # Errors
/// [`NoSuchCoordinate`](LinearisationError::NoSuchCoordinate).
pub fn coordinate<R: Real, M: Assemble<R>>(model: &M, name: &'static str) -> Result<u16, LinearisationError> {
    let found = model.conditions().iter().position(|condition| condition.of == name);
    found.map(|index| index as u16).ok_or(LinearisationError::NoSuchCoordinate { name })
}

/// The values of all conditions at a position, m and rad: angles in (−π, π], those whose turns are counted with their turns. A component of ω
/// has none; its entry is zero.
pub fn coordinate_values<R: Real, M: Assemble<R>>(model: &M, time: R, q: &M::Q) -> M::Conditions {
    let none = model.zero_conditions();
    let (mut values, mut cosines) = (model.zero_conditions(), model.zero_conditions());
    model.condition_residual(time, q, &none, &mut values);
    model.condition_cosines(time, q, &none, &mut cosines);
    let entries = values.as_mut_slice().iter_mut().zip(cosines.as_slice());
    for ((value, &cosine), condition) in entries.zip(model.conditions()) {
        *value = match condition.kind {
            ConditionKind::Angle => value.atan2(cosine),
            ConditionKind::Linear => *value,
            ConditionKind::Rate => R::ZERO,
        };
    }
    values
}

/// The rates of all conditions at a position and velocities, m/s and rad/s: B v, and more where places move with time.
pub fn coordinate_rates<R: Real, M: Assemble<R>>(model: &M, time: R, q: &M::Q, v: &M::V) -> M::Conditions {
    let (mut jacobian, mut rates) = (model.zero_condition_jacobian(), model.zero_conditions());
    model.condition_jacobian(time, q, &mut jacobian);
    model.condition_drift(time, q, &mut rates);
    rates.plus(R::ONE, &condition_product(model, &jacobian, v.as_slice()))
}

/// The state that has what was read of some coordinates, satisfies the constraints, and is near `near` in the rest:
///
/// ```text
/// Φ(t, q) = 0, s_k(q) = position_k,   D v = ν, ṡ_k = rate_k
/// ```
/// Positions by Newton's iteration from `near` on shortest steps (metres and radians alike), velocities nearest to those of `near` in the norm of M;
/// internal states are those of `near`, gates what they are at that state. Read as many coordinates as there are degrees of freedom, and nothing of `near` is left but which
/// way the mechanism is assembled; read fewer, and the rest stays where it is as far as it can. Read of a coordinate whose turns are counted, a
/// position has its turns. For a state of which everything was measured see [`project`](crate::AssembleExt::project); of more readings than degrees of
/// freedom make an estimate first, as a Kalman filter does.
///
/// # Errors
/// As [`assemble_position`] and [`assemble_velocity`](crate::assemble_velocity): [`RankDeficient`](AssemblyError::RankDeficient) also where
/// readings contradict or repeat one another, and at dead centres of what was read.
pub fn measured<R: Real, M: Assemble<R>>(
    model: &M,
    time: R,
    near: &StateOf<M, R>,
    readings: &[Reading<R>],
) -> Result<StateOf<M, R>, AssemblyError> {
    let (mut positions, mut rates) = (model.zero_conditions(), model.zero_conditions());
    let mut active = model.choice();
    let held = held(model, readings, active.as_mut())?;
    for reading in readings {
        let index = usize::from(reading.coordinate);
        crate::vector::put(positions.as_mut_slice(), index, reading.position);
        crate::vector::put(rates.as_mut_slice(), index, reading.rate);
    }
    let q = assemble_position(model, time, &near.q, &positions, held)?;
    let v = nearest_velocity(model, time, &q, &near.v, &rates, held)?;
    Ok(held_gates(model, time, State { q, v, z: near.z.clone(), gates: near.gates.clone() }))
}

/// The conditions that were read, in the places of `active`, of which there is one for each velocity.
fn held<'a, R: Real, M: Assemble<R>>(
    model: &M,
    readings: &[Reading<R>],
    active: &'a mut [u16],
) -> Result<&'a [u16], AssemblyError> {
    let (needed, given) = (model.freedoms(), readings.len());
    let held = active.get_mut(..given).filter(|_| given <= needed);
    let held = held.ok_or(AssemblyError::WrongLength { needed, given })?;
    for (to, reading) in held.iter_mut().zip(readings) {
        *to = reading.coordinate;
    }
    Ok(held)
}
