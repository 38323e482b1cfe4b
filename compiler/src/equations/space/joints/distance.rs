//! Distance (massless rod with two balls): (Δ·Δ − L²)/2 = 0, polynomial, with multiplier force/length.

use super::{Ends, SpatialJoint};
use crate::drawing::shapes::plate;
use crate::drawing::space::Symbol;
use crate::equations::{JointRow, Laws};
use crate::forms::row::DISTANCE;
use crate::forms::{Alone, Argument, Form, JointAxes, JointForm, Need, OfParticle, PLACES, Spans};
use crate::messages;
use crate::units::Dimension;

pub const FORM: JointForm = JointForm {
    call: Form {
        word: "distance",
        elsewhere: &[],
        positional: PLACES,
        named: &[Argument::moving("length", Need::Always, Dimension::LENGTH).positive()],
    },
    holds: "the distance, which may depend on time",
    angles: &[],
    travels: &[],
    freedoms: 5,
    keeps_place: false,
    keeps_orientation: false,
    axes: JointAxes::None,
    spans: Spans::Rod,
    only_pulls: false,
    of_particle: OfParticle::Any,
    alone: Alone::Otherwise,
    freer: &[],
    bearing: None,
    refuses: Some(|given| {
        let length = given.scalars.first().copied().flatten()?;
        (length <= 0.0).then(|| ("length", messages::distance_not_positive(given.name)))
    }),
};

pub static JOINT: SpatialJoint = SpatialJoint {
    form: FORM,
    // It leaves no frame to measure from.
    motions: None,
    rows,
    symbol,
};

pub fn rows(laws: &Laws, ends: &Ends) -> Vec<JointRow> {
    let gap = ends.gap();
    let length = laws.jet(ends.joint.scalar(0));
    let sum =
        gap.iter().fold(-(0.5 * (&length * &length)), |sum, component| sum + 0.5 * (component * component));
    vec![JointRow::new(&DISTANCE, sum)]
}

fn symbol(s: &mut Symbol) {
    let ends = [s.hinge.first, s.hinge.second].map(|end| s.view.spot(end));
    plate(&mut s.before, &ends, 0.45 * s.unit);
    ends.into_iter().for_each(|end| s.ball(end, 0.7 * s.unit));
}
