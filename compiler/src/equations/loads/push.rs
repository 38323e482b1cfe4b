//! A force along the travel of a joint, on the second's body, and opposite on the first.

use super::{LoadKind, LoadTerms, along, force, no_rotors};
use crate::drawing::load::Symbol;
use crate::equations::laws::Laws;
use crate::forms::{Acts, Law, LoadForm};
use crate::model::Load;
use crate::units::Dimension;

pub static LOAD: LoadKind = LoadKind {
    form: LoadForm {
        call: force::CALL,
        instead: None,
        meant: Some(|written| written.is_name && !written.is_directed && !written.has_components),
        title: "force along the travel",
        exerts: "a force along the travel of the joint, on its second body, and opposite on the first",
        exported: "push",
        on: &[Acts::Travel],
        law: Law::Value(Dimension::FORCE),
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
    let force = laws.value(&load.law[0]);
    along(&laws.kinematics().travel(laws, load.travel(), 0), force)
}

fn symbol(s: &mut Symbol) {
    let [sign, ..] = s.effort.law;
    let end = s.effort.ends[0];
    s.arrow(end.at, end.axis.map(|x| sign * x));
}
