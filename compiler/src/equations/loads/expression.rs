//! A force along an expression of positions: it does on the mechanism the work that it does along the expression.

use super::{LoadKind, LoadTerms, along, no_rotors};
use crate::equations::laws::Laws;
use crate::forms::{Acts, Form, Law, LoadForm, Positional};
use crate::model::Load;

pub static LOAD: LoadKind = LoadKind {
    form: LoadForm {
        call: Form { word: "along", elsewhere: &[], positional: &[Positional::Expression], named: &[] },
        instead: Some("what it acts along is an expression of positions, such as `distance(a.end, b.end)`"),
        meant: None,
        title: "force along an expression",
        exerts: "a force or torque that increases the expression, by virtual work: Q = Jᵀ f, J its derivative",
        exported: "along",
        on: &[Acts::Expression],
        law: Law::Conjugate,
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
    // It stands at no place.
    symbol: |_| {},
};

fn terms<'g>(laws: &Laws<'g>, load: &Load) -> LoadTerms<'g> {
    let force = laws.value(&load.law[0]);
    along(&laws.jet(load.expression()), force)
}
