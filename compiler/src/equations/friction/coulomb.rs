//! Coulomb's friction, made smooth: μ N v/√(v·v + v_s²), García de Jalón & Bayo, *Kinematic and Dynamic Simulation of Multibody Systems*,
//! 10.1. Where it would stick it creeps, on a slope of angle α with v_s t/√(1 − t²), t = tan α/μ.

use super::bearing::{LENGTH, PRELOAD, RADIUS, SHOULDER};
use super::{direction, effort, terms};
use crate::equations::laws::Laws;
use crate::equations::loads::{LoadKind, no_rotors};
use crate::forms::{Acts, Argument, Form, Law, LoadForm, Need, Value};
use crate::model::Load;
use crate::symbolic::Scalar;
use crate::units::Dimension;

pub static LOAD: LoadKind = LoadKind {
    form: LoadForm {
        call: Form {
            word: "coulomb",
            elsewhere: &[],
            positional: &[],
            named: &[
                Argument::of("coefficient", Need::Never, Value::Law(Dimension::ONE)).not_negative(),
                Argument::of("speed", Need::Always, SPEED).positive(),
                RADIUS,
                LENGTH,
                SHOULDER,
                PRELOAD,
                Argument::scalar("force", Need::Never, Dimension::FORCE).not_negative(),
                Argument::scalar("torque", Need::Never, Dimension::TORQUE).not_negative(),
            ],
        },
        instead: None,
        meant: None,
        title: "Coulomb friction",
        exerts: "a force or torque against the sliding in a joint, by the force that presses its surfaces together",
        exported: "coulomb",
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

/// v_s.
pub(super) const SPEED: Value = Value::Along { effort: false, way: 1, time: -1 };

fn resistance<'g>(laws: &Laws<'g>, load: &Load, v: &[Scalar<'g>], _: &[Scalar<'g>]) -> Vec<[Scalar<'g>; 2]> {
    let [coefficient, speed, force, torque] =
        ["coefficient", "speed", "force", "torque"].map(|name| laws.value(load.named(name)));
    direction(v, speed).into_iter().map(|s| [coefficient * s, (force + torque) * s]).collect()
}
