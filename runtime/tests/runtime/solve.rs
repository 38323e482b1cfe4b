//! What emitted code would have: tables of a dense elimination and the solution of the equations of motion.

use linkwright_runtime::ldl::Ldl;
use linkwright_runtime::{Assemble, Vector};

/// 0, 1, … as the order of elimination.
pub const fn natural<const N: usize>() -> [u16; N] {
    let mut order = [0; N];
    let mut k = 0;
    while k < N {
        order[k] = k as u16;
        k += 1;
    }
    order
}

/// The starts of the rows of a full lower triangle.
pub const fn full_row_start<const N_PLUS_ONE: usize>() -> [u32; N_PLUS_ONE] {
    let mut start = [0; N_PLUS_ONE];
    let mut k = 1;
    while k < N_PLUS_ONE {
        start[k] = start[k - 1] + (k as u32 - 1);
        k += 1;
    }
    start
}

/// The columns of a full lower triangle.
pub const fn full_columns<const N: usize, const ENTRIES: usize>() -> [u16; ENTRIES] {
    let mut columns = [0; ENTRIES];
    let (mut row, mut at) = (0, 0);
    while row < N {
        let mut column = 0;
        while column < row {
            columns[at] = column as u16;
            at += 1;
            column += 1;
        }
        row += 1;
    }
    columns
}

/// v̇ and λ of M v̇ + Dᵀ λ = Q, D v̇ = γ; the smallest relative pivot.
pub fn equations_of_motion<M: Assemble<f64>>(
    model: &M,
    time: f64,
    q: &M::Q,
    forces: &M::V,
    gamma: &M::Lambda,
    a: &mut M::V,
    lambda: &mut M::Lambda,
) -> f64 {
    let (tables, n, m) = (model.elimination(), model.velocity_count(), model.row_count());
    let mut matrix = Ldl::<f64, M::Factor, M::System>::new(&tables);
    let mut mass = model.zero_mass();
    model.mass_matrix(time, q, &mut mass);
    for (&entry, &(i, j)) in mass.as_slice().iter().zip(model.mass_pattern()) {
        matrix.add(&tables, i as usize, j as usize, entry);
    }
    let mut jacobian = model.zero_jacobian();
    model.constraint_jacobian(time, q, &mut jacobian);
    for (&entry, &(i, j)) in jacobian.as_slice().iter().zip(model.jacobian_pattern()) {
        matrix.add(&tables, n + i as usize, j as usize, entry);
    }
    for i in n + m..tables.order.len() {
        matrix.add(&tables, i, i, -1.0);
    }
    let pivot = matrix.factor(&tables);
    let mut right = model.zero_system();
    let (to_forces, rest) = right.as_mut_slice().split_at_mut(n);
    to_forces.copy_from_slice(forces.as_slice());
    rest[..m].copy_from_slice(gamma.as_slice());
    let solution = matrix.solve(&tables, &right);
    let (accelerations, rest) = solution.as_slice().split_at(n);
    a.as_mut_slice().copy_from_slice(accelerations);
    lambda.as_mut_slice().copy_from_slice(&rest[..m]);
    pivot.value
}

/// γ − 2α(D v − ν) − β² Φ.
pub fn baumgarte<M: Assemble<f64>>(
    model: &M,
    time: f64,
    q: &M::Q,
    v: &M::V,
    two_alpha: f64,
    beta_squared: f64,
) -> M::Lambda {
    let (mut gamma, mut phi, mut nu) = (model.zero_lambda(), model.zero_lambda(), model.zero_lambda());
    let mut jacobian = model.zero_jacobian();
    model.gamma(time, q, v, &mut gamma);
    model.constraints(time, q, &mut phi);
    model.nu(time, q, &mut nu);
    model.constraint_jacobian(time, q, &mut jacobian);
    for (&entry, &(i, j)) in jacobian.as_slice().iter().zip(model.jacobian_pattern()) {
        nu.as_mut_slice()[i as usize] -= entry * v.as_slice()[j as usize];
    }
    gamma.axpy(two_alpha, &nu);
    gamma.axpy(-beta_squared, &phi);
    gamma
}
