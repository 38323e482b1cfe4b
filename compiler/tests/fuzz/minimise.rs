//! A failing case with everything left out that it does not need: delta debugging (Zeller & Hildebrandt 2002), first on
//! statements, then on groups and tokens.

use super::tokens::{self, balanced, statements};

/// The least text found that still `fails`.
pub fn minimise(text: &str, mut fails: impl FnMut(&str) -> bool) -> String {
    let Some(mut tokens) = tokens::read(text) else { return text.to_string() };
    loop {
        let before = tokens.len();
        tokens = without_statements(tokens, &mut fails);
        tokens = without_tokens(tokens, &mut fails);
        if tokens.len() >= before {
            return tokens::text(&tokens);
        }
    }
}

/// Whole statements first: what is left stays well formed.
fn without_statements(mut tokens: Vec<String>, fails: &mut impl FnMut(&str) -> bool) -> Vec<String> {
    let mut at = 0;
    while let Some(range) = statements(&tokens).get(at).cloned() {
        let mut fewer = tokens.clone();
        fewer.drain(range);
        if fails(&tokens::text(&fewer)) {
            tokens = fewer;
        } else {
            at += 1;
        }
    }
    tokens
}

/// Runs of tokens, half of all at first, then shorter ones.
fn without_tokens(mut tokens: Vec<String>, fails: &mut impl FnMut(&str) -> bool) -> Vec<String> {
    let mut length = tokens.len() / 2;
    while length > 0 {
        let mut at = 0;
        while at < tokens.len() {
            let mut fewer = tokens.clone();
            fewer.drain(at..(at + length).min(tokens.len()));
            let fewer = balanced(fewer);
            if fewer.len() < tokens.len() && fails(&tokens::text(&fewer)) {
                tokens = fewer;
            } else {
                at += length;
            }
        }
        length /= 2;
    }
    tokens
}
