//! Fixed (bracket): p₁ − p₂ = 0 and sin(θ₂ − θ₁ − angle) = 0 on its upright root.

use super::{Carried, Ends, JointRow, Wrench, revolute};
use crate::equations::laws::Laws;
use crate::equations::plane::kinematics::Placement;
use crate::model::Expr;
use crate::symbolic::{Graph, Node};

pub fn rows(g: &mut Graph, laws: &Laws, ends: &Ends, angle: &Expr) -> Vec<JointRow> {
    let mut rows = revolute::rows(g, laws, ends);
    rows.push(direction_row(g, laws, ends, angle));
    rows
}

pub fn attach(g: &mut Graph, laws: &Laws, carried: Carried, angle: &Expr) -> Placement {
    let pair = laws.pair(g, angle);
    let offset = carried.kept(g, pair);
    let pivot = carried.pivot.clone();
    carried.at(g, &pivot, offset)
}

pub fn reaction(g: &mut Graph, laws: &Laws, ends: &Ends, angle: &Expr, lambda: &[Node]) -> Wrench {
    [lambda[0], lambda[1], direction_torque(g, laws, ends, angle, lambda[2])]
}

/// sin(θ₂ − θ₁ − angle), shared with the prismatic joint.
pub fn direction_row(g: &mut Graph, laws: &Laws, ends: &Ends, angle: &Expr) -> JointRow {
    let pair = laws.pair(g, angle);
    let (sine, cosine) = laws.plane().sine_jet(g, laws, ends.first, ends.second, pair);
    JointRow { upright: Some(cosine), ..JointRow::new("angle", sine) }
}

/// Torque on the second from the multiplier of [`direction_row`]: −cos(Δθ) λ.
pub fn direction_torque(g: &mut Graph, laws: &Laws, ends: &Ends, angle: &Expr, lambda: Node) -> Node {
    let pair = laws.pair(g, angle);
    let (_, cosine) = laws.plane().sine_jet(g, laws, ends.first, ends.second, pair);
    let torque = g.mul(cosine, lambda);
    g.neg(torque)
}
