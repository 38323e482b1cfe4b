//! Dry friction in joints: what it holds and slides with where that is not written, and what is refused beside it.

use crate::{bad, good};
use linkwright_compiler::model::{Expr, Load};
use std::fmt::Write;

/// An arm on a pin, with these statements.
fn arm(statements: &str) -> String {
    format!(
        "planar Arm {{ input grip [N*m]; rod arm {{ mass [kg] = 1; length [m] = 1; }} joint pin: revolute(ground(0, 0) [m], arm.start);
         torque motor: torque(pin) = grip; {statements} }}"
    )
}

const HOLDS: &str = "friction rub: on(pin) = dry(static = 0.5, radius [m] = 0.02);";

#[track_caller]
fn said(source: &str, text: &str) {
    let found = bad(source).to_string();
    assert!(found.contains(text), "{found}");
}

fn number(load: &Load, name: &str) -> Option<f64> {
    match load.named(name) {
        Expr::Number(value) => Some(*value),
        _ => None,
    }
}

#[test]
fn what_is_not_written_is_as_the_other() {
    let mechanism = good(&arm(HOLDS));
    let load = mechanism.loads.iter().find(|load| load.sticks()).expect("it holds");
    assert_eq!([number(load, "static"), number(load, "kinetic")], [Some(0.5); 2]);
    assert!(mechanism.sticks() && mechanism.is_rigid() && mechanism.pressed_by().is_empty());
    let mechanism = good(&arm("friction rub: on(pin) = dry(torque [N*m] = 3);"));
    let load = mechanism.loads.iter().find(|load| load.sticks()).expect("it holds");
    assert_eq!([number(load, "torque"), number(load, "breakaway")], [Some(3.0); 2]);
    good(&arm("friction rub: on(pin) = dry(torque = 2*grip, breakaway [N*m] = 3);"));
}

#[test]
fn what_is_not_there_yet_is_refused() {
    let with = |statements: &str| arm(&format!("{HOLDS} {statements}"));
    said(
        &with("options { export_c = f64; }"),
        "the functions in C take whole steps and do not find when `rub`",
    );
    said(
        &with("options { contact = held; }"),
        "held gates of contacts and the `dry` friction `rub` of a joint",
    );
    said(
        &with("friction other: on(pin) = dry(static = 0.5, radius [m] = 0.02);"),
        "`rub` is dry friction at `pin` already",
    );
    let mut many = String::new();
    for i in 0..9 {
        let _ = write!(
            many,
            "disk d{i} {{ mass [kg] = 1; radius [m] = 0.1; }} joint j{i}: revolute(ground({i}, 0) [m], d{i}.center); \
             friction f{i}: on(j{i}) = dry(torque [N*m] = 1); "
        );
    }
    said(
        &arm(&many),
        "all ways in which they may, of 8 coordinates at most, of which a pin or a rail has one",
    );
}

#[test]
fn more_than_can_be_tried_are_told() {
    let arms = "rod arm[i] { mass [kg] = 1; length [m] = 1; } joint pin[i]: revolute(ground(i, 0) [m], arm[i].start);";
    let source = format!(
        "planar Many {{ repeat i in 0..9 {{ {arms} friction rub[i]: on(pin[i]) = dry(torque [N*m] = 1); }} }}"
    );
    let text = "which of the joints with `dry` friction hold is found among all ways in which they may, of 8 coordinates at most";
    said(&source, text);
}

#[test]
fn a_sleeve_needs_its_radius() {
    let source = "spatial Rod { body rod { mass [kg] = 1; inertia [kg*m^2] = (1, 1, 1); }
         joint sleeve: cylindrical(ground(0, 0, 0) [m], rod.center, axis = (1, 0, 0)); friction rub: on(sleeve) = dry(static = 0.5); }";
    said(
        source,
        "the surfaces of `sleeve` slide along its axis with ẋ and about it with r ω, and a force of μ N resists both",
    );
    let with = |arguments: &str| source.replace("static = 0.5", arguments);
    // As many gates as directions, of which the first says which are one.
    let gates = |arguments: &str| {
        let mechanism = good(&with(arguments));
        (mechanism.gates().count(), mechanism.slide_as_one())
    };
    assert_eq!(gates("static = 0.5, radius [m] = 0.1"), (2, vec![0, 0]));
    assert_eq!(gates("force [N] = 2"), (1, vec![]));
}

#[test]
fn balls_are_counted_by_their_directions() {
    let balls = |count: usize| {
        let one = |i: usize| {
            format!(
                "body b{i} {{ mass [kg] = 1; inertia [kg*m^2] = (1, 1, 1); }} joint j{i}: spherical(ground({i}, 0, 0) [m], b{i}.center);
                 friction f{i}: on(j{i}) = dry(torque [N*m] = 1);"
            )
        };
        format!("spatial Balls {{ {} }}", (0..count).map(one).collect::<String>())
    };
    let mechanism = good(&balls(2));
    assert_eq!(mechanism.slide_as_one(), [0, 0, 0, 3, 3, 3]);
    said(
        &balls(3),
        "a sleeve, a universal joint or a point on a plane two, and a ball or a face on a plane three",
    );
}

#[test]
fn contacts_in_space_have_a_gate_along_each_axis() {
    let source = "spatial Floor { gravity [m/s^2] = (0, 0, -9.81); sphere ball { mass [kg] = 1; radius [m] = 0.1; }
         rod bar { mass [kg] = 1; length [m] = 1; radius [m] = 0.02; surface sole: capsule(bar.start, bar.end, radius [m] = 0.02); }
         surface floor: plane(ground(0, 0, 0) [m], axis = (0, 0, 1));
         contact touch: between(ball.surface, floor) = rigid(restitution = 0.5); friction grip: on(touch) = dry(static = 0.3);
         contact lies: between(bar.sole, floor) = rigid(restitution = 0); friction rub: on(lies) = dry(static = 0.3);
         contact drops: gap(ball.center.x + 5 [m], slip = ball.center.y) = rigid(restitution = 0); friction drag: on(drops) = dry(static = 0.3);
         start { ball.center.x [m] = 0; ball.center.y [m] = 0; ball.center.z [m] = 0.2; bar.center.x [m] = 0; bar.center.y [m] = 1; bar.center.z [m] = 0.2; } }";
    let mechanism = good(source);
    // Three for the ball, twice as many for both ends of the bar, one along the slip; then those of the gaps.
    assert_eq!(mechanism.slide_as_one(), [0, 0, 0, 3, 3, 3, 6, 6, 6, 9, 10, 11, 12, 13]);
    let pressed: Vec<Option<usize>> = mechanism.pressed_by();
    let by = |gap: usize| [Some(gap); 3];
    assert_eq!(
        pressed,
        [by(10), by(11), by(12)]
            .concat()
            .into_iter()
            .chain([Some(13), None, None, None, None])
            .collect::<Vec<_>>()
    );
}

#[test]
fn what_is_as_another_is_said_once() {
    let found = bad(&arm("friction rub: on(pin) = dry(static = -0.5, radius [m] = 0.02);"));
    let found: Vec<&str> = found.iter().map(|error| error.message.as_str()).collect();
    assert!(matches!(found[..], [one] if one.contains("the static of `rub` is negative")), "{found:?}");
}

#[test]
fn friction_that_is_not_there_yet_is_no_lack_of_surfaces() {
    let only = "friction acts in revolute, prismatic, cylindrical, spherical, universal, constant_velocity, planar and screw joints and where a \
                point slides along a line or curve or on a plane";
    for joint in ["fixed(ground(0, 0), b.center)", "parallel(ground(0, 0), b.center)"] {
        let (kind, _) = joint.split_once('(').expect("a joint");
        let source = format!(
            "planar Wire {{ body b {{ mass [kg] = 1; inertia [kg*m^2] = 1; }} joint j: {joint}; friction rub: on(j) = dry(static = 0.3); }}"
        );
        said(&source, &format!("no surfaces slide on each other in `j`, a {kind} joint: {only}"));
    }
    let spatial = |joint: &str| {
        format!(
            "spatial Nut {{ body b {{ mass [kg] = 1; inertia [kg*m^2] = (1, 1, 1); }} joint j: {joint};
             friction rub: on(j) = coulomb(coefficient = 0.3, speed [m/s] = 0.1); }}"
        )
    };
    for (joint, why) in [
        (
            "screw(ground(0, 0, 0), b.center, axis = (0, 0, 1), pitch [m] = 0.01)",
            "the friction `rub` needs its radius: the thread of `j` is as steep as its pitch on a turn",
        ),
        (
            "planar(ground(0, 0, 0), b.center, axis = (0, 0, 1))",
            "the friction `rub` needs its radius: the surfaces of `j` slide on each other with v along the plane",
        ),
    ] {
        said(&spatial(joint), why);
    }
}
