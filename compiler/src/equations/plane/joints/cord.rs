//! Cord: a distance that can only pull. The same row as `distance`; its tension is λ L.

use super::PlanarJoint;
use super::distance::{FORM, rows};
use crate::drawing::canvas::Pen;
use crate::drawing::plane::Symbol;
use crate::drawing::shapes::THIN;
use crate::forms::{Form, JointForm};
use crate::model::Frame;

pub static JOINT: PlanarJoint = PlanarJoint {
    form: JointForm {
        call: Form { word: "cord", ..FORM.call },
        holds: "the distance, which may depend on time, by pulling alone",
        only_pulls: true,
        ..FORM
    },
    rows,
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
