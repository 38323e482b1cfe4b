//! The scalar that every equation is evaluated in.
//!
//! [`Real`] is what emitted code may use and nothing more: four operations, a few functions, and choices written
//! as [`Real::select`] so that one source serves a number, a row of SIMD lanes and a dual number alike. This file
//! implements it for `f32` and `f64`. Vectors of scalars are `vector.rs`, rotations `rotation.rs`.

use crate::table;
use core::fmt::Debug;
use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// A real number in which the equations of motion are evaluated.
///
/// Sine, cosine and their kin always come from `libm`, so that a result has the same bits on every processor; the
/// square root is correctly rounded by IEEE 754 and may come from the hardware. Comparisons give a
/// [`Mask`](Real::Mask), not a `bool`: a SIMD lane cannot branch.
pub trait Real:
    Copy
    + Debug
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Send
    + Sync
    + 'static
{
    /// The result of a comparison: `bool` for one number, one truth value a lane for several.
    type Mask: Copy + BitAnd<Output = Self::Mask> + BitOr<Output = Self::Mask> + Not<Output = Self::Mask>;

    /// How many numbers it is: one, or as many as it has lanes.
    const LANES: usize = 1;
    /// The neutral element of addition.
    const ZERO: Self;
    /// The neutral element of multiplication.
    const ONE: Self;
    /// The distance from one to the next larger number.
    const EPSILON: Self;
    /// The relative pivot below which a factorisation has broken down.
    ///
    /// A pivot is compared with the sum of the magnitudes of the terms that formed it. After cancellation
    /// to rounding there remain a few [`EPSILON`](Real::EPSILON); the bound lies some forty roundings above, so a
    /// pivot below it has no correct digit worth dividing by: `1e-14` for `f64`, `5e-6` for `f32`.
    const BREAKDOWN: Self;
    /// The reciprocal condition of D M⁻¹ Dᵀ below which a position is reported as nearly singular: `1e-6` for `f64`,
    /// `1e-3` for `f32`.
    const NEAR_SINGULAR: Self;

    /// The nearest number to `value`.
    fn from_f64(value: f64) -> Self;
    /// The value in double precision, for messages; of several lanes the first, of a dual number the real part.
    fn to_f64(self) -> f64;

    /// √x, correctly rounded; NaN below zero.
    fn sqrt(self) -> Self;
    /// |x|.
    fn abs(self) -> Self;
    /// −1, 0 or 1 with the sign of x; a zero, and what is no number, is left as it is.
    fn sign(self) -> Self;
    /// The largest whole number that is not above x.
    fn floor(self) -> Self;
    /// The smaller of two; the second where either is NaN.
    fn min(self, other: Self) -> Self;
    /// The larger of two; the second where either is NaN.
    fn max(self, other: Self) -> Self;
    /// sin x, x in rad.
    fn sin(self) -> Self;
    /// cos x, x in rad.
    fn cos(self) -> Self;
    /// tan x, x in rad.
    fn tan(self) -> Self;
    /// The angle in [−π/2, π/2] whose sine is x; NaN outside [−1, 1].
    fn asin(self) -> Self;
    /// The angle in [0, π] whose cosine is x; NaN outside [−1, 1].
    fn acos(self) -> Self;
    /// The angle in [−π, π] of the point (x, `self`).
    fn atan2(self, x: Self) -> Self;
    /// eˣ.
    fn exp(self) -> Self;
    /// The natural logarithm; NaN below zero.
    fn ln(self) -> Self;
    /// The logarithm to the base ten; NaN below zero.
    fn log10(self) -> Self;
    /// sinh x.
    fn sinh(self) -> Self;
    /// cosh x.
    fn cosh(self) -> Self;
    /// tanh x.
    fn tanh(self) -> Self;
    /// `self · factor + term`, fused (rounded once) only where the target has the instruction and `std` is there to
    /// reach it, in two roundings elsewhere: never the slow emulation.
    fn mul_add(self, factor: Self, term: Self) -> Self;
    /// Whether the number, in every lane, is neither infinite nor NaN.
    fn is_finite(self) -> bool;

    /// `self < other`.
    fn less(self, other: Self) -> Self::Mask;
    /// `self ≤ other`.
    fn less_equal(self, other: Self) -> Self::Mask;
    /// `self > other`.
    fn greater(self, other: Self) -> Self::Mask;
    /// `self ≥ other`.
    fn greater_equal(self, other: Self) -> Self::Mask;
    /// `self = other`.
    fn equal(self, other: Self) -> Self::Mask;
    /// `self ≠ other`, true where either is NaN.
    fn not_equal(self, other: Self) -> Self::Mask;
    /// `a` where the mask is true, `b` where it is false; both are already evaluated.
    fn select(mask: Self::Mask, a: Self, b: Self) -> Self;
    /// The number of the row of a table that it is in, in every lane: how many bases, the first entries of rows, from the second
    /// row on are not above it. Bases ascend, and are NaN in the rows that fill up to a power of two.
    fn cell<const K: usize, const N: usize>(self, rows: &[[f64; K]; N]) -> Self;
    /// The entries of the row of this number, in every lane those of its own row.
    fn row<const K: usize, const N: usize>(self, rows: &[[f64; K]; N]) -> [Self; K];
    /// Whether the mask is true in at least one lane; lets rare work be skipped when no lane needs it.
    fn any(mask: Self::Mask) -> bool;
}

/// `new` in the lanes of the mask, `old` in the others; of a single number `new`, for which its own mask has been looked at.
#[inline(always)]
pub(crate) fn in_lanes<R: Real>(mask: R::Mask, new: R, old: R) -> R {
    if R::LANES == 1 { new } else { R::select(mask, new, old) }
}

/// `impl Real` for one primitive float; the functions of `libm` differ only in their names.
macro_rules! impl_real {
    (
        $float:ty, breakdown $breakdown:literal, near $near:literal, sqrt $sqrt:path, floor $floor:path, sin $sin:path, cos $cos:path,
        tan $tan:path, asin $asin:path, acos $acos:path, atan2 $atan2:path, exp $exp:path, ln $ln:path,
        log10 $log10:path, sinh $sinh:path, cosh $cosh:path, tanh $tanh:path
    ) => {
        impl Real for $float {
            type Mask = bool;

            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const EPSILON: Self = <$float>::EPSILON;
            const BREAKDOWN: Self = $breakdown;
            const NEAR_SINGULAR: Self = $near;

            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                value as $float
            }
            #[inline(always)]
            fn to_f64(self) -> f64 {
                self as f64
            }

            #[cfg(feature = "std")]
            #[inline(always)]
            fn sqrt(self) -> Self {
                <$float>::sqrt(self)
            }
            #[cfg(not(feature = "std"))]
            #[inline(always)]
            fn sqrt(self) -> Self {
                $sqrt(self)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                <$float>::abs(self)
            }
            #[inline(always)]
            fn sign(self) -> Self {
                if self > 0.0 {
                    1.0
                } else if self < 0.0 {
                    -1.0
                } else {
                    self
                }
            }
            #[inline(always)]
            fn floor(self) -> Self {
                $floor(self)
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                if self < other { self } else { other }
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                if self > other { self } else { other }
            }
            #[inline]
            fn sin(self) -> Self {
                $sin(self)
            }
            #[inline]
            fn cos(self) -> Self {
                $cos(self)
            }
            #[inline]
            fn tan(self) -> Self {
                $tan(self)
            }
            #[inline]
            fn asin(self) -> Self {
                $asin(self)
            }
            #[inline]
            fn acos(self) -> Self {
                $acos(self)
            }
            #[inline]
            fn atan2(self, x: Self) -> Self {
                $atan2(self, x)
            }
            #[inline]
            fn exp(self) -> Self {
                $exp(self)
            }
            #[inline]
            fn ln(self) -> Self {
                $ln(self)
            }
            #[inline]
            fn log10(self) -> Self {
                $log10(self)
            }
            #[inline]
            fn sinh(self) -> Self {
                $sinh(self)
            }
            #[inline]
            fn cosh(self) -> Self {
                $cosh(self)
            }
            #[inline]
            fn tanh(self) -> Self {
                $tanh(self)
            }
            #[cfg(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64")))]
            #[inline(always)]
            fn mul_add(self, factor: Self, term: Self) -> Self {
                <$float>::mul_add(self, factor, term)
            }
            #[cfg(not(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64"))))]
            #[inline(always)]
            fn mul_add(self, factor: Self, term: Self) -> Self {
                self * factor + term
            }
            #[inline(always)]
            fn is_finite(self) -> bool {
                <$float>::is_finite(self)
            }

            #[inline(always)]
            fn less(self, other: Self) -> bool {
                self < other
            }
            #[inline(always)]
            fn less_equal(self, other: Self) -> bool {
                self <= other
            }
            #[inline(always)]
            fn greater(self, other: Self) -> bool {
                self > other
            }
            #[inline(always)]
            fn greater_equal(self, other: Self) -> bool {
                self >= other
            }
            #[inline(always)]
            fn equal(self, other: Self) -> bool {
                self == other
            }
            #[inline(always)]
            fn not_equal(self, other: Self) -> bool {
                self != other
            }
            #[inline(always)]
            fn select(mask: bool, a: Self, b: Self) -> Self {
                if mask { a } else { b }
            }
            #[inline]
            fn cell<const K: usize, const N: usize>(self, rows: &[[f64; K]; N]) -> Self {
                table::find(rows, f64::from(self)) as $float
            }
            #[inline]
            fn row<const K: usize, const N: usize>(self, rows: &[[f64; K]; N]) -> [Self; K] {
                table::row(rows, self as u32).map(|entry| entry as $float)
            }
            #[inline(always)]
            fn any(mask: bool) -> bool {
                mask
            }
        }
    };
}

impl_real!(
    f64, breakdown 1e-14, near 1e-6, sqrt libm::sqrt, floor libm::floor, sin libm::sin, cos libm::cos,
    tan libm::tan, asin libm::asin, acos libm::acos, atan2 libm::atan2, exp libm::exp, ln libm::log,
    log10 libm::log10, sinh libm::sinh, cosh libm::cosh, tanh libm::tanh
);
impl_real!(
    f32, breakdown 5e-6, near 1e-3, sqrt libm::sqrtf, floor libm::floorf, sin libm::sinf, cos libm::cosf,
    tan libm::tanf, asin libm::asinf, acos libm::acosf, atan2 libm::atan2f, exp libm::expf, ln libm::logf,
    log10 libm::log10f, sinh libm::sinhf, cosh libm::coshf, tanh libm::tanhf
);

#[cfg(test)]
mod tests {
    use super::Real;

    /// f64 BREAKDOWN and f32 BREAKDOWN both stand well above rounding, and choices follow IEEE comparisons.
    #[test]
    fn choices_and_bounds() {
        const { assert!(<f64 as Real>::BREAKDOWN > 32.0 * f64::EPSILON) };
        const { assert!(<f32 as Real>::BREAKDOWN > 32.0 * f32::EPSILON) };
        assert_eq!(Real::sign(-2.5_f64), -1.0);
        assert_eq!(Real::sign(0.0_f32), 0.0);
        assert_eq!(f64::select(1.0_f64.less(2.0), 3.0, 4.0), 3.0);
        assert_eq!(Real::max(f64::NAN, 1.0), 1.0);
        assert!(f64::NAN.not_equal(f64::NAN) && !f64::any(f64::NAN.less_equal(0.0)));
        assert_eq!(Real::floor(-0.5_f64), -1.0);
    }
}
