//! The derivative of a period against differences of periods: where damping acts in contact only, in closed loops, with states, inputs and turns.

use core::f64::consts::TAU;
use linkwright::{AssembleExt, StateOf, Tangent, mechanism};
use linkwright_periodic::nalgebra::DVector;
use linkwright_periodic::{Along, Cycle, PeriodicMotion};

mechanism! {
    /// A spur gear pair whose damping acts where teeth touch: the force jumps as they do.
    pub planar Rattle {
        param omega [rad/s] = 0.75 in 0.01..10;
        body wheel { mass [kg] = 1; inertia [kg*m^2] = 0.05; toothing rim: external(teeth = 50, module [mm] = 3); }
        body partner { mass [kg] = 1; inertia [kg*m^2] = 1; toothing rim: external(teeth = 50, module [mm] = 3); }
        joint axle: revolute(ground(0, 0), wheel.center);
        joint held: fixed(ground(150, 0) [mm], partner.center);
        mesh teeth: mesh(wheel.rim, partner.rim, stiffness [N/m] = 10, damping [N*s/m] = 1, backlash [mm] = 0.2);
        torque load: torque(axle) = 1e-5 [N*m]*(1 + 8*cos(omega*time));
        options { emit = (tangent); }
        output x [mm] = teeth.deflection;
        output force [N] = teeth.force;
    }
}

mechanism! {
    /// A crank and rocker that swings about its spring, pushed at the crank, with a motor's current.
    pub planar Swing {
        param voltage [V] = 2 in 0..100;
        input push [N*m];
        gravity [m/s^2] = (0, -9.81);
        rod crank   { mass [kg] = 1; length [m] = 0.5; }
        rod coupler { mass [kg] = 2; length [m] = 1.1; }
        rod rocker  { mass [kg] = 1.5; length [m] = 0.9; }
        joint pivot: revolute(ground(0, 0) [m], crank.start);
        joint pin:   revolute(crank.end, coupler.start);
        joint knee:  revolute(coupler.end, rocker.end);
        joint base:  revolute(ground(1, 0) [m], rocker.start);
        state current [A] = 0; rate current = (voltage - 1 [ohm]*current - 0.2 [V*s/rad]*pivot.rate)/0.1 [H];
        torque motor: torque(pivot) = 0.2 [N*m/A]*current + push;
        torsion_spring back: torsion_spring(pivot, stiffness [N*m/rad] = 60, damping [N*m*s/rad] = 1, angle [rad] = 1);
        start { pivot.angle [rad] = 1; pivot.rate [rad/s] = 0; base.angle [rad] ~ 1.2535; }
        options { emit = (tangent); }
        output angle [rad] = pivot.angle;
    }
}

/// ∂x(T)/∂x(0) beside central differences in every direction.
fn compare<M: Tangent<f64>>(cycle: &Cycle<'_, M>, motion: &PeriodicMotion<M>, step: f64, within: f64) {
    let map = cycle.map(motion.value, &motion.state).unwrap();
    assert_eq!(map.derivative, motion.monodromy);
    let x = &motion.start;
    let at = |x: &DVector<f64>| -> StateOf<M> { cycle.state(motion.value, &motion.state, x).unwrap() };
    for column in 0..x.len() {
        let step = step * motion.swing[column];
        let moved = |by: f64| {
            let mut x = x.clone();
            x[column] += by;
            cycle.map(motion.value, &at(&x)).unwrap().x
        };
        let found = (moved(step) - moved(-step)) / (2.0 * step);
        for row in 0..x.len() {
            let unit = motion.swing[column] / motion.swing[row];
            let (found, exact) = (found[row] * unit, map.derivative[(row, column)] * unit);
            assert!((found - exact).abs() < within, "({row}, {column}): {exact}, by differences {found}");
        }
    }
}

fn rattle<'c>() -> Cycle<'c, Rattle> {
    Cycle::new(|omega| Rattle::prepare(RattleParameters { omega }), |omega| TAU / omega)
        .switch("x", 1e-4)
        .switch("x", -1e-4)
        .switch("force", 0.0)
}

/// Without the jump of the derivative the difference is of the first digit.
#[test]
fn damping_in_contact_only() {
    let cycle = rattle();
    let start = Rattle::<f64>::default().start();
    let motion = cycle.settle(1.5, &start, 60).unwrap();
    assert!(motion.switchings.len() >= 4, "{:?}", motion.switchings);
    compare(&cycle, &motion, 1e-5, 1e-6);
    // The law itself does not jump in the derivative where it is not told of.
    let blind = Cycle::new(|omega| Rattle::prepare(RattleParameters { omega }), |omega| TAU / omega);
    let without = blind.map(1.5, &motion.state).unwrap().derivative;
    assert!((without - &motion.monodromy).amax() > 1e-2 * motion.monodromy.amax());
}

/// A closed loop with an internal state, pushed by an input.
#[test]
fn loop_with_a_state_and_an_input() {
    let cycle = Cycle::new(|_| Swing::prepare(SwingParameters { voltage: 2.0 }), |omega| TAU / omega)
        .inputs(|omega, time| SwingInputs { push: 8.0 * (omega * time).cos() });
    let start = Swing::<f64>::default().start();
    let motion = cycle.settle(3.0, &start, 10).unwrap();
    assert_eq!(motion.start.len(), 3);
    assert!(motion.is_stable() && motion.swing[0] > 0.05, "{:?}", motion.swing);
    compare(&cycle, &motion, 1e-4, 1e-6);
    // It is the motion that is left when all else has died out.
    let later = cycle.numbers(3.0, &cycle.after(3.0, &start, 60).unwrap()).unwrap();
    assert!((later - &motion.start).amax() < 1e-8);
    let branch = cycle.branch(&motion, &Along::new(2.9..=3.3)).unwrap();
    let last = branch.motions.last().unwrap();
    let direct = cycle.settle(last.value, &last.state, 0).unwrap();
    assert!(last.value > 3.3 && (direct.start - &last.start).amax() < 1e-9);
}
