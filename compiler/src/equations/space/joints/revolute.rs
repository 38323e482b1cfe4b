//! Revolute: p₁ = p₂ and z₂ along z₁.

use super::{Elementary, Ends};
use crate::equations::JointRow;
use crate::symbolic::Graph;

pub fn motions() -> Vec<Elementary> {
    vec![Elementary::Turn { frame: 0, which: 0 }]
}

pub fn rows(g: &mut Graph, ends: &Ends) -> Vec<JointRow> {
    let mut rows = ends.together(g);
    rows.extend(ends.parallel(g));
    rows
}
