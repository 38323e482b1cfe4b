//! Every text of a message is what some test sees: of each literal in the sources of the messages, a piece stands in a
//! pair of `tests/messages/ui` or in a test of the compiler or of the command line.

use std::fs;
use std::path::{Path, PathBuf};

/// Shorter pieces say nothing.
const TELLING: usize = 12;

/// Texts that no test sees: limits of this crate against its own mistakes, what only a file system can bring about, and what
/// rustc refuses before any of this.
const UNSEEN: [&str; 10] = [
    // In the corpus of the fuzzer.
    "` is not known here: bodies are placed after their own points and lines are read",
    "` is not a literal of Rust",
    "from the folder `",
    "!` writes here cannot be told without rustc, so the definition in it is not checked: no rule of it fits, it takes more \
     than `ident`, `tt`, `literal`, `meta`, `lifetime`, `vis`, `block` and `expr`, or it calls itself too often",
    "the generated code could not be read back (",
    " must be known at expansion",
    "Linkwright contradicts itself, so there is no model: this is a mistake of Linkwright, not of the definition. It compared ",
    "` cannot be read: ",
    "` is not Unicode, and Rust cannot name it: rename the file or its folder",
    "beside the file that names them; which one that is could not be found out here, so the folder of Cargo.toml was \
     taken, `",
];

#[test]
fn every_text_is_seen_by_a_test() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut seen = String::new();
    for file in files(&root.join("../tests/messages/ui"), "stderr") {
        seen += &read(&file);
    }
    let tests = files(&root.join("tests"), "rs").into_iter().chain(files(&root.join("../cli/tests"), "rs"));
    for file in tests {
        for text in literals(&read(&file)) {
            seen += &text;
            seen.push('\n');
        }
    }
    for file in files(&root.join("../cli/tests"), "txt") {
        seen += &read(&file);
    }
    let mut unseen = Vec::new();
    for file in files(&root.join("src/messages"), "rs") {
        for text in literals(&read(&file)) {
            let pieces = pieces(&text);
            let known = pieces.iter().any(|piece| UNSEEN.contains(&piece.as_str()));
            if !pieces.is_empty() && !known && !pieces.iter().any(|piece| seen.contains(piece.as_str())) {
                unseen.push(format!("{}: {text}", file.file_name().unwrap_or_default().display()));
            }
        }
    }
    assert!(unseen.is_empty(), "no test sees these texts:\n{}", unseen.join("\n"));
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// All files with this extension below a folder, in a fixed order.
fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display())) {
        let path = entry.expect("it can be listed").path();
        if path.is_dir() {
            found.extend(files(&path, extension));
        } else if path.extension().is_some_and(|own| own == extension) {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// The strings of a source file, comments left out, as they read when they run.
fn literals(source: &str) -> Vec<String> {
    let is_comment = |line: &&str| !line.trim_start().starts_with("//");
    let source: String = source.lines().filter(is_comment).map(|line| format!("{line}\n")).collect();
    let tokens: proc_macro2::TokenStream = source.parse().expect("a source file");
    let mut found = Vec::new();
    collect(tokens, &mut found);
    found
}

fn collect(tokens: proc_macro2::TokenStream, found: &mut Vec<String>) {
    for token in tokens {
        match token {
            proc_macro2::TokenTree::Group(group) => collect(group.stream(), found),
            proc_macro2::TokenTree::Literal(literal) => found.extend(content(&literal.to_string())),
            _ => {}
        }
    }
}

/// What is between the quotes of a string.
fn content(literal: &str) -> Option<String> {
    if let Some(raw) = literal.strip_prefix("r#\"") {
        return raw.strip_suffix("\"#").map(str::to_string);
    }
    let inside = literal.strip_prefix('"')?.strip_suffix('"')?;
    let mut text = String::new();
    let mut rest = inside.chars().peekable();
    while let Some(character) = rest.next() {
        match (character, rest.peek()) {
            ('\\', Some('\n')) => while rest.next_if(|next| next.is_whitespace()).is_some() {},
            ('\\', Some('n')) => {
                rest.next();
                text.push('\n');
            }
            ('\\', Some(_)) => text.extend(rest.next()),
            _ => text.push(character),
        }
    }
    Some(text)
}

/// The telling parts of a format string between what is filled in.
fn pieces(format: &str) -> Vec<String> {
    let whole = format.replace("{{", "\u{1}").replace("}}", "\u{2}");
    let mut pieces = Vec::new();
    for (index, piece) in whole.split('{').enumerate() {
        let fixed = if index == 0 { piece } else { piece.split_once('}').map_or("", |(_, fixed)| fixed) };
        let fixed = fixed.replace('\u{1}', "{").replace('\u{2}', "}");
        // What has no space is a word of a table.
        if fixed.chars().count() >= TELLING && fixed.trim().contains(' ') {
            pieces.push(fixed);
        }
    }
    pieces
}
