//! Points on curves: what a curve may be made of, and where it may stand.

use crate::bad;
use linkwright_compiler::compile;

fn wire(arguments: &str) -> String {
    format!(
        "planar Wire {{
            param k [1/m] = 2;
            gravity [m/s^2] = (0, -9.81);
            table rail(along [m]) [m] = [(0, 0), (0.4, 0.1), (0.7, 0.3), (1, 0.2)], natural, outside = hold;
            table bend(along [m]) [m] = [(0, 0), (0.4, 0.1), (1, 0.2)], linear;
            particle bead {{ mass [kg] = 0.2; }}
            rod arm {{ mass [kg] = 1; length [m] = 1; }}
            joint pin: revolute(ground(0, 0), arm.start);
            joint wire: point_on_curve(ground(1, 0) [m], bead.center, {arguments};
            start {{ wire.parameter [m] = 0.1; pin.angle [rad] = 0.2; }}
        }}"
    )
}

/// The messages of the whole compiler.
fn all(source: &str) -> String {
    let found = compile(source.parse().expect("tokens"), None).map(|_| ());
    found.err().map_or_else(String::new, |errors| errors.to_string())
}

#[test]
fn a_curve_is_made_of_its_own_parameter() {
    for (arguments, expected) in [
        ("y = 3)", "expected m"),
        ("x = wire.parameter)", "`point_on_curve` needs its y: write `y = …`"),
        (
            "y = abs(wire.parameter))",
            "`y` of `wire` has a corner by `abs`, where its point would have no velocity: write a smooth function, or a `table` by a spline",
        ),
        ("y = min(wire.parameter, 1 [m]))", "has a corner by `min`"),
        ("x = max(wire.parameter, 1 [m]), y = wire.parameter)", "`x` of `wire` has a corner by `max`"),
        ("y = sign(wire.parameter)*1 [m])", "has a corner by `sign`"),
        (
            "y = if(wire.parameter > 0, wire.parameter, 0))",
            "`y` of `wire` goes over from one function to another by `if`, where its point could jump or have no velocity: write one smooth \
             function, such as `smoothstep`, or a `table` by a spline",
        ),
        ("y = step(k*wire.parameter)*1 [m])", "to another by `step`"),
        ("y = if(k > 1 [1/m], abs(wire.parameter), 0))", "has a corner by `abs`"),
        ("y = smoothstep(abs(wire.parameter), 0, 1 [m])*1 [m])", "has a corner by `abs`"),
        ("y = max(smoothstep(wire.parameter, 0, 1 [m]), 0.5)*1 [m])", "has a corner by `max`"),
        ("y = bend(wire.parameter))", "bend"),
        (
            "y = arm.end.y)",
            "`y` of `wire` is a function of `wire.parameter` and of parameters: the curve belongs to its first place and does not change; put that place on what moves instead",
        ),
        ("y = 1 [m/s]*time)", "`time` is the time, but a curve may depend on"),
        ("y = wire.parameter_rate*1 [s])", "`wire.parameter_rate` is a velocity, but a curve may depend on"),
        (
            "x = 1/k, y = 2 [m])",
            "neither `x` nor `y` of `wire` changes with `wire.parameter`: the curve is a point, which a `revolute` holds",
        ),
        (
            "y = wire.parameter) = penalty(stiffness [N/m] = 1e4)",
            "a point_on_curve that yields is a force along how far its place is off the curve: write `force wire: along(off) = -stiffness*(off)`",
        ),
    ] {
        let found = bad(&wire(arguments));
        let found: Vec<&str> = found.iter().map(|error| error.message.as_str()).collect();
        assert!(matches!(found[..], [message] if message.contains(expected)), "{found:?}, not {expected}");
    }
}

#[test]
fn a_curve_is_of_the_plane() {
    let found = bad("spatial Wire { particle bead { mass [kg] = 0.3; }
         joint wire: point_on_curve(ground(0, 0, 0), bead.center, y = 2 [1/m]*wire.parameter*wire.parameter); }");
    let expected = "a point_on_curve joint is one of planar mechanisms so far: write `planar` before the name of the mechanism, if it moves \
                    in a plane";
    assert_eq!(found.iter().map(|error| error.message.as_str()).collect::<Vec<_>>(), [expected]);
}

#[test]
fn a_curve_may_be_made_of_what_is_smooth() {
    assert_eq!(all(&wire("y = smoothstep(k*wire.parameter, -1, 1)*1 [m])")), "");
    assert_eq!(
        all(&wire("y = if(k > 1 [1/m], wire.parameter, 0) + abs(k)*wire.parameter*wire.parameter)")),
        ""
    );
}

#[test]
fn a_curve_that_is_no_graph_carries_a_body() {
    assert_eq!(all(&wire("y = rail(wire.parameter))")), "");
    assert_eq!(all(&wire("x = k*wire.parameter*wire.parameter, y = wire.parameter)")), "");
    let cycloid =
        "x = wire.parameter + 0.2 [m]*sin(wire.parameter/0.2 [m]), y = -0.2 [m]*cos(wire.parameter/0.2 [m]))";
    assert_eq!(all(&wire(cycloid)), "");
    let absolute = wire(cycloid).replace("start {", "options { coordinates = absolute; } start {");
    let stands =
        wire(cycloid).replace("wire.parameter [m] = 0.1", "wire.parameter [m] = 0.62831853071795864769");
    let cut = wire(cycloid).replace("start {", "options { cut = (wire); } start {");
    let both = wire(cycloid).replace(
        "start {",
        "joint other: point_on_curve(arm.start, bead.center, x = other.parameter + 1 [1/m]*other.parameter*other.parameter, y = other.parameter*0.5); start {",
    );
    for (source, expected) in [
        (absolute, "which absolute coordinates do not have; write `coordinates = tree`"),
        (stands, "the curve of \"wire\" stands still where its parameter is"),
        (cut, "\"wire\" closes a loop, and its curve is no graph"),
        (both, "closes a loop, and its curve is no graph"),
    ] {
        let found = all(&source);
        assert!(found.contains(expected), "{found}, not {expected}");
    }
}

#[test]
fn a_curve_is_a_number_where_it_starts() {
    let at = |start: &str, function: &str| {
        all(&wire(&format!("y = {function})"))
            .replace("wire.parameter [m] = 0.1", &format!("wire.parameter [m] = {start}")))
    };
    let expected = "`y` of \"wire\" has no value at the start, where `wire.parameter` is -0.3: start at another parameter, or write a \
                    function that has one there";
    assert!(at("-0.3", "ln(k*wire.parameter)*1 [m]").contains(expected));
    for (start, function, what) in [
        ("-0.3", "sqrt(wire.parameter*1 [m])", "no value"),
        ("1.5", "1 [m]*asin(wire.parameter/(1 [m]))/(1 [rad])", "no value"),
        ("0", "1 [m^2]/wire.parameter", "no value"),
        ("0", "sqrt(wire.parameter*1 [m])", "no slope"),
        ("0", "1 [m]*(k*wire.parameter)^1.5", "no curvature"),
    ] {
        let found = at(start, function);
        assert!(found.contains(what) && !found.contains("no mass"), "{function}: {found}");
        assert_eq!(at("0.5", function), "", "{function}");
    }
}

#[test]
fn a_table_that_ends_is_asked_within() {
    let source =
        wire("y = rail(wire.parameter))").replace("wire.parameter [m] = 0.1", "wire.parameter [m] = 1.4");
    let compiled = compile(source.parse().expect("tokens"), None).expect("it compiles");
    let found: Vec<&str> = compiled.warnings.iter().map(|warning| warning.message.as_str()).collect();
    assert!(found.iter().any(|message| message.contains("rail") && message.contains("1.4")), "{found:?}");
}
