//! Every shipped model, in both sets of coordinates, against a reference that knows nothing of the compiler: a Python
//! script that rebuilds the model from its `DEFINITION` by energies and CasADi's automatic differentiation.
//!
//! With CasADi the script judges over a hundred random states and parameter sets of each kind. Without a network the
//! committed values of the same script are compared instead (`recorded`), unless `REQUIRE_CASADI` is set.

mod casadi;
mod mutation;
pub mod random;
mod recorded;
mod request;
pub mod states;

use linkwright_compiler::model::Coordinates;
use linkwright_compiler::{Compiled, compile};
use std::path::PathBuf;

/// Name, `SOURCE` and `DEFINITION` of every shipped model.
pub fn models() -> Vec<(&'static str, &'static str, &'static str)> {
    macro_rules! list {
        ($($name:ident: $model:path),* $(,)?) => {{
            vec![$({ use $model as Model; (stringify!($name), Model::SOURCE, Model::DEFINITION) }),*]
        }};
    }
    linkwright_models::for_each_model!(list)
}

pub const SETS: [(Coordinates, &str); 2] = [(Coordinates::Absolute, "absolute"), (Coordinates::Tree, "tree")];

pub fn compiled(source: &str, coordinates: Coordinates) -> Compiled {
    let tokens = source.parse().unwrap_or_else(|error| panic!("{error}"));
    compile(tokens, Some(coordinates)).unwrap_or_else(|errors| panic!("{errors}"))
}

/// A hash of the definition, so that recorded values cannot outlive it (FNV-1a, 64 bit).
pub fn hash(definition: &str) -> String {
    let hash = definition.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    });
    format!("{hash:016x}")
}

#[test]
fn models_agree_with_casadi() {
    let python = match casadi::python() {
        Ok(python) => python,
        Err(reason) => {
            assert!(std::env::var_os("REQUIRE_CASADI").is_none(), "CasADi is required, but: {reason}");
            println!("CasADi is not to be had ({reason}): only the committed values are compared");
            recorded::compare_all();
            return;
        }
    };
    println!("comparing with CasADi itself");
    let requests = casadi::target().join("requests");
    let _ = std::fs::remove_dir_all(&requests);
    std::fs::create_dir_all(&requests).unwrap();
    let models = models();
    for (name, source, definition) in &models {
        for (coordinates, set) in SETS {
            let compiled = compiled(source, coordinates);
            assert_eq!(compiled.definition, *definition, "{name}: the emitted definition is another");
            let text = request::request(&compiled, &hash(definition), &|_| None);
            std::fs::write(requests.join(format!("{name}.{set}.json")), text).unwrap();
        }
    }
    let mut arguments = vec!["--minimum", "100"];
    let record = recorded::folder();
    let record = record.to_str().unwrap();
    if std::env::var_os("RECORD_CASADI").is_some() {
        arguments.extend(["--record", record, "--states", "3"]);
    }
    match casadi::check(&python, &requests, &arguments) {
        Ok(report) => println!("{report}"),
        Err(report) => panic!("{report}"),
    }
}

/// The committed values hold on every machine, with CasADi or without.
#[test]
fn models_agree_with_the_recorded_values() {
    if std::env::var_os("RECORD_CASADI").is_none() {
        recorded::compare_all();
    }
}

/// The definitions compared are those of `models/src`, all of them.
#[test]
fn every_definition_is_compared() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("models/src");
    let mut written = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let text = std::fs::read_to_string(entry.unwrap().path()).unwrap();
        written.extend(names_written(&text));
    }
    let mut compared: Vec<String> = models()
        .iter()
        .map(|(_, _, definition)| {
            let name = definition.split("\"name\":\"").nth(1).unwrap();
            name.split('"').next().unwrap().to_string()
        })
        .collect();
    written.sort();
    compared.sort();
    assert!(!compared.is_empty());
    assert_eq!(written, compared);
}

/// Names of the mechanisms in a file: behind `planar`, or, where a macro of the file writes the definition, what its
/// calls pass as the name.
fn names_written(text: &str) -> Vec<String> {
    let lines = text.lines().map(str::trim).filter(|line| !line.starts_with("//"));
    let code = lines.collect::<Vec<_>>().join("\n");
    let mut names = Vec::new();
    for (at, _) in code.match_indices("planar ") {
        let name = code[at + "planar ".len()..].split('{').next().unwrap().trim();
        if !name.starts_with('$') {
            names.push(name.to_string());
            continue;
        }
        let own = code.split("macro_rules! ").nth(1).unwrap().split_whitespace().next().unwrap();
        for call in code.split(&format!("\n{own}! {{")).skip(1) {
            let body = call.split("\n}").next().unwrap();
            names.push(body.split(',').next().unwrap().trim().to_string());
        }
    }
    names
}
