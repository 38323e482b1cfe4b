//! A spring between two places, with a damper beside it.

use super::{LoadKind, LoadTerms, elastic_energy, no_rotors};
use crate::drawing::load::Symbol;
use crate::equations::laws::Laws;
use crate::forms::{Acts, Argument, Form, Law, LoadForm, Need, PLACES};
use crate::messages;
use crate::model::{Expr, Load};
use crate::units::Dimension;

pub static LOAD: LoadKind = LoadKind {
    form: LoadForm {
        call: Form {
            word: "spring",
            elsewhere: &[],
            positional: PLACES,
            named: &[
                Argument::scalar("stiffness", Need::Always, Dimension::STIFFNESS).restoring(),
                Argument::scalar("length", Need::Always, Dimension::LENGTH).not_negative(),
                Argument::scalar("damping", Need::Never, Dimension::DAMPING).restoring(),
            ],
        },
        instead: Some("between the bodies of a joint write `torsion_spring(joint, …)`"),
        meant: None,
        title: "spring",
        exerts: "a tension by the distance of the places beyond the length, and by its rate",
        exported: "spring",
        on: &[Acts::Place, Acts::Place],
        law: Law::None,
        stores: true,
        turns: false,
        owns: None,
        rubs: false,
        holds: false,
        effort: None,
        // A damper has no length.
        doubt: Some(|name, values| match values {
            [Some(0.0), length, ..] if *length != Some(0.0) => Some(messages::spring_that_damps(name)),
            _ => None,
        }),
    },
    terms,
    inner: None,
    effort: None,
    counted: no_rotors,
    symbol,
};

fn terms<'g>(laws: &Laws<'g>, load: &Load) -> LoadTerms<'g> {
    pull(laws, load, load.value(0), load.value(1), load.value(2))
}

/// Tension T = k (l − l₀) + c l̇ with l = |Δ|: force −(T/l) Δ on the second place, V = ½ k (l − l₀)².
pub fn pull<'g>(
    laws: &Laws<'g>,
    load: &Load,
    stiffness: &Expr,
    length: &Expr,
    damping: &Expr,
) -> LoadTerms<'g> {
    let delta = laws.kinematics().between(laws, load.place(0), load.place(1));
    let (k, rest, c) = (laws.value(stiffness), laws.value(length), laws.value(damping));
    let square = laws.g.sum(delta.iter().map(|d| d.value().square()));
    let distance = square.sqrt();

    // T/l, written so that a spring of no free length needs neither root nor division.
    let mut pull = k;
    if !rest.is_zero() && !k.is_zero() {
        pull = k - k * (rest / distance);
    }
    // l l̇
    let stretching = laws.g.sum(delta.iter().map(|d| d.value() * d.rate()));
    if !c.is_zero() {
        pull += c * (stretching / square);
    }

    let mut forces = Vec::new();
    for component in &delta {
        let force = pull * component.value();
        let columns = component.jet.columns.iter();
        forces.extend(columns.map(|(index, column)| (*index, -(*column * force))));
    }
    let (power, extension) = (pull * stretching, distance - rest);
    LoadTerms { forces, power: -power, potential: elastic_energy(k, extension) }
}

fn symbol(s: &mut Symbol) {
    let values = &s.effort.values;
    s.coil(values[0] != [0.0; 3], values[2] != [0.0; 3]);
}
