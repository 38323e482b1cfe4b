//! Friction: the joint that it acts in, with its rows, and its law.

use super::laws::May;
use super::{Read, Reader};
use crate::error::DefinitionError;
use crate::friction::{Friction, Kind, SMALLEST, STANDARD_GRAVITY, Sliding, Slip};
use crate::json::{field, list, optional, text};
use crate::law::Law;
use crate::row::Row;
use crate::vector::*;
use serde_json::Value;

pub(super) fn is_friction(kind: &str) -> bool {
    matches!(kind, "coulomb" | "stribeck" | "lugre" | "asperity")
}

impl Reader<'_> {
    pub(super) fn friction(&self, node: &Value, own: &str, rows: &[Row]) -> Read<Friction> {
        let on = text(node, "on", own)?;
        let index = *self.joint_by_name.get(on).ok_or_else(|| DefinitionError::unknown(own, on))?;
        if self.penalties.iter().any(|load| load.name == on) {
            return Err(DefinitionError::not_there_yet(own, "friction in joints that yield"));
        }
        let joint = &self.joints[index];
        let number = |key: &str| Ok(self.entry_of(node, key, own)?.unwrap_or(0.0));
        let radius = number("radius")?;
        let of = |which: &str| {
            let quantity = self.of_joint(index, which);
            quantity
                .map(|quantity| Slip::Of(Box::new(quantity)))
                .ok_or_else(|| DefinitionError::unknown(own, which))
        };
        let (kind, slips, arm) = match joint.kind.as_str() {
            "revolute" if self.spatial => (Kind::Pin, vec![vec![(of("angle")?, 1.0)]], radius),
            "revolute" => (Kind::Any, vec![vec![(of("angle")?, 1.0)]], radius),
            "universal" => {
                let pins = vec![vec![(of("angle_1")?, 1.0)], vec![(of("angle_2")?, 1.0)]];
                (Kind::Any, pins, radius)
            }
            kind @ ("spherical" | "constant_velocity") => {
                let pressing = if kind == "spherical" { Kind::Any } else { Kind::Knuckle };
                let (first, second) = (joint.first.body, joint.second.body);
                let turn = |axis| (Slip::Turn { first, second, axis }, 1.0);
                (pressing, vec![vec![turn(0), turn(1), turn(2)]], radius)
            }
            "cylindrical" => (Kind::Rail, vec![vec![(of("angle")?, radius), (of("travel")?, 1.0)]], 1.0),
            "planar" => {
                let along = [("angle", radius), ("travel_1", 1.0), ("travel_2", 1.0)];
                let slips = along.into_iter().map(|(which, by)| Ok((of(which)?, by)));
                (Kind::Face, vec![slips.collect::<Read<Vec<_>>>()?], 1.0)
            }
            "point_on_plane" => {
                let along = [0, 1].map(|k| (Slip::Of(Box::new(joint.along_quantity(k))), 1.0));
                (Kind::Face, vec![along.into()], 1.0)
            }
            "screw" => {
                let named = |node: &&Value| node.get("name").and_then(Value::as_str) == Some(on);
                let joint = list(self.tree, "joints", own)?.iter().find(named);
                let joint = joint.ok_or_else(|| DefinitionError::unknown(own, on))?;
                let lead = self.needed(joint, "pitch", own)? / std::f64::consts::TAU;
                let whole = radius.hypot(lead);
                let quantity =
                    |which| self.of_joint(index, which).ok_or_else(|| DefinitionError::unknown(own, which));
                let parts =
                    vec![(quantity("angle")?, radius * radius / whole), (quantity("travel")?, lead / whole)];
                (Kind::Thread(whole / radius), vec![vec![(Slip::Sum(parts), 1.0)]], 1.0)
            }
            "point_on_curve" => return Err(DefinitionError::not_there_yet(own, "friction along a curve")),
            "prismatic" | "point_on_line" => (Kind::Rail, vec![vec![(of("travel")?, 1.0)]], 1.0),
            kind => return Err(DefinitionError::kind(own, kind)),
        };
        let sliding = self.sliding(node, own)?;
        let column_of_axis = if self.spatial { 2 } else { 0 };
        let rows = rows.iter().enumerate().filter(|(_, row)| row.of == on);
        Ok(Friction {
            kind,
            axis: turned(&joint.first.axes, column(&joint.frame, column_of_axis)),
            first: joint.first.clone(),
            second: joint.second.clone(),
            rows: rows.map(|(at, row)| (at, row.clone())).collect(),
            slips,
            radius: arm,
            length: number("length")?,
            shoulder: number("shoulder")?,
            preload: number("preload")?,
            smallest: self.smallest()?,
            law: sliding,
            index: 0,
        })
    }

    /// A law of friction.
    pub(super) fn sliding(&self, node: &Value, own: &str) -> Read<Sliding> {
        let number = |key: &str| Ok(self.entry_of(node, key, own)?.unwrap_or(0.0));
        let law = |key: &str| match optional(node, key) {
            Some(entry) => self.law(field(entry, "value", own)?, own, May::Motion),
            None => Ok(Law::constant(0.0)),
        };
        if let Some(bristles) = self.bristles(node, own)? {
            return Ok(Sliding::Remembers(bristles));
        }
        let speed = number("speed")?;
        Ok(match text(node, "kind", own)? {
            "coulomb" => {
                let own = number("force")? + number("torque")?;
                Sliding::Coulomb { coefficient: law("coefficient")?, speed, own }
            }
            _ => Sliding::Stribeck {
                most: law("static")?,
                least: law("kinetic")?,
                transition: number("transition")?,
                speed,
                viscous: number("viscous")?,
            },
        })
    }

    fn smallest(&self) -> Read<f64> {
        let mass: f64 = self.bodies.iter().map(|body| body.mass).sum();
        let gravity = match optional(self.tree, "gravity") {
            Some(tuple) => norm(self.tuple(tuple, "value", "gravity")?),
            None => 0.0,
        };
        Ok(SMALLEST * mass * if gravity > 0.0 { gravity } else { STANDARD_GRAVITY })
    }
}
