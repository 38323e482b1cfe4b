//! What the documents say about the source, where that can be checked.

use std::fs;
use std::path::{Path, PathBuf};

fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// All files with this ending below a folder.
fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut found = Vec::new();
    for entry in entries {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(files(&path, ending));
        } else if path.extension().is_some_and(|own| own == ending) {
            found.push(path);
        }
    }
    found
}

/// The example on the front page is `examples/crank_rocker.rs`, without its opening comment.
#[test]
fn front_page_example_is_compiled() {
    let example = read("examples/crank_rocker.rs");
    let code = example.split_once("\n\n").expect("an opening comment").1.trim();
    assert!(read("README.md").contains(code), "README.md and examples/crank_rocker.rs have come apart");
}

/// Every file and folder that the documents name exists.
#[test]
fn documents_name_what_exists() {
    for document in ["README.md", "ARCHITECTURE.md", "NOTATION.md", "CONTRIBUTING.md", "benches/RESULTS.md"] {
        let text = read(document);
        let names = text.split('`').skip(1).step_by(2);
        let is_path = |name: &&str| {
            name.contains('/') && name.chars().all(|c| c.is_ascii_alphanumeric() || "/._-".contains(c))
        };
        // Names in capitals stand for a name to be filled in; what begins with `target` is made by a build.
        let stands = |name: &&str| !name.contains("NAME") && !name.contains("KIND") && !name.starts_with("target");
        for name in names.filter(is_path).filter(stands) {
            let known = ["m/s", "rad/s", "kg/m", "N/m"].contains(&name) || root().join(name).exists();
            let in_compiler = root().join("compiler/src").join(name).exists();
            assert!(known || in_compiler, "{document} names `{name}`");
        }
    }
}

/// The symbolic core imports nothing of its crate and nothing of tokens.
#[test]
fn symbolic_core_stands_alone() {
    let sources = files(&root().join("compiler/src/symbolic"), "rs");
    assert!(sources.len() >= 4);
    for path in sources {
        let source = fs::read_to_string(&path).unwrap();
        for line in source.lines().filter(|line| !line.trim_start().starts_with("//")) {
            for foreign in ["crate::", "super::super", "proc_macro", "syn::", "quote::"] {
                assert!(!line.contains(foreign), "{}: {line}", path.display());
            }
        }
    }
}

/// The compiler and the runtime share nothing but the generated code.
#[test]
fn compiler_and_runtime_are_strangers() {
    assert!(!read("compiler/Cargo.toml").contains("linkwright-runtime"));
    assert!(!read("runtime/Cargo.toml").contains("linkwright-compiler"));
    for path in files(&root().join("runtime/src"), "rs") {
        let source = fs::read_to_string(&path).unwrap();
        assert!(!source.contains("extern crate alloc"), "{}", path.display());
    }
}
