//! Cord: a distance that can only pull. The same row as `distance`; its tension is λ L.

use super::SpatialJoint;
use super::distance::{FORM, rows};
use crate::drawing::canvas::Pen;
use crate::drawing::shapes::THIN;
use crate::drawing::space::Symbol;
use crate::forms::{Form, JointForm};

pub static JOINT: SpatialJoint = SpatialJoint {
    form: JointForm {
        call: Form { word: "cord", ..FORM.call },
        holds: "the distance, which may depend on time, by pulling alone",
        only_pulls: true,
        ..FORM
    },
    // It leaves no frame to measure from.
    motions: None,
    rows,
    symbol,
};

fn symbol(s: &mut Symbol) {
    let [first, second] = [s.hinge.first, s.hinge.second].map(|end| s.view.spot(end));
    s.before.line(first, second, Pen::Outline(THIN));
}
