//! Two pairs of rows in place of a vector's three and another row of its loop.
//!
//! The four rows and their velocities may be eliminated as a block of three and what is left, or as two blocks of two. The determinants
//! of the blocks have the same product either way, but which of them vanish where differs: entries of a vector's block vanish one by one, its determinant
//! does not. So pairs are taken only where they are as regular at every position along the motion.

use super::active::{Active, Rows};
use crate::equations::Equations;
use crate::solve::{Partition, Pivot};
use std::collections::{BTreeMap, BTreeSet};

/// The smaller determinant of two pairs is everywhere at least this part of that of a vector and its row, relative to their sizes.
const AS_REGULAR: f64 = 0.5;

/// The rows of a vector and another one.
const ROWS: usize = 4;

/// Two of them; the other two stand as far from the end.
const PAIRS: [[usize; 2]; 6] = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];

/// The same rows and velocities with loops of a vector and another row in two pairs, where some are as regular along the motion as
/// that vector's block. `along`: D at positions along the motion, the start first.
pub fn in_pairs(
    equations: &Equations,
    chosen: &Partition,
    along: impl FnOnce() -> Vec<Rows>,
) -> Option<Partition> {
    let origin = |pivot: &Pivot| equations.rows[pivot.row].origin;
    let is_vector_and_row = |vector: &[Pivot], row: &[Pivot]| {
        vector.len() + 1 == ROWS && row.len() == 1 && origin(&vector[0]) == origin(&row[0])
    };
    if !chosen.blocks.windows(2).any(|two| is_vector_and_row(&two[0], &two[1])) {
        return None;
    }
    let along = along();
    let (mut blocks, mut is_new): (Vec<Vec<Pivot>>, bool) = (Vec::new(), false);
    for block in &chosen.blocks {
        let pairs = match blocks.as_slice() {
            [before @ .., vector] if is_vector_and_row(vector, block) => {
                best(chosen, before, &[vector.as_slice(), block].concat(), &along)
            }
            _ => None,
        };
        match pairs {
            Some(pairs) => {
                is_new = true;
                blocks.pop();
                blocks.extend(pairs);
            }
            None => blocks.push(block.clone()),
        }
    }
    is_new.then(|| Partition { blocks, ..chosen.clone() })
}

/// Of all pairs that are as regular along the motion as the vector and its row those that take least, by structure.
fn best(
    chosen: &Partition,
    before: &[Vec<Pivot>],
    four: &[Pivot],
    along: &[Rows],
) -> Option<[Vec<Pivot>; 2]> {
    let left: Vec<Rows> = along.iter().filter_map(|rows| without(rows, &chosen.scales, before)).collect();
    let pattern = left.first()?;
    let vector = smaller(chosen, &left, &[four[..ROWS - 1].to_vec(), four[ROWS - 1..].to_vec()]);
    let two = |rows: [usize; 2], velocities: [usize; 2]| -> Vec<Pivot> {
        let both = rows.iter().zip(&velocities);
        both.map(|(row, at)| Pivot { row: four[*row].row, velocity: four[*at].velocity }).collect()
    };
    let last = PAIRS.len() - 1;
    let candidates = (0..=last).flat_map(|rows| (0..=last).map(move |velocities| (rows, velocities)));
    let candidates = candidates.map(|(rows, velocities)| {
        let rest = two(PAIRS[last - rows], PAIRS[last - velocities]);
        [two(PAIRS[rows], PAIRS[velocities]), rest]
    });
    let as_regular = |pairs: &[Vec<Pivot>; 2]| {
        let pairs = smaller(chosen, &left, pairs);
        pairs.iter().zip(&vector).all(|(pairs, vector)| *pairs >= AS_REGULAR * vector)
    };
    candidates.filter(as_regular).min_by_key(|pairs| products(pattern, pairs))
}

/// The smaller of two determinants at each position, relative to their sizes.
fn smaller(chosen: &Partition, along: &[Rows], blocks: &[Vec<Pivot>; 2]) -> Vec<f64> {
    let size = |block: &[Pivot]| -> f64 {
        let size = |pivot: &Pivot| chosen.row_sizes[pivot.row] / chosen.scales[pivot.velocity];
        block.iter().map(size).product()
    };
    let all = blocks.concat();
    let of = |rows: &Rows| {
        let first = determinant(rows, &blocks[0]);
        let second = determinant(rows, &all) / first;
        (first / size(&blocks[0])).abs().min((second / size(&blocks[1])).abs())
    };
    along.iter().map(of).collect()
}

/// The rows that are left after these blocks; `None` where a pivot is nothing.
fn without(rows: &Rows, scales: &[f64], blocks: &[Vec<Pivot>]) -> Option<Rows> {
    let mut active = Active::new(rows.clone(), scales);
    for pivot in blocks.iter().flatten() {
        active.eliminate(pivot.row, pivot.velocity);
    }
    let left = active.rows;
    left.values().flat_map(BTreeMap::values).all(|entry| entry.is_finite()).then_some(left)
}

/// Of the square of these rows and velocities, by Gauss's elimination with the largest pivots.
fn determinant(rows: &Rows, block: &[Pivot]) -> f64 {
    let entry = |row: usize, column: usize| rows[&row].get(&column).copied().unwrap_or(0.0);
    let of_row = |row: &Pivot| block.iter().map(|column| entry(row.row, column.velocity)).collect();
    let mut square: Vec<Vec<f64>> = block.iter().map(of_row).collect();
    let mut determinant = 1.0;
    for at in 0..square.len() {
        let largest = (at..square.len()).max_by(|a, b| square[*a][at].abs().total_cmp(&square[*b][at].abs()));
        let largest = largest.unwrap_or(at);
        if largest != at {
            square.swap(at, largest);
            determinant = -determinant;
        }
        let pivot = square[at].clone();
        determinant *= pivot[at];
        if pivot[at] == 0.0 {
            return 0.0;
        }
        for row in &mut square[at + 1..] {
            let factor = row[at] / pivot[at];
            row.iter_mut().zip(&pivot).for_each(|(entry, above)| *entry -= factor * above);
        }
    }
    determinant
}

/// Products of the elimination of two pairs and of three solutions with them, by structure.
fn products(rows: &Rows, pairs: &[Vec<Pivot>; 2]) -> usize {
    const SOLUTIONS: usize = 3;
    let mut pattern: BTreeMap<usize, BTreeSet<usize>> =
        rows.iter().map(|(row, entries)| (*row, entries.keys().copied().collect())).collect();
    let mut products = 0;
    for pair in pairs {
        let own: Vec<BTreeSet<usize>> =
            pair.iter().map(|pivot| pattern.remove(&pivot.row).unwrap_or_default()).collect();
        let velocities: Vec<usize> = pair.iter().map(|pivot| pivot.velocity).collect();
        // Of the inverse the entry that belongs to a velocity and a row is the opposite one of the block.
        let inverse = |velocity: usize, row: usize| own[1 - row].contains(&velocities[1 - velocity]);
        let places = || (0..2).flat_map(|velocity| (0..2).map(move |row| (velocity, row)));
        let in_inverse = places().filter(|(velocity, row)| inverse(*velocity, *row)).count();
        products += (1 + SOLUTIONS) * in_inverse;
        let beside: BTreeSet<usize> =
            own.iter().flatten().copied().filter(|column| !velocities.contains(column)).collect();
        let mut upper: BTreeMap<usize, [bool; 2]> = BTreeMap::new();
        for column in &beside {
            let terms = |velocity: usize| {
                (0..2).filter(|row| own[*row].contains(column) && inverse(velocity, *row)).count()
            };
            let terms = [terms(0), terms(1)];
            products += terms[0] + terms[1];
            upper.insert(*column, terms.map(|terms| terms > 0));
        }
        let in_upper = upper.values().flatten().filter(|entry| **entry).count();
        products += SOLUTIONS * in_upper;
        for entries in pattern.values_mut() {
            let below = [0, 1].map(|at| entries.remove(&velocities[at]));
            if below == [false, false] {
                continue;
            }
            products += SOLUTIONS * below.iter().filter(|entry| **entry).count();
            for (column, upper) in &upper {
                let terms = below.iter().zip(upper).filter(|(below, upper)| **below && **upper).count();
                products += terms;
                if terms > 0 {
                    entries.insert(*column);
                }
            }
        }
    }
    products
}

#[cfg(test)]
mod tests;
