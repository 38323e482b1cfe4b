//! D at a position while it is eliminated, row by row.

use std::collections::{BTreeMap, BTreeSet};

/// Entries of D by row and column.
pub type Rows = BTreeMap<usize, BTreeMap<usize, f64>>;

/// An entry of this part of the largest of its row is good enough for a pivot.
const GOOD: f64 = 0.3;

/// D while it is eliminated.
pub struct Active {
    pub rows: Rows,
    /// The rows that hold a velocity.
    holders: Vec<BTreeSet<usize>>,
    scales: Vec<f64>,
}

impl Active {
    /// `scales`: one over the size of each column.
    pub fn new(rows: Rows, scales: &[f64]) -> Active {
        let mut holders = vec![BTreeSet::new(); scales.len()];
        for (row, entries) in &rows {
            entries.keys().for_each(|column| _ = holders[*column].insert(*row));
        }
        Active { rows, holders, scales: scales.to_vec() }
    }

    /// Entries of the longest row of a block.
    pub fn length(&self, block: &[usize]) -> usize {
        block.iter().map(|row| self.rows[row].len()).max().unwrap_or(0)
    }

    /// The next pivot of a block; `None` at its end.
    pub fn next(&self, block: &[usize], spared: &BTreeSet<usize>) -> Option<(usize, usize)> {
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
    pub fn eliminate(&mut self, row: usize, pivot: usize) -> (usize, BTreeSet<usize>) {
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
