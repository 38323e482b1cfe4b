//! One bar on one joint: MSC ADAMS' runs, as Project Chrono keeps them, and closed forms.

use super::{Table, Worst, orientation, see_matrix};
use linkwright::{Simulation, SpatialMotion};
use linkwright_models::spatial_pendulums::{
    ConstantVelocityPendulum, CylindricalPendulum, DistancePendulum, PlanarPendulum, PointOnLinePendulum,
    PointOnPlanePendulum, PrismaticPendulum, RevolutePendulum, ScrewPendulum, SphericalPendulum,
    UniversalPendulum, VerticalCylindricalPendulum,
};

const G: f64 = 9.80665;
const STEP: f64 = 2.5e-4;

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Positions, velocities and accelerations in world axes; the reaction is the opposite of ADAMS', which is on the ground.
macro_rules! against_adams {
    ($test:ident, $model:ident, $data:literal, $position:literal, $velocity:literal, $acceleration:literal) => {
        #[test]
        fn $test() {
            let adams = Table::new(include_str!(concat!("../../data/", $data)));
            let model = $model::<f64>::default();
            let mut simulation = Simulation::new(&model, $model::START).step(STEP);
            let (mut position, mut velocity, mut acceleration, mut reaction) =
                (Worst::default(), Worst::default(), Worst::default(), Worst::default());
            for row in 0..adams.rows.len() {
                let value = |name: &str| adams.get(row, name);
                let time = value("t");
                simulation.advance_until(time).expect("it swings");
                let (state, a) = (*simulation.state(), simulation.acceleration().expect("it is regular"));
                let lambda = simulation.multipliers().expect("it is regular");
                let [bar] = model.motions(time, &state.q, &state.v, &a);
                let [pivot] = model.reactions(time, &state, &(), &a, &lambda);
                let vector = |what: &str, suffix: &str| {
                    ["X", "Y", "Z"].map(|axis| value(&format!("{what}.{axis}_{suffix}")))
                };
                let world =
                    |v: [f64; 3]| bar.orientation.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2]);
                for axis in 0..3 {
                    position.see(bar.position[axis], vector("Pos", "Pos")[axis]);
                    velocity.see(bar.velocity[axis], vector("Vel", "Vel")[axis]);
                    velocity.see(world(bar.rate)[axis], vector("Avel", "AngVel")[axis]);
                    acceleration.see(bar.acceleration[axis], vector("Acc", "Acc")[axis]);
                    acceleration.see(world(bar.angular_acceleration)[axis], vector("Aacc", "AngAcc")[axis]);
                    reaction.see(pivot.force[axis], -vector("Rforce", "Force")[axis]);
                    reaction.see(pivot.torque[axis], -vector("Rtorque", "Torque")[axis]);
                }
                // ADAMS prints six digits.
                let quaternion = ["Quat.e0", "Quat.e1", "Quat.e2", "Quat.e3"].map(value);
                see_matrix(&mut position, bar.orientation, orientation(quaternion));
            }
            position.below($position, concat!(stringify!($model), " against ADAMS, positions"));
            velocity.below($velocity, concat!(stringify!($model), " against ADAMS, velocities"));
            acceleration.below($acceleration, concat!(stringify!($model), " against ADAMS, accelerations"));
            reaction.below($acceleration, concat!(stringify!($model), " against ADAMS, reactions"));
        }
    };
}

// What ADAMS' own integration is off the closed form below: the second run more than the first.
against_adams!(revolute, RevolutePendulum, "chrono_adams_Revolute_Case01.csv", 1e-5, 1e-5, 1e-3);
against_adams!(spherical, SphericalPendulum, "chrono_adams_Spherical_Case01.csv", 1e-3, 3e-3, 1.5e-2);

/// θ̈ = (2 g/4.1) cos θ: place, speed and the force at the pivot, the horizontal it started on being `$along`.
macro_rules! swings {
    ($test:ident, $model:ident, $along:literal) => {
        #[test]
        fn $test() {
            let exact = Table::new(include_str!("../../data/swinging_bar_computed.csv"));
            let model = $model::<f64>::default();
            let mut simulation = Simulation::new(&model, $model::START).step(STEP);
            let (mut place, mut force) = (Worst::default(), Worst::default());
            for row in 0..exact.rows.len() {
                let value = |name: &str| exact.get(row, name);
                let time = value("t");
                simulation.advance_until(time).expect("it swings");
                let (state, a) = (*simulation.state(), simulation.acceleration().expect("it is regular"));
                let lambda = simulation.multipliers().expect("it is regular");
                let [bar] = model.motions(time, &state.q, &state.v, &a);
                let [pivot] = model.reactions(time, &state, &(), &a, &lambda);
                let (sine, cosine) = value("theta").sin_cos();
                let mut position = [0.0, 0.0, value("z")];
                let mut velocity = [0.0, 0.0, -2.0 * cosine * value("rate")];
                let mut reaction = [0.0, 0.0, value("force_z")];
                position[$along] = value("along");
                velocity[$along] = -2.0 * sine * value("rate");
                reaction[$along] = value("force_along");
                for axis in 0..3 {
                    place.see(bar.position[axis], position[axis]);
                    place.see(bar.velocity[axis], velocity[axis]);
                    force.see(pivot.force[axis], reaction[axis]);
                    force.see(pivot.torque[axis], 0.0);
                }
            }
            place.below(1e-11, concat!(stringify!($model), ", place and velocity"));
            force.below(1e-10, concat!(stringify!($model), ", reaction"));
        }
    };
}

swings!(revolute_swings, RevolutePendulum, 0);
swings!(spherical_swings, SphericalPendulum, 0);
swings!(cylindrical_swings, CylindricalPendulum, 0);
swings!(universal_swings, UniversalPendulum, 1);

/// The centre's place at 1 s and 2 s, from a constant acceleration along z and the speed it is thrown up with.
macro_rules! falls {
    ($test:ident, $model:ident, $thrown:literal, $acceleration:expr, $at:expr) => {
        #[test]
        fn $test() {
            let model = $model::<f64>::default();
            let mut simulation = Simulation::new(&model, $model::START).step(STEP);
            let mut worst = Worst::default();
            for time in [1.0, 2.0] {
                simulation.advance_until(time).expect("it falls");
                let outputs = simulation.sample().outputs;
                let fallen: f64 = 0.5 * $acceleration * time * time;
                let [x, y, z]: [f64; 3] = $at(time, fallen);
                worst.see(outputs.x, x);
                worst.see(outputs.y, y);
                worst.see(outputs.z, z);
                worst.see(outputs.velocity_z, $thrown + $acceleration * time);
            }
            worst.below(1e-10, concat!(stringify!($model), ", fall"));
        }
    };
}

falls!(prismatic_falls, PrismaticPendulum, 0.0, -G, |_, fallen| [2.0, 0.0, fallen]);
falls!(cylindrical_falls, VerticalCylindricalPendulum, 0.0, -G, |_, fallen| [2.0, 0.0, fallen]);
falls!(planar_falls, PlanarPendulum, 2.0, -G, |time: f64, fallen: f64| [
    0.5 * time,
    0.0,
    2.0 * time + fallen
]);

/// z̈ = −g/(1 + 4.1 (2π/p)²): m z̈ = −m g − F, 4.1 θ̈ = F p/2π, z = p θ/2π.
const SCREW: f64 = {
    let turns = core::f64::consts::TAU / 1.5;
    -G / (1.0 + 4.1 * turns * turns)
};
falls!(screw_falls, ScrewPendulum, 0.0, SCREW, |_, fallen: f64| {
    let (sine, cosine) = (core::f64::consts::TAU / 1.5 * fallen).sin_cos();
    [2.0 * cosine, 2.0 * sine, fallen]
});

/// θ̈ = (g/2) cos θ with no turning of the bar; its energy gives the speed.
#[test]
fn distance_swings_as_a_point() {
    let model = DistancePendulum::<f64>::default();
    let mut simulation =
        Simulation::new(&model, DistancePendulum::START).formulation(super::baumgarte(10.0)).step(STEP);
    let (mut length, mut speed, mut turned) = (Worst::default(), Worst::default(), Worst::default());
    simulation
        .run_until(5.0, |sample| {
            let at = sample.outputs;
            length.see(at.x * at.x + at.y * at.y + at.z * at.z, 4.0);
            let squared = at.velocity_x.powi(2) + at.velocity_y.powi(2) + at.velocity_z.powi(2);
            speed.see(squared, -2.0 * G * at.z);
            let [bar] = model.motions(
                sample.time,
                &sample.state.q,
                &sample.state.v,
                &[0.0; DistancePendulum::START.v.len()],
            );
            see_matrix(&mut turned, bar.orientation, orientation([1.0, 0.0, 0.0, 0.0]));
        })
        .expect("it swings");
    length.below(1e-11, "distance pendulum, squared length");
    speed.below(1e-10, "distance pendulum, squared speed");
    turned.below(1e-14, "distance pendulum, orientation");
}

/// A turn at a constant rate about the plane's normal.
#[test]
fn planar_keeps_its_spin() {
    let model = PlanarPendulum::<f64>::default();
    let mut simulation = Simulation::new(&model, PlanarPendulum::START).step(STEP);
    let mut turn = Worst::default();
    for time in [1.0, 2.0, 5.0] {
        let state = simulation.advance_until(time).expect("it turns");
        let [bar] = model.motions(time, &state.q, &state.v, &[0.0; PlanarPendulum::START.v.len()]);
        let half = 0.5 * (0.3 + 3.0 * time);
        see_matrix(&mut turn, bar.orientation, orientation([half.cos(), 0.0, half.sin(), 0.0]));
    }
    turn.below(1e-12, "PlanarPendulum, turn of 15 rad");
}

/// What a bar keeps of its motion over 5 s: its energy, and what the closure says of its place, velocity and
/// orientation is zero.
macro_rules! keeps {
    ($test:ident, $model:ident, $step:literal, energy = $energy:literal, $bound:literal, $closed_form:expr) => {
        #[test]
        fn $test() {
            let model = $model::<f64>::default();
            let mut simulation =
                Simulation::new(&model, $model::START).formulation(super::baumgarte(10.0)).step($step);
            let energy = simulation.energy();
            let (mut kept, mut known) = (Worst::default(), Worst::default());
            let closed_form: fn(f64, &SpatialMotion<f64>) -> [f64; 3] = $closed_form;
            simulation
                .run_until(5.0, |sample| {
                    kept.see(sample.energy(), energy);
                    let zero = [0.0; $model::START.v.len()];
                    let [bar] = model.motions(sample.time, &sample.state.q, &sample.state.v, &zero);
                    closed_form(sample.time, &bar).into_iter().for_each(|off| known.see(off, 0.0));
                })
                .expect("it moves");
            kept.below($energy, concat!(stringify!($model), ", energy"));
            known.below($bound, concat!(stringify!($model), ", closed forms"));
        }
    };
}

// The bar's direction and that of the shaft turn alike: no rate about their sum; the bar stays 2 m from the joint.
keeps!(constant_velocity_does_not_twist, ConstantVelocityPendulum, 5e-4, energy = 1e-9, 1e-9, |_, bar| {
    let rate = bar.orientation.map(|row| dot(row, bar.rate));
    let along = bar.orientation.map(|row| row[0]);
    [
        rate[0] + dot(rate, along),
        dot(bar.position, bar.position) - 4.0,
        // Without twist the half turn from the shaft to the bar is about an axis across both: q_x = 0.
        bar.orientation[1][2] - bar.orientation[2][1],
    ]
});

// No force along the wire but gravity's, no moment about the bar's own axis.
keeps!(point_on_line_slides, PointOnLinePendulum, 1.25e-4, energy = 1e-7, 1e-9, |time, bar| {
    let wire = [3.0, 1.0, -1.0].map(|part: f64| part / 11.0_f64.sqrt());
    let pull = -G * wire[2];
    // At the start the end slides with 0.2 m/s and the centre, 2 m along x, turns about it.
    let speed = 0.2 + dot(wire, [0.0, 2.0 * 0.5, 0.0]);
    [
        dot(wire, bar.velocity) - speed - pull * time,
        dot(wire, bar.position) - 2.0 * wire[0] - speed * time - 0.5 * pull * time * time,
        bar.rate[0] - 0.3,
    ]
});

// No force along the plane but gravity's, no moment about the bar's own axis.
keeps!(point_on_plane_slides, PointOnPlanePendulum, 1.25e-4, energy = 1e-6, 1e-9, |time, bar| {
    // Level, and the direction in which it falls most.
    let level = [1.0, 2.0, 0.0].map(|part: f64| part / 5.0_f64.sqrt());
    let fall = [0.2, -0.1, -0.05].map(|part: f64| part / 0.0525_f64.sqrt());
    let pull = -G * fall[2];
    // 0.1, −0.2 and thus −0.04 m/s of the end, and the centre, 2 m along x, turns about it with 0.5 rad/s.
    let start = [0.1, -0.2 + 2.0 * 0.5, -0.04];
    [
        dot(level, bar.position) - 2.0 * level[0] - time * dot(level, start),
        dot(fall, bar.velocity) - time * pull - dot(fall, start),
        bar.rate[0] - 0.3,
    ]
});
