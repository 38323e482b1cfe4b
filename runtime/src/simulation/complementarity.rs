//! The complementarity problem of a few contacts: which of them push, and how much.

use crate::real::Real;
use crate::vector::{at, dot, put};

/// How many rigid contacts may touch at one time: all 2⁴ ways in which they may push are tried.
pub const RIGID_TOUCHING: usize = 4;

/// What is left of numbers that are zero, as a part of those that they come from.
const NOTHING: f64 = 1e-11;

/// One number for each contact that touches.
pub(super) type Few<R> = [R; RIGID_TOUCHING];

/// 0 ≤ x ⟂ G x + c ≥ 0 of all `count` contacts.
pub(super) fn complementary<R: Real>(
    matrix: &[Few<R>; RIGID_TOUCHING],
    right: &Few<R>,
    count: usize,
) -> Option<Few<R>> {
    complementary_of(matrix, right, count, (1 << count) - 1)
}

/// 0 ≤ x ⟂ G x + c ≥ 0 of the contacts in `among`; the others have zero. The first of all sets that does, fewest first where one holds
/// another.
pub(super) fn complementary_of<R: Real>(
    matrix: &[Few<R>; RIGID_TOUCHING],
    right: &Few<R>,
    count: usize,
    among: usize,
) -> Option<Few<R>> {
    let largest = right.iter().fold(R::ZERO, |largest, c| largest.max(c.abs()));
    let nothing = R::from_f64(NOTHING).max(R::from_f64(1000.0) * R::EPSILON) * largest;
    let sets = (0..1_usize << count).filter(|set| set & !among == 0);
    sets.filter_map(|set| solved(matrix, right, count, set).map(|x| (set, x)))
        .find(|(set, x)| {
            (0..count).filter(|place| among >> place & 1 == 1).all(|place| {
                if set >> place & 1 == 1 {
                    return at(x, place) >= R::ZERO;
                }
                let rest = matrix.get(place).map_or(R::ZERO, |row| dot(row, x));
                rest + at(right, place) >= -nothing
            })
        })
        .map(|(_, x)| x)
}

/// G x = −c of the contacts in `set`, the others zero; nothing where G is singular.
pub(super) fn solved<R: Real>(
    matrix: &[Few<R>; RIGID_TOUCHING],
    right: &Few<R>,
    count: usize,
    set: usize,
) -> Option<Few<R>> {
    let (mut left, mut x) = (*matrix, right.map(|c| -c));
    let held = |place: usize| place < count && set >> place & 1 == 1;
    let least = R::from_f64(1e-10).max(R::from_f64(16.0) * R::EPSILON);
    for pivot in (0..count).filter(|pivot| held(*pivot)) {
        let row = left.get(pivot).copied()?;
        let diagonal = at(&row, pivot);
        let whole = matrix.get(pivot).map_or(R::ZERO, |row| at(row, pivot));
        // Written so that a NaN is singular.
        if !R::any(diagonal.greater(least * whole.abs())) {
            return None;
        }
        for below in (0..count).filter(|below| held(*below) && *below != pivot) {
            let target = left.get_mut(below)?;
            let factor = at(target, pivot) / diagonal;
            for (entry, above) in target.iter_mut().zip(&row) {
                *entry = *entry - factor * *above;
            }
            let value = at(&x, below) - factor * at(&x, pivot);
            put(&mut x, below, value);
        }
    }
    for place in 0..RIGID_TOUCHING {
        let value = match left.get(place) {
            Some(row) if held(place) => at(&x, place) / at(row, place),
            _ => R::ZERO,
        };
        put(&mut x, place, value);
    }
    Some(x)
}
