//! Couplings, equations and drivers: rows that name quantities.

use super::laws::May;
use super::{Read, Reader};
use crate::error::DefinitionError;
use crate::expression::{Expression, Operator};
use crate::json::{field, list, name, optional, text};
use crate::kinematics::Section;
use crate::quantity::Quantity;
use crate::row::{Equation, Phase, Row};
use serde_json::Value;

impl Reader<'_> {
    pub(super) fn read_couplings(&self) -> Read<Vec<Row>> {
        let pairs = self.pairs()?;
        let mut rows = Vec::new();
        for node in list(self.tree, "constraints", "constraints")? {
            let own = name(node, "constraints")?;
            let (what, equation) = match text(node, "kind", own)? {
                // left − right.
                "equation" => {
                    let law = self.reading(own, May::Positions, |law| {
                        let left = law.expression(field(node, "left", own)?)?;
                        let right = law.expression(field(node, "right", own)?)?;
                        Ok(Expression::binary(Operator::Minus, left, right))
                    })?;
                    ("equation", Equation::Law(law))
                }
                // θ_a − r θ_b − phase.
                "gear" => {
                    let ratio = self.needed(node, "ratio", own)?;
                    let (first, second) = (self.rotor(node, "first", own)?, self.rotor(node, "second", own)?);
                    let terms = vec![(1.0, first), (-ratio, second)];
                    ("gear", Equation::Sum { terms, phase: self.phase(node, own)? })
                }
                // Σ (factor/z₁) θ − phase; none where the teeth of others hold these in place.
                "teeth" => {
                    let pair = pairs.iter().find(|(name, _)| name == own).map(|(_, pair)| pair);
                    let pair = pair.filter(|pair| !pair.follows);
                    let Some(pair) = pair else { continue };
                    let teeth = pair.scale();
                    let terms = pair
                        .terms
                        .iter()
                        .map(|(factor, what)| Ok((factor / teeth, self.turning(*what, own)?)));
                    ("teeth", Equation::Sum { terms: terms.collect::<Read<_>>()?, phase: Phase::Open })
                }
                // travel − r θ − phase.
                "rack" => {
                    let radius = self.needed(node, "radius", own)?;
                    let rail = text(node, "rail", own)?;
                    let travel = self.joint_by_name.get(rail).and_then(|rail| self.of_joint(*rail, "travel"));
                    let travel = travel.ok_or_else(|| DefinitionError::unknown(own, rail))?;
                    let terms = vec![(1.0, travel), (-radius, self.rotor(node, "pinion", own)?)];
                    ("rack", Equation::Sum { terms, phase: self.phase(node, own)? })
                }
                kind => return Err(DefinitionError::kind(own, kind)),
            };
            rows.push(Row { of: own.to_string(), what, equation });
        }
        Ok(rows)
    }

    /// quantity − law(t).
    pub(super) fn read_drivers(&self) -> Read<Vec<Row>> {
        let mut rows = Vec::new();
        for node in list(self.tree, "drivers", "drivers")? {
            let own = name(node, "drivers")?;
            let law = self.reading(own, May::Positions, |law| {
                let quantity = law.expression(field(node, "quantity", own)?)?;
                let wanted = law.entry(field(node, "law", own)?)?;
                Ok(Expression::binary(Operator::Minus, quantity, wanted))
            })?;
            rows.push(Row { of: own.to_string(), what: "driver", equation: Equation::Law(law) });
        }
        Ok(rows)
    }

    fn phase(&self, node: &Value, own: &str) -> Read<Phase> {
        if optional(node, "phase").is_none() {
            return Ok(Phase::Open);
        }
        self.needed(node, "phase", own).map(Phase::Given)
    }

    /// The angle of a joint, or in the plane of a body, that a field names.
    pub(super) fn rotor(&self, node: &Value, key: &str, own: &str) -> Read<Quantity> {
        let rotor = text(node, key, own)?;
        if let Some(joint) = self.joint_by_name.get(rotor)
            && let Some(angle) = self.of_joint(*joint, "angle")
        {
            return Ok(angle);
        }
        match self.body_by_name.get(rotor) {
            Some(body) if !self.spatial && !self.bodies[*body].particle => {
                Ok(Quantity::PlaneAngle { first: Section::whole(None), second: Section::whole(Some(*body)) })
            }
            _ => Err(DefinitionError::unknown(own, rotor)),
        }
    }
}
