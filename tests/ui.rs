//! What the compiler says to mistakes, as a user sees it: message and underlined place, one pair of files each,
//! sorted by kind and named after the mistake.
//!
//! `TRYBUILD=overwrite cargo test --test ui` writes the answers anew; read them before keeping them. The texts stand
//! in `compiler/src/messages/` and `compiler/src/check/messages.rs`; spans and texts one by one are also tested in `compiler/tests/front_end`.

use linkwright_compiler::{check, model, syntax};

#[test]
fn mistakes() {
    let cases = trybuild::TestCases::new();
    cases.compile_fail("tests/ui/*/*.rs");
    cases.pass("tests/pass/*.rs");
}

/// What ships is free of warnings, or says why not.
#[test]
fn shipped_models_give_no_warnings() {
    macro_rules! sources { ($($name:ident: $model:path),* $(,)?) => { [$((stringify!($name), <$model>::SOURCE)),*] } }
    for (name, source) in linkwright_models::for_each_model!(sources) {
        let definition = syntax::parse(source.parse().expect("the source was tokens")).expect(name);
        let warnings = check::warnings(&model::lower(&definition).expect(name));
        assert!(warnings.is_empty(), "{name}: {warnings}");
    }
}
