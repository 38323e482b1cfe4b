//! Habits of Rust, of other programs and of plain writing: each is answered once, in the words of the language.

use crate::{bad, each_has_one_message, slider_crank};

#[test]
fn one_answer_for_each_habit() {
    each_has_one_message(HABITS);
}

#[test]
fn words_before_the_name() {
    for (source, advice) in [
        ("planer P { }", "did you mean `planar`?"),
        ("struct P { }", "write `planar Name { … }` or `spatial Name { … }`"),
        ("rod a { }", "statements stand in the braces of a mechanism: `planar Name { rod … }`"),
        ("planar \"P\" { }", "names are written without quotes: `P`"),
    ] {
        let text = bad(source).to_string();
        assert!(text.trim_end().ends_with(advice), "{text}");
        assert_eq!(text.lines().count(), 1, "{text}");
    }
}

#[test]
fn words_of_others() {
    for (more, advice) in [
        ("parameter p [m] = 1;", "write `param name [unit] = value;`"),
        ("if base.angle > 0 { }", "within expressions a choice is `if(condition, value, other)`"),
        ("struct B { }", "a mechanism has no items of Rust; write those beside `mechanism!`"),
        ("assert { }", "write `expect { … }`"),
        ("initial { }", "write `start { … }`"),
        ("bar b { }", "write `rod`"),
        ("wheel w { }", "write `disk`"),
        ("ball b { }", "write `sphere`, or `joint name: spherical(…)`"),
        ("cube c { }", "write `box`"),
        ("point_mass p { }", "write `particle`"),
        ("sensor s = base.angle;", "write `output name [unit] = value;`"),
        ("import \"arm\";", "a mechanism stands in one macro as a whole"),
        ("output o [1] = log(2);", "the natural logarithm is `ln`"),
        ("output o [1] = log2(2);", "write `ln(x)/ln(2)`"),
        ("output o [rad] = arcsin(1);", "write `asin`"),
        ("output o [rad] = arccos(1);", "write `acos`"),
        ("output o [1] = fabs(1);", "write `abs`"),
        ("output o [1] = length(1);", "write `norm(a.end - b.start)`, or `hypot(x, y)`"),
        ("output o [1] = sin(radians(30));", "write the unit: `30 [deg]`"),
        ("output o [1] = heaviside(1);", "write `step(x)`, 1 where x is positive"),
        ("output o [1] = floor(1);", "there is none whose value jumps by itself; write `if(…)`"),
        ("output o [1] = clip(1, 0, 2);", "write `clamp(x, least, most)`"),
        ("output o [1] = fmod(1, 2);", "write `wrap(x, period)`"),
        ("output o [m/s^2] = g;", "declare it: `const g [m/s^2] = 9.81;`"),
        ("output o [1] = e;", "write `exp(1)`"),
        ("const A [lb] = 1;", "one pound is 0.45359237 [kg]"),
        ("const A [lbf] = 1;", "one pound-force is 4.4482216152605 [N]"),
        ("const A [kgf] = 1;", "one kilogram-force is 9.80665 [N]"),
        ("const A [psi] = 1;", "one psi is 6894.757293168 [Pa]"),
        ("const A [hp] = 1;", "one horsepower is 745.7 [W], metric 735.49875 [W]"),
        ("rod b { mass [kg] = 1; length [m] = 1; };", "a block ends with `}`, without `;`"),
        ("gravity [m/s^2] = down;", "its components are written out, in parentheses"),
        ("quark q;", "statements begin with const, param, input, body, joint, force, start and the like"),
        (
            "joint j: ball(crank.pin, link.end);",
            "a ball joint is `spherical`, which needs space: write `spatial` before the name of the mechanism",
        ),
        ("options { redundant_constraints = drop; }", "did you mean `redundant`?"),
    ] {
        let text = bad(&slider_crank(more)).to_string();
        assert!(text.trim_end().ends_with(advice), "{more}: {text}");
        assert_eq!(text.lines().count(), 1, "{more}: {text}");
    }
}

/// Statements added to the slider-crank, and the only message they give.
const HABITS: &[(&str, &str)] = &[
    (
        "let L [m] = 1;",
        "no statement begins with `let`; write `const NAME [unit] = value;`, or `param name …` for a value that may change at run time",
    ),
    (
        "for i in 0..3 { rod a[i] { mass [kg] = 1; length [m] = 1; } }",
        "no statement begins with `for`; write `repeat i in 0..3 { … }`",
    ),
    (
        "link a { mass [kg] = 1; length [m] = 1; }",
        "no statement begins with `link`; write `body`, or a shape such as `rod`, `disk` or `box`",
    ),
    (
        "motor m: torque(base) = 1 [N*m];",
        "no statement begins with `motor`; write `drive name: joint.angle = law;` for a given motion, `torque name: torque(joint) = law;` for a given torque",
    ),
    (
        "revolute j: crank.pin, link.end;",
        "no statement begins with `revolute`; a revolute is a joint: write `joint name: revolute(…);`",
    ),
    (
        "hinge j: crank.pin, link.end;",
        "no statement begins with `hinge`; write `joint name: kind(place, place);`",
    ),
    (
        "limits { base.angle in 0..1; }",
        "no statement begins with `limits`; write `limit name: joint.angle [deg] in -90..20 = law;`, with the law of a contact",
    ),
    ("# a comment", "expected an attribute in `[ ]`, found `a`; comments begin with `//`"),
    (
        "param p: f64 = 1;",
        "expected `=`, found `:`; values stand behind `=`, units in brackets behind the name: `name [unit] = value`",
    ),
    (
        "param p [kg];",
        "the parameter `p` has no default: write `param p [unit] = value;`, or `input p [unit];` for what changes at every call",
    ),
    ("param p [kg] = 1 in (0, 2);", "expected the bounds, found `(`; bounds are written `least..most`"),
    (
        "param p [kg] = 1 in 0..=2;",
        "expected a value, found `=`; bounds are inclusive already: write `least..most`",
    ),
    ("const A [m] = 1,5;", "expected `;`, found `,`; decimals are written with a point: `1.5`"),
    ("const A = 1 m;", "expected `;`, found `m`; units stand in brackets: `[m]`"),
    ("const A = 1 meter;", "expected `;`, found `meter`; units stand in brackets: `[m]`"),
    (
        r#"const A = "1 m";"#,
        r#"expected a value, found `"1 m"`; values are written without quotes, their unit in brackets: `1 [kg]`"#,
    ),
    ("const A [inch] = 1;", r#"no unit called "inch"; one inch is 25.4 [mm]"#),
    ("const A [N.m] = 1;", "not a unit at `.m`: products of units are written with `*`, such as `N*m`"),
    (
        r#"rod "b" { mass [kg] = 1; length [m] = 1; }"#,
        r#"expected the name of the body, found `"b"`; names are written without quotes: `b`"#,
    ),
    (
        "rod b(mass = 1, length = 1);",
        "expected `{`, found `(`; properties stand in braces: `rod arm { mass [kg] = 1; length [m] = 1; }`",
    ),
    (
        "rod b { mass: 1 [kg]; length [m] = 1; }",
        "expected `=`, found `:`; values stand behind `=`, units in brackets behind the name: `name [unit] = value`",
    ),
    (
        "rod b { mass [kg] = 1, length [m] = 1 }",
        "expected `;`, found `,`; every line ends with `;`, and commas stand only within parentheses",
    ),
    (
        "rod b { mass [kg] = 1 length [m] = 1; }",
        "expected `;`, found `length`; what stands before it has no `;` at its end",
    ),
    (
        "rod b { mass (kg) = 1; length [m] = 1; }",
        "expected `=`, found `(`; units stand in brackets: `mass [kg] = 1`",
    ),
    (
        "rod b { [kg] mass = 1; length [m] = 1; }",
        "expected a property of the body, found `[`; the unit stands behind the name: `mass [kg] = 1;`",
    ),
    (
        "rod b { mass [kg] = 1; length [m] = 1; joint j: revolute(crank.pin, b.start); }",
        "`joint` begins a statement of the mechanism, not of a rod: close the braces of the rod first",
    ),
    (
        "body b { mass [kg] = 1; inertia [kg*m^2] = (1, 1, 1); }",
        "the inertia of a planar body is one number, about its centre of mass and across the plane: write `inertia [kg*m^2] = …;`",
    ),
    (
        "body b { mass [kg] = 1; inertia [kg*m^2] = 1; point p [m] = [1, 0]; }",
        "expected `(x, y)`, found `[`; vectors stand in parentheses, brackets are for units and indices",
    ),
    (
        "body b { mass [kg] = 1; inertia [kg*m^2] = 1; point p [m] = 1, 0; }",
        "expected `(x, y)`, found `1`; a vector has all its components in parentheses",
    ),
    (
        "joint j = revolute(crank.pin, link.end);",
        "expected `:` and what the joint is, such as `revolute(…);`, found `=`",
    ),
    ("joint j: hinge(crank.pin, link.end);", r#"no joint called "hinge"; did you mean `revolute`?"#),
    (
        "joint j: revolute(world, link.end);",
        r#"no body called "world"; the ground is written with a place, `ground(0, 0)`"#,
    ),
    (
        "joint j: revolute(link.end);",
        "`revolute` needs 2 unnamed arguments first, found 1; a place of the ground is written `ground(x, y) [m]`",
    ),
    ("joint j: revolute(ground(0, 0), end);", "a place is written with its body: `link.end`"),
    (
        "joint j: point_on_line(link.end, way);",
        "the line comes first and then the point on it: write `point_on_line(way, link.end)`",
    ),
    (
        "joint j: prismatic(crank.pin, link.end, (1, 0));",
        "expected a named argument, found `(`; what follows the unnamed arguments has a name: `axis = …`",
    ),
    (
        "joint j: prismatic(crank.pin, link.end, axis = x);",
        "expected `(x, y)`, found `x`; a direction is a vector: `(1, 0)` is along x",
    ),
    (
        "gear g: gear(base, knee, 2);",
        "expected a named argument, found `2`; what follows the unnamed arguments has a name: `ratio = …`",
    ),
    (
        "gear g: gear(crank.pin, link.end, ratio = 2);",
        "expected `,` or `)`, found `.`; joints and bodies are named here without a point, and two toothings bring their ratio: for these leave `ratio` out",
    ),
    (
        "damper d: damper(base, damping [N*m*s] = 0.1);",
        "`damper` needs 2 unnamed arguments first, found 1; between the bodies of a joint write `torsion_spring(joint, …)`",
    ),
    (
        "spring s: spring(crank.pin, link.end, k [N/m] = 1, l0 [m] = 1);",
        r#"`spring` has no argument called "k"; did you mean `stiffness`?"#,
    ),
    (
        "spring s: spring(crank.pin, link.end, stiffness = 100, length [m] = 1);",
        "stiffness is given a plain number: expected N/m; write the unit, as in `100 [N/m]`",
    ),
    (
        "force f: force(crank.pin, direction = (1, 0)) = (1, 0) [N];",
        "a force with a direction has one value: leave the direction out, or write one number",
    ),
    (
        "force f: torque(base) = base.angle > 0 [rad] ? 1 [N*m] : 0;",
        "expected `;`, found `?`; a choice is written `if(condition, value, other)`",
    ),
    (
        "force f: torque(base) = if base.angle > 0 [rad] { 1 [N*m] } else { 0 };",
        "expected a value, found `if`; a choice is written `if(condition, value, other)`",
    ),
    ("drive d: base.angle = 3 [rad/s]*t;", r#"no value called "t"; the time is `time`"#),
    (
        "drive d: base.rate = 3 [rad/s];",
        "`base.rate` cannot be driven: only an angle, a travel or a position can; a rate is driven through its angle or travel, such as `angle = 3 [rad/s]*time`",
    ),
    (
        "constraint c: base.angle == 3 [rad];",
        "expected `=` between the two sides of the constraint, found `;`; one `=` is enough here, `==` only compares",
    ),
    ("start { base.angle = 30 deg; }", "expected `;`, found `deg`; units stand in brackets: `[deg]`"),
    ("start { base.angle [rad] = PI/2; }", r#"no value called "PI"; π is `pi`"#),
    (
        "start { base.angle [rad] = std::f64::consts::PI; }",
        "expected `;`, found `:`; there are no paths of Rust here; π is `pi`",
    ),
    ("start { base = 30 [deg]; }", "`base` is a joint, expected a value: write `base.angle`"),
    (
        "output o = link.end.x;",
        "`o` is declared without a unit, as a plain number, and is given a length: write `output o [m] = …`",
    ),
    (
        "output link.end.x;",
        "expected `=`, found `.`; an output has a name of its own: `output name [unit] = value;`",
    ),
    (
        "output o [1] = base.angle.sin();",
        "expected `;`, found `(`; functions stand before their argument: `sin(…)`",
    ),
    ("output o [1] = pow(2, 3);", r#"no function called "pow"; a power is written `a^b`"#),
    (
        "output o [rad] = arctan(1);",
        r#"no function called "arctan"; write `atan`, or `atan2(y, x)`, which knows the quadrant"#,
    ),
    ("output o [1] = deadzone(1, 2);", r#"no function called "deadzone"; write `deadband(x, half)`"#),
    (
        "options { coordinates: tree; }",
        "expected `=`, found `:`; values stand behind `=`, units in brackets behind the name: `name [unit] = value`",
    ),
    (
        "options { emit = tangent, penalty; }",
        "expected `;`, found `,`; several stand in parentheses: `(one, other)`",
    ),
    (
        "expect { dof = 1; }",
        r#"nothing that can be expected is called "dof"; did you mean `degrees_of_freedom`?"#,
    ),
    (
        "expect { degrees_of_freedom == 1; }",
        "expected a value, found `=`; one `=` is enough here, `==` only compares",
    ),
    (
        "repeat i in 0..=2 { output o[i] [1] = 1; }",
        "expected a value, found `=`; `repeat` stops before the number behind `..`: write one more",
    ),
    (
        "repeat i in 3..1 { output o[i] [1] = i; }",
        "`repeat` counts upwards and stops before the number behind `..`, so from 3 to 1 there is no round: write `1..4` for the \
         numbers from 1 to 3, and `4 - i` in place of `i` to count them downwards",
    ),
    (
        "const N = 0; repeat i in 0..N - 1 { output o[i] [1] = i; }",
        "`repeat` counts upwards and stops before the number behind `..`, so from 0 to -1 there is no round: write the smaller \
         number first",
    ),
    (
        "repeat i in 0..2 { rod a { mass [kg] = 1; length [m] = 1; } }",
        "every round of `repeat` declares `a`: give it the index of the round, such as `a[i]`",
    ),
    (
        "repeat i in 0..2 { rod a[i] { mass [kg] = 1; length [m] = 1; } joint j[i]: revolute(a[i].end, a[i+1].start); }",
        r#"no "a[2]": indices go from "a[0]" to "a[1]""#,
    ),
    (
        "repeat i in 0..2 { rod a[i] { mass [kg] = 1; length [m] = 1; } joint j[i]: revolute(a[i-1].end, a[i].start); }",
        "-1 is negative; indices and counts start at 0",
    ),
];
