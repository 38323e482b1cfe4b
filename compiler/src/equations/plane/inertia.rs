//! Mass matrix and inertia forces, pair of velocities by pair of velocities.
//!
//! Body i has its centre at Σ_f A_f d_{i,f}. The column of a velocity k is A_{f(k)} u_{i,k} with u fixed in one frame:
//! u = d turned by a right angle for the rate of the frame, u = e for a slide along e. Hence
//!   M_kl = Σ_i m_i (A_k u_k)·(A_l u_l) = c Σ_i m_i u_k·u_l − s Σ_i m_i u_k×u_l,   (c, s) of θ_l − θ_k,
//! where both sums are constants unless something slides; so is every sum in the inertia forces
//!   −Σ_i m_i (A_k u_k)·a_i,   a_i = Σ_f A_f (−ω_f² d_f + 2 ω_f × ḋ_f + ∂²d_f/∂t²) − g.
//! Gravity is an acceleration of the ground's frame (Featherstone, Rigid Body Dynamics Algorithms, section 5.3).
//! This is the composite-rigid-body regrouping of inertial parameters, done by the graph's constant folding.

use super::kinematics::{FrameId, GROUND, Kinematics, Position};
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
enum Factor {
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

/// A sum over bodies of products m u·w and m u×w, and the last of these: bodies behind one joint have the same vectors in all frames
/// before it, and their products, if their masses are equal, too.
struct Sum<'g> {
    frames: (FrameId, FrameId),
    products: Products<'g>,
    last: (Scalar<'g>, Pair, Pair, Products<'g>),
}

struct Column {
    velocity: usize,
    frame: FrameId,
    u: Pair,
}

/// `gravity` in world axes.
pub fn inertia<'g>(
    kinematics: On<'g, &'g Kinematics>,
    bodies: &[Massive<'g>],
    gravity: Option<On<'g, Pair>>,
) -> Inertia<'g> {
    let zero = kinematics.g.zero();
    let mut masses: BTreeMap<(usize, usize), Sum> = BTreeMap::new();
    let mut biases: BTreeMap<(usize, FrameId, Factor), Sum> = BTreeMap::new();
    let mut rotary: BTreeMap<usize, Scalar> = BTreeMap::new();
    for body in bodies {
        if let (Some(inertia), Some(rate)) = (body.inertia, kinematics.bare.frames[body.frame].rate) {
            *rotary.entry(rate).or_insert(zero) += inertia;
        }
        let columns = columns(kinematics, &body.center);
        let accelerations = accelerations(kinematics, &body.center, gravity);
        for (at, k) in columns.iter().enumerate() {
            for l in &columns[..=at] {
                let entry = masses.entry((k.velocity, l.velocity));
                accumulate(entry, (k.frame, l.frame), body.mass, k.u, l.u);
            }
            for (frame, factor, w) in &accelerations {
                let entry = biases.entry((k.velocity, *frame, *factor));
                accumulate(entry, (k.frame, *frame), body.mass, k.u, *w);
            }
        }
    }

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

/// The columns of a point's velocity, ascending in the index of the velocity.
fn columns<'g>(kinematics: On<'g, &'g Kinematics>, position: &Position) -> Vec<Column> {
    let mut columns = Vec::new();
    for (frame, vector) in &position.parts {
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

/// The terms of a point's acceleration at v̇ = 0, less gravity.
fn accelerations<'g>(
    kinematics: On<'g, &'g Kinematics>,
    position: &Position,
    gravity: Option<On<'g, Pair>>,
) -> Vec<(FrameId, Factor, Pair)> {
    let g = kinematics.g;
    let mut terms = Vec::new();
    let mut explicit = gravity.map(|gravity| -gravity);
    for (frame, vector) in &position.parts {
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

/// Adds m u·w and m u×w of one body.
fn accumulate<'g, K: Ord>(
    entry: Entry<K, Sum<'g>>,
    frames: (FrameId, FrameId),
    mass: Scalar<'g>,
    u: Pair,
    w: Pair,
) {
    match entry {
        Entry::Vacant(vacant) => {
            let products = weighted(mass, u, w);
            vacant.insert(Sum { frames, products, last: (mass, u, w, products) });
        }
        Entry::Occupied(mut occupied) => {
            let sum = occupied.get_mut();
            if (sum.last.0.bare, sum.last.1, sum.last.2) != (mass.bare, u, w) {
                sum.last = (mass, u, w, weighted(mass, u, w));
            }
            sum.products.dot += sum.last.3.dot;
            sum.products.cross += sum.last.3.cross;
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
