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
    let internal = mechanism.states.len();
    let state = 2 * tangents.states.len() + internal;
    let unknowns = [Shape::Velocities, Shape::Rows, Shape::Internal];
    let unknowns: usize = unknowns.iter().map(|shape| emitter.compiled.entries(*shape)).sum();
    let dense = [
        ("StateMatrix", state * state),
        ("InputMatrix", state * inputs),
        ("OutputMatrix", outputs * state),
        ("Feedthrough", outputs * inputs),
        ("Unknowns", unknowns),
        ("Bordered", unknowns * unknowns),
    ];
    let sparse =
        DERIVATIVES.iter().map(|matrix| (matrix.name, emitter.compiled.entries(Shape::Matrix(matrix))));
    let arrays: Vec<(&str, usize)> = sparse.chain(dense).collect();
    // Where nothing is to be differentiated `()` stands for the entries.
    let rubs = !emitter.compiled.complete.equations.friction.is_none();
    let has = |name: &str| match name {
        "FrictionTangent" => rubs,
        name => internal > 0 || !name.starts_with("Internal"),
    };
    for (alias, length) in arrays.iter().filter(|(alias, _)| has(alias)) {
        let _ = writeln!(aliases, "type {alias}<R> = [R; {length}];");
    }

    let _ = writeln!(text, "impl<R: Real> Tangent<R> for {}<R> {{", emitter.inner);
    let states = tables::indices(tangents.states.iter().copied());
    tables::method(text, "states", "&[u16]", &states);
    for matrix in DERIVATIVES.iter().filter(|matrix| has(matrix.name)) {
        tables::pattern(text, emitter, matrix);
    }
    for (alias, _) in &arrays {
        let of = if has(alias) { format!("{alias}<R>") } else { "()".to_string() };
        let _ = writeln!(text, "type {alias} = {of};");
    }
    let order = format!("[u16; {unknowns}]");
    let _ = writeln!(text, "type Parameters = Parameters<R>;\ntype Order = {order};");
    tables::method(text, "parameter_names", "&[&'static str]", "<Parameters<R> as Fields<R>>::NAMES");
    let _ = writeln!(text, "fn order(&self) -> {order} {{ [0; {unknowns}] }}");
    let mut helpers = String::new();
    functions(text, &mut helpers, emitter, Interface::Tangent);
    text.push_str("}\n");
    text.push_str(&helpers);
}
