//! The `mechanism!` macro: a shell around `linkwright-compiler`.
#![warn(missing_docs)]

use linkwright_compiler::{Expansion, unreadable};
use proc_macro::{LexError, TokenStream};

/// Compiles a definition of a mechanism into its equations of motion.
///
/// ```text
/// mechanism! {
///     pub planar Pendulum {
///         gravity [m/s^2] = (0, -9.81);
///         rod arm { mass [kg] = 1; length [m] = 1; }
///         joint pivot: revolute(ground(0, 0) [m], arm.start);
///         start { pivot.angle [rad] = 0.5; }
///     }
/// }
/// ```
/// A definition may also stand in a file of its own, beside the Rust file that names it, which holds what stands in the
/// braces above:
///
/// ```text
/// mechanism!(file = "pendulum.mech");
/// ```
/// The language, and what is emitted, are described in the documentation of the crate `linkwright`.
#[proc_macro]
pub fn mechanism(tokens: TokenStream) -> TokenStream {
    match linkwright_compiler::expand(tokens.into(), |span| span.unwrap().local_file()) {
        Expansion::Items(text) => {
            text.parse().unwrap_or_else(|error: LexError| unreadable(&error.to_string()).into())
        }
        Expansion::Errors(tokens) => tokens.into(),
    }
}
