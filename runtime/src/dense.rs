//! Dense `nalgebra` matrices from the sparse ones, for sizes where dense makes sense.
//!
//! Only with the feature `nalgebra`. The runtime itself never goes through dense matrices.

use crate::mechanism::Mechanism;
use crate::real::Real;
use crate::vector::Vector;
use nalgebra::{SMatrix, SVector};

/// The symmetric mass matrix M(t, q), N = n_v.
///
/// # Panics
/// If N is another number.
pub fn mass_matrix<R: Real, M: Mechanism<R>, const N: usize>(
    model: &M,
    time: R,
    q: &M::Q,
) -> SMatrix<R, N, N> {
    assert!(N == model.velocity_count(), "N must be the number of velocities");
    let mut entries = model.zero_mass();
    model.mass_matrix(time, q, &mut entries);
    let mut dense = SMatrix::from_element(R::ZERO);
    for (&entry, &(row, column)) in entries.as_slice().iter().zip(model.mass_pattern()) {
        dense[(row as usize, column as usize)] = entry;
        dense[(column as usize, row as usize)] = entry;
    }
    dense
}

/// The constraint Jacobian D(t, q), ROWS = m, COLUMNS = n_v.
///
/// # Panics
/// If the sizes are others.
pub fn constraint_jacobian<R: Real, M: Mechanism<R>, const ROWS: usize, const COLUMNS: usize>(
    model: &M,
    time: R,
    q: &M::Q,
) -> SMatrix<R, ROWS, COLUMNS> {
    assert!(ROWS == model.row_count(), "ROWS must be the number of constraint rows");
    assert!(COLUMNS == model.velocity_count(), "COLUMNS must be the number of velocities");
    let mut entries = model.zero_jacobian();
    model.constraint_jacobian(time, q, &mut entries);
    let mut dense = SMatrix::from_element(R::ZERO);
    for (&entry, &(row, column)) in entries.as_slice().iter().zip(model.jacobian_pattern()) {
        dense[(row as usize, column as usize)] = entry;
    }
    dense
}

/// The entries of a vector of this crate as an `SVector`.
///
/// # Panics
/// If N is not its length.
pub fn vector<R: Real, V: Vector<R>, const N: usize>(entries: &V) -> SVector<R, N> {
    assert!(N == entries.as_slice().len(), "N must be the vector's length");
    SVector::from_fn(|i, _| entries.as_slice()[i])
}
