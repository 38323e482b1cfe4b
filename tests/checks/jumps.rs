//! Speeds that jump at events: against closed forms, in both coordinate sets, compiled and interpreted.

use linkwright::{
    AssembleExt, DormandPrince, LagrangeIndex1, Projected, Rk4, Simulation, SimulationError, Vector,
};
use linkwright_engine::Engine;
use mechanisms::zoo_memories::{Remembering, RememberingInputs};

/// Outputs after a run of steps of this size to a time.
fn after(engine: &Engine, step: f64, end: f64) -> Vec<f64> {
    let mut simulation =
        Simulation::new(engine, engine.start()).constant(engine.no_inputs()).integrator(Rk4).step(step);
    simulation.advance_until(end).expect("it moves");
    simulation.sample().outputs.as_slice().to_vec()
}

#[track_caller]
fn close(found: f64, wanted: f64, bound: f64, what: &str) {
    assert!((found - wanted).abs() <= bound, "{what}: {found} for {wanted}");
}

/// A restitution by hand is the ball that bounces by closed form: touches at t₁ (1 + 2 e (1 − eⁿ)/(1 − e)), t₁ = √(2 h/g), and apices e²ⁿ h.
#[test]
fn a_ball_bounces_by_an_event() {
    let source = "planar Ball {
        gravity [m/s^2] = (0, -9.81);
        body ball { mass [kg] = 0.3; inertia [kg*m^2] = 1e-3; }
        joint rail: prismatic(ground(0, 0) [m], ball.center, axis = (0, 1));
        event touch: rail.travel falls 0 [m] { jump(rail.speed) = -0.8*rail.speed; }
        start { rail.travel [m] = 1; rail.speed [m/s] = 0; }
        output height [m] = rail.travel; }";
    let engine = Engine::read(source).expect("it is well");
    for (time, height) in
        [(1.0, 0.468_004_452_526_036_3), (2.0, 0.260_741_728_327_057_2), (3.0, 0.068_707_460_965_765_7)]
    {
        close(after(&engine, 0.01, time)[0], height, 1e-10, "height");
    }
    let mut simulation = Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).step(0.5);
    let steps = (0..4).map(|_| simulation.advance().expect("it moves").events);
    assert_eq!(steps.collect::<Vec<_>>(), [1, 0, 1, 1]);
}

/// What is not held by the jump keeps its momentum: of a rod that hangs on a slider p = J θ̇ − ½ m l sin θ ẋ, J = m l²/3, θ from the x axis.
#[test]
fn what_hangs_on_it_keeps_its_momentum() {
    let of = |coordinates: &str| {
        let source = format!(
            "planar Crane {{ gravity [m/s^2] = (0, -9.81);
             body slider {{ mass [kg] = 1.5; inertia [kg*m^2] = 0.01; }} rod pendulum {{ mass [kg] = 0.5; length [m] = 0.6; }}
             joint rail: prismatic(ground(0, 0) [m], slider.origin, axis = (1, 0));
             joint pin: revolute(slider.origin, pendulum.start);
             event push: time rises 0.3 [s] {{ jump(rail.speed) = 2 [m/s]; }}
             start {{ rail.travel [m] = 0; rail.speed [m/s] = -0.4; pin.angle [deg] = -30; pin.rate [rad/s] = 1; }}
             options {{ coordinates = {coordinates}; }}
             output angle [rad] = pin.angle; output rate [rad/s] = pin.rate; output speed [m/s] = rail.speed; }}"
        );
        let engine = Engine::read(&source).expect("it is well");
        [0.3 - 1e-9, 0.3 + 1e-9, 0.9].map(|time| after(&engine, 1e-3, time))
    };
    let [before, behind, end] = of("tree");
    let momentum = |at: &[f64]| 0.5 * 0.36 / 3.0 * at[1] - 0.25 * 0.6 * at[0].sin() * at[2];
    close(momentum(&behind), momentum(&before), 1e-8, "momentum");
    close(behind[2], 2.0, 1e-8, "speed");
    assert!((behind[1] - before[1]).abs() > 1.0, "{before:?} {behind:?}");
    let other = of("absolute");
    for (a, b) in other[1].iter().chain(&other[2]).zip(behind.iter().chain(&end)) {
        close(*a, *b, 1e-8, "absolute coordinates");
    }
}

const LINKAGE: &str = "body crank { mass [kg] = 0.4; inertia [kg*m^2] = 2e-3; point pin [m] = (0.1, 0); }
    body coupler { mass [kg] = 0.6; inertia [kg*m^2] = 5e-3; point far [m] = (0.35, 0); }
    body rocker { mass [kg] = 0.5; inertia [kg*m^2] = 4e-3; point far [m] = (0.25, 0); }
    joint axle: revolute(ground(0, 0) [m], crank.origin); joint knee: revolute(crank.pin, coupler.origin);
    joint wrist: revolute(coupler.far, rocker.far); joint foot: revolute(ground(0.3, 0) [m], rocker.origin);";

/// A linkage at rest goes on as the one that starts with the speed to which it jumps; its loop stays closed.
#[test]
fn a_loop_takes_its_share() {
    for coordinates in ["tree", "absolute"] {
        let of = |event: &str, rate: f64| {
            let source = format!(
                "planar Linkage {{ {LINKAGE} {event} start {{ axle.angle [deg] = 60; foot.angle [deg] ~ 110; axle.rate [rad/s] = {rate}; }}
                 options {{ coordinates = {coordinates}; }}
                 output a [rad/s] = axle.rate; output b [rad/s] = foot.rate; output c [rad] = wrist.angle; }}"
            );
            Engine::read(&source).unwrap_or_else(|found| panic!("{found}"))
        };
        let started = of("", 5.0);
        let (engine, whole) =
            (of("event go: time rises 0.25 [s] { jump(axle.rate) = 5 [rad/s]; }", 0.0), 0.25);
        let mut simulation = Simulation::new(&engine, engine.start())
            .constant(engine.no_inputs())
            .formulation(Projected::after(LagrangeIndex1))
            .integrator(DormandPrince::tolerance(1e-11))
            .step(0.05);
        simulation.advance_until(whole).expect("it moves");
        assert_eq!(simulation.sample().outputs.as_slice()[0], 0.0);
        simulation.advance_until(whole + 0.4).expect("it moves");
        assert!(simulation.constraint_residual().velocity < 1e-10, "{:?}", simulation.constraint_residual());
        let other = after(&started, 1e-4, 0.4);
        for (found, wanted) in simulation.sample().outputs.as_slice().iter().zip(&other) {
            close(*found, *wanted, 1e-7, coordinates);
        }
    }
}

/// What jumps at one time does so together, by the values before; what follows from a jump is another pass at the same time.
#[test]
fn several_jump_together() {
    let source = "spatial Puck {
        body puck { mass [kg] = 0.3; inertia [kg*m^2] = (0.1, 0.2, 0.15); }
        memory hits = 0;
        event one: time rises 0.2 [s] { jump(puck.center.velocity.x) = 2*puck.center.velocity.y; }
        event two: time rises 0.2 [s] { jump(puck.center.velocity.y) = -puck.center.velocity.x; hits = hits + 1; }
        event fast: puck.center.velocity.x rises 3 [m/s] { hits = hits + 10; jump(puck.center.velocity.z) = 7 [m/s]; }
        start { puck.center.x [m] = 0; puck.center.y [m] = 0; puck.center.z [m] = 0;
                puck.center.velocity.x [m/s] = 1; puck.center.velocity.y [m/s] = 2; puck.center.velocity.z [m/s] = 0; }
        output x [m] = puck.center.x; output y [m] = puck.center.y; output z [m] = puck.center.z; output hits = hits; }";
    let engine = Engine::read(source).unwrap_or_else(|found| panic!("{found}"));
    let found = after(&engine, 0.03, 0.5);
    for (found, wanted) in found.iter().zip([0.2 + 0.3 * 4.0, 0.4 - 0.3, 0.3 * 7.0, 11.0]) {
        close(*found, wanted, 1e-11, "puck");
    }
    let mut simulation = Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).step(0.5);
    assert_eq!(simulation.advance().expect("it moves").events, 3);
}

/// Joints, drivers and other jumps may hold what is to jump.
#[test]
fn what_is_held_does_not_jump() {
    let of = |events: &str, start: &str| {
        let source =
            format!("planar Linkage {{ {LINKAGE} {events} start {{ foot.angle [deg] ~ 110; {start} }} }}");
        Engine::read(&source).unwrap_or_else(|found| panic!("{found}"))
    };
    let free = "axle.angle [deg] = 60; axle.rate [rad/s] = 1;";
    let together = "event one: time rises 0.1 [s] { jump(axle.rate) = 2 [rad/s]; }
        event two: time rises 0.1 [s] { jump(foot.rate) = 2 [rad/s]; }";
    let driven = "drive turn: axle.angle = 1 [rad] + 2 [rad/s]*time; event one: time rises 0.1 [s] { jump(foot.rate) = 9 [rad/s]; }";
    for (events, start) in [(together, free), (driven, "")] {
        let engine = of(events, start);
        let mut simulation = Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).step(0.03);
        let error = simulation.advance_until(1.0).expect_err("it is held");
        let SimulationError::NoJump { event: "one", time } = error else { panic!("{error}") };
        close(time, 0.1, 1e-9, "time");
        assert_eq!(error.joint(), Some("one"));
        assert!(error.to_string().contains("cannot: joints or drivers hold it"), "{error}");
        // It stands at the step before.
        close(simulation.time(), 0.09, 1e-12, "time");
    }
    let none = of(
        "memory none = 0; event one: time rises 0.1 [s] { none = 1; jump(axle.rate) = 1 [rad/s]/none; }",
        free,
    );
    let mut simulation = Simulation::new(&none, none.start()).constant(none.no_inputs()).step(0.03);
    let error = simulation.advance_until(1.0).expect_err("it is infinite");
    assert!(matches!(error, SimulationError::NonFinite { what: "one", .. }), "{error}");
}

/// What a speed would jump to is asked for only where it does: here it divides by what is zero before.
#[test]
fn what_does_not_occur_asks_for_no_number() {
    let source = "planar Puck {
        body puck { mass [kg] = 0.3; inertia [kg*m^2] = 0.1; }
        memory share = 0;
        event ready: time rises 0.1 [s] { share = 2; }
        event go: time rises 0.2 [s] { jump(puck.center.velocity.x) = 6 [m/s]/share; }
        start { puck.center.x [m] = 0; puck.center.y [m] = 0; puck.center.velocity.x [m/s] = 0; puck.center.velocity.y [m/s] = 0; }
        output x [m] = puck.center.x; }";
    let engine = Engine::read(source).unwrap_or_else(|found| panic!("{found}"));
    close(after(&engine, 0.03, 0.5)[0], 0.9, 1e-12, "puck");
}

/// Compiled and interpreted speeds have the same bits.
#[test]
fn the_interpreter_jumps_alike() {
    let (engine, model) = (Engine::read(Remembering::SOURCE).expect("it is well"), Remembering::default());
    let mut one = Simulation::new(&model, model.start()).constant(RememberingInputs { pull: 0.0 }).step(7e-3);
    let mut other = Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).step(7e-3);
    one.advance_until(1.3 - 1e-9).expect("it moves");
    let before = one.sample().outputs.back;
    one.advance_until(1.3 + 1e-9).expect("it moves");
    close(one.sample().outputs.back, 0.1 - 0.5 * before, 1e-7, "the speed of the bolt");
    other.advance_until(1.3 - 1e-9).expect("it moves");
    other.advance_until(1.3 + 1e-9).expect("it moves");
    let bits = |v: &[f64]| v.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(one.state().v.as_slice()), bits(other.state().v.as_slice()));
}
