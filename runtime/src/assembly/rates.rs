//! Velocities and accelerations that satisfy the constraints: one linear system each.
//!
//! Many rates may satisfy the rows; those of least kinetic energy are taken (Gauss's principle for corrections). The
//! position must already be consistent (`position.rs`); the linear algebra is `system.rs`, whether what is held determines the
//! motion `determinacy.rs`.

use super::determinacy::check_determined;
use super::given::{given_finite, given_targets, given_time};
use super::system::System;
use crate::error::AssemblyError;
use crate::mechanism::Assemble;
use crate::real::Real;
use crate::vector::Vector;

/// The velocities of least kinetic energy that satisfy the constraints and have the `rates` of the conditions
/// `active`: \[M, D̂ᵀ; D̂, 0\] (v, μ) = (−b, ν̂), where T = ½ vᵀ M v + bᵀ v + c and b ≠ 0 only if places move with time. Where massless bodies leave M singular, a tiny multiple of its largest
/// diagonal entry is added to the diagonal.
///
/// Where velocities other than zero are asked for by `active` near a singular position of these and the constraints, less than half
/// of their digits would mean anything: that is [`RankDeficient`](AssemblyError::RankDeficient) too.
///
/// # Errors
/// [`RankDeficient`](AssemblyError::RankDeficient), [`GivenNotFinite`](AssemblyError::GivenNotFinite),
/// [`NonFinite`](AssemblyError::NonFinite), [`NoSuchCondition`](AssemblyError::NoSuchCondition).
pub fn assemble_velocity<R: Real, M: Assemble<R>>(
    model: &M,
    time: R,
    q: &M::Q,
    rates: &M::Conditions,
    active: &[u16],
) -> Result<M::V, AssemblyError> {
    let v = held_velocity(model, time, q, rates, active)?;
    check_determined(model, time, q, active, v.max_abs())?;
    Ok(v)
}

/// [`assemble_velocity`] and [`assemble_acceleration`] at one position, which is judged once.
pub(super) fn assemble_rates<R: Real, M: Assemble<R>>(
    model: &M,
    time: R,
    q: &M::Q,
    rates: &M::Conditions,
    accelerations: &M::Conditions,
    active: &[u16],
) -> Result<(M::V, M::V), AssemblyError> {
    let v = held_velocity(model, time, q, rates, active)?;
    let a = held_acceleration(model, time, q, &v, accelerations, active)?;
    check_determined(model, time, q, active, v.max_abs() + a.max_abs())?;
    Ok((v, a))
}

fn held_velocity<R: Real, M: Assemble<R>>(
    model: &M,
    time: R,
    q: &M::Q,
    rates: &M::Conditions,
    active: &[u16],
) -> Result<M::V, AssemblyError> {
    check_position(model, time, q)?;
    given_targets(model, rates, active)?;
    let momentum = carried_momentum(model, time, q);
    let mut system = System::new(model, active)?;
    let (nu, targets) = asked(model, time, q, rates);
    correct(&mut system, time, q, &model.zero_v(), &nu, &targets, &momentum)
}

/// b of the kinetic energy ½ vᵀ M v + bᵀ v + c: places that move with time carry bodies along. From T itself, which is
/// quadratic: b_k = T(e_k) − T(0) − ½ M_kk.
fn carried_momentum<R: Real, M: Assemble<R>>(model: &M, time: R, q: &M::Q) -> M::V {
    let mut momentum = model.zero_v();
    let at_rest = model.kinetic_energy(time, q, &momentum);
    if at_rest == R::ZERO {
        return momentum;
    }
    let mut mass = model.zero_mass();
    model.mass_matrix(time, q, &mut mass);
    let half = R::from_f64(0.5);
    for k in 0..model.velocity_count() {
        let mut unit = model.zero_v();
        unit.as_mut_slice()[k] = R::ONE;
        momentum.as_mut_slice()[k] = model.kinetic_energy(time, q, &unit) - at_rest;
    }
    for (&entry, &(i, j)) in mass.as_slice().iter().zip(model.mass_pattern()) {
        if i == j {
            let own = &mut momentum.as_mut_slice()[i as usize];
            *own = *own - half * entry;
        }
    }
    momentum
}

/// The velocities nearest to `v` in the norm of M that satisfy the constraints.
///
/// # Errors
/// As [`assemble_velocity`].
pub fn project_velocity<R: Real, M: Assemble<R>>(
    model: &M,
    time: R,
    q: &M::Q,
    v: &M::V,
) -> Result<M::V, AssemblyError> {
    check_position(model, time, q)?;
    given_finite(v, model.velocity_names(), model.name())?;
    correct_velocity(model, time, q, v, &model.zero_conditions(), &[])
}

/// The same among those that have the `rates` of the conditions `active`, which must determine them.
pub(crate) fn nearest_velocity<R: Real, M: Assemble<R>>(
    model: &M,
    time: R,
    q: &M::Q,
    v: &M::V,
    rates: &M::Conditions,
    active: &[u16],
) -> Result<M::V, AssemblyError> {
    check_position(model, time, q)?;
    given_finite(v, model.velocity_names(), model.name())?;
    given_targets(model, rates, active)?;
    let found = correct_velocity(model, time, q, v, rates, active)?;
    check_determined(model, time, q, active, found.max_abs())?;
    Ok(found)
}

fn check_position<R: Real, M: Assemble<R>>(model: &M, time: R, q: &M::Q) -> Result<(), AssemblyError> {
    given_time(time)?;
    given_finite(q, model.position_names(), model.name())
}

/// The accelerations of least ½ aᵀ M a that satisfy the constraints and give the coordinates of the conditions
/// `active` the second derivatives `accelerations`: D̂ v̇ = (γ, target − bias).
///
/// # Errors
/// As [`assemble_velocity`].
pub fn assemble_acceleration<R: Real, M: Assemble<R>>(
    model: &M,
    time: R,
    q: &M::Q,
    v: &M::V,
    accelerations: &M::Conditions,
    active: &[u16],
) -> Result<M::V, AssemblyError> {
    let a = held_acceleration(model, time, q, v, accelerations, active)?;
    check_determined(model, time, q, active, a.max_abs())?;
    Ok(a)
}

fn held_acceleration<R: Real, M: Assemble<R>>(
    model: &M,
    time: R,
    q: &M::Q,
    v: &M::V,
    accelerations: &M::Conditions,
    active: &[u16],
) -> Result<M::V, AssemblyError> {
    check_position(model, time, q)?;
    given_finite(v, model.velocity_names(), model.name())?;
    given_targets(model, accelerations, active)?;
    let mut system = System::new(model, active)?;
    let mut gamma = model.zero_lambda();
    model.gamma(time, q, v, &mut gamma);
    let mut bias = model.zero_conditions();
    model.condition_bias(time, q, v, &mut bias);
    let targets = accelerations.plus(-R::ONE, &bias);
    correct(&mut system, time, q, &model.zero_v(), &gamma, &targets, &model.zero_v())
}

fn correct_velocity<R: Real, M: Assemble<R>>(
    model: &M,
    time: R,
    q: &M::Q,
    v: &M::V,
    rates: &M::Conditions,
    active: &[u16],
) -> Result<M::V, AssemblyError> {
    let mut system = System::new(model, active)?;
    let (nu, targets) = asked(model, time, q, rates);
    correct(&mut system, time, q, v, &nu, &targets, &model.zero_v())
}

/// ν̂: of the rows, and of conditions whose coordinates have these rates.
fn asked<R: Real, M: Assemble<R>>(
    model: &M,
    time: R,
    q: &M::Q,
    rates: &M::Conditions,
) -> (M::Lambda, M::Conditions) {
    let mut nu = model.zero_lambda();
    model.nu(time, q, &mut nu);
    let mut drift = model.zero_conditions();
    model.condition_drift(time, q, &mut drift);
    (nu, rates.plus(-R::ONE, &drift))
}

/// x + the least correction with D̂ x = (`rows`, `conditions`). The second round removes what rounding, or a shifted
/// mass matrix, left in the rows.
fn correct<R: Real, M: Assemble<R>>(
    system: &mut System<'_, R, M>,
    time: R,
    q: &M::Q,
    x: &M::V,
    rows: &M::Lambda,
    conditions: &M::Conditions,
    momentum: &M::V,
) -> Result<M::V, AssemblyError> {
    let model = system.model;
    system.evaluate(time, q, None);
    system.factor_mass_or_shifted(time, q)?;
    let mut x = x.clone();
    let mut force = momentum.scaled(-R::ONE);
    for _ in 0..2 {
        let (rows, conditions) = system.remaining(rows, conditions, &x);
        x.axpy(R::ONE, &system.least(&force, &rows, &conditions));
        // The second round only corrects what rounding left of the rows.
        force.as_mut_slice().fill(R::ZERO);
    }
    match x.first_not_finite() {
        Some(unknown) => Err(AssemblyError::NonFinite { row: super::system::name_unknown(model, unknown) }),
        None => Ok(x),
    }
}
