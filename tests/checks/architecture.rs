//! What must be absent from the sources: each absence that ARCHITECTURE.md lists under "What never happens" has its test
//! here, under its number. Sources are read as text.

use linkwright_compiler::source::{Source, invocations};
use linkwright_compiler::{Expansion, expand};
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn read(file: &str) -> String {
    fs::read_to_string(root().join(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
}

/// All files below a directory of the workspace whose names end so, in a fixed order, with their paths in it.
fn files(directory: &str, extension: &str) -> Vec<(String, String)> {
    fn collect(directory: &Path, extension: &str, found: &mut Vec<PathBuf>) {
        for entry in fs::read_dir(directory).expect("a directory of the workspace") {
            let path = entry.expect("it can be listed").path();
            if path.is_dir() {
                collect(&path, extension, found);
            } else if path.extension().is_some_and(|own| own == extension) {
                found.push(path);
            }
        }
    }
    let mut found = Vec::new();
    collect(&root().join(directory), extension, &mut found);
    found.sort();
    assert!(!found.is_empty(), "{directory} has files that end in .{extension}");
    let name = |path: &Path| {
        let inner = path.strip_prefix(root().join(directory)).expect("it lies in the directory");
        inner.to_string_lossy().replace('\\', "/")
    };
    found.iter().map(|path| (name(path), fs::read_to_string(path).expect("sources are text"))).collect()
}

/// The Rust files of a directory: their paths in it, and their code.
fn sources(directory: &str) -> Vec<(String, String)> {
    files(directory, "rs").into_iter().map(|(name, text)| (name, code(&text))).collect()
}

/// The code of a file without its comments and what follows `#[cfg(test)]`.
fn code(text: &str) -> String {
    let tested = text.find("#[cfg(test)]").unwrap_or(text.len());
    let lines = text[..tested].lines().map(|line| line.split("//").next().unwrap_or_default());
    lines.collect::<Vec<_>>().join("\n")
}

fn is_of_word(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}

/// Whether `word` stands in the code, not as the end of another word.
fn has(code: &str, word: &str) -> bool {
    code.match_indices(word).any(|(at, _)| !code[..at].ends_with(is_of_word))
}

/// What stands between the parenthesis that opens at `open` and the one that closes it.
fn arguments(code: &str, open: usize) -> &str {
    let mut depth = 0;
    for (at, c) in code[open..].char_indices() {
        match c {
            '(' => depth += 1,
            ')' if depth == 1 => return &code[open + 1..open + at],
            ')' => depth -= 1,
            _ => {}
        }
    }
    panic!("a parenthesis is closed")
}

/// As many absences are listed as are tested here.
#[test]
fn each_absence_has_a_number_here() {
    let page = read("ARCHITECTURE.md");
    let section = page.split_once("## What never happens").expect("the section").1;
    let section = section.split("\n## ").next().unwrap_or_default();
    let numbers = section.lines().filter_map(|line| line.split_once(". ")).map(|(number, _)| number);
    let listed: Vec<&str> = numbers.filter(|number| number.parse::<u8>().is_ok()).collect();
    let own = read("tests/checks/architecture.rs");
    for (index, number) in listed.iter().enumerate() {
        assert_eq!(*number, (index + 1).to_string(), "the list is numbered");
        assert!(own.contains(&format!("/// {number}. ")), "absence {number} is not tested");
    }
    assert!(listed.len() >= 11, "{listed:?}");
}

/// 1. The symbolic core knows nothing of mechanisms, tokens or Rust: it imports nothing of its crate, and of others only
///    `std` and `libm`.
#[test]
fn the_symbolic_core_imports_nothing() {
    for (file, code) in sources("compiler/src/symbolic") {
        for outside in ["crate::", "super::super", "proc_macro", "syn::", "quote"] {
            assert!(!code.contains(outside), "symbolic/{file} names `{outside}`");
        }
        for line in code.lines().map(str::trim).filter(|line| line.starts_with("use ")) {
            let inner =
                ["use super::", "use std::", "use self::"].iter().any(|known| line.starts_with(known));
            assert!(inner, "symbolic/{file}: {line}");
        }
    }
}

/// 2. Compiler and runtime do not depend on each other.
#[test]
fn compiler_and_runtime_do_not_know_each_other() {
    for (package, other) in [("compiler", "runtime"), ("runtime", "compiler")] {
        let manifest = read(&format!("{package}/Cargo.toml"));
        let depends = format!("linkwright-{other}");
        assert!(!manifest.contains(&depends), "{package}/Cargo.toml names {depends}");
        for (file, code) in sources(&format!("{package}/src")) {
            let crate_name = format!("linkwright_{other}");
            assert!(!code.contains(&crate_name), "{package}/src/{file} names {crate_name}");
        }
    }
}

/// 3. Only the front, `emit` and the entries know Rust's tokens.
#[test]
fn stages_in_between_know_no_tokens() {
    let folders = ["syntax/", "source/", "emit/", "diagnostics/"];
    let entries = ["lib.rs", "driver.rs", "file.rs", "counts.rs", "diagnostics.rs", "expansion.rs"];
    for (file, code) in sources("compiler/src") {
        if folders.iter().any(|folder| file.starts_with(folder)) || entries.contains(&file.as_str()) {
            continue;
        }
        for token in ["proc_macro2", "TokenStream", "TokenTree", "syn::", "quote::", "quote!"] {
            assert!(!has(&code, token), "compiler/src/{file} names `{token}`");
        }
    }
}

/// 4. Units are read in `syntax` only, and nothing after `model` sees what was written.
#[test]
fn units_and_names_stay_in_front() {
    for (file, code) in sources("compiler/src") {
        let reads = code.contains("units::parse");
        assert!(!reads || file.starts_with("syntax/"), "compiler/src/{file} reads a unit");
        let front = ["syntax/", "model/", "messages/", "source/"].iter().any(|front| file.starts_with(front));
        // The stub stands in the place of a definition with errors.
        let entry = ["driver.rs", "lib.rs", "emit/stub.rs"].contains(&file.as_str());
        let sees = has(&code, "syntax::") || code.contains("crate::{syntax") || code.contains(", syntax}");
        assert!(front || entry || !sees, "compiler/src/{file} names `syntax`");
    }
    let model = code(&read("compiler/src/model/mod.rs"));
    assert!(model.contains("\nmod names;"), "names are looked up inside of `model` only");
}

/// 5. No message is written where it is raised.
#[test]
fn messages_stand_together() {
    let mut raised = 0;
    for (file, code) in sources("compiler/src") {
        if file.contains("messages") || file.starts_with("diagnostics") {
            continue;
        }
        for call in [".error(", ".warning(", ".conflict("] {
            for (at, _) in code.match_indices(call) {
                let arguments = arguments(&code, at + call.len() - 1);
                let text = arguments.find('"').or(arguments.find("format!"));
                let message = arguments.find("messages::");
                let written = text.is_some_and(|text| message.is_none_or(|message| text < message));
                assert!(!written, "compiler/src/{file} writes a message: {arguments}");
                raised += 1;
            }
        }
    }
    assert!(raised >= 100, "{raised} messages found");
}

/// 6. Equal nodes are one node: only the graph makes nodes, in one place, after it has looked for an equal one.
#[test]
fn only_the_graph_makes_nodes() {
    let mut made = 0;
    for (file, code) in sources("compiler/src") {
        for (at, _) in code.match_indices("ops.push(").filter(|(at, _)| !code[..*at].ends_with(is_of_word)) {
            assert_eq!(file, "symbolic/graph.rs", "nodes are made in compiler/src/{file}");
            let begin = code[..at].rfind("fn ").expect("it stands in a function");
            assert!(code[begin..at].contains("self.known.get("), "it looks for an equal node first");
            made += 1;
        }
    }
    assert_eq!(made, 1);
    let graph = read("compiler/src/symbolic/graph.rs");
    assert!(graph.contains("    ops: Vec<Op>"), "operations are the graph's own");
    assert!(graph.contains("pub struct Node(pub(super) u32);"), "nodes cannot be made outside of `symbolic`");
}

/// The variables and the fields of a file whose type is a `HashMap` or `HashSet`.
fn hashed(code: &str) -> (Vec<&str>, Vec<&str>) {
    let (mut variables, mut fields) = (Vec::new(), Vec::new());
    let places = ["HashMap<", "HashSet<", "HashMap::new", "HashSet::new"];
    for (at, _) in places.iter().flat_map(|place| code.match_indices(place)) {
        let line = code[..at].rfind('\n').map_or(0, |end| end + 1);
        let before = code[line..at].trim_end_matches(['&', ' ']).trim_end_matches("mut").trim_end();
        // A value in a literal of a struct has its field declared elsewhere.
        let is_value = code[at..].starts_with("HashMap::new") || code[at..].starts_with("HashSet::new");
        let declares = if is_value { '=' } else { ':' };
        let Some(before) = before.strip_suffix(declares) else { continue };
        let before = before.trim_end();
        let name = &before[before.rfind(|c| !is_of_word(c)).map_or(0, |end| end + 1)..];
        if name.is_empty() {
            // Behind the type of what is declared.
            continue;
        }
        let declared = before.trim_start();
        let is_field = declared == name || declared.strip_prefix("pub ").is_some_and(|rest| rest == name);
        match is_field && !is_value {
            true => fields.push(name),
            false => variables.push(name),
        }
    }
    (variables, fields)
}

/// 7. No `HashMap` or `HashSet` is iterated where its order could show: what comes out is sorted, or its least and
///    greatest taken, in the same statement or the next.
#[test]
fn hash_maps_are_looked_up_only() {
    let (mut found, mut sorted) = (0, 0);
    let folder = |file: &str| file.rsplit_once('/').map_or(String::new(), |(folder, _)| folder.to_string());
    let sources = sources("compiler/src");
    for (file, code) in &sources {
        let (variables, own) = hashed(code);
        found += variables.len() + own.len();
        let beside = sources.iter().filter(|(other, _)| folder(other) == folder(file));
        let beside: Vec<&str> = beside.flat_map(|(_, code)| hashed(code).1).collect();
        let mut uses: Vec<String> = Vec::new();
        let calls = ["iter()", "into_iter()", "keys()", "values()", "into_keys()", "into_values()", "drain("];
        for call in calls {
            uses.extend(variables.iter().map(|name| format!("{name}.{call}")));
            uses.extend(own.iter().map(|name| format!(".{name}.{call}")));
            if call.contains("keys") || call.contains("values") || call.contains("drain") {
                uses.extend(beside.iter().map(|name| format!(".{name}.{call}")));
            }
        }
        uses.extend(variables.iter().flat_map(|name| [format!("in {name} "), format!("in &{name} ")]));
        uses.extend(own.iter().flat_map(|name| [format!("in self.{name} "), format!("in &self.{name} ")]));
        for used in uses {
            for (at, _) in code.match_indices(&used) {
                // A variable is not the field of another value with the same name, nor the end of another word.
                if !used.starts_with('.') && code[..at].ends_with(|c| is_of_word(c) || c == '.') {
                    continue;
                }
                let begin = code[..at].char_indices().rev().nth(60).map_or(0, |(begin, _)| begin);
                let around: String = code[begin..].chars().take(300).collect();
                let ordered =
                    around.contains("sort") || (around.contains(".min()") && around.contains(".max()"));
                assert!(ordered, "compiler/src/{file} iterates a hash map: {used}");
                sorted += 1;
            }
        }
    }
    assert!(found >= 20 && sorted >= 4, "{found} hash maps found, {sorted} sorted");
}

/// A text of Rust without the contents of its strings and without comments.
fn without_strings(text: &str) -> String {
    let mut bare = String::new();
    for line in text.lines().map(str::trim_end).filter(|line| !line.trim_start().starts_with("//")) {
        let mut inside = false;
        let mut escaped = false;
        for c in line.chars() {
            if !inside || (c == '"' && !escaped) {
                bare.push(c);
            }
            if c == '"' && !escaped {
                inside = !inside;
            }
            escaped = inside && c == '\\' && !escaped;
        }
        bare.push('\n');
    }
    bare
}

/// The expansions of some files of definitions, formatted, without comments and the contents of strings.
fn expansions() -> Vec<(String, String)> {
    let files = [
        "models/src/simple_pendulum.rs",
        "models/src/four_bar.rs",
        "models/src/general_four_bar.rs",
        "models/src/spatial_pendulums.rs",
        "tests/mechanisms/src/zoo_tangent.rs",
    ];
    let of_file = |file: &&str| {
        let source = Source::new(*file, read(file));
        let found = invocations(&source).expect("it is read").into_iter();
        let formatted = found.map(|invocation| match expand(invocation.tokens.stream, |_| None) {
            Expansion::Items { text, .. } => {
                prettyplease::unparse(&syn::parse_file(&text).expect("the expansion is a list of items"))
            }
            Expansion::Errors(errors) => panic!("{file}: {errors}"),
        });
        formatted.map(|text| (file.to_string(), without_strings(&text))).collect::<Vec<_>>()
    };
    files.iter().flat_map(of_file).collect()
}

/// 8. Generated functions do not branch, loop, allocate or panic; only `prepare` returns a `Result`, and what is indexed is
///    an array of known length at a constant index, which rustc checks.
#[test]
fn generated_functions_are_straight() {
    for (name, text) in expansions() {
        // Before and after the functions stand types and constants.
        let (_, code) = text.split_once("const _: () = {").expect("functions");
        let (code, _) = code.split_once("\n};\n").expect("their end");
        let words = code.split(|c| !is_of_word(c)).collect::<Vec<_>>();
        for word in ["if", "else", "match", "while", "loop", "return", "unsafe", "Vec", "Box", "String"] {
            assert!(!words.contains(&word), "{name} has `{word}`");
        }
        for line in code.lines().map(str::trim) {
            let of_impl = line.starts_with("impl") || line.contains("for<");
            assert!(of_impl || !line.split(|c| !is_of_word(c)).any(|word| word == "for"), "{name}: {line}");
            for call in [".unwrap(", ".expect("] {
                assert!(!line.contains(call), "{name}: {line}");
            }
            let calls_macro = line.match_indices('!').any(|(at, _)| line[..at].ends_with(is_of_word));
            assert!(!calls_macro, "{name} calls a macro: {line}");
        }
        let (before, prepare) = code.split_once("pub fn prepare(").expect("`prepare`");
        let (prepare, after) = prepare.split_once("\n        }\n").expect("its end");
        assert!(prepare.contains("-> Result<Self, SettingError>"), "{name}");
        // The same by the name of a trait, for code that serves every mechanism.
        let by_trait = "fn prepare(parameters: Parameters<R>) -> Result<Self, SettingError>";
        let after = after.replacen(by_trait, "", 1);
        for elsewhere in [before, &after] {
            assert!(!elsewhere.contains('?'), "{name} leaves a function early");
            assert!(!elsewhere.contains("Result<"), "{name} returns a result");
        }
        for (at, _) in code.match_indices('[') {
            let indexed = code[..at].ends_with(|c: char| is_of_word(c) || c == ')' || c == ']');
            let index = code[at + 1..].split(']').next().unwrap_or_default();
            let constant = !index.is_empty() && index.chars().all(|c| c.is_ascii_digit());
            assert!(!indexed || constant, "{name} indexes by `{index}`");
        }
    }
}

/// 9. Every absolute path of emitted code goes to `core` or through `__private::v1`, whose place one file of `emit` knows.
#[test]
fn emitted_paths_go_through_one_module() {
    for (name, text) in expansions() {
        for (at, _) in text.match_indices("::") {
            if text[..at].ends_with(|c: char| is_of_word(c) || c == '>') {
                continue;
            }
            let path = &text[at..];
            let known = path.starts_with("::core::") || path.starts_with("::linkwright::__private::v1");
            assert!(known, "{name} names {}", path.lines().next().unwrap_or_default());
        }
        let imports = text.lines().map(str::trim).filter(|line| line.starts_with("use "));
        let expected = [
            "use ::core::prelude::rust_2024::*;",
            "use ::linkwright::__private::v1::*;",
            "use ::core::primitive::{bool, f64, u16, u32, u64, usize, str};",
        ];
        assert!(imports.eq(expected), "{name} imports something else");
    }
    for (file, code) in sources("compiler/src") {
        let names = code.contains("__private");
        assert!(!names || file == "emit/home.rs", "compiler/src/{file} names `__private`");
    }
}

/// 10. Reference scripts import Python's own library, NumPy, CasADi and one another, and start no program but themselves.
#[test]
fn reference_scripts_share_nothing() {
    let library = "argparse contextlib copy dataclasses fractions functools io json math pathlib re sys tempfile time unittest";
    let library: Vec<&str> = library.split(' ').chain(["casadi", "numpy"]).collect();
    let scripts = files("tests/reference", "py");
    let own: Vec<&str> = scripts.iter().filter_map(|(name, _)| name.strip_suffix(".py")).collect();
    for (name, text) in &scripts {
        for line in text.lines().map(str::trim_start) {
            let Some(imported) = line.strip_prefix("import ").or(line.strip_prefix("from ")) else {
                continue;
            };
            let module = imported.split([' ', '.', ',']).next().unwrap_or_default();
            // The test of the command line runs the script itself.
            let starts_itself = module == "subprocess" && name == "test_reference.py";
            let imports = line.starts_with("import ") || line.contains(" import ");
            let known = library.contains(&module) || own.contains(&module) || starts_itself;
            assert!(!imports || known, "tests/reference/{name}: {line}");
        }
        for word in ["cargo", "compiler/", "linkwright_", "ctypes", "importlib", "os.system"] {
            assert!(!text.contains(word), "tests/reference/{name} has `{word}`");
        }
    }
}

/// 11. The runtime runs bare: no standard library, no allocation, no unsafe code, nothing that panics by name.
#[test]
fn the_runtime_runs_bare() {
    let library = read("runtime/src/lib.rs");
    for attribute in ["#![no_std]", "#![forbid(unsafe_code)]", "#![warn(missing_docs)]"] {
        assert!(library.contains(attribute), "the runtime states {attribute}");
    }
    for (file, code) in sources("runtime/src") {
        let panics = ["unwrap()", "expect(", "panic!", "unreachable!", "todo!", "unimplemented!"];
        for word in panics.into_iter().chain(["alloc::", "std::vec", "Vec<", "Box<", "String", "unsafe "]) {
            assert!(!has(&code, word), "runtime/src/{file} has `{word}`");
        }
        let standard = code.lines().filter(|line| line.contains("std::")).count();
        assert_eq!(standard, 0, "runtime/src/{file} reaches for the standard library");
    }
}

/// The rooms of the compiler in the order of ARCHITECTURE.md.
fn rooms() -> Vec<String> {
    let text = read("ARCHITECTURE.md");
    let (_, list) = text.split_once("never back:\n").expect("the list of rooms");
    let list = list.split("\n\n").next().expect("its end");
    list.split('`').skip(1).step_by(2).map(str::to_string).collect()
}

/// The rooms that code imports, by `crate::room` and `crate::{room, …}`.
fn imported(code: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (at, _) in code.match_indices("crate::") {
        let rest = &code[at + "crate::".len()..];
        let word = |text: &str| text.trim_start().chars().take_while(|c| is_of_word(*c)).collect::<String>();
        let Some(group) = rest.strip_prefix('{') else {
            found.push(word(rest));
            continue;
        };
        let (mut depth, mut begins) = (0, true);
        for (index, c) in group.char_indices() {
            match c {
                '}' if depth == 0 => break,
                '{' => depth += 1,
                '}' => depth -= 1,
                ',' if depth == 0 => begins = true,
                c if begins && is_of_word(c) => {
                    found.push(word(&group[index..]));
                    begins = false;
                }
                _ => {}
            }
        }
    }
    found
}

#[test]
fn rooms_import_from_those_before_them() {
    let rooms = rooms();
    let place = |room: &str| rooms.iter().position(|own| own == room);
    let mut found = std::collections::BTreeSet::new();
    for (file, text) in sources("compiler/src") {
        let room = file.split('/').next().expect("a room").trim_end_matches(".rs");
        if room == "lib" {
            continue;
        }
        found.insert(room.to_string());
        let own = place(room).unwrap_or_else(|| panic!("{room} is not in the list of ARCHITECTURE.md"));
        for other in imported(&without_strings(&text)).iter().filter(|other| *other != room) {
            let at = place(other).unwrap_or_else(|| panic!("{file} imports {other}, which is no room"));
            assert!(at < own, "{file} imports {other}, which comes later");
        }
    }
    let listed: std::collections::BTreeSet<String> = rooms.iter().cloned().collect();
    assert_eq!(found, listed, "rooms in the folder and in the list");
}

/// What is recorded of the reference is read by nobody and carried by everybody.
#[test]
fn recorded_values_are_within_a_megabyte() {
    let folder = root().join("tests/data/casadi");
    let files = std::fs::read_dir(&folder).expect("a folder").map(|entry| entry.expect("an entry"));
    let size: u64 = files.map(|file| file.metadata().expect("its size").len()).sum();
    assert!(size <= 1_000_000, "{size} bytes in {}", folder.display());
}

/// A mechanism may have any name: those that emitted code has in scope are known, and go out of its way.
#[test]
fn names_in_scope_of_emitted_code_are_known() {
    let runtime = read("runtime/src/lib.rs");
    let exported = code(&runtime);
    let exported = exported.split_once("pub mod v1").expect("the names for emitted code").1;
    let known = read("compiler/src/emit/names.rs");
    let names = exported.split(|c: char| !is_of_word(c)).filter(|name| name.starts_with(char::is_uppercase));
    let missing: Vec<&str> = names.filter(|name| !known.contains(&format!("\"{name}\""))).collect();
    assert!(exported.contains("Mechanism"), "no names were found");
    assert!(missing.is_empty(), "IN_SCOPE of emit/names.rs lacks {missing:?}");
}
