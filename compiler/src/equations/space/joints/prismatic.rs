//! Prismatic: Δ along z₁ and E₁ parallel to E₂.

use super::{Elementary, Ends};
use crate::equations::JointRow;
use crate::symbolic::Graph;

pub fn motions() -> Vec<Elementary> {
    vec![Elementary::Slide { axis: 2, which: 0 }]
}

pub fn rows(g: &mut Graph, ends: &Ends) -> Vec<JointRow> {
    let mut rows = ends.on_axis(g);
    rows.extend(ends.parallel(g));
    rows.push(ends.unturned(g));
    rows
}
