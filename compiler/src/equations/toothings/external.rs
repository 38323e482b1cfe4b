//! A wheel: teeth on its outside.

use super::WHEEL;
use crate::forms::{Form, Rim, ToothingForm};

pub static TOOTHING: ToothingForm = ToothingForm {
    call: Form { word: "external", elsewhere: &["spur", "pinion"], positional: &[], named: WHEEL },
    is: "teeth on the outside of a wheel",
    rim: Rim::External,
};
