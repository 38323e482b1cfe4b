//! The text that the compiler emits for every definition in files and folders, for comparing two states of the compiler:
//!
//! ```text
//! cargo run -p linkwright-compiler --example emitted -- OUT models/src tests/checks tests/mechanisms examples
//! diff -r OUT_BEFORE OUT
//! ```
//! Each definition is compiled in both sets of coordinates with every word of `emit`, and as it was written. A file in OUT
//! has the text, or the errors where there are some.

use linkwright_compiler::counts::COORDINATES;
use linkwright_compiler::emit::{Home, emit};
use linkwright_compiler::model::Coordinates;
use linkwright_compiler::source::{Source, definition, invocations};
use linkwright_compiler::syntax::EMITTED;
use linkwright_compiler::{compile_model, model, parse, syntax};
use proc_macro2::TokenStream;
use std::fs;
use std::path::{Path, PathBuf};

fn main() {
    let mut arguments = std::env::args().skip(1).map(PathBuf::from);
    let Some(out) = arguments.next() else {
        panic!("give a folder to write to, then files and folders to read")
    };
    fs::create_dir_all(&out).expect("the folder can be made");
    let mut files = Vec::new();
    arguments.for_each(|path| find(&path, &mut files));
    let mut written = 0;
    for file in &files {
        let text = fs::read_to_string(file).expect("sources are text");
        let source = Source::new(file.display().to_string(), text);
        let name = file.display().to_string().replace(['/', '\\'], "-");
        let definitions = if file.extension().is_some_and(|extension| extension == "rs") {
            let found = invocations(&source).unwrap_or_default();
            found.into_iter().map(|invocation| invocation.tokens.stream).collect()
        } else {
            vec![definition(&source).0.stream]
        };
        for (number, tokens) in definitions.iter().enumerate() {
            let sets = COORDINATES.map(|(set, coordinates)| (set, Some(coordinates)));
            for (set, coordinates) in sets.into_iter().chain([("as_written", None)]) {
                let to = out.join(format!("{name}.{number}.{set}.rs"));
                fs::write(to, emitted(tokens, coordinates)).expect("it can be written");
                written += 1;
            }
        }
    }
    println!("{written} texts of {} files", files.len());
}

/// Every Rust file and every definition in a file of its own, in the order of their names.
fn find(path: &Path, files: &mut Vec<PathBuf>) {
    if !path.is_dir() {
        if path.extension().is_some_and(|extension| extension == "rs" || extension == "mech") {
            files.push(path.to_path_buf());
        }
        return;
    }
    let entries = fs::read_dir(path).expect("the folder can be listed");
    let mut entries: Vec<PathBuf> = entries.map(|entry| entry.expect("it can be listed").path()).collect();
    entries.sort();
    entries.iter().for_each(|entry| find(entry, files));
}

/// What a definition expands to, with every word of `emit` where coordinates are given; or its errors.
fn emitted(tokens: &TokenStream, coordinates: Option<Coordinates>) -> String {
    let (home, tokens) = Home::split(tokens.clone());
    let compiled = parse(tokens.clone()).and_then(|definition| {
        let mut mechanism = model::lower(&definition)?;
        if coordinates.is_some() {
            EMITTED.iter().for_each(|word| mechanism.options.emit.set(word));
        }
        compile_model(mechanism, syntax::definition_json(&definition), coordinates)
    });
    match compiled {
        // A line for each statement, so that a difference is a short one.
        Ok(compiled) => {
            let text = emit(&compiled, &tokens.to_string(), &home).1;
            let apart = |line: &str| {
                if line.starts_with("//") { line.to_string() } else { line.replace("; ", ";\n") }
            };
            text.lines().map(|line| apart(line) + "\n").collect()
        }
        Err(errors) => format!("{errors}\n"),
    }
}
