//! Point on plane: Δ across z₁.

use super::{AXIS, Ends, SpatialJoint};
use crate::drawing::space::Symbol;
use crate::equations::{JointRow, Laws};
use crate::forms::{Alone, Bearing, Form, JointAxes, JointForm, OfParticle, PLACES, Spans};

pub static JOINT: SpatialJoint = SpatialJoint {
    form: JointForm {
        call: Form { word: "point_on_plane", elsewhere: &[], positional: PLACES, named: &[AXIS] },
        holds: "the second place in the plane of the first, across the axis",
        angles: &[],
        travels: &[],
        freedoms: 5,
        keeps_place: false,
        keeps_orientation: false,
        axes: JointAxes::Common,
        spans: Spans::Nothing,
        only_pulls: false,
        of_particle: OfParticle::Second,
        alone: Alone::Otherwise,
        freer: &[],
        bearing: Some(Bearing::Spot),
        refuses: None,
    },
    // It leaves five freedoms, and a free body has six.
    motions: None,
    rows,
    symbol,
};

pub fn rows(_: &Laws, ends: &Ends) -> Vec<JointRow> {
    vec![ends.on_plane()]
}

fn symbol(s: &mut Symbol) {
    s.table();
    s.ball(s.at, s.unit);
}
