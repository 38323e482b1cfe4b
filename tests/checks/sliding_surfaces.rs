//! Friction of faces and points on planes, of threads and of points on curves, against closed forms.

use linkwright::{AssembleExt, Rk4, Simulation};
use linkwright_engine::Engine;

#[track_caller]
fn close(found: f64, expected: f64, within: f64, what: &str) {
    println!("{what}: {found:.15}, {:.1e} off (bound {within:.0e})", (found - expected).abs());
    assert!((found - expected).abs() <= within, "{what}: {found} in place of {expected}");
}

fn read(source: &str) -> Engine {
    Engine::read(source).unwrap_or_else(|found| panic!("{found}"))
}

/// The outputs after a time.
fn after(engine: &Engine, time: f64) -> Vec<f64> {
    let mut simulation =
        Simulation::new(engine, engine.start()).constant(engine.no_inputs()).integrator(Rk4).step(1e-3);
    simulation.advance_until(time).expect("it moves");
    simulation.sample().outputs.as_slice().to_vec()
}

/// A puck in a planar joint: with J = m r² all of (r ω, v) is braked along itself by μ g, so that it stands after |w|/(μ g), half as far as it would have come by then.
#[test]
fn a_puck_on_a_table_stops_straight_while_it_spins() {
    let engine = read(
        "spatial Puck { gravity [m/s^2] = (0, 0, -9.81); body puck { mass [kg] = 2; inertia [kg*m^2] = (0.01, 0.01, 0.005); }
            joint table: planar(ground(0, 0, 0) [m], puck.center, axis = (0, 0, 1));
            friction rub: on(table) = dry(static = 0.4, kinetic = 0.3, radius [m] = 0.05);
            start { table.travel_1 [m] = 0; table.travel_2 [m] = 0; table.angle [rad] = 0;
                    table.speed_1 [m/s] = 1.2; table.speed_2 [m/s] = -0.4; table.rate [rad/s] = 12; }
            output x [m] = table.travel_1; output y [m] = table.travel_2; output angle [rad] = table.angle; output pressed [N] = rub.normal; output v [m/s] = table.speed_1; output rate [rad/s] = table.rate; }",
    );
    let size = (1.2_f64 * 1.2 + 0.4 * 0.4 + 0.6 * 0.6).sqrt();
    let half = 0.5 * size / (0.3 * 9.81);
    let outputs = after(&engine, 1.0);
    close(outputs[0], 1.2 * half, 1e-9, "along");
    close(outputs[1], -0.4 * half, 1e-9, "across");
    close(outputs[2], 12.0 * half, 1e-7, "turned");
    close(outputs[3], 2.0 * 9.81, 1e-9, "what presses");
    close(outputs[4].abs() + outputs[5].abs(), 0.0, 1e-12, "creeping");
}

/// A particle on a plane of 30 degrees, thrown across it: it turns downhill as the forces on it say, and stays where the plane is rough enough.
#[test]
fn a_particle_on_a_plane_is_held_or_slides_down() {
    let plane = |grip: f64| {
        read(&format!(
            "spatial Grain {{ gravity [m/s^2] = (0, 0, -9.81); particle grain {{ mass [kg] = 0.1; }}
                joint slope: point_on_plane(ground(0, 0, 0) [m], grain.center, axis = (-0.5, 0, 0.8660254037844386));
                friction rub: on(slope) = dry(static = {grip});
                start {{ grain.center.x [m] = 0; grain.center.y [m] = 0; grain.center.velocity.y [m/s] = 2; grain.center.velocity.x [m/s] = 0; }}
                output x [m] = grain.center.x; output y [m] = grain.center.y; output z [m] = grain.center.z; output pressed [N] = rub.normal; }}"
        ))
    };
    // The speed s and the angle φ from straight down, by the plane's own two equations: ṡ = g sin α cos φ − μ g cos α, φ̇ = −g sin α sin φ/s.
    let (mut s, mut phi, mut down, mut across) = (2.0_f64, std::f64::consts::FRAC_PI_2, 0.0, 0.0);
    let (pull, drag, h) = (9.81 * 0.5, 0.4 * 9.81 * 0.866_025_403_784_438_6, 1e-5);
    for _ in 0..50_000 {
        let rate =
            |s: f64, phi: f64| [pull * phi.cos() - drag, -pull * phi.sin() / s, s * phi.cos(), s * phi.sin()];
        let first = rate(s, phi);
        let middle = rate(s + 0.5 * h * first[0], phi + 0.5 * h * first[1]);
        s += h * middle[0];
        phi += h * middle[1];
        down += h * middle[2];
        across += h * middle[3];
    }
    let outputs = after(&plane(0.4), 0.5);
    close(outputs[2], -0.5 * down, 1e-8, "how far down");
    close(outputs[1], across, 1e-8, "how far across");
    close(outputs[3], 0.1 * 9.81 * 0.866_025_403_784_438_6, 1e-9, "what presses");
    let engine = plane(0.7);
    let [early, late] = [3.0, 4.0].map(|time| after(&engine, time));
    for (early, late) in early.iter().zip(&late) {
        close(*late, *early, 1e-12, "where it stays");
    }
}

/// A nut on an upright screw, of the pitch 2π p at the radius r: it runs down with φ̈ = −λ (p − μ r)/J, λ = m g/(1 + μ p/r + m p (p − μ r)/J) what its thread
/// carries, and N = λ √(1 + p²/r²), or stays where μ r > p, in a tree and beside it.
#[test]
fn a_nut_runs_down_its_screw_or_locks() {
    let jack = |grip: f64, coordinates: &str| {
        read(&format!(
            "spatial Jack {{ gravity [m/s^2] = (0, 0, -9.81); body nut {{ mass [kg] = 5; inertia [kg*m^2] = (0.01, 0.01, 0.02); }}
                joint thread: screw(ground(0, 0, 0) [m], nut.origin, axis = (0, 0, 1), pitch [mm] = 10);
                friction rub: on(thread) = dry(static = {grip}, radius [mm] = 10);
                start {{ thread.angle [rad] = 0; }} options {{ coordinates = {coordinates}; }}
                output angle [rad] = thread.angle; output pressed [N] = rub.normal; output force [N] = rub.force; }}"
        ))
    };
    let (m, j, r, p, mu, g) = (5.0, 0.02, 0.01, 0.01 / std::f64::consts::TAU, 0.1, 9.81);
    let carried = m * g / (1.0 + mu * p / r + m * p * (p - mu * r) / j);
    let pressed = carried * f64::hypot(r, p) / r;
    for coordinates in ["tree", "absolute"] {
        let outputs = after(&jack(mu, coordinates), 1.0);
        close(outputs[0], -0.5 * carried * (p - mu * r) / j, 1e-8, "how far it turned");
        // Nothing presses across, but for ε.
        close(outputs[1], pressed, 1e-7, "what presses");
        close(outputs[2], mu * pressed, 1e-7, "what brakes");
        let outputs = after(&jack(0.2, coordinates), 1.0);
        close(outputs[0], 0.0, 1e-12, "where it is held");
        // As an inclined plane: m g p/h along the thread.
        close(outputs[2], m * g * p / f64::hypot(r, p), 1e-9, "what holds");
    }
}

/// A bead on a ring without gravity: v = v₀/(1 + μ v₀ t/R), and it has turned by ln(1 + μ v₀ t/R)/μ; on a parabola it stays where its slope is below μ.
#[test]
fn a_bead_runs_on_a_ring_and_rests_in_a_parabola() {
    for law in ["dry(static = 0.3)", "coulomb(coefficient = 0.3, speed [m/s] = 1e-9)"] {
        let engine = read(&format!(
            "planar Ring {{ particle bead {{ mass [kg] = 0.2; }}
                joint ring: point_on_curve(ground(0, 0) [m], bead.center, x = 0.5 [m]*cos(ring.parameter/(0.25 [m])), y = 0.5 [m]*sin(ring.parameter/(0.25 [m])));
                friction rub: on(ring) = {law};
                start {{ ring.parameter [m] = 0; ring.parameter_rate [m/s] = 1; }}
                output turned [rad] = ring.parameter/(0.25 [m]); output speed [m/s] = 2*ring.parameter_rate; output pressed [N] = rub.normal; }}"
        ));
        let outputs = after(&engine, 1.5);
        let part: f64 = 1.0 + 0.3 * 2.0 * 1.5 / 0.5;
        close(outputs[0], part.ln() / 0.3, 1e-9, "how far it turned");
        close(outputs[1], 2.0 / part, 1e-9, "how fast it slides");
        close(outputs[2], 0.2 * (2.0 / part).powi(2) / 0.5, 1e-8, "what presses");
    }
    let bowl = |x: f64, coordinates: &str| {
        read(&format!(
            "planar Bowl {{ gravity [m/s^2] = (0, -9.81); particle bead {{ mass [kg] = 0.2; }}
                joint wire: point_on_curve(ground(0, 0) [m], bead.center, y = 1 [1/m]*wire.parameter*wire.parameter);
                friction rub: on(wire) = dry(static = 0.5); start {{ wire.parameter [m] = {x}; }} options {{ coordinates = {coordinates}; }}
                output x [m] = wire.parameter; output pressed [N] = rub.normal; }}"
        ))
    };
    for coordinates in ["tree", "absolute"] {
        let outputs = after(&bowl(0.249, coordinates), 1.0);
        close(outputs[0], 0.249, 1e-12, "where the slope is 0.498");
        close(outputs[1], 0.2 * 9.81 / 0.498_f64.hypot(1.0), 1e-9, "what presses");
        assert!(after(&bowl(0.251, coordinates), 1.0)[0] < 0.250, "where the slope is 0.502");
    }
}
