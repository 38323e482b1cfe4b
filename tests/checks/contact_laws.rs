//! What contacts may be told beyond stiffness and losses, against closed forms: that they adhere, that they are lines, the speed of each touch; bars that
//! meet in space, and friction between shafts that keep their speed.

use linkwright::{AssembleExt, DormandPrince, Rk4, Simulation};
use linkwright_engine::Engine;
use std::f64::consts::PI;

#[track_caller]
fn close(found: f64, expected: f64, within: f64, what: &str) {
    println!("{what}: {found:.15}, {:.1e} off (bound {within:.0e})", (found - expected).abs());
    assert!((found - expected).abs() <= within, "{what}: {found} in place of {expected}");
}

fn read(source: &str) -> Engine {
    Engine::read(source).unwrap_or_else(|found| panic!("{found}"))
}

/// The outputs after a time, in steps.
fn after(engine: &Engine, time: f64, step: f64) -> Vec<f64> {
    let mut simulation =
        Simulation::new(engine, engine.start()).constant(engine.no_inputs()).integrator(Rk4).step(step);
    simulation.advance_until(time).expect("it moves");
    simulation.sample().outputs.as_slice().to_vec()
}

/// m = 1, k = 1e4: what adheres comes back with exp(−ζπ/√(1 − ζ²)), as a damped oscillator after half a turn; what does not with more, since it parts where the
/// force would pull (Goldsmith, Impact, 1960). Without losses there is nothing to pull at.
#[test]
fn what_adheres_pulls_until_its_gap_opens() {
    let cases = [
        (0.1, 0.729_247_614_287_671, 0.744_079_397_721_78),
        (0.3, 0.372_326_104_926_586, 0.450_975_452_893_128),
        (0.7, 0.045_987_910_260_267_8, 0.210_284_564_378_478),
    ];
    for (zeta, pulls, pushes) in cases {
        let ball = |adhesion: &str, gates: &str| {
            read(&format!(
                "planar Ball {{ particle ball {{ mass [kg] = 1; }} surface own: point(ball.center);
                    surface wall: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
                    contact touch: between(own, wall) = kelvin_voigt(stiffness [N/m] = 1e4, damping [N*s/m] = {}{adhesion});
                    start {{ ball.center.x [m] = 0; ball.center.y [m] = 0.01; ball.center.velocity.y [m/s] = -1; }} {gates}
                    output v [m/s] = ball.center.velocity.y; output force [N] = touch.force; }}",
                200.0 * zeta
            ))
        };
        let held = "options { contact = held; }";
        close(after(&ball(", adhesion = on", held), 0.06, 1e-5)[0], pulls, 1e-9, "adhering, held gates");
        close(after(&ball(", adhesion = on", ""), 0.06, 1e-5)[0], pulls, 1e-3, "adhering, live gates");
        close(after(&ball("", held), 0.06, 1e-5)[0], pushes, 1e-9, "pushing, held gates");
        // Near the end of half a turn it pulls.
        let turn = PI / (100.0 * (1.0_f64 - zeta * zeta).sqrt());
        let force = after(&ball(", adhesion = on", held), 0.01 + 0.97 * turn, 1e-5)[1];
        assert!(force < -1.0, "{force} N");
    }
}

/// The force of a line contact is that of d = F/(π E l)(ln(4 π E l ΔR/F) − 1), of circles beside each other with ΔR = R₁ + R₂ and within each other with the
/// clearance (Johnson, Contact Mechanics, 1985, 5.6); without losses it gives back what it took.
#[test]
fn a_line_contact_is_as_stiff_as_its_closed_form() {
    let modulus = 1.0 / (0.91 / 207e9 + 0.84 / 70e9);
    for (surface, radii, x, v) in [("circle", 0.0195, 0.0196, -2.0), ("hole", 0.0005, 0.0004, 0.5)] {
        let roll = read(&format!(
            "planar Roll {{ material steel {{ modulus [Pa] = 207e9; poisson = 0.3; }} material alloy {{ modulus [Pa] = 70e9; poisson = 0.4; }}
                body roll {{ mass [kg] = 1; inertia [kg*m^2] = 0.001; }} surface own: circle(roll.center, radius [mm] = 9.5);
                surface other: {surface}(ground(0, 0) [m], radius [mm] = 10);
                contact touch: between(own, other) = hertz_line(first = steel, second = alloy, length [mm] = 20, dissipation [s/m] = 0);
                start {{ roll.center.x [m] = {x}; roll.center.y [m] = 0; roll.angle [rad] = 0; roll.center.velocity.x [m/s] = {v}; }}
                output depth [m] = touch.depth; output force [N] = touch.force; output v [m/s] = roll.center.velocity.x; }}"
        ));
        let stiffness = PI * modulus * 0.02;
        let mut simulation = Simulation::new(&roll, roll.start())
            .constant(roll.no_inputs())
            .integrator(DormandPrince::tolerance(1e-12))
            .step(1e-6);
        let (mut worst, mut deepest, mut seen) = (0.0_f64, 0.0_f64, 0);
        simulation
            .run_until(6e-4, |sample| {
                let [depth, force, _] = sample.outputs.as_slice() else { panic!("three outputs") };
                if *depth > 1e-8 {
                    let closed = force / stiffness * ((4.0 * stiffness * radii / force).ln() - 1.0);
                    worst = worst.max((closed / depth - 1.0).abs());
                    (deepest, seen) = (deepest.max(*depth), seen + 1);
                }
            })
            .expect("it moves");
        println!("{surface}: {deepest:.2e} m deep, worst {worst:.1e}, {seen} samples");
        assert!(seen > 20 && deepest > 1e-5 && worst < 1e-13, "{surface}: {worst:.1e}");
        close(simulation.sample().outputs.as_slice()[2], -v, 1e-9, "what it gives back, m/s");
    }
    // Beyond 4 ΔR/e³ it goes on with the slope that it has there.
    let at = |depth: f64| {
        let held = read(&format!(
            "#[allow(penetration)] planar Pressed {{ material rubber {{ modulus [Pa] = 1e6; poisson = 0; }}
                disk roll {{ mass [kg] = 1; radius [m] = 0.3; }} surface other: circle(ground(0, 0) [m], radius [m] = 0.7);
                contact touch: between(roll.surface, other) = hertz_line(first = rubber, second = rubber, length [m] = 1, dissipation [s/m] = 0);
                start {{ roll.center.x [m] = {}; roll.center.y [m] = 0; roll.angle [rad] = 0; }} output force [N] = touch.force; }}",
            1.0 - depth
        ));
        after(&held, 0.0, 1e-6)[0]
    };
    let edge = 4.0 * (-3.0_f64).exp();
    let slope = |from: f64| (at(from + 1e-7) - at(from)) / 1e-7;
    close(slope(edge - 2e-7) / slope(edge + 1e-7), 1.0, 1e-5, "slopes at the edge");
    close(slope(edge + 0.1) / slope(edge + 0.2), 1.0, 1e-7, "slopes beyond");
}

/// A ball between two walls keeps a share e of its speed at each touch, however slow it has become; with one speed for all it would keep more and more.
#[test]
fn each_touch_has_its_own_speed() {
    let ball = |speed: &str| {
        read(&format!(
            "planar Ball {{ particle ball {{ mass [kg] = 1; }} surface own: point(ball.center);
                surface low: half_plane(line(ground(0, 0) [m], ground(1, 0) [m])); surface high: half_plane(line(ground(1, 0.2) [m], ground(0, 0.2) [m]));
                contact down: between(own, low) = hunt_crossley(force [N] = 1e6, depth [m] = 1, restitution = 0.6, {speed});
                limit up: ball.center.y [m] in -9..0.2 = hunt_crossley(force [N] = 1e6, depth [m] = 1, exponent = 2.5, restitution = 0.8, {speed});
                start {{ ball.center.x [m] = 0; ball.center.y [m] = 0.1; ball.center.velocity.y [m/s] = -2; }} options {{ contact = held; }}
                output v [m/s] = ball.center.velocity.y; output y [m] = ball.center.y; {} }}",
            if speed == "speed = touch" { "output last [m/s] = down.speed; output above [m/s] = up.speed;" } else { "" }
        ))
    };
    let touched = ball("speed = touch");
    let mut simulation =
        Simulation::new(&touched, touched.start()).constant(touched.no_inputs()).integrator(Rk4).step(1e-5);
    let (mut speeds, mut known) = (vec![2.0], -2.0);
    simulation
        .run_until(1.2, |sample| {
            let [v, y, ..] = sample.outputs.as_slice() else { panic!("outputs") };
            // In flight behind a touch.
            if v * known < 0.0 && *y > 0.0 && *y < 0.2 {
                (known, _) = (*v, speeds.push(v.abs()));
            }
        })
        .expect("it moves");
    assert!(speeds.len() >= 5, "{speeds:?}");
    for (which, pair) in speeds.windows(2).enumerate() {
        let share = if which % 2 == 0 { 0.6 } else { 0.8 };
        close(pair[1] / pair[0], share, 1e-6, "share of a touch");
    }
    let outputs = simulation.sample().outputs.as_slice().to_vec();
    let last = speeds.len() - 2;
    close(outputs[2 + last % 2], speeds[last], 1e-6, "speed of the last touch");
    // The second touch of one that is told 2 m/s arrives with 1.2 and keeps more than 0.8.
    let told = ball("speed [m/s] = 2");
    let v = after(&told, 0.2, 1e-5)[0].abs();
    assert!(v > 0.85 * 1.2, "{v} m/s");
}

/// Two free bars: their gap is that of the nearest points by search, both ends and middles; what they exert on each other changes no momentum.
#[test]
fn bars_meet_where_they_are_nearest() {
    let bars = |orientation: &str, z: f64, x: f64| {
        read(&format!(
            "#[allow(penetration)] spatial Bars {{ rod one {{ mass [kg] = 1; length [m] = 0.8; radius [mm] = 20; surface skin: capsule(one.start, one.end, radius [m] = 0.05); }}
                rod two {{ mass [kg] = 2; length [m] = 0.5; radius [mm] = 20; surface skin: capsule(two.start, two.end, radius [m] = 0.03); }}
                contact knock: between(one.skin, two.skin) = kelvin_voigt(stiffness [N/m] = 2000, damping [N*s/m] = 5);
                friction rub: on(knock) = coulomb(coefficient = 0.4, speed [m/s] = 0.01);
                start {{ one.center.x [m] = 0; one.center.y [m] = 0; one.center.z [m] = 0; one.orientation = (0.9, 0.1, 0.2, 0.3);
                        two.center.x [m] = {x}; two.center.y [m] = 0.1; two.center.z [m] = {z}; two.orientation = {orientation};
                        two.center.velocity.z [m/s] = -1; two.center.velocity.y [m/s] = 0.3; one.rate.z [rad/s] = 2; }}
                output gap [m] = knock.gap; output force [N] = knock.force;
                output ax [m] = one.start.x; output ay [m] = one.start.y; output az [m] = one.start.z;
                output bx [m] = one.end.x; output by [m] = one.end.y; output bz [m] = one.end.z;
                output cx [m] = two.start.x; output cy [m] = two.start.y; output cz [m] = two.start.z;
                output dx [m] = two.end.x; output dy [m] = two.end.y; output dz [m] = two.end.z;
                output px [N*s] = 1 [kg]*one.center.velocity.x + 2 [kg]*two.center.velocity.x;
                output pz [N*s] = 1 [kg]*one.center.velocity.z + 2 [kg]*two.center.velocity.z;
                output energy [W] = power(rub); }}"
        ))
    };
    let mut kinds = [0; 4];
    for (orientation, z, x) in [
        ("(0.5, 0.6, 0.1, 0.4)", 0.2, 0.0),
        ("(0.7, 0.1, 0.7, 0.1)", 0.3, 0.3),
        ("(0.9, 0.1, 0.2, 0.3)", 0.2, 0.1),
        ("(0.2, 0.1, 0.9, 0.3)", 0.1, 0.6),
    ] {
        let engine = bars(orientation, z, x);
        let seen = after(&engine, 0.0, 1e-4);
        let place = |at: usize| [seen[at], seen[at + 1], seen[at + 2]];
        let [a, b, c, d] = [2, 5, 8, 11].map(place);
        let on = |from: [f64; 3], to: [f64; 3], s: f64| [0, 1, 2].map(|k| from[k] + s * (to[k] - from[k]));
        let far = |s: f64, t: f64| {
            let (p, q) = (on(a, b, s), on(c, d, t));
            (0..3).map(|k| (p[k] - q[k]).powi(2)).sum::<f64>().sqrt()
        };
        // A convex function on a square: the best of a grid, refined about itself.
        let (mut best, mut width) = ([0.5, 0.5], 0.5);
        for _ in 0..60 {
            let around = |at: f64, k: i32| (at + f64::from(k) * width / 4.0).clamp(0.0, 1.0);
            for (i, j) in (-4..=4).flat_map(|i| (-4..=4).map(move |j| (i, j))) {
                let tried = [around(best[0], i), around(best[1], j)];
                if far(tried[0], tried[1]) < far(best[0], best[1]) {
                    best = tried;
                }
            }
            width *= 0.7;
        }
        let ends = best.iter().filter(|s| **s < 1e-6 || **s > 1.0 - 1e-6).count();
        kinds[ends] += 1;
        close(seen[0], far(best[0], best[1]) - 0.08, 1e-7, "gap");
    }
    assert!(kinds[0] > 0 && kinds[1] + kinds[2] > 0, "bars that meet in the middle and at ends: {kinds:?}");
    let engine = bars("(0.5, 0.6, 0.1, 0.4)", 0.2, 0.0);
    let before = after(&engine, 0.0, 1e-4);
    let mut simulation =
        Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).integrator(Rk4).step(1e-4);
    let (mut touched, mut off, mut given) = (0, 0.0_f64, 0.0_f64);
    simulation
        .run_until(0.5, |sample| {
            let now = sample.outputs.as_slice();
            touched += usize::from(now[1] > 0.0);
            off = off.max((now[14] - before[14]).abs()).max((now[15] - before[15]).abs());
            given = given.max(now[16]);
        })
        .expect("they move");
    println!("{touched} samples in contact, momentum off by {off:.1e}");
    assert!(touched > 50 && off < 1e-12 && given <= 0.0, "{touched}, {off}, {given}");
}

/// A rod that hangs on a joint of constant velocity swings as on a pin: 1 kg, 1 m, r = 20 mm, μ = 0.3, ω_s = 0.05 rad/s, from 90 degrees, by a separate integration
/// with the size of the reaction in each step. What its shaft hands on presses too, by the radius.
#[test]
fn shafts_that_keep_their_speed_rub() {
    let rod = read(
        "spatial Rod { gravity [m/s^2] = (0, -9.81, 0); body rod { mass [kg] = 1; inertia [kg*m^2] = (1e-9, 0.08333333333333333, 0.08333333333333333); point top [m] = (-0.5, 0, 0); }
            joint knuckle: constant_velocity(ground(0, 0, 0) [m], rod.top, axis = (1, 0, 0));
            friction rub: on(knuckle) = coulomb(coefficient = 0.3, radius [m] = 0.02, speed [rad/s] = 0.05);
            start { rod.orientation = (1, 0, 0, 0); }
            output x [m] = rod.center.x; output y [m] = rod.center.y; output rate [rad/s] = rod.rate.z; }",
    );
    let outputs = after(&rod, 0.5, 1e-4);
    // From the horizontal.
    close(-outputs[0].atan2(-outputs[1]), 0.075_382_585_972_728_93, 1e-8, "angle after half a second");
    close(outputs[2], -5.328_482_822_176_402, 1e-8, "rate");
    let twisted = read(
        "spatial Twisted { gravity [m/s^2] = (-9.81, 0, 0); body rod { mass [kg] = 2; inertia [kg*m^2] = (0.01, 0.05, 0.05); point top [m] = (0.3, 0, 0); }
            joint knuckle: constant_velocity(ground(0, 0, 0) [m], rod.top, axis = (1, 0, 0));
            torque twist: torque(rod) = (3 [N*m], 0 [N*m], 0 [N*m]);
            friction rub: on(knuckle) = coulomb(coefficient = 0.1, radius [m] = 0.02, speed [rad/s] = 0.05);
            start { rod.orientation = (1, 0, 0, 0); } output normal [N] = rub.normal; output rate [rad/s] = rod.rate.x; }",
    );
    let outputs = after(&twisted, 0.0, 1e-3);
    close(outputs[0], 2.0 * 9.81 + 3.0 / 0.02, 1e-7, "what presses");
    assert_eq!(after(&twisted, 0.1, 1e-3)[1].abs().max(1e-12), 1e-12);
}
