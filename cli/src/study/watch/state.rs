//! What the page of `watch` shows of a file as it stands: messages at their lines, or the drawing and the motion with the values of its sliders.

use super::request::Request;
use crate::input::Found;
use crate::study::animate::{film, page};
use crate::study::draw::pose;
use crate::study::options::Study;
use crate::study::{Failure, Loaded, load, one_definition, settings, start};
use crate::with_engine;
use linkwright_compiler::diagnostics::Severity;
use linkwright_compiler::model::Mechanism;
use linkwright_compiler::page::drawing_at;
use linkwright_compiler::source::Located;
use serde_json::{Value, json};

/// The file as it stands, with the values that the page asks for.
pub fn state(study: &Study, request: &Request) -> Value {
    let found = match one_definition(study) {
        Ok(found) => found,
        Err(message) => return json!({ "messages": [plain(&message)] }),
    };
    let shown = load(&found, study).and_then(|loaded| {
        let asked = with_values(study, request, &loaded.compiled.mechanism);
        let loaded = if asked.set.len() == study.set.len() { loaded } else { load(&found, &asked)? };
        Ok((show(&asked, &loaded)?, loaded))
    });
    match shown {
        Ok((mut state, loaded)) => {
            let warnings = loaded.warnings.iter().map(|warning| at_its_line(&found, warning));
            state["messages"] = warnings.collect();
            state
        }
        Err(Failure::Definition(errors)) => {
            json!({ "messages": errors.iter().map(|error| at_its_line(&found, error)).collect::<Vec<_>>() })
        }
        Err(other) => json!({ "messages": [plain(&other.text())] }),
    }
}

/// The study with the values of sliders and fields, but for those whose names have gone from the file.
fn with_values(study: &Study, request: &Request, mechanism: &Mechanism) -> Study {
    let mut asked = study.clone();
    for (name, value) in request.under("set.") {
        let is_known = mechanism.parameters.iter().any(|parameter| parameter.name.text == name);
        if let (true, Ok(value)) = (is_known, value.parse::<f64>()) {
            asked.set.push((name.to_string(), value));
        }
    }
    for (name, law) in request.under("input.") {
        if mechanism.inputs.iter().any(|input| input.name.text == name) {
            asked.inputs.retain(|written| name_of(written) != name);
            asked.inputs.push(format!("{name}={law}"));
        }
    }
    asked
}

/// Of `name=law`.
fn name_of(written: &str) -> &str {
    written.split_once('=').map_or("", |(name, _)| name.trim())
}

fn show(study: &Study, loaded: &Loaded) -> Result<Value, Failure> {
    let film = film(study, loaded)?;
    let drawing = with_engine!(&loaded.engine, |engine| {
        drawing_at(&loaded.compiled, &pose(engine, &start(engine)?))
    });
    let mut parameters = settings(loaded);
    let known = &loaded.compiled.mechanism.parameters;
    for (value, parameter) in parameters.as_array_mut().into_iter().flatten().zip(known) {
        let scale = parameter.unit.scale;
        value["default"] = Value::from(parameter.default / scale);
        value["bounds"] = json!(parameter.bounds.map(|(least, most)| [least / scale, most / scale]));
    }
    let mechanism = &loaded.compiled.mechanism;
    let inputs = mechanism.inputs.iter().map(|input| {
        let own = study.inputs.iter().find(|written| name_of(written) == input.name.text);
        let law = own.and_then(|written| written.split_once('=')).map_or("0", |(_, law)| law);
        json!({ "name": input.name.text, "unit": input.unit.text, "law": law })
    });
    Ok(json!({
        "name": loaded.name,
        "drawing": drawing.svg,
        "motion": page(study, loaded, &film),
        "parameters": parameters,
        "inputs": inputs.collect::<Vec<_>>(),
    }))
}

/// A message with the line that it is about.
fn at_its_line(found: &Found, message: &Located) -> Value {
    let place = |range: &std::ops::Range<usize>| {
        let at = found.source.position(range.start);
        let line = found.source.text.lines().nth(at.line - 1).unwrap_or_default();
        let width =
            found.source.text.get(range.clone()).and_then(|text| text.lines().next()).unwrap_or_default();
        json!({
            "file": found.source.name, "line": at.line, "column": at.column, "text": line,
            "width": width.chars().count().max(1),
        })
    };
    let notes = message.notes.iter().map(|(range, note)| json!({ "message": note, "at": place(range) }));
    json!({
        "severity": if message.severity == Severity::Error { "error" } else { "warning" },
        "message": message.message,
        "at": place(&message.range),
        "notes": notes.collect::<Vec<_>>(),
    })
}

/// A message that has no place.
fn plain(message: &str) -> Value {
    json!({ "severity": "error", "message": message, "notes": [] })
}
