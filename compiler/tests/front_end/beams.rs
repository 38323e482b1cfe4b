//! Beams: what is warned of, and what is not.

use crate::{bad, warnings};
use linkwright_compiler::compile;
use std::f64::consts::PI;

/// One beam with what it is like, its joints and its start.
fn told(beam: &str, rest: &str) -> Vec<String> {
    let source = format!(
        "planar Beams {{ body press {{ mass [kg] = 200; inertia [kg*m^2] = 1; }}
         joint rail: prismatic(ground(0, 0) [m], press.center, axis = (1, 0));
         beam rod {{ length [m] = 1; section = circle(diameter [mm] = 10); young [GPa] = 210; density [kg/m^3] = 7800; {beam} }} {rest} }}"
    );
    let compiled =
        compile(source.parse().expect("tokens"), None).unwrap_or_else(|errors| panic!("{source}\n{errors}"));
    compiled.warnings.iter().map(|warning| warning.message.clone()).collect()
}

/// π² E I/L² and (1.8751/L)² √(E I/μ) by hand.
const EULER: f64 = 1_017.393_5;
const CLAMPED: f64 = 45.609_27;

#[test]
fn a_thrust_near_eulers_load() {
    let pressed = |part: f64, beam: &str| {
        told(
            beam,
            &format!(
                "joint left: revolute(ground(0, 0) [m], rod.start); joint right: revolute(rod.end, press.center);
                 force push: force(press.center, direction = (1, 0)) = {} [N]; start {{ rod.angle [rad] ~ 0; rail.travel [m] ~ 1; }}",
                -part * EULER
            ),
        )
    };
    for shapes in ["shapes = pinned;", "shapes = free;"] {
        assert!(pressed(0.3, shapes).is_empty() && pressed(-2.0, shapes).is_empty());
        let found = pressed(0.5, shapes);
        assert!(
            found.len() == 1 && found[0].contains("508.7 N at the start, 0.5 of Euler's load, 1017 N"),
            "{found:?}"
        );
        assert!(pressed(0.5, &format!("{shapes} stiffening = on;")).is_empty());
    }
    // A column on a foot has a quarter of it, and an input decides nothing.
    let column = |load: &str| {
        told(
            "shapes = clamped;",
            &format!(
                "input load [N]; joint foot: fixed(ground(0, 0) [m], rod.start);
                 force push: force(rod.end, direction = (1, 0)) = {load}; output load [N] = load;"
            ),
        )
    };
    for little in ["-70 [N]", "-load"] {
        assert_eq!(column(little), Vec::<String>::new(), "{little}");
    }
    let found = column("-127.2 [N]");
    assert!(found.len() == 1 && found[0].contains("0.5 of Euler's load, 254.3 N"), "{found:?}");
}

#[test]
fn a_turn_near_the_first_frequency() {
    let turned = |part: f64, beam: &str| {
        told(
            beam,
            &format!(
                "joint left: revolute(ground(0, 0) [m], rod.start);
                 start {{ left.angle [rad] = 0; left.rate [rad/s] = {}; rail.travel [m] = 0; }}",
                part * CLAMPED
            ),
        )
    };
    assert!(turned(0.3, "").is_empty() && turned(1.2, "stiffening = on;").is_empty());
    assert!(turned(1.2, "modes = (axial = 1, bending = 0);").is_empty());
    let found = turned(-1.2, "");
    assert!(found.len() == 1 && found[0].contains("turns at 54.73 rad/s at the start, 1.2 of"), "{found:?}");
}

#[test]
fn shapes_and_sections_that_do_not_suit() {
    let held = |beam: &str, joint: &str| {
        told(
            beam,
            &format!(
                "joint foot: {joint}(ground(0, 0) [m], rod.start); start {{ rod.angle [rad] ~ 0; rail.travel [m] = 0; }}"
            ),
        )
    };
    for shapes in ["clamped", "static"] {
        let beam = format!("shapes = {shapes}; modes = (bending = 2);");
        assert!(held(&beam, "fixed").is_empty());
        let found = held(&beam, "revolute");
        assert!(
            found.len() == 1 && found[0].contains(&format!("the `{shapes}` shapes of the beam `rod`")),
            "{found:?}"
        );
    }
    assert!(held("", "revolute").is_empty());
    let thick = |mm: f64| {
        let source = format!(
            "planar Thick {{ beam rod {{ length [m] = 1; section = rectangle(height [mm] = {mm}, width [mm] = 10); young [GPa] = 210;
             density [kg/m^3] = 7800; shapes = clamped; point far [m] = (0.9, 0); }}
             joint foot: fixed(ground(0, 0) [m], rod.start); joint tip: distance(ground(0.9, 1) [m], rod.far, length [m] = 1); }}"
        );
        compile(source.parse().expect("tokens"), None)
            .unwrap_or_else(|errors| panic!("{errors}"))
            .warnings
            .to_string()
    };
    // √12 L/h.
    assert_eq!(thick(173.0), "");
    assert!(thick(174.0).contains("is 19.9 radii of gyration √(I/A) long; below 20"), "{}", thick(174.0));
}

/// What is said of a beam in space that holds these.
fn mistakes_in_space(inside: &str, rest: &str) -> String {
    bad(&format!(
        "spatial Beams {{ beam rod {{ length [m] = 1; young [GPa] = 210; density [kg/m^3] = 7800; {inside} }}
         joint base: revolute(ground(0, 0, 0) [m], rod.start, axis = (0, 0, 1)); {rest} }}"
    ))
    .to_string()
}

#[test]
fn what_beams_in_space_are_made_of() {
    let section = "section = circle(diameter [mm] = 10);";
    let with = |more: &str| mistakes_in_space(&format!("{section} {more}"), "");
    for (inside, said) in [
        (
            "modes = (bending = 2);",
            "a beam in space bends two ways: write `bending_y` for what moves along y, and `bending_z`",
        ),
        ("modes = (torsion = 2);", "the beam `rod` has no shear modulus: write `shear_modulus [GPa] = …;`"),
        (
            "modes = (torsion = 2); shear_modulus [GPa] = -80;",
            "the shear modulus of the beam `rod` must be positive, found -8e10",
        ),
        (
            "shear_modulus [GPa] = 80;",
            "the beam `rod` has no modes in torsion, which its shear modulus would resist: write `modes = (bending_y = 3, bending_z = 3, torsion = 2)`",
        ),
        ("modes = (torsion = 13); shear_modulus [GPa] = 80;", "a beam has 0 to 12 torsion modes, found 13"),
        (
            "modes = (torsion = quadratic); shear_modulus [GPa] = 80;",
            "quadratic shapes are there along the axis alone",
        ),
        (
            "modes = (torsion = 2); shear_modulus [GPa] = 80; torsion_constant [mm^4] = 3;",
            "the torsion_constant of `rod` follows from its section",
        ),
        (
            "modes = (torsion = 2); shear_modulus [GPa] = 80; stiffening = on;",
            "write `modes = (bending_y = 3)`, or leave `stiffening` out",
        ),
        ("modes = (bending_x = 2);", "no modes called \"bending_x\"; did you mean `bending_y`?"),
        (
            "modes = 3;",
            "`(bending_y = 2, bending_z = 2)`, or `(axial = 1, bending_y = 2, bending_z = 2, torsion = 1)`",
        ),
        ("modes = (bending_y = 0, axial = 0);", "write `(bending_y = 3)`, or `rod`"),
        (
            "modes = (axial = 2); stiffening = on;",
            "write `modes = (bending_y = 3)`, or leave `stiffening` out",
        ),
        ("marker eye [m] = (0.1, 0, 0);", "a marker on the beam `rod` would have to turn with a section"),
        ("point far [m] = (0.1, 0, 0.2);", "the beam `rod`, whose points are on it"),
        ("inertia [kg*m^2] = (1, 1, 1);", "a beam has no `inertia`"),
    ] {
        let found = with(inside);
        assert!(found.contains(said), "{inside}: {found}");
    }
    assert!(mistakes_in_space("", "").contains(
        "or `area [mm^2] = …;` and `second_moment_z [mm^4] = …;` and `second_moment_y [mm^4] = …;`"
    ));
    let lacking = mistakes_in_space("area [mm^2] = 20; second_moment_z [mm^4] = 30;", "");
    assert!(lacking.contains("the beam `rod` has no second_moment_y"), "{lacking}");
    let lacking = mistakes_in_space(
        "area [mm^2] = 20; second_moment_z [mm^4] = 30; second_moment_y [mm^4] = 30; shear_modulus [GPa] = 80; modes = (torsion = 1);",
        "",
    );
    assert!(
        lacking.contains("the beam `rod` has no torsion constant: write `torsion_constant [mm^4] = …;`"),
        "{lacking}"
    );
    let twisting = format!("{section} modes = (torsion = 2); shear_modulus [GPa] = 80;");
    let angle = mistakes_in_space(&twisting, "output twist [mm] = rod.torsion[1];");
    assert!(angle.contains("an angle"), "{angle}");
    let mode = mistakes_in_space(&twisting, "output twist [rad] = rod.torsion[2];");
    assert!(mode.contains("it has `rod.torsion[0]` to `rod.torsion[1]`, each with `.rate`"), "{mode}");
    let mode = mistakes_in_space(section, "output bent [mm] = rod.bending[0];");
    assert!(mode.contains("`rod` has no mode `rod.bending[0]`; it has `rod.bending_y[0]`"), "{mode}");
    let mode = mistakes_in_space(section, "output bent [mm] = rod.bending_y[3];");
    assert!(
        mode.contains(
            "it has `rod.bending_y[0]` to `rod.bending_y[2]` and `rod.bending_z[0]` to `rod.bending_z[2]`"
        ),
        "{mode}"
    );
    let torque = mistakes_in_space(section, "torque turn: torque(rod) = (1 [N*m], 0 [N*m], 0 [N*m]);");
    assert!(torque.contains("a torque on the beam `rod` bends it where it acts"), "{torque}");
}

#[test]
fn modes_in_the_plane() {
    for (modes, said) in [
        ("(torsion = 2)", "` needs a beam in space; in the plane there are `axial` and `bending`"),
        ("3", "`(bending = 3)`, or `(axial = 1, bending = 3)`"),
    ] {
        let found = bad(&format!("planar Beams {{ beam rod {{ modes = {modes}; }} }}")).to_string();
        assert!(found.contains(said), "{modes}: {found}");
    }
}

#[test]
fn warnings_of_beams_in_space() {
    let told = |beam: &str, rest: &str| {
        let source = format!(
            "spatial Beams {{ beam rod {{ length [m] = 1; section = rectangle(height [mm] = 10, width [mm] = 30); young [GPa] = 210;
             density [kg/m^3] = 7800; {beam} }} {rest} }}"
        );
        let compiled = compile(source.parse().expect("tokens"), None)
            .unwrap_or_else(|errors| panic!("{source}\n{errors}"));
        compiled.warnings.to_string()
    };
    // (1.8751/L)² √(E h²/12 ρ) about the softer axis, 10 mm.
    let natural = 52.665_17;
    let turned = |part: f64, beam: &str| {
        told(
            beam,
            &format!(
                "joint left: revolute(ground(0, 0, 0) [m], rod.start, axis = (0, 1, 0));
                 start {{ left.angle [rad] = 0; left.rate [rad/s] = {}; }}",
                part * natural
            ),
        )
    };
    assert_eq!(turned(0.3, "") + &turned(0.5, "stiffening = on;"), "");
    let about_its_axis = "joint left: revolute(ground(0, 0, 0) [m], rod.start, axis = (1, 0, 0));
                          start { left.angle [rad] = 0; left.rate [rad/s] = 200; }";
    assert_eq!(told("", about_its_axis), "");
    assert!(
        turned(0.5, "").contains("0.5 of its first clamped frequency, 52.67 rad/s"),
        "{}",
        turned(0.5, "")
    );
    // A quarter of π² E I/L².
    let euler = 0.25 * 9.869_604_401 * 210e9 * 0.03 * 0.01_f64.powi(3) / 12.0;
    let column = |part: f64| {
        told(
            "shapes = clamped;",
            &format!(
                "joint foot: fixed(ground(0, 0, 0) [m], rod.start);
                 force push: force(rod.end) = ({} [N], 0 [N], 0 [N]);",
                -part * euler
            ),
        )
    };
    assert_eq!(column(0.3), "");
    assert!(column(0.5).contains("0.5 of Euler's load"), "{}", column(0.5));
    let thick = told("modes = (bending_y = 1);", "joint foot: spherical(ground(0, 0, 0) [m], rod.start);");
    assert_eq!(thick, "");
}

#[test]
fn motors_clamp() {
    // In the plane: all that passes a moment about the joint or the beam.
    let held = |more: &str| {
        let rest = format!(
            "disk gear {{ mass [kg] = 1; radius [m] = 0.1; }} joint hub: revolute(ground(2, 0) [m], gear.center);
             joint foot: revolute(ground(0, 0) [m], rod.start); start {{ rail.travel [m] = 0; }} {more}"
        );
        told("shapes = clamped; modes = (bending = 2);", &rest)
    };
    let start = "start { rod.angle [rad] = 0; hub.angle [rad] = 0; }";
    for holds in [
        "torque motor: torque(foot) = 1 [N*m];",
        "torque motor: torque(rod) = 1 [N*m];",
        "torsion_spring back: torsion_spring(foot, stiffness [N*m/rad] = 10);",
        "gear pair: gear(foot, hub, ratio = -2); start { hub.angle [rad] = 0; }",
        "drive swing: foot.angle = 0.1 [rad]*sin(2*pi*time/(1 [s])); start { hub.angle [rad] = 0; }",
        "constraint tied: foot.angle - hub.angle = 0 [rad]; start { hub.angle [rad] = 0; }",
    ] {
        let more = if holds.contains("start") { holds.to_string() } else { format!("{holds} {start}") };
        assert_eq!(held(&more), Vec::<String>::new(), "{holds}");
    }
    for lets in [
        "",
        "friction rub: on(foot) = coulomb(coefficient = 0.2, radius [m] = 0.01, speed [rad/s] = 0.05);",
        "torque motor: torque(hub) = 1 [N*m];",
    ] {
        let found = held(&format!("{lets} {start}"));
        let said = "lets that turn freely about z of the beam: no moment passes there";
        assert!(found.len() == 1 && found[0].contains(said), "{lets}: {found:?}");
        assert!(found[0].contains("or the motor of the joint, `torque motor: torque(foot) = …;`, or `#[allow(slender)]` before it"), "{found:?}");
    }
    // In space: about which axis of the beam, and whether it bends there.
    let held = |modes: &str, joint: &str, more: &str| {
        let source = format!(
            "spatial Arms {{ beam rod {{ length [m] = 1; section = circle(diameter [mm] = 10); young [GPa] = 210; density [kg/m^3] = 7800;
             shapes = static; modes = ({modes}); {} }} joint foot: {joint}; {more} }}",
            if modes == "torsion = 1" { "shear_modulus [GPa] = 80;" } else { "" }
        );
        let compiled = compile(source.parse().expect("tokens"), None)
            .unwrap_or_else(|errors| panic!("{source}\n{errors}"));
        compiled.warnings.iter().map(|warning| warning.message.clone()).collect::<Vec<_>>().join("; ")
    };
    let both = "bending_y = 1, bending_z = 1";
    let twist = "torsion = 1";
    let revolute = |axis: &str| format!("revolute(ground(0, 0, 0) [m], rod.start, axis = {axis})");
    let cross = "universal(ground(0, 0, 0) [m], rod.start, axis = (0, 1, 0), second_axis = (0, 0, 1))";
    let torque = "torque motor: torque(foot) = 1 [N*m];";
    let [one, two] = [1, 2].map(|k| format!("drive motor_{k}: foot.angle_{k} = 0 [rad];"));
    let ball = "spherical(ground(0, 0, 0) [m], rod.start)";
    for (modes, joint, more, about) in [
        (both, revolute("(1, 0, 0)"), "", None),
        (both, revolute("(0, 0, 2)"), "", Some("z")),
        ("bending_z = 1", revolute("(0, 0, 2)"), "", None),
        (both, revolute("(3, 1, 0)"), "", Some("y")),
        ("bending_y = 1", revolute("(3, 1, 0)"), "", None),
        (both, revolute("(0, 0, 1)"), torque, None),
        (both, cross.to_string(), &two, Some("z")),
        (both, cross.to_string(), &one, Some("z")),
        ("bending_z = 1", cross.to_string(), &one, None),
        (both, cross.to_string(), &format!("{one} {two}"), None),
        (both, ball.to_string(), "", Some("z")),
        (twist, revolute("(1, 0, 0)"), "", Some("x")),
        (twist, revolute("(0, 0, 2)"), "", None),
        (twist, revolute("(1, 0, 0)"), torque, None),
        (twist, cross.to_string(), "", None),
        (both, ball.to_string(), "torque motor: torque(rod) = (0 [N*m], 1 [N*m], 0 [N*m]);", None),
    ] {
        let found = held(modes, &joint, more);
        match about {
            None => assert_eq!(found, "", "{modes} {joint} {more}"),
            Some(axis) => {
                assert!(
                    found.contains(&format!("turn freely about {axis} of the beam")),
                    "{joint} {more}: {found}"
                );
                assert_eq!(found.contains("torque(foot)"), joint.contains("revolute"), "{found}");
            }
        }
    }
}

#[test]
fn columns_whose_heads_sway() {
    // A quarter of π² E I/L² where the foot is held and the head carries what nothing else holds; all of it where the head is guided.
    let quarter = 0.25 * EULER;
    let pressed = |foot: &str, rest: &str, newtons: f64| {
        told(
            "shapes = clamped;",
            &format!(
                "{foot} body load {{ mass [kg] = 1; inertia [kg*m^2] = 1e-2; }} joint hold: revolute(rod.end, load.center);
                 torque turn: torque(hold) = 0.01 [N*m];
                 force push: force(load.center, direction = (1, 0)) = {} [N]; {rest}",
                -newtons
            ),
        )
    };
    let foot = "joint foot: fixed(ground(0, 0) [m], rod.start);";
    let motor = "joint foot: revolute(ground(0, 0) [m], rod.start); drive still: foot.angle = 0 [rad];";
    let rest = "start { hold.angle [rad] = 0; rail.travel [m] = 2; }";
    for held in [foot, motor] {
        assert_eq!(pressed(held, rest, 0.3 * quarter), Vec::<String>::new());
        let found = pressed(held, rest, 0.5 * quarter);
        assert!(found.len() == 1 && found[0].contains("0.5 of Euler's load, 254.3 N"), "{found:?}");
    }
    let guided =
        "joint slot: prismatic(press.center, load.center, axis = (0, 1)); start { rail.travel [m] ~ 1; }";
    assert_eq!(pressed(foot, guided, 0.3 * EULER), Vec::<String>::new());
}

#[test]
fn frequencies_that_are_expected() {
    let with = |expectation: &str| {
        compile(
            format!(
                "planar Beams {{ beam rod {{ length [m] = 1; section = circle(diameter [mm] = 10); young [GPa] = 210; density [kg/m^3] = 7800;
                 shapes = pinned; }} body sled {{ mass [kg] = 1; inertia [kg*m^2] = 1; }}
                 joint pin: revolute(ground(0, 0) [m], rod.start); joint hook: revolute(rod.end, sled.center);
                 joint rail: prismatic(ground(0, 0) [m], sled.center, axis = (1, 0));
                 start {{ rod.angle [rad] ~ 0.1; rail.travel [m] ~ 1; }} expect {{ {expectation} }} }}"
            )
            .parse()
            .expect("tokens"),
            None,
        )
        .map_or_else(|errors| errors.to_string(), |_| String::new())
    };
    // π/2 √(E d²/(16 ρ L⁴)), four times that, and nine times.
    let first = PI / 2.0 * (210e9 * 1e-4 / 16.0 / 7800.0_f64).sqrt();
    for (mode, times) in [(0, 1.0), (1, 4.0), (2, 9.0)] {
        let [below, above] = [0.9999, 1.0001].map(|part| part * times * first);
        assert_eq!(with(&format!("frequency(rod.bending[{mode}]) >= {below} [Hz];")), "");
        assert_eq!(with(&format!("frequency(rod.bending[{mode}]) <= {above} [Hz];")), "");
        let missed = with(&format!("frequency(rod.bending[{mode}]) >= {above} [Hz];"));
        assert!(
            missed.contains(
                " Hz expected: change the section, the length or the material, or the finite element model"
            ),
            "{missed}"
        );
        let missed = with(&format!("frequency(rod.bending[{mode}]) <= {below} [Hz];"));
        assert!(missed.contains("Hz by itself, more than the"), "{missed}");
    }
    for (expectation, said) in [
        ("frequency(rod.bending[3]) >= 1 [Hz];", "`rod` has no mode `rod.bending[3]`"),
        (
            "frequency(rail.travel) >= 1 [Hz];",
            "` is no mode of a body that deforms, which has a frequency by itself: write `frequency(coupler.bending[0]) >= 200 [Hz]`",
        ),
        ("frequency(rod.bending[0]) = 1 [Hz];", "expected `>=` or `<=` and a frequency"),
        ("frequency(rod.bending[0]) >= 1 [m];", "frequency is given a length: expected 1/s, found m"),
        ("frequency(rod.bending[0], 2) >= 1 [Hz];", "expected `)`"),
        ("frequency() >= 1 [Hz];", "expected a mode, such as `coupler.bending[0]`"),
    ] {
        let found = with(expectation);
        assert!(found.contains("error") && found.contains(said), "{expectation}: {found}");
    }
}

/// What the ground clamps has shapes that know of a clamp, at the end that it clamps.
#[test]
fn clamps_of_the_ground_are_known() {
    let told = |shapes: &str, joints: &str| {
        let source = format!(
            "planar Cantilever {{ gravity [m/s^2] = (0, -9.81); beam rod {{ length [m] = 1; section = circle(diameter [mm] = 10); young [GPa] = 210;
             density [kg/m^3] = 7800; {shapes} }} {joints} output y [m] = rod.center.y; }}"
        );
        warnings(&source).to_string()
    };
    let (start, end) =
        ("joint foot: fixed(ground(0, 0) [m], rod.start);", "joint foot: fixed(ground(0, 0) [m], rod.end);");
    for joints in [start, end] {
        let found = told("", joints);
        let said = "the `free` shapes of the beam `rod` bend as if nothing clamped it, and `foot` does: a few of them lack a third of how far a \
            force at the other end deflects it. Write `shapes = clamped;` or `static`, whose start is where it is clamped, or `#[allow(slender)]` \
            before it";
        assert!(found.contains(said), "{found}");
    }
    for shapes in ["clamped", "static"] {
        let written = format!("shapes = {shapes};");
        assert_eq!(told(&written, start), "", "{shapes}");
        let found = told(&written, end);
        let said = format!(
            "the `{shapes}` shapes of the beam `rod` are clamped at its start, where nothing holds it, and `foot` clamps its end: let it begin \
             there, with `start` and `end` exchanged, or write `#[allow(slender)]` before it"
        );
        assert!(found.contains(&said), "{found}");
    }
}

#[test]
fn a_start_is_no_further_off_than_the_beam_is_long() {
    let source = |bending: &str| {
        format!(
            "planar Far {{ beam b {{ length [m] = 1; section = circle(diameter [mm] = 10); young [GPa] = 210; density [kg/m^3] = 7800; shapes = clamped; }}
             joint c: fixed(ground(0, 0), b.start); start {{ b.bending[0] [mm] = {bending}; }} }}"
        )
    };
    let found = bad(&source("1e6")).to_string();
    let expected = "`b.bending[0]` starts at 1000 m, and `b` is 1 m long: what bends is off its axis by small parts of its length";
    assert!(found.contains(expected), "{found}");
    crate::good(&source("-200"));
}

#[test]
fn points_are_listed_once() {
    let found = bad("planar Point { beam b { length [m] = 1; section = circle(diameter [mm] = 10); young [GPa] = 210; density [kg/m^3] = 7800; }
        joint c: revolute(ground(0, 0), b.middle); }");
    assert!(
        found.to_string().contains("`b` has no point called \"middle\"; it has center, end, origin, start"),
        "{found}"
    );
}
