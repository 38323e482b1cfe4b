//! Memories and events: what is refused, what is warned of, what the interpreted functions say of them.

use crate::{bad, warnings};
use linkwright_compiler::compile;
use linkwright_compiler::model::{Occasion, Way};
use linkwright_compiler::schedule::{Function, run};

/// A slider with these statements.
fn slider(statements: &str) -> String {
    format!(
        "planar Slider {{ input u [N]; param p [s] = 1;
         body slider {{ mass [kg] = 1; inertia [kg*m^2] = 0.01; }}
         joint rail: prismatic(ground(0, 0) [m], slider.origin, axis = (1, 0));
         force pull: along(rail.travel) = u*p/1 [s];
         start {{ rail.travel [m] = 0; rail.speed [m/s] = 1; }} {statements} }}"
    )
}

/// With one memory that an output names.
fn with(statements: &str) -> String {
    slider(&format!("memory m = 0; output a = m; {statements}"))
}

#[track_caller]
fn said(source: &str, text: &str) {
    let found = bad(source).to_string();
    assert!(found.contains(text), "{found}");
}

#[test]
fn mistakes_of_events_are_named() {
    let rises = "event e: rail.travel rises 1 [m]";
    for (statements, text) in [
        (
            "event e: rail.travel rises 1 { m = 1; }",
            "the two sides of `rises` do not fit: a plain number meets a length",
        ),
        ("event e: p rises 1 [s] { m = 1; }", "`e` never occurs: nothing on either side of `rises` changes"),
        (
            "event e: every p { m = 1; }",
            "`p` is a parameter, but the period of an event may depend on constants only",
        ),
        (
            "event e: every m*1 [s] { m = 1; }",
            "`m` is a memory, but the period of an event may depend on constants only",
        ),
        ("event e: every 1e-12 [s] { m = 1; }", "must be a nanosecond or more, found 1e-12 s"),
        ("event e: every 3 { m = 1; }", "the period of `e` is given a plain number"),
        ("event e: u rises 1 [N] { m = 1; }", "`u` is an input, but the condition of an event may depend on"),
        (
            "event e: energy rises 1 [J] { m = 1; }",
            "`energy` is a result, but the condition of an event may depend on",
        ),
        (
            "event e: rail.travel > 1 [m] { m = 1; }",
            "expected `rises`, `falls` or `crosses` and a level, found `{`",
        ),
        (
            "event e: every 1 [s] { q = 1; }",
            "no memory called \"q\": declare it by `memory q [unit] = value;`",
        ),
    ] {
        said(&with(statements), text);
    }
    for (sets, text) in [
        (
            "{ }",
            "` sets nothing: write `{ memory = value; }` or `{ jump(speed) = value; }` behind its condition, or leave it out",
        ),
        (
            "{ p = 1 [s]; }",
            "` is no memory, and events set memories and let speeds jump, nothing else: declare another name by \
             `memory NAME [unit] = value;`",
        ),
        (
            "{ rail.speed = 1; }",
            "no quantity of `rail` can be set like that: events set memories, which `memory NAME [unit] = value;` declares, and let speeds \
             jump, `jump(rail.…) = value;`",
        ),
        (
            "{ m = 1; m = 2; }",
            "` twice, and all that it sets is of the values before it: leave one of both out",
        ),
        ("{ m = rail.travel; }", "`m` is given a length"),
    ] {
        said(&with(&format!("{rises} {sets}")), text);
    }
    let again = "event e: every 1 [s] { m = 1; } event e: every 2 [s] { m = 1; }";
    said(&with(again), "`e` is declared twice");
    said(&slider("memory m [1];"), "the memory \"m\" has no start value");
    said(
        &slider("memory m = p/1 [s]; output a = m; event e: every 1 [s] { m = 1; }"),
        "`p` is a parameter, but",
    );
    let c = format!("{rises} {{ m = 1; }} options {{ export_c = f64; }}");
    said(
        &with(&c),
        "the functions in C take whole steps and find no event within them, so that `m` would be late",
    );
}

#[test]
fn what_makes_no_difference_is_warned_of() {
    assert!(
        warnings(&slider("memory m = 0; output a = m;")).to_string().contains("no event sets the memory `m`")
    );
    let unread = slider("memory m = 0; event e: every 1 [s] { m = 1; }");
    assert!(warnings(&unread).to_string().contains("nothing names the memory `m`"));
    let meant = slider("memory _m = 0; #[allow(unused)] memory n = 0; event e: every 1 [s] { n = n + 1; }");
    assert!(warnings(&meant).is_empty());
}

/// The gap of a rigid contact ends at zero, on whichever side a rounding leaves it; its speed of closing passes zero in a touch.
#[test]
fn touches_are_events_by_their_speed() {
    let of = |condition: &str| {
        with(&format!(
            "limit stop: rail.travel [m] in -1..2 = rigid(restitution = 0); event e: {condition} {{ m = 1; }}"
        ))
    };
    let text = "`stop` is rigid, and nothing is inside it, so that `stop.gap` does not pass this level";
    said(&of("stop.gap falls 0 [m]"), text);
    said(&of("stop.gap crosses -1 [mm]"), text);
    said(&of("stop.depth rises 0 [m]"), "of a touch write `stop.closing falls 0`, which an impulse does");
    for condition in ["stop.gap falls 1 [mm]", "stop.depth falls -1 [mm]", "stop.closing falls 0"] {
        assert!(warnings(&of(condition)).is_empty(), "{condition}");
    }
}

/// Of two places both are shown.
#[test]
fn what_is_set_twice_is_refused() {
    let twice = with("event e: every 1 [s] { m = 1; } event f: every 1000 [ms] { m = 2; }");
    said(&twice, "` is set here too");
}

#[test]
fn mistakes_of_jumps_are_named() {
    let rises = "event e: rail.travel rises 1 [m]";
    for (sets, text) in [
        (
            "{ jump(rail.travel) = 1 [m]; }",
            "`rail.travel` cannot jump: only a speed can, such as `rail.speed`, `pin.rate` or `body.origin.velocity.x`; positions go on as they \
             are",
        ),
        ("{ jump(energy) = 1 [J]; }", "`energy` cannot jump"),
        ("{ jump(rail.speed) = 1 [m]; }", "what `rail.speed` jumps to is given a length"),
        ("{ jump(rail.sped) = 1 [m/s]; }", "the prismatic joint `rail` has no sped; it has travel, speed"),
        (
            "{ jump(rail.speed = 1 [m/s]); }",
            "the value stands behind the parentheses: write `jump(rail.speed) = value;`",
        ),
        ("{ jump(2) = 1 [m/s]; }", "a speed or rate, such as `rail.speed`"),
        (
            "{ jump(rail.speed) = 1 [m/s]; jump(slider.rate) = 1 [rad/s]; }",
            "`e` lets a second speed jump, and an event has one: write another event with the same condition, for all that occurs at one time \
             jumps together",
        ),
    ] {
        said(&slider(&format!("{rises} {sets}")), text);
    }
    let driven = slider(
        "drive on: rail.travel = time*1 [m/s]; event e: time rises 1 [s] { jump(rail.speed) = 1 [m/s]; }",
    );
    let driven = driven.replace("start { rail.travel [m] = 0; rail.speed [m/s] = 1; }", "");
    let text =
        "`rail.speed` cannot jump, since `on` drives it: let the law of the driver jump, or another speed";
    said(&driven, text);
    said(&driven, "`on` drives it");
    let many: String = (1..10)
        .map(|k| format!("event e{k}: time rises {k} [s] {{ jump(rail.speed) = {k} [m/s]; }}"))
        .collect();
    said(
        &slider(&many),
        "9 events let speeds jump, and at most 8 may: let loads that a memory switches push instead",
    );
    let c = slider(&format!("{rises} {{ jump(rail.speed) = 0 [m/s]; }} options {{ export_c = f64; }}"));
    said(&c, "so that `e` would be late");
}

/// A mechanism may have events that set nothing but speeds.
#[test]
fn jumps_need_no_memories() {
    let source = slider(
        "event out: rail.travel rises 1 [m] { jump(rail.speed) = -0.5*rail.speed; }
         event tick: every 1 [s] { jump(rail.speed) = 2 [m/s]; }",
    );
    let compiled = compile(source.parse().expect("tokens"), None).unwrap_or_else(|found| panic!("{found}"));
    let names: Vec<&str> = compiled.mechanism.held_names().iter().map(|name| name.text.as_str()).collect();
    assert_eq!(names, ["out", "tick"]);
    let mut at = linkwright_compiler::schedule::Inputs {
        parameters: vec![1.0],
        q: vec![0.25],
        v: vec![3.0],
        inputs: vec![0.0],
        gates: vec![1.0, 0.0],
        ..Default::default()
    };
    at.prepared = run(compiled.programs.get(Function::Prepare), &at);
    assert_eq!(run(compiled.programs.get(Function::Assignments), &at), [-1.5, 2.0]);
    assert_eq!(run(compiled.programs.get(Function::Strikes), &at), [3.0, 3.0, 0.0, 0.0, 1.0, 1.0]);
}

/// The same event twice is refused only where both are sure to be at one time.
#[test]
fn events_that_may_differ_may_set_the_same() {
    let compiled = |statements: &str| {
        compile(with(statements).parse().expect("tokens"), None).unwrap_or_else(|found| panic!("{found}"))
    };
    compiled("event e: rail.travel rises 1 [m] { m = 1; } event f: rail.travel falls 1 [m] { m = 2; }");
    compiled("event e: every 1 [s] { m = 1; } event f: every 2 [s] { m = 2; }");
    said(
        &with("event e: rail.travel rises 1 [m] { m = 1; } event f: rail.travel crosses 1 [m] { m = 2; }"),
        "`f` occurs where `e` does, and both set `m`",
    );
}

/// Their jump by a turn is no event.
#[test]
fn angles_of_events_are_counted() {
    let wheel = "planar Wheel { disk wheel { mass [kg] = 1; radius [m] = 0.1; }
        joint axle: revolute(ground(0, 0) [m], wheel.center);
        memory m = 0; memory n [rad] = 0; output a = m; output b [rad] = n;
        start { axle.angle [rad] = 0; axle.rate [rad/s] = 1; }";
    for event in [
        "event e: axle.angle rises 10 [rad] { m = 1; n = 1 [rad]; }",
        "event e: every 1 [s] { m = 1; n = axle.angle; }",
    ] {
        let source = format!("{wheel} {event} }}");
        let compiled =
            compile(source.parse().expect("tokens"), None).unwrap_or_else(|found| panic!("{found}"));
        assert_eq!(compiled.complete.equations.layout.angles.len(), 1, "{event}");
    }
}

/// Guards are level − value; what is set is of the values before, the last written decides, and what does not occur sets nothing.
#[test]
fn functions_say_what_is_written() {
    let source = slider(
        "memory m = 2; memory n [m] = 0.5; output a = m; output b [m] = n;
         event tick: every 0.5 [s] { m = m + 1; n = rail.travel*m; }
         event out: 2*rail.travel falls 3 [m] { n = 7 [m]; }",
    );
    let compiled = compile(source.parse().expect("tokens"), None).unwrap_or_else(|found| panic!("{found}"));
    let mechanism = &compiled.mechanism;
    let names: Vec<&str> = mechanism.held_names().iter().map(|name| name.text.as_str()).collect();
    assert_eq!(names, ["out", "tick", "m", "n"]);
    assert!(matches!(mechanism.events[1].occasion, Occasion::Passing(_, Way::Falls)));
    assert_eq!(mechanism.events[0].occasion, Occasion::Every(0.5));
    assert_eq!(compiled.start_gates(), [0.0, 0.0, 2.0, 0.5]);
    let mut at = linkwright_compiler::schedule::Inputs {
        parameters: vec![1.0],
        q: vec![0.25],
        v: vec![1.0],
        inputs: vec![0.0],
        ..Default::default()
    };
    at.prepared = run(compiled.programs.get(Function::Prepare), &at);
    for (occur, after) in [
        ([0.0, 0.0], [2.0, 0.5]),
        ([0.0, 1.0], [3.0, 0.5]),
        ([1.0, 0.0], [2.0, 7.0]),
        ([1.0, 1.0], [3.0, 7.0]),
    ] {
        at.gates = vec![occur[0], occur[1], 2.0, 0.5];
        assert_eq!(run(compiled.programs.get(Function::Assignments), &at)[2..], after);
        let guards = run(compiled.programs.get(Function::Guards), &at);
        assert_eq!(guards, [3.0 - 0.5, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
    }
}

#[test]
fn what_is_declared_with_its_start_is_not_stated() {
    for (start, text) in [
        (
            "m = 3;",
            "`m` is a memory and starts with the number that it is declared with, `memory m [unit] = value;`: only angles, travels, positions \
                    and their rates can stand here",
        ),
        (
            "z = 3;",
            "`z` is a state and starts with the number that it is declared with, `state z [unit] = value;`",
        ),
        (
            "p = 3;",
            "`p` is a parameter and has the default that it is declared with, `param p [unit] = value;`",
        ),
        ("u = 3;", "`u` is an input and is given from outside, at each instant"),
        ("s = 3;", "`s` is a signal and has the value that it is declared with"),
        ("q = 3;", "no value called \"q\""),
    ] {
        let more = "state z = 0; rate z = -z/p; signal s = 2*z; output b = s;";
        said(&with(&format!("{more} start {{ {start} }}")), text);
    }
}
