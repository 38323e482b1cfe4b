//! Inertia and loads as a joint feels them, against closed forms.

use crate::compiled;

/// Of a coordinate: kg m² or kg, N m or N.
fn felt(source: &str, expected: &[(&str, f64, f64)]) {
    let found = compiled(source).reflected();
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (found, (of, inertia, load)) in found.iter().zip(expected) {
        assert_eq!(found.of, *of);
        assert!((found.inertia / inertia - 1.0).abs() < 1e-12, "{found:?} for {inertia}");
        assert!((found.load - load).abs() < 1e-12 * (1.0 + load.abs()), "{found:?} for {load}");
    }
}

/// Behind a gear of ratio 5 a load counts with J/25 and T/5.
#[test]
fn behind_a_gear() {
    felt(
        "planar Geared {
            body motor { mass [kg] = 1; inertia [kg*m^2] = 0.0016; } body load { mass [kg] = 10; inertia [kg*m^2] = 0.45; }
            joint fast: revolute(ground(0, 0) [m], motor.center); joint slow: revolute(ground(0.3, 0) [m], load.center);
            gear box_of: gear(fast, slow, ratio = 5); torque working: torque(slow) = -24 [N*m];
        }",
        &[("fast.angle", 0.0196, -4.8), ("slow.angle", 0.49, -24.0)],
    );
}

/// m r² of a rack at its pinion, J/r² of the pinion at the rack, whichever way it goes.
#[test]
fn on_a_rack() {
    let source = |axis: &str| {
        format!(
            "planar Racked {{
                body pinion {{ mass [kg] = 1; inertia [kg*m^2] = 5e-5; toothing rim: external(teeth = 20, module [mm] = 2); }}
                body bar {{ mass [kg] = 1.6; inertia [kg*m^2] = 1; point near [mm] = (-90, 0); point far [mm] = (90, 0); line pitch = (bar.near, bar.far);
                            toothing teeth: rack(module [mm] = 2, line = bar.pitch); }}
                joint axle: revolute(ground(0, 20) [mm], pinion.center);
                joint rail: prismatic(ground(0, 0) [mm], bar.center, axis = {axis});
                gear drive: gear(pinion.rim, bar.teeth); force push: force(rail) = 30 [N];
            }}"
        )
    };
    // Below its axle the rack goes along x as the pinion turns.
    let (turned, moved) = (5e-5 + 1.6 * 4e-4, 1.6 + 5e-5 / 4e-4);
    felt(&source("(1, 0)"), &[("axle.angle", turned, 0.6), ("rail.travel", moved, 30.0)]);
    felt(&source("(-1, 0)"), &[("axle.angle", turned, -0.6), ("rail.travel", moved, 30.0)]);
}

/// m l²/3 and −m g l cos θ/2 of a rod, whatever its rate; nothing is told of two.
#[test]
fn of_rods() {
    let rod = "gravity [m/s^2] = (0, -9.81); rod one { mass [kg] = 3; length [m] = 2; } joint pivot: revolute(ground(0, 0) [m], one.start);";
    felt(
        &format!("planar One {{ {rod} start {{ pivot.angle [deg] = 60; pivot.rate [rad/s] = 7; }} }}"),
        &[("pivot.angle", 4.0, -3.0 * 9.81 * 0.5)],
    );
    felt(
        &format!(
            "planar Two {{ {rod} rod two {{ mass [kg] = 1; length [m] = 1; }} joint knee: revolute(one.end, two.start); }}"
        ),
        &[],
    );
}
