//! The influences on one quantity as a table for people, as comma-separated values, and for machines.

use super::differences::{How, Slope};
use super::{Loaded, Parameter, short};
use crate::study::options::Study;
use serde_json::{Value, json};
use std::fmt::Write;

/// Of the largest: what is rounding of an exact derivative, and of one by differences.
const NOTHING: [f64; 2] = [1e-12, 1e-9];

/// A quantity and what each parameter does to it.
pub struct Table {
    pub of: String,
    /// Where it is plain.
    pub unit: Option<String>,
    pub value: f64,
    /// A measure of a run, else at the start.
    pub of_run: bool,
    pub lines: Vec<Line>,
}

/// What one parameter does, in the units of quantity and parameter.
pub struct Line {
    /// In the list of those asked for.
    pub parameter: usize,
    pub slope: Result<Slope, String>,
}

impl Table {
    /// p ∂y/∂p, what the parameter does as a whole; 0 where there is no derivative.
    fn whole(&self, line: &Line, by: &[Parameter]) -> f64 {
        line.slope.as_ref().map_or(0.0, |slope| slope.value * by[line.parameter].value)
    }

    fn largest(&self, by: &[Parameter]) -> f64 {
        self.lines.iter().fold(0.0, |largest, line| f64::max(largest, self.whole(line, by).abs()))
    }

    /// Whether a parameter does nothing, as far as numbers tell.
    fn is_nothing(&self, line: &Line, by: &[Parameter]) -> bool {
        let Ok(slope) = &line.slope else { return false };
        let parameter = &by[line.parameter];
        let change = if parameter.value == 0.0 { parameter.step / parameter.scale } else { parameter.value };
        let whole = (slope.value.abs() + slope.error) * change.abs();
        let rounding = if slope.how == How::Exact { NOTHING[0] } else { NOTHING[1] };
        whole <= rounding * self.largest(by).max(self.value.abs())
    }

    /// What +1 % of the parameter does; nothing is a percent of zero.
    fn of_percent(&self, line: &Line, by: &[Parameter]) -> Option<f64> {
        (line.slope.is_ok() && by[line.parameter].value != 0.0).then(|| 0.01 * self.whole(line, by))
    }

    /// p/y ∂y/∂p; there is none where the quantity is zero.
    fn relative(&self, line: &Line, by: &[Parameter]) -> Option<f64> {
        let is_zero = self.value.abs() <= 1e-9 * self.largest(by);
        self.of_percent(line, by).filter(|_| !is_zero).map(|change| 100.0 * change / self.value)
    }

    /// The most influential first, those without a derivative and those without influence last.
    fn sorted(&self, by: &[Parameter]) -> Vec<&Line> {
        let mut lines: Vec<&Line> = self.lines.iter().collect();
        let rank = |line: &Line| match (&line.slope, self.is_nothing(line, by)) {
            (_, true) => 3,
            (Err(_), _) => 2,
            (Ok(_), _) if by[line.parameter].value == 0.0 => 1,
            (Ok(_), _) => 0,
        };
        lines.sort_by(|a, b| {
            let size = |line: &Line| if rank(line) == 3 { 0.0 } else { self.whole(line, by).abs() };
            rank(a).cmp(&rank(b)).then(size(b).total_cmp(&size(a)))
        });
        lines
    }

    fn unit(&self) -> &str {
        self.unit.as_deref().unwrap_or("1")
    }

    pub fn for_machines(&self, by: &[Parameter]) -> Value {
        let line = |line: &&Line| {
            let parameter = &by[line.parameter];
            let slope = line.slope.as_ref();
            json!({
                "name": parameter.name,
                "value": parameter.value,
                "unit": parameter.unit,
                "derivative": slope.ok().map(|slope| slope.value),
                "derivative_unit": self.unit.as_ref().map(|unit| quotient(unit, &parameter.unit)),
                "error": slope.ok().map(|slope| slope.error),
                "of_one_percent": self.of_percent(line, by),
                "relative": self.relative(line, by),
                "how": slope.ok().map(|slope| slope.how.text()),
                "failure": slope.err(),
            })
        };
        json!({
            "of": self.of,
            "value": self.value,
            "unit": self.unit,
            "at": if self.of_run { "run" } else { "start" },
            "parameters": self.sorted(by).iter().map(line).collect::<Vec<Value>>(),
        })
    }
}

/// `deg/mm`, `1/(N*m)`, `(m/s)/mm`.
pub fn quotient(of: &str, by: &str) -> String {
    let of = if of.contains('/') && by != "1" { format!("({of})") } else { of.to_string() };
    match by {
        "1" => of,
        by if by.contains(['*', '/']) => format!("{of}/({by})"),
        by => format!("{of}/{by}"),
    }
}

/// A number with its unit.
fn with_unit(value: f64, unit: &str) -> String {
    if unit == "1" { short(value) } else { format!("{} {unit}", short(value)) }
}

/// All tables for people.
pub fn text(study: &Study, loaded: &Loaded, tables: &[Table], held: &[String], by: &[Parameter]) -> String {
    let mut text = String::new();
    let mut said = None;
    for table in tables {
        if said != Some(table.of_run) {
            said = Some(table.of_run);
            let space = if text.is_empty() { "" } else { "\n" };
            let when = match (table.of_run, held) {
                (true, _) => format!("in a run of {} s", short(study.course.duration)),
                (false, []) => "at the start".to_string(),
                (false, [one]) => format!("at the start, {one} and its rate held"),
                (false, several) => format!("at the start, {} and their rates held", several.join(", ")),
            };
            let _ = writeln!(text, "{space}{} {when}", loaded.name);
        }
        let _ = writeln!(text, "\n{} = {}", table.of, with_unit(table.value, table.unit()));
        one(&mut text, table, by);
    }
    text
}

fn one(text: &mut String, table: &Table, by: &[Parameter]) {
    let (nothing, lines): (Vec<&Line>, Vec<&Line>) =
        table.sorted(by).into_iter().partition(|line| table.is_nothing(line, by));
    let none = || "-".to_string();
    let mut rows =
        vec![["parameter", "value", "derivative", "for +1 %", "relative", "how"].map(str::to_string)];
    let mut failures = Vec::new();
    for line in &lines {
        let parameter = &by[line.parameter];
        let value = with_unit(parameter.value, &parameter.unit);
        match &line.slope {
            Ok(slope) => {
                let unit = quotient(table.unit(), &parameter.unit);
                let unit = if unit == "1" { String::new() } else { format!(" {unit}") };
                let error = match slope.how {
                    How::Exact => String::new(),
                    _ => format!(" ± {}", rough(slope.error)),
                };
                rows.push([
                    parameter.name.clone(),
                    value,
                    format!("{}{error}{unit}", short(slope.value)),
                    table.of_percent(line, by).map_or_else(none, |change| with_unit(change, table.unit())),
                    table.relative(line, by).map_or_else(none, short),
                    slope.how.text().to_string(),
                ]);
            }
            Err(message) => failures.push((parameter, value, message)),
        }
    }
    if rows.len() > 1 {
        let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
        let widths: Vec<usize> = (0..6).map(width).collect();
        for row in &rows {
            let cells: Vec<String> =
                row.iter().zip(&widths).map(|(cell, width)| format!("{cell:<width$}")).collect();
            let _ = writeln!(text, "  {}", cells.join("  ").trim_end());
        }
    }
    for (parameter, value, message) in failures {
        let _ = writeln!(text, "  {} = {value}: {message}", parameter.name);
    }
    if !nothing.is_empty() {
        let names: Vec<&str> = nothing.iter().map(|line| by[line.parameter].name.as_str()).collect();
        let _ = writeln!(text, "  no influence: {}", names.join(", "));
    }
    if rows.iter().skip(1).any(|row| row[4] == "-") {
        let why = match lines.iter().any(|line| by[line.parameter].value != 0.0) {
            true if table.value.abs() <= 1e-9 * table.largest(by) => {
                "the quantity is zero, and nothing is a part of it"
            }
            _ => "a parameter that is zero has no percent",
        };
        let _ = writeln!(text, "  -: {why}");
    }
}

/// One digit.
fn rough(error: f64) -> String {
    if error == 0.0 { "0".to_string() } else { format!("{error:.0e}") }
}

/// All tables, a line for each quantity and parameter.
pub fn csv(tables: &[Table], by: &[Parameter]) -> String {
    let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
    let number = |value: Option<f64>| value.map_or(String::new(), |value| value.to_string());
    let mut text =
        "of,quantity,unit,parameter,value,unit,derivative,error,for 1 %,relative,how,failure\n".to_string();
    for table in tables {
        for line in table.sorted(by) {
            let parameter = &by[line.parameter];
            let slope = line.slope.as_ref();
            let cells = [
                quoted(&table.of),
                table.value.to_string(),
                table.unit.clone().unwrap_or_default(),
                parameter.name.clone(),
                parameter.value.to_string(),
                parameter.unit.clone(),
                number(slope.ok().map(|slope| slope.value)),
                number(slope.ok().map(|slope| slope.error)),
                number(table.of_percent(line, by)),
                number(table.relative(line, by)),
                slope.map_or(String::new(), |slope| slope.how.text().to_string()),
                slope.err().map_or(String::new(), |message| quoted(message)),
            ];
            let _ = writeln!(text, "{}", cells.join(","));
        }
    }
    text
}
