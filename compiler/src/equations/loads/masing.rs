//! Hysteresis by a backbone: on first loading along it, and each way back along the same curve at twice its size (Masing 1926).
//!
//! Iwan's arrangement of Jenkins' elements: a spring and a slider in a row for each knot, all side by side. An element is its
//! deflection e, of which its force is k e: ė = v, but 0 where it has yielded, |e| ≥ x, and goes on.

use super::hysteresis::{self, Inner, way};
use super::{LoadKind, LoadTerms, no_rotors};
use crate::equations::laws::Laws;
use crate::forms::{Acts, Argument, Form, Law, LoadForm, Need, Owned, Positional, Value};
use crate::model::Load;
use crate::symbolic::{Compare, Scalar};

pub static LOAD: LoadKind = LoadKind {
    form: LoadForm {
        call: Form {
            word: "masing",
            elsewhere: &[],
            positional: &[Positional::Expression],
            named: &[Argument::of("backbone", Need::Always, Value::Backbone).restoring()],
        },
        instead: Some(
            "what it resists is a joint, or an expression of positions such as `distance(a.end, b.end) - 0.3 [m]`",
        ),
        meant: None,
        title: "hysteresis after Masing",
        exerts: "a force or torque against the way, by the backbone and by where it has turned",
        exported: "masing",
        on: &[Acts::Way],
        law: Law::None,
        stores: false,
        turns: false,
        owns: Some(Owned::Elements { name: "element", backbone: "backbone" }),
        rubs: false,
        holds: false,
        effort: Some("resistance"),
        doubt: None,
    },
    terms,
    inner: Some(&INNER),
    effort: Some(resistance),
    counted: no_rotors,
    // It stands at no place.
    symbol: |_| {},
};

static INNER: Inner = Inner { rates };

fn terms<'g>(laws: &Laws<'g>, load: &Load) -> LoadTerms<'g> {
    hysteresis::terms(laws, load, resistance(laws, load))
}

/// Each deflection, with where it yields and its stiffness.
fn elements<'g>(laws: &Laws<'g>, load: &Load) -> Vec<(Scalar<'g>, [Scalar<'g>; 2])> {
    let given = load.components(0)[1..].chunks(2);
    let given = given.map(|pair| [laws.value(&pair[0]), laws.value(&pair[1])]);
    laws.states(load).into_iter().zip(given).collect()
}

fn rates<'g>(laws: &Laws<'g>, load: &Load) -> Vec<Scalar<'g>> {
    let (zero, v) = (laws.g.zero(), way(laws, load).rate());
    let rate = |(e, [yields, _]): (Scalar<'g>, [Scalar<'g>; 2])| {
        let has_yielded = yields.compare(Compare::LessEqual, e.abs());
        (has_yielded & zero.compare(Compare::Less, e * v)).select(zero, v)
    };
    elements(laws, load).into_iter().map(rate).collect()
}

/// F = k x + Σ kᵢ eᵢ. A step may lead an element beyond its end, which its force does not follow.
fn resistance<'g>(laws: &Laws<'g>, load: &Load) -> Scalar<'g> {
    let forces = elements(laws, load)
        .into_iter()
        .map(|(e, [yields, stiffness])| stiffness * e.min(yields).max(-yields));
    let lasting = laws.value(load.value(0)) * way(laws, load).value();
    laws.g.sum(forces) + lasting
}
