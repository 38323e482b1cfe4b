//! A pair of gears, whatever their axes.

use super::{PHASE, RATIO, ROTORS};
use crate::forms::{Acts, CouplingForm, Factor, Form, Means, Proportion, RowForm};
use crate::units::Dimension;

/// first.angle = ratio · second.angle + phase.
pub static GEAR: Proportion = Proportion {
    exported: "gear",
    row: RowForm::own("gear"),
    on: [("first", Acts::Rotor), ("second", Acts::Rotor)],
    driven: 0,
    factor: ("ratio", Dimension::ONE),
    phase: Dimension::ANGLE,
};

pub static COUPLING: CouplingForm = CouplingForm {
    call: Form { word: "gear", elsewhere: &[], positional: ROTORS, named: &[RATIO, PHASE] },
    holds: "the first angle is the ratio times the second, and a phase",
    means: Means::Proportion { kind: &GEAR, factor: Factor::Argument("ratio") },
};
