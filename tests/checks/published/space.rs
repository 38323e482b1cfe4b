//! Mechanisms in space against closed forms and computed runs: tops and free bodies, loops with one degree of freedom,
//! overconstrained ones, the governor. Robots and suspensions are in `robots.rs`, single joints in `adams.rs`.

use super::{Table, Worst, baumgarte, orientation, run, see_matrix};
use linkwright::{Mechanism, Simulation};
use linkwright_models::bricard::Bricard;
use linkwright_models::flyball_governor::FlyballGovernor;
use linkwright_models::four_spherical_joints::FourSphericalJoints;
use linkwright_models::free_rigid_body::FreeRigidBody;
use linkwright_models::heavy_top::HeavyTop;
use linkwright_models::sarrus_linkage::SarrusLinkage;
use linkwright_models::spatial_four_bar::{Fourbar1, Fourbar2};
use linkwright_models::spatial_slider_crank::{
    SpatialSliderCrankArm, SpatialSliderCrankAxial, SpatialSliderCrankBalanced, SpatialSliderCrankThird,
};

/// A v.
fn turned(a: [[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
    a.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

/// Brüls & Cardona's data; orientation, rates and centre of a run at 3e-14.
#[test]
fn heavy_top() {
    let reference = Table::new(include_str!("../../data/heavy_top_computed.csv"));
    let model = HeavyTop::<f64>::default();
    let mut simulation = Simulation::new(&model, HeavyTop::START).step(2e-5);
    let energy = simulation.energy();
    let (mut angle, mut rate) = (Worst::default(), Worst::default());
    let (mut kept, mut moments) = (Worst::default(), Worst::default());
    for row in 0..reference.rows.len() {
        let value = |name: &str| reference.get(row, name);
        simulation.advance_until(value("t")).expect("the top spins");
        let (state, acceleration) = (*simulation.state(), simulation.acceleration().expect("it is regular"));
        let [top] = model.motions(value("t"), &state.q, &state.v, &acceleration);
        let expected = orientation(["qw", "qx", "qy", "qz"].map(value));
        see_matrix(&mut angle, top.orientation, expected);
        for (axis, name) in ["Wx", "Wy", "Wz"].into_iter().enumerate() {
            rate.see(top.rate[axis], value(name));
        }
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            angle.see(top.position[axis], value(name));
        }
        kept.see(simulation.energy(), energy);
        // About the fixed point, in the top's axes: about z and about the axis of the top it stays what it was.
        let [x, y, z] = top.rate;
        let moment = [(0.234375 + 15.0) * x, 0.46875 * y, (0.234375 + 15.0) * z];
        moments.see(turned(top.orientation, moment)[2], -4.61538 * (0.234375 + 15.0));
        moments.see(moment[1], 0.46875 * 150.0);
    }
    angle.below(1e-9, "heavy top, orientation and centre to 2 s");
    rate.below(1e-8, "heavy top, rates to 2 s");
    kept.below(1e-9, "heavy top, energy of 5436 J");
    moments.below(1e-8, "heavy top, moment of momentum of 70 N m s about its axis and the vertical");

    // The quaternion that the literature's data lead to.
    let state = *simulation.state();
    let [top] = model.motions(2.0, &state.q, &state.v, &[0.0; HeavyTop::START.v.len()]);
    let quaternion = [0.12294713504155, -0.49107989255038, 0.35043003034356, -0.78798688755028];
    let mut last = Worst::default();
    see_matrix(&mut last, top.orientation, orientation(quaternion));
    last.below(1e-9, "heavy top, quaternion at 2 s");
}

/// Jacobi's elliptic functions; energy, momentum and moment of momentum stay.
#[test]
fn free_rigid_body() {
    let reference = Table::new(include_str!("../../data/free_rigid_body_exact.csv"));
    let model = FreeRigidBody::<f64>::default();
    let (mut rate, mut angle, mut path) = (Worst::default(), Worst::default(), Worst::default());
    let (mut kept, mut moments) = (Worst::default(), Worst::default());
    let mut simulation = Simulation::new(&model, FreeRigidBody::START).step(5e-4);
    let energy = simulation.energy();
    let inertia = [1e-3, 2e-3, 3e-3];
    for row in 0..reference.rows.len() {
        let value = |name: &str| reference.get(row, name);
        let time = value("t");
        simulation.advance_until(time).expect("nothing acts");
        let (state, acceleration) = (*simulation.state(), simulation.acceleration().expect("it is regular"));
        let [nut] = model.motions(time, &state.q, &state.v, &acceleration);
        for (axis, name) in ["wx", "wy", "wz"].into_iter().enumerate() {
            rate.see(nut.rate[axis], value(name));
        }
        see_matrix(&mut angle, nut.orientation, orientation(["qw", "qx", "qy", "qz"].map(value)));
        for (axis, speed) in [0.1, -0.2, 0.3].into_iter().enumerate() {
            path.see(nut.velocity[axis], speed);
            path.see(nut.position[axis], speed * time);
        }
        kept.see(simulation.energy(), energy);
        let body = core::array::from_fn(|axis| inertia[axis] * nut.rate[axis]);
        for (found, start) in turned(nut.orientation, body).into_iter().zip([0.02e-3, 20e-3, 0.09e-3]) {
            moments.see(found, start);
        }
    }
    // Close to the separatrix roundings count a millionfold.
    rate.below(1e-7, "free body, rates of 10 rad/s");
    angle.below(1e-8, "free body, orientation");
    path.below(1e-11, "free body, straight path");
    kept.below(1e-12, "free body, energy of 0.1 J");
    moments.below(1e-12, "free body, moment of momentum of 0.02 N m s");
}

/// Half of its period from the start the body spins the other way; a period from the start as at the start.
#[test]
fn free_rigid_body_turns_over() {
    const PERIOD: f64 = 4.66008834689;
    let model = FreeRigidBody::<f64>::default();
    let after = |time: f64| {
        let end = Simulation::new(&model, FreeRigidBody::START).step(5e-4).advance_until(time);
        let state = end.expect("nothing acts");
        model.outputs(time, &state, &())
    };
    let mut worst = Worst::default();
    let end = after(PERIOD);
    worst.see(end.rate_x, 0.02);
    worst.see(end.rate_y, 10.0);
    worst.see(end.rate_z, 0.03);
    worst.see(after(0.5 * PERIOD).rate_y, -10.0);
    worst.below(1e-7, "free body, period");
}

/// D is 12 × 18, the rest is a separate integration.
#[test]
fn four_spherical_joints() {
    type Loop = FourSphericalJoints<f64>;
    assert_eq!(<Loop>::default().rows().len(), 12);
    assert_eq!(<Loop>::default().velocity_names().len(), 18);
    assert_eq!(Loop::DEGREES_OF_FREEDOM, 6);
    let reference = Table::new(include_str!("../../data/four_spherical_joints_computed.csv"));
    let model = Loop::default();
    let mut simulation =
        Simulation::new(&model, FourSphericalJoints::START).formulation(baumgarte(10.0)).step(1e-4);
    let energy = simulation.energy();
    let (mut place, mut kept) = (Worst::default(), Worst::default());
    for row in 0..reference.rows.len() {
        let value = |name: &str| reference.get(row, name);
        simulation.advance_until(value("t")).expect("the loop swings");
        let outputs = simulation.sample().outputs;
        place.see(outputs.b_x, value("bx"));
        place.see(outputs.b_y, value("by"));
        place.see(outputs.b_z, value("bz"));
        place.see(outputs.c_x, value("cx"));
        place.see(outputs.c_y, value("cy"));
        place.see(outputs.c_z, value("cz"));
        kept.see(simulation.energy(), energy);
    }
    place.below(1e-10, "four spherical joints, B and C");
    kept.below(1e-9, "four spherical joints, energy of 31 J");
}

/// One redundant row is dropped; P3 and energy at two step sizes.
#[test]
fn bricard() {
    let reference = Table::new(include_str!("../../data/bricard_computed.csv"));
    assert_eq!(Bricard::<f64>::DEGREES_OF_FREEDOM, 1);
    let model = Bricard::<f64>::default();
    let operations = Bricard::<f64>::OPERATIONS;
    assert!(operations <= 900, "A04: {operations} operations");
    assert_eq!(
        <Bricard>::default().rows().len(),
        4,
        "one of the five rows of the hinge that closes the loop is dropped"
    );
    // The comparison is good to 3e-9.
    for (step, bound) in [(1e-3, 1e-9), (5e-4, 1e-10)] {
        let mut simulation = Simulation::new(&model, Bricard::START).formulation(baumgarte(10.0)).step(step);
        let energy = simulation.energy();
        let (mut place, mut kept) = (Worst::default(), Worst::default());
        for row in 0..reference.rows.len() {
            let value = |name: &str| reference.get(row, name);
            simulation.advance_until(value("t")).expect("it moves all along");
            let outputs = simulation.sample().outputs;
            place.see(outputs.x, value("x"));
            place.see(outputs.y, value("y"));
            place.see(outputs.z, value("z"));
            kept.see(simulation.energy(), energy);
        }
        place.below(5e-9, "A04, P3 over 10 s");
        kept.below(bound, "A04, energy");
        let mut closed = Worst::default();
        closed.see(simulation.constraint_residual().position, 0.0);
        closed.below(1e-11, "A04, the loop after 10 s");
    }
}

/// s(t) every 0.1 s, as A05 asks for.
#[test]
fn flyball_governor() {
    let reference = Table::new(include_str!("../../data/flyball_governor_computed.csv"));
    let model = FlyballGovernor::<f64>::default();
    let (mut height, mut swing, mut speed) = (Worst::default(), Worst::default(), Worst::default());
    let mut simulation = Simulation::new(&model, FlyballGovernor::START).step(5e-5);
    for row in 0..reference.rows.len() {
        let value = |name: &str| reference.get(row, name);
        simulation.advance_until(value("t")).expect("it turns");
        let outputs = simulation.sample().outputs;
        height.see(outputs.height, value("s"));
        swing.see(outputs.swing, value("beta"));
        speed.see(outputs.speed, value("w"));
    }
    height.below(1e-11, "A05, s(t)");
    swing.below(1e-11, "A05, angle of the rods");
    speed.below(1e-10, "A05, speed of the shaft");
}

/// One redundant row; Lagrange's equation in the angle of the rods; the platform goes straight up and down.
#[test]
fn sarrus_linkage() {
    let reference = Table::new(include_str!("../../data/sarrus_linkage_computed.csv"));
    let model = SarrusLinkage::<f64>::default();
    let platform =
        SarrusLinkage::<f64>::BODIES.iter().position(|name| *name == "platform").expect("a platform");
    let mut simulation =
        Simulation::new(&model, SarrusLinkage::START).formulation(baumgarte(10.0)).step(1e-4);
    let (mut height, mut straight) = (Worst::default(), Worst::default());
    // Behind the last rows all rods lie in a plane.
    for row in 0..reference.rows.len() - 3 {
        let value = |name: &str| reference.get(row, name);
        simulation.advance_until(value("t")).expect("it comes down");
        let outputs = simulation.sample().outputs;
        height.see(outputs.height, value("h"));
        height.see(outputs.angle, value("angle"));
        straight.see(outputs.sideways_x, 0.0);
        straight.see(outputs.sideways_y, 0.0);
        let (state, a) = (*simulation.state(), simulation.acceleration().expect("it is regular"));
        let motions = model.motions(value("t"), &state.q, &state.v, &a);
        see_matrix(&mut straight, motions[platform].orientation, orientation([1.0, 0.0, 0.0, 0.0]));
    }
    height.below(1e-11, "Sarrus, height and angle");
    straight.below(1e-12, "Sarrus, platform off the straight line and turned");
}

macro_rules! slider_crank {
    ($test:ident, $model:ident, $prefix:literal) => {
        #[test]
        fn $test() {
            let reference = Table::new(include_str!("../../data/spatial_slider_crank_computed.csv"));
            let model = $model::<f64>::default();
            let (mut angle, mut rate) = (Worst::default(), Worst::default());
            let (mut stroke, mut speed) = (Worst::default(), Worst::default());
            let mut rows = 0;
            run(&model, $model::START, (20.0, 1e-4), 5.0, 2500, |row, sample| {
                let value = |name: &str| reference.get(row, &format!("{}_{name}", $prefix));
                angle.see(sample.outputs.crank_angle, value("theta"));
                rate.see(sample.outputs.crank_rate, value("rate"));
                stroke.see(sample.outputs.stroke, value("s"));
                speed.see(sample.outputs.speed, value("speed"));
                rows += 1;
            })
            .expect("the crank turns");
            assert_eq!(rows, reference.rows.len());
            angle.below(1e-8, concat!($prefix, " slider-crank, crank over eight turns"));
            rate.below(1e-7, concat!($prefix, " slider-crank, rate of the crank"));
            stroke.below(1e-9, concat!($prefix, " slider-crank, stroke"));
            speed.below(1e-8, concat!($prefix, " slider-crank, speed"));
        }
    };
}

/// The start that the library gives: slider at 0.2 m with 0.24 m/s, rod at (1.92, −0.96, 0.48) rad/s in world axes.
#[test]
fn start_of_the_slider_crank() {
    let model = SpatialSliderCrankAxial::<f64>::default();
    let mut simulation = Simulation::new(&model, SpatialSliderCrankAxial::START).step(1e-4);
    let outputs = simulation.sample().outputs;
    let mut worst = Worst::default();
    worst.see(outputs.stroke, 0.2);
    worst.see(outputs.speed, 0.24);
    let (state, a) = (*simulation.state(), simulation.acceleration().expect("it is regular"));
    let [_, rod, _] = model.motions(0.0, &state.q, &state.v, &a);
    for (found, published) in turned(rod.orientation, rod.rate).into_iter().zip([1.92, -0.96, 0.48]) {
        worst.see(found, published);
    }
    worst.below(1e-13, "slider-crank, start");
}

slider_crank!(axial_slider_crank, SpatialSliderCrankAxial, "axial");
slider_crank!(arm_slider_crank, SpatialSliderCrankArm, "arm");
slider_crank!(third_slider_crank, SpatialSliderCrankThird, "third");
slider_crank!(balanced_slider_crank, SpatialSliderCrankBalanced, "balanced");

/// The runs that González and Masoudi gave to the IFToMM library, at the accuracy they have.
#[test]
fn submitted_slider_cranks() {
    let gonzalez = Table::new(include_str!("../../data/spatial_slider_crank_gonzalez.csv"));
    let model = SpatialSliderCrankAxial::<f64>::default();
    let mut simulation =
        Simulation::new(&model, SpatialSliderCrankAxial::START).formulation(baumgarte(20.0)).step(1e-4);
    let mut stroke = Worst::default();
    for row in 0..gonzalez.rows.len() {
        simulation.advance_until(gonzalez.get(row, "t")).expect("the crank turns");
        stroke.see(simulation.sample().outputs.stroke, gonzalez.get(row, "s"));
    }
    stroke.below(6e-5, "slider-crank of Gonzalez, stroke");

    let masoudi = Table::new(include_str!("../../data/spatial_slider_crank_masoudi.csv"));
    let model = SpatialSliderCrankThird::<f64>::default();
    let (mut stroke, mut angle, mut row, mut before) = (Worst::default(), Worst::default(), 0, None);
    let mut simulation =
        Simulation::new(&model, SpatialSliderCrankThird::START).formulation(baumgarte(20.0)).step(1e-4);
    simulation
        .run_until(5.0, |sample| {
            let now = (sample.time, sample.outputs.stroke, sample.outputs.crank_angle);
            let (time_0, stroke_0, angle_0) = before.unwrap_or(now);
            // Its times are not multiples of the step: linear between two samples.
            while row < masoudi.rows.len() && masoudi.get(row, "t") <= sample.time + 1e-9 {
                let share =
                    if now.0 > time_0 { (masoudi.get(row, "t") - time_0) / (now.0 - time_0) } else { 1.0 };
                stroke.see(stroke_0 + share * (now.1 - stroke_0), masoudi.get(row, "s"));
                angle.see(angle_0 + share * (now.2 - angle_0), masoudi.get(row, "theta"));
                row += 1;
            }
            before = Some(now);
        })
        .expect("the crank turns");
    assert_eq!(row, masoudi.rows.len());
    stroke.below(2e-5, "slider-crank of Masoudi, stroke");
    angle.below(5e-4, "slider-crank of Masoudi, crank over eight turns");
}

macro_rules! four_bar {
    ($test:ident, $model:ident, $data:literal, $last:literal) => {
        #[test]
        fn $test() {
            let reference = Table::new(include_str!(concat!("../../data/", $data)));
            let model = $model::<f64>::default();
            let (mut angle, mut rate, mut last) = (Worst::default(), Worst::default(), Worst::default());
            let mut rows = 0;
            run(&model, $model::START, (20.0, 1e-4), 5.0, 1000, |row, sample| {
                angle.see(sample.outputs.crank_angle, reference.get(row, "phi"));
                rate.see(sample.outputs.crank_rate, reference.get(row, "w"));
                angle.see(1.2 + sample.outputs.stroke, reference.get(row, "xA"));
                if row + 1 == reference.rows.len() {
                    last.see(sample.outputs.crank_angle, $last);
                }
                rows += 1;
            })
            .expect("the crank turns");
            assert_eq!(rows, reference.rows.len());
            last.below(1e-9, concat!(stringify!($model), ", crank at 5 s"));
            angle.below(1e-10, concat!(stringify!($model), ", crank and slider"));
            rate.below(1e-9, concat!(stringify!($model), ", rate of the crank"));
        }
    };
}

four_bar!(four_bar_with_a_massive_rod, Fourbar1, "modelica_Fourbar1_computed.csv", 40.329165462177);
four_bar!(four_bar_with_a_massless_rod, Fourbar2, "modelica_Fourbar2_recomputed.csv", 40.24202506499);
