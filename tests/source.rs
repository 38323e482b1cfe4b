//! The definition that a model carries is what stands in the file; those that ship give no warnings, and files with definitions are sources.

use linkwright_compiler::{check, model, parse};

linkwright::mechanism! {
    // How a slider is written,
    pub planar Slider { // and where its brace stands,
        /* stays: */ rod   bar { mass [kg] = 1; length [m] = 1; } // ends of lines, too.
        joint rail: prismatic(ground(0, 0) [m],
                              bar.center, axis = (1, 0));
    }
}

macro_rules! written_by_a_macro {
    ($name:ident, $mass:literal) => {
        linkwright::mechanism! {
            // Nobody sees this.
            planar $name {
                rod bar { mass [kg] = $mass; length [m] = 1; }
                joint rail: prismatic(ground(0, 0) [m], bar.center, axis = (1, 0));
            }
        }
    };
}
written_by_a_macro!(Written, 2);

#[test]
fn comments_and_lines_are_kept() {
    let expected = "pub planar Slider { // and where its brace stands,
    /* stays: */ rod   bar { mass [kg] = 1; length [m] = 1; } // ends of lines, too.
    joint rail: prismatic(ground(0, 0) [m],
                          bar.center, axis = (1, 0));
}";
    assert_eq!(Slider::SOURCE, expected);
}

#[test]
fn what_a_macro_wrote_is_its_tokens() {
    assert!(Written::SOURCE.contains("mass [kg] = 2"), "{}", Written::SOURCE);
    assert!(!Written::SOURCE.contains("Nobody"), "{}", Written::SOURCE);
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
