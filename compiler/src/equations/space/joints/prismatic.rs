//! Prismatic: Δ along z₁ and E₁ parallel to E₂.

use super::{AXIS, Elementary, Ends, SpatialJoint};
use crate::drawing::canvas::Pen;
use crate::drawing::shapes::{THIN, across};
use crate::drawing::space::Symbol;
use crate::equations::{JointRow, Laws};
use crate::forms::{Alone, Bearing, Form, Freer, JointAxes, JointForm, OfParticle, PLACES, Spans};

pub static JOINT: SpatialJoint = SpatialJoint {
    form: JointForm {
        call: Form {
            word: "prismatic",
            elsewhere: &["slider", "translational"],
            positional: PLACES,
            named: &[AXIS],
        },
        holds: "the second place on the axis through the first, and orientation",
        angles: &[],
        travels: &[["travel", "speed"]],
        freedoms: 1,
        keeps_place: false,
        keeps_orientation: true,
        axes: JointAxes::Common,
        spans: Spans::Rail,
        only_pulls: false,
        of_particle: OfParticle::Neither,
        alone: Alone::Slides,
        freer: &[
            Freer { turns: 1, shifts: 0, joint: "cylindrical" },
            Freer { turns: 3, shifts: 0, joint: "point_on_line" },
        ],
        bearing: Some(Bearing::Rail),
        refuses: None,
    },
    motions: Some(&[Elementary::Slide { axis: 2, which: 0 }]),
    rows,
    symbol,
};

pub fn rows(_: &Laws, ends: &Ends) -> Vec<JointRow> {
    let mut rows = ends.on_axis();
    rows.extend(ends.parallel());
    rows.push(ends.unturned());
    rows
}

fn symbol(s: &mut Symbol) {
    s.rail();
    let [u, v] = across(s.hinge.axis);
    s.block([(2.6, s.hinge.axis), (1.3, u), (1.3, v)], Pen::Outline(THIN));
}
