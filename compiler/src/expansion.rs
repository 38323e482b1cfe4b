//! What the macro hands to rustc.

use crate::diagnostics::{Diagnostics, Region};
use proc_macro2::TokenStream;

/// What `mechanism! { … }` stands for.
#[derive(Clone, Debug)]
pub enum Expansion {
    /// The model's items, as Rust text, and what has to stand before it; warnings, and the name of the mechanism they are of.
    ///
    /// Text, because a macro hands it to rustc's own lexer at once: `proc_macro2` reads everything with its own lexer
    /// first, which takes an unoptimised macro seven times as long.
    Items { import: TokenStream, text: String, warnings: Diagnostics, name: Region },
    /// Errors at their places, and a stub in the model's place.
    Errors(TokenStream),
}
