//! Revolute: p₁ − p₂ = 0.

use super::{Carried, Ends, JointRow, Wrench};
use crate::equations::laws::Laws;
use crate::equations::plane::kinematics::Placement;
use crate::symbolic::{Graph, Node};

pub fn rows(g: &mut Graph, laws: &Laws, ends: &Ends) -> Vec<JointRow> {
    let [x, y] = laws.plane().world(g, &ends.delta);
    vec![JointRow::new("x", x.neg(g)), JointRow::new("y", y.neg(g))]
}

pub fn attach(g: &mut Graph, carried: Carried) -> Placement {
    let pivot = carried.pivot.clone();
    let offset = [g.constant(1.0), g.constant(0.0)];
    carried.at(g, &pivot, offset)
}

/// −Dᵀλ with ∂Φ/∂p₂ = −1: the force on the second is λ.
pub fn reaction(g: &mut Graph, lambda: &[Node]) -> Wrench {
    [lambda[0], lambda[1], g.constant(0.0)]
}
