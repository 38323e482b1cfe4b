//! A cable of no mass that runs from place to place, through eyes without friction, and pulls where it is longer than by itself:
//! Hooke's law on one side, T = max(0, EA (l − l₀)/l₀ + c d(l − l₀)/dt) in N with EA in N, l and l₀ in m and c in N s/m, along l − l₀
//! by virtual work. Why so, and what becomes of the kink: docs/decisions/cables.md.

use super::{LoadKind, LoadTerms, along, no_rotors};
use crate::drawing::load::Symbol;
use crate::equations::jet::{Jet, Moving};
use crate::equations::laws::Laws;
use crate::forms::{Acts, Argument, Form, Law, LoadForm, Need, Positional, Value};
use crate::model::{Coordinate, Load};
use crate::symbolic::{Compare, Scalar};
use crate::units::Dimension;

pub static LOAD: LoadKind = LoadKind {
    form: LoadForm {
        call: Form {
            word: "cable",
            elsewhere: &["rope", "tendon"],
            positional: &[Positional::Place, Positional::Place, Positional::Places],
            named: &[
                Argument::scalar("stiffness", Need::Always, Dimension::FORCE).restoring(),
                Argument::of("length", Need::Always, Value::Varying(Dimension::LENGTH)).positive(),
                Argument::scalar("damping", Need::Never, Dimension::DAMPING).restoring(),
                Argument::of("pay_out", Need::Never, PAYED_OUT),
                Argument::scalar("smooth", Need::Never, Dimension::LENGTH).not_negative(),
            ],
        },
        instead: None,
        meant: None,
        title: "cable",
        exerts: "a tension along its runs, by the length of these beyond its own, and by the rate of that; never a push",
        exported: "cable",
        on: &[Acts::Place, Acts::Place, Acts::Place],
        law: Law::None,
        // What winds it in or out works on it.
        stores: false,
        turns: false,
        owns: None,
        rubs: false,
        holds: false,
        effort: Some("tension"),
        doubt: None,
    },
    terms,
    inner: None,
    effort: Some(tension),
    counted: no_rotors,
    symbol,
};

const PAYED_OUT: Value = Value::RateOf { varying: "length", for_sake_of: "damping" };

/// −T along l − l₀, where l₀ counts as it changes with positions: what winds the cable up feels it.
fn terms<'g>(laws: &Laws<'g>, load: &Load) -> LoadTerms<'g> {
    let mut own = laws.jet(load.value(1));
    // What changes with time by itself is no motion of the mechanism.
    own.jet = Jet { drift: laws.g.zero().bare, known_rate: None, ..own.jet };
    along(&(run(laws, load) - own), -tension(laws, load))
}

/// l, the sum of the distances from place to place.
fn run<'g>(laws: &Laws<'g>, load: &Load) -> Moving<'g> {
    let places: Vec<_> = load.places().cloned().map(Box::new).collect();
    let runs = places.windows(2).map(|ends| Coordinate::Distance(ends[0].clone(), ends[1].clone()));
    let runs = runs.map(|run| laws.coordinate(&run));
    runs.reduce(|sum, run| sum + run).unwrap_or_else(|| laws.still(laws.g.zero()))
}

/// T = max(0, EA s/l₀ + c g d(l − l₀)/dt): s is what l − l₀ is above zero and g whether it is, or across the width `smooth` a
/// parabola and its slope.
fn tension<'g>(laws: &Laws<'g>, load: &Load) -> Scalar<'g> {
    let [stiffness, own, damping, pay_out, width] =
        [0, 1, 2, 3, 4].map(|which| laws.value(load.value(which)));
    let run = run(laws, load);
    let (zero, one) = (laws.g.zero(), laws.g.one());
    let stretch = run.value() - own;
    let (slope, beyond) = if width.is_zero() {
        (zero.compare(Compare::Less, stretch).select(one, zero), stretch.max(zero))
    } else {
        let slope = (stretch / width + 0.5).max(zero).min(one);
        (slope, 0.5 * (width * slope.square()) + (stretch - 0.5 * width).max(zero))
    };
    let elastic = stiffness / own * beyond;
    if damping.is_zero() {
        return elastic;
    }
    (elastic + damping * (slope * (run.rate() - pay_out))).max(zero)
}

fn symbol(s: &mut Symbol) {
    s.line();
}
