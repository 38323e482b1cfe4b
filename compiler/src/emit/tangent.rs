//! The implementation of the runtime's `Tangent`, where `options { emit = (tangent) }` asks for it.
//!
//! ```text
//! impl<R: Real> Tangent<R> for FourBar<R> {
//!     fn stiffness_pattern(&self) -> &[(u16, u16)] { &[(0, 0), …] }
//!     type Stiffness = [R; 5];
//!     fn tangent(&self, time: R, q: &Q<R>, …, stiffness_out: &mut Stiffness<R>, damping_out: &mut Damping<R>) { … }
//! }
//! ```

use super::function::functions;
use super::{Emitter, tables};
use crate::functions::{DERIVATIVES, Interface, Shape};
use std::fmt::Write;

/// Short names for the types, and the implementation; nothing where it is not asked for.
pub fn tangent(aliases: &mut String, text: &mut String, emitter: &Emitter) {
    let Some(tangents) = &emitter.compiled.complete.tangents else { return };
    let mechanism = emitter.mechanism;
    let (inputs, outputs) = (mechanism.inputs.len(), mechanism.outputs.len());
    let state = 2 * tangents.states.len();
    let static_unknowns = emitter.compiled.entries(Shape::Velocities) + emitter.compiled.entries(Shape::Rows);
    let dense = [
        ("StateMatrix", state * state),
        ("InputMatrix", state * inputs),
        ("OutputMatrix", outputs * state),
        ("Feedthrough", outputs * inputs),
        ("Unknowns", static_unknowns),
        ("Bordered", static_unknowns * static_unknowns),
    ];
    let sparse = DERIVATIVES.map(|matrix| (matrix.name, emitter.compiled.entries(Shape::Matrix(matrix))));
    let arrays: Vec<(&str, usize)> = sparse.into_iter().chain(dense).collect();
    for (alias, length) in &arrays {
        let _ = writeln!(aliases, "type {alias}<R> = [R; {length}];");
    }

    let _ = writeln!(text, "impl<R: Real> Tangent<R> for {}<R> {{", emitter.inner);
    let states = tables::indices(tangents.states.iter().copied());
    tables::method(text, "states", "&[u16]", &states);
    for matrix in DERIVATIVES {
        tables::pattern(text, emitter, matrix);
    }
    for (alias, _) in &arrays {
        let _ = writeln!(text, "type {alias} = {alias}<R>;");
    }
    let order = format!("[u16; {static_unknowns}]");
    let _ = writeln!(text, "type Parameters = Parameters<R>;\ntype Order = {order};");
    tables::method(text, "parameter_names", "&[&'static str]", "<Parameters<R> as Fields<R>>::NAMES");
    let _ = writeln!(text, "fn order(&self) -> {order} {{ [0; {static_unknowns}] }}");
    let mut helpers = String::new();
    functions(text, &mut helpers, emitter, Interface::Tangent);
    text.push_str("}\n");
    text.push_str(&helpers);
}
