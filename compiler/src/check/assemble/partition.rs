//! Which velocities are taken as dependent ones, where a formulation works with independent ones.

use super::pairs::in_pairs;
use super::scales::{column_sizes, row_sizes};
use super::{Ancestry, Assembly, Point};
use crate::equations::{Conditions, Equations};
use crate::model::Mechanism;
use crate::solve::{Partition, Pivot, groups};
use std::collections::{BTreeMap, BTreeSet};

/// An entry of this part of the largest of its row is good enough for a pivot.
const GOOD: f64 = 0.3;

/// The velocities of the independent coordinates stay independent if that costs less than this.
const DEARER: f64 = 1.25;

/// A column whose entries at the start are less than this part of those along the motion says nothing of its unit there.
const SMALL: f64 = 0.1;

/// Chooses the dependent velocities at the start; says in which ways they may be eliminated, that by the vectors of joints first. None of
/// those that carry an independent coordinate (conditions by index) is taken, where that is possible and not much dearer.
pub fn partitions(
    mechanism: &Mechanism,
    equations: &Equations,
    conditions: &Conditions,
    assembly: &Assembly,
    independent: &[usize],
) -> Vec<Partition> {
    let mut point = Point::at_defaults(mechanism, equations, &assembly.phases);
    let columns = equations.rows.iter().flat_map(|row| row.jet.columns.values().copied());
    let ancestry = Ancestry::of(equations, columns);
    let mut rows_at = |q: &Vec<f64>| -> BTreeMap<usize, BTreeMap<usize, f64>> {
        point.set_q(q);
        point.evaluate(&ancestry);
        let rows = equations.rows.iter().enumerate().filter(|(index, _)| !equations.idle.contains(index));
        rows.map(|(index, row)| {
            let entries = row.jet.columns.iter();
            (index, entries.map(|(column, node)| (*column, point.get(*node))).collect())
        })
        .collect()
    };
    let rows = rows_at(&assembly.q);

    let alone = independent.iter().filter_map(|condition| {
        let columns = &conditions.rows[*condition].jet.columns;
        columns.keys().next().copied().filter(|_| columns.len() == 1)
    });
    let mut blocks: BTreeMap<(usize, usize), Vec<usize>> = BTreeMap::new();
    for (row, group) in
        groups(&equations.rows).into_iter().enumerate().filter(|(row, _)| rows.contains_key(row))
    {
        blocks.entry(group.map_or((1, row), |group| (0, group))).or_default().push(row);
    }
    let blocks: Vec<Vec<usize>> = blocks.into_values().collect();
    let scales = column_scales(mechanism, equations, assembly, &rows);
    let sparing = choose(rows.clone(), blocks.clone(), &scales, &alone.collect());
    let free = choose(rows, blocks, &scales, &BTreeSet::new());
    let chosen = if sparing.operations as f64 <= DEARER * free.operations as f64 { sparing } else { free };
    let row_sizes = row_sizes(mechanism, equations, assembly, &chosen.scales);
    let chosen = Partition { row_sizes, ..chosen };
    let pairs = in_pairs(equations, &chosen, || assembly.along.iter().map(rows_at).collect());
    [Some(chosen), pairs].into_iter().flatten().collect()
}

/// One over the largest entry of each column of D, to a power of two: at the start (`rows`), but for a column that is small there beside
/// what it is along the motion.
fn column_scales(
    mechanism: &Mechanism,
    equations: &Equations,
    assembly: &Assembly,
    rows: &BTreeMap<usize, BTreeMap<usize, f64>>,
) -> Vec<f64> {
    let along = column_sizes(mechanism, equations, assembly);
    let mut largest = vec![0.0_f64; along.len()];
    for (column, entry) in rows.values().flatten() {
        largest[*column] = largest[*column].max(entry.abs());
    }
    let scale = |(here, along): (&f64, &f64)| {
        let size = if *here >= SMALL * along { *here } else { *along };
        if size > 0.0 { libm::exp2(-libm::round(libm::log2(size))) } else { 1.0 }
    };
    largest.iter().zip(&along).map(scale).collect()
}

/// D while it is eliminated.
struct Active {
    rows: BTreeMap<usize, BTreeMap<usize, f64>>,
    /// The rows that hold a velocity.
    holders: Vec<BTreeSet<usize>>,
    scales: Vec<f64>,
}

/// Block by block, the shortest first; in it row by row, of the good entries the one whose column is shortest (Markowitz,
/// Management Science 3 (1957) 255–269, with threshold pivoting). Those to be spared only where nothing else is good.
fn choose(
    rows: BTreeMap<usize, BTreeMap<usize, f64>>,
    waiting: Vec<Vec<usize>>,
    scales: &[f64],
    spared: &BTreeSet<usize>,
) -> Partition {
    let mut holders = vec![BTreeSet::new(); scales.len()];
    for (row, entries) in &rows {
        entries.keys().for_each(|column| _ = holders[*column].insert(*row));
    }
    let scales = scales.to_vec();
    let mut active = Active { rows, holders, scales: scales.clone() };
    let of: BTreeMap<usize, usize> =
        waiting.iter().enumerate().flat_map(|(at, rows)| rows.iter().map(move |row| (*row, at))).collect();
    let mut lengths: Vec<usize> = waiting.iter().map(|rows| active.length(rows)).collect();
    let mut queue: BTreeSet<(usize, usize)> = lengths.iter().copied().zip(0..).collect();
    let (mut blocks, mut operations) = (Vec::new(), 0);
    while let Some((_, own)) = queue.pop_first() {
        let mut rows = waiting[own].clone();
        let mut block = Vec::new();
        while let Some((row, velocity)) = active.next(&rows, spared) {
            let (cost, below) = active.eliminate(row, velocity);
            operations += cost;
            rows.retain(|other| *other != row);
            block.push(Pivot { row, velocity });
            for at in below.iter().map(|row| of[row]) {
                if queue.remove(&(lengths[at], at)) {
                    lengths[at] = active.length(&waiting[at]);
                    queue.insert((lengths[at], at));
                }
            }
        }
        blocks.push(block);
    }
    Partition { blocks, scales, row_sizes: Vec::new(), operations }
}

impl Active {
    /// Entries of the longest row of a block.
    fn length(&self, block: &[usize]) -> usize {
        block.iter().map(|row| self.rows[row].len()).max().unwrap_or(0)
    }

    /// The next pivot of a block; `None` at its end.
    fn next(&self, block: &[usize], spared: &BTreeSet<usize>) -> Option<(usize, usize)> {
        let row = block.iter().min_by_key(|row| self.rows[*row].len())?;
        let entries = &self.rows[row];
        let scaled = |(column, entry): (&usize, &f64)| (*column, entry.abs() * self.scales[*column]);
        let most = entries.iter().map(scaled).map(|(_, size)| size).fold(0.0, f64::max);
        let good = entries.iter().map(scaled).filter(|(_, size)| *size >= GOOD * most);
        let best = good.min_by(|(a, size_a), (b, size_b)| {
            let rank = |column: &usize| (spared.contains(column), self.holders[*column].len());
            rank(a).cmp(&rank(b)).then(size_b.total_cmp(size_a))
        });
        best.map(|(column, _)| (*row, column))
    }

    /// Takes a row and its pivot out; returns the operations, and the rows that it was subtracted from.
    fn eliminate(&mut self, row: usize, pivot: usize) -> (usize, BTreeSet<usize>) {
        let upper = self.rows.remove(&row).unwrap_or_default();
        for column in upper.keys() {
            self.holders[*column].remove(&row);
        }
        let below = std::mem::take(&mut self.holders[pivot]);
        for other in &below {
            let Some(entries) = self.rows.get_mut(other) else { continue };
            let factor = entries.remove(&pivot).unwrap_or(0.0) / upper[&pivot];
            for (column, value) in upper.iter().filter(|(column, _)| **column != pivot) {
                // An entry that cancels stays in the structure: it need not cancel elsewhere.
                *entries.entry(*column).or_default() -= factor * value;
                self.holders[*column].insert(*other);
            }
        }
        (upper.len() + below.len() * upper.len(), below)
    }
}
