//! Functions by their values: cubic pieces between knots, grids of two arguments. The slopes at knots are in `slopes`.

use crate::number::Number;
use std::sync::Arc;

/// Passes for a foot.
const FEET: usize = 60;

/// A function of one argument or two.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Table {
    Curve(Curve),
    /// Straight along both arguments; the values row by row of the second.
    Grid {
        x: Vec<f64>,
        y: Vec<f64>,
        values: Vec<Vec<f64>>,
        hold: bool,
    },
    /// Σ row_j(x) share_j(y): splines along x, each with the spline along y that is one at its knot and zero at the others.
    Sheet {
        rows: Vec<Curve>,
        shares: Vec<Curve>,
    },
    /// Of the two coordinates of a place, how far it is out of a closed curve base + r(φ) about their origin.
    Profile {
        curve: Curve,
        base: f64,
    },
}

/// A table and whether its value or its derivative by its argument is asked for.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Look {
    pub table: Arc<Table>,
    pub slope: bool,
}

/// Pieces a + b s + c s² + d s³ with s = x − start, each from its start on.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Curve {
    pieces: Vec<(f64, [f64; 4])>,
    /// First argument and length of what repeats itself.
    period: Option<(f64, f64)>,
}

impl Curve {
    /// From the pieces between the knots; before the first and behind the last knot the curve is straight.
    pub fn new(x: &[f64], y: &[f64], inner: Vec<[f64; 4]>, hold: bool, periodic: bool) -> Option<Self> {
        let ([first, .., last], [low, .., high]) = (x, y) else { return None };
        let (begin, end) = (inner.first()?, inner.last()?);
        let width = last - x.get(x.len().checked_sub(2)?)?;
        let kept = if hold { 0.0 } else { 1.0 };
        let slope = end[1] + width * (2.0 * end[2] + width * 3.0 * end[3]);
        // Any argument is beyond the start of the first piece; where that is does not matter to s.
        let mut pieces = vec![(*first, [*low, kept * begin[1], 0.0, 0.0])];
        pieces.extend(x.iter().copied().zip(inner));
        pieces.push((*last, [*high, kept * slope, 0.0, 0.0]));
        Some(Curve { pieces, period: periodic.then_some((*first, last - first)) })
    }

    fn of<N: Number>(&self, argument: N, slope: bool) -> N {
        let [value, first, second, third] = self.derivatives(argument.value());
        if slope { argument.chain(first, second, third) } else { argument.chain(value, first, second) }
    }

    fn derivatives(&self, mut x: f64) -> [f64; 4] {
        if let Some((first, length)) = self.period {
            x -= length * ((x - first) / length).floor();
        }
        // The last piece whose start is not beyond x; the first counts for all before it.
        let behind = self.pieces[1..].partition_point(|(start, _)| *start <= x);
        let (start, [a, b, c, d]) = self.pieces[behind];
        let s = x - start;
        let value = a + s * (b + s * (c + s * d));
        [value, b + s * (2.0 * c + s * 3.0 * d), 2.0 * c + 6.0 * d * s, 6.0 * d]
    }

    /// The distance of a place from the curve in polar form: its foot c is found to rounding. Near p the distance is
    /// n·(x − c) + κ/(2 (1 + κ d)) (t·(x − c))², to the second order.
    fn distance<N: Number>(&self, base: f64, [x, y]: [N; 2]) -> N {
        let (p, q) = (x.value(), y.value());
        let mut angle = q.atan2(p);
        // c, c′ and c″.
        let curve = |angle: f64| {
            let [mut r, first, second, _] = self.derivatives(angle);
            r += base;
            let (sin, cos) = angle.sin_cos();
            let along = |u: f64, v: f64| [u * cos - v * sin, u * sin + v * cos];
            [along(r, 0.0), along(first, r), along(second - r, 2.0 * first)]
        };
        for _ in 0..FEET {
            let [c, to, bent] = curve(angle);
            let out = [p - c[0], q - c[1]];
            let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
            let step = dot(out, to) / (dot(to, to) - dot(out, bent)).max(0.1 * dot(to, to));
            angle += step;
            if step.abs() < 1e-16 {
                break;
            }
        }
        let [c, to, bent] = curve(angle);
        let size = to[0].hypot(to[1]);
        let [t, u] = [to[0] / size, to[1] / size];
        let curvature = (to[0] * bent[1] - to[1] * bent[0]) / (size * size * size);
        let (a, b) = (x.minus(N::constant(c[0])), y.minus(N::constant(c[1])));
        let (out, along) = (a.scaled(u).minus(b.scaled(t)), a.scaled(t).plus(b.scaled(u)));
        let bent = curvature / (1.0 + curvature * out.value());
        out.plus(along.times(along).scaled(0.5 * bent))
    }
}

impl Look {
    pub fn of<N: Number>(&self, a: N, b: N) -> N {
        match &*self.table {
            Table::Curve(curve) => curve.of(a, self.slope),
            Table::Profile { curve, base } => curve.distance(*base, [a, b]),
            Table::Grid { x, y, values, hold } => {
                let ((i, right), (j, above)) = (share(x, a, *hold), share(y, b, *hold));
                let along = |j: usize| {
                    let rise = values[j][i + 1] - values[j][i];
                    right.scaled(rise).plus(N::constant(values[j][i]))
                };
                let (low, high) = (along(j), along(j + 1));
                low.plus(above.times(high.minus(low)))
            }
            Table::Sheet { rows, shares } => {
                let terms =
                    rows.iter().zip(shares).map(|(row, share)| row.of(a, false).times(share.of(b, false)));
                terms.fold(N::constant(0.0), N::plus)
            }
        }
    }
}

/// The interval that a value is in, the outer ones without end, and which share of it is passed.
fn share<N: Number>(knots: &[f64], argument: N, hold: bool) -> (usize, N) {
    let value = argument.value();
    let last = knots.len() - 2;
    let at = knots[1..=last].partition_point(|knot| *knot <= value);
    let (start, width) = (knots[at], knots[at + 1] - knots[at]);
    if hold && !(knots[0]..=knots[last + 1]).contains(&value) {
        let held = value.clamp(knots[0], knots[last + 1]);
        return (at, N::constant((held - start) / width));
    }
    (at, argument.minus(N::constant(start)).scaled(1.0 / width))
}
