//! Friction by bristles that bend before they slide, so that it sticks: with z their deflection and N what presses,
//!
//! ```text
//! F = N (σ₀ z + σ₁ ż) + c v,    ż = v − σ₀ |v| z/g(v),    g(v) = μ_k + (μ_s − μ_k) e^{−v·v/v_t²}
//! ```
//! σ₀ in 1/m and σ₁ in s/m, about a pin by rad. Canudas de Wit, Olsson, Åström, Lischinsky, IEEE Transactions on Automatic Control 40
//! (1995) 419, with F/N in place of F: surfaces that are pressed harder have stiffer bristles.

use super::bearing::{LENGTH, PRELOAD, RADIUS, SHOULDER};
use super::bristles::{self, DAMPING, STIFFNESS, length};
use super::coulomb::SPEED;
use super::stribeck::{VISCOUS, coefficient};
use super::{effort, terms};
use crate::equations::laws::Laws;
use crate::equations::loads::{Inner, LoadKind, no_rotors};
use crate::forms::{Acts, Argument, Form, Law, LoadForm, Need, Owned, Value};
use crate::model::Load;
use crate::symbolic::Scalar;
use crate::units::Dimension;

pub static LOAD: LoadKind = LoadKind {
    form: LoadForm {
        call: Form {
            word: "lugre",
            elsewhere: &[],
            positional: &[],
            named: &[
                Argument::of("static", Need::Always, Value::Law(Dimension::ONE)).positive(),
                Argument::of("kinetic", Need::Always, Value::Law(Dimension::ONE)).positive(),
                Argument::of("transition", Need::Always, SPEED).positive(),
                Argument::of("stiffness", Need::Always, STIFFNESS).positive(),
                Argument::of("damping", Need::Always, DAMPING).not_negative(),
                Argument::of("viscous", Need::Never, VISCOUS).not_negative(),
                RADIUS,
                LENGTH,
                SHOULDER,
                PRELOAD,
            ],
        },
        instead: None,
        meant: None,
        title: "LuGre friction",
        exerts: "a force or torque by bristles that bend and slide, by the force that presses its surfaces together, so that it sticks",
        exported: "lugre",
        on: &[Acts::Bearing],
        law: Law::None,
        stores: false,
        turns: false,
        owns: Some(Owned::Bristles { name: "bristle", most: "static", stiffness: "stiffness" }),
        rubs: true,
        holds: false,
        effort: None,
        doubt: None,
    },
    terms: |laws, load| terms(laws, load, resistance),
    inner: Some(&Inner { rates: |laws, load| bristles::rates(laws, load, bending) }),
    effort: Some(|laws, load| effort(laws, load, resistance)),
    counted: no_rotors,
    symbol: |_| {},
};

/// Of v_t: |v| of several components has no slope below.
const LEAST: f64 = 1e-6;

fn bending<'g>(laws: &Laws<'g>, load: &Load, v: &[Scalar<'g>], z: &[Scalar<'g>]) -> Vec<Scalar<'g>> {
    let [stiffness, transition] = ["stiffness", "transition"].map(|name| laws.value(load.named(name)));
    let sliding = stiffness * length(v, LEAST * transition) / coefficient(laws, load, v);
    v.iter().zip(z).map(|(v, z)| *v - sliding * *z).collect()
}

fn resistance<'g>(laws: &Laws<'g>, load: &Load, v: &[Scalar<'g>], z: &[Scalar<'g>]) -> Vec<[Scalar<'g>; 2]> {
    let [stiffness, damping, viscous] =
        ["stiffness", "damping", "viscous"].map(|name| laws.value(load.named(name)));
    let rates = bending(laws, load, v, z);
    let parts = v.iter().zip(z).zip(rates);
    parts.map(|((v, z), rate)| [stiffness * *z + damping * rate, viscous * *v]).collect()
}
