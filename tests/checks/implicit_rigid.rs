//! Rigid contacts under methods that iterate on residuals: the same motions as by explicit methods, their order, and what is stiff.

use linkwright::{
    Ali3p, AssembleExt, GeneralisedAlpha, ImplicitTrapezoidal, LagrangeIndex1, Linearisation,
    LinearisationError, Projected, Rk4, Simulation, Vector,
};
use linkwright_engine::{Derivatives, Engine};

linkwright::mechanism! {
    /// A slider-crank between two stops, of which one slides and rubs.
    planar Crank {
        gravity [m/s^2] = (0, -9.81);
        rod crank { mass [kg] = 1; length [m] = 0.2; }
        rod coupler { mass [kg] = 1; length [m] = 0.4; surface tip: point(coupler.end); }
        joint hinge: revolute(ground(0, 0) [m], crank.start);
        joint pin: revolute(crank.end, coupler.start);
        surface floor: half_plane(line(ground(0, -0.1) [m], ground(1, -0.1) [m]));
        contact lands: between(coupler.tip, floor) = rigid(restitution = 0.3);
        friction rub: on(lands) = dry(static = 0.4, kinetic = 0.3);
        limit stop: hinge.angle [deg] in -170..100 = rigid(restitution = 0.5);
        start { hinge.angle [deg] = 60; pin.angle [deg] = -40; }
        options { emit = (tangent); self_check = on; }
        output x [m] = coupler.end.x;
        output y [m] = coupler.end.y;
        output vx [m/s] = coupler.end.velocity.x;
    }
}

#[track_caller]
fn close(found: f64, expected: f64, within: f64, what: &str) {
    println!("{what}: {found:.15}, {:.1e} off (bound {within:.0e})", (found - expected).abs());
    assert!((found - expected).abs() <= within, "{what}: {found} in place of {expected}");
}

fn read(source: &str) -> Engine<Derivatives> {
    Engine::<Derivatives>::read_with_derivatives(source).unwrap_or_else(|found| panic!("{found}"))
}

/// The outputs after a time by a method, and how often something touched and how many iterations a step took at most.
macro_rules! after {
    ($engine:expr, $method:expr, $step:expr, $time:expr) => {{
        let engine = $engine;
        let mut simulation = Simulation::new(engine, engine.start())
            .formulation(LagrangeIndex1)
            .constant(engine.no_inputs())
            .integrator($method)
            .step($step);
        let (mut impacts, mut iterations) = (0, 0);
        while simulation.time() < $time - 1e-9 {
            let step = simulation.advance().unwrap_or_else(|error| panic!("{error}"));
            impacts += step.impacts;
            iterations = iterations.max(step.iterations);
        }
        (simulation.sample().outputs.as_slice().to_vec(), impacts, iterations)
    }};
}

fn crank() -> Engine<Derivatives> {
    read(Crank::<f64>::SOURCE)
}

/// Halving the step makes the error a quarter.
#[test]
fn implicit_methods_keep_their_order() {
    let engine = crank();
    let (exact, impacts, _) = after!(&engine, Rk4, 1e-4, 0.5);
    assert!(impacts >= 2, "{impacts} impacts");
    macro_rules! order {
        ($($name:literal: $method:expr;)*) => { $(
            let errors = [1e-3, 5e-4].map(|step| {
                let (found, count, _) = after!(&engine, $method, step, 0.5);
                assert_eq!(count, impacts, "{}", $name);
                found.iter().zip(&exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
            });
            let order = (errors[0] / errors[1]).log2();
            println!("{}: {errors:?}, order {order:.2}", $name);
            assert!(errors[0] < 2e-3 && order > 1.6, "{}: {errors:?}, order {order}", $name);
        )* };
    }
    order! {
        "implicit trapezoidal": ImplicitTrapezoidal::<f64>::default();
        "generalised-alpha": GeneralisedAlpha::new(0.8);
        "ALI3-P": Ali3p::new(1e9);
    }
}

/// A block on a slope stops where it must, and is held there.
#[test]
fn dry_friction_holds_under_implicit_methods() {
    let engine = read(
        "planar Block { const slope [deg] = 20; gravity = (-9.81 [m/s^2]*sin(slope), -9.81 [m/s^2]*cos(slope));
            body block { mass [kg] = 2; inertia [kg*m^2] = 0.01; point a [m] = (-0.1, -0.05); point b [m] = (0.1, -0.05);
                         surface left: point(block.a); surface right: point(block.b); }
            surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
            contact one: between(block.left, floor) = rigid(restitution = 0); contact other: between(block.right, floor) = rigid(restitution = 0);
            friction rub: on(one) = dry(static = 0.5); friction grip: on(other) = dry(static = 0.5);
            start { block.center.x [m] = 0; block.center.y [m] = 0.05; block.angle [rad] = 0; block.center.velocity.x [m/s] = 2; }
            output x [m] = block.center.x; output v [m/s] = block.center.velocity.x; output pressed [N] = rub.normal + grip.normal; }",
    );
    macro_rules! holds {
        ($($method:expr),*) => { $(
            let (found, ..) = after!(&engine, $method, 1e-2, 1.0);
            close(found[0], 0.251_117_160_261_027, 1e-9, "where it stays");
            close(found[1], 0.0, 1e-12, "creeping");
            close(found[2], 2.0 * 9.81 * 20.0_f64.to_radians().cos(), 1e-8, "what presses");
        )* };
    }
    holds!(ImplicitTrapezoidal::<f64>::default(), GeneralisedAlpha::new(0.8), Ali3p::new(1e9));
}

/// A ball that slides along a parabola in space and rolls on, as by explicit methods.
#[test]
fn a_ball_rolls_under_implicit_methods() {
    let engine = read(
        "spatial Ball { gravity [m/s^2] = (0, 0, -9.81); sphere ball { mass [kg] = 2; radius [m] = 0.1; }
            surface floor: plane(ground(0, 0, 0) [m], axis = (0, 0, 1));
            contact touch: between(ball.surface, floor) = rigid(restitution = 0); friction rub: on(touch) = dry(static = 0.2);
            start { ball.center.x [m] = 0; ball.center.y [m] = 0; ball.center.z [m] = 0.1; ball.center.velocity.x [m/s] = 3; ball.rate.x [rad/s] = 20; }
            output vx [m/s] = ball.center.velocity.x; output vy [m/s] = ball.center.velocity.y; }",
    );
    let (found, ..) = after!(&engine, ImplicitTrapezoidal::<f64>::default(), 1e-3, 0.7);
    close(found[0], 15.0 / 7.0, 1e-4, "speed along x");
    close(found[1], -4.0 / 7.0, 1e-4, "speed along y");
}

/// What a stiff spring presses: a weight on a spring of 1e9 N/m on a block that lies on the floor, in steps of 22 radians of its swing. The force of
/// the contact follows the spring's in the iteration, so that it ends as soon as without the contact; its swing is damped by the method alone.
#[test]
fn a_stiff_spring_presses_what_lies() {
    let engine = read(
        "planar Stiff { gravity [m/s^2] = (0, -10);
                particle block { mass [kg] = 1; surface foot: point(block.center); } particle weight { mass [kg] = 2; }
                joint guide: point_on_line(line(ground(0, 0) [m], ground(0, 1) [m]), weight.center);
                joint rail: point_on_line(line(ground(0, 0) [m], ground(0, 1) [m]), block.center);
                surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
                contact lies: between(block.foot, floor) = rigid(restitution = 0);
                spring strut: spring(block.center, weight.center, stiffness [N/m] = 1e9, length [m] = 0.5);
                start { weight.center.y [m] = 0.5; block.center.y [m] = 0; }
                output pressed [N] = lies.force; output travel [m] = weight.center.y; }",
    );
    let (_, _, iterations) = after!(&engine, ImplicitTrapezoidal::<f64>::default(), 1e-3, 0.2);
    assert!(iterations <= 3, "trapezoidal: {iterations} iterations");
    let (found, _, iterations) = after!(&engine, GeneralisedAlpha::new(0.5), 1e-3, 0.2);
    close(found[0], 30.0, 1e-5, "what presses");
    close(found[1], 0.5 - 20.0 / 1e9, 1e-12, "where the weight lies");
    assert!(iterations <= 3, "generalised-alpha: {iterations} iterations");
}

/// Projections after steps go on.
#[test]
fn projected_steps_touch_too() {
    let engine = crank();
    let mut simulation = Simulation::new(&engine, engine.start())
        .formulation(Projected::after(LagrangeIndex1))
        .constant(engine.no_inputs())
        .integrator(ImplicitTrapezoidal::<f64>::default())
        .step(5e-4);
    simulation.advance_until(0.5).expect("it moves");
    let (exact, ..) = after!(&engine, Rk4, 1e-4, 0.5);
    for (found, exact) in simulation.sample().outputs.as_slice().iter().zip(exact) {
        close(*found, exact, 1e-3, "an output");
    }
}

/// The macro's code and the interpreter move to the same bits; derivatives, which do not follow what touches, say so.
#[test]
fn compiled_code_moves_alike() {
    let (model, engine) = (Crank::default(), crank());
    let method = GeneralisedAlpha::new(0.8);
    let mut simulation = Simulation::new(&model, Crank::START).integrator(method).step(1e-3);
    let mut other =
        Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).integrator(method).step(1e-3);
    let mut impacts = 0;
    while simulation.time() < 0.5 {
        impacts += simulation.advance().expect("it moves").impacts;
        other.advance().expect("it moves");
    }
    assert!(impacts >= 2, "{impacts} impacts");
    assert_eq!(simulation.state().q.as_slice(), other.state().q.as_slice());
    assert_eq!(simulation.state().v.as_slice(), other.state().v.as_slice());
    let error = Linearisation::at(&model, 0.0, &Crank::START, &Default::default()).map(|_| ());
    let error = error.expect_err("it may touch");
    assert!(matches!(error, LinearisationError::Rigid { contact: "lands" }), "{error:?}");
    assert!(error.to_string().starts_with("`lands` is rigid"), "{error}");
}
