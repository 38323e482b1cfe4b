//! In the plane: orientations along the tree, then whatever follows from them.

use super::{Offsets, Stated, is_exact};
use crate::equations::{Attachment, Equations, Linear, Rotation};
use crate::model::{BodyId, Coordinate, Frame, JointId, Mechanism, Rotor};
use std::f64::consts::TAU;

/// Tree coordinates.
pub fn initial(
    given: &Stated,
    mechanism: &Mechanism,
    equations: &Equations,
    mut offsets: Offsets,
) -> Vec<f64> {
    let layout = &equations.layout;
    let mut q = vec![0.0; layout.positions()];
    let angles = orientations(given, mechanism, equations, &mut offsets);
    for (r, rotation) in layout.rotations.iter().enumerate() {
        let Rotation::Body(body) = rotation else { continue };
        q[layout.pair(r)] = libm::cos(angles[body.0]);
        q[layout.pair(r) + 1] = libm::sin(angles[body.0]);
    }
    let lengths = given.lengths(equations, &mut offsets);
    q[..lengths.len()].copy_from_slice(&lengths);
    for (a, angle) in layout.angles.iter().enumerate() {
        let value = match angle.rotor {
            Rotor::Body(body) => angles[body.0],
            Rotor::Joint(joint, _) => {
                let joint = &mechanism.joints[joint.0];
                of_frame(joint.second.frame, &angles) - of_frame(joint.first.frame, &angles)
            }
        };
        // Sections of beams are turned beyond their bodies by their modes, in which they are linear.
        let modes = angle
            .rate
            .iter()
            .filter(|(index, _)| matches!(layout.linear.get(*index), Some(Linear::Mode(..))));
        let value = modes.fold(value, |value, (index, slope)| value + slope * q[*index]);
        let turns = (value / TAU).round();
        q[layout.turns(a)] = turns;
        q[layout.turns(a) + 1] = value - turns * TAU;
    }
    q
}

fn of_frame(frame: Frame, angles: &[f64]) -> f64 {
    match frame {
        Frame::Ground => 0.0,
        Frame::Body(body) => angles[body.0],
    }
}

/// Orientations of the bodies, each behind its parent in the tree.
fn orientations(
    given: &Stated,
    mechanism: &Mechanism,
    equations: &Equations,
    offsets: &mut Offsets,
) -> Vec<f64> {
    let mut angles = vec![0.0; mechanism.bodies.len()];
    for Attachment { body, joint } in &equations.tree.attachments {
        let parent = joint.map_or(0.0, |(_, frame)| of_frame(frame, &angles));
        if !equations.layout.rotations.contains(&Rotation::Body(*body)) {
            angles[body.0] = parent;
            continue;
        }
        let relative = joint.and_then(|(id, _)| {
            let second = mechanism.joints[id.0].second.frame == Frame::Body(*body);
            given.angles.get(&(id, 0)).map(|angle| if second { *angle } else { -angle })
        });
        let stated = relative.map(|relative| parent + relative).or(given.bodies.get(&body.0).copied());
        let closing = || through_another_joint(given, mechanism, equations, *body, &angles);
        angles[body.0] = match stated.or_else(closing) {
            None => offsets.turn(false),
            // A value that is only guessed is varied too, so that other assemblies are found.
            Some(angle) if stated.is_some() && offsets.varies(is_stated(equations, *joint, *body)) => {
                angle + offsets.turn(true)
            }
            Some(angle) => angle,
        };
    }
    angles
}

/// Orientation of a body from the stated angle of a joint that the tree does not use.
fn through_another_joint(
    given: &Stated,
    mechanism: &Mechanism,
    equations: &Equations,
    body: BodyId,
    angles: &[f64],
) -> Option<f64> {
    let carrying = equations.tree.carrying(mechanism);
    let own = Frame::Body(body);
    given.angles.iter().filter(|((id, _), _)| !carrying[id.0]).find_map(|((id, _), angle)| {
        let joint = &mechanism.joints[id.0];
        if joint.second.frame == own {
            Some(of_frame(joint.first.frame, angles) + angle)
        } else if joint.first.frame == own {
            Some(of_frame(joint.second.frame, angles) - angle)
        } else {
            None
        }
    })
}

/// Whether `start` states the angle of a body or of the joint that carries it, and not only guesses it.
fn is_stated(equations: &Equations, joint: Option<(JointId, Frame)>, body: BodyId) -> bool {
    is_exact(equations, |coordinate| match coordinate {
        Coordinate::Angle(Rotor::Joint(own, _)) => joint.is_some_and(|(joint, _)| joint == *own),
        Coordinate::Angle(Rotor::Body(own)) => *own == body,
        _ => false,
    })
}
