//! Cylindrical: Δ along z₁ and z₂ along z₁.

use super::{Elementary, Ends};
use crate::equations::JointRow;

pub fn motions() -> Vec<Elementary> {
    vec![Elementary::Slide { axis: 2, which: 0 }, Elementary::Turn { frame: 0, which: 0 }]
}

pub fn rows(ends: &Ends) -> Vec<JointRow> {
    let mut rows = ends.on_axis();
    rows.extend(ends.parallel());
    rows
}
