//! A damper between two places: a spring without stiffness and length.

use super::{LoadKind, LoadTerms, no_rotors, spring};
use crate::drawing::load::Symbol;
use crate::equations::laws::Laws;
use crate::forms::{Acts, Argument, Form, Law, LoadForm, Need, PLACES};
use crate::model::{Expr, Load};
use crate::units::Dimension;

pub static LOAD: LoadKind = LoadKind {
    form: LoadForm {
        call: Form {
            word: "damper",
            elsewhere: &[],
            positional: PLACES,
            named: &[Argument::scalar("damping", Need::Always, Dimension::DAMPING).restoring()],
        },
        instead: Some("between the bodies of a joint write `torsion_spring(joint, …)`"),
        meant: None,
        title: "damper",
        exerts: "a tension by the rate of the distance of the places",
        exported: "spring",
        on: &[Acts::Place, Acts::Place],
        law: Law::None,
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

/// Tension c l̇.
fn terms<'g>(laws: &Laws<'g>, load: &Load) -> LoadTerms<'g> {
    let none = Expr::Number(0.0);
    spring::pull(laws, load, &none, &none, load.value(0))
}

fn symbol(s: &mut Symbol) {
    s.coil(false, s.effort.values[0] != [0.0; 3]);
}
