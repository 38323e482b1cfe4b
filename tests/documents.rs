//! What the documents say of the source, where that can be checked. The invariants of ARCHITECTURE.md are in
//! `checks/architecture.rs`.

use std::fs;
use std::path::Path;

fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The example on the front page is `examples/crank_rocker.rs`, without its opening comment.
#[test]
fn front_page_example_is_compiled() {
    let example = read("examples/crank_rocker.rs");
    let code = example.split_once("\n\n").expect("an opening comment").1.trim();
    assert!(read("README.md").contains(code), "README.md and examples/crank_rocker.rs have come apart");
}

/// The definition at the top of the language page is one.
#[test]
fn language_page_example_is_a_definition() {
    let page = read("docs/language.md");
    let rest = page.split_once("mechanism! {").expect("an example").1;
    let definition = rest.split_once("\n}\n```").expect("its end").0;
    let compiled = linkwright_compiler::compile(definition.parse().unwrap(), None);
    let compiled = compiled.unwrap_or_else(|errors| panic!("{errors}"));
    assert!(compiled.warnings.is_empty(), "{}", compiled.warnings);
}

/// Every word of the language page's tables is known: joints, loads and functions are refused only for their arguments.
#[test]
fn language_page_names_what_there_is() {
    let page = read("docs/language.md");
    let section =
        |title: &str| page.split_once(title).expect(title).1.split("\n## ").next().unwrap_or_default();
    let words = |text: &str| -> Vec<String> {
        let cells = text.lines().filter_map(|line| line.strip_prefix("| `")?.split_once('`'));
        cells.map(|(word, _)| word.to_string()).collect()
    };
    for (title, before) in [("## Joints", "joint"), ("## Loads", "force")] {
        let words = words(section(title));
        assert!(words.len() >= 5, "{title}");
        for word in words {
            let source =
                format!("planar A {{ rod r {{ mass [kg] = 1; length [m] = 1; }} {before} x: {word}(); }}");
            let errors = linkwright_compiler::compile(source.parse().unwrap(), None).unwrap_err().to_string();
            assert!(errors.contains("unnamed argument"), "{word}: {errors}");
        }
    }
}

/// The messages of `docs/messages.md` are those of the pairs in `tests/ui` that stand before them.
#[test]
fn message_page_shows_what_is_printed() {
    let page = read("docs/messages.md");
    let mut expected = String::new();
    let mut shown = 0;
    for (index, section) in page.split("\n## ").enumerate() {
        if index == 0 {
            expected += section;
            continue;
        }
        let (text, _) = section.split_once("```text\n").expect("a message");
        let pair =
            text.split('`').find(|name| name.starts_with("tests/ui/")).expect("the pair that it is of");
        let message = read(&pair.replace(".rs", ".stderr"));
        expected += &format!("\n## {text}```text\n{message}```\n");
        shown += 1;
    }
    assert!(shown >= 10, "{shown} messages");
    if std::env::var_os("UPDATE_MESSAGES").is_some() {
        fs::write(root().join("docs/messages.md"), &expected).expect("docs can be written");
        return;
    }
    assert_eq!(page, expected, "write it anew with UPDATE_MESSAGES=1");
}

/// What the tables of formulations and integrators name is written out below them, where it is compiled as an example.
#[test]
fn formulations_page_compiles_what_it_names() {
    let page = read("docs/formulations.md");
    let code =
        page.split("```rust\n").skip(1).filter_map(|rest| rest.split_once("```")).map(|(code, _)| code);
    let code = code.max_by_key(|code| code.len()).expect("an example");
    let rows = page.lines().take_while(|line| !line.starts_with("## What the settings mean"));
    let cells = rows.filter_map(|line| line.strip_prefix("| `")?.split_once([':', ' ', '`', '(']));
    // Types are what is compiled; calls stand in a table of their own.
    let names: Vec<&str> =
        cells.map(|(name, _)| name).filter(|name| name.starts_with(char::is_uppercase)).collect();
    assert!(names.len() >= 14, "{names:?}");
    for name in names {
        assert!(code.contains(name), "`{name}` is in no example");
    }
}

/// Every document whose Rust is to be compiled hands it to rustdoc, and no block of Rust is left without a language.
#[test]
fn rust_in_documents_is_compiled() {
    let library = read("src/lib.rs");
    for entry in fs::read_dir(root().join("docs")).expect("a folder") {
        let path = entry.expect("it can be listed").path();
        let name = path.file_name().and_then(|name| name.to_str()).expect("a name").to_string();
        if !name.ends_with(".md") {
            continue;
        }
        let page = read(&format!("docs/{name}"));
        let fences = page.lines().filter(|line| line.starts_with("```")).step_by(2);
        for fence in fences {
            assert!(["```text", "```rust"].contains(&fence), "{name} has a block of `{fence}`");
        }
        let compiled = library.contains(&format!("include_str!(\"../docs/{name}\")"));
        assert!(compiled || !page.contains("```rust"), "src/lib.rs does not include docs/{name}");
    }
}

/// Every file and folder that the documents name exists.
#[test]
fn documents_name_what_exists() {
    for document in [
        "README.md",
        "ARCHITECTURE.md",
        "NOTATION.md",
        "CONTRIBUTING.md",
        "benches/RESULTS.md",
        "docs/functions.md",
        "docs/messages.md",
    ] {
        let text = read(document);
        let names = text.split('`').skip(1).step_by(2);
        let is_path = |name: &&str| {
            name.contains('/') && name.chars().all(|c| c.is_ascii_alphanumeric() || "/._-".contains(c))
        };
        // Names in capitals stand for a name to be filled in; what begins with `target` is made by a build.
        let stands =
            |name: &&str| !name.contains("NAME") && !name.contains("KIND") && !name.starts_with("target");
        for name in names.filter(is_path).filter(stands) {
            let known = ["m/s", "rad/s", "kg/m", "N/m"].contains(&name) || root().join(name).exists();
            let in_compiler = root().join("compiler/src").join(name).exists();
            assert!(known || in_compiler, "{document} names `{name}`");
        }
    }
}
