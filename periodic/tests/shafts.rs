//! A gear pair behind an elastic shaft: how strong its jump is by the stiffness of the shaft.

use core::f64::consts::TAU;
use linkwright::{AssembleExt, mechanism};
use linkwright_periodic::{Along, Cycle};

mechanism! {
    /// The teeth of `GearPairOscillator` in units of their own, pushed by a rotor of the same inertia through a shaft; the motor's torque swings by a third.
    pub planar Shafted {
        const BASE [m] = 3e-3 [m]*50/2*cos(20 [deg]);
        param omega [rad/s] = 0.6 in 0.01..10;
        /// Of the shaft, by that of the teeth.
        param stiffness [1] = 1 in 0.01..1000;
        body motor { mass [kg] = 1; inertia [kg*m^2] = BASE*BASE*1 [kg]; }
        body wheel { mass [kg] = 1; inertia [kg*m^2] = BASE*BASE*1 [kg]; toothing rim: external(teeth = 50, module [mm] = 3); }
        body partner { mass [kg] = 1; inertia [kg*m^2] = 1; toothing rim: external(teeth = 50, module [mm] = 3); }
        joint axle: revolute(ground(0, 0), wheel.center);
        joint front: revolute(ground(0, 0), motor.center);
        joint held: fixed(ground(150, 0) [mm], partner.center);
        mesh teeth: mesh(wheel.rim, partner.rim, stiffness [N/m] = 1, damping = always(0.1 [N*s/m]), backlash [um] = 2);
        shaft coupling: shaft(front, axle, ratio = 1, stiffness = stiffness*BASE*BASE*1 [N/m]/1 [rad], damping = BASE*BASE*0.02 [N*s/m]/1 [rad]);
        torque load: torque(front) = BASE*1e-6 [N]*(0.1 + 0.033*cos(omega*time));
        options { emit = (tangent); }
        output x [um] = teeth.deflection;
    }
}

/// Folds of the first resonance as a part of its frequency: how far the jump down is below the jump up.
fn width(stiffness: f64) -> f64 {
    let cycle = Cycle::new(
        move |omega| Shafted::prepare(ShaftedParameters { omega, stiffness }),
        |omega| TAU / omega,
    )
    .switch("x", 1e-6)
    .switch("x", -1e-6);
    // Of the teeth and the shaft without play.
    let half = stiffness + 0.5;
    let first = (half - (half * half - stiffness).sqrt()).sqrt();
    let start = Shafted::<f64>::default().start();
    let from = 0.6 * first;
    let settled = cycle.settle(from, &start, 60).unwrap();
    let branch = cycle.branch(&settled, &Along { step: 0.02, ..Along::new(from..=1.3 * first) }).unwrap();
    let folds: Vec<f64> = branch.folds.iter().map(|fold| fold.value).collect();
    println!("{stiffness}: {first} {folds:?}");
    match folds[..] {
        [] => 0.0,
        [up, down] => (up - down) / first,
        _ => panic!("{folds:?}"),
    }
}

/// The softer the shaft, the less of the first mode is in the teeth, and the weaker the jump.
#[test]
fn jumps_weaken_as_shafts_soften() {
    let widths = [20.0, 1.0, 0.3].map(width);
    assert!(widths.windows(2).all(|pair| pair[1] < 0.8 * pair[0]), "{widths:?}");
    assert!(widths[0] > 0.02, "{widths:?}");
}
