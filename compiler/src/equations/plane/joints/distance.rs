//! Distance (massless rod with two pins): (Δ·Δ − L²)/2 = 0, polynomial, with multiplier force/length.

use super::{Ends, JointRow, Wrench};
use crate::equations::laws::Laws;
use crate::model::Expr;
use crate::symbolic::Scalar;

pub fn rows(laws: &Laws, ends: &Ends, length: &Expr) -> Vec<JointRow> {
    let [x, y] = ends.in_world(laws);
    let length = laws.jet(length);
    let (xx, yy, ll) = (0.5 * (&x * &x), 0.5 * (&y * &y), 0.5 * (&length * &length));
    vec![JointRow::new("distance", xx + yy - ll)]
}

/// −Dᵀλ with ∂Φ/∂p₂ = Δ: force −λ Δ at the second place.
pub fn reaction<'g>(laws: &Laws<'g>, ends: &Ends<'g>, lambda: &[Scalar<'g>]) -> Wrench<'g> {
    let [x, y] = ends.in_world(laws).map(|component| -(component.value() * lambda[0]));
    [x, y, laws.g.zero()]
}
