//! Point on line: Δ along z₁, the line's direction.

use super::{Elementary, Ends};
use crate::equations::JointRow;
use crate::symbolic::Graph;

pub fn motions() -> Vec<Elementary> {
    vec![Elementary::Slide { axis: 2, which: 0 }, Elementary::Ball]
}

pub fn rows(g: &mut Graph, ends: &Ends) -> Vec<JointRow> {
    ends.on_axis(g)
}
