//! Beams that start as their loads bend them, and what is expected of that.

use crate::bad;
use linkwright_compiler::compile;

/// What is said of a beam of 1 m, E I = 1400 N m² and 16.2 N/m of weight (a height of 20 mm), with these shapes and the rest.
fn told(beam: &str, rest: &str) -> String {
    let source = format!(
        "planar Beams {{ gravity [m/s^2] = (0, -10);
         beam arm {{ length [m] = 1; section = rectangle(height [mm] = 20, width [mm] = 30); young [GPa] = 70; density [kg/m^3] = 2700; {beam} }}
         {rest} }}"
    );
    compile(source.parse().expect("tokens"), None).map_or_else(|errors| errors.to_string(), |_| String::new())
}

/// That a place is off by this, to a part.
fn off(place: &str, expected: f64, part: f64) -> String {
    let [less, more] = [1.0 - part, 1.0 + part].map(|part| part * expected);
    format!("expect {{ deflection({place}) >= {less} [m]; deflection({place}) <= {more} [m]; }}")
}

const RIGIDITY: f64 = 70e9 * 0.03 * 8e-6 / 12.0;
const WEIGHT: f64 = 2700.0 * 0.02 * 0.03 * 10.0;

/// q L⁴/8 E I and 17 q L⁴/384 E I, F L³/3 E I; 4 q L⁴/π⁵ E I of a sine.
#[test]
fn deflections_are_closed() {
    let foot = "joint foot: fixed(ground(0, 0) [m], arm.start); start { arm = static; }";
    let exact = "shapes = static; modes = (bending = 3);";
    let sag = WEIGHT / (8.0 * RIGIDITY);
    assert_eq!(told(exact, &format!("{foot} {}", off("arm.end", sag, 1e-9))), "");
    assert_eq!(told(exact, &format!("{foot} {}", off("arm.center", 17.0 / 48.0 * sag, 1e-9))), "");
    let pushed = "force push: force(arm.end) = (3, 50) [N];";
    let bent = 50.0 / (3.0 * RIGIDITY) - sag;
    assert_eq!(told(exact, &format!("{foot} {pushed} {}", off("arm.end", bent, 1e-9))), "");
    // Modes of vibration only sum up to it.
    let modes = "shapes = clamped; modes = (bending = 12);";
    assert_eq!(told(modes, &format!("{foot} {}", off("arm.end", sag, 1e-5))), "");
    // The frame of `free` shapes is the mean of the beam: w less the straight line with its mass and its moment, sag/15 at both ends.
    let free = "shapes = free; modes = (bending = 12);";
    assert_eq!(told(free, &format!("{foot} {}", off("arm.end", sag / 15.0, 5e-3))), "");
    let hinges = "joint left: revolute(ground(0, 0) [m], arm.start); joint right: revolute(arm.end, sled.center);
                  body sled { mass [kg] = 1; inertia [kg*m^2] = 1; } joint rail: prismatic(ground(0, 0) [m], sled.center, axis = (1, 0));
                  start { arm = static; arm.angle [rad] ~ 0; rail.travel [m] ~ 1; }";
    let sine = 4.0 * WEIGHT / (std::f64::consts::PI.powi(5) * RIGIDITY);
    let pinned = "shapes = pinned; modes = (bending = 1);";
    assert_eq!(told(pinned, &format!("{hinges} {}", off("arm.center", sine, 1e-9))), "");
    // A thrust of half of Euler's load doubles it, and one as large as that finds nothing.
    let euler = std::f64::consts::PI.powi(2) * RIGIDITY;
    let pressed =
        |part: f64| format!("{hinges} force push: force(sled.center) = ({}, 0) [N];", -part * euler);
    let soft = "shapes = pinned; modes = (bending = 1); stiffening = on;";
    assert_eq!(told(soft, &format!("{} {}", pressed(0.5), off("arm.center", 2.0 * sine, 1e-4))), "");
}

/// A driven blade with stiffening: (K + ω² (G₁ − M)) p = ∫ μ g N at any rate, far beyond its first frequency.
#[test]
fn a_blade_that_turns_starts_without_swinging() {
    let turned = |rate: f64, more: &str| {
        told(
            "shapes = clamped; modes = (bending = 1); stiffening = on;",
            &format!(
                "body hub {{ mass [kg] = 1; inertia [kg*m^2] = 1; }} joint axle: revolute(ground(0, 0) [m], hub.center);
                 joint root: fixed(hub.center, arm.start); drive turn: axle.angle = {rate} [rad/s] * time;
                 start {{ arm = static; }} {more}"
            ),
        )
    };
    // λ⁴ E I/m L³ at rest, and for each (rad/s)² of the turn 1.193 more less 1 (Southwell's coefficient of one clamped shape).
    let natural = 1.875_104_068_711_961_f64.powi(4) * RIGIDITY / (WEIGHT / 10.0);
    let mean = 0.782_991_8;
    for rate in [0.0, 60.0, 300.0] {
        let sag = 2.0 * 10.0 * mean / (natural + 0.193_371 * rate * rate);
        assert_eq!(turned(rate, &off("arm.end", sag, 2e-3)), "", "{rate}");
    }
}

#[test]
fn starts_that_are_not_static() {
    let foot = "joint foot: fixed(ground(0, 0) [m], arm.start);";
    for (start, said) in [
        ("arme = static;", "no beam or flexible body called \"arme\"; did you mean \"arm\"?"),
        (
            "q = static;",
            "no beam or flexible body called \"q\": only what deforms can start as its loads bend it",
        ),
        (
            "load = static;",
            "`load` is rigid, and nothing bends it: leave `load = static` out, or declare it as a `beam`",
        ),
        (
            "arm = static; arm.bending[0] [mm] = 1;",
            "`arm.bending[0]` is stated, and `arm = static` finds it: leave one of them out",
        ),
        ("arm = static; arm = static;", "`arm` of `start` is given twice"),
        ("arm ~ static;", "error"),
    ] {
        let rest = format!(
            "{foot} body load {{ mass [kg] = 1; inertia [kg*m^2] = 1; }} joint top: fixed(arm.end, load.center); start {{ {start} }}"
        );
        let found = told("shapes = clamped;", &rest);
        assert!(found.contains(said), "{start}: {found}");
    }
    let both = "joint left: fixed(ground(0, 0) [m], arm.start); joint right: fixed(sled.center, arm.end);
                body sled { mass [kg] = 1; inertia [kg*m^2] = 1; } joint rail: prismatic(ground(0, 0) [m], sled.center, axis = (1, 0));
                start { arm = static; arm.angle [rad] ~ 0; rail.travel [m] ~ 1; }";
    let found = told("modes = (bending = 5);", both);
    assert!(
        found.contains("cannot start as its loads bend it: its joints do not let `arm.bending["),
        "{found}"
    );
}

#[test]
fn what_start_states_holds_too() {
    let ends = "joint left: revolute(ground(0, 0) [m], arm.start); joint right: point_on_line(line(ground(0, 0), ground(1, 0) [m]), arm.end);
                start { arm = static; left.angle [rad] = 0; }";
    let found = told("shapes = pinned; modes = (bending = 5);", ends);
    let said = "cannot start as its loads bend it: with `left.angle` as `start` states it and the joints closed, `arm.bending[";
    assert!(
        found.contains(said)
            && found.contains("Make that a guess (`~` in place of `=`), or leave `arm = static` out"),
        "{found}"
    );
}

#[test]
fn expectations_on_deflections() {
    let foot = "joint foot: fixed(ground(0, 0) [m], arm.start); body load { mass [kg] = 1; inertia [kg*m^2] = 1; } joint top: fixed(arm.end, load.center);";
    for (start, expectation, said) in [
        (
            "",
            "deflection(arm.end) >= 1 [mm];",
            "`arm.end` is 0 m off the axis of its frame at the start, less than the 0.001 m expected",
        ),
        (
            "",
            "deflection(arm.end) >= 1 [mm];",
            "write `start { arm = static; }` for what its loads bend it by, or change its modes there",
        ),
        (
            "arm = static;",
            "deflection(arm.end) <= 1 [mm];",
            "more than the 0.001 m expected: change the section, the length or the material",
        ),
        (
            "",
            "deflection(load.center) <= 1 [mm];",
            "`load.center` is on no beam, whose places are off its axis: write `deflection(arm.end) <= 3 [mm]` of a `beam arm`",
        ),
        ("", "deflection(arm.tip) <= 1 [mm];", "tip"),
        (
            "",
            "deflection(arm.end) = 1 [mm];",
            "expected `>=` or `<=` and a length, such as `deflection(arm.end) <= 3 [mm]`",
        ),
        ("", "deflection(arm.end) <= 1 [N];", "deflection is given a force: expected m, found N"),
        ("", "deflection(arm.end, 1) <= 1 [mm];", "expected `)`"),
    ] {
        let found =
            told("shapes = clamped;", &format!("{foot} start {{ {start} }} expect {{ {expectation} }}"));
        assert!(found.contains("error") && found.contains(said), "{expectation}: {found}");
    }
    assert!(
        bad("planar A { expect { deflection() <= 1 [mm]; } }")
            .to_string()
            .contains("expected a point of a beam, such as `arm.end`")
    );
}
