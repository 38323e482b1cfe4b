//! Rotations in space: unit quaternions, their exponential, and rotation matrices.
//!
//! A quaternion is (w, x, y, z), scalar first; A(q) carries from the turned axes to those it is turned in. Increments
//! δ and angular velocities are in the turned (body) axes: q ← q ⊗ exp(δ), q̇ = ½ q ⊗ (0, ω). Everything here works on
//! one orientation; which entries of q are quaternions is said by `layout.rs`, the plane has `rotation.rs`.

use crate::real::{Real, in_lanes};
use crate::rotation::{direct, series};

/// (cos ½|δ|, sin ½|δ| · δ/|δ|) of an increment δ, rad: the unit quaternion of the rotation by |δ| about δ.
///
/// Both are power series in z = |δ|²/4, the ones of `rotation.rs`, so that no square root and no division occur and
/// δ = 0 is no exception; for |δ| ≤ 1 (1/2 in single precision) the first neglected terms are below rounding. A larger increment is halved until it is
/// small and the result squared as often: with u = w − 1, (u, v) ← (2u (2 + u), 2 (1 + u) v). Errors of a few roundings
/// grow in proportion to |δ|. Beyond 2⁶⁴ or for NaN the result is meaningless or NaN.
#[inline]
pub fn exponential<R: Real>(delta: [R; 3]) -> [R; 4] {
    if !turns_far(delta) {
        return unit(half_turn(delta));
    }
    exponential_by_halving(delta)
}

/// q ⊗ exp(δ), δ in the turned axes, then normalised to first order with k = (3 − |q|²)/2.
///
/// The quaternion stays on the sphere to rounding, for the reason given at [`turn`](crate::rotation::turn).
#[inline]
pub fn turn<R: Real>(q: [R; 4], delta: [R; 3]) -> [R; 4] {
    compose(q, exponential(delta))
}

/// As [`turn`], to the bit, for increments that are not [`turns_far`].
#[inline(always)]
pub(crate) fn turn_little<R: Real>(q: [R; 4], delta: [R; 3]) -> [R; 4] {
    compose(q, unit(half_turn(delta)))
}

/// As [`turn_little`] without normalisation, for what is not turned further.
#[inline(always)]
pub(crate) fn turn_once<R: Real>(q: [R; 4], delta: [R; 3]) -> [R; 4] {
    product(q, unit(half_turn(delta)))
}

/// Whether an increment is beyond the direct polynomials of [`exponential`].
#[inline(always)]
pub(crate) fn is_far<R: Real>([x, y, z]: [R; 3]) -> R::Mask {
    (x * x + y * y + z * z).greater(R::from_f64(4.0) * direct::<R>())
}

/// Whether it is in some lane.
#[inline(always)]
fn turns_far<R: Real>(delta: [R; 3]) -> bool {
    R::any(is_far(delta))
}

/// The product p ⊗ q: first the rotation q, then p.
#[inline(always)]
pub fn product<R: Real>([pw, px, py, pz]: [R; 4], [w, x, y, z]: [R; 4]) -> [R; 4] {
    [
        pw * w - px * x - (py * y + pz * z),
        pw * x + px * w + (py * z - pz * y),
        pw * y + py * w + (pz * x - px * z),
        pw * z + pz * w + (px * y - py * x),
    ]
}

/// The product of two rotations, normalised to first order.
#[inline(always)]
fn compose<R: Real>(p: [R; 4], q: [R; 4]) -> [R; 4] {
    let [w, x, y, z] = product(p, q);
    let k = (R::from_f64(3.0) - (w * w + x * x + (y * y + z * z))) * R::from_f64(0.5);
    [w * k, x * k, y * k, z * k]
}

/// (w − 1, (x, y, z)) of exp(δ), which is not [`turns_far`].
#[inline(always)]
fn half_turn<R: Real>([x, y, z]: [R; 3]) -> (R, [R; 3]) {
    let half = R::from_f64(0.5);
    let square = (x * x + y * y + z * z) * R::from_f64(0.25);
    let (cosine, sine) = series(square);
    let factor = (half * square).mul_add(sine, half);
    (square * cosine, [factor * x, factor * y, factor * z])
}

#[inline(always)]
fn unit<R: Real>((u, [x, y, z]): (R, [R; 3])) -> [R; 4] {
    [R::ONE + u, x, y, z]
}

/// The exponential of an increment that [`turns_far`] in at least one lane, by at most 64 halvings: above 2⁶⁴ rad no digit of an angle is left.
/// Every lane is halved as often as it would be alone.
#[cold]
fn exponential_by_halving<R: Real>(delta: [R; 3]) -> [R; 4] {
    let mut small = delta;
    let (mut halvings, mut most) = (R::ZERO, 0);
    while most < 64 && turns_far(small) {
        let far = is_far(small);
        small = small.map(|entry| in_lanes(far, entry * R::from_f64(0.5), entry));
        halvings = in_lanes(far, halvings + R::ONE, halvings);
        most += 1;
    }
    let (mut u, mut v) = half_turn(small);
    for _ in 0..most {
        let again = halvings.greater(R::ZERO);
        let w = R::ONE + u;
        v = v.map(|entry| in_lanes(again, (entry + entry) * w, entry));
        u = in_lanes(again, (u + u) * (R::from_f64(2.0) + u), u);
        halvings = halvings - R::ONE;
    }
    unit((u, v))
}

/// A(q), row by row: world ← turned axes. |q| = 1 is taken for granted.
#[inline]
pub fn rotation_matrix<R: Real>([w, x, y, z]: [R; 4]) -> [[R; 3]; 3] {
    let two = R::from_f64(2.0);
    let diagonal = |a: R, b: R| R::ONE - two * (a * a + b * b);
    [
        [diagonal(y, z), two * (x * y - w * z), two * (x * z + w * y)],
        [two * (x * y + w * z), diagonal(x, z), two * (y * z - w * x)],
        [two * (x * z - w * y), two * (y * z + w * x), diagonal(x, y)],
    ]
}

/// The unit quaternion of a rotation matrix, w ≥ 0 of the two signs.
///
/// The largest of 4w² = 1 + tr A, 4x² = 1 + 2 A₁₁ − tr A, … is at least 1; its root is taken and the others follow
/// from off-diagonal entries, so that no small number is divided by (Shepperd, *Quaternion from Rotation Matrix*,
/// J. Guidance and Control 1, 1978). The deviation of |q| from 1 by rounding is divided out.
#[cold]
pub fn from_rotation_matrix<R: Real>(a: &[[R; 3]; 3]) -> [R; 4] {
    let trace = a[0][0] + a[1][1] + a[2][2];
    // 4w times each component, 4x times each, …: the row with the largest diagonal entry is used.
    let product = |i: usize, j: usize| a[i][j] + a[j][i];
    let difference = |i: usize, j: usize| a[i][j] - a[j][i];
    let square = |i: usize| R::ONE + a[i][i] + a[i][i] - trace;
    let (wx, wy, wz) = (difference(2, 1), difference(0, 2), difference(1, 0));
    let (xy, xz, yz) = (product(0, 1), product(0, 2), product(1, 2));
    let rows = [
        [R::ONE + trace, wx, wy, wz],
        [wx, square(0), xy, xz],
        [wy, xy, square(1), yz],
        [wz, xz, yz, square(2)],
    ];
    let mut largest = 0;
    for k in 1..4 {
        if rows[k][k] > rows[largest][largest] {
            largest = k;
        }
    }
    let [w, ..] = rows[largest];
    let norm = norm(rows[largest]);
    let scale = if w < R::ZERO { -R::ONE / norm } else { R::ONE / norm };
    rows[largest].map(|entry| entry * scale)
}

/// |q|.
pub fn norm<R: Real>([w, x, y, z]: [R; 4]) -> R {
    (w * w + x * x + (y * y + z * z)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rotation;

    /// Directions that are no axes, and axes.
    const DIRECTIONS: [[f64; 3]; 5] = [
        [1.0, 0.0, 0.0],
        [0.0, 0.0, -1.0],
        [0.6, 0.0, 0.8],
        [0.48, -0.6, 0.64],
        [-2.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0],
    ];

    fn apart(a: [f64; 4], b: [f64; 4]) -> f64 {
        a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn exponential_agrees_with_libm() {
        for direction in DIRECTIONS {
            for i in -2000..=2000 {
                let angle = f64::from(i) * 5e-3;
                let delta = direction.map(|entry| entry * angle);
                let half = 0.5 * libm::sqrt(delta.iter().map(|entry| entry * entry).sum());
                let factor = if half == 0.0 { 0.5 } else { 0.5 * libm::sin(half) / half };
                let expected = [libm::cos(half), factor * delta[0], factor * delta[1], factor * delta[2]];
                let bound = if angle.abs() <= 1.0 { 2.3e-16 } else { 4e-15 };
                let found = exponential(delta);
                assert!(apart(found, expected) <= bound, "{delta:?}: {found:?} {expected:?}");
            }
        }
    }

    #[test]
    fn about_one_axis_it_is_the_planar_one() {
        for i in -100..=100 {
            let angle = 0.0099 * f64::from(i);
            let (c, s) = rotation::exponential(0.5 * angle);
            assert!(apart(exponential([0.0, angle, 0.0]), [c, 0.0, s, 0.0]) < 2e-16, "{angle}");
        }
    }

    #[test]
    fn exponential_of_small_and_of_nonsense() {
        assert_eq!(exponential([0.0; 3]), [1.0, 0.0, 0.0, 0.0]);
        assert_eq!(exponential([2e-200, 0.0, -4e-300]), [1.0, 1e-200, 0.0, -2e-300]);
        assert!(exponential([f64::NAN, 0.0, 0.0])[0].is_nan());
        assert!(exponential([0.0, f64::INFINITY, 0.0]).iter().any(|entry| !entry.is_finite()));
        let single = exponential([0.3_f32, 1.9, -0.4]);
        let double = exponential([0.3, 1.9, -0.4]);
        assert!(single.iter().zip(double).all(|(a, b)| (f64::from(*a) - b).abs() < 4e-7), "{single:?}");
    }

    #[test]
    fn turning_is_the_product_and_little_turns_are_turns() {
        let q = exponential([0.4, -1.1, 2.0]);
        let delta = [0.2, 0.5, -0.7];
        assert_eq!(turn(q, delta), turn_little(q, delta));
        assert!(apart(turn(q, delta), product(q, exponential(delta))) < 1e-15);
    }

    #[test]
    fn matrices_compose_as_quaternions() {
        let (p, q) = (exponential([0.4, -1.1, 2.0]), exponential([-0.9, 0.3, 0.5]));
        let (a, b, c) = (rotation_matrix(p), rotation_matrix(q), rotation_matrix(product(p, q)));
        for i in 0..3 {
            for j in 0..3 {
                let entry: f64 = (0..3).map(|k| a[i][k] * b[k][j]).sum();
                assert!((entry - c[i][j]).abs() < 1e-15, "{i} {j}");
            }
        }
        // A right-handed turn by 90° about z carries x to y.
        let quarter = rotation_matrix(exponential([0.0, 0.0, core::f64::consts::FRAC_PI_2]));
        assert!((quarter[1][0] - 1.0).abs() < 1e-15 && quarter[0][0].abs() < 1e-15);
    }

    #[test]
    fn a_matrix_gives_its_quaternion_back() {
        for direction in DIRECTIONS {
            for i in 0..=64 {
                let angle = core::f64::consts::PI * f64::from(i) / 32.0;
                let q = exponential(direction.map(|entry| entry * angle));
                let found = from_rotation_matrix(&rotation_matrix(q));
                let opposite = q.map(|entry| -entry);
                assert!(found[0] >= 0.0 && (norm(found) - 1.0).abs() < 4e-16, "{found:?}");
                assert!(apart(found, q).min(apart(found, opposite)) < 5e-15, "{q:?} {found:?}");
            }
        }
        assert_eq!(
            from_rotation_matrix(&[[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]),
            [0.0, 0.0, 0.0, 1.0]
        );
    }
}
