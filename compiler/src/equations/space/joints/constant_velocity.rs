//! Constant velocity (homokinetic): p₁ = p₂, and E₂ against E₁ only swung, not turned about the shafts:
//! x₁·y₂ = y₁·x₂, with x₁·x₂ + y₁·y₂ positive.

use super::{Elementary, Ends};
use crate::equations::JointRow;
use crate::equations::space::vector;
use crate::symbolic::Graph;

/// Never carries a body: its two swings have no coordinates that stay regular.
pub fn motions() -> Vec<Elementary> {
    Vec::new()
}

pub fn rows(g: &mut Graph, ends: &Ends) -> Vec<JointRow> {
    let mut rows = ends.together(g);
    let (x1, y1) = (vector::column(&ends.e1, 0), vector::column(&ends.e1, 1));
    let (x2, y2) = (ends.second_axis(g, 0), ends.second_axis(g, 1));
    let (left, right) = (y2.project(g, x1), x2.project(g, y1));
    let (a, b) = (vector::dot(g, x1, x2.value), vector::dot(g, y1, y2.value));
    let upright = Some(g.add(a, b));
    rows.push(JointRow { upright, ..JointRow::new("twist", left.sub(g, &right)) });
    rows
}
