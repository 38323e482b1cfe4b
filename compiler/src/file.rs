//! Definitions in files of their own: `mechanism!(file = "arm.mech")`. What the macro names, where that is, what can be
//! wrong with it, and what is emitted so that the crate is built anew when the file changes.

use crate::diagnostics::{Diagnostics, Region};
use crate::emit::Home;
use crate::expansion::Expansion;
use crate::messages;
pub use crate::source::disk::{open, read, text};
use crate::source::{self, Tokens};
use crate::{driver, emit, export};
use proc_macro2::{TokenStream, TokenTree};
use std::path::PathBuf;

/// The name of a file as a macro gives it.
#[derive(Clone, Debug)]
pub struct Named {
    pub name: String,
    /// Where the name stands.
    pub region: Region,
}

/// What stands behind `file =`; nothing if the macro holds the definition itself.
pub fn named(tokens: &TokenStream) -> Option<Result<Named, Diagnostics>> {
    let mut tokens = tokens.clone().into_iter().zip(1..);
    let word = match tokens.next()? {
        (TokenTree::Ident(word), serial) if word == "file" => Region::of_token(word.span(), serial),
        _ => return None,
    };
    let mut errors = Diagnostics::new();
    let equals = matches!(tokens.next(), Some((TokenTree::Punct(punct), _)) if punct.as_char() == '=');
    let name = tokens.next().filter(|_| equals).map(|(tree, serial)| {
        let region = Region::of_token(tree.span(), serial);
        let text = syn::parse2::<syn::LitStr>(tree.into()).ok();
        (text.map(|text| text.value()).filter(|name| !name.is_empty()), region)
    });
    let more = tokens.find(|(tree, _)| !matches!(tree, TokenTree::Punct(punct) if punct.as_char() == ','));
    match (name, more) {
        (Some((Some(name), region)), None) => return Some(Ok(Named { name, region })),
        (Some((Some(_), _)), Some((tree, serial))) => {
            errors.error(Region::of_token(tree.span(), serial), messages::file_and_more());
        }
        (Some((None, region)), _) => errors.error(region, messages::file_without_name()),
        (None, _) => errors.error(word, messages::file_without_name()),
    }
    Some(Err(errors))
}

/// The expansion of a macro that names a file: what the same definition in the macro would become. Errors stand at the name
/// and tell their place in the file themselves.
pub(crate) fn expand(named: &Named, caller: Option<PathBuf>, home: &Home) -> Expansion {
    let span = named.region.start;
    let failed = |message: String| {
        let mut errors = Diagnostics::new();
        errors.error(span, message);
        Expansion::Errors(errors.into_compile_errors())
    };
    let source = match read(&named.name, caller.as_deref()) {
        Ok(source) => source,
        Err(message) => return failed(message),
    };
    let Some(path) =
        std::path::absolute(&source.name).ok().and_then(|path| path.to_str().map(str::to_string))
    else {
        return failed(messages::path_not_unicode(&source.name));
    };
    let (tokens, mut errors) = source::definition_at(&source, span);
    let beside = PathBuf::from(&source.name);
    let file_of = |_| Some(beside.clone());
    if errors.is_empty() {
        match driver::compile_at(tokens.stream.clone(), None, &file_of) {
            Ok(compiled) => {
                let (import, mut text) = emit::emit(&compiled, &source.text, home);
                text.push_str(&export::shims(&compiled, home));
                text.push_str(&emit::depends_on(&path));
                let warnings = tokens.locate(compiled.warnings);
                let warnings = source::warnings(&source, &warnings, named.region);
                return Expansion::Items { import, text, warnings, name: named.region };
            }
            Err(found) => errors = tokens.locate(found),
        }
    }
    let Tokens { stream, .. } = tokens;
    let errors = source::compile_errors(&source, &errors, span);
    Expansion::Errors(emit::stub(errors, stream, home, &file_of))
}

/// Takes `in "folder"` from the beginning of a definition: a file in that folder.
pub(crate) fn folder(tokens: TokenStream) -> (Option<PathBuf>, TokenStream) {
    let mut rest = tokens.clone().into_iter();
    let (word, name) = (rest.next(), rest.next());
    let literal = match (word, name) {
        (Some(TokenTree::Ident(word)), Some(name)) if word == "in" => {
            syn::parse2::<syn::LitStr>(name.into()).ok()
        }
        _ => None,
    };
    match literal {
        Some(literal) => (Some(PathBuf::from(literal.value()).join("definition")), rest.collect()),
        None => (None, tokens),
    }
}
