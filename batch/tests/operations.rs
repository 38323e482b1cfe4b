//! Every operation of a lane gives the bits of the same operation on its number alone, of zeros, infinities and what is no number too.

use linkwright::{F32x8, F32x16, F64x4, F64x8, Lanes, Real};

const NUMBERS: [f64; 20] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    3.0,
    -2.75,
    1e-3,
    1e300,
    -1e300,
    1e-310,
    5e-324,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
    1.5,
    2.5,
    -0.5,
    1234.5678,
    core::f64::consts::PI,
];
const ROWS: [[f64; 2]; 4] = [[0.0, 7.0], [1.0, 8.0], [2.0, 9.0], [f64::NAN, f64::NAN]];

fn same<R: Real>(what: &str, found: R, expected: R, of: [f64; 3]) {
    let same_sign = (R::ONE / found).to_f64() == (R::ONE / expected).to_f64();
    let is_nan = |x: R| R::any(x.not_equal(x));
    let both_nan = is_nan(found) && is_nan(expected);
    assert!(both_nan || (found == expected && same_sign), "{what} of {of:?}: {found:?}, {expected:?} alone");
}

/// All operations, on every three of the numbers, shifted from lane to lane.
fn operations<L: Lanes>() {
    let count = NUMBERS.len();
    for first in 0..count {
        for (second, third) in [(3, 7), (1, 11), (0, 5), (13, 2), (17, 19)] {
            let of = |lane: usize| {
                [first + lane, first + second + 2 * lane, first + third + 3 * lane]
                    .map(|k| NUMBERS[k % count])
            };
            let row = |k: usize| {
                let mut row = L::ZERO;
                let number = |lane| <L::Scalar as Real>::from_f64(of(lane)[k]);
                (0..L::LANES).for_each(|lane| row.set_lane(lane, number(lane)));
                row
            };
            let [a, b, c] = [row(0), row(1), row(2)];
            macro_rules! agree {
                ($($operation:ident($($argument:ident),*)),* $(,)?) => { $(
                    let all = Real::$operation($($argument),*);
                    for lane in 0..L::LANES {
                        let alone = Real::$operation($($argument.lane(lane)),*);
                        same(stringify!($operation), all.lane(lane), alone, of(lane));
                    }
                )* };
            }
            agree!(
                sqrt(a),
                abs(a),
                sign(a),
                floor(a),
                min(a, b),
                max(a, b),
                sin(a),
                cos(a),
                tan(a),
                asin(a),
                acos(a),
                atan2(a, b),
                exp(a),
                ln(a),
                log10(a),
                sinh(a),
                cosh(a),
                tanh(a),
                mul_add(a, b, c)
            );
            for lane in 0..L::LANES {
                let [x, y, z] = [a, b, c].map(|row| row.lane(lane));
                let of = of(lane);
                same("+", (a + b).lane(lane), x + y, of);
                same("-", (a - b).lane(lane), x - y, of);
                same("*", (a * b).lane(lane), x * y, of);
                same("/", (a / b).lane(lane), x / y, of);
                same("negation", (-a).lane(lane), -x, of);
                let is_below = x < y;
                let masks = [
                    (a.less(b), x < y),
                    (a.less_equal(b), x <= y),
                    (a.greater(b), x > y),
                    (a.greater_equal(b), x >= y),
                    (a.equal(b), x == y),
                    (a.not_equal(b), x != y),
                    (!a.less(b) & b.less(c), !is_below && y < z),
                    (a.less(b) | b.less(c), x < y || y < z),
                ];
                for (index, (mask, expected)) in masks.into_iter().enumerate() {
                    assert_eq!(L::bits(mask) >> lane & 1 == 1, expected, "comparison {index} of {of:?}");
                    same("select", L::select(mask, a, b).lane(lane), if expected { x } else { y }, of);
                    assert!(L::any(mask) || !expected);
                }
                same("cell", a.cell(&ROWS).lane(lane), x.cell(&ROWS), of);
                let cell = a.cell(&ROWS);
                let (found, expected) = (cell.row(&ROWS), cell.lane(lane).row(&ROWS));
                (0..2).for_each(|k| same("row", found[k].lane(lane), expected[k], of));
            }
            assert_eq!(a.is_finite(), (0..L::LANES).all(|lane| a.lane(lane).is_finite()));
            assert_eq!(a < b, (0..L::LANES).all(|lane| a.lane(lane) < b.lane(lane)));
            assert_eq!(a == b, (0..L::LANES).all(|lane| a.lane(lane) == b.lane(lane)));
        }
    }
    let bits = |bits: u32| L::bits(L::mask(bits));
    let all = (1 << L::LANES) - 1;
    assert_eq!((bits(0), bits(all), bits(5), bits(1 << (L::LANES - 1))), (0, all, 5, 1 << (L::LANES - 1)));
    assert_eq!(L::splat(L::Scalar::ONE), L::ONE);
    assert_eq!(L::from_f64(0.1).lane(L::LANES), <L::Scalar as Real>::from_f64(0.1), "beyond the last one");
}

#[test]
fn lanes_compute_as_their_numbers() {
    operations::<F64x4>();
    operations::<F64x8>();
    operations::<F32x8>();
    operations::<F32x16>();
}
