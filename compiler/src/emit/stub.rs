//! What stands in the model's place after an error, so that one mistake gives one message.
//!
//! The names that other code uses exist; their insides do not. Nothing can run, because the crate does not compile.

use crate::syntax;
use proc_macro2::TokenStream;
use std::fmt::Write;

/// Empty items with the model's names; nothing if not even a name was written.
pub fn stub(tokens: TokenStream) -> TokenStream {
    let Some(header) = syntax::header(tokens) else { return TokenStream::new() };
    let (visibility, name) = (header.visibility.to_string(), header.name.to_string());
    let mut text = String::new();
    let scalar = "scalar: ::core::marker::PhantomData<R>";
    for suffix in ["", "Parameters", "Inputs", "Outputs", "State"] {
        let _ = writeln!(
            text,
            "#[allow(missing_docs, dead_code)] {visibility} struct {name}{suffix}<R = ::core::primitive::f64> {{ {scalar} }}"
        );
    }
    text.parse().unwrap_or_default()
}
