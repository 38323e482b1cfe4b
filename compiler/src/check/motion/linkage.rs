//! What designers of linkages ask of a motion: which coordinate is the input, the time ratios of what swings to and fro while it turns,
//! and the transmission angles at links that push.
//!
//! The transmission angle μ at a link between two pins is 90° less the angle between the link and the way of the pin that it
//! pushes: sin μ = |u·w|, u along the link and w along the way of the pin, both of length one (H. Alt, "Der Übertragungswinkel und seine
//! Bedeutung für das Konstruieren periodischer Getriebe", Werkstattstechnik 26, 1932). In a four-bar it is the angle between coupler and
//! rocker, the acute one. Ways are known of bodies that a pin or a slide holds to the ground.

use super::path::Place;
use super::{End, Followed, Motion, Range};
use crate::check::assemble::Point;
use crate::check::assemble::pins::{Pin, pins};
use crate::model::{Coordinate, Frame, Joint, JointId, Load, Mechanism, Rotor, Subject};
use std::f64::consts::TAU;

/// Halves of the interval in which a least or largest value is looked for, and how often it is made smaller by the golden ratio.
const AROUND: f64 = 0.2;
const ROUNDS: usize = 32;
/// A sine as small as this is zero.
const ZERO: f64 = 1e-13;

/// A motion as that of a linkage.
#[derive(Clone, Debug, Default)]
pub struct Linkage {
    /// Index in [`Motion::ranges`] of the coordinate by which it is moved: that of a driver, that on which an input acts, or one that
    /// turns fully, in this order.
    pub input: Option<usize>,
    pub ratios: Vec<TimeRatio>,
    pub transmissions: Vec<Transmission>,
}

/// Of a joint at the ground that goes to and fro once in a turn of the input.
#[derive(Clone, Debug)]
pub struct TimeRatio {
    /// Index in [`Motion::ranges`].
    pub of: usize,
    /// The slower way's time by the faster one's, the input turning evenly; at least 1.
    pub ratio: f64,
}

/// The least and the largest transmission angle of a link, rad, from 0 to a right angle.
#[derive(Clone, Debug)]
pub struct Transmission {
    pub link: String,
    /// What it pushes.
    pub driven: String,
    pub least: f64,
    pub most: f64,
    /// Values of the input there.
    pub at: [f64; 2],
}

/// A link between two pins, and what holds the body that it pushes.
struct Pushing {
    link: Frame,
    driven: Frame,
    /// At its ends; the second is the driven body's.
    pins: [JointId; 2],
    guide: Guide,
}

/// What the ground lets a body do.
#[derive(Clone, Copy)]
enum Guide {
    /// Turn about a pin.
    Pin(JointId),
    /// Travel along a way, in world axes.
    Slide([f64; 2]),
}

/// Measures it.
pub fn linkage(mechanism: &Mechanism, point: &mut Point, followed: &mut Followed) -> Linkage {
    let input = input(mechanism, &followed.motion);
    let Some(input) = input else { return Linkage::default() };
    let ratios = ratios(mechanism, &followed.motion, input);
    let pushing = pushing(mechanism, &followed.motion.ranges[input]);
    let transmissions = pushing.iter().filter_map(|one| transmission(mechanism, point, followed, input, one));
    Linkage { input: Some(input), ratios, transmissions: transmissions.collect() }
}

fn input(mechanism: &Mechanism, motion: &Motion) -> Option<usize> {
    let index =
        |coordinate: &Coordinate| motion.ranges.iter().position(|range| range.coordinate == *coordinate);
    let driven = mechanism.drivers.iter().find_map(|driver| index(&driver.coordinate));
    let acts = |load: &&Load| load.law.iter().chain(load.values.iter().flatten()).any(|law| law.is_given());
    let on = |load: &Load| {
        load.on.iter().find_map(|subject| match subject {
            Subject::Rotor(rotor) => index(&Coordinate::Angle(*rotor)),
            Subject::Travel(joint) => index(&Coordinate::Travel(*joint, 0)),
            _ => None,
        })
    };
    let pushed = || mechanism.loads.iter().filter(acts).find_map(on);
    let turning = || motion.ranges.iter().position(|range| range.turns && is_grounded(mechanism, range));
    driven.or_else(pushed).or_else(turning)
}

fn is_grounded(mechanism: &Mechanism, range: &Range) -> bool {
    joint_of(range).is_some_and(|joint| other(&mechanism.joints[joint.0], Frame::Ground).is_some())
}

fn joint_of(range: &Range) -> Option<JointId> {
    match range.coordinate {
        Coordinate::Angle(Rotor::Joint(joint, _)) | Coordinate::Travel(joint, _) => Some(joint),
        _ => None,
    }
}

/// What a joint joins to a frame.
fn other(joint: &Joint, frame: Frame) -> Option<Frame> {
    match [joint.first.frame, joint.second.frame] {
        [one, another] if one == frame => Some(another),
        [another, one] if one == frame => Some(another),
        _ => None,
    }
}

fn ratios(mechanism: &Mechanism, motion: &Motion, input: usize) -> Vec<TimeRatio> {
    if !motion.ranges[input].turns || motion.end != End::Closed {
        return Vec::new();
    }
    let ratio = |of: usize| {
        let mut ends = motion.limits.iter().filter(|limit| limit.of == of).map(|limit| limit.values[input]);
        let (Some(one), Some(another), None) = (ends.next(), ends.next(), ends.next()) else { return None };
        let way = (another - one).abs() % TAU;
        let [faster, slower] = [way.min(TAU - way), way.max(TAU - way)];
        (of != input && faster > 1e-9).then_some(TimeRatio { of, ratio: slower / faster })
    };
    let outputs = (0..motion.ranges.len()).filter(|of| is_grounded(mechanism, &motion.ranges[*of]));
    outputs.filter_map(ratio).collect()
}

/// Links between two pins that push a body that the ground guides, away from the input.
fn pushing(mechanism: &Mechanism, input: &Range) -> Vec<Pushing> {
    let joints: Vec<(JointId, &Joint)> =
        mechanism.joints.iter().enumerate().map(|(index, joint)| (JointId(index), joint)).collect();
    let on = |frame: Frame| joints.iter().filter(move |(_, joint)| other(joint, frame).is_some());
    let is_pin = |joint: &Joint| joint.holds() && joint.form.keeps_place && !joint.form.keeps_orientation;
    let first = joint_of(input).and_then(|joint| other(&mechanism.joints[joint.0], Frame::Ground));
    let away = distances(mechanism, first);
    let mut found = Vec::new();
    for index in 0..mechanism.bodies.len() {
        let link = Frame::Body(crate::model::BodyId(index));
        let ends: Vec<_> = on(link).collect();
        let [(a, one), (b, another)] = ends[..] else { continue };
        if !is_pin(one) || !is_pin(another) {
            continue;
        }
        for (near, far) in [((*a, one), (*b, another)), ((*b, another), (*a, one))] {
            let (from, driven) = (other(near.1, link), other(far.1, link));
            let (Some(from), Some(driven)) = (from, driven) else { continue };
            let (Frame::Body(before), Frame::Body(behind)) = (from, driven) else { continue };
            let [Some(before), Some(behind)] = [before, behind].map(|body| away[body.0]) else { continue };
            if before >= behind {
                continue;
            }
            if let Some(guide) = on(driven).find_map(|(id, joint)| guide(mechanism, *id, joint)) {
                found.push(Pushing { link, driven, pins: [near.0, far.0], guide });
            }
        }
    }
    found
}

/// Joints from a frame to each body by the shortest way, the ground left out; none where there is no way.
fn distances(mechanism: &Mechanism, from: Option<Frame>) -> Vec<Option<usize>> {
    let mut found = vec![None; mechanism.bodies.len()];
    let mut reached: Vec<Frame> = from.into_iter().collect();
    for count in 0.. {
        let fresh = |frame: &Frame| matches!(frame, Frame::Body(body) if found[body.0].is_none());
        reached.retain(fresh);
        if reached.is_empty() {
            break;
        }
        for frame in &reached {
            if let Frame::Body(body) = frame {
                found[body.0] = Some(count);
            }
        }
        let next =
            mechanism.joints.iter().flat_map(|joint| reached.iter().filter_map(|one| other(joint, *one)));
        reached = next.collect();
    }
    found
}

/// What a joint to the ground lets a body do.
fn guide(mechanism: &Mechanism, id: JointId, joint: &Joint) -> Option<Guide> {
    other(joint, Frame::Ground)?;
    if joint.form.keeps_place && !joint.form.keeps_orientation {
        return Some(Guide::Pin(id));
    }
    // The rail is the ground's.
    let is_slide =
        joint.form.keeps_orientation && joint.form.travels.len() == 1 && joint.form.angles.is_empty();
    if !is_slide || joint.first.frame != Frame::Ground {
        return None;
    }
    let defaults = mechanism.defaults();
    let [x, y, _] = joint.directions.first()?.each_ref().map(|x| crate::model::fold::evaluate(x, &defaults));
    unit([x?, y?]).map(Guide::Slide)
}

fn unit([x, y]: [f64; 2]) -> Option<[f64; 2]> {
    let size = libm::sqrt(x * x + y * y);
    (size > 0.0).then(|| [x / size, y / size])
}

/// sin μ at a position, with a sign that changes where it passes zero.
fn sine(pins: &[Pin], pushing: &Pushing) -> Option<f64> {
    let at = |joint: JointId| pins.iter().find(|pin| pin.joint == joint).map(|pin| pin.at);
    let [near, far] = pushing.pins.map(at);
    let (near, far) = (near?, far?);
    let along = unit([far[0] - near[0], far[1] - near[1]])?;
    let way = match pushing.guide {
        Guide::Slide(way) => way,
        Guide::Pin(joint) => {
            let center = at(joint)?;
            unit([center[1] - far[1], far[0] - center[0]])?
        }
    };
    Some((along[0] * way[0] + along[1] * way[1]).clamp(-1.0, 1.0))
}

fn transmission(
    mechanism: &Mechanism,
    point: &mut Point,
    followed: &mut Followed,
    input: usize,
    pushing: &Pushing,
) -> Option<Transmission> {
    let mut measure = |place: &Place| sine(&pins(mechanism, point, &place.q), pushing);
    let sines: Vec<f64> = followed.places.iter().map_while(&mut measure).collect();
    if sines.len() < followed.places.len() || sines.is_empty() {
        return None;
    }
    let [(least, at_least), (most, at_most)] = [-1.0, 1.0].map(|sign| {
        let better = |a: &usize, b: &usize| (sign * sines[*a].abs()).total_cmp(&(sign * sines[*b].abs()));
        let best = (0..sines.len()).max_by(better).unwrap_or(0);
        let (place, path) = (&followed.places[best], &mut followed.path);
        let mut found = (sines[best], place.clone());
        let mut value = |distance: f64| {
            let there = path.step(place, distance)?;
            Some((measure(&there)?, there))
        };
        if sign < 0.0
            && let Some(zero) = zero(sines[best], &mut value)
        {
            found = (0.0, zero);
        } else {
            furthest(sign, &mut value, &mut found);
        }
        let (sine, at) = found;
        // As continued from the place beside it; of what turns fully, from 0 to a turn.
        let change = at.values[input] - place.values[input];
        let turn = |angle: f64| TAU * (angle / TAU).round();
        let jump = if followed.motion.ranges[input].angular { turn(change) } else { 0.0 };
        let mut value = at.values[input] - jump + followed.stated[input];
        if followed.motion.ranges[input].turns {
            value = value.rem_euclid(TAU);
        }
        (libm::asin(sine.abs()), value)
    });
    Some(Transmission {
        link: mechanism.frame_name(pushing.link).to_string(),
        driven: mechanism.frame_name(pushing.driven).to_string(),
        least,
        most,
        at: [at_least, at_most],
    })
}

/// Where the sine changes its sign beside a place: regula falsi, the older end's value halved where it stays (the Illinois rule).
fn zero(here: f64, value: &mut impl FnMut(f64) -> Option<(f64, Place)>) -> Option<Place> {
    for side in [-AROUND, AROUND] {
        let (mut near, mut far) = ((0.0, here), (side, value(side)?.0));
        if near.1 * far.1 > 0.0 {
            continue;
        }
        for _ in 0..ROUNDS {
            let at = (near.0 * far.1 - far.0 * near.1) / (far.1 - near.1);
            let (between, there) = value(at)?;
            if between.abs() < ZERO {
                return Some(there);
            }
            if between * far.1 < 0.0 {
                near = far;
            } else {
                near.1 *= 0.5;
            }
            far = (at, between);
        }
    }
    None
}

/// The least or largest size between the neighbours, by golden sections.
fn furthest(sign: f64, value: &mut impl FnMut(f64) -> Option<(f64, Place)>, found: &mut (f64, Place)) {
    let ratio = 0.5 * (libm::sqrt(5.0) - 1.0);
    let (mut from, mut to) = (-AROUND, AROUND);
    let mut at = |distance: f64| {
        let (sine, place) = value(distance)?;
        if sign * sine.abs() > sign * found.0.abs() {
            *found = (sine, place);
        }
        Some((distance, sign * sine.abs()))
    };
    let (Some(mut low), Some(mut high)) = (at(to - ratio * (to - from)), at(from + ratio * (to - from)))
    else {
        return;
    };
    for _ in 0..ROUNDS {
        if low.1 > high.1 {
            (to, high) = (high.0, low);
            let Some(next) = at(to - ratio * (to - from)) else { return };
            low = next;
        } else {
            (from, low) = (low.0, high);
            let Some(next) = at(from + ratio * (to - from)) else { return };
            high = next;
        }
    }
}
