//! A cam by a table, against SciPy's periodic spline and the equations of its follower.

use super::Worst;
use linkwright::{AssembleExt, Mechanism, Rk4, Simulation, State};
use linkwright_models::cam_follower::{CamFollower, CamFollowerOutputs, CamFollowerParameters};
use linkwright_models::cam_lift_off::{CamLiftOff, CamLiftOffParameters};
use std::f64::consts::TAU;

fn turning(speed: f64) -> CamFollower {
    CamFollower::prepare(CamFollowerParameters { speed, ..Default::default() }).expect("within its bounds")
}

/// Outputs and the follower's acceleration with the cam at an angle, in degrees.
fn at(model: &CamFollower, speed: f64, degrees: f64) -> (CamFollowerOutputs<f64>, f64) {
    let time = degrees.to_radians() / speed;
    let found = model.kinematics(time, &CamFollower::START.q, &[]).expect("the cam is driven");
    let state = State { q: found.q, v: found.v, ..CamFollower::START };
    let follower = CamFollower::BODIES.iter().position(|body| *body == "follower").expect("there is one");
    let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
    model.acceleration(time, &state, &(), &mut a, &mut lambda);
    let acceleration = model.motions(time, &state.q, &state.v, &a)[follower].acceleration[1];
    (model.outputs(time, &state, &()), acceleration)
}

#[test]
fn cam_follower() {
    let model = turning(100.0);
    let mut worst = Worst::default();
    for (degrees, lift, slope, curvature) in [
        (25.0, 5.163_118_787_913e-4, 3.116_271_481_205e-3, 1.042_307_330_591e-2),
        (200.0, 7.716e-3, -2.208_543_517_3e-3, -1.038_051_920_52e-2),
    ] {
        let (found, acceleration) = at(&model, 100.0, degrees);
        worst.see(found.travel, lift);
        worst.see(found.steep, slope);
        worst.see(acceleration / 1e4, curvature);
    }
    worst.below(1e-13, "cam, lift and its derivatives");
    let mut worst = Worst::default();
    for (degrees, force) in [
        (0.0, 63.566_939_825_19),
        (25.0, 96.277_467_432_89),
        (95.0, 61.608_532_567_11),
        (200.0, 62.665_442_384_41),
    ] {
        worst.see(at(&model, 100.0, degrees).0.contact, force);
    }
    worst.see(at(&model, 100.0, 45.0).0.torque, 0.571_793_472_471);
    worst.below(1e-10, "cam, contact force and torque");
}

/// The least contact force of a revolution, at half degrees, and where it is: s″ is straight between the knots, so that the least of
/// a fast cam is at a knot.
fn least(speed: f64) -> (f64, f64) {
    let model = turning(speed);
    let forces =
        (0..720).map(|half| (at(&model, speed, 0.5 * f64::from(half)).0.contact, 0.5 * f64::from(half)));
    forces.fold((f64::INFINITY, 0.0), |least, here| if here.0 < least.0 { here } else { least })
}

#[test]
fn the_follower_leaves_a_fast_cam() {
    let (force, degrees) = least(100.0);
    assert!((force - 60.234_117_780_1).abs() < 1e-9 && degrees == 210.0, "{force} N at {degrees}°");
    let (mut held, mut lost) = (100.0, 300.0);
    while lost - held > 1e-9 {
        let speed = 0.5 * (held + lost);
        if least(speed).0 > 0.0 { held = speed } else { lost = speed }
    }
    assert!((held - 170.835_432_38).abs() < 1e-8, "{held} rad/s");
    assert_eq!(least(lost).1, 210.0);
}

/// A loose follower at angles of the cam beyond the first revolution, in degrees: (how far it is from the cam, its travel, what the cam pushes
/// it up with).
fn loose(speed: f64, degrees: &[f64]) -> Vec<(f64, f64, f64)> {
    let model =
        CamLiftOff::prepare(CamLiftOffParameters { speed, ..Default::default() }).expect("within its bounds");
    let tied = turning(speed);
    let start = model.assemble(&CamLiftOff::START).expect("it turns at any speed");
    let mut simulation = Simulation::new(&model, start).integrator(Rk4).step(1e-5);
    let look = |degrees: &f64| {
        simulation.advance_until((TAU + degrees.to_radians()) / speed).expect("it moves");
        let found = simulation.sample().outputs;
        let steep = at(&tied, speed, *degrees).0.steep / (0.04 + found.travel);
        (found.gap, found.travel, found.contact / (1.0 + steep * steep).sqrt())
    };
    degrees.iter().map(look).collect()
}

#[test]
fn a_loose_follower_stays_on_a_slow_cam_with_the_force_of_a_tied_one() {
    let degrees: Vec<f64> = (1..36).map(|k| 10.0 * f64::from(k) + 3.0).collect();
    let mut worst = Worst::default();
    for (degrees, (gap, travel, force)) in degrees.iter().zip(loose(160.0, &degrees)) {
        let tied = at(&turning(160.0), 160.0, *degrees).0;
        assert!(gap < 1e-12, "{gap} above the cam at {degrees} deg");
        worst.see(1e3 * travel, 1e3 * tied.travel);
        worst.see(force, tied.contact);
    }
    worst.below(1e-9, "loose cam, travel in mm and force");
}

#[test]
fn a_loose_follower_is_lost_at_the_speed_of_the_source() {
    let most = |speed: f64| {
        let fall: Vec<f64> = (0..80).map(|k| 205.0 + 0.25 * f64::from(k)).collect();
        loose(speed, &fall).into_iter().map(|(gap, ..)| gap).fold(0.0, f64::max)
    };
    assert!(most(170.83) < 1e-13, "on the cam");
    // s″ is straight between knots, so that little above this speed the follower is off for a part of a degree.
    assert!(most(173.0) > 1e-10, "above it");
}

/// Of the oscillation on the spring between where the tied follower would be pulled and where the cam meets it again.
#[test]
fn a_lost_follower_flies_and_is_caught() {
    const SPEED: f64 = 190.0;
    let tied = turning(SPEED);
    let pull = |degrees: f64| at(&tied, SPEED, degrees).0.contact;
    // The fall of the lift begins at 180°.
    let root = |of: &dyn Fn(f64) -> f64, mut low: f64, mut high: f64| {
        assert!(of(low) > 0.0 && of(high) < 0.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if of(middle) > 0.0 { low = middle } else { high = middle }
        }
        low
    };
    let leaves = root(&pull, 182.0, 200.0);
    let (lift, rate) = (at(&tied, SPEED, leaves).0.travel, at(&tied, SPEED, leaves).0.steep * SPEED);
    let (rest, frequency) = (-(60.0 + 0.3 * 9.81) / 4000.0, (4000.0_f64 / 0.3).sqrt());
    let flight = |degrees: f64| {
        let phase = frequency * (degrees - leaves).to_radians() / SPEED;
        rest + (lift - rest) * phase.cos() + rate / frequency * phase.sin()
    };
    let above = |degrees: f64| flight(degrees) - at(&tied, SPEED, degrees).0.travel;
    let caught = root(&above, leaves + 10.0, 285.0);
    println!("leaves the cam at {leaves:.6} deg, is caught at {caught:.6} deg");
    let span = caught - leaves;
    let shares = [0.05, 0.25, 0.5, 0.75, 0.95];
    let degrees: Vec<f64> = shares.iter().map(|share| leaves + share * span).collect();
    let mut worst = Worst::default();
    for (degrees, (gap, travel, force)) in degrees.iter().zip(loose(SPEED, &degrees)) {
        assert!(gap > 0.0 && force == 0.0, "{gap} m, {force} N at {degrees} deg");
        worst.see(1e3 * travel, 1e3 * flight(*degrees));
    }
    worst.below(1e-9, "flight, mm");
    let beside = loose(SPEED, &[leaves - 0.02, leaves + 0.02, caught - 0.02, caught + 0.02]);
    assert!(beside[0].0 < 1e-12 && beside[1].0 > 0.0 && beside[2].0 > 0.0, "{beside:?}");
    assert!(beside[3].0 < 1e-12 && beside[3].2 > 0.0, "{beside:?}");
}
