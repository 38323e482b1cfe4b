//! Forces along driven motions against closed forms: a cam of the literature, an eccentric as a slider-crank, a bar that swings.

use crate::{Random, compiled, errors};
use linkwright_compiler::check::motion::Least;
use std::f64::consts::TAU;

fn least(source: &str) -> Least {
    compiled(source).efforts().remove(0)
}

fn near(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((found - expected).abs() <= tolerance * expected.abs(), "{what}: {found} for {expected}");
}

const LIFT: [f64; 37] = [
    0.0, 0.041, 0.284, 0.828, 1.679, 2.773, 4.0, 5.227, 6.321, 7.172, 7.716, 7.959, 8.0, 8.0, 8.0, 8.0, 8.0,
    8.0, 8.0, 7.959, 7.716, 7.172, 6.321, 5.227, 4.0, 2.773, 1.679, 0.828, 0.284, 0.041, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0,
];

fn table(of: impl Fn(usize) -> f64, count: usize) -> String {
    let step = 360.0 / (count - 1) as f64;
    let knots: Vec<String> = (0..count).map(|k| format!("({}, {:.15})", step * k as f64, of(k))).collect();
    format!("table lift(angle [deg]) [mm] = [{}], periodic;", knots.join(", "))
}

/// A follower of 0.3 kg on a spring of 4000 N/m and 60 N, above a cam at so many rad/s.
fn cam(follow: &str, speed: f64) -> String {
    format!(
        "planar Cam {{
            gravity [m/s^2] = (0, -9.81); {}
            body cam {{ mass [kg] = 1; inertia [kg*m^2] = 8e-4; }} body follower {{ mass [kg] = 0.3; inertia [kg*m^2] = 0; }}
            joint shaft: revolute(ground(0, 0) [m], cam.center);
            joint rail: prismatic(ground(0, 40) [mm], follower.center, axis = (0, 1));
            {follow}
            force spring: force(rail) = -60 [N] - 4000 [N/m]*rail.travel;
            drive motor: shaft.angle = {speed} [rad/s]*time; ",
        table(|k| LIFT[k], 37)
    )
}

/// N = m (ω² s″ + g) + F₀ + k s of SciPy's periodic spline: 60.2341177801 N at least, at 210° and by symmetry at 90°; none left at 170.83543238 rad/s.
/// The constraint by the lift says so, and the joint by the outline, whose force is N/cos α.
#[test]
fn a_follower_leaves_its_cam_as_the_source_says() {
    let law = cam("constraint follow: rail.travel = lift(shaft.angle);", 100.0);
    let found = least(&format!("{law} expect {{ follow.effort > 0; }} }}"));
    // At a knot, where the force has a corner.
    near(found.value, 60.2341177801, 1e-11, "least force");
    let is_there = |position: f64| [90.0, 210.0].iter().any(|at| (position.to_degrees() - at).abs() < 1e-5);
    assert!(is_there(found.at.position), "{found:?}");
    let (faster, at) = found.fails.expect("it leaves");
    near(100.0 * faster, 170.83543238, 1e-10, "speed");
    assert!(is_there(at.position) && (at.rate - 100.0).abs() < 1e-9, "{at:?}");

    // The same outline under the follower, turned the other way from a right angle.
    let outline = cam("joint follow: cam(cam.center, follower.center, lift = lift, base [mm] = 40);", 100.0);
    let outline = outline.replace("shaft.angle = 100", "shaft.angle = 90 [deg] - 100");
    let found =
        least(&format!("{outline} start {{ rail.travel [mm] ~ 1; }} expect {{ follow.force > 0; }} }}"));
    near(100.0 * found.fails.expect("it leaves").0, 170.83543238, 1e-10, "speed of the outline");

    let fast = law.replace("100 [rad/s]", "200 [rad/s]");
    let text = errors(&format!("{fast} expect {{ follow.effort > 0; }} }}"));
    for part in [
        "expected follow.effort > 0 N, but it is -33.96 N",
        "`motor` goes at 200 rad/s",
        "Slower than 170.835 rad/s it is so all along",
    ] {
        assert!(text.contains(part), "{text}");
    }
    let text = errors(&format!("{law} expect {{ follow.effort [N] > 65; }} }}"));
    assert!(text.contains("It is not so at rest either"), "{text}");
}

/// An eccentric circle of radius R under a roller of radius r is a slider-crank of links e and L = R + r:
/// y = e sin θ + √(L² − e² cos² θ), N = (m (ÿ + g) + F₀ + k y) L/√(L² − e² cos² θ).
#[test]
fn an_eccentric_with_a_roller_is_a_slider_crank() {
    let mut random = Random(5);
    for _ in 0..4 {
        let (e, rim, roller) =
            (random.between(2.0, 12.0), random.between(25.0, 40.0), random.between(0.0, 15.0));
        let speed = random.between(20.0, 60.0);
        let radius = |k: usize| {
            let angle = TAU * k as f64 / 720.0;
            e * angle.cos() + (rim * rim - (e * angle.sin()).powi(2)).sqrt()
        };
        let source = format!(
            "planar Eccentric {{
                gravity [m/s^2] = (0, -9.81); {}
                body cam {{ mass [kg] = 1; inertia [kg*m^2] = 8e-4; }} body follower {{ mass [kg] = 0.3; inertia [kg*m^2] = 0; }}
                joint shaft: revolute(ground(0, 0) [m], cam.center);
                joint rail: prismatic(ground(0, 0) [m], follower.center, axis = (0, 1));
                joint follow: cam(cam.center, follower.center, lift = lift, radius [mm] = {roller});
                force spring: force(rail) = -10 [N] - 4000 [N/m]*rail.travel;
                drive motor: shaft.angle = {speed} [rad/s]*time; start {{ rail.travel [mm] ~ {}; }}
                expect {{ follow.force > 0; }} }}",
            table(radius, 721),
            rim + roller
        );
        let (e, long) = (1e-3 * e, 1e-3 * (rim + roller));
        let force = |angle: f64, speed: f64| {
            let (sin, cos) = angle.sin_cos();
            let root = (long * long - (e * cos).powi(2)).sqrt();
            let (up, down) = (e * e * (2.0 * angle).cos() / root, (e * e * sin * cos).powi(2) / root.powi(3));
            let (y, curved) = (e * sin + root, -e * sin + up - down);
            (0.3 * (speed * speed * curved + 9.81) + 10.0 + 4000.0 * y) * long / root
        };
        let lowest = |speed: f64| {
            let all = (0..100_000).map(|k| force(TAU * f64::from(k) / 1e5, speed));
            all.fold(f64::INFINITY, f64::min)
        };
        let found = least(&source);
        near(found.value, lowest(speed), 1e-6, "least force");
        let (faster, _) = found.fails.expect("it leaves");
        // The curvature of the table is good for five digits.
        assert!(lowest(faster * speed).abs() < 2e-5 * found.value, "{e} {long} {speed}: {found:?}");
    }
}

/// A bar that is swung by φ = A sin ω t without gravity: its pin holds m l/2 √(φ̈² + φ̇⁴), four times as much at twice the speed.
#[test]
fn a_swung_bar_pulls_at_its_pin() {
    let (amplitude, omega) = (1.3, 4.0);
    let found = least(
        "planar Swung { rod bar { mass [kg] = 2; length [m] = 0.5; } joint pin: revolute(ground(0, 0) [m], bar.start);
            drive motor: pin.angle = 1.3 [rad]*sin(4 [rad/s]*time); expect { pin.reaction.size < 100 [N]; } }",
    );
    let pull = |k: u32| {
        let phase = TAU * f64::from(k) / 1e5;
        let (rate, second) = (amplitude * omega * phase.cos(), amplitude * omega * omega * phase.sin());
        0.5 * (second * second + rate.powi(4)).sqrt()
    };
    let most = (0..100_000).map(pull).fold(0.0, f64::max);
    near(found.value, most, 1e-8, "reaction");
    near(found.fails.expect("it grows with speed").0, (100.0 / most).sqrt(), 1e-8, "how many times as fast");
}

/// What cannot be followed says why.
#[test]
fn what_drivers_do_not_fix_is_named() {
    let cases = [
        (
            cam("joint far: revolute(ground(1, 0) [m], loose.center); body loose { mass [kg] = 1; inertia [kg*m^2] = 1; }
                 constraint follow: rail.travel = lift(shaft.angle);", 100.0),
            "drivers leave 1 of the degrees of freedom",
        ),
        (
            cam("friction rub: on(shaft) = coulomb(coefficient = 0.1, radius [mm] = 5, speed [rad/s] = 0.1);
                 constraint follow: rail.travel = lift(shaft.angle);", 100.0),
            "friction by reactions is not there yet along a driven motion",
        ),
        (
            cam("constraint follow: rail.travel = lift(shaft.angle);", 100.0).replace("100 [rad/s]*time", "0.1 [rad/s^2]*time^2"),
            "is not back where it began, as fast as there",
        ),
    ];
    for (source, expected) in cases {
        let text = errors(&format!("{source} expect {{ follow.effort > 0; }} }}"));
        assert!(text.contains(expected), "{text}");
    }
    let text = errors(
        "planar Stretched {
            rod crank { mass [kg] = 1; length [m] = 1; } rod link { mass [kg] = 1; length [m] = 2; } body block { mass [kg] = 1; inertia [kg*m^2] = 1; }
            joint main: revolute(ground(0, 0) [m], crank.start); joint big: revolute(crank.end, link.start);
            joint wrist: revolute(link.end, block.center);
            joint bore: prismatic(ground(0, 0) [m], block.center, axis = (1, 0));
            drive motor: bore.travel = 2 [m] + 1 [m/s]*time;
            start { main.angle [deg] ~ 75; link.angle [deg] ~ -30; }
            limit stop: bore.travel [m] in 0..5 = kelvin_voigt(stiffness [N/m] = 1000);
            expect { stop.force < 10 [N]; } }",
    );
    assert!(text.contains("after 1 s there is no position that the drivers ask for"), "{text}");
}
