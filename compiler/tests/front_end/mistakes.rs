//! Mistakes and what is said about them, one message each.

use crate::{bad, each_has_one_message, slider_crank};

#[test]
fn one_message_for_each_mistake() {
    each_has_one_message(MISTAKES);
}

#[test]
fn what_is_missing_is_said_once_each() {
    let diagnostics = bad(&slider_crank("body b { } rod r { }"));
    let found: Vec<&str> = diagnostics.iter().map(|error| error.message.as_str()).collect();
    let expected = [
        "the body `b` has no mass: write `mass [kg] = …;`",
        "the body `b` has no inertia: write `inertia [kg*m^2] = …;`",
        "the rod `r` has no mass: write `mass [kg] = …;`",
        "the rod `r` has no length: write `length [m] = …;`",
    ];
    assert_eq!(found, expected);
}

#[test]
fn around_the_braces() {
    for (source, expected) in [
        ("", "the definition is empty: write `planar Name { … }` or `spatial Name { … }`"),
        ("Name { }", "expected `planar` or `spatial`, the kind of the mechanism, found `Name`"),
        (
            "spatial Arm { }",
            "`Arm` has no body: write `body crank { mass [kg] = …; inertia [kg*m^2] = (…, …, …); }`",
        ),
        ("planar { }", "expected the name of the mechanism, found `{`"),
        ("planar Name;", "expected `{`, found `;`"),
        ("planar A { } planar B { }", "expected the end: one mechanism for each macro, found `planar`"),
        ("planar A { }", "`A` has no body: write `body crank { mass [kg] = …; inertia [kg*m^2] = …; }`"),
    ] {
        let diagnostics = bad(source);
        let found: Vec<&str> = diagnostics.iter().map(|error| error.message.as_str()).collect();
        assert_eq!(found, [expected], "{source}");
    }
}

#[test]
fn mistakes_of_one_stage_are_reported_together() {
    let source = slider_crank(
        "output a [m] = nothing; output b [m] = crank.pon.x; force f: torque(bas) = 1 [N*m];
         rod r { mass [kg] = 1 [m]; length [kg] = 1; } start { rail.angle [deg] = 1; base.angle [m] = 1; }",
    );
    assert_eq!(bad(&source).iter().count(), 7);
}

/// Statements added to the slider-crank, and the only message they give.
const MISTAKES: &[(&str, &str)] = &[
    (
        "body b { mass [kg*m^2] = 1; inertia [kg*m^2] = 1; }",
        "mass is given a moment of inertia: expected kg, found kg*m^2",
    ),
    ("output o [m] = link.ende.x;", r#"`link` has no point called "ende"; did you mean "end"?"#),
    ("output o [m] = link.x;", r#"`link` has no point called "x"; it has center, end, origin, start"#),
    ("output o [1] = link;", "`link` is a body, expected a value such as `link.angle` or `link.center.x`"),
    (
        "output o [m] = link.end;",
        "`link.end` is a place, expected a value: write `link.end.x`, `link.end.y` or `link.end.velocity.x`",
    ),
    ("output o [m] = nothing;", r#"no value called "nothing""#),
    (
        "spring s: (link.end, base.end, stiffness [N/m] = 1);",
        "expected the kind of the load (force, torque, spring, cable, damper, torsion_spring, shaft, along, masing, bouc_wen, bushing, mesh), found `(`",
    ),
    (
        "bushing b: bushing(ground(0, 0), link.end, stiffness [N/m] = 1);",
        "`bushing` needs its torsional_stiffness: write `torsional_stiffness = …`",
    ),
    (
        "bushing b: bushing(link.end, block.center, stiffness [N/m] = 1, torsional_stiffness = 0);",
        "`block.center` is a particle and has no orientation; write `body`, `rod`, `disk` or `box` for one that turns",
    ),
    (
        "bushing b: bushing(ground(0, 0), link.end, stiffness [N/m] = (1, 2, 3), torsional_stiffness = 0);",
        "a planar mechanism has two coordinates: leave the third out, or write `spatial` before the name of the mechanism",
    ),
    (
        "bushing b: bushing(ground(0, 0), link.end, stiffness [N/m] = 1, torsional_stiffness = (1, 2) [N*m]);",
        "one number is expected here, and these parentheses hold several: components are given one by one, such as `rod.rate.x [rad/s] = 1;`, and a vector stands only where places, axes and forces are",
    ),
    (
        "bushing b: bushing(ground(0, 0), link.end, stiffness [N/m] = (1, link.angle), torsional_stiffness = 0);",
        "`link.angle` is a position, but this argument may depend on constants and parameters only",
    ),
    (
        "bushing b: bushing(ground(0, 0), link.end, stiffness [N/m] = 1, torsional_stiffness [N/m] = 2);",
        "torsional_stiffness is given a stiffness: expected N*m, found N/m",
    ),
    (
        "bushing b: bushing(link.start, link.end, stiffness [N/m] = 1, torsional_stiffness = 0);",
        "`link.start` and `link.end` never move apart, so nothing between them does anything: name a place of another body, or leave it out",
    ),
    (
        "bushing b: bushing(ground(0, 0), link.end, stiffness [N/m] = 1, torsional_stiffness = 0) = 3 [N];",
        "a bushing has no law behind it, its arguments say all; write `;`",
    ),
    (
        "joint extra: point_on_line(link.end, line(ground(0, 0), ground(1, 0)));",
        "a line is not a place; a joint that has one takes it first: `point_on_line(line, place)`",
    ),
    (
        "start { base.angle = 30; }",
        "`base.angle` is given a plain number: expected rad; write the unit, as in `30 [deg]`",
    ),
    ("output o [1] = sine(1);", r#"no function called "sine"; did you mean "sin"?"#),
    ("output o [1] = clamp(2, 3, 1);", "the least value is above the largest: `clamp(x, least, most)`"),
    (
        "output o [1] = smoothstep(base.angle, 1 [rad], 1 [rad]);",
        "the step has no width: `smoothstep(x, from, to)` goes from 0 to 1 between the two",
    ),
    (
        "output o [m] = deadband(1 [m], -1 [m]);",
        "the band is negative: `deadband(x, half)` is zero from −half to half",
    ),
    (
        "output o [rad] = wrap(base.angle, 0 [rad]);",
        "a period is positive: `wrap(x, period)` is x less whole periods",
    ),
    ("state z [m];", "the state \"z\" has no start value: write `state z [unit] = value;`"),
    ("state z [m] = 1;", "the state `z` has no rate: write `rate z = …;`, in its unit per second"),
    ("state z [m] = 1; rate z = 1 [m/s]; rate z = 2 [m/s];", "`z` has a rate already: a state has one"),
    (
        "state z [m] = 1; rate z [m/s] = 1;",
        "a rate has the unit of its state per second: write `rate z = …;`",
    ),
    (
        "param p [m] = 1; rate p = 1 [m/s];",
        "`p` is no state: only what is declared by `state p [unit] = value;` has a rate of its own",
    ),
    (
        "state curent [A] = 1; rate curent = 1 [A/s]; rate current = 1 [A/s];",
        "no state called \"current\"; did you mean \"curent\"?",
    ),
    ("rate z = 1 [m/s];", "no state called \"z\": declare it by `state z [unit] = value;`"),
    ("state z [V] = 1; rate z = 1 [V];", "the rate of `z` is given a voltage: expected V/s, found V"),
    (
        "state z [m] = 1; rate z = 0;",
        "the rate of `z` is zero, so it keeps its start value: write `param z [unit] = value;`",
    ),
    ("state z [m] = 1, scale = -1; rate z = 1 [m/s];", "the scale of a state must be positive, found -1"),
    ("state z [m] = 1, size = 2; rate z = 1 [m/s];", "expected `scale = …`, found `size`"),
    (
        "state z [m] = crank.pin.x; rate z = 1 [m/s];",
        "`crank.pin.x` is a position, but a start value may depend on constants and parameters only",
    ),
    (
        "state z [rad] = 1; rate z = 1 [rad/s]; constraint c: base.angle = z;",
        "`z` is a state, but a constraint may depend on constants, parameters, time and positions only",
    ),
    (
        "output o [N] = base.reaction;",
        "a reaction is named by its parts: `base.reaction.x`, `base.reaction.y`, `base.reaction.torque`, `base.reaction.size`",
    ),
    (
        "output o [N] = rail.reaction.z;",
        "a reaction is named by its parts: `rail.reaction.x`, `rail.reaction.y`, `rail.reaction.normal`, `rail.reaction.torque`, \
         `rail.reaction.size`",
    ),
    (
        "force f: torque(base) = base.reaction.torque;",
        "`base.reaction.torque` is a result, but the law of a load may depend on constants, parameters, time, inputs, states, \
         positions and velocities only",
    ),
    ("signal s [1] = s;", "the signal `s` names itself"),
    ("signal s [1] = 2*t; signal t [1] = s;", "the signal `s` names itself: s → t → s"),
    (
        "signal s [rad/s] = base.rate; constraint c: base.angle = s*1 [s];",
        "`s` depends on a velocity, but a constraint may depend on constants, parameters, time and positions only",
    ),
    (
        "signal s [rad/s] = base.rate; output o [rad/s^2] = s.rate;",
        "`s.rate` depends on a velocity, but a rate may depend on constants, parameters, time and positions only",
    ),
    (
        "signal s = base.angle;",
        "`s` is declared without a unit, as a plain number, and is given an angle: write `signal s [rad] = …`",
    ),
    ("force f: along(3 [m]) = 2 [N];", "this depends on no position, so no force can act along it"),
    ("force f: along(link.end.x) = 2 [N*m];", "`f` is given a torque or energy: expected N, found N*m"),
    (
        "force f: along(base.rate) = 2 [N];",
        "`base.rate` is a velocity, but what a force acts along may depend on constants, parameters, time and positions only",
    ),
    ("output o [1] = wrap(1, 2, 3);", "`wrap` takes 1 or 2 arguments, found 3"),
    ("output o [1] = atan2(1);", "`atan2` takes 2 arguments, found 1"),
    ("output o [1] = sin(link.end.x);", "the argument of `sin` is given a length: expected rad, found m"),
    ("output o [1] = exp(base.angle);", "the argument of `exp` is given an angle: expected 1, found rad"),
    ("output o [1] = 1 < 2;", "a condition is no value: write `if(condition, value, other)`"),
    ("output o [1] = if(1, 2, 3);", "expected a condition, such as `a < b`"),
    ("output o [1] = 1 < 2 < 3;", "comparisons do not chain: write `a < b and b < c`"),
    ("output o [1] = 2 ** 3;", "`**` is no operator: a power is written `a^2`"),
    ("output o [1] = 2 % 3;", "`%` is no operator of the language"),
    ("output o [1] = if(1 < 2 && 2 < 3, 1, 2);", "`&` is no operator: write `and`"),
    (
        "output o [1] = 1.0f32;",
        "`1.0f32` is not a plain decimal number: write digits without suffix, such as `1.5` or `2e-3`",
    ),
    ("output o [1] = +1;", "a sign `+` before a value says nothing: leave it out"),
    ("output o [1] = 1/0;", "division by zero"),
    ("output o [1] = 2^heavy;", "an exponent must be a number known here; for others write `exp(b*ln(a))`"),
    ("output o [rad/s] = 3 [Hz];", "`o` is given a frequency: expected rad/s, found 1/s; write rad/s or rpm"),
    (
        "output o [rad/s] = base.rate + 3 [Hz];",
        "the summands do not fit: an angular rate (rad/s) meets a frequency (1/s); write rad/s or rpm",
    ),
    ("output o [Hz] = base.rate;", "`o` is given an angular rate: expected 1/s, found rad/s"),
    (
        "output o [m] = rail.angle + 1 [m];",
        "`rail` has no angle: one of its two bodies is a particle, which has no orientation",
    ),
    ("output o [m] = base.travel;", "the revolute joint `base` has no travel; it has angle, rate"),
    (
        "output o [N] = base.force;",
        "the revolute joint `base` has no force; it has angle, rate, and what it carries is `base.reaction.x`, `.y` or `.size`, in outputs",
    ),
    (
        "output o [rad] = block.angle;",
        "`block` is a particle and has no orientation; write `body`, `rod`, `disk` or `box` for one that turns",
    ),
    ("output o [1] = drive.effort;", r#"no body, joint or driver called "drive""#),
    ("output o [W] = power(crank);", "`crank` is a body, expected the name of a load"),
    (
        "output o [deg] = acos(0.5);",
        "the value is an angle in rad already and would be converted a second time by [deg]; write [rad]",
    ),
    (
        "output o [s] = time [s];",
        r#"no index or constant called "s"; brackets after a name are an index, a unit follows a number or `)`"#,
    ),
    ("output o [m] = crank.pin.z;", "the place `crank.pin` has x, y, velocity.x and velocity.y"),
    (
        "output o [m] = distance(crank.pin, crank.origin);",
        "the distance of two places of one body never changes",
    ),
    ("output o [m] = distance(crank.pin, 3);", "expected a place: `body.point` or `ground(x, y) [m]`"),
    ("output o [m] = ground(0, 0);", "a place is no value; `distance(a.p, ground(0, 0))` is one"),
    (
        "output heavy[x] [m] = 1;",
        r#"no index or constant called "x"; only variables of `repeat` and constants can be used here"#,
    ),
    ("output type [m] = 1;", "`type` is a word of Rust and cannot be a name; choose another"),
    ("param time [s] = 1;", "`time` has a meaning of its own here; choose another name"),
    (
        "param link [m] = base.angle;",
        "`base.angle` is a position, but a constant or default value may depend on constants only",
    ),
    (
        "param p [kg] = heavy;",
        "`heavy` is a parameter, but a constant or default value may depend on constants only",
    ),
    (
        "param p [kg] = 1 in 2..3;",
        "the default of `p` lies outside of its bounds: 1 is not in 2..3 (SI units); widen the bounds or change the default",
    ),
    (
        "start { base.rate [rad/s] ~ 3; }",
        "`base.rate` cannot be guessed: write `=` for a rate that is to be met, or leave it out; rates that are not stated \
         are those of least kinetic energy",
    ),
    ("param p [kg] = 1 in 3..0;", "the bounds of `p` hold no value: write the smaller one first"),
    ("param p [kg] = 1 [m];", "`p` is given a length: expected kg, found m"),
    (
        "input u [N] = 3;",
        "an input has no value here, it is given at every call; write `param u …` for a value that stays",
    ),
    ("input u [];", "the unit is missing: write `[1]` for a plain number"),
    (
        "const A [m] = B; const B [m] = A;",
        "the constants stand in a circle: `A` is defined by `B`, that by `A`. Give one of them a value",
    ),
    (
        "const A [m] = B; const B [m] = 2 * C; const C [m] = D - A; const D [m] = 1;",
        "the constants stand in a circle: `A` is defined by `B`, that by `C`, that by `A`. Give one of them a value",
    ),
    ("const A [m] = A;", "the constant `A` is defined by itself: give it a value"),
    (
        "const A = 2 * B; const B = C / 2; const C = A; repeat i in 0..A { output o[i] [1] = i; }",
        "the constants stand in a circle: `A` is defined by `B`, that by `C`, that by `A`. Give one of them a value",
    ),
    (
        "drive d: distance(crank.pin, link.end) = 0.4 [m];",
        "a driver moves one coordinate, such as `crank_pin.angle`; a distance of two places that follows a law is a joint: \
         `joint d: distance(one, other, length [m] = …);`",
    ),
    ("const A [Nm] = 1;", r#"no unit called "Nm"; did you mean `N*m`?"#),
    ("const A [mrad] = 1;", "`rad` takes no prefix: write the factor that `m` stands for into the number"),
    ("const A [m2] = 1;", r#"no unit called "m2"; did you mean `m^2`?"#),
    ("const A [degrees] = 1;", r#"no unit called "degrees"; did you mean `deg`?"#),
    (
        "const A [m+s] = 1;",
        "not a unit at `+s`: write products, quotients and integer powers, such as `kg*m^2/s`",
    ),
    ("gravity [m/s^2] = (0, -9.81); gravity [m/s^2] = (0, -9.81);", "gravity is given twice; write it once"),
    (
        "gravity [m/s^2] = -9.81;",
        "expected `(x, y)`, found `-`; a vector has all its components in parentheses",
    ),
    (
        "gravity = (0, -9.81);",
        "gravity is given a plain number: expected m/s^2; write the unit, as in `-9.81 [m/s^2]`",
    ),
    ("body b { mass [kg] = 1; }", "the body `b` has no inertia: write `inertia [kg*m^2] = …;`"),
    ("body b { inertia [kg*m^2] = 1; }", "the body `b` has no mass: write `mass [kg] = …;`"),
    ("rod b { mass [kg] = 1; }", "the rod `b` has no length: write `length [m] = …;`"),
    ("rod b { mass [kg] = 1; length [m] = -1; }", "the length of `b` must be positive, found -1 m"),
    (
        "rod b { mass [kg] = 1; width [m] = 1; }",
        "a rod has no `width`; it has mass, density, length, radius, inertia, and points and lines",
    ),
    (
        "disk b { density [kg/m^3] = 1; radius [m] = 1; }",
        "the mass of the disk `b` follows from its density only with a thickness: write `thickness [m] = …;`, or its `mass`",
    ),
    (
        "box b { density [kg/m^3] = 1; width [m] = 1; height [m] = 1; thickness [m] = -1; }",
        "the thickness of `b` must be positive, found -1 m",
    ),
    (
        "rod b { mass [kg] = 1; length [m] = 1; center [m] = (0, 0); }",
        "the centre of a rod is its middle; write `body` with a mass, an inertia and a centre instead",
    ),
    (
        "rod b { mass [kg] = 1; length [m] = 1; point end [m] = (0, 0); }",
        "a rod has a point `end` of its own; choose another name",
    ),
    (
        "particle b { mass [kg] = 1; point p [m] = (0, 0); }",
        "a particle has no extent: everything attached to `b` sits at `b.center`. Write `body` for more",
    ),
    (
        "disk b { mass [kg] = -1; radius [m] = 1; } joint jb: revolute(crank.pin, b.center);",
        "the mass of `b` is negative: -1 kg; it must be zero or more",
    ),
    (
        "body b { mass [kg] = 1; inertia [kg*m^2] = -1; } joint jb: revolute(crank.pin, b.center);",
        "the moment of inertia of `b` is negative: -1 kg*m^2; it must be zero or more",
    ),
    ("body b { mass [kg] = 1; mass [kg] = 2; inertia [kg*m^2] = 1; }", "`mass` of `b` is given twice"),
    (
        "body b { mass [kg] = drive / 1 [N*m] * 1 [kg]; inertia [kg*m^2] = 1; }",
        "`drive` is an input, but a property of a body may depend on constants and parameters only",
    ),
    (
        "body b { mass [kg] = time; inertia [kg*m^2] = 1; }",
        "`time` is the time, but a property of a body may depend on constants and parameters only",
    ),
    ("body b { mas [kg] = 1; inertia [kg*m^2] = 1; }", "a body has no `mas`; did you mean `mass`?"),
    (
        "body b { mass [kg] = 1; inertia [kg*m^2] = 1; point center [m] = (0, 0); }",
        "`center` has a meaning of its own here; choose another name",
    ),
    (
        "body b { mass [kg] = 1; inertia [kg*m^2] = 1; point p [m] = (0, 0, 0); }",
        "a planar mechanism has two coordinates: leave the third out, or write `spatial` before the name of the \
         mechanism",
    ),
    (
        "body b { mass [kg] = 1; inertia [kg*m^2] = 1; line l = (crank.pin, b.center); }",
        "a line of `b` goes through two places of `b`, but `crank.pin` is none of them",
    ),
    (
        "body b { mass [kg] = 1; inertia [kg*m^2] = 1; point p [m] = (0, 1); line l = (p, b.center); }",
        "a place is written with its body: `b.p`",
    ),
    (
        "body b { mass [kg] = 1; inertia [kg*m^2] = 1; line l = (b.center, b.origin); } joint jb: revolute(crank.pin, b.center);",
        "the two ends of `l` are the same point, so it has no direction",
    ),
    (
        "body b[i] { mass [kg] = 1; inertia [kg*m^2] = 1; }",
        r#"no index or constant called "i"; only variables of `repeat` and constants can be used here"#,
    ),
    ("body base { mass [kg] = 1; inertia [kg*m^2] = 1; }", "`base` is declared twice; rename one of them"),
    (
        "joint j: revolute(crank.pin, crank.center);",
        "the joint `j` connects `crank` with itself; its two places must belong to different bodies",
    ),
    (
        "joint j: revolute(ground(0, 0), ground(1, 0) [m]);",
        "the joint `j` connects the ground with itself; one of its places must belong to a body",
    ),
    (
        "joint j: revolute(ground(1, 0), link.end);",
        "the place is given a plain number: expected m; write the unit, as in `1 [m]`",
    ),
    (
        "joint j: revolute(link, crank.pin);",
        "a place is a point of a body: write `link.center` or another point of it",
    ),
    (
        "joint j: revolute(base, crank.pin);",
        "`base` is a joint and has no points; places belong to bodies or to the ground",
    ),
    (
        "joint j: revolute(ground, crank.pin);",
        "`ground` needs a place: write `ground(0, 0)`, or `ground(0.1, 0.2) [m]`",
    ),
    (
        "joint j: revolute(crank.pin);",
        "`revolute` needs 2 unnamed arguments first, found 1; a place of the ground is written `ground(x, y) [m]`",
    ),
    (
        "joint j: revolute(crank.pin, link.end, 3);",
        "expected a named argument, found `3`; there are no further arguments",
    ),
    (
        "joint j: revolute(crank.pin, link.end, angle = 3);",
        r#"`revolute` has no argument called "angle"; it takes none"#,
    ),
    ("joint j: prismatic(crank.pin, link.end);", "`prismatic` needs its axis: write `axis = (1, 0)`"),
    (
        "joint j: prismatic(crank.pin, link.end, axis = (0, 0));",
        "the axis is zero: it points nowhere; write for instance (1, 0)",
    ),
    (
        "joint j: prismatic(crank.pin, block.center, axis = (1, 0));",
        "a prismatic joint holds an orientation, and the particle at `block.center` has none; write `point_on_line`",
    ),
    (
        "joint j: fixed(crank.pin, block.center);",
        "a fixed joint holds an orientation, and the particle at `block.center` has none; write `revolute`",
    ),
    (
        "joint j: prismatic(crank.pin, link.end, axis = (time, 0));",
        "`time` is the time, but a direction may depend on constants and parameters only",
    ),
    (
        "joint j: prismatic(crank.pin, link.end, axis = (1, 0), axis = (0, 1));",
        "`axis` of `prismatic` is given twice",
    ),
    (
        "joint j: distance(crank.pin, link.end, length = 3);",
        "length is given a plain number: expected m; write the unit, as in `3 [m]`",
    ),
    (
        "joint j: distance(crank.pin, link.end, length [m] = 0);",
        "the length of `j` must be positive; write `revolute` for two places that coincide",
    ),
    (
        "joint j: point_on_line(crank.pin, link.end);",
        "`crank.pin` is a point; the first argument is a line, such as `line(crank.pin, …)`",
    ),
    (
        "joint j: point_on_line(ground(0, 0), link.end);",
        "the first argument is the line: write `line(ground(0, 0), ground(1, 0) [m])`, then the point",
    ),
    ("joint j: point_on_line(crank.slot, link.end);", r#"`crank` has no line called "slot"; it has arm"#),
    (
        "joint j: point_on_line(link.slot, crank.pin);",
        "`link` has no line: declare `line slot = (…, …);` in its braces",
    ),
    (
        "joint j: point_on_line(line(crank.pin, link.end), block.center);",
        "a line goes through two places of one body, but `crank.pin` and `link.end` belong to different ones",
    ),
    (
        "joint j: point_on_line(line(ground(0, 0), ground(time * 1 [m/s], 0)), link.end);",
        "`time` is the time, but a direction may depend on constants and parameters only",
    ),
    ("joint j: revolut(crank.pin, link.end);", r#"no joint called "revolut"; did you mean `revolute`?"#),
    (
        "joint j: spherical(crank.pin, link.end);",
        "a spherical joint needs space: write `spatial` before the name of the mechanism",
    ),
    (
        "constraint c: base.angle == 3 [rad];",
        "expected `=` between the two sides of the constraint, found `;`; one `=` is enough here, `==` only compares",
    ),
    (
        "constraint c: base.rate = 3 [rad/s];",
        "`base.rate` is a velocity, but a constraint may depend on constants, parameters, time and positions only",
    ),
    (
        "constraint c: base.angle = drive;",
        "`drive` is an input, but a constraint may depend on constants, parameters, time and positions only",
    ),
    (
        "constraint c: base.angle = 3;",
        "the two sides of the constraint do not fit: a plain number meets an angle; write the unit, as in `3 [rad]`",
    ),
    ("constraint c: heavy = 3 [kg];", "the constraint `c` names nothing that can move, such as `knee.angle`"),
    ("constraint c: gear(base, base, ratio = 2);", "`c` couples something with itself"),
    ("constraint c: gear(base, knee, ratio = 0);", "the ratio of `c` is zero: nothing would be passed on"),
    ("constraint c: gear(base, knee);", "`gear` needs its ratio: write `ratio = …`"),
    (
        "constraint c: gear(base, wrist, ratio = 2);",
        "`wrist` has no angle: one of its two bodies is a particle, which has no orientation",
    ),
    ("constraint c: gear(base, kne, ratio = 2);", r#"no joint or body called "kne"; did you mean "knee"?"#),
    ("constraint c: gear(base, knee, ratio = 2 [m]);", "ratio is given a length: expected 1, found m"),
    (
        "constraint c: rack(base, knee, radius = 2 [m]);",
        "the revolute joint `knee` has no travel; it has angle, rate",
    ),
    ("constraint c: rack(base, rail, radius = 0);", "the radius of `c` is zero: nothing would be passed on"),
    (
        "constraint c: belt(base, knee, radius [m] = 0.1);",
        "`belt` needs its second_radius: write `second_radius = …`",
    ),
    (
        "drive d: base.rate = 3 [rad/s];",
        "`base.rate` cannot be driven: only an angle, a travel or a position can; a rate is driven through its angle or travel, such as `angle = 3 [rad/s]*time`",
    ),
    ("drive d: base.angle = 15 * time;", "`base.angle` is given a time: expected rad, found s"),
    (
        "drive d: base.angle = base.angle;",
        "`base.angle` is a position, but the law of a driver may depend on constants, parameters and time only",
    ),
    (
        "drive d: base.angle = 1 [rad]; drive e: base.angle = 2 [rad];",
        "`e` drives what `d` drives already: remove one of them",
    ),
    (
        "force f: force(crank.pin, direction = (0, 0)) = 3 [N];",
        "the direction is zero: it points nowhere; write for instance (1, 0)",
    ),
    (
        "force f: force(crank.pin, direction = (1, 0)) = 3;",
        "`f` is given a plain number: expected N; write the unit, as in `3 [N]`",
    ),
    (
        "force f: force(ground(0, 0)) = (1, 0) [N];",
        "`f` acts at `ground(0, 0)`, a place of the ground, which nothing moves: write a place of a body, `body.point`",
    ),
    (
        "#[allow(unusd)] body b { mass [kg] = 1; inertia [kg*m^2] = 1; }",
        r#"no warning called "unusd"; did you mean `unused`?"#,
    ),
    (
        "#[inline] body b { mass [kg] = 1; inertia [kg*m^2] = 1; }",
        "`#[inline]` has no effect here: doc comments and `#[allow(unused)]`, `no_effect` or `outside` may stand before any \
         statement, other attributes before the mechanism, parameters, inputs, states and outputs",
    ),
    (
        "#[cfg(feature = \"wheel\")] body b { mass [kg] = 1; inertia [kg*m^2] = 1; }",
        "`#[cfg]` has no effect within a mechanism, whose equations have all of its parts: put it before the whole \
         `mechanism!`",
    ),
    (
        "force f: force(crank.pin) = 3 [N];",
        "a force needs two components, `force(place) = (fx, fy)`, or a direction, `force(place, direction = (1, 0)) = law`",
    ),
    (
        "force f: torque(rail) = 3 [N*m];",
        "`rail` has no angle: one of its two bodies is a particle, which has no orientation",
    ),
    (
        "force f: torque(block) = 3 [N*m];",
        "`block` is a particle and has no orientation; write `body`, `rod`, `disk` or `box` for one that turns",
    ),
    (
        "force f: torque(base) = energy;",
        "`energy` is a result, but the law of a load may depend on constants, parameters, time, inputs, states, positions and velocities only",
    ),
    (
        "force f: spring(crank.pin, crank.center, stiffness = 3 [N/m], length = 1 [m]);",
        "`crank.pin` and `crank.center` never move apart, so nothing between them does anything: name a place of another body, or leave it out",
    ),
    (
        "force f: spring(crank.pin, link.end, stiffness = 3 [N/m], length = -1 [m]);",
        "the length of `f` is negative: -1 m; it must be zero or more",
    ),
    (
        "force f: spring(crank.pin, link.end, stifness = 3 [N/m], length = 1 [m]);",
        r#"`spring` has no argument called "stifness"; did you mean `stiffness`?"#,
    ),
    (
        "spring f: damper(crank.pin, link.end, damping = 3 [N*s/m]);",
        "a `spring` cannot be a damper: write `force` or `damper` before the name",
    ),
    (
        "force f: damper(crank.pin, link.end, damping = 3 [N*s/m]) = 3;",
        "a damper has no law behind it, its arguments say all; write `;`",
    ),
    (
        "force f: friction(base);",
        "friction acts in a joint or a contact: write `friction name: on(joint) = coulomb(coefficient = 0.2, radius [m] = 0.01, speed [rad/s] = 0.05);`",
    ),
    ("start { base.angle [m] = 3; }", "`base.angle` is given a length: expected rad, found m"),
    (
        "start { base.angle = 3; }",
        "`base.angle` is given a plain number: expected rad; write the unit, as in `3 [rad]`",
    ),
    ("start { base.angle [deg] = 3; base.angle [deg] ~ 4; }", "the start of `base.angle` is given twice"),
    (
        "start { power [W] = 3; }",
        r#"no index or constant called "W"; brackets after a name are an index, a unit follows a number or `)`"#,
    ),
    ("start { knee.travel [m] = 3; }", "the revolute joint `knee` has no travel; it has angle, rate"),
    ("options { coordinates = best; }", "expected `absolute` or `tree` or `auto`, found `best`"),
    (
        "options { solution = null_space; }",
        "expected `multipliers` or `independent` or `auto`, found `null_space`",
    ),
    ("options { solution = auto; solution = auto; }", "`solution` of `options` is given twice"),
    ("options { redundant = most; }", "expected `refuse` or `drop` or `keep`, found `most`"),
    (
        "options { emit = (tangents); }",
        "expected `penalty` or `projection` or `null_space` or `tangent`, found `tangents`",
    ),
    ("options { cuts = base; }", r#"nothing here is called "cuts"; did you mean `cut`?"#),
    ("options { cut = bas; }", r#"no joint called "bas"; did you mean "base"?"#),
    ("options { cut = (base, base); }", "`base` is cut twice"),
    ("options { coordinates = tree; coordinates = auto; }", "`coordinates` of `options` is given twice"),
    (
        "options { independent = base.rate; }",
        "`base.rate` cannot be an independent coordinate: only an angle, a travel or a position can",
    ),
    (
        "expect { freedom = 1; }",
        r#"nothing that can be expected is called "freedom"; did you mean `degrees_of_freedom`?"#,
    ),
    (
        "expect { rotates = rail; }",
        r#"`rail` has no angle: one of its two bodies is a particle, which has no orientation"#,
    ),
    (
        "expect { rotates = block; }",
        r#"`block` is a particle and has no orientation; write `body`, `rod`, `disk` or `box` for one that turns"#,
    ),
    ("expect { rotates = (base, knees); }", r#"no joint or body called "knees"; did you mean "knee"?"#),
    ("expect { rotates; }", "expected `=`, found `;`"),
    ("expect { no_singularity = 1; }", "expected `;`, found `=`"),
    (
        "expect { knee.angle = 1; }",
        "expected `in` and a range such as `10..170 [deg]`, or `>` or `<` and a force, found `=`",
    ),
    ("expect { knee.angle in 1 [rad]; }", "expected `..`, found `;`"),
    (
        "expect { knee.angle in 170..10 [deg]; }",
        r#"the range is upside down: from 170 to 10 deg; write `10..170 [deg]`, or `170..370 [deg]` if it goes on past half a turn"#,
    ),
    (
        "expect { knee.angle in 0..heavy*1 [rad/kg]; }",
        r#"`heavy` is a parameter, but an expected range may depend on constants only"#,
    ),
    (
        "expect { knee.angle in 0..base.angle; }",
        r#"`base.angle` is a position, but an expected range may depend on constants only"#,
    ),
    (
        "expect { knee.angle [deg] in 10..170 [m]; }",
        r#"`knee.angle` is given a length: expected rad, found m"#,
    ),
    ("expect { rail.travel in 10..20 [deg]; }", r#"`rail.travel` is given an angle: expected m, found rad"#),
    (
        "expect { knee.rate in 1..2 [rad/s]; }",
        r#"`knee.rate` cannot be expected in a range: only an angle, a travel or a position can"#,
    ),
    (
        "expect { energy in 1..2 [J]; }",
        r#"nothing that can be expected is called "energy"; there are degrees_of_freedom, operations, live_values, rotates, no_singularity, contact_time, friction_time, frequency, deflection and ranges such as `knee.angle in 10..170 [deg]`"#,
    ),
    ("expect { no_singularity; no_singularity; }", r#"`no_singularity` of `expect` is given twice"#),
    ("expect { operations = 3; }", "expected `<=`, found `=`"),
    ("expect { live_values(mass_matrix) < 3; }", "expected `<=`, found `<`"),
    (
        "expect { live_value <= 3; }",
        r#"nothing that can be expected is called "live_value"; did you mean `live_values`?"#,
    ),
    ("options { self_check = maybe; }", "expected `on` or `off`, found `maybe`"),
    ("options { self_check = on; self_check = off; }", "`self_check` of `options` is given twice"),
    ("expect { degrees_of_freedom = -1; }", "-1 is negative; indices and counts start at 0"),
    (
        "repeat i in 0..N { }",
        r#"no index or constant called "N"; only variables of `repeat` and constants can be used here"#,
    ),
    (
        "repeat i in 0..1.5 { }",
        "expected a whole number: digits, constants, variables of `repeat` and + - * / ^",
    ),
    ("repeat i in 0..2 { const A [m] = 1; }", "constants stand outside of `repeat`"),
    (
        "repeat i in 0..2 { repeat i in 0..2 { } }",
        "`i` is the variable of an outer `repeat` already; choose another name",
    ),
    (
        "repeat i in 0..2 { body b[i-1] { mass [kg] = 1; inertia [kg*m^2] = 1; } }",
        "-1 is negative; indices and counts start at 0",
    ),
    (
        "output a_1 [1] = 1; repeat i in 1..2 { output a[i] [1] = 1; }",
        "`a[1]` and `a_1` become the same name in Rust; rename one of them",
    ),
    (
        "cable c: (base.start, ground(0, 0)) = 1;",
        "expected the kind of the load (force, torque, spring, cable, damper, torsion_spring, shaft, along, masing, bouc_wen, bushing, mesh), found `(`",
    ),
    ("jiont j: revolute(crank.pin, link.end);", "no statement begins with `jiont`; did you mean `joint`?"),
    ("3;", "expected a statement, found `3`"),
    ("output o [1] = sin(30);", "sin of a bare number: write its unit, `sin(30 [deg])` or `sin(30 [rad])`"),
    (
        "output o [1] = distance(crank.pin.x, ground(0, 0));",
        "`crank.pin.x` is not a place: a place is written `body.point`",
    ),
    (
        "line l = (crank.pin, crank.center);",
        "a line of a body stands inside the braces of the body; out here lines go through places of the ground",
    ),
    (
        "joint j: point_on_line(crank, link.end);",
        "`crank` is a body, expected a line such as `crank.slot` or `line(place, place)`",
    ),
    ("output o [W] = motor.power;", "a load has no quantities but its power: write `power(motor)`"),
    ("output o [m] = way.x;", "`way` is a line and has no quantities"),
    (
        "joint j: distance(crank.pin, link.end, length [m] = 1); output o [m] = j;",
        "`j` is a joint without coordinates, expected a value",
    ),
    ("drive d: base.angle = 1 [rad/s]*time; output o [W] = d.force;", "the driver `d` has effort and power"),
    ("constraint c: base.angle = 1 [rad]; output o [W] = c.force;", "the constraint `c` has an effort"),
    (
        "constraint c: base.angle = 1 [rad] + c.effort/1 [N*m/rad];",
        "`c.effort` is a result, but a constraint may depend on constants, parameters, time and positions only",
    ),
    ("output o [W] = power(3);", "`power` takes the name of a load"),
    (
        "drive d: base.angle = 1 [rad/s]*time; output o [W] = power(d);",
        "the power of a driver is written `d.power`",
    ),
    (
        "start { base.rate [rad/s] = (1, 2); }",
        "one number is expected here, and these parentheses hold several: components are given one by one, such as \
         `rod.rate.x [rad/s] = 1;`, and a vector stands only where places, axes and forces are",
    ),
    (
        "sphere s { mass [kg] = 1; radius [m] = 1; }",
        "`sphere` needs space: write `spatial` before the name of the mechanism",
    ),
    ("output o [m] = heavy/2 + 1 [m];", "the summands do not fit: a mass (kg) meets a length (m)"),
    (
        "output o [m] = (1 + pi)/2 + link.end.x;",
        "the summands do not fit: a plain number meets a length; write its unit as a factor, `… * 1 [m]`",
    ),
    ("output o [1] = link.end.x^0.1234567;", "a length to the power 0.1234567 has no unit"),
    (
        "quark q;",
        "no statement begins with `quark`; statements begin with const, param, input, body, joint, force, start and the like",
    ),
    ("const A [1] = exp(1000);", "this has no value: it is infinite"),
    ("output o [1] = if(1 < 2 || 2 < 3, 1, 2);", "`|` is no operator: write `or`"),
    ("output o [1] = if(!(1 < 2), 1, 2);", "`!` is no operator: write `not`"),
    (
        "joint j: revolute(place(0, 0), link.end);",
        "`place(…)` is not a place: write `body.point` or `ground(x, y) [m]`",
    ),
    ("output o[] [m] = 1;", "the index is missing"),
    (
        "start { repeat i in 0..2 { base.angle [deg] = 3; } }",
        "`repeat` goes around the block: write `repeat i in 0..N { start { … } }`",
    ),
    (
        "body b { density [kg/m^3] = 1; inertia [kg*m^2] = 1; }",
        "the volume of a body is not known, so it has no `density`: write its `mass`",
    ),
];
