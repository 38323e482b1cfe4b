//! A sparse LDLᵀ factorisation whose order and pattern are tables made at expansion.
//!
//! This is the cold path: assembly, projection, naming a joint at a breakdown. The accelerations of a time step use
//! the factorisation that the compiler writes out as straight-line code; this one needs no code per mechanism, only
//! an [`Elimination`]. Which numbers K holds is decided in `assembly/system.rs`.

use crate::mechanism::Elimination;
use crate::real::Real;
use crate::vector::{Vector, at, put};
use core::marker::PhantomData;

/// A symmetric matrix K = L D Lᵀ in the pattern of an [`Elimination`]: first its entries, then in place its factor.
///
/// `F` holds the entries below the diagonal (`columns.len()` of them), `S` one entry for each unknown. Unknowns are
/// numbered as in [`Elimination`]; right-hand sides and solutions are in that numbering too. Every call takes the same tables, which
/// belong to the mechanism.
///
/// ```
/// use linkwright_runtime::mechanism::Elimination;
/// use linkwright_runtime::ldl::Ldl;
/// static TABLES: Elimination<'static> =
///     Elimination { order: &[1, 0], position: &[1, 0], row_start: &[0, 0, 1], columns: &[0] };
/// let mut k = Ldl::<f64, [f64; 1], [f64; 2]>::new(&TABLES);
/// k.add(&TABLES, 0, 0, 4.0); // K = [4 2; 2 2]
/// k.add(&TABLES, 1, 1, 2.0);
/// k.add(&TABLES, 0, 1, 2.0);
/// assert_eq!(k.factor(&TABLES).value, 0.3333333333333333); // 4 − 2²/2 against 4 + 2²/2
/// assert_eq!(k.solve(&TABLES, &[8.0, 6.0]), [1.0, 2.0]);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Ldl<R, F, S> {
    lower: F,
    diagonal: S,
    scalar: PhantomData<R>,
}

/// The sum of the terms that formed a pivot, and the sum of their magnitudes.
struct Terms<R> {
    value: R,
    magnitude: R,
}

impl<R: Real> Terms<R> {
    /// How much of the terms is left; a pivot without any term is as lost as one that cancelled.
    fn relative(&self) -> R {
        if self.magnitude == R::ZERO { R::ZERO } else { self.value.abs() / self.magnitude }
    }
}

/// The smallest pivot of a factorisation, relative to the sum of the magnitudes of the terms that formed it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pivot<R> {
    /// |d| / (|K_kk| + Σ|l w|), in [0, 1].
    pub value: R,
    /// The unknown that was being eliminated.
    pub unknown: usize,
}

impl<R: Real, F: Vector<R>, S: Vector<R>> Ldl<R, F, S> {
    /// The zero matrix in the pattern of `tables`.
    pub fn new(tables: &Elimination<'_>) -> Self {
        let (lower, diagonal) = (F::zeros(tables.columns.len()), S::zeros(tables.order.len()));
        Ldl { lower, diagonal, scalar: PhantomData }
    }

    /// Sets all entries to zero, to be filled anew.
    pub fn clear(&mut self) {
        self.lower.as_mut_slice().fill(R::ZERO);
        self.diagonal.as_mut_slice().fill(R::ZERO);
    }

    /// K(i, j) and K(j, i) += `value`, once for the pair; an entry outside the pattern is a fault of the tables.
    pub fn add(&mut self, tables: &Elimination<'_>, i: usize, j: usize, value: R) {
        let position = |unknown: usize| tables.position.get(unknown).copied().unwrap_or_default();
        let (i, j) = (position(i), position(j));
        let (early, late) = if i < j { (i, j) } else { (j, i) };
        let entry = if early == late {
            self.diagonal.as_mut_slice().get_mut(late as usize)
        } else {
            let (start, columns) = row(tables, late as usize);
            let found = columns.binary_search(&early);
            debug_assert!(found.is_ok(), "the entry ({i}, {j}) is not in the pattern of the factor");
            found.ok().and_then(|offset| self.lower.as_mut_slice().get_mut(start + offset))
        };
        if let Some(entry) = entry {
            *entry = *entry + value;
        }
    }

    /// K ← (L, D) in place, row by row; stops at the first relative pivot below [`Real::BREAKDOWN`], after which the
    /// factor must not be used to solve.
    ///
    /// Row k of L solves a triangular system with the rows above it (up-looking: Davis, *Direct Methods for Sparse
    /// Linear Systems*, 4.8): w_j = K_kj − Σ_i L_ji w_i, l_kj = w_j / d_j, d_k = K_kk − Σ_j l_kj w_j.
    pub fn factor(&mut self, tables: &Elimination<'_>) -> Pivot<R> {
        let mut smallest = Pivot { value: R::ONE, unknown: 0 };
        let mut work = S::zeros(tables.order.len());
        for (k, &unknown) in tables.order.iter().enumerate() {
            let terms = self.factor_row(tables, k, work.as_mut_slice());
            let relative = terms.relative();
            if k == 0 || relative < smallest.value {
                smallest = Pivot { value: relative, unknown: unknown as usize };
            }
            if relative < R::BREAKDOWN {
                break;
            }
        }
        smallest
    }

    /// As [`factor`](Ldl::factor), to the end whatever the pivots; of each unknown `magnitudes` receives the sum of the
    /// terms that have the sign of its pivot in a K of full rank: positive of the velocities, those before `rows_from`,
    /// negative of rows. The smallest relative pivot is that of the velocities.
    pub(crate) fn factor_measured(
        &mut self,
        tables: &Elimination<'_>,
        rows_from: usize,
        magnitudes: &mut S,
    ) -> Pivot<R> {
        let mut smallest = Pivot { value: R::ONE, unknown: 0 };
        let mut work = S::zeros(tables.order.len());
        for (k, &unknown) in tables.order.iter().enumerate() {
            let unknown = unknown as usize;
            let terms = self.factor_row(tables, k, work.as_mut_slice());
            let value = if unknown < rows_from { terms.value } else { -terms.value };
            put(magnitudes.as_mut_slice(), unknown, R::from_f64(0.5) * (terms.magnitude + value));
            if unknown < rows_from && terms.relative() < smallest.value {
                smallest = Pivot { value: terms.relative(), unknown };
            }
        }
        smallest
    }

    /// D, in the order of elimination.
    pub(crate) fn pivots(&self) -> &[R] {
        self.diagonal.as_slice()
    }

    /// One row of [`factor`](Ldl::factor): writes d_k and gives the terms that formed it; leaves `work` cleared.
    fn factor_row(&mut self, tables: &Elimination<'_>, k: usize, work: &mut [R]) -> Terms<R> {
        let (start, columns) = row(tables, k);
        let Some((done, own)) = self.lower.as_mut_slice().split_at_mut_checked(start) else {
            return Terms { value: R::ZERO, magnitude: R::ZERO };
        };
        for (&j, &entry) in columns.iter().zip(own.iter()) {
            put(work, j as usize, entry);
        }

        let diagonal = self.diagonal.as_mut_slice();
        let mut value = at(diagonal, k);
        let mut magnitude = value.abs();
        for (&j, entry) in columns.iter().zip(own.iter_mut()) {
            let j = j as usize;
            let (begin, above) = row(tables, j);
            let mut w = at(work, j);
            for (&i, &l) in above.iter().zip(done.get(begin..).unwrap_or_default()) {
                w = w - l * at(work, i as usize);
            }
            put(work, j, w);
            let l = w / at(diagonal, j);
            *entry = l;
            value = value - l * w;
            magnitude = magnitude + (l * w).abs();
        }
        for &j in columns {
            put(work, j as usize, R::ZERO);
        }
        put(diagonal, k, value);
        Terms { value, magnitude }
    }

    /// K⁻¹ · `right` after [`factor`](Ldl::factor): forward, diagonal, backward.
    pub fn solve(&self, tables: &Elimination<'_>, right: &S) -> S {
        let (lower, diagonal) = (self.lower.as_slice(), self.diagonal.as_slice());
        let mut permuted = S::zeros(right.as_slice().len());
        let x = permuted.as_mut_slice();
        for (entry, &unknown) in x.iter_mut().zip(tables.order) {
            *entry = at(right.as_slice(), unknown as usize);
        }
        for k in 0..x.len() {
            let (start, columns) = row(tables, k);
            let mut rest = at(x, k);
            for (&j, &l) in columns.iter().zip(lower.get(start..).unwrap_or_default()) {
                rest = rest - l * at(x, j as usize);
            }
            put(x, k, rest);
        }
        for (entry, &d) in x.iter_mut().zip(diagonal) {
            *entry = *entry / d;
        }
        for k in (0..x.len()).rev() {
            let (start, columns) = row(tables, k);
            let own = at(x, k);
            for (&j, &l) in columns.iter().zip(lower.get(start..).unwrap_or_default()) {
                put(x, j as usize, at(x, j as usize) - l * own);
            }
        }
        let mut solution = S::zeros(right.as_slice().len());
        for (&entry, &unknown) in permuted.as_slice().iter().zip(tables.order) {
            put(solution.as_mut_slice(), unknown as usize, entry);
        }
        solution
    }
}

/// Where row k of L begins, and its columns.
#[inline]
fn row<'t>(tables: &Elimination<'t>, k: usize) -> (usize, &'t [u16]) {
    let begins = |k: usize| tables.row_start.get(k).map_or(0, |&start| start as usize);
    let start = begins(k);
    (start, tables.columns.get(start..begins(k + 1)).unwrap_or_default())
}
