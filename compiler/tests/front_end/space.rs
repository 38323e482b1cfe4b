//! What definitions in space mean: shapes, markers, joints, couplings that are written in other words.

use crate::{bad, good};
use linkwright_compiler::model::{Axes, ConstraintKind, Expr, Mechanism, Space, Subject};

const PARTS: &str = "
spatial Parts {
    body hull { mass [kg] = 2; center [m] = (0, 0, 0.1); inertia [kg*m^2] = (3, 4, 5);
                products [kg*m^2] = (0.1, 0.2, 0.3); inertia_axes = keel;
                point bow [m] = (1, 2, 3);
                marker keel [m] = (0, 0, -1), about_z [deg] = 90, about_x [deg] = 30; }
    rod slender { mass [kg] = 3; length [m] = 2; }
    rod thick { mass [kg] = 3; length [m] = 2; radius [m] = 0.5; }
    cylinder drum { density [kg/m^3] = 1000; length [m] = 2; radius [m] = 0.5; }
    sphere ball { density [kg/m^3] = 1000; radius [m] = 0.3; }
    box block { density [g/cm^3] = 1; size [m] = (0.1, 0.2, 0.3); }
    disk plate { mass [kg] = 4; radius [m] = 0.5; }
    particle dust { mass [kg] = 0.1; }
    marker mast [m] = (1, 1, 1), axis = (0, 2, 0), reference = (1, 1, 0);
    gravity [m/s^2] = (0, 0, -9.81);
    joint a: revolute(mast, hull.keel);
    joint b: universal(hull.bow, slender.start, axis = (0, 0, 1), second_axis = (0, 1, 0));
    joint c: cylindrical(slender.end, thick.start, axis = (1, 0, 0));
    joint d: screw(thick.end, drum.start, axis = (1, 0, 0), pitch [mm] = 5);
    joint e: planar(drum.end, ball.center, axis = (0, 0, 1));
    line rail = (ground(0, 0, 0) [m], ground(1, 0, 0) [m]);
    joint f: point_on_line(rail, plate.center);
    joint g: spherical(plate.center, block.center);
    joint h: distance(block.center, dust.center, length [m] = 1);
}";

fn moments(mechanism: &Mechanism, body: usize) -> [f64; 3] {
    [0, 1, 2].map(|k| number(&mechanism.bodies[body].inertia.moments[k]))
}

fn number(expr: &Expr) -> f64 {
    match expr {
        Expr::Number(value) => *value,
        other => panic!("expected a number, found {other:?}"),
    }
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-14 * b.abs()
}

fn parts() -> Mechanism {
    good(PARTS)
}

#[test]
fn shapes_have_the_inertia_of_the_books() {
    let m = parts();
    assert_eq!(m.space, Space::Spatial);
    assert_eq!(moments(&m, 0), [3.0, 4.0, 5.0]);
    assert_eq!([0, 1, 2].map(|k| number(&m.bodies[0].inertia.products[k])), [0.1, 0.2, 0.3]);
    assert_eq!(moments(&m, 1), [0.0, 1.0, 1.0]);
    let expected = [3.0 * 0.25 / 2.0, 3.0 * (0.75 + 4.0) / 12.0, 3.0 * (0.75 + 4.0) / 12.0];
    assert_eq!(moments(&m, 2), expected);
    let (drum, ball, block) =
        (number(&m.bodies[3].mass), number(&m.bodies[4].mass), number(&m.bodies[5].mass));
    assert!(near(drum, 1000.0 * std::f64::consts::PI * 0.25 * 2.0), "{drum}");
    assert!(near(ball, 1000.0 * 4.0 / 3.0 * std::f64::consts::PI * 0.027), "{ball}");
    assert!(near(block, 6.0), "{block}");
    assert!(near(moments(&m, 4)[0], 0.4 * ball * 0.09));
    assert!(near(moments(&m, 5)[0], block * (0.04 + 0.09) / 12.0));
    assert!(near(moments(&m, 5)[2], block * (0.01 + 0.04) / 12.0));
    assert_eq!(moments(&m, 6), [0.25, 0.25, 0.5]);
    let thick = "spatial A { disk b { density [kg/m^3] = 1000; radius [m] = 0.5; thickness [m] = 0.1; } }";
    let mass = 25.0 * std::f64::consts::PI;
    let expected = [mass * 0.76 / 12.0, mass * 0.76 / 12.0, mass / 8.0];
    assert!(
        moments(&good(thick), 0).into_iter().zip(expected).all(|(found, expected)| near(found, expected))
    );
    assert_eq!(moments(&m, 7), [0.0; 3]);
}

#[test]
fn markers_have_axes_of_their_own() {
    let m = parts();
    let Axes::Directed { axis, reference: Some(reference) } = &m.joints[0].first.axes else {
        panic!("{:?}", m.joints[0].first.axes)
    };
    assert_eq!(axis.each_ref().map(number), [0.0, 2.0, 0.0]);
    assert_eq!(reference.each_ref().map(number), [1.0, 1.0, 0.0]);
    let Axes::Turned(turns) = &m.joints[0].second.axes else { panic!("{:?}", m.joints[0].second.axes) };
    let turns: Vec<(usize, f64)> = turns.iter().map(|(about, angle)| (*about, number(angle))).collect();
    assert_eq!(turns, [(2, 90.0_f64.to_radians()), (0, 30.0_f64.to_radians())]);
    assert!(matches!(m.bodies[0].inertia.axes, Axes::Turned(_)));
    // Their axis is the joint's.
    assert_eq!(m.joints[0].word(), "revolute");
    assert_eq!(m.joints[0].direction(0).each_ref().map(number), [0.0, 0.0, 1.0]);
}

#[test]
fn joints_have_their_axes() {
    let m = parts();
    let words: Vec<&str> = m.joints[1..6].iter().map(|joint| joint.word()).collect();
    assert_eq!(words, ["universal", "cylindrical", "screw", "planar", "point_on_line"]);
    assert_eq!(m.joints[1].directions.len(), 2);
    assert!(near(number(m.joints[3].scalar(0)), 0.005));
}

#[test]
fn couplings_in_other_words() {
    let m = good(
        "spatial Train {
            disk a { mass [kg] = 1; radius [m] = 1; }  disk b { mass [kg] = 1; radius [m] = 1; }
            disk c { mass [kg] = 1; radius [m] = 1; }  disk d { mass [kg] = 1; radius [m] = 1; }
            joint one:   revolute(ground(0, 0, 0) [m], a.center, axis = (0, 0, 1));
            joint two:   revolute(ground(3, 0, 0) [m], b.center, axis = (0, 1, 0));
            joint three: revolute(ground(6, 0, 0) [m], c.center, axis = (1, 0, 0));
            joint nut:   prismatic(ground(9, 0, 0) [m], d.center, axis = (1, 0, 0));
            bevel mitre: bevel(one, two, ratio = -2);
            constraint turn: worm(two, three, ratio = 1/30);
            belt drive_belt: belt(one, three, radius [mm] = 20, second_radius [mm] = 50);
            screw feed: screw(three, nut, pitch [mm] = 6);
            differential axle: differential(one, two, three);
            force push: force(nut) = 3 [N];
            torque twist: torque(a) = (1, 2, 3) [N*m];
        }",
    );
    let ratio = |index: usize| match &m.constraints[index].kind {
        ConstraintKind::Coupling(coupling) => number(&coupling.factor),
        other => panic!("{other:?}"),
    };
    assert_eq!((ratio(0), ratio(1)), (-2.0, 1.0 / 30.0));
    assert!(near(ratio(2), 2.5));
    assert!(near(ratio(3), 0.006 / std::f64::consts::TAU));
    assert!(matches!(m.constraints[4].kind, ConstraintKind::Equation { .. }));
    assert!(matches!(m.loads[0].on[..], [Subject::Travel(_)]));
    assert!(matches!(m.loads[1].on[..], [Subject::Body(_)]));
}

/// Statements added to a pendulum in space, and the only message they give.
const MISTAKES: &[(&str, &str)] = &[
    (
        "bushing b: bushing(ground(0, 0, 0), arm.tip, stiffness [N/m] = (1, 2), torsional_stiffness = 0);",
        "expected `,` and a third coordinate, found the end",
    ),
    (
        "force f: force(arm.tip) = 3 [N];",
        "a force needs three components, `force(place) = (fx, fy, fz)`, or a direction, \
         `force(place, direction = (1, 0, 0)) = law`",
    ),
    (
        "body b { mass [kg] = 1; inertia [kg*m^2] = (1, 1, 1); inertia_axes = hip; }",
        "`b` has no marker: declare `marker hip [m] = (0, 0, 0), …;` in its braces",
    ),
    (
        "particle p { mass [kg] = 1; } joint j: point_on_plane(p.center, arm.tip, axis = (0, 0, 1));",
        "a plane turns with its body, and the particle at `p.center` has no orientation; name the particle second",
    ),
    (
        "disk wheel { density [kg/m^3] = 1; radius [m] = 1; }",
        "the mass of the disk `wheel` follows from its density only with a thickness: write `thickness [m] = …;`, or its `mass`",
    ),
    (
        "output o [m] = arm.tip.w;",
        "the place `arm.tip` has x, y, z, velocity.x, velocity.y and velocity.z, in world axes",
    ),
    ("output o [rad/s] = arm.rate.w;", "`arm.rate` has the components x, y and z, in the axes of `arm`"),
    ("output o [m] = hinge.travel;", "the revolute joint `hinge` has no travel; it has angle, rate"),
    (
        "body b { mass [kg] = 1; inertia [kg*m^2] = 1; }",
        "expected the moments of inertia `(Ixx, Iyy, Izz)`, found `1`",
    ),
    ("box b { mass [kg] = 1; }", "the box `b` has no size: write `size [m] = (…, …, …);`"),
    ("box b { mass [kg] = 1; size [m] = (1, 0, 1); }", "the size of `b` must be positive, found 0 m"),
    (
        "cylinder b { mass [kg] = 1; length [m] = 1; }",
        "the cylinder `b` has no radius: write `radius [m] = …;`",
    ),
    ("sphere b { density [kg] = 1; radius [m] = 1; }", "density is given a mass: expected kg/m^3, found kg"),
    ("gravity [m/s^2] = (0, 1);", "expected `,` and a third coordinate, found the end"),
    ("torque t: torque(arm) = (1, 2, 3) [N];", "`t` is given a force: expected N*m, found N"),
    ("force f: force(hinge) = 3 [N];", "the revolute joint `hinge` has no travel; it has angle, rate"),
    (
        "marker m [m] = (0, 0, 0), reference = (1, 0, 0);",
        "a reference direction fixes the turn about the axis: write `axis = (…)` before it",
    ),
    (
        "marker m [m] = (0, 0, 0), abut_x [deg] = 3;",
        "`marker` has no argument called \"abut_x\"; did you mean `about_x`?",
    ),
    ("start { arm.orientation = (1, 0, 0); }", "expected `,` and a fourth coordinate, found the end"),
    (
        "start { arm.tip.orientation = (1, 0, 0, 0); }",
        "`arm.tip.orientation` cannot be given at the start: only angles, travels, positions and their rates can",
    ),
    (
        "joint j: revolute(arm.tip, arm.end, axis = (0, 0, 1));",
        "`arm` has no point called \"end\"; it has center, origin, tip",
    ),
    ("options { redundant = droop; }", "expected `refuse` or `drop` or `keep`, found `droop`"),
];

#[test]
fn one_message_for_each_mistake() {
    for (more, expected) in MISTAKES {
        let source = format!(
            "spatial Pendulum {{
                body arm {{ mass [kg] = 1; inertia [kg*m^2] = (1, 1, 1); point tip [m] = (1, 0, 0); }}
                joint hinge: revolute(ground(0, 0, 0) [m], arm.origin, axis = (0, 0, 1));
                {more}
            }}"
        );
        let diagnostics = bad(&source);
        let found: Vec<&str> = diagnostics.iter().map(|error| error.message.as_str()).collect();
        assert_eq!(found, [*expected], "{more}");
    }
}

#[test]
fn an_orientation_said_twice() {
    let source = "spatial A { body b { mass [kg] = 1; inertia [kg*m^2] = (1, 1, 1); }
        start { b.orientation = (1, 0, 0, 0); b.orientation ~ (0, 1, 0, 0); } }";
    let text = bad(source).to_string();
    assert_eq!(
        text,
        "error: the start of `b.orientation` is given twice\n  note: the first `b.orientation` is here\n"
    );
}
