//! `linkwright sweep`: a run for each value of a parameter, or for each pair of values of two, on all cores, and what is measured of each.

use super::expression::{Expression, call, pair, unknown};
use super::methods::{self, AnyEngine, EngineState};
use super::options::Study;
use super::record::{Group, Trajectory, columns};
use super::{Done, Failure, Loaded, laws, short, start, write};
use crate::with_engine;
use linkwright_engine::Numbers;
use serde_json::{Value, json};
use std::fmt::Write;
use std::sync::atomic::{AtomicUsize, Ordering};

/// What a measure may be of.
const GROUPS: [Group; 6] =
    [Group::Outputs, Group::Energy, Group::Residual, Group::Reactions, Group::Efforts, Group::Powers];

/// Functions of a whole run.
const MEASURES: [&str; 7] = ["max", "min", "mean", "rms", "range", "first", "last"];

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
    let measures = measures(study, loaded).map_err(Failure::Usage)?;
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
    if !study.json {
        write(study.out.as_deref(), &csv(study, loaded, &points))?;
        eprintln!(
            "{}: {} runs of {} s, {failed} failed",
            loaded.name,
            points.len(),
            short(study.course.duration)
        );
    }
    Ok(Done { value, failed: failed > 0 })
}

/// The measures, whose names are known.
fn measures(study: &Study, loaded: &Loaded) -> Result<Vec<Expression>, String> {
    if study.measures.is_empty() {
        return Err("sweep needs `--measure`, such as --measure 'max(swing)'".to_string());
    }
    let columns = columns(&loaded.compiled, &GROUPS);
    let names: Vec<&str> = columns.iter().map(|column| column.name.as_str()).collect();
    let parsed = study.measures.iter().map(|text| {
        let expression = Expression::parse(text).map_err(|error| format!("--measure: {error}"))?;
        check(&expression, &names).map_err(|error| format!("--measure: {error}"))?;
        Ok(expression)
    });
    parsed.collect()
}

/// Columns stand in functions of whole runs, and nothing else has to do with runs.
fn check(expression: &Expression, names: &[&str]) -> Result<(), String> {
    match expression {
        Expression::Call(name, arguments) if arguments.len() == 1 && MEASURES.contains(&name.as_str()) => {
            arguments[0].check(names, &[])
        }
        Expression::Name(name) if names.contains(&name.as_str()) => Err(format!(
            "`{name}` has many values in a run: write max({name}), or min, mean, rms, range, first, last"
        )),
        Expression::Name(_) | Expression::Number(_) => expression.check(&[], &[]),
        Expression::Negated(inner) => check(inner, names),
        Expression::Pair(_, operands) => operands.iter().try_for_each(|operand| check(operand, names)),
        Expression::Call(name, arguments) => {
            arguments.iter().try_for_each(|argument| check(argument, names))?;
            let numbers = vec![Expression::Number(0.0); arguments.len()];
            Expression::Call(name.clone(), numbers).check(&[], &MEASURES)
        }
    }
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
    let next = AtomicUsize::new(0);
    let (combined, columns, laws, next, places) = (&combined, &columns, &laws, &next, &places);
    let one = |engine: &AnyEngine, values: &[f64]| -> Result<Vec<f64>, String> {
        let mut parameters = with_engine!(engine, |engine| engine.parameters().to_vec());
        places.iter().zip(values).for_each(|((index, scale), value)| parameters[*index] = value * scale);
        let said = |error: linkwright_runtime::SettingError| error.to_string();
        let engine = match engine {
            AnyEngine::Plain(engine) => AnyEngine::Plain(engine.prepared(&parameters).map_err(said)?),
            AnyEngine::Implicit(engine) => AnyEngine::Implicit(engine.prepared(&parameters).map_err(said)?),
        };
        let begin = with_engine!(&engine, |engine| start(engine)).map_err(Failure::text)?;
        let mut trajectory = Trajectory::new(columns.clone());
        let mut show = |time: f64, state: &EngineState, inputs: &Numbers, outputs: &Numbers| {
            with_engine!(&engine, |engine| trajectory.add(engine, &GROUPS, time, state, inputs, outputs));
        };
        methods::run(&engine, &begin, laws, &study.course, &mut show).map_err(|error| error.to_string())?;
        Ok(measures.iter().map(|measure| value(measure, &trajectory)).collect())
    };
    let cores = std::thread::available_parallelism().map_or(1, usize::from).min(combined.len().max(1));
    let mut found: Vec<(usize, Result<Vec<f64>, String>)> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..cores)
            .map(|_| {
                let engine = loaded.engine.clone();
                let one = &one;
                scope.spawn(move || {
                    let mut own = Vec::new();
                    loop {
                        let index = next.fetch_add(1, Ordering::Relaxed);
                        let Some(values) = combined.get(index) else { return own };
                        own.push((index, one(&engine, values)));
                    }
                })
            })
            .collect();
        threads.into_iter().flat_map(|thread| thread.join().unwrap_or_default()).collect()
    });
    found.sort_by_key(|(index, _)| *index);
    let point = |(index, measured): (usize, _)| Point { values: combined[index].clone(), measured };
    Ok(found.into_iter().map(point).collect())
}

/// The value of a measure of a run.
fn value(measure: &Expression, run: &Trajectory) -> f64 {
    match measure {
        Expression::Call(name, arguments) if arguments.len() == 1 && MEASURES.contains(&name.as_str()) => {
            let index = |name: &str| run.columns.iter().position(|column| column.name == name);
            let rows = run.rows().map(|row| arguments[0].value(&|name| index(name).map(|index| row[index])));
            of_run(name, &run.times, &rows.collect::<Vec<f64>>())
        }
        Expression::Negated(inner) => -value(inner, run),
        Expression::Pair(sign, operands) => pair(*sign, value(&operands[0], run), value(&operands[1], run)),
        Expression::Call(name, arguments) => {
            call(name, &arguments.iter().map(|argument| value(argument, run)).collect::<Vec<_>>())
        }
        Expression::Number(_) | Expression::Name(_) => measure.value(&|_| None),
    }
}

/// Means are over time, by trapezoids between samples.
fn of_run(name: &str, times: &[f64], values: &[f64]) -> f64 {
    let least = || values.iter().copied().fold(f64::INFINITY, f64::min);
    let most = || values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let mean = |of: fn(f64) -> f64| {
        let area: f64 = times
            .windows(2)
            .zip(values.windows(2))
            .map(|(t, x)| 0.5 * (t[1] - t[0]) * (of(x[0]) + of(x[1])))
            .sum();
        area / (times[times.len() - 1] - times[0])
    };
    match name {
        "max" => most(),
        "min" => least(),
        "mean" => mean(|x| x),
        "rms" => mean(|x| x * x).sqrt(),
        "range" => most() - least(),
        "first" => values[0],
        _ => values[values.len() - 1],
    }
}

/// A line for each run; of a failed one its message in the last column.
fn csv(study: &Study, loaded: &Loaded, points: &[Point]) -> String {
    let known = &loaded.compiled.mechanism.parameters;
    let head = study.over.iter().map(|over| {
        let unit = known.iter().find(|it| it.name.text == over.name).map_or("1", |it| it.unit.text.as_str());
        format!("{} [{unit}]", over.name)
    });
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
    fn ranges_and_measures() {
        let over = Over::parse("l=0.2..0.5:4").expect("it is one");
        assert_eq!(over.values.iter().map(|value| tidy(*value)).collect::<Vec<_>>(), [0.2, 0.3, 0.4, 0.5]);
        for text in ["l", "l=1..2", "l=1:3", "l=a..2:3", "l=1..2:1", "l=1..2:x"] {
            assert!(Over::parse(text).is_err(), "{text}");
        }
        let (times, values) = ([0.0, 1.0, 3.0], [0.0, 2.0, 2.0]);
        for (name, expected) in
            [("max", 2.0), ("min", 0.0), ("range", 2.0), ("mean", 5.0 / 3.0), ("first", 0.0), ("last", 2.0)]
        {
            assert!((of_run(name, &times, &values) - expected).abs() < 1e-12, "{name}");
        }
        let check = |text: &str| check(&Expression::parse(text).expect(text), &["swing"]);
        assert_eq!(check("max(swing) - 2 * min(abs(swing))"), Ok(()));
        assert!(check("swing").unwrap_err().contains("write max(swing)"));
        assert!(check("max(swign)").unwrap_err().contains("did you mean `swing`?"));
        assert!(check("maxx(swing)").is_err());
    }
}
