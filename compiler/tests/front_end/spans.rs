//! Where errors point: `~~~~` under the source.

use crate::{bad, slider_crank, underlined};

/// Checks message and underlining of the only error, without the indentation of the line.
#[track_caller]
fn points_at(more: &str, message: &str, marked: &str) {
    let source = slider_crank(more);
    let diagnostics = bad(&source);
    let errors: Vec<_> = diagnostics.iter().collect();
    assert_eq!(errors.len(), 1, "{diagnostics}");
    assert_eq!(errors[0].message, message);
    assert_eq!(underlined(&source, errors[0].region), marked);
}

#[test]
fn names() {
    points_at(
        "joint extra: revolute(crnk.pin, ground(0, 0));",
        "no body called \"crnk\"; did you mean \"crank\"?",
        "joint extra: revolute(crnk.pin, ground(0, 0));
                      ~~~~",
    );
    points_at(
        "joint extra: revolute(crank.pn, ground(0, 0));",
        "`crank` has no point called \"pn\"; did you mean \"pin\"?",
        "joint extra: revolute(crank.pn, ground(0, 0));
                            ~~",
    );
}

#[test]
fn units() {
    points_at(
        "param p [kg*mm/sek] = 1;",
        "no unit called \"sek\"; units are m g s N Pa J W Hz A V ohm H F Wb with prefixes, kg rad deg rev rpm min h t bar",
        "param p [kg*mm/sek] = 1;
               ~~~",
    );
    points_at(
        "body b { mass [m] = 1; inertia [kg*m^2] = 1; }",
        "mass is given a length: expected kg, found m",
        "body b { mass [m] = 1; inertia [kg*m^2] = 1; }
               ~",
    );
}

#[test]
fn expressions() {
    points_at(
        "output o [m] = link.end.x + 3;",
        "the summands do not fit: a plain number meets a length; write the unit, as in `3 [m]`",
        "output o [m] = link.end.x + 3;
                            ~",
    );
    points_at(
        "output o [m] = 2*(link.end.x + heavy*3);",
        "the summands do not fit: a length (m) meets a mass (kg)",
        "output o [m] = 2*(link.end.x + heavy*3);
                  ~~~~~~~~~~~~~~~~~~~~",
    );
    points_at(
        "output o [m] = sqrt(1 - 4/2) * 1 [m];",
        "this has no value: it is not defined",
        "output o [m] = sqrt(1 - 4/2) * 1 [m];
               ~~~~~~~~~~~~~",
    );
}

#[test]
fn two_places() {
    let source = slider_crank("rod crank { mass [kg] = 1; length [m] = 1; }");
    let diagnostics = bad(&source);
    let error = diagnostics.iter().next().expect("an error");
    assert_eq!(error.message, "`crank` is declared twice; rename one of them");
    assert_eq!(underlined(&source, error.region), "rod crank { mass [kg] = 1; length [m] = 1; }\n    ~~~~~");
    assert_eq!(error.notes[0].message, "the first `crank` is here");
    let marked = underlined(&source, error.notes[0].region);
    assert!(marked.ends_with("\n         ~~~~~"), "{marked}");
    assert_eq!(error.notes[0].region.start.start().line, 5);
}

/// Checks a conflict: the message's place, and that of its note, both without the indentation of the line.
#[track_caller]
fn points_at_two(more: &str, message: &str, marked: &str, note: &str, other: &str) {
    let source = slider_crank(more);
    let diagnostics = bad(&source);
    let errors: Vec<_> = diagnostics.iter().collect();
    assert_eq!(errors.len(), 1, "{diagnostics}");
    assert_eq!((errors[0].message.as_str(), errors[0].notes[0].message.as_str()), (message, note));
    assert_eq!(underlined(&source, errors[0].region), marked);
    assert_eq!(underlined(&source, errors[0].notes[0].region), other);
}

#[test]
fn what_is_said_twice() {
    points_at_two(
        "gravity [m/s^2] = (0, -9.81); gravity [m/s^2] = (0, -1.62);",
        "gravity is given twice; write it once",
        "gravity [m/s^2] = (0, -9.81); gravity [m/s^2] = (0, -1.62);
                              ~~~~~~~",
        "the first `gravity` is here",
        "gravity [m/s^2] = (0, -9.81); gravity [m/s^2] = (0, -1.62);
                  ~~~~~~~~~~",
    );
    points_at_two(
        "expect { degrees_of_freedom = 1; degrees_of_freedom = 2; }",
        "`degrees_of_freedom` of `expect` is given twice",
        "expect { degrees_of_freedom = 1; degrees_of_freedom = 2; }
                                 ~~~~~~~~~~~~~~~~~~~~~~",
        "the first `degrees_of_freedom` is here",
        "expect { degrees_of_freedom = 1; degrees_of_freedom = 2; }
         ~~~~~~~~~~~~~~~~~~~~~~",
    );
    points_at_two(
        "start { base.rate [rad/s] = 1; base.rate [rad/s] = 2; }",
        "the start of `base.rate` is given twice",
        "start { base.rate [rad/s] = 1; base.rate [rad/s] = 2; }
                               ~~~~~~~~~",
        "the first `base.rate` is here",
        "start { base.rate [rad/s] = 1; base.rate [rad/s] = 2; }
        ~~~~~~~~~",
    );
}

#[test]
fn values_of_properties() {
    points_at(
        "body b { mass [kg] = 1 - 2; inertia [kg*m^2] = 1; } joint j: revolute(b.center, link.end);",
        "the mass of `b` is negative: -1 kg; it must be zero or more",
        "body b { mass [kg] = 1 - 2; inertia [kg*m^2] = 1; } joint j: revolute(b.center, link.end);
                     ~~~~~",
    );
    points_at(
        "param none [m] = 0; rod b { mass [kg] = 1; length [m] = none; } joint j: revolute(b.center, link.end);",
        "the length of `b` must be positive, found 0 m",
        "param none [m] = 0; rod b { mass [kg] = 1; length [m] = none; } joint j: revolute(b.center, link.end);
                        ~",
    );
}

#[test]
fn arguments() {
    points_at(
        "joint j: point_on_line(link.end, way);",
        "the line comes first and then the point on it: write `point_on_line(way, link.end)`",
        "joint j: point_on_line(link.end, way);
                       ~~~~~~~~~~~~~",
    );
    points_at(
        "force f: force(ground(0, 0)) = (1, 0) [N];",
        "`f` acts at `ground(0, 0)`, a place of the ground, which nothing moves: write a place of a body, `body.point`",
        "force f: force(ground(0, 0)) = (1, 0) [N];
               ~~~~~~~~~~~~",
    );
    points_at(
        "spring s: spring(crank.pin, link.end, k [N/m] = 1);",
        "`spring` has no argument called \"k\"; did you mean `stiffness`?",
        "spring s: spring(crank.pin, link.end, k [N/m] = 1);
                                      ~",
    );
    points_at(
        "#[allow(unusd)] const A [m] = 1;",
        "no warning called \"unusd\"; did you mean `unused`?",
        "#[allow(unusd)] const A [m] = 1;
        ~~~~~",
    );
}

#[test]
fn names_with_indices() {
    points_at(
        "repeat i in 0..2 { rod a[i] { mass [kg] = 1; length [m] = 1; } joint j[i]: revolute(a[i].end, a[i+1].start); }",
        "no \"a[2]\": indices go from \"a[0]\" to \"a[1]\"",
        "repeat i in 0..2 { rod a[i] { mass [kg] = 1; length [m] = 1; } joint j[i]: revolute(a[i].end, a[i+1].start); }
                                                                                              ~~~~~~",
    );
}

#[test]
fn errors_come_in_the_order_of_the_source() {
    let source = slider_crank(
        "rod b { mass = 1; length = 1; } output o [m] = nothing; joint j: revolute(b.end, crnk.pin);",
    );
    let diagnostics = bad(&source);
    let places: Vec<_> = diagnostics.iter().map(|error| error.region.start.start()).collect();
    assert_eq!(places.len(), 4, "{diagnostics}");
    assert!(places.is_sorted(), "{diagnostics}");
}

#[test]
fn several_statements_at_once() {
    let source = slider_crank("param p [kg = 1;");
    assert!(source.parse::<proc_macro2::TokenStream>().is_err(), "unbalanced brackets never reach the macro");

    let source = slider_crank(
        "param = 1;
        joint j revolute(ground(0, 0), crank.pin);
        body { mass [kg] = 1; }
        body c { mass [kgg] = 1; inertia = ; }
        start { base.angle [rad] 1; base.rate = ; }
        output o [m] = 1 +;",
    );
    let messages: Vec<String> = bad(&source).iter().map(|error| error.message.clone()).collect();
    assert_eq!(
        messages,
        [
            "expected the name of the parameter, found `=`",
            "expected `:` and what the joint is, such as `revolute(…);`, found `revolute`",
            "expected the name of the body, found `{`",
            "no unit called \"kgg\"; did you mean `kg`?",
            "expected a value, found `;`",
            "expected `=` (a condition) or `~` (a guess), found `1`",
            "expected a value, found `;`",
            "expected a value, found `;`",
        ]
    );
}

#[test]
fn compile_errors_carry_the_message() {
    let text = bad(&slider_crank("output o [m] = nothing;")).into_compile_errors().to_string();
    assert_eq!(text.replace(' ', ""), "::core::compile_error!{\"novaluecalled\\\"nothing\\\"\"}");
}
