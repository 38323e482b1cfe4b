//! Arms against Pinocchio; the Stewart platform, the delta robot and the double wishbone against computations of their own.

use super::{Table, Worst, baumgarte, orientation, see_matrix};
use linkwright::{Assemble, AssembleExt, Mechanism, Motion, Simulation, State};
use linkwright_models::delta_robot::{DeltaRobot, DeltaRobotInputs};
use linkwright_models::double_wishbone::{DoubleWishbone, DoubleWishboneInputs};
use linkwright_models::iiwa14::{Iiwa14, Iiwa14Inputs, Iiwa14Parametric, Iiwa14ParametricInputs};
use linkwright_models::panda::{Panda, PandaInputs};
use linkwright_models::stewart_platform::{StewartPlatform, StewartPlatformInputs};
use serde_json::Value;

/// The numbers of a field, row by row.
fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(values) => values.iter().flat_map(numbers).collect(),
        value => vec![value.as_f64().expect("a number")],
    }
}

/// M, bias, inverse and forward dynamics at the start, which is Pinocchio's state; kinetic energy and the last joint's place.
macro_rules! against_pinocchio {
    ($test:ident, $model:ident, $inputs:ident, $data:literal, $key:literal) => {
        #[test]
        fn $test() {
            let file: Value =
                serde_json::from_str(include_str!(concat!("../../data/", $data))).expect("JSON");
            let expected = |name: &str| numbers(&file[$key][name]);
            let model = $model::<f64>::default();
            let start = $model::START;

            // (cos, sin) of each angle, in the order of the joints, and their rates.
            let mut given = Worst::default();
            for (joint, angle) in expected("q").into_iter().enumerate() {
                given.see(start.q[2 * joint], angle.cos());
                given.see(start.q[2 * joint + 1], angle.sin());
                given.see(start.v[joint], expected("qd")[joint]);
            }
            given.below(1e-15, concat!(stringify!($model), ", the state of the comparison"));

            let mut mass = Default::default();
            model.mass_matrix(0.0, &start.q, &mut mass);
            let mut dense = [[0.0; 7]; 7];
            for (&(row, column), value) in <$model>::default().mass_pattern().iter().zip(mass) {
                dense[row as usize][column as usize] = value;
                dense[column as usize][row as usize] = value;
            }
            let mut worst = Worst::default();
            for (found, expected) in dense.iter().flatten().zip(expected("M")) {
                worst.see(*found, expected);
            }
            worst.below(1e-11, concat!(stringify!($model), ", M"));

            let [torque_1, torque_2, torque_3, torque_4, torque_5, torque_6, torque_7] = [0.0; 7];
            let none = $inputs { torque_1, torque_2, torque_3, torque_4, torque_5, torque_6, torque_7 };
            let mut forces = [0.0; 7];
            model.forces(0.0, &start, &none, &mut forces);
            let mut worst = Worst::default();
            for (found, bias) in forces.into_iter().zip(expected("bias_h")) {
                worst.see(found, -bias);
            }
            worst.below(1e-11, concat!(stringify!($model), ", bias"));

            let given = <[f64; 7]>::try_from(expected("qdd_for_rnea")).expect("seven accelerations");
            let found = model.inverse_dynamics(0.0, &start, &none, &given);
            let mut worst = Worst::default();
            for (found, expected) in found.into_iter().zip(expected("tau_rnea")) {
                worst.see(found, expected);
            }
            worst.below(1e-11, concat!(stringify!($model), ", inverse dynamics"));

            let [torque_1, torque_2, torque_3, torque_4, torque_5, torque_6, torque_7] =
                <[f64; 7]>::try_from(expected("tau_for_aba")).expect("seven torques");
            let torques = $inputs { torque_1, torque_2, torque_3, torque_4, torque_5, torque_6, torque_7 };
            let (mut a, mut lambda) = ([0.0; 7], []);
            model.acceleration(0.0, &start, &torques, &mut a, &mut lambda);
            let mut worst = Worst::default();
            for (found, expected) in a.into_iter().zip(expected("qdd_aba")) {
                // Relative to 1 + |a|: the last joint has 10⁴ rad/s².
                worst.see((found - expected) / (1.0 + expected.abs()), 0.0);
            }
            worst.below(1e-11, concat!(stringify!($model), ", forward dynamics"));

            let last = model.motions(0.0, &start.q, &start.v, &a)[6];
            let rotation = expected("last_joint_rotation_rowmajor");
            let expected_rotation =
                core::array::from_fn(|row| core::array::from_fn(|column| rotation[3 * row + column]));
            let mut worst = Worst::default();
            see_matrix(&mut worst, last.orientation, expected_rotation);
            worst.see(model.kinetic_energy(0.0, &start.q, &start.v), expected("kinetic_energy")[0]);
            worst.see(model.potential_energy(0.0, &start), expected("potential_energy")[0]);
            worst.below(1e-11, concat!(stringify!($model), ", last link and energies"));
        }
    };
}

against_pinocchio!(iiwa14, Iiwa14, Iiwa14Inputs, "iiwa14_dynamics_pinocchio.json", "drake_iiwa14");
against_pinocchio!(
    iiwa14_with_parameters,
    Iiwa14Parametric,
    Iiwa14ParametricInputs,
    "iiwa14_dynamics_pinocchio.json",
    "drake_iiwa14"
);
against_pinocchio!(panda, Panda, PandaInputs, "panda_dynamics_pinocchio.json", "panda");

/// The figure that is promised for one evaluation of the seven accelerations.
#[test]
fn panda_in_few_operations() {
    let operations = Panda::<f64>::OPERATIONS;
    assert!(operations <= 1150, "{operations} operations");
}

/// f = [M g + 6 m₁ g (ℓ/2) c²/L + 6 m₂ g (1 − (ℓ/2) c²/L)]/(6 s), computed.
const THRUST: f64 = 4078.783656699347;

fn thrusts(of: impl Fn(f64) -> f64) -> StewartPlatformInputs<f64> {
    let [thrust_0, thrust_1, thrust_2, thrust_3, thrust_4, thrust_5] =
        [0.0, 1.0, 2.0, 3.0, 4.0, 5.0].map(|leg| THRUST * of(leg));
    StewartPlatformInputs { thrust_0, thrust_1, thrust_2, thrust_3, thrust_4, thrust_5 }
}

#[test]
fn stewart_platform_stands_still() {
    let model = StewartPlatform::<f64>::default();
    let start = StewartPlatform::START;
    let (mut a, mut lambda) = (start.v, model.zero_lambda());
    model.acceleration(0.0, &start, &thrusts(|_| 1.0), &mut a, &mut lambda);
    let mut worst = Worst::default();
    a.iter().for_each(|found| worst.see(*found, 0.0));
    worst.below(1e-11, "Stewart platform, accelerations under its own weight");
}

#[test]
fn stewart_platform_moves() {
    let reference = Table::new(include_str!("../../data/stewart_platform_computed.csv"));
    let model = StewartPlatform::<f64>::default();
    let platform =
        StewartPlatform::<f64>::BODIES.iter().position(|name| *name == "platform").expect("a platform");
    let mut simulation = Simulation::new(&model, StewartPlatform::START)
        .formulation(baumgarte(10.0))
        .held(|_, _| thrusts(|leg| 1.0 + 0.02 * (leg - 2.5)))
        .step(5e-4);
    let mut worst = Worst::default();
    for row in 0..reference.rows.len() {
        let value = |name: &str| reference.get(row, name);
        simulation.advance_until(value("t")).expect("it moves");
        let (state, a) = (*simulation.state(), simulation.acceleration().expect("it is regular"));
        let body = model.motions(value("t"), &state.q, &state.v, &a)[platform];
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            worst.see(body.position[axis], value(name));
        }
        see_matrix(&mut worst, body.orientation, orientation(["qw", "qx", "qy", "qz"].map(value)));
    }
    worst.below(1e-10, "Stewart platform, pose over 0.5 s");
}

fn torques([torque_0, torque_1, torque_2]: [f64; 3]) -> DeltaRobotInputs<f64> {
    DeltaRobotInputs { torque_0, torque_1, torque_2 }
}

/// The torque that holds the platform with arms at rest, and the depth of the platform.
#[test]
fn delta_robot_holds_its_platform() {
    let model = DeltaRobot::<f64>::default();
    let start = DeltaRobot::START;
    let (mut a, mut lambda) = (start.v, model.zero_lambda());
    let rest = State::new(start.q, [0.0; DeltaRobot::START.v.len()]);
    let held = torques([-15.072845703509; 3]);
    model.acceleration(0.0, &rest, &held, &mut a, &mut lambda);
    let mut worst = Worst::default();
    a.iter().for_each(|found| worst.see(*found, 0.0));
    worst.below(1e-11, "delta robot, accelerations at rest");
    let mut depth = Worst::default();
    let outputs = model.outputs(0.0, &rest, &held);
    depth.see(outputs.z, -1.0985777543177184);
    depth.see(outputs.x, 0.0);
    depth.see(outputs.y, 0.0);
    depth.below(1e-12, "delta robot, place of the platform");
}

#[test]
fn delta_robot_moves() {
    let reference = Table::new(include_str!("../../data/delta_robot_computed.csv"));
    let model = DeltaRobot::<f64>::default();
    let mut simulation = Simulation::new(&model, DeltaRobot::START)
        .formulation(baumgarte(10.0))
        .held(|_, _| torques([-12.0, -15.0, -18.0]))
        .step(1e-4);
    let (mut place, mut speed, mut turned) = (Worst::default(), Worst::default(), Worst::default());
    let platform = DeltaRobot::<f64>::BODIES.iter().position(|name| *name == "platform").expect("a platform");
    for row in 0..reference.rows.len() {
        let value = |name: &str| reference.get(row, name);
        simulation.advance_until(value("t")).expect("it moves");
        let outputs = simulation.sample().outputs;
        place.see(outputs.x, value("x"));
        place.see(outputs.y, value("y"));
        place.see(outputs.z, value("z"));
        speed.see(outputs.velocity_x, value("vx"));
        speed.see(outputs.velocity_y, value("vy"));
        speed.see(outputs.velocity_z, value("vz"));
        let (state, a) = (*simulation.state(), simulation.acceleration().expect("it is regular"));
        let body = model.motions(value("t"), &state.q, &state.v, &a)[platform];
        see_matrix(&mut turned, body.orientation, orientation([1.0, 0.0, 0.0, 0.0]));
    }
    place.below(1e-11, "delta robot, platform over 0.3 s");
    speed.below(1e-10, "delta robot, speed of the platform");
    turned.below(1e-12, "delta robot, the platform does not turn");
}

/// Place, inclination and steering of the wheel over its travel.
#[test]
fn double_wishbone_positions() {
    let reference = Table::new(include_str!("../../data/double_wishbone_computed.csv"));
    let model = DoubleWishbone::<f64>::default();
    let independent: Vec<&str> = <DoubleWishbone>::default()
        .independent()
        .iter()
        .map(|&index| <DoubleWishbone>::default().conditions()[index as usize].of)
        .collect();
    let spindle =
        DoubleWishbone::<f64>::BODIES.iter().position(|name| *name == "spindle").expect("a spindle");
    let given = |lower: f64| -> Vec<Motion<f64>> {
        let at = |name: &&str| if *name == "lower_bearing.angle" { lower } else { 0.0 };
        independent.iter().map(|name| Motion { position: at(name), rate: 0.0, acceleration: 0.0 }).collect()
    };
    assert!(independent.contains(&"lower_bearing.angle"), "{independent:?}");
    let mut worst = Worst::default();
    for row in 0..reference.rows.len() {
        let value = |name: &str| reference.get(row, name);
        let mut near = DoubleWishbone::START.q;
        let mut found = model.kinematics(0.0, &near, &given(0.0)).expect("the design position");
        for part in 1..=4 {
            found = model
                .kinematics(0.0, &near, &given(value("lower") * f64::from(part) / 4.0))
                .expect("it travels");
            near = found.q;
        }
        let wheel = model.motions(0.0, &found.q, &found.v, &found.a)[spindle];
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            worst.see(wheel.position[axis], value(name));
        }
        let axis = wheel.orientation.map(|row| row[1]);
        worst.see(axis[2].atan2(axis[1]), value("inclination"));
        worst.see((-axis[0]).atan2(axis[1]), value("steering"));
        let inputs = DoubleWishboneInputs { road: 0.0, brake: 0.0 };
        worst.see(model.outputs(0.0, &found.state(), &inputs).upper_angle, value("upper"));
    }
    worst.below(1e-11, "double wishbone, wheel over its travel");
}
