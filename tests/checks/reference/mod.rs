//! Every shipped model and the zoo's, in both sets of coordinates, against a reference that knows nothing of the compiler: a Python
//! script that rebuilds the model from its `DEFINITION` by energies and CasADi's automatic differentiation.
//!
//! With CasADi the script judges over a hundred random states and parameter sets of each kind. Without a network the
//! committed values of the same script are compared instead (`recorded`), unless `REQUIRE_CASADI` is set.

mod casadi;
mod control;
pub mod mutation;
pub mod random;
pub mod recorded;
mod request;
mod sensitivity;
pub mod states;

use linkwright_compiler::model::Coordinates;
use linkwright_compiler::{Compiled, compile};
use std::path::{Path, PathBuf};

/// Name, `SOURCE` and `DEFINITION` of every shipped model.
pub fn models() -> Vec<(&'static str, &'static str, &'static str)> {
    macro_rules! list {
        ($($name:ident: $model:path),* $(,)?) => {{
            vec![$((stringify!($name), <$model as crate::registry::Model>::source(), <$model>::DEFINITION)),*]
        }};
    }
    linkwright_models::for_each_model!(list)
}

/// Mechanisms of the zoo whose values are recorded too: for the mutations, because in space their axes lie anywhere, where those of
/// shipped models are such that many a term vanishes; beams that shear; rigid contacts that rub; and those of joints that no shipped model has.
const RECORDED_OF_ZOO: [&str; 8] =
    ["crank", "gripping_in_space", "jack", "oldham", "shafts", "sheared", "snake", "stage"];

/// Models whose values are not recorded, so that all stay within a megabyte: one like it is, or its values are among the longest. Contacts whose gates
/// are not forces and friction by reactions are not part of a recorded system.
const NOT_RECORDED: [&str; 53] = [
    "ball_between_walls",
    "bevel_pair",
    "bouncing_ball",
    "bouncing_ball_of_hunt_and_crossley",
    "cam_lift_off",
    "clutched_differential",
    "delta_robot",
    "elastic_cable_robot",
    "falling_cross",
    "flexible_arm",
    "flexible_quick_return",
    "flexible_slider_crank",
    "gear_pair_oscillator",
    "geared_shafts",
    "hammer_at_rigid_wall",
    "hammer_at_wall",
    "held_block",
    "hinged_bar",
    "hinged_bar_of_five",
    "hinged_bar_of_one",
    "hinged_bar_of_sines",
    "iiwa14",
    "iiwa14_parametric",
    "laval_rotor",
    "loose_wrist",
    "n_four_bar_10",
    "n_four_bar_40",
    "panda",
    "penalty_chain",
    "planetary_stage",
    "princeton_beam",
    "rack_and_pinion",
    "rimless_wheel",
    "rod_on_pin",
    "rubbing_block",
    "rubbing_four_bar",
    "rubbing_four_bars",
    "sarrus_linkage",
    "slider_crank_on_stop",
    "sliding_ball",
    "sliding_disk",
    "spatial_slider_crank_balanced",
    "spatial_slider_crank_third",
    "spin_up_without_stiffening",
    "stewart_platform",
    "stick_slip",
    "stribeck_brake",
    "tracked_vehicle",
    "vehicle_on_pans",
    "vertical_cylindrical_pendulum",
    "woodpecker",
    "worm_drive",
    "yaw_drive",
];

/// The models, and what is recorded of the zoo.
pub fn recorded_models() -> Vec<(&'static str, &'static str, &'static str)> {
    let mut all = models();
    all.retain(|(name, ..)| !NOT_RECORDED.contains(name));
    all.extend(zoo().into_iter().filter(|(name, ..)| RECORDED_OF_ZOO.contains(name)));
    all
}

/// What is not recorded: mechanisms of the zoo, and models.
pub fn others() -> [Vec<(&'static str, &'static str, &'static str)>; 2] {
    let rest = |all: Vec<(&'static str, _, _)>, names: &[&str], recorded: bool| {
        all.into_iter().filter(|(name, ..)| names.contains(name) != recorded).collect()
    };
    [rest(zoo(), &RECORDED_OF_ZOO, true), rest(models(), &NOT_RECORDED, false)]
}

/// The same of the zoo's mechanisms.
fn zoo() -> Vec<(&'static str, &'static str, &'static str)> {
    macro_rules! list {
        ($($name:ident: $model:path),* $(,)?) => {{
            vec![$((stringify!($name), <$model as crate::registry::Model>::source(), <$model>::DEFINITION)),*]
        }};
    }
    crate::zoo::for_each_in_zoo!(list)
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

/// Python with CasADi; none where it is not to be had and need not be.
pub fn python() -> Option<PathBuf> {
    match casadi::python() {
        Ok(python) => {
            println!("comparing with CasADi itself");
            Some(python)
        }
        Err(reason) => {
            assert!(std::env::var_os("REQUIRE_CASADI").is_none(), "CasADi is required, but: {reason}");
            println!("CasADi is not to be had ({reason}): only the committed values are compared");
            None
        }
    }
}

/// Writes the requests of some mechanisms into a folder of their own.
pub fn write_requests(folder: &str, models: &[(&str, &str, &str)]) -> PathBuf {
    let requests = casadi::target().join(folder);
    let _ = std::fs::remove_dir_all(&requests);
    std::fs::create_dir_all(&requests).unwrap();
    for (name, source, definition) in models {
        for (coordinates, set) in SETS {
            let compiled = compiled(source, coordinates);
            assert_eq!(compiled.definition, *definition, "{name}: the emitted definition is another");
            let text = request::request(&compiled, &hash(definition), &|_| None);
            std::fs::write(requests.join(format!("{name}.{set}.json")), text).unwrap();
        }
    }
    requests
}

pub fn compare(python: &Path, requests: &Path, arguments: &[&str]) {
    match casadi::check(python, requests, arguments) {
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

/// Names of the mechanisms in a file: behind `planar` or `spatial`, or, where a macro of the file writes the definition,
/// what its calls pass as the name.
fn names_written(text: &str) -> Vec<String> {
    let lines = text.lines().map(str::trim).filter(|line| !line.starts_with("//"));
    let code = lines.collect::<Vec<_>>().join("\n");
    let name = |text: &str| -> String {
        text.trim_start().chars().take_while(|letter| letter.is_alphanumeric() || *letter == '_').collect()
    };
    let mut names = Vec::new();
    for word in ["planar ", "spatial "] {
        for (at, _) in code.match_indices(word) {
            let behind = &code[at + word.len()..];
            if !behind.starts_with('$') {
                names.push(name(behind));
                continue;
            }
            let own = name(code.split("macro_rules! ").nth(1).unwrap());
            names.extend(code.split(&format!("\n{own}! {{")).skip(1).map(name));
        }
    }
    names
}
