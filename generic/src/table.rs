//! Functions by their values: cubic pieces between knots, grids of two arguments. The slopes at knots are in `slopes`.

use crate::number::Number;
use std::sync::Arc;

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
        let mut x = argument.value();
        if let Some((first, length)) = self.period {
            x -= length * ((x - first) / length).floor();
        }
        // The last piece whose start is not beyond x; the first counts for all before it.
        let behind = self.pieces[1..].partition_point(|(start, _)| *start <= x);
        let (start, [a, b, c, d]) = self.pieces[behind];
        let s = x - start;
        let value = a + s * (b + s * (c + s * d));
        let [first, second, third] = [b + s * (2.0 * c + s * 3.0 * d), 2.0 * c + 6.0 * d * s, 6.0 * d];
        if slope { argument.chain(first, second, third) } else { argument.chain(value, first, second) }
    }
}

impl Look {
    pub fn of<N: Number>(&self, a: N, b: N) -> N {
        match &*self.table {
            Table::Curve(curve) => curve.of(a, self.slope),
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
