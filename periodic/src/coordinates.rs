//! States as numbers x = (s, ṡ, z), in as many coordinates as there are degrees of freedom, and back.

use crate::cycle::Cycle;
use crate::error::PeriodicError;
use core::f64::consts::TAU;
use linkwright::{
    ConditionKind, Reading, State, StateOf, Tangent, Vector, coordinate_rates, coordinate_values, measured,
    retract,
};
use nalgebra::{DMatrix, DVector};

/// n_x = 2f + n_z.
pub(crate) fn size<M: Tangent<f64>>(model: &M) -> usize {
    2 * model.states().len() + model.internal_count()
}

/// x of a state.
pub(crate) fn numbers<M: Tangent<f64>>(model: &M, time: f64, state: &StateOf<M>) -> DVector<f64> {
    let values = coordinate_values(model, time, &state.q);
    let rates = coordinate_rates(model, time, &state.q, &state.v);
    let chosen = |of: &M::Conditions| {
        let of = of.as_slice().to_vec();
        model.states().iter().map(move |&index| of[usize::from(index)])
    };
    let all: Vec<f64> =
        chosen(&values).chain(chosen(&rates)).chain(state.z.as_slice().iter().copied()).collect();
    DVector::from_vec(all)
}

/// The state with these x, assembled as `near` is.
pub(crate) fn state<M: Tangent<f64>>(
    model: &M,
    time: f64,
    near: &StateOf<M>,
    x: &DVector<f64>,
) -> Result<StateOf<M>, PeriodicError> {
    let count = model.states().len();
    let readings: Vec<Reading> = (model.states().iter().enumerate())
        .map(|(at, &coordinate)| Reading { coordinate, position: x[at], rate: x[count + at] })
        .collect();
    let State { q, v, gates, .. } =
        measured(model, time, near, &readings).map_err(PeriodicError::Assembly)?;
    let mut z = model.zero_z();
    z.as_mut_slice().copy_from_slice(&x.as_slice()[2 * count..]);
    Ok(polished(model, time, State { q, v, z, gates }, x))
}

/// The state to the last digit of x: assembly ends where roundings of the largest coordinate do, and a swing may be a millionth of that.
///
/// ```text
/// [D; B] δq = (0, δs),   [D; B] δv = (0, δṡ)
/// ```
fn polished<M: Tangent<f64>>(model: &M, time: f64, state: StateOf<M>, x: &DVector<f64>) -> StateOf<M> {
    let (rows, count) = (model.row_count(), model.states().len());
    let (mut d, mut b) = (model.zero_jacobian(), model.zero_condition_jacobian());
    model.constraint_jacobian(time, &state.q, &mut d);
    model.condition_jacobian(time, &state.q, &mut b);
    let mut stacked = DMatrix::zeros(rows + count, model.velocity_count());
    for (&entry, &(row, column)) in d.as_slice().iter().zip(model.jacobian_pattern()) {
        stacked[(usize::from(row), usize::from(column))] += entry;
    }
    for (&entry, &(row, column)) in b.as_slice().iter().zip(model.condition_pattern()) {
        for at in (0..count).filter(|&at| model.states()[at] == row) {
            stacked[(rows + at, usize::from(column))] += entry;
        }
    }
    let inverse = stacked.svd(true, true);
    let moved = |from: &DVector<f64>, first: usize| {
        let mut right = DVector::zeros(rows + count);
        right.rows_mut(rows, count).copy_from(&from.rows(first, count));
        let mut moved = model.zero_v();
        let solved = inverse.solve(&right, 1e-12).unwrap_or_else(|_| DVector::zeros(model.velocity_count()));
        moved.as_mut_slice().copy_from_slice(solved.as_slice());
        moved
    };
    let off = wrapped(model, x - numbers(model, time, &state));
    let mut next = state.clone();
    retract(model.layout(), &state.q, &moved(&off, 0), &mut next.q);
    let off = x - numbers(model, time, &next);
    next.v = next.v.plus(1.0, &moved(&off, count));
    next
}

/// a − b − what the motion goes on by in a share of the period, angles on the shorter way.
pub(crate) fn difference<M: Tangent<f64>>(
    cycle: &Cycle<'_, M>,
    model: &M,
    [a, b]: [&DVector<f64>; 2],
    share: f64,
) -> DVector<f64> {
    let mut difference = a - b;
    for (at, &index) in model.states().iter().enumerate() {
        let condition = model.conditions()[usize::from(index)];
        for (_, advance) in cycle.turns.iter().filter(|(name, _)| *name == condition.of) {
            difference[at] -= share * advance;
        }
    }
    wrapped(model, difference)
}

/// The mean rates of what goes on, in the places of x.
pub(crate) fn evenly<M: Tangent<f64>>(cycle: &Cycle<'_, M>, model: &M, period: f64) -> DVector<f64> {
    let mut rates = DVector::zeros(size(model));
    for (at, &index) in model.states().iter().enumerate() {
        let name = model.conditions()[usize::from(index)].of;
        let advance = cycle.turns.iter().filter(|(turn, _)| *turn == name).map(|(_, advance)| advance);
        rates[model.states().len() + at] = advance.sum::<f64>() / period;
    }
    rates
}

/// Differences of x with angles on the shorter way.
fn wrapped<M: Tangent<f64>>(model: &M, mut difference: DVector<f64>) -> DVector<f64> {
    for (at, &index) in model.states().iter().enumerate() {
        if model.conditions()[usize::from(index)].kind == ConditionKind::Angle {
            difference[at] -= TAU * (difference[at] / TAU).round();
        }
    }
    difference
}

/// B δv of the coordinates: how their second derivatives differ with the accelerations.
pub(crate) fn seen<M: Tangent<f64>>(model: &M, time: f64, q: &M::Q, delta: &M::V) -> Vec<f64> {
    let mut jacobian = model.zero_condition_jacobian();
    model.condition_jacobian(time, q, &mut jacobian);
    let mut all = vec![0.0; model.conditions().len()];
    for (&entry, &(row, column)) in jacobian.as_slice().iter().zip(model.condition_pattern()) {
        all[usize::from(row)] += entry * delta.as_slice()[usize::from(column)];
    }
    model.states().iter().map(|&index| all[usize::from(index)]).collect()
}
