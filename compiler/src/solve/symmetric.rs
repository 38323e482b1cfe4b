//! M by rows, both triangles.

use super::elimination::Entries;
use crate::symbolic::{Scalar, Sheet};
use std::collections::BTreeMap;

/// A sparse vector by its entries that are not zero.
pub type Sparse<'g> = BTreeMap<usize, Scalar<'g>>;

pub struct Symmetric<'g> {
    pub rows: Vec<Vec<(usize, Scalar<'g>)>>,
}

impl<'g> Symmetric<'g> {
    pub fn new(g: Sheet<'g>, size: usize, lower: &Entries) -> Self {
        let mut rows = vec![Vec::new(); size];
        for ((i, j), entry) in lower {
            rows[*i].push((*j, g.on(*entry)));
            if i != j {
                rows[*j].push((*i, g.on(*entry)));
            }
        }
        Symmetric { rows }
    }

    /// Entries that are not zero, of both triangles.
    pub fn entries(&self) -> usize {
        self.rows.iter().map(Vec::len).sum()
    }

    pub fn times(&self, x: &Sparse<'g>) -> Sparse<'g> {
        let mut product = Sparse::new();
        for (j, value) in x {
            for (i, entry) in &self.rows[*j] {
                let term = *entry * *value;
                let sum = product.get(i).map_or(term, |sum| *sum + term);
                product.insert(*i, sum);
            }
        }
        product
    }

    /// Q − M a.
    pub fn taken_from(&self, forces: &[Scalar<'g>], a: &[Scalar<'g>]) -> Vec<Scalar<'g>> {
        let product = self.times(&sparse(a));
        let entry = |(at, x): (usize, &Scalar<'g>)| product.get(&at).map_or(*x, |y| *x - *y);
        forces.iter().enumerate().map(entry).collect()
    }
}

/// The entries that are not zero.
pub fn sparse<'g>(entries: &[Scalar<'g>]) -> Sparse<'g> {
    entries.iter().copied().enumerate().filter(|(_, entry)| entry.value() != Some(0.0)).collect()
}
