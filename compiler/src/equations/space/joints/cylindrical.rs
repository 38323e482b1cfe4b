//! Cylindrical: Δ along z₁ and z₂ along z₁.

use super::{AXIS, Elementary, Ends, SpatialJoint};
use crate::drawing::space::Symbol;
use crate::equations::{JointRow, Laws};
use crate::forms::{Alone, Bearing, Form, Freer, JointAxes, JointForm, OfParticle, PLACES, Spans};

pub static JOINT: SpatialJoint = SpatialJoint {
    form: JointForm {
        call: Form { word: "cylindrical", elsewhere: &[], positional: PLACES, named: &[AXIS] },
        holds: "the second place on the axis through the first, and the axis",
        angles: &[["angle", "rate"]],
        travels: &[["travel", "speed"]],
        freedoms: 2,
        keeps_place: false,
        keeps_orientation: false,
        axes: JointAxes::Common,
        spans: Spans::Rail,
        only_pulls: false,
        of_particle: OfParticle::Neither,
        alone: Alone::TurnsAndSlides,
        freer: &[Freer { turns: 2, shifts: 0, joint: "point_on_line" }],
        bearing: Some(Bearing::Sleeve),
        refuses: None,
    },
    motions: Some(&[Elementary::Slide { axis: 2, which: 0 }, Elementary::Turn { frame: 0, which: 0 }]),
    rows,
    symbol,
};

pub fn rows(_: &Laws, ends: &Ends) -> Vec<JointRow> {
    let mut rows = ends.on_axis();
    rows.extend(ends.parallel());
    rows
}

pub(super) fn symbol(s: &mut Symbol) {
    s.rail();
    s.cylinder(1.4, 3.0);
}
