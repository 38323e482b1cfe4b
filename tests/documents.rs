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

/// The definition with tables on the language page is one, and every word for what stands between knots has a line there.
#[test]
fn language_page_shows_tables() {
    let page = read("docs/language.md");
    let rest = page.split_once("A **table** is").expect("its place").1;
    let definition =
        rest.split_once("```text\n").and_then(|(_, rest)| rest.split_once("```")).expect("an example").0;
    let compiled = linkwright_compiler::compile(definition.parse().unwrap(), None);
    let compiled = compiled.unwrap_or_else(|errors| panic!("{errors}"));
    assert!(compiled.warnings.is_empty(), "{}", compiled.warnings);
    for kind in linkwright_compiler::forms::Interpolation::ALL {
        let line =
            rest.lines().find(|line| line.starts_with("| `") && line.contains(&format!("`{}`", kind.word())));
        let smooth = ["value |", "slope |", "curvature |"][kind.smoothness()];
        assert!(line.is_some_and(|line| line.ends_with(smooth)), "{}", kind.word());
    }
}

/// Surfaces and laws of contacts have a line each on the language page.
#[test]
fn language_page_names_surfaces() {
    let page = read("docs/language.md");
    let section = page.split_once("## Contacts and limits").expect("a section").1;
    let section = section.split("\n## ").next().unwrap_or_default();
    let cells: Vec<&str> =
        section.lines().filter_map(|line| line.strip_prefix("| ")?.split(" | ").next()).collect();
    let vocabulary = &linkwright_compiler::equations::VOCABULARY;
    let surfaces = vocabulary.surfaces.iter().map(|surface| surface.call.word);
    for word in surfaces.chain(vocabulary.contact_laws.iter().map(|law| law.call.word)) {
        let named = |cell: &&str| cell.contains(&format!("`{word}`")) || cell.contains(&format!("`{word}("));
        assert!(cells.iter().any(named), "{word}");
    }
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

/// The messages of `docs/messages.md` are those of the pairs in `tests/messages/ui` that stand before them.
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
        let pair = text
            .split('`')
            .find(|name| name.starts_with("tests/messages/ui/"))
            .expect("the pair that it is of");
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

/// The documents for readers: those of the root, of `docs` and of `docs/decisions`.
fn documents() -> Vec<String> {
    let mut found = vec!["benches/RESULTS.md".to_string(), "tests/reference/README.md".to_string()];
    for folder in [".", "docs", "docs/decisions"] {
        for entry in fs::read_dir(root().join(folder)).expect("a folder") {
            let name = entry.expect("it can be listed").file_name().to_string_lossy().into_owned();
            if name.ends_with(".md") {
                found.push(format!("{folder}/{name}").trim_start_matches("./").to_string());
            }
        }
    }
    found.sort();
    found
}

/// Every file and folder that the documents name exists.
#[test]
fn documents_name_what_exists() {
    for document in documents() {
        let text = read(&document);
        let names = text.split('`').skip(1).step_by(2);
        let is_path = |name: &&str| {
            name.contains('/') && name.chars().all(|c| c.is_ascii_alphanumeric() || "/._-".contains(c))
        };
        // Names in capitals stand for a name to be filled in; what begins with `target` is made by a build.
        let stands =
            |name: &&str| !name.contains("NAME") && !name.contains("KIND") && !name.starts_with("target");
        for name in names.filter(is_path).filter(stands) {
            let unit = ["m/s", "rad/s", "kg/m", "N/m", "/"].contains(&name);
            let beside = root().join(&document).parent().is_some_and(|folder| folder.join(name).exists());
            let in_compiler = root().join("compiler/src").join(name).exists();
            assert!(unit || beside || in_compiler || root().join(name).exists(), "{document} names `{name}`");
        }
    }
}

/// Every link of a document to another one leads to a file.
#[test]
fn links_lead_somewhere() {
    let mut followed = 0;
    for document in documents() {
        let text = read(&document);
        let folder = root().join(&document).parent().expect("its folder").to_path_buf();
        for target in text.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            let file = target.split('#').next().unwrap_or_default();
            if target.contains("://") || file.is_empty() || file.contains(' ') || !file.contains('.') {
                continue;
            }
            assert!(folder.join(file).exists(), "{document} links to {target}");
            followed += 1;
        }
    }
    assert!(followed >= 40, "{followed} links");
}

/// The front page links to every document and is read without turning the head; the page of the architecture fits on two
/// sheets.
#[test]
fn pages_stay_short() {
    let front = read("README.md");
    for document in documents().iter().filter(|name| *name != "README.md") {
        let linked = front.contains(&format!("]({document})"));
        let inner = document.starts_with("docs/decisions/") && !document.ends_with("README.md");
        assert!(linked || inner, "README.md does not link to {document}");
    }
    let mut code = false;
    for (number, line) in front.lines().enumerate() {
        if line.starts_with("```") {
            code = !code;
        }
        let wide = line.chars().count() > 100 && !line.starts_with(['|', '<']) && !code;
        assert!(!wide, "README.md:{} is longer than 100 characters", number + 1);
    }
    let lines = front.lines().count();
    assert!(lines < 120, "README.md has {lines} lines");
    let words = read("ARCHITECTURE.md").split_whitespace().count();
    assert!(words <= 1400, "ARCHITECTURE.md has {words} words: decisions go to docs/decisions");
}

/// The stages that ARCHITECTURE.md lists are those that the driver calls, in its order.
#[test]
fn stages_are_those_of_the_driver() {
    let page = read("ARCHITECTURE.md");
    let block = page.split_once("## Stages").and_then(|(_, rest)| rest.split_once("```text\n"));
    let block = block.and_then(|(_, rest)| rest.split_once("```")).expect("the list").0;
    let sources = read("compiler/src/driver.rs") + &read("compiler/src/lib.rs");
    let mut rest = sources.as_str();
    let mut stages = 0;
    for line in block.lines() {
        let (before, _) = line.split_once("─▶").expect("a stage and its result");
        let stage = before.rsplit_once("─ ").map_or(before, |(_, stage)| stage).trim();
        let call = format!("{stage}(");
        rest = rest.split_once(&call).unwrap_or_else(|| panic!("the driver does not call {stage} there")).1;
        stages += 1;
    }
    assert!(stages >= 15, "{stages} stages");
}

/// The index of decisions names each page by its title.
#[test]
fn decisions_are_listed() {
    let index = read("docs/decisions/README.md");
    for document in documents() {
        let Some(name) = document.strip_prefix("docs/decisions/") else { continue };
        let page = read(&document);
        let title = page.lines().next().and_then(|line| line.strip_prefix("# ")).expect("a title");
        if name != "README.md" {
            let line = format!("- [{title}]({name})");
            assert!(index.lines().any(|known| known == line), "the index lacks {line}");
            assert!(page.contains("\n**Question.** "), "{document} says what the question was");
        }
    }
}

/// The counts of operations that readers see first are those that the tests hold: every row that names a mechanism and has
/// a number of its own.
#[test]
fn operations_are_those_that_are_held() {
    let held = read("tests/data/operation_ceilings.csv");
    let found = |model: &str, function: &str| {
        let line = held.lines().find_map(|line| line.strip_prefix(&format!("{model},tree,{function},")));
        line.and_then(|line| line.split(',').next()).map(str::to_string)
    };
    // What formulations ask first, and by multipliers.
    let operations = |model: &str, functions: &str| {
        let count = functions.split(" or ").find_map(|function| found(model, function));
        count.expect("the table has it")
    };
    let first = "null_space_baumgarte or acceleration_baumgarte";
    let models = [
        ("double pendulum", "double_pendulum"),
        ("four-bar", "four_bar"),
        ("two windows", "n_four_bar_2"),
        ("ladder of 10", "n_four_bar_10"),
        ("ladder of 40", "n_four_bar_40"),
        ("Andrews' squeezer", "andrews"),
        ("40 four-bars", "n_four_bar_40"),
        ("Panda arm", "panda"),
        ("seven-joint arm (Panda)", "panda"),
        ("Bricard", "bricard"),
        ("Stewart platform", "stewart_platform"),
        ("delta robot", "delta_robot"),
        ("double wishbone", "double_wishbone"),
    ];
    let formulations = read("docs/formulations.md");
    let (formulations, _) = formulations.split_once("## On published problems").expect("counts, then runs");
    let mut compared = 0;
    for (page, functions) in [
        (read("README.md").as_str(), [first].as_slice()),
        (read("docs/performance.md").split_once("## Beside C code").expect("a table").1, &[first]),
        (read("docs/linearisation.md").as_str(), &["acceleration_baumgarte"]),
        (formulations, &["", "acceleration", "acceleration_baumgarte", "null_space", "null_space_baumgarte"]),
    ] {
        let mut of_the_row_before = None;
        for line in page.lines().filter_map(|line| line.strip_prefix("| ")) {
            let cells: Vec<String> = line.split(" | ").map(|cell| cell.replace('\u{a0}', " ")).collect();
            let named = models.iter().find(|(name, _)| cells[0].starts_with(name)).map(|(_, model)| *model);
            let other = match cells[0].as_str() {
                "the same by multipliers" => Some("acceleration_baumgarte"),
                "the same without Baumgarte's terms" => Some("null_space or acceleration"),
                _ => None,
            };
            let model = named.or(of_the_row_before.filter(|_| other.is_some()));
            of_the_row_before = named.or(of_the_row_before.filter(|_| cells[0].starts_with("the same")));
            let Some(model) = model else { continue };
            for (cell, function) in
                cells[1..].iter().zip(functions).filter(|(_, function)| !function.is_empty())
            {
                let function = other.unwrap_or(function);
                assert_eq!(cell.replace(' ', ""), operations(model, function), "{line}");
                compared += 1;
            }
        }
    }
    assert!(compared >= 35, "{compared} counts");
}

/// The page on controllers shows what the tests on bare metal hold.
#[test]
fn counts_on_bare_metal_are_those_held() {
    let held = read("tests/bare_metal/counts.csv");
    let count = |scalar: &str, model: &str, what: &str| {
        let line = held.lines().find_map(|line| line.strip_prefix(&format!("{scalar},{model},{what},")));
        line.unwrap_or_else(|| panic!("{scalar} {model} {what} is not held")).to_string()
    };
    let rows = [
        ("four-bar", "four_bar", "four_bar alone"),
        ("quick return", "quick_return", "quick_return alone"),
        ("Andrews' squeezer", "andrews", ""),
        ("arm of seven joints (iiwa 14)", "iiwa14", "arm alone"),
        ("Panda arm", "panda", ""),
        ("double wishbone", "double_wishbone", ""),
    ];
    let page = read("docs/in-a-controller.md");
    for (name, model, alone) in rows {
        let row = page.lines().find(|line| line.starts_with(&format!("| {name} | "))).expect("a row");
        let found: Vec<String> = row
            .split(['|', ','])
            .skip(2)
            .map(|cell| cell.replace(' ', ""))
            .filter(|cell| !cell.is_empty())
            .collect();
        let of = |scalar: &str| {
            ["evaluation_most", "step_most", "stack", "step_bound"].map(|what| count(scalar, model, what))
        };
        let flash = (!alone.is_empty()).then(|| count("f32", alone, "flash"));
        let expected: Vec<String> = of("f32").into_iter().chain(flash).chain(of("f64")).collect();
        assert_eq!(found, expected, "{name}");
    }
}

/// The gallery shows every model that ships, with a picture that is well formed and moves where it is not said to be at rest.
#[test]
fn the_gallery_shows_every_model() {
    macro_rules! names {
        ($($name:ident: $model:path),* $(,)?) => { &[$(stringify!($name)),*] };
    }
    let models: &[&str] = linkwright_models::for_each_model!(names);
    let page = read("docs/gallery.md");
    for name in models {
        let shown = page.split_once(&format!("src=\"gallery/{name}.svg\"")).map(|(_, rest)| rest);
        let shown = shown.and_then(|rest| rest.split('>').next());
        let shown = shown.unwrap_or_else(|| panic!("{name} is not shown: run docs/gallery/make.py"));
        let picture = read(&format!("docs/gallery/{name}.svg"));
        roxmltree::Document::parse(&picture).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(picture.contains("<animate"), !shown.contains(" at rest\""), "{name}");
        assert!(!picture.contains("NaN"), "{name}");
    }
    assert_eq!(page.matches("<img ").count(), models.len(), "pictures of what is no model");
}

/// Pictures that documents show exist.
#[test]
fn pictures_exist() {
    let mut shown = 0;
    for document in documents() {
        let folder = root().join(&document).parent().expect("its folder").to_path_buf();
        for file in read(&document).split("<img src=\"").skip(1).filter_map(|rest| rest.split('"').next()) {
            assert!(folder.join(file).exists(), "{document} shows {file}");
            shown += 1;
        }
    }
    assert!(shown > 90, "{shown} pictures");
}
