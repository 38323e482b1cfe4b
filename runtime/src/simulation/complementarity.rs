//! The complementarity problem of a few contacts: which of them push, and how much; and the laws of impacts, which are such problems.

use crate::real::Real;
use crate::vector::{at, dot, put};

/// How many rigid contacts may touch at one time: all 2⁴ ways in which they may push are tried.
pub const RIGID_TOUCHING: usize = 4;

/// What is left of numbers that are zero, as a part of those that they come from.
const NOTHING: f64 = 1e-11;

/// One number for each contact that touches.
pub(super) type Few<R> = [R; RIGID_TOUCHING];

/// The impulses of contacts whose gaps close with `rates` ġ⁻, by restitutions e of speeds: 0 ≤ P ⟂ G P + (1 + e) ġ⁻ ≥ 0. What would part slower
/// than `rests` does not bounce.
pub(super) fn newton<R: Real>(
    matrix: &[Few<R>; RIGID_TOUCHING],
    count: usize,
    rates: &Few<R>,
    shares: &Few<R>,
    rests: &Few<R>,
) -> Option<Few<R>> {
    let wanted = core::array::from_fn(|place| {
        let (rate, share) = (at(rates, place), at(shares, place));
        if -rate * share > at(rests, place) { (R::ONE + share) * rate } else { rate }
    });
    complementary(matrix, &wanted, count)
}

/// The same by restitutions of impulses: 0 ≤ P_c ⟂ G P_c + ġ⁻ ≥ 0 ends the approach, then P = (1 + e) P_c + X with 0 ≤ X ⟂ G P + ġ⁻ ≥ 0. How
/// fast something parts is here the rate that its impulse alone gives.
pub(super) fn poisson<R: Real>(
    matrix: &[Few<R>; RIGID_TOUCHING],
    count: usize,
    rates: &Few<R>,
    shares: &Few<R>,
    rests: &Few<R>,
) -> Option<Few<R>> {
    let mut given = complementary(matrix, rates, count)?;
    for (place, row) in matrix.iter().enumerate().take(count) {
        let (impulse, share) = (at(&given, place), at(shares, place));
        if share * impulse * at(row, place) > at(rests, place) {
            put(&mut given, place, (R::ONE + share) * impulse);
        }
    }
    let left = core::array::from_fn(|place| {
        at(rates, place) + matrix.get(place).map_or(R::ZERO, |row| dot(row, &given))
    });
    let more = complementary(matrix, &left, count)?;
    Some(core::array::from_fn(|place| at(&given, place) + at(&more, place)))
}

/// 0 ≤ x ⟂ G x + c ≥ 0 of all `count` contacts.
fn complementary<R: Real>(matrix: &[Few<R>; RIGID_TOUCHING], right: &Few<R>, count: usize) -> Option<Few<R>> {
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
