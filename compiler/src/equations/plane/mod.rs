//! Planar mechanisms: every orientation is one pair (cos, sin), every position a sum of vectors in turning frames.

mod angles;
mod bodies;
mod coordinates;
mod inertia;
pub mod joints;
mod kinematics;

pub use coordinates::coordinates;
pub use kinematics::Kinematics;

use super::{Consequences, Dropped, Dynamics, Laws, Row, SpanningTree};
use crate::model::BodyKind;
use crate::symbolic::{Graph, Node};
use inertia::Massive;

/// M, gyroscopic and gravity forces, energies.
pub fn dynamics(g: &mut Graph, laws: &Laws) -> Dynamics {
    let kinematics = laws.plane();
    let massive = massive(g, laws);
    let gravity = laws.mechanism.gravity.as_ref().map(|gravity| laws.pair_of(g, gravity));
    let inertia::Inertia { mass, forces } = inertia::inertia(g, kinematics, &massive, gravity);
    let mut inverse: Vec<Node> = forces.iter().map(|force| g.neg(*force)).collect();
    for ((k, l), entry) in &mass {
        let own = g.mul(*entry, laws.symbols.acceleration[*l]);
        inverse[*k] = g.add(inverse[*k], own);
        if k != l {
            let other = g.mul(*entry, laws.symbols.acceleration[*k]);
            inverse[*l] = g.add(inverse[*l], other);
        }
    }
    let kinetic_energy = kinetic_energy(g, kinematics, &massive);
    let potential_energy = gravity_potential(g, kinematics, &massive, gravity);
    Dynamics { mass, forces, inverse, kinetic_energy, potential_energy, distributions: Vec::new() }
}

/// Motions of the bodies and reactions of the joints.
pub fn consequences(
    g: &mut Graph,
    laws: &Laws,
    tree: &SpanningTree,
    rows: &[Row],
    lambda: &[Node],
    dropped: &[Dropped],
) -> Consequences {
    let massive = massive(g, laws);
    let motions = bodies::motions(g, laws.plane(), &massive, laws.symbols);
    let overlay = super::Kinematics::Plane(bodies::overlay(g, laws, &motions));
    let absolute = Laws::moving(laws.mechanism, laws.symbols, laws.layout, &overlay);
    let absolute_rows = super::rows(g, &absolute, tree, &tree.carrying(laws.mechanism), dropped);
    let reactions =
        bodies::reactions(g, laws, &absolute, tree, &massive, &motions, rows, lambda, &absolute_rows);
    Consequences {
        motions: motions.iter().map(bodies::Motion::flat).collect(),
        reactions: reactions.into_iter().map(|wrench| wrench.to_vec()).collect(),
    }
}

fn massive(g: &mut Graph, laws: &Laws) -> Vec<Massive> {
    let mut massive = Vec::new();
    for (index, body) in laws.mechanism.bodies.iter().enumerate() {
        let at = laws.pair_of(g, &body.center);
        let rigid = body.kind == BodyKind::Rigid;
        massive.push(Massive {
            mass: laws.value(g, &body.mass),
            inertia: rigid.then(|| laws.value(g, &body.inertia.moments[2])),
            center: laws.plane().point(g, index, at),
            frame: laws.plane().bodies[index].frame,
        });
    }
    massive
}

/// T = Σ ½ m |ẋ|² + ½ J ω².
fn kinetic_energy(g: &mut Graph, kinematics: &Kinematics, bodies: &[Massive]) -> Node {
    let mut twice = g.constant(0.0);
    for body in bodies {
        let v = &kinematics.velocities;
        let [x, y] = kinematics.world(g, &body.center);
        let (x, y) = (x.rate(g, v), y.rate(g, v));
        let (xx, yy) = (g.mul(x, x), g.mul(y, y));
        let square = g.add(xx, yy);
        let translation = g.mul(body.mass, square);
        twice = g.add(twice, translation);
        if let (Some(inertia), Some(rate)) = (body.inertia, kinematics.frames[body.frame].rate) {
            let square = g.mul(v[rate], v[rate]);
            let rotation = g.mul(inertia, square);
            twice = g.add(twice, rotation);
        }
    }
    let half = g.constant(0.5);
    g.mul(half, twice)
}

/// V = −Σ m g·r.
fn gravity_potential(
    g: &mut Graph,
    kinematics: &Kinematics,
    bodies: &[Massive],
    gravity: Option<[Node; 2]>,
) -> Node {
    let mut sum = g.constant(0.0);
    let Some(gravity) = gravity else { return sum };
    for body in bodies {
        let [x, y] = kinematics.world(g, &body.center);
        let (gx, gy) = (g.mul(gravity[0], x.value), g.mul(gravity[1], y.value));
        let height = g.add(gx, gy);
        let weight = g.mul(body.mass, height);
        sum = g.sub(sum, weight);
    }
    sum
}
