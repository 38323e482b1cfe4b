//! Joints that stick and are held by others that do.

use super::complementarity::{Few, ROWS, solved};
use crate::real::Real;
use crate::vector::{at, dot, put};

/// What is left of the motion that a joint has by itself where others hold it, as a part of it without them.
const TIED: f64 = 1e-6;

/// What sticks and has no motion of its own, since others that stick hold it: they share what is asked of them so that Σ G_ii y_i² is least,
///
/// ```text
/// Σ n_i G_ii y_i = 0,    G n = 0,  n_t = 1
/// ```
/// which stands in the place of ẇ_t = 0. G are the derivatives of ẇ by y.
pub(super) struct Ties<R> {
    pub rows: [Option<Few<R>>; ROWS],
    /// Those with a motion of their own, as bits.
    pub firm: usize,
}

impl<R: Real> Ties<R> {
    pub fn of(matrix: &[Few<R>; ROWS], sticking: usize) -> Self {
        let mut ties = Ties { rows: [None; ROWS], firm: 0 };
        for (t, tie) in ties.rows.iter_mut().enumerate().filter(|(t, _)| sticking >> t & 1 == 1) {
            match share(matrix, ties.firm, t) {
                Some(null) => {
                    let diagonal = |i: usize| matrix.get(i).map_or(R::ZERO, |row| at(row, i));
                    *tie = Some(core::array::from_fn(|i| at(&null, i) * diagonal(i)));
                }
                None => ties.firm |= 1 << t,
            }
        }
        ties
    }
}

/// n of a joint that is held by those in `firm`; nothing where it is not.
pub(super) fn share<R: Real>(matrix: &[Few<R>; ROWS], firm: usize, t: usize) -> Option<Few<R>> {
    if firm == 0 {
        return None;
    }
    let column = core::array::from_fn(|i| matrix.get(i).map_or(R::ZERO, |row| at(row, t)));
    let mut null = solved(matrix, &column, 0, ROWS, firm)?;
    put(&mut null, t, R::ONE);
    let row = matrix.get(t)?;
    let least = R::from_f64(TIED).max(R::EPSILON.sqrt());
    R::any(dot(row, &null).less(least * at(row, t))).then_some(null)
}
