//! Computed torque on the delta robot: at each tick of 1 ms the torques that give the platform's motion the accelerations asked for, against
//! control of each arm by itself.
//!
//! ```text
//! cargo run --release -p linkwright-models --example computed_torque               writes computed_torque.svg in the target directory
//! cargo run --release -p linkwright-models --example computed_torque -- FILE.svg
//! ```
//! s̈ = s̈_d + 2 ω (ṡ_d − ṡ) + ω² (s_d − s) for the three arms; `Reduced` makes accelerations of the whole of these, `Actuators` the torques. The
//! other controller has the same ω, and for each arm the inertia and the weight that it has at the start, without the others. Source: Spong, Hutchinson, Vidyasagar, *Robot Modeling
//! and Control*, 8.3.

use linkwright::{Actuators, AssembleExt, Reduced, Rk4, Stepper, coordinate_rates, coordinate_values};
use linkwright_examples::plots::{Curve, Panel, draw};
use linkwright_models::delta_robot::{DeltaRobot, DeltaRobotInputs};
use std::error::Error;

/// The tick, s, and how many there are.
const TICK: f64 = 1e-3;
const TICKS: usize = 3000;
/// rad/s.
const OMEGA: f64 = 25.0;

fn main() -> Result<(), Box<dyn Error>> {
    let computed = run(true)?;
    let alone = run(false)?;
    println!(
        "largest error of an arm after half a second: {:.2e} rad, each arm by itself {:.2e} rad",
        computed.worst, alone.worst
    );
    println!("largest torque {:.1} N m; the loops are closed to {:.1e} m", computed.torque, computed.closed);
    assert!(computed.worst < 2e-4 && computed.worst < 0.05 * alone.worst);
    assert!(computed.closed < 1e-8);
    let panels = [
        Panel {
            label: "error of the first arm, rad",
            curves: vec![
                Curve { label: "computed torque", points: computed.errors },
                Curve { label: "each arm by itself", points: alone.errors },
            ],
        },
        Panel {
            label: "torque on the first arm, N m",
            curves: vec![
                Curve { label: "computed torque", points: computed.torques },
                Curve { label: "each arm by itself", points: alone.torques },
            ],
        },
    ];
    let file = draw("computed_torque", "Delta robot on a fast path", "time, s", &panels)?;
    println!("{} shows both", file.display());
    Ok(())
}

/// Angle, rate and acceleration that an arm should have.
fn wanted(arm: usize, time: f64) -> [f64; 3] {
    let (size, rate, phase) = (0.25, 9.0, std::f64::consts::TAU / 3.0 * arm as f64);
    let (s, c) = (rate * time + phase).sin_cos();
    [std::f64::consts::FRAC_PI_6 + size * s, size * rate * c, -size * rate * rate * s]
}

struct Run {
    /// Of the first arm, over time.
    errors: Vec<(f64, f64)>,
    torques: Vec<(f64, f64)>,
    worst: f64,
    torque: f64,
    closed: f64,
}

fn run(computed: bool) -> Result<Run, Box<dyn Error>> {
    let model = DeltaRobot::<f64>::default();
    let motors = Actuators::named(&model, ["torque[0]", "torque[1]", "torque[2]"])?;
    let mut plant: Stepper<_> = model.stepper(model.start(), Rk4);
    let mut inputs = DeltaRobotInputs { torque_0: 0.0, torque_1: 0.0, torque_2: 0.0 };
    // Each arm by itself has the inertia and the weight that it has at the start.
    let start = Reduced::at(&model, 0.0, plant.state(), &inputs)?;
    let (weight, inertia) = (start.gravity().to_vec(), start.mass_matrix()[0]);
    let mut run = Run { errors: Vec::new(), torques: Vec::new(), worst: 0.0, torque: 0.0, closed: 0.0 };
    for _ in 0..TICKS {
        let (time, state) = (plant.time(), plant.state());
        let (angles, rates) =
            (coordinate_values(&model, time, &state.q), coordinate_rates(&model, time, &state.q, &state.v));
        let mut asked = [0.0; 3];
        for (arm, (asked, index)) in
            asked.iter_mut().zip(linkwright::Assemble::<f64>::independent(&model)).enumerate()
        {
            let [position, rate, acceleration] = wanted(arm, time);
            let error = position - angles[usize::from(*index)];
            *asked = acceleration + 2.0 * OMEGA * (rate - rates[usize::from(*index)]) + OMEGA * OMEGA * error;
            if arm == 0 {
                run.errors.push((time, error));
            }
            if time > 0.5 {
                run.worst = run.worst.max(error.abs());
            }
        }
        inputs = if computed {
            let a = Reduced::at(&model, time, state, &inputs)?.acceleration(&asked);
            motors.inputs_for(&model, (time, state), &a, &inputs)?.inputs
        } else {
            let torque = |arm: usize| inertia * asked[arm] + weight[arm];
            DeltaRobotInputs { torque_0: torque(0), torque_1: torque(1), torque_2: torque(2) }
        };
        run.torques.push((time, inputs.torque_0));
        run.torque = run.torque.max(inputs.torque_0.abs());
        plant.step(&inputs, TICK)?;
        run.closed = run.closed.max(plant.constraint_residual().position);
    }
    Ok(run)
}
