//! Beams within the reach of their theory: slender ones, whose shapes suit what holds them, and where nothing stiffens them none that a
//! turn or a thrust would soften or stiffen by much. What holds a beam's direction at its start is in `clamps`, by how much it is
//! turned and pressed in `strain`, how fast drivers turn it later in `driven`.

mod clamps;
mod driven;
mod strain;

pub use strain::{Strain, strains};

use super::assemble::Assembly;
use super::rules::at_defaults;
use super::warnings::Wanted;
use crate::beams::{Shapes, Way};
use crate::diagnostics::{Diagnostics, Lint};
use crate::equations::{Equations, Linear};
use crate::messages;
use crate::model::{Beam, Body, BodyId, Coordinate, Expr, Frame, JointId, Mechanism, Place, Side};
use crate::solve::Solved;
use std::f64::consts::TAU;

/// Lengths in radii of gyration √(I/A) below which shear and the turning of sections are seen (Timoshenko).
const SLENDER: f64 = 20.0;
/// Of the first clamped frequency and of Euler's load: squares of a tenth matter from here on.
const MUCH: f64 = 1.0 / 3.0;

/// Frequencies of modes by themselves are as expected.
pub(super) fn frequencies(mechanism: &Mechanism, errors: &mut Diagnostics) {
    let defaults = mechanism.defaults();
    for expected in &mechanism.expect.frequencies {
        let body = &mechanism.bodies[expected.body.0];
        let Some(deforms) = &body.deforms else { continue };
        let found = deforms.rates(&body.mass, &defaults)[expected.mode] / TAU;
        let holds = match expected.side {
            Side::Above => found >= expected.bound,
            Side::Below => found <= expected.bound,
        };
        if !holds {
            let mode = format!("{}.{}", body.name.text, deforms.mode_name(expected.mode));
            let above = expected.side == Side::Above;
            errors.error(expected.span, messages::frequency_missed(&mode, found, above, expected.bound));
        }
    }
}

/// Beams do not start further off their axes than they are long.
pub(super) fn starts(mechanism: &Mechanism, errors: &mut Diagnostics) {
    for start in mechanism.start.iter().filter(|start| !start.rate) {
        let Coordinate::Mode(body, _, false) = &start.coordinate else { continue };
        let body = &mechanism.bodies[body.0];
        let (Some(beam), Some(value)) = (body.beam(), at_defaults(mechanism, &start.value)) else { continue };
        if value.abs() > beam.slender.length {
            let message = messages::bent_too_far(&start.text, value, &body.name.text, beam.slender.length);
            errors.error(start.span, message);
        }
    }
}

/// Places of beams are off the axes of their frames at the start as far as is expected.
pub fn deflections(
    mechanism: &Mechanism,
    equations: &Equations,
    assembly: &Assembly,
    errors: &mut Diagnostics,
) {
    for expected in &mechanism.expect.deflections {
        let body = &mechanism.bodies[expected.body.0];
        let Some(beam) = body.beam() else { continue };
        let coordinate = |mode: usize| {
            let own = Linear::Mode(expected.body, mode);
            let index = equations.layout.linear.iter().position(|linear| *linear == own);
            index.map_or(0.0, |index| assembly.q[index])
        };
        let modes = beam.slender.modes.iter().zip(beam.slender.values(expected.x)).enumerate();
        let along = |axis: usize| -> f64 {
            let own = modes.clone().filter(|(_, (mode, _))| mode.way.bends() && mode.way.axis() == axis);
            own.map(|(index, (_, value))| value * coordinate(index)).sum()
        };
        let found = libm::hypot(along(1), along(2));
        let holds = match expected.side {
            Side::Above => found >= expected.bound,
            Side::Below => found <= expected.bound,
        };
        if !holds {
            let above = expected.side == Side::Above;
            let bent = mechanism.deflected.iter().any(|(body, _)| *body == expected.body);
            let message = messages::deflection_missed(
                &expected.text,
                &body.name.text,
                found,
                above,
                expected.bound,
                bent,
            );
            errors.error(expected.span, message);
        }
    }
}

/// A beam is long in its thickness.
pub(super) fn beams_are_slender(mechanism: &Mechanism, wanted: &mut Wanted) {
    for body in &mechanism.bodies {
        let Some(beam) = body.beam() else { continue };
        let Some(ratio) = slenderness(mechanism, beam) else { continue };
        if ratio < SLENDER && has_bending(beam) && beam.slender.turning.is_none() {
            wanted.push(Lint::Slender, body.name.span, messages::thick_beam(&body.name.text, ratio, SLENDER));
        }
    }
}

/// The length of a beam in radii of gyration √(I/A) of its section, the largest of those about which it bends.
fn slenderness(mechanism: &Mechanism, beam: &Beam) -> Option<f64> {
    let rigidity = |way: Way| at_defaults(mechanism, beam.rigidity(way));
    let stiffest = ways(beam).filter_map(rigidity).fold(0.0, f64::max);
    Some(beam.slender.length / (stiffest / rigidity(Way::Axial)?).sqrt())
}

/// Shapes that are clamped at the start belong to a beam that something clamps there.
pub(super) fn clamps_hold(mechanism: &Mechanism, wanted: &mut Wanted) {
    for (index, body) in mechanism.bodies.iter().enumerate() {
        let Some(beam) = body.beam() else { continue };
        let shapes = beam.slender.shapes;
        let clamped = matches!(shapes, Shapes::Clamped | Shapes::Static) && has_bending(beam);
        let twists = shapes != Shapes::Free && beam.has(Way::Torsion);
        if !clamped && !twists {
            continue;
        }
        if let [(id, place)] = at(mechanism, index, beam.slender.from)[..]
            && let Some(axis) = clamps::loose(mechanism, BodyId(index), beam, id, place)
        {
            let joint = &mechanism.joints[id.0];
            let message = messages::clamp_that_turns(
                &body.name.text,
                shapes.word(),
                &joint.name.text,
                [joint.form.call.word, axis],
                joint.form.angles.len() == 1,
            );
            wanted.push(Lint::Slender, body.name.span, message);
        }
    }
}

/// What the ground clamps has shapes that are clamped, and at the end that it clamps.
pub(super) fn clamps_are_known(mechanism: &Mechanism, wanted: &mut Wanted) {
    for (index, body) in mechanism.bodies.iter().enumerate() {
        let Some(beam) = body.beam().filter(|beam| has_bending(beam)) else { continue };
        let [start, end] = [0.0, beam.slender.length].map(|x| at(mechanism, index, beam.slender.from + x));
        let clamps = |(id, _): &&(JointId, &Place)| {
            let joint = &mechanism.joints[id.0];
            let grounded =
                [&joint.first, &joint.second].into_iter().any(|place| place.frame == Frame::Ground);
            joint.form.keeps_orientation && grounded
        };
        let (name, shapes) = (&body.name.text, beam.slender.shapes);
        let (at_start, at_end) = (start.iter().find(clamps), end.iter().find(clamps));
        let said = |joint: &(JointId, &Place)| &mechanism.joints[joint.0.0].name.text;
        let message = match (shapes, at_start, at_end) {
            (Shapes::Free, Some(joint), _) | (Shapes::Free, _, Some(joint)) => {
                messages::clamped_free_shapes(name, said(joint))
            }
            (Shapes::Clamped | Shapes::Static, None, Some(joint)) if start.is_empty() => {
                messages::clamped_at_the_end(name, shapes.word(), said(joint))
            }
            _ => continue,
        };
        wanted.push(Lint::Slender, body.name.span, message);
    }
}

/// The joints at a point of a beam, each with its place there.
fn at(mechanism: &Mechanism, body: usize, x: f64) -> Vec<(JointId, &Place)> {
    let joints = mechanism.joints.iter().enumerate();
    let places = joints.flat_map(|(id, joint)| [(JointId(id), &joint.first), (JointId(id), &joint.second)]);
    places.filter(|(_, place)| x_of(place, body) == Some(x)).collect()
}

/// Warnings of beams without stiffening that turn fast at the start or are driven so later, or are pressed together at the start, as far as no input
/// decides that.
pub fn unstiffened(
    mechanism: &Mechanism,
    equations: &Equations,
    solved: &Solved,
    assembly: &Assembly,
    found: &mut Diagnostics,
) {
    let is_soft = |body: &Body| {
        let covered = mechanism.allowed.covers(Lint::Stiffening, body.name.span);
        let is_soft = |beam: &Beam| has_bending(beam) && beam.slender.shortenings.is_empty();
        !covered && body.beam().is_some_and(is_soft)
    };
    if !mechanism.bodies.iter().any(is_soft) {
        return;
    }
    for strain in strains(mechanism, equations, solved, assembly) {
        let body = &mechanism.bodies[strain.body.0];
        if !is_soft(body) {
            continue;
        }
        let (name, span) = (&body.name.text, body.name.span);
        let much = MUCH * strain.natural;
        if strain.rate > much {
            let message = messages::fast_beam(name, strain.rate, strain.natural, None);
            found.warning(Lint::Stiffening, span, message);
        } else if let Some([time, rate]) = driven::beyond(mechanism, strain.body, much) {
            let message = messages::fast_beam(name, rate, strain.natural, Some(time));
            found.warning(Lint::Stiffening, span, message);
        } else if let Some([thrust, euler]) = strain.pressed
            && !strain.by_inputs
            && thrust > MUCH * euler
        {
            found.warning(Lint::Stiffening, span, messages::pressed_beam(name, thrust, euler));
        }
    }
}

/// What joints in the first half and in the second half press the beam together with.
fn thrusts(
    mechanism: &Mechanism,
    body: usize,
    beam: &Beam,
    along: impl Fn(usize) -> f64,
) -> [Option<f64>; 2] {
    let middle = beam.slender.from + 0.5 * beam.slender.length;
    let mut ends = [None, None];
    for (index, joint) in mechanism.joints.iter().enumerate() {
        // The reaction is what the second place gets.
        for (place, sign) in [(&joint.first, -1.0), (&joint.second, 1.0)] {
            let Some(x) = x_of(place, body) else { continue };
            let (end, inward) = if x < middle { (0, 1.0) } else { (1, -1.0) };
            *ends[end].get_or_insert(0.0) += inward * sign * along(index);
        }
    }
    ends
}

/// Where on a beam a place is, if it is on it.
fn x_of(place: &Place, body: usize) -> Option<f64> {
    match &place.at[0] {
        Expr::Number(x) if place.frame == Frame::Body(BodyId(body)) => Some(*x),
        _ => None,
    }
}

fn has_bending(beam: &Beam) -> bool {
    beam.slender.modes.iter().any(|mode| mode.way.bends())
}

/// The ways in which a beam bends.
fn ways(beam: &Beam) -> impl Iterator<Item = Way> + '_ {
    let bends = |way: &Way| beam.slender.modes.iter().any(|mode| mode.way == *way);
    Way::of(beam.space).iter().copied().filter(|way| way.bends()).filter(bends)
}
