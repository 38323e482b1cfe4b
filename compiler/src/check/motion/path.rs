//! A mechanism with one degree of freedom along its motion: one position after another, by the distance travelled.
//!
//! Predictor: along the null vector t of D. Corrector: Newton's method, each step the shortest with D δ = −Φ. The
//! parameter is the distance travelled and no coordinate of a joint, so that dead centres are positions like all others
//! (Allgower & Georg, Introduction to Numerical Continuation Methods, chapters 3 and 6). Distances weigh turns by 1 rad
//! and lengths by the size of the mechanism; t has its largest entry 1.

use crate::check::assemble::{Ancestry, Point, retract};
use crate::equations::{Condition, Equations};
use crate::model::Mechanism;
use crate::solve::table::{Numeric, Table};

/// Steps of the corrector; from a good prediction three are enough.
const CORRECTIONS: usize = 8;
/// A correction this short is the last: the next would be of its square.
const SETTLED: f64 = 1e-9;

/// The mechanism at any of its positions.
pub struct Path<'a> {
    point: Point<'a>,
    /// Constraint rows of the motion: drivers and redundant rows have none.
    rows: Vec<usize>,
    /// Coordinates that are watched.
    pub watched: Vec<Condition>,
    ancestry: Ancestry,
    table: Table,
    /// 1 of turns, 1/(length of the mechanism) of lengths, by index of velocity.
    scales: Vec<f64>,
    /// Squares of the rows in their full size, as [`Path::regularity`] compares them.
    full: Vec<f64>,
}

/// One position.
#[derive(Clone, Debug)]
pub struct Place {
    pub q: Vec<f64>,
    /// t.
    pub tangent: Vec<f64>,
    /// Sine of the angle between the row that the others nearly fix and those others; zero at singular positions.
    pub regularity: f64,
    /// The watched coordinates: values, and rates along t.
    pub values: Vec<f64>,
    pub rates: Vec<f64>,
}

impl<'a> Path<'a> {
    /// `watched` were made on the graph of `equations`.
    pub fn new(
        mechanism: &Mechanism,
        equations: &'a Equations,
        phases: &[f64],
        watched: Vec<Condition>,
        length: f64,
        q: &[f64],
    ) -> Self {
        let mut point = Point::at_defaults(mechanism, equations, phases);
        let undriven = 0..equations.rows.len() - mechanism.drivers.len();
        let rows: Vec<usize> = undriven.filter(|row| !equations.idle.contains(row)).collect();
        let jets = rows.iter().map(|row| &equations.rows[*row].jet);
        let jets = jets.chain(watched.iter().map(|condition| &condition.jet));
        let nodes = jets.flat_map(|jet| jet.columns.values().copied().chain([jet.value]));
        let ancestry = Ancestry::of(equations, nodes.collect::<Vec<_>>());
        let (n, linear) = (equations.symbols.v.len(), equations.layout.linear.len());
        let entries = rows.iter().enumerate().flat_map(|(at, row)| {
            equations.rows[*row].jet.columns.keys().map(move |column| (n + at, *column))
        });
        let table = Table::new(n, rows.len(), entries.collect::<Vec<_>>());
        let scales = (0..n).map(|k| if k < linear { 1.0 / length } else { 1.0 }).collect();
        let full = crate::check::assemble::full_squares(&mut point, &rows, q);
        Path { point, rows, watched, ancestry, table, scales, full }
    }

    pub fn rows(&self) -> &[usize] {
        &self.rows
    }

    /// How many of the coordinates are lengths, those that come first.
    pub fn lengths(&self) -> usize {
        self.equations().layout.linear.len()
    }

    fn equations(&self) -> &'a Equations {
        self.point.equations
    }

    /// [W Dᵀ; D 0] at `q`, and Φ.
    fn system(&mut self, q: &[f64]) -> (Vec<(usize, usize, f64)>, Vec<f64>) {
        self.point.set_q(q);
        self.point.evaluate(&self.ancestry);
        let n = self.scales.len();
        let mut entries: Vec<_> =
            self.scales.iter().enumerate().map(|(k, scale)| (k, k, scale * scale)).collect();
        let mut residuals = Vec::with_capacity(self.rows.len());
        for (at, row) in self.rows.iter().enumerate() {
            let jet = &self.point.equations.rows[*row].jet;
            entries.extend(jet.columns.iter().map(|(k, column)| (n + at, *k, self.point.get(*column))));
            residuals.push(self.point.get(jet.value));
        }
        (entries, residuals)
    }

    /// The position nearest to `q` that the constraints admit.
    fn correct(&mut self, mut q: Vec<f64>) -> Option<Vec<f64>> {
        let n = self.scales.len();
        if self.rows.is_empty() {
            return Some(q);
        }
        let mut before = f64::INFINITY;
        for _ in 0..CORRECTIONS {
            let (entries, residuals) = self.system(&q);
            let mut rhs = vec![0.0; n];
            rhs.extend(residuals.iter().map(|residual| -residual));
            let step = Numeric::factor(&self.table, entries).solve(&rhs);
            let length = self.length(&step[..n]);
            if !length.is_finite() || length > 2.0 * before {
                return None;
            }
            q = retract(self.equations(), &q, &step[..n]);
            if length < SETTLED {
                return Some(q);
            }
            before = length;
        }
        None
    }

    /// The position at `q`, which the constraints admit; t is on the side of `along`.
    pub fn at(&mut self, q: Vec<f64>, along: &[f64]) -> Option<Place> {
        let (entries, _) = self.system(&q);
        let n = self.scales.len();
        let mut rhs: Vec<f64> = along.iter().zip(&self.scales).map(|(x, scale)| x * scale * scale).collect();
        rhs.resize(n + self.rows.len(), 0.0);
        let factor = Numeric::factor(&self.table, entries);
        let mut tangent = factor.solve(&rhs);
        tangent.truncate(n);
        let length = self.length(&tangent);
        if !length.is_finite() || length < 1e-9 {
            return None;
        }
        tangent.iter_mut().for_each(|x| *x /= length);
        let regularity = self.regularity(&factor.relative_pivots[n..]);
        let point = &self.point;
        let value = |condition: &Condition| point.get(condition.jet.value);
        let rate = |condition: &Condition| -> f64 {
            condition.jet.columns.iter().map(|(k, column)| point.get(*column) * tangent[*k]).sum()
        };
        let values: Vec<f64> = self.watched.iter().map(value).collect();
        let rates = self.watched.iter().map(rate).collect();
        values.iter().all(|x| x.is_finite()).then_some(Place { q, tangent, regularity, values, rates })
    }

    /// The position a distance further on; `None` where the corrector does not settle.
    pub fn step(&mut self, from: &Place, distance: f64) -> Option<Place> {
        let q = self.correct(self.moved(from, distance))?;
        self.at(q, &from.tangent)
    }

    /// Along the tangent, where the constraints are met to the first order only.
    pub fn moved(&self, from: &Place, distance: f64) -> Vec<f64> {
        let increment: Vec<f64> = from.tangent.iter().map(|x| x * distance).collect();
        retract(self.equations(), &from.q, &increment)
    }

    /// Root of the smallest relative pivot of the rows, each brought to its full size.
    fn regularity(&self, pivots: &[f64]) -> f64 {
        let square = |row: &usize| {
            let columns = self.point.equations.rows[*row].jet.columns.values();
            columns.map(|column| self.point.get(*column).powi(2)).sum::<f64>()
        };
        let of_row = |((row, full), pivot): ((&usize, &f64), &f64)| {
            let share = if *full > 0.0 { (square(row) / full).min(1.0) } else { 0.0 };
            share * pivot
        };
        let all = self.rows.iter().zip(&self.full).zip(pivots).map(of_row);
        all.fold(1.0, f64::min).sqrt()
    }

    /// The diagonal of W.
    pub fn weights(&self) -> impl Iterator<Item = f64> + '_ {
        self.scales.iter().map(|scale| scale * scale)
    }

    /// Largest entry, lengths by the size of the mechanism.
    pub fn length(&self, increment: &[f64]) -> f64 {
        let scaled = increment.iter().zip(&self.scales).map(|(x, scale)| (x * scale).abs());
        scaled.fold(0.0, |largest, x| if x > largest || x.is_nan() { x } else { largest })
    }

    /// The cosine of the angle between two tangents.
    pub fn cosine(&self, a: &[f64], b: &[f64]) -> f64 {
        self.inner(a, b) / (self.inner(a, a) * self.inner(b, b)).sqrt()
    }

    /// aᵀ W b.
    pub fn inner(&self, a: &[f64], b: &[f64]) -> f64 {
        let scales = self.scales.iter().map(|scale| scale * scale);
        a.iter().zip(b).zip(scales).map(|((a, b), weight)| a * b * weight).sum()
    }

    /// The increment that leads from `from` to `to`, turns taken the short way.
    pub fn difference(&self, from: &[f64], to: &[f64]) -> Vec<f64> {
        let layout = &self.equations().layout;
        let linear = layout.linear.len();
        let mut increment: Vec<f64> = (0..linear).map(|k| to[k] - from[k]).collect();
        for r in 0..layout.rotations.len() {
            let at = layout.pair(r);
            let [(c, s), (x, y)] = [(from[at], from[at + 1]), (to[at], to[at + 1])];
            increment.push(libm::atan2(c * y - s * x, c * x + s * y));
        }
        increment
    }
}
