//! Velocities that rows of constraints admit, in a metric that weighs lengths and angles alike: K = [W, Dᵀ; D, 0].

use super::assemble::{Ancestry, Point};
use crate::equations::{Equations, Jet};
use crate::solve::table::{Numeric, Table};
use std::ops::Range;

/// Some rows of the constraints.
pub struct Admitted<'e> {
    rows: Vec<&'e Jet>,
    velocities: usize,
    /// How many velocities are of lengths, those that come first.
    lengths: usize,
    table: Table,
    ancestry: Ancestry,
}

impl<'e> Admitted<'e> {
    pub fn new(equations: &'e Equations, rows: Range<usize>) -> Self {
        let rows: Vec<&Jet> = equations.rows[rows].iter().map(|row| &row.jet).collect();
        let velocities = equations.layout.velocities();
        let places = rows
            .iter()
            .enumerate()
            .flat_map(|(at, row)| row.columns.keys().map(move |column| (velocities + at, *column)));
        let table = Table::new(velocities, rows.len(), places.collect::<Vec<_>>());
        let ancestry = Ancestry::of_jets(equations, rows.iter().copied());
        Admitted { rows, velocities, lengths: equations.layout.linear.len(), table, ancestry }
    }

    /// At a position. Rows that repeat others are left out.
    pub fn at(&self, point: &mut Point, q: &[f64]) -> Here<'_> {
        point.set_q(q);
        point.evaluate(&self.ancestry);
        let of = |row: &&Jet| -> Vec<(usize, f64)> {
            row.columns.iter().map(|(column, node)| (*column, point.get(*node))).collect()
        };
        let entries: Vec<Vec<(usize, f64)>> = self.rows.iter().map(of).collect();
        let levers = entries.iter().flatten().filter(|(column, _)| *column >= self.lengths);
        let lever = levers.fold(0.0_f64, |most, (_, entry)| most.max(entry.abs()));
        let length = if lever > 0.0 { lever } else { 1.0 };
        let weight = |column: usize| if column < self.lengths { 1.0 / (length * length) } else { 1.0 };
        let weights: Vec<f64> = (0..self.velocities).map(weight).collect();
        let n = self.velocities;
        let matrix = weights.iter().enumerate().map(|(column, weight)| (column, column, *weight));
        let rows = entries.iter().enumerate();
        let matrix = matrix.chain(
            rows.flat_map(|(at, row)| row.iter().map(move |(column, entry)| (n + at, *column, *entry))),
        );
        let factored = Numeric::factor(&self.table, matrix);
        Here { factored, weights, rows: self.rows.len() }
    }
}

/// The same at a position.
pub struct Here<'a> {
    factored: Numeric<'a>,
    weights: Vec<f64>,
    rows: usize,
}

impl Here<'_> {
    /// |J_N|², what is left of a gradient along the velocities that are admitted, and |J|².
    pub fn squares(&self, gradient: &[(usize, f64)]) -> [f64; 2] {
        let whole = gradient.iter().map(|(column, entry)| entry * entry / self.weights[*column]).sum();
        [self.factored.inverse_square(gradient.iter().copied()).abs(), whole]
    }

    /// The velocity nearest to a wish, its largest entry 1; nothing where there is none.
    pub fn velocity(&self, wish: impl Fn(usize) -> f64) -> Option<Vec<f64>> {
        let mut right: Vec<f64> =
            self.weights.iter().enumerate().map(|(k, weight)| weight * wish(k)).collect();
        right.resize(self.weights.len() + self.rows, 0.0);
        let mut v = self.factored.solve(&right);
        v.truncate(self.weights.len());
        let largest = v.iter().fold(0.0_f64, |largest, v| largest.max(v.abs()));
        (largest.is_finite() && largest > 1e-6).then(|| v.into_iter().map(|v| v / largest).collect())
    }
}
