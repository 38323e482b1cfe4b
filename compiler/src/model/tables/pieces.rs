//! Knots → rows of bases and coefficients.

use super::slopes::{akima, monotone, pchip, secants};
use super::splines::{cubic, natural, periodic};
use crate::forms::{Interpolation, Outside};
use crate::symbolic::{BICUBIC, PATCHES};

/// The rows of a table of one argument: outside, from knot to knot, outside. x ascends.
///
/// Between knots a distance h apart, with the slope Δ of the line between them and slopes m, n at the knots,
/// y = a + b s + c s² + d s³ with a = y, b = m, c = (3 Δ − 2 m − n)/h, d = (m + n − 2 Δ)/h².
pub(super) fn of_line(x: &[f64], y: &[f64], kind: Interpolation, outside: Outside) -> Vec<f64> {
    let (widths, secants) = secants(x, y);
    let count = x.len();
    let (slopes, straight) = match kind {
        Interpolation::Linear | Interpolation::Bilinear => {
            (secants.iter().chain(secants.last()).copied().collect(), true)
        }
        Interpolation::Akima => (akima(&secants, false), false),
        Interpolation::ModifiedAkima => (akima(&secants, true), false),
        Interpolation::Monotone => (monotone(&widths, &secants), false),
        Interpolation::Pchip => (pchip(&widths, &secants), false),
        Interpolation::Cubic | Interpolation::Bicubic => (cubic(&widths, &secants), false),
        Interpolation::Natural => (natural(&widths, &secants), false),
        Interpolation::Periodic => (periodic(&widths, &secants), false),
    };
    let slopes: Vec<f64> = slopes;
    let slope_outside = |at: usize| if outside == Outside::Hold { 0.0 } else { slopes[at] };
    let mut rows = vec![[x[0], y[0], slope_outside(0), 0.0, 0.0]];
    for i in 0..count - 1 {
        let (h, rise, m, n) = (widths[i], secants[i], slopes[i], slopes[i + 1]);
        let bends = if straight { [0.0, 0.0] } else { bends(h, rise, [m, n]) };
        rows.push([x[i], y[i], m, bends[0], bends[1]]);
    }
    rows.push([x[count - 1], y[count - 1], slope_outside(count - 1), 0.0, 0.0]);
    rows.concat()
}

/// c and d of the piece with these slopes at its ends.
fn bends(h: f64, rise: f64, [m, n]: [f64; 2]) -> [f64; 2] {
    [(3.0 * rise - 2.0 * m - n) / h, (m + n - 2.0 * rise) / h / h]
}

/// The bases of one argument of a grid, as rows.
pub(super) fn of_axis(x: &[f64]) -> Vec<f64> {
    x[..1].iter().chain(x).copied().collect()
}

/// The patches of a grid, those of one row of the first argument one behind the other; `z` by rows of the second argument.
pub(super) fn of_grid(
    x: &[f64],
    y: &[f64],
    z: &[Vec<f64>],
    kind: Interpolation,
    outside: Outside,
) -> (usize, Vec<f64>) {
    match kind {
        Interpolation::Bicubic => (BICUBIC, bicubic(x, y, z, outside)),
        _ => (PATCHES, bilinear(x, y, z, outside)),
    }
}

/// Splines along x through splines along y: what is linear in the values does not mind the order.
fn bicubic(x: &[f64], y: &[f64], z: &[Vec<f64>], outside: Outside) -> Vec<f64> {
    let slopes = |x: &[f64], y: &[f64]| {
        let (widths, secants) = secants(x, y);
        cubic(&widths, &secants)
    };
    let turned = |rows: &[Vec<f64>]| -> Vec<Vec<f64>> {
        (0..rows[0].len()).map(|k| rows.iter().map(|row| row[k]).collect()).collect()
    };
    let by_x: Vec<Vec<f64>> = z.iter().map(|row| slopes(x, row)).collect();
    // Each by columns: along y.
    let by_y: Vec<Vec<f64>> = turned(z).iter().map(|column| slopes(y, column)).collect();
    let by_both: Vec<Vec<f64>> = turned(&by_x).iter().map(|column| slopes(y, column)).collect();
    let mut rows = Vec::new();
    for i in 0..=x.len() {
        for j in 0..=y.len() {
            // Of what is known along y for x at a knot: the value, or the slope by x.
            let value = |at: usize| factors(y, j, outside, |to| [z[to][at], by_y[at][to]]);
            let slope = |at: usize| factors(y, j, outside, |to| [by_x[to][at], by_both[at][to]]);
            let powers = [0, 1, 2, 3].map(|l| factors(x, i, outside, |at| [value(at)[l], slope(at)[l]]));
            rows.extend([x[i.saturating_sub(1)], y[j.saturating_sub(1)]]);
            rows.extend((0..4).flat_map(|k| powers.map(|of_t| of_t[k])));
        }
    }
    rows
}

/// The factors of the powers in one row along an axis, by values and slopes at the knots.
fn factors(x: &[f64], row: usize, outside: Outside, of: impl Fn(usize) -> [f64; 2]) -> [f64; 4] {
    let base = row.saturating_sub(1);
    let [value, slope] = of(base);
    if row == 0 || row == x.len() {
        return [value, if outside == Outside::Hold { 0.0 } else { slope }, 0.0, 0.0];
    }
    let [next, last] = of(row);
    let h = x[row] - x[base];
    let [c, d] = bends(h, (next - value) / h, [slope, last]);
    [value, slope, c, d]
}

fn bilinear(x: &[f64], y: &[f64], z: &[Vec<f64>], outside: Outside) -> Vec<f64> {
    // Row of an axis → the knot that it begins at, the interval whose slope it has, and whether it has one.
    let along = |row: usize, count: usize| {
        let out = row == 0 || row == count;
        let base = row.saturating_sub(1);
        (base, base.min(count - 2), !(out && outside == Outside::Hold))
    };
    let mut rows = Vec::new();
    for i in 0..=x.len() {
        for j in 0..=y.len() {
            let ((bx, ix, slopes_x), (by, iy, slopes_y)) = (along(i, x.len()), along(j, y.len()));
            let (h, k) = (x[ix + 1] - x[ix], y[iy + 1] - y[iy]);
            let by_x = |at: usize| (z[at][ix + 1] - z[at][ix]) / h;
            let by_y = |at: usize| (z[iy + 1][at] - z[iy][at]) / k;
            let both = (by_x(iy + 1) - by_x(iy)) / k;
            let b = if slopes_x { by_x(by) } else { 0.0 };
            let c = if slopes_y { by_y(bx) } else { 0.0 };
            let d = if slopes_x && slopes_y { both } else { 0.0 };
            rows.push([x[bx], y[by], z[by][bx], b, c, d]);
        }
    }
    rows.concat()
}
