//! A ring: teeth on its inside.

use super::WHEEL;
use crate::forms::{Form, Rim, ToothingForm};

pub static TOOTHING: ToothingForm = ToothingForm {
    call: Form { word: "internal", elsewhere: &["ring", "annulus"], positional: &[], named: WHEEL },
    is: "teeth on the inside of a ring",
    rim: Rim::Internal,
};
