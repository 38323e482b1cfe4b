//! The report: what is shown and said about the runs and the experiment.
//!
//! Uses the generic parts (`page.rs`, `plots.rs`, `drawing.rs`, `tables.rs`); all texts are here.

use crate::baumgarte::{self, ClosedLoop, Trial};
use crate::drawing::{self, Drawing, Readout};
use crate::flexible::{self, Bent, Flexible};
use crate::geometry::Geometry;
use crate::page::Page;
use crate::plots::{Axis, Curve, Plot};
use crate::runs::{self, Point, Run};
use crate::tables::escape;
use linkwright_examples::quick_return::QuickReturn;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

/// Writes the report and returns its path.
pub fn write(
    directory: &Path,
    runs: &[Run],
    bent: &[Flexible],
    trials: &[Trial],
) -> Result<PathBuf, Box<dyn Error>> {
    let mut page = Page::new(
        "Quick-return mechanism",
        "Rigid parts, driven by the torque that should keep the crank at constant speed; the same with a slender coupler that \
         bends; and what Baumgarte’s stabilisation does for a closed loop. Simulated with equations of motion that Linkwright derived at compile \
         time.",
    );
    summary(&mut page, runs, trials);
    mechanism(&mut page, &runs[0])?;
    loads(&mut page, runs)?;
    accuracy(&mut page, runs)?;
    flexibility(&mut page, bent)?;
    stabilisation(&mut page, trials)?;
    let path = directory.join("report.html");
    fs::write(&path, page.finish(SOURCES))?;
    Ok(path)
}

const SOURCES: &str = "Sources. Mechanism, tables and equations (24) to (26): G. Catania, A. Zanarini, <i>On the effects \
    of flexibility in a quick return planar mechanism</i>, University of Bologna; its rigid reference was recomputed in \
    closed form and by an independent integration. Experiment: S. Bai, lecture <i>Dynamics</i>, Aalborg University, \
    example 4; J. Baumgarte, <i>Stabilization of constraints and integrals of motion in dynamical systems</i>, Computer \
    Methods in Applied Mechanics and Engineering 1 (1972) 1–16. Written by <code>cargo run --release --example \
    quick_return</code>.";

fn summary(page: &mut Page, runs: &[Run], trials: &[Trial]) {
    let slow = &runs[0];
    let speed = runs.iter().map(|run| run.speed_deviation).fold(0.0, f64::max);
    let energy = runs.iter().map(Run::imbalance).fold(0.0, f64::max);
    let (drift, best) = (trials[0].end().position, trials[trials.len() - 1].end().position);
    page.facts(&[
        (scientific(speed), "largest relative deviation of the crank speed, which should stay constant"),
        (format!("{:.6} m", slow.stroke), "stroke of the slider (0.6 m by construction)"),
        (
            format!("{:.2} N m", slow.torque[0].0),
            "largest crank torque at 15 rad/s (recomputed from the source: 2027.13 N m)",
        ),
        (scientific(energy), "largest gap between kinetic energy and work, relative"),
        (
            format!("{} → {} m", scientific(drift), scientific(best)),
            "rms of constraint residuals after 100 s, without stabilisation and with α = β = 50 s⁻¹",
        ),
    ]);
}

fn mechanism(page: &mut Page, run: &Run) -> Result<(), Box<dyn Error>> {
    page.heading("The mechanism");
    page.paragraph(
        "The crank turns about a fixed pin; its tip slides in the slot of the guide, which swings about a pin 0.2 m \
         below. The coupler takes the guide’s tip to the slider, which moves on a rail 0.2 m above the crank’s pin. The \
         forward stroke, to the left, takes 277° of the crank; the return is quick: the remaining 83°.",
    );
    let geometry = Geometry::of(QuickReturn::DEFINITION)?;
    let readout = |label, unit, value: &dyn Fn(&Point) -> String| Readout {
        label,
        unit,
        values: run.points.iter().map(value).collect(),
    };
    let drawing = Drawing {
        geometry: &geometry,
        frames: &run.frames,
        traces: vec!["guide.tip", "coupler.center"],
        readouts: vec![
            readout("crank", "°", &|point| format!("{:.1}", point.angles[0].to_degrees().rem_euclid(360.0))),
            readout("slider", "m", &|point| format!("{:.4}", point.slider[0])),
            readout("its velocity", "m/s", &|point| format!("{:.3}", point.slider[1])),
            readout("slider force (24)", "N", &|point| format!("{:.1}", point.force)),
            readout("crank torque (26)", "N m", &|point| format!("{:.1}", point.torque)),
        ],
        speeds: vec![0.1, 0.02, 0.05, 0.25, 1.0],
        caption: format!(
            "Two strokes at {} rad/s, {:.3} s, slowed down. Thin lines: paths of the guide’s tip and of \
             the coupler’s centre; small dots: centres of mass.",
            run.crank_speed,
            run.points[run.points.len() - 1].time
        ),
    };
    page.element(&drawing.figure());
    page.script(drawing::SCRIPT);
    page.paragraph(&format!(
        "One degree of freedom; {} operations give all accelerations and the forces of the constraints.",
        QuickReturn::OPERATIONS
    ));
    page.element(&definition(QuickReturn::SOURCE));
    Ok(())
}

fn loads(page: &mut Page, runs: &[Run]) -> Result<(), Box<dyn Error>> {
    page.heading("Motion, loads and joint forces");
    page.paragraph(
        "The slider force (24) opposes the forward stroke. The torque (26) balances it and accelerates the parts, so that \
         the crank turns at constant speed; it is a function of time alone, computed beforehand from the kinematics. \
         Without inertia the torque (25) would do.",
    );
    let slow = &runs[0];
    let turns = "crank turns";
    let plots = [
        Plot {
            title: "Slider".into(),
            caption: "Position, and velocity divided by the crank speed: the same curves at any speed. Slow to the left, \
                      quick back to the right."
                .into(),
            x: Axis::linear(turns),
            y: Axis::linear("m, m/rad"),
            curves: vec![
                curve("position x₄ (m)", 0, slow, |point| point.slider[0]),
                curve("velocity ẋ₄/ω (m/rad)", 1, slow, |point| point.slider[1] / slow.crank_speed),
            ],
        },
        Plot {
            title: "Slider force and the torque that balances it".into(),
            caption: "Laws (24) and (25): the same at any crank speed, when shown over its angle.".into(),
            x: Axis::linear(turns),
            y: Axis::linear("N, N m"),
            curves: vec![
                curve("slider force (24), N", 0, slow, |point| point.force),
                curve("crank torque (25), N m", 1, slow, |point| point.torque_without_inertia),
            ],
        },
        Plot {
            title: "Crank torque with inertia".into(),
            caption: "Law (26). Inertia asks for a hundred times the torque of the slider force, and for four times as \
                      much at twice the speed."
                .into(),
            x: Axis::linear(turns),
            y: Axis::linear("crank torque (26) (N m)"),
            curves: by_speed(runs, |_, point| point.torque),
        },
        Plot {
            title: format!("Forces in the joints at {} rad/s", slow.crank_speed),
            caption: "Magnitudes. The quick return loads the joints: the guide’s block, and with it the crank’s pin (not shown), carry the most.".into(),
            x: Axis::linear(turns),
            y: Axis::linear("force (N)"),
            curves: ["block", "guide_pin", "knee", "rail"]
                .into_iter()
                .enumerate()
                .filter_map(|(colour, name)| {
                    let joint = QuickReturn::JOINTS.iter().position(|joint| *joint == name)?;
                    Some(curve(name, colour, slow, |point| point.reactions[joint]))
                })
                .collect(),
        },
    ];
    figures(page, &plots)
}

fn accuracy(page: &mut Page, runs: &[Run]) -> Result<(), Box<dyn Error>> {
    page.heading("What was found");
    page.paragraph(&format!(
        "Runge–Kutta of order 4 with {} steps for two strokes, constraints stabilised with α = β = {} s⁻¹, {} output points.",
        runs[0].steps,
        runs::STABILISATION,
        runs::INTERVALS + 1
    ));
    page.table(&runs::findings(runs));
    let plots = [
        Plot {
            title: "Crank speed".into(),
            caption: "The torque is an open-loop function of time: nothing holds the speed but the agreement of dynamics \
                      and kinematics. What is left is the error of the integration."
                .into(),
            x: Axis::linear("crank turns"),
            y: Axis::logarithmic("|θ̇₁/ω − 1|"),
            curves: by_speed(runs, |_, point| point.speed_deviation.abs()),
        },
        Plot {
            title: "Energy".into(),
            caption: "Kinetic energy without the work of torque and slider force since the start, relative to the largest \
                      kinetic energy."
                .into(),
            x: Axis::linear("crank turns"),
            y: Axis::logarithmic("|E − E₀ − W| / E max"),
            curves: by_speed(runs, |run, point| {
                let largest = run.points.iter().map(|point| point.kinetic).fold(0.0, f64::max);
                (point.imbalance(run.points[0].kinetic) / largest).abs()
            }),
        },
    ];
    figures(page, &plots)
}

fn flexibility(page: &mut Page, runs: &[Flexible]) -> Result<(), Box<dyn Error>> {
    page.heading("A coupler that bends");
    page.paragraph(&format!(
        "The coupler as a round bar of steel of 7 mm in a floating frame, with free–free modes in bending and along it, as many as \
         the source takes at each speed; straight and at rest in itself at the start, without damping, under torque (26) of the \
         rigid mechanism and slider force (24); two strokes, {} output points.",
        runs::INTERVALS + 1
    ));
    page.table(&flexible::findings(runs));
    let over = |label: &str, colour: usize, run: &Flexible, of: &dyn Fn(&Bent) -> f64| Curve {
        label: label.to_string(),
        colour,
        dashed: false,
        points: run.points.iter().map(|point| (run.turns(point.time), of(point))).collect(),
    };
    let name = |run: &Flexible| format!("{} rad/s", run.crank_speed);
    let each = |of: &dyn Fn(&Bent) -> f64| -> Vec<Curve> {
        runs.iter().enumerate().map(|(colour, run)| over(&name(run), colour, run, of)).collect()
    };
    let slow = &runs[0];
    let mut thrusts = each(&|point| point.thrust / flexible::euler());
    thrusts.push(Curve {
        label: "Euler’s load".into(),
        colour: runs.len(),
        dashed: true,
        points: vec![(0.0, 1.0), (2.0, 1.0)],
    });
    let stretched = runs.iter().enumerate().filter(|(_, run)| !run.points[0].axial.is_empty());
    let turns = "crank turns";
    let plots = [
        Plot {
            title: "Bending: the first mode".into(),
            caption: "The ends move by twice this. At 15 rad/s it is back at rest after each fast return; at 30 rad/s it goes on \
                      oscillating, and the forward stroke bends more by that than by its own loads."
                .into(),
            x: Axis::linear(turns),
            y: Axis::linear("first mode in bending (mm)"),
            curves: each(&|point| 1e3 * point.bending[0]),
        },
        Plot {
            title: format!("All modes in bending at {}", name(slow)),
            caption: "Only the first takes part: the others stay below 6 % of it.".into(),
            x: Axis::linear(turns),
            y: Axis::linear("modes in bending (mm)"),
            curves: ["first", "second", "third", "fourth", "fifth"]
                .into_iter()
                .enumerate()
                .map(|(mode, label)| over(label, mode, slow, &|point| 1e3 * point.bending[mode]))
                .collect(),
        },
        Plot {
            title: "Along the coupler: the first mode".into(),
            caption: "It follows the force that the slider takes, and oscillates about that from the start, where the coupler is not \
                      stretched and the slider’s inertia pulls at it at once. The fast return adds nothing that stays."
                .into(),
            x: Axis::linear(turns),
            y: Axis::linear("first mode along (mm)"),
            curves: stretched.map(|(colour, run)| over(&name(run), colour, run, &|point| 1e3 * point.axial[0])).collect(),
        },
        Plot {
            title: "Thrust in the coupler".into(),
            caption: format!("The mean of both ends, of Euler’s load, {:.0} N.", flexible::euler()),
            x: Axis::linear(turns),
            y: Axis::linear("thrust, of Euler’s load"),
            curves: thrusts,
        },
    ];
    figures(page, &plots)?;
    let passed: Vec<String> = runs
        .iter()
        .filter_map(|run| {
            let most = run.most(|point| point.thrust) / flexible::euler();
            Some(format!(
                "at {} after {:.2} turns, up to {most:.1} times",
                name(run),
                run.turns(run.buckles()?.time)
            ))
        })
        .collect();
    page.paragraph(&format!(
        "The thrust of the fast return passes Euler’s load {}. Equations whose stiffness is constant, the source’s and these, know \
         nothing of that: a real bar would buckle there as far as the short time allows, and these curves say how the linear \
         model moves and not how the machine would. <code>stiffening = on</code> lets a thrust soften the coupler.",
        if passed.is_empty() { "at no speed".to_string() } else { passed.join("; ") }
    ));
    Ok(())
}

fn stabilisation(page: &mut Page, trials: &[Trial]) -> Result<(), Box<dyn Error>> {
    page.heading("Baumgarte’s stabilisation");
    page.paragraph(&format!(
        "Equations of motion hold constraints at the level of accelerations, Φ̈ = 0, which lets errors of the integration \
         grow: Φ = a₁ + a₂ t for each perturbation. Baumgarte replaces that by Φ̈ + 2α Φ̇ + β² Φ = 0, under which they \
         decay. Here a crank-rocker of our own turns over under gravity, in absolute coordinates, so that all {} \
         constraint rows can drift; Runge–Kutta of order 4 with a step of {} ms.",
        trials_rows(),
        1e3 * baumgarte::STEP
    ));
    let residuals = |title: &str, label, of: &dyn Fn(&baumgarte::Window) -> f64| Plot {
        title: title.into(),
        caption: format!("Root mean square of all rows over {} s.", baumgarte::WINDOW),
        x: Axis::linear("time (s)"),
        y: Axis::logarithmic(label),
        curves: trials
            .iter()
            .enumerate()
            .map(|(colour, trial)| Curve {
                label: trial.name(),
                colour,
                dashed: trial.rate.is_none(),
                points: trial.windows.iter().map(|window| (window.time, of(window))).collect(),
            })
            .collect(),
    };
    let plots = [
        residuals("Residuals of positions", "rms of Φ (m)", &|window| window.position),
        residuals("Residuals of velocities", "rms of Φ̇ (m/s)", &|window| window.velocity),
    ];
    figures(page, &plots)?;
    page.table(&baumgarte::findings(trials));
    page.paragraph(
        "Without stabilisation the drift has no bound: errors of velocities add up, and those of positions with them, so \
         that positions leave the constraints with the square of time. With it, residuals stay where new errors and their \
         decay balance. Positions follow the constraints better the larger α and β, still at 50, as in the lecture. For \
         velocities the best values are near the rate of the motion itself (the crank turns at some 15 rad/s): stronger \
         feedback adds truncation errors of its own. The order of the curves depends on the motion: from a slow start (5 or \
         8 rad/s) the positions are already better at 10 than at 50, at every step from 1 to 10 ms.",
    );
    let geometry = Geometry::of(ClosedLoop::DEFINITION)?;
    let drawings: Vec<String> = [0, 3].iter().map(|index| end_of(&trials[*index], &geometry)).collect();
    page.figures(&drawings);
    page.script(drawing::SCRIPT);
    page.element(&definition(ClosedLoop::SOURCE));
    Ok(())
}

/// The drawing of a run's last seconds.
fn end_of(trial: &Trial, geometry: &Geometry) -> String {
    let frames = &trial.frames;
    let (from, to) = (frames[0].time, frames[frames.len() - 1].time);
    let drawing = Drawing {
        geometry,
        frames,
        traces: vec!["coupler.center", "rocker.end"],
        readouts: Vec::new(),
        speeds: vec![0.1, 0.25, 0.5, 1.0],
        caption: format!(
            "<b>{}</b>, {from:.0} s to {to:.0} s: rms of Φ {:.1e} m.",
            trial.name(),
            trial.end().position
        ),
    };
    drawing.figure()
}

fn figures(page: &mut Page, plots: &[Plot]) -> Result<(), Box<dyn Error>> {
    let figures = plots.iter().map(Plot::figure).collect::<Result<Vec<_>, _>>()?;
    page.figures(&figures);
    Ok(())
}

fn curve(label: &str, colour: usize, run: &Run, of: impl Fn(&Point) -> f64) -> Curve {
    let points = run.points.iter().map(|point| (run.turns(point.time), of(point))).collect();
    Curve { label: label.to_string(), colour, dashed: false, points }
}

/// One curve for each run.
fn by_speed(runs: &[Run], of: impl Fn(&Run, &Point) -> f64) -> Vec<Curve> {
    let curve = |(colour, run): (usize, &Run)| {
        curve(&format!("{} rad/s", run.crank_speed), colour, run, |point| of(run, point))
    };
    runs.iter().enumerate().map(curve).collect()
}

fn trials_rows() -> usize {
    linkwright::Mechanism::rows(&<ClosedLoop>::default()).len()
}

/// What a mechanism is derived from, folded away.
fn definition(source: &str) -> String {
    format!(
        "<details><summary>The definition from which it was derived</summary><pre><code>{}</code></pre></details>",
        escape(source)
    )
}

/// Two digits and a power of ten.
fn scientific(value: f64) -> String {
    let text = format!("{value:.1e}");
    match text.split_once('e') {
        Some((digits, exponent)) => format!("{digits}·10<sup>{}</sup>", exponent.replace('-', "−")),
        None => text,
    }
}
