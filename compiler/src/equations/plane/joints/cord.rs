//! Cord: a distance that can only pull. The same row as `distance`; its tension is λ L.

use super::PlanarJoint;
use crate::drawing::canvas::Pen;
use crate::drawing::plane::Symbol;
use crate::drawing::shapes::THIN;
use crate::forms::{Alone, Argument, Form, JointAxes, JointForm, Need, OfParticle, PLACES, Spans};
use crate::messages;
use crate::model::Frame;
use crate::units::Dimension;

pub static JOINT: PlanarJoint = PlanarJoint {
    form: JointForm {
        call: Form {
            word: "cord",
            elsewhere: &[],
            positional: PLACES,
            named: &[Argument::moving("length", Need::Always, Dimension::LENGTH).positive()],
        },
        holds: "the distance, which may depend on time, by pulling alone",
        angles: &[],
        travels: &[],
        freedoms: 2,
        keeps_place: false,
        keeps_orientation: false,
        axes: JointAxes::None,
        spans: Spans::Rod,
        only_pulls: true,
        of_particle: OfParticle::Any,
        alone: Alone::Otherwise,
        freer: &[],
        refuses: Some(|given| {
            let length = given.scalars.first().copied().flatten()?;
            (length <= 0.0).then(|| ("length", messages::distance_not_positive(given.name)))
        }),
    },
    rows: super::distance::rows,
    attach: None,
    symbol,
};

fn symbol(s: &mut Symbol) {
    s.before.line(s.first, s.second, Pen::Outline(THIN));
    for (at, on) in [(s.first, s.hinge.first_on), (s.second, s.hinge.second_on)] {
        if on == Frame::Ground {
            s.pin_support(at);
        }
    }
}
