//! Dependent and independent velocities: a factorisation of D that chooses them, and the null space it gives.
//!
//! D v = rows is solved for m dependent velocities, given the others. Which ones these are is kept from one position to the
//! next for as long as their pivots are good, and chosen anew where they are not. Mechanisms whose definition says
//! `options { emit = (null_space); }` factor D by straight-line code for the velocities chosen at expansion; tables take over where
//! one of its pivots is too small. Formulations in independent coordinates are `formulation/null_space.rs` and `partitioned.rs`.

use crate::mechanism::Assemble;
use crate::real::Real;
use crate::vector::{Vector, at, put};

/// A pivot of this part of the largest entry of its row is good enough to keep the velocity that was dependent before.
const GOOD: f64 = 0.1;

/// The place of a velocity that depends on no row.
const NONE: u16 = u16::MAX;

/// The square of a written-out pivot, relative to the size of its row, below which accelerations are computed in another way:
/// two digits lost.
const WRITTEN_OUT: f64 = 1e-4;

/// The dependent velocity of each row: those of [`Assemble::dependent`], until others serve better. It is kept from one position
/// to the next; the factors are not.
///
/// By tables U has the pivot of the k-th row in column `columns[k]`, and L is stored where U is zero.
#[derive(Clone, Copy, Debug)]
pub struct Partition<C> {
    /// The dependent velocity of the k-th row of [`Assemble::dependent`].
    columns: C,
    /// The place in `columns` of each velocity, or [`NONE`].
    places: C,
    /// How often a dependent velocity was replaced since the beginning.
    pub changes: u32,
}

/// The partition of a mechanism.
pub type PartitionOf<R, M> = Partition<<M as Assemble<R>>::Choice>;

/// The written-out factors of D for the velocities of [`Assemble::dependent`], where their pivots are good.
pub(crate) fn written_out<R: Real, M: Assemble<R>>(model: &M, time: R, q: &M::Q) -> Option<M::Lu> {
    let mut lu = model.lu();
    let pivot = model.factor_jacobian(time, q, &mut lu);
    is_good(pivot).then_some(lu)
}

/// Whether the square of a pivot is that of one that a choice is kept for. Written so that a NaN is not.
pub(crate) fn is_good<R: Real>(pivot: R) -> bool {
    R::any(pivot.greater_equal(R::from_f64(GOOD * GOOD)))
}

impl<C: Clone + AsRef<[u16]> + AsMut<[u16]>> Partition<C> {
    /// The choice made at expansion.
    pub fn new<R: Real, M: Assemble<R, Choice = C>>(model: &M) -> Self {
        debug_assert_eq!(
            model.dependent().len() + model.idle().len(),
            model.row_count(),
            "each row has its velocity"
        );
        let mut partition = Partition { columns: model.choice(), places: model.choice(), changes: 0 };
        partition.reset(model);
        partition
    }

    /// Takes the velocities chosen at expansion.
    pub(crate) fn reset<R: Real, M: Assemble<R, Choice = C>>(&mut self, model: &M) {
        self.columns.as_mut().fill(NONE);
        self.places.as_mut().fill(NONE);
        for (k, &(_, chosen)) in model.dependent().iter().enumerate() {
            if let Some(column) = self.columns.as_mut().get_mut(k) {
                *column = chosen;
            }
            if let Some(place) = self.places.as_mut().get_mut(chosen as usize) {
                *place = k as u16;
            }
        }
    }

    /// The independent velocities, ascending.
    pub fn independent(&self) -> impl Iterator<Item = usize> + '_ {
        let places = self.places.as_ref().iter().enumerate();
        places.filter(|(_, place)| **place == NONE).map(|(velocity, _)| velocity)
    }

    /// Factors D at a position into `factors` (m × n_v), row by row: what earlier pivots have is taken off, then the velocity that
    /// depended on the row before stays dependent if its entry is a tenth of the largest, else that of the largest takes its place
    /// (partial pivoting by columns).
    ///
    /// Returns the square of the smallest pivot relative to the size of its row along the motion, which like the other pivots vanishes
    /// with the square of the distance from a singular position.
    pub fn factor<R: Real, M: Assemble<R, Choice = C>>(
        &mut self,
        model: &M,
        time: R,
        q: &M::Q,
        factors: &mut M::Dense,
    ) -> R {
        let n = model.velocity_count();
        let mut jacobian = model.zero_jacobian();
        model.constraint_jacobian(time, q, &mut jacobian);
        let rows = factors.as_mut_slice();
        rows.fill(R::ZERO);
        for (&entry, &(row, column)) in jacobian.as_slice().iter().zip(model.jacobian_pattern()) {
            put(rows, row as usize * n + column as usize, entry);
        }
        let before = self.columns.clone();
        let sizes = model.row_sizes();
        self.places.as_mut().fill(NONE);
        let mut smallest = R::ONE;
        for (step, &(row, _)) in model.dependent().iter().enumerate() {
            let size = at(sizes.as_slice(), row as usize);
            let own = row as usize * n;
            for (k, (&(above, _), &column)) in
                model.dependent().iter().zip(self.columns.as_ref()).take(step).enumerate()
            {
                let (above, column) = (above as usize * n, column as usize);
                let entry = at(rows, own + column);
                if entry == R::ZERO {
                    continue;
                }
                let l = entry / at(rows, above + column);
                for (j, &place) in self.places.as_ref().iter().enumerate() {
                    // Where an earlier row has its pivot, the row above holds L.
                    if place == NONE || usize::from(place) > k {
                        put(rows, own + j, at(rows, own + j) - l * at(rows, above + j));
                    }
                }
                put(rows, own + column, l);
            }
            let own = rows.get(own..own + n).unwrap_or_default();
            let places = self.places.as_ref();
            let free = |column: usize| places.get(column) == Some(&NONE);
            let (best, most) = largest(model, own, free);
            let kept = before.as_ref().get(step).map_or(n, |&kept| kept as usize);
            let good = kept < n && free(kept) && scaled(model, own, kept) >= R::from_f64(GOOD) * most;
            let chosen = if good { kept } else { best };
            smallest = (scaled(model, own, chosen) / size).min(smallest);
            if !good && kept < n {
                self.changes += 1;
            }
            if let Some(column) = self.columns.as_mut().get_mut(step) {
                *column = chosen as u16;
            }
            if let Some(place) = self.places.as_mut().get_mut(chosen) {
                *place = step as u16;
            }
        }
        smallest * smallest
    }

    /// The dependent entries of `v` such that D v = `right`, given the independent ones.
    pub fn dependent<R: Real, M: Assemble<R, Choice = C>>(
        &self,
        model: &M,
        factors: &M::Dense,
        right: &M::Lambda,
        v: &mut M::V,
    ) {
        let (columns, places) = (self.columns.as_ref(), self.places.as_ref());
        let n = model.velocity_count();
        let entries = |row: u16| factors.as_slice().get(usize::from(row) * n..).unwrap_or_default();
        let (mut rest, v) = (right.clone(), v.as_mut_slice());
        let y = rest.as_mut_slice();
        for (step, &(row, _)) in model.dependent().iter().enumerate() {
            let (own, mut rest) = (entries(row), at(y, row as usize));
            for (&(above, _), &column) in model.dependent().iter().zip(columns).take(step) {
                rest = rest - at(own, column as usize) * at(y, above as usize);
            }
            put(y, row as usize, rest);
        }
        for (step, (&(row, _), &pivot)) in model.dependent().iter().zip(columns).enumerate().rev() {
            let (own, pivot) = (entries(row), pivot as usize);
            let mut rest = at(y, row as usize);
            for ((&entry, &place), &v) in own.iter().zip(places).zip(v.iter()) {
                // NONE is above all places: independent velocities count among the later ones.
                if usize::from(place) > step {
                    rest = rest - entry * v;
                }
            }
            put(v, pivot, rest / at(own, pivot));
        }
    }

    /// R with D R = 0, column by column, `[R; f·n_v]`: one for each independent velocity, ascending, which has a one there.
    pub(crate) fn basis<R: Real, M: Assemble<R, Choice = C>>(
        &self,
        model: &M,
        factors: &M::Dense,
        basis: &mut M::Basis,
    ) {
        let (n, none) = (model.velocity_count(), model.zero_lambda());
        let places = basis.as_mut_slice().chunks_exact_mut(n.max(1));
        for (own, velocity) in places.zip(self.independent()) {
            let mut column = model.zero_v();
            put(column.as_mut_slice(), velocity, R::ONE);
            self.dependent(model, factors, &none, &mut column);
            own.iter_mut().zip(column.as_slice()).for_each(|(entry, &value)| *entry = value);
        }
    }

    /// λ of D_dᵀ λ = `forces` in the dependent velocities; idle rows have none.
    pub(crate) fn multipliers<R: Real, M: Assemble<R, Choice = C>>(
        &self,
        model: &M,
        factors: &M::Dense,
        forces: &M::V,
        lambda: &mut M::Lambda,
    ) {
        let columns = self.columns.as_ref();
        let place = |row: u16, column: u16| usize::from(row) * model.velocity_count() + usize::from(column);
        let entry = |row: u16, column: u16| at(factors.as_slice(), place(row, column));
        let y = lambda.as_mut_slice();
        y.fill(R::ZERO);
        // Uᵀ y = forces, then Lᵀ λ = y.
        for (step, (&(row, _), &column)) in model.dependent().iter().zip(columns).enumerate() {
            let mut rest = at(forces.as_slice(), column as usize);
            for &(above, _) in model.dependent().iter().take(step) {
                rest = rest - entry(above, column) * at(y, above as usize);
            }
            put(y, row as usize, rest / entry(row, column));
        }
        for (step, &(row, _)) in model.dependent().iter().enumerate().rev() {
            let own = at(y, row as usize);
            for (&(above, _), &column) in model.dependent().iter().zip(columns).take(step) {
                put(y, above as usize, at(y, above as usize) - entry(row, column) * own);
            }
        }
    }
}

/// The magnitude of an entry of a row, to be compared with others of it.
fn scaled<R: Real, M: Assemble<R>>(model: &M, row: &[R], column: usize) -> R {
    let entry = at(row, column).abs();
    model.scales().get(column).map_or(entry, |&scale| entry * R::from_f64(scale))
}

/// Place and scaled magnitude of the largest entry of a row among those that count.
fn largest<R: Real, M: Assemble<R>>(model: &M, row: &[R], counts: impl Fn(usize) -> bool) -> (usize, R) {
    let mut found: Option<(usize, R)> = None;
    for column in (0..row.len()).filter(|&column| counts(column)) {
        let size = scaled(model, row, column);
        if found.is_none_or(|(_, largest)| size > largest) {
            found = Some((column, size));
        }
    }
    found.unwrap_or((0, R::ZERO))
}

/// Whether written-out accelerations with this pivot are good enough, in all lanes.
#[inline(always)]
pub(crate) fn serves<R: Real>(pivot: R) -> bool {
    !R::any(!serving(pivot))
}

/// In which lanes they are. Written so that a NaN is not.
#[inline(always)]
pub(crate) fn serving<R: Real>(pivot: R) -> R::Mask {
    pivot.greater_equal(R::from_f64(WRITTEN_OUT).max(R::NEAR_SINGULAR))
}
