//! Why no periodic motion was found.

use core::error::Error;
use core::fmt::{self, Display, Formatter};
use linkwright::{AssemblyError, LinearisationError, SettingError};

/// Why there is no periodic motion, or none was found.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum PeriodicError {
    /// The mechanism cannot have this parameter.
    Setting(SettingError),
    /// A state could not be assembled from its coordinates.
    Assembly(AssemblyError),
    /// The equations or their derivatives have no value along the motion.
    Linearisation(LinearisationError),
    /// The period is not a positive number.
    Period {
        /// The parameter.
        value: f64,
        /// s.
        period: f64,
    },
    /// There is no output of that name.
    NoSuchOutput {
        /// The name.
        name: &'static str,
        /// Those that there are.
        given: &'static [&'static str],
    },
    /// There is no coordinate of that name among those of the motion.
    NoSuchCoordinate {
        /// The name.
        name: &'static str,
        /// Those that there are.
        given: Vec<&'static str>,
    },
    /// Not as many coordinates as degrees of freedom.
    Incomplete {
        /// Degrees of freedom.
        needed: usize,
        /// Coordinates.
        given: usize,
    },
    /// A body turns on a ball: its orientation has no three coordinates that could repeat.
    Orientation {
        /// The component of ω that stands for it.
        rate: &'static str,
    },
    /// The mechanism holds something from event to event.
    Events {
        /// Its name.
        mechanism: &'static str,
    },
    /// The law switches without end.
    Chatter {
        /// s.
        time: f64,
        /// The output that passes its level.
        output: &'static str,
    },
    /// Newton's iteration did not close the cycle.
    NotClosed {
        /// The parameter.
        value: f64,
        /// What is left of the largest difference, in swings of its coordinate.
        residual: f64,
        /// Iterations made.
        iterations: u32,
    },
    /// The second period is not as the first.
    NotPeriodic {
        /// The parameter.
        value: f64,
        /// s.
        period: f64,
        /// By how much of its swing a coordinate differs.
        off: f64,
    },
    /// The start does not move the mechanism: what is asked of a branch makes no step.
    NoStep {
        /// The step.
        step: f64,
    },
}

impl Display for PeriodicError {
    fn fmt(&self, to: &mut Formatter<'_>) -> fmt::Result {
        match self {
            PeriodicError::Setting(error) => write!(to, "{error}"),
            PeriodicError::Assembly(error) => {
                write!(to, "the beginning of the cycle cannot be assembled: {error}")
            }
            PeriodicError::Linearisation(error) => {
                write!(to, "the motion cannot be followed through its cycle: {error}")
            }
            PeriodicError::Period { value, period } => {
                write!(to, "at {value} the period is {period} s; it must be positive and finite")
            }
            PeriodicError::NoSuchOutput { name, given: [] } => {
                write!(
                    to,
                    "there is no output \"{name}\": the mechanism has none; add `output {name} [unit] = …;`"
                )
            }
            PeriodicError::NoSuchOutput { name, given } => {
                write!(to, "there is no output \"{name}\"; there are {}", given.join(", "))
            }
            PeriodicError::NoSuchCoordinate { name, given } => {
                write!(to, "\"{name}\" is no coordinate of the motion; these are {}", given.join(", "))
            }
            PeriodicError::Incomplete { needed, given } => write!(
                to,
                "{given} coordinates cannot say how {needed} degrees of freedom repeat; name {needed} by `options {{ independent = (…); }}`"
            ),
            PeriodicError::Orientation { rate } => write!(
                to,
                "{rate} stands for an orientation without coordinates, and what has none cannot be compared after a cycle; \
                 write joints with angles, `universal` or three `revolute`, in place of the ball"
            ),
            PeriodicError::Events { mechanism } => write!(
                to,
                "{mechanism} holds from event to event what its contacts do or its memories are, which this integration does not see; write contacts as laws of their gaps, and leave memories out"
            ),
            PeriodicError::Chatter { time, output } => write!(
                to,
                "{output} passes its level again and again at {time} s; the law has no motion along its kink, or the level is touched by noise"
            ),
            PeriodicError::NotClosed { value, residual, iterations } => write!(
                to,
                "at {value} the cycle does not close: after {iterations} iterations a coordinate is off by {residual:.1e} of its swing; \
                 begin nearer, with `settle` of more periods or from a motion at a neighbouring value"
            ),
            PeriodicError::NotPeriodic { value, period, off } => write!(
                to,
                "at {value} the motion returns after {period} s, but then goes on in another way: after one more period a coordinate is off by \
                 {off:.1e} of its swing; give the period of the laws and inputs"
            ),
            PeriodicError::NoStep { step } => {
                write!(to, "a branch cannot be followed in steps of {step}; write a positive step")
            }
        }
    }
}

impl Error for PeriodicError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            PeriodicError::Setting(error) => Some(error),
            PeriodicError::Assembly(error) => Some(error),
            PeriodicError::Linearisation(error) => Some(error),
            _ => None,
        }
    }
}
