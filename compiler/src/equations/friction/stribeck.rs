//! Friction that is less where surfaces slide faster, by Stribeck's curve: N (μ_k + (μ_s − μ_k) e^{−v·v/v_t²}) v/√(v·v + v_s²) + c v, c in
//! N s/m or N m s. Armstrong-Hélouvry, Dupont, Canudas de Wit, Automatica 30 (1994) 1083.

use super::bearing::{LENGTH, PRELOAD, RADIUS, SHOULDER};
use super::coulomb::SPEED;
use super::{direction, effort, terms};
use crate::equations::laws::Laws;
use crate::equations::loads::{LoadKind, no_rotors};
use crate::forms::{Acts, Argument, Form, Law, LoadForm, Need, Value};
use crate::model::Load;
use crate::symbolic::{Scalar, Unary};
use crate::units::Dimension;

pub static LOAD: LoadKind = LoadKind {
    form: LoadForm {
        call: Form {
            word: "stribeck",
            elsewhere: &[],
            positional: &[],
            named: &[
                Argument::of("static", Need::Always, Value::Law(Dimension::ONE)).not_negative(),
                Argument::of("kinetic", Need::Always, Value::Law(Dimension::ONE)).not_negative(),
                Argument::of("transition", Need::Always, SPEED).positive(),
                Argument::of("speed", Need::Always, SPEED).positive(),
                Argument::of("viscous", Need::Never, VISCOUS).not_negative(),
                RADIUS,
                LENGTH,
                SHOULDER,
                PRELOAD,
            ],
        },
        instead: None,
        meant: None,
        title: "Stribeck friction",
        exerts: "a force or torque against the sliding in a joint, by the force that presses its surfaces together, less where they slide faster",
        exported: "stribeck",
        on: &[Acts::Bearing],
        law: Law::None,
        stores: false,
        turns: false,
        owns: None,
        rubs: true,
        holds: false,
        effort: None,
        doubt: None,
    },
    terms: |laws, load| terms(laws, load, resistance),
    inner: None,
    effort: Some(|laws, load| effort(laws, load, resistance)),
    counted: no_rotors,
    symbol: |_| {},
};

/// c.
pub(super) const VISCOUS: Value = Value::Along { effort: true, way: -1, time: 1 };

fn resistance<'g>(laws: &Laws<'g>, load: &Load, v: &[Scalar<'g>], _: &[Scalar<'g>]) -> Vec<[Scalar<'g>; 2]> {
    let [speed, viscous] = ["speed", "viscous"].map(|name| laws.value(load.named(name)));
    let coefficient = coefficient(laws, load, v);
    let directions = direction(v, speed);
    v.iter().zip(directions).map(|(v, s)| [coefficient * s, viscous * *v]).collect()
}

/// μ_k + (μ_s − μ_k) e^{−v·v/v_t²}.
pub(super) fn coefficient<'g>(laws: &Laws<'g>, load: &Load, v: &[Scalar<'g>]) -> Scalar<'g> {
    let [most, least, transition] =
        ["static", "kinetic", "transition"].map(|name| laws.value(load.named(name)));
    let inverse = transition.reciprocal();
    let square = laws.g.sum(v.iter().map(|v| (*v * inverse).square()));
    least + (most - least) * (-square).unary(Unary::Exp)
}
