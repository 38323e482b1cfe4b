//! Prismatic: Δ along z₁ and E₁ parallel to E₂.

use super::{Elementary, Ends};
use crate::equations::JointRow;

pub fn motions() -> Vec<Elementary> {
    vec![Elementary::Slide { axis: 2, which: 0 }]
}

pub fn rows(ends: &Ends) -> Vec<JointRow> {
    let mut rows = ends.on_axis();
    rows.extend(ends.parallel());
    rows.push(ends.unturned());
    rows
}
