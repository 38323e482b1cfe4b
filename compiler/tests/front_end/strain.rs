//! By how much beams are turned and pressed: at the start, and as drivers turn them later.

use linkwright_compiler::check::{Strain, strains};
use linkwright_compiler::{Compiled, compile};
use std::f64::consts::PI;

fn compiled(source: &str) -> Compiled {
    compile(source.parse().expect("tokens"), None).unwrap_or_else(|errors| panic!("{source}\n{errors}"))
}

fn of(compiled: &Compiled) -> Vec<Strain> {
    let Compiled { mechanism, complete, assembly, .. } = compiled;
    strains(mechanism, &complete.equations, &complete.solved, assembly)
}

fn near(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-9 * expected.abs(), "{found} is not {expected}");
}

/// √12 L/h, 1.8751² √(EI/mL³), the rate, and the thrust of a weight on a column against a quarter of π² EI/L².
#[test]
fn beams_at_the_start() {
    let found = of(&compiled(
        "planar Column { gravity [m/s^2] = (-9.81, 0);
         beam rod { length [m] = 2; section = rectangle(height [mm] = 10, width [mm] = 30); young [GPa] = 210; mass [kg] = 3; shapes = clamped; }
         body load { mass [kg] = 4; inertia [kg*m^2] = 0.1; } joint foot: fixed(ground(0, 0) [m], rod.start); joint top: fixed(rod.end, load.center); }",
    ));
    let [column] = found.as_slice() else { panic!("{found:?}") };
    let rigidity = 210e9 * 0.03 * 1e-6 / 12.0;
    near(column.slenderness, 12_f64.sqrt() * 200.0);
    near(column.natural, 1.875_104_068_711_961_f64.powi(2) * (rigidity / (3.0 * 8.0_f64)).sqrt());
    let [thrust, euler] = column.pressed.expect("it stands on its foot");
    // Between what its foot and its head have: half of its own weight.
    near(thrust, (4.0 + 1.5) * 9.81);
    near(euler, 0.25 * PI * PI * rigidity / 4.0);
    assert!(column.rate == 0.0 && !column.by_inputs);

    let spun = of(&compiled(
        "spatial Spun { beam rod { length [m] = 1; section = circle(diameter [mm] = 10); young [GPa] = 210; density [kg/m^3] = 7800; stiffening = on; }
         joint ball: spherical(ground(0, 0, 0) [m], rod.start); start { rod.rate.x [rad/s] = 50; rod.rate.y [rad/s] = 3; rod.rate.z [rad/s] = -4; } }",
    ));
    near(spun[0].rate, 5.0);
    assert!(of(&compiled("planar None { rod a { mass [kg] = 1; length [m] = 1; } joint pin: revolute(ground(0, 0) [m], a.start); }")).is_empty());
}

/// A blade on a hub that is driven, in the plane; √(EI/mL³) 1.8751² is 45.609 rad/s.
fn blade(beam: &str, more: &str) -> String {
    compiled(&format!(
        "planar Driven {{ body hub {{ mass [kg] = 1; inertia [kg*m^2] = 1; }}
         beam rod {{ length [m] = 1; section = circle(diameter [mm] = 10); young [GPa] = 210; density [kg/m^3] = 7800; {beam} }}
         joint axle: revolute(ground(0, 0) [m], hub.center); {more} }}"
    ))
    .warnings
    .to_string()
}

#[test]
fn what_drivers_turn_later() {
    let root = "joint root: fixed(hub.center, rod.start);";
    // Up to 40 rad/s in 5 s: a third of the frequency is passed at 1.9 s.
    let law = "drive motor: axle.angle = 4 [rad/s^2]*time*time;";
    let found = blade("shapes = clamped;", &format!("{root} {law}"));
    assert!(found.contains("the beam `rod` is driven at 15.24 rad/s after 1.91 s, 0.33 of its first clamped frequency, 45.61 rad/s"), "{found}");
    for (beam, more) in [
        ("shapes = clamped; stiffening = on;", format!("{root} {law}")),
        ("shapes = clamped;", format!("{root} drive motor: axle.angle = 15 [rad/s]*time;")),
        ("shapes = clamped;", format!("{root} drive motor: axle.angle = 0.1 [rad]*sin(100 [rad/s]*time);")),
        // Not what drives the beam.
        (
            "",
            format!("joint hinge: revolute(hub.center, rod.start); {law} start {{ hinge.angle [rad] = 0; }}"),
        ),
    ] {
        assert_eq!(blade(beam, &more), "", "{beam} {more}");
    }
    let swings = blade(
        "shapes = clamped;",
        &format!("{root} drive motor: axle.angle = 0.3 [rad]*cos(100 [rad/s]*time);"),
    );
    assert!(swings.contains("the beam `rod` is driven at"), "{swings}");
    // In space an axis along the beam bends nothing.
    let about = |axis: &str| {
        let source = format!(
            "spatial Driven {{ beam rod {{ length [m] = 1; section = circle(diameter [mm] = 10); young [GPa] = 210; density [kg/m^3] = 7800; shapes = clamped;
             modes = (bending_y = 1, bending_z = 1); }} body hub {{ mass [kg] = 1; inertia [kg*m^2] = (1, 1, 1); }}
             joint axle: revolute(ground(0, 0, 0) [m], hub.origin, axis = {axis}); joint root: fixed(hub.origin, rod.start);
             drive motor: axle.angle = 4 [rad/s^2]*time*time; }}"
        );
        compiled(&source).warnings.to_string()
    };
    assert_eq!(about("(1, 0, 0)"), "");
    assert!(about("(0, 0, 1)").contains("after 1.91 s"), "{}", about("(0, 0, 1)"));
    // √2 times later.
    assert!(about("(1, 0, 1)").contains("after 2.69 s"), "{}", about("(1, 0, 1)"));
}
