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
pub mod solve;
pub mod syntax;

pub mod symbolic;

pub use choice::{Choice, Rejected};
pub use driver::{Compiled, compile, compile_model};

use proc_macro2::TokenStream;

/// The expansion of `mechanism! { … }`: the model's items, or errors and a stub in its place.
pub fn expand(tokens: TokenStream) -> TokenStream {
    let source = tokens.to_string();
    match compile(tokens.clone(), None) {
        Ok(compiled) => match emit::emit(&compiled, &source) {
            Ok(items) => items,
            Err(error) => {
                let mut errors = diagnostics::Diagnostics::new();
                errors.error(compiled.mechanism.name.span, messages::unreadable_expansion(&error));
                errors.into_compile_errors()
            }
        },
        Err(errors) => {
            let mut stream = errors.into_compile_errors();
            stream.extend(emit::stub(tokens));
            stream
        }
    }
}
