//! Revolute: p₁ − p₂ = 0.

use super::{Carried, Ends, JointRow, Wrench, vector};
use crate::equations::laws::Laws;
use crate::equations::plane::kinematics::Placement;
use crate::symbolic::Scalar;

pub fn rows(laws: &Laws, ends: &Ends) -> Vec<JointRow> {
    let [x, y] = ends.in_world(laws);
    vec![JointRow::new("x", -x), JointRow::new("y", -y)]
}

pub fn attach<'g>(laws: &Laws<'g>, carried: Carried<'g>) -> Placement {
    let pivot = carried.pivot.clone();
    carried.at(pivot, vector::unturned(laws.g))
}

/// −Dᵀλ with ∂Φ/∂p₂ = −1: the force on the second is λ.
pub fn reaction<'g>(laws: &Laws<'g>, lambda: &[Scalar<'g>]) -> Wrench<'g> {
    [lambda[0], lambda[1], laws.g.zero()]
}
