//! Degrees of freedom, lost ranks and the choice of independent coordinates, by the pivots of one factorisation.

use super::point::{Ancestry, Point};
use crate::equations::{Condition, Equations};
use crate::solve::table::{DEPENDENT, Numeric, Table};

/// What the pivots of D say at one position.
#[derive(Clone, Debug, Default)]
pub struct Rank {
    /// Rank of the rows asked about.
    pub rank: usize,
    /// Rows that the others already fix, indices into [`Equations::rows`].
    pub dependent: Vec<usize>,
}

/// Rank of the given rows of D at `q`, with the increments of all velocities weighted alike.
pub fn rank(point: &mut Point, rows: &[usize], q: &[f64]) -> Rank {
    let equations = point.equations;
    let pivots = pivots(point, rows, &[], q);
    let n = equations.symbols.v.len();
    let lost = |(at, row): &(usize, &usize)| pivots[n + at] * share(point, **row) < DEPENDENT;
    let dependent: Vec<usize> = rows.iter().enumerate().filter(lost).map(|(_, row)| *row).collect();
    Rank { rank: rows.len() - dependent.len(), dependent }
}

/// Square of a row of D relative to the larger one of the pair that holds two points together: with all links in one
/// line along an axis one row of the pair vanishes, down to rounding, and its pivot with it, so that relative to its own
/// terms alone the pivot would look sound.
fn share(point: &Point, row: usize) -> f64 {
    let rows = &point.equations.rows;
    let square = |at: usize| rows[at].jet.columns.values().map(|node| point.get(*node).powi(2)).sum::<f64>();
    let of_pair = |at: usize| rows[at].joint == rows[row].joint && matches!(rows[at].what, "x" | "y");
    if rows[row].joint.is_none() || !of_pair(row) {
        return 1.0;
    }
    let largest = (0..rows.len()).filter(|at| of_pair(*at)).map(square).fold(0.0, f64::max);
    if largest > 0.0 { square(row) / largest } else { 0.0 }
}

/// The first of `candidates`, in order, that together with all rows fix the position at `q`.
pub fn independent(point: &mut Point, candidates: &[Condition], q: &[f64]) -> Vec<usize> {
    let rows: Vec<usize> = (0..point.equations.rows.len()).collect();
    let pivots = pivots(point, &rows, candidates, q);
    let first = point.equations.symbols.v.len() + rows.len();
    (0..candidates.len()).filter(|at| pivots[first + at] >= DEPENDENT).collect()
}

/// Relative pivots of [1 D̂ᵀ; D̂ 0], the candidates eliminated last and in order.
fn pivots(point: &mut Point, rows: &[usize], candidates: &[Condition], q: &[f64]) -> Vec<f64> {
    let equations: &Equations = point.equations;
    let n = equations.symbols.v.len();
    let jets: Vec<_> = rows
        .iter()
        .map(|row| &equations.rows[*row].jet)
        .chain(candidates.iter().map(|candidate| &candidate.jet))
        .collect();
    point.set_q(q);
    point.evaluate(&Ancestry::of_jets(equations, jets.iter().copied()));
    let structure = |jets: &[&crate::equations::Jet]| -> Vec<(usize, usize)> {
        let entry = |(at, jet): (usize, &&crate::equations::Jet)| {
            jet.columns.keys().map(move |column| (n + at, *column)).collect::<Vec<_>>()
        };
        jets.iter().enumerate().flat_map(entry).collect()
    };
    // The order of the velocities and rows is chosen without the candidates, which follow.
    let mut sequence = Table::new(n, rows.len(), structure(&jets[..rows.len()])).order;
    sequence.extend(n + rows.len()..n + jets.len());
    let pattern = crate::solve::order::Pattern::new(n, jets.len(), structure(&jets));
    let table = Table::with_order(&pattern, sequence);
    let mut entries: Vec<(usize, usize, f64)> = (0..n).map(|k| (k, k, 1.0)).collect();
    for (at, jet) in jets.iter().enumerate() {
        entries.extend(jet.columns.iter().map(|(column, node)| (n + at, *column, point.get(*node))));
    }
    Numeric::factor(&table, entries).relative_pivots
}
