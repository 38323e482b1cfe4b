//! What is refused, and what is said where the equations have no solution.

use linkwright::{Baumgarte, SimulationError, State};
use linkwright_diffsol::{Error, Method, Settings, StateOf, problem, solve};
use linkwright_models::change_point_four_bar::ChangePointFourBar;
use linkwright_models::four_bar::FourBar;
use linkwright_models::heavy_top::HeavyTop;
use linkwright_models::quick_return::{QuickReturn, QuickReturnInputs};

const METHODS: [Method; 4] = [Method::Bdf, Method::TrBdf2, Method::Esdirk34, Method::Tsit45];

/// The error of a problem of the four-bar.
fn refused(time: f64, state: &StateOf<FourBar>, settings: &Settings) -> Error {
    let model = FourBar::default();
    let refused = problem(&model, time, state, |_, _| (), settings);
    refused.err().expect("it is refused")
}

#[test]
fn settings() {
    let good = Settings::default();
    for bad in [
        Settings { relative: 0.0, ..good },
        Settings { relative: f64::NAN, ..good },
        Settings { absolute: -1.0, ..good },
        Settings { baumgarte: Baumgarte { alpha: -1.0, beta: 0.0 }, ..good },
        Settings { baumgarte: Baumgarte { alpha: 0.0, beta: f64::NAN }, ..good },
        Settings { length_rate: -1.0, ..good },
    ] {
        let error = refused(0.0, &FourBar::START, &bad);
        assert!(matches!(error, Error::Mechanism(SimulationError::Setting(_))), "{error:?}");
        assert!(error.to_string().contains("must be"), "{error}");
    }
}

#[test]
fn starts() {
    let settings = Settings::default();
    let error = refused(f64::NAN, &FourBar::START, &settings);
    assert!(matches!(error, Error::StartTime { .. }), "{error:?}");

    let mut state = FourBar::START;
    state.v[0] = f64::INFINITY;
    let error = refused(0.0, &state, &settings);
    assert!(matches!(error, Error::Mechanism(SimulationError::NonFinite { .. })), "{error:?}");

    let mut state = FourBar::START;
    state.v[0] += 0.5;
    let error = refused(0.0, &state, &settings);
    assert!(matches!(error, Error::Mechanism(SimulationError::Inconsistent { .. })), "{error:?}");
    let model = FourBar::default();
    let lenient = Settings { accept_inconsistent_start: true, ..settings };
    assert!(problem(&model, 0.0, &state, |_, _| (), &lenient).is_ok());

    let top = HeavyTop::default();
    let mut state = HeavyTop::START;
    state.q[0] = 0.9;
    for settings in [settings, lenient] {
        let error = problem(&top, 0.0, &state, |_, _| (), &settings).err().expect("it is refused");
        assert!(matches!(error, Error::Mechanism(SimulationError::NotNormalised { .. })), "{error:?}");
    }
}

#[test]
fn times() {
    let model = FourBar::default();
    let problem = problem(&model, 1.0, &FourBar::START, |_, _| (), &Settings::default()).expect("a problem");
    for (times, at) in
        [(&[0.5][..], 0), (&[1.0, 2.0, 1.5][..], 2), (&[1.5, f64::NAN][..], 1), (&[f64::INFINITY][..], 0)]
    {
        let error = solve(&problem, Method::Bdf, times).expect_err("it is refused");
        assert!(matches!(error, Error::Time { index, .. } if index == at), "{error:?}");
    }
    assert!(solve(&problem, Method::Bdf, &[]).expect("nothing is asked").is_empty());
    let same = solve(&problem, Method::Bdf, &[1.0, 1.0]).expect("the start");
    assert_eq!(same, [FourBar::START; 2]);
    let twice = solve(&problem, Method::Bdf, &[1.0, 1.1, 1.1]).expect("it moves");
    assert_eq!(twice[1], twice[2]);
    assert_ne!(twice[0], twice[1]);
}

/// A stiff problem under an explicit method does not run for ever.
#[test]
fn too_many_steps() {
    let model = FourBar::default();
    let settings =
        Settings { baumgarte: Baumgarte { alpha: 1e6, beta: 1e6 }, most_steps: 2000, ..Settings::default() };
    let problem = problem(&model, 0.0, &FourBar::START, |_, _| (), &settings).expect("a problem");
    let error = solve(&problem, Method::Tsit45, &[0.1]).expect_err("it is too stiff");
    assert!(matches!(error, Error::TooManySteps { steps: 2000, time } if time < 0.1), "{error:?}");
    assert!(solve(&problem, Method::Bdf, &[0.1]).is_ok());
}

/// Inputs that are no numbers, from the start or later on.
#[test]
fn inputs_that_are_no_numbers() {
    let model = QuickReturn::default();
    let inputs_until = |end: f64| {
        move |time: f64, _: &StateOf<QuickReturn>| {
            let drive = if time > end { f64::NAN } else { 1.0 };
            QuickReturnInputs { drive, cutting: 0.0 }
        }
    };
    let settings = Settings::default();
    let error = problem(&model, 0.0, &QuickReturn::START, inputs_until(-1.0), &settings).err();
    assert!(matches!(error, Some(Error::Mechanism(SimulationError::NonFinite { .. }))), "{error:?}");
    let problem =
        problem(&model, 0.0, &QuickReturn::START, inputs_until(0.005), &settings).expect("a problem");
    for method in METHODS {
        assert_eq!(solve(&problem, method, &[0.002]).expect("it moves").len(), 1);
        let error = solve(&problem, method, &[0.01]).expect_err("it cannot go on");
        let Error::Mechanism(SimulationError::NonFinite { time, .. }) = error else {
            panic!("{method:?}: {error:?}")
        };
        assert!((time - 0.005).abs() < 1e-3, "{method:?}: {time}");
        assert!(problem.eqn().failure().is_some());
    }
}

/// All links in one line: a start there has no accelerations.
#[test]
fn singular_starts() {
    let model = ChangePointFourBar::default();
    let start = State::new([-1.0, 0.0, -1.0, 0.0, 1.0, 0.0], [0.0; 3]);
    let error = problem(&model, 0.0, &start, |_, _| (), &Settings::default()).err();
    assert!(matches!(error, Some(Error::Mechanism(SimulationError::Breakdown { .. }))), "{error:?}");
}

linkwright::mechanism! {
    planar Bouncing {
        gravity [m/s^2] = (0, -9.81);
        particle ball { mass [kg] = 1; }
        surface below: point(ball.center);
        surface floor: half_plane(line(ground(0, 0) [m], ground(1, 0) [m]));
        contact stop: between(below, floor) = rigid(restitution = 0.8);
        start { ball.center.x [m] = 0; ball.center.y [m] = 1; }
    }
}

/// It would fall through.
#[test]
fn rigid_contacts() {
    let model = Bouncing::<f64>::default();
    let start = linkwright::AssembleExt::start(&model);
    let error = problem(&model, 0.0, &start, |_, _| (), &Settings::default()).err();
    let error = error.expect("it is refused");
    assert!(matches!(error, Error::RigidContact { contact: "stop" }), "{error:?}");
    assert!(error.to_string().contains("`stop` is a rigid contact"), "{error}");
}
