//! Shipped mechanisms under diffsol's solvers against Linkwright's own RK4 and a published run.

use core::f64::consts::{PI, TAU};
use linkwright::{Assemble, Baumgarte, Mechanism, Residual, Simulation, State, Variables, Vector};
use linkwright_diffsol::{Method, Settings, StateOf, problem, solve};
use linkwright_models::andrews::Andrews;
use linkwright_models::double_pendulum::DoublePendulum;
use linkwright_models::four_bar::FourBar;
use linkwright_models::heavy_top::HeavyTop;
use linkwright_models::planetary_gear_train::{PlanetaryGearTrain, PlanetaryGearTrainInputs};
use linkwright_models::quick_return::{QuickReturn, QuickReturnInputs};
use linkwright_models::spatial_pendulums::SphericalPendulum;

const METHODS: [Method; 4] = [Method::Bdf, Method::TrBdf2, Method::Esdirk34, Method::Tsit45];

/// Errors per step that are as large as the tolerance add up; none of these motions makes more of them than this.
const STEPS: f64 = 1000.0;

/// max |q − q'|, counted angles relative to their size, and max |v − v'| relative to the largest velocity.
fn apart<M: Mechanism<f64>>(model: &M, found: &StateOf<M>, expected: &StateOf<M>) -> (f64, f64) {
    let layout = model.layout();
    let plain = layout.positions() - 2 * layout.angles.len();
    let (q, p) = (found.q.as_slice(), expected.q.as_slice());
    let mut position = (0..plain).fold(0.0_f64, |worst, i| worst.max((q[i] - p[i]).abs()));
    for k in (plain..q.len()).step_by(2) {
        let turned = TAU * (q[k] - p[k]) + q[k + 1] - p[k + 1];
        position = position.max(turned.abs() / (1.0 + TAU * p[k].abs()));
    }
    let velocity = found.v.plus(-1.0, &expected.v).max_abs() / (1.0 + expected.v.max_abs());
    (position, velocity)
}

/// Every method at its own tolerance against RK4 with Baumgarte's terms.
fn agrees<M: Assemble<f64>>(
    model: &M,
    start: StateOf<M>,
    inputs: impl Fn(f64, &StateOf<M>) -> M::Inputs,
    (end, step): (f64, f64),
) {
    let times: Vec<f64> = (0..=4).map(|k| 0.25 * end * f64::from(k)).collect();
    let baumgarte = Baumgarte { alpha: 10.0, beta: 10.0 };
    let mut simulation =
        Simulation::new(model, start.clone()).formulation(baumgarte).sampled(&inputs).step(step);
    let expected: Vec<_> =
        times.iter().map(|&time| simulation.advance_until(time).expect("RK4 gets there")).collect();
    for method in METHODS {
        // The methods of low order would take a million steps for the tolerances of the others.
        let relative = if matches!(method, Method::Tsit45 | Method::Bdf) { 1e-9 } else { 1e-7 };
        let settings = Settings { relative, absolute: relative, ..Settings::default() };
        let problem = problem(model, 0.0, &start, &inputs, &settings).expect("a problem");
        let states = solve(&problem, method, &times).expect("it gets there");
        assert_eq!(states.len(), times.len());
        assert_eq!(states[0], start);
        for ((state, expected), time) in states.iter().zip(&expected).zip(&times) {
            let (position, velocity) = apart(model, state, expected);
            let residual = Residual::of(model, *time, state);
            println!(
                "{} {method:?} at {time}: {position:.1e} {velocity:.1e}, constraints {:.1e} {:.1e}",
                model.name(),
                residual.position,
                residual.velocity
            );
            let bound = STEPS * relative;
            assert!(position < bound && velocity < bound, "{position:.1e} {velocity:.1e} > {bound:.1e}");
            assert!(residual.position < bound && residual.velocity < bound * (1.0 + state.v.max_abs()));
        }
    }
}

#[test]
fn double_pendulum() {
    agrees(&DoublePendulum::default(), DoublePendulum::START, |_, _| (), (1.0, 1e-3));
}

/// Until shortly before the crank lies on the ground, where another branch of the motion begins.
#[test]
fn four_bar() {
    agrees(&FourBar::default(), FourBar::START, |_, _| (), (0.6, 1e-3));
}

#[test]
fn spherical_pendulum() {
    let start = State { v: [0.3, 1.1, -0.7], ..SphericalPendulum::START };
    agrees(&SphericalPendulum::default(), start, |_, _| (), (1.0, 1e-3));
}

/// It turns 150 rad/s about itself: two revolutions of the quaternion's axis.
#[test]
fn heavy_top() {
    agrees(&HeavyTop::default(), HeavyTop::START, |_, _| (), (0.1, 1e-5));
}

#[test]
fn quick_return_with_inputs_of_time_and_state() {
    // No speed of any part; what matters is that both sides see the same.
    let speed = |state: &StateOf<QuickReturn>| state.v.iter().sum::<f64>();
    let inputs = |time: f64, state: &StateOf<QuickReturn>| QuickReturnInputs {
        drive: 20.0 * (9.0 * time).sin() - 0.3 * speed(state),
        cutting: 50.0 * (7.0 * time).cos(),
    };
    agrees(&QuickReturn::default(), QuickReturn::START, inputs, (0.4, 1e-4));
}

/// Angles that gears count run through several turns and come back as turns and remainder.
#[test]
fn counted_angles_keep_their_turns() {
    let model = PlanetaryGearTrain::<f64>::default();
    let layout = model.layout();
    assert!(!layout.angles.is_empty());
    let inputs = |time: f64, _: &_| PlanetaryGearTrainInputs { arm_torque: time.sin(), sun_torque: 0.0 };
    agrees(&model, PlanetaryGearTrain::START, inputs, (0.3, 1e-3));

    let problem =
        problem(&model, 0.0, &PlanetaryGearTrain::START, inputs, &Settings::default()).expect("a problem");
    let end = solve(&problem, Method::Tsit45, &[3.0]).expect("it turns")[0];
    let counted = &end.q[end.q.len() - 2 * layout.angles.len()..];
    assert!(counted.chunks(2).any(|angle| angle[0].abs() >= 3.0), "{counted:?}");
    for angle in counted.chunks(2) {
        assert!(angle[0] == angle[0].round() && angle[1].abs() <= PI, "{angle:?}");
    }
}

/// IVP test set, reference solution at 0.03 s.
#[test]
fn andrews_squeezer() {
    let model = Andrews::<f64>::default();
    let settings = Settings {
        relative: 1e-9,
        absolute: 1e-9,
        baumgarte: Baumgarte { alpha: 100.0, beta: 100.0 },
        ..Settings::default()
    };
    let problem = problem(&model, 0.0, &Andrews::START, |_, _| (), &settings).expect("a problem");
    // Close enough together that the angles can be followed.
    let times: Vec<f64> = (0..=600).map(|k| 0.03 * f64::from(k) / 600.0).collect();
    for method in [Method::Bdf, Method::Tsit45] {
        let states = solve(&problem, method, &times).expect("the squeezer runs");
        let mut last = model.outputs(0.0, &states[0], &());
        model.unwrap_start(&mut last);
        for (state, time) in states.iter().zip(&times) {
            let mut outputs = model.outputs(*time, state, &());
            model.unwrap(&mut outputs, &last);
            last = outputs;
        }
        let mut worst = 0.0_f64;
        for (found, expected) in [
            (last.beta, 15.81077119629904),
            (last.theta, -15.75637105984298),
            (last.gamma, 0.04082224013073101),
            (last.phi, -0.5347301163226948),
            (last.delta, 0.5244099658805304),
            (last.omega, 0.5347301163226948),
            (last.epsilon, 1.048080741042263),
        ] {
            worst = worst.max((found - expected).abs());
        }
        let residual = Residual::of(&model, 0.03, &states[600]);
        println!("Andrews {method:?}: {worst:.1e}, constraints {:.1e}", residual.position);
        assert!(worst < 1e-6, "{method:?}: {worst:.1e}");
        assert!(residual.position < 1e-9);
    }
}
