//! The influence of parameters along a run: at each sample the exact derivatives of outputs, the coordinates held there.

use super::exact::Exact;
use super::table::quotient;
use super::{Parameter, wanted};
use crate::study::methods::{self, EngineState};
use crate::study::options::Study;
use crate::study::plot::{Curve, picture_against};
use crate::study::record::{Column, Group, columns};
use crate::study::run::number;
use crate::study::{Done, Failure, Loaded, laws, short, start, write};
use crate::with_engine;
use linkwright_engine::Numbers;
use serde_json::{Value, json};
use std::fmt::Write;

/// So many samples if nothing is said.
const SAMPLES: f64 = 600.0;

/// What is known at a sample.
struct Sample {
    time: f64,
    /// All outputs, in their units.
    outputs: Vec<f64>,
    /// Of each wanted output, then of each parameter, in their units; no number where the coordinates do not move the whole.
    slopes: Vec<f64>,
}

/// The command with `--along`.
pub fn along(study: &Study, loaded: &Loaded, by: &[Parameter]) -> Result<Done, Failure> {
    let usage = |message: &str| Err(Failure::Usage(message.to_string()));
    if !study.measures.is_empty() {
        return usage("--along is of outputs: a measure is one number of a whole run, leave --along out");
    }
    let wanted = wanted(study, loaded).map_err(Failure::Usage)?;
    if let Some(other) = wanted.iter().find(|column| column.group != Group::Outputs) {
        return Err(Failure::Usage(format!(
            "--along is of outputs, and `{}` is none: declare an output for it, or leave --along out",
            other.name
        )));
    }
    let outputs = columns(&loaded.compiled, &[Group::Outputs]);
    let against = match &study.against {
        None => None,
        Some(name) => {
            let names = outputs.iter().map(|column| column.name.as_str());
            let index = outputs.iter().position(|column| column.name == *name);
            let message = || super::unknown("--against: there is no output", name, names);
            Some(index.ok_or_else(|| Failure::Usage(message()))?)
        }
    };
    let mut course = study.course.clone();
    course.every.get_or_insert(((course.duration / SAMPLES / course.step).round().max(1.0)) * course.step);
    let laws = laws(loaded, study)?;
    let begin = with_engine!(&loaded.engine, |engine| start(engine)?);
    let mut exact = Exact::of(loaded)?;
    let held = exact.held();
    let places: Vec<usize> = wanted
        .iter()
        .filter_map(|column| outputs.iter().position(|known| known.name == column.name))
        .collect();
    let mut samples: Vec<Sample> = Vec::new();
    let mut missing: Option<(usize, f64, String)> = None;
    let mut show = |time: f64, state: &EngineState, inputs: &Numbers, values: &Numbers| {
        let found = exact.at(time, state, inputs, by);
        if let Some(Err(message)) = found.iter().find(|slopes| slopes.is_err()) {
            missing.get_or_insert((0, time, message.clone())).0 += 1;
        }
        let slope = |place: &usize, k: usize| match &found[k] {
            Ok(slopes) => slopes[*place] * by[k].scale / outputs[*place].scale,
            Err(_) => f64::NAN,
        };
        let slopes = places.iter().flat_map(|place| (0..by.len()).map(move |k| (place, k)));
        samples.push(Sample {
            time,
            outputs: values.as_slice().iter().zip(&outputs).map(|(value, it)| value / it.scale).collect(),
            slopes: slopes.map(|(place, k)| slope(place, k)).collect(),
        });
    };
    let stopped = methods::run(&loaded.engine, &begin, &laws, &course, &mut show).err();
    let stopped = stopped.map(|error| error.to_string());
    if let (true, Some(message)) = (samples.len() <= 1, &stopped) {
        return Err(Failure::Motion(message.clone()));
    }
    let of = Columns { wanted: &wanted, by };
    if !study.json || study.out.is_some() {
        let text = if study.svg {
            let axis =
                against.map(|index| (&outputs[index], samples.iter().map(|it| it.outputs[index]).collect()));
            of.svg(loaded, axis, &samples)
        } else {
            of.csv(&places, &samples)
        };
        write(study.out.as_deref(), &text)?;
    }
    if !study.json {
        if let Some((count, time, message)) = &missing {
            eprintln!(
                "at {count} of {} samples there is no derivative, first at {} s: {message}",
                samples.len(),
                short(*time)
            );
        }
        if let Some(message) = &stopped {
            let end = samples.last().map_or(0.0, |sample| sample.time);
            eprintln!("stopped at {} s of {} s: {message}", short(end), short(course.duration));
        }
    }
    let rows = samples
        .iter()
        .map(|it| std::iter::once(it.time).chain(it.slopes.iter().copied()).collect::<Vec<f64>>());
    let value = json!({
        "held": held,
        "columns": of.names().map(|(name, unit)| json!({ "name": name, "unit": unit })).collect::<Vec<Value>>(),
        "rows": rows.collect::<Vec<_>>(),
        "missing": missing.as_ref().map(|(count, time, message)| json!({ "samples": count, "time": time, "message": message })),
        "stopped": stopped,
    });
    Ok(Done { value, failed: stopped.is_some() })
}

struct Columns<'c> {
    wanted: &'c [Column],
    by: &'c [Parameter],
}

impl Columns<'_> {
    /// Name and unit of each derivative.
    fn names(&self) -> impl Iterator<Item = (String, String)> {
        self.wanted.iter().flat_map(|column| {
            self.by.iter().map(|parameter| {
                (format!("{} by {}", column.name, parameter.name), quotient(&column.unit, &parameter.unit))
            })
        })
    }

    fn csv(&self, places: &[usize], samples: &[Sample]) -> String {
        let mut text = "time [s]".to_string();
        for column in self.wanted {
            let _ = write!(text, ",{} [{}]", column.name, column.unit);
        }
        for (name, unit) in self.names() {
            let _ = write!(text, ",{name} [{unit}]");
        }
        text.push('\n');
        for sample in samples {
            let _ = write!(text, "{}", sample.time);
            let values = places.iter().map(|place| sample.outputs[*place]);
            for value in values.chain(sample.slopes.iter().copied()) {
                text.push(',');
                if value.is_finite() {
                    number(&mut text, value);
                }
            }
            text.push('\n');
        }
        text
    }

    /// A panel for each output and parameter: what one percent more of the parameter does, so that parameters of different units can be
    /// compared; of a parameter that is zero the derivative.
    fn svg(&self, loaded: &Loaded, axis: Option<(&Column, Vec<f64>)>, samples: &[Sample]) -> String {
        let curves = self.names().enumerate().map(|(index, (name, unit))| {
            let (column, parameter) = (&self.wanted[index / self.by.len()], &self.by[index % self.by.len()]);
            let values = samples.iter().map(|sample| sample.slopes[index]);
            let (name, unit, factor) = if parameter.value == 0.0 {
                (name, unit, 1.0)
            } else {
                let name = format!("{} for +1 % of {}", column.name, parameter.name);
                (name, column.unit.clone(), 0.01 * parameter.value)
            };
            Curve {
                name: name.replace('_', " "),
                unit,
                group: Group::Outputs,
                values: values.map(|it| factor * it).collect(),
            }
        });
        let curves: Vec<Curve> = curves.collect();
        let times = || samples.iter().map(|sample| sample.time).collect();
        let (name, unit, values) = match axis {
            None => ("time".to_string(), "s", times()),
            Some((column, values)) => (column.name.replace('_', " "), column.unit.as_str(), values),
        };
        picture_against(&loaded.name, (&name, unit, &values), &curves)
    }
}
