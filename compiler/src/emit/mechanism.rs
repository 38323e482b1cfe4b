//! The implementations of `Variables` and `Mechanism`: M, Φ, D, ν, γ, Q, energies, accelerations and outputs.

use super::function::functions;
use super::names::field;
use super::rust::literal;
use super::{Emitter, array, quoted, tables};
use crate::compiled::AngleInOutputs;
use crate::functions::{Interface, JACOBIAN, MASS, Shape};
use crate::model::{Occasion, Way};
use std::fmt::Write;

pub fn mechanism(text: &mut String, emitter: &Emitter) {
    let Emitter { name, inner, mechanism, compiled, .. } = emitter;
    let layout = &compiled.complete.equations.layout;
    let mut helpers = String::new();
    variables(text, emitter);
    let _ = writeln!(text, "impl<R: Real> Mechanism<R> for {inner}<R> {{");
    tables::method(text, "name", "&'static str", &quoted(name));
    tables::method(text, "fingerprint", "u64", &format!("{:#018x}", compiled.fingerprint()));
    tables::method(text, "rows", "&[Row]", &tables::rows(emitter));
    let names = [
        ("position_names", layout.position_names(mechanism)),
        ("velocity_names", layout.velocity_names(mechanism)),
    ];
    for (method, names) in names {
        tables::method(text, method, "&[&'static str]", &tables::strings(names));
    }
    for matrix in [&MASS, &JACOBIAN] {
        tables::pattern(text, emitter, matrix);
    }
    for alias in ["Mass", "Jacobian"] {
        let _ = writeln!(text, "type {alias} = {alias}<R>;");
    }
    let named = [("Inputs", "input_names", Shape::Inputs), ("Outputs", "output_names", Shape::Outputs)];
    for (alias, method, shape) in named {
        let of = emitter.type_of(shape);
        let _ = writeln!(text, "type {alias} = {of};");
        tables::method(text, method, "&'static [&'static str]", &format!("<{of} as Fields<R>>::NAMES"));
    }
    if compiled.complete.further.leads {
        tables::method(text, "null_space_first", "bool", "true");
    }
    if !compiled.complete.equations.friction.is_none() {
        tables::method(text, "rubs", "bool", "true");
    }
    if mechanism.holds() {
        let names = mechanism.held_names().into_iter().map(|name| name.text.clone()).collect();
        tables::method(text, "gate_names", "&[&'static str]", &tables::strings(names));
        if !mechanism.events.is_empty() || !mechanism.memories.is_empty() {
            let names = mechanism.memories.iter().map(|memory| memory.name.text.clone()).collect();
            tables::method(text, "memory_names", "&[&'static str]", &tables::strings(names));
            let triggers =
                mechanism.events_in_places().into_iter().map(|(_, event)| trigger(&event.occasion));
            tables::method(text, "triggers", "&[Trigger]", &format!("&{}", array(triggers)));
        }
        if mechanism.is_rigid() {
            tables::method(text, "is_rigid", "bool", "true");
        }
        if mechanism.sticks() {
            tables::method(text, "sticks", "bool", "true");
        }
        let pressed = mechanism.pressed_by();
        if !pressed.is_empty() {
            let entries = array(pressed.iter().map(|gate| format!("{gate:?}")));
            tables::method(text, "pressed_by", "&[Option<usize>]", &format!("&{entries}"));
        }
        let as_one = mechanism.slide_as_one();
        if !as_one.is_empty() {
            let entries = array(as_one.iter().map(ToString::to_string));
            tables::method(text, "slide_as_one", "&[usize]", &format!("&{entries}"));
        }
        if mechanism.options.by_impulses {
            tables::method(text, "parts_by_impulses", "bool", "true");
        }
    }
    functions(text, &mut helpers, emitter, Interface::Mechanism);
    if mechanism.states.is_empty() {
        let _ = writeln!(
            text,
            "fn internal_rates(&self, _time: R, _state: &{}, _u: &{}, _a: &V<R>, _lambda: &Lambda<R>, _rates: &mut ()) {{}}",
            emitter.type_of(Shape::State),
            emitter.type_of(Shape::Inputs)
        );
    } else {
        let names = mechanism.states.iter().map(|state| state.name.text.clone()).collect();
        tables::method(text, "internal_names", "&[&'static str]", &tables::strings(names));
    }
    unwrap(text, emitter);
    text.push_str("}\n");
    text.push_str(&helpers);
}

/// What lets an event occur, as the runtime says it.
fn trigger(occasion: &Occasion) -> String {
    match occasion {
        Occasion::Passing(_, Way::Rises) => "Trigger::Rises".to_string(),
        Occasion::Passing(_, Way::Falls) => "Trigger::Falls".to_string(),
        Occasion::Passing(_, Way::Crosses) => "Trigger::Crosses".to_string(),
        Occasion::Every(period) => format!("Trigger::Every({})", literal(*period)),
    }
}

/// What a state is made of.
fn variables(text: &mut String, emitter: &Emitter) {
    let _ = writeln!(text, "impl<R: Real> Variables<R> for {}<R> {{", emitter.inner);
    tables::method(text, "layout", "&Layout<'_>", &format!("&{}", tables::layout(emitter)));
    let states = &emitter.mechanism.states;
    if states.iter().any(|state| state.scale.is_some()) {
        let scales = array(states.iter().map(|state| literal(state.scale.unwrap_or(1.0))));
        tables::method(text, "internal_scales", "&[f64]", &format!("&{scales}"));
    }
    for alias in ["Q", "V", "Lambda"] {
        let _ = writeln!(text, "type {alias} = {alias}<R>;");
    }
    let internal = if emitter.mechanism.states.is_empty() { "()" } else { "Z<R>" };
    let gates = if emitter.mechanism.holds() { "Gates<R>" } else { "()" };
    let _ = writeln!(text, "type Z = {internal};\ntype Gates = {gates};\n}}");
}

fn unwrap(text: &mut String, emitter: &Emitter) {
    let Emitter { mechanism, compiled, .. } = emitter;
    let angles = compiled.angles_in_outputs();
    let field = |angle: &AngleInOutputs| field(&mechanism.outputs[angle.output].name.identifier());
    let of = emitter.type_of(Shape::Outputs);
    let _ = writeln!(text, "fn unwrap(&self, outputs: &mut {of}, previous: &{of}) {{");
    for field in angles.iter().map(field) {
        let _ = writeln!(text, "outputs.{field} = unwrap_angle(outputs.{field}, previous.{field});");
    }
    text.push_str("}\n");
    let stated: Vec<(String, usize)> =
        angles.iter().filter_map(|angle| Some((field(angle), angle.stated?))).collect();
    if stated.is_empty() {
        return;
    }
    let zeros = format!("[R::ZERO; {}]", emitter.compiled.entries(Shape::Conditions));
    let _ = writeln!(text, "fn unwrap_start(&self, outputs: &mut {of}) {{");
    let _ = writeln!(text, "let (mut positions, mut rates) = ({zeros}, {zeros});");
    text.push_str("self.start_targets(&mut positions, &mut rates);\n");
    for (field, at) in stated {
        let _ = writeln!(text, "outputs.{field} = unwrap_angle(outputs.{field}, positions[{at}]);");
    }
    text.push_str("}\n");
}
