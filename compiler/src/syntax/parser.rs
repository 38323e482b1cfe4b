//! The parser's state and what every statement needs: names with indices, units, `;`, recovery.
//!
//! A function that fails has pushed its error and returns [`Failed`]; the statement is then given up and the next
//! one is read, so that one mistake gives one message and several mistakes give several.

use super::definition::{Definition, Label, Path, Term, WrittenUnit};
use super::habits::habit;
use super::scope::Scope;
use super::shelf::Declarations;
use super::token::{Cursor, Kind, Token};
use super::unread::Unread;
use crate::diagnostics::{Diagnostics, Region};
use crate::forms::Vocabulary;
use crate::messages;
use crate::units::{self, UnitError};
use proc_macro2::Delimiter;
use std::collections::{BTreeMap, HashMap};

/// The error has been pushed.
#[derive(Debug)]
pub(super) struct Failed;

/// A part of the definition, or nothing after an error.
pub(super) type Parsed<T> = Result<T, Failed>;

/// What has been read, and what reading needs to know.
pub(super) struct Parser<'t> {
    pub vocabulary: &'static Vocabulary,
    pub diagnostics: Diagnostics,
    pub definition: Definition,
    /// The parts that may be used.
    pub declarations: Declarations<'t>,
    /// What names mean here.
    pub scope: Scope,
    /// Values of constants, for indices and bounds of `repeat`.
    pub constants: HashMap<String, Term>,
    /// Those that have been counted with: each is evaluated once, however often others name it.
    pub integers: HashMap<String, i64>,
    /// Variables of the `repeat`s around, innermost last.
    pub indices: Vec<(String, i64)>,
    /// The `repeat`s whose bounds stand the wrong way round, by their tokens; nothing of those that made a round within another one.
    pub backwards: BTreeMap<(u32, u32), Option<(Region, String)>>,
    /// Rounds and statements that `repeat` may still unroll to.
    pub budget: usize,
    /// Nesting of the expression being read.
    pub depth: usize,
    /// Whether the rounds after one with an error are read too.
    pub patient: bool,
    /// What statements with errors would have given.
    pub unread: Unread,
}

impl Parser<'_> {
    /// Pushes an error and gives up.
    pub fn fail<T>(&mut self, at: Region, message: String) -> Parsed<T> {
        self.diagnostics.error(at, message);
        Err(Failed)
    }

    /// Gives up because something else stands here.
    pub fn expected<T>(&mut self, c: &Cursor, what: &str) -> Parsed<T> {
        match habit(c, what) {
            Some(habit) => self.advised(c, what, &habit.advice()),
            None => {
                let message = messages::expected(what, &found(c.peek()));
                self.fail(c.region(), message)
            }
        }
    }

    /// The same, with what to write instead.
    pub fn advised<T>(&mut self, c: &Cursor, what: &str, advice: &str) -> Parsed<T> {
        let message = messages::expected_and_advice(what, &found(c.peek()), advice);
        self.fail(c.region(), message)
    }

    /// `;`, or the end of the braces.
    pub fn semicolon(&mut self, c: &mut Cursor) -> Parsed<()> {
        if c.eat_punct(';') || c.is_done() { Ok(()) } else { self.expected(c, "`;`") }
    }

    /// One particular character.
    pub fn punct(&mut self, c: &mut Cursor, character: char) -> Parsed<()> {
        if c.eat_punct(character) { Ok(()) } else { self.expected(c, &format!("`{character}`")) }
    }

    /// Any word.
    pub fn word(&mut self, c: &mut Cursor, what: &str) -> Parsed<Label> {
        let region = c.region();
        match c.word() {
            Some(word) => {
                c.advance();
                Ok(Label { text: word.to_string(), region })
            }
            None => self.expected(c, what),
        }
    }

    /// A group of this delimiter.
    pub fn group<'t>(&mut self, c: &mut Cursor<'t>, delimiter: Delimiter) -> Parsed<Cursor<'t>> {
        let what = match delimiter {
            Delimiter::Parenthesis => "`(`",
            Delimiter::Brace => "`{`",
            Delimiter::Bracket => "`[`",
            Delimiter::None => "a group",
        };
        match c.enter(delimiter) {
            Some(inside) => Ok(inside),
            None => self.expected(c, what),
        }
    }

    /// Nothing more may stand in this group.
    pub fn end(&mut self, c: &Cursor, what: &str) -> Parsed<()> {
        if c.is_done() { Ok(()) } else { self.expected(c, what) }
    }

    /// A name that is declared here; every bracket after it is an index.
    pub fn declared(&mut self, c: &mut Cursor, what: &str) -> Parsed<Label> {
        let count = c.peek_second().map_or(0, |_| {
            let mut ahead = c.clone();
            ahead.advance();
            ahead.groups_ahead(Delimiter::Bracket)
        });
        self.indexed(c, count, what)
    }

    /// A name that is declared here with a unit: the last bracket after it.
    pub fn declared_with_unit(&mut self, c: &mut Cursor, what: &str) -> Parsed<(Label, Option<WrittenUnit>)> {
        let mut ahead = c.clone();
        ahead.advance();
        let brackets = ahead.groups_ahead(Delimiter::Bracket);
        let label = self.indexed(c, brackets.saturating_sub(1), what)?;
        let unit = self.unit(c)?;
        Ok((label, unit))
    }

    /// The name of a joint or body that is used here, perhaps one of a part: all brackets are indices.
    pub fn label(&mut self, c: &mut Cursor, what: &str) -> Parsed<Label> {
        if let Some(mut inside) = c.enter(Delimiter::None) {
            let label = self.label(&mut inside, what)?;
            self.end(&inside, "a single name")?;
            return Ok(label);
        }
        let mut parts = vec![self.declared(c, what)?];
        while self.is_use(&parts) && c.eat_punct('.') {
            parts.push(self.declared(c, "a name")?);
        }
        let path = self.resolved(Path::joined(parts))?;
        match path.parts.as_slice() {
            [label] => Ok(Label { text: label.text.clone(), region: path.region }),
            // A place that a port was given.
            _ => {
                let message = messages::expected_and_advice(
                    what,
                    &messages::quoted(&path.text),
                    messages::names_without_point(),
                );
                self.fail(path.region, message)
            }
        }
    }

    /// Names joined by dots.
    pub fn path(&mut self, c: &mut Cursor, what: &str) -> Parsed<Path> {
        if let Some(mut inside) = c.enter(Delimiter::None) {
            let path = self.path(&mut inside, what)?;
            self.end(&inside, "a single name")?;
            return Ok(path);
        }
        let mut parts = vec![self.declared(c, what)?];
        while c.at_punct('.') && matches!(c.peek_second(), Some(Token { kind: Kind::Word(_), .. })) {
            c.advance();
            parts.push(self.declared(c, "a name")?);
        }
        self.resolved(Path::joined(parts))
    }

    /// A name and this many bracketed indices.
    fn indexed(&mut self, c: &mut Cursor, brackets: usize, what: &str) -> Parsed<Label> {
        let mut label = self.word(c, what)?;
        for _ in 0..brackets {
            let inside = self.group(c, Delimiter::Bracket)?;
            let value = self.index(inside)?;
            label.text.push_str(&format!("[{value}]"));
            label.region = label.region.to(c.previous());
        }
        Ok(label)
    }

    /// A unit in brackets, if brackets come next.
    pub fn unit(&mut self, c: &mut Cursor) -> Parsed<Option<WrittenUnit>> {
        let whole = c.region();
        let Some(inside) = c.enter(Delimiter::Bracket) else { return Ok(None) };
        let region = if inside.is_done() { whole } else { inside.whole() };
        match units::parse(&inside.joined()) {
            Ok(unit) => Ok(Some(WrittenUnit { unit, region })),
            Err(error) => {
                let narrow = match &error {
                    UnitError::Unknown(name) => inside.find(name),
                    UnitError::Prefix(prefix, name) => inside.find(&format!("{prefix}{name}")),
                    _ => None,
                };
                self.fail(narrow.unwrap_or(region), messages::unit(&error))
            }
        }
    }
}

/// A token in the words of a message.
pub(super) fn found(token: Option<&Token>) -> String {
    match token.map(|token| &token.kind) {
        None => "the end".to_string(),
        Some(Kind::Word(text) | Kind::Number(text) | Kind::Text(text)) => format!("`{text}`"),
        Some(Kind::Punct(character)) => format!("`{character}`"),
        Some(Kind::Group(Delimiter::Parenthesis, ..)) => "`(`".to_string(),
        Some(Kind::Group(Delimiter::Brace, ..)) => "`{`".to_string(),
        Some(Kind::Group(Delimiter::Bracket, ..)) => "`[`".to_string(),
        Some(Kind::Group(Delimiter::None, ..)) => "a group of tokens".to_string(),
    }
}
