//! Universal: p₁ = p₂ and the first's axis across the second's.

use super::{Elementary, Ends};
use crate::equations::space::{axes, vector};
use crate::equations::{JointRow, Laws};
use crate::model::Vector;
use crate::symbolic::Graph;

pub fn motions() -> Vec<Elementary> {
    vec![Elementary::Turn { frame: 0, which: 0 }, Elementary::Turn { frame: 1, which: 1 }]
}

pub fn rows(g: &mut Graph, laws: &Laws, ends: &Ends, axis: &Vector, second_axis: &Vector) -> Vec<JointRow> {
    let mut rows = ends.together(g);
    let [a, b] = [axis, second_axis].map(|axis| {
        let axis = laws.vector(g, axis);
        axes::normalized(g, axis)
    });
    let (a, b) = (vector::apply(g, &ends.first.axes, a), vector::apply(g, &ends.second.axes, b));
    let b = ends.direction(g, b);
    rows.push(JointRow::new("cross", b.project(g, a)));
    rows
}
