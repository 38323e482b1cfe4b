//! The `mechanism!` macro: a shell around `linkwright-compiler`.
#![warn(missing_docs)]

use linkwright_compiler::diagnostics::Region;
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
/// The language, and what is emitted, are described in the documentation of the crate `linkwright`.
#[proc_macro]
pub fn mechanism(tokens: TokenStream) -> TokenStream {
    match linkwright_compiler::expand(tokens.into()) {
        Expansion::Items { text, mut warnings, name } => {
            let items = text.parse();
            let mut items: TokenStream =
                items.unwrap_or_else(|error: LexError| unreadable(&error.to_string()).into());
            warnings.retain(|warning| is_of_the_user(warning.region));
            items.extend(TokenStream::from(warnings.into_warnings(name)));
            items
        }
        Expansion::Errors(tokens) => tokens.into(),
    }
}

/// Whether a place is in a file that the user may change, and not in one that cargo has fetched: a definition can come
/// out of a macro of somebody else's.
fn is_of_the_user(region: Region) -> bool {
    let file = region.start.unwrap().local_file().unwrap_or_default();
    let folders: Vec<_> = file.components().map(|part| part.as_os_str().to_os_string()).collect();
    let fetched = |pair: &[std::ffi::OsString]| {
        (pair[0] == "registry" && pair[1] == "src") || (pair[0] == "git" && pair[1] == "checkouts")
    };
    !folders.windows(2).any(fetched)
}
