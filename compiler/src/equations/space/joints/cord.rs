//! Cord: a distance that can only pull. The same row as `distance`; its tension is λ L.

use super::SpatialJoint;
use crate::drawing::canvas::Pen;
use crate::drawing::shapes::THIN;
use crate::drawing::space::Symbol;
use crate::forms::{Alone, Argument, Form, JointAxes, JointForm, Need, OfParticle, PLACES, Spans};
use crate::messages;
use crate::units::Dimension;

pub static JOINT: SpatialJoint = SpatialJoint {
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
        freedoms: 5,
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
    // It leaves no frame to measure from.
    motions: None,
    rows: super::distance::rows,
    symbol,
};

fn symbol(s: &mut Symbol) {
    let [first, second] = [s.hinge.first, s.hinge.second].map(|end| s.view.spot(end));
    s.before.line(first, second, Pen::Outline(THIN));
}
