//! What can go wrong with a member, and with a batch as a whole.

use linkwright::{AssemblyError, SettingError, StepError};
use std::error::Error;
use std::fmt::{self, Display, Formatter};

/// Why a member does not move.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Failure {
    /// A parameter is not finite or out of its bounds, or a mass is not positive.
    Parameters(SettingError),
    /// With its parameters it cannot be assembled near the start.
    Assembly(AssemblyError),
    /// A step failed, or a state that was given makes no sense.
    Step(StepError),
}

impl Display for Failure {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Failure::Parameters(error) => error.fmt(f),
            Failure::Assembly(error) => error.fmt(f),
            Failure::Step(error) => error.fmt(f),
        }
    }
}

impl Error for Failure {}

impl From<SettingError> for Failure {
    fn from(error: SettingError) -> Self {
        Failure::Parameters(error)
    }
}

impl From<AssemblyError> for Failure {
    fn from(error: AssemblyError) -> Self {
        Failure::Assembly(error)
    }
}

impl From<StepError> for Failure {
    fn from(error: StepError) -> Self {
        Failure::Step(error)
    }
}

/// Why there is no batch.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum BatchError {
    /// It was to have no members.
    Empty,
    /// No member can be prepared; this is why the first cannot.
    NoMember(Failure),
    /// There is no member of this index; there are so many.
    OutOfRange {
        /// The index.
        member: usize,
        /// How many members there are.
        len: usize,
    },
    /// What was given for this member makes no sense; the member is what it was.
    Member {
        /// Its index.
        member: usize,
        /// What is wrong.
        failure: Failure,
    },
}

impl Display for BatchError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            BatchError::Empty => f.write_str("a batch has at least one member; 0 were asked for"),
            BatchError::NoMember(failure) => {
                write!(f, "no member of the batch can be prepared; the first: {failure}")
            }
            BatchError::OutOfRange { member, len } => {
                write!(f, "there is no member {member}: the batch has {len}, counted from 0")
            }
            BatchError::Member { member, failure } => write!(f, "member {member}: {failure}"),
        }
    }
}

impl Error for BatchError {}
