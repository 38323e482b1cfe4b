//! Planar mechanisms: every orientation is one pair (cos, sin), every position a sum of vectors in turning frames.

mod angles;
mod bodies;
mod coordinates;
mod flexible;
mod inertia;
pub mod joints;
mod kinematics;
pub mod loads;
mod moving_axes;
pub mod vector;

pub use coordinates::coordinates;
pub use kinematics::Kinematics;
pub use moving_axes::MovingAxes;

use super::{Consequences, Dynamics, Laws, Row, RowOfJoint, SpanningTree};
use crate::symbolic::{Node, On, Scalar};
use inertia::Massive;
use vector::Pair;

/// M, gyroscopic and gravity forces, energies.
pub fn dynamics<'g>(laws: &Laws<'g>) -> Dynamics<'g> {
    let kinematics = laws.plane();
    let massive = massive(laws);
    let gravity = laws.mechanism.gravity.as_ref().map(|gravity| laws.pair_of(gravity));
    let inertia::Inertia { mass, mut forces } = inertia::inertia(kinematics, &massive, gravity);
    for (velocity, force) in flexible::elastic_forces(laws) {
        forces[velocity] += force;
    }
    let mut inverse: Vec<Scalar> = forces.iter().map(|force| -*force).collect();
    let acceleration = &laws.symbols.acceleration;
    for ((k, l), entry) in &mass {
        inverse[*k] += *entry * acceleration[*l];
        if k != l {
            inverse[*l] += *entry * acceleration[*k];
        }
    }
    let kinetic_energy = kinetic_energy(laws, &massive) + flexible::kinetic_energy(laws, &massive);
    let potential_energy =
        gravity_potential(laws, &massive, gravity) + flexible::potential_energy(laws, &massive, gravity);
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
    let absolute_rows = super::rows::rows(&absolute, tree, &tree.carrying(laws.mechanism), dropped, None);
    let reactions =
        bodies::reactions(laws, &absolute, tree, &massive, &motions, rows, lambda, &absolute_rows);
    Consequences {
        motions: motions.iter().map(bodies::Motion::flat).collect(),
        reactions: reactions.into_iter().map(|wrench| wrench.map(|part| part.bare).to_vec()).collect(),
    }
}

/// The kinetic energy of rigid bodies and of slices of beams, by quadrature of ½ μ |ṙ|² along their axes: what no algebra of integrals
/// has gone into.
pub fn kinetic_energy_of_slices<'g>(laws: &Laws<'g>, rule: &crate::beams::Rule) -> Scalar<'g> {
    let (g, kinematics) = (laws.g, laws.plane());
    let mut rigid = massive(laws);
    let mut sum = g.zero();
    for (index, body) in rigid.iter_mut().enumerate() {
        let Some(flexible) = &kinematics.bare.bodies[index].flexible else { continue };
        let slender = &flexible.slender;
        for (share, weight) in rule.points() {
            let x = g.number(slender.from + share * slender.length);
            let place = kinematics.point(index, g.on([x.bare, g.zero().bare]));
            let [x, y] = kinematics.world(&place.bare);
            sum += weight * (body.mass * (x.rate().square() + y.rate().square()));
        }
        let rate = kinematics.bare.frames[kinematics.bare.bodies[index].frame].rate;
        let omega = rate.map(|rate| g.on(kinematics.bare.velocities[rate]));
        sum += body.mass * flexible::twice_turning_of_slices(flexible, rule, omega, g);
        body.mass = g.zero();
    }
    0.5 * sum + kinetic_energy(laws, &rigid)
}

fn massive<'g>(laws: &Laws<'g>) -> Vec<Massive<'g>> {
    let mut massive = Vec::new();
    for (index, body) in laws.mechanism.bodies.iter().enumerate() {
        let at = laws.pair_of(&body.center);
        let placement = &laws.plane().bare.bodies[index];
        // The mass of a beam is at the origin of its frame, and what it has beyond that is added by `flexible`.
        let bends = placement.flexible.is_some();
        let moment = || if bends { laws.g.zero() } else { laws.value(&body.inertia.moments[2]) };
        massive.push(Massive {
            mass: laws.value(&body.mass),
            inertia: body.form.turns.then(moment),
            center: if bends { placement.origin.clone() } else { laws.plane().point(index, at).bare },
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
