//! The definitions in a Rust file: every `mechanism! { … }`, wherever it stands. Calls of a `macro_rules!` of the same file
//! that writes one are followed.

use super::lexer::lex;
use super::macro_rules::MacroRules;
use super::tokens::{Piece, group, pieces, tokens};
use super::{Located, Source, Tokens, delimiters};
use crate::messages;
use proc_macro2::Span;
use std::collections::BTreeMap;
use std::ops::Range;

/// Macros that call one another are followed so deep, and so often in one file.
const DEEPEST_CALL: usize = 16;
const MOST_CALLS: usize = 1000;

/// One `mechanism! { … }`.
#[derive(Clone, Debug)]
pub struct Invocation {
    /// From the word to the closing delimiter; of the outermost macro.
    pub range: Range<usize>,
    /// What stands between the delimiters.
    pub tokens: Tokens,
    /// What of that is no token.
    pub errors: Vec<Located>,
}

/// Whether a text of unknown kind is Rust around a definition.
pub fn is_rust(source: &Source) -> bool {
    let lexemes = lex(&source.text, &mut Vec::new());
    let pieces = pieces(source, &lexemes, Span::call_site(), &mut Vec::new());
    pieces.windows(2).any(|pair| pair[0].is("mechanism") && pair[1].is("!"))
}

/// The definitions of a Rust file, in the order written; an error where its delimiters do not balance. What else is no Rust
/// is left to rustc.
pub fn invocations(source: &Source) -> Result<Vec<Invocation>, Located> {
    let mut errors = Vec::new();
    let lexemes = lex(&source.text, &mut errors);
    if let Some(error) = delimiters::unbalanced(source, &lexemes) {
        // A string that never ends takes delimiters along.
        return Err(errors.into_iter().next().unwrap_or(error));
    }
    let pieces = pieces(source, &lexemes, Span::call_site(), &mut errors);
    let mut search = Search { errors, macros: BTreeMap::new(), calls: 0, found: Vec::new() };
    search.search(&pieces, &[]);
    Ok(search.found)
}

struct Search {
    /// What of the file is no token.
    errors: Vec<Located>,
    /// Those that write definitions, by name.
    macros: BTreeMap<String, MacroRules>,
    /// Calls that have been followed.
    calls: usize,
    found: Vec<Invocation>,
}

impl Search {
    /// `callers` are the ranges of the macros that have written `pieces`, and of their calls, outermost call first.
    fn search(&mut self, pieces: &[Piece], callers: &[Range<usize>]) {
        let mut at = 0;
        while at < pieces.len() {
            let rest = &pieces[at..];
            let [word, bang, ..] = rest else { return };
            let Some(name) = word.word().filter(|_| bang.is("!")) else {
                at += 1;
                continue;
            };
            // `macro_rules! name { … }`
            let ahead = if name == "macro_rules" { 3 } else { 2 };
            let length = group(rest.get(ahead..).unwrap_or_default());
            if length == 0 {
                at += 1;
                continue;
            }
            let range = word.place.start..rest[ahead + length - 1].place.end;
            let inside = &rest[ahead + 1..ahead + length - 1];
            if name == "macro_rules" {
                let writes = |known: &str| inside.windows(2).any(|pair| pair[0].is(known) && pair[1].is("!"));
                if writes("mechanism") || self.macros.keys().any(|known| writes(known)) {
                    let name = rest[2].word().unwrap_or_default();
                    self.macros.insert(name, MacroRules::new(inside, range));
                }
            } else if name == "mechanism" {
                let end = rest[ahead + length - 1].place.clone();
                self.definition(inside.to_vec(), range, end, callers);
            } else if let Some(rules) = self.macros.get(&name) {
                let endless = callers.len() >= 2 * DEEPEST_CALL || self.calls >= MOST_CALLS;
                let written = rules.expand(inside).filter(|_| !endless);
                self.calls += 1;
                let callers = [callers, &[range.clone(), rules.range.clone()]].concat();
                match written {
                    Some(written) => self.search(&written, &callers),
                    None if self.calls > MOST_CALLS + 1 => {}
                    None => self.unclear(&name, callers[0].clone()),
                }
            } else {
                at += 1;
                continue;
            }
            at += ahead + length;
        }
    }

    fn definition(
        &mut self,
        inside: Vec<Piece>,
        own: Range<usize>,
        end: Range<usize>,
        callers: &[Range<usize>],
    ) {
        let ranges = || callers.iter().chain([&own]);
        let touches = |error: &&Located| ranges().any(|range| range.contains(&error.range.start));
        let mut errors: Vec<Located> = self.errors.iter().filter(touches).cloned().collect();
        let mut tokens = tokens(inside, end, Span::call_site(), &mut errors);
        tokens.call = callers.first().cloned();
        let range = callers.first().unwrap_or(&own).clone();
        self.found.push(Invocation { range, tokens, errors });
    }

    /// A call whose text cannot be told.
    fn unclear(&mut self, name: &str, range: Range<usize>) {
        let error = Located::new(range.clone(), messages::macro_not_followed(name));
        self.found.push(Invocation { range, tokens: Tokens::default(), errors: vec![error] });
    }
}
