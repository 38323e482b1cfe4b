//! A bushing between two places of space: restoring force and torque by what the second place is moved and turned against
//! the first.
//!
//! With E₁, E₂ the axes of the two places, δ = E₁ᵀ (p₂ − p₁), R = E₁ᵀ E₂ and φ = ½ (R₃₂ − R₂₃, R₁₃ − R₃₁, R₂₁ − R₁₂), for small turns the
//! angles about the axes: V = ½ δᵀ K δ + ½ φᵀ K_t φ, and by virtual work Q −= J_δᵀ (K δ + C δ̇) + J_φᵀ (K_t φ + C_t φ̇), with the exact J_φ.
//! φ is n sin of the turn about n: beyond a right angle it grows smaller. The force on the second body acts at the second
//! place, and its opposite on the first body at that same point, so that momentum and power balance.

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
                Argument::diagonal("torsional_stiffness", Need::Always, Dimension::TORQUE).restoring(),
                Argument::diagonal("torsional_damping", Need::Never, Dimension::ANGULAR_DAMPING).restoring(),
            ],
        },
        instead: None,
        meant: None,
        title: "bushing",
        exerts: "a force by the way between the places and a torque by the turn, along the first's axes, and by their rates",
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
    counted: no_rotors,
    symbol: |s| s.sleeve(),
};

fn terms<'g>(laws: &Laws<'g>, load: &Load) -> LoadTerms<'g> {
    let space = laws.space().expect("a load of space");
    let [stiffness, damping, torsional_stiffness, torsional_damping] =
        [0, 1, 2, 3].map(|which| load.components(which));
    let [first, second] = [0, 1].map(|which| space.spot(laws, load.place(which)));
    let delta = space.delta(&first, &second);
    let way = [0, 1, 2].map(|k| delta.project(first.axes.column(k)));
    let seen = [0, 1, 2].map(|k| space.direction(&first, &second, second.axes.column(k)));
    // R = E₁ᵀ E₂, row after row.
    let entry = |row: usize, column: usize| seen[column].project(first.axes.column(row));
    let turn = [(2, 1), (0, 2), (1, 0)].map(|(i, j)| 0.5 * (entry(i, j) - entry(j, i)));
    let pull = restoring_each(laws, &way, stiffness, damping);
    pull.and(restoring_each(laws, &turn, torsional_stiffness, torsional_damping))
}
