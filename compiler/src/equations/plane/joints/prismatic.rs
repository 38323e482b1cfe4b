//! Prismatic along â of the first body, n̂ = â turned by a right angle: n̂·Δ = 0 and sin(θ₂ − θ₁ − angle) = 0.

use super::fixed::{direction_row, direction_torque};
use super::{Carried, Ends, JointRow, Wrench, normalized, point_on_line};
use crate::equations::laws::Laws;
use crate::equations::plane::kinematics::{Placement, rotate};
use crate::model::{Expr, Vector};
use crate::symbolic::{Graph, Node};

pub fn rows(g: &mut Graph, laws: &Laws, ends: &Ends, axis: &Vector, angle: &Expr) -> Vec<JointRow> {
    let mut rows = point_on_line::rows(g, laws, ends, axis);
    rows.push(direction_row(g, laws, ends, angle));
    rows
}

pub fn attach(g: &mut Graph, laws: &Laws, carried: Carried, axis: &Vector, angle: &Expr) -> Placement {
    let pair = laws.pair(g, angle);
    let offset = carried.kept(g, pair);
    // The axis is given in the first body's axes; parent and child share one frame.
    let first = if carried.child_is_second { carried.parent.offset } else { offset };
    let along = laws.pair_of(g, axis);
    let along = normalized(g, along);
    let along = rotate(g, first, along);
    let slide = carried.slide(g, carried.parent.frame, along);
    let far = carried.pivot.add(g, &slide);
    carried.at(g, &far, offset)
}

/// −Dᵀλ: force −λₙ n̂ at the second place, torque −cos(Δθ) λ_angle.
pub fn reaction(
    g: &mut Graph,
    laws: &Laws,
    ends: &Ends,
    axis: &Vector,
    angle: &Expr,
    lambda: &[Node],
) -> Wrench {
    let [x, y, _] = point_on_line::reaction(g, laws, ends, axis, lambda);
    [x, y, direction_torque(g, laws, ends, angle, lambda[1])]
}
