//! Fixed (bracket): p₁ − p₂ = 0 and sin(θ₂ − θ₁ − angle) = 0 on its upright root.

use super::{Carried, Ends, JointRow, Wrench, revolute};
use crate::equations::laws::Laws;
use crate::equations::plane::kinematics::Placement;
use crate::model::Expr;
use crate::symbolic::Scalar;

pub fn rows(laws: &Laws, ends: &Ends, angle: &Expr) -> Vec<JointRow> {
    let mut rows = revolute::rows(laws, ends);
    rows.push(direction_row(laws, ends, angle));
    rows
}

pub fn attach<'g>(laws: &Laws<'g>, carried: Carried<'g>, angle: &Expr) -> Placement {
    let offset = carried.kept(laws.pair(angle));
    let pivot = carried.pivot.clone();
    carried.at(pivot, offset)
}

pub fn reaction<'g>(laws: &Laws<'g>, ends: &Ends<'g>, angle: &Expr, lambda: &[Scalar<'g>]) -> Wrench<'g> {
    [lambda[0], lambda[1], direction_torque(laws, ends, angle, lambda[2])]
}

/// sin(θ₂ − θ₁ − angle), shared with the prismatic joint.
pub fn direction_row(laws: &Laws, ends: &Ends, angle: &Expr) -> JointRow {
    let (sine, cosine) = laws.plane().sine_jet(laws, ends.first, ends.second, laws.pair(angle));
    JointRow::upright("angle", sine, cosine)
}

/// Torque on the second from the multiplier of [`direction_row`]: −cos(Δθ) λ.
pub fn direction_torque<'g>(
    laws: &Laws<'g>,
    ends: &Ends<'g>,
    angle: &Expr,
    lambda: Scalar<'g>,
) -> Scalar<'g> {
    let (_, cosine) = laws.plane().sine_jet(laws, ends.first, ends.second, laws.pair(angle));
    -(cosine * lambda)
}
