//! Parts: what they bring, what they see, their mistakes, the library.

use crate::{bad, good, warnings};
use linkwright_compiler::source::{PARTS, Source, definition, library};
use linkwright_compiler::{Compiled, compile, counts, syntax};

/// A hull on a rail, with statements behind it.
fn hull(more: &str) -> String {
    format!(
        "planar Walker {{
    gravity [m/s^2] = (0, -9.81);
    body hull {{ mass [kg] = 10; inertia [kg*m^2] = 1; point left [m] = (-0.2, 0); }}
    joint rail: prismatic(ground(0, 1) [m], hull.center, axis = (1, 0));
    table soft(angle [rad]) [N*m] = [(-1, -2), (1, 2)], outside = linear;
{more}
}}"
    )
}

/// A leg with statements in it, and a use of it.
fn leg(inside: &str, arguments: &str) -> String {
    hull(&format!(
        "part Leg(hip: place, length [m] = 0.4) {{
        rod thigh {{ mass [kg] = 1; length = length; }}
        joint pin: revolute(hip, thigh.start);
        {inside}
    }}
    part left: Leg({arguments});"
    ))
}

fn compiled(source: &str) -> Compiled {
    let tokens = source.parse().expect("the source consists of tokens");
    compile(tokens, None).unwrap_or_else(|errors| panic!("{errors}"))
}

#[test]
fn a_part_is_what_it_would_be_written_out() {
    let parts = hull(
        "part Shank(knee: place, share [1]) {
            rod bone { mass = share*2 [kg]; length [m] = 0.3; point heel [m] = (0.1, 0.02); }
            joint pin: revolute(knee, bone.start);
            signal bent [rad] = pin.angle - 0.1 [rad];
        }
        part Leg(hip: place, side [1] = 1, soft: table, on: body) {
            const N = 2;
            param stiff [N*m/rad] = 3;
            state tired [N*m*s] = 0.1*side*1 [N*m*s];
            rate tired = -soft(pin.angle);
            rod thigh { mass [kg] = 1.5; length [m] = 0.4; }
            joint pin: revolute(hip, thigh.start);
            repeat i in 0..N { part shank[i]: Shank(knee = thigh.end, share = 1 + i); }
            torque muscle: torque(shank[1].pin) = -stiff*shank[0].bent - 2 [1/s]*tired;
            spring tie: spring(shank[0].bone.heel, on.center, stiffness [N/m] = 20, length [m] = 0.1);
            start { pin.angle = 0.3 [rad]*side; shank[N - 1].pin.angle [rad] = 0.5; }
        }
        part left: Leg(hip = hull.left, side = -1, soft = soft, on = hull);
        part right: Leg(hip = ground(0, 0.5) [m], soft = soft, on = left.thigh);
        output lead [rad] = left.shank[1].pin.angle - right.pin.angle;",
    );
    let leg = |name: &str, hip: &str, side: &str, on: &str| {
        let shank = |i: usize| {
            format!(
                "rod NAME_shank_{i}_bone {{ mass = (1 + {i})*2 [kg]; length [m] = 0.3; point heel [m] = (0.1, 0.02); }}
                joint NAME_shank_{i}_pin: revolute(NAME_thigh.end, NAME_shank_{i}_bone.start);"
            )
        };
        format!(
            "param NAME_stiff [N*m/rad] = 3;
            state NAME_tired [N*m*s] = 0.1*({side})*1 [N*m*s];
            rate NAME_tired = -soft(NAME_pin.angle);
            rod NAME_thigh {{ mass [kg] = 1.5; length [m] = 0.4; }}
            joint NAME_pin: revolute({hip}, NAME_thigh.start);
            {} {}
            torque NAME_muscle: torque(NAME_shank_1_pin) =
                -NAME_stiff*(NAME_shank_0_pin.angle - 0.1 [rad]) - 2 [1/s]*NAME_tired;
            spring NAME_tie: spring(NAME_shank_0_bone.heel, {on}.center, stiffness [N/m] = 20, length [m] = 0.1);
            start {{ NAME_pin.angle = 0.3 [rad]*({side}); NAME_shank_1_pin.angle [rad] = 0.5; }}",
            shank(0),
            shank(1),
        )
        .replace("NAME", name)
    };
    let written = hull(&format!(
        "{} {} output lead [rad] = left_shank_1_pin.angle - right_pin.angle;",
        leg("left", "hull.left", "-1", "hull"),
        leg("right", "ground(0, 0.5) [m]", "1", "left_thigh"),
    ));
    let (parts, written) = (compiled(&parts), compiled(&written));
    let rows = |compiled: &Compiled| format!("{:?}", counts::rows_of("walker", compiled, "chosen"));
    assert_eq!(rows(&parts), rows(&written));
    assert_eq!(parts.assembly.q, written.assembly.q);
    let names = |compiled: &Compiled| -> Vec<String> {
        let mechanism = &compiled.mechanism;
        let bodies = mechanism.bodies.iter().map(|body| body.name.identifier());
        let joints = bodies.chain(mechanism.joints.iter().map(|joint| joint.name.identifier()));
        joints.chain(mechanism.parameters.iter().map(|parameter| parameter.name.identifier())).collect()
    };
    assert_eq!(names(&parts), names(&written));
    let used: Vec<(&str, &str)> =
        parts.mechanism.parts.iter().map(|part| (part.name.text.as_str(), part.of.as_str())).collect();
    let legs = [("left", "Leg"), ("left.shank[0]", "Shank"), ("left.shank[1]", "Shank")];
    let others = [("right", "Leg"), ("right.shank[0]", "Shank"), ("right.shank[1]", "Shank")];
    assert_eq!(used, [legs, others].concat());
}

#[test]
fn values_that_are_given_count_rounds() {
    let mechanism = good(&hull(
        "const N = 2;
        part Row(at: place, n [1]) {
            repeat i in 0..n { rod link[i] { mass [kg] = 1; length [m] = 0.1; } joint pin[i]: revolute(at, link[i].start); }
        }
        part row: Row(at = hull.left, n = N + 1);",
    ));
    let names: Vec<&str> = mechanism.bodies.iter().map(|body| body.name.text.as_str()).collect();
    assert_eq!(names, ["hull", "row.link[0]", "row.link[1]", "row.link[2]"]);
    assert!(mechanism.unused.iter().all(|unused| unused.name.text == "soft"), "{:?}", mechanism.unused);
}

#[test]
fn what_is_given_may_be_anything_that_may_stand_there() {
    let inside = "input u [N]; spring s: spring(hip, thigh.end, stiffness [N/m] = 2, length = length); output o [m] = hip.x;";
    good(&leg(inside, "hip = hull.left, length [cm] = 30"));
    good(&leg("output far [m] = distance(hip, thigh.end);", "hip = ground(0, 1) [m]"));
    // A parameter stays one.
    let mechanism = good(&hull(
        "param reach [m] = 0.3;
        part Leg(hip: place, length [m]) { rod thigh { mass [kg] = 1; length = length; } joint pin: revolute(hip, thigh.start); }
        part left: Leg(hip = hull.left, length = reach);",
    ));
    assert_eq!(mechanism.bodies[1].dimensions.len(), 1);
    assert!(linkwright_compiler::model::value_at(&mechanism.bodies[1].dimensions[0].1, &[0.7]) == Some(0.7));
}

#[test]
fn mistakes_have_one_message_each() {
    let fine = "hip = hull.left";
    let many: String = (0..110).map(|index| format!("output o{index} [1] = 1;")).collect();
    let cases: Vec<(String, &str)> = vec![
        (leg("", "length [m] = 1"), "`Leg` needs to be given `hip`, a place: write `hip = …`"),
        (hull("part P(k [1]) { } part p: P();"), "`P` needs to be given `k`, a value: write `k = …`"),
        (hull("part P(k [1] = 1 2) { output o [1] = k; } part p: P();"), "expected `,` or `)`, found `2`"),
        (leg("", "hipp = hull.left"), "`Leg` has no port called `hipp`; did you mean `hip`?"),
        (leg("", "hip = hull.left, quack = 1"), "`Leg` has no port called `quack`; it is given hip, length"),
        (hull("part P() { } part p: P(k = 1);"), "`P` has no port called `k`; it is given nothing"),
        (leg("", "hip = hull.left, hip = hull.left"), "`hip` of `Leg` is given twice"),
        (leg("", "hip = hull"), "a place is a point of a body: write `hull.center` or another point of it"),
        (leg("", "hip = 3"), "expected a place such as `crank.tip` or `ground(0, 0)`, found `3`"),
        (leg("", "hip hull.left"), "expected `=` and what `hip` is given, found `hull`"),
        (leg("", "hip = hull.left, length = 2 [s]"), "`left.length` is given a time: expected m, found s"),
        (leg("", "hip = hull.left; "), "expected `,` or `)`, found `;`"),
        (
            leg("part Inner() { }", fine),
            "`Inner` is declared within a part or a `repeat`; declare it beside the bodies of the mechanism",
        ),
        (
            hull("repeat i in 0..2 { part Inner = file(\"inner.mech\"); }"),
            "`Inner` is declared within a part or a `repeat`; declare it beside the bodies of the mechanism",
        ),
        (
            hull("part Leg { } part Leg() { }"),
            "a part called `Leg` is declared already; give one of them another name",
        ),
        (hull("part p: Quack();"), "no part called \"Quack\""),
        (hull("part p: DcMoto();"), "no part called \"DcMoto\"; did you mean \"DcMotor\"?"),
        (hull("part p = Leg();"), "expected `file(\"…\")`, found `Leg`"),
        (hull("part P = file(leg);"), "expected the name of a file in quotes, found `leg`"),
        (hull("part P() ;"), "expected `{` and the statements of the part, found `;`"),
        (
            hull("part p Leg();"),
            "expected `:` and which part it is, such as `Leg(hip = hull.left);`, found `Leg`",
        ),
        (
            hull("part P(a: plate) { } part p: P(a = hull.left);"),
            "`plate` is no kind of port: write `a: place`, `body`, `joint` or `table`, or the unit of a value, `a [m]`",
        ),
        (
            hull("part P(time [s]) { } part p: P(time = 1);"),
            "`time` has a meaning of its own here; choose another name",
        ),
        (hull("part P(a [s], a [m]) { } part p: P(a = 1);"), "`a` of `P` is given twice"),
        (
            hull("part P(a: joint) { } part p: P(a = hull);"),
            "`a` is to be given a joint, and `hull` is a body",
        ),
        (
            hull("param k = 1; output o = k; part P(a: body) { } part p: P(a = k);"),
            "`a` is to be given a body, and `k` is a value",
        ),
        (hull("part P(a: body) { } part p: P(a = hul);"), "no body called \"hul\"; did you mean \"hull\"?"),
        (hull("part P(a: table) { } part p: P(a = sof);"), "no table called \"sof\"; did you mean \"soft\"?"),
        (hull("part P() { part q: P(); } part p: P();"), "the part `P` uses itself; it would never end"),
        (
            hull("part P() { part q: Q(); } part Q() { part p: P(); } part p: P();"),
            "parts use one another in a circle, which would never end: P uses Q uses P",
        ),
        (
            hull(&format!(
                "part P() {{ repeat i in 0..100 {{ part q[i]: Q(); }} }} part Q() {{ {many} }} part p: P();"
            )),
            "with the statements of this part there are more than 10000; use fewer parts",
        ),
        (
            leg("gravity [m/s^2] = (0, 1);", fine),
            "`gravity` is of the whole mechanism; write it beside the uses of parts, not within one",
        ),
        (
            leg("output o [m] = hip.x;", "hip = ground(0, 1) [m]"),
            "`hip` was given a place of the ground here, which has no quantities; ask for `distance(hip, …)` or for a quantity of \
             what is joined to it",
        ),
        (
            leg("output o [m] = distance(hip, hull.center);", fine),
            "no body called `hull` in `left`: a part sees what it is given and what stands in it; give the mechanism's `hull` to it \
             by a port",
        ),
        (hull("part hull: P(); part P() { }"), "`hull` is declared twice; rename one of them"),
        (hull("part P() { } part p: P(); part p: P();"), "`p` is declared twice; rename one of them"),
        (
            hull("part P() { } repeat i in 0..2 { part p: P(); }"),
            "every round of `repeat` declares `p`: give it the index of the round, such as `p[i]`",
        ),
        (
            leg("", "hip = hull.left").replace("part left", "output o [m] = left; part left"),
            "`left` is a part, expected a value",
        ),
        (
            hull("part P() { param in [m] = 1; } part p: P();"),
            "`in` is a word of Rust and cannot be a name; choose another",
        ),
    ];
    let mut others = Vec::new();
    for (source, expected) in cases {
        let found: Vec<String> = bad(&source).iter().map(|error| error.message.clone()).collect();
        if found != [expected] {
            others.push(format!("{expected}\n  {found:?}"));
        }
    }
    assert!(others.is_empty(), "{}", others.join("\n"));
    let found: Vec<String> = bad("part Leg() { }").iter().map(|error| error.message.clone()).collect();
    assert_eq!(
        found,
        [
            "a part is declared within a mechanism, or in a file of its own that a mechanism names: `part Leg = file(\"leg.mech\");`"
        ]
    );
}

#[test]
fn what_has_a_memory_may_be_in_a_part() {
    let mechanism = good(&hull(
        "part Bush(a: place, b: place, depth [m], shaft: joint, curve: table) {
            signal way [m] = norm(b - a);
            force bush: bouc_wen(way, stiffness [N/m] = 1e4, share = 0.1, depth = depth, beta = 0.5, gamma = 0.5, exponent = 2);
            masing bar: masing(shaft, backbone = curve);
            output d [N] = bush.resistance;
        }
        table curve(angle [rad]) [N*m] = [(0, 0), (0.1, 3), (0.3, 5)], linear;
        rod arm { mass [kg] = 1; length [m] = 1; }
        joint pin: revolute(hull.left, arm.start);
        part left: Bush(a = ground(1.2, 0.5) [m], b = arm.end, depth [mm] = 2, shaft = pin, curve = curve);
        output f [N*m] = left.bar.resistance;",
    ));
    let names: Vec<&str> = mechanism.states.iter().map(|state| state.name.text.as_str()).collect();
    assert_eq!(names[0], "left.bush.deflection");
    assert!(names[1..].iter().all(|name| name.starts_with("left.bar.")), "{names:?}");
}

#[test]
fn parts_of_one_space_say_so() {
    let source = "spatial Car {
        sphere wheel { mass [kg] = 1; radius [m] = 0.3; }
        part tyre: Tyre(wheel = wheel, radius [m] = 0.3, stiffness [N/m] = 1000);
    }";
    let found: Vec<String> = bad(source).iter().map(|error| error.message.clone()).collect();
    assert_eq!(found, ["the part `Tyre` is made for the plane; use it in a `planar` mechanism"]);
}

#[test]
fn both_places_are_shown() {
    // The same mistake of two uses is said once.
    let source = leg("output o [m] = shank.end.x;", "hip = hull.left").replace(
        "part left",
        "part right: Leg(hip = hull.left);
    part left",
    );
    let tokens = source.parse().expect("the source consists of tokens");
    let errors = compile(tokens, None).map(|_| ()).expect_err("there is no shank");
    let shown: Vec<(String, Vec<String>)> = errors
        .iter()
        .map(|error| (error.message.clone(), error.notes.iter().map(|note| note.message.clone()).collect()))
        .collect();
    let note = "this is said of the part `right`, which is used here: a `Leg`";
    assert_eq!(
        shown,
        [("no body, joint or driver called \"right.shank\"".to_string(), vec![note.to_string()])]
    );
    // Of the library the message tells the place.
    let source = hull(
        "part motor: DcMotor(shaft = rail, voltage [V] = 1, resistance [ohm] = 1, inductance [H] = 1, constant [N*m/A] = 1);",
    );
    let tokens = source.parse().expect("the source consists of tokens");
    let errors = compile(tokens, None).map(|_| ()).expect_err("a rail does not turn");
    let first = errors.iter().next().expect("an error").message.clone();
    assert!(first.starts_with("the prismatic joint `rail` has no rate; it has travel, speed\n"), "{first}");
    assert!(
        first.contains("--> the library's dc_motor.mech:")
            && first.ends_with("note: within `motor`, a `DcMotor`"),
        "{first}"
    );
}

#[test]
fn a_part_of_its_own_hides_that_of_the_library() {
    let mechanism = good(
        &hull("part Tyre(a [m]) { output o = a; } part p: Tyre(a = 1);").replace("output o", "output o [m]"),
    );
    assert_eq!(mechanism.outputs.len(), 1);
}

/// Parts of the library are texts that anyone may read and begin from; each declares what it is called.
#[test]
fn the_library_declares_its_parts() {
    for name in PARTS {
        let text = library(name).expect(name);
        let (_, errors) = definition(&Source::new(name, text));
        assert!(errors.is_empty(), "{name}: {errors:?}");
        assert!(text.contains(&format!("part {name}(")), "{name}");
        assert!(text.starts_with("/// ") && text.contains("/// Source: ") || name == "Strut", "{name}");
    }
    assert_eq!(library("Quack"), None);
}

#[test]
fn nothing_is_said_of_what_a_part_has_for_others() {
    let found = warnings(&hull(
        "input u [V]; rod arm { mass [kg] = 1; length [m] = 1; } joint pin: revolute(hull.left, arm.start);
         torque hold: torque(pin) = -soft(pin.angle);
         part motor: DcMotor(shaft = pin, voltage = u, resistance [ohm] = 1, inductance [H] = 1, constant [N*m/A] = 1);",
    ));
    assert!(found.is_empty(), "{found}");
    assert_eq!(syntax::identifier("left.shank[2].bone"), "left_shank_2_bone");
}
