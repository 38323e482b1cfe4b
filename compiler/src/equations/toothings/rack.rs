//! A rack: teeth along a straight line of a part.

use crate::forms::{Argument, Form, Need, Rim, ToothingForm};
use crate::units::Dimension;

pub static TOOTHING: ToothingForm = ToothingForm {
    call: Form { word: "rack", elsewhere: &[], positional: &[], named: RACK },
    is: "teeth along `line = part.line`, on which they are as thick as their spaces; one stands in the middle of its first point",
    rim: Rim::Rack,
};

const RACK: &[Argument] = &[
    Argument::scalar("module", Need::Always, Dimension::LENGTH),
    Argument::scalar("face_width", Need::Never, Dimension::LENGTH),
    Argument::scalar("pressure_angle", Need::Never, Dimension::ANGLE),
    Argument::scalar("addendum", Need::Never, Dimension::ONE),
    Argument::scalar("dedendum", Need::Never, Dimension::ONE),
];
