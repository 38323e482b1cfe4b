//! Independent velocities give way to multipliers at their dead centres, and nothing is seen of it.

use linkwright::{
    AssembleExt, Baumgarte, LagrangeIndex1, Mechanism, Rk4, Simulation, Vector, WithMultipliers,
};

linkwright::mechanism! {
    /// A crank and rocker, led by the rocker, which turns back twice a turn.
    planar LedByTheRocker {
        options { independent = rocker_pin.angle; solution = independent; }
        gravity [m/s^2] = (0, -9.81);
        rod crank { mass [kg] = 0.5; length [m] = 0.2; }
        rod coupler { mass [kg] = 1; length [m] = 0.6; }
        body rocker { mass [kg] = 2; inertia [kg*m^2] = 0.05; center [m] = (0.3, 0); point tip [m] = (0.4, 0); }
        joint crank_pin: revolute(ground(0, 0) [m], crank.start);
        joint knee: revolute(crank.end, coupler.start);
        joint wrist: revolute(coupler.end, rocker.tip);
        joint rocker_pin: revolute(ground(0.5, 0) [m], rocker.origin);
        start { rocker_pin.angle [deg] ~ 70; crank_pin.angle [deg] = 90; crank_pin.rate [rad/s] = 20; }
    }
}

/// Where the mechanism is asked one way, the other, and how often the first does not serve.
fn pivots(model: &LedByTheRocker, h: f64, steps: usize) -> Vec<f64> {
    let terms = WithMultipliers(Baumgarte { alpha: 20.0, beta: 20.0 });
    let mut plant = model.stepper(model.start(), (Rk4, terms));
    let mut pivot = || {
        plant.step(&(), h).expect("a regular position");
        let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
        let pivot = model.null_space(plant.time(), plant.state(), &(), &mut a, &mut lambda);
        if pivot >= 1e-4 {
            let (mut b, mut mu) = (model.zero_v(), model.zero_lambda());
            model.acceleration(plant.time(), plant.state(), &(), &mut b, &mut mu);
            let size = b.max_abs();
            let apart = a.plus(-1.0, &b).max_abs() / size;
            assert!(apart < 1e-14 / pivot.sqrt(), "{apart:e} apart at a pivot of {pivot:e}");
        }
        pivot
    };
    (0..steps).map(|_| pivot()).collect()
}

#[test]
fn nothing_is_seen_of_dead_centres() {
    let model = LedByTheRocker::default();
    assert!(model.null_space_first());
    let (h, steps) = (1e-4, 4000);
    let pivots = pivots(&model, h, steps);
    let bad = pivots.iter().filter(|pivot| **pivot < 1e-4).count();
    let passages = pivots.windows(2).filter(|pair| pair[0] >= 1e-4 && pair[1] < 1e-4).count();
    assert!(passages >= 2 && bad < steps / 10, "multipliers were asked {bad} times, in {passages} passages");

    let terms = Baumgarte { alpha: 20.0, beta: 20.0 };
    let mut switching = model.stepper(model.start(), (Rk4, terms));
    let mut steady = model.stepper(model.start(), (Rk4, WithMultipliers(terms)));
    for step in 0..steps {
        switching.step(&(), h).expect("a regular position");
        steady.step(&(), h).expect("a regular position");
        let (a, b) = (switching.state(), steady.state());
        let apart = a.v.plus(-1.0, &b.v).max_abs();
        assert!(apart < 1e-10, "step {step}: {apart:e} rad/s apart");
    }
}

/// A simulation tells of no singular position at dead centres of the independent velocity, and of none that is not there.
#[test]
fn dead_centres_are_not_singular() {
    let model = LedByTheRocker::default();
    let mut simulation = Simulation::new(&model, model.start()).formulation(LagrangeIndex1).step(1e-3);
    for _ in 0..400 {
        let step = simulation.advance().expect("a regular position");
        assert!(step.near_singular.is_none(), "{step:?}");
    }
}
