//! How the elements of the language are written, and what anyone may know of them: plain data, without equations.
//!
//! The forms themselves stand with their elements, one file each. Those who read, name and check elements are handed a
//! [`Vocabulary`] and know no element by itself.

mod body;
mod contact;
mod coupling;
mod joint;
mod load;
mod loose;
pub mod row;
mod table;
mod toothing;

pub use body::{BodyForm, Deforms, Length, Moment, Outline, SECTIONS, Solid, Volume, second_moments};
pub use contact::{CONTACT_LAWS, ContactLaw, ContactLawForm, SURFACES, SurfaceForm, SurfaceKind};
pub use coupling::{CouplingForm, Factor, Means, Proportion};
pub use joint::{Alone, Bearing, Freer, Given, JointAxes, JointForm, OfParticle, Spans, degrees_between};
pub use load::{Acts, Law, LoadForm, Owned, Written};
pub use loose::{LOOSE, LooseForm};
pub use row::{Measures, RowForm};
pub use table::{Interpolation, Outside};
pub use toothing::{INVOLUTE, Rim, ToothingForm};

use crate::units::Dimension;

/// In how many dimensions a mechanism moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Space {
    Planar,
    Spatial,
}

impl Space {
    /// As written.
    pub fn text(self) -> &'static str {
        match self {
            Self::Planar => "planar",
            Self::Spatial => "spatial",
        }
    }

    /// Components of a vector.
    pub fn dimensions(self) -> usize {
        match self {
            Self::Planar => 2,
            Self::Spatial => 3,
        }
    }
}

/// All words of elements.
#[derive(Clone, Copy, Debug)]
pub struct Vocabulary {
    pub bodies: &'static [&'static BodyForm],
    pub joints: fn(Space) -> Vec<&'static JointForm>,
    pub toothings: &'static [&'static ToothingForm],
    pub couplings: &'static [&'static CouplingForm],
    pub loads: fn(Space) -> Vec<&'static LoadForm>,
    pub surfaces: &'static [SurfaceForm],
    pub contact_laws: &'static [ContactLawForm],
    /// What a contact is as a load.
    pub contact: &'static LoadForm,
    /// What a joint is as a load whose rows yield.
    pub penalty: &'static LoadForm,
}

/// How an element is written: `word(positional, …, name = value, …)`.
#[derive(Debug)]
pub struct Form {
    pub word: &'static str,
    /// What other programs call it.
    pub elsewhere: &'static [&'static str],
    pub positional: &'static [Positional],
    pub named: &'static [Argument],
}

/// What a positional argument is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Positional {
    Place,
    /// As many further places as are written.
    Places,
    Line,
    /// The name of a joint or body.
    Rotor,
    /// A toothing of a body, `sun.rim`.
    Toothing,
    Expression,
}

/// An argument with a name.
#[derive(Clone, Copy, Debug)]
pub struct Argument {
    pub name: &'static str,
    pub need: Need,
    pub value: Value,
    pub sign: Sign,
}

/// What an argument's sign may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    Any,
    /// It is positive, whatever parameters make of it.
    Positive,
    /// Zero is possible, less is not.
    NotNegative,
    /// It pulls back: less than zero is possible and probably not meant, and where all such are zero nothing acts.
    Restoring,
}

/// Whether an argument must be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Need {
    Always,
    /// Unless one of the places is a marker, whose z it then is.
    UnlessMarked,
    Never,
}

/// What an argument is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Value {
    /// Components of which only the ratios matter.
    Direction,
    /// A number of parameters; zero where it is not written.
    Scalar(Dimension),
    /// A number of parameters and time.
    Moving(Dimension),
    /// A law of what moves: parameters, time, positions, inputs and states. Zero where it is not written.
    Varying(Dimension),
    /// The rate of another argument, by a law: its derivative where it is not written, which has to be where that depends on inputs
    /// or states and a third is written.
    RateOf { varying: &'static str, for_sake_of: &'static str },
    /// A number of parameters for all axes, or in parentheses one for each; zero where it is not written.
    Diagonal(Dimension),
    /// A number of parameters in the unit of the way that a load resists.
    Way,
    /// A number of parameters: force or torque for each unit of that way.
    Stiffness,
    /// The same, of velocities too.
    Law(Dimension),
    /// A number of parameters: what a friction resists with (a force or torque) or none of that, times powers of the way that it slides
    /// and of time.
    Along { effort: bool, way: i32, time: i32 },
    /// A number that is known at expansion and at least one.
    Exponent,
    /// The name of a table: force or torque by the way, on first loading.
    Backbone,
    /// The name of a table that repeats itself after a turn: a length by an angle.
    Outline,
    /// Of parameters and the parameter of its own joint's curve, which it is itself where it is not written.
    OfParameter(Dimension),
    /// A number of parameters whose dimension follows from that of a contact's gap.
    OfGap,
    /// One of several words, or the name of a material.
    Word,
    /// Of teeth: a law of what moves, or what is made of their shape by [`INVOLUTE`].
    TeethStiffness,
    /// Of teeth: a number of parameters, in `always(…)` also where they do not touch.
    TeethDamping,
}

impl Argument {
    pub const fn direction(name: &'static str, need: Need) -> Self {
        Argument { name, need, value: Value::Direction, sign: Sign::Any }
    }

    pub const fn scalar(name: &'static str, need: Need, dimension: Dimension) -> Self {
        Argument { name, need, value: Value::Scalar(dimension), sign: Sign::Any }
    }

    pub const fn moving(name: &'static str, need: Need, dimension: Dimension) -> Self {
        Argument { name, need, value: Value::Moving(dimension), sign: Sign::Any }
    }

    pub const fn diagonal(name: &'static str, need: Need, dimension: Dimension) -> Self {
        Argument { name, need, value: Value::Diagonal(dimension), sign: Sign::Any }
    }

    /// What is none of these.
    pub const fn of(name: &'static str, need: Need, value: Value) -> Self {
        Argument { name, need, value, sign: Sign::Any }
    }

    pub const fn positive(self) -> Self {
        Argument { sign: Sign::Positive, ..self }
    }

    pub const fn not_negative(self) -> Self {
        Argument { sign: Sign::NotNegative, ..self }
    }

    pub const fn restoring(self) -> Self {
        Argument { sign: Sign::Restoring, ..self }
    }

    pub fn is_direction(&self) -> bool {
        self.value == Value::Direction
    }

    /// What it measures, whatever it stands with; a direction may measure anything.
    pub fn dimension(&self) -> Option<Dimension> {
        match self.value {
            Value::Direction
            | Value::RateOf { .. }
            | Value::Way
            | Value::Along { .. }
            | Value::Stiffness
            | Value::Exponent
            | Value::Backbone
            | Value::Outline
            | Value::OfGap
            | Value::Word
            | Value::TeethStiffness
            | Value::TeethDamping => None,
            Value::Scalar(dimension)
            | Value::Moving(dimension)
            | Value::Varying(dimension)
            | Value::Law(dimension)
            | Value::OfParameter(dimension)
            | Value::Diagonal(dimension) => Some(dimension),
        }
    }

    /// Whether the parser asks for it.
    pub fn is_required(&self) -> bool {
        self.need == Need::Always
    }
}

/// Two places.
pub const PLACES: &[Positional] = &[Positional::Place, Positional::Place];
