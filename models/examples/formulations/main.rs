//! Every formulation on the published benchmarks: `cargo run --release -p linkwright-models --example formulations`.
//!
//! Prints the tables of `docs/formulations.md`: for each formulation and step the error at the end of the run, the drift of
//! the energy, the violation of the constraints, where the motion came near a singular position, and the time taken.

mod benchmarks;
mod methods;
mod trial;

use std::io::Write;

fn main() {
    let mut out = std::io::stdout().lock();
    let chosen: Vec<String> = std::env::args().skip(1).collect();
    for benchmark in benchmarks::ALL {
        if !chosen.is_empty() && !chosen.iter().any(|name| benchmark.name.contains(name.as_str())) {
            continue;
        }
        let table = (benchmark.run)();
        // A reader that stops early (`| head`) is no failure.
        if write!(out, "## {}\n\n{table}\n", benchmark.name).is_err() {
            return;
        }
    }
}
