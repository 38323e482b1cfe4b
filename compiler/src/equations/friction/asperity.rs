//! Friction by asperities that hold like a spring to an anchor, which is dragged along where more is asked of it: with z the way from the
//! anchor and N what presses,
//!
//! ```text
//! F = N f μ/max(|f|, μ),    f = μ v/max(|v|, v_s) + k z
//! ż = v where |z| < μ/k or z·v < 0, else v less what of it is along z
//! ```
//! k in 1/m, about a pin 1/rad. The last twentieth of z is a smooth way between both. Wasfy, Wasfy and Mahfouz's tracked vehicle (equations
//! 24 and 25: an approximate Coulomb element beside a spring to a moving anchor, together at most μ N); Dupont, Hayward, Armstrong, Altpeter,
//! IEEE Transactions on Automatic Control 47 (2002) 787 for the smooth way.

use super::bearing::{LENGTH, PRELOAD, RADIUS, SHOULDER};
use super::bristles::{self, STIFFNESS, length};
use super::coulomb::SPEED;
use super::{effort, terms};
use crate::equations::laws::Laws;
use crate::equations::loads::{Inner, LoadKind, no_rotors};
use crate::forms::{Acts, Argument, Form, Law, LoadForm, Need, Owned, Value};
use crate::model::Load;
use crate::symbolic::{Compare, Scalar};
use crate::units::Dimension;

pub static LOAD: LoadKind = LoadKind {
    form: LoadForm {
        call: Form {
            word: "asperity",
            elsewhere: &[],
            positional: &[],
            named: &[
                Argument::of("coefficient", Need::Always, Value::Law(Dimension::ONE)).not_negative(),
                Argument::of("stiffness", Need::Always, STIFFNESS).positive(),
                Argument::of("speed", Need::Always, SPEED).positive(),
                RADIUS,
                LENGTH,
                SHOULDER,
                PRELOAD,
            ],
        },
        instead: None,
        meant: None,
        title: "asperity friction",
        exerts: "a force or torque by a spring to an anchor that is dragged along, by the force that presses its surfaces together, so that it sticks",
        exported: "asperity",
        on: &[Acts::Bearing],
        law: Law::None,
        stores: false,
        turns: false,
        owns: Some(Owned::Bristles { name: "way", most: "coefficient", stiffness: "stiffness" }),
        rubs: true,
        holds: false,
        effort: None,
        doubt: None,
    },
    terms: |laws, load| terms(laws, load, resistance),
    inner: Some(&Inner { rates: |laws, load| bristles::rates(laws, load, dragging) }),
    effort: Some(|laws, load| effort(laws, load, resistance)),
    counted: no_rotors,
    symbol: |_| {},
};

/// Of the largest z: the stretch in which the anchor begins to be dragged.
const SOFTLY: f64 = 0.05;
/// Of v_s, and of the largest z: what several components never have less of, so that their lengths have slopes.
const LEAST: f64 = 1e-6;

/// ż: s of what of v goes on along z is left, s = 3 u² − 2 u³, u = (1 − k |z|/μ)/0.05 within 0 and 1.
fn dragging<'g>(laws: &Laws<'g>, load: &Load, v: &[Scalar<'g>], z: &[Scalar<'g>]) -> Vec<Scalar<'g>> {
    let [most, stiffness] = ["coefficient", "stiffness"].map(|name| laws.value(load.named(name)));
    let least = laws.g.number(LEAST) * most / stiffness;
    let rest = (1.0 - stiffness * length(z, least) / most) / SOFTLY;
    let u = rest.max(laws.g.zero()).min(laws.g.one());
    let dragged = 1.0 - u.square() * (3.0 - 2.0 * u);
    if let ([v], [z]) = (v, z) {
        let goes_on = laws.g.zero().compare(Compare::Less, *v * *z);
        return vec![goes_on.select(*v - dragged * *v, *v)];
    }
    let along = laws.g.sum(v.iter().zip(z).map(|(v, z)| *v * *z)).max(laws.g.zero());
    let share = dragged * along / length(z, least).square();
    v.iter().zip(z).map(|(v, z)| *v - share * *z).collect()
}

fn resistance<'g>(laws: &Laws<'g>, load: &Load, v: &[Scalar<'g>], z: &[Scalar<'g>]) -> Vec<[Scalar<'g>; 2]> {
    let [most, stiffness, speed] =
        ["coefficient", "stiffness", "speed"].map(|name| laws.value(load.named(name)));
    let slope = most / length(v, LEAST * speed).max(speed);
    let asked: Vec<Scalar> = v.iter().zip(z).map(|(v, z)| slope * *v + stiffness * *z).collect();
    let held = most / length(&asked, LEAST * most).max(most);
    asked.iter().map(|asked| [held * *asked, laws.g.zero()]).collect()
}
