//! Dense `nalgebra` matrices from the sparse ones, for sizes where dense makes sense.
//!
//! Only with the feature `nalgebra`. The runtime itself never goes through dense matrices.

use crate::mechanism::Mechanism;
use crate::real::Real;
use crate::vector::Vector;
use nalgebra::{SMatrix, SVector};

/// The symmetric mass matrix M(t, q), N = n_v. A wrong N does not compile.
pub fn mass_matrix<R: Real, M: Mechanism<R>, const N: usize>(
    model: &M,
    time: R,
    q: &M::Q,
) -> SMatrix<R, N, N> {
    const { assert!(N == M::V::LEN, "N must be the number of velocities") };
    let mut entries = M::Mass::zero();
    model.mass_matrix(time, q, &mut entries);
    let mut dense = SMatrix::from_element(R::ZERO);
    for (&entry, &(row, column)) in entries.as_slice().iter().zip(M::MASS_PATTERN) {
        dense[(row as usize, column as usize)] = entry;
        dense[(column as usize, row as usize)] = entry;
    }
    dense
}

/// The constraint Jacobian D(t, q), ROWS = m, COLUMNS = n_v. Wrong sizes do not compile.
pub fn constraint_jacobian<R: Real, M: Mechanism<R>, const ROWS: usize, const COLUMNS: usize>(
    model: &M,
    time: R,
    q: &M::Q,
) -> SMatrix<R, ROWS, COLUMNS> {
    const { assert!(ROWS == M::Lambda::LEN, "ROWS must be the number of constraint rows") };
    const { assert!(COLUMNS == M::V::LEN, "COLUMNS must be the number of velocities") };
    let mut entries = M::Jacobian::zero();
    model.constraint_jacobian(time, q, &mut entries);
    let mut dense = SMatrix::from_element(R::ZERO);
    for (&entry, &(row, column)) in entries.as_slice().iter().zip(M::JACOBIAN_PATTERN) {
        dense[(row as usize, column as usize)] = entry;
    }
    dense
}

/// The entries of a vector of this crate as an `SVector`. A wrong N does not compile.
pub fn vector<R: Real, V: Vector<R>, const N: usize>(entries: &V) -> SVector<R, N> {
    const { assert!(N == V::LEN, "N must be the vector's length") };
    SVector::from_fn(|i, _| entries.as_slice()[i])
}
