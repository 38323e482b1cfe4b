//! A screw and its nut: a rack that travels the pitch for each turn.

use super::rack::RACK;
use super::{LENGTH_PHASE, ROTORS};
use crate::forms::{Argument, CouplingForm, Factor, Form, Means, Need};
use crate::units::Dimension;

pub static COUPLING: CouplingForm = CouplingForm {
    call: Form {
        word: "screw",
        elsewhere: &[],
        positional: ROTORS,
        named: &[Argument::scalar("pitch", Need::Always, Dimension::LENGTH), LENGTH_PHASE],
    },
    holds: "the travel of the second is the pitch for each turn of the first, and a phase",
    means: Means::Proportion { kind: &RACK, factor: Factor::PerTurn("pitch") },
};
