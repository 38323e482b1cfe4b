//! States of emitted models as the generic solver has them: body by body.

use linkwright::{Fields, Report, StateOf, Vector};
use linkwright_generic::{BodyMotion, Mechanism, State};

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

/// The modes of beams by name, with coordinate, rate and acceleration, as `COORDINATES` says where they stand.
pub fn modes(coordinates: &str, q: &[f64], v: &[f64], a: &[f64]) -> Vec<(String, [f64; 3])> {
    let tree: serde_json::Value = serde_json::from_str(coordinates).expect("JSON");
    let linear = tree["linear"].as_array().expect("a list").iter().enumerate();
    let names = linear.filter_map(|(index, entry)| {
        let kind = entry["kind"].as_str()?;
        kind.ends_with(']').then(|| (index, format!("{}.{kind}", entry["of"].as_str().unwrap_or_default())))
    });
    names.map(|(index, name)| (name, [q[index], v[index], a[index]])).collect()
}

/// Gives the modes of beams to a state.
pub fn set_modes(mechanism: &Mechanism, state: &mut State, modes: &[(String, [f64; 3])]) {
    for (name, [value, rate, _]) in modes {
        mechanism.set_mode(state, name, *value, *rate).expect("a mode");
    }
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
