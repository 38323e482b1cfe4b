//! Roots and means against published values, closed forms and finer quadrature.

use super::*;

fn near(found: f64, expected: f64, within: f64) {
    assert!((found - expected).abs() <= within, "{found:?} is not {expected:?}");
}

/// Blevins, *Formulas for Natural Frequency and Mode Shape*, table 8-1; more digits by continued fractions.
#[test]
fn roots_have_all_digits() {
    let free =
        [4.730040744862704, 7.853204624095838, 10.995607838001671, 14.137165491257464, 17.278_759_657_399_48];
    let clamped =
        [1.875_104_068_711_961_1, 4.694_091_132_974_175, 7.854_757_438_237_613, 10.995_540_734_875_467];
    for (number, root) in free.into_iter().enumerate() {
        near(roots::free_free(number), root, 4e-15);
    }
    for (number, root) in clamped.into_iter().enumerate() {
        near(roots::clamped_free(number), root, 4e-15);
    }
}

/// ∫₀¹ N = 2 σ/λ of the clamped shape; ∫ ξ N = 2/λ²: Blevins, table 8-1.
#[test]
fn clamped_means_are_closed() {
    let length = 0.7;
    let beam = Slender::new(Shapes::Clamped, length, 2, MOST_MODES);
    for number in 0..MOST_MODES {
        let lambda = roots::clamped_free(number);
        let (sinh, cosh) = (libm::sinh(lambda), libm::cosh(lambda));
        let sigma = (sinh - libm::sin(lambda)) / (cosh + libm::cos(lambda));
        near(beam.first[3 + number], 2.0 * sigma / lambda, 1e-14);
        near(beam.second[0][3 + number], 2.0 * length / (lambda * lambda), 1e-14);
        near(beam.modes[2 + number].shape.at(1.0, 0).abs(), 2.0, 1e-13);
    }
    for axial in 0..2 {
        let lambda = (2.0 * axial as f64 + 1.0) * FRAC_PI_2;
        near(beam.first[1 + axial], 1.0 / lambda, 1e-14);
        near(beam.second[0][1 + axial], length * libm::sin(lambda) / (lambda * lambda), 1e-14);
    }
}

/// ∫ x cos kπξ dx = −2L²/(kπ)² for odd k and 0 for even ones; ∫ cos kπξ N_b only where both have one parity about the middle.
#[test]
fn free_means_are_closed_or_zero() {
    let length = 0.35;
    let beam = Slender::new(Shapes::Free, length, MOST_MODES, MOST_MODES);
    for axial in 0..MOST_MODES {
        let k = axial as f64 + 1.0;
        let expected = if axial % 2 == 0 { -2.0 * length / (k * PI).powi(2) } else { 0.0 };
        near(beam.second[0][1 + axial], expected, 1e-15);
        for bending in 0..MOST_MODES {
            // The first bending shape is even, the first axial one odd.
            let zero = axial % 2 == bending % 2;
            assert_eq!(beam.second[1 + axial][1 + MOST_MODES + bending] == 0.0, zero, "{axial} {bending}");
        }
    }
    assert!(beam.first.iter().all(|mean| *mean == 0.0));
}

/// What theory says of orthogonality holds of the shapes as they are computed, and so do stiffnesses and means.
#[test]
fn shapes_are_orthogonal_in_mass_and_stiffness() {
    for shapes in Shapes::ALL {
        let length = 1.3;
        let beam = Slender::new(shapes, length, MOST_MODES, MOST_MODES);
        let rule = Rule::new(200);
        for (i, one) in beam.modes.iter().enumerate() {
            for (j, other) in beam.modes.iter().enumerate() {
                let mean = |order: usize| -> f64 {
                    let value = |share: f64| one.shape.at(share, order) * other.shape.at(share, order);
                    rule.points().map(|(share, weight)| weight * value(share)).sum()
                };
                near(beam.second[i + 1][j + 1], mean(0), 1e-13);
                if one.way == other.way {
                    let order = if one.way == Way::Axial { 1 } else { 2 };
                    let expected = if i == j { one.stiffness } else { 0.0 };
                    let scale = length.powi(1 - 2 * order);
                    let size = (one.stiffness * other.stiffness).sqrt();
                    near(scale * mean(order as usize), expected, 1e-11 * size);
                }
            }
            let mean: f64 = rule.points().map(|(share, weight)| weight * one.shape.at(share, 0)).sum();
            near(beam.first[i + 1], mean, 1e-14);
            let moment = |share: f64| (beam.from + length * share) * one.shape.at(share, 0);
            let mean: f64 = rule.points().map(|(share, weight)| weight * moment(share)).sum();
            near(beam.second[0][i + 1], mean, 1e-14);
        }
        let square = |share: f64| (beam.from + length * share).powi(2);
        near(beam.second[0][0], rule.points().map(|(share, weight)| weight * square(share)).sum(), 1e-15);
    }
}

/// Displacement and direction of what is held do not move at all.
#[test]
fn what_is_held_stays() {
    let clamped = Slender::new(Shapes::Clamped, 2.0, 3, MOST_MODES);
    assert!(clamped.values(0.0).iter().all(|value| *value == 0.0));
    assert!(clamped.keeps_direction(0.0) && !clamped.keeps_direction(2.0));
    let pinned = Slender::new(Shapes::Pinned, 2.0, 0, MOST_MODES);
    assert!(pinned.values(0.0).iter().chain(&pinned.values(2.0)).all(|value| *value == 0.0));
    assert!(!pinned.keeps_direction(0.0));
}

/// Free bar of steel, 7 mm thick and 350 mm long, Hz.
#[test]
fn frequencies_of_a_free_bar() {
    let (length, diameter, young, density) = (0.35, 7e-3_f64, 207e9, 7801.0);
    let area = PI * diameter.powi(2) / 4.0;
    let (mass, second_moment) = (density * area * length, PI * diameter.powi(4) / 64.0);
    let beam = Slender::new(Shapes::Free, length, 3, 3);
    let rigidity = |mode: usize| young * if mode < 3 { area } else { second_moment };
    let hertz = |mode: usize| beam.square_of_rate(mode, rigidity(mode), mass).sqrt() / (2.0 * PI);
    for (mode, printed) in
        [7358.885, 14717.769, 22076.654, 262.037, 722.314, 1416.024].into_iter().enumerate()
    {
        near(hertz(mode), printed, 5.1e-4);
    }
}
