//! The `mechanism!` macro, and the one that writes its documentation: shells around `linkwright-compiler`.
#![warn(missing_docs)]

use linkwright_compiler::diagnostics::Region;
use linkwright_compiler::source::written::Place;
use linkwright_compiler::{Expansion, unreadable};
use proc_macro::{LexError, Literal, TokenStream, TokenTree};
use proc_macro2::Span;
use std::ffi::OsStr;
use std::path::Path;

/// What `linkwright::mechanism!` calls, with `($crate)` before the definition. Called without it, it takes the crate for `::linkwright`.
#[proc_macro]
pub fn mechanism(tokens: TokenStream) -> TokenStream {
    match linkwright_compiler::expand(tokens.into(), place_of) {
        Expansion::Items { import, text, mut warnings, name } => {
            let mut items = TokenStream::from(import);
            let read = text.parse::<TokenStream>();
            items.extend(read.unwrap_or_else(|error: LexError| unreadable(&error.to_string()).into()));
            warnings.retain(|warning| is_of_the_user(warning.region));
            items.extend(TokenStream::from(warnings.into_warnings(name)));
            items
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

/// Where a token stands, as far as rustc tells.
fn place_of(span: Span) -> Option<Place> {
    let span = span.unwrap();
    let ends = [span.start(), span.end()];
    let [start, end] = ends.map(|end| [end.line(), end.column()]);
    Some(Place { file: span.local_file()?, start, end })
}

/// Whether a place is in a file that the user may change: a definition can come out of a macro of somebody else's.
fn is_of_the_user(region: Region) -> bool {
    region.start.unwrap().local_file().is_none_or(|file| !is_fetched(&file))
}

/// Whether cargo has fetched a file, from a registry or a repository.
fn is_fetched(file: &Path) -> bool {
    let folders: Vec<&OsStr> = file.components().map(|part| part.as_os_str()).collect();
    let pairs = [["registry", "src"], ["git", "checkouts"]];
    folders.windows(2).any(|pair| pairs.iter().any(|fetched| pair == fetched))
}

#[cfg(test)]
mod tests {
    use super::is_fetched;
    use std::path::Path;

    #[test]
    fn what_cargo_has_fetched() {
        for file in [
            "/home/user/.cargo/registry/src/index-1949/arms-0.1.0/src/lib.rs",
            "/cargo/git/checkouts/arms-1/2/src/lib.rs",
        ] {
            assert!(is_fetched(Path::new(file)), "{file}");
        }
        for file in ["src/main.rs", "/home/user/registry/arms/src/lib.rs", "/home/user/git/arms/src/lib.rs"] {
            assert!(!is_fetched(Path::new(file)), "{file}");
        }
    }
}
