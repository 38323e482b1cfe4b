//! The operations of every generated function, of every shipped model, in both coordinate sets.
//!
//! ```text
//! cargo run --release --example counts                 tables
//! cargo run --release --example counts -- --json       an array of objects
//! cargo run --release --example counts -- four_bar     only models whose name contains this
//! ```
//! Counted are the instructions of the scheduled programs, from which the code is emitted one to one: the watch over
//! the pivots is part of the acceleration functions. A fused multiply-add is one operation, so is a division, a square
//! root, a choice (min, max, abs, sign, comparison, logic, select) and a call of sin or the like. Depth is the longest
//! chain of operations that wait for one another. Live is the largest number of results that are alive at once, in the
//! order of the code; true use of registers and stack is decided by the target's compiler.

use linkwright_compiler::model::Coordinates;
use linkwright_compiler::schedule::{Counts, Function, count, live_values};
use std::fmt::Write as _;
use std::io::Write as _;
use std::process::ExitCode;

/// Name and definition of every shipped model.
macro_rules! sources {
    ($($name:ident: $model:path),* $(,)?) => { &[$((stringify!($name), <$model>::SOURCE)),*] };
}
const MODELS: &[(&str, &str)] = linkwright_models::for_each_model!(sources);

const COORDINATES: [(&str, Coordinates); 2] =
    [("absolute", Coordinates::Absolute), ("tree", Coordinates::Tree)];

/// One function of one model in one coordinate set.
struct Row {
    model: &'static str,
    coordinates: &'static str,
    function: &'static str,
    counts: Counts,
    live: usize,
}

fn main() -> ExitCode {
    let mut json = false;
    let mut part = String::new();
    for argument in std::env::args().skip(1) {
        match argument.as_str() {
            "--json" => json = true,
            option if option.starts_with('-') => {
                eprintln!("unknown option {option}; usage: counts [--json] [PART OF A MODEL'S NAME]");
                return ExitCode::FAILURE;
            }
            name => part = name.to_string(),
        }
    }
    let mut rows = Vec::new();
    for (model, source) in MODELS.iter().filter(|(model, _)| model.contains(&part)) {
        for (coordinates, asked) in COORDINATES {
            eprintln!("{model}, {coordinates} coordinates");
            match functions(source, asked) {
                Ok(functions) => rows.extend(functions.into_iter().map(|(function, counts, live)| Row {
                    model,
                    coordinates,
                    function,
                    counts,
                    live,
                })),
                Err(message) => {
                    eprintln!("{model}: {message}");
                    return ExitCode::FAILURE;
                }
            }
        }
    }
    if rows.is_empty() {
        eprintln!("no model's name contains \"{part}\"");
        return ExitCode::FAILURE;
    }
    let text = if json { as_json(&rows) } else { as_tables(&rows) };
    // A reader that stops early (`| head`) is no failure.
    let _ = std::io::stdout().write_all(text.as_bytes());
    ExitCode::SUCCESS
}

/// Compiles a definition in one coordinate set and counts its functions.
fn functions(source: &str, coordinates: Coordinates) -> Result<Vec<(&'static str, Counts, usize)>, String> {
    let tokens = source.parse().map_err(|error| format!("{error}"))?;
    let compiled =
        linkwright_compiler::compile(tokens, Some(coordinates)).map_err(|errors| errors.to_string())?;
    let of = |function: Function| {
        let program = compiled.programs.get(function);
        (function.name(), count(program), live_values(program))
    };
    Ok(Function::ALL.map(of).into())
}

fn as_json(rows: &[Row]) -> String {
    let objects: Vec<String> = rows
        .iter()
        .map(|Row { model, coordinates, function, counts: c, live }| {
            format!(
                "{{\"model\":\"{model}\",\"coordinates\":\"{coordinates}\",\"function\":\"{function}\",\
                 \"operations\":{},\"depth\":{},\"live_values\":{live},\"additions\":{},\"multiplications\":{},\
                 \"fused_multiply_adds\":{},\"divisions\":{},\"square_roots\":{},\"choices\":{},\
                 \"transcendentals\":{}}}",
                c.total(),
                c.depth,
                c.additions,
                c.multiplications,
                c.fused_multiply_adds,
                c.divisions,
                c.square_roots,
                c.choices,
                c.transcendentals
            )
        })
        .collect();
    format!("[\n{}\n]\n", objects.join(",\n"))
}

/// One table for each model and coordinate set; functions that compute nothing are left out.
fn as_tables(rows: &[Row]) -> String {
    let mut text = String::new();
    for table in rows.chunk_by(|a, b| (a.model, a.coordinates) == (b.model, b.coordinates)) {
        let _ = writeln!(text, "{}, {} coordinates", table[0].model, table[0].coordinates);
        let _ = writeln!(
            text,
            "  {:<24}{:>7}{:>7}{:>6}{:>6}{:>6}{:>6}{:>7}{:>6}{:>6}{:>7}",
            "function", "total", "depth", "live", "add", "mul", "fma", "div", "sqrt", "min..", "sin.."
        );
        for Row { function, counts: c, live, .. } in table.iter().filter(|row| row.counts.total() > 0) {
            let _ = writeln!(
                text,
                "  {function:<24}{:>7}{:>7}{live:>6}{:>6}{:>6}{:>6}{:>7}{:>6}{:>6}{:>7}",
                c.total(),
                c.depth,
                c.additions,
                c.multiplications,
                c.fused_multiply_adds,
                c.divisions,
                c.square_roots,
                c.choices,
                c.transcendentals
            );
        }
        text.push('\n');
    }
    text.push_str(
        "live: results alive at once; add: additions, subtractions, negations; min..: min, max, abs, sign, comparisons, logic, select; sin..: \
         calls of sin and the like\n",
    );
    text
}
