//! A differential: its carrier turns by the mean of both wheels.

use crate::forms::{CouplingForm, Form, Means, Positional};

pub static COUPLING: CouplingForm = CouplingForm {
    call: Form {
        word: "differential",
        elsewhere: &[],
        positional: &[Positional::Rotor, Positional::Rotor, Positional::Rotor],
        named: &[],
    },
    holds: "the angles of the second and third add up to twice the angle of the first",
    means: Means::Sum { of: [1, 2], times: "2", by: 0 },
};
