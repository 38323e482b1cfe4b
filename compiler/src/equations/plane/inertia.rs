//! Mass matrix and inertia forces, pair of velocities by pair of velocities.
//!
//! Body i has its centre at Σ_f A_f d_{i,f}. The column of a velocity k is A_{f(k)} u_{i,k} with u fixed in one frame:
//! u = d turned by a right angle for the rate of the frame, u = e for a slide along e. Hence
//!   M_kl = Σ_i m_i (A_k u_k)·(A_l u_l) = c Σ_i m_i u_k·u_l − s Σ_i m_i u_k×u_l,   (c, s) of θ_l − θ_k,
//! where both sums are constants unless something slides; so is every sum in the inertia forces
//!   −Σ_i m_i (A_k u_k)·a_i,   a_i = Σ_f A_f (−ω_f² d_f + 2 ω_f × ḋ_f + ∂²d_f/∂t²) − g.
//! Gravity is an acceleration of the ground's frame (Featherstone, Rigid Body Dynamics Algorithms, section 5.3).
//! Bodies behind one joint have the same vectors in all frames before it, so that sums go over the stretches of the ways to the
//! centres, each with the mass of all that is behind it: the composite-rigid-body regrouping of inertial parameters.

use super::kinematics::{FrameId, GROUND, Kinematics, LocalVector, Position};
use super::vector::{self, Pair};
use crate::symbolic::{On, Scalar};
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

/// A body for this purpose.
pub struct Massive<'g> {
    pub mass: Scalar<'g>,
    /// About the centre; `None` for a particle.
    pub inertia: Option<Scalar<'g>>,
    pub center: Position,
    pub frame: FrameId,
}

/// M (lower triangle, structural non-zeros) and the inertia and gravity forces on the right-hand side.
pub struct Inertia<'g> {
    pub mass: BTreeMap<(usize, usize), Scalar<'g>>,
    pub forces: Vec<Scalar<'g>>,
}

/// What multiplies a local acceleration vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Factor {
    /// ω² of the frame.
    Centripetal,
    /// 2 ω v of the frame and a slide.
    Coriolis(usize),
    /// 2 ω of the frame (its vector changes with time).
    Drift,
    /// 1.
    Explicit,
}

/// Σ m u·w and Σ m u×w.
#[derive(Clone, Copy)]
struct Products<'g> {
    dot: Scalar<'g>,
    cross: Scalar<'g>,
}

/// A sum of products m u·w and m u×w.
struct Sum<'g> {
    frames: (FrameId, FrameId),
    products: Products<'g>,
}

/// A stretch of the ways from the ground to the centres, in one frame: what all bodies behind it have in common.
struct Stretch<'g> {
    /// The one before it, of a smaller index, and those behind it.
    before: Option<usize>,
    behind: Vec<usize>,
    /// In its frame; of the first, the vectors of all frames that do not turn.
    vectors: Vec<(FrameId, LocalVector)>,
    /// Of all bodies behind it.
    mass: Scalar<'g>,
    columns: Vec<Column>,
    accelerations: Vec<(FrameId, Factor, Pair)>,
}

pub struct Column {
    pub velocity: usize,
    pub frame: FrameId,
    pub u: Pair,
}

/// The sums behind M and the inertia forces, to which masses that are spread add.
#[derive(Default)]
pub struct Sums<'g> {
    masses: BTreeMap<(usize, usize), Sum<'g>>,
    biases: BTreeMap<(usize, FrameId, Factor), Sum<'g>>,
}

impl<'g> Sums<'g> {
    /// u·w and u×w, u with the mass, of two velocities.
    pub fn mass(&mut self, k: usize, l: usize, frames: (FrameId, FrameId), u: On<'g, Pair>, w: Pair) {
        let products = Products { dot: u.dot(w), cross: u.cross(w) };
        // The sine belongs to the way from the row's frame to the column's.
        let (frames, products) = if k >= l { (frames, products) } else { swapped(frames, products) };
        add(self.masses.entry((k.max(l), k.min(l))), frames, products);
    }

    /// Within one frame.
    pub fn mass_of(&mut self, k: usize, l: usize, frame: FrameId, dot: Scalar<'g>) {
        let products = Products { dot, cross: dot.g.zero() };
        add(self.masses.entry((k.max(l), k.min(l))), (frame, frame), products);
    }

    /// u, with the mass, against an acceleration w of the second frame.
    pub fn bias(&mut self, k: usize, frames: (FrameId, FrameId), factor: Factor, u: On<'g, Pair>, w: Pair) {
        let products = Products { dot: u.dot(w), cross: u.cross(w) };
        add(self.biases.entry((k, frames.1, factor)), frames, products);
    }

    /// Within one frame.
    pub fn bias_of(&mut self, k: usize, frame: FrameId, factor: Factor, dot: Scalar<'g>) {
        let products = Products { dot, cross: dot.g.zero() };
        add(self.biases.entry((k, frame, factor)), (frame, frame), products);
    }
}

/// u×w = −w×u.
fn swapped<'g>((k, l): (FrameId, FrameId), products: Products<'g>) -> ((FrameId, FrameId), Products<'g>) {
    ((l, k), Products { cross: -products.cross, ..products })
}

/// `gravity` in world axes.
pub fn inertia<'g>(
    kinematics: On<'g, &'g Kinematics>,
    bodies: &[Massive<'g>],
    gravity: Option<On<'g, Pair>>,
) -> Inertia<'g> {
    let zero = kinematics.g.zero();
    let mut sums = Sums::default();
    let Sums { masses, biases } = &mut sums;
    let mut rotary: BTreeMap<usize, Scalar> = BTreeMap::new();
    for body in bodies {
        if let (Some(inertia), Some(rate)) = (body.inertia, kinematics.bare.frames[body.frame].rate) {
            *rotary.entry(rate).or_insert(zero) += inertia;
        }
    }
    let stretches = stretches(kinematics, bodies, gravity);
    for own in &stretches {
        let mut other = Some(own);
        while let Some(far) = other {
            let is_own = std::ptr::eq(own, far);
            for (at, k) in own.columns.iter().enumerate() {
                for l in &far.columns[..if is_own { at + 1 } else { far.columns.len() }] {
                    let (k, l) = if k.velocity >= l.velocity { (k, l) } else { (l, k) };
                    let entry = masses.entry((k.velocity, l.velocity));
                    accumulate(entry, (k.frame, l.frame), own.mass, k.u, l.u);
                }
            }
            let mut against = |columns: &[Column], accelerations: &[(FrameId, Factor, Pair)]| {
                for k in columns {
                    for (frame, factor, w) in accelerations {
                        let entry = biases.entry((k.velocity, *frame, *factor));
                        accumulate(entry, (k.frame, *frame), own.mass, k.u, *w);
                    }
                }
            };
            against(&own.columns, &far.accelerations);
            if !is_own {
                against(&far.columns, &own.accelerations);
            }
            other = far.before.map(|before| &stretches[before]);
        }
    }

    super::flexible::accumulate(kinematics, bodies, gravity, &mut sums);
    let Sums { masses, biases } = sums;
    let mut mass = BTreeMap::new();
    for ((k, l), Sum { frames, products, .. }) in masses {
        let entry = turned(kinematics, frames, products);
        if !entry.is_zero() {
            mass.insert((k, l), entry);
        }
    }
    for (rate, inertia) in rotary {
        let sum = inertia + mass.get(&(rate, rate)).copied().unwrap_or(zero);
        if !sum.is_zero() {
            mass.insert((rate, rate), sum);
        }
    }

    let mut forces = vec![zero; kinematics.bare.velocities.len()];
    for ((k, frame, factor), Sum { frames, products, .. }) in biases {
        let coefficient = turned(kinematics, frames, products);
        forces[k] -= coefficient * factor_value(kinematics, frame, factor);
    }
    Inertia { mass, forces }
}

/// The stretches of all ways, each before those behind it.
fn stretches<'g>(
    kinematics: On<'g, &'g Kinematics>,
    bodies: &[Massive<'g>],
    gravity: Option<On<'g, Pair>>,
) -> Vec<Stretch<'g>> {
    let g = kinematics.g;
    let turns = |frame: FrameId| kinematics.bare.frames[frame].rate.is_some();
    let mut stretches: Vec<Stretch> = Vec::new();
    let mut first: Vec<usize> = Vec::new();
    for body in bodies {
        let parts = || body.center.parts.iter().map(|(frame, vector)| (*frame, vector.clone()));
        let still: Vec<(FrameId, LocalVector)> = parts().filter(|(frame, _)| !turns(*frame)).collect();
        let turning = parts().filter(|(frame, _)| turns(*frame)).map(|part| vec![part]);
        let mut before = None;
        for vectors in std::iter::once(still).chain(turning) {
            let siblings = before.map_or(&first, |before: usize| &stretches[before].behind);
            let known = siblings.iter().copied().find(|own| stretches[*own].vectors == vectors);
            let index = known.unwrap_or_else(|| {
                let columns = columns(kinematics, &vectors);
                let gravity = gravity.filter(|_| before.is_none());
                let accelerations = accelerations(kinematics, &vectors, gravity);
                let (mass, behind) = (g.zero(), Vec::new());
                stretches.push(Stretch { before, behind, vectors, mass, columns, accelerations });
                let index = stretches.len() - 1;
                before.map_or(&mut first, |before| &mut stretches[before].behind).push(index);
                index
            });
            stretches[index].mass += body.mass;
            before = Some(index);
        }
    }
    stretches
}

/// The columns of a vector's velocity, ascending in the index of the velocity.
pub(super) fn columns<'g>(
    kinematics: On<'g, &'g Kinematics>,
    vectors: &[(FrameId, LocalVector)],
) -> Vec<Column> {
    let mut columns = Vec::new();
    for (frame, vector) in vectors {
        for (velocity, direction) in &vector.slides {
            columns.push(Column { velocity: *velocity, frame: *frame, u: *direction });
        }
        let at = kinematics.g.on(vector.at);
        if let Some(rate) = kinematics.bare.frames[*frame].rate
            && !at.is_zero()
        {
            columns.push(Column { velocity: rate, frame: *frame, u: at.perpendicular().bare });
        }
    }
    columns.sort_by_key(|column| column.velocity);
    columns
}

/// The terms of a vector's acceleration at v̇ = 0, less gravity.
pub(super) fn accelerations<'g>(
    kinematics: On<'g, &'g Kinematics>,
    vectors: &[(FrameId, LocalVector)],
    gravity: Option<On<'g, Pair>>,
) -> Vec<(FrameId, Factor, Pair)> {
    let g = kinematics.g;
    let mut terms = Vec::new();
    let mut explicit = gravity.map(|gravity| -gravity);
    for (frame, vector) in vectors {
        if kinematics.bare.frames[*frame].rate.is_some() {
            terms.push((*frame, Factor::Centripetal, -g.on(vector.at)));
            for (velocity, e) in &vector.slides {
                terms.push((*frame, Factor::Coriolis(*velocity), g.on(*e).perpendicular()));
            }
            terms.push((*frame, Factor::Drift, g.on(vector.drift).perpendicular()));
            terms.push((*frame, Factor::Explicit, g.on(vector.drift_rate)));
        } else {
            explicit = Some(explicit.unwrap_or(vector::zero(g)) + vector.drift_rate);
        }
    }
    terms.extend(explicit.map(|sum| (GROUND, Factor::Explicit, sum)));
    terms.retain(|(_, _, w)| !w.is_zero());
    terms.into_iter().map(|(frame, factor, w)| (frame, factor, w.bare)).collect()
}

fn factor_value<'g>(kinematics: On<'g, &'g Kinematics>, frame: FrameId, factor: Factor) -> Scalar<'g> {
    let g = kinematics.g;
    let Kinematics { frames, velocities, .. } = kinematics.bare;
    let omega = frames[frame].rate.map_or_else(|| g.one(), |rate| g.on(velocities[rate]));
    match factor {
        Factor::Centripetal => omega.square(),
        Factor::Coriolis(slide) => 2.0 * (omega * velocities[slide]),
        Factor::Drift => 2.0 * omega,
        Factor::Explicit => g.one(),
    }
}

fn weighted<'g>(mass: Scalar<'g>, u: Pair, w: Pair) -> Products<'g> {
    let u = mass.g.on(u);
    Products { dot: mass * u.dot(w), cross: mass * u.cross(w) }
}

/// Adds m u·w and m u×w.
fn accumulate<'g, K: Ord>(
    entry: Entry<K, Sum<'g>>,
    frames: (FrameId, FrameId),
    mass: Scalar<'g>,
    u: Pair,
    w: Pair,
) {
    add(entry, frames, weighted(mass, u, w));
}

/// Adds to a sum.
fn add<'g, K: Ord>(entry: Entry<K, Sum<'g>>, frames: (FrameId, FrameId), products: Products<'g>) {
    match entry {
        Entry::Vacant(vacant) => {
            vacant.insert(Sum { frames, products });
        }
        Entry::Occupied(mut occupied) => {
            let sum = occupied.get_mut();
            sum.products.dot += products.dot;
            sum.products.cross += products.cross;
        }
    }
}

/// c Σ m u·w − s Σ m u×w with (c, s) of θ_l − θ_k.
fn turned<'g>(
    kinematics: On<'g, &'g Kinematics>,
    (k, l): (FrameId, FrameId),
    products: Products<'g>,
) -> Scalar<'g> {
    let [cos, sin] = kinematics.relative(k, l).parts();
    cos * products.dot - sin * products.cross
}
