//! Distance (massless rod with two balls): (Δ·Δ − L²)/2 = 0, polynomial, with multiplier force/length.

use super::{Elementary, Ends};
use crate::equations::{JointRow, Laws};
use crate::model::Expr;

/// Never carries a body: it leaves no frame to measure from.
pub fn motions() -> Vec<Elementary> {
    Vec::new()
}

pub fn rows(laws: &Laws, ends: &Ends, length: &Expr) -> Vec<JointRow> {
    let gap = ends.gap();
    let length = laws.jet(length);
    let sum =
        gap.iter().fold(-(0.5 * (&length * &length)), |sum, component| sum + 0.5 * (component * component));
    vec![JointRow::new("distance", sum)]
}
