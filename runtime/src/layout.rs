//! How the entries of a position vector move: the retraction q ⊕ δ.
//!
//! Positions are no vector space: an orientation is a pair (c, s) on the unit circle, so n_q ≠ n_v and an increment
//! of the velocities' kind is carried to the positions by the exponential of the group (`rotation.rs`). Integrators,
//! Newton iterations and projections all move through [`retract`]. What the velocities are, the mechanism says.

use crate::real::Real;
use crate::rotation::{turn, turn_little, turns_far, wrap};
use crate::vector::Vector;

/// Where the kinds of coordinates stand in q and v.
///
/// ```text
/// q = [ linear coordinates | pairs c, s interleaved | multi-turn angles: turns, remainder interleaved ]
/// v = [ linear rates       | rotation rates ω                                                          ]
/// ```
/// so n_q = linear + 2·rotations + 2·angles.len() and n_v = linear + rotations. A multi-turn angle has no velocity
/// of its own: its rate is the difference of two entries of v. Units: m and m/s, 1 and rad/s, rev and rad.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    /// The number of linear coordinates.
    pub linear: usize,
    /// The number of orientations in the plane, each a pair (c, s) = (cos θ, sin θ).
    pub rotations: usize,
    /// The angles that are counted over several turns.
    pub angles: &'static [MultiTurn],
}

/// An angle over several turns, kept as whole turns and a remainder in [−π, π), rad.
///
/// Its value is 2π·turns + remainder; its rate v\[plus\] − v\[minus\], an absent index counting as zero. One growing
/// float would lose 7e-6 rad in a million steps; the remainder receives the very increments that turn the pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MultiTurn {
    /// Index into v of the rate that is added.
    pub plus: Option<u32>,
    /// Index into v of the rate that is subtracted.
    pub minus: Option<u32>,
}

impl Layout {
    /// The number of entries of q.
    pub const fn positions(&self) -> usize {
        self.linear + 2 * self.rotations + 2 * self.angles.len()
    }

    /// The number of entries of v.
    pub const fn velocities(&self) -> usize {
        self.linear + self.rotations
    }
}

/// q ⊕ δ: moves every coordinate of `q0` by the increment `dv` (shape n_v, units of v times s) into `q_out`.
///
/// - linear: q + δ;
/// - pair: (c, s) · (cos δ, sin δ), then the first-order renormalisation of [`turn`];
/// - multi-turn angle: remainder + δ_plus − δ_minus, whole turns moved out.
///
/// SO(2) is commutative, so one exponential of a sum of stage increments is exact: a Runge–Kutta–Munthe-Kaas method
/// needs no correction terms in the plane (Hairer, Lubich, Wanner, *Geometric Numerical Integration*, IV.8).
#[inline]
pub fn retract<R: Real, Q: Vector<R>, V: Vector<R>>(layout: &Layout, q0: &Q, dv: &V, q_out: &mut Q) {
    let Layout { linear, rotations, angles } = *layout;
    let (from_linear, from_rest) = q0.as_slice().split_at(linear);
    let (to_linear, to_rest) = q_out.as_mut_slice().split_at_mut(linear);
    let (d_linear, d_rotations) = dv.as_slice().split_at(linear);
    for ((to, &from), &delta) in to_linear.iter_mut().zip(from_linear).zip(d_linear) {
        *to = from + delta;
    }

    let (from_pairs, from_angles) = from_rest.split_at(2 * rotations);
    let (to_pairs, to_angles) = to_rest.split_at_mut(2 * rotations);
    let pairs = to_pairs.chunks_exact_mut(2).zip(from_pairs.chunks_exact(2)).zip(d_rotations);
    // Asked once for all, so that the usual case is a loop without branches.
    if d_rotations.iter().fold(false, |far, &delta| far | turns_far(delta)) {
        for ((to, from), &delta) in pairs {
            (to[0], to[1]) = turn(from[0], from[1], delta);
        }
    } else {
        for ((to, from), &delta) in pairs {
            (to[0], to[1]) = turn_little(from[0], from[1], delta);
        }
    }

    let increment = |index: Option<u32>| match index {
        Some(index) => dv.as_slice()[index as usize],
        None => R::ZERO,
    };
    for ((to, from), angle) in to_angles.chunks_exact_mut(2).zip(from_angles.chunks_exact(2)).zip(angles) {
        let remainder = from[1] + (increment(angle.plus) - increment(angle.minus));
        (to[0], to[1]) = wrap(from[0], remainder);
    }
}
