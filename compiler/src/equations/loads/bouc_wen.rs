//! Hysteresis after Bouc and Wen: F = α k x + (1 − α) k z, ż = v (1 − (β sgn(v z) + γ) |z/z₀|ⁿ) (Wen, J. Eng. Mech. Div. 102 (1976)
//! 249; z and z₀ are lengths, β and γ numbers).

use super::hysteresis::{self, Inner, way};
use super::{LoadKind, LoadTerms, no_rotors};
use crate::equations::laws::Laws;
use crate::equations::power;
use crate::forms::{Acts, Argument, Form, Law, LoadForm, Need, Owned, Positional, Value};
use crate::model::Load;
use crate::symbolic::Scalar;
use crate::units::Dimension;

pub static LOAD: LoadKind = LoadKind {
    form: LoadForm {
        call: Form {
            word: "bouc_wen",
            elsewhere: &[],
            positional: &[Positional::Expression],
            named: &[
                Argument::of("stiffness", Need::Always, Value::Stiffness).restoring(),
                Argument::scalar("share", Need::Never, Dimension::ONE),
                Argument::of("depth", Need::Always, Value::Way).positive(),
                Argument::scalar("beta", Need::Always, Dimension::ONE),
                Argument::scalar("gamma", Need::Always, Dimension::ONE),
                Argument::of("exponent", Need::Always, Value::Exponent),
            ],
        },
        instead: Some(
            "what it resists is a joint, or an expression of positions such as `distance(a.end, b.end) - 0.3 [m]`",
        ),
        meant: None,
        title: "hysteresis after Bouc and Wen",
        exerts: "a force or torque against the way, a share of it elastic, the rest by a deflection that yields",
        exported: "bouc_wen",
        on: &[Acts::Way],
        law: Law::None,
        stores: false,
        turns: false,
        owns: Some(Owned::One { name: "deflection", size: "depth" }),
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

/// Relative deflections below it are taken for it where their logarithm is needed.
const LEAST: f64 = 1e-12;

fn terms<'g>(laws: &Laws<'g>, load: &Load) -> LoadTerms<'g> {
    hysteresis::terms(laws, load, resistance(laws, load))
}

/// v − |ζ|ⁿ⁻¹ (β |v| ζ + γ v |ζ|) with ζ = z/z₀.
fn rates<'g>(laws: &Laws<'g>, load: &Load) -> Vec<Scalar<'g>> {
    let v = way(laws, load).rate();
    let [depth, beta, gamma] = [2, 3, 4].map(|which| laws.value(load.value(which)));
    let less_one = laws.value(load.value(5)).value().unwrap_or(1.0) - 1.0;
    let rate = |z: Scalar<'g>| {
        let relative = z / depth;
        let size = relative.abs();
        // Whole powers need neither root nor logarithm, which have no slope at zero.
        let base = if less_one.fract() == 0.0 { size } else { size.max(laws.g.number(LEAST)) };
        v - power(base, less_one) * (beta * (v.abs() * relative) + gamma * (v * size))
    };
    laws.states(load).into_iter().map(rate).collect()
}

fn resistance<'g>(laws: &Laws<'g>, load: &Load) -> Scalar<'g> {
    let [stiffness, share] = [0, 1].map(|which| laws.value(load.value(which)));
    let x = way(laws, load).value();
    let yielding = laws.g.sum(laws.states(load));
    stiffness * (share * x + (1.0 - share) * yielding)
}
