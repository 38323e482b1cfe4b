//! Definitions that stand in texts: a file of their own, or a Rust file around the macro. Text → tokens with the places
//! they were read from, so that an error can say file, line and column wherever the compiler runs.
//!
//! The spans of a procedural macro know nothing of files that rustc has not read. Regions carry serial numbers of their
//! tokens anyway; what is kept here is the place of each number. What tokens mean is left to `syntax`.

mod brought;
mod csv;
mod delimiters;
pub mod disk;
mod flex;
mod invocations;
mod lexer;
mod macro_rules;
mod shelf;
mod snippet;
mod tables;
mod tokens;
pub mod written;

pub(crate) use brought::brought;
pub use flex::modes;
pub use invocations::{Invocation, invocations, is_rust};
pub(crate) use shelf::{FileOf, Shelf};
pub use shelf::{PARTS, library};
pub use snippet::{compile_errors, warnings};
pub(crate) use tables::read_files;
pub(crate) use tokens::definition_at;
pub use tokens::{Tokens, definition};

use crate::diagnostics::Severity;
use std::ops::Range;

/// A text and where its lines begin.
#[derive(Clone, Debug)]
pub struct Source {
    /// The file, as shown in messages.
    pub name: String,
    pub text: String,
    /// The first byte of each line.
    lines: Vec<usize>,
}

/// Line and column, both from 1; columns are characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Position {
    pub line: usize,
    pub column: usize,
}

impl Source {
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Self {
        let text = text.into();
        let lines = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect();
        Self { name: name.into(), text, lines }
    }

    /// Where a byte stands.
    pub fn position(&self, byte: usize) -> Position {
        let line = self.line_of(byte);
        let before = self.text.get(self.lines[line - 1]..byte).unwrap_or_default();
        Position { line, column: before.chars().filter(|c| *c != '\u{feff}').count() + 1 }
    }

    /// The line of a byte, from 1.
    fn line_of(&self, byte: usize) -> usize {
        self.lines.partition_point(|start| *start <= byte)
    }

    /// A line from 1, without its end, and its first byte.
    fn line(&self, line: usize) -> (&str, usize) {
        let start = self.lines[line - 1];
        (self.text[start..].lines().next().unwrap_or_default(), start)
    }
}

/// An error or a warning at its place in a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Located {
    pub severity: Severity,
    /// Bytes; empty where something is missing at the end.
    pub range: Range<usize>,
    /// What is wrong, why, and what to write instead.
    pub message: String,
    /// Other places that the error speaks of.
    pub notes: Vec<(Range<usize>, String)>,
}

impl Located {
    pub fn new(range: Range<usize>, message: impl Into<String>) -> Self {
        Self { severity: Severity::Error, range, message: message.into(), notes: Vec::new() }
    }

    /// Points at another place too.
    pub fn note(mut self, range: Range<usize>, message: impl Into<String>) -> Self {
        self.notes.push((range, message.into()));
        self
    }
}
