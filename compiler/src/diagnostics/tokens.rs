//! What rustc is told: `compile_error!` at the place of an error, and something deprecated at the place of a warning.
//!
//! The stable compiler gives procedural macros no warnings of their own. What it does warn of at any place, with any
//! text, is the use of something deprecated. Of a macro it tells the name alone, of all else the modules around too:
//!
//! ```text
//! #[warn(warnings, deprecated)]
//! const _: () = {
//!     {
//!         #[deprecated(note = "…")] macro_rules! unused { () => {} }
//!         unused! {}     // these tokens stand where the warning points
//!     }
//! };
//! ```
//! The level is set there, so that `deny(warnings)` around it, or `-D warnings`, leaves a warning what it is.

use super::{Diagnostics, Region, Severity};
use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};
use std::str::FromStr;

impl Diagnostics {
    /// One `::core::compile_error! { "…" }` per error and per note, each at its place.
    pub fn into_compile_errors(self) -> TokenStream {
        let mut stream = TokenStream::new();
        for error in self.into_found() {
            compile_error(&mut stream, error.region, &error.message);
            for note in error.notes {
                compile_error(&mut stream, note.region, &note.message);
            }
        }
        stream
    }

    /// Warnings, each at its place; `home` is the name of the mechanism, where rustc shows their level.
    pub fn into_warnings(self, home: Region) -> TokenStream {
        let mut uses = TokenStream::new();
        for warning in self.found {
            let Severity::Warning(lint) = warning.severity else { continue };
            uses.extend([braced(deprecated(warning.region, lint.word(), &warning.message))]);
        }
        if uses.is_empty() {
            return uses;
        }
        let mut stream = spanned("#[warn(warnings, deprecated)] const _: () =", home.start);
        stream.extend([braced(uses), punct(';', Spacing::Alone, home.start)]);
        stream
    }
}

/// Something deprecated and, at the place of the warning, its use.
fn deprecated(region: Region, name: &str, message: &str) -> TokenStream {
    let text = format!("#[deprecated(note = {message:?})] macro_rules! {name} {{ () => {{}} }} {name}! {{}}");
    // rustc points at the name only, so its one token has to have the whole place.
    spanned(&text, region.span())
}

/// Tokens of this crate's own text, all at one place.
fn spanned(text: &str, span: Span) -> TokenStream {
    fn respan(stream: TokenStream, span: Span) -> TokenStream {
        let tokens = stream.into_iter().map(|mut token| {
            if let TokenTree::Group(group) = &token {
                let inner = respan(group.stream(), span);
                token = TokenTree::Group(Group::new(group.delimiter(), inner));
            }
            token.set_span(span);
            token
        });
        tokens.collect()
    }
    respan(TokenStream::from_str(text).unwrap_or_default(), span)
}

fn braced(stream: TokenStream) -> TokenTree {
    TokenTree::Group(Group::new(Delimiter::Brace, stream))
}

fn word(text: &str, span: Span) -> TokenTree {
    TokenTree::Ident(Ident::new(text, span))
}

fn punct(character: char, spacing: Spacing, span: Span) -> TokenTree {
    let mut punct = Punct::new(character, spacing);
    punct.set_span(span);
    TokenTree::Punct(punct)
}

/// `::core::compile_error! { "message" }`: the compiler underlines from the first token's span to the last one's.
pub(crate) fn compile_error(stream: &mut TokenStream, region: Region, message: &str) {
    let mut literal = Literal::string(message);
    literal.set_span(region.end);
    let mut group = Group::new(Delimiter::Brace, TokenTree::Literal(literal).into());
    group.set_span(region.end);
    stream.extend([
        punct(':', Spacing::Joint, region.start),
        punct(':', Spacing::Alone, region.start),
        word("core", region.start),
        punct(':', Spacing::Joint, region.start),
        punct(':', Spacing::Alone, region.start),
        word("compile_error", region.start),
        punct('!', Spacing::Alone, region.start),
        TokenTree::Group(group),
    ]);
}
