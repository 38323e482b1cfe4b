//! A worm: threads of a screw that drive the teeth of a wheel across.

use crate::forms::{Argument, Form, Need, Rim, ToothingForm};
use crate::units::Dimension;

pub static TOOTHING: ToothingForm = ToothingForm {
    call: Form { word: "worm", elsewhere: &["screw"], positional: &[], named: WORM },
    is: "threads of a screw; the module is that along its axis, and a helical wheel its partner, whose helix says by its sign which hand both have",
    rim: Rim::Worm,
};

const WORM: &[Argument] = &[
    Argument::scalar("starts", Need::Always, Dimension::ONE),
    Argument::scalar("module", Need::Always, Dimension::LENGTH),
    Argument::scalar("diameter", Need::Always, Dimension::LENGTH),
    Argument::scalar("pressure_angle", Need::Never, Dimension::ANGLE),
    Argument::scalar("addendum", Need::Never, Dimension::ONE),
    Argument::scalar("dedendum", Need::Never, Dimension::ONE),
    Argument::scalar("first", Need::Never, Dimension::ANGLE),
];
