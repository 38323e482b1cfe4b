//! Delimiters that do not balance: the place where it shows, and the place where one is likely to be missing.

use super::lexer::{Kind, Lexeme};
use super::{Located, Source};
use crate::messages;
use proc_macro2::Delimiter;
use std::ops::Range;

/// The first error of the delimiters, if there is one: what follows from it is no other mistake.
pub(super) fn unbalanced(source: &Source, lexemes: &[Lexeme]) -> Option<Located> {
    let mut open: Vec<(Delimiter, &Range<usize>)> = Vec::new();
    let mut askew = None;
    for Lexeme { kind, range } in lexemes {
        match kind {
            Kind::Open(delimiter) => open.push((*delimiter, range)),
            Kind::Close(delimiter) => match open.pop() {
                Some((opened, first)) if opened == *delimiter => {
                    if askew.is_none() && is_askew(source, first, range) {
                        askew = Some((first, range));
                    }
                }
                Some((opened, first)) => {
                    let message = messages::wrong_delimiter(characters(*delimiter).1, characters(opened));
                    let note = messages::opened_here(characters(opened).0);
                    return Some(Located::new(range.clone(), message).note(first.clone(), note));
                }
                None => {
                    let (opening, closing) = characters(*delimiter);
                    let error = Located::new(range.clone(), messages::nothing_to_close(opening, closing));
                    return Some(likely(source, error, askew));
                }
            },
            _ => {}
        }
    }
    let (delimiter, first) = open.pop()?;
    let error = Located::new(first.clone(), messages::never_closed(characters(delimiter)));
    Some(likely(source, error, askew))
}

/// Points at the first pair whose ends are indented differently.
fn likely(source: &Source, error: Located, askew: Option<(&Range<usize>, &Range<usize>)>) -> Located {
    let Some((first, last)) = askew else { return error };
    let line = source.line_of(first.start);
    let pair = (&source.text[first.clone()], &source.text[last.clone()]);
    error.note(last.clone(), messages::closes_askew(pair, line))
}

/// Whether a closing delimiter that begins its line is indented otherwise than the line on which it was opened.
fn is_askew(source: &Source, first: &Range<usize>, last: &Range<usize>) -> bool {
    let (opening, closing) = (source.line_of(first.start), source.line_of(last.start));
    if opening == closing {
        return false;
    }
    let before = &source.text[source.lines[closing - 1]..last.start];
    let begins_line = before.chars().all(char::is_whitespace);
    let line = &source.text[source.lines[opening - 1]..];
    begins_line && before.len() != line.len() - line.trim_start_matches([' ', '\t']).len()
}

fn characters(delimiter: Delimiter) -> (char, char) {
    match delimiter {
        Delimiter::Parenthesis | Delimiter::None => ('(', ')'),
        Delimiter::Bracket => ('[', ']'),
        Delimiter::Brace => ('{', '}'),
    }
}
