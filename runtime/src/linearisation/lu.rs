//! A small dense factorisation P R A C = L U with partial pivoting, for matrices without symmetry.
//!
//! Rows and columns are first scaled by R and C to largest entries of 1, so that metres beside newtons do not decide which
//! pivots are taken, and so that a pivot has a size by itself.

use crate::real::Real;

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
        for k in 0..n {
            let at = |i: usize| i * n + k;
            let largest = (k..n).fold(k, |best, i| {
                if self.entries[at(i)].abs() > self.entries[at(best)].abs() { i } else { best }
            });
            let pivot = self.entries[at(largest)];
            // Written so that a NaN fails.
            if pivot == R::ZERO || !R::any(pivot.abs().greater_equal(least)) {
                return Err(NoPivot { unknown: k, pivot: pivot.abs() });
            }
            self.order[k] = largest as u16;
            for column in 0..n {
                self.entries.swap(k * n + column, largest * n + column);
            }
            let (above, below) = self.entries.split_at_mut((k + 1) * n);
            let own = &above[k * n..];
            for row in below.chunks_exact_mut(n) {
                let factor = row[k] / pivot;
                row[k] = factor;
                if factor != R::ZERO {
                    for (entry, &above) in row[k + 1..].iter_mut().zip(&own[k + 1..]) {
                        *entry = *entry - factor * above;
                    }
                }
            }
        }
        Ok(())
    }

    /// Divides rows, then columns, by their largest entries; a row or column of zeros has none.
    fn scale(&mut self, n: usize) -> Result<(), NoPivot<R>> {
        let largest = |largest: R, entry: &R| largest.max(entry.abs());
        for (unknown, row) in self.entries.chunks_exact_mut(n.max(1)).enumerate() {
            let size = row.iter().fold(R::ZERO, largest);
            self.rows[unknown] = invert(size, unknown)?;
            row.iter_mut().for_each(|entry| *entry = *entry * self.rows[unknown]);
        }
        for column in 0..n {
            let size = self.entries[column..].iter().step_by(n).fold(R::ZERO, largest);
            self.columns[column] = invert(size, column)?;
            for entry in self.entries[column..].iter_mut().step_by(n) {
                *entry = *entry * self.columns[column];
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
            x.swap(k, other as usize);
        }
        for k in 0..n {
            let row = &self.entries[k * n..k * n + k];
            x[k] = row.iter().zip(x.iter()).fold(x[k], |rest, (&l, &x)| rest - l * x);
        }
        for k in (0..n).rev() {
            let row = &self.entries[k * n + k + 1..(k + 1) * n];
            let rest = row.iter().zip(&x[k + 1..]).fold(x[k], |rest, (&u, &x)| rest - u * x);
            x[k] = rest / self.entries[k * n + k];
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
