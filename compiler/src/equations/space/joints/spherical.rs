//! Spherical: p₁ = p₂.

use super::{Elementary, Ends};
use crate::equations::JointRow;
use crate::symbolic::Graph;

pub fn motions() -> Vec<Elementary> {
    vec![Elementary::Ball]
}

pub fn rows(g: &mut Graph, ends: &Ends) -> Vec<JointRow> {
    ends.together(g)
}
