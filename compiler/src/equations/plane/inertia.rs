//! Mass matrix and inertia forces, pair of velocities by pair of velocities.
//!
//! Body i has its centre at Σ_f A_f d_{i,f}. The column of a velocity k is A_{f(k)} u_{i,k} with u fixed in one frame:
//! u = d turned by a right angle for the rate of the frame, u = e for a slide along e. Hence
//!   M_kl = Σ_i m_i (A_k u_k)·(A_l u_l) = c Σ_i m_i u_k·u_l − s Σ_i m_i u_k×u_l,   (c, s) of θ_l − θ_k,
//! where both sums are constants unless something slides; so is every sum in the inertia forces
//!   −Σ_i m_i (A_k u_k)·a_i,   a_i = Σ_f A_f (−ω_f² d_f + 2 ω_f × ḋ_f + ∂²d_f/∂t²) − g.
//! Gravity is an acceleration of the ground's frame (Featherstone, Rigid Body Dynamics Algorithms, section 5.3).
//! This is the composite-rigid-body regrouping of inertial parameters, done by the graph's constant folding.

use super::kinematics::{FrameId, GROUND, Kinematics, LocalVector, Position};
use crate::symbolic::{Graph, Node};
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

/// A body for this purpose.
pub struct Massive {
    pub mass: Node,
    /// About the centre; `None` for a particle.
    pub inertia: Option<Node>,
    pub center: Position,
    pub frame: FrameId,
}

/// M (lower triangle, structural non-zeros) and the inertia and gravity forces on the right-hand side.
pub struct Inertia {
    pub mass: BTreeMap<(usize, usize), Node>,
    pub forces: Vec<Node>,
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
struct Products {
    dot: Node,
    cross: Node,
}

/// A sum over bodies of products m u·w and m u×w, and the last of these: bodies behind one joint have the same vectors in all frames
/// before it, and their products, if their masses are equal, too.
struct Sum {
    frames: (FrameId, FrameId),
    products: Products,
    last: (Node, [Node; 2], [Node; 2], Products),
}

struct Column {
    velocity: usize,
    frame: FrameId,
    u: [Node; 2],
}

/// `gravity` in world axes.
pub fn inertia(
    g: &mut Graph,
    kinematics: &Kinematics,
    bodies: &[Massive],
    gravity: Option<[Node; 2]>,
) -> Inertia {
    let mut masses: BTreeMap<(usize, usize), Sum> = BTreeMap::new();
    let mut biases: BTreeMap<(usize, FrameId, Factor), Sum> = BTreeMap::new();
    let mut rotary: BTreeMap<usize, Node> = BTreeMap::new();
    for body in bodies {
        if let (Some(inertia), Some(rate)) = (body.inertia, kinematics.frames[body.frame].rate) {
            let sum = rotary.get(&rate).copied().unwrap_or(g.constant(0.0));
            rotary.insert(rate, g.add(sum, inertia));
        }
        let columns = columns(g, kinematics, &body.center);
        let accelerations = accelerations(g, kinematics, &body.center, gravity);
        for (at, k) in columns.iter().enumerate() {
            for l in &columns[..=at] {
                accumulate(
                    g,
                    masses.entry((k.velocity, l.velocity)),
                    (k.frame, l.frame),
                    body.mass,
                    k.u,
                    l.u,
                );
            }
            for (frame, factor, w) in &accelerations {
                let entry = biases.entry((k.velocity, *frame, *factor));
                accumulate(g, entry, (k.frame, *frame), body.mass, k.u, *w);
            }
        }
    }

    let mut mass = BTreeMap::new();
    for ((k, l), Sum { frames, products, .. }) in masses {
        let entry = turned(g, kinematics, frames, products);
        if !g.is_zero(entry) {
            mass.insert((k, l), entry);
        }
    }
    for (rate, inertia) in rotary {
        let sum = mass.get(&(rate, rate)).copied().unwrap_or(g.constant(0.0));
        let sum = g.add(inertia, sum);
        if !g.is_zero(sum) {
            mass.insert((rate, rate), sum);
        }
    }

    let zero = g.constant(0.0);
    let mut forces = vec![zero; kinematics.velocities.len()];
    for ((k, frame, factor), Sum { frames, products, .. }) in biases {
        let coefficient = turned(g, kinematics, frames, products);
        let factor = factor_value(g, kinematics, frame, factor);
        let force = g.mul(coefficient, factor);
        forces[k] = g.sub(forces[k], force);
    }
    Inertia { mass, forces }
}

/// The columns of a point's velocity, ascending in the index of the velocity.
fn columns(g: &mut Graph, kinematics: &Kinematics, position: &Position) -> Vec<Column> {
    let mut columns = Vec::new();
    for (frame, vector) in &position.parts {
        for (velocity, direction) in &vector.slides {
            columns.push(Column { velocity: *velocity, frame: *frame, u: *direction });
        }
        if let Some(rate) = kinematics.frames[*frame].rate
            && !(g.is_zero(vector.at[0]) && g.is_zero(vector.at[1]))
        {
            columns.push(Column { velocity: rate, frame: *frame, u: [g.neg(vector.at[1]), vector.at[0]] });
        }
    }
    columns.sort_by_key(|column| column.velocity);
    columns
}

/// The terms of a point's acceleration at v̇ = 0, less gravity.
fn accelerations(
    g: &mut Graph,
    kinematics: &Kinematics,
    position: &Position,
    gravity: Option<[Node; 2]>,
) -> Vec<(FrameId, Factor, [Node; 2])> {
    let mut terms = Vec::new();
    let mut explicit = gravity.map(|gravity| [g.neg(gravity[0]), g.neg(gravity[1])]);
    for (frame, vector) in &position.parts {
        if kinematics.frames[*frame].rate.is_some() {
            terms.push((*frame, Factor::Centripetal, [g.neg(vector.at[0]), g.neg(vector.at[1])]));
            for (velocity, e) in &vector.slides {
                terms.push((*frame, Factor::Coriolis(*velocity), [g.neg(e[1]), e[0]]));
            }
            terms.push((*frame, Factor::Drift, [g.neg(vector.drift[1]), vector.drift[0]]));
            terms.push((*frame, Factor::Explicit, vector.drift_rate));
        } else {
            let moving: &LocalVector = vector;
            let sum = explicit.unwrap_or([g.constant(0.0); 2]);
            explicit = Some([g.add(sum[0], moving.drift_rate[0]), g.add(sum[1], moving.drift_rate[1])]);
        }
    }
    terms.extend(explicit.map(|sum| (GROUND, Factor::Explicit, sum)));
    terms.retain(|(_, _, w)| !(g.is_zero(w[0]) && g.is_zero(w[1])));
    terms
}

fn factor_value(g: &mut Graph, kinematics: &Kinematics, frame: FrameId, factor: Factor) -> Node {
    let one = g.constant(1.0);
    let omega = kinematics.frames[frame].rate.map_or(one, |rate| kinematics.velocities[rate]);
    let two = g.constant(2.0);
    match factor {
        Factor::Centripetal => g.mul(omega, omega),
        Factor::Coriolis(slide) => {
            let product = g.mul(omega, kinematics.velocities[slide]);
            g.mul(two, product)
        }
        Factor::Drift => g.mul(two, omega),
        Factor::Explicit => one,
    }
}

fn weighted(g: &mut Graph, mass: Node, u: [Node; 2], w: [Node; 2]) -> Products {
    let (xx, yy) = (g.mul(u[0], w[0]), g.mul(u[1], w[1]));
    let (xy, yx) = (g.mul(u[0], w[1]), g.mul(u[1], w[0]));
    let (dot, cross) = (g.add(xx, yy), g.sub(xy, yx));
    Products { dot: g.mul(mass, dot), cross: g.mul(mass, cross) }
}

fn plus(g: &mut Graph, a: Products, b: Products) -> Products {
    Products { dot: g.add(a.dot, b.dot), cross: g.add(a.cross, b.cross) }
}

/// Adds m u·w and m u×w of one body.
fn accumulate<K: Ord>(
    g: &mut Graph,
    entry: Entry<K, Sum>,
    frames: (FrameId, FrameId),
    mass: Node,
    u: [Node; 2],
    w: [Node; 2],
) {
    match entry {
        Entry::Vacant(vacant) => {
            let products = weighted(g, mass, u, w);
            vacant.insert(Sum { frames, products, last: (mass, u, w, products) });
        }
        Entry::Occupied(mut occupied) => {
            let sum = occupied.get_mut();
            if (sum.last.0, sum.last.1, sum.last.2) != (mass, u, w) {
                sum.last = (mass, u, w, weighted(g, mass, u, w));
            }
            sum.products = plus(g, sum.products, sum.last.3);
        }
    }
}

/// c Σ m u·w − s Σ m u×w with (c, s) of θ_l − θ_k.
fn turned(g: &mut Graph, kinematics: &Kinematics, (k, l): (FrameId, FrameId), products: Products) -> Node {
    let [cos, sin] = kinematics.relative(g, k, l);
    let (a, b) = (g.mul(cos, products.dot), g.mul(sin, products.cross));
    g.sub(a, b)
}
