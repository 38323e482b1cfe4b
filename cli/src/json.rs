//! Results for machines: one object, versioned, described in `docs/command-line.md`.

use crate::arguments::Command;
use crate::explain::{Beam, Explanation, MeshOf, Mode, Value as Quantity};
use crate::input::Found;
use linkwright_compiler::Repetition;
use linkwright_compiler::check::Strain;
use linkwright_compiler::check::motion::Reflected;
use linkwright_compiler::counts::Row;
use linkwright_compiler::diagnostics::Severity;
use linkwright_compiler::model::gears::{Gives, Told};
use linkwright_compiler::source::{Located, Source};
use serde_json::{Map, Value, json};
use std::ops::Range;

/// Raised when a field changes its meaning or goes.
pub const VERSION: u32 = 1;

/// The whole answer.
pub fn document(command: Command, mechanisms: Vec<Value>, unreadable: &[(String, String)]) -> String {
    document_of(command.text(), mechanisms, unreadable)
}

/// The same of a command of this name.
pub fn document_of(command: &str, mechanisms: Vec<Value>, unreadable: &[(String, String)]) -> String {
    let unreadable: Vec<Value> =
        unreadable.iter().map(|(file, message)| json!({ "file": file, "message": message })).collect();
    let document = json!({
        "version": VERSION,
        "command": command,
        "mechanisms": mechanisms,
        "unreadable": unreadable,
    });
    format!("{document:#}\n")
}

/// A definition: name, place, errors and warnings.
pub fn mechanism(found: &Found, name: Option<&str>, errors: &[Located]) -> Value {
    let source = &found.source;
    let errors: Vec<Value> = errors.iter().map(|error| diagnostic(source, error)).collect();
    let mut object = place(source, &found.range);
    object.insert("name".into(), json!(name));
    object.insert("diagnostics".into(), Value::Array(errors));
    Value::Object(object)
}

fn diagnostic(source: &Source, error: &Located) -> Value {
    let message = |range: &Range<usize>, message: &str| {
        let mut object = place(source, range);
        object.insert("message".into(), json!(message));
        object
    };
    let notes = error.notes.iter().map(|(range, text)| Value::Object(message(range, text)));
    let mut object = message(&error.range, &error.message);
    let severity = if error.severity == Severity::Error { "error" } else { "warning" };
    object.insert("severity".into(), json!(severity));
    object.insert("notes".into(), notes.collect());
    Value::Object(object)
}

/// File, bytes from 0, lines and columns from 1.
fn place(source: &Source, range: &Range<usize>) -> Map<String, Value> {
    let end = |byte: usize| {
        let at = source.position(byte);
        json!({ "byte": byte, "line": at.line, "column": at.column })
    };
    let fields = [("file", json!(source.name)), ("start", end(range.start)), ("end", end(range.end))];
    fields.into_iter().map(|(name, value)| (name.to_string(), value)).collect()
}

/// Operations, one object for each function.
pub fn counts(rows: &[Row]) -> Value {
    rows.iter()
        .map(|row| {
            let mut object: Map<String, Value> =
                row.named().into_iter().map(|(name, count)| (name.to_string(), json!(count))).collect();
            object.insert("coordinates".into(), json!(row.coordinates));
            object.insert("function".into(), json!(row.function));
            Value::Object(object)
        })
        .collect()
}

/// What `explain` tells.
pub fn explanation(e: &Explanation) -> Value {
    let value = |value: &Quantity| json!({ "name": value.name, "value": value.value, "unit": value.unit });
    let named = |parts: &[[String; 2]]| -> Value {
        parts.iter().map(|[name, kind]| json!({ "name": name, "kind": kind })).collect()
    };
    let rows = |rows: &[[String; 2]]| -> Value {
        rows.iter().map(|[of, what]| json!({ "of": of, "what": what })).collect()
    };
    let parameters = e.parameters.iter().map(|parameter| {
        let Quantity { name, value, unit } = &parameter.default;
        json!({ "name": name, "default": value, "unit": unit, "bounds": parameter.bounds })
    });
    let bodies = e.bodies.iter().map(
        |body| json!({ "name": body.name, "shape": body.shape, "mass": body.mass, "moments": body.moments }),
    );
    let joints = e.joints.iter().map(|joint| {
        json!({ "name": joint.name, "kind": joint.kind, "places": joint.places, "carries": joint.carries })
    });
    let start = e.start.iter().map(|found| {
        let Quantity { name, value, unit } = &found.value;
        json!({ "name": name, "value": value, "unit": unit, "given": found.given.text() })
    });
    let mut object = json!({
        "definition": serde_json::from_str::<Value>(&e.definition).unwrap_or_default(),
        "space": e.space,
        "parameters": parameters.collect::<Vec<_>>(),
        "inputs": e.inputs.iter().map(|[name, unit]| json!({ "name": name, "unit": unit })).collect::<Vec<_>>(),
        "states": e.states.iter().map(value).collect::<Vec<_>>(),
        "memories": e.memories.iter().map(value).collect::<Vec<_>>(),
        "events": e.events.iter().map(|[name, when, sets]| json!({ "name": name, "when": when, "sets": sets })).collect::<Vec<_>>(),
        "bodies": bodies.collect::<Vec<_>>(),
        "joints": joints.collect::<Vec<_>>(),
        "couplings": named(&e.couplings),
        "teeth": e.teeth.iter().map(teeth).collect::<Value>(),
        "loads": named(&e.loads),
        "frictions": e.frictions.iter().map(|[name, braking]| json!({ "name": name, "near_rest": braking })).collect::<Vec<_>>(),
        "contacts": e.contacts.iter().map(|[name, touch]| json!({ "name": name, "touch": touch })).collect::<Vec<_>>(),
        "degrees_of_freedom": e.degrees_of_freedom,
        "gruebler": e.gruebler,
        "mobility": e.mobility,
        "motion": e.motion,
        "independent": e.independent,
        "coordinates": e.coordinates,
        "choice": e.choice,
        "solution": e.solution,
        "repetition": e.repetition.iter().map(repetition).collect::<Vec<_>>(),
        "positions": e.positions,
        "velocities": e.velocities,
        "rows": rows(&e.rows),
        "redundant": { "rows": rows(&e.redundant), "kept": e.keeps_redundant, "shared_reactions": e.shared_reactions },
        "start": start.collect::<Vec<_>>(),
        "outputs": e.outputs.iter().map(value).collect::<Vec<_>>(),
        "counts": counts(&e.functions),
    });
    if !e.signals.is_empty() {
        object["signals"] =
            e.signals.iter().map(|[name, unit]| json!({ "name": name, "unit": unit })).collect();
    }
    if !e.modes.is_empty() {
        let mode = |mode: &Mode| json!({ "name": mode.name, "hertz": mode.hertz, "step": mode.step });
        object["modes"] = e.modes.iter().map(mode).collect();
    }
    if !e.gives.is_empty() {
        object["teeth_that_give"] = e.gives.iter().map(gives).collect();
    }
    if !e.beams.is_empty() {
        object["beams"] = e.beams.iter().map(beam).collect();
    }
    if !e.meshes.is_empty() {
        object["meshes"] = e.meshes.iter().map(mesh).collect();
    }
    if !e.reflected.is_empty() {
        object["reflected"] = e.reflected.iter().map(reflected).collect();
    }
    if !e.parts.is_empty() {
        object["parts"] = named(&e.parts);
    }
    if !e.tables.is_empty() {
        object["tables"] = named(&e.tables);
    }
    object
}

fn beam(of: &Beam) -> Value {
    let Strain { slenderness, rate, natural, pressed, .. } = &of.strain;
    let mut object = json!({
        "name": of.name, "radii_of_gyration": slenderness, "rate_rad_s": rate, "clamped_rad_s": natural
    });
    if let Some([thrust, euler]) = pressed {
        object["thrust_N"] = json!(thrust);
        object["euler_N"] = json!(euler);
    }
    object
}

fn repetition(of: &Repetition) -> Value {
    let Repetition { function, operations, statements, alike } = of;
    json!({ "function": function, "operations": operations, "statements": statements, "alike": alike })
}

fn reflected(of: &Reflected) -> Value {
    let [inertia, load] = if of.angular { ["inertia_kg_m2", "torque_N_m"] } else { ["mass_kg", "force_N"] };
    json!({ "name": of.of, inertia: of.inertia, load: of.load })
}

fn gives(of: &Gives) -> Value {
    let [along, around] = of.backlash;
    json!({
        "name": of.name,
        "mean_stiffness_N_m": of.stiffness,
        "reduced_mass_kg": of.mass,
        "frequency_Hz": of.hertz(),
        "backlash_m": along,
        "circumferential_backlash_m": around,
    })
}

fn mesh(of: &MeshOf) -> Value {
    let column = |of: Vec<f64>| Value::from(of);
    json!({
        "name": of.name,
        "mean_N_m": of.mean,
        "exact_N_m": column(of.places.iter().map(|(exact, ..)| *exact).collect()),
        "series_N_m": column(of.places.iter().map(|(_, series, _)| *series).collect()),
        "pairs": of.places.iter().map(|(.., pairs)| *pairs).collect::<Value>(),
        "left_out": of.left_out,
        "largest_step": of.step,
    })
}

fn teeth(pair: &Told) -> Value {
    json!({
        "name": pair.name,
        "of": pair.of,
        "teeth": pair.teeth,
        "distance_m": pair.distance,
        "working_angle_deg": pair.working_angle,
        "contact_ratio": pair.contact_ratio,
        "overlap_ratio": pair.overlap,
        "turns_until_the_same_teeth_meet": pair.hunting,
        "self_locking_friction": pair.locking,
    })
}
