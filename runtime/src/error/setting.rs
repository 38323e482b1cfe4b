//! Errors of what a formulation is given.

use core::error::Error;
use core::fmt::{self, Display, Formatter};

/// A parameter of a formulation that makes no sense.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SettingError {
    /// The parameter.
    pub what: &'static str,
    /// The value it was given.
    pub value: f64,
    /// What it must be.
    pub must_be: &'static str,
}

impl Display for SettingError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{} is {}; it must be {}", self.what, self.value, self.must_be)
    }
}

impl Error for SettingError {}
