//! Applied loads: generalised forces, power and potential energy of each.

use super::jet::Jet;
use super::laws::Laws;
use crate::model::{Expr, Load, LoadKind, Place, Rotor, Vector};
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
        LoadKind::Push { joint, force } => {
            let force = laws.value(g, force);
            let travel = laws.kinematics().travel(g, laws, *joint, 0);
            along(g, laws, &travel, force)
        }
        LoadKind::BodyTorque { body, components } => {
            let components = laws.vector(g, components);
            let turning = laws.kinematics().turning(g, *body);
            together(g, laws, &turning, &components)
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
    let rate = coordinate.rate(g, laws.kinematics().velocities());
    LoadTerms { forces, power: g.mul(effort, rate), potential: g.constant(0.0) }
}

fn force(g: &mut Graph, laws: &Laws, place: &Place, components: &Vector) -> LoadTerms {
    let position = laws.kinematics().world(g, laws, place);
    let components = laws.vector(g, components);
    together(g, laws, &position, &components)
}

/// Components of a force or torque along as many coordinates.
fn together(g: &mut Graph, laws: &Laws, coordinates: &[Jet], efforts: &[Node]) -> LoadTerms {
    let zero = g.constant(0.0);
    let mut sum = LoadTerms { forces: Vec::new(), power: zero, potential: zero };
    for (coordinate, effort) in coordinates.iter().zip(efforts) {
        let terms = along(g, laws, coordinate, *effort);
        sum.forces.extend(terms.forces);
        sum.power = g.add(sum.power, terms.power);
    }
    sum
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
    let v = laws.kinematics().velocities();
    let delta = laws.kinematics().between(g, laws, first, second);
    let (k, rest, c) = (laws.value(g, stiffness), laws.value(g, length), laws.value(g, damping));
    let squares: Vec<Node> = delta.iter().map(|d| g.mul(d.value, d.value)).collect();
    let square = g.sum(squares);
    let distance = g.unary(Unary::Sqrt, square);

    // T/l, written so that a spring of no free length needs neither root nor division.
    let mut ratio = k;
    if !g.is_zero(rest) && !g.is_zero(k) {
        let shortening = g.div(rest, distance);
        let product = g.mul(k, shortening);
        ratio = g.sub(ratio, product);
    }
    let mut products = Vec::new();
    for component in &delta {
        let rate = component.rate(g, v);
        products.push(g.mul(component.value, rate));
    }
    let stretching = g.sum(products);
    if !g.is_zero(c) {
        let relative = g.div(stretching, square);
        let product = g.mul(c, relative);
        ratio = g.add(ratio, product);
    }

    let mut forces = Vec::new();
    for component in &delta {
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
    let rate = angle.rate(g, laws.kinematics().velocities());
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
