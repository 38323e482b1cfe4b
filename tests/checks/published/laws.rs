//! Laws of contacts and friction against what they are in closed form or by quadrature: how fast a blow comes back, a pin with play in soft steel, a
//! mass on a belt.

use linkwright::{AssembleExt, DormandPrince, Rk4, Simulation};
use linkwright_engine::Engine;

#[track_caller]
fn close(found: f64, expected: f64, within: f64, what: &str) {
    println!("{what}: {found:.15}, {:.1e} off (bound {within:.0e})", (found - expected).abs());
    assert!((found - expected).abs() <= within, "{what}: {found} in place of {expected}");
}

/// The part of its speed of 1 m/s with which a ball of 1 kg comes back from a wall of this law.
fn restitution(law: &str) -> f64 {
    let source = format!(
        "planar Blow {{ disk ball {{ mass [kg] = 1; radius [m] = 0.1; }} surface wall: half_plane(line(ground(0, 1) [m], ground(0, -1) [m]), side = right);
            contact strike: between(ball.surface, wall) = {law}; options {{ contact = held; }}
            start {{ ball.center.x [m] = -0.2; ball.center.y [m] = 0; ball.angle [rad] = 0; ball.center.velocity.x [m/s] = 1; }}
            output speed [m/s] = ball.center.velocity.x; }}"
    );
    let engine = Engine::read(&source).unwrap_or_else(|found| panic!("{found}"));
    let mut simulation = Simulation::new(&engine, engine.start())
        .constant(engine.no_inputs())
        .integrator(DormandPrince::tolerance(1e-12))
        .step(1e-4);
    simulation.advance_until(0.3).expect("it comes back");
    -simulation.sample().outputs.as_slice()[0]
}

/// F = K dⁿ (1 + b ḋ), whatever n is: b v with the speed v of the blow decides.
#[test]
fn losses_by_speed_decide_what_comes_back() {
    let cases = [
        (0.1, 0.937_475_579_949_905),
        (0.5, 0.748_434_931_597_434),
        (1.0, 0.593_624_260_040_04),
        (2.0, 0.410_719_686_061_039),
    ];
    for (b, expected) in cases {
        for exponent in ["1", "1.5"] {
            let law = format!(
                "hunt_crossley(force [N] = 1e3, depth [mm] = 10, exponent = {exponent}, dissipation [s/m] = {b})"
            );
            close(restitution(&law), expected, 1e-9, &format!("with b v = {b}, n = {exponent}"));
        }
    }
}

/// A spring and a damper of the damping ratio ζ that do not pull.
#[test]
fn a_damper_that_does_not_pull_gives_back_more() {
    let cases = [(0.1, 0.744_079_397_721_78), (0.3, 0.450_975_452_893_128), (0.7, 0.210_284_564_378_478)];
    for (ratio, expected) in cases {
        let law = format!("kelvin_voigt(stiffness [N/m] = 1e4, damping [N*s/m] = {})", 200.0 * ratio);
        close(restitution(&law), expected, 1e-9, &format!("with ζ = {ratio}"));
    }
}

/// As the model `LooseWrist`, with K = 1e8 N/m^1.5.
#[test]
fn a_wrist_has_play_in_what_is_softer() {
    let source = "planar Wrist { gravity [m/s^2] = (0, -9.81);
        rod crank { mass [kg] = 0.3; length [m] = 0.05; }
        body rod { mass [kg] = 0.21; inertia [kg*m^2] = 2.5e-4; point big [m] = (-0.06, 0); point small [m] = (0.06, 0); }
        body slider { mass [kg] = 0.14; inertia [kg*m^2] = 1e-5; }
        joint main: revolute(ground(0, 0) [m], crank.start); joint crank_pin: revolute(crank.end, rod.big);
        joint rail: prismatic(ground(0, 0) [m], slider.center, axis = (1, 0)); drive motor: main.angle = 20*pi*time*(1 [rad/s]);
        joint wrist: revolute(rod.small, slider.center, play [mm] = 0.5, radius [mm] = 10)
            = hunt_crossley(force [N] = 1e5, depth [mm] = 10, exponent = 1.5, dissipation [s/m] = 20);
        start { crank_pin.angle [rad] ~ 0; rail.travel [m] ~ 0.17; }
        output travel [m] = rail.travel; output off_x [m] = slider.center.x - rod.small.x; output off_y [m] = slider.center.y - rod.small.y; }";
    let engine = Engine::read(source).unwrap_or_else(|found| panic!("{found}"));
    let mut simulation = Simulation::new(&engine, engine.start())
        .constant(engine.no_inputs())
        .integrator(DormandPrince::tolerance(1e-11))
        .step(1e-6);
    simulation.advance_until(0.05).expect("it moves");
    let outputs = simulation.sample().outputs.as_slice().to_vec();
    close(outputs[0], 0.069_597_201_8, 1e-9, "slider");
    close(outputs[1], -0.402_343_56e-3, 1e-10, "off along x");
    close(outputs[2], 0.330_329_61e-3, 1e-10, "off along y");
}

/// A mass on a spring on a belt, where sliding takes less the faster it is: F/(1 + 3 |v|) (Leine, van Campen, de Kraker, van den Steen, Nonlinear
/// Dynamics 16 (1998) 41); the times by quadrature.
#[test]
fn a_mass_on_a_belt_slides_the_easier_the_faster() {
    let source = "planar Carried { body belt { mass [kg] = 1; inertia [kg*m^2] = 1; } body block { mass [kg] = 1; inertia [kg*m^2] = 1; }
        joint guide: prismatic(ground(0, 0) [m], belt.center, axis = (1, 0));
        joint over: prismatic(belt.center, block.center, axis = (1, 0));
        drive run: guide.travel = 0.2 [m/s]*time;
        friction rub: on(over) = dry(force = 1 [N]/(1 + 3 [s/m]*abs(over.speed)), breakaway [N] = 1);
        spring back: spring(ground(-10, 0) [m], block.center, stiffness [N/m] = 1, length [m] = 10);
        start { over.travel [m] = 0; over.speed [m/s] = 0; } output x [m] = block.center.x; }";
    let engine = Engine::read(source).unwrap_or_else(|found| panic!("{found}"));
    let mut simulation =
        Simulation::new(&engine, engine.start()).constant(engine.no_inputs()).integrator(Rk4).step(1e-3);
    let (slips, sticks_at, period) = (4.295_999_525_480_07, -0.541_006_353_870_048, 12.001_031_294_830_307);
    let (mut most, mut least) = (0.0_f64, 0.0_f64);
    for (begun, end) in [(5.0, 9.5), (5.0 + period, 21.5)] {
        while simulation.time() < end - 1e-9 {
            simulation.advance().expect("it moves");
            let x = simulation.sample().outputs.as_slice()[0];
            (most, least) = (most.max(x), least.min(x));
        }
        let expected = sticks_at + 0.2 * (end - begun - slips);
        close(simulation.sample().outputs.as_slice()[0], expected, 1e-9, "where it is carried on");
    }
    close(most, 1.133_944_676_437_86, 2e-7, "farthest");
    close(least, -0.555_432_690_033_27, 2e-7, "and back");
}
