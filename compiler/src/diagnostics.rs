//! Errors of a stage, collected: a region of the source, a text, and notes that point at other places.
//!
//! A stage pushes every error it finds and its caller stops at the stage's end ([`Diagnostics::finish`]).
//! The texts themselves stand in `messages`.

use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};
use std::collections::BTreeSet;
use std::fmt;

/// Errors beyond this many are counted, not kept.
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
}

impl Region {
    /// The region of the token with this serial number (from 1).
    pub(crate) fn of_token(span: Span, serial: u32) -> Self {
        Self { start: span, end: span, tokens: (serial, serial) }
    }

    /// Serial numbers of its first and last token, zero where it is none: the end of the definition.
    pub(crate) fn tokens(self) -> (usize, usize) {
        (self.tokens.0 as usize, self.tokens.1 as usize)
    }

    /// From the start of `self` to the end of `last`.
    pub fn to(self, last: Region) -> Region {
        Region { start: self.start, end: last.end, tokens: (self.tokens.0, last.tokens.1) }
    }
}

impl From<Span> for Region {
    fn from(span: Span) -> Self {
        Self { start: span, end: span, tokens: (0, 0) }
    }
}

/// One error.
#[derive(Clone, Debug)]
pub struct Diagnostic {
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

/// The errors of a stage, in the order found.
#[derive(Clone, Debug, Default)]
#[must_use]
pub struct Diagnostics {
    errors: Vec<Diagnostic>,
    beyond: usize,
    known: BTreeSet<String>,
}

impl Diagnostics {
    /// No errors.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds an error at a place.
    pub fn error(&mut self, at: impl Into<Region>, message: impl Into<String>) {
        self.push(Diagnostic { region: at.into(), message: message.into(), notes: Vec::new() });
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
        self.push(Diagnostic { region: at.into(), message: message.into(), notes });
    }

    /// Adds an error unless the same place already has it: the rounds of a `repeat` give one message.
    pub fn push(&mut self, error: Diagnostic) {
        if !self.known.insert(identity(&error)) {
            return;
        }
        if self.errors.len() < MOST {
            self.errors.push(error);
        } else {
            self.beyond += 1;
        }
    }

    /// Takes over all errors of another collection.
    pub fn append(&mut self, other: Diagnostics) {
        self.beyond += other.beyond;
        for error in other.errors {
            self.push(error);
        }
    }

    /// Whether nothing was found.
    pub fn is_empty(&self) -> bool {
        self.errors.is_empty()
    }

    /// Whether so many were found that no more are kept; costly advice can then be spared.
    pub fn is_full(&self) -> bool {
        self.errors.len() >= MOST
    }

    /// The errors, in the order found.
    pub fn iter(&self) -> impl Iterator<Item = &Diagnostic> {
        self.errors.iter()
    }

    /// The end of a stage: `value` if there was no error.
    pub fn finish<T>(self, value: T) -> Result<T, Diagnostics> {
        if self.is_empty() { Ok(value) } else { Err(self) }
    }

    /// The errors, in the order found; the last one says how many were not kept.
    pub fn into_errors(mut self) -> Vec<Diagnostic> {
        if let (Some(last), true) = (self.errors.last_mut(), self.beyond > 0) {
            last.message.push_str(&format!("\n(and {} more errors)", self.beyond));
        }
        self.errors
    }

    /// One `::core::compile_error! { "…" }` per error and per note, each at its place.
    pub fn into_compile_errors(self) -> TokenStream {
        let mut stream = TokenStream::new();
        for error in self.into_errors() {
            compile_error(&mut stream, error.region, &error.message);
            for note in error.notes {
                compile_error(&mut stream, note.region, &note.message);
            }
        }
        stream
    }
}

/// One line per error, its notes indented below it.
impl fmt::Display for Diagnostics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for error in &self.errors {
            writeln!(f, "error: {}", error.message)?;
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

/// `::core::compile_error! { "message" }`: the compiler underlines from the first token's span to the last one's.
pub(crate) fn compile_error(stream: &mut TokenStream, region: Region, message: &str) {
    let punct = |character, spacing| {
        let mut punct = Punct::new(character, spacing);
        punct.set_span(region.start);
        TokenTree::Punct(punct)
    };
    let word = |text| TokenTree::Ident(Ident::new(text, region.start));
    let mut literal = Literal::string(message);
    literal.set_span(region.end);
    let mut group = Group::new(Delimiter::Brace, TokenTree::Literal(literal).into());
    group.set_span(region.end);
    stream.extend([
        punct(':', Spacing::Joint),
        punct(':', Spacing::Alone),
        word("core"),
        punct(':', Spacing::Joint),
        punct(':', Spacing::Alone),
        word("compile_error"),
        punct('!', Spacing::Alone),
        TokenTree::Group(group),
    ]);
}
