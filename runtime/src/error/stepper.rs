//! Errors of steppers: a code each, whose text is linked only where it is written.

use core::error::Error;
use core::fmt::{self, Display, Formatter};

/// Why a stepper did not do what it was asked to. It keeps its last good state, and goes on from it when it is called again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
#[repr(u8)]
pub enum StepError {
    /// The size of the step is zero, negative, not finite, or so small that time would stand.
    StepSize = 1,
    /// An input is infinite or NaN.
    Input = 2,
    /// A state that was given is infinite or NaN, or an orientation in it is not of length 1.
    State = 3,
    /// The state at the end of the step is infinite or NaN.
    NotFinite = 4,
    /// The equations of a stage, and of positions near it, have no solution: constraints lost rank, or M is singular.
    Breakdown = 5,
    /// The state at the end of the step is off the constraints by more than a tenth of a radian, or what makes as much of a length.
    Diverged = 6,
    /// A saved state is of another definition, or of another version of the format.
    OtherModel = 7,
    /// The mechanism holds gates of its contacts or memories within steps, and a stepper finds no times between them.
    HeldGates = 8,
}

impl StepError {
    /// The code, from 1 on.
    pub const fn code(self) -> u8 {
        self as u8
    }

    /// What is wrong, and what to do.
    pub const fn text(self) -> &'static str {
        match self {
            StepError::StepSize => {
                "the size of a step must be positive, finite, and no less than a millionth of what the clock resolves"
            }
            StepError::Input => "an input is not finite; the state is that before the step",
            StepError::State => {
                "the state is not finite, or an orientation is not of length 1; the state before is kept"
            }
            StepError::NotFinite => {
                "the step ended in a number that is not finite; take a smaller step, or look for a force that grows without bound"
            }
            StepError::Breakdown => {
                "the equations have no solution here: a singular position, which `near_singular` names; change the input or the state"
            }
            StepError::Diverged => {
                "the step left the constraints; take a smaller step, a stronger correction, or `assemble` the state"
            }
            StepError::OtherModel => {
                "the saved state belongs to another definition, or to another version of this library"
            }
            StepError::HeldGates => {
                "the mechanism holds gates of contacts or memories, and a stepper finds no touch or event within a step; write `options { contact = live; }`, \
                 or keep what memories hold beside the stepper as inputs"
            }
        }
    }
}

impl Display for StepError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(self.text())
    }
}

impl Error for StepError {}
