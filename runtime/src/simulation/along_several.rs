//! Dry friction of joints whose surfaces slide along several directions, as those of balls and sleeves: which of the gates are one, and where
//! such a joint goes that begins to slide.
//!
//! ```text
//! ẇ = G y + ẇ₀ = −λ y,   |y| = f,   λ > 0        so that   (G + λ I) y = −ẇ₀
//! ```
//! from rest: what resists is against where it goes. |y| falls with λ from what would hold, so that there is one λ where that is more than f and
//! none else; it is found by Newton's method for 1/|y| (Moré and Sorensen, SIAM J. Sci. Stat. Comput. 4 (1983) 553).

use super::complementarity::{Few, ROWS, solved};
use crate::mechanism::Mechanism;
use crate::real::Real;
use crate::trigger::contacts;
use crate::vector::{Vector, at, dot, put};

/// The most passes of Newton's method.
const PASSES: u32 = 60;

/// A last change of |y| as a part of it, in roundings.
const ROUNDINGS: f64 = 16.0;

fn first<R: Real, M: Mechanism<R>>(model: &M, gate: usize) -> usize {
    model.slide_as_one().get(gate).copied().unwrap_or(gate)
}

/// Whether no gate before it slides as one with it.
pub(super) fn is_first<R: Real, M: Mechanism<R>>(model: &M, gate: usize) -> bool {
    first(model, gate) == gate
}

/// The gates that slide as one with this, itself among them.
pub(super) fn together<R: Real, M: Mechanism<R>>(model: &M, gate: usize) -> impl Iterator<Item = usize> {
    let own = first(model, gate);
    (own..contacts(model).min(ROWS)).filter(move |other| first(model, *other) == own)
}

/// Whether it slides along one direction.
pub(super) fn alone<R: Real, M: Mechanism<R>>(model: &M, gate: usize) -> bool {
    model.slide_as_one().is_empty() || together(model, gate).nth(1).is_none()
}

/// The size of what belongs to a gate and those that slide as one with it.
pub(super) fn size<R: Real, M: Mechanism<R>>(model: &M, of: &M::Gates, gate: usize) -> R {
    if alone(model, gate) {
        return at(of.as_slice(), gate).abs();
    }
    let squares =
        together(model, gate).map(|i| at(of.as_slice(), i)).fold(R::ZERO, |sum, x| x.mul_add(x, sum));
    squares.sqrt()
}

/// The ways of what slides along several directions with these rates, faster than `slow`; where a rate has turned back beyond rest the way is
/// as if it had not, so that it goes on evenly to where rest is sought.
pub(super) fn along_rates<R: Real, M: Mechanism<R>>(
    model: &M,
    rates: &M::Gates,
    slow: R,
    ways: &mut M::Gates,
) {
    for gate in (0..model.slide_as_one().len()).filter(|gate| is_first(model, *gate) && !alone(model, *gate))
    {
        let speed = size(model, rates, gate);
        let product = |i| at(ways.as_slice(), i) * at(rates.as_slice(), i);
        let along = together(model, gate).fold(R::ZERO, |sum, i| sum + product(i));
        if !R::any(speed.greater(slow)) || R::any(size(model, ways, gate).equal(R::ZERO)) {
            continue;
        }
        let signed = if R::any(along.less(R::ZERO)) { -speed } else { speed };
        for i in together(model, gate) {
            put(ways.as_mut_slice(), i, at(rates.as_slice(), i) / signed);
        }
    }
}

/// y of those in the set where they begin to slide with |y| = f, ẇ being `open` without it; nothing where they are held with less.
pub(super) fn begun<R: Real>(matrix: &[Few<R>; ROWS], open: &Few<R>, set: usize, force: R) -> Option<Few<R>> {
    let mut lambda = R::ZERO;
    let mut forces = solved(matrix, open, 0, ROWS, set)?;
    let size = |x: &Few<R>| dot(x, x).sqrt();
    if !R::any(size(&forces).greater(force)) {
        return None;
    }
    let enough = R::from_f64(ROUNDINGS) * R::EPSILON * force;
    for _ in 0..PASSES {
        let more = size(&forces) - force;
        if !R::any(more.abs().greater(enough)) {
            break;
        }
        let mut stiffer = *matrix;
        for (i, row) in stiffer.iter_mut().enumerate() {
            let own = at(row, i);
            put(row, i, own + lambda);
        }
        // It is the other way round than y.
        let bent = solved(&stiffer, &forces, 0, ROWS, set)?;
        let (squares, falls) = (dot(&forces, &forces), -dot(&forces, &bent));
        lambda = lambda + more / force * (squares / falls);
        for (i, row) in stiffer.iter_mut().enumerate() {
            put(row, i, at(matrix.get(i)?, i) + lambda);
        }
        forces = solved(&stiffer, open, 0, ROWS, set)?;
    }
    Some(forces)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(of: [[f64; 3]; 3]) -> [Few<f64>; ROWS] {
        core::array::from_fn(|i| core::array::from_fn(|j| of.get(i).map_or(0.0, |row| at(row, j))))
    }

    #[test]
    fn what_begins_to_slide_goes_against_what_resists() {
        let matrix = rows([[4.0, 1.0, 0.0], [1.0, 0.5, 0.1], [0.0, 0.1, 20.0]]);
        let open: Few<f64> = core::array::from_fn(|i| [3.0, -7.0, 11.0].get(i).copied().unwrap_or(0.0));
        for force in [0.01, 1.0, 17.0, 29.0] {
            let y = begun(&matrix, &open, 0b111, force).expect("it slides");
            assert!((dot(&y, &y).sqrt() - force).abs() <= 1e-14 * force, "{force}: {y:?}");
            let bends: [f64; 3] = core::array::from_fn(|i| dot(&matrix[i], &y) + open[i]);
            let along: f64 = bends.iter().zip(&y).map(|(a, y)| -a * y / force).sum();
            assert!(along > 0.0);
            for (a, y) in bends.iter().zip(&y) {
                assert!((a + along * y / force).abs() < 1e-12, "{force}: {bends:?} {y:?}");
            }
        }
        // (G)⁻¹ ẇ₀ is 31 N, which holds.
        assert!(begun(&matrix, &open, 0b111, 40.0).is_none());
    }
}
