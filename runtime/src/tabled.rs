//! K(c) = \[M, Dᵀ; D, −c\] by tables: the factorisation of mechanisms that do not write their own out.
//!
//! A mechanism whose definition asks for it (`options { emit = … }`) has `system`, `factor` and `solve` as straight-line
//! code; for all others the emitted functions call these, which loop over the elimination of [`Assemble::elimination`]. Both
//! solve the same system; with this one a step under the penalty takes five times as long.

use crate::ldl::Ldl;
use crate::mechanism::Assemble;
use crate::real::Real;
use crate::vector::{Vector, at, put};

/// The values that [`factor`] leaves for [`solve`].
#[derive(Clone, Copy, Debug)]
pub struct Tabled<R, F, S, J> {
    ldl: Ldl<R, F, S>,
    /// D, for rows that hold velocities without mass.
    jacobian: J,
    compliance: R,
}

/// The store of a mechanism without a factorisation of its own.
pub type Store<R, M> =
    Tabled<R, <M as Assemble<R>>::Factor, <M as Assemble<R>>::System, <M as crate::Mechanism<R>>::Jacobian>;

/// An empty store.
pub fn store<R: Real, M: Assemble<R>>(model: &M) -> Store<R, M> {
    Tabled { ldl: Ldl::new(&model.elimination()), jacobian: model.zero_jacobian(), compliance: R::ZERO }
}

/// Factors K(c); returns what [`Assemble::factor`] does.
///
/// Where M alone is singular, ρ′ Dᵀ D of the rows that hold the massless velocities is added, ρ′ = ρ/(1 + ρ c), and c of
/// these rows becomes c (1 + ρ c): with ρ′ Dᵀ γ added to Q and λ of these rows multiplied by 1 + ρ c the solution is the
/// same, because D v̇ = γ + c λ.
pub fn factor<R: Real, M: Assemble<R>>(
    model: &M,
    time: R,
    q: &M::Q,
    compliance: R,
    store: &mut Store<R, M>,
) -> R {
    fill(model, time, q, compliance, store);
    let mut magnitudes = model.zero_system();
    let velocities = store.ldl.factor_measured(&model.elimination(), model.velocity_count(), &mut magnitudes);
    let velocities = if model.massless_rows().is_empty() { R::ONE } else { velocities.value };
    let mut smallest = velocities;
    each_row(model, store, |_, relative| smallest = relative.min(smallest));
    smallest
}

/// K(c) in numbers.
fn fill<R: Real, M: Assemble<R>>(model: &M, time: R, q: &M::Q, compliance: R, store: &mut Store<R, M>) {
    let (n, m) = (model.velocity_count(), model.row_count());
    let mut mass = model.zero_mass();
    model.mass_matrix(time, q, &mut mass);
    model.constraint_jacobian(time, q, &mut store.jacobian);
    store.compliance = compliance;
    let idle = |row: u16| model.idle().contains(&row);
    let (matrix, tables) = (&mut store.ldl, model.elimination());
    matrix.clear();
    for (&entry, &(i, j)) in mass.as_slice().iter().zip(model.mass_pattern()) {
        matrix.add(&tables, i as usize, j as usize, entry);
    }
    let entries = || store.jacobian.as_slice().iter().zip(model.jacobian_pattern());
    for (&entry, &(row, column)) in entries().filter(|(_, (row, _))| !idle(*row)) {
        matrix.add(&tables, n + row as usize, column as usize, entry);
    }
    for (held, rho) in massless(model) {
        let weight = rho / (R::ONE + rho * compliance);
        for (&a, &(_, i)) in entries().filter(|(_, (row, _))| *row == held) {
            for (&b, &(_, j)) in entries().filter(|(_, (row, j))| *row == held && *j <= i) {
                matrix.add(&tables, i as usize, j as usize, weight * a * b);
            }
        }
    }
    for row in 0..m as u16 {
        let own = if idle(row) { R::ONE } else { softness(model, row, compliance) };
        matrix.add(&tables, n + row as usize, n + row as usize, -own);
    }
    // Conditions take no part.
    for condition in n + m..model.elimination().order.len() {
        matrix.add(&tables, condition, condition, -R::ONE);
    }
}

/// c of a row.
fn softness<R: Real, M: Assemble<R>>(model: &M, row: u16, compliance: R) -> R {
    compliance * (R::ONE + rho(model, row) * compliance)
}

/// The rows that hold massless velocities, each with its ρ.
fn massless<R: Real, M: Assemble<R>>(model: &M) -> impl Iterator<Item = (u16, R)> + use<'_, R, M> {
    model.massless_rows().iter().zip(model.massless_weights()).map(|(&row, &rho)| (row, R::from_f64(rho)))
}

/// ρ of a row; zero of those that hold no massless velocity.
fn rho<R: Real, M: Assemble<R>>(model: &M, row: u16) -> R {
    massless(model).find(|(held, _)| *held == row).map_or(R::ZERO, |(_, rho)| rho)
}

/// The row with the smallest relative pivot of D M⁻¹ Dᵀ; `None` without rows.
pub(crate) fn weakest_row<R: Real, M: Assemble<R>>(model: &M, time: R, q: &M::Q) -> Option<usize> {
    let mut store = store(model);
    fill(model, time, q, R::ZERO, &mut store);
    let mut magnitudes = model.zero_system();
    store.ldl.factor_measured(&model.elimination(), model.velocity_count(), &mut magnitudes);
    let mut weakest: Option<(usize, R)> = None;
    each_row(model, &store, |row, relative| {
        // Written so that a NaN is the weakest.
        if weakest.is_none_or(|(_, least)| !R::any(relative.greater_equal(least))) {
            weakest = Some((row, relative));
        }
    });
    weakest.map(|(row, _)| row)
}

/// Shows the pivot of each row relative to its size along the motion.
fn each_row<R: Real, M: Assemble<R>>(model: &M, store: &Store<R, M>, mut show: impl FnMut(usize, R)) {
    let mut scales = model.zero_lambda();
    model.row_scales(&mut scales);
    let (pivots, positions) =
        (store.ldl.pivots(), model.elimination().position.iter().skip(model.velocity_count()));
    for (row, (&scale, &position)) in scales.as_slice().iter().zip(positions).enumerate() {
        let idle = model.idle().contains(&(row as u16));
        if let Some(pivot) = pivots.get(position as usize).filter(|_| !idle) {
            show(row, pivot.abs() / scale);
        }
    }
}

/// a and λ of K(c) (a, λ) = (`forces`, `rows`).
pub fn solve<R: Real, M: Assemble<R>>(
    model: &M,
    store: &Store<R, M>,
    forces: &M::V,
    rows: &M::Lambda,
    a: &mut M::V,
    lambda: &mut M::Lambda,
) {
    let n = model.velocity_count();
    let mut right = model.zero_system();
    let entries = right.as_mut_slice();
    let given = forces.as_slice().iter().chain(rows.as_slice());
    for (entry, &value) in entries.iter_mut().zip(given) {
        *entry = value;
    }
    for &row in model.idle() {
        put(entries, n + row as usize, R::ZERO);
    }
    for (&entry, &(row, column)) in store.jacobian.as_slice().iter().zip(model.jacobian_pattern()) {
        let rho = rho(model, row);
        if rho > R::ZERO {
            let weight = rho / (R::ONE + rho * store.compliance);
            let force = at(entries, column as usize) + weight * entry * at(rows.as_slice(), row as usize);
            put(entries, column as usize, force);
        }
    }
    let solution = store.ldl.solve(&model.elimination(), &right);
    let found = a.as_mut_slice().iter_mut().chain(lambda.as_mut_slice());
    for (entry, &value) in found.zip(solution.as_slice()) {
        *entry = value;
    }
    for (row, rho) in massless(model) {
        let stiffened = at(lambda.as_slice(), row as usize) * (R::ONE + rho * store.compliance);
        put(lambda.as_mut_slice(), row as usize, stiffened);
    }
}
