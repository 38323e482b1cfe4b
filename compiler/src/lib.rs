//! The compiler of Linkwright: the tokens of a definition in, Rust items out.
//!
//! An ordinary library: [`expand`] is what the macro calls, [`compile`] what tests and tools call. The stages, in
//! order, are the modules below; `driver` chains them.

pub mod beams;
mod budget;
pub mod builder;
mod choice;
mod compiled;
pub mod complete;
pub mod counts;
pub mod diagnostics;
mod drawing;
mod driver;
pub mod file;
pub mod forms;
pub mod functions;
mod messages;
pub mod modal;
pub mod numbers;
mod scalar;
pub mod source;
pub mod spelling;
pub mod units;

pub mod check;
pub mod emit;
pub mod equations;
mod expansion;
pub mod export;
pub mod model;
pub mod optimize;
pub mod order;
pub mod page;
pub mod schedule;
pub mod self_check;
pub mod solve;
pub mod syntax;

pub mod symbolic;

pub use choice::{Choice, Rejected};
pub use compiled::{Compiled, Repetition};
pub use driver::{
    Start, compile, compile_at, compile_definition, compile_model, compile_with, header, parse, parse_at,
    start,
};
pub use expansion::Expansion;
pub use page::page;

/// How drawings write text and numbers, for those who put more beside them.
pub mod drawing_text {
    pub use crate::drawing::canvas::{escaped, number};
}

use emit::Home;
use proc_macro2::{Span, TokenStream};
use source::written::{Place, as_written};

/// The expansion of `mechanism! { … }` or `mechanism!(file = "…")`, before which `($crate)` may stand. `place_of` tells where a token stands,
/// where that is known.
pub fn expand(tokens: TokenStream, place_of: impl Fn(Span) -> Option<Place>) -> Expansion {
    let (home, tokens) = Home::split(tokens);
    match file::named(&tokens) {
        None => expand_definition(tokens, &home, &place_of),
        Some(Ok(named)) => {
            let caller = place_of(named.region.start).map(|place| place.file);
            file::expand(&named, caller, &home)
        }
        Some(Err(errors)) => Expansion::Errors(errors.into_compile_errors()),
    }
}

fn expand_definition(
    tokens: TokenStream,
    home: &Home,
    place_of: &dyn Fn(Span) -> Option<Place>,
) -> Expansion {
    let file_of = |span| place_of(span).map(|place| place.file);
    match compile_at(tokens.clone(), None, &file_of) {
        Ok(compiled) => {
            let source = as_written(&tokens, place_of).unwrap_or_else(|| tokens.to_string());
            let (import, mut text) = emit::emit(&compiled, &source, home);
            text.push_str(&export::shims(&compiled, home));
            let name = compiled.mechanism.name.span;
            Expansion::Items { import, text, warnings: compiled.warnings, name }
        }
        Err(errors) => Expansion::Errors(emit::stub(errors.into_compile_errors(), tokens, home, &file_of)),
    }
}

/// The page of documentation of what [`expand`] expands, before which `in "folder"` may stand, where tables in files of their own are.
pub fn expand_page(tokens: TokenStream) -> String {
    let (folder, tokens) = file::folder(tokens);
    match compile_at(tokens, None, &|_| folder.clone()) {
        Ok(compiled) => page(&compiled),
        // What was compiled before cannot be read again: the page says so, and documentation is built all the same.
        Err(errors) => format!("```text\nNo page: {errors}\n```\n"),
    }
}

/// The error in place of items that cannot be read back, which is a mistake of this crate.
pub fn unreadable(error: &str) -> TokenStream {
    let mut errors = diagnostics::Diagnostics::new();
    errors.error(Span::call_site(), messages::unreadable_expansion(error));
    errors.into_compile_errors()
}
