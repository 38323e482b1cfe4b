//! The kinds of toothings, one file each with its record. What follows from their numbers is `model::gears`.

mod bevel;
mod external;
mod internal;
mod rack;
mod worm;

use crate::forms::{Argument, Need, ToothingForm};
use crate::units::Dimension;

/// All kinds, in the order of documents.
pub static TOOTHINGS: &[&ToothingForm] =
    &[&external::TOOTHING, &internal::TOOTHING, &rack::TOOTHING, &bevel::TOOTHING, &worm::TOOTHING];

/// The arguments of a wheel or ring.
const WHEEL: &[Argument] = &[
    Argument::scalar("teeth", Need::Always, Dimension::ONE),
    Argument::scalar("module", Need::Always, Dimension::LENGTH),
    Argument::scalar("face_width", Need::Never, Dimension::LENGTH),
    Argument::scalar("pressure_angle", Need::Never, Dimension::ANGLE),
    Argument::scalar("helix", Need::Never, Dimension::ANGLE),
    Argument::scalar("shift", Need::Never, Dimension::ONE),
    Argument::scalar("addendum", Need::Never, Dimension::ONE),
    Argument::scalar("dedendum", Need::Never, Dimension::ONE),
    Argument::scalar("first", Need::Never, Dimension::ANGLE),
    Argument::scalar("bore", Need::Never, Dimension::LENGTH),
];
