//! A torque on a body in space, along the axes of the world.

use crate::drawing::load::Symbol;
use crate::equations::laws::Laws;
use crate::equations::loads::{LoadKind, LoadTerms, TORQUE, law, no_rotors, together};
use crate::forms::{Acts, Law, LoadForm};
use crate::model::{Load, Subject};
use crate::units::Dimension;

pub static LOAD: LoadKind = LoadKind {
    form: LoadForm {
        call: TORQUE,
        instead: None,
        meant: Some(|written| written.has_components),
        title: "torque",
        exerts: "a torque on the body, in world axes",
        exported: "torque",
        on: &[Acts::Body],
        law: Law::Components(Dimension::TORQUE),
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
    let components = law(laws, load);
    let bodies = load.on.iter().filter_map(|subject| match subject {
        Subject::Body(body) => Some(laws.kinematics().turning(*body)),
        Subject::Place(_)
        | Subject::Rotor(_)
        | Subject::Travel(_)
        | Subject::Bearing(..)
        | Subject::Joint(_)
        | Subject::Touches(_)
        | Subject::Expression(..)
        | Subject::Toothing(_) => None,
    });
    bodies.fold(LoadTerms::none(laws), |sum, turning| sum.and(together(laws, &turning, &components)))
}

fn symbol(s: &mut Symbol) {
    s.turn(s.effort.ends[0].at, s.effort.law);
}
