//! Numbers in lanes, over the vectors of the crate `wide`.
//!
//! Operations that processors have for whole registers go to these; functions of `libm`, tables and rounding to whole numbers go lane by
//! lane, through the scalar that is in it, and so with its bits.

use super::Lanes;
use crate::real::Real;
use core::cmp::Ordering;
use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

macro_rules! lanes {
    ($(#[$doc:meta])* $name:ident, $mask:ident: $wide:ident of $count:literal $scalar:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[repr(transparent)]
        pub struct $name(wide::$wide);

        #[doc = concat!("A truth value for each lane of [`", stringify!($name), "`].")]
        #[derive(Clone, Copy, Debug)]
        #[repr(transparent)]
        pub struct $mask(wide::$wide);

        impl $name {
            /// The row of these numbers.
            #[inline(always)]
            pub const fn new(numbers: [$scalar; $count]) -> Self {
                $name(wide::$wide::new(numbers))
            }

            /// The numbers, first lane first.
            #[inline(always)]
            pub const fn to_array(self) -> [$scalar; $count] {
                self.0.to_array()
            }

            #[inline]
            fn each(self, f: impl FnMut($scalar) -> $scalar) -> Self {
                Self::new(self.to_array().map(f))
            }
        }

        impl From<[$scalar; $count]> for $name {
            fn from(numbers: [$scalar; $count]) -> Self {
                Self::new(numbers)
            }
        }

        impl From<$name> for [$scalar; $count] {
            fn from(row: $name) -> Self {
                row.to_array()
            }
        }

        /// In order where all lanes are, in the same.
        impl PartialOrd for $name {
            #[inline]
            fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
                let (a, b) = (self.to_array(), other.to_array());
                let mut orders = a.iter().zip(&b).map(|(a, b)| a.partial_cmp(b));
                let first = orders.next().flatten()?;
                orders.all(|order| order == Some(first)).then_some(first)
            }
            #[inline(always)]
            fn lt(&self, other: &Self) -> bool {
                self.0.simd_lt(other.0).all()
            }
            #[inline(always)]
            fn le(&self, other: &Self) -> bool {
                self.0.simd_le(other.0).all()
            }
            #[inline(always)]
            fn gt(&self, other: &Self) -> bool {
                self.0.simd_gt(other.0).all()
            }
            #[inline(always)]
            fn ge(&self, other: &Self) -> bool {
                self.0.simd_ge(other.0).all()
            }
        }

        impl Add for $name {
            type Output = Self;
            #[inline(always)]
            fn add(self, other: Self) -> Self {
                $name(self.0 + other.0)
            }
        }

        impl Sub for $name {
            type Output = Self;
            #[inline(always)]
            fn sub(self, other: Self) -> Self {
                $name(self.0 - other.0)
            }
        }

        impl Mul for $name {
            type Output = Self;
            #[inline(always)]
            fn mul(self, other: Self) -> Self {
                $name(self.0 * other.0)
            }
        }

        impl Div for $name {
            type Output = Self;
            #[inline(always)]
            fn div(self, other: Self) -> Self {
                $name(self.0 / other.0)
            }
        }

        impl Neg for $name {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                $name(-self.0)
            }
        }

        impl BitAnd for $mask {
            type Output = Self;
            #[inline(always)]
            fn bitand(self, other: Self) -> Self {
                $mask(self.0 & other.0)
            }
        }

        impl BitOr for $mask {
            type Output = Self;
            #[inline(always)]
            fn bitor(self, other: Self) -> Self {
                $mask(self.0 | other.0)
            }
        }

        impl Not for $mask {
            type Output = Self;
            #[inline(always)]
            fn not(self) -> Self {
                $mask(!self.0)
            }
        }

        impl Real for $name {
            type Mask = $mask;

            const LANES: usize = $count;
            const ZERO: Self = Self::new([0.0; $count]);
            const ONE: Self = Self::new([1.0; $count]);
            const EPSILON: Self = Self::new([<$scalar as Real>::EPSILON; $count]);
            const BREAKDOWN: Self = Self::new([<$scalar as Real>::BREAKDOWN; $count]);
            const NEAR_SINGULAR: Self = Self::new([<$scalar as Real>::NEAR_SINGULAR; $count]);

            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                Self::new([<$scalar as Real>::from_f64(value); $count])
            }
            #[inline(always)]
            fn to_f64(self) -> f64 {
                Lanes::lane(self, 0).to_f64()
            }

            #[cfg(feature = "std")]
            #[inline(always)]
            fn sqrt(self) -> Self {
                $name(self.0.sqrt())
            }
            #[cfg(not(feature = "std"))]
            #[inline]
            fn sqrt(self) -> Self {
                self.each(Real::sqrt)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                $name(self.0.abs())
            }
            #[inline(always)]
            fn sign(self) -> Self {
                let not_positive = Self::select(self.less(Self::ZERO), -Self::ONE, self);
                Self::select(self.greater(Self::ZERO), Self::ONE, not_positive)
            }
            #[inline]
            fn floor(self) -> Self {
                self.each(Real::floor)
            }
            // The instructions of these processors take the second where either is NaN.
            #[cfg(target_arch = "x86_64")]
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                $name(self.0.fast_min(other.0))
            }
            #[cfg(not(target_arch = "x86_64"))]
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                Self::select(self.less(other), self, other)
            }
            #[cfg(target_arch = "x86_64")]
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                $name(self.0.fast_max(other.0))
            }
            #[cfg(not(target_arch = "x86_64"))]
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                Self::select(self.greater(other), self, other)
            }
            #[inline]
            fn sin(self) -> Self {
                self.each(Real::sin)
            }
            #[inline]
            fn cos(self) -> Self {
                self.each(Real::cos)
            }
            #[inline]
            fn tan(self) -> Self {
                self.each(Real::tan)
            }
            #[inline]
            fn asin(self) -> Self {
                self.each(Real::asin)
            }
            #[inline]
            fn acos(self) -> Self {
                self.each(Real::acos)
            }
            #[inline]
            fn atan2(self, x: Self) -> Self {
                let mut x = x.to_array().into_iter();
                self.each(|y| Real::atan2(y, x.next().unwrap_or_default()))
            }
            #[inline]
            fn exp(self) -> Self {
                self.each(Real::exp)
            }
            #[inline]
            fn ln(self) -> Self {
                self.each(Real::ln)
            }
            #[inline]
            fn log10(self) -> Self {
                self.each(Real::log10)
            }
            #[inline]
            fn sinh(self) -> Self {
                self.each(Real::sinh)
            }
            #[inline]
            fn cosh(self) -> Self {
                self.each(Real::cosh)
            }
            #[inline]
            fn tanh(self) -> Self {
                self.each(Real::tanh)
            }
            // As the scalar has it.
            #[cfg(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64")))]
            #[inline(always)]
            fn mul_add(self, factor: Self, term: Self) -> Self {
                $name(self.0.mul_add(factor.0, term.0))
            }
            #[cfg(not(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64"))))]
            #[inline(always)]
            fn mul_add(self, factor: Self, term: Self) -> Self {
                self * factor + term
            }
            #[inline(always)]
            fn is_finite(self) -> bool {
                (self - self).0.simd_eq(wide::$wide::new([0.0; $count])).all()
            }

            #[inline(always)]
            fn less(self, other: Self) -> $mask {
                $mask(self.0.simd_lt(other.0))
            }
            #[inline(always)]
            fn less_equal(self, other: Self) -> $mask {
                $mask(self.0.simd_le(other.0))
            }
            #[inline(always)]
            fn greater(self, other: Self) -> $mask {
                $mask(self.0.simd_gt(other.0))
            }
            #[inline(always)]
            fn greater_equal(self, other: Self) -> $mask {
                $mask(self.0.simd_ge(other.0))
            }
            #[inline(always)]
            fn equal(self, other: Self) -> $mask {
                $mask(self.0.simd_eq(other.0))
            }
            #[inline(always)]
            fn not_equal(self, other: Self) -> $mask {
                $mask(self.0.simd_ne(other.0))
            }
            #[inline(always)]
            fn select(mask: $mask, a: Self, b: Self) -> Self {
                $name(mask.0.select(a.0, b.0))
            }
            #[inline]
            fn cell<const K: usize, const N: usize>(self, rows: &[[f64; K]; N]) -> Self {
                self.each(|number| number.cell(rows))
            }
            #[inline]
            fn row<const K: usize, const N: usize>(self, rows: &[[f64; K]; N]) -> [Self; K] {
                let mut entries = [[0.0; $count]; K];
                for (lane, number) in self.to_array().into_iter().enumerate() {
                    for (entries, entry) in entries.iter_mut().zip(number.row(rows)) {
                        entries[lane] = entry;
                    }
                }
                entries.map(Self::new)
            }
            #[inline(always)]
            fn any(mask: $mask) -> bool {
                mask.0.any()
            }
        }

        impl Lanes for $name {
            type Scalar = $scalar;

            #[inline(always)]
            fn splat(value: $scalar) -> Self {
                Self::new([value; $count])
            }
            #[inline(always)]
            fn lane(self, index: usize) -> $scalar {
                self.to_array()[index.min($count - 1)]
            }
            #[inline(always)]
            fn set_lane(&mut self, index: usize, value: $scalar) {
                let mut numbers = self.to_array();
                if let Some(number) = numbers.get_mut(index) {
                    *number = value;
                }
                *self = Self::new(numbers);
            }
            #[inline(always)]
            fn bits(mask: $mask) -> u32 {
                mask.0.to_bitmask()
            }
            #[inline(always)]
            fn mask(bits: u32) -> $mask {
                let mut numbers = [0.0; $count];
                for (lane, number) in numbers.iter_mut().enumerate() {
                    *number = if bits >> lane & 1 == 1 { 1.0 } else { 0.0 };
                }
                Self::new(numbers).not_equal(Self::ZERO)
            }
        }
    };
}

lanes!(
    /// Four numbers in double precision: a register of AVX2.
    F64x4, F64x4Mask: f64x4 of 4 f64
);
lanes!(
    /// Eight numbers in double precision: a register of AVX-512.
    F64x8, F64x8Mask: f64x8 of 8 f64
);
lanes!(
    /// Eight numbers in single precision: a register of AVX2.
    F32x8, F32x8Mask: f32x8 of 8 f32
);
lanes!(
    /// Sixteen numbers in single precision: a register of AVX-512.
    F32x16, F32x16Mask: f32x16 of 16 f32
);
