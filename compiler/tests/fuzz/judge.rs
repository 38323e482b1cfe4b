//! What the compiler may not do, whatever it is given.

use super::tokens;
use linkwright_compiler::Expansion;
use proc_macro2::{Span, TokenStream, TokenTree};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Mutex;

/// How a case ended that is as it should be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Not tokens of Rust: rustc would not call the macro.
    Unread,
    /// The expansion, which reads as Rust.
    Items,
    /// Messages, all of them at a place.
    Errors,
}

/// Where the last panic was, and what it said.
static PANIC: Mutex<String> = Mutex::new(String::new());

/// Panics are kept for the report and not printed.
#[allow(dead_code)] // Only the example prints what it finds.
pub fn keep_panics() {
    std::panic::set_hook(Box::new(|panic| {
        if let Ok(mut last) = PANIC.lock() {
            *last = panic.to_string().replace('\n', " ");
        }
    }));
}

/// Expands the text as the macro would, and looks at what comes out. The error is what is wrong with it.
pub fn judge(text: &str) -> Result<Verdict, String> {
    // The places of tokens of former cases are forgotten.
    proc_macro2::extra::invalidate_current_thread_spans();
    let Some(stream) = tokens::stream(text) else { return Ok(Verdict::Unread) };
    let empty = stream.is_empty();
    let expansion = catch_unwind(AssertUnwindSafe(|| linkwright_compiler::expand(stream, |_| None)))
        .map_err(|_| PANIC.lock().map_or_else(|_| "panicked".to_string(), |last| last.clone()))?;
    match expansion {
        Expansion::Items { text: items, .. } => readable(text, &items).map(|()| Verdict::Items),
        Expansion::Errors(errors) => messages(text, errors, empty).map(|()| Verdict::Errors),
    }
}

/// Rust, and no number that is none.
fn readable(source: &str, items: &str) -> Result<(), String> {
    syn::parse_file(items).map_err(|error| format!("unreadable expansion: {error}"))?;
    for word in ["inf", "NaN"] {
        let outside = |piece: &str| !piece.ends_with(|c: char| c.is_alphanumeric() || c == '_');
        let found =
            items.split(word).collect::<Vec<_>>().windows(2).any(|pair| {
                outside(pair[0]) && !pair[1].starts_with(|c: char| c.is_alphanumeric() || c == '_')
            });
        if found && !source.contains(word) {
            return Err(format!("`{word}` is emitted"));
        }
    }
    Ok(())
}

/// At least one message, each at a place, and a stub that reads as Rust. Only nothing at all has no place.
fn messages(source: &str, errors: TokenStream, empty: bool) -> Result<(), String> {
    let count = texts(source, errors.clone(), empty)?;
    if count == 0 {
        return Err("no items and no message".to_string());
    }
    syn::parse2::<syn::File>(errors).map(drop).map_err(|error| format!("unreadable stub: {error}"))
}

/// How many messages there are, in braces within too.
fn texts(source: &str, errors: TokenStream, empty: bool) -> Result<usize, String> {
    let tokens: Vec<TokenTree> = errors.into_iter().collect();
    let inside = tokens.iter().filter_map(|token| match token {
        TokenTree::Group(group) => Some(texts(source, group.stream(), empty)),
        _ => None,
    });
    let mut count = inside.sum::<Result<usize, String>>()?;
    for at in (0..tokens.len()).filter(|at| tokens[*at].to_string() == "compile_error") {
        let (first, Some(TokenTree::Group(group))) = (&tokens[at.saturating_sub(5)], tokens.get(at + 2))
        else {
            return Err("a message without its text".to_string());
        };
        let Some(TokenTree::Literal(text)) = group.stream().into_iter().next() else {
            return Err("a message without its text".to_string());
        };
        count += 1;
        if !empty && (nowhere(first.span()) || nowhere(text.span())) {
            return Err(format!("a message at no place: {text}"));
        }
        let words = text.to_string();
        let not_finite =
            words.split(|c: char| !c.is_alphanumeric()).find(|word| matches!(*word, "NaN" | "inf"));
        if not_finite.is_some_and(|word| !source.contains(word)) {
            return Err(format!("a message with a number that is none: {text}"));
        }
    }
    Ok(count)
}

fn nowhere(span: Span) -> bool {
    span.byte_range().is_empty()
}
