//! A torsion spring on a body of the plane or between the bodies of a joint, over any number of turns.

use super::{LoadKind, LoadTerms, restoring};
use crate::drawing::load::Symbol;
use crate::equations::laws::Laws;
use crate::forms::{Acts, Argument, Form, Law, LoadForm, Need, Positional};
use crate::model::Load;
use crate::units::Dimension;

pub static LOAD: LoadKind = LoadKind {
    form: LoadForm {
        call: Form {
            word: "torsion_spring",
            elsewhere: &[],
            positional: &[Positional::Rotor],
            named: &[
                Argument::scalar("stiffness", Need::Always, Dimension::TORQUE).restoring(),
                Argument::scalar("angle", Need::Never, Dimension::ANGLE),
                Argument::scalar("damping", Need::Never, Dimension::ANGULAR_DAMPING).restoring(),
                // One that has it is read as a limit.
                Argument::scalar("play", Need::Never, Dimension::ANGLE),
            ],
        },
        instead: None,
        meant: None,
        title: "torsion spring",
        exerts: "a torque by the angle beyond that at rest, and by its rate",
        exported: "torsion_spring",
        on: &[Acts::Rotor],
        law: Law::None,
        stores: true,
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
    counted: |load| load.rotors().collect(),
    symbol,
};

/// Torque −k (θ − θ₀) − c ω, V = ½ k (θ − θ₀)².
fn terms<'g>(laws: &Laws<'g>, load: &Load) -> LoadTerms<'g> {
    let rotors = load.rotors();
    rotors.fold(LoadTerms::none(laws), |sum, rotor| {
        let angle = laws.angle(rotor);
        let [k, rest, c] = [0, 1, 2].map(|which| laws.value(load.value(which)));
        let deflection = angle.value() - rest;
        sum.and(restoring(&angle, deflection, k, c))
    })
}

fn symbol(s: &mut Symbol) {
    let end = s.effort.ends[0];
    s.spiral(end.at, end.axis);
}
