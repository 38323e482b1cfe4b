//! What is asked wrongly, and what the answer says.

use core::f64::consts::TAU;
use linkwright::{AssembleExt, mechanism};
use linkwright_models::gear_pair::{GearPairOscillator, GearPairOscillatorParameters};
use linkwright_periodic::{Along, Cycle, PeriodicError};

mechanism! {
    /// A bob on a ball joint: its orientation has no coordinates.
    pub spatial Bob {
        gravity [m/s^2] = (0, 0, -9.81);
        body bob { mass [kg] = 1; inertia [kg*m^2] = (0.01, 0.01, 0.01); point hook [m] = (0, 0, 1); }
        joint ball: spherical(ground(0, 0, 0) [m], bob.hook);
        options { emit = (tangent); }
    }
}

fn pair<'c>(period: impl Fn(f64) -> f64 + 'c) -> Cycle<'c, GearPairOscillator<f64>> {
    let parameters = |omega| GearPairOscillatorParameters { omega, shake: 0.05, swing: 0.0 };
    Cycle::new(move |omega| GearPairOscillator::prepare(parameters(omega)), period)
}

fn answer(cycle: &Cycle<'_, GearPairOscillator<f64>>, omega: f64) -> String {
    cycle
        .settle(omega, &GearPairOscillator::<f64>::default().start(), 1)
        .err()
        .expect("a mistake")
        .to_string()
}

#[test]
fn names_that_are_not_there() {
    assert_eq!(
        answer(&pair(|omega| TAU / omega).switch("gap", 0.0), 1.0),
        "there is no output \"gap\"; there are x, force"
    );
    assert_eq!(
        answer(&pair(|omega| TAU / omega).advancing("axel.angle", 0.1), 1.0),
        "\"axel.angle\" is no coordinate of the motion; these are axle.angle"
    );
}

#[test]
fn periods_and_parameters() {
    let told = answer(&pair(|_| 0.0), 1.0);
    assert_eq!(told, "at 1 the period is 0 s; it must be positive and finite");
    let told = answer(&pair(|omega| TAU / omega), -1.0);
    assert!(told.contains("omega"), "{told}");
}

/// With time back at zero after each cycle a motion closes, which is none of the mechanism.
#[test]
fn a_period_that_the_load_does_not_have() {
    let told = answer(&pair(|omega| TAU / (1.37 * omega)), 0.9);
    assert!(told.contains("then goes on in another way"), "{told}");
    assert!(told.ends_with("give the period of the laws and inputs"), "{told}");
}

#[test]
fn steps_of_a_branch() {
    let cycle = pair(|omega| TAU / omega).switch("x", 1e-6);
    let motion = cycle.settle(0.6, &GearPairOscillator::<f64>::default().start(), 40).unwrap();
    let along = Along { step: 0.0, ..Along::new(0.5..=1.0) };
    assert_eq!(cycle.branch(&motion, &along).err(), Some(PeriodicError::NoStep { step: 0.0 }));
}

#[test]
fn orientations_without_coordinates() {
    let cycle = Cycle::new(|_| Ok(Bob::default()), |_| 1.0);
    let told = cycle.settle(1.0, &Bob::<f64>::default().start(), 0).err().unwrap();
    assert!(matches!(told, PeriodicError::Orientation { .. }), "{told}");
    assert!(told.to_string().contains("`universal` or three `revolute`"), "{told}");
}
