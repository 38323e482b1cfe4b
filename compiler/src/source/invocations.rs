//! The definitions in a Rust file: every `mechanism! { … }`, wherever it stands, but in a `macro_rules!`.

use super::lexer::{Kind, Lexeme, lex};
use super::tokens::convert;
use super::{Located, Source, Tokens, delimiters};
use proc_macro2::Span;
use std::ops::Range;

/// One `mechanism! { … }`.
#[derive(Clone, Debug)]
pub struct Invocation {
    /// From the word to the closing delimiter.
    pub range: Range<usize>,
    /// What stands between the delimiters.
    pub tokens: Tokens,
    /// What of that is no token.
    pub errors: Vec<Located>,
}

/// Whether a text of unknown kind is Rust around a definition.
pub fn is_rust(source: &Source) -> bool {
    let lexemes = lex(&source.text, &mut Vec::new());
    (0..lexemes.len()).any(|at| is_macro(source, &lexemes[at..], "mechanism"))
}

/// The definitions of a Rust file, in the order written; an error where its delimiters do not balance. Other words that
/// are no Rust are left to rustc.
pub fn invocations(source: &Source) -> Result<Vec<Invocation>, Located> {
    let mut errors = Vec::new();
    let lexemes = lex(&source.text, &mut errors);
    if let Some(error) = delimiters::unbalanced(source, &lexemes) {
        // A string that never ends takes delimiters along.
        return Err(errors.into_iter().next().unwrap_or(error));
    }
    let mut found = Vec::new();
    let mut at = 0;
    while at < lexemes.len() {
        let rest = &lexemes[at..];
        if is_macro(source, rest, "macro_rules") {
            // `macro_rules! name { … }`
            at += 3 + group(rest.get(3..).unwrap_or_default());
        } else if is_macro(source, rest, "mechanism") && group(&rest[2..]) > 0 {
            let length = 2 + group(&rest[2..]);
            let (first, last) = (&rest[0].range, &rest[length - 1].range);
            let mut errors: Vec<Located> = errors
                .iter()
                .filter(|error| (first.end..last.start).contains(&error.range.start))
                .cloned()
                .collect();
            let inside = &rest[3..length - 1];
            let tokens = convert(source, inside, last.clone(), Span::call_site(), &mut errors);
            found.push(Invocation { range: first.start..last.end, tokens, errors });
            at += length;
        } else {
            at += 1;
        }
    }
    Ok(found)
}

/// Whether `name!` comes next.
fn is_macro(source: &Source, lexemes: &[Lexeme], name: &str) -> bool {
    let [word, bang, ..] = lexemes else { return false };
    word.kind == Kind::Word && bang.kind == Kind::Punct('!') && source.text[word.range.clone()] == *name
}

/// How many lexemes the group that comes next has, its delimiters included; 0 where none comes.
fn group(lexemes: &[Lexeme]) -> usize {
    let mut depth = 0;
    for (index, lexeme) in lexemes.iter().enumerate() {
        match lexeme.kind {
            Kind::Open(_) => depth += 1,
            Kind::Close(_) => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return if index == 0 { 0 } else { index + 1 };
        }
    }
    0
}
