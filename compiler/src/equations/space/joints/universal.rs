//! Universal: p₁ = p₂ and the first's axis across the second's.

use super::{Elementary, Ends};
use crate::equations::{JointRow, Laws};
use crate::model::Vector;

pub fn motions() -> Vec<Elementary> {
    vec![Elementary::Turn { frame: 0, which: 0 }, Elementary::Turn { frame: 1, which: 1 }]
}

pub fn rows(laws: &Laws, ends: &Ends, axis: &Vector, second_axis: &Vector) -> Vec<JointRow> {
    let mut rows = ends.together();
    let [a, b] = [axis, second_axis].map(|axis| laws.vector(axis).normalized());
    let (a, b) = (ends.first.axes * a, ends.second.axes * b);
    rows.push(JointRow::new("cross", ends.direction(b).project(a)));
    rows
}
