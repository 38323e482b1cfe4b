//! Positions as numbers that a general solver can integrate, and back.
//!
//! The part of y that holds positions is q with each multi-turn angle as one number, the angle less the whole turns it had at
//! the start. What is stated here is the map N of δ, an increment or a velocity, to the entries, its inverse on unit
//! orientations, and the pull on their lengths.

use core::f64::consts::TAU;
use linkwright::quaternion::product;
use linkwright::rotation::wrap;
use linkwright::{Layout, Vector};

/// The number of entries of y that hold positions.
pub(crate) fn positions(layout: &Layout<'_>) -> usize {
    layout.positions() - layout.angles.len()
}

/// The number of entries of q that are not angles: q and y agree in them.
fn plain(layout: &Layout<'_>) -> usize {
    layout.positions() - 2 * layout.angles.len()
}

/// The orientations: first entry, number of entries, first velocity.
fn orientations(layout: &Layout<'_>) -> impl Iterator<Item = (usize, usize, usize)> + use<> {
    let Layout { linear, rotations, quaternions, .. } = *layout;
    let pairs = (0..rotations).map(move |k| (linear + 2 * k, 2, linear + k));
    let first = linear + 2 * rotations;
    pairs.chain((0..quaternions).map(move |k| (first + 4 * k, 4, linear + rotations + 3 * k)))
}

/// The entries of `q`, with the whole turns of its angles counted from those of `origin`.
pub(crate) fn to_entries<Q: Vector<f64>>(layout: &Layout<'_>, origin: &Q, q: &Q, entries: &mut [f64]) {
    let plain = plain(layout);
    let (q, origin) = (q.as_slice(), origin.as_slice());
    entries[..plain].copy_from_slice(&q[..plain]);
    for (k, entry) in entries[plain..].iter_mut().enumerate().take(layout.angles.len()) {
        let turns = plain + 2 * k;
        *entry = TAU * (q[turns] - origin[turns]) + q[turns + 1];
    }
}

/// q of the entries, its orientations brought to length one.
pub(crate) fn from_entries<Q: Vector<f64>>(layout: &Layout<'_>, origin: &Q, entries: &[f64]) -> Q {
    let mut position = origin.clone();
    let plain = plain(layout);
    let q = position.as_mut_slice();
    q[..plain].copy_from_slice(&entries[..plain]);
    for (first, count, _) in orientations(layout) {
        let scale = 1.0 / squared_length(&q[first..first + count]).sqrt();
        q[first..first + count].iter_mut().for_each(|entry| *entry *= scale);
    }
    for k in 0..layout.angles.len() {
        let turns = plain + 2 * k;
        (q[turns], q[turns + 1]) = wrap(origin.as_slice()[turns], entries[plain + k]);
    }
    position
}

/// N(q) δ: how the entries move with the increments or velocities `delta`.
pub(crate) fn entries_along(layout: &Layout<'_>, entries: &[f64], delta: &[f64], to: &mut [f64]) {
    to[..layout.linear].copy_from_slice(&delta[..layout.linear]);
    let plain = plain(layout);
    to[layout.linear..plain].fill(0.0);
    for (to, angle) in to[plain..].iter_mut().zip(layout.angles) {
        *to = angle.rate.iter().map(|&(index, weight)| weight * delta[index as usize]).sum();
    }
    add_turned(layout, entries, delta, to);
}

/// Adds N(q) δ of the orientations alone; bilinear in both.
pub(crate) fn add_turned(layout: &Layout<'_>, entries: &[f64], delta: &[f64], to: &mut [f64]) {
    for (first, count, velocity) in orientations(layout) {
        let (q, to) = (&entries[first..first + count], &mut to[first..first + count]);
        if let [c, s] = *q {
            // d(c, s) = (−s, c) δ.
            to[0] -= s * delta[velocity];
            to[1] += c * delta[velocity];
        } else {
            // dp = ½ p ⊗ (0, δ).
            let turned = product([0, 1, 2, 3].map(|i| q[i]), with_scalar(&delta[velocity..]));
            to.iter_mut().zip(turned).for_each(|(to, entry)| *to += 0.5 * entry);
        }
    }
}

/// Adds κ/2 (1 − |p|²) p of every orientation: its length tends to one as e^(−κt).
pub(crate) fn add_pull(layout: &Layout<'_>, rate: f64, entries: &[f64], to: &mut [f64]) {
    for (first, count, _) in orientations(layout) {
        let q = &entries[first..first + count];
        let factor = 0.5 * rate * (1.0 - squared_length(q));
        to[first..first + count].iter_mut().zip(q).for_each(|(to, entry)| *to += factor * entry);
    }
}

/// Adds the derivative of [`add_pull`] along `along`: κ/2 \[(1 − |p|²) dp − 2 (p·dp) p\].
pub(crate) fn add_pull_along(layout: &Layout<'_>, rate: f64, entries: &[f64], along: &[f64], to: &mut [f64]) {
    for (first, count, _) in orientations(layout) {
        let (q, dq) = (&entries[first..first + count], &along[first..first + count]);
        let factor = 0.5 * rate * (1.0 - squared_length(q));
        let radial = rate * q.iter().zip(dq).map(|(q, dq)| q * dq).sum::<f64>();
        for ((to, q), dq) in to[first..first + count].iter_mut().zip(q).zip(dq) {
            *to += factor * dq - radial * q;
        }
    }
}

/// δ of the motion `along` of the entries: what is radial in an orientation's motion does not turn it.
pub(crate) fn increment<V: Vector<f64>>(layout: &Layout<'_>, entries: &[f64], along: &[f64]) -> V {
    let mut increment = V::zeros(layout.velocities());
    let delta = increment.as_mut_slice();
    delta[..layout.linear].copy_from_slice(&along[..layout.linear]);
    for (first, count, velocity) in orientations(layout) {
        let (q, dq) = (&entries[first..first + count], &along[first..first + count]);
        let square = squared_length(q);
        if let ([c, s], [dc, ds]) = (q, dq) {
            // dθ = (c ds − s dc)/(c² + s²).
            delta[velocity] = (c * ds - s * dc) / square;
        } else {
            // δ = 2 vec(p* ⊗ dp)/|p|².
            let conjugate = [q[0], -q[1], -q[2], -q[3]];
            let turned = product(conjugate, [0, 1, 2, 3].map(|i| dq[i]));
            delta[velocity..velocity + 3].copy_from_slice(&[1, 2, 3].map(|i| 2.0 * turned[i] / square));
        }
    }
    increment
}

/// The first entry and the length of an orientation whose squared length is further than `tolerance` from one.
pub(crate) fn first_not_unit(layout: &Layout<'_>, q: &[f64], tolerance: f64) -> Option<(usize, f64)> {
    orientations(layout).find_map(|(first, count, _)| {
        let square = squared_length(&q[first..first + count]);
        ((square - 1.0).abs() > tolerance).then(|| (first, square.sqrt()))
    })
}

/// (0, δ) of three entries.
fn with_scalar(delta: &[f64]) -> [f64; 4] {
    [0.0, delta[0], delta[1], delta[2]]
}

fn squared_length(entries: &[f64]) -> f64 {
    entries.iter().map(|entry| entry * entry).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use linkwright::{MultiTurn, retract};

    const ANGLES: &[MultiTurn] = &[MultiTurn { rate: &[(0, 2.0), (1, -0.5)] }];
    const LAYOUT: Layout = Layout { linear: 1, rotations: 1, quaternions: 1, angles: ANGLES };
    const Q: [f64; 9] = [0.3, 0.6, 0.8, 0.5, -0.5, 0.5, 0.5, 4.0, 3.0];
    const DELTA: [f64; 5] = [0.4, -1.1, 0.7, 0.2, -0.9];

    fn entries(q: &[f64; 9]) -> [f64; 8] {
        let mut entries = [0.0; 8];
        to_entries(&LAYOUT, &Q, q, &mut entries);
        entries
    }

    #[test]
    fn entries_give_the_position_back() {
        let mut moved = Q;
        retract(&LAYOUT, &Q, &DELTA.map(|d| 2.0 * d), &mut moved);
        assert!(moved[7] > Q[7], "the angle passes π");
        let mut long = entries(&moved);
        long[1..7].iter_mut().for_each(|entry| *entry *= 1.5);
        let back: [f64; 9] = from_entries(&LAYOUT, &Q, &long);
        for i in 0..9 {
            assert!((back[i] - moved[i]).abs() < 1e-14, "{back:?} {moved:?}");
        }
    }

    /// N δ by differences of the retraction, and δ back from it, also with a part along the orientations.
    #[test]
    fn entries_move_as_the_retraction_does() {
        let h = 1e-6;
        let at = |t: f64| {
            let mut moved = Q;
            retract(&LAYOUT, &Q, &DELTA.map(|d| t * d), &mut moved);
            entries(&moved)
        };
        let (before, after, here) = (at(-h), at(h), entries(&Q));
        let mut along = [0.0; 8];
        entries_along(&LAYOUT, &here, &DELTA, &mut along);
        for i in 0..8 {
            assert!((along[i] - (after[i] - before[i]) / (2.0 * h)).abs() < 1e-8, "{i}");
        }
        (1..7).for_each(|i| along[i] += 0.7 * here[i]);
        let back: [f64; 5] = increment(&LAYOUT, &here, &along);
        for i in 0..5 {
            assert!((back[i] - DELTA[i]).abs() < 1e-14, "{back:?}");
        }
    }

    #[test]
    fn the_pull_and_its_derivative_agree() {
        let (mut here, along) = (entries(&Q), [0.3, 0.1, -0.4, 0.2, 0.6, -0.1, 0.5, 0.7]);
        (1..7).for_each(|i| here[i] *= 1.1);
        let h = 1e-6;
        let at = |t: f64| {
            let mut pull = [0.0; 8];
            let moved: Vec<f64> = here.iter().zip(along).map(|(x, d)| x + t * d).collect();
            add_pull(&LAYOUT, 3.0, &moved, &mut pull);
            pull
        };
        let (before, after) = (at(-h), at(h));
        let mut found = [0.0; 8];
        add_pull_along(&LAYOUT, 3.0, &here, &along, &mut found);
        for i in 0..8 {
            assert!((found[i] - (after[i] - before[i]) / (2.0 * h)).abs() < 1e-8, "{i}");
        }
    }
}
