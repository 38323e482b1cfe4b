//! `linkwright draw`: the drawing of a mechanism at its start.

use super::methods::EngineState;
use super::options::Study;
use super::picture::write_picture;
use super::{Done, Failure, Loaded};
use crate::with_engine;
use linkwright_compiler::page::{Pose, alone, dimensioned_at, drawing_at};
use linkwright_engine::Engine;
use linkwright_runtime::Vector;
use serde_json::json;

/// The command.
pub fn draw(study: &Study, loaded: &Loaded) -> Result<Done, Failure> {
    let drawn = if study.dimensions { dimensioned_at } else { drawing_at };
    let drawing = with_engine!(&loaded.engine, |engine| {
        drawn(&loaded.compiled, &pose(engine, &super::start(engine)?))
    });
    let picture = || format!("{}\n", alone(&drawing.svg));
    if !study.json {
        write_picture(study.out.as_deref(), &picture())?;
        if drawing.left_out > 0 {
            let names = if drawing.left_out == 1 { "name" } else { "names" };
            eprintln!("{}: {} {names} found no place in the drawing", loaded.name, drawing.left_out);
        }
        if study.dimensions && drawing.dimensions == 0 {
            eprintln!("{}: no body has two joints that turn, so there are no dimensions", loaded.name);
        }
        if !drawing.without_place.is_empty() {
            let which = drawing.without_place.join(", ");
            eprintln!("{}: no place in the drawing for the dimensions {which}", loaded.name);
        }
    } else if let Some(out) = &study.out {
        write_picture(Some(out), &picture())?;
    }
    let mut value = json!({ "svg": drawing.svg, "left_out": drawing.left_out });
    if study.dimensions {
        value["dimensions"] = json!({ "count": drawing.dimensions, "without_place": drawing.without_place });
    }
    Ok(Done { value, failed: false })
}

/// Where a mechanism stands at its start.
pub fn pose<D: 'static>(engine: &Engine<D>, start: &EngineState) -> Pose {
    Pose {
        parameters: engine.parameters().to_vec(),
        phases: engine.phases().to_vec(),
        time: 0.0,
        q: start.q.as_slice().to_vec(),
        v: start.v.as_slice().to_vec(),
        internal: start.z.as_slice().to_vec(),
    }
}
