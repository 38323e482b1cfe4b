//! Spherical: p₁ = p₂.

use super::{Elementary, Ends, SpatialJoint};
use crate::drawing::space::Symbol;
use crate::equations::{JointRow, Laws};
use crate::forms::{Alone, Bearing, Form, JointAxes, JointForm, OfParticle, PLACES, Spans};

pub static JOINT: SpatialJoint = SpatialJoint {
    form: JointForm {
        call: Form {
            word: "spherical",
            elsewhere: &["ball", "ball_and_socket"],
            positional: PLACES,
            named: &[],
        },
        holds: "position",
        angles: &[],
        travels: &[],
        freedoms: 3,
        keeps_place: true,
        keeps_orientation: false,
        axes: JointAxes::None,
        spans: Spans::Nothing,
        only_pulls: false,
        of_particle: OfParticle::Any,
        alone: Alone::Turns,
        freer: &[],
        bearing: Some(Bearing::Ball),
        refuses: None,
    },
    motions: Some(&[Elementary::Ball]),
    rows,
    symbol,
};

pub fn rows(_: &Laws, ends: &Ends) -> Vec<JointRow> {
    ends.together()
}

fn symbol(s: &mut Symbol) {
    s.ball(s.at, s.unit);
}
