//! Orders of the integrators in space: quaternions of a tree, quaternions under constraints, loops of joints with one
//! angle each, counted angles of bodies that tumble. Those of the plane are in `convergence.rs`.

use linkwright::{
    Assemble, AssembleExt, Baumgarte, DormandPrince, ExplicitTrapezoidal, Formulation, Integrator,
    LagrangeIndex1, Layout, Mechanism, MechanismDynamics, NoInputs, NullSpace, Partitioned, Rk4,
    SemiImplicitEuler, Simulation, State, StateOf, Variables, Vector,
};
use linkwright_models::bricard::Bricard;
use linkwright_models::four_spherical_joints::FourSphericalJoints;
use linkwright_models::free_rigid_body::FreeRigidBody;
use linkwright_models::heavy_top::HeavyTop;
use linkwright_models::spatial_four_bar::Fourbar1;
use linkwright_models::spatial_pendulums::{ConstantVelocityPendulum, PointOnLinePendulum};
use linkwright_models::spatial_slider_crank::SpatialSliderCrankAxial;

linkwright::mechanism! {
    /// A wheel on a carrier that tumbles, wound up against a torsion spring: the angle between them is counted, its rate
    /// a linear form of both bodies' ω.
    pub spatial Gyrostat {
        body carrier { mass [kg] = 2; inertia [kg*m^2] = (0.03, 0.05, 0.06); products [kg*m^2] = (0.004, -0.002, 0.005);
                       point seat [m] = (0.1, -0.05, 0.02); }
        disk wheel   { mass [kg] = 1; radius [m] = 0.2; marker bore [m] = (0.02, 0.01, 0), axis = (0.1, 0.2, 1); }
        joint axle: revolute(carrier.seat, wheel.bore, axis = (0, 0, 1));
        torsion_spring coil: torsion_spring(axle, stiffness = 0.05 [N*m]);
        start { carrier.center.x [m] = 0; carrier.center.y [m] = 0; carrier.center.z [m] = 0;
                carrier.orientation = (1, 0, 0, 0); axle.angle [rad] = 0; axle.rate [rad/s] = 12;
                carrier.rate.x [rad/s] = 3; carrier.rate.y [rad/s] = -2; carrier.rate.z [rad/s] = 1; }
        options { coordinates = absolute; }
        output turned [rad] = axle.angle;
    }
}

/// The state after `steps` steps to `end` from the start of the model.
fn reached<M, F, I>(model: &M, (formulation, integrator): (F, I), end: f64, steps: u32) -> StateOf<M>
where
    M: Assemble<f64, Inputs = ()>,
    F: Formulation<f64, M>,
    I: for<'m> Integrator<f64, MechanismDynamics<'m, M, f64, F, NoInputs>>,
{
    let start = model.start();
    let simulation = Simulation::new(model, start).formulation(formulation).integrator(integrator);
    let reached = simulation.step(end / f64::from(steps)).advance_until(end);
    reached.unwrap_or_else(|error| panic!("{}: {error}", model.name()))
}

/// log₂ of the ratio of the errors with `steps` and with twice as many.
fn order<M, F, I>(model: &M, methods: (F, I), end: f64, steps: u32) -> f64
where
    M: Assemble<f64, Inputs = ()>,
    F: Formulation<f64, M> + Copy,
    I: for<'m> Integrator<f64, MechanismDynamics<'m, M, f64, F, NoInputs>> + Copy,
    DormandPrince: for<'m> Integrator<f64, MechanismDynamics<'m, M, f64, F, NoInputs>>,
{
    let exact = reached(model, (methods.0, DormandPrince::fixed()), end, 16 * steps.min(200));
    let error = |steps: u32| {
        let State { q, v, .. } = reached(model, methods, end, steps);
        q.plus(-1.0, &exact.q).max_abs().max(v.plus(-1.0, &exact.v).max_abs())
    };
    let (coarse, fine) = (error(steps), error(2 * steps));
    println!("{}: {coarse:.2e} {fine:.2e}", model.name());
    (coarse / fine).log2()
}

/// Rotations in space do not commute: increments that were not corrected would make Runge and Kutta's method one of order 2.
#[test]
fn fourth_order() {
    const BAUMGARTE: Baumgarte<f64> = Baumgarte { alpha: 10.0, beta: 10.0 };
    let index_1 = (LagrangeIndex1, Rk4);
    for (name, order) in [
        ("free body", order(&FreeRigidBody::default(), index_1, 2.0, 200)),
        ("heavy top", order(&HeavyTop::default(), index_1, 0.1, 200)),
        ("point on a line, tree with a ball", order(&PointOnLinePendulum::default(), index_1, 0.5, 50)),
        (
            "constant velocity, a body under constraints",
            order(&ConstantVelocityPendulum::default(), index_1, 1.0, 100),
        ),
        ("four spherical joints, absolute", order(&FourSphericalJoints::default(), index_1, 0.5, 50)),
        ("spatial four-bar", order(&Fourbar1::default(), index_1, 1.0, 150)),
        ("spatial slider-crank", order(&SpatialSliderCrankAxial::default(), index_1, 0.5, 100)),
        ("Bricard, a row dropped", order(&Bricard::default(), index_1, 1.0, 50)),
        ("spatial four-bar, Baumgarte", order(&Fourbar1::default(), (BAUMGARTE, Rk4), 1.0, 150)),
        (
            "four spherical joints, Baumgarte",
            order(&FourSphericalJoints::default(), (BAUMGARTE, Rk4), 0.5, 50),
        ),
        ("gyrostat, absolute with a counted angle", order(&Gyrostat::default(), index_1, 1.0, 100)),
    ] {
        println!("{name}: order {order:.3}");
        assert!((order - 4.0).abs() < 0.2, "{name}: order {order}");
    }
}

/// Terms of the inverse differential beyond the second are not needed.
#[test]
fn fifth_order() {
    const BAUMGARTE: Baumgarte<f64> = Baumgarte { alpha: 10.0, beta: 10.0 };
    let index_1 = (LagrangeIndex1, DormandPrince::fixed());
    let baumgarte = (BAUMGARTE, DormandPrince::fixed());
    for (name, order) in [
        ("free body", order(&FreeRigidBody::default(), index_1, 2.0, 100)),
        ("heavy top", order(&HeavyTop::default(), index_1, 0.1, 100)),
        ("point on a line, tree with a ball", order(&PointOnLinePendulum::default(), index_1, 0.5, 20)),
        (
            "constant velocity, a body under constraints",
            order(&ConstantVelocityPendulum::default(), index_1, 1.0, 40),
        ),
        ("four spherical joints, absolute", order(&FourSphericalJoints::default(), index_1, 0.3, 80)),
        ("spatial four-bar", order(&Fourbar1::default(), index_1, 1.0, 160)),
        ("spatial slider-crank", order(&SpatialSliderCrankAxial::default(), index_1, 0.3, 160)),
        ("Bricard, a row dropped", order(&Bricard::default(), index_1, 0.5, 40)),
        ("spatial four-bar, Baumgarte", order(&Fourbar1::default(), baumgarte, 0.3, 80)),
        ("four spherical joints, Baumgarte", order(&FourSphericalJoints::default(), baumgarte, 0.3, 80)),
        (
            "spatial four-bar, null space",
            order(&Fourbar1::default(), (NullSpace, DormandPrince::fixed()), 0.3, 80),
        ),
        (
            "spatial four-bar, partitioned",
            order(&Fourbar1::default(), (Partitioned::default(), DormandPrince::fixed()), 0.3, 80),
        ),
        ("gyrostat, absolute with a counted angle", order(&Gyrostat::default(), index_1, 1.0, 50)),
    ] {
        println!("{name}: order {order:.3}");
        assert!((order - 5.0).abs() < 0.3, "{name}: order {order}");
    }
}

#[test]
fn second_order() {
    let trapezoidal = (LagrangeIndex1, ExplicitTrapezoidal);
    for (name, order) in [
        ("free body", order(&FreeRigidBody::default(), trapezoidal, 2.0, 800)),
        ("heavy top", order(&HeavyTop::default(), trapezoidal, 0.05, 800)),
        ("four spherical joints, absolute", order(&FourSphericalJoints::default(), trapezoidal, 0.3, 200)),
        ("spatial four-bar", order(&Fourbar1::default(), trapezoidal, 0.3, 200)),
        ("gyrostat, absolute with a counted angle", order(&Gyrostat::default(), trapezoidal, 1.0, 400)),
    ] {
        println!("{name}: order {order:.3}");
        assert!((order - 2.0).abs() < 0.2, "{name}: order {order}");
    }
}

#[test]
fn first_order() {
    let euler = (LagrangeIndex1, SemiImplicitEuler);
    for (name, order) in [
        ("heavy top", order(&HeavyTop::default(), euler, 0.02, 2000)),
        ("point on a line, tree with a ball", order(&PointOnLinePendulum::default(), euler, 0.5, 800)),
        ("four spherical joints, absolute", order(&FourSphericalJoints::default(), euler, 0.3, 800)),
        ("spatial four-bar", order(&Fourbar1::default(), euler, 0.3, 800)),
        ("spatial slider-crank", order(&SpatialSliderCrankAxial::default(), euler, 0.3, 800)),
    ] {
        println!("{name}: order {order:.3}");
        assert!((order - 1.0).abs() < 0.2, "{name}: order {order}");
    }
}

/// The counted angle of the axle, which is integrated by itself, stays that of the two quaternions.
#[test]
fn counted_angles_are_those_of_the_quaternions() {
    use std::f64::consts::{PI, TAU};
    let model = Gyrostat::<f64>::default();
    let Layout { quaternions, angles, .. } = *model.layout();
    assert_eq!((quaternions, angles.len()), (2, 1), "two bodies and an angle between them");
    let place = |name: &str| Gyrostat::<f64>::BODIES.iter().position(|body| *body == name).expect("a body");
    let (carrier, wheel) = (place("carrier"), place("wheel"));
    let off = |step: f64| {
        let (mut worst, mut least, mut most) = (0.0_f64, 0.0_f64, 0.0_f64);
        let run = Simulation::new(&model, Gyrostat::START).step(step).run_until(8.0, |sample| {
            let motions = model.motions(sample.time, &sample.state.q, &sample.state.v, &model.zero_v());
            // The bore's axes in the wheel: z = (0.1, 0.2, 1)/|…|, x that of the canonical frame of its z.
            let z = [0.1, 0.2, 1.0].map(|part: f64| part / 1.05_f64.sqrt());
            let [x, y] = frame(z);
            let world = |axis: [f64; 3]| motions[wheel].orientation.map(|row| dot(row, axis));
            let [x_1, y_1] = [0, 1].map(|axis| motions[carrier].orientation.map(|row| row[axis]));
            // The angle from the seat's x to the bore's x; both frames turn about one axis.
            let (x_2, y_2) = (world(x), world(y));
            let angle = (dot(y_1, x_2) - dot(x_1, y_2)).atan2(dot(x_1, x_2) + dot(y_1, y_2));
            let turned = sample.outputs.turned;
            worst = worst.max(((turned - angle + PI).rem_euclid(TAU) - PI).abs());
            (least, most) = (least.min(turned), most.max(turned));
        });
        run.expect("it tumbles");
        assert!(most - least > TAU, "it turned by {} rad only", most - least);
        worst
    };
    let (coarse, fine) = (off(2e-3), off(1e-3));
    println!("counted angle off the quaternions: {coarse:.2e} {fine:.2e}");
    assert!(fine < 1e-6 && coarse / fine > 12.0, "{coarse:e} {fine:e}");
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// x and y of the canonical frame of a unit vector z whose largest component is the third.
fn frame(z: [f64; 3]) -> [[f64; 3]; 2] {
    let x = [1.0 - z[0] * z[0], -z[0] * z[1], -z[0] * z[2]];
    let x = x.map(|part| part / dot(x, x).sqrt());
    [x, [z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]]]
}
