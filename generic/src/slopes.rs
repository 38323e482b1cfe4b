//! The pieces of curves between knots: Hermite's polynomials by slopes at the knots, splines by their second derivatives there.

use crate::number::sign;
use crate::solver::{Algebra, Solver};
use std::collections::BTreeMap;

type Piece = [f64; 4];

/// The pieces of a curve of this kind; `None` where the knots are too few for it. `x` ascends.
pub(crate) fn pieces(x: &[f64], y: &[f64], kind: &str) -> Option<Vec<Piece>> {
    let h: Vec<f64> = x.windows(2).map(|x| x[1] - x[0]).collect();
    let rise: Vec<f64> = y.windows(2).zip(&h).map(|(y, h)| (y[1] - y[0]) / h).collect();
    if h.is_empty() {
        return None;
    }
    match kind {
        "linear" => Some(y.iter().zip(&rise).map(|(y, rise)| [*y, *rise, 0.0, 0.0]).collect()),
        "cubic" | "natural" | "periodic" => splines(&h, &rise, y, kind),
        _ if h.len() == 1 => Some(vec![[y[0], rise[0], 0.0, 0.0]]),
        "monotone" => Some(hermite(&h, &rise, y, &steffen(&h, &rise))),
        "pchip" => Some(hermite(&h, &rise, y, &pchip(&h, &rise))),
        "akima" => {
            let flat = |m: &[f64]| 0.5 * (m[1] + m[2]);
            Some(hermite(&h, &rise, y, &akima(&rise, |a, b| (b - a).abs(), flat, 1e-9)))
        }
        "modified_akima" => {
            let weight = |a: f64, b: f64| (b - a).abs() + 0.5 * (a + b).abs();
            Some(hermite(&h, &rise, y, &akima(&rise, weight, |_| 0.0, 0.0)))
        }
        _ => None,
    }
}

fn hermite(h: &[f64], rise: &[f64], y: &[f64], m: &[f64]) -> Vec<Piece> {
    let piece = |i: usize| {
        let c = (3.0 * rise[i] - 2.0 * m[i] - m[i + 1]) / h[i];
        let d = (m[i] + m[i + 1] - 2.0 * rise[i]) / (h[i] * h[i]);
        [y[i], m[i], c, d]
    };
    (0..h.len()).map(piece).collect()
}

/// Slopes that never leave the values beside them (Steffen 1990).
fn steffen(h: &[f64], rise: &[f64]) -> Vec<f64> {
    let end = |h: [f64; 2], s: [f64; 2]| {
        let share = h[0] / (h[0] + h[1]);
        let p = s[0] * (1.0 + share) - s[1] * share;
        if p * s[0] <= 0.0 {
            0.0
        } else if p.abs() > 2.0 * s[0].abs() {
            2.0 * s[0]
        } else {
            p
        }
    };
    let inner = |i: usize| {
        let p = (rise[i - 1] * h[i] + rise[i] * h[i - 1]) / (h[i - 1] + h[i]);
        let least = rise[i - 1].abs().min(rise[i].abs()).min(0.5 * p.abs());
        (sign(rise[i - 1]) + sign(rise[i])) * least
    };
    at_knots(h, rise, end, inner)
}

/// As SciPy's `PchipInterpolator` (Fritsch & Butland 1984).
fn pchip(h: &[f64], rise: &[f64]) -> Vec<f64> {
    let end = |h: [f64; 2], s: [f64; 2]| {
        let d = ((2.0 * h[0] + h[1]) * s[0] - h[0] * s[1]) / (h[0] + h[1]);
        if sign(d) != sign(s[0]) {
            0.0
        } else if sign(s[0]) != sign(s[1]) && d.abs() > 3.0 * s[0].abs() {
            3.0 * s[0]
        } else {
            d
        }
    };
    let inner = |i: usize| {
        if rise[i - 1] * rise[i] <= 0.0 {
            return 0.0;
        }
        let (a, b) = (2.0 * h[i] + h[i - 1], h[i] + 2.0 * h[i - 1]);
        (a + b) / (a / rise[i - 1] + b / rise[i])
    };
    at_knots(h, rise, end, inner)
}

fn at_knots(
    h: &[f64],
    rise: &[f64],
    end: impl Fn([f64; 2], [f64; 2]) -> f64,
    inner: impl Fn(usize) -> f64,
) -> Vec<f64> {
    let n = h.len();
    let mut slopes = vec![end([h[0], h[1]], [rise[0], rise[1]])];
    slopes.extend((1..n).map(inner));
    slopes.push(end([h[n - 1], h[n - 2]], [rise[n - 1], rise[n - 2]]));
    slopes
}

/// Means of the neighbouring rises by how little they change further on (Akima 1970); rises go on straight beyond the ends.
fn akima(
    rise: &[f64],
    weight: impl Fn(f64, f64) -> f64,
    flat: impl Fn(&[f64]) -> f64,
    least: f64,
) -> Vec<f64> {
    let n = rise.len();
    let low = 2.0 * rise[0] - rise[1];
    let high = 2.0 * rise[n - 1] - rise[n - 2];
    let mut m = vec![2.0 * low - rise[0], low];
    m.extend_from_slice(rise);
    m.extend([high, 2.0 * high - rise[n - 1]]);
    let weights: Vec<(f64, f64)> =
        (0..=n).map(|i| (weight(m[i], m[i + 1]), weight(m[i + 2], m[i + 3]))).collect();
    let least = least * weights.iter().map(|(a, b)| a + b).fold(0.0, f64::max);
    let slope = |(i, (a, b)): (usize, &(f64, f64))| {
        if a + b > least { (b * m[i + 1] + a * m[i + 2]) / (a + b) } else { flat(&m[i..i + 4]) }
    };
    weights.iter().enumerate().map(slope).collect()
}

/// By the second derivatives M at the knots, straight between them, so that the first one is continuous (de Boor 1978):
/// h₋ M₋/6 + (h₋ + h) M/3 + h M₊/6 = rise − rise₋, and a condition at either end.
fn splines(h: &[f64], rise: &[f64], y: &[f64], kind: &str) -> Option<Vec<Piece>> {
    let n = h.len();
    if n < if kind == "cubic" { 3 } else { 2 } {
        return None;
    }
    let mut system: BTreeMap<(usize, usize), f64> = BTreeMap::new();
    let mut add =
        |row: usize, column: usize, value: f64| *system.entry((row, column)).or_insert(0.0) += value;
    let mut right = vec![0.0; n + 1];
    for i in 1..n {
        add(i, i - 1, h[i - 1] / 6.0);
        add(i, i, (h[i - 1] + h[i]) / 3.0);
        add(i, i + 1, h[i] / 6.0);
        right[i] = rise[i] - rise[i - 1];
    }
    match kind {
        "natural" => {
            add(0, 0, 1.0);
            add(n, n, 1.0);
        }
        // The third derivative is continuous at the second knot and at the last but one.
        "cubic" => {
            for (row, at) in [(0, 0), (n, n - 2)] {
                add(row, at, -1.0 / h[at]);
                add(row, at + 1, 1.0 / h[at] + 1.0 / h[at + 1]);
                add(row, at + 2, -1.0 / h[at + 1]);
            }
        }
        _ => {
            add(0, 0, 1.0);
            add(0, n, -1.0);
            add(n, 0, h[0] / 3.0);
            add(n, 1, h[0] / 6.0);
            add(n, n - 1, h[n - 1] / 6.0);
            add(n, n, h[n - 1] / 3.0);
            right[n] = rise[0] - rise[n - 1];
        }
    }
    let pattern: Vec<(usize, usize)> = system.keys().copied().collect();
    let mut solver = Solver::new(n + 1, &pattern, Algebra::Sparse).ok()?;
    solver.factor(system.into_values()).ok()?;
    solver.solve(&mut right);
    let piece = |i: usize| {
        let slope = rise[i] - h[i] * (2.0 * right[i] + right[i + 1]) / 6.0;
        [y[i], slope, right[i] / 2.0, (right[i + 1] - right[i]) / (6.0 * h[i])]
    };
    Some((0..n).map(piece).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    const X: [f64; 6] = [0.0, 0.7, 1.5, 2.0, 3.1, 4.0];

    /// All pass through their values, and their slopes are continuous but for straight ones.
    #[test]
    fn pieces_meet_at_the_knots() {
        let y = [0.3, 1.2, 0.9, 0.9, -0.4, 0.3];
        for kind in ["linear", "monotone", "pchip", "akima", "modified_akima", "cubic", "natural", "periodic"]
        {
            let pieces = pieces(&X, &y, kind).expect("enough knots");
            for i in 0..5 {
                let s = X[i + 1] - X[i];
                let [a, b, c, d] = pieces[i];
                assert!((a + s * (b + s * (c + s * d)) - y[i + 1]).abs() < 1e-14, "{kind}");
                if kind != "linear" && i < 4 {
                    let slope = b + s * (2.0 * c + s * 3.0 * d);
                    assert!((slope - pieces[i + 1][1]).abs() < 1e-13, "{kind}");
                }
            }
        }
    }

    /// Not-a-knot splines are exact for cubics.
    #[test]
    fn a_cubic_is_its_own_spline() {
        let y = X.map(|x| 1.0 + x * (2.0 - x * (3.0 - 0.5 * x)));
        for ([a, b, c, d], x) in pieces(&X, &y, "cubic").expect("enough knots").into_iter().zip(X) {
            let expected =
                [1.0 + x * (2.0 - x * (3.0 - 0.5 * x)), 2.0 - x * (6.0 - 1.5 * x), -3.0 + 1.5 * x, 0.5];
            assert!([a, b, c, d].iter().zip(expected).all(|(found, value)| (found - value).abs() < 1e-12));
        }
    }
}
