//! Prismatic along â of the first body, n̂ = â turned by a right angle: n̂·Δ = 0 and sin(θ₂ − θ₁ − angle) = 0.

use super::fixed::{direction_row, direction_torque};
use super::{Carried, Ends, JointRow, Wrench, point_on_line};
use crate::equations::laws::Laws;
use crate::equations::plane::kinematics::Placement;
use crate::model::{Expr, Vector};
use crate::symbolic::Scalar;

pub fn rows(laws: &Laws, ends: &Ends, axis: &Vector, angle: &Expr) -> Vec<JointRow> {
    let mut rows = point_on_line::rows(laws, ends, axis);
    rows.push(direction_row(laws, ends, angle));
    rows
}

pub fn attach<'g>(laws: &Laws<'g>, carried: Carried<'g>, axis: &Vector, angle: &Expr) -> Placement {
    let offset = carried.kept(laws.pair(angle));
    // The axis is given in the first body's axes; parent and child share one frame.
    let first = if carried.child_is_second { carried.parent.offset } else { offset.bare };
    let along = laws.pair_of(axis).normalized().turned(first);
    let far = carried.pivot.clone() + carried.slide(carried.parent.frame, along);
    carried.at(far, offset)
}

/// −Dᵀλ: force −λₙ n̂ at the second place, torque −cos(Δθ) λ_angle.
pub fn reaction<'g>(
    laws: &Laws<'g>,
    ends: &Ends<'g>,
    axis: &Vector,
    angle: &Expr,
    lambda: &[Scalar<'g>],
) -> Wrench<'g> {
    let [x, y, _] = point_on_line::reaction(laws, ends, axis, lambda);
    [x, y, direction_torque(laws, ends, angle, lambda[1])]
}
