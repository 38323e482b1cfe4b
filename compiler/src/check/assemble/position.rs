//! The start position: constraints and exact conditions met, as near to the guesses as they allow.
//!
//! Gauss–Newton with equality constraints: each step minimises Σ (guess residual)² + ε |δ|² subject to D̂ δ = −r, by the
//! sparse factorisation that is also emitted, with ε there only to keep steps short (Nocedal & Wright, Numerical
//! Optimization, section 18.1). Conditions on angles are compared on the circle.

use super::point::{Ancestry, Point, retract};
use crate::equations::{Condition, Equations};
use crate::forms::row::Measures;
use crate::model::Coordinate;
use crate::solve::table::{Numeric, Table};

/// The problem, set up once for all attempts.
pub struct Problem<'a> {
    pub(super) equations: &'a Equations,
    /// Rows of constraints that take part (those of couplings with an open phase do not).
    pub(super) rows: Vec<usize>,
    /// Exact conditions and their values.
    pub(super) conditions: Vec<(Condition, f64)>,
    /// Guesses and their values.
    pub(super) guesses: Vec<(Condition, f64)>,
    pub(super) ancestry: Ancestry,
    table: Table,
}

/// Where an attempt ended.
#[derive(Clone, Debug)]
pub struct Attempt {
    pub q: Vec<f64>,
    /// Largest residual of constraints and conditions, relative to the size of what they compare.
    pub residual: f64,
    /// The same residual as it is: m, rad, m² of a distance.
    pub amount: f64,
    /// Index in [`Equations::rows`] of the row with the largest residual, if a row has it.
    pub worst: Option<usize>,
    pub closed: bool,
    /// Σ (value − guess)².
    pub distance: f64,
    /// The last step was short: no nearer position is next to this one.
    pub settled: bool,
}

/// Relative residuals below this close a loop.
const CLOSED: f64 = 1e-12;
/// Relative residuals below this are a solution's neighbourhood, where full steps converge.
const NEAR: f64 = 1e-6;
/// The last step of an iteration that has converged is shorter.
const SETTLED: f64 = 1e-9;
const ITERATIONS: usize = 60;
/// Weight of the step's own length beside the guesses.
const STEP_WEIGHT: f64 = 1e-4;

impl<'a> Problem<'a> {
    pub fn new(
        equations: &'a Equations,
        rows: Vec<usize>,
        conditions: Vec<(Condition, f64)>,
        guesses: Vec<(Condition, f64)>,
    ) -> Self {
        let jets = rows.iter().map(|row| &equations.rows[*row].jet);
        let held = conditions.iter().chain(&guesses).map(|(condition, _)| &condition.jet);
        let upright = equations.rows.iter().filter_map(|row| row.upright);
        let closings = conditions.iter().filter(|(condition, _)| is_closing(condition));
        let mut nodes: Vec<_> = upright.chain(closings.map(|(condition, _)| condition.upright)).collect();
        for jet in jets.chain(held) {
            nodes.extend(jet.columns.values().copied().chain([jet.value]));
        }
        let ancestry = Ancestry::of(equations, nodes);
        let n = equations.symbols.v.len();
        let mut entries = Vec::new();
        for (at, row) in rows.iter().enumerate() {
            entries.extend(equations.rows[*row].jet.columns.keys().map(|column| (n + at, *column)));
        }
        for (at, (condition, _)) in conditions.iter().enumerate() {
            entries.extend(condition.jet.columns.keys().map(|column| (n + rows.len() + at, *column)));
        }
        for (guess, _) in &guesses {
            let columns: Vec<usize> = guess.jet.columns.keys().copied().collect();
            entries.extend(columns.iter().flat_map(|a| columns.iter().map(|b| (*a, *b))));
        }
        let table = Table::new(n, rows.len() + conditions.len(), entries);
        Problem { equations, rows, conditions, guesses, ancestry, table }
    }

    /// The same without drivers and without what `start` says: what the joints admit.
    pub fn joints_only(&self, mechanism: &crate::model::Mechanism) -> Problem<'a> {
        let undriven = self.equations.rows.len() - mechanism.drivers.len();
        let rows = self.rows.iter().copied().filter(|row| *row < undriven).collect();
        Problem::new(self.equations, rows, Vec::new(), Vec::new())
    }

    /// The same with these conditions beside those that are exact.
    pub(super) fn with(&self, conditions: Vec<(Condition, f64)>) -> Problem<'a> {
        let conditions = self.conditions.iter().cloned().chain(conditions).collect();
        Problem::new(self.equations, self.rows.clone(), conditions, self.guesses.clone())
    }

    pub(super) fn table(&self) -> &Table {
        &self.table
    }

    /// [1 Dᵀ; D 0] and a right-hand side of its size.
    pub(super) fn unit_system(&self, point: &mut Point, q: &[f64]) -> (Vec<(usize, usize, f64)>, Vec<f64>) {
        let n = self.equations.symbols.v.len();
        let unknowns = n + self.rows.len() + self.conditions.len();
        let (mut entries, rhs) = self.system(point, q, n, unknowns, &[]);
        for (i, j, value) in entries.iter_mut().take(n) {
            debug_assert_eq!(i, j);
            *value = 1.0;
        }
        (entries, rhs)
    }

    /// Newton's method from `q`.
    pub fn solve(&self, point: &mut Point, q: Vec<f64>) -> Attempt {
        let n = self.equations.symbols.v.len();
        let unknowns = n + self.rows.len() + self.conditions.len();
        let mut best = self.measure(point, q);
        for _ in 0..ITERATIONS {
            let (entries, rhs) = self.system(point, &best.q, n, unknowns, &self.guesses);
            let step = Numeric::factor(&self.table, entries).solve(&rhs);
            let length = step[..n].iter().fold(0.0_f64, |longest, s| longest.max(s.abs()));
            if !length.is_finite() {
                break;
            }
            // Large turns leave the neighbourhood in which the linearisation means anything; lengths may be of any size.
            let linear = self.equations.layout.linear.len();
            let turn = step[linear..n].iter().fold(0.0_f64, |longest, s| longest.max(s.abs()));
            let mut scale = if turn > 0.7 { 0.7 / turn } else { 1.0 };
            let mut next = None;
            for _ in 0..12 {
                let increment: Vec<f64> = step[..n].iter().map(|s| s * scale).collect();
                let attempt = self.measure(point, retract(self.equations, &best.q, &increment));
                if attempt.merit() < best.merit() || (attempt.closed && best.closed) {
                    next = Some(attempt);
                    break;
                }
                scale *= 0.5;
            }
            let Some(attempt) = next else { break };
            best = attempt;
            best.settled = best.closed && length * scale < SETTLED;
            if best.closed && length * scale < 1e-13 {
                break;
            }
        }
        self.polish(point, best, n, unknowns)
    }

    /// A position found by other means, measured and brought to rounding.
    pub fn settled(&self, point: &mut Point, q: Vec<f64>) -> Attempt {
        let n = self.equations.symbols.v.len();
        let found = self.measure(point, q);
        self.polish(point, found, n, n + self.rows.len() + self.conditions.len())
    }

    /// Full steps for as long as they bring the residual down, which is to rounding. Guesses have had their say: in the
    /// least-squares sum they outweigh what is left to correct, so that an attempt may come near without closing.
    fn polish(&self, point: &mut Point, mut best: Attempt, n: usize, unknowns: usize) -> Attempt {
        while best.residual < NEAR && best.residual > 0.0 {
            let (entries, rhs) = self.system(point, &best.q, n, unknowns, &[]);
            let step = Numeric::factor(&self.table, entries).solve(&rhs);
            let attempt = self.measure(point, retract(self.equations, &best.q, &step[..n]));
            if attempt.residual < 0.5 * best.residual {
                best = Attempt { settled: best.settled, ..attempt };
            } else {
                break;
            }
        }
        best
    }

    fn system(
        &self,
        point: &mut Point,
        q: &[f64],
        n: usize,
        unknowns: usize,
        guesses: &[(Condition, f64)],
    ) -> (Entries, Vec<f64>) {
        point.set_q(q);
        point.evaluate(&self.ancestry);
        let mut entries: Entries = (0..n).map(|k| (k, k, STEP_WEIGHT)).collect();
        let mut rhs = vec![0.0; unknowns];
        for (at, row) in self.rows.iter().enumerate() {
            let jet = &self.equations.rows[*row].jet;
            entries.extend(jet.columns.iter().map(|(k, column)| (n + at, *k, point.get(*column))));
            rhs[n + at] = -point.get(jet.value);
        }
        let first = n + self.rows.len();
        for (at, (condition, target)) in self.conditions.iter().enumerate() {
            let columns = &condition.jet.columns;
            entries.extend(columns.iter().map(|(k, column)| (first + at, *k, point.get(*column))));
            rhs[first + at] = -deviation(point, condition, *target);
        }
        for (guess, target) in guesses {
            let columns: Vec<(usize, f64)> =
                guess.jet.columns.iter().map(|(k, column)| (*k, point.get(*column))).collect();
            let deviation = deviation(point, guess, *target);
            for (a, x) in &columns {
                rhs[*a] -= x * deviation;
                entries.extend(columns.iter().filter(|(b, _)| b <= a).map(|(b, y)| (*a, *b, x * y)));
            }
        }
        (entries, rhs)
    }

    fn measure(&self, point: &mut Point, q: Vec<f64>) -> Attempt {
        point.set_q(&q);
        point.evaluate(&self.ancestry);
        let sizes = self.sizes(point, &q);
        let mut attempt = Attempt {
            q,
            residual: 0.0,
            amount: 0.0,
            worst: None,
            closed: false,
            distance: 0.0,
            settled: false,
        };
        let rows = self.rows.iter().zip(&sizes.rows);
        let rows =
            rows.map(|(row, size)| (Some(*row), point.get(self.equations.rows[*row].jet.value), *size));
        let conditions = self.conditions.iter().map(|(condition, target)| {
            let size = if condition.angular { 1.0 } else { sizes.length };
            (None, deviation(point, condition, *target), size)
        });
        for (row, amount, size) in rows.chain(conditions) {
            let residual = amount.abs() / size;
            if residual > attempt.residual || residual.is_nan() {
                (attempt.residual, attempt.amount, attempt.worst) = (residual, amount.abs(), row);
            }
        }
        attempt.distance = self.guesses.iter().map(|(guess, t)| deviation(point, guess, *t).powi(2)).sum();
        // A joint that yields stands upright where it is closed, as one that holds does.
        let mut closings = self.conditions.iter().filter(|(condition, _)| is_closing(condition));
        attempt.closed =
            attempt.residual < CLOSED && closings.all(|(condition, _)| point.get(condition.upright) >= 0.0);
        attempt
    }

    /// Direction rows on their flipped root.
    pub fn flipped(&self, point: &mut Point, q: &[f64]) -> Option<usize> {
        point.set_q(q);
        point.evaluate(&self.ancestry);
        self.equations.rows.iter().position(|row| row.upright.is_some_and(|cosine| point.get(cosine) < 0.0))
    }
}

/// Whether it closes a joint that yields.
fn is_closing(condition: &Condition) -> bool {
    matches!(condition.coordinate, Coordinate::Closing(..))
}

/// Sizes that residuals are compared with.
pub(super) struct Sizes {
    /// The size of the mechanism, m.
    pub(super) length: f64,
    /// Per row: the length for what is measured in metres, its like for distances, and the row's own for the rest.
    pub(super) rows: Vec<f64>,
}

impl Problem<'_> {
    /// The size of the mechanism at `q`, m.
    pub(super) fn length(&self, point: &mut Point, q: &[f64]) -> f64 {
        point.set_q(q);
        point.evaluate(&self.ancestry);
        self.sizes(point, q).length
    }

    /// Σ |D_rk| · (1 rad, or the size of the linear coordinate) is the lever arms that a row adds up.
    pub(super) fn sizes(&self, point: &Point, q: &[f64]) -> Sizes {
        let linear = self.equations.layout.linear.len();
        let own: Vec<f64> = self
            .rows
            .iter()
            .map(|row| {
                let columns = self.equations.rows[*row].jet.columns.iter();
                let term = |(k, column): (&usize, &crate::symbolic::Node)| {
                    point.get(*column).abs() * if *k < linear { q[*k].abs() } else { 1.0 }
                };
                columns.map(term).sum()
            })
            .collect();
        let measures = |row: &usize| self.equations.rows[*row].form.measures;
        let largest = |measure: Measures| {
            let rows = self.rows.iter().zip(&own);
            let alike = rows.filter(|(row, _)| measures(row) == measure);
            alike.fold(0.0_f64, |largest, (_, own)| largest.max(*own))
        };
        let or_one = |size: f64| if size > 0.0 { size } else { 1.0 };
        let (length, square) = (largest(Measures::Length), largest(Measures::Squares));
        let length = or_one(if length > 0.0 { length } else { square.sqrt() });
        let size = |(row, own): (&usize, &f64)| match measures(row) {
            Measures::Length => length,
            Measures::Squares => or_one(square),
            Measures::Direction => 1.0,
            Measures::Own => or_one(*own),
        };
        Sizes { length, rows: self.rows.iter().zip(&own).map(size).collect() }
    }
}

type Entries = Vec<(usize, usize, f64)>;

impl Attempt {
    /// Whether the guesses may be nearer than they are here.
    pub fn is_on_its_way(&self) -> bool {
        !self.settled && self.distance >= super::attempts::MET
    }

    fn merit(&self) -> f64 {
        if self.residual.is_nan() { f64::INFINITY } else { self.residual }
    }
}

/// Value − target, for angles brought into (−π, π].
fn deviation(point: &Point, condition: &Condition, target: f64) -> f64 {
    let difference = point.get(condition.jet.value) - target;
    if !condition.angular {
        return difference;
    }
    difference - std::f64::consts::TAU * (difference / std::f64::consts::TAU).round()
}

impl<'p> Problem<'p> {
    pub fn equations(&self) -> &'p Equations {
        self.equations
    }

    /// Rows that take part, indices into [`Equations::rows`].
    pub fn rows(&self) -> &[usize] {
        &self.rows
    }

    pub fn conditions(&self) -> &[(Condition, f64)] {
        &self.conditions
    }

    pub fn guesses(&self) -> &[(Condition, f64)] {
        &self.guesses
    }

    /// Whether constraints and conditions leave the position open and no guess decides.
    pub fn is_free(&self, point: &mut Point, q: &[f64]) -> bool {
        self.guesses.is_empty() && self.freedoms(point, q) > 0
    }

    /// Freedoms that constraints and conditions leave.
    pub fn freedoms(&self, point: &mut Point, q: &[f64]) -> usize {
        let n = self.equations.symbols.v.len();
        let held: Vec<Condition> = self.conditions.iter().map(|(condition, _)| condition.clone()).collect();
        let rank = super::mobility::rank(point, &self.rows, q).rank;
        let fixed = super::mobility::independent(point, &held, q).len();
        n.saturating_sub(rank + fixed)
    }

    /// Whether constraints, conditions and guesses together decide every coordinate.
    pub fn is_decided(&self, point: &mut Point, q: &[f64]) -> bool {
        let n = self.equations.symbols.v.len();
        let held = self.conditions.iter().chain(&self.guesses);
        let held: Vec<Condition> = held.map(|(condition, _)| condition.clone()).collect();
        super::mobility::rank(point, &self.rows, q).rank + super::mobility::independent(point, &held, q).len()
            >= n
    }

    /// Angle of a joint at `q`, in (−π, π].
    pub fn joint_angle(&self, point: &mut Point, q: &[f64], joint: [Option<usize>; 2]) -> f64 {
        let bodies = joint.map(|body| body.map(|body| self.equations.motions[body].orientation.as_slice()));
        point.set_q(q);
        point.evaluate(&Ancestry::of(self.equations, bodies.iter().flatten().copied().flatten().copied()));
        let [first, second] =
            bodies.map(|pair| pair.map_or(0.0, |pair| libm::atan2(point.get(pair[1]), point.get(pair[0]))));
        let difference = second - first;
        difference - std::f64::consts::TAU * (difference / std::f64::consts::TAU).round()
    }
}
