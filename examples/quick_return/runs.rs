//! The quick return in motion: two strokes at a nominal crank speed, under the torque and the force of the source.
//!
//! The model and the laws (24), (25), (26) are those of `linkwright_examples::quick_return`; here they are integrated and
//! the results gathered. What is said about them is in `report.rs`.

use crate::drawing::Frame;
use crate::tables::{Table, write_csv};
use linkwright::{Baumgarte, BodyMotion, Reaction, Sampled, Simulation, State};
use linkwright_examples::progress::Progress;
use linkwright_examples::quick_return::{ConstantSpeed, QuickReturn, QuickReturnInputs, slider_force};
use std::error::Error;
use std::f64::consts::TAU;
use std::io;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Output intervals of a run, as in the source.
pub const INTERVALS: usize = 500;
/// Steps of an output interval: even, so that Simpson's rule for the work ends at each output point.
const STEPS: usize = 40;
/// α = β of the stabilisation, 1/s.
pub const STABILISATION: f64 = 10.0;

/// What the source and an independent recomputation of it say about the crank at 15 rad/s.
pub mod expected {
    /// The slider's stroke, m.
    pub const STROKE: f64 = 0.6;
    /// Crank angle of the forward stroke, π + 2 asin ¾, degrees.
    pub const FORWARD: f64 = 277.1807558;
    /// Largest and smallest torque (26), N m, and their times, s.
    pub const TORQUE: [(f64, f64); 2] = [(2027.1328, 0.363409), (-1719.0391, 0.377939)];
    /// Largest torque (25), N m.
    pub const TORQUE_WITHOUT_INERTIA: f64 = 17.1428571;
}

/// A run over two strokes.
pub struct Run {
    /// Nominal crank speed ω, rad/s.
    pub crank_speed: f64,
    pub steps: usize,
    /// The output points, [`INTERVALS`] + 1 of them.
    pub points: Vec<Point>,
    pub frames: Vec<Frame>,
    /// Largest |θ̇₁/ω − 1| over all steps.
    pub speed_deviation: f64,
    /// Difference of the slider's ends, m.
    pub stroke: f64,
    /// Crank angle between the slider's right and left end, degrees.
    pub forward: f64,
    /// Largest and smallest torque (26) in the first stroke: value, N m, and time, s.
    pub torque: [(f64, f64); 2],
    /// Largest torque (25), N m.
    pub torque_without_inertia: f64,
    /// Largest |Φ| over all steps, m or 1.
    pub residual: f64,
    pub wall_time: Duration,
}

/// What is known at one output point, SI.
#[derive(Clone, Copy)]
pub struct Point {
    pub time: f64,
    /// θ̇₁/ω − 1.
    pub speed_deviation: f64,
    pub slider: [f64; 3],
    /// f₄ of (24).
    pub force: f64,
    /// (25) and (26).
    pub torque_without_inertia: f64,
    pub torque: f64,
    pub kinetic: f64,
    /// Work of torque and slider force since the start.
    pub work: [f64; 2],
    pub angles: [f64; 2],
    /// Magnitude of the force in each joint, in the order of `JOINTS`.
    pub reactions: [f64; QuickReturn::JOINTS.len()],
}

impl Point {
    /// Kinetic energy that work does not account for, J, since a start with `kinetic`.
    pub fn imbalance(&self, kinetic: f64) -> f64 {
        self.kinetic - kinetic - self.work[0] - self.work[1]
    }
}

impl Run {
    /// Turns of the crank at a time.
    pub fn turns(&self, time: f64) -> f64 {
        time * self.crank_speed / TAU
    }

    /// Work of the torque and of the slider force over the run, J.
    pub fn work(&self) -> [f64; 2] {
        self.points[self.points.len() - 1].work
    }

    /// Largest difference between energy and work, as a share of the largest kinetic energy.
    pub fn imbalance(&self) -> f64 {
        let start = self.points[0].kinetic;
        let largest = |of: &dyn Fn(&Point) -> f64| self.points.iter().map(of).fold(0.0, f64::max);
        largest(&|point| point.imbalance(start).abs()) / largest(&|point| point.kinetic)
    }
}

/// Two strokes, 4π/ω, at the nominal crank speed ω (rad/s).
pub fn run(crank_speed: f64) -> Result<Run, Box<dyn Error>> {
    let started = Instant::now();
    let model = QuickReturn::default();
    let mut law = ConstantSpeed::new(&model, crank_speed);
    let start = law.kinematics(0.0)?.state();
    let step = 2.0 * TAU / crank_speed / (INTERVALS * STEPS) as f64;
    // Where the law finds no position its torque is no number, which the simulation reports.
    let mut inputs = law.clone();
    let mut simulation = Simulation::new(&model, start)
        .formulation(Baumgarte { alpha: STABILISATION, beta: STABILISATION })
        .inputs(Sampled(move |time: f64, _state: &State<_, _>| QuickReturnInputs {
            drive: inputs.torque(time).unwrap_or(f64::NAN),
            cutting: slider_force(time, crank_speed),
        }))
        .step(step);

    let mut recorder = Recorder::new(crank_speed, step);
    let mut progress = Progress::new(&format!("quick return at {crank_speed} rad/s"), INTERVALS * STEPS);
    for count in 0..=INTERVALS * STEPS {
        if count > 0 {
            simulation.advance()?;
        }
        let sample = simulation.sample();
        let powers = model.powers(sample.time, &sample.state, &sample.inputs);
        let outputs = sample.outputs;
        let without_inertia = law.torque_without_inertia(sample.time)?;
        recorder.step(&powers, [outputs.rate, outputs.stroke, sample.inputs.drive, without_inertia]);
        recorder.residual = recorder.residual.max(sample.constraint_residual().position);
        if count % STEPS == 0 {
            let (a, lambda) = (simulation.acceleration()?, simulation.multipliers()?);
            let motions = model.motions(sample.time, &sample.state.q, &sample.state.v, &a);
            let reactions = model.reactions(sample.time, &sample.state, &sample.inputs, &a, &lambda);
            let [motor, cut] = [sample.inputs.drive, sample.inputs.cutting];
            recorder.point(
                sample.time,
                [without_inertia, motor, cut],
                sample.kinetic_energy(),
                &motions,
                &reactions,
            );
            progress.at(count);
        }
    }
    Ok(recorder.finish(started.elapsed()))
}

/// What a run gathers step by step.
struct Recorder {
    crank_speed: f64,
    step: f64,
    /// Crank speed, slider position, torques (26) and (25) at each step.
    history: Vec<[f64; 4]>,
    /// Powers of the last three steps, W.
    powers: [[f64; 2]; 3],
    work: [f64; 2],
    points: Vec<Point>,
    frames: Vec<Frame>,
    residual: f64,
}

impl Recorder {
    fn new(crank_speed: f64, step: f64) -> Recorder {
        Recorder {
            crank_speed,
            step,
            history: Vec::new(),
            powers: [[0.0; 2]; 3],
            work: [0.0; 2],
            points: Vec::new(),
            frames: Vec::new(),
            residual: 0.0,
        }
    }

    fn step(&mut self, powers: &[f64; 2], history: [f64; 4]) {
        self.powers = [self.powers[1], self.powers[2], *powers];
        let count = self.history.len();
        self.history.push(history);
        if count > 0 && count.is_multiple_of(2) {
            // Simpson's rule over the last two steps.
            for (load, work) in self.work.iter_mut().enumerate() {
                let [before, between, now] = self.powers.map(|powers| powers[load]);
                *work += self.step / 3.0 * (before + 4.0 * between + now);
            }
        }
    }

    fn point(
        &mut self,
        time: f64,
        [torque_without_inertia, torque, force]: [f64; 3],
        kinetic: f64,
        motions: &[BodyMotion; QuickReturn::BODIES.len()],
        reactions: &[Reaction; QuickReturn::JOINTS.len()],
    ) {
        let [crank, guide, _, slider] = motions;
        let angle = |body: &BodyMotion| body.orientation[1].atan2(body.orientation[0]);
        self.points.push(Point {
            time,
            speed_deviation: crank.rate / self.crank_speed - 1.0,
            slider: [slider.position[0], slider.velocity[0], slider.acceleration[0]],
            force,
            torque_without_inertia,
            torque,
            kinetic,
            work: self.work,
            angles: [angle(crank), angle(guide)],
            reactions: reactions.map(|reaction| reaction.force[0].hypot(reaction.force[1])),
        });
        self.frames.push(Frame::of(time, motions));
    }

    fn finish(self, wall_time: Duration) -> Run {
        let first_stroke = self.history.len() / 2 + 1;
        let column = |index: usize| self.history[..first_stroke].iter().map(move |row| row[index]);
        let slider: Vec<f64> = column(1).collect();
        let torque: Vec<f64> = column(2).collect();
        let negative = |values: &[f64]| values.iter().map(|value| -value).collect::<Vec<_>>();
        let (right, left) = (peak(&slider), peak(&negative(&slider)));
        let (most, least) = (peak(&torque), peak(&negative(&torque)));
        let deviation = |row: &[f64; 4]| (row[0] / self.crank_speed - 1.0).abs();
        // The right end is at the start of each stroke.
        let period = (first_stroke - 1) as f64;
        let forward = (left.1 - right.1).rem_euclid(period) / period * 360.0;
        Run {
            crank_speed: self.crank_speed,
            steps: self.history.len() - 1,
            speed_deviation: self.history.iter().map(deviation).fold(0.0, f64::max),
            stroke: right.0 + left.0,
            forward,
            torque: [(most.0, most.1 * self.step), (-least.0, least.1 * self.step)],
            torque_without_inertia: peak(&column(3).collect::<Vec<_>>()).0,
            residual: self.residual,
            points: self.points,
            frames: self.frames,
            wall_time,
        }
    }
}

/// The largest of equidistant values and its index, between them by the parabola through three.
fn peak(values: &[f64]) -> (f64, f64) {
    let mut index = 0;
    for (k, value) in values.iter().enumerate() {
        if *value > values[index] {
            index = k;
        }
    }
    if index == 0 || index + 1 == values.len() {
        return (values[index], index as f64);
    }
    let [before, at, after] = [values[index - 1], values[index], values[index + 1]];
    let offset = 0.5 * (before - after) / (before - 2.0 * at + after);
    (at - 0.25 * (before - after) * offset, index as f64 + offset)
}

/// What was found, beside what is expected at 15 rad/s.
pub fn findings(runs: &[Run]) -> Table {
    let mut header = vec!["quick return".to_string()];
    header.extend(runs.iter().map(|run| format!("{} rad/s", run.crank_speed)));
    header.push("expected".to_string());
    let mut table = Table { header, rows: Vec::new() };
    let mut line = |what: &str, expected: &str, value: &dyn Fn(&Run) -> String| {
        let values = runs.iter().map(value);
        let cells = std::iter::once(what.to_string()).chain(values).chain([expected.to_string()]);
        table.row(cells);
    };
    let at_15 = |text: String| format!("{text} (15 rad/s)");
    line("crank speed: largest relative deviation", "0", &|run| format!("{:.1e}", run.speed_deviation));
    line("slider stroke (m)", &format!("{:.1}", expected::STROKE), &|run| format!("{:.9}", run.stroke));
    line("forward stroke (deg of crank)", &format!("{:.4}", expected::FORWARD), &|run| {
        format!("{:.4}", run.forward)
    });
    for (index, which) in ["largest", "smallest"].into_iter().enumerate() {
        let (value, time) = expected::TORQUE[index];
        line(&format!("torque (26): {which} (N m)"), &at_15(format!("{value:.3}")), &|run| {
            format!("{:.3}", run.torque[index].0)
        });
        line("… at time (s)", &at_15(format!("{time:.6}")), &|run| format!("{:.6}", run.torque[index].1));
    }
    let published = at_15(format!("{:.4}", expected::TORQUE_WITHOUT_INERTIA));
    line("torque (25): largest (N m)", &published, &|run| format!("{:.4}", run.torque_without_inertia));
    line("work of the torque, two strokes (J)", "", &|run| format!("{:.6}", run.work()[0]));
    line("work of the slider force (J)", "− work of the torque", &|run| format!("{:.6}", run.work()[1]));
    line("energy − work: largest, relative", "0", &|run| format!("{:.1e}", run.imbalance()));
    line("constraint residual: largest", "0", &|run| format!("{:.1e}", run.residual));
    line("steps", "", &|run| run.steps.to_string());
    line("computing time (s)", "", &|run| format!("{:.2}", run.wall_time.as_secs_f64()));
    table
}

/// The output points as a CSV file.
pub fn write(directory: &Path, run: &Run) -> io::Result<PathBuf> {
    let path = directory.join(format!("quick_return_{}_rad_s.csv", run.crank_speed));
    let mut header: Vec<String> = [
        "time_s",
        "crank_angle_rad",
        "crank_speed_relative_deviation",
        "guide_angle_rad",
        "slider_x_m",
        "slider_velocity_m_s",
        "slider_acceleration_m_s2",
        "slider_force_N",
        "torque_25_Nm",
        "torque_26_Nm",
        "kinetic_energy_J",
        "work_torque_J",
        "work_slider_force_J",
    ]
    .map(String::from)
    .to_vec();
    header.extend(QuickReturn::JOINTS.iter().map(|joint| format!("force_{joint}_N")));
    let rows = run.points.iter().map(|point| {
        let mut row = vec![point.time, point.angles[0], point.speed_deviation, point.angles[1]];
        row.extend(point.slider);
        row.extend([point.force, point.torque_without_inertia, point.torque, point.kinetic]);
        row.extend(point.work);
        row.extend(point.reactions);
        row
    });
    write_csv(&path, &header, rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_peak_between_samples_is_found() {
        let values: Vec<f64> = (0..10).map(|k| 3.0 - (k as f64 - 4.3).powi(2)).collect();
        let (value, index) = peak(&values);
        assert!((value - 3.0).abs() < 1e-12 && (index - 4.3).abs() < 1e-12);
    }

    #[test]
    fn the_published_numbers_are_met() {
        let run = run(15.0).unwrap();
        assert!(run.speed_deviation < 1e-9, "{:e}", run.speed_deviation);
        assert!((run.stroke - expected::STROKE).abs() < 1e-8);
        for ((value, time), (expected, at)) in run.torque.into_iter().zip(expected::TORQUE) {
            assert!((value - expected).abs() < 1e-3 && (time - at).abs() < 2e-6, "{value} at {time}");
        }
        assert!(run.imbalance() < 1e-9);
    }
}
