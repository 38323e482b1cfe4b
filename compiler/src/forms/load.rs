//! What anyone may know of a kind of load.

use super::Form;
use crate::units::Dimension;

/// A kind of load, without its equations.
#[derive(Debug)]
pub struct LoadForm {
    /// How it is written. Loads with the same word have the same call.
    pub call: Form,
    /// What else could be meant where a place is missing.
    pub instead: Option<&'static str>,
    /// Whether it is this one of those with its word; `None`: it is where none of the others is.
    pub meant: Option<fn(&Written) -> bool>,
    /// What it is called.
    pub title: &'static str,
    /// What it exerts, for documents.
    pub exerts: &'static str,
    /// Its kind in an exported definition.
    pub exported: &'static str,
    /// What its unnamed arguments name; any further ones are as the last.
    pub on: &'static [Acts],
    pub law: Law,
    /// Whether it stores energy: of its power, what changes sign with all velocities is then taken from its potential.
    pub stores: bool,
    /// Whether its places turn, so that particles have none.
    pub turns: bool,
    /// The internal states that it has, of what it resists.
    pub owns: Option<Owned>,
    /// Whether it is a friction: written `friction name: on(joint) = word(…);`.
    pub rubs: bool,
    /// Whether it is the dry friction of a rigid contact, whose force is a number of the state.
    pub holds: bool,
    /// The name of what it exerts as one quantity, if it has one.
    pub effort: Option<&'static str>,
    /// What is possible and probably not meant, given its name and its scalar arguments as far as they are plain numbers.
    pub doubt: Option<Doubt>,
}

impl LoadForm {
    /// What each of its unnamed arguments names.
    pub fn acts(&self) -> impl Iterator<Item = Acts> {
        self.on.iter().chain(std::iter::repeat(self.on.last()).flatten()).copied()
    }
}

/// Internal states of a load: deflections along what it resists, zero at the start. Each is called by the load's name and this one.
#[derive(Clone, Copy, Debug)]
pub enum Owned {
    /// One, as large as an argument says.
    One { name: &'static str, size: &'static str },
    /// One for each element of a backbone, as large as the way at which it yields.
    Elements { name: &'static str, backbone: &'static str },
    /// Of a friction one for each component of the sliding, as large as one argument over another.
    Bristles { name: &'static str, most: &'static str, stiffness: &'static str },
}

/// A warning, if there is one, of a load with this name and these arguments.
pub type Doubt = fn(&str, &[Option<f64>]) -> Option<String>;

/// What a load acts on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Acts {
    /// A place of a body or of the ground.
    Place,
    /// The one angle of a joint, or in the plane of a body.
    Rotor,
    /// The one travel of a joint.
    Travel,
    /// A joint whose surfaces slide on each other.
    Bearing,
    /// A joint, in place of its rows.
    Joint,
    /// A body that turns.
    Body,
    /// A toothing of a body.
    Toothing,
    /// An expression of positions.
    Expression,
    /// The same, or what has one angle or travel alone, by its name.
    Way,
}

/// What stands behind a load, `= law`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// Nothing: its arguments say all.
    None,
    Value(Dimension),
    /// What makes a power of the rate of the expression that the load acts on.
    Conjugate,
    /// Components along the axes of the world, or one value where a direction is among the arguments.
    Components(Dimension),
}

/// How a load is written, beyond its word.
#[derive(Clone, Copy, Debug)]
pub struct Written {
    /// Its first unnamed argument is a name without a point.
    pub is_name: bool,
    /// A direction is among its arguments.
    pub is_directed: bool,
    /// Its law is several values in parentheses.
    pub has_components: bool,
}
