//! Warnings: their texts and places, and what takes them back.

use crate::{slider_crank, underlined, warnings};
use linkwright_compiler::compile;

/// What the compiler warns of, without the advice behind the first colon.
fn heads(source: &str) -> Vec<String> {
    let head = |message: &str| message.split(':').next().unwrap_or_default().to_string();
    warnings(source).iter().map(|warning| head(&warning.message)).collect()
}

#[track_caller]
fn warns(more: &str, expected: &[&str]) {
    assert_eq!(heads(&slider_crank(more)), expected, "{more}");
}

#[test]
fn a_definition_that_uses_all_it_declares_has_none() {
    warns("output o [m] = link.end.x; start { base.rate [rad/s] = 1; }", &[]);
}

#[test]
fn contacts_that_the_motion_never_closes() {
    let of = |x: &str, before: &str, more: &str| {
        let source = slider_crank(&format!(
            "surface nose: point(block.center); surface wall: half_plane(line(ground({x}, 0 [m]), ground({x}, 1 [m])));
             {before} contact stop: between(nose, wall) = kelvin_voigt(stiffness [N/m] = 1e4);
             start {{ base.angle [rad] = 1; block.center.x [m] ~ 0.4; }} {more}"
        ));
        let compiled =
            compile(source.parse().expect("tokens"), None).unwrap_or_else(|errors| panic!("{errors}"));
        compiled.warnings.iter().map(|warning| warning.message.clone()).collect::<Vec<_>>()
    };
    let turns = "expect { rotates = base; }";
    let found = of("0.6 [m]", "", turns);
    let [message] = &found[..] else { panic!("{found:?}") };
    let (head, tail) = message.split_once(" mm. ").expect("a length");
    let (head, least) = head.rsplit_once(' ').expect("a number");
    assert_eq!(head, "`stop` never closes: all along the motion its gap stays above");
    assert_eq!(tail, "Bring what touches nearer, leave it out, or write `#[allow(no_effect)]` before it");
    // The block comes to 0.1 m before the wall, and is looked at in steps.
    let least: f64 = least.parse().expect("a number");
    assert!((90.0..=100.0).contains(&least), "{least}");
    let moves = "0.6 [m] + 0.01 [m]*sin(3 [rad/s]*time)";
    let others = [
        ("0.6 [m]", "#[allow(no_effect)]", turns),
        ("0.499 [m]", "", turns),
        ("0.6 [m]", "", ""),
        (moves, "", turns),
    ];
    for (x, before, more) in others {
        assert_eq!(of(x, before, more), [""; 0], "{x} {before} {more}");
    }
}

#[test]
fn what_nothing_names() {
    for (more, expected) in [
        ("const A [m] = 1;", "nothing names the constant `A`, so it stands for nothing"),
        ("param p [m] = 1;", "nothing names the parameter `p`, so no equation depends on it"),
        ("input u [N];", "nothing names the input `u`, so no equation depends on it"),
        (
            "body b { mass [kg] = 1; inertia [kg*m^2] = 1; point p [m] = (1, 0); } joint j: revolute(b.center, link.end);",
            "nothing names the point `p` of `b`, so no joint, load, start value or output is there",
        ),
        (
            "body b { mass [kg] = 1; inertia [kg*m^2] = 1; point p [m] = (1, 0); line l = (b.p, b.center); } \
             joint j: revolute(b.center, link.end);",
            "nothing names the line `l` of `b`, so no joint, load, start value or output is there",
        ),
        (
            "line l = (ground(0, 0), ground(0, 1) [m]);",
            "nothing names the line `l`, so no joint, load, start value or output is there",
        ),
        (
            "body b { mass [kg] = 1; inertia [kg*m^2] = 1; }",
            "`b` is connected to nothing, and moves by itself",
        ),
    ] {
        warns(more, &[expected]);
    }
}

#[test]
fn loads_without_effect() {
    let held = "joint weld: fixed(ground(0, 1) [m], post.start); rod post { mass [kg] = 1; length [m] = 1; }";
    for (load, expected) in [
        ("force f: torque(base) = 0;", "`f` is zero at all times"),
        ("force f: force(crank.pin) = (0, 0);", "`f` is zero at all times"),
        (
            "spring f: spring(crank.pin, post.end, stiffness [N/m] = 0, length [m] = 1);",
            "`f` has neither stiffness nor damping, so it pulls at nothing",
        ),
        (
            "spring f: spring(crank.pin, post.end, stiffness [N/m] = 0, length [m] = 1, damping [N*s/m] = 3);",
            "the stiffness of `f` is zero, so its length says nothing",
        ),
        (
            "force f: force(post.end) = (1, 0) [N];",
            "`f` acts on `post`, which fixed joints hold to the ground",
        ),
        ("force f: torque(post) = 1 [N*m];", "`f` would turn `post`, which cannot turn"),
        (
            "spring f: spring(ground(0, 0), post.end, stiffness [N/m] = 1, length [m] = 1);",
            "`f` pulls `ground(0, 0)` and `post.end` together, which fixed joints hold apart",
        ),
    ] {
        warns(&format!("{held} {load}"), &[expected]);
    }
    let slide = "joint slide: prismatic(ground(0, 1) [m], post.start, axis = (1, 0)); rod post { mass [kg] = 1; \
                 length [m] = 1; }";
    warns(
        &format!("{slide} force f: torque(post) = 1 [N*m];"),
        &["`f` would turn `post`, which cannot turn"],
    );
    warns(&format!("{slide} force f: force(slide) = 1 [N];"), &[]);
    warns("gravity [m/s^2] = (0, 0);", &["this gravity is zero"]);
    warns("damper d: damper(crank.pin, link.end, damping [N*s/m] = 1);", &[]);
}

#[test]
fn what_to_write_instead() {
    let held = "rod post { mass [kg] = 1; length [m] = 1; } joint weld: fixed(ground(0, 1) [m], post.start);
                rod mast { mass [kg] = 1; length [m] = 1; } joint foot: fixed(ground(0, 2) [m], mast.start);";
    for (more, expected) in [
        (
            "spring f: spring(crank.pin, link.end, stiffness [N/m] = 0, length [m] = 1);",
            "`f` has neither stiffness nor damping, so it pulls at nothing: give it one of them, or a parameter, or leave it \
             out, or write `#[allow(no_effect)]` before it",
        ),
        (
            "joint bolt: revolute(post.end, mast.start); torque f: torque(bolt) = 1 [N*m];",
            "`f` acts along `bolt`, which cannot move: other joints hold its two bodies together. Name a joint that moves, or \
             write `#[allow(no_effect)]` before it",
        ),
        (
            "joint bolt: prismatic(post.end, mast.start, axis = (1, 0)); force f: force(bolt) = 1 [N];",
            "`f` acts along `bolt`, which cannot move: other joints hold its two bodies together. Name a joint that moves, or \
             write `#[allow(no_effect)]` before it",
        ),
        (
            "damper f: damper(post.end, mast.end, damping [N*s/m] = 1);",
            "`f` pulls `post.end` and `mast.end` together, which fixed joints hold apart: it moves nothing. Name a place that \
             moves, or write `#[allow(no_effect)]` before it",
        ),
    ] {
        let found = warnings(&slider_crank(&format!("{held} {more}")));
        let found: Vec<_> = found.iter().map(|warning| warning.message.as_str()).collect();
        assert_eq!(found, [expected], "{more}");
    }
}

#[test]
fn springs_that_push() {
    for (load, expected) in [
        (
            "spring f: spring(crank.pin, link.end, stiffness [N/m] = -1, length [m] = 1);",
            "the stiffness of `f` is negative, -1 in SI units, so it pushes where it should pull",
        ),
        (
            "damper f: damper(crank.pin, link.end, damping [N*s/m] = -heavy/1 [s]);",
            "the damping of `f` is negative, -2 in SI units, so it drives the motion it should damp",
        ),
        (
            "torsion_spring f: torsion_spring(base, stiffness [N*m] = 1, damping [N*m*s] = -0.005);",
            "the damping of `f` is negative, -0.005 in SI units, so it drives the motion it should damp",
        ),
    ] {
        warns(load, &[expected]);
        warns(&format!("#[allow(negative)] {load}"), &[]);
    }
}

#[test]
fn places_outside_of_their_shape() {
    for (shape, expected) in [
        (
            "rod b { mass [kg] = 1; length [m] = 1; point p [m] = (0.6, 0); }",
            Some("`p` lies outside of the rod `b`: 0.6 m along x, and the rod ends at 0.5 m"),
        ),
        ("rod b { mass [kg] = 1; length [m] = 1; point p [m] = (0.5, 0.1); }", None),
        (
            "disk b { mass [kg] = 1; radius [m] = 0.1; point p [m] = (0.1, 0.1); }",
            Some("`p` lies outside of the disk `b`: 0.14142 m off its axis, and the disk ends at 0.1 m"),
        ),
        (
            "box b { mass [kg] = 1; width [m] = 1; height [m] = 2; point p [m] = (0, -1.1); }",
            Some("`p` lies outside of the box `b`: 1.1 m along y, and the box ends at 1 m"),
        ),
        ("box b { mass [kg] = 1; width [m] = 1; height [m] = 2; point p [m] = (0.5, 1); }", None),
    ] {
        let source = slider_crank(&format!("{shape} joint j: revolute(link.end, b.p);"));
        let found = warnings(&source);
        let found: Vec<_> = found.iter().map(|warning| warning.message.split(". ").next().unwrap()).collect();
        assert_eq!(found, expected.into_iter().collect::<Vec<_>>(), "{shape}");
    }
}

#[test]
fn what_takes_a_warning_back() {
    warns("#[allow(unused)] const A [m] = 1;", &[]);
    warns(
        "#[allow(no_effect)] const A [m] = 1;",
        &["nothing names the constant `A`, so it stands for nothing"],
    );
    warns("const _A [m] = 1;", &[]);
    warns("#[allow(unused, no_effect)] repeat i in 0..2 { param p[i] [1] = 1; }", &[]);
    warns("#[allow(no_effect)] force f: torque(base) = 0;", &[]);
    let disk = "disk b { mass [kg] = 1; radius [m] = 0.1; #[allow(outside)] point p [m] = (1, 0); }";
    warns(&format!("{disk} joint j: revolute(link.end, b.p);"), &[]);
    let whole = slider_crank("const A [m] = 1; force f: torque(base) = 0;");
    assert_eq!(heads(&format!("#[allow(unused)] {whole}")), ["`f` is zero at all times"]);
}

#[test]
fn one_of_several_rounds_is_enough() {
    let used = "repeat i in 0..3 { param p[i] [m] = 1; } output o [m] = p[1];";
    warns(used, &[]);
    let unused = slider_crank("repeat i in 0..3 { param p[i] [m] = 1; }");
    assert_eq!(warnings(&unused).iter().count(), 1);
    // What only counts is used too.
    warns("const N = 2; repeat i in 0..N { output o[i] [m] = i * 1 [m]; }", &[]);
}

#[test]
fn they_point_at_the_name() {
    let source = slider_crank("param spare [m] = 1;");
    let found = warnings(&source);
    let warning = found.iter().next().expect("a warning");
    assert_eq!(underlined(&source, warning.region), "param spare [m] = 1;\n      ~~~~~");
}

#[test]
fn rustc_is_told_at_the_place_of_the_warning() {
    let found = warnings(&slider_crank("param spare [m] = 1;"));
    let home = found.iter().next().expect("a warning").region;
    let text = found.into_warnings(home).to_string().replace(' ', "");
    assert!(
        text.starts_with("#[warn(warnings,deprecated)]const_:()={{#[deprecated(note=\"nothing"),
        "{text}"
    );
    assert!(text.ends_with("macro_rules!unused{()=>{}}unused!{}}};"), "{text}");
    let none = warnings(&slider_crank(""));
    assert!(none.into_warnings(home).is_empty(), "nothing is emitted where nothing is to say");
}

/// The sixth body of the slider-crank, which reaches 0.2 m, with a moment of inertia.
fn arm(more: &str) -> String {
    format!("body b {{ mass [kg] = 1.2; {more} point p [m] = (0.2, 0); }} joint j: revolute(link.end, b.p);")
}

#[test]
fn inertia_out_of_proportion() {
    let found = warnings(&slider_crank(&arm("inertia [kg*m^2] = 4000;")));
    let found: Vec<_> = found.iter().map(|warning| warning.message.as_str()).collect();
    let expected = "`b` has a moment of inertia of 4000 kg*m^2 and a mass of 1.2 kg, a radius of gyration of 57.735 m, but nothing of it \
                    is farther than 0.2 m from its centre of mass: a body of that size and mass has up to 0.048 kg*m^2. Correct the \
                    number or the unit, which `[kg*mm^2]` would fit, or write `#[allow(proportion)]` before it";
    assert_eq!(found, [expected]);
    let source = slider_crank(&arm("inertia [kg*m^2] = 4000;"));
    let region = warnings(&source).iter().next().expect("a warning").region;
    assert!(underlined(&source, region).contains("~~~~"));
    for (inertia, unit) in [("160", "kg*cm^2"), ("1.6e5", "g*cm^2"), ("1.6e7", "g*mm^2")] {
        let found = warnings(&slider_crank(&arm(&format!("inertia [kg*m^2] = {inertia};"))));
        let found: String = found.iter().map(|warning| warning.message.clone()).collect();
        assert!(found.contains(&format!("which `[{unit}]` would fit")), "{inertia}: {found}");
    }
    warns(&arm("#[allow(proportion)] inertia [kg*m^2] = 4000;"), &[]);
    warns(&format!("{} options {{ inertia = accept; }}", arm("inertia [kg*m^2] = 4000;")), &[]);
}

/// What is sensible, however unlike a plate of the size of its places.
#[test]
fn inertia_in_proportion() {
    for body in [
        // A plate; the same in the right unit; a point; a massless frame.
        "mass [kg] = 1.2; inertia [kg*m^2] = 0.016;",
        "mass [kg] = 1.2; inertia [kg*mm^2] = 16000;",
        "mass [kg] = 1.2; inertia [kg*m^2] = 0;",
        "mass [kg] = 0; inertia [kg*m^2] = 1;",
        // A flywheel of 1 m on a crank of 0.2 m; a motor of 2e-5 kg m² behind a gear of 160.
        "mass [kg] = 200; inertia [kg*m^2] = 100;",
        "mass [kg] = 1.2; inertia [kg*m^2] = 0.5;",
        // A ball of 1 cm on a wire of 0.2 m.
        "mass [kg] = 1.2; inertia [kg*m^2] = 4.8e-5;",
    ] {
        let more = format!("body b {{ {body} point p [m] = (0.2, 0); }} joint j: revolute(link.end, b.p);");
        warns(&more, &[]);
    }
    // The disk of a rotor, 10 µm off its shaft; one that has no place but its centre.
    let disk = "body b { mass [kg] = 5; inertia [kg*m^2] = 0.1; point p [um] = (10, 0); } joint j: revolute(link.end, b.p);";
    warns(disk, &[]);
    warns("body b { mass [kg] = 1; inertia [kg*m^2] = 4000; } joint j: revolute(link.end, b.center);", &[]);
}

#[test]
fn a_reaction_that_is_one_of_many() {
    let source = "spatial Twice {
        rod bar { mass [kg] = 1; length [m] = 1; radius [m] = 0.1; }
        joint one: revolute(ground(0, 0, 0) [m], bar.start, axis = (1, 0, 0));
        joint other: revolute(ground(1, 0, 0) [m], bar.end, axis = (1, 0, 0));
        start { one.angle [rad] = 0; }
        options { redundant = drop; }
        output o [N] = one.reaction.x + 2*one.reaction.y;
        #[allow(shared)] output p [N] = other.reaction.x;
    }";
    let tokens = source.parse().expect("tokens");
    let found = compile(tokens, None).expect("it holds").warnings;
    let heads: Vec<&str> = found.iter().filter_map(|warning| warning.message.split(':').next()).collect();
    assert_eq!(heads, ["`o` names the reaction of `one`, which is one of many"]);
}
