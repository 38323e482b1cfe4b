//! Mechanisms whose motion is known exactly: A01, A02 with two windows, the slider-crank; and what energy says where
//! nothing else is known.

use super::{Table, Worst, run};
use linkwright::{Assemble, AssembleExt, Mechanism, Motion, Simulation};
use linkwright_models::n_four_bar::NFourBar2;
use linkwright_models::simple_pendulum::SimplePendulum;
use linkwright_models::slider_crank::{SliderCrank, SliderCrankInputs};
use linkwright_models::tree_pendulum::TreePendulum;

#[test]
fn simple_pendulum() {
    let exact = Table::new(include_str!("../../data/A01_simple_pendulum_exact.csv"));
    let model = SimplePendulum::<f64>::default();
    let mut worst = Worst::default();
    let mut rows = 0;
    run(&model, SimplePendulum::START, (0.0, 1e-3), 10.0, 100, |row, sample| {
        worst.see(sample.outputs.x, exact.get(row, "x"));
        worst.see(sample.outputs.y, exact.get(row, "y"));
        rows += 1;
    })
    .expect("a pendulum swings");
    assert_eq!(rows, exact.rows.len());
    worst.below(1e-10, "A01, position");
}

/// A02 in absolute coordinates: the text of `n_four_bar_2` with that option.
mod absolute {
    linkwright::mechanism! {
        /// Two windows of unit rods in absolute coordinates.
        pub planar AbsoluteFourBar2 {
            gravity [m/s^2] = (0, -9.81);
            repeat i in 0..3 {
                rod crank[i] { mass [kg] = 1; length [m] = 1; }
                joint pin[i]: revolute(ground(i, 0) [m], crank[i].start);
            }
            repeat i in 0..2 {
                rod coupler[i] { mass [kg] = 1; length [m] = 1; }
                joint left[i]:  revolute(crank[i].end, coupler[i].start);
                joint right[i]: revolute(coupler[i].end, crank[i+1].end);
                start { coupler[i].angle [rad] ~ 0; pin[i+1].angle [deg] ~ 90; }
            }
            start   { pin[0].angle [deg] = 90; pin[0].rate [rad/s] = -1; }
            options { coordinates = absolute; }
            expect  { degrees_of_freedom = 1; }
            output x [m] = crank[0].end.x;
            output y [m] = crank[0].end.y;
            output velocity_x [m/s] = crank[0].end.velocity.x;
            output velocity_y [m/s] = crank[0].end.velocity.y;
        }
    }
}

macro_rules! a02 {
    ($model:ty, $coordinates:literal, $bound:expr) => {{
        assert!(
            <$model>::COORDINATES.contains(concat!("\"", $coordinates, "\"")),
            "{}",
            <$model>::COORDINATES
        );
        let exact = Table::new(include_str!("../../data/A02_N2_fourbar_exact.csv"));
        let model = <$model>::default();
        let (mut position, mut velocity, mut last) = (Worst::default(), Worst::default(), Worst::default());
        let mut rows = 0;
        run(&model, <$model>::START, (10.0, 1e-3), 10.0, 100, |row, sample| {
            position.see(sample.outputs.x, exact.get(row, "xB0"));
            position.see(sample.outputs.y, exact.get(row, "yB0"));
            velocity.see(sample.outputs.velocity_x, exact.get(row, "vxB0"));
            velocity.see(sample.outputs.velocity_y, exact.get(row, "vyB0"));
            if row + 1 == exact.rows.len() {
                last.see(sample.outputs.x, exact.get(row, "xB0"));
                last.see(sample.outputs.y, exact.get(row, "yB0"));
            }
            rows += 1;
        })
        .expect("the ladder passes its collinear positions");
        assert_eq!(rows, exact.rows.len());
        last.below($bound, concat!("A02 N = 2, ", $coordinates, ", position at 10 s"));
        position.below(5.0 * $bound, concat!("A02 N = 2, ", $coordinates, ", position along"));
        velocity.below(20.0 * $bound, concat!("A02 N = 2, ", $coordinates, ", velocity"));
    }};
}

#[test]
fn two_windows_in_tree_coordinates() {
    a02!(NFourBar2, "tree", 1e-8);
}

#[test]
fn two_windows_in_absolute_coordinates() {
    a02!(absolute::AbsoluteFourBar2, "absolute", 2e-8);
}

/// x = r cos θ + √(l² − r² sin² θ) with its derivatives at constant θ̇ and θ̈.
#[test]
fn slider_crank() {
    const R: f64 = 0.04;
    const L: f64 = 0.14;
    let model = SliderCrank::<f64>::default();
    let (rate, acceleration) = (100.0, -700.0);
    let mut worst = [Worst::default(), Worst::default(), Worst::default()];
    let mut near = SliderCrank::START.q;
    for step in 0..=72 {
        let angle = 30_f64.to_radians() + f64::from(step) * 5_f64.to_radians();
        let motion = Motion { position: angle, rate, acceleration };
        let found = model.kinematics(0.0, &near, &[motion]).expect("the crank turns freely");
        near = found.q;
        let piston = model.motions(0.0, &found.q, &found.v, &found.a)[2];

        let (sine, cosine) = angle.sin_cos();
        let root = (L * L - R * R * sine * sine).sqrt();
        let root_1 = -R * R * sine * cosine / root;
        let root_2 = (-R * R * (cosine * cosine - sine * sine) - root_1 * root_1) / root;
        let (x_1, x_2) = (-R * sine + root_1, -R * cosine + root_2);
        worst[0].see(piston.position[0], R * cosine + root);
        worst[1].see(piston.velocity[0], x_1 * rate);
        worst[2].see(piston.acceleration[0], x_2 * rate * rate + x_1 * acceleration);
    }
    worst[0].below(1e-14, "slider-crank, position");
    worst[1].below(1e-13, "slider-crank, velocity");
    worst[2].below(1e-11, "slider-crank, acceleration");
}

/// The work of the two inputs is what the kinetic energy gains.
#[test]
fn slider_crank_turns_work_into_speed() {
    let model = SliderCrank::<f64>::default();
    let inputs = SliderCrankInputs { torque: 3.0, gas: 40.0 };
    let mut simulation = Simulation::new(&model, SliderCrank::START)
        .formulation(super::baumgarte(10.0))
        .held(|_, _| inputs)
        .step(1e-5);
    let first = simulation.sample();
    let mut worst = Worst::default();
    let mut turned = 0.0;
    simulation
        .run_until(0.1, |sample| {
            turned = sample.outputs.angle - first.outputs.angle;
            let work = 3.0 * turned - 40.0 * (sample.outputs.stroke - first.outputs.stroke);
            worst.see(sample.kinetic_energy() - first.kinetic_energy(), work);
        })
        .expect("the crank turns");
    assert!(turned > core::f64::consts::TAU, "more than a turn: {turned}");
    worst.below(1e-9, "slider-crank, work of the inputs against kinetic energy");
}

#[test]
fn tree_pendulum_keeps_its_energy() {
    let model = TreePendulum::<f64>::default();
    assert!(<TreePendulum>::default().rows().is_empty(), "no loops, no rows");
    assert_eq!(<TreePendulum>::default().independent().len(), 5);
    let mut simulation = Simulation::new(&model, TreePendulum::START).step(2e-4);
    let energy = simulation.energy();
    let mut worst = Worst::default();
    simulation.run_until(3.0, |sample| worst.see(sample.energy(), energy)).expect("it swings");
    worst.below(1e-8, "tree pendulum, energy");
}
