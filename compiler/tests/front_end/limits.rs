//! Depth, size and time are bounded; errors instead of stack overflows.

use crate::{bad, good, slider_crank};
use std::time::Instant;

/// On a thread with the small stack of a test.
fn on_small_stack(run: impl FnOnce() + Send + 'static) {
    let thread = std::thread::Builder::new().stack_size(1 << 20).spawn(run).expect("a thread");
    thread.join().expect("no overflow");
}

#[test]
fn deep_nesting_is_an_error() {
    on_small_stack(|| {
        for (open, close) in
            [("(", ")"), ("-", ""), ("sin(", ")"), ("2^", ""), ("1 + (", ")"), ("if(1 < ", ", 1, 2)")]
        {
            let deep = format!("{}1{}", open.repeat(300), close.repeat(300));
            let text = bad(&slider_crank(&format!("output deep [1] = {deep};"))).to_string();
            assert!(text.contains("nested more than 96 deep"), "{open}: {text}");
        }
    });
}

#[test]
fn nesting_just_below_the_limit_is_lowered() {
    on_small_stack(|| {
        for (open, close, levels) in [("(", ")", 90), ("sin(", ")", 90), ("1 + (", ")", 45)] {
            let deep = format!("{}base.angle/1 [rad]{}", open.repeat(levels), close.repeat(levels));
            good(&slider_crank(&format!("output deep [1] = {deep};")));
        }
        good(&slider_crank(&format!("output deep [1] = 0{};", "+ 1".repeat(90))));
    });
}

/// A constant that others name twice over, and these others again, is counted with once.
#[test]
fn constants_are_evaluated_once() {
    let begin = Instant::now();
    let chain: String = (1..31).map(|i| format!("const A{i} = A{} + A{};", i - 1, i - 1)).collect();
    good(&slider_crank(&format!("const A0 = 0; {chain} repeat i in 0..A30 {{ output o[i] [1] = i; }}")));
    assert!(begin.elapsed().as_secs() < 5, "{:?}", begin.elapsed());
}

#[test]
fn long_sums_are_an_error() {
    on_small_stack(|| {
        let text = bad(&slider_crank(&format!("output long [1] = 0{};", "+ 1".repeat(5000)))).to_string();
        assert!(
            text.contains("more than 96 operations in a row; put parentheses around parts of it"),
            "{text}"
        );
    });
}

#[test]
fn too_many_rounds_are_an_error() {
    let start = Instant::now();
    for repeat in [
        "repeat i in 0..1000000 { output a[i] [1] = 1; }",
        "repeat i in 0..9223372036854775807 { output a[i] [1] = 1; }",
        "repeat i in 0..9000 { repeat j in 0..9000 { } }",
    ] {
        let text = bad(&slider_crank(repeat)).to_string();
        assert!(text.contains("rounds are too many"), "{text}");
        assert_eq!(text.lines().count(), 1, "{text}");
    }
    assert!(start.elapsed().as_secs() < 5);
}

#[test]
fn one_mistake_in_many_rounds_is_one_message() {
    let text = bad(&slider_crank("repeat i in 0..1000 { force f[i]: force(blok.center) = (1, 0) [N]; }"))
        .to_string();
    assert_eq!(text, "error: no body called \"blok\"; did you mean \"block\"?\n");
}

#[test]
fn one_broken_rule_in_many_rounds_is_one_message() {
    let body = "repeat i in 0..9 { particle p[i] { mass [kg] = -1; } spring s[i]: spring(p[i].center, ground(0, 0), \
                stiffness [N/m] = 1, length [m] = 1); }";
    let text = bad(&slider_crank(body)).to_string();
    assert_eq!(text, "error: the mass of `p[0]` is negative: -1 kg; it must be zero or more\n");
}

#[test]
fn many_mistakes_stay_readable() {
    let many: String = (0..500).map(|i| format!("output o{i} [m] = nothing{i};")).collect();
    let text = bad(&slider_crank(&many)).to_string();
    assert_eq!(text.lines().count(), 51);
    assert!(text.ends_with("and 450 more errors\n"));
}

#[test]
fn a_ladder_of_81_bodies_is_fast() {
    let source = "planar Ladder {
        const N = 40;
        gravity [m/s^2] = (0, -9.81);
        repeat i in 0..N+1 {
            rod upright[i] { mass [kg] = 1; length [m] = 1; }
            joint foot[i]: revolute(ground(i, 0) [m], upright[i].start);
            start { foot[i].angle [deg] ~ 60; }
        }
        repeat i in 0..N {
            rod rung[i] { mass [kg] = 1; length [m] = 1; }
            joint left[i]: revolute(upright[i].end, rung[i].start);
            joint right[i]: revolute(rung[i].end, upright[i+1].end);
        }
        output end [m] = upright[N].end.x;
    }";
    assert_eq!(good(source).bodies.len(), 81);
    let start = Instant::now();
    let definition = linkwright_compiler::parse(source.parse().expect("tokens")).expect("a definition");
    linkwright_compiler::model::lower(&definition).expect("a mechanism");
    let text = linkwright_compiler::syntax::definition_json(&definition);
    // Some tens of milliseconds at worst; the bound leaves room for a busy machine.
    assert!(start.elapsed().as_millis() < 500, "{:?} for {} bytes", start.elapsed(), text.len());
}

/// What the generated code could not hold, or could not be.
#[test]
fn values_places_and_attributes_out_of_bounds() {
    for (source, message) in [
        (
            slider_crank("const A [kg] = 1e70;"),
            "1e70 (SI units) is out of range: a value is 0 or its magnitude lies between 1e-60 and 1e60; check its exponent \
             and its unit",
        ),
        (
            "pub(in pub) planar A { }".to_string(),
            "a visibility is `pub`, `pub(crate)`, `pub(self)`, `pub(super)` or `pub(in path)`",
        ),
        (
            "#[1] planar A { }".to_string(),
            "this is no attribute: write a path, and behind it nothing, `(…)` or `= literal`",
        ),
        (
            slider_crank("repeat i in 0..2100 { rod more[i] { mass [kg] = 1; length [m] = 1; } }"),
            ", and the equations of all are written out in full; take a smaller mechanism",
        ),
        (
            slider_crank("options { crate = a b; }"),
            "expected the path of this crate, such as `::my_crate::linkwright`, found `ab`",
        ),
    ] {
        let text = bad(&source).to_string();
        assert!(text.contains(message), "{text}");
    }
}
