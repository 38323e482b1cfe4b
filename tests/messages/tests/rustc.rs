//! What the compiler says to mistakes, as a user sees it: message and underlined place, one pair of files each,
//! sorted by kind and named after the mistake.
//!
//! `TRYBUILD=overwrite cargo test --package messages` writes the answers anew; read them before keeping them. The texts stand
//! in `compiler/src/messages/` and `compiler/src/check/messages/`; spans and texts one by one are also tested in `compiler/tests/front_end`.

#[test]
fn mistakes() {
    let cases = trybuild::TestCases::new();
    cases.compile_fail("ui/*/*.rs");
    cases.pass("pass/*.rs");
    // Unkind surroundings, each a crate of its own: they compile without a warning and run.
    cases.pass("../hygiene/*.rs");
}
