//! Distance (massless rod with two balls): (Δ·Δ − L²)/2 = 0, polynomial, with multiplier force/length.

use super::{Elementary, Ends};
use crate::equations::{JointRow, Laws};
use crate::model::Expr;
use crate::symbolic::Graph;

/// Never carries a body: it leaves no frame to measure from.
pub fn motions() -> Vec<Elementary> {
    Vec::new()
}

pub fn rows(g: &mut Graph, laws: &Laws, ends: &Ends, length: &Expr) -> Vec<JointRow> {
    let gap = ends.gap(g);
    let length = laws.jet(g, length);
    let half = g.constant(0.5);
    let mut sum = length.mul(g, &length, ends.velocities).scale(g, half).neg(g);
    for component in &gap {
        let square = component.mul(g, component, ends.velocities).scale(g, half);
        sum = sum.add(g, &square);
    }
    vec![JointRow::new("distance", sum)]
}
