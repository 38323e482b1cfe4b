//! What is measured of a whole run: `max`, `mean` and so on of expressions of columns.

use super::expression::{Expression, call, pair};
use super::record::{Column, Group, Trajectory, columns};
use linkwright_compiler::Compiled;

/// What a measure may be of.
pub const GROUPS: [Group; 6] =
    [Group::Outputs, Group::Energy, Group::Residual, Group::Reactions, Group::Efforts, Group::Powers];

/// Functions of a whole run.
const MEASURES: [&str; 7] = ["max", "min", "mean", "rms", "range", "first", "last"];

/// The measures that were written, whose names are known.
pub fn measures(written: &[String], compiled: &Compiled) -> Result<Vec<Expression>, String> {
    let columns = columns(compiled, &GROUPS);
    let names: Vec<&str> = columns.iter().map(|column| column.name.as_str()).collect();
    let parsed = written.iter().map(|text| {
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

/// The value of a measure of a run.
pub fn value(measure: &Expression, run: &Trajectory) -> f64 {
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

/// The unit of an expression, where it is plain: of one quantity, or of sums of several with the same one.
pub fn unit(expression: &Expression, columns: &[Column]) -> Option<String> {
    match expression {
        Expression::Name(name) => {
            columns.iter().find(|column| column.name == *name).map(|column| column.unit.clone())
        }
        Expression::Negated(inner) => unit(inner, columns),
        Expression::Pair('+' | '-', operands) => {
            let [a, b] = [0, 1].map(|which| unit(&operands[which], columns));
            if a == b { a } else { None }
        }
        Expression::Call(name, arguments) if arguments.len() == 1 => {
            let keeps = MEASURES.contains(&name.as_str()) || name == "abs";
            unit(&arguments[0], columns).filter(|_| keeps)
        }
        Expression::Number(_) | Expression::Pair(..) | Expression::Call(..) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn measures_of_runs() {
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

    #[test]
    fn units_of_measures() {
        let column = |name: &str, unit: &str| Column {
            group: Group::Outputs,
            name: name.to_string(),
            unit: unit.to_string(),
            scale: 1.0,
        };
        let columns = [column("swing", "deg"), column("height", "mm"), column("width", "mm")];
        for (text, expected) in [
            ("max(swing) - min(swing)", Some("deg")),
            ("-mean(abs(height))", Some("mm")),
            ("max(height - width)", Some("mm")),
            ("max(height) - max(swing)", None),
            ("max(height) / max(width)", None),
            ("max(sin(swing))", None),
        ] {
            let expression = Expression::parse(text).expect(text);
            assert_eq!(unit(&expression, &columns).as_deref(), expected, "{text}");
        }
    }
}
