//! A shaft between two angles: what twists it, and a gap in which it turns freely.

use super::{LoadKind, LoadTerms, along};
use crate::drawing::load::Symbol;
use crate::equations::jet::Moving;
use crate::equations::laws::Laws;
use crate::forms::{Acts, Argument, Form, Law, LoadForm, Need, Positional};
use crate::model::Load;
use crate::symbolic::Scalar;
use crate::units::Dimension;

pub static LOAD: LoadKind = LoadKind {
    form: LoadForm {
        call: Form {
            word: "shaft",
            elsewhere: &[],
            positional: &[Positional::Rotor, Positional::Rotor],
            named: &[
                Argument::scalar("ratio", Need::Always, Dimension::ONE),
                Argument::scalar("stiffness", Need::Always, Dimension::TORQUE).restoring(),
                Argument::scalar("damping", Need::Never, Dimension::ANGULAR_DAMPING).restoring(),
                Argument::scalar("backlash", Need::Never, Dimension::ANGLE).not_negative(),
            ],
        },
        instead: None,
        meant: None,
        title: "shaft",
        exerts: "a torque on the first by how far it is ahead of the ratio times the second, and the ratio times its opposite on that",
        exported: "shaft",
        on: &[Acts::Rotor, Acts::Rotor],
        law: Law::None,
        stores: true,
        turns: false,
        owns: None,
        rubs: false,
        holds: false,
        effort: Some("torque"),
        doubt: None,
    },
    terms,
    inner: None,
    effort: Some(torque),
    counted: |load| load.rotors().collect(),
    symbol,
};

/// u = θ₁ − r θ₂, with its rate.
fn twist<'g>(laws: &Laws<'g>, load: &Load) -> Moving<'g> {
    let angles: Vec<_> = load.rotors().map(|rotor| laws.angle(rotor)).collect();
    match &angles[..] {
        [first, second] => first - laws.value(load.value(0)) * second,
        _ => laws.still(laws.g.zero()),
    }
}

/// What of u is beyond the gap, on either side of which is half of the backlash.
fn beyond<'g>(laws: &Laws<'g>, load: &Load, u: Scalar<'g>) -> Scalar<'g> {
    let backlash = laws.value(load.value(3));
    if backlash.is_zero() {
        return u;
    }
    let half = 0.5 * backlash;
    u - u.min(half).max(-half)
}

/// k f(u) + c u̇, by which the first is held back.
fn torque<'g>(laws: &Laws<'g>, load: &Load) -> Scalar<'g> {
    let u = twist(laws, load);
    let [k, c] = [1, 2].map(|which| laws.value(load.value(which)));
    k * beyond(laws, load, u.value()) + c * u.rate()
}

/// V = ½ k f(u)².
fn terms<'g>(laws: &Laws<'g>, load: &Load) -> LoadTerms<'g> {
    let u = twist(laws, load);
    let stretch = beyond(laws, load, u.value());
    let potential = super::elastic_energy(laws.value(load.value(1)), stretch);
    LoadTerms { potential, ..along(&u, -torque(laws, load)) }
}

fn symbol(s: &mut Symbol) {
    s.line();
}
