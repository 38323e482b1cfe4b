//! What can be wrong with a definition, and what can go wrong in a solution.

use std::fmt::{self, Display, Formatter};

/// Why a definition makes no mechanism here. `part` is the name of the joint, body, load, … at fault.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum DefinitionError {
    /// The text is no JSON.
    Json {
        /// What the parser says.
        message: String,
    },
    /// A field is missing or of another form than a definition has it.
    Malformed {
        /// The part that has it.
        part: String,
        /// The field, or what is expected.
        field: String,
    },
    /// A name that nothing declares.
    UnknownName {
        /// The part that uses it.
        part: String,
        /// The name.
        name: String,
    },
    /// A kind of joint, load, body, …, a function or an operator that the language does not have.
    UnknownKind {
        /// The part of that kind.
        part: String,
        /// The kind.
        kind: String,
    },
    /// A unit that cannot be read.
    Unit {
        /// The part that uses it.
        part: String,
        /// The unit as written.
        unit: String,
    },
    /// A value that is infinite, NaN, out of its bounds, without direction, or names what may not stand there.
    Value {
        /// The part that has it.
        part: String,
        /// What is wrong with it.
        what: String,
    },
    /// The language has it, this solver does not.
    NotThereYet {
        /// The part that needs it.
        part: String,
        /// What it is.
        what: String,
    },
}

impl DefinitionError {
    pub(crate) fn malformed(part: &str, field: &str) -> Self {
        DefinitionError::Malformed { part: part.to_string(), field: field.to_string() }
    }
    pub(crate) fn unknown(part: &str, name: &str) -> Self {
        DefinitionError::UnknownName { part: part.to_string(), name: name.to_string() }
    }
    pub(crate) fn kind(part: &str, kind: &str) -> Self {
        DefinitionError::UnknownKind { part: part.to_string(), kind: kind.to_string() }
    }
    pub(crate) fn value(part: &str, what: &str) -> Self {
        DefinitionError::Value { part: part.to_string(), what: what.to_string() }
    }
    pub(crate) fn not_there_yet(part: &str, what: &str) -> Self {
        DefinitionError::NotThereYet { part: part.to_string(), what: what.to_string() }
    }
}

impl Display for DefinitionError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            DefinitionError::Json { message } => write!(f, "the definition is no JSON: {message}"),
            DefinitionError::Malformed { part, field } => {
                write!(
                    f,
                    "`{part}`: {field} is missing or of another form; give a model's `DEFINITION`, version 1"
                )
            }
            DefinitionError::UnknownName { part, name } => {
                write!(f, "`{part}`: nothing is called `{name}` that may stand there")
            }
            DefinitionError::UnknownKind { part, kind } => {
                write!(f, "`{part}`: the kind `{kind}` is unknown")
            }
            DefinitionError::Unit { part, unit } => write!(f, "`{part}`: `{unit}` is no unit"),
            DefinitionError::Value { part, what } => write!(f, "`{part}`: {what}"),
            DefinitionError::NotThereYet { part, what } => {
                write!(f, "`{part}`: {what} is not there yet in the generic solver")
            }
        }
    }
}

impl std::error::Error for DefinitionError {}

/// Why there is no acceleration, no projection or no step.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// A list of another length than the mechanism's.
    Length {
        /// What it is of.
        what: &'static str,
        /// The mechanism's.
        expected: usize,
        /// That of the list.
        given: usize,
    },
    /// No body, parameter or input has this name.
    UnknownName {
        /// The name.
        name: String,
    },
    /// A time, position, velocity, input or setting that is infinite, NaN or of no use.
    Value {
        /// What it is.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// A force, constraint or acceleration became infinite or NaN.
    NotFinite {
        /// What became so.
        what: String,
        /// When, s.
        time: f64,
    },
    /// The augmented matrix is singular: the position is singular, rows repeat others, or something without mass moves freely.
    Singular {
        /// When, s.
        time: f64,
        /// The first row that depends on those before it, as `joint.row`; none where all are independent.
        row: Option<String>,
    },
    /// The constraints are not met after as many iterations as there may be.
    NotConverged {
        /// When, s.
        time: f64,
        /// The row that is met worst, as `joint.row`.
        row: String,
        /// By how much it is missed, m, rad or m².
        residual: f64,
    },
    /// The phase of a gear or rack is what the start gives; see [`keep_phases`](crate::Mechanism::keep_phases).
    Phase {
        /// The coupling.
        name: String,
    },
}

impl Display for Error {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Error::Length { what, expected, given } => {
                write!(f, "{given} {what} are given where the mechanism has {expected}")
            }
            Error::UnknownName { name } => write!(f, "nothing is called `{name}`"),
            Error::Value { what, value } => write!(f, "{what} is {value}, which cannot be"),
            Error::NotFinite { what, time } => write!(f, "{what} is not finite at t = {time} s"),
            Error::Singular { time, row: Some(row) } => write!(
                f,
                "no accelerations at t = {time} s: the position is singular, `{row}` repeats the rows before it"
            ),
            Error::Singular { time, row: None } => {
                write!(f, "no accelerations at t = {time} s: something without mass or inertia moves freely")
            }
            Error::NotConverged { time, row, residual } => {
                write!(f, "the constraints cannot be met at t = {time} s: `{row}` is off by {residual:e}")
            }
            Error::Phase { name } => {
                write!(f, "the phase of `{name}` is not known yet; call `keep_phases` at the start")
            }
        }
    }
}

impl std::error::Error for Error {}
