//! Constraints between joint coordinates: gears, racks, general equations, and drivers.

use super::jet::Jet;
use super::laws::Laws;
use super::space::joints::{self, Elementary};
use crate::model::{
    Constraint, ConstraintKind, Driver, Expr, JointId, LoadKind, Mechanism, Quantity, Rotor, Space,
};
use crate::symbolic::{Graph, Node};
use std::collections::BTreeSet;

/// Couplings whose phase comes from the assembled start, by name, in order.
pub fn open_phases(mechanism: &Mechanism) -> impl Iterator<Item = String> + '_ {
    mechanism.constraints.iter().filter(|constraint| is_open(constraint)).map(|c| c.name.identifier())
}

/// Whether a coupling's phase comes from the assembled start.
pub fn is_open(constraint: &Constraint) -> bool {
    matches!(
        constraint.kind,
        ConstraintKind::Gear { phase: None, .. } | ConstraintKind::Rack { phase: None, .. }
    )
}

/// The residual of a constraint, and what its row is called. `phase` is used where the definition gives none.
pub fn row(g: &mut Graph, laws: &Laws, constraint: &Constraint, phase: Option<Node>) -> (&'static str, Jet) {
    let shift = |g: &mut Graph, jet: Jet, given: &Option<Expr>| {
        let phase = match given {
            Some(given) => laws.value(g, given),
            None => phase.unwrap_or(g.constant(0.0)),
        };
        let phase = Jet::constant(g, phase);
        jet.sub(g, &phase)
    };
    match &constraint.kind {
        ConstraintKind::Gear { first, second, ratio, phase } => {
            let ratio = laws.value(g, ratio);
            let (a, b) = (laws.angle(g, *first), laws.angle(g, *second).scale(g, ratio));
            let difference = a.sub(g, &b);
            ("gear", shift(g, difference, phase))
        }
        ConstraintKind::Rack { pinion, rail, radius, phase } => {
            let radius = laws.value(g, radius);
            let (a, b) =
                (laws.kinematics().travel(g, laws, *rail, 0), laws.angle(g, *pinion).scale(g, radius));
            let difference = a.sub(g, &b);
            ("rack", shift(g, difference, phase))
        }
        ConstraintKind::Equation { residual } => ("equation", laws.jet(g, residual)),
    }
}

/// quantity − law(time).
pub fn driver_row(g: &mut Graph, laws: &Laws, driver: &Driver) -> (&'static str, Jet) {
    let (quantity, law) = (laws.quantity(g, &driver.quantity), laws.jet(g, &driver.law));
    ("driver", quantity.sub(g, &law))
}

/// The rotors whose angle the dynamics use, and which therefore carry it over several turns.
pub fn multi_turn_rotors(mechanism: &Mechanism) -> Vec<Rotor> {
    let mut rotors = BTreeSet::new();
    for constraint in &mechanism.constraints {
        match &constraint.kind {
            ConstraintKind::Gear { first, second, .. } => rotors.extend([*first, *second]),
            ConstraintKind::Rack { pinion, .. } => {
                rotors.insert(*pinion);
            }
            ConstraintKind::Equation { residual } => angles_in(residual, &mut rotors),
        }
    }
    for driver in &mechanism.drivers {
        angles_of(&driver.quantity, &mut rotors);
    }
    for load in &mechanism.loads {
        match &load.kind {
            LoadKind::Force { components, .. } => {
                components.iter().for_each(|component| angles_in(component, &mut rotors));
            }
            LoadKind::Torque { torque, .. } => angles_in(torque, &mut rotors),
            LoadKind::Push { force, .. } => angles_in(force, &mut rotors),
            LoadKind::BodyTorque { components, .. } => {
                components.iter().for_each(|component| angles_in(component, &mut rotors));
            }
            LoadKind::Spring { stiffness, length, damping, .. } => {
                [stiffness, length, damping].into_iter().for_each(|law| angles_in(law, &mut rotors));
            }
            LoadKind::TorsionSpring { on, stiffness, rest, damping } => {
                rotors.insert(*on);
                [stiffness, rest, damping].into_iter().for_each(|law| angles_in(law, &mut rotors));
            }
        }
    }
    // The travel of a screw is its counted angle times the pitch.
    for (index, joint) in mechanism.joints.iter().enumerate() {
        if mechanism.space == Space::Spatial && joints::motions(joint).contains(&Elementary::Wind) {
            rotors.insert(Rotor::Joint(JointId(index), 0));
        }
    }
    rotors.into_iter().collect()
}

fn angles_in(expr: &Expr, rotors: &mut BTreeSet<Rotor>) {
    match expr {
        Expr::Number(_) | Expr::Parameter(_) | Expr::Input(_) | Expr::Time => {}
        Expr::Quantity(quantity) => angles_of(quantity, rotors),
        Expr::Unary(_, a) | Expr::Power(a, _) => angles_in(a, rotors),
        Expr::Binary(_, a, b) => {
            angles_in(a, rotors);
            angles_in(b, rotors);
        }
        Expr::If(condition, a, b) => {
            angles_in_condition(condition, rotors);
            angles_in(a, rotors);
            angles_in(b, rotors);
        }
    }
}

fn angles_in_condition(condition: &crate::model::Condition, rotors: &mut BTreeSet<Rotor>) {
    use crate::model::Condition;
    match condition {
        Condition::Compare(_, a, b) => {
            angles_in(a, rotors);
            angles_in(b, rotors);
        }
        Condition::And(a, b) | Condition::Or(a, b) => {
            angles_in_condition(a, rotors);
            angles_in_condition(b, rotors);
        }
        Condition::Not(a) => angles_in_condition(a, rotors),
    }
}

fn angles_of(quantity: &Quantity, rotors: &mut BTreeSet<Rotor>) {
    match quantity {
        Quantity::BodyAngle(body) => {
            rotors.insert(Rotor::Body(*body));
        }
        Quantity::JointAngle(joint, which) => {
            rotors.insert(Rotor::Joint(*joint, *which));
        }
        _ => {}
    }
}
