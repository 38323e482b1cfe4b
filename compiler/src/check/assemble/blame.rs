//! Which length or axis of a loop is to blame when it does not close.

use super::point::Point;
use super::world::{Vec3, World, cross, length, sub};
use crate::equations::space::constant_axis;
use crate::model::{Axes, Frame, Joint, JointId, Mechanism, Place, Space, fold};

/// The fault of a loop.
pub enum Blame {
    /// One length is greater than all others together, which no position helps: (its link, length, the others together), m.
    TooLong { link: String, length: f64, others: f64 },
    /// The axes of two joints on a link are off parallel by so many radians, while those on most others are parallel.
    Twisted { link: String, joints: [String; 2], angle: f64 },
    /// The joint's `axis` is read in the axes of a marker.
    AxisOfMarker { joint: String, marker: String },
}

/// Axes of two joints further off parallel than this are meant to be.
const SLIGHT: f64 = 0.3;
/// Sines below this are zero.
const PARALLEL: f64 = 1e-9;

/// The faults that are known of the loop that `joint` closes; lengths and axes on bodies do not depend on the
/// position `q`.
pub fn of_loop(mechanism: &Mechanism, point: &mut Point, joint: JointId, q: &[f64]) -> Vec<Blame> {
    let joints = point.equations.tree.around(mechanism, joint);
    let world = World::at(mechanism, point, q);
    let mut found = Vec::new();
    found.extend(too_long(mechanism, &world, &joints));
    if mechanism.space == Space::Spatial && found.is_empty() {
        found.extend(twisted(mechanism, &world, &joints));
        found.extend(joints.iter().find_map(|joint| axis_of_marker(&mechanism.joints[joint.0])));
    }
    found
}

/// The links of a loop, each with the two joints that it has on it.
fn links(mechanism: &Mechanism, joints: &[JointId]) -> Option<Vec<(Frame, [JointId; 2])>> {
    let mut frames: Vec<Frame> = Vec::new();
    for joint in joints {
        let joint = &mechanism.joints[joint.0];
        frames.extend([joint.first.frame, joint.second.frame]);
    }
    frames.sort_unstable();
    frames.dedup();
    let link = |frame: Frame| {
        let own = joints.iter().filter(|joint| place_on(&mechanism.joints[joint.0], frame).is_some());
        let own: Vec<JointId> = own.copied().collect();
        Some((frame, <[JointId; 2]>::try_from(own).ok()?))
    };
    frames.into_iter().map(link).collect()
}

fn place_on(joint: &Joint, frame: Frame) -> Option<&Place> {
    [&joint.first, &joint.second].into_iter().find(|place| place.frame == frame)
}

/// By the inequality of polygons, in the plane as in space, where all joints are points that two links share, or rods.
fn too_long(mechanism: &Mechanism, world: &World, joints: &[JointId]) -> Option<Blame> {
    let mut lengths: Vec<(String, f64)> = Vec::new();
    for id in joints {
        let joint = &mechanism.joints[id.0];
        if let Some(length) = joint.rod() {
            let length = fold::evaluate(length, &mechanism.defaults())?;
            lengths.push((joint.name.text.clone(), length));
        } else if !joint.form.keeps_place || joint.form.freedoms == 0 {
            return None;
        }
    }
    for (frame, own) in links(mechanism, joints)? {
        let places = own.map(|joint| place_on(&mechanism.joints[joint.0], frame));
        let [Some(a), Some(b)] = places else { return None };
        let length = length(sub(world.place(a)?, world.place(b)?));
        lengths.push((mechanism.frame_name(frame).to_string(), length));
    }
    let longest = lengths.iter().max_by(|a, b| a.1.total_cmp(&b.1))?.clone();
    let others = lengths.iter().map(|(_, length)| length).sum::<f64>() - longest.1;
    let (link, length) = longest;
    (length > others).then_some(Blame::TooLong { link, length, others })
}

/// The link on which axes are slightly off parallel that are parallel on the others.
fn twisted(mechanism: &Mechanism, world: &World, joints: &[JointId]) -> Option<Blame> {
    let mut twists: Vec<(f64, Frame, [JointId; 2])> = Vec::new();
    for (frame, own) in links(mechanism, joints)? {
        let axis = |id: JointId| -> Option<Vec3> {
            let joint = &mechanism.joints[id.0];
            let place = place_on(joint, frame)?;
            Some(world.turned(frame, constant_axis(mechanism, joint, place)?))
        };
        let [a, b] = own.map(axis);
        twists.push((libm::asin(length(cross(a?, b?)).min(1.0)), frame, own));
    }
    let slight = twists.iter().filter(|(angle, ..)| *angle > PARALLEL && *angle < SLIGHT).count();
    let parallel = twists.iter().filter(|(angle, ..)| *angle <= PARALLEL).count();
    let (angle, frame, own) =
        twists.into_iter().filter(|(angle, ..)| *angle < SLIGHT).max_by(|a, b| a.0.total_cmp(&b.0))?;
    (slight > 0 && parallel >= slight).then(|| Blame::Twisted {
        link: mechanism.frame_name(frame).to_string(),
        joints: own.map(|joint| mechanism.joints[joint.0].name.text.clone()),
        angle,
    })
}

/// An `axis` beside a marker that has axes of its own, unless it is the marker's z.
fn axis_of_marker(joint: &Joint) -> Option<Blame> {
    let axis = joint.common_axis()?;
    let [x, y, _] = axis.each_ref().map(|component| fold::evaluate(component, &[]));
    let marker =
        [&joint.first, &joint.second].into_iter().find(|place| !matches!(place.axes, Axes::Parallel))?;
    let beside = x.is_none_or(|x| x != 0.0) || y.is_none_or(|y| y != 0.0);
    beside.then(|| Blame::AxisOfMarker { joint: joint.name.text.clone(), marker: marker.text.clone() })
}
