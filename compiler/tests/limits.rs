//! The whole compiler, unoptimised, at the bounds of what it admits: on a thread as small as rustc's, in bounded time.

use linkwright_compiler::{Expansion, expand};
use std::time::{Duration, Instant};

/// What a thread has at least.
const STACK: usize = 2 << 20;

fn expanded_on(stack: usize, source: String) -> Result<String, String> {
    let run = move || match expand(source.parse().expect("tokens"), |_| None) {
        Expansion::Items { text, .. } => Ok(text),
        Expansion::Errors(tokens) => Err(tokens.to_string()),
    };
    let thread = std::thread::Builder::new().stack_size(stack).spawn(run).expect("a thread");
    thread.join().expect("neither a panic nor an overflow")
}

/// Of a long expansion.
fn beginning(expansion: Result<String, String>) -> String {
    expansion.unwrap_or_else(|errors| errors).chars().take(400).collect()
}

/// A pendulum with more statements.
fn pendulum(more: &str) -> String {
    format!(
        "planar Pendulum {{ gravity [m/s^2] = (0, -9.81); param k [1] = 1; rod arm {{ mass [kg] = 1; length [m] = 1; }}
         joint pivot: revolute(ground(0, 0) [m], arm.start); start {{ pivot.angle [rad] = 0.5; }} {more} }}"
    )
}

/// `bodies` rods in a row.
fn chain(bodies: usize) -> String {
    format!(
        "planar Chain {{ const N = {bodies}; rod link[0] {{ mass [kg] = 1; length [m] = 1; }}
         joint pin[0]: revolute(ground(0, 0) [m], link[0].start);
         repeat i in 1..N {{ rod link[i] {{ mass [kg] = 1; length [m] = 1; }}
                             joint pin[i]: revolute(link[i-1].end, link[i].start); }} }}"
    )
}

#[test]
fn the_deepest_expressions_are_compiled() {
    for (open, close, levels) in [
        ("sin(", " * 1 [rad])", 45),
        ("-(", ")", 45),
        ("k*(1 + ", ")", 30),
        ("if(k > 0.5, ", ", 1)", 90),
        ("min(k, ", ")", 90),
        ("(", "^2)", 8),
    ] {
        let law = format!("{}sin(pivot.angle){}", open.repeat(levels), close.repeat(levels));
        let source = pendulum(&format!(
            "torque motor: torque(pivot) = {law} * 1 [N*m]; output o [1] = {law}; options {{ emit = (tangent); }}"
        ));
        let expansion = expanded_on(STACK, source);
        assert!(expansion.is_ok(), "{open}: {}", beginning(expansion));
    }
}

#[test]
fn ten_thousand_terms_in_a_row_are_refused_and_in_parentheses_compiled() {
    let row = vec!["pivot.angle"; 10_000].join(" + ");
    let refused =
        expanded_on(STACK, pendulum(&format!("output o [rad] = {row};"))).expect_err("it is too long");
    assert!(refused.contains("more than 96 operations in a row"), "{refused:.300}");

    let ten = |term: String| format!("({})", vec![term; 10].join(" + "));
    let all = ten(ten(ten(ten("pivot.angle*time".to_string()))));
    let source = pendulum(&format!("output o [rad*s] = {all};"));
    let expansion = expanded_on(STACK, source);
    assert!(expansion.is_ok(), "{}", beginning(expansion));
}

/// A quarter of the bodies that are admitted on a quarter of the stack: nothing may grow with their number.
#[test]
fn long_chains_need_no_stack() {
    let expansion = expanded_on(STACK / 4, chain(64));
    assert!(expansion.is_ok(), "{}", beginning(expansion));
}

/// Rods on pins of their own, and equations that name all of them; in groups of fifty terms.
fn tied(rods: usize, equations: usize) -> String {
    use std::fmt::Write;
    let (mut text, mut start) = (String::from("planar Tied { gravity [m/s^2] = (0, -9.81);"), String::new());
    let angle = |i: usize| ((i * 37 + 11) % 100) as f64 / 50.0 - 1.0;
    for i in 0..rods {
        let _ = write!(text, " rod r{i} {{ mass [kg] = 1; length [m] = 1; }}");
        let _ = write!(text, " joint p{i}: revolute(ground({i}, 0) [m], r{i}.start);");
        let _ = write!(start, " p{i}.angle [rad] ~ {};", angle(i));
    }
    for k in 0..equations {
        let factor = |i: usize| ((i * 61 + k * 89 + i * k * 7) % 97 + 3) as f64 / 100.0;
        let of_group = |group: usize| {
            let terms = (group..rods.min(group + 50)).map(|i| format!("r{i}.end.y*{}", factor(i)));
            format!("({})", terms.collect::<Vec<_>>().join(" + "))
        };
        let groups: Vec<String> = (0..rods).step_by(50).map(of_group).collect();
        let right: f64 = (0..rods).map(|i| factor(i) * angle(i).sin()).sum();
        let _ = write!(text, " constraint c{k}: {} = {right} [m];", groups.join(" + "));
    }
    format!("{text} start {{ {start} }} }}")
}

/// Fewer parts than the limits and more work than a build can bear.
#[test]
fn too_long_an_elimination_is_refused_at_once() {
    let begin = Instant::now();
    let refused = expanded_on(STACK, tied(120, 80)).expect_err("it is too large");
    for text in [
        "is too large to be written out",
        "120 velocities and 80 rows",
        "more than 300000",
        "c0",
        "fewer coordinates",
    ] {
        assert!(refused.contains(text), "no {text}: {refused:.900}");
    }
    let in_tree = chain(128).replace("const N", "options { coordinates = tree; } const N");
    let refused = expanded_on(STACK, in_tree).expect_err("it is too large");
    for text in ["128 velocities and 0 rows", "hang on one another", "options { coordinates = absolute; }"] {
        assert!(refused.contains(text), "no {text}: {refused:.900}");
    }
    // Seconds, of an unoptimised compiler on a machine that may do much else; written out it would take many minutes.
    assert!(begin.elapsed() < Duration::from_secs(240), "{:?}", begin.elapsed());
}

#[test]
fn too_large_a_mechanism_is_refused_at_once() {
    let begin = Instant::now();
    let refused = expanded_on(STACK, chain(3000)).expect_err("it is too large");
    for text in ["3000 bodies are too many", "beyond 2048", "`link[2048]`"] {
        assert!(refused.contains(text), "no {text}: {refused:.600}");
    }
    let loads = "repeat i in 0..3000 { force f[i]: force(arm.end) = (1, 0) [N]; }";
    let refused = expanded_on(STACK, pendulum(loads)).expect_err("it is too large");
    assert!(refused.contains("3000 loads are too many"), "{refused:.600}");
    let outputs: String = (0..10_000).map(|i| format!("output o{i} [m] = arm.end.x;")).collect();
    let refused = expanded_on(STACK, pendulum(&outputs)).expect_err("it is too large");
    assert!(refused.contains("10001 parameters, inputs, states and outputs are too many"), "{refused:.600}");
    let outputs = "repeat i in 0..2000 { output o[i] [m] = arm.end.x; }";
    let refused = expanded_on(STACK, pendulum(outputs)).expect_err("it is too large");
    assert!(refused.contains("2001 parameters, inputs, states and outputs are too many"), "{refused:.600}");
    assert!(begin.elapsed() < Duration::from_secs(30), "{:?}", begin.elapsed());
}

#[test]
fn bodies_that_hang_on_one_another_are_counted() {
    let refused = expanded_on(STACK, chain(300)).expect_err("they are too many");
    for text in [
        "too many bodies hang on one another: `link[299]` is number 300 on its way from the ground",
        "45150 together, more than 40000",
        "hold long chains to the ground in between",
    ] {
        assert!(refused.contains(text), "no {text}: {refused:.600}");
    }
}

/// Hinged cranks side by side with a coupler between each two: many bodies, none of which hang on many.
#[test]
fn hundreds_of_windows_are_compiled() {
    let ladder = "planar Ladder { const N = 300;
        repeat i in 0..N+1 { rod crank[i] { mass [kg] = 1; length [m] = 1; }
            joint pin[i]: revolute(ground(i, 0) [m], crank[i].start); }
        repeat i in 0..N { rod coupler[i] { mass [kg] = 1; length [m] = 1; }
            joint left[i]: revolute(crank[i].end, coupler[i].start);
            joint right[i]: revolute(coupler[i].end, crank[i+1].end);
            start { coupler[i].angle [rad] ~ 0; pin[i+1].angle [deg] ~ 90; } }
        start { pin[0].angle [deg] = 90; pin[0].rate [rad/s] = -1; }
        expect { degrees_of_freedom = 1; } }";
    let text = expanded_on(STACK, ladder.to_string()).unwrap_or_else(|errors| panic!("{errors:.600}"));
    // Half of it are names and tables, an entry for each part; written out one by one it would be ten times as long.
    assert!(text.len() < 1_200_000, "{} bytes", text.len());
}
