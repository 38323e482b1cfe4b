//! Constraints between joint coordinates: gears, racks, general equations, and drivers.

use super::jet::Moving;
use super::laws::Laws;
use super::loads;
use super::space::joints::{self, Elementary};
use crate::model::{Constraint, ConstraintKind, Driver, Expr, JointId, Mechanism, Quantity, Rotor, Space};
use crate::symbolic::Node;
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
pub fn row<'g>(laws: &Laws<'g>, constraint: &Constraint, phase: Option<Node>) -> (&'static str, Moving<'g>) {
    let shift = |given: &Option<Expr>| {
        laws.still(match given {
            Some(given) => laws.value(given),
            None => phase.map_or_else(|| laws.g.zero(), |phase| laws.g.on(phase)),
        })
    };
    match &constraint.kind {
        ConstraintKind::Gear { first, second, ratio, phase } => {
            let ratio = laws.value(ratio);
            ("gear", laws.angle(*first) - ratio * laws.angle(*second) - shift(phase))
        }
        ConstraintKind::Rack { pinion, rail, radius, phase } => {
            let radius = laws.value(radius);
            let travel = laws.kinematics().travel(laws, *rail, 0);
            ("rack", travel - radius * laws.angle(*pinion) - shift(phase))
        }
        ConstraintKind::Equation { residual } => ("equation", laws.jet(residual)),
    }
}

/// quantity − law(time).
pub fn driver_row<'g>(laws: &Laws<'g>, driver: &Driver) -> (&'static str, Moving<'g>) {
    ("driver", laws.quantity(&driver.quantity) - laws.jet(&driver.law))
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
        rotors.extend((loads::of(load.form).counted)(load));
        load.expressions().for_each(|expression| angles_in(expression, &mut rotors));
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
