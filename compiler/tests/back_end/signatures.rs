//! The table of functions against the programs that were written by it.

use super::compiled;
use super::mechanisms::{CHAIN, FOUR_BAR, SHAFTS, with};
use linkwright_compiler::emit::{Home, emit};
use linkwright_compiler::functions::{FUNCTIONS, Function, Shape};
use std::collections::BTreeSet;

const ALL: &str = "options { solution = independent; emit = (tangent, penalty, projection, null_space); }";

#[test]
fn names_are_given_once() {
    let names: BTreeSet<&str> = FUNCTIONS.iter().map(|signature| signature.name).collect();
    assert_eq!(names.len(), FUNCTIONS.len());
    for signature in &FUNCTIONS {
        assert!(!signature.doc.is_empty() && !signature.results.is_empty(), "{}", signature.name);
    }
}

/// A program has as many results as its groups, and a group as many as its shape has names.
#[test]
fn results_are_those_of_their_groups() {
    for source in [FOUR_BAR, CHAIN, SHAFTS] {
        let compiled = compiled(&with(source, ALL)).expect("it compiles");
        let emitted = FUNCTIONS.iter().filter(|signature| (signature.emitted)(&compiled.complete));
        for signature in emitted.filter(|signature| signature.function != Function::Prepare) {
            let outputs = &compiled.programs.get(signature.function).outputs;
            let groups = signature.groups(&compiled.complete, outputs);
            assert!(!outputs.is_empty() || groups.iter().all(|group| group.is_empty()), "{}", signature.name);
            assert_eq!(
                groups.iter().map(|group| group.len()).sum::<usize>(),
                outputs.len(),
                "{}",
                signature.name
            );
            for (group, own) in signature.results.iter().zip(groups) {
                let names = group.shape.names(&compiled.mechanism, &compiled.complete.equations);
                assert!(names.is_empty() || names.len() == own.len(), "{} {}", signature.name, group.name);
                if let Shape::Bodies(record) = group.shape {
                    let length = record.of(compiled.mechanism.space).length();
                    assert_eq!(own.len(), length * compiled.mechanism.bodies.len());
                }
            }
        }
    }
}

/// What a parameter is called in a function is no word that the function writes its results to.
#[test]
fn parameters_may_be_called_as_results_are() {
    let words = [
        "a_out",
        "lambda_out",
        "positions",
        "rates",
        "store_out",
        "forces_out",
        "rows_out",
        "lu",
        "out",
        "w",
    ];
    for word in words {
        let source = with(FOUR_BAR, ALL).replace("payload", word);
        let compiled = compiled(&source).expect("it compiles");
        let (_, text) = emit(&compiled, &source, &Home::default());
        assert!(text.contains(&format!("let {word}_ = ")), "{word} has another name in functions");
        assert!(!text.contains(&format!("let {word} = ")), "{word} hides what results are written to");
    }
}
