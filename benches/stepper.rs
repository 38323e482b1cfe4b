//! A step of RK4 with Baumgarte's terms, by a stepper, by one that solves by multipliers at every position, and by a simulation with
//! held inputs, interleaved: what independent velocities save, and what a simulation does beside the step.
//!
//! ```text
//! cargo bench --bench stepper
//! ```

mod harness;

use harness::least;
use linkwright::{Assemble, AssembleExt, Baumgarte, Fields, Rk4, Simulation, Vector, WithMultipliers};
use linkwright_models::{
    andrews::Andrews,
    bricard::Bricard,
    four_bar::FourBar,
    iiwa14::Iiwa14,
    n_four_bar::{NFourBar10, NFourBar40},
    stewart_platform::StewartPlatform,
};
use std::hint::black_box;
use std::time::Instant;

const SAMPLES: usize = 400;
const STEPS: usize = 200;
const H: f64 = 1e-7;

fn main() {
    println!("{}", harness::machine());
    println!("ns a step, least of {SAMPLES} samples of {STEPS} steps\n");
    println!("{:<16}{:>10}{:>8}{:>14}{:>8}{:>12}", "", "stepper", "", "multipliers", "", "simulation");
    beside("four_bar", &FourBar::default());
    beside("andrews", &Andrews::default());
    beside("bricard", &Bricard::default());
    beside("iiwa14", &Iiwa14::default());
    beside("n_four_bar_10", &NFourBar10::default());
    beside("n_four_bar_40", &NFourBar40::default());
    beside("stewart_platform", &StewartPlatform::default());
}

fn beside<M: Assemble<f64, Inputs: Fields<f64>> + Clone>(name: &str, model: &M) {
    let terms = Baumgarte { alpha: 10.0, beta: 10.0 };
    let none = || M::Inputs::from_array(Vector::zeros(M::Inputs::NAMES.len()));
    let mut plant = model.stepper(model.start(), (Rk4, terms));
    let mut other = model.stepper(model.start(), (Rk4, WithMultipliers(terms)));
    let simulation = Simulation::new(model, model.start()).formulation(terms);
    let mut simulation = simulation.held(move |_, _| none()).step(H);
    let inputs = none();
    let mut samples = [const { Vec::new() }; 3];
    for _ in 0..SAMPLES {
        samples[0].push(time(|| plant.step(black_box(&inputs), black_box(H)).is_ok()));
        samples[1].push(time(|| other.step(black_box(&inputs), black_box(H)).is_ok()));
        samples[2].push(time(|| simulation.advance().is_ok()));
    }
    let [stepper, multipliers, simulation] = samples.map(|samples| 1e9 * least(&samples));
    let [of_multipliers, of_simulation] = [multipliers, simulation].map(|other| stepper / other);
    println!(
        "{name:<16}{stepper:>10.1}{of_multipliers:>8.2}{multipliers:>14.1}{of_simulation:>8.2}{simulation:>12.1}"
    );
}

/// Seconds a step.
fn time(mut step: impl FnMut() -> bool) -> f64 {
    let begin = Instant::now();
    let good = (0..STEPS).filter(|_| step()).count();
    let passed = begin.elapsed().as_secs_f64();
    assert_eq!(black_box(good), STEPS, "a step failed");
    passed / STEPS as f64
}
