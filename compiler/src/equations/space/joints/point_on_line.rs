//! Point on line: Δ along z₁, the line's direction.

use super::{Elementary, Ends};
use crate::equations::JointRow;

pub fn motions() -> Vec<Elementary> {
    vec![Elementary::Slide { axis: 2, which: 0 }, Elementary::Ball]
}

pub fn rows(ends: &Ends) -> Vec<JointRow> {
    ends.on_axis()
}
