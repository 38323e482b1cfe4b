//! Errors of a stage, and warnings, collected: a region of the source, a text, and notes that point at other places.
//!
//! A stage pushes every error it finds and its caller stops at the stage's end ([`Diagnostics::finish`]). Warnings have a
//! collection of their own, which lives as long as the compilation. The texts themselves stand in `messages`, what
//! rustc is told in `tokens`.

mod tokens;

pub(crate) use tokens::compile_error;

use proc_macro2::Span;
use std::collections::BTreeSet;
use std::fmt;

/// Those beyond this many are counted, not kept.
const MOST: usize = 50;

/// A stretch of the source, from the start of one token to the end of another.
///
/// Spans cannot be joined in a procedural macro of the stable compiler, so both ends are kept apart.
#[derive(Clone, Copy, Debug)]
pub struct Region {
    /// The first token's.
    pub start: Span,
    /// The last token's.
    pub end: Span,
    /// Serial numbers of both tokens, zero where unknown. The rounds of a `repeat` share them.
    tokens: (u32, u32),
    /// Which use of a part brought it here, from 1; zero outside of parts.
    brought: u32,
}

impl Region {
    /// The region of the token with this serial number (from 1).
    pub(crate) fn of_token(span: Span, serial: u32) -> Self {
        Self { start: span, end: span, tokens: (serial, serial), brought: 0 }
    }

    /// Serial numbers of its first and last token, zero where it is none: the end of the definition.
    pub(crate) fn tokens(self) -> (usize, usize) {
        (self.tokens.0 as usize, self.tokens.1 as usize)
    }

    /// From the start of `self` to the end of `last`.
    pub fn to(self, last: Region) -> Region {
        Region { end: last.end, tokens: (self.tokens.0, last.tokens.1), ..self }
    }

    /// The same, read for this use of a part.
    pub(crate) fn brought_by(self, brought: u32) -> Region {
        Region { brought, ..self }
    }

    /// Which use of a part brought it here, from 1; zero outside of parts.
    pub(crate) fn brought(self) -> usize {
        self.brought as usize
    }

    /// What the rounds of a `repeat` have in common.
    pub(crate) fn serials(self) -> (u32, u32) {
        self.tokens
    }

    /// One span: the whole region where spans can be joined, else its start.
    pub fn span(self) -> Span {
        self.start.join(self.end).unwrap_or(self.start)
    }
}

impl From<Span> for Region {
    fn from(span: Span) -> Self {
        Self { start: span, end: span, tokens: (0, 0), brought: 0 }
    }
}

/// What a warning is of: the word that `#[allow(…)]` takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Lint {
    /// Declared, and named by nothing.
    Unused,
    /// A load or the like that changes nothing.
    NoEffect,
    /// A place outside of the shape that it belongs to.
    Outside,
    /// A stiffness or damping below zero.
    Negative,
    /// A moment of inertia that mass and size cannot have.
    Proportion,
    /// A table whose curvature jumps where accelerations follow it.
    Kinks,
    /// A reaction that is one of many.
    Shared,
    /// A cord whose tension nothing names.
    Unwatched,
    /// An internal state that grows by itself at the start.
    UnstableState,
    /// A table that is asked for more than its knots.
    OutsideTable,
    /// Teeth that are undercut, reach too far or barely touch.
    Teeth,
    /// A contact that is closed at the start: an error, unless it is allowed.
    Penetration,
    /// A beam that is thick, or whose shapes do not suit what holds it.
    Slender,
    /// A beam without stiffening that turns fast or is pressed together.
    Stiffening,
    /// Friction that presses harder by itself than it lets go.
    Locks,
}

impl Lint {
    pub const ALL: [Lint; 15] = [
        Self::Unused,
        Self::NoEffect,
        Self::Outside,
        Self::Negative,
        Self::Proportion,
        Self::Kinks,
        Self::Shared,
        Self::Unwatched,
        Self::UnstableState,
        Self::OutsideTable,
        Self::Teeth,
        Self::Penetration,
        Self::Slender,
        Self::Stiffening,
        Self::Locks,
    ];

    /// As in `#[allow(unused)]`.
    pub fn word(self) -> &'static str {
        match self {
            Self::Unused => "unused",
            Self::NoEffect => "no_effect",
            Self::Outside => "outside",
            Self::Negative => "negative",
            Self::Proportion => "proportion",
            Self::Kinks => "kinks",
            Self::Shared => "shared",
            Self::Unwatched => "unwatched",
            Self::UnstableState => "unstable_state",
            Self::OutsideTable => "outside_table",
            Self::Teeth => "teeth",
            Self::Penetration => "penetration",
            Self::Slender => "slender",
            Self::Stiffening => "stiffening",
            Self::Locks => "locks",
        }
    }
}

/// Where which warnings are not wanted, because `#[allow(…)]` says so.
#[derive(Clone, Debug, Default)]
pub struct Allowed(BTreeSet<(Lint, (u32, u32))>);

impl Allowed {
    /// Within this stretch of the source.
    pub(crate) fn add(&mut self, lint: Lint, within: Region) {
        self.0.insert((lint, within.tokens));
    }

    /// Whether a warning at this place is not wanted.
    pub(crate) fn covers(&self, lint: Lint, at: Region) -> bool {
        let (first, last) = at.tokens;
        let covers = |(start, end): (u32, u32)| first != 0 && start <= first && last <= end;
        self.0.iter().any(|(allowed, within)| *allowed == lint && covers(*within))
    }
}

/// How grave it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    Error,
    Warning(Lint),
}

/// One error or warning.
#[derive(Clone, Debug)]
pub struct Diagnostic {
    pub severity: Severity,
    /// Where.
    pub region: Region,
    /// What is wrong, why, and what to write instead.
    pub message: String,
    /// Other places that the error speaks of.
    pub notes: Vec<Note>,
}

/// Another place that an error speaks of.
#[derive(Clone, Debug)]
pub struct Note {
    /// Where.
    pub region: Region,
    /// Complete in itself: it is shown as a message of its own.
    pub message: String,
}

/// The errors of a stage, or the warnings of all, in the order found.
#[derive(Clone, Debug, Default)]
#[must_use]
pub struct Diagnostics {
    found: Vec<Diagnostic>,
    beyond: usize,
    known: BTreeSet<String>,
}

impl Diagnostics {
    /// Nothing found.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds an error at a place.
    pub fn error(&mut self, at: impl Into<Region>, message: impl Into<String>) {
        self.push(Diagnostic {
            severity: Severity::Error,
            region: at.into(),
            message: message.into(),
            notes: Vec::new(),
        });
    }

    /// Adds a warning at a place.
    pub fn warning(&mut self, lint: Lint, at: impl Into<Region>, message: impl Into<String>) {
        self.push(Diagnostic {
            severity: Severity::Warning(lint),
            region: at.into(),
            message: message.into(),
            notes: Vec::new(),
        });
    }

    /// Adds an error that also points at a second place.
    pub fn conflict(
        &mut self,
        at: impl Into<Region>,
        message: impl Into<String>,
        other: impl Into<Region>,
        note: impl Into<String>,
    ) {
        let notes = vec![Note { region: other.into(), message: note.into() }];
        self.push(Diagnostic {
            severity: Severity::Error,
            region: at.into(),
            message: message.into(),
            notes,
        });
    }

    /// Adds it unless the same place already has it: the rounds of a `repeat` give one message.
    pub fn push(&mut self, diagnostic: Diagnostic) {
        if !self.known.insert(identity(&diagnostic)) {
            return;
        }
        if self.found.len() < MOST {
            self.found.push(diagnostic);
        } else {
            self.beyond += 1;
        }
    }

    /// Takes over all of another collection.
    pub fn append(&mut self, other: Diagnostics) {
        self.beyond += other.beyond;
        for error in other.found {
            self.push(error);
        }
    }

    /// Whether nothing was found.
    pub fn is_empty(&self) -> bool {
        self.found.is_empty()
    }

    /// Whether so many were found that no more are kept; costly advice can then be spared.
    pub fn is_full(&self) -> bool {
        self.found.len() >= MOST
    }

    /// Errors and warnings, in the order found.
    pub fn iter(&self) -> impl Iterator<Item = &Diagnostic> {
        self.found.iter()
    }

    /// The end of a stage: `value` if there was no error. Errors come in the order of the source.
    pub fn finish<T>(mut self, value: T) -> Result<T, Diagnostics> {
        if self.is_empty() {
            return Ok(value);
        }
        self.found.sort_by_key(|found| found.region.tokens.0);
        Err(self)
    }

    /// The findings, in order; the last one says how many were not kept.
    pub fn into_found(mut self) -> Vec<Diagnostic> {
        if let (Some(last), true) = (self.found.last_mut(), self.beyond > 0) {
            last.message.push_str(&format!("\n(and {} more errors)", self.beyond));
        }
        self.found
    }

    /// Keeps those that are shown.
    pub fn retain(&mut self, shown: impl Fn(&Diagnostic) -> bool) {
        self.found.retain(shown);
    }
}

/// One line each, its notes indented below it.
impl fmt::Display for Diagnostics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for error in &self.found {
            let grave = if error.severity == Severity::Error { "error" } else { "warning" };
            writeln!(f, "{grave}: {}", error.message)?;
            for note in &error.notes {
                writeln!(f, "  note: {}", note.message)?;
            }
        }
        if self.beyond > 0 {
            writeln!(f, "and {} more errors", self.beyond)?;
        }
        Ok(())
    }
}

/// What two errors of different rounds of a `repeat` have in common: the place, and the text without indices.
fn identity(error: &Diagnostic) -> String {
    let text: String = error.message.chars().filter(|c| !c.is_ascii_digit()).collect();
    format!("{:?} {text}", error.region.tokens)
}
