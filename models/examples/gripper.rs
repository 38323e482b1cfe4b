//! A gripper with a motor and a gearbox: it closes by position, feels its object, and goes on by force.
//!
//! ```text
//! cargo run --release -p linkwright-models --example gripper               writes gripper.svg in the target directory
//! cargo run --release -p linkwright-models --example gripper -- FILE.svg
//! ```
//! A direct-current motor with inductance turns the left finger through a gear of 60; a gear between the fingers turns the right one the other way. Each
//! finger is a parallelogram, so that its jaw stays upright. The object is two springs that push where a jaw is closer than its half width.
//! While it closes the torque is that of the inertia and the bias of `Reduced` along the finger's angle (computed torque), then that of the grip; the
//! voltage follows the current asked for by the motor's data.

use linkwright::{
    AssembleExt, Reduced, Rk4, State, Stepper, coordinate, coordinate_rates, coordinate_values, mechanism,
};
use linkwright_examples::plots::{Curve, Panel, draw};
use std::error::Error;

mechanism! {
    /// Two fingers on parallelograms, a motor, two gears.
    pub planar Gripper {
        const RATIO = 60;
        const LENGTH [m] = 0.08;
        param resistance [ohm] = 1.2;
        param inductance [mH] = 0.8;
        param constant [N*m/A] = 0.02;
        param half_width [m] = 0.03;
        param stiffness [N/m] = 20000;
        param damping [N*s/m] = 40;
        input voltage [V];
        gravity [m/s^2] = (0, -9.81);

        /// Through the motor.
        state current [A] = 0;
        rate  current = (voltage - resistance*current - constant*shaft.rate)/inductance;

        body rotor { mass [kg] = 0.05; inertia [kg*m^2] = 2e-6; }
        joint  shaft: revolute(ground(0, -0.05) [m], rotor.center);
        torque motor: torque(shaft) = constant*current - 2e-6 [N*m*s]*shaft.rate;

        rod left        { mass [kg] = 0.05; length = LENGTH; }
        rod left_guide  { mass [kg] = 0.03; length = LENGTH; }
        body left_jaw   { mass [kg] = 0.08; inertia [kg*m^2] = 2e-5; point foot [m] = (-0.01, 0); point heel [m] = (-0.03, 0);
                          point pad [m] = (0, 0.03); }
        joint left_pin:   revolute(ground(-0.04, 0) [m], left.start);
        joint left_post:  revolute(ground(-0.06, 0) [m], left_guide.start);
        joint left_knee:  revolute(left.end, left_jaw.foot);
        joint left_wrist: revolute(left_guide.end, left_jaw.heel);

        rod right       { mass [kg] = 0.05; length = LENGTH; }
        rod right_guide { mass [kg] = 0.03; length = LENGTH; }
        body right_jaw  { mass [kg] = 0.08; inertia [kg*m^2] = 2e-5; point foot [m] = (0.01, 0); point heel [m] = (0.03, 0);
                          point pad [m] = (0, 0.03); }
        joint right_pin:   revolute(ground(0.04, 0) [m], right.start);
        joint right_post:  revolute(ground(0.06, 0) [m], right_guide.start);
        joint right_knee:  revolute(right.end, right_jaw.foot);
        joint right_wrist: revolute(right_guide.end, right_jaw.heel);

        gear gearbox: gear(shaft, left_pin, ratio = RATIO);
        gear between: gear(left_pin, right_pin, ratio = -1);

        // How far a jaw is in the object.
        signal left_in [m] = left_jaw.pad.x + half_width;
        signal right_in [m] = half_width - right_jaw.pad.x;
        signal left_grip [N] = max(0 [N], stiffness*left_in + damping*left_jaw.pad.velocity.x)*step(left_in/1 [m]);
        signal right_grip [N] = max(0 [N], stiffness*right_in - damping*right_jaw.pad.velocity.x)*step(right_in/1 [m]);
        force left_touch:  force(left_jaw.pad, direction = (-1, 0)) = left_grip;
        force right_touch: force(right_jaw.pad, direction = (1, 0)) = right_grip;

        start { left_pin.angle [deg] = 130; left_pin.rate [rad/s] = 0; left_guide.angle [deg] ~ 130; left_jaw.angle [rad] ~ 0;
                right_pin.angle [deg] ~ 50; right_guide.angle [deg] ~ 50; right_jaw.angle [rad] ~ 0; shaft.angle [rad] ~ 0; }
        expect { degrees_of_freedom = 1; }
        output left_grip [N] = left_grip;
        output right_grip [N] = right_grip;
        output gap [m] = right_jaw.pad.x - left_jaw.pad.x;
        output current [A] = current;
    }
}

/// The tick, s, and how many there are.
const TICK: f64 = 1e-4;
const TICKS: usize = 12_000;
/// The force on the object, N.
const GRIP: f64 = 25.0;
/// Of the gearbox, and of a finger, m.
const RATIO: f64 = 60.0;
const LENGTH: f64 = 0.08;

fn main() -> Result<(), Box<dyn Error>> {
    let model = Gripper::<f64>::default();
    let parameters = *model.parameters();
    let shaft = coordinate(&model, "left_pin.angle")?;
    let mut plant: Stepper<_> = model.stepper(model.start(), Rk4);
    let mut inputs = GripperInputs { voltage: 0.0 };
    let (mut gaps, mut grips, mut currents, mut volts) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let mut touched = None;
    let mut integral = 0.0;
    let mut largest = 0.0_f64;
    for tick in 0..TICKS {
        let (time, state) = (plant.time(), *plant.state());
        let outputs = plant.outputs(&inputs);
        let angle = coordinate_values(&model, time, &state.q)[usize::from(shaft)];
        let rate = coordinate_rates(&model, time, &state.q, &state.v)[usize::from(shaft)];
        // Without current: what the motor has to hold.
        let still = State { z: [0.0], ..state };
        let along = Reduced::along(&model, time, &still, &inputs, &[shaft])?;
        let grip = 0.5 * (outputs.left_grip + outputs.right_grip);
        if touched.is_none() && grip > 1.0 {
            touched = Some(time);
        }
        let torque = if touched.is_some() {
            // A turn of the finger moves both pads by L sin θ.
            integral = (integral + 40.0 * TICK * (GRIP - grip)).clamp(-GRIP, GRIP);
            -2.0 * LENGTH * angle.sin() * (GRIP + 0.5 * (GRIP - grip) + integral) - 0.3 * rate
        } else {
            let (wanted, speed) = path(time);
            along.bias()[0] + along.mass_matrix()[0] * (900.0 * (wanted - angle) + 60.0 * (speed - rate))
        };
        let asked = (torque / RATIO / parameters.constant).clamp(-6.0, 6.0);
        let back = parameters.constant * RATIO * rate;
        let current = outputs.current;
        let fast = parameters.inductance / 4e-4;
        inputs.voltage = (parameters.resistance * asked + back + fast * (asked - current)).clamp(-24.0, 24.0);
        plant.step(&inputs, TICK)?;
        if tick % 10 == 0 {
            gaps.push((time, 1e3 * outputs.gap));
            grips.push((time, grip));
            currents.push((time, current));
            volts.push((time, inputs.voltage));
        }
        largest = largest.max(grip);
    }
    let end = plant.outputs(&inputs);
    println!(
        "touched after {:.3} s; at the end {:.2} N and {:.2} N, at most {largest:.1} N",
        touched.unwrap_or(f64::NAN),
        end.left_grip,
        end.right_grip
    );
    println!("the loops are closed to {:.1e} m", plant.constraint_residual().position);
    assert!((end.left_grip - GRIP).abs() < 0.25 && (end.right_grip - GRIP).abs() < 0.25, "it does not hold");
    assert!(largest < 2.0 * GRIP, "it crushes what it holds");
    let curve = |label, points| Curve { label, points };
    let panels = [
        Panel { label: "gap, mm", curves: vec![curve("between the pads", gaps)] },
        Panel { label: "grip, N", curves: vec![curve("mean of both jaws", grips)] },
        Panel { label: "motor, A and V", curves: vec![curve("current", currents), curve("voltage", volts)] },
    ];
    let file = draw("gripper", "Gripper with a motor and a gearbox", "time, s", &panels)?;
    println!("{} shows it", file.display());
    Ok(())
}

/// Angle and rate of the left finger while it closes.
fn path(time: f64) -> (f64, f64) {
    let (begin, end, last) = (130_f64.to_radians(), 60_f64.to_radians(), 0.8);
    let x = (time / last).min(1.0);
    let blend = x * x * (3.0 - 2.0 * x);
    (begin + (end - begin) * blend, (end - begin) * 6.0 * x * (1.0 - x) / last)
}
