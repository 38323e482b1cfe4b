//! The Baumgarte experiment: how far a closed loop drifts off its constraints, and what stabilisation does about it.
//!
//! Example 4 of the lecture: rms of all constraint residuals over time without stabilisation and for α = β = 1, 5, 10
//! and 50. The loop is a crank-rocker of our own in absolute coordinates, so that all eight rows can drift.

use crate::drawing::Frame;
use crate::tables::{Table, write_csv};
use linkwright::{Baumgarte, Formulation, LagrangeIndex1, Sample, Simulation, SimulationError, State};
use linkwright_examples::progress::Progress;
use std::io;
use std::path::{Path, PathBuf};

linkwright::mechanism! {
    /// Crank-rocker that turns over under gravity; conservative, so that its energy can be watched too.
    pub planar ClosedLoop {
        gravity [m/s^2] = (0, -9.81);
        rod crank   { mass [kg] = 1.0; length [m] = 0.4; }
        rod coupler { mass [kg] = 1.5; length [m] = 1.1; }
        rod rocker  { mass [kg] = 1.2; length [m] = 0.8; }
        joint crank_pin:  revolute(ground(0, 0) [m], crank.start);
        joint rocker_pin: revolute(ground(1, 0) [m], rocker.start);
        joint left:       revolute(crank.end, coupler.start);
        joint right:      revolute(coupler.end, rocker.end);
        start { crank_pin.angle [deg] = 60; crank_pin.rate [rad/s] = 15;
                rocker_pin.angle [deg] ~ 80; coupler.angle [deg] ~ 20; }
        options { coordinates = absolute; }
        expect { degrees_of_freedom = 1; }
    }
}

/// The stabilisations compared: none, and α = β in 1/s.
pub const RATES: [Option<f64>; 5] = [None, Some(1.0), Some(5.0), Some(10.0), Some(50.0)];
/// Step of the integrator (RK4), s: coarse, so that there is something to stabilise.
pub const STEP: f64 = 1e-3;
/// Length of each run, s.
pub const DURATION: f64 = 100.0;
/// Over this time residuals are averaged, s: more than a turn of the crank, so that the curves show the drift.
pub const WINDOW: f64 = 1.0;
/// The end of each run, kept for drawings: its length and the time between frames, s.
const SHOWN: f64 = 2.0;
const FRAME: f64 = 0.01;

/// One run.
pub struct Trial {
    /// α = β, 1/s; `None`: not stabilised.
    pub rate: Option<f64>,
    pub windows: Vec<Window>,
    /// The motion at the end of the run.
    pub frames: Vec<Frame>,
    /// |E − E₀| at the end, J.
    pub energy_drift: f64,
}

/// The root mean square of all constraint residuals over a stretch of time.
#[derive(Clone, Copy)]
pub struct Window {
    /// Its end, s.
    pub time: f64,
    /// Of Φ, m.
    pub position: f64,
    /// Of D v − ν, m/s.
    pub velocity: f64,
}

impl Trial {
    /// As it stands in legends and tables.
    pub fn name(&self) -> String {
        self.rate.map_or("not stabilised".to_string(), |rate| format!("α = β = {rate} s⁻¹"))
    }

    /// The last window.
    pub fn end(&self) -> Window {
        self.windows[self.windows.len() - 1]
    }

    /// The exponent p of Φ ~ tᵖ over the last nine tenths of the run, by least squares in logarithms.
    pub fn growth(&self) -> f64 {
        let late = self.windows.iter().filter(|window| window.time > 0.1 * DURATION);
        let points: Vec<(f64, f64)> = late.map(|window| (window.time.ln(), window.position.ln())).collect();
        let mean = |of: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / points.len() as f64;
        let (x, y) = (mean(&|point| point.0), mean(&|point| point.1));
        mean(&|point| (point.0 - x) * (point.1 - y)) / mean(&|point| (point.0 - x).powi(2))
    }
}

/// All runs, from the same start.
pub fn experiment() -> Result<Vec<Trial>, SimulationError> {
    let mut progress = Progress::new("Baumgarte experiment", RATES.len());
    let mut trials = Vec::new();
    for rate in RATES {
        trials.push(match rate {
            None => trial(rate, LagrangeIndex1)?,
            Some(rate) => trial(Some(rate), Baumgarte { alpha: rate, beta: rate })?,
        });
        progress.at(trials.len());
    }
    Ok(trials)
}

fn trial(
    rate: Option<f64>,
    formulation: impl Formulation<f64, ClosedLoop>,
) -> Result<Trial, SimulationError> {
    let model = ClosedLoop::default();
    let mut simulation = Simulation::new(&model, ClosedLoop::START).formulation(formulation).step(STEP);
    let start = simulation.energy();
    let (mut windows, mut frames) = (Vec::new(), Vec::new());
    let [window, frame] = [WINDOW, FRAME].map(|seconds| (seconds / STEP).round() as u64);
    let mut sums = [0.0; 2];
    let mut count = 0;
    simulation.run_until(DURATION, |sample: &Sample<f64, ClosedLoop>| {
        let residual = sample.constraint_residual();
        if count > 0 {
            sums = [sums[0] + residual.position_rms.powi(2), sums[1] + residual.velocity_rms.powi(2)];
            if count % window == 0 {
                let [position, velocity] = sums.map(|sum| (sum / window as f64).sqrt());
                windows.push(Window { time: sample.time, position, velocity });
                sums = [0.0; 2];
            }
        }
        if sample.time > DURATION - SHOWN && count % frame == 0 {
            let State { q, v, .. } = &sample.state;
            // A frame holds positions only, for which any acceleration will do.
            let motions = model.motions(sample.time, q, v, &[0.0; ClosedLoop::START.v.len()]);
            frames.push(Frame::of(sample.time, &motions));
        }
        count += 1;
    })?;
    Ok(Trial { rate, windows, frames, energy_drift: (simulation.energy() - start).abs() })
}

/// Residuals at the end of each run.
pub fn findings(trials: &[Trial]) -> Table {
    let mut table = Table::new(&[
        "constraint residuals after 100 s",
        "rms of Φ (m)",
        "of its rate (m/s)",
        "relative",
        "grows like",
        "energy drift (J)",
    ]);
    let reference = trials.first().map_or(f64::NAN, |trial| trial.end().position);
    for trial in trials {
        let end = trial.end();
        table.row([
            trial.name(),
            format!("{:.2e}", end.position),
            format!("{:.2e}", end.velocity),
            share(end.position / reference),
            power(trial.growth()),
            format!("{:.1e}", trial.energy_drift),
        ]);
    }
    table
}

/// How a quantity that follows tᵖ grows.
fn power(exponent: f64) -> String {
    if exponent.abs() < 0.05 { "constant".to_string() } else { format!("t^{exponent:.1}") }
}

fn share(value: f64) -> String {
    if value == 1.0 { "1".to_string() } else { format!("{value:.1e}") }
}

/// The residuals of all runs as a CSV file.
pub fn write(directory: &Path, trials: &[Trial]) -> io::Result<PathBuf> {
    let mut header = vec!["time_s".to_string()];
    for trial in trials {
        let name = trial.rate.map_or("none".to_string(), |rate| rate.to_string());
        header.extend([format!("rms_position_{name}_m"), format!("rms_velocity_{name}_m_s")]);
    }
    let rows = (0..trials[0].windows.len()).map(|index| {
        let mut row = vec![trials[0].windows[index].time];
        row.extend(trials.iter().flat_map(|trial| {
            let window = trial.windows[index];
            [window.position, window.velocity]
        }));
        row
    });
    write_csv(&directory.join("baumgarte.csv"), &header, rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stronger_stabilisation_leaves_smaller_residuals() {
        let trials = experiment().unwrap();
        let ends: Vec<f64> = trials.iter().map(|trial| trial.end().position).collect();
        assert!(ends.windows(2).all(|pair| pair[1] < pair[0]), "{ends:?}");
        assert!(trials[0].growth() > 0.5, "an unstabilised loop drifts");
    }
}
