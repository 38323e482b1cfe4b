//! Revolute: p₁ = p₂ and z₂ along z₁.

use super::{AXIS, Elementary, Ends, SpatialJoint};
use crate::drawing::space::Symbol;
use crate::equations::{JointRow, Laws};
use crate::forms::{Alone, Bearing, Form, Freer, JointAxes, JointForm, OfParticle, PLACES, Spans};

pub static JOINT: SpatialJoint = SpatialJoint {
    form: JointForm {
        call: Form {
            word: "revolute",
            elsewhere: &["hinge", "pin", "continuous"],
            positional: PLACES,
            named: &[AXIS],
        },
        holds: "position and the axis",
        angles: &[["angle", "rate"]],
        travels: &[],
        freedoms: 1,
        keeps_place: true,
        keeps_orientation: false,
        axes: JointAxes::Common,
        spans: Spans::Nothing,
        only_pulls: false,
        of_particle: OfParticle::Neither,
        alone: Alone::Turns,
        freer: &[
            Freer { turns: 1, shifts: 0, joint: "universal" },
            Freer { turns: 2, shifts: 0, joint: "spherical" },
            Freer { turns: 0, shifts: 1, joint: "cylindrical" },
            Freer { turns: 2, shifts: 1, joint: "point_on_line along its axis" },
        ],
        bearing: Some(Bearing::Pin),
        refuses: None,
    },
    motions: Some(&[Elementary::Turn { frame: 0, which: 0 }]),
    rows,
    symbol,
};

pub fn rows(_: &Laws, ends: &Ends) -> Vec<JointRow> {
    let mut rows = ends.together();
    rows.extend(ends.parallel());
    rows
}

fn symbol(s: &mut Symbol) {
    s.cylinder(1.3, 2.0);
}
