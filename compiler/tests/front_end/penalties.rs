//! Joints that yield: their mistakes, what stands for their rows, and how fast they vibrate.

use crate::{bad, good};
use linkwright_compiler::compile;
use linkwright_compiler::model::{Coordinates, LoadId};

/// A body on a joint to the ground, with these statements.
fn hung(joint: &str, more: &str) -> String {
    format!(
        "planar Hung {{ body arm {{ mass [kg] = 2; inertia [kg*m^2] = 0.5; point end [m] = (1, 0); }} joint top: {joint}; {more} }}"
    )
}

const PIN: &str = "revolute(ground(0, 0) [m], arm.origin)";

#[test]
fn one_message_for_each_mistake() {
    let pin = |arguments: &str| hung(&format!("{PIN} = penalty({arguments})"), "");
    for (source, expected) in [
        (pin("stiffness [N/m] = 0"), "the stiffness of `top` must be positive, found 0"),
        (pin("stiffness [N/m] = -5"), "the stiffness of `top` must be positive, found -5"),
        (
            pin("stiffness [N/m] = 5, damping [N*s/m] = -1"),
            "the damping of `top` is negative: -1 N*s/m; it must be zero or more",
        ),
        (
            pin(""),
            "`top`, a revolute joint, holds shifts, and nothing says how stiffly: write `stiffness [N/m] = …` in its `penalty(…)`",
        ),
        (
            pin("stiffness [N/m] = 5, torsional_damping [N*m*s/rad] = 1"),
            "`torsional_damping` has no use: `top`, a revolute joint, holds no turns; leave it out",
        ),
        (pin("stiffness [N*m/rad] = 5"), "stiffness is given a torque or energy: expected N/m, found N*m"),
        (pin("stiffness [N/m] = 5, stiffness [N/m] = 6"), "`stiffness` of `penalty` is given twice"),
        (
            pin("stiffness [N/m] = 5, damping_along = line"),
            "`damping_along` says how damping acts, and `top` has none: write `damping [N*s/m] = …` too, or leave it out",
        ),
        (
            pin("stiffness [N/m] = 5, damping [N*s/m] = 1, damping_along = line"),
            "damping along a line has no value where the places of `top` coincide: write `smallest [m] = …`, the distance below which it fades, well below \
             force/stiffness",
        ),
        (
            pin("stiffness [N/m] = 5, damping [N*s/m] = 1, smallest [m] = 1e-3"),
            "`smallest` is the distance below which damping along a line fades, and that of `top` acts along all axes: write `damping_along = line` too, or leave it out",
        ),
        (
            pin("stiffness [N/m] = 5, damping [N*s/m] = 1, damping_along = axes, smallest [m] = 1e-3"),
            "this is a word: `line`",
        ),
        (
            hung("fixed(ground(0, 0) [m], arm.end) = penalty(stiffness [N/m] = 5)", ""),
            "`top`, a fixed joint, holds turns, and nothing says how stiffly: write `torsional_stiffness [N*m/rad] = …` in its `penalty(…)`",
        ),
        (
            hung("parallel(ground(0, 0) [m], arm.end) = penalty(stiffness [N/m] = 5, torsional_stiffness [N*m/rad] = 1)", ""),
            "`stiffness` has no use: `top`, a parallel joint, holds no shifts; leave it out",
        ),
        (
            hung(
                "prismatic(ground(0, 0) [m], arm.end, axis = (1, 0)) = penalty(stiffness [N/m] = 5, torsional_stiffness [N*m/rad] = 1, damping_along = line)",
                "",
            ),
            "damping along the line between two places needs a joint that keeps these together, and `top`, a prismatic joint, lets them part: leave \
             `damping_along` out",
        ),
        (
            hung("distance(ground(0, 0) [m], arm.end, length [m] = 1) = penalty(stiffness [N/m] = 5)", ""),
            "a distance that yields is a spring: write `spring top: spring(place, place, stiffness [N/m] = …, damping [N*s/m] = …, length [m] = …);` in place of the joint",
        ),
        (
            hung("cord(ground(0, 0) [m], arm.end, length [m] = 1) = penalty(stiffness [N/m] = 5)", ""),
            "a cord that yields is a cable, which pulls as it is stretched: write `cable top: cable(place, place, stiffness [N] = …, length [m] = …);` in place of the joint",
        ),
        (
            hung(&format!("{PIN} = spring(stiffness [N/m] = 5)"), ""),
            "a joint holds, or yields by `= penalty(stiffness [N/m] = …, damping [N*s/m] = …);`, with `torsional_stiffness [N*m/rad]` where it holds a turn",
        ),
        (
            hung(&format!("{PIN} = penalty(stiffness [N/m] = 5) = penalty(stiffness [N/m] = 5)"), ""),
            "expected `;`, found `=`",
        ),
        (
            hung(&format!("{PIN} = penalty(stiffness [N/m] = 5)"), "options { cut = top; }"),
            "`top` yields by its `penalty`, and carries no body that a cut could free: leave it out of `cut`",
        ),
        (
            "spatial Wound { body nut { mass [kg] = 1; inertia [kg*m^2] = (1, 1, 1); }
             joint top: screw(ground(0, 0, 0) [m], nut.origin, axis = (0, 0, 1), pitch [m] = 0.01)
                 = penalty(stiffness [N/m] = 5, torsional_stiffness [N*m/rad] = 5); }"
                .to_string(),
            "`top` is a screw, whose travel follows an angle counted over its turns, and a penalty counts none: write `cylindrical(…) = penalty(…)` and \
             a `constraint` or a load between travel and angle",
        ),
        (
            "planar Bowed { beam bar { length [m] = 1; section = circle(diameter [mm] = 20); young [GPa] = 210; density [kg/m^3] = 7850; modes = (bending = 1); }
             joint top: revolute(ground(0, 0) [m], bar.start) = penalty(stiffness [N/m] = 5); }"
                .to_string(),
            "`top` yields by its `penalty`, and `bar.start` is on a body that bends, which no penalty knows yet: put a small body there with `fixed`, and \
             the penalty between that and the rest",
        ),
    ] {
        let diagnostics = bad(&source);
        let messages: Vec<String> = diagnostics.iter().map(|one| one.message.clone()).collect();
        assert_eq!(messages, [expected], "of {source}");
    }
}

#[test]
fn a_joint_that_yields_has_a_load_behind_all_others() {
    let mechanism = good(&hung(
        &format!("{PIN} = penalty(stiffness [N/m] = 5)"),
        "limit stop: arm.angle in -1..1 [rad] = kelvin_voigt(stiffness [N*m/rad] = 4); torque turn: torque(arm) = 1 [N*m];
         output taken [W] = top.power;",
    ));
    assert_eq!(mechanism.joints[0].penalty, Some(LoadId(2)));
    let names: Vec<&str> = mechanism.loads.iter().map(|load| load.name.text.as_str()).collect();
    assert_eq!(names, ["turn", "stop", "top"]);
}

/// They have no rows, and the message about freedoms says so.
#[test]
fn freedoms_are_those_without_them() {
    let hung = |freedoms: usize| {
        let source = hung(
            &format!("{PIN} = penalty(stiffness [N/m] = 5)"),
            &format!("expect {{ degrees_of_freedom = {freedoms}; }}"),
        );
        compile(source.parse().expect("tokens"), None)
    };
    let mobility = hung(3).expect("it compiles").assembly.mobility;
    assert_eq!((mobility.joints, mobility.equations, mobility.generic), (0, 0, 3));
    assert!(
        mobility.to_string().ends_with("Joints that yield or have play take no freedoms away: \"top\"."),
        "{mobility}"
    );
    let errors = hung(1).map(|_| ()).expect_err("there are three").to_string();
    assert!(errors.contains("expected 1 degree of freedom, found 3"), "{errors}");
    assert!(errors.contains("Joints that yield or have play take no freedoms away: \"top\""), "{errors}");
}

/// A particle on a spring vibrates with √(k/m), and c/(2 √(k m)) of critical damping; a body that turns about the place by
/// √(k (1/m + r²/J)) where it is hit across.
#[test]
fn vibrations_are_those_of_closed_forms() {
    let found = |source: &str| {
        let sets = [Coordinates::Tree, Coordinates::Absolute];
        sets.map(|set| {
            let compiled = compile(source.parse().expect("tokens"), Some(set)).expect("it compiles");
            compiled.vibration.expect("it yields")
        })
    };
    let bead = "planar Bead { particle bead { mass [kg] = 2; } joint top: revolute(ground(0, 0) [m], bead.center) = penalty(stiffness [N/m] = 800, damping [N*s/m] = 24); }";
    for vibration in found(bead) {
        assert!(
            (vibration.rate - 20.0).abs() < 1e-9 && (vibration.damping - 0.3).abs() < 1e-12,
            "{vibration:?}"
        );
        // z² + 4 ζ z = 4 with z = ω h.
        let z = vibration.rate * vibration.longest_step();
        assert!((z * z + 4.0 * vibration.damping * z - 4.0).abs() < 1e-12, "{vibration:?}");
    }
    let arm = hung(
        "revolute(ground(1, 0) [m], arm.end) = penalty(stiffness [N/m] = 800)",
        "start { arm.angle [rad] = 0; }",
    );
    for vibration in found(&arm) {
        let expected = f64::sqrt(800.0 * (1.0 / 2.0 + 1.0 / 0.5));
        assert!(
            (vibration.rate - expected).abs() < 1e-9 * expected && vibration.damping == 0.0,
            "{vibration:?}"
        );
    }
}
