//! Distance (massless rod with two pins): (Δ·Δ − L²)/2 = 0, polynomial, with multiplier force/length.

use super::{Ends, JointRow, PlanarJoint};
use crate::drawing::canvas::Pen;
use crate::drawing::plane::Symbol;
use crate::drawing::shapes::{THIN, plate};
use crate::equations::laws::Laws;
use crate::forms::row::DISTANCE;
use crate::forms::{Alone, Argument, Form, JointAxes, JointForm, Need, OfParticle, PLACES, Spans};
use crate::messages;
use crate::model::Frame;
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
    freedoms: 2,
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

pub static JOINT: PlanarJoint = PlanarJoint { form: FORM, rows, attach: None, symbol };

pub fn rows(laws: &Laws, ends: &Ends) -> Vec<JointRow> {
    let [x, y] = ends.in_world(laws);
    let length = laws.jet(ends.joint.scalar(0));
    let (xx, yy, ll) = (0.5 * (&x * &x), 0.5 * (&y * &y), 0.5 * (&length * &length));
    vec![JointRow::new(&DISTANCE, xx + yy - ll)]
}

fn symbol(s: &mut Symbol) {
    plate(&mut s.before, &[s.first, s.second], 0.45 * s.unit);
    for (at, on) in [(s.first, s.hinge.first_on), (s.second, s.hinge.second_on)] {
        if on == Frame::Ground {
            s.pin_support(at);
        }
        s.before.circle(at, 0.8 * s.unit, Pen::Outline(THIN));
    }
}
