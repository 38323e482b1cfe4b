//! Degrees of freedom, lost ranks and the choice of independent coordinates, by the pivots of one factorisation.

use super::point::{Ancestry, Point, retract};
use crate::equations::{Condition, Equations};
use crate::solve::table::{DEPENDENT, Numeric, Table};

/// The freedoms by the pivots of D at one position.
#[derive(Clone, Debug, Default)]
pub struct Rank {
    /// Rank of the rows asked about.
    pub rank: usize,
    /// Rows that the others already fix, indices into [`Equations::rows`].
    pub dependent: Vec<usize>,
}

/// Rank of the given rows of D at `q`, with the increments of all velocities weighted alike.
pub fn rank(point: &mut Point, rows: &[usize], q: &[f64]) -> Rank {
    let n = point.equations.symbols.v.len();
    let shares = shares(point, rows, q);
    let pivots = pivots(point, rows, &[], q);
    let lost = |(at, _): &(usize, &usize)| pivots[n + at] * shares[*at] < DEPENDENT;
    let dependent: Vec<usize> = rows.iter().enumerate().filter(lost).map(|(_, row)| *row).collect();
    Rank { rank: rows.len() - dependent.len(), dependent }
}

/// Square of each row of D relative to what it is with all bodies turned, one at most. Where a row vanishes, as with
/// all links in one line along an axis, or a point driven along the line to its pivot, only rounding is left of it;
/// relative to its own terms alone its pivot would look sound.
fn shares(point: &mut Point, rows: &[usize], q: &[f64]) -> Vec<f64> {
    let ancestry = ancestry(point, rows);
    let (here, away) = (squares(point, &ancestry, rows, q), turned(point, q));
    let there = squares(point, &ancestry, rows, &away);
    let share = |(here, there): (&f64, &f64)| {
        if *here > 0.0 && *there > 0.0 { (here / there).min(1.0) } else { 0.0 }
    };
    here.iter().zip(&there).map(share).collect()
}

/// Square of each row of D with all bodies turned: far, so that the row shows its full size, and by different amounts, so
/// that not all stay in line.
pub fn full_squares(point: &mut Point, rows: &[usize], q: &[f64]) -> Vec<f64> {
    let (ancestry, away) = (ancestry(point, rows), turned(point, q));
    squares(point, &ancestry, rows, &away)
}

fn turned(point: &Point, q: &[f64]) -> Vec<f64> {
    let equations = point.equations;
    let linear = equations.layout.linear.len();
    let turn = |k: usize| if k < linear { 0.0 } else { 0.4 + 0.17 * (k % 7) as f64 };
    let away: Vec<f64> = (0..equations.symbols.v.len()).map(turn).collect();
    retract(equations, q, &away)
}

fn ancestry(point: &Point, rows: &[usize]) -> Ancestry {
    let equations = point.equations;
    Ancestry::of_jets(equations, rows.iter().map(|row| &equations.rows[*row].jet))
}

fn squares(point: &mut Point, ancestry: &Ancestry, rows: &[usize], q: &[f64]) -> Vec<f64> {
    let equations = point.equations;
    point.set_q(q);
    point.evaluate(ancestry);
    let square = |row: &usize| {
        equations.rows[*row].jet.columns.values().map(|node| point.get(*node).powi(2)).sum::<f64>()
    };
    rows.iter().map(square).collect()
}

/// How many candidates are tried at once: each that is refused costs as much as one that is taken.
const AT_ONCE: usize = 32;

/// The first of `candidates`, in order, that together with all rows fix the position at `q`. No more are looked at once as many
/// are found as there are freedoms.
pub fn independent(point: &mut Point, candidates: &[Condition], q: &[f64]) -> Vec<usize> {
    let all = 0..point.equations.rows.len();
    let rows: Vec<usize> = all.filter(|row| !point.equations.idle.contains(row)).collect();
    let n = point.equations.symbols.v.len();
    let mut chosen: Vec<usize> = Vec::new();
    for from in (0..candidates.len()).step_by(AT_ONCE) {
        let tried: Vec<usize> =
            chosen.iter().copied().chain(from..candidates.len().min(from + AT_ONCE)).collect();
        let conditions: Vec<&Condition> = tried.iter().map(|at| &candidates[*at]).collect();
        let pivots = pivots(point, &rows, &conditions, q);
        let is_held = |pivot: &f64| *pivot >= DEPENDENT;
        let freedoms = n - pivots[n..n + rows.len()].iter().filter(|pivot| is_held(pivot)).count();
        let taken = tried.iter().zip(&pivots[n + rows.len()..]).filter(|(_, pivot)| is_held(pivot));
        chosen = taken.map(|(at, _)| *at).collect();
        if chosen.len() >= freedoms {
            break;
        }
    }
    chosen
}

/// Relative pivots of [1 D̂ᵀ; D̂ 0], the candidates eliminated last and in order.
fn pivots(point: &mut Point, rows: &[usize], candidates: &[&Condition], q: &[f64]) -> Vec<f64> {
    let equations: &Equations = point.equations;
    let n = equations.symbols.v.len();
    let candidates = candidates.iter().map(|candidate| &candidate.jet);
    let jets: Vec<_> = rows.iter().map(|row| &equations.rows[*row].jet).chain(candidates).collect();
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
    let pattern = crate::order::Pattern::new(n, jets.len(), structure(&jets));
    let table = Table::with_order(&pattern, sequence);
    let mut entries: Vec<(usize, usize, f64)> = (0..n).map(|k| (k, k, 1.0)).collect();
    for (at, jet) in jets.iter().enumerate() {
        entries.extend(jet.columns.iter().map(|(column, node)| (n + at, *column, point.get(*node))));
    }
    Numeric::factor(&table, entries).relative_pivots
}
