//! The rigid quick return: kinematics and torques of a whole run at constant crank speed, and the run itself.

use super::{Table, Worst, baumgarte};
use linkwright::Simulation;
use linkwright_models::quick_return::{ConstantSpeed, QuickReturn, QuickReturnInputs, slider_force};

const CRANK_SPEED: f64 = 15.0;

fn reference() -> Table {
    Table::new(include_str!("../../data/quick_return_rigid_w15.csv"))
}

#[test]
fn motion_at_constant_speed() {
    let reference = reference();
    let model = QuickReturn::<f64>::default();
    let mut law = ConstantSpeed::new(&model, CRANK_SPEED);
    let (mut position, mut velocity, mut acceleration) =
        (Worst::default(), Worst::default(), Worst::default());
    for row in 0..reference.rows.len() {
        let value = |name: &str| reference.get(row, name);
        let time = value("t");
        let found = law.kinematics(time).expect("the crank turns");
        let [_, guide, coupler, slider] = model.motions(time, &found.q, &found.v, &found.a);
        position.see(coupler.position[0], value("x3"));
        position.see(coupler.position[1], value("y3"));
        position.see(coupler.orientation[1].atan2(coupler.orientation[0]), value("th3"));
        position.see(slider.position[0], value("x4"));
        position.see(guide.orientation[0], value("th2").cos());
        position.see(guide.orientation[1], value("th2").sin());
        velocity.see(coupler.velocity[0], value("vx3"));
        velocity.see(coupler.velocity[1], value("vy3"));
        velocity.see(coupler.rate, value("w3"));
        velocity.see(slider.velocity[0], value("v4"));
        velocity.see(guide.rate, value("w2"));
        // Relative to 1 + |a|: accelerations reach some 10⁴ rad/s².
        let mut relative =
            |found: f64, expected: f64| acceleration.see((found - expected) / (1.0 + expected.abs()), 0.0);
        relative(coupler.acceleration[0], value("ax3"));
        relative(coupler.acceleration[1], value("ay3"));
        relative(coupler.angular_acceleration, value("al3"));
        relative(slider.acceleration[0], value("a4"));
        relative(guide.angular_acceleration, value("al2"));
    }
    position.below(1e-12, "quick return, positions");
    velocity.below(1e-10, "quick return, velocities");
    acceleration.below(1e-11, "quick return, accelerations");
}

#[test]
fn force_and_torque_laws() {
    let reference = reference();
    let model = QuickReturn::<f64>::default();
    let mut law = ConstantSpeed::new(&model, CRANK_SPEED);
    let (mut force, mut light, mut heavy) = (Worst::default(), Worst::default(), Worst::default());
    for row in 0..reference.rows.len() {
        let time = reference.get(row, "t");
        force.see(slider_force(time, CRANK_SPEED), reference.get(row, "f"));
        light.see(law.torque_without_inertia(time).expect("the crank turns"), reference.get(row, "M25"));
        heavy.see(law.torque(time).expect("the crank turns"), reference.get(row, "M26"));
    }
    force.below(1e-11, "quick return, slider force");
    light.below(1e-11, "quick return, torque (25)");
    heavy.below(1e-9, "quick return, torque (26)");
}

/// Peaks recomputed in closed form: +2027.1328 N m at 0.363409 s, −1719.0391 N m at 0.377939 s, 17.1428571 N m.
#[test]
fn peaks_of_the_torques() {
    let model = QuickReturn::<f64>::default();
    let mut law = ConstantSpeed::new(&model, CRANK_SPEED);
    let (mut most, mut least, mut light) = ((0.0, 0.0), (0.0, 0.0), 0.0_f64);
    for step in 0..45_000 {
        let time = 1e-5 * f64::from(step);
        light = light.max(law.torque_without_inertia(time).expect("the crank turns"));
        // The peaks lie in the fast return.
        if (36_000..38_000).contains(&step) {
            let torque = law.torque(time).expect("the crank turns");
            if torque > most.0 {
                most = (torque, time);
            }
            if torque < least.0 {
                least = (torque, time);
            }
        }
    }
    for (found, expected, tolerance) in [
        (most.0, 2027.1328, 1e-3),
        (most.1, 0.363409, 1e-5),
        (least.0, -1719.0391, 1e-3),
        (least.1, 0.377939, 1e-5),
        (light, 17.1428571, 1e-7),
    ] {
        assert!((found - expected).abs() <= tolerance, "{found} for {expected}");
    }
}

/// Torque (26), an open-loop function of time, keeps the crank speed over two strokes.
#[test]
fn torque_of_the_rigid_mechanism_keeps_the_crank_speed() {
    let model = QuickReturn::<f64>::default();
    let mut law = ConstantSpeed::new(&model, CRANK_SPEED);
    let inputs = |time: f64, _: &_| QuickReturnInputs {
        drive: law.torque(time).expect("the crank turns"),
        cutting: slider_force(time, CRANK_SPEED),
    };
    let mut simulation =
        Simulation::new(&model, QuickReturn::START).formulation(baumgarte(50.0)).sampled(inputs).step(5e-5);
    let mut speed = Worst::default();
    let two_strokes = 4.0 * core::f64::consts::PI / CRANK_SPEED;
    simulation.run_until(two_strokes, |sample| speed.see(sample.outputs.rate, CRANK_SPEED)).expect("it runs");
    speed.below(1e-10, "quick return, crank speed over two strokes");
}
