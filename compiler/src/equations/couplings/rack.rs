//! A pinion and its rack.

use super::{LENGTH_PHASE, ROTORS};
use crate::forms::{Acts, Argument, CouplingForm, Factor, Form, Means, Need, Proportion, RowForm};
use crate::units::Dimension;

/// rail.travel = radius · pinion.angle + phase.
pub static RACK: Proportion = Proportion {
    exported: "rack",
    row: RowForm::own("rack"),
    on: [("pinion", Acts::Rotor), ("rail", Acts::Travel)],
    driven: 1,
    factor: ("radius", Dimension::LENGTH),
    phase: Dimension::LENGTH,
};

pub static COUPLING: CouplingForm = CouplingForm {
    call: Form {
        word: "rack",
        elsewhere: &[],
        positional: ROTORS,
        named: &[Argument::scalar("radius", Need::Always, Dimension::LENGTH), LENGTH_PHASE],
    },
    holds: "the travel of the second is the radius times the angle of the first, and a phase",
    means: Means::Proportion { kind: &RACK, factor: Factor::Argument("radius") },
};
