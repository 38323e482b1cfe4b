//! A small dense factorisation P R A C = L U with partial pivoting, for matrices without symmetry.
//!
//! Rows and columns are first scaled by R and C to largest entries of 1, so that metres beside newtons do not decide which
//! pivots are taken, and so that a pivot has a size by itself.

use crate::real::Real;
use crate::vector::{at, put};

/// The factors, in the place of the matrix; n unknowns, everything row by row.
pub(crate) struct Lu<'w, R> {
    /// A, then L (below the diagonal, whose ones are not stored) and U.
    pub(crate) entries: &'w mut [R],
    /// R and C.
    pub(crate) rows: &'w mut [R],
    pub(crate) columns: &'w mut [R],
    /// The row that step k exchanged with row k.
    pub(crate) order: &'w mut [u16],
}

/// The matrix is singular: no pivot is left for this unknown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct NoPivot<R> {
    pub(crate) unknown: usize,
    /// The largest candidate, relative to its row and column.
    pub(crate) pivot: R,
}

impl<R: Real> Lu<'_, R> {
    /// Scales and factors in place.
    pub(crate) fn factor(&mut self) -> Result<(), NoPivot<R>> {
        self.factor_above(R::BREAKDOWN)
    }

    /// The same with another bound for pivots: zero where an iteration shows by itself whether the factors are good.
    pub(crate) fn factor_above(&mut self, least: R) -> Result<(), NoPivot<R>> {
        let n = self.order.len();
        self.scale(n)?;
        let mut rest = &mut *self.entries;
        for (k, order) in self.order.iter_mut().enumerate() {
            let Some((own, below)) = rest.split_at_mut_checked(n) else { break };
            let rows = || below.chunks_exact(n.max(1)).enumerate();
            let (largest, pivot) = rows().fold((0, at(own, k)), |best, (i, row)| {
                if at(row, k).abs() > best.1.abs() { (i + 1, at(row, k)) } else { best }
            });
            // Written so that a NaN fails.
            if pivot == R::ZERO || !R::any(pivot.abs().greater_equal(least)) {
                return Err(NoPivot { unknown: k, pivot: pivot.abs() });
            }
            *order = (k + largest) as u16;
            if let Some(row) = largest.checked_sub(1).and_then(|i| below.chunks_exact_mut(n.max(1)).nth(i)) {
                own.iter_mut().zip(row).for_each(|(a, b)| core::mem::swap(a, b));
            }
            for row in below.chunks_exact_mut(n.max(1)) {
                let factor = at(row, k) / pivot;
                put(row, k, factor);
                if factor != R::ZERO {
                    for (entry, &above) in row.iter_mut().zip(own.iter()).skip(k + 1) {
                        *entry = *entry - factor * above;
                    }
                }
            }
            rest = below;
        }
        Ok(())
    }

    /// Divides rows, then columns, by their largest entries; a row or column of zeros has none.
    fn scale(&mut self, n: usize) -> Result<(), NoPivot<R>> {
        let largest = |largest: R, entry: &R| largest.max(entry.abs());
        let step = n.max(1);
        for (unknown, (row, scale)) in
            self.entries.chunks_exact_mut(step).zip(self.rows.iter_mut()).enumerate()
        {
            let size = row.iter().fold(R::ZERO, largest);
            *scale = invert(size, unknown)?;
            row.iter_mut().for_each(|entry| *entry = *entry * *scale);
        }
        for (column, scale) in self.columns.iter_mut().enumerate() {
            let size = self.entries.iter().skip(column).step_by(step).fold(R::ZERO, largest);
            *scale = invert(size, column)?;
            for entry in self.entries.iter_mut().skip(column).step_by(step) {
                *entry = *entry * *scale;
            }
        }
        Ok(())
    }

    /// x ← A⁻¹ x; gives the Euclidean norm of C⁻¹ x, in which all unknowns weigh alike.
    pub(crate) fn solve(&self, x: &mut [R]) -> R {
        let n = self.order.len();
        for (entry, &scale) in x.iter_mut().zip(self.rows.iter()) {
            *entry = *entry * scale;
        }
        for (k, &other) in self.order.iter().enumerate() {
            let (own, exchanged) = (at(x, k), at(x, other as usize));
            put(x, k, exchanged);
            put(x, other as usize, own);
        }
        let rows = || self.entries.chunks_exact(n.max(1)).enumerate();
        for (k, row) in rows() {
            let terms = row.iter().zip(x.iter()).take(k);
            let value = terms.fold(at(x, k), |rest, (&l, &x)| rest - l * x);
            put(x, k, value);
        }
        for (k, row) in rows().rev() {
            let terms = row.iter().zip(x.iter()).skip(k + 1);
            let rest = terms.fold(at(x, k), |rest, (&u, &x)| rest - u * x);
            put(x, k, rest / at(row, k));
        }
        let norm = x.iter().fold(R::ZERO, |sum, &entry| sum + entry * entry).sqrt();
        for (entry, &scale) in x.iter_mut().zip(self.columns.iter()) {
            *entry = *entry * scale;
        }
        norm
    }
}

fn invert<R: Real>(size: R, unknown: usize) -> Result<R, NoPivot<R>> {
    let inverse = R::ONE / size;
    if size > R::ZERO && inverse.is_finite() && size.is_finite() {
        return Ok(inverse);
    }
    Err(NoPivot { unknown, pivot: R::ZERO })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn factored<const N: usize>(entries: &mut [f64], check: impl FnOnce(Result<(), NoPivot<f64>>, &Lu<f64>)) {
        let (mut rows, mut columns, mut order) = ([0.0; N], [0.0; N], [0; N]);
        let mut lu = Lu { entries, rows: &mut rows, columns: &mut columns, order: &mut order };
        let result = lu.factor();
        check(result, &lu);
    }

    #[test]
    fn badly_scaled_systems_are_solved() {
        // Zero on the diagonal, newtons beside metres.
        let a = [[0.0, 2e8, 1.0], [1e8, 3e8, 0.0], [4e-6, 1.0, 1e-9]];
        let exact = [0.5, -3.0, 7e7];
        let mut x = a.map(|row| row.iter().zip(exact).map(|(a, x)| a * x).sum::<f64>());
        factored::<3>(&mut a.concat(), |result, lu| {
            assert_eq!(result, Ok(()));
            lu.solve(&mut x);
        });
        for (found, exact) in x.iter().zip(exact) {
            assert!((found - exact).abs() < 1e-13 * exact.abs(), "{x:?}");
        }
    }

    #[test]
    fn the_norm_weighs_all_unknowns_alike() {
        let mut x = [3.0, 8e6];
        factored::<2>(&mut [1.0, 0.0, 0.0, 2e6], |result, lu| {
            assert_eq!(result, Ok(()));
            assert_eq!(lu.solve(&mut x), 5.0);
        });
        assert_eq!(x, [3.0, 4.0]);
    }

    #[test]
    fn what_is_singular_is_named() {
        factored::<3>(&mut [1.0, 2.0, 3.0, 2.0, 4.0, 6.5, 1.0, 2.0, -1.0], |result, _| {
            assert_eq!(result.map_err(|error| error.unknown), Err(1));
        });
        factored::<2>(&mut [1.0, 2.0, 0.0, 0.0], |result, _| {
            assert_eq!(result, Err(NoPivot { unknown: 1, pivot: 0.0 }));
        });
        factored::<2>(&mut [1.0, f64::NAN, 1.0, 2.0], |result, _| assert!(result.is_err()));
        factored::<0>(&mut [], |result, _| assert_eq!(result, Ok(())));
    }
}
