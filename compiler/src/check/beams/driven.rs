//! How fast drivers turn a beam after the start, as far as their laws alone decide that: where all that joins it to the ground is one angle that is
//! driven, and joints that hold directions.

use crate::model::{
    BodyId, Coordinate, Frame, Joint, JointId, Mechanism, Rotor, Space, value_at, value_in_time,
};

/// How long is looked ahead, s, as long as `linkwright run` moves a mechanism that it is told nothing else of, and at how many times.
const AHEAD: f64 = 10.0;
const TIMES: usize = 2000;
/// Of the time between two of these, over which a rate is a difference.
const PART: f64 = 1e-3;

/// The rate across its axis, rad/s, at the first time, s, at which it is above a bound.
pub fn beyond(mechanism: &Mechanism, body: BodyId, bound: f64) -> Option<[f64; 2]> {
    let (law, share) = mechanism.drivers.iter().find_map(|driver| {
        let share = match &driver.coordinate {
            Coordinate::Angle(Rotor::Joint(id, which)) => carried(mechanism, body, *id, *which)?,
            Coordinate::Angle(Rotor::Body(turned)) => stands(mechanism, body, *turned)?,
            _ => return None,
        };
        Some((&driver.law, share))
    })?;
    let defaults = mechanism.defaults();
    let step = AHEAD / TIMES as f64;
    let difference = PART * step;
    let rate = |time: f64| {
        let value = |time: f64| value_in_time(law, &defaults, time);
        let [before, after] = [value(time - difference)?, value(time + difference)?];
        Some(share * ((after - before) / (2.0 * difference)).abs())
    };
    let times = (1..=TIMES).map(|k| k as f64 * step);
    times.filter_map(|time| Some([time, rate(time)?])).find(|[_, rate]| *rate > bound)
}

/// What of the rate of an angle of a joint turns the beam across its axis, where the joint has one end at rest and the beam on the other.
fn carried(mechanism: &Mechanism, body: BodyId, id: JointId, which: usize) -> Option<f64> {
    let joint = &mechanism.joints[id.0];
    let with = held_with(mechanism, Frame::Body(body), id);
    let ends = [joint.first.frame, joint.second.frame];
    let [first, second] = ends.map(|end| with.contains(&end));
    let other = match (first, second) {
        (true, false) => ends[1],
        (false, true) => ends[0],
        _ => return None,
    };
    if !held_with(mechanism, other, id).contains(&Frame::Ground) || joint.form.angles.len() != 1 || which != 0
    {
        return None;
    }
    across(mechanism, joint)
}

/// Of what a body is turned by itself.
fn stands(mechanism: &Mechanism, body: BodyId, turned: BodyId) -> Option<f64> {
    let is_planar = mechanism.space == Space::Planar;
    let with = held_with(mechanism, Frame::Body(body), JointId(usize::MAX));
    (is_planar && with.contains(&Frame::Body(turned))).then_some(1.0)
}

/// The sine between the axis of a joint and x, which all that is held with the beam has in common.
fn across(mechanism: &Mechanism, joint: &Joint) -> Option<f64> {
    if mechanism.space == Space::Planar {
        return Some(1.0);
    }
    let defaults = mechanism.defaults();
    let [x, y, z] = joint.directions.first()?.each_ref().map(|it| value_at(it, &defaults));
    let (x, y, z) = (x?, y?, z?);
    let across = libm::hypot(y, z);
    Some(across / libm::hypot(across, x))
}

/// All frames that joints hold in the direction of one, this joint left out.
fn held_with(mechanism: &Mechanism, frame: Frame, without: JointId) -> Vec<Frame> {
    let joints = mechanism.joints.iter().enumerate();
    let holding: Vec<[Frame; 2]> = joints
        .filter(|(id, joint)| JointId(*id) != without && joint.holds() && joint.form.keeps_orientation)
        .map(|(_, joint)| [joint.first.frame, joint.second.frame])
        .collect();
    let mut reached = vec![frame];
    let mut at = 0;
    while let Some(frame) = reached.get(at).copied() {
        for [one, other] in &holding {
            for (from, to) in [(one, other), (other, one)] {
                if *from == frame && !reached.contains(to) {
                    reached.push(*to);
                }
            }
        }
        at += 1;
    }
    reached
}
