//! Positions from which assembly is tried: what `start` and the drivers state or guess, the rest at zero first and later turned by
//! the golden angle, each by a different multiple.

mod plane;
mod space;

use super::point::{Ancestry, Point};
use crate::equations::Equations;
use crate::model::{Frame, JointId, Mechanism, Quantity, Space};
use std::collections::BTreeMap;

/// Turns by multiples of the golden angle never repeat.
const GOLDEN: f64 = 2.399963229728653;

/// Values that `start` and the drivers give to coordinates.
pub struct Stated {
    angles: BTreeMap<(JointId, usize), f64>,
    bodies: BTreeMap<usize, f64>,
    travels: BTreeMap<(JointId, usize), f64>,
    centers: BTreeMap<(usize, usize), f64>,
}

impl Stated {
    pub fn of(equations: &Equations, point: &mut Point) -> Self {
        let mut stated = Stated {
            angles: BTreeMap::new(),
            bodies: BTreeMap::new(),
            travels: BTreeMap::new(),
            centers: BTreeMap::new(),
        };
        let exact = equations.conditions.iter().zip(&equations.start_targets);
        let exact = exact.filter_map(|(condition, start)| Some((condition, start.position?)));
        let guessed = equations.guesses.iter().chain(&equations.driven);
        let guessed = guessed.map(|(condition, node)| (condition, *node));
        for (condition, node) in guessed.chain(exact) {
            point.evaluate(&Ancestry::of(equations, [node]));
            let value = point.get(node);
            match &condition.quantity {
                Quantity::JointAngle(joint, which) => {
                    stated.angles.insert((*joint, *which), value);
                }
                Quantity::BodyAngle(body) => {
                    stated.bodies.insert(body.0, value);
                }
                Quantity::JointTravel(joint, which) => {
                    stated.travels.insert((*joint, *which), value);
                }
                Quantity::Position(place, axis) => {
                    if let Frame::Body(body) = place.frame {
                        stated.centers.insert((body.0, *axis), value);
                    }
                }
                _ => {}
            }
        }
        stated
    }

    /// q for attempt `number`.
    pub fn initial(&self, mechanism: &Mechanism, point: &mut Point, number: usize) -> Vec<f64> {
        match mechanism.space {
            Space::Planar => plane::initial(self, mechanism, point.equations, number),
            Space::Spatial => space::initial(self, mechanism, point, number),
        }
    }

    /// Whether `start` states an angle of a joint, and not only guesses it.
    fn is_exact_angle(equations: &Equations, joint: JointId, which: usize) -> bool {
        let exact = equations.conditions.iter().zip(&equations.start_targets);
        exact.filter(|(_, start)| start.position.is_some()).any(|(condition, _)| {
            matches!(condition.quantity, Quantity::JointAngle(own, angle) if own == joint && angle == which)
        })
    }
}
