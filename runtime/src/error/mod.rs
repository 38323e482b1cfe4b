//! All errors of this crate and their texts, a file for each type.
//!
//! Each message has three parts: what is wrong, the numbers, what to do. Numbers are `f64` whatever the scalar, so
//! that one error type serves all; names are those of the mechanism's definition. Where errors arise is elsewhere.

mod assembly;
mod linearisation;
mod setting;
mod simulation;
mod stepper;

pub use assembly::AssemblyError;
pub use linearisation::LinearisationError;
pub use setting::SettingError;
pub use simulation::SimulationError;
pub use stepper::StepError;

use crate::mechanism::Row;
use core::fmt::{self, Display, Formatter};

impl Display for Row {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "`{}` ({})", self.of, self.what)
    }
}
