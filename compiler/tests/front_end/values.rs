//! Expressions: precedence, folding, units. Each value is that of a parameter, so it must fold to a number.

use crate::good;

fn value(unit: &str, expression: &str) -> f64 {
    let source = format!(
        "planar V {{ const L [mm] = 250; const N = 3; param p {unit} = {expression};
         body b {{ mass [kg] = 1; inertia [kg*m^2] = 1; }} }}"
    );
    good(&source).parameters[0].default
}

#[test]
fn precedence() {
    for (expression, expected) in [
        ("1 + 2*3", 7.0),
        ("(1 + 2)*3", 9.0),
        ("2 + 3^2", 11.0),
        ("-3^2", -9.0),
        ("2^3^2", 512.0),
        ("2^-1", 0.5),
        ("2*-3", -6.0),
        ("8/4/2", 1.0),
        ("1 - 2 - 3", -4.0),
        ("- -2", 2.0),
        ("1/2", 0.5),
        ("N/2", 1.5),
        ("1_000e-3", 1.0),
    ] {
        assert_eq!(value("[1]", expression), expected, "{expression}");
    }
}

#[test]
fn functions() {
    for (expression, expected) in [
        ("sqrt(2)", std::f64::consts::SQRT_2),
        ("abs(-2)", 2.0),
        ("sign(-2)", -1.0),
        ("min(1, 2) + max(1, 2)", 3.0),
        ("sin(90 [deg])", 1.0),
        ("cos(0)", 1.0),
        ("exp(0) + ln(1)", 1.0),
        ("if(1 < 2 and not 2 < 1, 5, 6)", 5.0),
        ("if(1 >= 2 or 1 != 1, 5, 6)", 6.0),
        ("L / 1 [m]", 0.25),
    ] {
        assert_eq!(value("[1]", expression), expected, "{expression}");
    }
    assert_eq!(value("[rad]", "atan2(1, 1)"), std::f64::consts::FRAC_PI_4);
    assert_eq!(value("[rad]", "acos(0)"), std::f64::consts::FRAC_PI_2);
}

#[test]
fn units_and_bare_numbers() {
    for (unit, expression, expected) in [
        ("[mm]", "3", 0.003),
        ("[mm]", "3 [m]", 3.0),
        ("[mm]", "2*L", 0.5),
        ("[mm]", "(1 + 2) [cm]", 0.03),
        ("[deg]", "180", std::f64::consts::PI),
        ("[rad]", "pi/2", std::f64::consts::FRAC_PI_2),
        ("[rev]", "1", 2.0 * std::f64::consts::PI),
        ("[kN/mm]", "1", 1e6),
        ("[t]", "1", 1000.0),
        ("[bar]", "1", 1e5),
        ("[\u{b5}m]", "1", 1e-6),
        ("[kg*m/s^2]", "1 [N]", 1.0),
        ("[N/(m*s)]", "1", 1.0),
        ("[1/s]", "1 [Hz]", 1.0),
        ("[rad/s]", "0", 0.0),
        // The angle cancels against a length: rad m is m, and a speed over a radius is an angular rate.
        ("[m]", "2 [rad] * 3 [m]", 6.0),
        ("[rad/s]", "3 [m/s] / L", 12.0),
        ("[rad/s]", "sqrt(4 [N*m/rad] / 1 [kg*m^2])", 2.0),
        ("[m]", "sqrt(4 [m^2])", 2.0),
    ] {
        assert!((value(unit, expression) - expected).abs() <= 1e-15 * expected, "{unit} {expression}");
    }
}

#[test]
fn constants_in_any_order() {
    let chain: String = (0..2000).map(|i| format!("const C{i} [1] = C{} + 1;", i + 1)).collect();
    let source = format!(
        "planar V {{ {chain} const C2000 [1] = 0; param p = C0;
         body b {{ mass [kg] = 1; inertia [kg*m^2] = 1; }} }}"
    );
    assert_eq!(good(&source).parameters[0].default, 2000.0);
}

/// Mass and moment of inertia of a planar shape.
fn shape(shape: &str) -> (f64, f64) {
    let mechanism = good(&format!("planar V {{ param r [m] = 0.5; {shape} }}"));
    let defaults = [0.5];
    let number = |expr| linkwright_compiler::model::value_at(expr, &defaults).expect("of parameters");
    (number(&mechanism.bodies[0].mass), number(&mechanism.bodies[0].inertia.moments[2]))
}

#[test]
fn planar_shapes_have_mass_by_density() {
    let pi = std::f64::consts::PI;
    for (written, mass, inertia) in [
        ("rod b { mass [kg] = 2; length [m] = 3; }", 2.0, 1.5),
        (
            "rod b { density [kg/m^3] = 1000; length [m] = 3; radius [m] = 0.1; }",
            30.0 * pi,
            30.0 * pi * 9.03 / 12.0,
        ),
        (
            "disk b { density [kg/m^3] = 1000; radius [m] = r; thickness [m] = 0.1; }",
            25.0 * pi,
            25.0 * pi / 8.0,
        ),
        (
            "box b { density [kg/m^3] = 1000; width [m] = 0.1; height [m] = 0.2; thickness [m] = 0.3; }",
            6.0,
            0.025,
        ),
        (
            "box b { density [kg/m^3] = 1000; width [m] = 1; height [m] = 1; thickness [m] = 1; inertia [kg*m^2] = 7; }",
            1000.0,
            7.0,
        ),
    ] {
        let (m, i) = shape(written);
        assert!((m / mass - 1.0).abs() < 1e-14 && (i / inertia - 1.0).abs() < 1e-14, "{written}: {m}, {i}");
    }
}

/// `dot`, `cross` and `norm` take places and what is made of them, and nothing else takes vectors.
#[test]
fn vectors_stand_in_three_functions() {
    let source = |space: &str, output: &str| {
        let (inertia, at) = if space == "planar" { ("0.1", "0, 1") } else { ("(0.1, 0.1, 0.1)", "0, 1, 2") };
        format!(
            "{space} P {{ body a {{ mass [kg] = 1; inertia [kg*m^2] = {inertia}; point p [m] = ({at}); }}
             particle cross {{ mass [kg] = 1; }}
             output x = {output}; }}"
        )
    };
    for (space, output) in [
        ("planar", "norm(a.p - cross.center)/1 [m]"),
        ("planar", "cross(2*a.p, -a.p.velocity/3)/1 [m^2/s]"),
        ("planar", "cross(a.p + cross.center - ground(1, 2) [m], a.center)/1 [m^2]"),
        ("planar", "dot(a.p.velocity, a.p.velocity)/1 [m^2/s^2]"),
        ("spatial", "dot(cross(a.p, cross.center), a.p*a.rate.x)/1 [m^3*rad/s]"),
        ("spatial", "norm(cross(a.p, cross.center.velocity))/1 [m^2/s]"),
    ] {
        crate::good(&source(space, output));
    }
    for (space, output, expected) in [
        (
            "planar",
            "norm(3)",
            "`norm` takes vectors: places and their velocities, sums of these, and products with numbers, such as `a.end - b.start`",
        ),
        (
            "planar",
            "dot(a.p, a.angle)",
            "`dot` takes vectors: places and their velocities, sums of these, and products with numbers, such as `a.end - b.start`",
        ),
        ("planar", "norm(a.p*a.p)", "two vectors meet in a product: write `dot(a, b)` or `cross(a, b)`"),
        ("planar", "norm(a.p - a.p.velocity)", "the two sides of `-` do not fit"),
        ("planar", "norm(a.p/0)", "division by zero"),
        (
            "spatial",
            "cross(a.p, a.p)",
            "the cross product of vectors in space is a vector: write `dot(cross(a, b), c)`, or `norm(cross(a, b))`",
        ),
        ("spatial", "norm(cross(a.p))", "`cross` takes 2 arguments, found 1"),
    ] {
        let found = crate::bad(&source(space, output)).to_string();
        assert!(found.contains(expected), "{output}\nexpected: {expected}\nfound: {found}");
    }
    let constant =
        "planar P { body a { mass [kg] = 1; inertia [kg*m^2] = 1; point p [m] = (0, 1); } output x = 1;
                    param k = norm(a.p)/1 [m]; output y = k; }";
    assert!(
        crate::bad(constant).to_string().contains("may depend on constants only"),
        "{}",
        crate::bad(constant)
    );
}
