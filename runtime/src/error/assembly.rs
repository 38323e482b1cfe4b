//! Errors of assembly, kinematics and projection.

use crate::mechanism::{Assemble, Row, name_row};
use crate::real::Real;
use crate::vector::Vector;
use core::error::Error;
use core::fmt::{self, Display, Formatter};

/// Why no consistent position, velocity or acceleration was found.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum AssemblyError {
    /// The iteration ended away from the constraints.
    NoConvergence {
        /// The row that is violated most; for a held quantity `what` is `"held"`.
        row: Row,
        /// Its residual, m, rad or the row's own unit.
        residual: f64,
        /// Iterations made.
        iterations: u32,
    },
    /// A row depends on the others at this position: a dead centre, a redundant joint or contradicting conditions.
    RankDeficient {
        /// The row, or the velocity, at which the factorisation broke down.
        row: Row,
        /// The relative pivot found there.
        pivot: f64,
    },
    /// A residual became infinite or NaN.
    NonFinite {
        /// The row in which it was seen first.
        row: Row,
    },
    /// An angle constraint ended half a turn away from where it should be.
    Flipped {
        /// The row sin Δθ = 0 whose cosine is negative.
        row: Row,
    },
    /// A number that was given is infinite or NaN.
    GivenNotFinite {
        /// The coordinate, velocity or held quantity; `"time"`.
        what: &'static str,
    },
    /// An orientation of the given position has no direction.
    NoOrientation {
        /// The name of its first entry.
        what: &'static str,
        /// The length of the pair or quaternion.
        length: f64,
    },
    /// The number of given values is not the number of coordinates.
    WrongLength {
        /// How many are needed.
        needed: usize,
        /// How many were given.
        given: usize,
    },
    /// A condition's index is out of range.
    NoSuchCondition {
        /// The index.
        index: usize,
        /// How many conditions the mechanism has.
        count: usize,
    },
}

impl AssemblyError {
    /// The iteration ended with these residuals.
    #[cold]
    pub(crate) fn worst<R: Real, M: Assemble<R>>(model: &M, phi: &M::Lambda, iterations: u32) -> Self {
        let worst = phi.as_slice().iter().enumerate().fold((0, R::ZERO), |(at, largest), (row, entry)| {
            if entry.abs() <= largest { (at, largest) } else { (row, entry.abs()) }
        });
        let row = name_row(model, Some(worst.0));
        AssemblyError::NoConvergence { row, residual: worst.1.to_f64(), iterations }
    }
}

impl Display for AssemblyError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            AssemblyError::NoConvergence { row, residual, iterations } => write!(
                f,
                "the mechanism cannot be assembled: {row} is still off by {residual:.3e} after {iterations} \
                 iterations; start from a nearer position, or check that lengths and held values can be reached"
            ),
            AssemblyError::RankDeficient { row, pivot } => write!(
                f,
                "{row} depends on the other rows at this position: relative pivot {pivot:.1e}; move away from the \
                 dead centre, hold another coordinate, or remove the redundant joint"
            ),
            AssemblyError::NonFinite { row } => write!(
                f,
                "the residual of {row} is infinite or NaN; check the parameters, the time and the start position"
            ),
            AssemblyError::Flipped { row } => write!(
                f,
                "{row} was assembled half a turn away from its angle; start from a position that has the bodies \
                 about the right way round"
            ),
            AssemblyError::GivenNotFinite { what } => {
                write!(f, "`{what}` was given as infinite or NaN; give a finite number")
            }
            AssemblyError::NoOrientation { what, length } => write!(
                f,
                "the orientation that begins with `{what}` is of length {length:e} and so points nowhere; give a pair \
                 (cos, sin) or a quaternion (w, x, y, z) of about length 1, such as (1, 0) or (1, 0, 0, 0)"
            ),
            AssemblyError::WrongLength { needed, given } => write!(
                f,
                "{given} motions were given for {needed} independent coordinates; give one for each, in the order of \
                 `independent()`"
            ),
            AssemblyError::NoSuchCondition { index, count } => write!(
                f,
                "there is no condition {index} among the {count} of this mechanism; use indices into `conditions()`"
            ),
        }
    }
}

impl Error for AssemblyError {}
