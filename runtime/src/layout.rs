//! How the entries of a position vector move: the retraction q ⊕ δ and the inverse of its differential.
//!
//! Positions are no vector space: an orientation is a pair (c, s) on the unit circle or a unit quaternion, so n_q ≠ n_v
//! and an increment of the velocities' kind is carried to the positions by the exponential of the group (`rotation.rs`,
//! `quaternion.rs`). Integrators, Newton iterations and projections all move through [`retract`]. The mechanism says
//! what the velocities are.

use crate::quaternion;
use crate::real::Real;
use crate::rotation::{turn, turn_far, turn_little, turn_once, wrap};
use crate::vector::{Vector, at};

/// Where the kinds of coordinates stand in q and v.
///
/// ```text
/// q = [ linear | pairs c, s    | quaternions w, x, y, z | multi-turn angles: turns, remainder ]
/// v = [ rates  | rotation rates | ω: three each         ]
/// ```
/// each kind with the entries of one coordinate side by side, so n_q = linear + 2·rotations + 4·quaternions +
/// 2·angles.len() and n_v = linear + rotations + 3·quaternions. A quaternion's ω is in the turned axes:
/// q̇ = ½ q ⊗ (0, ω). A multi-turn angle has no velocity of its own: its rate is a linear form of v. Units: m and m/s,
/// 1 and rad/s, rev and rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layout<'a> {
    /// The number of linear coordinates.
    pub linear: usize,
    /// The number of orientations in the plane or about one axis, each a pair (c, s) = (cos θ, sin θ).
    pub rotations: usize,
    /// The number of orientations in space, each a unit quaternion (w, x, y, z).
    pub quaternions: usize,
    /// The angles that are counted over several turns.
    pub angles: &'a [MultiTurn<'a>],
}

/// An angle over several turns, kept as whole turns and a remainder in [−π, π), rad.
///
/// Its value is 2π·turns + remainder; its rate Σ weight·v\[index\]. One growing float would lose 7e-6 rad in a million
/// steps; the remainder receives the very increments that turn the pair.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MultiTurn<'a> {
    /// (index into v, weight) of each velocity in the rate.
    pub rate: &'a [(u32, f64)],
}

impl Layout<'_> {
    /// The number of entries of q.
    pub const fn positions(&self) -> usize {
        self.linear + 2 * self.rotations + 4 * self.quaternions + 2 * self.angles.len()
    }

    /// The number of entries of v.
    pub const fn velocities(&self) -> usize {
        self.linear + self.rotations + 3 * self.quaternions
    }

    /// The orientations, as the first index into q and the number of entries of each: what must have length 1.
    pub(crate) fn orientations(&self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let Layout { linear, rotations, quaternions, .. } = *self;
        let pairs = (0..rotations).map(move |k| (linear + 2 * k, 2));
        pairs.chain((0..quaternions).map(move |k| (linear + 2 * rotations + 4 * k, 4)))
    }
}

/// q ⊕ δ: moves every coordinate of `q0` by the increment `dv` (shape n_v, units of v times s) into `q_out`.
///
/// - linear: q + δ;
/// - pair: (c, s) · (cos δ, sin δ), then the first-order renormalisation of [`turn`];
/// - quaternion: q ⊗ exp(δ), δ in the turned axes, renormalised in the same way;
/// - multi-turn angle: remainder + Σ weight·δ\[index\], whole turns moved out.
///
/// Along a constant velocity this is the exact motion. Where velocities vary, the increment of a quaternion is not the
/// integral of ω: see [`inverse_differential`].
#[inline]
pub fn retract<R: Real, Q: Vector<R>, V: Vector<R>>(layout: &Layout<'_>, q0: &Q, dv: &V, q_out: &mut Q) {
    retract_counting(layout, q0, dv, dv, q_out);
}

/// As [`retract`], with the multi-turn angles moved by Σ weight·`integral`\[index\].
///
/// `integral` is ∫ v dt over the step, `dv` the increment on the group that brings the positions to the step's end; they
/// differ in the entries of quaternions whose axis of rotation moves. A counted angle is not on that group: its rate is
/// linear in v, so it takes the integral.
#[inline(always)]
pub fn retract_counting<R: Real, Q: Vector<R>, V: Vector<R>>(
    layout: &Layout<'_>,
    q0: &Q,
    dv: &V,
    integral: &V,
    q_out: &mut Q,
) {
    retraction::<R, Q, V, true>(layout, q0, dv, integral, q_out);
}

/// As [`retract_counting`], to a position from which nothing moves on: orientations keep their lengths but for rounding, and are not
/// normalised.
#[inline(always)]
pub(crate) fn retract_once<R: Real, Q: Vector<R>, V: Vector<R>>(
    layout: &Layout<'_>,
    q0: &Q,
    dv: &V,
    integral: &V,
    q_out: &mut Q,
) {
    retraction::<R, Q, V, false>(layout, q0, dv, integral, q_out);
}

/// So many orientations, a quaternion counted as two, are turned where the step stands. The text of more, once for each stage, would
/// take the place in the processor's cache of instructions that the equations need: a call and loops take their place.
const FEW: usize = 12;

#[inline(always)]
fn retraction<R: Real, Q: Vector<R>, V: Vector<R>, const NORMALISED: bool>(
    layout: &Layout<'_>,
    q0: &Q,
    dv: &V,
    integral: &V,
    q_out: &mut Q,
) {
    if layout.rotations + 2 * layout.quaternions > FEW {
        retraction_of_many::<R, Q, V, NORMALISED>(layout, q0, dv, integral, q_out);
    } else {
        retraction_here::<R, Q, V, NORMALISED>(layout, q0, dv, integral, q_out);
    }
}

#[inline(never)]
fn retraction_of_many<R: Real, Q: Vector<R>, V: Vector<R>, const NORMALISED: bool>(
    layout: &Layout<'_>,
    q0: &Q,
    dv: &V,
    integral: &V,
    q_out: &mut Q,
) {
    retraction_here::<R, Q, V, NORMALISED>(layout, q0, dv, integral, q_out);
}

#[inline(always)]
fn retraction_here<R: Real, Q: Vector<R>, V: Vector<R>, const NORMALISED: bool>(
    layout: &Layout<'_>,
    q0: &Q,
    dv: &V,
    integral: &V,
    q_out: &mut Q,
) {
    let Layout { linear, rotations, quaternions, angles } = *layout;
    let (from_linear, from_rest) = cut(q0.as_slice(), linear);
    let (to_linear, to_rest) = cut_mut(q_out.as_mut_slice(), linear);
    let (d_linear, d_rest) = cut(dv.as_slice(), linear);
    for ((to, &from), &delta) in to_linear.iter_mut().zip(from_linear).zip(d_linear) {
        *to = from + delta;
    }

    let (from_pairs, from_rest) = cut(from_rest, 2 * rotations);
    let (to_pairs, to_rest) = cut_mut(to_rest, 2 * rotations);
    let (d_rotations, d_rest) = cut(d_rest, rotations);
    let from_pairs = from_pairs.as_chunks::<2>().0.iter();
    let pairs = to_pairs.as_chunks_mut::<2>().0.iter_mut().zip(from_pairs).zip(d_rotations);
    // Asked once for all, so that the usual case is a loop without branches.
    let far = turn_far(d_rotations);
    if R::any(far) {
        for ((to, &[c, s]), &delta) in pairs {
            let mut turned = turn_pair(c, s, delta);
            if !NORMALISED && R::LANES > 1 {
                let (c, s) = turn_once(c, s, delta);
                turned = (R::select(far, turned.0, c), R::select(far, turned.1, s));
            }
            *to = turned.into();
        }
    } else {
        for ((to, &[c, s]), &delta) in pairs {
            let turned = if NORMALISED { turn_little } else { turn_once };
            *to = turned(c, s, delta).into();
        }
    }

    let (from_quaternions, from_angles) = cut(from_rest, 4 * quaternions);
    let (to_quaternions, to_angles) = cut_mut(to_rest, 4 * quaternions);
    let (d_quaternions, _) = d_rest.as_chunks::<3>();
    let from_quaternions = from_quaternions.as_chunks::<4>().0.iter();
    let turned = to_quaternions.as_chunks_mut::<4>().0.iter_mut().zip(from_quaternions).zip(d_quaternions);
    let far = d_quaternions
        .iter()
        .map(|&delta| quaternion::is_far(delta))
        .reduce(|far, other| far | other)
        .filter(|&far| R::any(far));
    if let Some(far) = far {
        for ((to, &from), &delta) in turned {
            *to = turn_quaternion(from, delta);
            if !NORMALISED && R::LANES > 1 {
                let once = quaternion::turn_once(from, delta);
                to.iter_mut().zip(once).for_each(|(to, once)| *to = R::select(far, *to, once));
            }
        }
    } else {
        for ((to, &from), &delta) in turned {
            let turned = if NORMALISED { quaternion::turn_little } else { quaternion::turn_once };
            *to = turned(from, delta);
        }
    }

    let from_angles = from_angles.as_chunks::<2>().0.iter();
    let counted = to_angles.as_chunks_mut::<2>().0.iter_mut().zip(from_angles).zip(angles);
    for ((to, &[turns, remainder]), angle) in counted {
        let increment = angle.rate.iter().fold(R::ZERO, |sum, &(index, weight)| {
            sum + R::from_f64(weight) * at(integral.as_slice(), index as usize)
        });
        *to = wrap(turns, remainder + increment).into();
    }
}

/// The entries before a place and behind it; an end that does not come, because lengths are those of the layout, takes no panic.
#[inline(always)]
fn cut<R>(entries: &[R], place: usize) -> (&[R], &[R]) {
    entries.split_at_checked(place).unwrap_or((entries, &[]))
}

#[inline(always)]
fn cut_mut<R>(entries: &mut [R], place: usize) -> (&mut [R], &mut [R]) {
    let place = place.min(entries.len());
    entries.split_at_mut(place)
}

/// A pair by an increment of any size. By values, so that positions need not stand in memory for what is rare.
#[cold]
#[inline(never)]
fn turn_pair<R: Real>(c: R, s: R, delta: R) -> (R, R) {
    turn(c, s, delta)
}

/// A quaternion by an increment of any size.
#[cold]
#[inline(never)]
fn turn_quaternion<R: Real>(q: [R; 4], delta: [R; 3]) -> [R; 4] {
    quaternion::turn(q, delta)
}

/// u̇ of positions q(t) = q₀ ⊕ u(t) that move with the velocities `v`: the inverse of the differential of ⊕ at `u`.
///
/// Linear coordinates and rotations of the plane commute: u̇ = v. For a quaternion q₀ ⊗ exp(u) with ω in the turned
/// axes, ω = dexp₋ᵤ u̇, so
///
/// ```text
/// u̇ = dexp₋ᵤ⁻¹ ω = Σ B_k/k! (−u×)ᵏ ω = ω + ½ u × ω + ¹⁄₁₂ u × (u × ω) + O(|u|⁴ |ω|)
/// ```
/// (B_k: Bernoulli's numbers, B₃ = 0; the series with −½ belongs to velocities in world axes). Written as far as
/// methods up to order 5 need it with u = O(h): Munthe-Kaas, *High order Runge–Kutta methods on manifolds*, 1999; Iserles,
/// Munthe-Kaas, Nørsett, Zanna, *Lie-group methods*, Acta Numerica 9 (2000), 3.2; Hairer, Lubich, Wanner, *Geometric
/// Numerical Integration*, IV.7–8.
#[inline]
pub fn inverse_differential<R: Real, V: Vector<R>>(layout: &Layout<'_>, u: &V, v: &V) -> V {
    let mut rate = v.clone();
    if layout.quaternions == 0 {
        return rate;
    }
    let first = layout.linear + layout.rotations;
    let (half, twelfth) = (R::from_f64(0.5), R::from_f64(1.0 / 12.0));
    let (turned, _) = cut(u.as_slice(), first).1.as_chunks::<3>();
    for (omega, &u) in cut_mut(rate.as_mut_slice(), first).1.as_chunks_mut::<3>().0.iter_mut().zip(turned) {
        let once = cross(u, *omega);
        let twice = cross(u, once);
        for (entry, (once, twice)) in omega.iter_mut().zip(once.into_iter().zip(twice)) {
            *entry = *entry + (half * once + twelfth * twice);
        }
    }
    rate
}

/// dexp₋ᵤ of a quaternion turned by u, row by row: an increment δu of u turns it by dexp₋ᵤ δu in its own axes.
///
/// dexp₋ᵤ = Σ (−û)ᵏ/(k+1)! = 1 − û/2 + û²/6 − û³/24 + û⁴/120 − …, here to û⁴: it is the matrix of a Newton iteration.
pub(crate) fn differential<R: Real>(u: [R; 3]) -> [[R; 3]; 3] {
    let mut columns = [[R::ZERO; 3]; 3];
    for (k, column) in columns.iter_mut().enumerate() {
        let mut unit = [R::ZERO; 3];
        unit[k] = R::ONE;
        // Horner's scheme: x − u×/2 (x − u×/3 (x − u×/4 (x − u×/5 x))).
        let mut value = unit;
        for divisor in [5.0, 4.0, 3.0, 2.0] {
            let turned = cross(u, value);
            let scale = R::from_f64(-1.0 / divisor);
            value = [0, 1, 2].map(|i| unit[i] + scale * turned[i]);
        }
        *column = value;
    }
    [0, 1, 2].map(|row| [0, 1, 2].map(|column| columns[column][row]))
}

/// a × b.
#[inline(always)]
pub(crate) fn cross<R: Real>(a: [R; 3], b: [R; 3]) -> [R; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The first orientation whose squared length is further than `tolerance` from one: its first index into q and its
/// length. Other checks find entries that are not finite.
pub(crate) fn first_not_unit<R: Real, Q: Vector<R>>(
    layout: &Layout<'_>,
    q: &Q,
    tolerance: R,
) -> Option<(usize, R)> {
    layout.orientations().find_map(|(first, count)| {
        let square = length_squared(q.as_slice().get(first..first + count).unwrap_or_default());
        ((square - R::ONE).abs() > tolerance).then(|| (first, square.sqrt()))
    })
}

/// `q` with every orientation brought to length 1; those that have it to rounding are left as they are, to the bit.
///
/// # Errors
/// The first index and the length of an orientation so near zero or so large that it has no direction.
pub(crate) fn normalised<R: Real, Q: Vector<R>>(layout: &Layout<'_>, q: &Q) -> Result<Q, (usize, R)> {
    let mut q = q.clone();
    for (first, count) in layout.orientations() {
        let entries = q.as_mut_slice().get_mut(first..first + count).unwrap_or_default();
        let square = length_squared(entries);
        if (square - R::ONE).abs() <= R::from_f64(64.0) * R::EPSILON {
            continue;
        }
        let scale = R::ONE / square.sqrt();
        if square.is_finite() && !(scale.is_finite() && scale > R::ZERO) {
            return Err((first, square.sqrt()));
        }
        for entry in entries {
            *entry = *entry * scale;
        }
    }
    Ok(q)
}

fn length_squared<R: Real>(entries: &[R]) -> R {
    entries.iter().fold(R::ZERO, |sum, &entry| sum + entry * entry)
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAYOUT: Layout<'static> = Layout { linear: 1, rotations: 1, quaternions: 1, angles: &[] };

    /// u̇ by differences: exp(u(t+h)) = exp(u(t)) exp(∫ω), to which the velocity in the turned axes belongs.
    #[test]
    fn the_inverse_differential_belongs_to_velocities_in_the_turned_axes() {
        let (u, du) = ([0.02, -0.01, 0.03], [0.7, 1.1, -0.4]);
        let h = 1e-4;
        let at = |t: f64| quaternion::exponential([u[0] + t * du[0], u[1] + t * du[1], u[2] + t * du[2]]);
        let [w, x, y, z] = at(-h);
        let [_, x, y, z] = quaternion::product([w, -x, -y, -z], at(h));
        // The vector part of a small rotation's quaternion is half its angle; 2h passed.
        let omega = [x / h, y / h, z / h];
        let v = [0.3, -2.0, omega[0], omega[1], omega[2]];
        let found = inverse_differential(&LAYOUT, &[9.0, 9.0, u[0], u[1], u[2]], &v);
        assert_eq!(found[..2], v[..2]);
        for i in 0..3 {
            // |u|⁴|ω|/720 and h².
            assert!((found[2 + i] - du[i]).abs() < 3e-8, "{found:?}");
            assert!((v[2 + i] - du[i]).abs() > 1e-4, "the correction is not small");
        }
    }

    #[test]
    fn the_differential_is_the_inverse_of_its_inverse() {
        let (u, du) = ([0.02, -0.01, 0.03], [0.7, 1.1, -0.4]);
        let turned = differential(u).map(|row| row[0] * du[0] + row[1] * du[1] + row[2] * du[2]);
        let back = inverse_differential(
            &LAYOUT,
            &[9.0, 9.0, u[0], u[1], u[2]],
            &[0.0, 0.0, turned[0], turned[1], turned[2]],
        );
        for i in 0..3 {
            // |u|⁴|δ|/720.
            assert!((back[2 + i] - du[i]).abs() < 1e-8, "{back:?}");
            assert!((turned[i] - du[i]).abs() > 1e-3, "{turned:?}");
        }
    }

    #[test]
    fn orientations_are_normalised_where_they_are_not() {
        let q = [5.0, 0.6, -0.8, 0.0, 2.0, 0.0, 0.0];
        assert_eq!(first_not_unit(&LAYOUT, &q, 1e-6), Some((3, 2.0)));
        let unit = normalised(&LAYOUT, &q).unwrap();
        assert_eq!(unit, [5.0, 0.6, -0.8, 0.0, 1.0, 0.0, 0.0]);
        assert_eq!(first_not_unit(&LAYOUT, &unit, 1e-6), None);
        let long = [0.0, 3.0, 4.0, 1.0, 0.0, 0.0, 0.0];
        assert_eq!(first_not_unit(&LAYOUT, &long, 1e-6), Some((1, 5.0)));
        assert!((normalised(&LAYOUT, &long).unwrap()[1] - 0.6).abs() < 1e-15);
        assert_eq!(normalised(&LAYOUT, &[0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0]), Err((3, 0.0)));
    }

    #[test]
    fn counted_angles_take_the_integral() {
        const ANGLES: &[MultiTurn] = &[MultiTurn { rate: &[(0, 2.0), (3, -0.5)] }];
        let layout = Layout { linear: 1, rotations: 0, quaternions: 1, angles: ANGLES };
        assert_eq!((layout.positions(), layout.velocities()), (7, 4));
        let q = [0.0, 1.0, 0.0, 0.0, 0.0, 4.0, 3.0];
        let mut moved = q;
        retract_counting(&layout, &q, &[0.1, 0.0, 0.0, 0.0], &[0.25, 0.0, 0.0, 0.2], &mut moved);
        assert_eq!(moved[..5], [0.1, 1.0, 0.0, 0.0, 0.0]);
        assert!(moved[5] == 5.0 && (moved[6] - (3.4 - core::f64::consts::TAU)).abs() < 1e-15, "{moved:?}");
    }
}
