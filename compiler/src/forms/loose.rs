//! Joints that have a short form with play: two round surfaces, one about the first place and one in it about the second.

use super::{Argument, Form, Need, PLACES, Space};
use crate::units::Dimension;

/// A joint with play.
#[derive(Debug)]
pub struct LooseForm {
    /// The joint's word, with what its play takes.
    pub call: Form,
    pub space: Space,
    /// The words of the surface around, and of that within.
    pub surfaces: [&'static str; 2],
}

const fn loose(word: &'static str, space: Space, surfaces: [&'static str; 2]) -> LooseForm {
    const NAMED: &[Argument] = &[
        Argument::scalar("play", Need::Always, Dimension::LENGTH),
        Argument::scalar("radius", Need::Always, Dimension::LENGTH),
    ];
    LooseForm { call: Form { word, elsewhere: &[], positional: PLACES, named: NAMED }, space, surfaces }
}

pub static LOOSE: [LooseForm; 2] = [
    loose("revolute", Space::Planar, ["hole", "circle"]),
    loose("spherical", Space::Spatial, ["ball_socket", "sphere"]),
];
