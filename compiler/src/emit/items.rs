//! The items a user sees: the model, its parameters, inputs, outputs and state, and its constants.

use super::names::field;
use super::rust::literal;
use super::{Emitter, array, coordinates_json, declared, documentation, named, quoted};
use crate::functions::Shape;
use crate::schedule::count;
use std::fmt::Write;

pub(super) const DERIVES: &str = "#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, \
                       ::core::cmp::PartialEq)]";
pub(super) const F64: &str = "::core::primitive::f64";

pub fn items(text: &mut String, emitter: &Emitter, source: &str) {
    let Emitter { name, visibility, path, mechanism, compiled, .. } = emitter;
    let _ = writeln!(text, "{}", mechanism.attributes);
    documentation::model(text, emitter, source);
    let layout = layout(emitter);
    let _ = writeln!(
        text,
        "{DERIVES} {layout}{visibility} struct {name}<R = {F64}> {{ parameters: {name}Parameters<R>, phases: [R; {}], \
         constants: [R; {}] }}",
        compiled.complete.equations.symbols.phases.len(),
        compiled.programs.prepared
    );
    parameters(text, emitter);
    inputs(text, emitter);
    outputs(text, emitter);
    let gates = emitter.compiled.entries(Shape::Gates);
    let kinds = [
        (mechanism.options.held, "gates of contacts"),
        (mechanism.sticks(), "forces of dry friction"),
        (!mechanism.events.is_empty(), "events"),
        (!mechanism.memories.is_empty(), "memories"),
    ];
    let kinds: Vec<&str> = kinds.into_iter().filter(|(is, _)| *is).map(|(_, kind)| kind).collect();
    let held = match kinds.split_last() {
        Some((last, [])) => (*last).to_string(),
        Some((last, before)) => format!("{} and {last}", before.join(", ")),
        None => String::new(),
    };
    let (states, internal) = match (mechanism.states.len(), gates) {
        (0, 0) => ("Positions and velocities".to_string(), String::new()),
        (n, 0) => ("Positions, velocities and internal states".to_string(), format!(", [R; {n}]")),
        (0, m) => (format!("Positions, velocities and {held}"), format!(", (), [R; {m}]")),
        (n, m) => {
            (format!("Positions, velocities, internal states and {held}"), format!(", [R; {n}], [R; {m}]"))
        }
    };
    let _ = writeln!(
        text,
        "#[doc = \"{states} of [`{name}`].\"] {visibility} type {name}State<R = {F64}> = \
         {path}::State<[R; {}], [R; {}]{internal}>;",
        emitter.compiled.entries(Shape::Positions),
        emitter.compiled.entries(Shape::Velocities)
    );
    named::items(text, emitter);
    constants(text, emitter, source);
}

/// That of C where functions with its interface are beside them.
fn layout(emitter: &Emitter) -> &'static str {
    if emitter.mechanism.options.export_c.is_some() { "#[repr(C)] " } else { "" }
}

fn parameters(text: &mut String, emitter: &Emitter) {
    let Emitter { name, visibility, mechanism, .. } = emitter;
    let layout = layout(emitter);
    let _ = writeln!(
        text,
        "#[doc = \"Parameters of [`{name}`], in SI units.\"] {DERIVES} {layout}{visibility} struct {name}Parameters<R = {F64}> {{"
    );
    for parameter in &mechanism.parameters {
        let field = field(&parameter.name.identifier());
        let own = parameter.name.identifier();
        let doc = declared::doc(&parameter.unit, &format!("{name}Parameters"), &own, Some(parameter.default));
        let _ = writeln!(text, "{} #[doc = {}] pub {field}: R,", parameter.docs, quoted(&doc));
    }
    if mechanism.parameters.is_empty() {
        text.push_str("#[doc(hidden)] pub scalar: ::core::marker::PhantomData<R>,");
    }
    text.push_str("}\n");
}

fn inputs(text: &mut String, emitter: &Emitter) {
    let Emitter { name, visibility, mechanism, .. } = emitter;
    let layout = layout(emitter);
    if mechanism.inputs.is_empty() {
        return;
    }
    let _ = writeln!(
        text,
        "#[doc = \"Inputs of [`{name}`], in SI units.\"] {DERIVES} {layout}{visibility} struct {name}Inputs<R = {F64}> {{"
    );
    for input in &mechanism.inputs {
        let own = input.name.identifier();
        let doc = quoted(&declared::doc(&input.unit, &format!("{name}Inputs"), &own, None));
        let _ = writeln!(text, "{} #[doc = {doc}] pub {}: R,", input.docs, field(&input.name.identifier()));
    }
    text.push_str("}\n");
}

fn outputs(text: &mut String, emitter: &Emitter) {
    let Emitter { name, visibility, mechanism, .. } = emitter;
    let layout = layout(emitter);
    if mechanism.outputs.is_empty() {
        return;
    }
    let _ = writeln!(
        text,
        "#[doc = \"Outputs of [`{name}`], in SI units.\"] {DERIVES} {layout}{visibility} struct {name}Outputs<R = {F64}> {{"
    );
    for output in &mechanism.outputs {
        let own = output.name.identifier();
        let doc = quoted(&declared::doc(&output.unit, &format!("{name}Outputs"), &own, None));
        let _ = writeln!(text, "{} #[doc = {doc}] pub {}: R,", output.docs, field(&output.name.identifier()));
    }
    text.push_str("}\n");
}

fn numbers(values: &[f64]) -> String {
    array(values.iter().map(|value| literal(*value)))
}

/// The state at the start.
fn start(emitter: &Emitter) -> String {
    let Emitter { path, compiled, .. } = emitter;
    let (q, v) = (numbers(&compiled.assembly.q), numbers(&compiled.assembly.v));
    let z = compiled.mechanism.internal_starts();
    if compiled.mechanism.holds() {
        let z = if z.is_empty() { "()".to_string() } else { numbers(&z) };
        let gates = numbers(&compiled.start_gates());
        return format!("{path}::State {{ q: {q}, v: {v}, z: {z}, gates: {gates} }}");
    }
    match z.as_slice() {
        [] => format!("{path}::State::new({q}, {v})"),
        z => format!("{path}::State {{ q: {q}, v: {v}, z: {}, gates: () }}", numbers(z)),
    }
}

fn constants(text: &mut String, emitter: &Emitter, source: &str) {
    let Emitter { name, compiled, mechanism, .. } = emitter;
    let string = "&'static ::core::primitive::str";
    let operations = count(compiled.programs.get(compiled.default_solution())).total();
    // A number of the start may happen to be near π, or have more digits than one writes by hand.
    let _ = writeln!(text, "#[allow(clippy::all)] impl {name}<{F64}> {{");
    let mut constant = |doc: &str, declaration: &str, value: &str| {
        let _ = writeln!(text, "#[doc = {}] pub const {declaration} = {value};", quoted(doc));
    };
    constant(
        "Consistent start state for the default parameters, assembled at compile time.",
        &format!("START: {name}State"),
        &start(emitter),
    );
    let usize = "::core::primitive::usize";
    constant(
        "Degrees of freedom, drivers removed.",
        &format!("DEGREES_OF_FREEDOM: {usize}"),
        &compiled.assembly.mobility.generic.to_string(),
    );
    constant(
        "Operations of the default acceleration function (Baumgarte), a fused multiply-add counted once.",
        &format!("OPERATIONS: {usize}"),
        &operations.to_string(),
    );
    // Taken out of a tuple, because rustdoc prints a literal in full and of other expressions `_`.
    let unprinted = |text: &str| format!("({},).0", quoted(text));
    constant("The definition as written.", &format!("SOURCE: {string}"), &unprinted(source));
    constant(
        "The definition as versioned JSON: kinds, shapes and units as written.",
        &format!("DEFINITION: {string}"),
        &unprinted(&compiled.definition),
    );
    constant(
        "What the entries of q and v and the constraint rows are, as JSON.",
        &format!("COORDINATES: {string}"),
        &unprinted(&coordinates_json(mechanism, &compiled.complete.equations)),
    );
    constant(
        "Names of the bodies, in the order of `motions`.",
        &format!("BODIES: &'static [{string}]"),
        &format!("&{}", array(mechanism.bodies.iter().map(|body| quoted(&body.name.text)))),
    );
    constant(
        "Names of the joints, in the order of `reactions`.",
        &format!("JOINTS: &'static [{string}]"),
        &format!("&{}", array(mechanism.joints.iter().map(|joint| quoted(&joint.name.text)))),
    );
    constant(
        "Names of the loads, in the order of `powers`.",
        &format!("LOADS: &'static [{string}]"),
        &format!("&{}", array(mechanism.loads.iter().map(|load| quoted(&load.name.text)))),
    );
    let dropped = compiled.assembly.dropped.iter();
    constant(
        "Constraint rows that repeat what others fix: joint and row. They are left out, or kept with the multiplier zero.",
        &format!("REDUNDANT_ROWS: &'static [({string}, {string})]"),
        &format!(
            "&{}",
            array(dropped.map(|row| {
                format!("({}, {})", quoted(&mechanism.joints[row.joint.0].name.text), quoted(row.form.name))
            }))
        ),
    );
    let shared = compiled.assembly.shared.iter();
    constant(
        "Joints whose reactions are not unique, because constraint rows repeat what others fix.",
        &format!("SHARED_REACTIONS: &'static [{string}]"),
        &format!("&{}", array(shared.map(|joint| quoted(&mechanism.joints[joint.0].name.text)))),
    );
    text.push_str("}\n");
}
