//! Dry friction of rigid contacts: it holds with whatever is asked of it up to μ_s N, and slides with μ_k N against the sliding, Coulomb's law as it
//! is. Its force is a number of the state, along what slides: what it is, and when it changes between both, follows in the run from all
//! that touches (`simulation/rigid.rs` of the runtime; Pfeiffer and Glocker, *Multibody Dynamics with Unilateral Contacts*, 1996, 5).

use super::{slips, touching};
use crate::equations::laws::Laws;
use crate::equations::loads::{LoadKind, LoadTerms, along, no_rotors};
use crate::forms::{Acts, Argument, Form, Law, LoadForm, Need};
use crate::model::{Load, LoadId};
use crate::symbolic::{Node, Scalar};
use crate::units::Dimension;

pub static LOAD: LoadKind = LoadKind {
    form: LoadForm {
        call: Form {
            word: "dry",
            elsewhere: &[],
            positional: &[],
            named: &[
                Argument::scalar("static", Need::Always, Dimension::ONE).restoring(),
                Argument::scalar("kinetic", Need::Never, Dimension::ONE).restoring(),
            ],
        },
        instead: None,
        meant: None,
        title: "dry friction",
        exerts: "what keeps the surfaces of a rigid contact from sliding, up to a share of what presses them, and a share of it where they slide",
        exported: "dry",
        on: &[Acts::Bearing],
        law: Law::None,
        stores: false,
        turns: false,
        owns: None,
        rubs: true,
        holds: true,
        effort: None,
        doubt: None,
    },
    terms,
    inner: None,
    effort: Some(|laws, load| laws.g.sum(forces(laws, load))),
    counted: no_rotors,
    symbol: |_| {},
};

/// Of each gap of the contact.
fn forces<'g>(laws: &Laws<'g>, load: &Load) -> Vec<Scalar<'g>> {
    let id = laws.mechanism.loads.iter().position(|it| std::ptr::eq(it, load)).map(LoadId);
    let gates = id.into_iter().flat_map(|id| (0..load.ungated.len()).map(move |which| (id, which)));
    gates.map(|(id, which)| laws.gate(id, which)).collect()
}

fn terms<'g>(laws: &Laws<'g>, load: &Load) -> LoadTerms<'g> {
    slips(laws, load).iter().zip(forces(laws, load)).fold(LoadTerms::none(laws), |sum, (slip, force)| {
        slip.along.iter().fold(sum, |sum, (coordinate, _)| sum.and(along(coordinate, force)))
    })
}

/// Of each gap: how fast the surfaces slide, and the derivative of that at v̇ = 0.
pub fn slidings(laws: &Laws, load: &Load) -> Vec<[Node; 2]> {
    let Some(contact) = load.contact() else { return Vec::new() };
    let all = laws.mechanism.loads[contact.0].slides.iter();
    all.map(|sliding| touching::moved(laws, sliding).map(|it| it.bare)).collect()
}

/// μ_s and μ_k of a dry friction.
pub fn shares(laws: &Laws, load: &Load) -> [Node; 2] {
    ["static", "kinetic"].map(|name| laws.value(load.named(name)).bare)
}
