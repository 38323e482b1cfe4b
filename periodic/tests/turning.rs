//! Wheels that turn: a cycle is one tooth further on each time.

use core::f64::consts::TAU;
use linkwright::{AssembleExt, mechanism};
use linkwright_periodic::{Along, Cycle, End};

mechanism! {
    /// The gear pair with k = 1 + 0.3 cos Ωt, turning: k follows the phase of the wheel that swings, and not time.
    pub planar Turning {
        const BASE [m] = 3e-3 [m]*50/2*cos(20 [deg]);
        param omega [rad/s] = 1 in 0.01..10;
        body pinion { mass [kg] = 1; inertia [kg*m^2] = 1; toothing rim: external(teeth = 50, module [mm] = 3); }
        body wheel  { mass [kg] = 1; inertia [kg*m^2] = BASE*BASE*1 [kg]; toothing rim: external(teeth = 50, module [mm] = 3); }
        joint front: revolute(ground(0, 0), pinion.center);
        joint back:  revolute(ground(150, 0) [mm], wheel.center);
        drive turning: front.angle = omega*time/50;
        mesh teeth: mesh(pinion.rim, wheel.rim, stiffness = 1 [N/m]*(1 - 0.3*cos(50*back.angle)), damping = always(0.1 [N*s/m]),
                         backlash [um] = 2);
        torque load: torque(back) = BASE*1e-7 [N];
        start { back.rate [rad/s] = -0.02; }
        options { emit = (tangent); }
        output x [um] = teeth.deflection;
    }
}

/// 50 u/r_b is 7e-4 rad; the rms differs from that of the equation in time by 4e-6 of itself.
#[test]
fn stiffness_by_phase_is_nearly_that_by_time() {
    let cycle = Cycle::new(|omega| Turning::prepare(TurningParameters { omega }), |omega| TAU / omega)
        .advancing("back.angle", -TAU / 50.0)
        .switch("x", 1e-6)
        .switch("x", -1e-6);
    let start = Turning::<f64>::default().start();
    let motion = cycle.settle(1.0, &start, 40).unwrap();
    assert_eq!(motion.start.len(), 2);
    let found = cycle.measure(&motion, "x").unwrap();
    // Case B of the gear pair at Ω = 1: rms 0.1001475, largest 1.223308.
    let deviations = [
        found.rms.abs() / 0.1001475e-6 - 1.0,
        found.largest.abs().max(found.least.abs()) / 1.223308e-6 - 1.0,
    ];
    assert!(deviations.iter().all(|deviation| deviation.abs() < 1e-5), "{deviations:?}");
    let branch = cycle.branch(&motion, &Along::new(0.6..=1.0).downwards()).unwrap();
    assert_eq!(branch.end, End::Left);
    // By time the folds are at 0.7056975 and 0.8445641.
    let folds: Vec<f64> = branch.folds.iter().map(|fold| fold.value).collect();
    assert!((folds[0] - 0.7056975).abs() < 2e-5 && (folds[1] - 0.8445641).abs() < 1e-5, "{folds:?}");
}
