//! What anyone may know of a kind of coupling between joints or bodies.

use super::{Acts, Form, RowForm};
use crate::units::Dimension;

/// A kind of coupling.
#[derive(Debug)]
pub struct CouplingForm {
    /// How it is written.
    pub call: Form,
    /// What it holds, for documents.
    pub holds: &'static str,
    pub means: Means,
}

/// What a coupling holds.
#[derive(Clone, Copy, Debug)]
pub enum Means {
    /// One coordinate is a factor times another, and a phase.
    Proportion { kind: &'static Proportion, factor: Factor },
    /// The angles of two arguments add up to a number of times the angle of a third.
    Sum { of: [usize; 2], times: &'static str, by: usize },
    /// The teeth of two toothings mesh: a sum of angles by numbers of teeth, and which of them face which spaces.
    Teeth { row: &'static RowForm },
}

/// One coordinate is a factor times another, and a phase, which may be an argument `phase`.
#[derive(Debug)]
pub struct Proportion {
    /// Its kind in an exported definition.
    pub exported: &'static str,
    pub row: RowForm,
    /// The keys of its unnamed arguments in an exported definition, and what they name.
    pub on: [(&'static str, Acts); 2],
    /// Which of them is the factor times the other.
    pub driven: usize,
    /// The name of the factor and what it measures.
    pub factor: (&'static str, Dimension),
    pub phase: Dimension,
}

/// How the factor follows from named arguments.
#[derive(Clone, Copy, Debug)]
pub enum Factor {
    Argument(&'static str),
    /// One over another.
    Quotient {
        of: &'static str,
        to: &'static str,
    },
    /// One for each turn.
    PerTurn(&'static str),
}
