//! `linkwright sweep`: a run for each value of a parameter, or for each pair of values of two, on all cores, and what is measured of each.

use super::expression::{Expression, unknown};
use super::heat_map::{Map, Side, heat_maps};
use super::measure::{GROUPS, measures, value};
use super::options::Study;
use super::picture::write_picture;
use super::plot::{Curve, picture_against};
use super::record::{Group, columns};
use super::runs::{on_all_cores, run_with};
use super::{Done, Failure, Loaded, laws, short, write};
use crate::with_engine;
use serde_json::{Value, json};
use std::fmt::Write;

/// Values of a parameter, in its unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Over {
    pub name: String,
    pub values: Vec<f64>,
}

impl Over {
    /// `name=from..to:count`.
    pub fn parse(text: &str) -> Result<Over, String> {
        let wrong =
            || format!("--over \"{text}\" is not `name=from..to:count`, such as crank_length=100..200:11");
        let (name, range) = text.split_once('=').ok_or_else(wrong)?;
        let (ends, count) = range.split_once(':').ok_or_else(wrong)?;
        let (from, to) = ends.split_once("..").ok_or_else(wrong)?;
        let number =
            |text: &str| text.trim().parse::<f64>().ok().filter(|it| it.is_finite()).ok_or_else(wrong);
        let (from, to) = (number(from)?, number(to)?);
        let count: u32 = count.trim().parse().map_err(|_| wrong())?;
        if !(2..=10_000).contains(&count) {
            return Err(format!("--over {name}: {count} values are asked for; there can be 2 to 10000"));
        }
        if from == to {
            return Err(format!(
                "--over {name}: both ends are {from}; write another, or --set {name}={from}"
            ));
        }
        let value = |k: u32| from + (to - from) * f64::from(k) / f64::from(count - 1);
        Ok(Over { name: name.trim().to_string(), values: (0..count).map(value).collect() })
    }
}

/// One run: the values of the parameters, and what was measured or why it failed.
struct Point {
    values: Vec<f64>,
    measured: Result<Vec<f64>, String>,
}

/// The command.
pub fn sweep(study: &Study, loaded: &Loaded) -> Result<Done, Failure> {
    if study.measures.is_empty() {
        let message = "sweep needs `--measure`, such as --measure 'max(swing)'".to_string();
        return Err(Failure::Usage(message));
    }
    let measures = measures(&study.measures, &loaded.compiled).map_err(Failure::Usage)?;
    let combined = combinations(study, loaded).map_err(Failure::Usage)?;
    let points = points(study, loaded, &measures, combined)?;
    let failed = points.iter().filter(|point| point.measured.is_err()).count();
    let value = json!({
        "over": study.over.iter().map(|over| &over.name).collect::<Vec<_>>(),
        "measures": study.measures,
        "points": points.iter().map(|point| match &point.measured {
            Ok(measured) => json!({ "values": point.values, "measured": measured, "failure": null }),
            Err(error) => json!({ "values": point.values, "measured": null, "failure": error }),
        }).collect::<Vec<Value>>(),
    });
    if study.svg && (!study.json || study.out.is_some()) {
        write_picture(study.out.as_deref(), &picture(study, loaded, &points))?;
    } else if !study.json {
        write(study.out.as_deref(), csv(study, loaded, &points))?;
    }
    if !study.json {
        eprintln!(
            "{}: {} runs of {} s, {failed} failed",
            loaded.name,
            points.len(),
            short(study.course.duration)
        );
    }
    Ok(Done { value, failed: failed > 0 })
}

/// All combinations of the values, the last parameter fastest.
fn combinations(study: &Study, loaded: &Loaded) -> Result<Vec<Vec<f64>>, String> {
    if study.over.is_empty() {
        return Err("sweep needs `--over`, such as --over crank_length=100..200:11".to_string());
    }
    let known = || loaded.compiled.mechanism.parameters.iter().map(|it| it.name.text.as_str());
    if let Some(over) = study.over.iter().find(|over| !known().any(|name| name == over.name)) {
        return Err(unknown("--over: no parameter is called", &over.name, known()));
    }
    if study.svg && study.over.len() > 2 {
        return Err("--svg is of one `--over` or two: more have no picture".to_string());
    }
    let mut all: Vec<Vec<f64>> = vec![Vec::new()];
    for over in &study.over {
        let with = |before: &Vec<f64>| {
            over.values.iter().map(|value| [&before[..], &[*value]].concat()).collect::<Vec<_>>()
        };
        all = all.iter().flat_map(with).collect();
    }
    Ok(all)
}

/// All runs, as many at a time as there are cores.
fn points(
    study: &Study,
    loaded: &Loaded,
    measures: &[Expression],
    combined: Vec<Vec<f64>>,
) -> Result<Vec<Point>, Failure> {
    let laws = laws(loaded, study)?;
    let columns = columns(&loaded.compiled, &GROUPS);
    let known = &loaded.compiled.mechanism.parameters;
    let places: Vec<(usize, f64)> = study
        .over
        .iter()
        .filter_map(|over| known.iter().position(|it| it.name.text == over.name))
        .map(|index| (index, known[index].unit.scale))
        .collect();
    let found = on_all_cores(&loaded.engine, combined.len(), &|engine, index| {
        let mut parameters = with_engine!(engine, |engine| engine.parameters().to_vec());
        let values = places.iter().zip(&combined[index]);
        values.for_each(|((place, scale), value)| parameters[*place] = value * scale);
        let run = run_with(engine, &parameters, &laws, &study.course, &columns)?;
        Ok(measures.iter().map(|measure| value(measure, &run)).collect())
    });
    let point = |(values, measured)| Point { values, measured };
    Ok(combined.into_iter().zip(found).map(point).collect())
}

/// Measures against the parameter, or in colours over both of them.
fn picture(study: &Study, loaded: &Loaded, points: &[Point]) -> String {
    let of = |index: usize| {
        points.iter().map(|point| point.measured.as_ref().map_or(f64::NAN, |it| it[index])).collect()
    };
    let sides: Vec<Side> = study
        .over
        .iter()
        .map(|over| Side { name: &over.name, unit: unit(loaded, over), values: over.values.clone() })
        .collect();
    let measures = study.measures.iter().enumerate();
    match &sides[..] {
        [across, upward] => {
            let maps: Vec<Map> = measures.map(|(index, name)| Map { name, values: of(index) }).collect();
            heat_maps(&loaded.name, [across, upward], &maps)
        }
        sides => {
            let curve = |(index, name): (usize, &String)| Curve {
                name: name.clone(),
                unit: String::new(),
                group: Group::Outputs,
                values: of(index),
            };
            let curves: Vec<Curve> = measures.map(curve).collect();
            let axis =
                sides.first().map_or(("", "", &[][..]), |side| (side.name, side.unit, &side.values[..]));
            picture_against(&loaded.name, axis, &curves, &[])
        }
    }
}

/// The unit of a parameter.
fn unit<'l>(loaded: &'l Loaded, over: &Over) -> &'l str {
    let known = &loaded.compiled.mechanism.parameters;
    known.iter().find(|it| it.name.text == over.name).map_or("1", |it| it.unit.text.as_str())
}

/// A line for each run; of a failed one its message in the last column.
fn csv(study: &Study, loaded: &Loaded, points: &[Point]) -> String {
    let head = study.over.iter().map(|over| format!("{} [{}]", over.name, unit(loaded, over)));
    let measures = study.measures.iter().map(|measure| format!("\"{}\"", measure.replace('"', "\"\"")));
    let head: Vec<String> = head.chain(measures).chain(["failure".to_string()]).collect();
    let mut text = head.join(",") + "\n";
    for Point { values, measured } in points {
        let mut cells: Vec<String> = values.iter().map(|value| format!("{}", tidy(*value))).collect();
        match measured {
            Ok(measured) => {
                cells.extend(measured.iter().map(|value| format!("{value}")));
                cells.push(String::new());
            }
            Err(error) => {
                cells.extend(study.measures.iter().map(|_| String::new()));
                cells.push(format!("\"{}\"", error.replace('"', "\"\"")));
            }
        }
        let _ = writeln!(text, "{}", cells.join(","));
    }
    text
}

fn tidy(value: f64) -> f64 {
    format!("{value:.11e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges() {
        let over = Over::parse("l=0.2..0.5:4").expect("it is one");
        assert_eq!(over.values.iter().map(|value| tidy(*value)).collect::<Vec<_>>(), [0.2, 0.3, 0.4, 0.5]);
        for text in ["l", "l=1..2", "l=1:3", "l=a..2:3", "l=1..2:1", "l=1..2:x", "l=2..2:3"] {
            assert!(Over::parse(text).is_err(), "{text}");
        }
    }
}
