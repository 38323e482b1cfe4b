//! Roots and means against published values, closed forms and finer quadrature.

mod shear;

use super::*;

fn slender(shapes: Shapes, length: f64, axial: usize, bending: usize) -> Slender {
    Slender::new(shapes, length, Counts { axial, bending, bending_z: 0, torsion: 0, quadratic: false })
}

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
    let beam = slender(Shapes::Clamped, length, 2, MOST_MODES);
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
    let beam = slender(Shapes::Free, length, MOST_MODES, MOST_MODES);
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
        let beam = slender(shapes, length, MOST_MODES, MOST_MODES);
        let rule = Rule::new(200);
        for (i, one) in beam.modes.iter().enumerate() {
            for (j, other) in beam.modes.iter().enumerate() {
                let mean = |order: usize| -> f64 {
                    let value = |share: f64| one.shape.at(share, order) * other.shape.at(share, order);
                    rule.points().map(|(share, weight)| weight * value(share)).sum()
                };
                // Of polynomials the fastest are scaled up from a ten thousandth.
                near(
                    beam.second[i + 1][j + 1],
                    mean(0),
                    if shapes == Shapes::Static { 1e-11 } else { 1e-13 },
                );
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

/// Ends move by whole numbers, and by the same from both ends, so that what one has and the other takes away is nothing.
#[test]
fn ends_are_whole_and_mirrored() {
    for shapes in [Shapes::Free, Shapes::Clamped, Shapes::Pinned] {
        for mode in &slender(shapes, 0.35, MOST_MODES, MOST_MODES).modes {
            for end in [0.0, 1.0] {
                let value = mode.shape.at(end, 0);
                assert!([0.0, 1.0, 2.0].contains(&value.abs()), "{shapes:?} {mode:?}: {value:?}");
            }
            if shapes == Shapes::Free && mode.way == Way::Bending {
                for (order, share) in [(0, 0.0), (1, 0.0), (0, 0.125), (1, 0.25), (2, 0.375), (3, 0.25)] {
                    let [one, other] = [share, 1.0 - share].map(|at| mode.shape.at(at, order).abs());
                    assert_eq!(one, other, "{mode:?}");
                }
            }
        }
    }
}

/// Displacement and direction of what is held do not move at all.
#[test]
fn what_is_held_stays() {
    let clamped = slender(Shapes::Clamped, 2.0, 3, MOST_MODES);
    assert!(clamped.values(0.0).iter().all(|value| *value == 0.0));
    assert!(clamped.keeps_direction(0.0) && !clamped.keeps_direction(2.0));
    let pinned = slender(Shapes::Pinned, 2.0, 0, MOST_MODES);
    assert!(pinned.values(0.0).iter().chain(&pinned.values(2.0)).all(|value| *value == 0.0));
    assert!(!pinned.keeps_direction(0.0));
}

/// Free bar of steel, 7 mm thick and 350 mm long, Hz.
#[test]
fn frequencies_of_a_free_bar() {
    let (length, diameter, young, density) = (0.35, 7e-3_f64, 207e9, 7801.0);
    let area = PI * diameter.powi(2) / 4.0;
    let (mass, second_moment) = (density * area * length, PI * diameter.powi(4) / 64.0);
    let beam = slender(Shapes::Free, length, 3, 3);
    let rigidity = |mode: usize| young * if mode < 3 { area } else { second_moment };
    let hertz = |mode: usize| beam.square_of_rate(mode, rigidity(mode), mass).sqrt() / (2.0 * PI);
    for (mode, printed) in
        [7358.885, 14717.769, 22076.654, 262.037, 722.314, 1416.024].into_iter().enumerate()
    {
        near(hertz(mode), printed, 5.1e-4);
    }
}

/// Γ of a clamped beam at its end is ∫ N_j′ N_k′; its means are those of finer quadrature; ∫ x Γ is the moment of what is drawn in.
#[test]
fn bending_draws_in() {
    let rule = Rule::new(120);
    for shapes in Shapes::ALL {
        let length = 0.7;
        let beam = slender(shapes, length, 1, 4).stiffened();
        assert_eq!(beam.shortenings.len(), 10);
        assert_eq!(beam.first.len(), 16);
        let slope = |mode: usize, share: f64| beam.modes[mode].shape.at(share, 1) / length;
        for (index, it) in beam.shortenings.iter().enumerate() {
            let (j, k) = it.modes;
            assert_eq!(beam.shortening_of(k, j), Some(6 + index));
            let from_start = |share: f64| -> f64 {
                let part = |at: f64| slope(j, share * at) * slope(k, share * at);
                share * length * rule.points().map(|(at, weight)| weight * part(at)).sum::<f64>()
            };
            let size = (from_start(1.0).abs()).max(1.0);
            let mean = |of: &dyn Fn(f64) -> f64| -> f64 {
                rule.points().map(|(share, weight)| weight * of(share)).sum()
            };
            let own_mean = mean(&from_start);
            let offset = if shapes == Shapes::Free { own_mean } else { 0.0 };
            for share in [0.0, 0.3, 0.5, 1.0] {
                let found = beam.shortenings_at(beam.from + share * length)[index];
                near(found, from_start(share) - offset, 1e-12 * size);
            }
            near(beam.first[6 + index], own_mean - offset, 1e-12 * size);
            let function = |which: usize, share: f64| match which {
                0 => beam.from + length * share,
                _ => beam.modes[which - 1].shape.at(share, 0),
            };
            for which in 0..6 {
                let product = mean(&|share| function(which, share) * (from_start(share) - offset));
                near(beam.second[which][6 + index], product, 1e-12 * size);
                assert_eq!(beam.second[6 + index][which], beam.second[which][6 + index]);
            }
            let square = mean(&|share| (from_start(share) - offset).powi(2));
            near(beam.second[6 + index][6 + index], square, 1e-12 * (size + square));
        }
        for (one, other) in [(6, 9), (7, 12), (11, 15)] {
            assert_eq!(beam.second[one][other], beam.second[other][one]);
        }
    }
}

/// Squares of the rates of a clamped beam that turns about its start at λ = Ω √(ρA/EI) L², out of the plane that it turns in: Wright,
/// Smith, Thresher, Wang, J. Appl. Mech. 49, 1982, and collocation by Chebyshev's points. In the plane they are less by λ².
#[test]
fn a_turning_beam_is_stiffer() {
    let beam = slender(Shapes::Clamped, 1.0, 0, MOST_MODES).stiffened();
    for (turned, published) in [
        (0.0, [3.516_015_00, 22.034_491_4]),
        (1.0, [3.681_646_31, 22.181_011_0]),
        (3.0, [4.797_278_34, 23.320_263_5]),
        (6.0, [7.360_372_74, 26.809_081_3]),
        (12.0, [13.170_150_3, 37.603_112_1]),
    ] {
        // det(K + λ² G − ω²) changes its sign within 20 millionths of each.
        let determinant = |omega: f64| {
            let entry = |j: usize, k: usize| {
                let gamma = beam.second[0][beam.shortening_of(j, k).unwrap()];
                let own = if j == k { beam.modes[j].stiffness - omega * omega } else { 0.0 };
                own + turned * turned * gamma
            };
            let mut rows: Vec<Vec<f64>> =
                (0..MOST_MODES).map(|j| (0..MOST_MODES).map(|k| entry(j, k)).collect()).collect();
            let mut product = 1.0;
            for pivot in 0..MOST_MODES {
                let top = rows[pivot].clone();
                product *= top[pivot];
                for row in rows.iter_mut().skip(pivot + 1) {
                    let factor = row[pivot] / top[pivot];
                    row.iter_mut().zip(&top).for_each(|(entry, above)| *entry -= factor * above);
                }
            }
            product
        };
        for omega in published {
            let (below, above) = (determinant(omega * (1.0 - 2e-5)), determinant(omega * (1.0 + 2e-5)));
            assert!(below * above < 0.0, "{turned}: {omega}");
        }
    }
}

/// A thrust on a beam between hinges against K p = P Γ p: Euler's load π² EI/L², and k² times it.
#[test]
fn a_thrust_buckles() {
    let length = 0.7;
    let beam = slender(Shapes::Pinned, length, 0, 5).stiffened();
    let gammas = beam.shortenings_at(length);
    for (it, gamma) in beam.shortenings.iter().zip(gammas) {
        let (j, k) = it.modes;
        if j == k {
            let euler = (PI * (j as f64 + 1.0) / length).powi(2);
            near(beam.modes[j].stiffness / gamma, euler, 1e-12 * euler);
        } else {
            assert_eq!(gamma, 0.0, "{j} {k}");
        }
    }
}

/// At its end a clamped beam of polynomials moves under a force by L³/3EI and turns by L²/2EI, under a moment by L²/2EI and L/EI; it stretches by
/// L/EA; under a load spread evenly it moves by L⁴/8EI with three: what p = Σ N f/k adds up to.
#[test]
fn polynomials_are_exact_under_static_loads() {
    let length = 0.7;
    for count in [2, 3, 6, MOST_MODES] {
        let beam = slender(Shapes::Static, length, count.min(3), count);
        let (values, slopes) = (beam.values(length), beam.slopes(length));
        let modes = || beam.modes.iter().enumerate().filter(|(_, mode)| mode.way == Way::Bending);
        let sum = |load: &[f64], seen: &[f64]| -> f64 {
            modes().map(|(mode, it)| load[mode] * seen[mode] / it.stiffness).sum()
        };
        near(sum(&values, &values), length.powi(3) / 3.0, 1e-13);
        near(sum(&values, &slopes), length.powi(2) / 2.0, 1e-13);
        near(sum(&slopes, &slopes), length, 1e-12);
        if count > 2 {
            let spread: Vec<f64> = beam.first[1..].iter().map(|mean| mean * length).collect();
            near(sum(&spread, &values), length.powi(4) / 8.0, 1e-13);
        }
        let axial = beam.modes.iter().enumerate().filter(|(_, mode)| mode.way == Way::Axial);
        near(axial.map(|(mode, it)| values[mode].powi(2) / it.stiffness).sum(), length, 1e-13);
    }
}

/// By Ritz's method: from above, and the faster the more there are.
#[test]
fn polynomials_find_the_frequencies() {
    for (count, mode, within) in [(2, 0, 5e-3), (3, 0, 3.1e-4), (6, 2, 3e-3), (MOST_MODES, 3, 1e-7)] {
        let beam = slender(Shapes::Static, 1.0, 0, count);
        let (found, exact) = (beam.modes[mode].stiffness, roots::clamped_free(mode).powi(4));
        assert!(
            found > exact * (1.0 - 1e-13) && found < exact * (1.0 + 2.0 * within),
            "{count}: {found} {exact}"
        );
    }
}

/// The element of two quadratic functions that are 1 in the middle and at the end: its stiffness 16/3, −8/3, 7/3 and its mass 8, 1, 2 fifteenths.
#[test]
fn quadratic_is_the_element() {
    let beam = Slender::new(
        Shapes::Pinned,
        1.0,
        Counts { axial: 2, bending: 1, bending_z: 0, torsion: 0, quadratic: true },
    );
    // Rows: u in the middle and at the end of each mode.
    let nodes = [beam.values(0.5), beam.values(1.0)];
    let of = |matrix: [[f64; 2]; 2], j: usize, k: usize| -> f64 {
        let entry = |a: usize, b: usize| matrix[a][b] * nodes[a][j] * nodes[b][k];
        entry(0, 0) + entry(0, 1) + entry(1, 0) + entry(1, 1)
    };
    for j in 0..2 {
        for k in 0..2 {
            let stiffness = of([[16.0 / 3.0, -8.0 / 3.0], [-8.0 / 3.0, 7.0 / 3.0]], j, k);
            near(stiffness, if j == k { beam.modes[j].stiffness } else { 0.0 }, 1e-12);
            near(
                of([[8.0 / 15.0, 1.0 / 15.0], [1.0 / 15.0, 2.0 / 15.0]], j, k),
                beam.second[1 + j][1 + k],
                1e-14,
            );
        }
    }
}

/// What joints hold stays where it is, with its direction where they hold that, and all else moves so many times as far.
#[test]
fn pictures_leave_joints_where_they_are() {
    let beam = std::sync::Arc::new(slender(Shapes::Free, 0.7, 2, 4));
    let modes = [2e-4, -1e-4, 3e-3, 2e-3, -1e-3, 5e-4];
    let held = |share: f64, turns_with: bool| Held { x: (share - 0.5) * 0.7, turns_with };
    for places in [vec![], vec![held(0.0, true)], vec![held(0.0, false), held(1.0, true), held(0.3, false)]] {
        let bow = Bow::new(beam.clone(), &places);
        for Held { x, turns_with } in &places {
            let [one, many] = [1.0, 500.0].map(|times| bow.shown(*x, &modes, times));
            (0..2).for_each(|axis| near(many[axis], one[axis], 1e-12));
            let slope = |times: f64| {
                let [a, b] = [-1e-5, 1e-5].map(|h| bow.shown((x + h).clamp(-0.35, 0.35), &modes, times));
                (b[1] - a[1]) / (b[0] - a[0])
            };
            let turned = (slope(500.0) - slope(1.0)).abs();
            assert_eq!(turned < 0.05, *turns_with, "{turned}");
        }
        let x = 0.7 * 0.17;
        let [one, two, three] = [1.0, 2.0, 3.0].map(|times| bow.shown(x, &modes, times));
        (0..2).for_each(|axis| near(three[axis] - two[axis], two[axis] - one[axis], 1e-15));
        let real = beam.values(x).iter().zip(modes).skip(2).map(|(shape, mode)| shape * mode).sum();
        near(one[1], real, 1e-15);
    }
}

/// A stiffened beam is drawn in as its equations have it.
#[test]
fn pictures_have_what_bending_draws_in() {
    let beam = std::sync::Arc::new(slender(Shapes::Clamped, 2.0, 0, 3).stiffened());
    let bow = Bow::new(beam.clone(), &[Held { x: 0.0, turns_with: true }]);
    let modes = [0.05, -0.02, 0.01];
    let values = beam.shortenings_at(2.0);
    let mut drawn = 0.0;
    for j in 0..3 {
        for k in 0..3 {
            let pair = beam.shortenings.iter().position(|it| it.modes == (j.min(k), j.max(k))).unwrap();
            drawn += 0.5 * values[pair] * modes[j] * modes[k];
        }
    }
    near(bow.shown(2.0, &modes, 1.0)[0], 2.0 - drawn, 1e-15);
    near(bow.deflection(&modes), 2.0 * (0.05 + 0.02 + 0.01) / 2.0, 1e-13);
}

#[test]
fn deflections_are_magnified_by_round_numbers() {
    for (deflection, times) in
        [(0.0, 1.0), (1e-12, 1.0), (0.05, 1.0), (0.03, 2.0), (1e-3, 100.0), (3e-5, 2000.0)]
    {
        near(magnification(deflection), times, 1e-9 * times);
    }
}

/// A shaft's twist has the equation of a bar's stretch: the same shapes, which turn sections and move no place.
#[test]
fn shafts_twist_as_bars_stretch() {
    for shapes in Shapes::ALL {
        let counts = Counts { axial: 3, bending: 1, bending_z: 1, torsion: 3, quadratic: false };
        let beam = Slender::new(shapes, 0.7, counts);
        for x in [beam.from, beam.from + 0.3, beam.from + 0.7] {
            let (values, turns) = (beam.values(x), beam.slopes(x));
            assert_eq!(values[..3], turns[5..], "{shapes:?}");
            assert!(values[5..].iter().chain(&turns[..3]).all(|it| *it == 0.0));
        }
        for k in 0..3 {
            assert_eq!(beam.modes[k].stiffness, beam.modes[5 + k].stiffness);
            assert_eq!(beam.second[1 + k][1 + k], beam.second[6 + k][6 + k]);
            assert_eq!(beam.modes[5 + k].way, Way::Torsion);
        }
        assert_eq!(beam.stays(beam.from), shapes != Shapes::Free && shapes != Shapes::Pinned);
    }
}
