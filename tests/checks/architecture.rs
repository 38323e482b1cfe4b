//! What must be absent from the sources: the invariants of ARCHITECTURE.md that the compiler cannot enforce.

use std::fs;
use std::path::{Path, PathBuf};

/// All Rust files below a directory of the workspace.
fn sources(directory: &str) -> Vec<(PathBuf, String)> {
    fn collect(directory: &Path, found: &mut Vec<(PathBuf, String)>) {
        for entry in fs::read_dir(directory).expect("a directory of the workspace") {
            let path = entry.expect("it can be listed").path();
            if path.is_dir() {
                collect(&path, found);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let text = fs::read_to_string(&path).expect("sources are text");
                found.push((path, text));
            }
        }
    }
    let mut found = Vec::new();
    collect(&Path::new(env!("CARGO_MANIFEST_DIR")).join(directory), &mut found);
    assert!(!found.is_empty(), "{directory} has sources");
    found
}

/// The code of a file without its comments and what follows `#[cfg(test)]`.
fn code(text: &str) -> String {
    let tested = text.find("#[cfg(test)]").unwrap_or(text.len());
    let lines = text[..tested].lines().map(|line| line.split("//").next().unwrap_or_default());
    lines.collect::<Vec<_>>().join("\n")
}

/// The symbolic core knows nothing of mechanisms, tokens or Rust: it imports nothing of its crate, and of others only
/// `std` and `libm`.
#[test]
fn the_symbolic_core_imports_nothing() {
    for (path, text) in sources("compiler/src/symbolic") {
        let code = code(&text);
        for outside in ["crate::", "super::super", "proc_macro", "syn::", "quote"] {
            let found = code.contains(outside);
            assert!(!found, "{} names `{outside}`", path.display());
        }
        for line in code.lines().map(str::trim).filter(|line| line.starts_with("use ")) {
            let inner =
                ["use super::", "use std::", "use self::"].iter().any(|known| line.starts_with(known));
            assert!(inner, "{}: {line}", path.display());
        }
    }
}

/// The runtime runs bare: no standard library, no allocation, no unsafe code, nothing that panics by name.
#[test]
fn the_runtime_runs_bare() {
    let sources = sources("runtime/src");
    let root = sources
        .iter()
        .find(|(path, _)| path.ends_with("runtime/src/lib.rs"))
        .expect("the runtime has a root");
    for attribute in ["#![no_std]", "#![forbid(unsafe_code)]", "#![warn(missing_docs)]"] {
        assert!(root.1.contains(attribute), "the runtime states {attribute}");
    }
    for (path, text) in &sources {
        let code = code(text);
        let panics = ["unwrap()", "expect(", "panic!", "unreachable!", "todo!", "unimplemented!"];
        for word in panics.into_iter().chain(["alloc::", "std::vec", "Vec<", "Box<", "String", "unsafe "]) {
            // A word of its own, not the end of another.
            let found = code.match_indices(word).any(|(at, _)| {
                !code[..at].ends_with(|before: char| before.is_ascii_alphanumeric() || before == '_')
            });
            assert!(!found, "{} has `{word}`", path.display());
        }
        let standard = code.lines().filter(|line| line.contains("std::")).count();
        assert_eq!(standard, 0, "{} reaches for the standard library", path.display());
    }
}

/// What is recorded of the reference is read by nobody and carried by everybody.
#[test]
fn recorded_values_are_within_a_megabyte() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/casadi");
    let files = std::fs::read_dir(&folder).expect("a folder").map(|entry| entry.expect("an entry"));
    let size: u64 = files.map(|file| file.metadata().expect("its size").len()).sum();
    assert!(size <= 1_000_000, "{size} bytes in {}", folder.display());
}
