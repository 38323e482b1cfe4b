//! Joints that yield: the ways along which their penalties act.

use super::joints::Joint;
use super::{Read, Reader};
use crate::error::DefinitionError;
use crate::json::optional;
use crate::load::{Acts, Load, Way};
use crate::penalty::Penalty;
use crate::quantity::Quantity;
use crate::row::Equation;
use crate::vector::unit_axis;
use serde_json::Value;

impl Reader<'_> {
    /// The load in place of the rows of a joint.
    pub(super) fn penalty(
        &self,
        joint: &Joint,
        node: &Value,
        own: &str,
        rows: Vec<(&'static str, Equation)>,
    ) -> Read<Load> {
        let value = |key: &str| Ok(self.entry_of(node, key, own)?.unwrap_or(0.0));
        let (damping, line) = match optional(node, "damping_along") {
            Some(_) => (0.0, Some([value("damping")?, value("smallest")?])),
            None => (value("damping")?, None),
        };
        let along = [value("stiffness")?, damping];
        let about = [value("torsional_stiffness")?, value("torsional_damping")?];
        let (mut shifts, mut turns) = (Vec::new(), Vec::new());
        for (what, equation) in rows {
            let terms = match equation {
                Equation::Zero(Quantity::Gap { first, second, axis }) => {
                    vec![(1.0, Quantity::Along { axis: unit_axis(axis), first, second })]
                }
                Equation::Zero(quantity) => vec![(1.0, quantity)],
                Equation::Sum { terms, .. } => terms,
                Equation::Distance { .. } | Equation::Law(_) => {
                    return Err(DefinitionError::kind(own, joint.kind()));
                }
            };
            let turned = matches!(what, "angle" | "axis_1" | "axis_2" | "cross" | "twist");
            let [stiffness, damping] = if turned { about } else { along };
            let way = Way { terms, wrapped: false, gap: 0.0, stiffness, damping };
            if turned { turns.push(way) } else { shifts.push(way) }
        }
        let acts = Acts::Penalty(Box::new(Penalty { shifts, turns, line }));
        Ok(Load { name: own.to_string(), acts })
    }
}
