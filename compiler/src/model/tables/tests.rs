//! Reference values, computed with the splines of SciPy 1.16 (`CubicSpline`, `Akima1DInterpolator`, `PchipInterpolator`); Steffen's by
//! his equations in Python.

use super::pieces;
use super::{Curve, Interpolation, Outside};
use crate::symbolic::{AXIS, Orders, PIECES, Table};
use std::sync::Arc;

const X: [f64; 9] = [-0.5, -0.3, -0.1, 0.0, 0.05, 0.2, 0.25, 0.6, 1.0];
const Y: [f64; 9] = [-900.0, -700.0, -250.0, 0.0, 0.0, 400.0, 420.0, 900.0, 2500.0];

fn line(x: &[f64], y: &[f64], kind: Interpolation, outside: Outside) -> Curve {
    let rows = pieces::of_line(x, y, kind, outside);
    let period = (kind == Interpolation::Periodic).then(|| [x[0], x[x.len() - 1] - x[0]]);
    Curve::Line { pieces: Arc::new(Table::new("t", PIECES, rows)), period }
}

fn at(curve: &Curve, order: u8, x: f64) -> f64 {
    curve.at(Orders::new(order, 0), &[x])
}

#[track_caller]
fn close(found: f64, expected: f64) {
    assert!(
        (found - expected).abs() <= 1e-12 * expected.abs().max(1.0),
        "{found:?} in place of {expected:?}"
    );
}

#[test]
fn values_and_slopes_of_splines() {
    for (kind, expected) in [
        (Interpolation::Linear, [0.0, 0.0, 1700.0, 4000.0]),
        (
            Interpolation::Cubic,
            [0.516_864_655_877_994_1, -265.504_227_892_321_3, 1_570.304_283_074_195_2, 4_019.081_380_481_22],
        ),
        (
            Interpolation::Natural,
            [0.516_462_847_498_303_3, -265.322_404_988_503_4, 1_611.850_285_828_795, 4_146.916_190_285_342],
        ),
        (
            Interpolation::Akima,
            [9.743_856_143_856_144, -721.838_161_838_162, 1_538.321_995_464_852_8, 4_151.247_165_532_881],
        ),
        (
            Interpolation::ModifiedAkima,
            [4.510_308_634_262_156, -604.973_135_074_347, 1_549.510_605_592_993_7, 4_312.775_851_788_374],
        ),
        (Interpolation::Pchip, [0.0, 0.0, 1_530.933_760_969_308_7, 4_144.378_814_201_078]),
        (Interpolation::Monotone, [0.0, 0.0, 1_559.809_523_809_524, 4000.0]),
    ] {
        let curve = line(&X, &Y, kind, Outside::Linear);
        let found = [at(&curve, 0, 0.02), at(&curve, 1, 0.02), at(&curve, 0, 0.8), at(&curve, 1, 0.8)];
        for (found, expected) in found.into_iter().zip(expected) {
            assert!(
                (found - expected).abs() <= 1e-12 * expected.abs().max(1.0),
                "{kind:?}: {found:?} {expected:?}"
            );
        }
    }
}

#[test]
fn every_kind_goes_through_its_knots_with_one_slope() {
    for kind in Interpolation::ALL.into_iter().filter(|kind| kind.arguments() == 1) {
        let mut y = Y;
        if kind == Interpolation::Periodic {
            y[8] = y[0];
        }
        let curve = line(&X, &y, kind, Outside::Linear);
        for (index, (x, y)) in X.iter().zip(&y).enumerate() {
            if kind != Interpolation::Periodic || index < 8 {
                assert_eq!(at(&curve, 0, *x), *y, "{kind:?}");
            }
            for order in 1..=kind.smoothness() as u8 {
                let inner = (1..8).contains(&index) || kind == Interpolation::Periodic;
                if order == 1 || inner {
                    let [before, behind] = [x - 1e-9, x + 1e-9].map(|x| at(&curve, order, x));
                    assert!((before - behind).abs() <= 1e-2, "{kind:?}, order {order}: {before} {behind}");
                }
            }
        }
    }
}

#[test]
fn outside() {
    let curve = |outside| line(&X, &Y, Interpolation::Natural, outside);
    let (on, held) = (curve(Outside::Linear), curve(Outside::Hold));
    close(at(&on, 0, 1.5), 2500.0 + 0.5 * at(&on, 1, 1.0));
    close(at(&on, 0, -1.5), -900.0 - at(&on, 1, -0.5));
    assert_eq!([at(&held, 0, 1.5), at(&held, 1, 1.5), at(&held, 0, -7.0)], [2500.0, 0.0, -900.0]);
}

#[test]
fn few_knots() {
    for kind in
        [Interpolation::Akima, Interpolation::ModifiedAkima, Interpolation::Monotone, Interpolation::Pchip]
    {
        let curve = line(&[1.0, 3.0], &[2.0, 8.0], kind, Outside::Linear);
        assert_eq!(
            [at(&curve, 0, 2.0), at(&curve, 1, 2.0), at(&curve, 0, 5.0)],
            [5.0, 3.0, 14.0],
            "{kind:?}"
        );
    }
    let parabola = line(&[0.0, 1.0, 2.0, 4.0], &[0.0, 1.0, 4.0, 16.0], Interpolation::Cubic, Outside::Linear);
    close(at(&parabola, 0, 3.0), 9.0);
    close(at(&parabola, 2, 1.5), 2.0);
}

/// A cosine by 13, 4 and 3 knots and one: period 2, and what is equal at all knots.
#[test]
fn periods() {
    let knots = |n: usize| (0..n).map(move |k| 2.0 * k as f64 / (n - 1) as f64);
    let curve = |n: usize| {
        let x: Vec<f64> = knots(n).collect();
        let mut y: Vec<f64> = x.iter().map(|x| libm::cos(std::f64::consts::PI * x)).collect();
        y[n - 1] = y[0];
        line(&x, &y, Interpolation::Periodic, Outside::Linear)
    };
    let fine = curve(13);
    for x in [0.1, 0.5, 1.3, 1.99] {
        close(at(&fine, 0, x + 14.0), at(&fine, 0, x));
        close(at(&fine, 1, x - 6.0), at(&fine, 1, x));
        assert!((at(&fine, 0, x) - libm::cos(std::f64::consts::PI * x)).abs() < 2e-4);
    }
    let [before, behind] = [1.999_999_999, 2.000_000_001].map(|x| at(&fine, 2, x));
    assert!((before - behind).abs() < 1e-6, "{before} {behind}");
    // 1, −1, 1: of slope zero at both, a cubic between.
    let coarse = curve(3);
    close(at(&coarse, 0, 0.5), 0.0);
    close(at(&coarse, 1, 0.5), -3.0);
    close(at(&coarse, 1, 1.0), 0.0);
    let four = curve(4);
    close(at(&four, 0, 2.0 / 3.0), -0.5);
    close(at(&four, 2, 0.0), at(&four, 2, 2.0 - 1e-15));
    assert_eq!(at(&line(&[0.0, 1.0], &[3.0, 3.0], Interpolation::Periodic, Outside::Linear), 0, 7.3), 3.0);
}

/// The lift of a cam: 8 mm, polynomial 3-4-5, 0–120° up, to 180° at rest, to 300° down, in steps of 10° rounded to 1 µm.
#[test]
fn a_cam() {
    let rise = |p: f64| 10.0 * p.powi(3) - 15.0 * p.powi(4) + 6.0 * p.powi(5);
    let lift = |angle: f64| match angle {
        _ if angle <= 120.0 => rise(angle / 120.0),
        _ if angle <= 180.0 => 1.0,
        _ if angle <= 300.0 => 1.0 - rise((angle - 180.0) / 120.0),
        _ => 0.0,
    };
    let x: Vec<f64> = (0..=36).map(|k| f64::from(10 * k).to_radians()).collect();
    let y: Vec<f64> = (0..=36).map(|k| (8000.0 * lift(f64::from(10 * k))).round() / 1e6).collect();
    let cam = line(&x, &y, Interpolation::Periodic, Outside::Linear);
    for (angle, expected) in [
        (25.0, [5.163_118_787_913e-4, 3.116_271_481_205e-3, 1.042_307_330_591e-2]),
        (200.0, [7.716e-3, -2.208_543_517_3e-3, -1.038_051_920_52e-2]),
    ] {
        for (order, expected) in expected.into_iter().enumerate() {
            let found = at(&cam, order as u8, f64::to_radians(angle));
            assert!((found - expected).abs() <= 1e-11 * expected.abs(), "{angle}°, order {order}: {found:e}");
        }
    }
}

#[test]
fn bilinear() {
    let (x, y) = ([0.0, 1.0, 2.0, 4.0], [0.0, 0.5, 2.0]);
    // By rows of y.
    let z = [vec![0.0, 2.0, 3.0, 8.0], vec![1.0, 2.5, 5.0, 9.0], vec![3.0, 6.0, 7.0, 12.0]];
    let grid = |outside| {
        let axes = [&x[..], &y[..]].map(|knots| Arc::new(Table::new("a", AXIS, pieces::of_axis(knots))));
        let (width, rows) = pieces::of_grid(&x, &y, &z, Interpolation::Bilinear, outside);
        let patches = Arc::new(Table::new("g", width, rows));
        Curve::Grid { axes, patches }
    };
    let (on, held) = (grid(Outside::Linear), grid(Outside::Hold));
    let at = |grid: &Curve, first, second, x, y| grid.at(Orders::new(first, second), &[x, y]);
    for (place, expected) in [
        ([0.5, 0.25], 1.375),
        ([1.5, 1.0], 4.666_666_666_666_667),
        ([3.0, 0.4], 6.7),
        ([3.9, 1.9], 11.553_333_333_333_33),
    ] {
        close(at(&on, 0, 0, place[0], place[1]), expected);
        close(at(&held, 0, 0, place[0], place[1]), expected);
    }
    // Outside, with the slopes at the border or without.
    close(at(&on, 0, 0, -1.0, 0.0), -2.0);
    close(at(&on, 0, 0, 6.0, 2.0), 17.0);
    close(at(&on, 0, 0, 5.0, 3.0), 14.5 + 2.0 + 1.0 / 3.0);
    close(at(&held, 0, 0, 6.0, 2.5), 12.0);
    close(at(&held, 0, 0, -3.0, 0.25), 0.5);
    close(at(&held, 0, 1, -3.0, 0.25), 2.0);
    close(at(&on, 1, 0, 0.5, 0.25), 1.75);
    close(at(&on, 1, 1, 0.5, 0.25), -1.0);
}

/// x, y; the value, then the derivatives by x, y, both, x twice, y twice, both twice.
const SCIPY: [(f64, f64, [f64; 7]); 4] = [
    (
        0.5,
        0.25,
        [
            1.3750302269345238,
            1.6059694320436515,
            0.5212146577380969,
            -0.647129216269839,
            -0.3752418154761911,
            3.4990327380952304,
            -15.992261904761877,
        ],
    ),
    (
        1.5,
        1.0,
        [
            4.886755952380952,
            2.8689484126984137,
            2.326711309523807,
            -0.40719246031745926,
            0.7726190476190467,
            -0.945386904761907,
            -0.17023809523809275,
        ],
    ),
    (
        3.0,
        0.4,
        [
            7.469923809523811,
            2.4784603174603177,
            4.017285714285715,
            -0.8468650793650786,
            -1.529180952380952,
            -2.871904761904762,
            4.810476190476188,
        ],
    ),
    (
        4.7,
        2.9,
        [
            12.715294599999996,
            1.9611416190476172,
            -1.714650916666665,
            4.238118690476184,
            -4.585274285714287,
            -7.585139999999998,
            0.8420952380952271,
        ],
    ),
];

/// Against the tensor product of splines of another program (SciPy 1.17, `RectBivariateSpline` with `s = 0`); outside, a plane at the border.
#[test]
fn bicubic() {
    let (x, y) = ([0.0, 1.0, 2.0, 4.0, 5.0], [0.0, 0.5, 2.0, 3.0]);
    // By rows of y.
    let z = [
        vec![0.0, 2.0, 3.0, 8.0, 7.0],
        vec![1.0, 2.5, 5.0, 9.0, 6.0],
        vec![3.0, 6.0, 7.0, 12.0, 11.0],
        vec![2.0, 6.5, 4.0, 10.0, 13.0],
    ];
    let sheet = |outside| {
        let axes = [&x[..], &y[..]].map(|knots| Arc::new(Table::new("a", AXIS, pieces::of_axis(knots))));
        let (width, rows) = pieces::of_grid(&x, &y, &z, Interpolation::Bicubic, outside);
        Curve::Grid { axes, patches: Arc::new(Table::new("g", width, rows)) }
    };
    let (on, held) = (sheet(Outside::Linear), sheet(Outside::Hold));
    let at = |sheet: &Curve, orders: [u8; 2], x, y| sheet.at(Orders::new(orders[0], orders[1]), &[x, y]);
    for (row, y) in z.iter().zip(y) {
        for (value, x) in row.iter().zip(x) {
            close(at(&on, [0, 0], x, y), *value);
        }
    }
    for (x, y, expected) in SCIPY {
        for (orders, expected) in
            [[0, 0], [1, 0], [0, 1], [1, 1], [2, 0], [0, 2], [2, 2]].into_iter().zip(expected)
        {
            close(at(&on, orders, x, y), expected);
        }
    }
    // Beyond a border with value and slope there, or with the value.
    let (value, slope) = (at(&on, [0, 0], 5.0, 1.2), at(&on, [1, 0], 5.0, 1.2));
    close(at(&on, [0, 0], 5.5, 1.2), value + 0.5 * slope);
    close(at(&held, [0, 0], 5.5, 1.2), value);
    close(at(&on, [0, 0], -1.0, 1.2), at(&on, [0, 0], 0.0, 1.2) - at(&on, [1, 0], 0.0, 1.2));
    assert_eq!(
        [at(&on, [2, 0], 6.0, 1.2), at(&on, [4, 0], 1.0, 1.0), at(&held, [1, 0], -1.0, 1.2)],
        [0.0; 3]
    );
    assert!(at(&on, [1, 1], f64::NAN, 1.0).is_nan());
}
