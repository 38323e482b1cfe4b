//! The operations of every generated function, of every shipped model, in both coordinate sets. What is counted says
//! `compiler/src/counts.rs`; `linkwright counts FILE` does the same for any definition.
//!
//! ```text
//! cargo run --release -p linkwright-models --example counts                 tables
//! cargo run --release -p linkwright-models --example counts -- --json       an array of objects
//! cargo run --release -p linkwright-models --example counts -- four_bar     only models whose name contains this
//! ```

use linkwright_compiler::counts;
use std::io::Write;
use std::process::ExitCode;

/// Name and definition of every shipped model.
macro_rules! sources {
    ($($name:ident: $model:path),* $(,)?) => { &[$((stringify!($name), <$model>::SOURCE)),*] };
}
const MODELS: &[(&str, &str)] = linkwright_models::for_each_model!(sources);

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
        for coordinates in counts::COORDINATES {
            eprintln!("{model}, {} coordinates", coordinates.0);
            let tokens = source.parse().expect("the definition of a model consists of tokens");
            match counts::rows(model, tokens, coordinates) {
                Ok(functions) => rows.extend(functions),
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
    let text = if json { counts::as_json(&rows) } else { counts::as_tables(&rows) };
    // A reader that stops early (`| head`) is no failure.
    let _ = std::io::stdout().write_all(text.as_bytes());
    ExitCode::SUCCESS
}
