//! Coordinates that can be held at a value: those that `start` states, and the independent ones.

use super::coordinates::{Symbols, angle_name, travel_name};
use super::jet::Jet;
use super::laws::Laws;
use crate::model::{Mechanism, Quantity, Rotor, StartOrientation};
use crate::symbolic::{Class, Node};

/// One coordinate as a row beside the constraints.
#[derive(Clone, Debug)]
pub struct Condition {
    /// `crank_pin.angle`.
    pub of: String,
    pub quantity: Quantity,
    /// An angle: at expansion compared on the circle, because `start` speaks of positions.
    pub angular: bool,
    /// An angle whose turns the dynamics count: at run time compared with them, because laws depend on them.
    pub counted: bool,
    /// sin(θ − target) of an angle that is not counted, else value − target.
    pub residual: Node,
    /// cos(θ − target), or 1.
    pub upright: Node,
    /// A rate without a coordinate: ω of a body in space. It has no value.
    pub rate_only: bool,
    /// Value (of an angle: atan2), columns and bias of the coordinate itself.
    pub jet: Jet,
}

/// The position coordinate that a quantity, or its rate, belongs to; `None` if it can be no condition.
pub fn coordinate_of(quantity: &Quantity) -> Option<Quantity> {
    Some(match quantity {
        Quantity::BodyAngle(body) | Quantity::BodyRate(body) => Quantity::BodyAngle(*body),
        Quantity::JointAngle(joint, which) | Quantity::JointRate(joint, which) => {
            Quantity::JointAngle(*joint, *which)
        }
        Quantity::JointTravel(joint, which) | Quantity::JointSpeed(joint, which) => {
            Quantity::JointTravel(*joint, *which)
        }
        Quantity::BodyOmega(body, axis) => Quantity::BodyOmega(*body, *axis),
        Quantity::Position(place, axis) | Quantity::Velocity(place, axis) => {
            Quantity::Position(place.clone(), *axis)
        }
        Quantity::Distance(a, b) => Quantity::Distance(a.clone(), b.clone()),
        _ => return None,
    })
}

/// Whether a quantity is itself a position coordinate (not the rate of one).
pub fn is_position(quantity: &Quantity) -> bool {
    matches!(
        quantity,
        Quantity::BodyAngle(_)
            | Quantity::JointAngle(..)
            | Quantity::JointTravel(..)
            | Quantity::Position(..)
            | Quantity::Distance(..)
    )
}

/// Name of a position coordinate, `crank_pin.angle`.
pub fn name(mechanism: &Mechanism, quantity: &Quantity) -> String {
    match quantity {
        Quantity::BodyAngle(body) => format!("{}.angle", mechanism.bodies[body.0].name.text),
        Quantity::BodyOmega(body, axis) => {
            format!("{}.rate.{}", mechanism.bodies[body.0].name.text, ["x", "y", "z"][*axis])
        }
        Quantity::JointAngle(id, which) => angle_name(mechanism, *id, *which, 0),
        Quantity::JointTravel(id, which) => travel_name(mechanism, *id, *which, 0),
        Quantity::Position(place, axis) => format!("{}.{}", place.text, ["x", "y", "z"][*axis]),
        Quantity::Distance(a, b) => format!("distance({}, {})", a.text, b.text),
        other => format!("{other:?}"),
    }
}

/// The row of one position coordinate; makes a new target symbol.
pub fn condition(laws: &Laws, quantity: &Quantity) -> (Condition, Node) {
    let of = name(laws.mechanism, quantity);
    let target = laws.g.symbol(format!("target_{of}"), Class::Input);
    let coordinate = laws.quantity(quantity);
    let rotor = match quantity {
        Quantity::BodyAngle(body) => Some(Rotor::Body(*body)),
        Quantity::JointAngle(joint, which) => Some(Rotor::Joint(*joint, *which)),
        _ => None,
    };
    let counted = rotor.is_some_and(|rotor| laws.is_counted(rotor));
    let (residual, upright) = match rotor.filter(|_| !counted) {
        Some(rotor) => {
            let [cos, sin] = laws.kinematics().rotor_pair(laws, rotor).parts();
            let (c, s) = (target.cos(), target.sin());
            (sin * c - cos * s, cos * c + sin * s)
        }
        None => (coordinate.value() - target, laws.g.one()),
    };
    (
        Condition {
            of,
            quantity: quantity.clone(),
            angular: rotor.is_some(),
            counted,
            rate_only: matches!(quantity, Quantity::BodyOmega(..)),
            residual: residual.bare,
            upright: upright.bare,
            jet: coordinate.jet,
        },
        target.bare,
    )
}

/// What `start` asks of a condition.
#[derive(Clone, Debug, Default)]
pub struct StartTarget {
    pub position: Option<Node>,
    pub rate: Option<Node>,
}

/// The positions that `start` guesses, with the values guessed.
pub fn guesses(laws: &Laws) -> Vec<(Condition, Node)> {
    let guessed = laws.mechanism.start.iter().filter(|start| !start.exact && is_position(&start.quantity));
    let mut guesses: Vec<(Condition, Node)> = guessed
        .map(|start| {
            let (condition, _) = condition(laws, &start.quantity);
            (condition, laws.value(&start.value).bare)
        })
        .collect();
    let zero = laws.g.zero().bare;
    for start in laws.mechanism.orientations.iter().filter(|start| !start.exact) {
        let rows = orientation(laws, start);
        guesses.extend(rows.into_iter().map(|(condition, _)| (condition, zero)));
    }
    guesses
}

/// Three rows that hold a body in space at an orientation A₀: Σ ½ A₀ e_j × A e_j, the axis of the turn between them
/// times its sine. Their targets are zero.
pub fn orientation(laws: &Laws, start: &StartOrientation) -> Vec<(Condition, Node)> {
    let quaternion = laws.g.on([0, 1, 2, 3].map(|k| laws.value(&start.quaternion[k]).bare));
    let deviations = laws.kinematics().deviation(start.body, quaternion);
    let body = &laws.mechanism.bodies[start.body.0].name.text;
    let upright = laws.g.one().bare;
    let mut rows = Vec::new();
    for (axis, deviation) in deviations.into_iter().enumerate() {
        let of = format!("{body}.orientation.{}", ["x", "y", "z"][axis]);
        let target = laws.g.symbol(format!("target_{of}"), Class::Input);
        let residual = (deviation.value() - target).bare;
        let quantity = Quantity::BodyOmega(start.body, axis);
        let condition = Condition {
            of,
            quantity,
            angular: false,
            counted: false,
            rate_only: false,
            residual,
            upright,
            jet: deviation.jet,
        };
        rows.push((condition, target.bare));
    }
    rows
}

/// The conditions of `start`, in order of first mention, with the values asked.
pub fn start_conditions(laws: &Laws, symbols: &mut Symbols) -> (Vec<Condition>, Vec<StartTarget>) {
    let mut conditions: Vec<Condition> = Vec::new();
    let mut targets: Vec<StartTarget> = Vec::new();
    for start in laws.mechanism.start.iter().filter(|start| start.exact) {
        let Some(coordinate) = coordinate_of(&start.quantity) else { continue };
        let of = name(laws.mechanism, &coordinate);
        let index = match conditions.iter().position(|known| known.of == of) {
            Some(index) => index,
            None => {
                let (condition, target) = condition(laws, &coordinate);
                symbols.targets.push(target);
                conditions.push(condition);
                targets.push(StartTarget::default());
                conditions.len() - 1
            }
        };
        let value = Some(laws.value(&start.value).bare);
        if is_position(&start.quantity) {
            targets[index].position = value;
        } else {
            targets[index].rate = value;
        }
    }
    let zero = laws.g.zero().bare;
    for start in laws.mechanism.orientations.iter().filter(|start| start.exact) {
        for (condition, target) in orientation(laws, start) {
            symbols.targets.push(target);
            conditions.push(condition);
            targets.push(StartTarget { position: Some(zero), rate: None });
        }
    }
    (conditions, targets)
}
