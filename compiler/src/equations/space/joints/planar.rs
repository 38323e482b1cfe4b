//! Planar: Δ across z₁ and z₂ along z₁.

use super::{Elementary, Ends};
use crate::equations::JointRow;

pub fn motions() -> Vec<Elementary> {
    vec![
        Elementary::Slide { axis: 0, which: 0 },
        Elementary::Slide { axis: 1, which: 1 },
        Elementary::Turn { frame: 0, which: 0 },
    ]
}

pub fn rows(ends: &Ends) -> Vec<JointRow> {
    let mut rows = vec![ends.on_plane()];
    rows.extend(ends.parallel());
    rows
}
