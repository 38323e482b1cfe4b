//! Uses of parts. What they brought stands in the definition as if it were written there, each name behind that of its use:
//! `left.foot`.

use super::{Label, Path};
use crate::diagnostics::Region;
use std::ops::Range;

/// `part left: Leg(hip = hull.left, side = -1);`
#[derive(Clone, Debug)]
pub struct PartUse {
    /// `left`, or `left.knee` of a part within a part.
    pub name: Label,
    /// The whole use.
    pub region: Region,
    /// The name of the part, `Leg`.
    pub part: String,
    /// What it is given that has a name.
    pub given: Vec<Given>,
    /// Where the part is declared, among [`Definition::files`](super::Definition::files); nothing if beside the mechanism.
    pub file: Option<usize>,
}

/// What a use gives to a port: `hip = hull.left`.
#[derive(Clone, Debug)]
pub struct Given {
    /// The name of the port.
    pub port: String,
    pub kind: PortKind,
    pub path: Path,
}

/// The kinds of ports that are no values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PortKind {
    Place,
    Body,
    Joint,
    Table,
}

impl PortKind {
    pub const ALL: [PortKind; 4] = [Self::Place, Self::Body, Self::Joint, Self::Table];

    pub fn word(self) -> &'static str {
        match self {
            Self::Place => "place",
            Self::Body => "body",
            Self::Joint => "joint",
            Self::Table => "table",
        }
    }
}

/// Where a file is, both from the root.
#[derive(Clone, Debug)]
pub struct OnDisk {
    pub path: String,
    /// The folder that its name is taken from.
    pub folder: String,
}

/// A text outside of the definition that parts were read from, with the places of its tokens.
#[derive(Clone, Debug)]
pub struct PartFile {
    /// As messages show it.
    pub shown: String,
    /// Nothing of the library.
    pub on_disk: Option<OnDisk>,
    pub text: String,
    /// By serial number, counted from `before`.
    pub places: Vec<Range<usize>>,
    /// The serial number before its first token.
    pub before: usize,
}
