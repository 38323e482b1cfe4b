//! Recognises habits of Rust, of other programs and of plain writing by the tokens where something else was expected.
//! What is said about them stands in `messages`.

use super::token::{Cursor, Kind, Token};
use crate::messages::Habit;
use crate::units;
use proc_macro2::Delimiter;

/// What is written at `c`, where `what` was expected.
pub(super) fn habit(c: &Cursor, what: &str) -> Option<Habit> {
    let (found, before) = (&c.peek()?.kind, c.before().map(|token| &token.kind));
    let next = c.peek_second().map(|token| &token.kind);
    Some(match (what, found) {
        ("`;`", found) => return where_a_line_ends(before, found, next),
        ("`=`", Kind::Punct(':')) => Habit::ColonForEquals,
        ("`=`", Kind::Group(Delimiter::Parenthesis, ..)) => Habit::UnitInParentheses,
        ("`{`", Kind::Group(Delimiter::Parenthesis, ..)) => Habit::PropertiesInParentheses,
        ("an attribute in `[ ]`", _) => Habit::HashComment,
        ("a value", Kind::Text(_)) => Habit::QuotedValue,
        (_, Kind::Text(text)) if text.starts_with('"') => {
            Habit::QuotedName(text.trim_matches('"').to_string())
        }
        ("a value", Kind::Punct('=')) if matches!(before, Some(Kind::Punct('='))) => Habit::EqualsTwice,
        ("a value", Kind::Word(word)) if word == "if" => Habit::RustIf,
        ("a statement" | "the end: one mechanism for each macro", Kind::Punct(';')) => {
            Habit::SemicolonBehindBlock
        }
        ("a property of the body" | "a statement", Kind::Group(Delimiter::Bracket, ..)) => {
            Habit::UnitBeforeName
        }
        (vector, found) if vector.starts_with("`(x, y") => match found {
            Kind::Number(_) | Kind::Punct('-') => Habit::VectorWithoutParentheses,
            Kind::Group(Delimiter::Bracket, ..) => Habit::VectorInBrackets,
            Kind::Word(word) => {
                let letters: &[&str] = if vector.contains('z') { &["x", "y", "z"] } else { &["x", "y"] };
                match letters.contains(&word.as_str()) {
                    true => Habit::AxisByLetter(word.clone(), letters),
                    false => Habit::NameForVector,
                }
            }
            _ => return None,
        },
        _ => return None,
    })
}

fn where_a_line_ends(before: Option<&Kind>, found: &Kind, next: Option<&Kind>) -> Option<Habit> {
    Some(match (before, found, next) {
        (Some(Kind::Number(whole)), Kind::Punct(','), Some(Kind::Number(rest))) => {
            Habit::DecimalComma(whole.clone(), rest.clone())
        }
        (_, Kind::Punct(','), _) => Habit::CommaForSemicolon,
        (Some(Kind::Number(_) | Kind::Group(Delimiter::Parenthesis, ..)), Kind::Word(word), _) => {
            let known = units::parse(word).is_ok().then(|| word.clone());
            match known.or_else(|| units::suggest(word)) {
                Some(unit) => Habit::BareUnit(unit),
                None => Habit::LineWithoutEnd,
            }
        }
        (_, Kind::Word(_), _) => Habit::LineWithoutEnd,
        (_, Kind::Punct('?'), _) => Habit::Ternary,
        (_, Kind::Punct(':'), Some(Kind::Punct(':'))) => Habit::RustPath,
        (Some(Kind::Word(function)), Kind::Group(Delimiter::Parenthesis, ..), _) => {
            Habit::Method(function.clone())
        }
        _ => return None,
    })
}

impl<'t> Cursor<'t> {
    /// The token before this position.
    fn before(&self) -> Option<&'t Token> {
        self.back(1)
    }
}
