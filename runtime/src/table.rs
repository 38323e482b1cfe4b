//! Tables: the row that an argument is in, found by a search of fixed length, and the polynomial of that row.
//!
//! A row is a base and coefficients, a number of rows is a power of two, and rows to fill it have NaN as their base: nothing is
//! above that. Each comparison of the search is one bit of the row, so that there is no branch, and the mask of the index leaves no
//! bound to check. The instructions are the same for every argument; what is no number gives none. Every lane of a
//! [`Real`] looks up for itself, by [`Real::cell`] and [`Real::row`].

use crate::real::Real;

/// The number of the row of x: how many bases from the second row on are not above x.
#[inline]
pub fn cell<R: Real, const K: usize, const N: usize>(rows: &[[f64; K]; N], x: R) -> R {
    x.cell(rows)
}

/// a + b s + c s² + d s³, or one of its derivatives up to the third.
#[inline]
fn cubic<R: Real>(order: u8, [a, b, c, d]: [R; 4], s: R) -> R {
    let (two, three, six) = (R::from_f64(2.0), R::from_f64(3.0), R::from_f64(6.0));
    match order {
        0 => d.mul_add(s, c).mul_add(s, b).mul_add(s, a),
        1 => (three * d).mul_add(s, two * c).mul_add(s, b),
        2 => (six * d).mul_add(s, two * c),
        // Zero times the argument, so that what is no number gives none.
        _ => R::ZERO.mul_add(s, six * d),
    }
}

/// a + b s + c s² + d s³ with s = x − base, of the row of that number.
#[inline]
pub fn value<R: Real, const N: usize>(rows: &[[f64; 5]; N], cell: R, x: R) -> R {
    let [base, a, b, c, d] = cell.row(rows);
    cubic(0, [a, b, c, d], x - base)
}

/// Its first derivative.
#[inline]
pub fn slope<R: Real, const N: usize>(rows: &[[f64; 5]; N], cell: R, x: R) -> R {
    let [base, a, b, c, d] = cell.row(rows);
    cubic(1, [a, b, c, d], x - base)
}

/// Its second derivative.
#[inline]
pub fn second<R: Real, const N: usize>(rows: &[[f64; 5]; N], cell: R, x: R) -> R {
    let [base, a, b, c, d] = cell.row(rows);
    cubic(2, [a, b, c, d], x - base)
}

/// Its third derivative.
#[inline]
pub fn third<R: Real, const N: usize>(rows: &[[f64; 5]; N], cell: R, x: R) -> R {
    let [base, a, b, c, d] = cell.row(rows);
    cubic(3, [a, b, c, d], x - base)
}

/// a + b s + c t + d s t with s = x − base, t = y − base, of the row of that number.
#[inline]
pub fn patch<R: Real, const N: usize>(rows: &[[f64; 6]; N], cell: R, x: R, y: R) -> R {
    let [first, second, a, b, c, d] = cell.row(rows);
    let (s, t) = (x - first, y - second);
    d.mul_add(t, b).mul_add(s, c.mul_add(t, a))
}

/// Its derivative by x.
#[inline]
pub fn patch_x<R: Real, const N: usize>(rows: &[[f64; 6]; N], cell: R, x: R, y: R) -> R {
    let [first, second, _, b, _, d] = cell.row(rows);
    R::ZERO.mul_add(x - first, d.mul_add(y - second, b))
}

/// Its derivative by y.
#[inline]
pub fn patch_y<R: Real, const N: usize>(rows: &[[f64; 6]; N], cell: R, x: R, y: R) -> R {
    let [first, second, _, _, c, d] = cell.row(rows);
    R::ZERO.mul_add(y - second, d.mul_add(x - first, c))
}

/// Its derivative by both.
#[inline]
pub fn patch_xy<R: Real, const N: usize>(rows: &[[f64; 6]; N], cell: R, x: R, y: R) -> R {
    let [first, second, _, _, _, d] = cell.row(rows);
    R::ZERO.mul_add(x - first, R::ZERO.mul_add(y - second, d))
}

/// Σ c s^k t^l with s = x − base, t = y − base, differentiated so often by x and by y, up to three times by each, of the row of that
/// number.
#[inline]
pub fn bicubic<R: Real, const N: usize>(rows: &[[f64; 18]; N], by_x: u8, by_y: u8, cell: R, x: R, y: R) -> R {
    let [first, second, factors @ ..] = cell.row(rows);
    let [a0, a1, a2, a3, b0, b1, b2, b3, c0, c1, c2, c3, d0, d1, d2, d3] = factors;
    let t = y - second;
    let powers = [[a0, a1, a2, a3], [b0, b1, b2, b3], [c0, c1, c2, c3], [d0, d1, d2, d3]];
    cubic(by_x, powers.map(|of_t| cubic(by_y, of_t, t)), x - first)
}

/// The search for one number.
#[inline]
pub(crate) fn find<const K: usize, const N: usize>(rows: &[[f64; K]; N], x: f64) -> u32 {
    const { assert!(N.is_power_of_two() && N <= 1 << 16 && K > 0) };
    let mut found = 0;
    let mut bit = N / 2;
    while bit > 0 {
        let base = rows.get((found | bit) & (N - 1)).and_then(|row| row.first()).copied().unwrap_or(f64::NAN);
        found |= usize::from(base <= x) * bit;
        bit /= 2;
    }
    found as u32
}

/// The row of that number for one number; an index beyond the end, which none has, comes round.
#[inline]
pub(crate) fn row<const K: usize, const N: usize>(rows: &[[f64; K]; N], cell: u32) -> [f64; K] {
    const { assert!(N.is_power_of_two()) };
    rows.get(cell as usize & (N - 1)).copied().unwrap_or([f64::NAN; K])
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILL: [f64; 5] = [f64::NAN; 5];
    /// (1, 0), (2, 2), (5, 5), level below and above, with a cube above 2.
    const ROWS: [[f64; 5]; 8] = [
        [1.0, 0.0, 0.0, 0.0, 0.0],
        [1.0, 0.0, 2.0, 0.0, 0.0],
        [2.0, 2.0, 1.0, -0.5, 0.25],
        [5.0, 5.0, 0.0, 0.0, 0.0],
        FILL,
        FILL,
        FILL,
        FILL,
    ];

    #[test]
    fn rows_begin_at_their_bases() {
        for (x, row) in [(0.9, 0.0), (1.0, 1.0), (1.9, 1.0), (2.0, 2.0), (4.9, 2.0), (5.0, 3.0), (1e300, 3.0)]
        {
            assert_eq!(cell(&ROWS, x), row);
            assert_eq!(cell(&ROWS, x as f32), row as f32, "{x}");
        }
        assert_eq!(cell(&ROWS, f64::INFINITY), 3.0);
        assert_eq!(cell(&ROWS, f64::NEG_INFINITY), 0.0);
        assert_eq!(cell(&[[3.0]], 5.0), 0.0);
    }

    #[test]
    fn polynomials_and_their_derivatives() {
        let row = cell(&ROWS, 3.0);
        assert_eq!(value(&ROWS, row, 3.0), 2.0 + 1.0 - 0.5 + 0.25);
        assert_eq!(slope(&ROWS, row, 3.0), 1.0 - 1.0 + 0.75);
        assert_eq!(second(&ROWS, row, 3.0), -1.0 + 1.5);
        assert_eq!(third(&ROWS, row, 3.0), 1.5);
        let patches = [[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]];
        assert_eq!(patch(&patches, 0.0_f32, 2.0, 4.0), 3.0 + 4.0 + 10.0 + 12.0);
        assert_eq!(patch_x(&patches, 0.0, 2.0, 4.0), 4.0 + 12.0);
        assert_eq!(patch_y(&patches, 0.0, 2.0, 4.0), 5.0 + 6.0);
        assert_eq!(patch_xy(&patches, 0.0, 2.0, 4.0), 6.0);
    }

    #[test]
    fn what_is_no_number_gives_none() {
        let row = cell(&ROWS, f64::NAN);
        for of in [value, slope, second, third] {
            assert!(of(&ROWS, row, f64::NAN).is_nan());
            // Nor does a row that is none panic.
            of(&ROWS, f64::NAN, 1.0);
            of(&ROWS, 1e9, 1.0);
        }
        let patches = [[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]];
        for of in [patch, patch_x, patch_y, patch_xy] {
            assert!(of(&patches, 0.0, f64::NAN, 1.0).is_nan() && of(&patches, 0.0, 1.0, f64::NAN).is_nan());
        }
    }
}
