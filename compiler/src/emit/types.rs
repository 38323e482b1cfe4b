//! The short names of this mechanism's types, and `Fields` of its parameters, inputs and outputs.

use super::names::field;
use super::{Emitter, array, tables};
use crate::functions::{CONDITION_JACOBIAN, JACOBIAN, MASS, Shape};
use std::fmt::Write;

/// Short names for the types of this mechanism.
pub fn aliases(text: &mut String, emitter: &Emitter) {
    let name = &emitter.name;
    let equations = &emitter.compiled.complete.equations;
    let of = |shape: Shape| emitter.compiled.entries(shape);
    let (velocities, rows) = (of(Shape::Velocities), of(Shape::Rows));
    let freedoms = velocities + equations.idle.len() - rows;
    let arrays = [
        ("Constants", of(Shape::Constants)),
        ("Phases", of(Shape::Phases)),
        ("Q", of(Shape::Positions)),
        ("V", velocities),
        ("Lambda", rows),
        ("Mass", of(Shape::Matrix(&MASS))),
        ("Jacobian", of(Shape::Matrix(&JACOBIAN))),
        ("Conditions", of(Shape::Conditions)),
        ("ConditionJacobian", of(Shape::Matrix(&CONDITION_JACOBIAN))),
        ("Factor", emitter.compiled.table.columns.len()),
        ("System", emitter.compiled.table.order.len()),
        ("Dense", rows * velocities),
        ("Basis", freedoms * velocities),
        ("Reduced", freedoms * freedoms),
        ("Store", of(Shape::Store)),
        ("Lu", of(Shape::Lu)),
    ];
    let further = &emitter.compiled.complete.further;
    let absent =
        |alias: &str| alias == "Store" && further.stored.is_none() || alias == "Lu" && !further.emits_factors;
    if !emitter.mechanism.states.is_empty() {
        let _ = writeln!(text, "type Z<R> = [R; {}];", of(Shape::Internal));
    }
    if emitter.mechanism.holds() {
        let _ = writeln!(text, "type Gates<R> = [R; {}];", of(Shape::Gates));
    }
    for (alias, length) in arrays.into_iter().filter(|(alias, _)| !absent(alias)) {
        let _ = writeln!(text, "type {alias}<R> = [R; {length}];");
    }
    let _ = writeln!(text, "type Parameters<R> = {name}Parameters<R>;");
    if !emitter.mechanism.inputs.is_empty() {
        let _ = writeln!(text, "type Inputs<R> = {name}Inputs<R>;");
    }
    if !emitter.mechanism.outputs.is_empty() {
        let _ = writeln!(text, "type Outputs<R> = {name}Outputs<R>;");
    }
}

/// `Fields` of the parameters, and of the inputs and outputs where there are any.
pub fn fields(text: &mut String, emitter: &Emitter) {
    let Emitter { name, mechanism, .. } = emitter;
    let parameters = mechanism.parameters.iter().map(|parameter| &parameter.name).collect::<Vec<_>>();
    let inputs = mechanism.inputs.iter().map(|input| &input.name).collect();
    let outputs = mechanism.outputs.iter().map(|output| &output.name).collect();
    for (of, names) in [("Parameters", parameters), ("Inputs", inputs), ("Outputs", outputs)] {
        if names.is_empty() && of != "Parameters" {
            continue;
        }
        let n = names.len();
        let fields: Vec<String> = names.iter().map(|name| field(&name.identifier())).collect();
        let scalar = if names.is_empty() { "scalar: ::core::marker::PhantomData" } else { "" };
        let given: Vec<String> =
            fields.iter().enumerate().map(|(index, field)| format!("{field}: values[{index}]")).collect();
        let _ = writeln!(
            text,
            "impl<R: Real> Fields<R> for {of}<R> {{\n\
             const NAMES: &'static [&'static str] = {};\n\
             type Array = [R; {n}];\n\
             fn from_array(values: [R; {n}]) -> Self {{ {name}{of} {{ {}{scalar} }} }}\n\
             fn to_array(&self) -> [R; {n}] {{ {} }}\n}}",
            tables::strings(names.iter().map(|name| name.text.clone()).collect()),
            given.join(", "),
            array(fields.iter().map(|field| format!("self.{field}")))
        );
    }
}
