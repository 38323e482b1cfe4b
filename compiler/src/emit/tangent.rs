//! The implementation of the runtime's `Tangent`, where `options { emit = (tangent) }` asks for it.
//!
//! ```text
//! impl<R: Real> Tangent<R> for FourBar<R> {
//!     const STIFFNESS_PATTERN: &'static [(u16, u16)] = &[(0, 0), …];
//!     type Stiffness = [R; 5];
//!     fn tangent(&self, time: R, q: &Q<R>, …, stiffness_out: &mut Stiffness<R>, damping_out: &mut Damping<R>) { … }
//! }
//! ```

use super::function::{all, function, list};
use super::names::Argument;
use super::{Emitter, array, tables};
use crate::equations::Tangents;
use crate::equations::tangent::Matrix;
use crate::schedule::Function;
use std::fmt::Write;

use Argument::{Acceleration, Constants, Inputs, Lambda, Q, Time, V};

/// The matrices, by the names of their types and of their patterns.
fn matrices(tangents: &Tangents) -> [(&'static str, &'static str, &Matrix); 9] {
    [
        ("Stiffness", "STIFFNESS_PATTERN", &tangents.stiffness),
        ("Damping", "DAMPING_PATTERN", &tangents.damping),
        ("RowStiffness", "ROW_STIFFNESS_PATTERN", &tangents.row_stiffness),
        ("RowDamping", "ROW_DAMPING_PATTERN", &tangents.row_damping),
        ("RateTangent", "RATE_PATTERN", &tangents.rate),
        ("InputTangent", "INPUT_PATTERN", &tangents.input),
        ("ParameterTangent", "PARAMETER_PATTERN", &tangents.parameter),
        ("OutputTangent", "OUTPUT_PATTERN", &tangents.output),
        ("CoordinateTangent", "COORDINATE_PATTERN", &tangents.coordinate),
    ]
}

fn length(matrix: &Matrix) -> usize {
    matrix.iter().map(|row| row.len()).sum()
}

/// Short names for the types, and the implementation; nothing where it is not asked for.
pub fn tangent(aliases: &mut String, text: &mut String, emitter: &Emitter) {
    let Some(tangents) = &emitter.compiled.equations.tangents else { return };
    let matrices = matrices(tangents);
    let mechanism = emitter.mechanism;
    let (inputs, outputs) = (mechanism.inputs.len(), mechanism.outputs.len());
    let state = 2 * tangents.states.len();
    let static_unknowns = emitter.velocities() + emitter.rows();
    let dense = [
        ("StateMatrix", state * state),
        ("InputMatrix", state * inputs),
        ("OutputMatrix", outputs * state),
        ("Feedthrough", outputs * inputs),
        ("Unknowns", static_unknowns),
        ("Bordered", static_unknowns * static_unknowns),
    ];
    let sparse = matrices.iter().map(|(alias, _, matrix)| (*alias, length(matrix)));
    let arrays: Vec<(&str, usize)> = sparse.chain(dense).collect();
    for (alias, length) in &arrays {
        let _ = writeln!(aliases, "type {alias}<R> = [R; {length}];");
    }

    let _ = writeln!(text, "impl<R: Real> Tangent<R> for {}<R> {{", emitter.inner);
    let states = tables::indices(tangents.states.iter().copied());
    let _ = writeln!(text, "const STATES: &'static [u16] = {states};");
    for (_, pattern, matrix) in &matrices {
        let pairs = matrix.iter().enumerate().flat_map(|(row, entries)| {
            entries.keys().map(move |column| format!("({row}, {column})")).collect::<Vec<_>>()
        });
        let _ = writeln!(text, "const {pattern}: &'static [(u16, u16)] = &{};", array(pairs));
    }
    for (alias, _) in &arrays {
        let _ = writeln!(text, "type {alias} = {alias}<R>;");
    }
    let order = format!("[u16; {static_unknowns}]");
    let _ = writeln!(text, "type Parameters = Parameters<R>;\ntype Order = {order};");
    let _ = writeln!(text, "fn order() -> {order} {{ [0; {static_unknowns}] }}");
    let mut helpers = String::new();
    functions(text, &mut helpers, emitter, tangents);
    text.push_str("}\n");
    text.push_str(&helpers);
}

fn functions(text: &mut String, helpers: &mut String, emitter: &Emitter, tangents: &Tangents) {
    let everything = [Constants, Time, Q, V, Inputs, Acceleration, Lambda];
    let moving = [Constants, Time, Q, V, Acceleration];
    let point = "time: R, q: &Q<R>, v: &V<R>";
    let solved = "u: &Inputs<R>, a: &V<R>, lambda: &Lambda<R>";
    let mut write = |which: Function, arguments: &[Argument], signature: &str| {
        function(text, helpers, emitter, which, arguments, signature, all);
    };
    write(Function::Residual, &everything, &format!("residual(&self, {point}, {solved}, out: &mut V<R>)"));
    write(
        Function::RateTangent,
        &[Constants, Time, Q, V],
        &format!("rate_tangent(&self, {point}, out: &mut RateTangent<R>)"),
    );
    write(
        Function::InputTangent,
        &[Constants, Time, Q, V, Inputs],
        &format!("input_tangent(&self, {point}, u: &Inputs<R>, out: &mut InputTangent<R>)"),
    );
    write(
        Function::ParameterTangent,
        &everything,
        &format!("parameter_tangent(&self, {point}, {solved}, out: &mut ParameterTangent<R>)"),
    );
    write(
        Function::OutputTangent,
        &[Constants, Time, Q, V, Inputs, Lambda],
        &format!(
            "output_tangent(&self, {point}, u: &Inputs<R>, lambda: &Lambda<R>, out: &mut OutputTangent<R>)"
        ),
    );
    write(
        Function::CoordinateTangent,
        &moving,
        &format!("coordinate_tangent(&self, {point}, a: &V<R>, out: &mut CoordinateTangent<R>)"),
    );
    // Two matrices each.
    let mut pair = |which: Function, arguments: &[Argument], first: usize, signature: &str| {
        function(text, helpers, emitter, which, arguments, signature, |outputs| {
            let (stiffness, damping) = outputs.split_at(first);
            format!("*stiffness_out = {};\n*damping_out = {};", list(stiffness), list(damping))
        });
    };
    pair(
        Function::Tangent,
        &everything,
        length(&tangents.stiffness),
        &format!(
            "tangent(&self, {point}, {solved}, stiffness_out: &mut Stiffness<R>, damping_out: &mut Damping<R>)"
        ),
    );
    pair(
        Function::RowTangent,
        &moving,
        length(&tangents.row_stiffness),
        &format!(
            "row_tangent(&self, {point}, a: &V<R>, stiffness_out: &mut RowStiffness<R>, \
             damping_out: &mut RowDamping<R>)"
        ),
    );
}
