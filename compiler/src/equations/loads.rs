//! Applied loads: generalised forces, power and potential energy of each.

use super::jet::Moving;
use super::laws::Laws;
use crate::model::{Expr, Load, LoadKind, Place, Rotor};
use crate::symbolic::{Node, Scalar};

/// What one load does.
pub struct LoadTerms<'g> {
    /// Added to Q, per velocity.
    pub forces: Vec<(usize, Scalar<'g>)>,
    /// W, of everything the load exerts, springs' conservative part included.
    pub power: Scalar<'g>,
    /// J, of springs.
    pub potential: Scalar<'g>,
}

pub fn terms<'g>(laws: &Laws<'g>, load: &Load) -> LoadTerms<'g> {
    match &load.kind {
        LoadKind::Force { place, components } => {
            let position = laws.kinematics().world(laws, place);
            together(laws, &position, &laws.vector(components).bare)
        }
        LoadKind::Torque { on, torque } => {
            let torque = laws.value(torque);
            along(&laws.angle(*on), torque)
        }
        LoadKind::Push { joint, force } => {
            let force = laws.value(force);
            along(&laws.kinematics().travel(laws, *joint, 0), force)
        }
        LoadKind::BodyTorque { body, components } => {
            let components = laws.vector(components);
            together(laws, &laws.kinematics().turning(*body), &components.bare)
        }
        LoadKind::Spring { first, second, stiffness, length, damping } => {
            spring(laws, [first, second], stiffness, length, damping)
        }
        LoadKind::TorsionSpring { on, stiffness, rest, damping } => {
            torsion_spring(laws, *on, stiffness, rest, damping)
        }
    }
}

/// Effort f along a coordinate: Q += Jᵀ f, power f·(rate).
fn along<'g>(coordinate: &Moving<'g>, effort: Scalar<'g>) -> LoadTerms<'g> {
    let columns = coordinate.jet.columns.iter();
    let forces = columns.map(|(index, column)| (*index, *column * effort)).collect();
    LoadTerms { forces, power: effort * coordinate.rate(), potential: effort.g.zero() }
}

/// Components of a force or torque along as many coordinates.
fn together<'g>(laws: &Laws<'g>, coordinates: &[Moving<'g>], efforts: &[Node]) -> LoadTerms<'g> {
    let zero = laws.g.zero();
    let mut sum = LoadTerms { forces: Vec::new(), power: zero, potential: zero };
    for (coordinate, effort) in coordinates.iter().zip(efforts) {
        let terms = along(coordinate, laws.g.on(*effort));
        sum.forces.extend(terms.forces);
        sum.power += terms.power;
    }
    sum
}

/// Tension T = k (l − l₀) + c l̇ with l = |Δ|: force −(T/l) Δ on the second place, V = ½ k (l − l₀)².
fn spring<'g>(
    laws: &Laws<'g>,
    [first, second]: [&Place; 2],
    stiffness: &Expr,
    length: &Expr,
    damping: &Expr,
) -> LoadTerms<'g> {
    let delta = laws.kinematics().between(laws, first, second);
    let (k, rest, c) = (laws.value(stiffness), laws.value(length), laws.value(damping));
    let square = laws.g.sum(delta.iter().map(|d| d.value().square()));
    let distance = square.sqrt();

    // T/l, written so that a spring of no free length needs neither root nor division.
    let mut pull = k;
    if !rest.is_zero() && !k.is_zero() {
        pull -= k * (rest / distance);
    }
    // l l̇
    let stretching = laws.g.sum(delta.iter().map(|d| d.value() * d.rate()));
    if !c.is_zero() {
        pull += c * (stretching / square);
    }

    let mut forces = Vec::new();
    for component in &delta {
        let force = pull * component.value();
        let columns = component.jet.columns.iter();
        forces.extend(columns.map(|(index, column)| (*index, -(*column * force))));
    }
    LoadTerms { forces, power: -(pull * stretching), potential: elastic_energy(k, distance - rest) }
}

/// Torque −k (θ − θ₀) − c ω, V = ½ k (θ − θ₀)².
fn torsion_spring<'g>(
    laws: &Laws<'g>,
    on: Rotor,
    stiffness: &Expr,
    rest: &Expr,
    damping: &Expr,
) -> LoadTerms<'g> {
    let angle = laws.angle(on);
    let (k, rest, c) = (laws.value(stiffness), laws.value(rest), laws.value(damping));
    let (deflection, rate) = (angle.value() - rest, angle.rate());
    let torque = -(k * deflection + c * rate);
    LoadTerms { potential: elastic_energy(k, deflection), ..along(&angle, torque) }
}

/// ½ k x².
fn elastic_energy<'g>(k: Scalar<'g>, x: Scalar<'g>) -> Scalar<'g> {
    0.5 * (k * x.square())
}
