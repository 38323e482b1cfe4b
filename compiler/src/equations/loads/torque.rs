//! A torque, counter-clockwise, on a body of the plane, or about the axis of a joint on its second body and opposite on the
//! first.

use super::{LoadKind, LoadTerms, along, no_rotors};
use crate::drawing::load::Symbol;
use crate::equations::laws::Laws;
use crate::forms::{Acts, Form, Law, LoadForm, Positional};
use crate::model::Load;
use crate::units::Dimension;

/// `torque` about an axis, or on a body in space.
pub const CALL: Form = Form { word: "torque", elsewhere: &[], positional: &[Positional::Rotor], named: &[] };

pub static LOAD: LoadKind = LoadKind {
    form: LoadForm {
        call: CALL,
        instead: None,
        meant: None,
        title: "torque",
        exerts: "a torque on the body, or on the second body of the joint and opposite on the first",
        exported: "torque",
        on: &[Acts::Rotor],
        law: Law::Value(Dimension::TORQUE),
        stores: false,
        turns: false,
        owns: None,
        rubs: false,
        holds: false,
        effort: None,
        doubt: None,
    },
    terms,
    inner: None,
    effort: None,
    counted: no_rotors,
    symbol,
};

fn terms<'g>(laws: &Laws<'g>, load: &Load) -> LoadTerms<'g> {
    let torque = laws.value(&load.law[0]);
    let angles = load.rotors().map(|rotor| laws.angle(rotor));
    angles.fold(LoadTerms::none(laws), |sum, angle| sum.and(along(&angle, torque)))
}

fn symbol(s: &mut Symbol) {
    let [sign, ..] = s.effort.law;
    let end = s.effort.ends[0];
    s.turn(end.at, end.axis.map(|x| sign * x));
}
