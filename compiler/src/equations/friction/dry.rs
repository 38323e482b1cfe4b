//! Dry friction: it holds with whatever is asked of it up to a bound, and slides with a lesser one against the sliding, Coulomb's law as it is.
//!
//! ```text
//! contact   holds with |F| ≤ μ_s N, slides with μ_k N; in space F = g − n (n·g), g three numbers along the axes of the world, n the normal
//! joint     holds with |F| ≤ b + r μ_s N, slides with f + r μ_k N       r the radius of what turns, else 1; N as `bearing` has it
//! ```
//! Its force (N or N m) is a number of the state, of each component along what slides, of which |F| is the size: what it is, and when it changes between both, follows in the run from all
//! that touches (`simulation/rigid.rs` of the runtime; Pfeiffer and Glocker, *Multibody Dynamics with Unilateral Contacts*, 1996, 5) or that
//! rubs in joints (`simulation/sticking.rs` there).

use super::bearing::{LENGTH, RADIUS, SHOULDER};
use super::{bearing, pressed, slips, touching};
use crate::equations::jet::Moving;
use crate::equations::laws::Laws;
use crate::equations::loads::{LoadKind, LoadTerms, along, no_rotors};
use crate::forms::{Acts, Argument, Form, Law, LoadForm, Need, Value};
use crate::model::{Load, LoadId};
use crate::symbolic::{Compare, Node, Scalar};
use crate::units::Dimension;

pub static LOAD: LoadKind = LoadKind {
    form: LoadForm {
        call: Form {
            word: "dry",
            elsewhere: &[],
            positional: &[],
            named: &[
                Argument::scalar("static", Need::Never, Dimension::ONE).not_negative(),
                Argument::scalar("kinetic", Need::Never, Dimension::ONE).not_negative(),
                RADIUS,
                LENGTH,
                SHOULDER,
                Argument::of("preload", Need::Never, Value::Law(Dimension::FORCE)).not_negative(),
                Argument::of("force", Need::Never, Value::Law(Dimension::FORCE)).not_negative(),
                Argument::of("torque", Need::Never, Value::Law(Dimension::TORQUE)).not_negative(),
                Argument::of("breakaway", Need::Never, Value::Along { effort: true, way: 0, time: 0 })
                    .not_negative(),
            ],
        },
        instead: None,
        meant: None,
        title: "dry friction",
        exerts: "what keeps surfaces of a rigid contact or of a joint from sliding, up to a share of what presses them, and a share of it where they slide",
        exported: "dry",
        on: &[Acts::Bearing],
        law: Law::None,
        stores: false,
        turns: false,
        owns: None,
        rubs: true,
        holds: true,
        effort: None,
        doubt: None,
    },
    terms,
    inner: None,
    effort: Some(effort),
    counted: no_rotors,
    symbol: |_| {},
};

/// Of each gap of the contact; of a joint along each of the coordinates that slide.
fn forces<'g>(laws: &Laws<'g>, load: &Load) -> Vec<Scalar<'g>> {
    let id = laws.mechanism.loads.iter().position(|it| std::ptr::eq(it, load)).map(LoadId);
    let gates = id.into_iter().flat_map(|id| (0..load.ungated.len()).map(move |which| (id, which)));
    gates.map(|(id, which)| laws.gate(id, which)).collect()
}

/// The coordinates that slide, and by how much each moves the surfaces on each other; none that moves them by nothing.
fn slide<'g>(laws: &Laws<'g>, load: &Load) -> Vec<(Moving<'g>, Scalar<'g>)> {
    let along = slips(laws, load).into_iter().flat_map(|slip| slip.along);
    along.filter(|(_, lever)| !lever.is_zero()).collect()
}

fn terms<'g>(laws: &Laws<'g>, load: &Load) -> LoadTerms<'g> {
    if load.contact().is_some() {
        return in_contact(laws, load);
    }
    let slide = slide(laws, load).into_iter().zip(forces(laws, load));
    slide.fold(LoadTerms::none(laws), |sum, ((coordinate, lever), force)| {
        sum.and(along(&coordinate, lever * force))
    })
}

/// Of each gap along what slides; in space what of three numbers is along the surface.
fn in_contact<'g>(laws: &Laws<'g>, load: &Load) -> LoadTerms<'g> {
    let mut forces = forces(laws, load).into_iter();
    slips(laws, load).into_iter().fold(LoadTerms::none(laws), |sum, slip| {
        let own = forces.by_ref().take(slip.along.len()).collect::<Vec<_>>();
        let along = touching::beside(&slip.normal, own);
        slip.along
            .iter()
            .zip(along)
            .fold(sum, |sum, ((slides, _), force)| sum.and(super::along(slides, force)))
    })
}

/// Of a contact in all; of a joint along the first coordinate that slides.
fn effort<'g>(laws: &Laws<'g>, load: &Load) -> Scalar<'g> {
    if load.contact().is_some() {
        return laws.g.sum(forces(laws, load));
    }
    let first = slide(laws, load).into_iter().zip(forces(laws, load)).next();
    first.map_or_else(|| laws.g.zero(), |((_, lever), force)| lever * force)
}

/// Of each gap, in space along each axis, or of the joint along each coordinate: how fast the surfaces slide, and the derivative of that at v̇ = 0.
pub fn slidings(laws: &Laws, load: &Load) -> Vec<[Node; 2]> {
    let Some(contact) = load.contact() else {
        let moved = |(coordinate, lever): (Moving, Scalar)| {
            [coordinate.rate(), coordinate.bias()].map(|it| (lever * it).bare)
        };
        return slide(laws, load).into_iter().map(moved).collect();
    };
    let all = laws.mechanism.loads[contact.0].slides.iter();
    all.flat_map(|sliding| touching::moved(laws, sliding)).map(|it| it.map(|it| it.bare)).collect()
}

/// μ_s and μ_k of the dry friction of a contact.
pub fn shares(laws: &Laws, load: &Load) -> [Node; 2] {
    ["static", "kinetic"].map(|name| laws.value(load.named(name)).bare)
}

/// Of the dry friction of a joint the most that it holds with, and what it slides with, N or N m, for each of its gates.
pub fn bounds(laws: &Laws, load: &Load) -> Vec<[Node; 2]> {
    let slips = bearing::slips(laws, load);
    let radius = slips.first().map_or_else(|| laws.g.one(), |slip| slip.radius);
    let by_load = radius * pressed(laws, load);
    let named = |name: &str| laws.value(load.named(name));
    let slides = named("force") + named("torque");
    let own = [named("breakaway"), slides];
    let shares = ["static", "kinetic"].map(named);
    let [holds, slides] = [0, 1].map(|which| own[which] + shares[which] * by_load);
    vec![ordered(laws, load, holds, slides); load.ungated.len()]
}

/// Of what varies: what would push does nothing, and what slides holds with as much at least. Of numbers that is checked.
fn ordered<'g>(laws: &Laws<'g>, load: &Load, holds: Scalar<'g>, slides: Scalar<'g>) -> [Node; 2] {
    let mut written = load.form.call.named.iter().map(|argument| load.named(argument.name));
    if written.all(|value| !value.varies()) {
        return [holds.bare, slides.bare];
    }
    // Written so that what is no number stays none.
    let zero = laws.g.zero();
    let slides = slides.compare(Compare::Less, zero).select(zero, slides);
    [holds.compare(Compare::Less, slides).select(slides, holds).bare, slides.bare]
}
