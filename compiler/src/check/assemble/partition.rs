//! Which velocities are taken as dependent ones, where a formulation works with independent ones.

use super::active::{Active, Rows};
use super::pairs::in_pairs;
use super::scales::{column_sizes, row_sizes};
use super::{Ancestry, Assembly, Point};
use crate::equations::{Conditions, Equations};
use crate::model::Mechanism;
use crate::solve::{Partition, Pivot, groups};
use std::collections::{BTreeMap, BTreeSet};

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
    let mut rows_at = |q: &Vec<f64>| -> Rows {
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
fn column_scales(mechanism: &Mechanism, equations: &Equations, assembly: &Assembly, rows: &Rows) -> Vec<f64> {
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

/// Block by block, the shortest first; in it row by row, of the good entries the one whose column is shortest (Markowitz,
/// Management Science 3 (1957) 255–269, with threshold pivoting). Those to be spared only where nothing else is good.
fn choose(rows: Rows, waiting: Vec<Vec<usize>>, scales: &[f64], spared: &BTreeSet<usize>) -> Partition {
    let mut active = Active::new(rows, scales);
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
    Partition { blocks, scales: scales.to_vec(), row_sizes: Vec::new(), operations }
}
