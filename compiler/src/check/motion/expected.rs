//! The expectations of the motion in `expect`, against the motion.

use super::messages::{self, Outside};
use super::{End, Motion, Range, efforts, follow, reach};
use crate::check::assemble::{Assembly, Point, pins};
use crate::check::beyond;
use crate::diagnostics::Diagnostics;
use crate::equations::Equations;
use crate::model::{
    BodyId, Coordinate, Frame, Joint, JointId, Mechanism, MotionExpected, Rotor, Turning, Within,
};
use std::f64::consts::TAU;

/// Follows the motion if `expect` asks about it; silent where it is as expected. Warns of tables that the motion leaves, and of contacts that
/// it never closes.
pub fn check(
    mechanism: &Mechanism,
    equations: &Equations,
    assembly: &Assembly,
    warnings: &mut Diagnostics,
    errors: &mut Diagnostics,
) {
    let expected = &mechanism.expect.motion;
    efforts::check(mechanism, equations, assembly, errors);
    let Some(span) = expected.span() else { return };
    let tables = beyond::asked(mechanism);
    let of_tables: Vec<_> = tables.iter().filter_map(|asked| Some((asked, asked.coordinate()?))).collect();
    let mut watched = coordinates(expected);
    let first_of_tables = watched.len();
    watched.extend(of_tables.iter().map(|(_, coordinate)| (*coordinate).clone()));
    let followed = match follow(mechanism, equations, assembly, &watched) {
        Ok(followed) => followed,
        Err(unswept) => return errors.error(span, messages::unswept(unswept)),
    };
    reach::warn(mechanism, equations, assembly, &followed, warnings);
    let motion = followed.motion;
    for ((asked, _), range) in of_tables.iter().zip(&motion.ranges[first_of_tables..]) {
        asked.warn(mechanism, [range.from, range.to], true, warnings);
    }
    let (turning, within) = motion.ranges.split_at(expected.rotates.len());
    for (index, (expected, range)) in expected.rotates.iter().zip(turning).enumerate() {
        turns(mechanism, equations, assembly, &motion, (index, range), expected, errors);
    }
    let first = expected.rotates.len();
    for (index, (expected, range)) in expected.within.iter().zip(within).enumerate() {
        stays(&motion, (first + index, range), expected, errors);
    }
    if let Some(span) = expected.no_singularity {
        let no_loops = equations.rows.len() == mechanism.drivers.len();
        match motion.singular.first() {
            Some(singular) => {
                let links = of_four_bar(mechanism, equations, assembly, None);
                let reference = &motion.ranges[motion.reference];
                errors.error(span, messages::singular_on_the_way(singular, reference, links));
            }
            None if motion.end == End::Closed || no_loops => {}
            None => errors.error(span, messages::undecided("no_singularity", &motion)),
        }
    }
}

fn coordinates(expected: &MotionExpected) -> Vec<Coordinate> {
    let rotates = expected.rotates.iter().map(|turning| Coordinate::Angle(turning.rotor));
    rotates.chain(expected.within.iter().map(|within| within.coordinate.clone())).collect()
}

fn turns(
    mechanism: &Mechanism,
    equations: &Equations,
    assembly: &Assembly,
    motion: &Motion,
    (index, range): (usize, &Range),
    expected: &Turning,
    errors: &mut Diagnostics,
) {
    if range.turns {
        return;
    }
    if motion.end != End::Closed {
        return errors
            .error(expected.span, messages::undecided(&format!("rotates = {}", expected.name), motion));
    }
    let mut in_line: Vec<&[String]> = Vec::new();
    for limit in motion.limits.iter().filter(|limit| limit.of == index && !limit.in_line.is_empty()) {
        if !in_line.contains(&limit.in_line.as_slice()) {
            in_line.push(&limit.in_line);
        }
    }
    let joint = match expected.rotor {
        Rotor::Joint(joint, _) => Some(joint),
        Rotor::Body(body) => on_ground(mechanism, body),
    };
    let links = joint.and_then(|joint| of_four_bar(mechanism, equations, assembly, Some(joint)));
    errors.error(expected.span, messages::turns_back(&expected.name, range, &in_line, links));
}

fn stays(motion: &Motion, (index, range): (usize, &Range), expected: &Within, errors: &mut Diagnostics) {
    // Angles are the same a turn further: that turn is meant which brings both ranges nearest.
    let between = 0.5 * (expected.from + expected.to - range.from - range.to);
    let turns = if range.angular { TAU * (between / TAU).round() } else { 0.0 };
    let (from, to) = (range.from + turns, range.to + turns);
    let rounding = 1e-9 * (expected.to - expected.from);
    if from >= expected.from - rounding && to <= expected.to + rounding {
        if motion.end != End::Closed {
            errors.error(expected.span, messages::undecided(&expected.text, motion));
        }
        return;
    }
    // Where it is furthest out.
    let low = expected.from - from > to - expected.to;
    let extreme = if low { range.from } else { range.to };
    let limits = motion.limits.iter().filter(|limit| limit.of == index);
    let nearest = limits.min_by(|a, b| (a.value - extreme).abs().total_cmp(&(b.value - extreme).abs()));
    let reference = &motion.ranges[motion.reference];
    let at = nearest.filter(|_| motion.reference != index).map(|limit| (reference, limit.reference));
    let unlimited = motion.end == End::Unlimited && !range.angular;
    let outside = Outside { low, from, to, turns: range.turns, unlimited, at };
    errors.error(expected.span, messages::leaves_range(expected, &outside));
}

/// The joint between a body and the ground.
fn on_ground(mechanism: &Mechanism, body: BodyId) -> Option<JointId> {
    let ends = |joint: &Joint| [joint.first.frame, joint.second.frame];
    let pair = [Frame::Ground, Frame::Body(body)];
    let index =
        mechanism.joints.iter().position(|joint| pair.iter().all(|frame| ends(joint).contains(frame)));
    index.map(JointId)
}

/// Names and lengths of the links of the four-bar that a joint, or any, belongs to.
fn of_four_bar(
    mechanism: &Mechanism,
    equations: &Equations,
    assembly: &Assembly,
    joint: Option<JointId>,
) -> Option<[(String, f64); 4]> {
    let mut point = Point::at_defaults(mechanism, equations, &assembly.phases);
    let pins = pins::pins(mechanism, &mut point, &assembly.q);
    let joints = pins.iter().map(|pin| pin.joint).filter(|own| joint.is_none_or(|joint| joint == *own));
    let links = joints.collect::<Vec<_>>().into_iter().find_map(|joint| pins::four_bar(&pins, joint))?;
    Some(links.map(|(frame, length)| (mechanism.frame_name(frame).to_string(), length)))
}
