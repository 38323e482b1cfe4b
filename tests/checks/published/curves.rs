//! Points on curves against closed forms: Huygens' pendulum, a bead on a parabola, an ellipse that two sliders draw, a slot in a loop.

use super::Worst;
use linkwright::{Mechanism, Simulation, State};
use std::f64::consts::TAU;

const G: f64 = 9.81;
const A: f64 = 0.25;

linkwright::mechanism! {
    /// A bead on a cycloid, x = a (φ + sin φ), y = a (1 − cos φ), with u = a φ.
    pub planar Huygens {
        param a [m] = 0.25;
        gravity [m/s^2] = (0, -9.81);
        particle bead { mass [kg] = 0.5; }
        joint wire: point_on_curve(ground(0, 0), bead.center,
            x = wire.parameter + a*sin(wire.parameter/a), y = a*(1 - cos(wire.parameter/a)));
        start { wire.parameter [m] = 0.4; wire.parameter_rate [m/s] = 0; }
        expect { degrees_of_freedom = 1; }
        output force [N] = wire.force;
    }
}

linkwright::mechanism! {
    /// A bead on y = k x²/2.
    pub planar Parabola {
        param k [1/m] = 2;
        gravity [m/s^2] = (0, -9.81);
        particle bead { mass [kg] = 0.5; }
        joint wire: point_on_curve(ground(0, 0), bead.center, y = k/2*wire.parameter*wire.parameter);
        start { wire.parameter [m] = 0.7; wire.parameter_rate [m/s] = 0.3; }
        output force [N] = wire.force;
    }
}

linkwright::mechanism! {
    /// A bead on an ellipse.
    pub planar Ellipse {
        gravity [m/s^2] = (0, -9.81);
        particle bead { mass [kg] = 0.5; }
        joint wire: point_on_curve(ground(0, 0), bead.center,
            x = 0.3 [m]*cos(wire.parameter/0.3 [m]), y = 0.2 [m]*sin(wire.parameter/0.3 [m]));
        start { wire.parameter [m] = 0.21; wire.parameter_rate [m/s] = 0.39; }
    }
}

linkwright::mechanism! {
    /// Its trammel: a bar whose ends slide on the axes, with its mass where it draws the ellipse.
    pub planar Trammel {
        gravity [m/s^2] = (0, -9.81);
        body bar { mass [kg] = 0.5; inertia [kg*m^2] = 0; point on_x [m] = (-0.2, 0); point on_y [m] = (-0.3, 0); }
        joint one: point_on_line(line(ground(0, 0), ground(1, 0) [m]), bar.on_x);
        joint other: point_on_line(line(ground(0, 0), ground(0, 1) [m]), bar.on_y);
        start { bar.angle [rad] = 0.7; bar.rate [rad/s] = 1.3; }
    }
}

/// A crank whose pin slides in a rocker: along a line, along the same line as a graph, and as a curve whose parameter is not its length.
macro_rules! slotted {
    ($name:ident, [$($joint:tt)*], [$($across:tt)*]) => {
        linkwright::mechanism! {
            pub planar $name {
                gravity [m/s^2] = (0, -9.81);
                rod crank { mass [kg] = 0.5; length [m] = 0.2; }
                rod rocker { mass [kg] = 1; length [m] = 0.8; }
                joint a: revolute(ground(0, 0), crank.start);
                joint b: revolute(ground(-0.3, -0.1) [m], rocker.start);
                joint pin: $($joint)*;
                start { a.angle [deg] = 60; b.angle [deg] ~ 20; a.rate [rad/s] = 2; }
                expect { degrees_of_freedom = 1; }
                output across [N] = $($across)*;
            }
        }
    };
}
slotted!(Straight, [point_on_line(line(rocker.start, rocker.end), crank.end)], [pin.reaction.normal]);
slotted!(AsGraph, [point_on_curve(rocker.start, crank.end, y = 0[m])], [pin.force]);
slotted!(
    Uneven,
    [point_on_curve(
        rocker.start,
        crank.end,
        x = pin.parameter + pin.parameter * pin.parameter * pin.parameter * 2[1 / m ^ 2],
        y = 0[m]
    )],
    [pin.force]
);

/// s = 4 a sin(φ/2) is the length from the lowest point, and s̈ = −g/(4 a) s whatever the amplitude (Huygens, 1673); from
/// the curvature 1/(4 a cos(φ/2)) the force N = m (g cos(φ/2) + ṡ²/(4 a cos(φ/2))).
#[test]
fn a_cycloid_swings_harmonically() {
    let model = Huygens::<f64>::default();
    let mut worst = Worst::default();
    for (phi, rate) in [(0.0, 2.0), (0.3, -1.0), (-1.1, 0.4), (2.2, 3.0), (-2.9, 0.0)] {
        let state = State { q: [A * phi], v: [A * rate], ..Huygens::START };
        let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
        model.acceleration(0.0, &state, &(), &mut a, &mut lambda);
        let (sin, cos) = (0.5 * phi).sin_cos();
        let (length, speed) = (4.0 * A * sin, 2.0 * A * cos * rate);
        worst.see(2.0 * cos * a[0] - A * sin * rate * rate, -G / (4.0 * A) * length);
        let force = 0.5 * (G * cos + speed * speed / (4.0 * A * cos));
        worst.see(model.outputs(0.0, &state, &()).force, force);
    }
    worst.below(1e-12, "cycloid, acceleration and force");

    let period = TAU * (4.0 * A / G).sqrt();
    let mut worst = Worst::default();
    for start in [0.05, 0.4, 0.7] {
        let state = State { q: [start], ..Huygens::START };
        let steps = 4000.0;
        let mut simulation = Simulation::new(&model, state).step(period / steps);
        simulation.run_until(period, |_| {}).expect("it swings");
        worst.see(simulation.state().q[0], start);
    }
    worst.below(1e-9, "cycloid, after a period");
}

/// N = m (g + k ẋ²)/√(1 + k² x²), and the energy m/2 (1 + k² x²) ẋ² + m g k x²/2.
#[test]
fn a_bead_on_a_parabola() {
    let (model, k, m) = (Parabola::<f64>::default(), 2.0, 0.5);
    let energy = |x: f64, v: f64| 0.5 * m * (1.0 + k * k * x * x) * v * v + 0.5 * m * G * k * x * x;
    let start = Parabola::START;
    let total = energy(start.q[0], start.v[0]);
    let (mut forces, mut energies) = (Worst::default(), Worst::default());
    let mut simulation = Simulation::new(&model, start).step(1e-3);
    simulation
        .run_until(3.0, |sample| {
            let (x, v) = (sample.state.q[0], sample.state.v[0]);
            forces.see(sample.outputs.force, m * (G + k * v * v) / (1.0 + k * k * x * x).sqrt());
            energies.see(energy(x, v), total);
        })
        .expect("it swings");
    forces.below(1e-12, "parabola, force");
    energies.below(1e-9, "parabola, energy");
}

/// Position, velocity and acceleration of the only body's centre at the start.
macro_rules! at_start {
    ($name:ident) => {{
        let model = $name::<f64>::default();
        let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
        model.acceleration(0.0, &$name::START, &(), &mut a, &mut lambda);
        let motion = model.motions(0.0, &$name::START.q, &$name::START.v, &a)[0];
        [motion.position, motion.velocity, motion.acceleration].concat()
    }};
}

/// The bar of a trammel draws an ellipse, so that its mass there moves as a bead on one does; φ̈ (A² s² + B² c²) = −(A² − B²) s c φ̇² − g B c.
#[test]
fn an_ellipse_is_what_a_trammel_draws() {
    let (bead, bar) = (at_start!(Ellipse), at_start!(Trammel));
    let mut worst = Worst::default();
    for (found, expected) in bead.iter().zip(&bar) {
        worst.see(*found, *expected);
    }
    let (a, b, rate) = (0.3, 0.2, 1.3);
    let (s, c) = 0.7_f64.sin_cos();
    let angular = -((a * a - b * b) * s * c * rate * rate + G * b * c) / (a * a * s * s + b * b * c * c);
    let expected = [
        a * c,
        b * s,
        -a * s * rate,
        b * c * rate,
        -a * (s * angular + c * rate * rate),
        b * (c * angular - s * rate * rate),
    ];
    for (found, expected) in bead.iter().zip(expected) {
        worst.see(*found, expected);
    }
    worst.below(1e-12, "ellipse");
}

macro_rules! turned {
    ($name:ident, $time:expr) => {{
        let model = $name::<f64>::default();
        let mut simulation =
            Simulation::new(&model, $name::START).formulation(super::baumgarte(20.0)).step(5e-4);
        simulation.run_until($time, |_| {}).expect("it turns");
        let state = *simulation.state();
        let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
        model.acceleration(0.0, &state, &(), &mut a, &mut lambda);
        let across = model.outputs(0.0, &state, &()).across;
        let motions = model.motions(0.0, &state.q, &state.v, &a);
        let [crank, rocker] = [0, 1].map(|body| [motions[body].rate, motions[body].angular_acceleration]);
        [crank, rocker, [across, 0.0]].concat()
    }};
}

/// In a loop: the row of a graph, and the body that hangs on a curve which is none, move as the pin in a straight slot.
#[test]
fn a_slot_in_a_loop() {
    assert!(Uneven::COORDINATES.contains("\"tree\""), "{}", Uneven::COORDINATES);
    for (time, graph, uneven) in [(0.0, 1e-12, 1e-10), (0.5, 1e-12, 1e-5)] {
        let straight = turned!(Straight, time);
        let (mut as_graph, mut by_uneven) = (Worst::default(), Worst::default());
        for (k, expected) in straight.iter().enumerate() {
            as_graph.see(turned!(AsGraph, time)[k], *expected);
            by_uneven.see(turned!(Uneven, time)[k], *expected);
        }
        as_graph.below(graph, "slot as a graph");
        // After a while other coordinates have drifted otherwise.
        by_uneven.below(uneven, "slot by an uneven parameter");
    }
}
