//! Point on line: n̂·Δ = 0 with n̂ normal to the line, which the first body carries.

use super::{Carried, Ends, JointRow, Pair, Wrench, vector};
use crate::equations::laws::Laws;
use crate::equations::plane::kinematics::{FrameId, Placement};
use crate::model::Vector;
use crate::symbolic::{On, Scalar};

pub fn rows(laws: &Laws, ends: &Ends, direction: &Vector) -> Vec<JointRow> {
    let (frame, normal) = normal(laws, ends, direction);
    vec![JointRow::new("normal", laws.plane().project(frame, normal, &ends.delta.bare))]
}

pub fn attach<'g>(laws: &Laws<'g>, carried: Carried<'g>, direction: &Vector) -> Placement {
    let along = laws.pair_of(direction).normalized();
    // The line's body is the parent, or else the carried body itself.
    let (frame, along) = if carried.child_is_second {
        (carried.parent.frame, along.turned(carried.parent.offset))
    } else {
        (carried.frame, along)
    };
    let far = carried.pivot.clone() + carried.slide(frame, along);
    carried.at(far, vector::unturned(laws.g))
}

/// −Dᵀλ: force −λ n̂ at the second place.
pub fn reaction<'g>(
    laws: &Laws<'g>,
    ends: &Ends<'g>,
    direction: &Vector,
    lambda: &[Scalar<'g>],
) -> Wrench<'g> {
    let (frame, normal) = normal(laws, ends, direction);
    let [x, y] = laws.plane().to_world(frame, normal).parts().map(|part| -(part * lambda[0]));
    [x, y, laws.g.zero()]
}

/// n̂ and the frame in whose axes it is given.
fn normal<'g>(laws: &Laws<'g>, ends: &Ends<'g>, direction: &Vector) -> (FrameId, On<'g, Pair>) {
    laws.plane().carried_by(ends.first, laws.pair_of(direction).normalized().perpendicular())
}
