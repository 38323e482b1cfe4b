//! Point on line: n̂·Δ = 0 with n̂ normal to the line, which the first body carries.

use super::{Carried, Ends, JointRow, Pair, PlanarJoint, vector};
use crate::drawing::canvas::Pen;
use crate::drawing::plane::Symbol;
use crate::drawing::shapes::{THIN, away, ground_line, heading, rectangle, shifted};
use crate::equations::laws::Laws;
use crate::equations::plane::kinematics::{FrameId, Placement};
use crate::forms::row::NORMAL;
use crate::forms::{Alone, Bearing, Form, JointAxes, JointForm, OfParticle, Positional, Spans};
use crate::model::Frame;
use crate::symbolic::On;

pub static JOINT: PlanarJoint = PlanarJoint {
    form: JointForm {
        call: Form {
            word: "point_on_line",
            elsewhere: &[],
            positional: &[Positional::Line, Positional::Place],
            named: &[],
        },
        holds: "the place on the line",
        angles: &[["angle", "rate"]],
        travels: &[["travel", "speed"]],
        freedoms: 2,
        keeps_place: false,
        keeps_orientation: false,
        axes: JointAxes::OfFirst,
        spans: Spans::Line,
        only_pulls: false,
        of_particle: OfParticle::Any,
        alone: Alone::Otherwise,
        freer: &[],
        bearing: Some(Bearing::Point),
        refuses: None,
    },
    rows,
    attach: Some(attach),
    symbol,
};

pub fn rows(laws: &Laws, ends: &Ends) -> Vec<JointRow> {
    let (frame, normal) = normal(laws, ends);
    vec![JointRow::new(&NORMAL, laws.plane().project(frame, normal, &ends.delta.bare))]
}

pub fn attach<'g>(laws: &Laws<'g>, carried: Carried<'g>) -> Placement {
    let along = laws.pair_of(carried.joint.direction(0)).normalized();
    // The line's body is the parent, or else the carried body itself.
    let (frame, along) = if carried.child_is_second {
        (carried.parent.frame, along.turned(carried.parent.offset))
    } else {
        (carried.frame, along)
    };
    let far = carried.pivot.clone() + carried.slide(0, frame, along);
    carried.at(far, vector::unturned(laws.g))
}

/// n̂ and the frame in whose axes it is given.
fn normal<'g>(laws: &Laws<'g>, ends: &Ends<'g>) -> (FrameId, On<'g, Pair>) {
    laws.plane().carried_by(ends.first, laws.pair_of(ends.joint.direction(0)).normalized().perpendicular())
}

/// The line is a slot in which a pin carries a block.
fn symbol(s: &mut Symbol) {
    let (from, to, pin, unit) = (s.first, shifted(s.first, 1.0, s.way), s.second, s.unit);
    let Some(e) = heading(from, to) else { return };
    let position = (pin[0] - from[0]) * e[0] + (pin[1] - from[1]) * e[1];
    let is_ground = s.hinge.first_on == Frame::Ground;
    // In a bar it stays within the bar.
    let (beyond, aside) = if is_ground { (3.0, 1.5) } else { (0.0, 0.4) };
    let least = position.min(0.0) - beyond * unit;
    let most = position.max(away(from, to)) + beyond * unit;
    let n = [-e[1], e[0]];
    for side in [-aside, aside] {
        let at = |along: f64| shifted(shifted(from, along, e), side * unit, n);
        if is_ground {
            let into = if side < 0.0 { [e[1], -e[0]] } else { n };
            ground_line(&mut s.before, at(least), at(most), into, unit);
        } else {
            s.before.line(at(least), at(most), Pen::Line(0.8));
        }
    }
    let block = rectangle(pin, e, 2.4 * unit, 1.5 * unit);
    s.before.path(&block, true, Pen::Outline(THIN));
    s.before.circle(pin, 0.8 * unit, Pen::Outline(THIN));
}
