//! Vectors of scalars, whose length is a matter of their type or of the mechanism.
//!
//! A compiled mechanism names its own array types (`[R; 9]` for positions, and so on), whose lengths the optimiser knows; one
//! that is read while the program runs may keep its entries in lists. [`Vector`] is what the rest of the runtime needs of both.
//! No geometry here: what the entries mean is said by `layout.rs`.

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

/// aᵀ b; what one has beyond the other does not count.
pub(crate) fn dot<R: Real>(a: &[R], b: &[R]) -> R {
    a.iter().zip(b).fold(R::ZERO, |sum, (&a, &b)| a.mul_add(b, sum))
}

/// Writes the entries of `from` over those of `into` in the lanes of the mask.
#[inline(always)]
pub(crate) fn blend<R: Real, V: Vector<R>>(mask: R::Mask, from: &V, into: &mut V) {
    for (into, &from) in into.as_mut_slice().iter_mut().zip(from.as_slice()) {
        *into = R::select(mask, from, *into);
    }
}

/// A vector over the scalars `R`; implemented for `[R; N]`, and for `()`, which has no entries.
///
/// The length never changes. Vectors that belong to one place of one mechanism, such as its velocities, have the same.
/// ```
/// use linkwright_runtime::Vector;
///
/// /// Entries in a list, as long as a definition says.
/// #[derive(Clone, Debug, PartialEq)]
/// struct Entries(Vec<f64>);
///
/// impl Vector<f64> for Entries {
///     fn zeros(len: usize) -> Self {
///         Entries(vec![0.0; len])
///     }
///     fn as_slice(&self) -> &[f64] {
///         &self.0
///     }
///     fn as_mut_slice(&mut self) -> &mut [f64] {
///         &mut self.0
///     }
/// }
///
/// let mut x = Entries::zeros(2);
/// x.axpy(2.0, &Entries(vec![1.0, -3.0]));
/// assert_eq!((x.max_abs(), x.as_slice().len()), (6.0, 2));
/// ```
pub trait Vector<R: Real>: Clone + Debug + PartialEq + 'static {
    /// The vector of so many zeros. An array has the length of its type, whatever is asked for; that it is another one is a fault
    /// of the mechanism's tables, which a build with debug assertions finds.
    fn zeros(len: usize) -> Self;
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
        let mut sum = self.clone();
        sum.axpy(a, x);
        sum
    }

    /// `a·self`.
    #[inline]
    fn scaled(&self, a: R) -> Self {
        let mut product = self.clone();
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
    #[inline(always)]
    fn zeros(len: usize) -> Self {
        debug_assert_eq!(len, N, "the length of a vector is that of its array");
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
    #[inline(always)]
    fn zeros(len: usize) -> Self {
        debug_assert_eq!(len, 0, "nothing has no entries");
    }
    #[inline(always)]
    fn as_slice(&self) -> &[R] {
        &[]
    }
    #[inline(always)]
    fn as_mut_slice(&mut self) -> &mut [R] {
        &mut []
    }
}
