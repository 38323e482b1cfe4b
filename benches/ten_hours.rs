//! Ten hours of a controller: the four-bar stepped 3.6·10⁷ times at 1 ms, as an embedded model would be, with its energy and
//! its constraints watched all the way.
//!
//! ```text
//! cargo bench --bench ten_hours [-- HOURS]
//! ```

mod harness;
#[path = "../examples/progress.rs"]
mod progress;

use harness::seconds;
use linkwright::{Baumgarte, Formulation, LagrangeIndex1, Projected, Rk4, Simulation};
use linkwright_models::four_bar::FourBar;
use progress::Progress;

/// s.
const STEP: f64 = 1e-3;
/// Steps between two looks.
const STRETCH: u64 = 1000;

fn main() {
    println!("{}", harness::machine());
    let hours = std::env::args().skip(1).find_map(|argument| argument.parse::<f64>().ok()).unwrap_or(10.0);
    println!("four-bar, {hours} h at {} ms, RK4\n", 1e3 * STEP);
    println!(
        "{:<24}{:>12}{:>18}{:>18}{:>12}{:>14}{:>10}",
        "formulation", "steps", "energy drift, J", "per hour, J", "max Φ, m", "stepped over", "time, s"
    );
    watch("Baumgarte, 20/s", Baumgarte { alpha: 20.0, beta: 20.0 }, hours);
    watch("index 1, projected", Projected::after(LagrangeIndex1), hours);
}

fn watch<F: Formulation<f64, FourBar<f64>>>(name: &str, formulation: F, hours: f64) {
    let model = FourBar::<f64>::default();
    // The rods lie in one line twice a swing; in so many passages a stage falls on the singular position itself.
    let simulation = Simulation::new(&model, FourBar::START).formulation(formulation).integrator(Rk4);
    let mut simulation = simulation.step(STEP).step_over_breakdowns();
    let begin = simulation.energy();
    let stretches = (hours * 3600.0 / STEP / STRETCH as f64).round() as usize;
    let mut progress = Progress::new(name, stretches);
    let (mut drift, mut off, mut over) = (0.0_f64, 0.0_f64, 0);
    let (outcome, time) = seconds(|| {
        for stretch in 0..stretches {
            for _ in 0..STRETCH {
                over += simulation.advance()?.stepped_over;
            }
            drift = drift.max((simulation.energy() - begin).abs());
            off = off.max(simulation.constraint_residual().position);
            progress.at(stretch);
        }
        Ok::<(), linkwright::SimulationError>(())
    });
    drop(progress);
    let steps = stretches as u64 * STRETCH;
    match outcome {
        Ok(()) => {
            println!(
                "{name:<24}{steps:>12}{drift:>18.2e}{:>18.2e}{off:>12.1e}{over:>14}{time:>10.1}",
                drift / hours
            )
        }
        Err(error) => println!("{name:<24} stopped: {error}"),
    }
}
