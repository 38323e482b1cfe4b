//! The main job: the quick return of the source at 15 and 30 rad/s, with a coupler that bends at 15 to 30 rad/s, and the Baumgarte
//! experiment, printed and shown.
//!
//! ```text
//! cargo run --release --example quick_return
//! ```
//! Writes a report (one HTML file that needs nothing else) and CSV files to `target/quick_return/`.

mod baumgarte;
mod drawing;
mod flexible;
mod geometry;
mod page;
mod plots;
mod report;
mod runs;
mod shapes;
mod tables;

use std::error::Error;
use std::path::PathBuf;

/// Nominal crank speeds, rad/s.
const CRANK_SPEEDS: [f64; 2] = [15.0, 30.0];
/// Those with a flexible coupler, and steps of an output interval, for what oscillates along it.
const FLEXIBLE: [(f64, usize); 4] = [(15.0, 80), (20.0, 40), (25.0, 80), (30.0, 60)];

fn main() -> Result<(), Box<dyn Error>> {
    let directory = output_directory()?;

    let runs = CRANK_SPEEDS.into_iter().map(runs::run).collect::<Result<Vec<_>, _>>()?;
    println!("\n{}", runs::findings(&runs).text());

    let bent = FLEXIBLE
        .into_iter()
        .map(|(speed, steps)| flexible::run(speed, steps))
        .collect::<Result<Vec<_>, _>>()?;
    println!("{}", flexible::findings(&bent).text());

    let trials = baumgarte::experiment()?;
    println!("{}", baumgarte::findings(&trials).text());

    let mut files = vec![report::write(&directory, &runs, &bent, &trials)?];
    for run in &runs {
        files.push(runs::write(&directory, run)?);
    }
    for run in &bent {
        files.push(flexible::write(&directory, run)?);
    }
    files.push(baumgarte::write(&directory, &trials)?);
    println!("  written:");
    let here = std::env::current_dir()?;
    for file in &files {
        println!("    {}", file.strip_prefix(&here).unwrap_or(file).display());
    }
    Ok(())
}

/// `quick_return` in the target directory.
fn output_directory() -> std::io::Result<PathBuf> {
    let directory = linkwright_examples::in_target("quick_return");
    std::fs::create_dir_all(&directory)?;
    Ok(directory)
}
