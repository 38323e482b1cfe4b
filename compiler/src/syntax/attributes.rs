//! Attributes in front of statements: doc comments, attributes to hand through, and `#[allow(unused)]`.

use super::parser::{Parsed, Parser};
use super::token::{Cursor, Kind};
use crate::diagnostics::{Lint, Region};
use crate::messages;
use proc_macro2::{Delimiter, TokenStream};

/// What an attribute stands in front of.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Bearer {
    /// The mechanism, which becomes a struct.
    Item,
    /// A parameter, input or output, which becomes a field.
    Field,
    /// Anything else, which becomes nothing that could carry an attribute.
    Part,
}

/// The attributes of one statement.
#[derive(Default)]
pub(super) struct Attributes {
    /// For the item in the generated code.
    pub handed_through: TokenStream,
    pub allowed: Vec<Lint>,
}

impl Parser<'_> {
    /// Attributes and doc comments in front of a statement.
    pub fn attributes(&mut self, c: &mut Cursor, bearer: Bearer) -> Parsed<Attributes> {
        let mut found = Attributes::default();
        while c.at_punct('#') {
            let mut ahead = c.clone();
            let hash = ahead.advance();
            let Some(inside) = ahead.inside(Delimiter::Bracket) else {
                return self.expected(&ahead, "an attribute in `[ ]`");
            };
            if !inside.is_attribute() {
                return self.fail(ahead.region(), messages::attribute());
            }
            let brackets = ahead.advance();
            if !self.is_of_the_language(inside, bearer, &mut found.allowed)? {
                found
                    .handed_through
                    .extend([hash, brackets].into_iter().flatten().map(|t| t.original.clone()));
            }
            *c = ahead;
        }
        Ok(found)
    }

    /// Whether an attribute is for the compiler of mechanisms alone; an error if it would be for nobody.
    fn is_of_the_language(
        &mut self,
        inside: Cursor,
        bearer: Bearer,
        allowed: &mut Vec<Lint>,
    ) -> Parsed<bool> {
        let word = inside.word().unwrap_or_default();
        match (word, bearer) {
            ("allow", _) => self.allow_words(inside, bearer, allowed),
            ("doc", _) => Ok(false),
            ("cfg", _) | ("cfg_attr", Bearer::Field) | (_, Bearer::Part) => {
                self.fail(inside.whole(), messages::attribute_without_effect(word))
            }
            (_, Bearer::Item | Bearer::Field) => Ok(false),
        }
    }

    /// The words of `allow(…)`; rustc gets those that are not of the language.
    fn allow_words(&mut self, mut c: Cursor, bearer: Bearer, allowed: &mut Vec<Lint>) -> Parsed<bool> {
        c.advance();
        let mut inside = self.group(&mut c, Delimiter::Parenthesis)?;
        let mut all_known = true;
        while let Some(token) = inside.advance() {
            let Kind::Word(word) = &token.kind else { continue };
            match Lint::ALL.into_iter().find(|lint| lint.word() == word) {
                Some(lint) => allowed.push(lint),
                None if bearer == Bearer::Part => {
                    let at = inside.previous();
                    return self.fail(at, messages::unknown_lint(word, &Lint::ALL.map(Lint::word)));
                }
                None => all_known = false,
            }
        }
        Ok(all_known)
    }

    /// Warnings that are not wanted within a statement.
    pub fn allow(&mut self, lints: &[Lint], within: Region) {
        for lint in lints {
            self.definition.allowed.add(*lint, within);
        }
    }
}

impl Cursor<'_> {
    /// Whether a parameter, input or output follows the attributes.
    pub fn declares_field(mut self) -> bool {
        self.skip_attributes() && matches!(self.word(), Some("param" | "input" | "output"))
    }
}
