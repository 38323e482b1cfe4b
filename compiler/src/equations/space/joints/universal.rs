//! Universal: p₁ = p₂ and the first's axis across the second's.

use super::{Elementary, Ends, SpatialJoint};
use crate::drawing::canvas::Pen;
use crate::drawing::shapes::THIN;
use crate::drawing::space::Symbol;
use crate::equations::{JointRow, Laws};
use crate::forms::{
    Alone, Argument, Bearing, Form, Freer, JointAxes, JointForm, Need, OfParticle, PLACES, RowForm, Spans,
    degrees_between,
};
use crate::messages;

pub static JOINT: SpatialJoint = SpatialJoint {
    form: JointForm {
        call: Form {
            word: "universal",
            elsewhere: &["cardan", "hooke"],
            positional: PLACES,
            named: &[
                Argument::direction("axis", Need::Always),
                Argument::direction("second_axis", Need::Always),
            ],
        },
        holds: "position, and the axis of the first across the second axis, of the second",
        angles: &[["angle_1", "rate_1"], ["angle_2", "rate_2"]],
        travels: &[],
        freedoms: 2,
        keeps_place: true,
        keeps_orientation: false,
        axes: JointAxes::OfEach,
        spans: Spans::Nothing,
        only_pulls: false,
        of_particle: OfParticle::Neither,
        alone: Alone::Turns,
        freer: &[Freer { turns: 1, shifts: 0, joint: "spherical" }],
        bearing: Some(Bearing::Cross),
        refuses: Some(|given| {
            let [Some(axis), Some(second)] = given.directions[..] else { return None };
            let degrees = degrees_between(axis, second);
            ((degrees - 90.0).abs() > 1e-6).then(|| ("second_axis", messages::not_perpendicular(degrees)))
        }),
    },
    motions: Some(&[Elementary::Turn { frame: 0, which: 0 }, Elementary::Turn { frame: 1, which: 1 }]),
    rows,
    symbol,
};

/// The first axis is across the second.
static CROSS: RowForm = RowForm::direction("cross", "turns across both its axes");

pub fn rows(laws: &Laws, ends: &Ends) -> Vec<JointRow> {
    let mut rows = ends.together();
    let [a, b] = [0, 1].map(|which| laws.vector(ends.joint.direction(which)).normalized());
    let (a, b) = (ends.first.axes * a, ends.second.axes * b);
    rows.push(JointRow::new(&CROSS, ends.cosine(a, b)));
    rows
}

fn symbol(s: &mut Symbol) {
    s.before.circle(s.at, 1.9 * s.unit, Pen::Outline(THIN));
    for axis in [s.hinge.axis, s.hinge.second_axis] {
        let (from, to) = (s.beside(-1.9, axis), s.beside(1.9, axis));
        s.before.line(from, to, Pen::Line(2.0));
    }
}
