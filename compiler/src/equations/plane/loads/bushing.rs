//! A bushing between two places of the plane: restoring force and torque by what the second place is moved and turned against
//! the first.
//!
//! With δ the components of p₂ − p₁ along the axes of what the first place belongs to, and φ = θ₂ − θ₁ in (−π, π]:
//! V = ½ δᵀ K δ + ½ k_t φ², and by virtual work Q −= J_δᵀ (K δ + C δ̇) + J_φ (k_t φ + c_t φ̇). The force on the second body acts at
//! the second place, and its opposite on the first body at that same point, so that momentum and power balance.

use crate::equations::laws::Laws;
use crate::equations::loads::{LoadKind, LoadTerms, no_rotors, restoring_each};
use crate::forms::{Acts, Argument, Form, Law, LoadForm, Need, PLACES};
use crate::model::Load;
use crate::units::Dimension;

pub static LOAD: LoadKind = LoadKind {
    form: LoadForm {
        call: Form {
            word: "bushing",
            elsewhere: &[],
            positional: PLACES,
            named: &[
                Argument::diagonal("stiffness", Need::Always, Dimension::STIFFNESS).restoring(),
                Argument::diagonal("damping", Need::Never, Dimension::DAMPING).restoring(),
                Argument::scalar("torsional_stiffness", Need::Always, Dimension::TORQUE).restoring(),
                Argument::scalar("torsional_damping", Need::Never, Dimension::ANGULAR_DAMPING).restoring(),
            ],
        },
        instead: None,
        meant: None,
        title: "bushing",
        exerts: "a force by the way between the places along the first's axes, a torque by the angle, and by their rates",
        exported: "bushing",
        on: &[Acts::Place, Acts::Place],
        law: Law::None,
        stores: true,
        turns: true,
        owns: None,
        rubs: false,
        holds: false,
        effort: None,
        doubt: None,
    },
    terms,
    inner: None,
    effort: None,
    // The angle is small; counted turns of both bodies could differ by one.
    counted: no_rotors,
    symbol: |s| s.sleeve(),
};

fn terms<'g>(laws: &Laws<'g>, load: &Load) -> LoadTerms<'g> {
    let (plane, [first, second]) = (laws.plane(), [load.place(0), load.place(1)]);
    let way = plane.difference_in_first(laws, first, second);
    let angle = plane.angle_between(laws, first.frame, second.frame);
    let [stiffness, damping, torsional_stiffness, torsional_damping] =
        [0, 1, 2, 3].map(|which| load.components(which));
    let pull = restoring_each(laws, &way, stiffness, damping);
    pull.and(restoring_each(laws, &[angle], torsional_stiffness, torsional_damping))
}
