//! The quick return with a slender coupler that bends and stretches, at the four crank speeds of the source and with its sets of modes.
//!
//! Torque (26) of the rigid mechanism and slider force (24) drive it; the coupler starts straight and at rest in itself, and nothing damps
//! it. What is said about these runs is in `report.rs`.

use crate::runs::{INTERVALS, STABILISATION};
use crate::tables::{Table, write_csv};
use linkwright::{AssembleExt, Baumgarte, Sampled, Simulation, State};
use linkwright_examples::progress::Progress;
use linkwright_examples::quick_return::{ConstantSpeed, QuickReturn, slider_force};
use std::error::Error;
use std::f64::consts::{PI, TAU};
use std::io;
use std::path::{Path, PathBuf};

/// Length of the coupler, m, its Young's modulus, Pa, and diameter, m.
const LENGTH: f64 = 0.35;
const YOUNG: f64 = 207e9;
const DIAMETER: f64 = 7e-3;
/// Part of a turn that the forward stroke takes, (π + 2 asin ¾)/2π.
pub const FORWARD: f64 = 277.180_755_8 / 360.0;

macro_rules! flexible_quick_return {
    ($name:ident, ($($modes:tt)*), [$($output:ident: $way:ident $mode:tt),*]) => {
        linkwright::mechanism! {
            /// The quick return of the source with so many modes of its coupler.
            pub planar $name {
                const GUIDE [m] = 0.4;
                param speed [rad/s] = 20 in 1..100;
                input drive [N*m];
                input cutting [N];
                body crank   { mass [kg] = 0.368; inertia [kg*m^2] = 1.26069;
                               point pivot [m] = (-0.075, 0); point tip [m] = (0.075, 0); }
                body guide   { mass [kg] = 0.551; inertia [kg*m^2] = 0.00735;
                               point pivot [m] = (-GUIDE/2, 0); point tip [m] = (GUIDE/2, 0);
                               line slot = (guide.pivot, guide.tip); }
                beam coupler { length [m] = 0.35; section = circle(diameter [mm] = 7); young [GPa] = 207; density [kg/m^3] = 7801;
                               modes = ($($modes)*); }
                body slider  { mass [kg] = 2.206; inertia [kg*m^2] = 0.00184; }
                joint crank_pin: revolute(ground(0, 0) [m], crank.pivot);
                joint guide_pin: revolute(ground(0, -0.2) [m], guide.pivot);
                joint block:     point_on_line(guide.slot, crank.tip);
                joint knee:      revolute(guide.tip, coupler.end);
                joint wrist:     revolute(coupler.start, slider.center);
                joint rail:      prismatic(ground(0, 0.2) [m], slider.center, axis = (1, 0));
                force motor: torque(crank_pin) = drive;
                force cut:   force(slider.center, direction = (1, 0)) = cutting;
                start   { crank_pin.angle [rad] = 360 [deg] - asin(3/4); crank_pin.rate [rad/s] = speed;
                          guide_pin.angle [rad] ~ 0.7; coupler.angle [rad] ~ -0.4; rail.travel [m] ~ -0.02; }
                output rate [rad/s] = crank_pin.rate;
                $(output $output [m] = coupler.$way[$mode];)*
            }
        }
    };
}

flexible_quick_return!(WithTwoAndFive, (axial = 2, bending = 5),
    [a0: axial 0, a1: axial 1, b0: bending 0, b1: bending 1, b2: bending 2, b3: bending 3, b4: bending 4]);
flexible_quick_return!(WithThree, (bending = 3), [b0: bending 0, b1: bending 1, b2: bending 2]);
flexible_quick_return!(WithTwoAndThree, (axial = 2, bending = 3),
    [a0: axial 0, a1: axial 1, b0: bending 0, b1: bending 1, b2: bending 2]);

/// Two strokes with a coupler that bends.
pub struct Flexible {
    pub crank_speed: f64,
    pub steps: usize,
    /// The output points, [`INTERVALS`] + 1 of them.
    pub points: Vec<Bent>,
}

/// What is known at one output point, SI.
#[derive(Clone, Debug)]
pub struct Bent {
    pub time: f64,
    pub axial: Vec<f64>,
    pub bending: Vec<f64>,
    /// Force that presses the coupler together, the mean of its ends, N.
    pub thrust: f64,
    /// θ̇₁/ω − 1.
    pub speed_deviation: f64,
}

/// π² E I/L², the thrust under which the coupler between its hinges buckles, N.
pub fn euler() -> f64 {
    PI * PI * YOUNG * (PI * DIAMETER.powi(4) / 64.0) / (LENGTH * LENGTH)
}

impl Flexible {
    /// Turns of the crank at a time.
    pub fn turns(&self, time: f64) -> f64 {
        time * self.crank_speed / TAU
    }

    /// The largest of something in a part of the run, in turns of the crank.
    pub fn largest(&self, turns: std::ops::Range<f64>, of: impl Fn(&Bent) -> f64) -> f64 {
        let within = self.points.iter().filter(|point| turns.contains(&self.turns(point.time)));
        within.map(of).fold(0.0, f64::max)
    }

    /// When the thrust first passes Euler's load.
    pub fn buckles(&self) -> Option<&Bent> {
        self.points.iter().find(|point| point.thrust > euler())
    }

    /// The largest deflection of a mode in bending in the forward strokes, the first and the second, m.
    pub fn forward(&self, mode: usize) -> [f64; 2] {
        [0.0, 1.0].map(|from| self.largest(from..from + FORWARD, |point| point.bending[mode].abs()))
    }

    /// The same of the first mode along the coupler, if there are such.
    pub fn forward_along(&self) -> Option<[f64; 2]> {
        let along = |point: &Bent| point.axial.first().map_or(0.0, |a| a.abs());
        let has_axial = !self.points[0].axial.is_empty();
        has_axial.then(|| [0.0, 1.0].map(|from| self.largest(from..from + FORWARD, along)))
    }

    /// The largest of something in the whole run.
    pub fn most(&self, of: impl Fn(&Bent) -> f64) -> f64 {
        self.largest(0.0..f64::INFINITY, of)
    }
}

macro_rules! two_strokes {
    ($model:ident, $parameters:ident, $inputs:ident, $crank_speed:expr, $steps:expr, [$($axial:ident),*], [$($bending:ident),*]) => {{
        let (crank_speed, steps): (f64, usize) = ($crank_speed, $steps);
        let rigid = QuickReturn::<f64>::default();
        let mut law = ConstantSpeed::new(&rigid, crank_speed);
        let model = $model::prepare($parameters { speed: crank_speed })?;
        let start = model.assemble(&$model::START)?;
        let inputs = move |time: f64, _state: &State<_, _>| $inputs {
            drive: law.torque(time).unwrap_or(f64::NAN),
            cutting: slider_force(time, crank_speed),
        };
        let mut simulation = Simulation::new(&model, start)
            .formulation(Baumgarte { alpha: STABILISATION, beta: STABILISATION })
            .inputs(Sampled(inputs))
            .step(2.0 * TAU / crank_speed / (INTERVALS * steps) as f64);
        let joint = |name: &str| $model::JOINTS.iter().position(|known| *known == name);
        let (Some(knee), Some(wrist)) = (joint("knee"), joint("wrist")) else { return Err("joints of the coupler".into()) };
        let mut points = Vec::new();
        let mut progress = Progress::new(&format!("flexible quick return at {crank_speed} rad/s"), INTERVALS * steps);
        for count in 0..=INTERVALS * steps {
            if count > 0 {
                simulation.advance()?;
            }
            if count % steps > 0 {
                continue;
            }
            let sample = simulation.sample();
            let (a, lambda) = (simulation.acceleration()?, simulation.multipliers()?);
            let coupler = &model.motions(sample.time, &sample.state.q, &sample.state.v, &a)[2];
            let reactions = model.reactions(sample.time, &sample.state, &sample.inputs, &a, &lambda);
            let along = |force: [f64; 2]| force[0] * coupler.orientation[0] + force[1] * coupler.orientation[1];
            let outputs = &sample.outputs;
            points.push(Bent {
                time: sample.time,
                axial: vec![$(outputs.$axial),*],
                bending: vec![$(outputs.$bending),*],
                // The knee pushes the end towards the start, the coupler the slider away from its end.
                thrust: -0.5 * (along(reactions[knee].force) + along(reactions[wrist].force)),
                speed_deviation: outputs.rate / crank_speed - 1.0,
            });
            progress.at(count);
        }
        Flexible { crank_speed, steps: INTERVALS * steps, points }
    }};
}

/// Two strokes at one of the speeds of the source, with its modes; steps of an output interval.
pub fn run(crank_speed: f64, steps: usize) -> Result<Flexible, Box<dyn Error>> {
    Ok(match crank_speed {
        ..17.5 => two_strokes!(
            WithTwoAndFive,
            WithTwoAndFiveParameters,
            WithTwoAndFiveInputs,
            crank_speed,
            steps,
            [a0, a1],
            [b0, b1, b2, b3, b4]
        ),
        17.5..22.5 => {
            two_strokes!(
                WithThree,
                WithThreeParameters,
                WithThreeInputs,
                crank_speed,
                steps,
                [],
                [b0, b1, b2]
            )
        }
        _ => two_strokes!(
            WithTwoAndThree,
            WithTwoAndThreeParameters,
            WithTwoAndThreeInputs,
            crank_speed,
            steps,
            [a0, a1],
            [b0, b1, b2]
        ),
    })
}

/// What was found, by crank speed.
pub fn findings(runs: &[Flexible]) -> Table {
    let mut header = vec!["flexible coupler".to_string()];
    header.extend(runs.iter().map(|run| format!("{} rad/s", run.crank_speed)));
    let mut table = Table { header, rows: Vec::new() };
    let mut line = |what: &str, value: &dyn Fn(&Flexible) -> String| {
        table.row(std::iter::once(what.to_string()).chain(runs.iter().map(value)));
    };
    line("modes: axial, bending", &|run| {
        format!("{}, {}", run.points[0].axial.len(), run.points[0].bending.len())
    });
    let millimetres = |metres: f64| format!("{:.4}", 1e3 * metres);
    for (mode, which) in ["first", "second", "third"].into_iter().enumerate() {
        line(&format!("{which} mode in bending: largest (mm)"), &|run| {
            millimetres(run.most(|point| point.bending[mode].abs()))
        });
    }
    for (stroke, which) in ["first", "second"].into_iter().enumerate() {
        line(&format!("first mode in bending, {which} forward stroke (mm)"), &|run| {
            millimetres(run.forward(0)[stroke])
        });
    }
    for (stroke, which) in ["first", "second"].into_iter().enumerate() {
        line(&format!("first mode along, {which} forward stroke (mm)"), &|run| {
            run.forward_along().map_or("–".to_string(), |strokes| millimetres(strokes[stroke]))
        });
    }
    line("largest thrust, of Euler’s load", &|run| {
        format!("{:.3}", run.most(|point| point.thrust) / euler())
    });
    line("which it first passes after (turns)", &|run| {
        run.buckles().map_or("–".to_string(), |point| format!("{:.3}", run.turns(point.time)))
    });
    line("crank speed: largest relative deviation", &|run| {
        format!("{:.1e}", run.most(|point| point.speed_deviation.abs()))
    });
    line("steps", &|run| run.steps.to_string());
    table
}

/// The output points as a CSV file.
pub fn write(directory: &Path, run: &Flexible) -> io::Result<PathBuf> {
    let path = directory.join(format!("flexible_quick_return_{}_rad_s.csv", run.crank_speed));
    let first = &run.points[0];
    let modes = |way: &str, count: usize| (0..count).map(|k| format!("{way}_{k}_m")).collect::<Vec<_>>();
    let mut header = vec!["time_s".to_string()];
    header.extend(modes("axial", first.axial.len()));
    header.extend(modes("bending", first.bending.len()));
    header.extend(["thrust_N", "crank_speed_relative_deviation"].map(String::from));
    let rows = run.points.iter().map(|point| {
        let mut row = vec![point.time];
        row.extend(&point.axial);
        row.extend(&point.bending);
        row.extend([point.thrust, point.speed_deviation]);
        row
    });
    write_csv(&path, &header, rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// At 15 rad/s it bends in its first mode, and nothing of that is left after the fast return.
    #[test]
    fn slowly_only_the_first_mode_takes_part() {
        let run = run(15.0, 60).unwrap();
        let largest = |mode: usize| run.most(|point| point.bending[mode].abs());
        assert!((largest(0) / 3.177e-4 - 1.0).abs() < 2e-3, "{:e}", largest(0));
        assert!((1..5).all(|mode| largest(mode) < 0.055 * largest(0)));
        let [before, after] = run.forward(0);
        assert!((after / before - 1.0).abs() < 0.02, "{before:e} {after:e}");
        assert!(run.buckles().is_none());
    }

    /// At 30 rad/s bending dominates from the first fast return on. What oscillates along the coupler does so from the start, where the
    /// coupler is not stretched and the slider's inertia pulls at it, and as much after the return as before.
    #[test]
    fn fast_it_goes_on_bending_after_the_return() {
        let run = run(30.0, 32).unwrap();
        let [before, after] = run.forward(0);
        assert!(after > 3.0 * before, "{before:e} {after:e}");
        let [before, after] = run.forward_along().unwrap();
        assert!((after / before - 1.0).abs() < 0.05, "{before:e} {after:e}");
        let buckles = run.turns(run.buckles().unwrap().time);
        assert!((FORWARD..1.0).contains(&buckles), "{buckles}");
        assert!((3.4..4.0).contains(&(run.most(|point| point.thrust) / euler())));
    }
}
