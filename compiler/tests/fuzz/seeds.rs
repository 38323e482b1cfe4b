//! What mutation starts from: every definition in the sources of this workspace, right or wrong, and the regressions.

use super::tokens;
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::fs;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// Where definitions stand: models, mistakes with their messages, tests of unusual parts.
const PLACES: [&str; 6] = [
    "../models/src",
    "../tests/messages/ui",
    "../tests/hygiene",
    "../tests/checks",
    "../tests/mechanisms/src",
    "../examples",
];

/// One definition and where it comes from.
pub struct Seed {
    pub file: PathBuf,
    pub tokens: Vec<String>,
}

impl Seed {
    /// Whether it is there for the message that it gives.
    pub fn is_mistake(&self) -> bool {
        self.file.components().any(|part| part.as_os_str() == "ui" || part.as_os_str() == "corpus")
    }
}

/// All seeds, in the order of their files.
pub fn all() -> Vec<Seed> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut seeds = Vec::new();
    for file in PLACES.iter().flat_map(|place| files(&root.join(place), "rs")) {
        let text = fs::read_to_string(&file).expect("sources are text");
        if let Ok(stream) = TokenStream::from_str(&text) {
            definitions(stream, &mut |definition| {
                let tokens = tokens::read(&definition.to_string()).expect("tokens were read before");
                seeds.push(Seed { file: file.clone(), tokens });
            });
        }
    }
    for (file, text) in regressions() {
        seeds.push(Seed { file, tokens: tokens::read(&text).expect("a regression consists of tokens") });
    }
    seeds
}

/// The cases that went wrong once, in the order of their names.
pub fn regressions() -> Vec<(PathBuf, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fuzz/corpus");
    let read = |file: PathBuf| (file.clone(), fs::read_to_string(file).expect("a regression is text"));
    files(&folder, "mech").into_iter().map(read).collect()
}

fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder of the workspace");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("it can be listed").path()).collect();
    paths.sort();
    let mut found = Vec::new();
    for path in paths {
        if path.is_dir() {
            found.extend(files(&path, extension));
        } else if path.extension().is_some_and(|found| found == extension) {
            found.push(path);
        }
    }
    found
}

/// What stands in `mechanism! { … }`, however deep.
fn definitions(stream: TokenStream, found: &mut impl FnMut(TokenStream)) {
    let tokens: Vec<TokenTree> = stream.into_iter().collect();
    for (at, token) in tokens.iter().enumerate() {
        let TokenTree::Group(group) = token else { continue };
        if at >= 2 && tokens[at - 2].to_string() == "mechanism" && tokens[at - 1].to_string() == "!" {
            found(concrete(group.stream()));
        } else {
            definitions(group.stream(), found);
        }
    }
}

/// A definition within `macro_rules!` with its variables filled in: repetitions empty, the rest a name or a number.
fn concrete(stream: TokenStream) -> TokenStream {
    let mut result: Vec<TokenTree> = Vec::new();
    let mut tokens = stream.into_iter().peekable();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Punct(punct) if punct.as_char() == '$' => match tokens.next() {
                Some(TokenTree::Group(_)) => {
                    tokens.next();
                }
                Some(TokenTree::Ident(name)) => {
                    let filling = if name == "name" { "Name" } else { "2" };
                    result.extend(TokenStream::from_str(filling).expect("a token"));
                }
                _ => {}
            },
            TokenTree::Group(group) => {
                let inner = concrete(group.stream());
                let delimiter = group.delimiter();
                // An attribute that was a repetition has left its `#` behind.
                if delimiter != Delimiter::None {
                    result.push(TokenTree::Group(proc_macro2::Group::new(delimiter, inner)));
                }
            }
            token => result.push(token),
        }
    }
    result.into_iter().collect()
}
