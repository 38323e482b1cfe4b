//! A force at a place, by its components along the axes of the world or by a direction and a value.

use super::{LoadKind, LoadTerms, law, no_rotors, together};
use crate::drawing::load::Symbol;
use crate::equations::laws::Laws;
use crate::forms::{Acts, Argument, Form, Law, LoadForm, Need, Positional};
use crate::model::Load;
use crate::units::Dimension;

/// `force` at a place, or along the travel of a joint.
pub const CALL: Form = Form {
    word: "force",
    elsewhere: &[],
    positional: &[Positional::Place],
    named: &[Argument::direction("direction", Need::Never)],
};

pub static LOAD: LoadKind = LoadKind {
    form: LoadForm {
        call: CALL,
        instead: None,
        meant: None,
        title: "force",
        exerts: "a force at the place, in world axes",
        exported: "force",
        on: &[Acts::Place],
        law: Law::Components(Dimension::FORCE),
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
    let position = laws.kinematics().world(laws, load.place(0));
    together(laws, &position, &law(laws, load))
}

fn symbol(s: &mut Symbol) {
    s.arrow(s.effort.ends[0].at, s.effort.law);
}
