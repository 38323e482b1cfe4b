//! Planar: Δ across z₁ and z₂ along z₁.

use super::{AXIS, Elementary, Ends, SpatialJoint};
use crate::drawing::canvas::Pen;
use crate::drawing::shapes::THIN;
use crate::drawing::space::Symbol;
use crate::equations::{JointRow, Laws};
use crate::forms::{Alone, Bearing, Form, Freer, JointAxes, JointForm, OfParticle, PLACES, Spans};

pub static JOINT: SpatialJoint = SpatialJoint {
    form: JointForm {
        call: Form { word: "planar", elsewhere: &[], positional: PLACES, named: &[AXIS] },
        holds: "the second place in the plane of the first, and the axis across it",
        angles: &[["angle", "rate"]],
        travels: &[["travel_1", "speed_1"], ["travel_2", "speed_2"]],
        freedoms: 3,
        keeps_place: false,
        keeps_orientation: false,
        axes: JointAxes::Common,
        spans: Spans::Nothing,
        only_pulls: false,
        of_particle: OfParticle::Neither,
        alone: Alone::Otherwise,
        freer: &[Freer { turns: 2, shifts: 0, joint: "point_on_plane" }],
        bearing: Some(Bearing::Face),
        refuses: None,
    },
    motions: Some(&[
        Elementary::Slide { axis: 0, which: 0 },
        Elementary::Slide { axis: 1, which: 1 },
        Elementary::Turn { frame: 0, which: 0 },
    ]),
    rows,
    symbol,
};

pub fn rows(_: &Laws, ends: &Ends) -> Vec<JointRow> {
    let mut rows = vec![ends.on_plane()];
    rows.extend(ends.parallel());
    rows
}

fn symbol(s: &mut Symbol) {
    s.table();
    s.disk(1.6, Pen::Outline(THIN));
}
