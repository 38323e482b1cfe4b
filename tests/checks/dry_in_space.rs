//! Dry friction of rigid contacts in space: what slides goes against what resists it, in touches too, and what holds rolls, as closed forms say.

use linkwright::{AssembleExt, DormandPrince, LagrangeIndex1, Rk4, Simulation, Vector};
use linkwright_engine::Engine;

#[track_caller]
fn close(found: f64, expected: f64, within: f64, what: &str) {
    println!("{what}: {found:.15}, {:.1e} off (bound {within:.0e})", (found - expected).abs());
    assert!((found - expected).abs() <= within, "{what}: {found} in place of {expected}");
}

fn read(source: &str) -> Engine {
    Engine::read(source).unwrap_or_else(|found| panic!("{found}"))
}

/// A ball of 2 kg and 0.1 m above a floor, or on it.
fn ball(restitution: f64, grip: f64, start: &str) -> Engine {
    read(&format!(
        "spatial Ball {{ gravity [m/s^2] = (0, 0, -9.81);
            sphere ball {{ mass [kg] = 2; radius [m] = 0.1; }}
            surface floor: plane(ground(0, 0, 0) [m], axis = (0, 0, 1));
            contact touch: between(ball.surface, floor) = rigid(restitution = {restitution});
            friction rub: on(touch) = dry(static = {grip});
            state taken [J] = 0; rate taken = power(rub);
            start {{ ball.center.x [m] = 0; ball.center.y [m] = 0; {start} }}
            output x [m] = ball.center.x; output y [m] = ball.center.y;
            output vx [m/s] = ball.center.velocity.x; output vy [m/s] = ball.center.velocity.y;
            output sx [m/s] = touch.sliding.x; output sy [m/s] = touch.sliding.y;
            output energy [J] = kinetic_energy; output balance [J] = kinetic_energy - taken; output pressed [N] = rub.normal; }}"
    ))
}

/// A ball of a billiard that spins across its way slides with w along a parabola, for a = μ g w/|w| stays the same, and rolls straight on after
/// 2 |w|/(7 μ g), with v − 2/7 w.
#[test]
fn a_ball_slides_along_a_parabola_and_rolls_on() {
    let (grip, g, v, w) = (0.2, 9.81, 3.0, [3.0, 2.0_f64]);
    let engine = ball(
        0.0,
        grip,
        "ball.center.z [m] = 0.1; ball.center.velocity.x [m/s] = 3; ball.rate.x [rad/s] = 20;",
    );
    let speed = w[0].hypot(w[1]);
    let a = w.map(|w| -grip * g * w / speed);
    let rolls = 2.0 * speed / (7.0 * grip * g);
    for (step, within) in [(1e-3, 1e-9), (5e-3, 2e-7)] {
        let mut simulation =
            Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).integrator(Rk4).step(step);
        simulation.advance_until(0.3).expect("it slides");
        let outputs = simulation.sample().outputs.as_slice().to_vec();
        close(outputs[0], v * 0.3 + 0.5 * a[0] * 0.09, within, "x while it slides");
        close(outputs[1], 0.5 * a[1] * 0.09, within, "y while it slides");
        close(outputs[8], 2.0 * g, 1e-10, "what presses");
        simulation.advance_until(rolls - 1e-6).expect("it slides");
        let outputs = simulation.sample().outputs.as_slice().to_vec();
        assert!(outputs[4].hypot(outputs[5]) > 1e-7, "it rolls too early");
        simulation.advance_until(rolls + 1e-6).expect("it rolls");
        let mut changed = 0;
        while simulation.time() < 1.0 - 1e-9 {
            changed += simulation.advance().expect("it rolls").gates_changed;
        }
        let outputs = simulation.sample().outputs.as_slice().to_vec();
        let ends = simulation.time();
        let at = |axis: usize, v: f64| {
            v * rolls + 0.5 * a[axis] * rolls * rolls + (v + a[axis] * rolls) * (ends - rolls)
        };
        close(outputs[0], at(0, v), 10.0 * within, "x where it rolls");
        close(outputs[1], at(1, 0.0), 10.0 * within, "y where it rolls");
        close(outputs[2], v - 2.0 / 7.0 * w[0], within, "speed along x");
        close(outputs[3], -2.0 / 7.0 * w[1], within, "speed along y");
        close(outputs[4].hypot(outputs[5]), 0.0, 1e-12, "sliding where it rolls");
        assert!(changed <= 1, "{changed} changes where it rolls");
    }
}

/// A ball falls with spin: P_N = (1 + e) m v_z; along the floor it slips through the touch with μ P_N against the sliding, or sticks with 2/7 m w.
#[test]
fn a_spinning_ball_slips_or_sticks_in_a_touch() {
    let (mass, g, fall) = (2.0, 9.81, 0.5_f64);
    for (grip, bounces) in [(0.1, 0.6), (0.6, 0.6), (0.1, 0.0), (0.6, 0.0)] {
        let engine = ball(
            bounces,
            grip,
            "ball.center.z [m] = 0.6; ball.center.velocity.x [m/s] = 1.5; ball.rate.x [rad/s] = 20; ball.rate.y [rad/s] = 4;",
        );
        let mut simulation = Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).step(1e-3);
        let mut step = simulation.advance().expect("it falls");
        while step.impacts == 0 {
            step = simulation.advance().expect("it falls");
        }
        let down = (2.0 * g * fall).sqrt();
        let pressed = (1.0 + bounces) * mass * down;
        // Turning freely changes nothing in these; r ω is 2 along y and −0.4 along x.
        let w = [1.5 - 0.4, 2.0_f64];
        let (speed, stopped) = (w[0].hypot(w[1]), 2.0 / 7.0 * mass * w[0].hypot(w[1]));
        let along = stopped.min(grip * pressed);
        let after = [1.5 - along / mass * w[0] / speed, -along / mass * w[1] / speed];
        let left = speed - 3.5 * along / mass;
        let name = format!("friction {grip}, restitution {bounces}");
        let outputs = simulation.sample().outputs.as_slice().to_vec();
        if bounces > 0.0 {
            close(outputs[2], after[0], 1e-6, &format!("{name}: speed along x"));
            close(outputs[3], after[1], 1e-6, &format!("{name}: speed along y"));
        }
        // ½ P·(w⁺ + w⁻) of both.
        let lost = 0.5 * pressed * down * (1.0 - bounces) + 0.5 * along * (speed + left);
        close(step.lost, lost, 1e-6, &format!("{name}: lost"));
        assert_eq!(step.gained, 0.0);
    }
}

/// A block on four corners, thrown up a slope of 20 degrees along the way with this angle to the steepest one, with this spin.
fn brick(slope: f64, aside: f64, spin: f64) -> Engine {
    let corner = |name: &str, x: f64, y: f64| {
        format!("point {name} [m] = ({x}, {y}, -0.05); surface on_{name}: point(brick.{name});")
    };
    let corners = [("a", 0.1, 0.08), ("b", -0.1, 0.08), ("c", -0.1, -0.08), ("d", 0.1, -0.08)];
    let points: String = corners.iter().map(|(name, x, y)| corner(name, *x, *y)).collect();
    let contacts: String = corners
        .iter()
        .map(|(name, ..)| {
            format!(
                "contact stands_{name}: between(brick.on_{name}, floor) = rigid(restitution = 0);
                 friction rub_{name}: on(stands_{name}) = dry(static = 0.5);"
            )
        })
        .collect();
    let sum = |of: &str| ["a", "b", "c", "d"].map(|name| of.replace('?', name)).join(" + ");
    read(&format!(
        "spatial Brick {{ const slope [deg] = {slope}; const aside [deg] = {aside};
            gravity = (-9.81 [m/s^2]*sin(slope)*cos(aside), -9.81 [m/s^2]*sin(slope)*sin(aside), -9.81 [m/s^2]*cos(slope));
            body brick {{ mass [kg] = 2; inertia [kg*m^2] = (0.02, 0.03, 0.04); {points} }}
            surface floor: plane(ground(0, 0, 0) [m], axis = (0, 0, 1));
            {contacts}
            state taken [J] = 0; rate taken = {};
            start {{ brick.center.x [m] = 0; brick.center.y [m] = 0; brick.center.z [m] = 0.05; brick.center.velocity.x = 2 [m/s]*cos(aside);
                     brick.center.velocity.y = 2 [m/s]*sin(aside); brick.rate.z [rad/s] = {spin}; }}
            output up [m] = brick.center.x*cos(aside) + brick.center.y*sin(aside);
            output across [m] = brick.center.y*cos(aside) - brick.center.x*sin(aside);
            output speed [m/s] = brick.center.velocity.x*cos(aside) + brick.center.velocity.y*sin(aside);
            output turning [rad/s] = brick.rate.z;
            output pressed [N] = {};
            output balance [J] = kinetic_energy + potential_energy - taken; }}",
        sum("power(rub_?)"),
        sum("rub_?.normal"),
    ))
}

/// It stops where the block of the plane does and stays, and slides back where that does, whichever way the slope lies.
#[test]
fn a_brick_on_its_corners_stops_on_a_slope_or_slides_back() {
    for aside in [0.0, 77.0] {
        let engine = brick(20.0, aside, 0.0);
        let mut simulation = Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).step(1e-2);
        simulation.advance_until(0.5).expect("it rests");
        let outputs = simulation.sample().outputs.as_slice().to_vec();
        close(outputs[0], 0.251_117_160_261_027, 1e-10, &format!("{aside} degrees aside: where it stays"));
        close(outputs[1], 0.0, 1e-12, "across");
        close(outputs[2], 0.0, 1e-14, "creeping");
        close(outputs[4], 2.0 * 9.81 * 20.0_f64.to_radians().cos(), 1e-10, "what presses");
    }
    let engine = brick(30.0, 30.0, 0.0);
    let mut simulation = Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).step(1e-2);
    simulation.advance_until(1.0).expect("it moves");
    let outputs = simulation.sample().outputs.as_slice().to_vec();
    close(outputs[0], 0.017_843_517_838_295, 1e-8, "30 degrees: where it is after 1 s");
    close(outputs[2], -0.513_551_854_988_346, 1e-8, "and how fast");
}

/// What friction takes is what is missing, while it slides and turns at once; both end at one time, and it stands.
#[test]
fn a_brick_that_spins_comes_to_rest_at_once() {
    let engine = brick(0.0, 0.0, 6.0);
    let mut simulation = Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).step(1e-2);
    simulation.advance_until(0.3).expect("it slides");
    let outputs = simulation.sample().outputs.as_slice().to_vec();
    assert!(outputs[2] > 0.1 && outputs[3] > 0.1, "{outputs:?}");
    simulation.advance_until(0.8).expect("it stands");
    let outputs = simulation.sample().outputs.as_slice().to_vec();
    close(outputs[2], 0.0, 1e-13, "speed");
    close(outputs[3], 0.0, 1e-12, "turning");
    let begin = 0.5 * 2.0 * 4.0 + 0.5 * 0.04 * 36.0 + 2.0 * 9.81 * 0.05;
    close(outputs[5], begin, 1e-6, "energy and what friction took");
}

/// What is pulled across its way with γ of the friction a m that brakes it stands after w/(a (1 − γ²)), having gone 2 w²/(a (4 − γ²)) along and
/// w² γ/(4 a (1 − γ²)) down, as a rod in its sleeve does (`dry_along_several.rs`).
#[test]
fn what_slides_across_a_slope_turns_down() {
    let slope: f64 = 0.25_f64.atan();
    let engine = read(&format!(
        "spatial Across {{ const slope [rad] = {slope:?};
            gravity = (-9.81 [m/s^2]*sin(slope), 0 [m/s^2], -9.81 [m/s^2]*cos(slope));
            particle puck {{ mass [kg] = 3; surface foot: point(puck.center); }}
            surface floor: plane(ground(0, 0, 0) [m], axis = (0, 0, 1));
            contact lies: between(puck.foot, floor) = rigid(restitution = 0);
            friction rub: on(lies) = dry(static = 0.6, kinetic = 0.5);
            start {{ puck.center.x [m] = 0; puck.center.y [m] = 0; puck.center.z [m] = 0; puck.center.velocity.y [m/s] = 2; }}
            output down [m] = -puck.center.x; output along [m] = puck.center.y; }}"
    ));
    let (w, gamma, a) = (2.0, 0.5, 0.5 * 9.81 * slope.cos());
    for (step, within) in [(1e-2, 1e-5), (1e-3, 1e-8)] {
        let mut simulation = Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).step(step);
        let stands = w / (a * (1.0 - gamma * gamma));
        simulation.advance_until(stands - 1e-4).expect("it slides");
        assert!(simulation.state().v.max_abs() > 1e-5);
        simulation.advance_until(stands + 0.3).expect("it stands");
        assert_eq!(simulation.state().v.max_abs(), 0.0);
        let outputs = simulation.sample().outputs.as_slice().to_vec();
        close(outputs[1], 2.0 * w * w / (a * (4.0 - gamma * gamma)), within, "how far it went along");
        close(outputs[0], w * w * gamma / (4.0 * a * (1.0 - gamma * gamma)), within, "and down");
    }
}

/// A ball that rolls on a table which turns with Ω goes round in a circle with 2/7 Ω, wherever it is put: it is as if it were charged in a magnetic
/// field (Weltner, Am. J. Phys. 47 (1979) 984). Here the table is driven, and the ball begins at rest.
#[test]
fn a_ball_circles_on_a_table_that_turns() {
    let engine = read(
        "spatial Table { gravity [m/s^2] = (0, 0, -9.81);
            body table { mass [kg] = 5; inertia [kg*m^2] = (0.5, 0.5, 1); surface top: plane(table.center, axis = (0, 0, 1)); }
            sphere ball { mass [kg] = 0.2; radius [m] = 0.05; }
            joint axle: revolute(ground(0, 0, 0) [m], table.center, axis = (0, 0, 1));
            drive turns: axle.angle = 3 [rad/s]*time;
            contact rides: between(ball.surface, table.top) = rigid(restitution = 0);
            friction rub: on(rides) = dry(static = 0.8);
            start { ball.center.x [m] = 0.4; ball.center.y [m] = 0; ball.center.z [m] = 0.05; ball.center.velocity.y [m/s] = 0.6; ball.rate.x [rad/s] = 12; ball.rate.y [rad/s] = 0; }
            output x [m] = ball.center.x; output y [m] = ball.center.y;
            output sliding [m/s] = sqrt(rides.sliding.x*rides.sliding.x + rides.sliding.y*rides.sliding.y); }",
    );
    // v̇ = 2/7 Ω × v: with v = (0, 0.6) at (0.4, 0) the middle is 0.7 m to the left of it.
    let (turn, radius) = (2.0 / 7.0 * 3.0, 0.6 / (2.0 / 7.0 * 3.0));
    let at = |time: f64| [0.4 - radius + radius * (turn * time).cos(), radius * (turn * time).sin()];
    let mut simulations = [1e-2, 5e-3].map(|step| {
        let simulation = Simulation::new(&engine, engine.start()).constant(engine.no_inputs());
        simulation.integrator(Rk4).step(step)
    });
    for (simulation, within) in simulations.iter_mut().zip([1e-4, 6e-6]) {
        for time in [1.0, 4.0] {
            simulation.advance_until(time).expect("it rolls");
            let outputs = simulation.sample().outputs.as_slice().to_vec();
            for (found, expected) in outputs.iter().zip(at(time)) {
                close(*found, expected, within, &format!("{time} s"));
            }
            close(outputs[2], 0.0, 1e-9, "sliding");
        }
    }
}

/// A thin disk rolls steadily round: its middle on a circle of radius b, leaning inwards by θ. With A = m r²/4 about a diameter and C = 2 A about
/// the axis, n = (cos θ, 0, sin θ) along the radius, along the way and up, it turns with ω = Ω ẑ + s n, and
///
/// ```text
/// Ω (b + r sin θ) + s r = 0                                                    at the foot
/// Ω (C (s + Ω sin θ) cos θ − A Ω cos θ sin θ) = r (m Ω² b cos θ − m g sin θ)     moments about the middle, L̇ = Ω ẑ × L
/// ```
#[test]
fn a_disk_rolls_round_in_a_circle() {
    let (mass, r, lean, b, g) = (1.5, 0.2, 0.3_f64, 0.8, 9.81);
    let (across, axial) = (mass * r * r / 4.0, mass * r * r / 2.0);
    let (sine, cosine) = lean.sin_cos();
    // All but the weight goes with Ω².
    let spin = -(b + r * sine) / r;
    let share = axial * (spin + sine) * cosine - across * cosine * sine - r * mass * b * cosine;
    let turn = (-r * mass * g * sine / share).sqrt();
    let spin = spin * turn;
    let tensor = |i: usize, j: usize| {
        let n = [cosine, 0.0, sine];
        (axial - across) * n[i] * n[j] + if i == j { across } else { 0.0 }
    };
    let engine = read(&format!(
        "spatial Rolling {{ gravity [m/s^2] = (0, 0, -9.81);
            body disk {{ mass [kg] = {mass}; inertia [kg*m^2] = ({:?}, {:?}, {:?}); products [kg*m^2] = ({:?}, {:?}, {:?});
                         surface rim: disk_rim(disk.center, axis = ({cosine:?}, 0, {sine:?}), radius [m] = {r}); }}
            surface floor: plane(ground(0, 0, 0) [m], axis = (0, 0, 1));
            contact rolls: between(disk.rim, floor) = rigid(restitution = 0);
            friction rub: on(rolls) = dry(static = 0.9);
            start {{ disk.center.x [m] = {b}; disk.center.y [m] = 0; disk.center.z [m] = {:?};
                     disk.center.velocity.y [m/s] = {:?}; disk.rate.x [rad/s] = {:?}; disk.rate.y [rad/s] = 0; disk.rate.z [rad/s] = {:?}; }}
            output x [m] = disk.center.x; output y [m] = disk.center.y; output z [m] = disk.center.z;
            output energy [J] = kinetic_energy + potential_energy; }}",
        tensor(0, 0),
        tensor(1, 1),
        tensor(2, 2),
        tensor(0, 1),
        tensor(0, 2),
        tensor(1, 2),
        r * cosine,
        turn * b,
        spin * cosine,
        turn + spin * sine,
    ));
    let mut simulation =
        Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).integrator(Rk4).step(2e-3);
    let begin = simulation.sample().outputs.as_slice()[3];
    for time in [0.5, 1.0] {
        simulation.advance_until(time).expect("it rolls");
        let outputs = simulation.sample().outputs.as_slice().to_vec();
        close(outputs[0], b * (turn * time).cos(), 1e-6, "x");
        close(outputs[1], b * (turn * time).sin(), 1e-6, "y");
        close(outputs[2], r * cosine, 1e-7, "height");
        close(outputs[3], begin, 1e-7, "energy");
    }
}

/// Parameters may say anything.
#[test]
fn coefficients_below_zero_are_named() {
    let engine = read(
        "planar Puck { param grip [1] = 0.2; gravity [m/s^2] = (0, -9.81); particle puck { mass [kg] = 1; surface foot: point(puck.center); }
            surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
            contact lies: between(puck.foot, floor) = rigid(restitution = 0); friction rub: on(lies) = dry(static = grip);
            start { puck.center.x [m] = 0; puck.center.y [m] = 0.1; } }",
    );
    let model = engine.prepared(&[-0.2]).expect("a number");
    let error =
        Simulation::new(&model, model.start()).constant(model.no_inputs()).step(1e-2).advance_until(1.0);
    let text = error.expect_err("it lands").to_string();
    assert!(text.contains("rub") && text.contains("a coefficient of friction of at least 0"), "{text}");
}

/// Formulations and methods agree, on a body in tree and in absolute coordinates.
#[test]
fn methods_agree() {
    let engine = ball(
        0.5,
        0.3,
        "ball.center.z [m] = 0.2; ball.center.velocity.x [m/s] = 1; ball.rate.x [rad/s] = 12;",
    );
    let run = || Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).step(1e-3);
    let first = run().run_until(1.0, |_| {}).expect("it moves");
    let mut adaptive = run().integrator(DormandPrince::tolerance(1e-10));
    adaptive.advance_until(1.0).expect("it moves");
    let others =
        [adaptive.state(), &run().formulation(LagrangeIndex1).run_until(1.0, |_| {}).expect("it moves")]
            .map(Clone::clone);
    for other in others {
        for (a, b) in first.q.as_slice().iter().zip(other.q.as_slice()) {
            close(*b, *a, 1e-6, "a coordinate");
        }
    }
}
