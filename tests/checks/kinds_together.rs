//! Memories and events beside rigid contacts and beside dry friction that sticks in joints, and contacts that yield beside rigid ones: against
//! closed forms, by several methods, compiled and interpreted.

use linkwright::{
    AssembleExt, DormandPrince, ExplicitTrapezoidal, LagrangeIndex1, Mechanism, NullSpace, Projected,
    SemiImplicitEuler, Simulation, SimulationError, Vector,
};
use linkwright_engine::{Engine, Numbers};
use mechanisms::zoo_memories::{
    RememberingBrakes, RememberingBrakesInputs, RememberingImpacts, RememberingImpactsInputs,
};

fn read(source: &str) -> Engine {
    Engine::read(source).unwrap_or_else(|errors| panic!("{errors}"))
}

/// A block on a rail with these statements; x its way, v its speed.
fn block(axis: &str, statements: &str, x: f64, v: f64) -> Engine {
    read(&format!(
        "planar Block {{ gravity [m/s^2] = (0, -9.81);
         body block {{ mass [kg] = 2; inertia [kg*m^2] = 0.01; }}
         joint rail: prismatic(ground(0, 0) [m], block.origin, axis = {axis});
         output way [m] = rail.travel; output speed [m/s] = rail.speed;
         {statements}
         start {{ rail.travel [m] = {x}; rail.speed [m/s] = {v}; }} }}"
    ))
}

/// Outputs after a run of steps of this size to a time.
fn after(engine: &Engine, step: f64, end: f64) -> Vec<f64> {
    let mut simulation = Simulation::new(engine, engine.start()).constant(engine.no_inputs()).step(step);
    simulation.advance_until(end).expect("it moves");
    simulation.sample().outputs.as_slice().to_vec()
}

#[track_caller]
fn close(found: f64, wanted: f64, bound: f64, what: &str) {
    assert!((found - wanted).abs() <= bound, "{what}: {found} for {wanted}");
}

/// Of a ball that was let go at 1 m: touches, the speed after the last and the height of the last apex, by closed form.
fn bounces(end: f64) -> [f64; 3] {
    let (g, share) = (9.81_f64, 0.8);
    let (mut speed, mut touch) = ((2.0 * g).sqrt(), (2.0 / g).sqrt());
    let [mut count, mut parted, mut apex] = [0.0; 3];
    while touch < end {
        speed *= share;
        (count, parted) = (count + 1.0, speed);
        if touch + speed / g < end {
            apex = speed * speed / (2.0 * g);
        }
        touch += 2.0 * speed / g;
    }
    [count, parted, apex]
}

/// A touch lets an event occur whose speed passes its level in the impulse, and memories see the speeds behind it.
#[test]
fn touches_are_counted() {
    let engine = block(
        "(0, 1)",
        "limit floor: rail.travel [m] in 0..10 = rigid(restitution = 0.8);
         memory touches = 0; memory parted [m/s] = 0; memory apex [m] = 0;
         event touch: rail.speed rises 0 { touches = touches + 1; parted = rail.speed; }
         event top: rail.speed falls 0 { apex = rail.travel; }
         output count = touches; output fast [m/s] = parted; output high [m] = apex;",
        1.0,
        0.0,
    );
    for (step, end) in [(0.01, 1.0), (0.01, 2.2), (0.3, 2.2), (0.0037, 3.0)] {
        let found = after(&engine, step, end);
        for (found, wanted) in found[2..].iter().zip(bounces(end)) {
            close(*found, wanted, 1e-9, &format!("in steps of {step} s until {end} s"));
        }
    }
    let mut simulation = Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).step(0.5);
    let step = simulation.advance().expect("it moves");
    assert_eq!((step.impacts, step.events), (1, 1));
}

/// What lies is pressed by what a memory says from the time of its event on, leaves when its speed jumps, and bounces when that is downwards.
#[test]
fn what_lies_is_pressed_and_thrown() {
    let engine = block(
        "(0, 1)",
        "limit floor: rail.travel [m] in 0..10 = rigid(restitution = 0.5);
         memory push [N] = 0; force down: along(rail.travel) = -push;
         event press: time rises 0.2 [s] { push = 30 [N]; }
         event release: time rises 0.4 [s] { push = 0; }
         event thrown: time rises 0.5 [s] { jump(rail.speed) = 2 [m/s]; }
         event struck: time rises 2 [s] { jump(rail.speed) = -1 [m/s]; }
         output force [N] = floor.force;",
        0.0,
        0.0,
    );
    let (g, weight) = (9.81, 2.0 * 9.81);
    for step in [0.01, 0.07] {
        for (time, force) in [(0.1, weight), (0.3, weight + 30.0), (0.45, weight), (1.9, weight)] {
            let found = after(&engine, step, time);
            close(found[2], force, 1e-9, "force");
            close(found[0].abs() + found[1].abs(), 0.0, 1e-12, "it lies");
        }
        for (time, thrown, speed) in [(0.6, 0.5, 2.0), (0.9, 0.5, 2.0), (2.05, 2.0, 0.5)] {
            let (found, t) = (after(&engine, step, time), time - thrown);
            close(found[0], speed * t - 0.5 * g * t * t, 1e-10, "way of what was thrown");
            close(found[1], speed - g * t, 1e-10, "speed of what was thrown");
            close(found[2], 0.0, 0.0, "force in flight");
        }
    }
}

/// A block that sticks is pushed by what a memory says: it goes by (F − μ m g)/m, stands v²/(2 μ g) after it was let go, and goes that far when thrown.
#[test]
fn what_sticks_is_pushed_and_thrown() {
    let engine = block(
        "(1, 0)",
        "friction rub: on(rail) = dry(static = 0.5, kinetic = 0.4);
         memory push [N] = 5; force along_it: along(rail.travel) = push;
         event stronger: time rises 0.2 [s] { push = 12 [N]; }
         event off: rail.travel rises 0.1 [m] { push = 0; }
         event thrown: time rises 2 [s] { jump(rail.speed) = -1 [m/s]; }
         output force [N] = rub.force;",
        0.0,
        0.0,
    );
    let (slows, gains) = (0.4 * 9.81, 6.0 - 0.4 * 9.81);
    let (let_go, stands) = ((0.2_f64 / gains).sqrt() + 0.2, 0.1 + 0.2 * gains / (2.0 * slows));
    for step in [0.01, 0.053] {
        let found = after(&engine, step, 0.15);
        close(found[0], 0.0, 0.0, "it sticks");
        close(found[2], -5.0, 1e-9, "what holds it");
        let found = after(&engine, step, let_go - 0.01);
        close(found[0], 0.5 * gains * (let_go - 0.21) * (let_go - 0.21), 1e-9, "pushed");
        let found = after(&engine, step, 1.9);
        close(found[0], stands, 1e-9, "it stands");
        close(found[1].abs() + found[2].abs(), 0.0, 1e-9, "nothing asks for friction");
        let found = after(&engine, step, 2.1);
        close(found[0], stands - 0.1 + 0.5 * slows * 0.01, 1e-9, "thrown");
        close(found[2], 2.0 * slows, 1e-9, "what brakes it");
        close(after(&engine, step, 3.0)[0], stands - 1.0 / (2.0 * slows), 1e-9, "it stands again");
    }
}

/// Ticks come at their times while friction sticks and while contacts rest, however long the steps are, and count for no changes of either.
#[test]
fn ticks_come_beside_what_rests() {
    for statements in [
        "friction rub: on(rail) = dry(static = 0.5, kinetic = 0.4);",
        "limit wall: rail.travel [m] in 0..1 = rigid(restitution = 0);",
    ] {
        let engine = block(
            "(1, 0)",
            &format!(
                "{statements} memory ticks = 0; event tick: every 1 [ms] {{ ticks = ticks + 1; }} output count = ticks;"
            ),
            0.0,
            0.0,
        );
        let mut simulation = Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).step(0.02);
        let step = simulation.advance().expect("it rests");
        assert_eq!((step.events, step.gates_changed), (21, 0), "{statements}");
        assert_eq!(simulation.sample().outputs.as_slice()[2], 21.0, "{statements}");
    }
}

/// An event that its own memories let occur again and again is an error by name, here too.
#[test]
fn events_without_end_are_named() {
    let engine = block(
        "(1, 0)",
        "friction rub: on(rail) = dry(static = 0.5, kinetic = 0.4); memory n = 0;
         event up: time - 2 [s]*n crosses 0.1 [s] { n = 1 - n; } output count = n;",
        0.0,
        0.0,
    );
    let mut simulation = Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).step(0.01);
    let error = simulation.advance_until(1.0).expect_err("it never ends");
    assert!(matches!(error, SimulationError::EventWithoutEnd { event: "up", .. }), "{error}");
}

/// Between a rigid wall and a buffer without damping: there and back takes 2 l/v + π √(m/k); the buffer's gates are live, so that its force begins
/// within a step.
#[test]
fn what_yields_stands_beside_what_is_rigid() {
    let engine = block(
        "(1, 0)",
        "limit wall: rail.travel [m] in 0..5 = rigid(restitution = 1);
         limit buffer: rail.travel [m] in -1..1 = kelvin_voigt(stiffness [N/m] = 200);
         output force [N] = buffer.force;",
        0.0,
        1.0,
    );
    let period = 2.0 + core::f64::consts::PI / 10.0;
    let turning = after(&engine, 1e-4, 1.0 + 0.25 * (period - 2.0) * 2.0);
    close(turning[0], 1.1, 1e-6, "deepest");
    close(turning[2].abs(), 20.0, 1e-4, "force");
    for time in [period + 0.3, 2.0 * period + 0.3] {
        let found = after(&engine, 1e-4, time);
        close(found[0], 0.3, 1e-6, "way");
        close(found[1], 1.0, 1e-6, "speed");
    }
}

/// A disk slides on a floor that yields, whose friction of another law is pressed by a force, into a rigid wall: v = v₀ − μ g t before, half of that
/// back, and slower by μ g t again, for it spins on.
#[test]
fn friction_at_what_yields_stands_beside_what_is_rigid() {
    let engine = read(
        "planar Slides { gravity [m/s^2] = (0, -9.81);
         disk puck { mass [kg] = 1; radius [m] = 0.1; }
         surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
         surface wall: half_plane(line(ground(0.4, 0) [m], ground(0.4, 1) [m]));
         #[allow(penetration)]
         contact soft: between(puck.surface, floor) = kelvin_voigt(stiffness [N/m] = 1e4, damping [N*s/m] = 20);
         contact hard: between(puck.surface, wall) = rigid(restitution = 0.5);
         friction rub: on(soft) = coulomb(coefficient = 0.3, speed [m/s] = 1e-3);
         start { puck.center.x [m] = 0; puck.center.y [m] = 0.1 - 9.81e-4; puck.angle [rad] = 0;
                 puck.center.velocity.x [m/s] = 2; puck.center.velocity.y [m/s] = 0; puck.rate [rad/s] = 0; }
         output speed [m/s] = puck.center.velocity.x; }",
    );
    let slows = 0.3 * 9.81;
    let touch = (2.0 - (4.0 - 2.0 * slows * 0.3_f64).sqrt()) / slows;
    close(after(&engine, 1e-3, 0.15)[0], 2.0 - slows * 0.15, 1e-5, "before");
    let back = 0.5 * (2.0 - slows * touch) - slows * (0.2 - touch);
    close(after(&engine, 1e-3, 0.2)[0], -back, 1e-5, "behind");
}

/// Compiled and interpreted mechanisms have the same bits; formulations and methods that are exact or of high order agree.
#[test]
fn all_ways_agree() {
    macro_rules! alike {
        ($model:ident, $inputs:expr, $given:expr, $end:expr, $bound:expr) => {{
            let (model, engine) = ($model::default(), read($model::<f64>::SOURCE));
            let run = || Simulation::new(&model, model.start()).constant($inputs).step(2e-3);
            let (mut one, mut events, mut changed) = (run(), 0, 0);
            let mut other =
                Simulation::new(&engine, engine.start()).constant(Numbers::of(&[$given])).step(2e-3);
            while one.time() < $end {
                let (step, alike) = (one.advance().expect("it moves"), other.advance().expect("it moves"));
                assert_eq!((step.events, step.gates_changed), (alike.events, alike.gates_changed));
                (events, changed) = (events + step.events, changed + step.gates_changed + step.impacts);
            }
            let bits = |numbers: &[f64]| numbers.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
            assert_eq!(bits(one.state().q.as_slice()), bits(other.state().q.as_slice()));
            assert_eq!(bits(one.state().gates.as_slice()), bits(other.state().gates.as_slice()));
            println!("{}: {events} events, {changed} changes", model.name());
            assert!(events > 20 && changed > 2, "{events} events, {changed} changes");
            let end = one.time();
            let check = |q: &[f64], bound: f64, what: &str| {
                for (found, wanted) in q.iter().zip(one.state().q.as_slice()) {
                    close(*found, *wanted, bound, &format!("{} by {what}", model.name()));
                }
            };
            macro_rules! under {
                ($formulation:expr) => {{
                    let mut simulation = run().formulation($formulation);
                    simulation.advance_until(end).expect("it moves");
                    check(simulation.state().q.as_slice(), $bound, stringify!($formulation));
                }};
            }
            under!(LagrangeIndex1);
            under!(NullSpace);
            under!(Projected::after(LagrangeIndex1));
            macro_rules! by {
                ($integrator:expr, $bounded:expr) => {{
                    let mut simulation = run().integrator($integrator);
                    simulation.advance_until(end).expect("it moves");
                    check(simulation.state().q.as_slice(), $bounded, stringify!($integrator));
                }};
            }
            by!(DormandPrince::tolerance(1e-9), $bound);
            by!(ExplicitTrapezoidal, 30.0 * $bound);
            by!(SemiImplicitEuler, 5e-2);
        }};
    }
    let (wind, push) = (0.1, 1.0);
    alike!(RememberingImpacts, RememberingImpactsInputs { wind }, wind, 1.5, 1e-5);
    alike!(RememberingBrakes, RememberingBrakesInputs { push }, push, 1.0, 1e-5);
    let model = RememberingImpacts::<f64>::default();
    assert!(model.is_rigid() && !model.sticks() && model.memory_names().len() == 3);
}
