//! Dependent and independent velocities: a factorisation of D that chooses them, and the null space it gives.
//!
//! D v = rows is solved for m dependent velocities, given the others. Which ones these are is kept from one position to the
//! next for as long as their pivots are good, and chosen anew where they are not. Formulations in independent coordinates are
//! `formulation/null_space.rs` and `partitioned.rs`.

use crate::mechanism::Assemble;
use crate::real::Real;
use crate::vector::Vector;

/// A pivot of this part of the largest entry of its row is good enough to keep the velocity that was dependent before.
const GOOD: f64 = 0.1;

/// The place of a velocity that depends on no row.
const NONE: u16 = u16::MAX;

/// D = L U with a dependent velocity for each row: U has the pivot of row i in column `columns[i]`, L is stored where U is
/// zero.
#[derive(Clone, Copy, Debug)]
pub struct Partition<D, C, R> {
    /// m × n_v, row by row.
    rows: D,
    /// The dependent velocity of each row.
    columns: C,
    /// The row of each velocity, or [`NONE`].
    places: C,
    /// The smallest pivot, relative to the largest entry of its row before elimination.
    pivot: R,
    /// How often a dependent velocity was replaced since the beginning.
    pub changes: u32,
}

/// The partition of a mechanism.
pub type PartitionOf<R, M> = Partition<<M as Assemble<R>>::Dense, <M as Assemble<R>>::Choice, R>;

impl<R: Real, D: Vector<R>, C: Copy + AsRef<[u16]> + AsMut<[u16]>> Partition<D, C, R> {
    /// The choice made at expansion, if there is one; nothing factored yet.
    pub fn new<M: Assemble<R, Dense = D, Choice = C>>() -> Self {
        let mut none = M::choice();
        none.as_mut().fill(NONE);
        let mut columns = none;
        for (column, &chosen) in columns.as_mut().iter_mut().zip(M::DEPENDENT) {
            *column = chosen;
        }
        Partition { rows: D::zero(), columns, places: none, pivot: R::ONE, changes: 0 }
    }

    /// Whether a velocity is an independent one.
    pub fn is_independent(&self, velocity: usize) -> bool {
        self.places.as_ref()[velocity] == NONE
    }

    /// The independent velocities, ascending.
    pub fn independent(&self) -> impl Iterator<Item = usize> + '_ {
        let places = self.places.as_ref().iter().enumerate();
        places.filter(|(_, place)| **place == NONE).map(|(velocity, _)| velocity)
    }

    /// Factors D at a position; returns the square of the smallest pivot relative to its row, which like the other pivots
    /// vanishes with the square of the distance from a singular position.
    ///
    /// Row by row: what earlier pivots have is taken off, then the velocity that depended on the row before stays dependent if its
    /// entry is a tenth of the largest, else that of the largest takes its place (partial pivoting by columns).
    pub fn factor<M: Assemble<R, Dense = D, Choice = C>>(&mut self, model: &M, time: R, q: &M::Q) -> R {
        let n = M::V::LEN;
        let mut jacobian = M::Jacobian::zero();
        model.constraint_jacobian(time, q, &mut jacobian);
        self.rows = D::zero();
        for (&entry, &(row, column)) in jacobian.as_slice().iter().zip(M::JACOBIAN_PATTERN) {
            self.rows.as_mut_slice()[row as usize * n + column as usize] = entry;
        }
        let before = self.columns;
        self.places.as_mut().fill(NONE);
        self.pivot = R::ONE;
        for row in (0..M::Lambda::LEN).filter(|&row| !M::IDLE.contains(&(row as u16))) {
            let (above, rest) = self.rows.as_mut_slice().split_at_mut(row * n);
            let entries = &mut rest[..n];
            let size = largest(entries, |_| true).1;
            for (k, upper) in above.chunks_exact(n).enumerate() {
                let column = self.columns.as_ref()[k] as usize;
                if column >= n || M::IDLE.contains(&(k as u16)) || entries[column] == R::ZERO {
                    continue;
                }
                let l = entries[column] / upper[column];
                for (j, (entry, &u)) in entries.iter_mut().zip(upper).enumerate() {
                    // Where an earlier row has its pivot, `upper` holds L.
                    let eliminated = self.places.as_ref()[j];
                    if eliminated == NONE || usize::from(eliminated) > k {
                        *entry = *entry - l * u;
                    }
                }
                entries[column] = l;
            }
            let places = self.places.as_ref();
            let (best, most) = largest(entries, |column| places[column] == NONE);
            let kept = before.as_ref()[row] as usize;
            let good = kept < n && places[kept] == NONE && entries[kept].abs() >= R::from_f64(GOOD) * most;
            let chosen = if good { kept } else { best };
            if !good && kept < n {
                self.changes += 1;
            }
            self.columns.as_mut()[row] = chosen as u16;
            self.places.as_mut()[chosen] = row as u16;
            let relative = if size > R::ZERO { entries[chosen].abs() / size } else { R::ZERO };
            self.pivot = relative.min(self.pivot);
        }
        self.pivot * self.pivot
    }

    /// The dependent entries of `v` such that D v = `rows`, given the independent ones.
    pub fn dependent<M: Assemble<R, Dense = D, Choice = C>>(&self, rows: &M::Lambda, v: &mut M::V) {
        let n = M::V::LEN;
        let (columns, places) = (self.columns.as_ref(), self.places.as_ref());
        let mut y = *rows;
        let live = |row: usize| !M::IDLE.contains(&(row as u16));
        let y = y.as_mut_slice();
        for row in (0..y.len()).filter(|&row| live(row)) {
            let entries = &self.rows.as_slice()[row * n..][..n];
            for k in (0..row).filter(|&k| live(k)) {
                y[row] = y[row] - entries[columns[k] as usize] * y[k];
            }
        }
        let v = v.as_mut_slice();
        for row in (0..y.len()).rev().filter(|&row| live(row)) {
            let entries = &self.rows.as_slice()[row * n..][..n];
            let pivot = columns[row] as usize;
            let mut rest = y[row];
            for (j, &entry) in entries.iter().enumerate() {
                // NONE is above all rows: independent velocities count among the later ones.
                if usize::from(places[j]) > row {
                    rest = rest - entry * v[j];
                }
            }
            v[pivot] = rest / entries[pivot];
        }
    }

    /// λ of D_dᵀ λ = `forces` in the dependent velocities; idle rows have none.
    pub fn multipliers<M: Assemble<R, Dense = D, Choice = C>>(&self, forces: &M::V, lambda: &mut M::Lambda) {
        let n = M::V::LEN;
        let columns = self.columns.as_ref();
        let live = |row: usize| !M::IDLE.contains(&(row as u16));
        *lambda = M::Lambda::zero();
        let y = lambda.as_mut_slice();
        // Uᵀ y = forces, then Lᵀ λ = y.
        for row in (0..y.len()).filter(|&row| live(row)) {
            let column = columns[row] as usize;
            let mut rest = forces.as_slice()[column];
            for k in (0..row).filter(|&k| live(k)) {
                rest = rest - self.rows.as_slice()[k * n + column] * y[k];
            }
            y[row] = rest / self.rows.as_slice()[row * n + column];
        }
        for row in (0..y.len()).rev().filter(|&row| live(row)) {
            let entries = &self.rows.as_slice()[row * n..][..n];
            for k in (0..row).filter(|&k| live(k)) {
                y[k] = y[k] - entries[columns[k] as usize] * y[row];
            }
        }
    }
}

/// Place and magnitude of the largest entry among those that count.
fn largest<R: Real>(entries: &[R], counts: impl Fn(usize) -> bool) -> (usize, R) {
    let mut found = (0, R::ZERO);
    for (column, entry) in entries.iter().enumerate().filter(|(column, _)| counts(*column)) {
        if entry.abs() > found.1 || !counts(found.0) {
            found = (column, entry.abs());
        }
    }
    found
}
