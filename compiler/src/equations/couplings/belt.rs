//! A belt or chain: a gear by its radii, r₁ θ₁ = r₂ θ₂.

use super::gear::GEAR;
use super::{PHASE, ROTORS};
use crate::forms::{Argument, CouplingForm, Factor, Form, Means, Need};
use crate::units::Dimension;

pub static COUPLING: CouplingForm = CouplingForm {
    call: Form {
        word: "belt",
        elsewhere: &[],
        positional: ROTORS,
        named: &[
            Argument::scalar("radius", Need::Always, Dimension::LENGTH),
            Argument::scalar("second_radius", Need::Always, Dimension::LENGTH),
            PHASE,
        ],
    },
    holds: "radius times the first angle is the second radius times the second, and a phase",
    means: Means::Proportion { kind: &GEAR, factor: Factor::Quotient { of: "second_radius", to: "radius" } },
};
