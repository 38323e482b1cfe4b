//! Rigid contacts: against closed forms and published values, by every explicit method, in both coordinate sets, in closed loops.

use linkwright::{
    Assemble, AugmentedLagrangian, Baumgarte, DormandPrince, ExplicitTrapezoidal, Formulation, Integrator,
    LagrangeIndex1, MechanismDynamics, NoInputs, NullSpace, Partitioned, Penalty, Projected, Rk4,
    SemiImplicitEuler, Simulation, SimulationError, StateOf, Step,
};

linkwright::mechanism! {
    planar Bouncing {
        gravity [m/s^2] = (0, -9.81);
        particle ball { mass [kg] = 1; }
        surface below: point(ball.center);
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        contact stop: between(below, floor) = rigid(restitution = 0.8);
        start { ball.center.x [m] = 0; ball.center.y [m] = 1; }
        output height [m] = ball.center.y;
        output force [N] = stop.force;
        output gap [m] = stop.gap;
    }
}

/// Two rods on a pin, whose tip comes to a wall.
macro_rules! hammer {
    ($name:ident, $coordinates:ident) => {
        linkwright::mechanism! {
            planar $name {
                param share [1] = 0.5;
                gravity [m/s^2] = (0, -9.81);
                rod upper { mass [kg] = 1; length [m] = 1; }
                rod lower { mass [kg] = 1; length [m] = 1; surface tip: point(lower.end); }
                joint shoulder: revolute(ground(0, 0) [m], upper.start);
                joint elbow: revolute(upper.end, lower.start);
                surface wall: half_plane(line(ground(0.5, -3) [m], ground(0.5, 3) [m]));
                contact strike: between(lower.tip, wall) = rigid(restitution = share);
                start { upper.angle [deg] = -150; lower.angle [deg] = -180; }
                options { coordinates = $coordinates; emit = (null_space); }
                output above [rad/s] = upper.rate;
                output below [rad/s] = lower.rate;
            }
        }
    };
}
hammer!(Hammer, absolute);
hammer!(HammerInTree, tree);

linkwright::mechanism! {
    /// Between two walls, with nothing else.
    planar Between {
        particle ball { mass [kg] = 1; }
        surface spot: point(ball.center);
        surface left: half_plane(line(ground(0, 1) [m], ground(0, 0) [m]));
        surface right: half_plane(line(ground(1, 0) [m], ground(1, 1) [m]));
        contact on_left: between(spot, left) = rigid(restitution = 0.9999);
        contact on_right: between(spot, right) = rigid(restitution = 0.9999);
        start { ball.center.x [m] = 0.3; ball.center.y [m] = 0; ball.center.velocity.x [m/s] = 1; }
    }
}

linkwright::mechanism! {
    /// A slider-crank whose slider comes to a stop at the end of its rail, and whose crank to one of its own.
    planar Stopped {
        gravity [m/s^2] = (0, -9.81);
        rod crank { mass [kg] = 1; length [m] = 0.2; }
        rod coupler { mass [kg] = 2; length [m] = 0.5; }
        body slider { mass [kg] = 1.5; inertia [kg*m^2] = 0.01; }
        joint hinge: revolute(ground(0, 0) [m], crank.start);
        joint pin: revolute(crank.end, coupler.start);
        joint wrist: revolute(coupler.end, slider.center);
        joint rail: prismatic(ground(0, 0) [m], slider.center, axis = (1, 0));
        limit end: rail.travel [mm] in 0..640 = rigid(restitution = 0.6);
        limit stop: hinge.angle [deg] in -200..150 = rigid(restitution = 0.3);
        start { hinge.angle [deg] = 120; coupler.angle [deg] ~ -20; }
        options { coordinates = absolute; emit = (null_space); }
        output angle [rad] = hinge.angle;
        output travel [m] = rail.travel;
    }
}

linkwright::mechanism! {
    /// A bar that falls flat on both of its ends.
    planar Flat {
        gravity [m/s^2] = (0, -9.81);
        rod bar { mass [kg] = 3; length [m] = 1; surface left: point(bar.start); surface right: point(bar.end); }
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        contact on_left: between(bar.left, floor) = rigid(restitution = 0.5);
        contact on_right: between(bar.right, floor) = rigid(restitution = 0.5);
        start { bar.center.x [m] = 0; bar.center.y [m] = 0.2; bar.angle [rad] = 0; }
        output forces [N] = on_left.force - on_right.force;
        output force [N] = on_left.force;
    }
}

linkwright::mechanism! {
    /// A ball on a table that falls away faster and faster.
    spatial Left {
        gravity [m/s^2] = (0, 0, -9.81);
        particle ball { mass [kg] = 2; }
        surface below: point(ball.center);
        surface table: plane(ground(0 [m], 0 [m], -10 [m/s^4]*time^4), axis = (0, 0, 1));
        contact stop: between(below, table) = rigid(restitution = 0);
        start { ball.center.x [m] = 0; ball.center.y [m] = 0; ball.center.z [m] = 0; }
        output force [N] = stop.force;
    }
}

#[track_caller]
fn close(found: f64, expected: f64, within: f64, what: &str) {
    println!("{what}: {found:.15}, {:.1e} off (bound {within:.0e})", (found - expected).abs());
    assert!((found - expected).abs() <= within, "{what}: {found} in place of {expected}");
}

/// It falls 1 m, touches at √(2h/g) and then after 2 eⁿ √(2h/g) each.
#[test]
fn a_ball_bounces_and_rests() {
    let model = Bouncing::default();
    let mut simulation = Simulation::new(&model, Bouncing::START).step(1e-3);
    for touch in [0.4515236409857309, 1.1739614665629004, 1.7519117270246359] {
        simulation.advance_until(touch - 1e-9).expect("it moves");
        let before = simulation.state().v[1];
        simulation.advance_until(touch + 1e-9).expect("it moves");
        close(simulation.state().v[1], -0.8 * before, 1e-7, "speed after a touch");
    }
    simulation.advance_until(2.0).expect("it moves");
    close(simulation.state().q[1], 0.2607417283270572, 1e-11, "height");
    simulation.advance_until(3.0).expect("it moves");
    close(simulation.state().q[1], 0.068_707_460_965_765_72, 1e-11, "height");
    let at_rest = 4.063_712_768_871_578;
    let (mut rested, mut lost, mut impacts) = (0, 0.0, 0);
    simulation.advance_until(at_rest - 2e-9).expect("it moves");
    assert_eq!(simulation.state().gates, [0.0]);
    while simulation.time() < 4.2 {
        let step = simulation.advance().expect("it moves");
        (rested, lost, impacts) = (rested + step.rested, lost + step.lost, impacts + step.impacts);
    }
    println!("{impacts} impacts, {lost:e} J in the last of them");
    assert_eq!(rested, 1);
    assert_eq!((simulation.state().q[1], simulation.state().v[1]), (0.0, 0.0));
    close(simulation.sample().outputs.force, 9.81, 1e-12, "force at rest");
    let mut simulation = Simulation::new(&model, Bouncing::START).step(1e-3);
    let (mut lost, mut rested) = (0.0, 0);
    while simulation.time() < at_rest + 1e-9 - 1e-3 {
        lost += simulation.advance().expect("it moves").lost;
    }
    for end in [at_rest - 1e-9, at_rest + 1e-9] {
        while simulation.time() < end {
            let left = end - simulation.time();
            let step = simulation.step(left.min(1e-3));
            simulation = step;
            let step = simulation.advance().expect("it moves");
            lost += step.lost;
            rested += step.rested;
        }
    }
    assert_eq!(rested, 1);
    close(lost, 9.81, 1e-9, "lost");
}

/// Samples at even times, before, between and after touches.
#[test]
fn dense_output_ends_at_a_touch() {
    let model = Bouncing::default();
    let mut simulation =
        Simulation::new(&model, Bouncing::START).integrator(DormandPrince::tolerance(1e-11)).step(0.1);
    let mut forces = 0;
    simulation
        .run_every(0.01, 4.5, |sample| {
            assert!(sample.outputs.height >= -1e-12, "{} m at {} s", sample.outputs.height, sample.time);
            assert_eq!(sample.outputs.gap, sample.outputs.height);
            if (sample.time - 3.0).abs() < 1e-9 {
                close(sample.outputs.height, 0.068_707_460_965_765_72, 1e-9, "height");
            }
            if sample.time > 4.07 {
                close(sample.outputs.force, 9.81, 1e-12, "force at rest");
                forces += 1;
            }
        })
        .expect("it moves");
    assert!(forces > 40);
}

macro_rules! struck {
    ($model:ident, $parameters:ident, $share:literal, $after:expr, $lost:literal) => {{
        let model = $model::prepare($parameters { share: $share }).expect("a share");
        let touch = 0.7075810264493055;
        let mut simulation = Simulation::new(&model, $model::START).step(1e-4);
        simulation.advance_until(touch - 1e-9).expect("it moves");
        assert!(simulation.sample().outputs.above < 3.35);
        let mut simulation = simulation.step(2e-9);
        let step = simulation.advance().expect("it moves");
        assert_eq!(step.impacts, 1);
        close(step.lost, $lost, 1e-8, "lost");
        let outputs = simulation.sample().outputs;
        for (found, expected) in [outputs.above, outputs.below].into_iter().zip($after) {
            close(found, expected, 1e-7, "rate after the touch");
        }
    }};
}

/// Two rods and a wall, frictionless: times, rates and energies by two tolerances of another program.
#[test]
fn a_hammer_strikes_a_wall() {
    struck!(Hammer, HammerParameters, 0.5, [4.7185486690284, -8.08191058550152], 4.0788729150076);
    struck!(HammerInTree, HammerInTreeParameters, 0.5, [4.7185486690284, -8.08191058550152], 4.0788729150076);
    struck!(Hammer, HammerParameters, 1.0, [5.17710102491304, -11.5146065184155], 0.0);
    struck!(
        HammerInTree,
        HammerInTreeParameters,
        0.0,
        [4.25999631314376, -4.64921465258749],
        5.43849722001014
    );
}

/// The energy that is missing in the end, and where it is then.
fn balance<'m, M, F, I>(
    model: &'m M,
    start: StateOf<M>,
    formulation: F,
    integrator: I,
    h: f64,
) -> (u32, f64, StateOf<M>)
where
    M: Assemble<f64, Inputs = ()>,
    F: Formulation<f64, M>,
    I: Integrator<f64, MechanismDynamics<'m, M, f64, F, NoInputs>>,
{
    let mut simulation =
        Simulation::new(model, start).formulation(formulation).integrator(integrator).step(h);
    let (begun, mut lost, mut impacts) = (simulation.energy(), 0.0, 0);
    let steps = (END / h).round() as usize;
    for _ in 0..steps {
        let step: Step = simulation.advance().expect("it moves");
        (lost, impacts) = (lost + step.lost, impacts + step.impacts);
        if simulation.time() >= END - 1e-9 {
            break;
        }
    }
    (impacts, simulation.energy() + lost - begun, simulation.state().clone())
}

const END: f64 = 0.9;

/// Impulses through a closed loop: energies close, and every method comes to the same place.
#[test]
fn a_slider_crank_comes_to_its_stops() {
    let model = Stopped::default();
    let projected = Projected::after(NullSpace);
    let (impacts, off, end) = balance(&model, Stopped::START, projected, Rk4, 1e-4);
    println!("{impacts} impacts, energy {off:.1e} J off, at {:?}", end.q);
    assert!(impacts >= 3 && off.abs() < 1e-9);
    let augmented = AugmentedLagrangian::new(Penalty::for_model(&model, 0.0, &Stopped::START.q, 5e-4));
    macro_rules! by {
        ($($name:literal: $formulation:expr, $integrator:expr, $h:literal, $bound:literal;)*) => {$({
            let (count, off, found) = balance(&model, Stopped::START, $formulation, $integrator, $h);
            let away = end.q.iter().zip(found.q).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            println!("{}: {count} impacts, {off:.1e} J, {away:.1e} away", $name);
            assert!(away <= $bound && count > 5 && off.abs() <= $bound, "{}", $name);
        })*};
    }
    by! {
        "index 1, RK4": LagrangeIndex1, Rk4, 5e-4, 1e-6;
        "null space, RK4": NullSpace, Rk4, 5e-4, 1e-6;
        "Baumgarte, RK4": Baumgarte { alpha: 10.0, beta: 10.0 }, Rk4, 5e-4, 1e-6;
        "partitioned, RK4": Partitioned::default(), Rk4, 5e-4, 1e-4;
        "penalty, RK4": Penalty::for_model(&model, 0.0, &Stopped::START.q, 1e-4), Rk4, 1e-4, 1e-2;
        "augmented Lagrangian, RK4": augmented, Rk4, 5e-4, 1e-6;
        "explicit trapezoidal": LagrangeIndex1, ExplicitTrapezoidal, 5e-4, 1e-2;
        "semi-implicit Euler": LagrangeIndex1, SemiImplicitEuler, 1e-4, 5e-2;
    }
}

/// A mechanism whose bar falls flat: both ends at once, by symmetry with equal impulses, and to rest.
#[test]
fn two_at_once() {
    let model = Flat::default();
    let mut simulation = Simulation::new(&model, Flat::START).step(1e-3);
    let (mut rested, mut lost) = (0, 0.0);
    let mut most = 0;
    while simulation.time() < 1.0 {
        let step = simulation.advance().expect("it moves");
        (rested, lost) = (rested + step.rested, lost + step.lost);
        most = most.max(step.impacts);
        assert!(simulation.state().v.as_slice().iter().skip(2).all(|rate| rate.abs() < 1e-9));
    }
    assert!(most >= 2);
    assert_eq!(rested, 2);
    close(lost, 3.0 * 9.81 * 0.2, 1e-9, "lost");
    close(simulation.sample().outputs.force, 1.5 * 9.81, 1e-9, "force at rest");
    close(simulation.sample().outputs.forces, 0.0, 1e-9, "difference of the forces");
}

/// It rests with m (g − 120 t²), parts where that is zero, and then flies.
#[test]
fn what_rests_parts_where_its_force_ends() {
    let model = Left::default();
    let mut simulation = Simulation::new(&model, Left::START).step(1e-3);
    let left = (9.81_f64 / 120.0).sqrt();
    simulation.advance_until(0.2).expect("it moves");
    close(simulation.state().q[2], -10.0 * 0.2_f64.powi(4), 1e-12, "height at rest");
    close(simulation.sample().outputs.force, 2.0 * (9.81 - 120.0 * 0.04), 1e-9, "force at rest");
    simulation.advance_until(left - 1e-8).expect("it moves");
    assert!(simulation.state().gates[0] > 0.0);
    simulation.advance_until(left + 1e-8).expect("it moves");
    assert_eq!(simulation.state().gates[0], 0.0);
    simulation.advance_until(0.5).expect("it moves");
    let flown = 0.5 - left;
    let height = -10.0 * left.powi(4) - 40.0 * left.powi(3) * flown - 0.5 * 9.81 * flown * flown;
    close(simulation.state().q[2], height, 1e-9, "height in flight");
}

/// Ten thousand impacts, none lost: the speed is eⁿ of that at the start.
#[test]
fn nothing_falls_through() {
    let model = Between::default();
    let mut simulation = Simulation::new(&model, Between::START).step(0.2);
    let mut impacts = 0;
    while impacts < 10_000 {
        impacts += simulation.advance().expect("it moves").impacts;
        assert!(simulation.state().q[0] >= -1e-12 && simulation.state().q[0] <= 1.0 + 1e-12);
    }
    let expected = 0.9999_f64.powi(2 * impacts as i32);
    close(2.0 * simulation.energy() / expected, 1.0, 1e-9, "energy");
}

/// What cannot be is named, and changes nothing.
#[test]
fn what_cannot_be_is_named() {
    let model = Bouncing::default();
    let inside = StateOf::<Bouncing> { q: [0.0, -0.01], ..Bouncing::START };
    let mut simulation = Simulation::new(&model, inside).step(1e-3);
    let error = simulation.advance().expect_err("it is inside");
    let SimulationError::Inside { contact: "stop", time: 0.0, depth } = error else { panic!("{error}") };
    close(depth, 0.01, 1e-12, "depth");
    assert!(error.to_string().contains("the rigid `stop` is 1.0e-2 m (or rad) inside"), "{error}");
    assert_eq!(error.joint(), Some("stop"));
    for error in [
        SimulationError::Crowded { contact: "stop", time: 1.0, most: 4 },
        SimulationError::NoImpact { contact: "stop", time: 1.0 },
        SimulationError::RigidByResidual { contact: "stop" },
    ] {
        assert!(error.to_string().contains("`stop`"), "{error}");
        assert_eq!(error.joint(), Some("stop"));
    }
}
