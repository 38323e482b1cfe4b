//! Distance (massless rod with two pins): (Δ·Δ − L²)/2 = 0, polynomial, with multiplier force/length.

use super::{Ends, JointRow, Wrench};
use crate::equations::laws::Laws;
use crate::model::Expr;
use crate::symbolic::{Graph, Node};

pub fn rows(g: &mut Graph, laws: &Laws, ends: &Ends, length: &Expr) -> Vec<JointRow> {
    let kinematics = laws.plane();
    let [x, y] = kinematics.world(g, &ends.delta);
    let length = laws.jet(g, length);
    let half = g.constant(0.5);
    let square = |g: &mut Graph, jet: &super::Jet| jet.mul(g, jet, &kinematics.velocities).scale(g, half);
    let (xx, yy, ll) = (square(g, &x), square(g, &y), square(g, &length));
    let sum = xx.add(g, &yy).sub(g, &ll);
    vec![JointRow::new("distance", sum)]
}

/// −Dᵀλ with ∂Φ/∂p₂ = Δ: force −λ Δ at the second place.
pub fn reaction(g: &mut Graph, laws: &Laws, ends: &Ends, lambda: &[Node]) -> Wrench {
    let [x, y] = laws.plane().world(g, &ends.delta);
    let force = [x.value, y.value].map(|component| {
        let product = g.mul(component, lambda[0]);
        g.neg(product)
    });
    [force[0], force[1], g.constant(0.0)]
}
