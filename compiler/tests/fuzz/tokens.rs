//! A case: a flat list of tokens, which is easy to mutate, and the text and the stream that it stands for.
//!
//! Groups without delimiters, which a macro's fragments arrive in, are written `«` and `»`.

use proc_macro2::{Delimiter, Group, Spacing, TokenStream, TokenTree};
use std::ops::Range;
use std::str::FromStr;

/// What `«` is between text and stream: a word that no definition has.
const UNSEEN: &str = "group_without_delimiters";

/// The tokens of a text; `None` if it has none that Rust could read.
pub fn read(text: &str) -> Option<Vec<String>> {
    let mut tokens = Vec::new();
    flatten(stream(text)?, &mut tokens);
    Some(tokens)
}

/// The stream that the macro would receive for this text.
pub fn stream(text: &str) -> Option<TokenStream> {
    if !text.contains('«') {
        return TokenStream::from_str(text).ok();
    }
    let text = text.replace('«', &format!(" {UNSEEN}(")).replace('»', ")");
    Some(without_delimiters(TokenStream::from_str(&text).ok()?))
}

/// Tokens as text that reads as the same tokens.
pub fn text(tokens: &[String]) -> String {
    let mut text = String::new();
    for token in tokens {
        text.push_str(token);
        text.push(if matches!(token.as_str(), ";" | "{" | "}") { '\n' } else { ' ' });
    }
    text
}

fn without_delimiters(stream: TokenStream) -> TokenStream {
    let mut result = Vec::new();
    let mut tokens = stream.into_iter();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Ident(ident) if ident == UNSEEN => {
                let Some(TokenTree::Group(group)) = tokens.next() else { continue };
                let mut unseen = Group::new(Delimiter::None, without_delimiters(group.stream()));
                unseen.set_span(group.span());
                result.push(TokenTree::Group(unseen));
            }
            TokenTree::Group(group) => {
                let mut new = Group::new(group.delimiter(), without_delimiters(group.stream()));
                new.set_span(group.span());
                result.push(TokenTree::Group(new));
            }
            token => result.push(token),
        }
    }
    result.into_iter().collect()
}

fn flatten(stream: TokenStream, tokens: &mut Vec<String>) {
    let (mut quote, mut colon) = (false, false);
    for token in stream {
        match token {
            TokenTree::Group(group) => {
                let (open, close) = delimiters(group.delimiter());
                tokens.push(open.to_string());
                flatten(group.stream(), tokens);
                tokens.push(close.to_string());
            }
            // A lifetime is a quote and a word.
            TokenTree::Ident(ident) if quote => tokens.push(format!("'{ident}")),
            TokenTree::Punct(punct) if punct.as_char() == '\'' => {
                quote = true;
                continue;
            }
            // `::` is one token to Rust.
            TokenTree::Punct(punct)
                if punct.as_char() == ':' && tokens.last().is_some_and(|last| last == "::" && colon) =>
            {
                colon = false;
                continue;
            }
            TokenTree::Punct(punct) if punct.as_char() == ':' && punct.spacing() == Spacing::Joint => {
                tokens.push("::".to_string());
                colon = true;
                continue;
            }
            token => tokens.push(token.to_string()),
        }
        (quote, colon) = (false, false);
    }
}

fn delimiters(delimiter: Delimiter) -> (&'static str, &'static str) {
    match delimiter {
        Delimiter::Parenthesis => ("(", ")"),
        Delimiter::Brace => ("{", "}"),
        Delimiter::Bracket => ("[", "]"),
        Delimiter::None => ("«", "»"),
    }
}

/// What closes this opening delimiter.
fn closing(token: &str) -> Option<&'static str> {
    match token {
        "(" => Some(")"),
        "{" => Some("}"),
        "[" => Some("]"),
        "«" => Some("»"),
        _ => None,
    }
}

fn closes(token: &str) -> bool {
    matches!(token, ")" | "}" | "]" | "»")
}

/// The same with every delimiter matched: what opens is closed, what closes nothing is left out.
pub fn balanced(tokens: Vec<String>) -> Vec<String> {
    let mut open: Vec<&str> = Vec::new();
    let mut result = Vec::with_capacity(tokens.len());
    for token in tokens {
        if let Some(close) = closing(&token) {
            open.push(close);
        } else if closes(&token) {
            let Some(expected) = open.pop() else { continue };
            result.push(expected.to_string());
            continue;
        }
        result.push(token);
    }
    result.extend(open.into_iter().rev().map(str::to_string));
    result
}

/// All groups, from the opening delimiter to the closing one.
pub fn groups(tokens: &[String]) -> Vec<Range<usize>> {
    let mut open = Vec::new();
    let mut found = Vec::new();
    for (at, token) in tokens.iter().enumerate() {
        if closing(token).is_some() {
            open.push(at);
        } else if closes(token)
            && let Some(start) = open.pop()
        {
            found.push(start..at + 1);
        }
    }
    found
}

/// All statements within braces, with their `;` or braces.
pub fn statements(tokens: &[String]) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    for group in groups(tokens).into_iter().filter(|group| tokens[group.start] == "{") {
        let (mut start, mut depth) = (group.start + 1, 0_usize);
        let inside = tokens.iter().enumerate().take(group.end - 1).skip(group.start + 1);
        for (at, token) in inside {
            let token = token.as_str();
            depth += usize::from(closing(token).is_some());
            depth -= usize::from(closes(token));
            if depth == 0 && matches!(token, ";" | "}") {
                found.push(start..at + 1);
                start = at + 1;
            }
        }
    }
    found
}
