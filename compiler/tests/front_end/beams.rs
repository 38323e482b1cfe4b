//! Beams: what is warned of, and what is not.

use linkwright_compiler::compile;

/// One beam with what it is like, its joints and its start.
fn told(beam: &str, rest: &str) -> Vec<String> {
    let source = format!(
        "planar Beams {{ body press {{ mass [kg] = 200; inertia [kg*m^2] = 1; }}
         joint rail: prismatic(ground(0, 0) [m], press.center, axis = (1, 0));
         beam rod {{ length [m] = 1; section = circle(diameter [mm] = 10); young [GPa] = 210; density [kg/m^3] = 7800; {beam} }} {rest} }}"
    );
    let compiled =
        compile(source.parse().expect("tokens"), None).unwrap_or_else(|errors| panic!("{source}\n{errors}"));
    compiled.warnings.iter().map(|warning| warning.message.clone()).collect()
}

/// π² E I/L² and (1.8751/L)² √(E I/μ) by hand.
const EULER: f64 = 1_017.393_5;
const CLAMPED: f64 = 45.609_27;

#[test]
fn a_thrust_near_eulers_load() {
    let pressed = |part: f64, beam: &str| {
        told(
            beam,
            &format!(
                "joint left: revolute(ground(0, 0) [m], rod.start); joint right: revolute(rod.end, press.center);
                 force push: force(press.center, direction = (1, 0)) = {} [N]; start {{ rod.angle [rad] ~ 0; rail.travel [m] ~ 1; }}",
                -part * EULER
            ),
        )
    };
    for shapes in ["shapes = pinned;", "shapes = free;"] {
        assert!(pressed(0.3, shapes).is_empty() && pressed(-2.0, shapes).is_empty());
        let found = pressed(0.5, shapes);
        assert!(
            found.len() == 1 && found[0].contains("508.7 N at the start, 0.5 of Euler's load, 1017 N"),
            "{found:?}"
        );
        assert!(pressed(0.5, &format!("{shapes} stiffening = on;")).is_empty());
    }
    // A column on a foot has a quarter of it, and an input decides nothing.
    let column = |load: &str| {
        told(
            "shapes = clamped;",
            &format!(
                "input load [N]; joint foot: fixed(ground(0, 0) [m], rod.start);
                 force push: force(rod.end, direction = (1, 0)) = {load}; output load [N] = load;"
            ),
        )
    };
    for little in ["-70 [N]", "-load"] {
        assert_eq!(column(little), Vec::<String>::new(), "{little}");
    }
    let found = column("-127.2 [N]");
    assert!(found.len() == 1 && found[0].contains("0.5 of Euler's load, 254.3 N"), "{found:?}");
}

#[test]
fn a_turn_near_the_first_frequency() {
    let turned = |part: f64, beam: &str| {
        told(
            beam,
            &format!(
                "joint left: revolute(ground(0, 0) [m], rod.start);
                 start {{ left.angle [rad] = 0; left.rate [rad/s] = {}; rail.travel [m] = 0; }}",
                part * CLAMPED
            ),
        )
    };
    assert!(turned(0.3, "").is_empty() && turned(1.2, "stiffening = on;").is_empty());
    assert!(turned(1.2, "modes = (axial = 1, bending = 0);").is_empty());
    let found = turned(-1.2, "");
    assert!(found.len() == 1 && found[0].contains("turns at 54.73 rad/s at the start, 1.2 of"), "{found:?}");
}

#[test]
fn shapes_and_sections_that_do_not_suit() {
    let held = |beam: &str, joint: &str| {
        told(
            beam,
            &format!(
                "joint foot: {joint}(ground(0, 0) [m], rod.start); start {{ rod.angle [rad] ~ 0; rail.travel [m] = 0; }}"
            ),
        )
    };
    for shapes in ["clamped", "static"] {
        let beam = format!("shapes = {shapes}; modes = (bending = 2);");
        assert!(held(&beam, "fixed").is_empty());
        let found = held(&beam, "revolute");
        assert!(
            found.len() == 1 && found[0].contains(&format!("the `{shapes}` shapes of the beam `rod`")),
            "{found:?}"
        );
    }
    assert!(held("", "revolute").is_empty());
    let thick = |mm: f64| {
        let source = format!(
            "planar Thick {{ beam rod {{ length [m] = 1; section = rectangle(height [mm] = {mm}, width [mm] = 10); young [GPa] = 210;
             density [kg/m^3] = 7800; shapes = clamped; point far [m] = (0.9, 0); }}
             joint foot: fixed(ground(0, 0) [m], rod.start); joint tip: distance(ground(0.9, 1) [m], rod.far, length [m] = 1); }}"
        );
        compile(source.parse().expect("tokens"), None)
            .unwrap_or_else(|errors| panic!("{errors}"))
            .warnings
            .to_string()
    };
    // √12 L/h.
    assert_eq!(thick(173.0), "");
    assert!(thick(174.0).contains("is 19.9 radii of gyration √(I/A) long; below 20"), "{}", thick(174.0));
}
