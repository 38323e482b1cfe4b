//! `linkwright run`: a run as comma-separated values, with a summary of energy and constraints.

use super::format::Format;
use super::methods::{self, Course, EngineState};
use super::options::Study;
use super::progress::Progress;
use super::record::{Extremes, Group, Trajectory, columns};
use super::{Done, Failure, Loaded, arrow, laws, settings, short, start, write};
use crate::with_engine;
use linkwright_engine::Numbers;
use linkwright_runtime::SimulationError;
use serde_json::{Value, json};
use std::fmt::Write;
use std::time::Instant;

/// A run, and why it stopped if it did.
pub struct Run {
    pub trajectory: Trajectory,
    pub stopped: Option<SimulationError>,
    pub begun: Instant,
}

/// The command.
pub fn run(study: &Study, loaded: &Loaded) -> Result<Done, Failure> {
    let groups = groups(study, loaded);
    let run = recorded(study, loaded, &groups)?;
    let Run { trajectory, stopped, .. } = &run;
    let failed = stopped.is_some();
    if study.json {
        return Ok(Done { value: for_machines(study, loaded, &run), failed });
    }
    let out = study.out.as_deref();
    match Format::of(out) {
        Format::Arrow => write(out, arrow(study, loaded, trajectory)?)?,
        Format::Text | Format::Png => write(out, csv(trajectory))?,
    }
    eprint!("{}", summary(study, loaded, &run));
    Ok(Done { value: Value::Null, failed })
}

/// What is shown: outputs, or of a mechanism without any its state.
fn groups(study: &Study, loaded: &Loaded) -> Vec<Group> {
    let has_outputs = !loaded.compiled.mechanism.outputs.is_empty();
    let standard = if has_outputs { Group::Outputs } else { Group::State };
    study.show.clone().unwrap_or_else(|| vec![standard])
}

/// Runs and keeps these groups of columns.
pub fn recorded(study: &Study, loaded: &Loaded, groups: &[Group]) -> Result<Run, Failure> {
    let begun = Instant::now();
    let any = &loaded.engine;
    let laws = laws(loaded, study)?;
    let start = with_engine!(any, |engine| start(engine)?);
    let mut trajectory = Trajectory::new(columns(&loaded.compiled, groups));
    let (progress, duration, mut samples) = (Progress::new(), study.course.duration, 0_u32);
    let mut show = |time: f64, state: &EngineState, inputs: &Numbers, outputs: &Numbers| {
        samples = samples.wrapping_add(1);
        // The clock is not asked at every step.
        if samples.is_multiple_of(256) {
            let percent = 100.0 * time / duration;
            progress.say(|| format!("{percent:3.0} %, {} s of {} s", short(time), short(duration)));
        }
        with_engine!(any, |engine| trajectory.add(engine, groups, time, state, inputs, outputs));
    };
    let stopped = methods::run(any, &start, &laws, &study.course, &mut show).err();
    progress.end();
    match stopped {
        // Nothing has moved: the settings are wrong.
        Some(
            error @ (SimulationError::Setting(_)
            | SimulationError::Step { .. }
            | SimulationError::TooMany { .. }),
        ) if trajectory.times.len() <= 1 => Err(Failure::Motion(error.to_string())),
        stopped => Ok(Run { trajectory, stopped, begun }),
    }
}

fn arrow(study: &Study, loaded: &Loaded, trajectory: &Trajectory) -> Result<Vec<u8>, Failure> {
    let Course { step, formulation, integrator, .. } = &study.course;
    let about = [
        ("mechanism", loaded.name.clone()),
        ("step", format!("{step} s")),
        ("formulation", formulation.to_string()),
        ("integrator", integrator.to_string()),
        ("parameters", settings(loaded).to_string()),
    ];
    arrow::file(trajectory, &about).map_err(|why| Failure::Usage(format!("--out: no Arrow: {why}")))
}

/// A head with names and units, and a line for each sample. Numbers read back to the same bits.
pub fn csv(trajectory: &Trajectory) -> String {
    let mut text = String::with_capacity(24 * (trajectory.values.len() + trajectory.times.len()) + 256);
    text.push_str("time [s]");
    for column in &trajectory.columns {
        let _ = write!(text, ",{} [{}]", column.name, column.unit);
    }
    text.push('\n');
    for (time, row) in trajectory.times.iter().zip(trajectory.rows()) {
        let _ = write!(text, "{time}");
        for value in row {
            text.push(',');
            number(&mut text, *value);
        }
        text.push('\n');
    }
    text
}

/// Plain digits where they are few, else with an exponent.
pub fn number(text: &mut String, value: f64) {
    let size = value.abs();
    let _ = if size != 0.0 && !(1e-5..1e16).contains(&size) {
        write!(text, "{value:e}")
    } else {
        write!(text, "{value}")
    };
}

/// What a run was and what came of it, for people.
fn summary(study: &Study, loaded: &Loaded, run: &Run) -> String {
    let Run { trajectory, stopped, begun } = run;
    let Course { step, formulation, integrator, duration, .. } = &study.course;
    let Extremes { energy, energy_range, position, velocity } = trajectory.extremes;
    let end = trajectory.times.last().copied().unwrap_or_default();
    let mut text = String::new();
    let _ = writeln!(
        text,
        "{}: {} s in steps of {} s, {formulation}, {integrator}; {} samples, {} s of computing",
        loaded.name,
        short(end),
        short(*step),
        trajectory.times.len(),
        short((begun.elapsed().as_secs_f64() * 1e3).round() / 1e3),
    );
    let _ = writeln!(
        text,
        "energy: {} J at the start, {} J at the end, from {} J to {} J between",
        short(energy[0]),
        short(energy[1]),
        short(energy_range[0]),
        short(energy_range[1])
    );
    if !loaded.compiled.complete.equations.rows.is_empty() {
        let _ = writeln!(
            text,
            "constraints: at most {} off (at {} s), their rates {} (at {} s)",
            short(position[0]),
            short(position[1]),
            short(velocity[0]),
            short(velocity[1])
        );
    }
    if let Some(error) = stopped {
        let _ = writeln!(text, "stopped at {} s of {} s: {error}", short(end), short(*duration));
    }
    text
}

fn for_machines(study: &Study, loaded: &Loaded, run: &Run) -> Value {
    let Run { trajectory, stopped, .. } = run;
    let Extremes { energy, energy_range, position, velocity } = trajectory.extremes;
    let columns = trajectory
        .columns
        .iter()
        .map(|column| json!({ "name": column.name, "unit": column.unit, "group": column.group.text() }));
    let rows = trajectory.times.iter().zip(trajectory.rows());
    let rows = rows.map(|(time, row)| std::iter::once(time).chain(row).copied().collect::<Vec<f64>>());
    let end = trajectory.times.last().copied().unwrap_or_default();
    json!({
        "parameters": settings(loaded),
        "duration": study.course.duration,
        "step": study.course.step,
        "formulation": study.course.formulation.to_string(),
        "integrator": study.course.integrator.to_string(),
        "columns": columns.collect::<Vec<_>>(),
        "rows": rows.collect::<Vec<_>>(),
        "energy": { "start": energy[0], "end": energy[1], "least": energy_range[0], "largest": energy_range[1] },
        "constraints": {
            "position": { "largest": position[0], "time": position[1] },
            "velocity": { "largest": velocity[0], "time": velocity[1] },
        },
        "stopped": stopped.as_ref().map(|error| json!({ "time": end, "message": error.to_string() })),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_back() {
        for value in [0.0, 1.5, -2.25e-9, 1e300, 123456.789, 0.1 + 0.2, 1e-5, f64::MIN_POSITIVE] {
            let mut text = String::new();
            number(&mut text, value);
            assert_eq!(text.parse::<f64>().expect("a number").to_bits(), value.to_bits(), "{text}");
        }
        for (value, text) in
            [(0.001, "0.001"), (1234567.0, "1.23457e6"), (-2.5, "-2.5"), (1e-9, "1e-9"), (100.0, "100")]
        {
            assert_eq!(short(value), text);
        }
    }
}
