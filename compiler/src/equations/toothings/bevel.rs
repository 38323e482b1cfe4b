//! A bevel gear: straight teeth on a cone.

use crate::forms::{Argument, Form, Need, Rim, ToothingForm};
use crate::units::Dimension;

pub static TOOTHING: ToothingForm = ToothingForm {
    call: Form { word: "bevel", elsewhere: &["miter"], positional: &[], named: BEVEL },
    is: "straight teeth on a cone; its centre is that of the pitch circle at the outer end of the teeth, where the module counts",
    rim: Rim::Bevel,
};

const BEVEL: &[Argument] = &[
    Argument::scalar("teeth", Need::Always, Dimension::ONE),
    Argument::scalar("module", Need::Always, Dimension::LENGTH),
    // Half the angle of the pitch cone.
    Argument::scalar("cone", Need::Always, Dimension::ANGLE),
    Argument::scalar("face_width", Need::Never, Dimension::LENGTH),
    Argument::scalar("pressure_angle", Need::Never, Dimension::ANGLE),
    Argument::scalar("addendum", Need::Never, Dimension::ONE),
    Argument::scalar("dedendum", Need::Never, Dimension::ONE),
    Argument::scalar("first", Need::Never, Dimension::ANGLE),
];
