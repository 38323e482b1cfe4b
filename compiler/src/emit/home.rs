//! How emitted code finds the runtime, whatever the crate is called where the macro is used.
//!
//! `linkwright::mechanism!` hands its own crate over as `($crate)` before the definition. Text cannot say `$crate`, because only that
//! token itself carries which crate is meant, so one import of tokens stands before the text and gives it a name:
//!
//! ```text
//! use $crate::__private::v1 as __linkwright_FourBar;
//! pub type FourBarState<R = f64> = __linkwright_FourBar::State<[R; 6], [R; 3]>;
//! ```
//! A path in the definition's options comes before that, and `::linkwright` after it, where nothing was handed over.

use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};

/// The crate that the macro was called from, where it was handed over.
#[derive(Clone, Debug, Default)]
pub struct Home(Option<TokenTree>);

/// What emitted text calls the runtime's names, and the tokens that have to stand before it.
pub struct Runtime {
    pub import: TokenStream,
    pub path: String,
}

impl Home {
    /// Takes `($crate)` from the beginning of what the macro was given.
    pub fn split(tokens: TokenStream) -> (Home, TokenStream) {
        let mut rest = tokens.clone().into_iter();
        let Some(TokenTree::Group(group)) = rest.next() else { return (Home(None), tokens) };
        let mut inside = group.stream().into_iter();
        match (group.delimiter(), inside.next(), inside.next()) {
            (Delimiter::Parenthesis, Some(TokenTree::Ident(word)), None) if word == "$crate" => {
                (Home(Some(word.into())), rest.collect())
            }
            _ => (Home(None), tokens),
        }
    }

    /// For the items of the mechanism of this name, whose options may name the crate.
    pub fn runtime(&self, option: Option<&str>, mechanism: &str) -> Runtime {
        let (import, path) = match (option, &self.0) {
            (Some(path), _) => (TokenStream::new(), format!("{path}::__private::v1")),
            (None, None) => (TokenStream::new(), "::linkwright::__private::v1".to_string()),
            (None, Some(word)) => {
                let name = format!("__linkwright_{}", mechanism.trim_start_matches("r#"));
                (import(word, &name), name)
            }
        };
        Runtime { import, path }
    }
}

/// `use $crate::__private::v1 as NAME;`
fn import(word: &TokenTree, name: &str) -> TokenStream {
    let parsed = |text: &str| text.parse::<TokenStream>().unwrap_or_default();
    let mut import = parsed("#[doc(hidden)] use");
    import.extend([word.clone()]);
    import.extend(parsed("::__private::v1 as"));
    import.extend([TokenTree::Ident(proc_macro2::Ident::new(name, Span::call_site()))]);
    import.extend(parsed(";"));
    import
}
