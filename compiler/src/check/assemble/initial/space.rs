//! In space: the coordinates of the tree one by one.

use super::{Offsets, Stated, is_exact};
use crate::check::assemble::point::{Ancestry, Point};
use crate::check::assemble::quaternion;
use crate::equations::{Attachment, Ball, Kinematics, Rotation};
use crate::model::{BodyId, Coordinate, Frame, JointId, Mechanism, Rotor, fold};
use crate::symbolic::Node;
use std::f64::consts::TAU;

/// Tree coordinates.
pub fn initial(stated: &Stated, mechanism: &Mechanism, point: &mut Point, mut offsets: Offsets) -> Vec<f64> {
    let equations = point.equations;
    let layout = &equations.layout;
    let mut q = vec![0.0; layout.positions()];
    let lengths = stated.lengths(equations, &mut offsets);
    q[..lengths.len()].copy_from_slice(&lengths);
    let mut angles = Vec::new();
    for (r, rotation) in layout.rotations.iter().enumerate() {
        let Rotation::Joint(joint, which) = rotation else { continue };
        let value = stated.angles.get(&(*joint, *which)).copied();
        let mut angle = value.unwrap_or(0.0);
        let rotor = Rotor::Joint(*joint, *which);
        let is_own = |coordinate: &Coordinate| *coordinate == Coordinate::Angle(rotor);
        if offsets.varies(value.is_some() && is_exact(equations, is_own)) {
            angle += offsets.turn(value.is_some());
        }
        q[layout.pair(r)] = libm::cos(angle);
        q[layout.pair(r) + 1] = libm::sin(angle);
        angles.push((rotor, angle));
    }
    for (b, ball) in layout.quaternions.iter().enumerate() {
        let (given, exact) = match ball {
            Ball::Body(body) => orientation(mechanism, *body),
            Ball::Joint(joint) => carried(mechanism, point, &q, *joint),
        };
        let mut orientation = given;
        if offsets.varies(exact) {
            // About a different axis each time.
            let angle = offsets.turn(false);
            let axis = [libm::cos(angle), libm::sin(angle), libm::cos(0.5 * angle)];
            let length = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
            let turned = angle - TAU * (angle / TAU).round();
            orientation = quaternion::turn(given, axis.map(|x| x / length * turned));
        }
        q[layout.quaternion(b)..layout.quaternion(b) + 4].copy_from_slice(&orientation);
    }
    for (a, counted) in layout.angles.iter().enumerate() {
        let value = angles.iter().find(|(rotor, _)| *rotor == counted.rotor).map_or(0.0, |(_, angle)| *angle);
        let turns = (value / TAU).round();
        q[layout.turns(a)] = turns;
        q[layout.turns(a) + 1] = value - turns * TAU;
    }
    q
}

/// The turn of a ball that gives the carried body the orientation that `start` states: (A_n B_n)ᵀ A_f B_f. Balls are in
/// the order of the tree, so the body that carries it has its orientation already.
fn carried(mechanism: &Mechanism, point: &mut Point, q: &[f64], joint: JointId) -> ([f64; 4], bool) {
    let none = ([1.0, 0.0, 0.0, 0.0], false);
    let equations = point.equations;
    let Kinematics::Space(kinematics) = &equations.kinematics else { return none };
    let own = equations.tree.attachments.iter().find(|own| own.joint.is_some_and(|(id, _)| id == joint));
    let Some(Attachment { body, joint: Some((_, parent)) }) = own else { return none };
    if mechanism.orientations.iter().all(|start| start.body != *body) {
        return none;
    }
    let (wanted, exact) = orientation(mechanism, *body);
    let [near, far] = kinematics.balls[&joint];
    let carrier = match parent {
        Frame::Ground => Vec::new(),
        Frame::Body(parent) => equations.motions[parent.0].orientation.clone(),
    };
    point.set_q(q);
    let nodes = carrier.iter().chain(near.iter().flatten()).chain(far.iter().flatten());
    point.evaluate(&Ancestry::of(equations, nodes.copied()));
    let matrix = |m: &[[Node; 3]; 3]| quaternion::of_matrix(m.map(|row| row.map(|node| point.get(node))));
    let (near, far) = (matrix(&near), matrix(&far));
    let carrier = match carrier.as_slice() {
        [] => [1.0, 0.0, 0.0, 0.0],
        a => quaternion::of_matrix([0, 1, 2].map(|i| [0, 1, 2].map(|j| point.get(a[3 * i + j])))),
    };
    let carrying = quaternion::product(carrier, near);
    let turned = quaternion::product(quaternion::conjugate(carrying), quaternion::product(wanted, far));
    (quaternion::normalized(turned), exact)
}

/// The orientation that `start` states or guesses for a body, and whether it must be met.
fn orientation(mechanism: &Mechanism, body: BodyId) -> ([f64; 4], bool) {
    let defaults = mechanism.defaults();
    match mechanism.orientations.iter().find(|start| start.body == body) {
        Some(start) => {
            let value = |k: usize| fold::evaluate(&start.quaternion[k], &defaults).unwrap_or(0.0);
            (quaternion::normalized([0, 1, 2, 3].map(value)), start.exact)
        }
        None => ([1.0, 0.0, 0.0, 0.0], false),
    }
}
