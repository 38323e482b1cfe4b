//! One run and its row of a table.

use linkwright::{
    Assemble, Formulation, Integrator, MechanismDynamics, NoInputs, Residual, Sample, Simulation,
    SimulationError, StateOf,
};
use std::time::Instant;

/// A benchmark: how long it runs, and how a sample is judged.
pub struct Setting<'m, M: Assemble<f64, Inputs = ()>> {
    pub model: &'m M,
    pub start: StateOf<M>,
    pub end: f64,
    pub steps: &'static [f64],
    /// T + V, without the work of loads.
    pub energy: fn(&Sample<'_, f64, M>) -> f64,
    /// The error at the end of the run.
    pub error: &'m dyn Fn(&Sample<'_, f64, M>) -> f64,
}

/// What came out of a run.
#[derive(Clone, Copy, Debug)]
pub struct Trial {
    pub step: f64,
    pub error: f64,
    pub drift: f64,
    pub position: f64,
    pub velocity: f64,
    /// The first time near a singular position.
    pub near_singular: Option<f64>,
    pub iterations: u32,
    pub seconds: f64,
    pub failure: Option<SimulationError>,
}

/// Runs one formulation and integrator with one step.
pub fn trial<M, F, I>(setting: &Setting<'_, M>, (formulation, integrator): (F, I), step: f64) -> Trial
where
    M: Assemble<f64, Inputs = ()>,
    F: Formulation<f64, M>,
    I: for<'m> Integrator<f64, MechanismDynamics<'m, M, f64, F, NoInputs>>,
{
    let mut simulation = Simulation::new(setting.model, setting.start.clone())
        .formulation(formulation)
        .integrator(integrator)
        .step(step);
    let begin = (setting.energy)(&simulation.sample());
    let mut trial = Trial {
        step,
        error: f64::NAN,
        drift: 0.0,
        position: 0.0,
        velocity: 0.0,
        near_singular: None,
        iterations: 0,
        seconds: 0.0,
        failure: None,
    };
    let clock = Instant::now();
    let mut looked = 0.0;
    let count = (setting.end / step).round() as u64;
    for _ in 0..count {
        match simulation.advance() {
            Ok(taken) => {
                trial.iterations += taken.iterations;
                if trial.near_singular.is_none() {
                    trial.near_singular = taken.near_singular.map(|found| found.time);
                }
            }
            Err(error) => {
                trial.failure = Some(error);
                break;
            }
        }
        let begun = Instant::now();
        let sample = simulation.sample();
        trial.drift = trial.drift.max(((setting.energy)(&sample) - begin).abs());
        let Residual { position, velocity, .. } = simulation.constraint_residual();
        (trial.position, trial.velocity) = (trial.position.max(position), trial.velocity.max(velocity));
        looked += begun.elapsed().as_secs_f64();
    }
    trial.seconds = clock.elapsed().as_secs_f64() - looked;
    if trial.failure.is_none() {
        trial.error = (setting.error)(&simulation.sample());
    }
    trial
}

/// The head of a table for these steps.
pub fn head(steps: &[f64]) -> String {
    let errors: Vec<String> = steps.iter().map(|step| format!("error at {:e} s", step)).collect();
    let columns = errors.len() + 7;
    format!(
        "| method | {} | energy drift, J | max Φ | max D v − ν | near singular, s | iterations a step | µs a step |\n|{}\n",
        errors.join(" | "),
        "---|".repeat(columns)
    )
}

/// The row of a table: errors of all trials, the rest of the one with the smallest step.
pub fn row(name: &str, trials: &[Trial], end: f64) -> String {
    let errors: Vec<String> = trials.iter().map(error).collect();
    let Some(trial) = trials.last() else { return String::new() };
    let near = trial.near_singular.map_or("–".to_string(), |time| format!("{time:.4}"));
    let steps = (end / trial.step).round();
    let done = match trial.failure {
        Some(SimulationError::NonFinite { time, .. }) => (time / trial.step).max(1.0),
        _ => steps,
    };
    let Trial { drift, position, velocity, iterations, seconds, .. } = trial;
    format!(
        "| {name} | {} | {drift:.1e} | {position:.1e} | {velocity:.1e} | {near} | {:.2} | {:.2} |\n",
        errors.join(" | "),
        f64::from(*iterations) / done,
        1e6 * seconds / done
    )
}

/// The error, or where the run stopped.
fn error(trial: &Trial) -> String {
    match &trial.failure {
        None => format!("{:.1e}", trial.error),
        Some(SimulationError::NonFinite { time, .. } | SimulationError::Breakdown { time, .. }) => {
            format!("stopped at {time:.2} s")
        }
        Some(SimulationError::NoConvergence { time, .. }) => format!("no convergence at {time:.2} s"),
        Some(failure) => format!("stopped: {failure}"),
    }
}
