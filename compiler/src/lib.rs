//! The compiler of Linkwright: the tokens of a definition in, Rust items out.
//!
//! An ordinary library: [`expand`] is what the macro calls, [`compile`] what tests and tools call. The stages, in
//! order, are the modules below; `driver` chains them.

mod choice;
pub mod diagnostics;
mod driver;
mod functions;
mod messages;
pub mod units;

pub mod check;
pub mod emit;
pub mod equations;
pub mod model;
pub mod optimize;
pub mod schedule;
pub mod self_check;
pub mod solve;
pub mod syntax;

pub mod symbolic;

pub use choice::{Choice, Rejected};
pub use driver::{Compiled, compile, compile_model};

use proc_macro2::TokenStream;

/// What `mechanism! { … }` stands for.
#[derive(Clone, Debug)]
pub enum Expansion {
    /// The model's items, as Rust text.
    ///
    /// Text, because a macro hands it to rustc's own lexer at once: `proc_macro2` reads everything with its own lexer
    /// first, which takes an unoptimised macro seven times as long.
    Items(String),
    /// Errors at their places, and a stub in the model's place.
    Errors(TokenStream),
}

/// The expansion of `mechanism! { … }`.
pub fn expand(tokens: TokenStream) -> Expansion {
    match compile(tokens.clone(), None) {
        Ok(compiled) => Expansion::Items(emit::emit(&compiled, &tokens.to_string())),
        Err(errors) => {
            let mut stream = errors.into_compile_errors();
            stream.extend(emit::stub(tokens));
            Expansion::Errors(stream)
        }
    }
}

/// The error in place of items that cannot be read back, which is a mistake of this crate.
pub fn unreadable(error: &str) -> TokenStream {
    let mut errors = diagnostics::Diagnostics::new();
    errors.error(proc_macro2::Span::call_site(), messages::unreadable_expansion(error));
    errors.into_compile_errors()
}
