//! Dense matrices from the sparse ones.

use crate::double_pendulum::DoublePendulum;
use crate::four_bar::FourBar;
use linkwright_runtime::{Mechanism, dense};
use nalgebra::{SMatrix, SVector};

#[test]
fn the_mass_matrix_is_symmetric_and_gives_the_energy() {
    let model = DoublePendulum::<f64>::new();
    let (q, v) = ([0.6, 0.8, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0], [2.0, -3.0]);
    let mass: SMatrix<f64, 2, 2> = dense::mass_matrix(&model, 0.0, &q);
    let rates: SVector<f64, 2> = dense::vector(&v);
    assert_eq!(mass, mass.transpose());
    let energy = 0.5 * (rates.transpose() * mass * rates)[0];
    assert!((energy - model.kinetic_energy(0.0, &q, &v)).abs() < 1e-15);
}

#[test]
fn the_jacobian_stands_where_the_pattern_says() {
    let model = FourBar::new();
    let jacobian: SMatrix<f64, 8, 9> = dense::constraint_jacobian(&model, 0.0, &model.rough([0.9, 0.5, 1.6]));
    assert_eq!(jacobian.iter().filter(|&&entry| entry != 0.0).count(), 24);
    // The first pin's x row: the crank's centre, and its own rotation about the pin.
    assert_eq!((jacobian[(0, 0)], jacobian[(0, 6)]), (-1.0, -0.05 * 0.9_f64.sin()));
}
