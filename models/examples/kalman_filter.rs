//! An extended Kalman filter on a four-bar: the crank's angle and rate from a noisy camera that follows a point of the coupler.
//!
//! ```text
//! cargo run --release -p linkwright-models --example kalman_filter               writes kalman_filter.svg in the target directory
//! cargo run --release -p linkwright-models --example kalman_filter -- FILE.svg
//! ```
//! The true mechanism is pushed by a torque that nobody measures. At each tick of 2 ms the estimate x = (θ, θ̇) and its covariance go on by the step
//! and its exact derivative (`step_map`); at each fifth the camera gives y with 5 mm of noise, C is that of `output_matrices`, and the estimate is
//! brought onto the constraints by what it says of the crank (`measured`). Source: Simon, *Optimal State Estimation*, 13.2.

use linkwright::{
    Assemble, AssembleExt, Linearisation, Mechanism, Reading, Rk4, State, StateOf, Stepper, coordinate_rates,
    coordinate_values, measured, mechanism, step_map,
};
use linkwright_examples::plots::{Curve, Panel, draw};
use std::error::Error;

mechanism! {
    /// A crank-rocker with a motor, a disturbance and a camera.
    pub planar Linkage {
        input drive [N*m];
        input disturbance [N*m];
        gravity [m/s^2] = (0, -9.81);
        body crank   { mass [kg] = 0.71; inertia [kg*m^2] = 0.013; center [m] = (0.17, 0.033); point tip [m] = (0.4, 0); }
        body coupler { mass [kg] = 1.93; inertia [kg*m^2] = 0.187; center [m] = (0.43, -0.12);
                       point tip [m] = (1.0, 0); point tracer [m] = (0.62, 0.29); }
        body rocker  { mass [kg] = 1.37; inertia [kg*m^2] = 0.091; center [m] = (0.52, 0.071); point tip [m] = (0.9, 0); }
        joint crank_pin:  revolute(ground(-0.15, 0.24) [m], crank.origin);
        joint rocker_pin: revolute(ground(0.93, 0.45) [m], rocker.origin);
        joint left:  revolute(crank.tip, coupler.origin);
        joint right: revolute(coupler.tip, rocker.tip);
        torque motor: torque(crank_pin) = drive;
        torque wind:  torque(crank_pin) = disturbance;
        start { crank_pin.angle [deg] = 40; crank_pin.rate [rad/s] = 6; rocker_pin.angle [deg] ~ 100; coupler.angle [deg] ~ 40; }
        options { emit = (tangent); }
        expect { degrees_of_freedom = 1; rotates = crank_pin; no_singularity; }
        output x [m] = coupler.tracer.x;
        output y [m] = coupler.tracer.y;
    }
}

/// s.
const TICK: f64 = 2e-3;
const TICKS: usize = 2500;
/// A picture every so many ticks.
const PICTURE: usize = 5;
/// Of the camera, m, and of the torque that is not known, N m, as standard deviations.
const CAMERA: f64 = 5e-3;
const TORQUE: f64 = 2.0;

/// Gauss's numbers, the same in every run (a linear congruence and the polar method of Box and Muller).
struct Noise(u64);

impl Noise {
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 11) as f64 + 0.5) / (1_u64 << 53) as f64
    }

    fn normal(&mut self) -> f64 {
        (-2.0 * self.uniform().ln()).sqrt() * (std::f64::consts::TAU * self.uniform()).cos()
    }
}

/// What is believed: a state and the covariance of (θ, θ̇).
struct Estimate {
    state: StateOf<Linkage>,
    covariance: [[f64; 2]; 2],
}

fn main() -> Result<(), Box<dyn Error>> {
    let model = Linkage::<f64>::default();
    let crank = model.independent()[0];
    let mut noise = Noise(7);
    let mut plant: Stepper<_> = model.stepper(model.start(), Rk4);
    let wrong = Reading { coordinate: crank, position: 1.0, rate: 4.0 };
    let mut estimate = Estimate {
        state: measured(&model, 0.0, &model.start(), &[wrong])?,
        covariance: [[0.1, 0.0], [0.0, 4.0]],
    };
    let (mut angle, mut rate, mut band) = (Vec::new(), Vec::new(), Vec::new());
    let (mut raw, mut squares, mut surprise, mut count) = (0.0, [0.0; 2], 0.0, 0);
    for tick in 0..TICKS {
        let time = plant.time();
        let drive = 1.5 + 4.0 * (1.3 * time).sin();
        let known = LinkageInputs { drive, disturbance: 0.0 };
        if tick % PICTURE == 0 {
            let seen = plant.outputs(&known);
            let picture = [seen.x + CAMERA * noise.normal(), seen.y + CAMERA * noise.normal()];
            correct(&model, time, crank, &mut estimate, &known, picture)?;
        }
        let off = difference(&model, time, crank, plant.state(), &estimate.state);
        angle.push((time, off[0]));
        rate.push((time, off[1]));
        band.push((time, estimate.covariance[0][0].sqrt()));
        if time > 1.0 {
            (squares[0], squares[1], count) =
                (squares[0] + off[0] * off[0], squares[1] + off[1] * off[1], count + 1);
            surprise += normalised(&estimate.covariance, off);
            // What a picture alone would say of the angle, at the best place of the coupler's curve.
            raw = CAMERA / 0.4;
        }
        // The torque that nobody knows is another one in every tick.
        let truth = LinkageInputs { drive, disturbance: TORQUE * noise.normal() };
        plant.step(&truth, TICK)?;
        predict(&model, time, &mut estimate, &known)?;
    }
    let [angle_error, rate_error] = squares.map(|sum| (sum / f64::from(count)).sqrt());
    let surprise = surprise / f64::from(count);
    println!("after a second: {angle_error:.2e} rad and {rate_error:.2e} rad/s as standard deviations");
    println!(
        "a picture alone: {raw:.2e} rad; squared errors in units of the covariance: {surprise:.2} (2 expected)"
    );
    assert!(angle_error < 0.6 * raw && rate_error < 0.2, "the filter does not follow");
    assert!((0.5..4.0).contains(&surprise), "the filter does not know what it does not know");
    let below = band.iter().map(|(time, sigma)| (*time, -sigma)).collect();
    let panels = [
        Panel {
            label: "error of the crank's angle, rad",
            curves: vec![
                Curve { label: "error", points: angle },
                Curve { label: "σ of the filter", points: band },
                Curve { label: "−σ", points: below },
            ],
        },
        Panel { label: "error of its rate, rad/s", curves: vec![Curve { label: "error", points: rate }] },
    ];
    let file = draw("kalman_filter", "Four-bar, followed by a camera", "time, s", &panels)?;
    println!("{} shows the errors", file.display());
    Ok(())
}

/// x ← F(x), P ← A_d P A_dᵀ + B_w σ² B_wᵀ.
fn predict(
    model: &Linkage,
    time: f64,
    estimate: &mut Estimate,
    known: &LinkageInputs,
) -> Result<(), Box<dyn Error>> {
    let step = step_map(model, &Rk4, (time, &estimate.state), known, TICK)?;
    let ([a, b, c, d], p) = (step.a, estimate.covariance);
    let rows = [[a, b], [c, d]];
    // The second column of B_d is that of the disturbance.
    let wind = [step.b[1], step.b[3]];
    estimate.covariance = std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let sum = (0..2).flat_map(|k| (0..2).map(move |l| (k, l)));
            let carried: f64 = sum.map(|(k, l)| rows[i][k] * p[k][l] * rows[j][l]).sum();
            carried + wind[i] * wind[j] * TORQUE * TORQUE
        })
    });
    estimate.state = step.state;
    Ok(())
}

/// x ← x + K (y − h(x)), one coordinate of the picture after the other, and back onto the constraints.
fn correct(
    model: &Linkage,
    time: f64,
    crank: u16,
    estimate: &mut Estimate,
    known: &LinkageInputs,
    picture: [f64; 2],
) -> Result<(), Box<dyn Error>> {
    let here = Linearisation::at(model, time, &estimate.state, known)?;
    let (c, _) = here.output_matrices()?;
    let outputs = model.outputs(time, &estimate.state, known);
    let (mut x, mut p) = ([0.0; 2], estimate.covariance);
    for (row, innovation) in [picture[0] - outputs.x, picture[1] - outputs.y].into_iter().enumerate() {
        let c = [c[2 * row], c[2 * row + 1]];
        let pc: [f64; 2] = std::array::from_fn(|i| p[i][0] * c[0] + p[i][1] * c[1]);
        let size = CAMERA * CAMERA + c[0] * pc[0] + c[1] * pc[1];
        let left = innovation - c[0] * x[0] - c[1] * x[1];
        x = std::array::from_fn(|i| x[i] + pc[i] / size * left);
        p = std::array::from_fn(|i| std::array::from_fn(|j| p[i][j] - pc[i] * pc[j] / size));
    }
    let [position, rate] = read(model, time, crank, &estimate.state);
    let reading = Reading { coordinate: crank, position: position + x[0], rate: rate + x[1] };
    estimate.state = measured(model, time, &estimate.state, &[reading])?;
    estimate.covariance = p;
    Ok(())
}

/// θ and θ̇.
fn read(model: &Linkage, time: f64, crank: u16, state: &StateOf<Linkage>) -> [f64; 2] {
    let State { q, v, .. } = state;
    let values = coordinate_values(model, time, q);
    let rates = coordinate_rates(model, time, q, v);
    [values.as_slice()[usize::from(crank)], rates.as_slice()[usize::from(crank)]]
}

/// How far the estimate is off.
fn difference(
    model: &Linkage,
    time: f64,
    crank: u16,
    truth: &StateOf<Linkage>,
    found: &StateOf<Linkage>,
) -> [f64; 2] {
    let (truth, found) = (read(model, time, crank, truth), read(model, time, crank, found));
    let angle = found[0] - truth[0];
    [angle - (angle / std::f64::consts::TAU).round() * std::f64::consts::TAU, found[1] - truth[1]]
}

/// eᵀ P⁻¹ e.
fn normalised([[a, b], [_, d]]: &[[f64; 2]; 2], e: [f64; 2]) -> f64 {
    (d * e[0] * e[0] - 2.0 * b * e[0] * e[1] + a * e[1] * e[1]) / (a * d - b * b)
}
