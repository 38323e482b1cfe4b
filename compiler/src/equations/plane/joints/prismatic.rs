//! Prismatic along â of the first body, n̂ = â turned by a right angle: n̂·Δ = 0 and sin(θ₂ − θ₁ − angle) = 0.

use super::fixed::direction_row;
use super::{Carried, Ends, JointRow, PlanarJoint, point_on_line};
use crate::drawing::canvas::Pen;
use crate::drawing::plane::Symbol;
use crate::drawing::shapes::{THIN, ground_line, heading, plate, rectangle, shifted};
use crate::equations::laws::Laws;
use crate::equations::plane::kinematics::Placement;
use crate::forms::{
    Alone, Argument, Bearing, Form, Freer, JointAxes, JointForm, Need, OfParticle, PLACES, Spans,
};
use crate::model::Frame;
use crate::units::Dimension;

pub static JOINT: PlanarJoint = PlanarJoint {
    form: JointForm {
        call: Form {
            word: "prismatic",
            elsewhere: &["slider", "translational"],
            positional: PLACES,
            named: &[
                Argument::direction("axis", Need::Always),
                Argument::scalar("angle", Need::Never, Dimension::ANGLE),
            ],
        },
        holds: "the second place on the axis through the first, and orientation",
        angles: &[],
        travels: &[["travel", "speed"]],
        freedoms: 1,
        keeps_place: false,
        keeps_orientation: true,
        axes: JointAxes::OfFirst,
        spans: Spans::Rail,
        only_pulls: false,
        of_particle: OfParticle::Neither,
        alone: Alone::Slides,
        freer: &[Freer { turns: 1, shifts: 0, joint: "point_on_line" }],
        bearing: Some(Bearing::Rail),
        refuses: None,
    },
    rows,
    attach: Some(attach),
    symbol,
};

pub fn rows(laws: &Laws, ends: &Ends) -> Vec<JointRow> {
    let mut rows = point_on_line::rows(laws, ends);
    rows.push(direction_row(laws, ends));
    rows
}

pub fn attach<'g>(laws: &Laws<'g>, carried: Carried<'g>) -> Placement {
    let offset = carried.kept(laws.pair(carried.joint.scalar(0)));
    // The axis is given in the first body's axes; parent and child share one frame.
    let first = if carried.child_is_second { carried.parent.offset } else { offset.bare };
    let along = laws.pair_of(carried.joint.direction(0)).normalized().turned(first);
    let far = carried.pivot.clone() + carried.slide(0, carried.parent.frame, along);
    carried.at(far, offset)
}

/// The rail is the first body's, the block the second's.
fn symbol(s: &mut Symbol) {
    let (first, second, unit) = (s.first, s.second, s.unit);
    let e = heading([0.0; 2], s.way).unwrap_or([1.0, 0.0]);
    let n = if e[0] >= 0.0 { [-e[1], e[0]] } else { [e[1], -e[0]] };
    let far = (second[0] - first[0]) * e[0] + (second[1] - first[1]) * e[1];
    let (least, most) = match s.hinge.is_grounded() {
        true => (far - 9.0 * unit, far + 9.0 * unit),
        false => (far.min(0.0) - 7.0 * unit, far.max(0.0) + 7.0 * unit),
    };
    let rail = |from: f64, aside: f64| shifted(shifted(first, from, e), aside, n);
    let on_ground = s.hinge.first_on == Frame::Ground;
    if on_ground {
        let below = 1.8 * unit;
        ground_line(&mut s.behind, rail(least, below), rail(most, below), n, unit);
    } else {
        plate(&mut s.behind, &[rail(least, 0.0), rail(most, 0.0)], 0.5 * unit);
    }
    let block = rectangle(second, e, 2.8 * unit, 1.8 * unit);
    s.before.path(&block, true, Pen::Outline(THIN));
    if on_ground {
        s.before.path(&block, true, Pen::Tint(0.0));
    } else {
        // What slides through it is seen.
        s.before.line(shifted(second, -2.8 * unit, e), shifted(second, 2.8 * unit, e), Pen::Line(0.8));
    }
    if s.hinge.second_on == Frame::Ground {
        let (a, b) = (shifted(second, 1.8 * unit, n), 2.8 * unit);
        ground_line(&mut s.before, shifted(a, -b, e), shifted(a, b, e), n, unit);
    }
}
