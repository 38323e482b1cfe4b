//! What statements that could not be read would have given to code that uses the mechanism: fields of its structs.

use super::definition::Label;
use super::parser::Parser;
use super::token::{Cursor, Kind};
use crate::spelling::closest;
use proc_macro2::Delimiter;

/// Words of statements that give fields, or hold statements that may.
const GIVING: [&str; 5] = ["param", "input", "output", "repeat", "part"];

/// Fields of statements that could not be read.
#[derive(Debug, Default)]
pub(super) struct Unread {
    pub parameters: Vec<Label>,
    pub inputs: Vec<Label>,
    pub outputs: Vec<Label>,
    /// Whether there may be others.
    pub others: bool,
}

impl Parser<'_> {
    /// Notes a statement that could not be read. Where it does not begin as one, or is several of them without the `;` between, nobody
    /// knows what it gives.
    pub fn unread(&mut self, mut c: Cursor) {
        let is_readable = c.skip_attributes();
        let written = c.word().unwrap_or_default();
        // A misspelled word gives what the word that the message proposes would have given.
        let words = self.statement_words();
        let meant = words.iter().copied().find(|word| *word == written);
        let meant = meant.or_else(|| closest(written, words.iter().copied()));
        let (word, is_known) = (meant.unwrap_or(written), is_readable && meant.is_some());
        c.advance();
        let name = c.word().map(|name| Label { text: name.to_string(), region: c.region() });
        let list = match word {
            "param" => &mut self.unread.parameters,
            "input" => &mut self.unread.inputs,
            "output" => &mut self.unread.outputs,
            _ => {
                self.unread.others |= !is_known || GIVING.contains(&word) || gives(c);
                return;
            }
        };
        let is_single = self.indices.is_empty() && self.scope.name.is_none();
        match name.filter(|_| is_single && is_readable) {
            Some(name) => {
                c.advance();
                list.push(name);
                self.unread.others |= gives(c);
            }
            None => self.unread.others = true,
        }
    }
}

/// Whether a word that begins such a statement comes before the end of this one.
fn gives(mut c: Cursor) -> bool {
    while let Some(token) = c.advance() {
        match &token.kind {
            Kind::Word(word) if GIVING.contains(&word.as_str()) => return true,
            Kind::Punct(';') | Kind::Group(Delimiter::Brace, ..) => return false,
            _ => {}
        }
    }
    false
}
