//! Fixed-length vectors of scalars.
//!
//! A mechanism names its own array types (`[R; 9]` for positions, and so on), because stable Rust cannot yet compute
//! an array's length from an associated constant; [`Vector`] is what the rest of the runtime needs of them. No
//! geometry here: what the entries mean is said by `layout.rs`.

use crate::real::Real;
use core::fmt::Debug;

/// Entry `index`, zero beyond the end. Indices come from tables made at expansion and lie within; this way no image that the runtime
/// is linked into has to hold the message of a panic that cannot happen, and the comparison costs the same.
#[inline(always)]
pub(crate) fn at<R: Real>(entries: &[R], index: usize) -> R {
    entries.get(index).copied().unwrap_or(R::ZERO)
}

/// Writes entry `index`; nothing beyond the end.
#[inline(always)]
pub(crate) fn put<R: Real>(entries: &mut [R], index: usize, value: R) {
    if let Some(entry) = entries.get_mut(index) {
        *entry = value;
    }
}

/// A vector of fixed length over the scalars `R`; implemented for `[R; N]`, and for `()`, which has no entries.
pub trait Vector<R: Real>: Copy + Debug + PartialEq + 'static {
    /// The number of entries.
    const LEN: usize;

    /// The vector of zeros.
    fn zero() -> Self;
    /// The entries, first to last.
    fn as_slice(&self) -> &[R];
    /// The entries, first to last, to be written.
    fn as_mut_slice(&mut self) -> &mut [R];

    /// `self ← self + a·x`.
    #[inline]
    fn axpy(&mut self, a: R, x: &Self) {
        for (entry, &x) in self.as_mut_slice().iter_mut().zip(x.as_slice()) {
            *entry = a.mul_add(x, *entry);
        }
    }

    /// `self + a·x`.
    #[inline]
    fn plus(&self, a: R, x: &Self) -> Self {
        let mut sum = *self;
        sum.axpy(a, x);
        sum
    }

    /// `a·self`.
    #[inline]
    fn scaled(&self, a: R) -> Self {
        let mut product = *self;
        for entry in product.as_mut_slice() {
            *entry = a * *entry;
        }
        product
    }

    /// max |xᵢ|, zero for the empty vector.
    fn max_abs(&self) -> R {
        self.as_slice().iter().fold(R::ZERO, |largest, entry| largest.max(entry.abs()))
    }

    /// Σ xᵢ².
    fn norm_squared(&self) -> R {
        self.as_slice().iter().fold(R::ZERO, |sum, &entry| entry.mul_add(entry, sum))
    }

    /// The index of the first entry that is infinite or NaN.
    #[inline]
    fn first_not_finite(&self) -> Option<usize> {
        self.as_slice().iter().position(|entry| !entry.is_finite())
    }
}

impl<R: Real, const N: usize> Vector<R> for [R; N] {
    const LEN: usize = N;

    #[inline(always)]
    fn zero() -> Self {
        [R::ZERO; N]
    }
    #[inline(always)]
    fn as_slice(&self) -> &[R] {
        self
    }
    #[inline(always)]
    fn as_mut_slice(&mut self) -> &mut [R] {
        self
    }
}

impl<R: Real> Vector<R> for () {
    const LEN: usize = 0;

    #[inline(always)]
    fn zero() -> Self {}
    #[inline(always)]
    fn as_slice(&self) -> &[R] {
        &[]
    }
    #[inline(always)]
    fn as_mut_slice(&mut self) -> &mut [R] {
        &mut []
    }
}
