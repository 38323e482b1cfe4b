//! Spherical: p₁ = p₂.

use super::{Elementary, Ends};
use crate::equations::JointRow;

pub fn motions() -> Vec<Elementary> {
    vec![Elementary::Ball]
}

pub fn rows(ends: &Ends) -> Vec<JointRow> {
    ends.together()
}
