//! What anyone may know of a kind of toothing.

use super::Form;

/// A kind of toothing: what stands behind `toothing name:` in the braces of a part.
#[derive(Debug)]
pub struct ToothingForm {
    /// How it is written: all its arguments are numbers that are known at expansion, but for the line of a rack.
    pub call: Form,
    /// What it is, for documents.
    pub is: &'static str,
    pub rim: Rim,
}

/// Where the teeth stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rim {
    /// On the outside of a wheel.
    External,
    /// On the inside of a ring.
    Internal,
    /// Along a straight line.
    Rack,
    /// On a cone.
    Bevel,
    /// As threads of a screw.
    Worm,
}

impl Rim {
    /// The name of the number of teeth; a rack has as many as it is long.
    pub fn counts(self) -> Option<&'static str> {
        match self {
            Self::External | Self::Internal | Self::Bevel => Some("teeth"),
            Self::Rack => None,
            Self::Worm => Some("starts"),
        }
    }
}

/// The arguments of `involute(…)`, the stiffness of teeth by their shape.
pub const INVOLUTE: [&str; 5] = ["young", "poisson", "tooth", "harmonics", "entry"];
