//! A contact: a force along each of its gaps where it is closed, which its law says (`model::contacts`). It is written by its own
//! statement and is among no loads that a user may name.

use super::{LoadKind, LoadTerms, along, no_rotors};
use crate::equations::laws::Laws;
use crate::forms::{Acts, Form, Law, LoadForm};
use crate::model::Load;
use crate::symbolic::Node;

pub static LOAD: LoadKind = LoadKind {
    form: LoadForm {
        call: Form { word: "contact", elsewhere: &[], positional: &[], named: &[] },
        instead: None,
        meant: None,
        title: "contact",
        exerts: "a force along the gap where that is closed, never a pull",
        exported: "contact",
        on: &[Acts::Expression],
        law: Law::Conjugate,
        stores: false,
        turns: false,
        owns: None,
        rubs: false,
        effort: None,
        doubt: None,
    },
    terms,
    inner: None,
    effort: None,
    counted: no_rotors,
    // Its surfaces are drawn.
    symbol: |_| {},
};

/// Q += Jᵀ F with J the gradient of the gap, and power F ġ.
fn terms<'g>(laws: &Laws<'g>, load: &Load) -> LoadTerms<'g> {
    load.along()
        .zip(&load.law)
        .fold(LoadTerms::none(laws), |sum, (gap, force)| sum.and(along(&laws.jet(gap), laws.value(force))))
}

/// Of each gate that is held over a step, in their order: the gap, and the force without the gate. The gate is that of the state where the
/// gap is below zero and the force above.
pub fn guards(laws: &Laws) -> Vec<[Node; 2]> {
    let contacts = laws.mechanism.loads.iter();
    let of = |load: &Load| -> Vec<[Node; 2]> {
        let guards = load.along().zip(&load.ungated);
        guards.map(|(gap, force)| [laws.value(gap).bare, laws.value(force).bare]).collect()
    };
    contacts.flat_map(of).collect()
}

/// Of each gap of a rigid contact, in the same order: its rate ġ, its second time derivative at v̇ = 0, and the restitution.
pub fn strikes(laws: &Laws) -> Vec<[Node; 3]> {
    let of = |load: &Load| -> Vec<[Node; 3]> {
        let Some(restitution) = &load.restitution else { return Vec::new() };
        let restitution = laws.value(restitution).bare;
        let each = |gap| {
            let gap = laws.jet(gap);
            [gap.rate().bare, gap.bias().bare, restitution]
        };
        load.along().map(each).collect()
    };
    laws.mechanism.loads.iter().flat_map(of).collect()
}
