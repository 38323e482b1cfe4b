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
        ("{ }", "` sets nothing: write `{ memory = value; }` behind its condition, or leave it out"),
        (
            "{ p = 1 [s]; }",
            "` is no memory, and events set memories only: declare another name by `memory NAME [unit] = value;`",
        ),
        ("{ rail.speed = 1; }", "no quantity of `rail` can be set here"),
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
        "the functions in C take whole steps and find no event within them, so that `m` would be set late",
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

/// What there is not yet is said to be so, with what to write instead; of two places both are shown.
#[test]
fn what_is_not_there_yet_is_refused() {
    said(
        &with("event e: every 1 [s] { m = 1; jump(rail.speed = 0); }"),
        "` cannot make a velocity jump: events set memories only; let a load push that a memory switches on, or let a rigid contact strike, \
         `contact NAME: between(…) = rigid(restitution = …);`",
    );
    let rigid =
        "event e: every 1 [s] { m = 1; } limit stop: rail.travel [m] in -1..2 = rigid(restitution = 0);";
    said(&with(rigid), "` cannot be in one mechanism yet: give `");
    said(&with(rigid), "memories such as `m` and rigid contacts such as `stop`");
    let twice = with("event e: every 1 [s] { m = 1; } event f: every 1000 [ms] { m = 2; }");
    said(&twice, "` is set here too");
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
