//! Rotations in the plane: the exponential on SO(2), angles over several turns, unwrapping of outputs.
//!
//! Everything here works on single numbers; which entries of q are pairs or angles is said by `layout.rs`. Rotations in
//! space are `quaternion.rs`.

use crate::real::{Real, in_lanes};

const TWO_PI: f64 = core::f64::consts::TAU;

/// Scalars whose rounding is above this need few terms.
const SINGLE: f64 = 1e-10;

/// Known where this is compiled.
#[inline(always)]
fn is_single<R: Real>() -> bool {
    R::EPSILON.to_f64() > SINGLE
}

/// The largest z = δ² at which [`series`] is summed: 1/4, in single precision 1/16.
#[inline(always)]
pub(crate) fn direct<R: Real>() -> R {
    R::from_f64(if is_single::<R>() { 0.0625 } else { 0.25 })
}

/// (cos δ, sin δ) of an increment δ, rad.
///
/// For |δ| ≤ 1/2 the Taylor polynomials to δ¹⁴ and δ¹⁵, whose first neglected terms are below 1e-18, summed in
/// Estrin's order for a short dependency chain; in single precision, for |δ| ≤ 1/4, to δ⁶ and δ⁵, with 1.2e-8 left out. A larger increment is halved until it is small and the result
/// doubled as often: cos 2δ − 1 = (2 + u) 2u with u = cos δ − 1, which keeps the digits of a small u.
/// No range reduction, no table, no branch between lanes. Beyond 2⁶⁴ or for NaN the result is meaningless or NaN.
#[inline]
pub fn exponential<R: Real>(delta: R) -> (R, R) {
    if !turns_far(delta) {
        let (u, s) = versine(delta);
        return (R::ONE + u, s);
    }
    exponential_by_halving(delta)
}

/// (c, s) turned by δ rad, then normalised to first order with k = (3 − (c² + s²))/2.
///
/// The pair stays on the circle to rounding because each step removes the half of second order that the last one
/// left; the factor changes the length only, never the angle.
#[inline]
pub fn turn<R: Real>(c: R, s: R, delta: R) -> (R, R) {
    compose(c, s, exponential(delta))
}

/// As [`turn`], to the bit, for increments that are not [`turns_far`].
#[inline(always)]
pub(crate) fn turn_little<R: Real>(c: R, s: R, delta: R) -> (R, R) {
    let (c, s) = turn_once(c, s, delta);
    normalise(c, s)
}

/// As [`turn_little`] without normalisation, for what is not turned further.
#[inline(always)]
pub(crate) fn turn_once<R: Real>(c: R, s: R, delta: R) -> (R, R) {
    let (u, sd) = versine(delta);
    product(c, s, (R::ONE + u, sd))
}

/// Whether an increment is beyond the direct polynomial of [`exponential`].
#[inline(always)]
fn is_far<R: Real>(delta: R) -> R::Mask {
    (delta * delta).greater(direct())
}

/// Whether it is in some lane.
#[inline(always)]
fn turns_far<R: Real>(delta: R) -> bool {
    R::any(is_far(delta))
}

/// Whether one of these increments may be beyond the direct polynomial of [`exponential`]; by the sum of their squares, which
/// takes one comparison.
#[inline(always)]
pub(crate) fn turn_far<R: Real>(deltas: &[R]) -> R::Mask {
    let squares = deltas.iter().fold(R::ZERO, |sum, &delta| delta.mul_add(delta, sum));
    squares.greater(direct())
}

/// The product of two rotations, normalised to first order.
#[inline(always)]
fn compose<R: Real>(c: R, s: R, by: (R, R)) -> (R, R) {
    let (c, s) = product(c, s, by);
    normalise(c, s)
}

#[inline(always)]
fn product<R: Real>(c: R, s: R, (cd, sd): (R, R)) -> (R, R) {
    (c * cd - s * sd, s * cd + c * sd)
}

#[inline(always)]
fn normalise<R: Real>(c: R, s: R) -> (R, R) {
    let k = (R::from_f64(3.0) - (c * c + s * s)) * R::from_f64(0.5);
    (c * k, s * k)
}

/// Moves whole turns out of a remainder (rad) that has left [−π, π): gives the new turns and remainder.
#[inline]
pub fn wrap<R: Real>(turns: R, remainder: R) -> (R, R) {
    let pi = R::from_f64(core::f64::consts::PI);
    if !R::any(remainder.abs().greater_equal(pi)) {
        return (turns, remainder);
    }
    let moved = (remainder * R::from_f64(1.0 / TWO_PI) + R::from_f64(0.5)).floor();
    (turns + moved, remainder - moved * R::from_f64(TWO_PI))
}

/// The angle (rad) that differs from `new` by whole turns and lies nearest to `previous`.
///
/// Right as long as the angle moves less than half a turn from sample to sample.
#[inline]
pub fn unwrap_angle<R: Real>(new: R, previous: R) -> R {
    let turns = ((previous - new) * R::from_f64(1.0 / TWO_PI) + R::from_f64(0.5)).floor();
    new + turns * R::from_f64(TWO_PI)
}

/// (cos δ − 1, sin δ) of increments that are not [`turns_far`].
#[inline(always)]
fn versine<R: Real>(delta: R) -> (R, R) {
    let z = delta * delta;
    let (cosine, sine) = series(z);
    (z * cosine, (delta * z).mul_add(sine, delta))
}

/// The series (c, s) in z = δ² up to [`direct`] with cos δ = 1 + z c and sin δ = δ + δ z s.
#[inline(always)]
pub(crate) fn series<R: Real>(z: R) -> (R, R) {
    let k = R::from_f64;
    // By Horner's scheme no power of a small z is formed: it would be no normal number, at which processors are slow.
    if is_single::<R>() {
        let cosine = z.mul_add(k(-1.0 / 720.0), k(1.0 / 24.0));
        return (z.mul_add(cosine, k(-0.5)), z.mul_add(k(1.0 / 120.0), k(-1.0 / 6.0)));
    }
    let z2 = z * z;
    let z4 = z2 * z2;
    // sin δ = δ + δ z (−1/3! + z/5! − …), cos δ − 1 = z (−1/2! + z/4! − …)
    let s_low = z.mul_add(k(1.0 / 120.0), k(-1.0 / 6.0));
    let s_mid = z.mul_add(k(1.0 / 362_880.0), k(-1.0 / 5_040.0));
    let s_high = z.mul_add(k(1.0 / 6_227_020_800.0), k(-1.0 / 39_916_800.0));
    let s_last = k(-1.0 / 1_307_674_368_000.0);
    let c_low = z.mul_add(k(1.0 / 24.0), k(-0.5));
    let c_mid = z.mul_add(k(1.0 / 40_320.0), k(-1.0 / 720.0));
    let c_high = z.mul_add(k(1.0 / 479_001_600.0), k(-1.0 / 3_628_800.0));
    let c_last = k(-1.0 / 87_178_291_200.0);
    let sine = z4.mul_add(z2.mul_add(s_last, s_high), z2.mul_add(s_mid, s_low));
    let cosine = z4.mul_add(z2.mul_add(c_last, c_high), z2.mul_add(c_mid, c_low));
    (cosine, sine)
}

/// The exponential of an increment above 1/2 in at least one lane, by at most 64 halvings: above 2⁶³ rad no digit of an angle is left.
/// Every lane is halved as often as it would be alone.
#[cold]
fn exponential_by_halving<R: Real>(delta: R) -> (R, R) {
    let half = R::from_f64(0.5);
    let mut small = delta;
    let (mut halvings, mut most) = (R::ZERO, 0);
    while most < 64 && turns_far(small) {
        let far = is_far(small);
        small = in_lanes(far, small * half, small);
        halvings = in_lanes(far, halvings + R::ONE, halvings);
        most += 1;
    }
    let (mut u, mut s) = versine(small);
    for _ in 0..most {
        let again = halvings.greater(R::ZERO);
        s = in_lanes(again, (s + s) * (R::ONE + u), s);
        u = in_lanes(again, (u + u) * (R::from_f64(2.0) + u), u);
        halvings = halvings - R::ONE;
    }
    (R::ONE + u, s)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponential_agrees_with_libm() {
        for i in -4000..=4000 {
            let delta = f64::from(i) * 2.5e-3;
            let (c, s) = exponential(delta);
            let bound = if delta.abs() <= 0.5 { 2.3e-16 } else { 4e-15 };
            assert!((c - libm::cos(delta)).abs() <= bound, "cos {delta}: {c}");
            assert!((s - libm::sin(delta)).abs() <= bound, "sin {delta}: {s}");
        }
    }

    /// Small increments in single precision, to rounding: what is left out of their series is less.
    #[test]
    fn single_precision_keeps_its_digits_at_small_increments() {
        for i in 0..2000 {
            let delta = libm::pow(10.0, -0.3 - 0.01 * f64::from(i)) as f32;
            let (c, s) = exponential(delta);
            let rounding = if turns_far(delta) { 1.5 } else { 0.75 } * f64::from(f32::EPSILON);
            assert!((f64::from(c) - libm::cos(delta.into())).abs() <= rounding, "cos {delta:e}");
            let sine = libm::sin(delta.into());
            assert!((f64::from(s) - sine).abs() <= rounding * sine, "sin {delta:e}: {s:e}");
            let (u, _) = versine(delta);
            let expected = -2.0 * libm::pow(libm::sin(0.5 * f64::from(delta)), 2.0);
            if delta > 1e-18 && !turns_far(delta) {
                assert!(
                    (f64::from(u) - expected).abs() <= -2.0 * f64::from(f32::EPSILON) * expected,
                    "{delta:e}: {u:e}"
                );
            }
        }
        assert_eq!(exponential(0.0_f32), (1.0, 0.0));
    }

    #[test]
    fn exponential_of_nonsense_ends() {
        assert!(exponential(f64::NAN).0.is_nan());
        assert!(!exponential(f64::INFINITY).1.is_finite());
    }

    #[test]
    fn wrapping_and_unwrapping() {
        let (turns, remainder) = wrap(2.0, 10.0_f64);
        assert_eq!(turns, 4.0);
        assert!((remainder + 2.0 * TWO_PI - 10.0).abs() < 1e-14);
        assert_eq!(wrap(0.0, -core::f64::consts::PI), (0.0, -core::f64::consts::PI));
        assert!((unwrap_angle(-3.0, 3.1) - (TWO_PI - 3.0)).abs() < 1e-15);
        assert_eq!(unwrap_angle(0.25, 0.5), 0.25);
    }
}
