//! Control work, by identities, against differences of the stepper, and in both precisions: a file for each subject.

mod actuators;
mod encoders;
mod held;
mod reduced;
mod steps;
#[path = "../checks/walking.rs"]
mod walking;

use mechanisms::registry::{self, At, Model};

/// States of each mechanism.
pub const STATES: usize = 3;

pub fn assert_close(name: &str, found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len(), "{name}");
    let largest = expected.iter().fold(1e-3, |largest, entry| f64::max(largest, entry.abs()));
    assert_close_by(name, found, expected, tolerance * largest);
}

pub fn assert_close_by(name: &str, found: &[f64], expected: &[f64], bound: f64) {
    for (index, (found, expected)) in found.iter().zip(expected).enumerate() {
        let off = (found - expected).abs();
        assert!(off <= bound, "{name}[{index}]: {found} {expected}, off by {off:e}, bound {bound:e}");
    }
}

pub fn solved<M: Model>(model: &M, at: &At<M>) -> M::V {
    let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
    model.acceleration(at.time, &at.state(), &at.u, &mut a, &mut lambda);
    a
}
