//! Point on line: Δ along z₁, the line's direction.

use super::{Elementary, Ends, SpatialJoint};
use crate::drawing::shapes::plate;
use crate::drawing::space::Symbol;
use crate::drawing::vector::along;
use crate::equations::{JointRow, Laws};
use crate::forms::{Alone, Bearing, Form, JointAxes, JointForm, OfParticle, Positional, Spans};

pub static JOINT: SpatialJoint = SpatialJoint {
    form: JointForm {
        call: Form {
            word: "point_on_line",
            elsewhere: &[],
            positional: &[Positional::Line, Positional::Place],
            named: &[],
        },
        holds: "the place on the line",
        angles: &[],
        travels: &[["travel", "speed"]],
        freedoms: 4,
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
    motions: Some(&[Elementary::Slide { axis: 2, which: 0 }, Elementary::Ball]),
    rows,
    symbol,
};

pub fn rows(_: &Laws, ends: &Ends) -> Vec<JointRow> {
    ends.on_axis()
}

fn symbol(s: &mut Symbol) {
    let ends = [s.hinge.first, along(s.hinge.first, 1.0, s.hinge.axis)].map(|end| s.view.spot(end));
    plate(&mut s.behind, &ends, 0.5 * s.unit);
    s.ball(s.at, s.unit);
}
