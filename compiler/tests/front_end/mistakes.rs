//! Mistakes and what is said about them, one message each.

use crate::{bad, slider_crank};

/// Statements added to the slider-crank, and the only message they give.
const MISTAKES: &[(&str, &str)] = &[
];

#[test]
fn messages() {
    for (more, expected) in MISTAKES {
        let diagnostics = bad(&slider_crank(more));
        let found: Vec<&str> = diagnostics.iter().map(|error| error.message.as_str()).collect();
        assert_eq!(found, [*expected], "{more}");
    }
}
