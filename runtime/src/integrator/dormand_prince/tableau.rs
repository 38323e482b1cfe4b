//! The coefficients of Dormand and Prince's method of order 5(4), and of its continuous extension.

use crate::integrator::runge_kutta::Tableau;

/// The weights of the step, which are the last row of a_ij: the seventh stage is the end of the step.
const B: [f64; 7] = [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0, 0.0];

/// Dormand, Prince, *A family of embedded Runge–Kutta formulae*, J. Comput. Appl. Math. 6 (1980) 19–26; Hairer, Nørsett, Wanner,
/// *Solving Ordinary Differential Equations I*, 2nd edition, table II.5.2, as is [`ESTIMATE`].
#[rustfmt::skip]
pub const DORMAND_PRINCE: Tableau<7> = Tableau {
    a: [
        [0.0; 7],
        [1.0 / 5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0, 0.0],
        [19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0, 0.0, 0.0, 0.0],
        [9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0, 0.0, 0.0],
        B,
    ],
    b: B,
    c: [0.0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0, 1.0],
};

/// A step of Euler's method, and a stage at its end.
pub const EULER: Tableau<2> = Tableau { a: [[0.0; 2], [1.0, 0.0]], b: [1.0, 0.0], c: [0.0, 1.0] };

/// b_i − b̂_i, b̂ being the weights of the embedded method of order 4.
pub const ESTIMATE: [f64; 7] =
    [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0];

/// d_i of the last term of the continuous extension of order 4: Hairer, Nørsett, Wanner, II.6, (6.12), with the factor that is
/// linear in θ taken at θ = ½, as in their program DOPRI5.
pub const DENSE: [f64; 7] = [
    -12715105075.0 / 11282082432.0,
    0.0,
    87487479700.0 / 32700410799.0,
    -10690763975.0 / 1880347072.0,
    701980252875.0 / 199316789632.0,
    -1453857185.0 / 822651844.0,
    69997945.0 / 29380423.0,
];

#[cfg(test)]
mod tests {
    use super::*;

    fn moment(weights: &[f64], power: i32) -> f64 {
        weights
            .iter()
            .enumerate()
            .map(|(i, weight)| weight * libm::pow(DORMAND_PRINCE.c[i], power.into()))
            .sum()
    }

    /// Σ b_i c_iᵏ = 1/(k + 1) to order 5, of the embedded weights to order 4.
    #[test]
    fn quadrature_to_the_orders() {
        for power in 0..5 {
            let exact = 1.0 / f64::from(power + 1);
            assert!((moment(&B, power) - exact).abs() < 1e-15, "{power}");
            let estimate = moment(&ESTIMATE, power);
            assert!(if power < 4 { estimate.abs() < 1e-15 } else { estimate.abs() > 1e-4 }, "{estimate}");
        }
    }

    /// The extension is a quadrature to order 4 at every θ; in the form of `dense.rs`, with slopes k_i = c_iᵏ.
    #[test]
    fn the_extension_is_of_order_4() {
        assert!(DENSE.iter().sum::<f64>().abs() < 1e-14);
        for power in 0..4 {
            let total = moment(&B, power);
            let (first, last) = (if power == 0 { 1.0 } else { 0.0 }, 1.0);
            let second = first - total;
            let third = total - last - second;
            let fourth = moment(&DENSE, power);
            for part in [0.1, 0.3, 0.5, 0.8, 1.0] {
                let rest = 1.0 - part;
                let found = part * (total + rest * (second + part * (third + rest * fourth)));
                let exact = libm::pow(part, f64::from(power + 1)) / f64::from(power + 1);
                assert!((found - exact).abs() < 1e-14, "{power} {part}: {found} {exact}");
            }
        }
    }
}
