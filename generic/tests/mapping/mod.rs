//! States of emitted models as the generic solver has them: body by body.

#![allow(dead_code, reason = "each program takes what it needs")]

pub mod beams;
pub mod relevance;
pub mod states;
pub mod truth;

use linkwright::{Fields, Report, StateOf, Vector};
use linkwright_generic::{BodyMotion, Mechanism, State};

/// The largest input of a mechanism in a test. Teeth in error by metres would be driven through each other.
pub fn largest_input(name: &str) -> f64 {
    if name == "meshed" { 1e-5 } else { 1.0 }
}

/// The motions of all bodies of a model; `angles` are those of planar bodies just before, whose turns are continued.
pub fn bodies<M: Report<f64>>(
    model: &M,
    time: f64,
    state: &StateOf<M>,
    a: &M::V,
    angles: &mut Vec<f64>,
) -> Vec<BodyMotion> {
    let motions = model.motions(time, &state.q, &state.v, a);
    angles.resize(motions.as_ref().len(), 0.0);
    let motions = motions.as_ref().iter().zip(angles);
    motions
        .map(|(motion, angle)| {
            let motion = read(motion.to_array().as_slice(), *angle);
            *angle = motion.angle;
            motion
        })
        .collect()
}

/// The same state of the mechanism that was rebuilt; bodies and internal states are in the same order.
pub fn state(mechanism: &Mechanism, motions: &[BodyMotion], internal: &[f64]) -> State {
    let mut state = mechanism.origin();
    let first = state.q.len() - internal.len();
    state.q[first..].copy_from_slice(internal);
    for (body, motion) in mechanism.bodies().zip(motions) {
        mechanism.set_body(&mut state, body, motion).expect("a body");
    }
    state
}

/// Of a body in the plane (10 numbers) or in space (24), as `motions` gives it.
fn read(numbers: &[f64], previous: f64) -> BodyMotion {
    let mut motion = BodyMotion::default();
    match numbers {
        [x, y, c, s, vx, vy, rate, ax, ay, alpha] => {
            motion.position = [*x, *y, 0.0];
            let turns = (previous - s.atan2(*c)) / std::f64::consts::TAU;
            motion.angle = s.atan2(*c) + turns.round() * std::f64::consts::TAU;
            motion.velocity = [*vx, *vy, 0.0];
            motion.rate[2] = *rate;
            motion.acceleration = [*ax, *ay, 0.0];
            motion.angular_acceleration[2] = *alpha;
        }
        _ => {
            let at = |k: usize| [numbers[k], numbers[k + 1], numbers[k + 2]];
            motion.position = at(0);
            motion.orientation = [at(3), at(6), at(9)];
            motion.velocity = at(12);
            motion.rate = at(15);
            motion.acceleration = at(18);
            motion.angular_acceleration = at(21);
        }
    }
    motion
}
