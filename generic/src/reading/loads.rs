//! Loads: what they act on and their laws.

use super::friction::is_friction;
use super::hysteresis::is_hysteresis;
use super::laws::May;
use super::{Read, Reader};
use crate::error::DefinitionError;
use crate::expression::{Expression, Operator};
use crate::json::{field, list, name, optional, text};
use crate::kinematics::Place;
use crate::kinematics::Section;
use crate::law::Law;
use crate::load::{Acts, Cable, Load, Way};
use crate::quantity::Quantity;
use crate::row::Row;
use crate::rubbing::Rubbing;
use crate::vector::{V3, column};
use serde_json::Value;

impl Reader<'_> {
    pub(super) fn read_loads(&self, rows: &[Row]) -> Read<Vec<Load>> {
        let mut loads = Vec::new();
        for node in list(self.tree, "loads", "loads")? {
            let own = name(node, "loads")?;
            loads.push(Load { name: own.to_string(), acts: self.acts(node, own, rows)? });
        }
        Ok(loads)
    }

    fn acts(&self, node: &Value, own: &str, rows: &[Row]) -> Read<Acts> {
        let value = || self.law(field(node, "value", own)?, own, May::Motion);
        Ok(match text(node, "kind", own)? {
            "force" => {
                let place = self.place(field(node, "place", own)?, own)?;
                if optional(node, "components").is_some() {
                    Acts::Force { place, components: self.components(node, "components", own)? }
                } else {
                    let direction = self.components(node, "direction", own)?;
                    Acts::Directed { place, direction, value: value()? }
                }
            }
            "torque" if optional(node, "components").is_some() => {
                let on = text(node, "on", own)?;
                let body = self.body_by_name.get(on).ok_or_else(|| DefinitionError::unknown(own, on))?;
                Acts::Torque { body: *body, components: self.components(node, "components", own)? }
            }
            "torque" => Acts::Effort { along: self.rotor(node, "on", own)?, value: value()? },
            "push" => {
                let on = text(node, "on", own)?;
                let along = self.joint_by_name.get(on).and_then(|joint| self.of_joint(*joint, "travel"));
                let along = along.ok_or_else(|| DefinitionError::unknown(own, on))?;
                Acts::Effort { along, value: value()? }
            }
            "along" => {
                let expression = self.law(field(node, "expression", own)?, own, May::Positions)?;
                Acts::Along { expression, value: value()? }
            }
            "spring" => {
                let along = Quantity::Length {
                    first: self.place(field(node, "first", own)?, own)?,
                    second: self.place(field(node, "second", own)?, own)?,
                };
                self.spring(node, along, "length", own)?
            }
            "torsion_spring" => self.spring(node, self.rotor(node, "on", own)?, "angle", own)?,
            "cable" => Acts::Cable(Box::new(self.cable(node, own)?)),
            "bushing" => Acts::Bushing(self.bushing(node, own)?),
            // −k f(θ₁ − r θ₂) − c (ω₁ − r ω₂).
            "shaft" => {
                let given = |key: &str| Ok(self.entry_of(node, key, own)?.unwrap_or(0.0));
                let ratio = self.needed(node, "ratio", own)?;
                let terms =
                    vec![(1.0, self.rotor(node, "first", own)?), (-ratio, self.rotor(node, "second", own)?)];
                let (stiffness, damping) = (given("stiffness")?, given("damping")?);
                Acts::Bushing(vec![Way {
                    terms,
                    wrapped: false,
                    gap: given("backlash")?,
                    stiffness,
                    damping,
                }])
            }
            "mesh" => self.mesh(node, own)?,
            "dry" if self.contact_named(text(node, "on", own)?)?.is_none() => {
                return Err(DefinitionError::not_there_yet(own, "dry friction that sticks in joints"));
            }
            "dry" => return Err(DefinitionError::not_there_yet(own, "impulses of rigid contacts that rub")),
            kind if is_friction(kind) && self.contact_named(text(node, "on", own)?)?.is_some() => {
                let spots = self.spots(text(node, "on", own)?)?;
                Acts::Rubbing(Box::new(Rubbing { law: self.sliding(node, own)?, spots }))
            }
            kind if is_friction(kind) => Acts::Friction(Box::new(self.friction(node, own, rows)?)),
            kind if is_hysteresis(kind) => self.hysteresis(node, own)?,
            kind => return Err(DefinitionError::kind(own, kind)),
        })
    }

    /// Laws along the world's axes; the third is zero in the plane.
    fn components(&self, node: &Value, key: &str, own: &str) -> Read<[Law; 3]> {
        let values = list(node, key, own)?;
        if values.len() != self.dimension() {
            return Err(DefinitionError::malformed(own, key));
        }
        let mut components = [0.0; 3].map(Law::constant);
        for (component, value) in components.iter_mut().zip(values) {
            *component = self.law(value, own, May::Motion)?;
        }
        Ok(components)
    }

    fn spring(&self, node: &Value, along: Quantity, rest: &str, own: &str) -> Read<Acts> {
        let given = |key: &str| Ok(self.entry_of(node, key, own)?.unwrap_or(0.0));
        Ok(Acts::Spring {
            along,
            stiffness: given("stiffness")?,
            rest: given(rest)?,
            damping: given("damping")?,
        })
    }

    /// Along the first place's axes: E₁ᵀ (p₂ − p₁). The turn is θ₂ − θ₁ in the plane, in space the vector of the antisymmetric part of
    /// E₁ᵀ E₂, ½ (e₁ₖ·e₂ⱼ − e₁ⱼ·e₂ₖ).
    fn bushing(&self, node: &Value, own: &str) -> Read<Vec<Way>> {
        let (first, second) =
            (self.place(field(node, "first", own)?, own)?, self.place(field(node, "second", own)?, own)?);
        let (one, other) = (first.body, second.body);
        let turns = if self.spatial { 3 } else { 1 };
        let stiffness = self.diagonal(node, "stiffness", self.dimension(), own)?;
        let damping = self.diagonal(node, "damping", self.dimension(), own)?;
        let torsional = self.diagonal(node, "torsional_stiffness", turns, own)?;
        let torsional_damping = self.diagonal(node, "torsional_damping", turns, own)?;
        let mut ways = Vec::new();
        for k in 0..self.dimension() {
            let axis = column(&first.axes, k);
            let along = Quantity::Along { axis, first: first.clone(), second: second.clone() };
            let terms = vec![(1.0, along)];
            ways.push(Way { terms, wrapped: false, gap: 0.0, stiffness: stiffness[k], damping: damping[k] });
        }
        for k in 0..turns {
            let dot = |i: usize, j: usize| Quantity::Dot {
                first: Section::whole(one),
                a: column(&first.axes, i),
                second: Section::whole(other),
                b: column(&second.axes, j),
            };
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            let terms = if self.spatial {
                vec![(0.5, dot(j, i)), (-0.5, dot(i, j))]
            } else {
                let [first, second] = [Section::whole(one), Section::whole(other)];
                vec![(1.0, Quantity::PlaneAngle { first, second })]
            };
            let (stiffness, damping) = (torsional[k], torsional_damping[k]);
            ways.push(Way { terms, wrapped: !self.spatial, gap: 0.0, stiffness, damping });
        }
        Ok(ways)
    }

    /// One value for all axes or one for each; zero where it is not written.
    fn diagonal(&self, node: &Value, key: &str, count: usize, own: &str) -> Read<V3> {
        let Some(entry) = optional(node, key) else { return Ok([0.0; 3]) };
        let Some(values) = entry.get("value").and_then(Value::as_array) else {
            return Ok([self.entry(entry, own)?; 3]);
        };
        if values.len() != count {
            return Err(DefinitionError::malformed(own, key));
        }
        let unit = entry.get("unit").and_then(Value::as_str);
        let mut diagonal = [0.0; 3];
        for (component, value) in diagonal.iter_mut().zip(values) {
            *component = self.in_unit(value, unit, own)?;
        }
        Ok(diagonal)
    }

    fn cable(&self, node: &Value, own: &str) -> Read<Cable> {
        let mut places =
            vec![self.place(field(node, "first", own)?, own)?, self.place(field(node, "second", own)?, own)?];
        for further in list(node, "further", own)? {
            places.push(self.place(further, own)?);
        }
        let length = field(node, "length", own)?;
        let run = self.reading(own, May::Positions, |law| Ok(law.run(&places)))?;
        let stretch = self.reading(own, May::Positions, |law| {
            let run = law.run(&places);
            Ok(Expression::binary(Operator::Minus, run, law.entry(length)?))
        });
        let given = |key: &str| Ok(self.entry_of(node, key, own)?.unwrap_or(0.0));
        let pay_out = optional(node, "pay_out");
        let law = self.entry_law(length, own, May::Motion)?;
        if stretch.is_err() && !law.quantities.is_empty() {
            return Err(DefinitionError::not_there_yet(own, "a cable's length of both positions and inputs"));
        }
        Ok(Cable {
            run,
            own: law,
            // Where the length is of inputs, it is none of positions, and nothing winds the cable up but they.
            stretch: stretch.ok(),
            stiffness: given("stiffness")?,
            damping: given("damping")?,
            pay_out: pay_out.map(|rate| self.entry_law(rate, own, May::Motion)).transpose()?,
            smooth: given("smooth")?,
        })
    }
}

impl super::laws::LawReader<'_, '_> {
    /// The sum of the distances from place to place.
    fn run(&mut self, places: &[Place]) -> Expression {
        let mut run = Expression::Number(0.0);
        for pair in places.windows(2) {
            let [first, second] = [0, 1].map(|k| pair[k].clone());
            let length = self.leaf(Quantity::Length { first, second });
            run = Expression::binary(Operator::Plus, run, length);
        }
        run
    }
}
