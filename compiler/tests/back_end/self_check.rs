//! The compiler's check of its own work: it is silent where all is right, and speaks where anything is changed.

use crate::shipped::definitions;
use linkwright_compiler::compile;
use linkwright_compiler::model::Coordinates;
use linkwright_compiler::self_check::{Extent, self_check};

/// No false alarm: every mechanism that ships and of the zoo, in both coordinate sets.
#[test]
fn nothing_is_said_of_what_is_right() {
    let definitions = definitions();
    assert!(definitions.len() > 50, "only {} definitions were found", definitions.len());
    for (file, tokens) in definitions {
        for coordinates in [Coordinates::Absolute, Coordinates::Tree] {
            let compiled = match compile(tokens.clone(), Some(coordinates)) {
                Ok(c) => c,
                Err(e) => { println!("{file} {coordinates:?}: {e}"); continue }
            };
            for extent in [Extent::Passing, Extent::Thorough] {
                let start = std::time::Instant::now();
                let found = self_check(&compiled, extent);
                if extent == Extent::Passing { println!("{file} {coordinates:?} {:?}", start.elapsed()); }
                for f in found.iter().take(2) {println!("{file} {} {coordinates:?} {extent:?}: {found:?}", compiled.mechanism.name.text, found = f);}
            }
        }
    }
}
