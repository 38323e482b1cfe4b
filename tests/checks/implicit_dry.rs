//! Dry friction in joints under methods that iterate on residuals: the same motions as by explicit methods, their order, what is stiff, and errors.

use linkwright::{
    Ali3p, AssembleExt, GeneralisedAlpha, ImplicitTrapezoidal, LagrangeIndex1, LinearisationError, Projected,
    Rk4, Simulation, SimulationError, Vector, equilibrium,
};
use linkwright_engine::{Derivatives, Engine};
use mechanisms::zoo_dry::{Braking, BrakingAllWays, BrakingInSpace};

linkwright::mechanism! {
    /// A four-bar whose pins at the ground brake it until it stands, and turns again: there both hold the same.
    planar FourBar {
        gravity [m/s^2] = (0, -9.81);
        param large [m] = 0.03;
        rod crank { mass [kg] = 1; length [m] = 0.2; }
        rod coupler { mass [kg] = 2.5; length [m] = 0.5; }
        rod rocker { mass [kg] = 2; length [m] = 0.4; }
        joint a: revolute(ground(0, 0) [m], crank.start);
        joint b: revolute(crank.end, coupler.start);
        joint c: revolute(coupler.end, rocker.end);
        joint d: revolute(ground(0.6, 0) [m], rocker.start);
        friction drum: on(a) = dry(static = 0.4, kinetic = 0.3, radius = large);
        friction band: on(d) = dry(torque [N*m] = 1.5, breakaway [N*m] = 2);
        start { a.angle [deg] = 60; a.rate [rad/s] = 12; rocker.angle [deg] ~ 98; }
        options { emit = (tangent); self_check = on; }
        output angle [rad] = a.angle;
        output rate [rad/s] = a.rate;
        output pressed [N] = drum.normal;
    }
}

#[track_caller]
fn close(found: f64, expected: f64, within: f64, what: &str) {
    println!("{what}: {found:.15}, {:.1e} off (bound {within:.0e})", (found - expected).abs());
    assert!((found - expected).abs() <= within, "{what}: {found} in place of {expected}");
}

fn four_bar(large: f64) -> FourBar {
    FourBar::prepare(FourBarParameters { large }).expect("a pin")
}

fn read(source: &str) -> Engine<Derivatives> {
    Engine::<Derivatives>::read_with_derivatives(source).unwrap_or_else(|found| panic!("{found}"))
}

/// The outputs after a time by a method, how often something began to stick or slide, and how many iterations a step took at most.
macro_rules! after {
    ($engine:expr, $formulation:expr, $method:expr, $step:expr, $time:expr) => {{
        let engine = $engine;
        let mut simulation = Simulation::new(engine, engine.start())
            .formulation($formulation)
            .constant(engine.no_inputs())
            .integrator($method)
            .step($step);
        let (mut changed, mut iterations) = (0, 0);
        while simulation.time() < $time - 1e-9 {
            let step = simulation.advance().unwrap_or_else(|error| panic!("{error}"));
            changed += step.gates_changed;
            iterations = iterations.max(step.iterations);
        }
        (simulation.sample().outputs.as_slice().to_vec(), changed, iterations)
    }};
    ($engine:expr, $method:expr, $step:expr, $time:expr) => {
        after!($engine, LagrangeIndex1, $method, $step, $time)
    };
}

/// The order by the errors of two steps, after as many changes as by an explicit method in small ones.
macro_rules! orders {
    ($engine:expr, $time:expr, $steps:expr, $least:expr, $within:expr) => {{
        let engine = $engine;
        let (exact, changes, _) = after!(engine, Rk4, 5e-4, $time);
        orders!(@ engine, $time, $steps, $least, $within, exact, changes;
            "implicit trapezoidal": ImplicitTrapezoidal::<f64>::default();
            "generalised-alpha": GeneralisedAlpha::new(0.8);
            "ALI3-P": Ali3p::new(1e9););
        changes
    }};
    (@ $engine:ident, $time:expr, $steps:expr, $least:expr, $within:expr, $exact:ident, $changes:ident; $($name:literal: $method:expr;)*) => { $(
        let errors = $steps.map(|step| {
            let (found, changed, _) = after!($engine, $method, step, $time);
            assert_eq!(changed, $changes, "{}, steps of {step} s", $name);
            found.iter().zip(&$exact).map(|(a, b)| (a - b).abs() / (1.0 + b.abs())).fold(0.0, f64::max)
        });
        let order = (errors[0] / errors[1]).log2();
        println!("{}: {errors:?}, order {order:.2}, {} changes", $name, $changes);
        assert!(errors[0] < $within && order > $least, "{}: {errors:?}, order {order}", $name);
    )* };
}

/// A block that is thrown up a slope stops where it must, and is held there.
#[test]
fn a_block_on_a_rail_stops_and_stays() {
    let engine = read(
        "planar Slope { const slope [deg] = 20; gravity = (-9.81 [m/s^2]*sin(slope), -9.81 [m/s^2]*cos(slope));
            body block { mass [kg] = 2; inertia [kg*m^2] = 0.01; }
            joint rail: prismatic(ground(0, 0) [m], block.center, axis = (1, 0));
            friction rub: on(rail) = dry(static = 0.5, length [m] = 0.2);
            start { rail.travel [m] = 0; rail.speed [m/s] = 2; }
            output x [m] = rail.travel; output v [m/s] = rail.speed; output held [N] = rub.force; }",
    );
    macro_rules! holds {
        ($($method:expr),*) => { $(
            let (found, changed, _) = after!(&engine, $method, 1e-2, 2.0);
            assert_eq!(changed, 1);
            close(found[0], 0.251_117_160_261_027, 1e-12, "where it stays");
            close(found[1], 0.0, 0.0, "creeping");
            close(found[2], 2.0 * 9.81 * 20.0_f64.to_radians().sin(), 1e-12, "what holds");
        )* };
    }
    holds!(ImplicitTrapezoidal::<f64>::default(), GeneralisedAlpha::new(0.8), Ali3p::new(1e9));
}

/// In a closed loop joints stop at one time, and each time both find it.
#[test]
fn a_braked_four_bar_keeps_the_order_of_methods() {
    let changes = orders!(&read(FourBar::<f64>::SOURCE), 2.0, [2e-3, 1e-3], 1.8, 4e-4);
    assert!(changes > 10, "{changes} changes");
}

/// Brakes by reactions and beside them, with friction of another law within the iteration.
#[test]
fn a_braked_crank_keeps_the_order_of_methods() {
    let changes = orders!(&read(Braking::<f64>::SOURCE), 1.0, [1e-3, 5e-4], 1.6, 1e-4);
    assert!(changes > 5, "{changes} changes");
}

/// In space, and along several directions at once.
#[test]
fn brakes_in_space_keep_the_order_of_methods() {
    assert!(orders!(&read(BrakingInSpace::<f64>::SOURCE), 1.0, [2e-3, 1e-3], 1.8, 1e-4) > 1);
    assert!(orders!(&read(BrakingAllWays::<f64>::SOURCE), 0.3, [2e-3, 1e-3], 1.6, 1e-4) > 1);
}

/// A weight on a spring of 1e9 N/m on a block that its rail holds: what holds follows the spring's force in the iteration, which takes no longer.
#[test]
fn a_stiff_spring_presses_what_sticks() {
    let engine = read(
        "planar Stiff { gravity [m/s^2] = (0, -10);
            body block { mass [kg] = 1; inertia [kg*m^2] = 0.01; } particle weight { mass [kg] = 2; }
            joint rail: prismatic(ground(0, 0) [m], block.center, axis = (0, 1));
            joint guide: point_on_line(line(ground(0, 0) [m], ground(0, 1) [m]), weight.center);
            friction clamp: on(rail) = dry(force [N] = 100);
            spring strut: spring(block.center, weight.center, stiffness [N/m] = 1e9, length [m] = 0.5);
            start { rail.travel [m] = 0; weight.center.y [m] = 0.5; }
            output held [N] = clamp.force; output height [m] = weight.center.y; output travel [m] = rail.travel; }",
    );
    let (_, _, iterations) = after!(&engine, ImplicitTrapezoidal::<f64>::default(), 1e-3, 0.2);
    assert!(iterations <= 3, "trapezoidal: {iterations} iterations");
    let (found, changed, iterations) = after!(&engine, GeneralisedAlpha::new(0.5), 1e-3, 0.2);
    assert!(iterations <= 3 && changed == 0, "generalised-alpha: {iterations} iterations, {changed} changes");
    close(found[0], 30.0, 1e-5, "what holds");
    close(found[1], 0.5 - 20.0 / 1e9, 1e-12, "where the weight lies");
    close(found[2], 0.0, 1e-15, "where the block is");
}

/// The macro's code and the interpreter move to the same bits, and projections after steps go on.
#[test]
fn compiled_code_moves_alike() {
    let (model, engine) = (four_bar(0.03), read(FourBar::<f64>::SOURCE));
    let method = GeneralisedAlpha::new(0.8);
    let mut simulation = Simulation::new(&model, FourBar::START).integrator(method).step(2e-3);
    let mut other =
        Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).integrator(method).step(2e-3);
    let mut changed = 0;
    while simulation.time() < 1.0 {
        changed += simulation.advance().expect("it moves").gates_changed;
        other.advance().expect("it moves");
    }
    assert!(changed > 3, "{changed} changes");
    assert_eq!(simulation.state().q.as_slice(), other.state().q.as_slice());
    assert_eq!(simulation.state().gates.as_slice(), other.state().gates.as_slice());
    let projected = Projected::after(LagrangeIndex1);
    let (found, ..) = after!(&engine, projected, ImplicitTrapezoidal::<f64>::default(), 5e-4, 2.0);
    let (exact, ..) = after!(&engine, Rk4, 1e-4, 2.0);
    for (found, exact) in found.iter().zip(exact) {
        close(*found, exact, 1e-4 * (1.0 + exact.abs()), "an output");
    }
}

/// A pin so large that it presses harder by itself than it lets go; derivatives, which do not follow what sticks.
#[test]
fn errors_name_what_sticks() {
    let model = four_bar(5.0);
    let error = Simulation::new(&model, FourBar::START)
        .integrator(GeneralisedAlpha::new(0.8))
        .step(1e-3)
        .advance_until(1.0)
        .expect_err("it jams");
    assert!(matches!(error, SimulationError::Locked { friction: "drum", .. }), "{error:?}");
    let error = equilibrium(&model, 0.0, &FourBar::START.q, &Default::default());
    let error = error.expect_err("it may stand anywhere");
    assert_eq!(error, LinearisationError::Sticks { friction: "drum" });
    assert!(error.to_string().starts_with("`drum` sticks"), "{error}");
}
