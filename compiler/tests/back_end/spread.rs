//! Masses, stiffnesses and sizes far apart: the self-check raises no alarm, still notices mutants, and the digits are there.

use crate::compiled;
use crate::self_check::noticed;
use linkwright_compiler::Compiled;
use linkwright_compiler::schedule::{Function, Inputs, run};
use linkwright_compiler::self_check::{Extent, self_check};

const MASSES: [f64; 7] = [1e-3, 1e-5, 1e-6, 1e-8, 1e-10, 1e-12, 1e-15];
const COORDINATES: [&str; 2] = ["absolute", "tree"];

/// A particle on a rail and a point mass on a massless rod, at an angle with the rod's rate: every velocity of the rod's is
/// without inertia.
fn cart(mass: f64, coordinates: &str) -> String {
    format!(
        "planar LightCart {{
    gravity [m/s^2] = (0, -9.81);
    particle cart {{ mass [kg] = {mass:?}; }}
    body pole {{ mass [kg] = 1; inertia [kg*m^2] = 0; center [m] = (0, -1); }}
    joint rail: point_on_line(line(ground(0, 0) [m], ground(1, 0) [m]), cart.center);
    joint pin: revolute(cart.center, pole.origin);
    start {{ rail.travel [m] = 0; rail.speed [m/s] = 0; pole.angle [rad] = 1; pole.rate [rad/s] = 2; }}
    options {{ coordinates = {coordinates}; }}
    expect {{ degrees_of_freedom = 2; }}
}}"
    )
}

/// A four-bar of some size with links of these masses, and a stiff spring beside a soft one.
fn four_bar(masses: [f64; 3], size: f64, coordinates: &str) -> String {
    let link = |name: &str, mass: f64, length: f64| {
        let (inertia, center) = (0.1 * mass * size * size, 0.5 * length * size);
        format!(
            "body {name} {{ mass [kg] = {mass:?}; inertia [kg*m^2] = {inertia:?}; center [m] = ({center:?}, 0);
                 point end [m] = ({:?}, 0); }}",
            length * size
        )
    };
    format!(
        "planar FourBar {{
    gravity [m/s^2] = (0, -9.81);
    {} {} {}
    joint a: revolute(ground(0, 0) [m], crank.origin);
    joint b: revolute(crank.end, coupler.origin);
    joint c: revolute(coupler.end, rocker.end);
    joint d: revolute(ground({:?}, 0) [m], rocker.origin);
    force stiff: spring(ground(0, {size:?}) [m], rocker.end, stiffness [N/m] = 1e9, length [m] = {size:?});
    force soft: spring(ground(0, {size:?}) [m], crank.end, stiffness [N/m] = 1e-9, length [m] = {size:?});
    start {{ a.angle [deg] = 60; a.rate [rad/s] = 1; d.angle [deg] ~ 90; coupler.angle [deg] ~ 20; }}
    options {{ coordinates = {coordinates}; }}
}}",
        link("crank", masses[0], 0.4),
        link("coupler", masses[1], 1.0),
        link("rocker", masses[2], 0.8),
        0.9 * size
    )
}

/// A frame of a tonne on a wheel of this mass, between springs of 1e9 and 1e-9 N/m.
fn wheel(mass: f64, coordinates: &str) -> String {
    format!(
        "planar Wheel {{
    gravity [m/s^2] = (0, -9.81);
    body frame {{ mass [kg] = 1000; inertia [kg*m^2] = 100; center [m] = (0, 0.5); point hub [m] = (0.2, 0); }}
    body wheel {{ mass [kg] = {mass:?}; inertia [kg*m^2] = {:?}; center [m] = (0, 0); point rim [m] = (0.1, 0); }}
    joint slide: prismatic(ground(0, 0) [m], frame.origin, axis = (1, 0));
    joint hub: revolute(frame.hub, wheel.origin);
    force stiff: spring(ground(0, 1) [m], wheel.rim, stiffness [N/m] = 1e9, length [m] = 0.3);
    force soft: spring(ground(0, 1) [m], frame.hub, stiffness [N/m] = 1e-9, length [m] = 0.3);
    start {{ slide.travel [m] = 0; slide.speed [m/s] = 1; hub.angle [rad] = 0.2; hub.rate [rad/s] = 1; }}
    options {{ coordinates = {coordinates}; }}
}}",
        0.01 * mass
    )
}

/// A body of 1 kg and one of this mass behind it, held at a distance.
fn in_space(mass: f64, coordinates: &str) -> String {
    let body = |name: &str, mass: f64| {
        let (along, across) = (0.01 * mass, 0.1 * mass);
        format!(
            "body {name} {{ mass [kg] = {mass:?}; center [m] = (0.5, 0, 0); point end [m] = (1, 0, 0);
                 inertia [kg*m^2] = ({along:?}, {across:?}, {across:?}); }}"
        )
    };
    format!(
        "spatial Pair {{
    gravity [m/s^2] = (0, 0, -9.81);
    {} {}
    joint root: spherical(ground(0, 0, 0) [m], near.origin);
    joint elbow: spherical(near.end, far.origin);
    joint stay: distance(ground(1, 1, 0) [m], far.end, length [m] = 1.2);
    options {{ coordinates = {coordinates}; }}
}}",
        body("near", 1.0),
        body("far", mass)
    )
}

/// It compiles, and the thorough check says nothing.
fn assert_sound(source: &str) -> Compiled {
    let compiled = compiled(source).unwrap_or_else(|errors| panic!("{errors}\n{source}"));
    let found = self_check(&compiled, Extent::Thorough);
    assert!(found.is_empty(), "{}\n{source}", found[0]);
    compiled
}

#[test]
fn light_parts_raise_no_alarm() {
    for (mass, coordinates) in
        MASSES.iter().flat_map(|mass| COORDINATES.map(|coordinates| (*mass, coordinates)))
    {
        assert_sound(&cart(mass, coordinates));
        assert_sound(&wheel(mass, coordinates));
        assert_sound(&in_space(mass, coordinates));
        for masses in [[mass, 1.0, 1.0], [1.0, mass, 1.0], [1.0, 1.0, mass], [mass, mass, 1.0]] {
            assert_sound(&four_bar(masses, 1.0, coordinates));
        }
    }
}

#[test]
fn micrometres_and_kilometres_raise_no_alarm() {
    for (size, mass) in [1e-6, 1e3].into_iter().flat_map(|size| MASSES.map(|mass| (size, mass))) {
        for coordinates in COORDINATES {
            assert_sound(&four_bar([1.0, mass, 1.0], size, coordinates));
        }
    }
}

/// ẍ of the cart is m sin θ (l θ̇² + g cos θ)/(m_c + m sin² θ), whatever m_c: nothing of it is lost beside the mass of the pole.
#[test]
fn the_light_cart_keeps_its_digits() {
    for (mass, coordinates) in
        MASSES.iter().flat_map(|mass| COORDINATES.map(|coordinates| (*mass, coordinates)))
    {
        let compiled = assert_sound(&cart(mass, coordinates));
        let inputs = Inputs {
            q: compiled.assembly.q.clone(),
            v: compiled.assembly.v.clone(),
            phases: compiled.assembly.phases.clone(),
            ..Inputs::default()
        };
        let solution = run(compiled.programs.get(Function::Acceleration), &inputs);
        let (s, c) = (f64::sin(1.0), f64::cos(1.0));
        let expected = s * (4.0 + 9.81 * c) / (mass + s * s);
        let error = (solution[0] / expected - 1.0).abs();
        assert!(error < 1e-11, "{mass:e} kg in {coordinates} coordinates: {error:e}");
        // The force on the cart is the cart's own: the row's multiplier is as small as its mass.
        let row =
            compiled.complete.equations.rows.iter().position(|row| row.of == "pin" && row.form.name == "x");
        let force = solution[compiled.assembly.v.len() + row.expect("the pin holds x")];
        let error = (force.abs() / (mass * expected) - 1.0).abs();
        assert!(error < 1e-9, "{mass:e} kg in {coordinates} coordinates: {force:e}, {error:e}");
    }
}

/// The wider margins of light parts are those of their rounding: mistakes are noticed as they are elsewhere.
#[test]
fn wrong_expressions_are_noticed_beside_a_light_cart() {
    let share = |mass: f64| {
        let (mutants, noticed) = noticed(&assert_sound(&cart(mass, "tree")));
        println!("{mass:e} kg: {noticed} of {mutants} mutants noticed");
        noticed as f64 / mutants as f64
    };
    let ordinary = share(1.0);
    assert!(ordinary > 0.9, "{ordinary}");
    for mass in [1e-3, 1e-6, 1e-9] {
        assert!(share(mass) > ordinary - 0.02, "{mass:e} kg");
    }
    // A sign before 1e-12 kg beside one kilogram is less than what folding may have rounded.
    assert!(share(1e-12) > 0.8);
}
