//! How one function is written: signature, loads, instructions, result.

use super::names::Argument;
use super::{Emitter, array};
use crate::schedule::Function;
use std::fmt::Write;

use Argument::{Constants, Inputs, Q, Time, V};

/// Arguments of the solution: of `acceleration`, and the first of `acceleration_baumgarte`.
pub const SOLUTION: [Argument; 5] = [Constants, Time, Q, V, Inputs];

/// One function: signature, loads, instructions, result.
pub fn function(
    text: &mut String,
    helpers: &mut String,
    emitter: &Emitter,
    function: Function,
    arguments: &[Argument],
    signature: &str,
    result: impl Fn(&[String]) -> String,
) {
    let body = emitter.body(function, arguments, helpers);
    let _ = writeln!(text, "fn {signature} {{");
    let uses = |text: &String| text.contains("constants");
    if uses(&body.statements) || body.outputs.iter().any(uses) {
        text.push_str("let constants = &self.constants;\n");
    }
    text.push_str(&body.statements);
    let _ = writeln!(text, "{}\n}}", result(&body.outputs));
}

/// All results into `out`.
pub fn all(outputs: &[String]) -> String {
    format!("*out = {};", list(outputs))
}

/// The one result.
pub fn one(outputs: &[String]) -> String {
    outputs[0].clone()
}

/// `[a, b, c]` of texts.
pub fn list(texts: &[String]) -> String {
    array(texts.iter().cloned())
}

/// v̇ and λ to where they go, the pivot as the result.
pub fn solution_of(velocities: usize) -> impl Fn(&[String]) -> String {
    move |outputs| {
        let (a, rest) = outputs.split_at(velocities);
        let (lambda, pivot) = rest.split_at(rest.len() - 1);
        format!("*a_out = {};\n*lambda_out = {};\n{}", list(a), list(lambda), pivot[0])
    }
}
