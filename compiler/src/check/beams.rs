//! Beams within the reach of their theory: slender ones, whose shapes suit what holds them, and where nothing stiffens them none that a
//! turn or a thrust would soften or stiffen by much. What holds a beam's direction at its start is in `clamps`.

mod clamps;

use super::assemble::{Ancestry, Assembly, Point};
use super::rules::at_defaults;
use super::warnings::Wanted;
use crate::beams::{Shapes, Way};
use crate::diagnostics::{Diagnostics, Lint};
use crate::equations::Equations;
use crate::messages;
use crate::model::{Beam, Body, BodyId, Expr, Frame, JointId, Mechanism, Place, Side, Space};
use crate::solve::Solved;
use std::f64::consts::{PI, TAU};

/// Lengths in radii of gyration √(I/A) below which shear and the turning of sections are seen (Timoshenko).
const SLENDER: f64 = 20.0;
/// Of the first clamped frequency and of Euler's load: squares of a tenth matter from here on.
const MUCH: f64 = 1.0 / 3.0;
/// The first root of the clamped beam, squared.
const CLAMPED: f64 = 1.875_104_068_711_961_1 * 1.875_104_068_711_961_1;

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

/// A beam is long in its thickness.
pub(super) fn beams_are_slender(mechanism: &Mechanism, wanted: &mut Wanted) {
    for body in &mechanism.bodies {
        let Some(beam) = body.beam() else { continue };
        let axial = at_defaults(mechanism, beam.rigidity(Way::Axial));
        let stiffest =
            ways(beam).filter_map(|way| at_defaults(mechanism, beam.rigidity(way))).fold(0.0, f64::max);
        let Some(axial) = axial else { continue };
        let ratio = beam.slender.length / (stiffest / axial).sqrt();
        if ratio < SLENDER && has_bending(beam) {
            wanted.push(Lint::Slender, body.name.span, messages::thick_beam(&body.name.text, ratio, SLENDER));
        }
    }
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

/// The joints at a point of a beam, each with its place there.
fn at(mechanism: &Mechanism, body: usize, x: f64) -> Vec<(JointId, &Place)> {
    let joints = mechanism.joints.iter().enumerate();
    let places = joints.flat_map(|(id, joint)| [(JointId(id), &joint.first), (JointId(id), &joint.second)]);
    places.filter(|(_, place)| x_of(place, body) == Some(x)).collect()
}

/// Warnings of beams without stiffening that turn fast or are pressed together at the start, as far as no input decides that.
pub fn unstiffened<'m>(
    mechanism: &'m Mechanism,
    equations: &Equations,
    solved: &Solved,
    assembly: &Assembly,
    found: &mut Diagnostics,
) {
    let is_soft = |body: &'m Body| -> Option<&'m Beam> {
        let beam = body.beam()?;
        let covered = mechanism.allowed.covers(Lint::Stiffening, body.name.span);
        (has_bending(beam) && beam.slender.shortenings.is_empty() && !covered).then_some(beam)
    };
    if !mechanism.bodies.iter().any(|body| is_soft(body).is_some()) {
        return;
    }
    let mut point = Point::at_start(mechanism, equations, assembly);
    let index1 = &solved.index1;
    let results = || index1.acceleration.iter().chain(&index1.lambda).copied();
    point.evaluate(&Ancestry::of(equations, results()));
    let values =
        |nodes: &[crate::symbolic::Node]| nodes.iter().map(|node| point.get(*node)).collect::<Vec<_>>();
    let (acceleration, lambda) = (values(&index1.acceleration), values(&index1.lambda));
    point.set(&equations.symbols.acceleration, &acceleration);
    point.set(&equations.symbols.lambda, &lambda);
    let motions = equations.motions.iter().flat_map(|motion| motion.flat());
    let reactions = equations.reactions.iter().flatten().copied();
    point.evaluate(&Ancestry::of(equations, motions.chain(reactions)));
    let by_inputs = results().any(|node| equations.takes_inputs(node));
    for (index, body) in mechanism.bodies.iter().enumerate() {
        let Some(beam) = is_soft(body) else { continue };
        let value = |expr: &Expr| at_defaults(mechanism, expr);
        let softest = ways(beam).filter_map(|way| value(beam.rigidity(way))).reduce(f64::min);
        let (Some(bending), Some(mass)) = (softest, value(&body.mass)) else { continue };
        let length = beam.slender.length;
        let name = &body.name.text;
        // Across the axis: in the plane there is no other rate.
        let rates = equations.motions[index].rate.iter().map(|node| point.get(*node)).collect::<Vec<_>>();
        let rate = match rates.as_slice() {
            [_, y, z] => y.hypot(*z),
            rates => rates.iter().fold(0.0, |sum: f64, rate| sum.hypot(*rate)),
        };
        let natural = CLAMPED * (bending / (mass * length.powi(3))).sqrt();
        if rate > MUCH * natural {
            found.warning(Lint::Stiffening, body.name.span, messages::fast_beam(name, rate, natural));
            continue;
        }
        // The axis of its frame: (cos, sin), or the first column of the matrix.
        let orientation = &equations.motions[index].orientation;
        let along: Vec<f64> = match mechanism.space {
            Space::Planar => orientation.iter().map(|node| point.get(*node)).collect(),
            Space::Spatial => orientation.iter().step_by(3).map(|node| point.get(*node)).collect(),
        };
        let ends = thrusts(mechanism, index, beam, |joint| {
            let force = equations.reactions[joint].iter();
            along.iter().zip(force).map(|(along, force)| along * point.get(*force)).sum()
        });
        let thrust = match ends {
            [Some(start), Some(end)] => 0.5 * (start + end),
            [Some(only), None] | [None, Some(only)] => only,
            [None, None] => continue,
        };
        // A column on a foot whose head sways, or one between two hinges.
        let one_end = ends.iter().flatten().count() == 1;
        let sways = one_end
            || clamps::sways(mechanism, BodyId(index), beam, &at(mechanism, index, beam.slender.from));
        let factor = if sways { 0.25 } else { 1.0 };
        let euler = factor * PI * PI * bending / (length * length);
        if !by_inputs && thrust > MUCH * euler {
            found.warning(Lint::Stiffening, body.name.span, messages::pressed_beam(name, thrust, euler));
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
