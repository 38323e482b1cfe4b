//! What the compiler says to mistakes, as a user sees it: message and underlined place, one pair of files each,
//! sorted by kind and named after the mistake.
//!
//! `TRYBUILD=overwrite cargo test --test ui` writes the answers anew; read them before keeping them. The texts stand
//! in `compiler/src/messages/` and `compiler/src/check/messages/`; spans and texts one by one are also tested in `compiler/tests/front_end`.

use linkwright_compiler::{check, model, parse};

#[test]
fn mistakes() {
    let cases = trybuild::TestCases::new();
    cases.compile_fail("tests/ui/*/*.rs");
    cases.pass("tests/pass/*.rs");
    // Unkind surroundings, each a crate of its own: they compile without a warning and run.
    cases.pass("tests/hygiene/*.rs");
}

/// What ships is free of warnings, or says why not.
#[test]
fn shipped_models_give_no_warnings() {
    macro_rules! sources { ($($name:ident: $model:path),* $(,)?) => { [$((stringify!($name), <$model>::SOURCE)),*] } }
    for (name, source) in linkwright_models::for_each_model!(sources) {
        let definition = parse(source.parse().expect("the source was tokens")).expect(name);
        let warnings = check::warnings(&model::lower(&definition).expect(name), &[]);
        assert!(warnings.is_empty(), "{name}: {warnings}");
    }
}

/// Cargo builds a crate anew when a file changes that rustc names among its sources: the definition in a file is one.
#[test]
fn a_file_is_a_source_of_its_crate() {
    let test = std::env::current_exe().expect("this test runs");
    let folder = test.parent().expect("it lies beside what it was built from");
    let mut newest = None;
    for entry in std::fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("it can be listed")) {
        let name = entry.file_name().into_string().unwrap_or_default();
        if name.starts_with("linkwright_models-") && name.ends_with(".d") {
            let changed = entry.metadata().and_then(|metadata| metadata.modified()).expect("its time");
            newest = newest.max(Some((changed, entry.path())));
        }
    }
    let (_, path) = newest.expect("the models are built for the tests");
    let sources = std::fs::read_to_string(&path).expect("a list of sources");
    for source in ["panda.rs", "panda.mech"] {
        let found =
            sources.lines().any(|line| line.trim_end_matches(':').ends_with(&format!("models/src/{source}")));
        assert!(found, "{} does not name {source}", path.display());
    }
}
