//! Constant velocity (homokinetic): p₁ = p₂, and E₂ against E₁ only swung, not turned about the shafts:
//! x₁·y₂ = y₁·x₂, with x₁·x₂ + y₁·y₂ positive.

use super::{Elementary, Ends};
use crate::equations::JointRow;

/// Never carries a body: its two swings have no coordinates that stay regular.
pub fn motions() -> Vec<Elementary> {
    Vec::new()
}

pub fn rows(ends: &Ends) -> Vec<JointRow> {
    let mut rows = ends.together();
    let (x1, y1) = (ends.e1.column(0), ends.e1.column(1));
    let (x2, y2) = (ends.second_axis(0), ends.second_axis(1));
    let (left, right) = (y2.project(x1), x2.project(y1));
    let upright = x1.dot(x2.value()) + y1.dot(y2.value());
    rows.push(JointRow::upright("twist", left - right, upright));
    rows
}
