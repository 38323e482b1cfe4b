//! The deflections of frictions that remember: their names, their law, and their rates.

use super::laws::May;
use super::{Read, Reader};
use crate::bristles::{Bristles, Kind};
use crate::definition::InternalState;
use crate::error::DefinitionError;
use crate::expression::Expression;
use crate::json::{field, optional, text};
use crate::law::{Law, Rate};
use serde_json::Value;

/// What its deflections are called by, if it remembers.
fn deflection(kind: &str) -> Option<&'static str> {
    match kind {
        "lugre" => Some("bristle"),
        "asperity" => Some("way"),
        _ => None,
    }
}

impl Reader<'_> {
    /// Components at each place where surfaces touch, and all of them.
    fn deflections(&self, node: &Value, own: &str) -> Read<[usize; 2]> {
        let on = text(node, "on", own)?;
        if let Some(contact) = self.contact_named(on)? {
            let each = if self.spatial && optional(contact, "slip").is_none() { 3 } else { 1 };
            return Ok([each, each * self.count(contact, on)?]);
        }
        let index = *self.joint_by_name.get(on).ok_or_else(|| DefinitionError::unknown(own, on))?;
        Ok(match self.joints[index].kind.as_str() {
            "spherical" | "constant_velocity" => [3, 3],
            "cylindrical" => [2, 2],
            "universal" => [1, 2],
            _ => [1, 1],
        })
    }

    /// Names of the deflections of a load.
    pub(super) fn bristles_of(&self, node: &Value, own: &str) -> Read<Vec<String>> {
        let Some(what) = deflection(text(node, "kind", own)?) else { return Ok(Vec::new()) };
        let [_, count] = self.deflections(node, own)?;
        Ok(match count {
            1 => vec![format!("{own}.{what}")],
            _ => (0..count).map(|which| format!("{own}.{what}[{which}]")).collect(),
        })
    }

    /// The law of a friction that remembers.
    pub(super) fn bristles(&self, node: &Value, own: &str) -> Read<Option<Bristles>> {
        let names = self.bristles_of(node, own)?;
        let Some(first) = names.first() else { return Ok(None) };
        let number = |key: &str| Ok(self.entry_of(node, key, own)?.unwrap_or(0.0));
        let law = |key: &str| match optional(node, key) {
            Some(entry) => self.law(field(entry, "value", own)?, own, May::Motion),
            None => Ok(Law::constant(0.0)),
        };
        let kind = if text(node, "kind", own)? == "lugre" {
            Kind::LuGre {
                most: law("static")?,
                least: law("kinetic")?,
                transition: number("transition")?,
                stiffness: number("stiffness")?,
                damping: number("damping")?,
                viscous: number("viscous")?,
            }
        } else {
            Kind::Asperity {
                most: law("coefficient")?,
                stiffness: number("stiffness")?,
                speed: number("speed")?,
            }
        };
        let first = *self.states.get(first).ok_or_else(|| DefinitionError::unknown(own, first))?;
        let [components, _] = self.deflections(node, own)?;
        Ok(Some(Bristles { kind, first, components }))
    }

    /// Of one load, in their order.
    pub(super) fn bristle_states(&self, node: &Value, own: &str) -> Read<Vec<InternalState>> {
        let names = self.bristles_of(node, own)?.into_iter().enumerate();
        let state = |(which, name): (usize, String)| {
            let load = self.loads.get(own).ok_or_else(|| DefinitionError::unknown(own, own))?;
            let rate = Law {
                expression: Expression::Rate(0),
                quantities: Vec::new(),
                rates: vec![Rate::Bending(Box::new(load.clone()), which)],
            };
            Ok(InternalState { name, start: 0.0, rate })
        };
        names.map(state).collect()
    }
}
