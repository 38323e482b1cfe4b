//! The surfaces of joints: along which coordinates they slide on each other, and which forces press them together.
//!
//! | joint | slides | N |
//! |---|---|---|
//! | pin, in the plane | about it | \|R\| |
//! | pin, in space | about it | \|R_r\| + \|R_a\| r_a/r + 2 \|M_b\|/l |
//! | two pins that cross | about each | \|R\| of each |
//! | ball | about any axis | \|R\| |
//! | balls between two shafts | about any axis | \|R\| + \|M\|/r |
//! | rail | along it | \|R_n\|, or with a length \|R_n/2 + M/l\| + \|R_n/2 − M/l\| |
//! | sleeve | along and about it | the same, across the axis |
//! | point | along its line | \|R_n\| |
//! | face on a plane | along and about it | \|R_a\| |
//! | point on a plane | along it | \|R_a\| |
//! | point on a curve | along it | \|R_n\| |
//! | nut on its thread | along that | \|R_a\| h/r + \|R_r\| |
//!
//! R is the force at the joint's second place, M the torque about it (N, N m), R_a along the axis, R_r, M_b and R_n across; r is the radius, r_a
//! that of the shoulder, l the length. A thread of the pitch 2π p slides with (r² ω + p ẋ)/h, h² = r² + p², and its force has a part along the axis.
//! A length or shoulder that is not given carries nothing. Moments of a rail or sleeve are carried by its
//! ends, at l/2 to both sides of the second place.

use super::{Slip, pressed};
use crate::equations::jet::Moving;
use crate::equations::laws::Laws;
use crate::equations::plane::joints;
use crate::forms::{Argument, Bearing, Need};
use crate::model::{Frame, Joint, JointId, Load, Place, Rotor, Space};
use crate::symbolic::Scalar;
use crate::units::Dimension;
use std::f64::consts::TAU;

/// What a law of friction is told of the joint that it acts in: r, l, r_a, and what presses beside its reaction.
pub(super) const RADIUS: Argument = Argument::scalar("radius", Need::Never, Dimension::LENGTH).not_negative();
pub(super) const LENGTH: Argument = Argument::scalar("length", Need::Never, Dimension::LENGTH).not_negative();
pub(super) const SHOULDER: Argument =
    Argument::scalar("shoulder", Need::Never, Dimension::LENGTH).not_negative();
pub(super) const PRELOAD: Argument =
    Argument::scalar("preload", Need::Never, Dimension::FORCE).not_negative();

/// The components of each of the forces whose sizes together are N.
pub type Pressing<'g> = Vec<Vec<Scalar<'g>>>;

fn joint_of<'l>(laws: &Laws<'l>, load: &Load) -> Option<(JointId, &'l Joint, Bearing)> {
    let id = load.bearing()?;
    let joint = &laws.mechanism.joints[id.0];
    Some((id, joint, joint.form.bearing?))
}

/// What slides in the joint of a friction.
pub(super) fn slips<'g>(laws: &Laws<'g>, load: &Load) -> Vec<Slip<'g>> {
    let Some((id, joint, bearing)) = joint_of(laws, load) else { return Vec::new() };
    let (one, radius) = (laws.g.one(), laws.value(load.named("radius")));
    let turn = |which| laws.kinematics().rotor_rate(laws, Rotor::Joint(id, which));
    let travel = |which| laws.kinematics().travel(laws, id, which);
    let pressed = pressed(laws, load);
    let slip = |along, radius| Slip { along, radius, pressed, normal: Vec::new(), closed: None };
    match bearing {
        Bearing::Pin => vec![slip(vec![(turn(0), one)], radius)],
        Bearing::Cross => [0, 1].map(|which| slip(vec![(turn(which), one)], radius)).into(),
        Bearing::Ball | Bearing::Knuckle => {
            vec![slip(relative_turn(laws, joint).into_iter().map(|it| (it, one)).collect(), radius)]
        }
        Bearing::Rail | Bearing::Point => vec![slip(vec![(travel(0), one)], one)],
        Bearing::Sleeve => vec![slip(vec![(turn(0), radius), (travel(0), one)], one)],
        Bearing::Face => vec![slip(vec![(turn(0), radius), (travel(0), one), (travel(1), one)], one)],
        Bearing::Spot => {
            vec![slip([0, 1].map(|axis| (laws.kinematics().shift(laws, id, axis), one)).into(), one)]
        }
        Bearing::Curve => vec![slip(vec![joints::sliding_on_curve(laws, id)], one)],
        Bearing::Thread => {
            let (lead, whole) = thread(laws, joint, radius);
            let along = (radius.square() / whole) * &turn(0) + (lead / whole) * &travel(0);
            vec![slip(vec![(along, one)], one)]
        }
    }
}

/// p and h = √(r² + p²) of a thread.
fn thread<'g>(laws: &Laws<'g>, joint: &Joint, radius: Scalar<'g>) -> (Scalar<'g>, Scalar<'g>) {
    let lead = laws.value(joint.scalar(0)) / TAU;
    (lead, (radius.square() + lead.square()).sqrt())
}

/// Quantities whose rates are ω of the second body less that of the first, along the axes of the world.
fn relative_turn<'g>(laws: &Laws<'g>, joint: &Joint) -> Vec<Moving<'g>> {
    let turning = |place: &Place| match place.frame {
        Frame::Body(_) => laws.kinematics().turning_at(laws, place),
        Frame::Ground => vec![laws.still(laws.g.zero()); 3],
    };
    turning(&joint.second).into_iter().zip(turning(&joint.first)).map(|(two, one)| two - one).collect()
}

/// The forces that press, of what the joint exerts on its second body: force, then torque, along the axes of the world.
pub fn pressing<'g>(laws: &Laws<'g>, load: &Load, wrench: &[Scalar<'g>]) -> Pressing<'g> {
    let Some((id, joint, bearing)) = joint_of(laws, load) else { return Vec::new() };
    let (force, torque) = wrench.split_at(laws.mechanism.space.dimensions());
    let length = laws.value(load.named("length"));
    if laws.mechanism.space == Space::Planar {
        return match bearing {
            Bearing::Pin => vec![force.to_vec()],
            Bearing::Curve => {
                let [x, y] = joints::out_of_curve(laws, id).parts();
                vec![vec![x * force[0] + y * force[1]]]
            }
            _ => {
                let normal = laws.plane().normal(laws, joint).parts();
                let across = normal[0] * force[0] + normal[1] * force[1];
                at_ends(&[across], &[torque[0]], length)
            }
        };
    }
    let Some(axis) = axis(laws, joint) else { return vec![force.to_vec()] };
    let cross = |a: [Scalar<'g>; 3], b: &[Scalar<'g>]| {
        [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i] * b[j] - a[j] * b[i])
    };
    let along = |v: &[Scalar<'g>]| laws.g.sum(axis.iter().zip(v).map(|(a, v)| *a * *v));
    let across = |v: &[Scalar<'g>]| {
        let along = along(v);
        v.iter().zip(&axis).map(|(v, a)| *v - along * *a).collect::<Vec<_>>()
    };
    match bearing {
        Bearing::Cross | Bearing::Ball => vec![force.to_vec()],
        Bearing::Knuckle => {
            let by = laws.value(load.named("radius")).reciprocal();
            vec![force.to_vec(), torque.iter().map(|moment| *moment * by).collect()]
        }
        Bearing::Face | Bearing::Spot => vec![vec![along(force)]],
        Bearing::Thread => {
            let radius = laws.value(load.named("radius"));
            let (_, whole) = thread(laws, joint, radius);
            vec![vec![along(force) * (whole / radius)], across(force)]
        }
        Bearing::Pin => {
            let [shoulder, radius] = ["shoulder", "radius"].map(|name| laws.value(load.named(name)));
            let mut pressing = vec![across(force)];
            if !shoulder.is_zero() {
                pressing.push(vec![along(force) * (shoulder / radius)]);
            }
            if !length.is_zero() {
                let by = 2.0 * length.reciprocal();
                pressing.push(across(torque).into_iter().map(|moment| moment * by).collect());
            }
            pressing
        }
        // A moment M is carried by forces M × a/l at the one end and −M × a/l at the other.
        Bearing::Rail | Bearing::Sleeve | Bearing::Point | Bearing::Curve => {
            let couple = cross(axis, torque).map(|moment| -moment);
            at_ends(&across(force), &couple, length)
        }
    }
}

/// R/2 + M/l and R/2 − M/l; R where no length carries a moment.
fn at_ends<'g>(force: &[Scalar<'g>], couple: &[Scalar<'g>], length: Scalar<'g>) -> Pressing<'g> {
    if length.is_zero() {
        return vec![force.to_vec()];
    }
    let by = length.reciprocal();
    let end = |sign: f64| force.iter().zip(couple).map(|(r, m)| 0.5 * *r + sign * (*m * by)).collect();
    vec![end(1.0), end(-1.0)]
}

/// The axis of a joint in space along the axes of the world, if it has one.
fn axis<'g>(laws: &Laws<'g>, joint: &Joint) -> Option<[Scalar<'g>; 3]> {
    let space = laws.space()?;
    let direction = joint.directions.first()?;
    let spot = space.spot(laws, &joint.first);
    let local = spot.axes * laws.vector(direction).normalized();
    Some((space.world_axes(spot.link) * local).parts())
}
