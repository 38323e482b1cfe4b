//! Planar mechanisms: every orientation is one pair (cos, sin), every position a sum of vectors in turning frames.

mod angles;
mod bodies;
mod coordinates;
mod inertia;
pub mod joints;
mod kinematics;
pub mod loads;
mod vector;

pub use coordinates::coordinates;
pub use kinematics::Kinematics;

use super::{Consequences, Dynamics, Laws, Row, RowOfJoint, SpanningTree};
use crate::symbolic::{Node, On, Scalar};
use inertia::Massive;
use vector::Pair;

/// M, gyroscopic and gravity forces, energies.
pub fn dynamics<'g>(laws: &Laws<'g>) -> Dynamics<'g> {
    let kinematics = laws.plane();
    let massive = massive(laws);
    let gravity = laws.mechanism.gravity.as_ref().map(|gravity| laws.pair_of(gravity));
    let inertia::Inertia { mass, forces } = inertia::inertia(kinematics, &massive, gravity);
    let mut inverse: Vec<Scalar> = forces.iter().map(|force| -*force).collect();
    let acceleration = &laws.symbols.acceleration;
    for ((k, l), entry) in &mass {
        inverse[*k] += *entry * acceleration[*l];
        if k != l {
            inverse[*l] += *entry * acceleration[*k];
        }
    }
    let kinetic_energy = kinetic_energy(laws, &massive);
    let potential_energy = gravity_potential(laws, &massive, gravity);
    Dynamics { mass, forces, inverse, kinetic_energy, potential_energy, distributions: Vec::new() }
}

/// Motions of the bodies and reactions of the joints.
pub fn consequences(
    laws: &Laws,
    tree: &SpanningTree,
    rows: &[Row],
    lambda: &[Node],
    dropped: &[RowOfJoint],
) -> Consequences {
    let massive = massive(laws);
    let motions = bodies::motions(laws, &massive);
    let overlay = super::Kinematics::Plane(bodies::overlay(laws, &motions));
    let absolute = laws.of(&overlay);
    let absolute_rows = super::rows::rows(&absolute, tree, &tree.carrying(laws.mechanism), dropped);
    let reactions =
        bodies::reactions(laws, &absolute, tree, &massive, &motions, rows, lambda, &absolute_rows);
    Consequences {
        motions: motions.iter().map(bodies::Motion::flat).collect(),
        reactions: reactions.into_iter().map(|wrench| wrench.map(|part| part.bare).to_vec()).collect(),
    }
}

fn massive<'g>(laws: &Laws<'g>) -> Vec<Massive<'g>> {
    let mut massive = Vec::new();
    for (index, body) in laws.mechanism.bodies.iter().enumerate() {
        let at = laws.pair_of(&body.center);
        massive.push(Massive {
            mass: laws.value(&body.mass),
            inertia: body.form.turns.then(|| laws.value(&body.inertia.moments[2])),
            center: laws.plane().point(index, at).bare,
            frame: laws.plane().bare.bodies[index].frame,
        });
    }
    massive
}

/// T = Σ ½ m |ẋ|² + ½ J ω².
fn kinetic_energy<'g>(laws: &Laws<'g>, bodies: &[Massive<'g>]) -> Scalar<'g> {
    let kinematics = laws.plane();
    let mut twice = laws.g.zero();
    for body in bodies {
        let [x, y] = kinematics.world(&body.center);
        let (x, y) = (x.rate(), y.rate());
        twice += body.mass * (x.square() + y.square());
        if let (Some(inertia), Some(rate)) = (body.inertia, kinematics.bare.frames[body.frame].rate) {
            twice += inertia * laws.g.on(kinematics.bare.velocities[rate]).square();
        }
    }
    0.5 * twice
}

/// V = −Σ m g·r.
fn gravity_potential<'g>(
    laws: &Laws<'g>,
    bodies: &[Massive<'g>],
    gravity: Option<On<'g, Pair>>,
) -> Scalar<'g> {
    let mut sum = laws.g.zero();
    let Some(gravity) = gravity else { return sum };
    for body in bodies {
        let [x, y] = laws.plane().world(&body.center);
        sum -= body.mass * gravity.dot([x.jet.value, y.jet.value]);
    }
    sum
}
