//! Point on line: n̂·Δ = 0 with n̂ normal to the line, which the first body carries.

use super::{Carried, Ends, JointRow, Wrench, normalized, perpendicular};
use crate::equations::laws::Laws;
use crate::equations::plane::kinematics::{Placement, rotate};
use crate::model::Vector;
use crate::symbolic::{Graph, Node};

pub fn rows(g: &mut Graph, laws: &Laws, ends: &Ends, direction: &Vector) -> Vec<JointRow> {
    let along = laws.pair_of(g, direction);
    let along = normalized(g, along);
    let normal = perpendicular(g, along);
    let (frame, normal) = ends.direction(g, laws, normal);
    vec![JointRow::new("normal", laws.plane().project(g, frame, normal, &ends.delta))]
}

pub fn attach(g: &mut Graph, laws: &Laws, carried: Carried, direction: &Vector) -> Placement {
    let one = [g.constant(1.0), g.constant(0.0)];
    let along = laws.pair_of(g, direction);
    let along = normalized(g, along);
    // The line's body is the parent, or else the carried body itself.
    let (frame, along) = if carried.child_is_second {
        (carried.parent.frame, rotate(g, carried.parent.offset, along))
    } else {
        (carried.frame, along)
    };
    let slide = carried.slide(g, frame, along);
    let far = carried.pivot.add(g, &slide);
    carried.at(g, &far, one)
}

/// −Dᵀλ: force −λ n̂ at the second place.
pub fn reaction(g: &mut Graph, laws: &Laws, ends: &Ends, direction: &Vector, lambda: &[Node]) -> Wrench {
    let along = laws.pair_of(g, direction);
    let along = normalized(g, along);
    let normal = perpendicular(g, along);
    let (frame, normal) = ends.direction(g, laws, normal);
    let normal = laws.plane().to_world(g, frame, normal);
    let force = normal.map(|component| {
        let product = g.mul(component, lambda[0]);
        g.neg(product)
    });
    [force[0], force[1], g.constant(0.0)]
}
