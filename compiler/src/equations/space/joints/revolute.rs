//! Revolute: p₁ = p₂ and z₂ along z₁.

use super::{Elementary, Ends};
use crate::equations::JointRow;

pub fn motions() -> Vec<Elementary> {
    vec![Elementary::Turn { frame: 0, which: 0 }]
}

pub fn rows(ends: &Ends) -> Vec<JointRow> {
    let mut rows = ends.together();
    rows.extend(ends.parallel());
    rows
}
