//! The influence of parameters along a run: at each sample the exact derivatives of outputs, the coordinates held there.

use super::exact::Exact;
use super::table::quotient;
use super::{Parameter, wanted};
use crate::study::methods::{self, EngineState};
use crate::study::options::Study;
use crate::study::picture::write_picture;
use crate::study::plot::{Curve, picture_against};
use crate::study::record::{Column, Group, columns};
use crate::study::run::number;
use crate::study::{Done, Failure, Loaded, laws, short, start, write};
use crate::with_engine;
use linkwright_engine::Numbers;
use serde_json::{Value, json};
use std::fmt::Write;

/// Of what the others do: rounding.
const NOTHING: f64 = 1e-12;
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
        if study.svg {
            let axis =
                against.map(|index| (&outputs[index], samples.iter().map(|it| it.outputs[index]).collect()));
            write_picture(study.out.as_deref(), &of.svg(loaded, axis, &places, &samples)?)?;
        } else {
            write(study.out.as_deref(), of.csv(&places, &samples))?;
        }
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

    /// A panel for each output and each parameter that does something to it: what one percent more of the parameter does, on one scale for
    /// all parameters of an output, so that they can be compared; of a parameter that is zero the derivative.
    fn svg(
        &self,
        loaded: &Loaded,
        axis: Option<(&Column, Vec<f64>)>,
        places: &[usize],
        samples: &[Sample],
    ) -> Result<String, Failure> {
        let (mut curves, mut ranges) = (Vec::new(), Vec::new());
        for (which, place) in places.iter().enumerate() {
            let of = samples.iter().map(|sample| sample.outputs[*place]);
            self.panels(which, extremes(of), samples, &mut curves, &mut ranges);
        }
        if curves.is_empty() {
            let names: Vec<&str> = self.wanted.iter().map(|column| column.name.as_str()).collect();
            let message = format!("no parameter does anything to {} along the run", names.join(", "));
            return Err(Failure::Motion(message));
        }
        let times = || samples.iter().map(|sample| sample.time).collect();
        let (name, unit, values) = match axis {
            None => ("time".to_string(), "s", times()),
            Some((column, values)) => (column.name.replace('_', " "), column.unit.as_str(), values),
        };
        Ok(picture_against(&loaded.name, (&name, unit, &values), &curves, &ranges))
    }

    /// Those of one output, whose own values are from `least` to `most`.
    fn panels(
        &self,
        which: usize,
        [least, most]: [f64; 2],
        samples: &[Sample],
        curves: &mut Vec<Curve>,
        ranges: &mut Vec<Option<[f64; 2]>>,
    ) {
        let (column, count) = (&self.wanted[which], self.by.len());
        let is_whole = |k: usize| self.by[k].value != 0.0;
        let values = |k: usize| -> Vec<f64> {
            let factor = if is_whole(k) { 0.01 * self.by[k].value } else { 1.0 };
            samples.iter().map(|sample| factor * sample.slopes[which * count + k]).collect()
        };
        let all: Vec<Vec<f64>> = (0..count).map(values).collect();
        let compared = (0..count).filter(|k| is_whole(*k)).flat_map(|k| all[k].iter().copied());
        let range = extremes(compared.chain([0.0]));
        let rounding = NOTHING * (range[1] - range[0]).max(most - least);
        for (k, values) in all.into_iter().enumerate() {
            let [least, most] = extremes(values.iter().copied());
            if most.max(-least) <= rounding {
                continue;
            }
            let parameter = &self.by[k];
            let (name, unit) = if is_whole(k) {
                (format!("{} for +1 % of {}", column.name, parameter.name), column.unit.clone())
            } else {
                (format!("{} by {}", column.name, parameter.name), quotient(&column.unit, &parameter.unit))
            };
            curves.push(Curve { name: name.replace('_', " "), unit, group: Group::Outputs, values });
            ranges.push(is_whole(k).then_some(range));
        }
    }
}

/// Least and most of what is finite; zeros where nothing is.
fn extremes(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let found = values.filter(|value| value.is_finite()).fold(None, |found: Option<[f64; 2]>, value| {
        let [least, most] = found.unwrap_or([value, value]);
        Some([least.min(value), most.max(value)])
    });
    found.unwrap_or_default()
}
