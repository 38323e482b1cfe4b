//! The `mechanism!` macro, and the one that writes its documentation: shells around `linkwright-compiler`.
#![warn(missing_docs)]

use linkwright_compiler::{Expansion, unreadable};
use proc_macro::{LexError, Literal, TokenStream, TokenTree};

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
/// The language, and what is emitted, are described in the documentation of the crate `linkwright`.
#[proc_macro]
pub fn mechanism(tokens: TokenStream) -> TokenStream {
    match linkwright_compiler::expand(tokens.into()) {
        Expansion::Items(text) => {
            text.parse().unwrap_or_else(|error: LexError| unreadable(&error.to_string()).into())
        }
        Expansion::Errors(tokens) => tokens.into(),
    }
}

/// The page of a mechanism, as a string. [`mechanism!`] puts it where only a build with `cfg(doc)` expands it.
#[doc(hidden)]
#[proc_macro]
pub fn mechanism_page(tokens: TokenStream) -> TokenStream {
    let page = linkwright_compiler::expand_page(tokens.into());
    TokenTree::from(Literal::string(&page)).into()
}
