//! A worm and its wheel: a gear, as the axes do not matter.

use super::gear::GEAR;
use super::{PHASE, RATIO, ROTORS};
use crate::forms::{CouplingForm, Factor, Form, Means};

pub static COUPLING: CouplingForm = CouplingForm {
    call: Form { word: "worm", elsewhere: &[], positional: ROTORS, named: &[RATIO, PHASE] },
    holds: "the first angle is the ratio times the second, and a phase",
    means: Means::Proportion { kind: &GEAR, factor: Factor::Argument("ratio") },
};
