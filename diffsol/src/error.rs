//! What can go wrong on the way to a solver and in it.

use core::fmt::{self, Display, Formatter};
use diffsol::DiffsolError;
use linkwright::SimulationError;

/// Why there is no problem or no solution.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Error {
    /// The start, a setting, or the equations of motion: the error that a simulation would name.
    Mechanism(SimulationError),
    /// The start time is infinite or NaN.
    StartTime {
        /// The time, s.
        time: f64,
    },
    /// Contacts are rigid: their impulses are no part of differential equations.
    RigidContact {
        /// The first of them.
        contact: &'static str,
    },
    /// Events set memories: what is held between them is no part of differential equations.
    Memory {
        /// The first of them.
        memory: &'static str,
    },
    /// A time at which a state is asked for is before the one before it or the start, infinite or NaN.
    Time {
        /// Its index.
        index: usize,
        /// The time, s.
        time: f64,
    },
    /// The solver took as many steps as it may and is not at the end.
    TooManySteps {
        /// The time it came to, s.
        time: f64,
        /// The steps taken.
        steps: usize,
    },
    /// The solver gave up, without fault of the equations.
    Solver(DiffsolError),
}

impl Display for Error {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Error::Mechanism(error) => Display::fmt(error, f),
            Error::StartTime { time } => {
                write!(f, "the start time {time} s is not finite; give a finite one")
            }
            Error::RigidContact { contact } => write!(
                f,
                "`{contact}` is a rigid contact, whose impulses a solver of differential equations does not know; move the mechanism \
                 with a `Simulation`, or give the contact a law that yields"
            ),
            Error::Memory { memory } => write!(
                f,
                "`{memory}` is a memory, and a solver of differential equations does not know the events that set it; move the mechanism with \
                 a `Simulation`"
            ),
            Error::Time { index, time } => write!(
                f,
                "time {index} of those asked for, {time} s, is not finite or before the one before it; give times in \
                 ascending order from the start on"
            ),
            Error::TooManySteps { time, steps } => write!(
                f,
                "after {steps} steps the solver is at t = {time} s; loosen the tolerances, choose an implicit method if the \
                 motion is stiff, or allow more steps"
            ),
            Error::Solver(error) => write!(
                f,
                "the solver gave up: {error}; loosen the tolerances, choose another method, or look at the motion just \
                 before"
            ),
        }
    }
}

impl core::error::Error for Error {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Error::Mechanism(error) => Some(error),
            Error::Solver(error) => Some(error),
            _ => None,
        }
    }
}

impl From<SimulationError> for Error {
    fn from(error: SimulationError) -> Self {
        Error::Mechanism(error)
    }
}

impl From<DiffsolError> for Error {
    fn from(error: DiffsolError) -> Self {
        Error::Solver(error)
    }
}
