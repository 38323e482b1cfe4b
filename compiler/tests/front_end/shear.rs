//! Beams whose sections shear: what they need, and their frequencies.

use linkwright_compiler::compile;
use std::f64::consts::{PI, TAU};

fn told(space: &str, beam: &str, rest: &str) -> String {
    let source =
        format!("{space} Beams {{ beam rod {{ length [m] = 1; young [GPa] = 210; {beam} }} {rest} }}");
    compile(source.parse().expect("tokens"), None)
        .map_or_else(|errors| errors.to_string(), |compiled| compiled.warnings.to_string())
}

fn near(mode: usize, hertz: f64) -> String {
    let [less, more] = [hertz * (1.0 - 1e-9), hertz * (1.0 + 1e-9)];
    format!("frequency(rod.bending[{mode}]) >= {less} [Hz]; frequency(rod.bending[{mode}]) <= {more} [Hz];")
}

/// A cantilever with κ = 5/6 by an independent computation, and Timoshenko's own formula of a bar on two hinges with Cowper's κ of each section.
#[test]
fn frequencies_are_known() {
    let steel = "density [kg/m^3] = 7850; shear_modulus [Pa] = 210e9/2.6; theory = timoshenko;";
    let foot = "joint foot: fixed(ground(0, 0) [m], rod.start);";
    let rates = [520.840641723, 3121.577765398, 8210.226133092];
    let all: String = rates.iter().enumerate().map(|(mode, rate)| near(mode, rate / TAU)).collect();
    let beam = format!(
        "section = rectangle(height [mm] = 100, width [mm] = 50); shear_factor = 5/6; shapes = clamped; {steel}"
    );
    assert_eq!(told("planar", &beam, &format!("{foot} expect {{ {all} }}")), "");
    let nu = 0.3;
    let hollow = 0.36_f64;
    let tube = 6.0 * (1.0 + nu) * (1.0 + hollow).powi(2)
        / ((7.0 + 6.0 * nu) * (1.0 + hollow).powi(2) + (20.0 + 12.0 * nu) * hollow);
    for (section, gyration, factor) in [
        ("circle(diameter [mm] = 80)", 0.0064 / 16.0, 6.0 * (1.0 + nu) / (7.0 + 6.0 * nu)),
        ("tube(outer [mm] = 100, inner [mm] = 60)", 0.01 * (1.0 + hollow) / 16.0, tube),
        (
            "rectangle(height [mm] = 90, width [mm] = 10)",
            0.0081 / 12.0,
            10.0 * (1.0 + nu) / (12.0 + 11.0 * nu),
        ),
    ] {
        let (r2, s2) = (gyration, gyration * 2.6 / factor);
        let rate = |k: f64| {
            let p = 1.0 + k * k * PI * PI * (r2 + s2);
            let square = (p - (p * p - 4.0 * r2 * s2 * (k * PI).powi(4)).sqrt()) / (2.0 * r2 * s2);
            (square * 210e9 * gyration / 7850.0).sqrt() / TAU
        };
        let hinges = "body sled { mass [kg] = 1; inertia [kg*m^2] = 1; } joint pin: revolute(ground(0, 0) [m], rod.start);
                      joint hook: revolute(rod.end, sled.center); joint rail: prismatic(ground(0, 0) [m], sled.center, axis = (1, 0));
                      start { rod.angle [rad] ~ 0.1; rail.travel [m] ~ 1; }";
        let all: String = (0..3).map(|mode| near(mode, rate(mode as f64 + 1.0))).collect();
        let beam = format!("section = {section}; shapes = pinned; {steel}");
        assert_eq!(told("planar", &beam, &format!("{hinges} expect {{ {all} }}")), "", "{section}");
    }
}

#[test]
fn what_they_need() {
    let circle = "section = circle(diameter [mm] = 80); mass [kg] = 1;";
    let stated = "area [mm^2] = 500; second_moment [mm^4] = 3e5; mass [kg] = 1;";
    let foot = "joint foot: fixed(ground(0, 0) [m], rod.start); param soft [GPa] = 80; param big [mm^2] = 500; output soft [GPa] = soft; output big [mm^2] = big;";
    for (beam, said) in [
        (format!("{circle} theory = timoshenco;"), "no theory of beams called \"timoshenco\"; did you mean `timoshenko`?"),
        (format!("{circle} theory = vlasov;"), "no theory of beams called \"vlasov\"; there are `euler_bernoulli`, `timoshenko`."),
        (format!("{circle} theory = timoshenko; theory = timoshenko;"), "`theory` of `rod` is given twice"),
        (format!("{circle} theory = timoshenko;"), "the beam `rod` has no shear modulus: write `shear_modulus [GPa] = …;`"),
        (format!("{circle} theory = timoshenko; shear_modulus [GPa] = 80; shapes = static;"), "`static` shapes are the deflections of beams that do not shear, and the beam `rod` has `theory = timoshenko`: write `shapes = clamped;`"),
        (format!("{circle} theory = timoshenko; shear_modulus = soft;"), "with `theory = timoshenko` the shear modulus of the beam `rod` must be a number at expansion, because its shapes depend on it: write a `const`"),
        ("area = big; second_moment [mm^4] = 3e5; mass [kg] = 1; theory = timoshenko; shear_modulus [GPa] = 80; shear_factor = 0.5;".to_string(), "the area of the beam `rod` must be a number at expansion"),
        (format!("{stated} theory = timoshenko; shear_modulus [GPa] = 80;"), "the beam `rod` shears and has no section with a known shear factor: write `shear_factor = 0.83;`, that of its section (5/6 of a rectangle, 0.9 of a circle, 0.5 of a thin tube)"),
        (format!("{circle} theory = timoshenko; shear_modulus [GPa] = 80; shear_factor = 1.2;"), "the shear factor of the beam `rod` must be above 0 and at most 1, found 1.2: it is the part of the section that carries shear"),
        (format!("{circle} theory = timoshenko; shear_modulus [GPa] = 60;"), "Young's modulus and the shear modulus of the beam `rod` are those of Poisson's ratio E/(2 G) - 1 = 0.75, and no isotropic material has less than -1 or more than 0.5"),
        (format!("{circle} shear_factor = 0.9;"), "the beam `rod` does not shear, which its shear factor would be for: write `theory = timoshenko;`, or leave `shear_factor` out"),
        (format!("{circle} shear_modulus [GPa] = 80;"), "the beam `rod` does not shear, which its shear modulus would be for"),
        ("section = circle(diameter [mm] = 200); mass [kg] = 1; theory = timoshenko; shear_modulus [GPa] = 80; modes = (bending = 12);".to_string(), "has 12 bending modes, of which only 7 are below the frequency √(κ G A/(ρ I)) at which its sections shear by themselves: write `bending = 7`, or a thinner beam"),
    ] {
        let found = told("planar", &beam, foot);
        assert!(found.contains(said), "{beam}: {found}");
    }
    // Thick ones are not warned of where they shear.
    let thick = "section = circle(diameter [mm] = 400); mass [kg] = 1; theory = timoshenko; shear_modulus [GPa] = 80; modes = (bending = 1);";
    assert!(!told("planar", thick, foot).contains("radii of gyration"));
}
