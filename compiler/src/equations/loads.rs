//! Applied loads: generalised forces, power and potential energy of each.

use super::jet::Jet;
use super::laws::Laws;
use crate::model::{Expr, Load, LoadKind, Place, Rotor};
use crate::symbolic::{Graph, Node, Unary};

/// What one load does.
pub struct LoadTerms {
    /// Added to Q, per velocity.
    pub forces: Vec<(usize, Node)>,
    /// W, of everything the load exerts, springs' conservative part included.
    pub power: Node,
    /// J, of springs.
    pub potential: Node,
}

pub fn terms(g: &mut Graph, laws: &Laws, load: &Load) -> LoadTerms {
    match &load.kind {
        LoadKind::Force { place, components } => force(g, laws, place, components),
        LoadKind::Torque { on, torque } => {
            let torque = laws.value(g, torque);
            let angle = laws.angle(g, *on);
            along(g, laws, &angle, torque)
        }
        LoadKind::Spring { first, second, stiffness, length, damping } => {
            spring(g, laws, [first, second], stiffness, length, damping)
        }
        LoadKind::TorsionSpring { on, stiffness, rest, damping } => {
            torsion_spring(g, laws, *on, stiffness, rest, damping)
        }
    }
}

/// Force f along a scalar coordinate: Q += Jᵀ f, power f·(rate).
fn along(g: &mut Graph, laws: &Laws, coordinate: &Jet, effort: Node) -> LoadTerms {
    let forces = coordinate.columns.iter().map(|(index, column)| (*index, g.mul(*column, effort))).collect();
    let rate = coordinate.rate(g, &laws.kinematics().velocities);
    LoadTerms { forces, power: g.mul(effort, rate), potential: g.constant(0.0) }
}

fn force(g: &mut Graph, laws: &Laws, place: &Place, components: &[Expr; 2]) -> LoadTerms {
    let position = laws.place(g, place);
    let [x, y] = laws.kinematics().world(g, &position);
    let [fx, fy] = laws.vector(g, components);
    let (mut a, b) = (along(g, laws, &x, fx), along(g, laws, &y, fy));
    a.forces.extend(b.forces);
    a.power = g.add(a.power, b.power);
    a
}

/// Tension T = k (l − l₀) + c l̇ with l = |Δ|: force −(T/l) Δ on the second place, V = ½ k (l − l₀)².
fn spring(
    g: &mut Graph,
    laws: &Laws,
    [first, second]: [&Place; 2],
    stiffness: &Expr,
    length: &Expr,
    damping: &Expr,
) -> LoadTerms {
    let v = &laws.kinematics().velocities;
    let (first, second) = (laws.place(g, first), laws.place(g, second));
    let delta = second.sub(g, &first);
    let [x, y] = laws.kinematics().world(g, &delta);
    let (k, rest, c) = (laws.value(g, stiffness), laws.value(g, length), laws.value(g, damping));
    let (xx, yy) = (g.mul(x.value, x.value), g.mul(y.value, y.value));
    let square = g.add(xx, yy);
    let distance = g.unary(Unary::Sqrt, square);

    // T/l, written so that a spring of no free length needs neither root nor division.
    let mut ratio = k;
    if !g.is_zero(rest) && !g.is_zero(k) {
        let shortening = g.div(rest, distance);
        let product = g.mul(k, shortening);
        ratio = g.sub(ratio, product);
    }
    let (x_rate, y_rate) = (x.rate(g, v), y.rate(g, v));
    let (px, py) = (g.mul(x.value, x_rate), g.mul(y.value, y_rate));
    let stretching = g.add(px, py);
    if !g.is_zero(c) {
        let relative = g.div(stretching, square);
        let product = g.mul(c, relative);
        ratio = g.add(ratio, product);
    }

    let mut forces = Vec::new();
    for component in [&x, &y] {
        let pull = g.mul(ratio, component.value);
        for (index, column) in &component.columns {
            let force = g.mul(*column, pull);
            forces.push((*index, g.neg(force)));
        }
    }
    let power = g.mul(ratio, stretching);
    let extension = g.sub(distance, rest);
    LoadTerms { forces, power: g.neg(power), potential: quadratic(g, k, extension) }
}

/// Torque −k (θ − θ₀) − c ω, V = ½ k (θ − θ₀)².
fn torsion_spring(
    g: &mut Graph,
    laws: &Laws,
    on: Rotor,
    stiffness: &Expr,
    rest: &Expr,
    damping: &Expr,
) -> LoadTerms {
    let angle = laws.angle(g, on);
    let (k, rest, c) = (laws.value(g, stiffness), laws.value(g, rest), laws.value(g, damping));
    let deflection = g.sub(angle.value, rest);
    let rate = angle.rate(g, &laws.kinematics().velocities);
    let (elastic, viscous) = (g.mul(k, deflection), g.mul(c, rate));
    let torque = g.add(elastic, viscous);
    let torque = g.neg(torque);
    let mut terms = along(g, laws, &angle, torque);
    terms.potential = quadratic(g, k, deflection);
    terms
}

/// ½ k x².
fn quadratic(g: &mut Graph, k: Node, x: Node) -> Node {
    let half = g.constant(0.5);
    let square = g.mul(x, x);
    let product = g.mul(k, square);
    g.mul(half, product)
}
