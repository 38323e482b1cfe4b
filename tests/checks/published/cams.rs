//! A cam by a table, against SciPy's periodic spline and the equations of its follower.

use super::Worst;
use linkwright::{AssembleExt, Mechanism, State};
use linkwright_models::cam_follower::{CamFollower, CamFollowerOutputs, CamFollowerParameters};

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
