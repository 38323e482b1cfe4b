//! Cylindrical: Δ along z₁ and z₂ along z₁.

use super::{Elementary, Ends};
use crate::equations::JointRow;
use crate::symbolic::Graph;

pub fn motions() -> Vec<Elementary> {
    vec![Elementary::Slide { axis: 2, which: 0 }, Elementary::Turn { frame: 0, which: 0 }]
}

pub fn rows(g: &mut Graph, ends: &Ends) -> Vec<JointRow> {
    let mut rows = ends.on_axis(g);
    rows.extend(ends.parallel(g));
    rows
}
