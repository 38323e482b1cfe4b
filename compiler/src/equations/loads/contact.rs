//! A contact: a force along each of its gaps where it is closed, which its law says (`model::contacts`). It is written by its own
//! statement and is among no loads that a user may name.

use super::{LoadKind, LoadTerms, along, no_rotors};
use crate::equations::friction;
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
        holds: false,
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
/// gap is below zero and the force above. Dry friction has none of both.
pub fn guards(laws: &Laws) -> Vec<[Node; 2]> {
    let of = |load: &Load| -> Vec<[Node; 2]> {
        if load.form.holds {
            return load.ungated.iter().map(|none| [laws.value(none).bare; 2]).collect();
        }
        let guards = load.along().zip(&load.ungated);
        guards.map(|(gap, force)| [laws.value(gap).bare, laws.value(force).bare]).collect()
    };
    laws.mechanism.loads.iter().flat_map(of).collect()
}

/// Of each gate of rigid contacts, in the same order: the rate ġ of the gap, its second time derivative at v̇ = 0, and the restitution; of dry
/// friction the sliding, its derivative at v̇ = 0, and nothing.
pub fn strikes(laws: &Laws) -> Vec<[Node; 3]> {
    let of = |load: &Load| -> Vec<[Node; 3]> {
        if load.form.holds {
            let zero = laws.g.zero().bare;
            return friction::slidings(laws, load)
                .into_iter()
                .map(|[rate, bias]| [rate, bias, zero])
                .collect();
        }
        let each = |(gap, restitution)| {
            let (gap, restitution) = (laws.jet(gap), laws.value(restitution));
            [gap.rate().bare, gap.bias().bare, restitution.bare]
        };
        load.along().zip(&load.restitutions).map(each).collect()
    };
    laws.mechanism.loads.iter().flat_map(of).collect()
}

/// μ_s and μ_k of each gate, where any is of the dry friction of a contact; zeros of the others.
pub fn grips(laws: &Laws) -> Vec<[Node; 2]> {
    let loads = laws.mechanism.loads.iter();
    if !loads.clone().any(|load| load.form.holds && load.contact().is_some()) {
        return Vec::new();
    }
    let of = |load: &Load| {
        let shares = if load.form.holds { friction::shares(laws, load) } else { [laws.g.zero().bare; 2] };
        vec![shares; load.ungated.len()]
    };
    loads.flat_map(of).collect()
}

/// What the dry friction of each joint holds and slides with, in the order of the gates, which are all of joints then.
pub fn bounds(laws: &Laws) -> Vec<[Node; 2]> {
    let sticking = laws.mechanism.loads.iter().filter(|load| load.sticks());
    sticking.flat_map(|load| friction::bounds(laws, load)).collect()
}
