//! A step of RK4 with Baumgarte's terms, by a stepper and by a simulation with held inputs, interleaved: what a simulation does beside
//! the step.
//!
//! ```text
//! cargo bench --bench stepper
//! ```

mod harness;

use harness::least;
use linkwright::{Assemble, AssembleExt, Baumgarte, Fields, Rk4, Simulation, Vector};
use linkwright_models::{andrews::Andrews, four_bar::FourBar, iiwa14::Iiwa14, n_four_bar::NFourBar10};
use std::hint::black_box;
use std::time::Instant;

const SAMPLES: usize = 400;
const STEPS: usize = 200;
const H: f64 = 1e-7;

fn main() {
    println!("{}", harness::machine());
    println!("ns a step, least of {SAMPLES} samples of {STEPS} steps\n");
    println!("{:<16}{:>10}{:>12}{:>8}", "", "stepper", "simulation", "ratio");
    beside("four_bar", &FourBar::default());
    beside("andrews", &Andrews::default());
    beside("iiwa14", &Iiwa14::default());
    beside("n_four_bar_10", &NFourBar10::default());
}

fn beside<M: Assemble<f64, Inputs: Fields<f64>> + Clone>(name: &str, model: &M) {
    let terms = Baumgarte { alpha: 10.0, beta: 10.0 };
    let none = || M::Inputs::from_array(Vector::zeros(M::Inputs::NAMES.len()));
    let mut plant = model.stepper(model.start(), (Rk4, terms));
    let simulation = Simulation::new(model, model.start()).formulation(terms);
    let mut simulation = simulation.held(move |_, _| none()).step(H);
    let inputs = none();
    let (mut by_stepper, mut by_simulation) = (Vec::new(), Vec::new());
    for _ in 0..SAMPLES {
        by_stepper.push(time(|| plant.step(black_box(&inputs), black_box(H)).is_ok()));
        by_simulation.push(time(|| simulation.advance().is_ok()));
    }
    let (stepper, simulation) = (1e9 * least(&by_stepper), 1e9 * least(&by_simulation));
    println!("{name:<16}{stepper:>10.1}{simulation:>12.1}{:>8.2}", stepper / simulation);
}

/// Seconds a step.
fn time(mut step: impl FnMut() -> bool) -> f64 {
    let begin = Instant::now();
    let good = (0..STEPS).filter(|_| step()).count();
    let passed = begin.elapsed().as_secs_f64();
    assert_eq!(black_box(good), STEPS, "a step failed");
    passed / STEPS as f64
}
