//! Definitions in files of their own: `mechanism!(file = "arm.mech")`. What the macro names, where that is, what can be
//! wrong with it, and what is emitted so that the crate is built anew when the file changes.

use crate::diagnostics::{Diagnostics, Region};
use crate::emit::Home;
use crate::expansion::Expansion;
use crate::messages;
use crate::source::{self, Source, Tokens};
use crate::{driver, emit};
use proc_macro2::{TokenStream, TokenTree};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

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

/// The file of that name as seen from the Rust file that names it, which is not known everywhere.
pub fn read(name: &str, caller: Option<&Path>) -> Result<Source, String> {
    let manifest = std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from).unwrap_or_default();
    let (folder, beside) = match caller {
        Some(file) => {
            (file.parent().unwrap_or(Path::new("")), messages::beside_caller(&file.display().to_string()))
        }
        None => (manifest.as_path(), messages::beside_manifest(&manifest.display().to_string())),
    };
    open_from(&folder.join(name), &beside)
}

/// The file of that path as seen from where the program runs.
pub fn open(path: &Path) -> Result<Source, String> {
    let here = std::env::current_dir().map(|folder| folder.display().to_string()).unwrap_or_default();
    open_from(path, &messages::from_folder(&here))
}

/// `from` says where the path begins.
fn open_from(path: &Path, from: &str) -> Result<Source, String> {
    let shown = path.display().to_string();
    if path.is_dir() {
        return Err(messages::is_directory(&shown));
    }
    let bytes = std::fs::read(path).map_err(|error| match error.kind() {
        ErrorKind::NotFound => messages::no_file(&shown, from, similar(path).as_deref()),
        _ => messages::unreadable_file(&shown, &error.to_string()),
    })?;
    text(&shown, bytes)
}

/// The bytes of a file as text.
pub fn text(name: &str, bytes: Vec<u8>) -> Result<Source, String> {
    String::from_utf8(bytes).map(|text| Source::new(name, text)).map_err(|error| {
        let valid = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let valid = Source::new(name, String::from_utf8_lossy(valid));
        let at = valid.position(valid.text.len());
        messages::not_utf8(name, at.line, at.column)
    })
}

/// The file in the same folder whose name is nearest.
fn similar(path: &Path) -> Option<String> {
    let name = path.file_name()?.to_str()?;
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let names =
        std::fs::read_dir(folder).ok()?.flatten().filter_map(|entry| entry.file_name().into_string().ok());
    let mut names: Vec<String> = names.collect();
    names.sort_unstable();
    messages::closest(name, names.iter().map(String::as_str)).map(str::to_string)
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
    if errors.is_empty() {
        match driver::compile(tokens.stream.clone(), None) {
            Ok(compiled) => {
                let (import, mut text) = emit::emit(&compiled, &source.text, home);
                text.push_str(&emit::depends_on(&path));
                let warnings = tokens.locate(compiled.warnings);
                let warnings = source::warnings(&source, &warnings, named.region);
                return Expansion::Items { import, text, warnings, name: named.region };
            }
            Err(found) => errors = tokens.locate(found),
        }
    }
    let Tokens { stream, .. } = tokens;
    let mut errors = source::compile_errors(&source, &errors, span);
    errors.extend(emit::stub(stream, home));
    Expansion::Errors(errors)
}
