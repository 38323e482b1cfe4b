//! The definitions that ship, and those of the zoo, as their files have them.

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::path::Path;

/// File and tokens of every `mechanism! { … }` in `models/src` and `tests/checks/zoo*.rs`.
pub fn definitions() -> Vec<(String, TokenStream)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut files = Vec::new();
    for folder in ["models/src", "tests/checks"] {
        let entries = std::fs::read_dir(root.join(folder)).expect("the workspace has this folder");
        files.extend(entries.map(|entry| entry.expect("an entry").path()).filter(|path| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            name.ends_with(".rs") && (folder == "models/src" || name.starts_with("zoo"))
        }));
    }
    files.sort();
    let mut found = Vec::new();
    for file in files {
        let text = std::fs::read_to_string(&file).expect("a source file");
        let tokens = text.parse().expect("a source file consists of tokens");
        let name = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        collect(tokens, &name, &mut found);
    }
    found
}

fn collect(tokens: TokenStream, file: &str, found: &mut Vec<(String, TokenStream)>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    for (at, tree) in tokens.iter().enumerate() {
        let TokenTree::Group(group) = tree else { continue };
        let is_macro = at >= 2
            && matches!(&tokens[at - 1], TokenTree::Punct(punct) if punct.as_char() == '!')
            && matches!(&tokens[at - 2], TokenTree::Ident(word) if word == "mechanism");
        if is_macro && group.delimiter() == Delimiter::Brace {
            found.push((file.to_string(), group.stream()));
        } else {
            collect(group.stream(), file, found);
        }
    }
}
