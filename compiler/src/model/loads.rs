//! Loads: forces, torques, springs. Directions become unit vectors here.

use super::fold;
use super::lower::{Lowering, Use, name};
use super::names::Part;
use super::values::padded;
use super::{Expr, Function1, Function2, Load, LoadKind, Place, Vector};
use crate::messages;
use crate::syntax::{self, Entry, LoadTerm, PlaceTerm, Space, Tuple};
use crate::units::Dimension;

impl<'d> Lowering<'d> {
    pub fn load(&mut self, load: &'d syntax::Load) -> Option<Load> {
        let kind = match &load.kind {
            LoadTerm::Force { place, direction, value } => {
                let place = self.place(place);
                let direction = self.direction(direction, "direction").map(normalised);
                let value = self.value(value, Use::LOAD);
                let value =
                    self.expect_dimension(value?, Dimension::FORCE, &messages::quoted(&load.name.text))?;
                let along = |component| fold::binary(Function2::Mul, value.clone(), component);
                LoadKind::Force { place: place?, components: direction?.map(along) }
            }
            LoadTerm::Components { place, components } => {
                let place = self.place(place);
                let components =
                    self.vector(components, Dimension::FORCE, Use::LOAD, &messages::quoted(&load.name.text));
                LoadKind::Force { place: place?, components: components? }
            }
            LoadTerm::Push { on, value } => {
                let joint = self.slide(on);
                let value = self.value(value, Use::LOAD);
                let force =
                    self.expect_dimension(value?, Dimension::FORCE, &messages::quoted(&load.name.text));
                LoadKind::Push { joint: joint?, force: force? }
            }
            LoadTerm::Torque { on, value } => {
                if let (Space::Spatial, Some(Part::Body(_))) =
                    (self.definition.space, self.names.part(&on.text))
                {
                    self.diagnostics.error(on.region, messages::torque_of_components(&on.text));
                    return None;
                }
                let on = self.rotor(on);
                let value = self.value(value, Use::LOAD);
                let torque =
                    self.expect_dimension(value?, Dimension::TORQUE, &messages::quoted(&load.name.text));
                LoadKind::Torque { on: on?, torque: torque? }
            }
            LoadTerm::BodyTorque { on, components } => {
                let body = self.turning_body(on);
                let what = messages::quoted(&load.name.text);
                let components = self.vector(components, Dimension::TORQUE, Use::LOAD, &what);
                LoadKind::BodyTorque { body: body?, components: components? }
            }
            LoadTerm::Spring { first, second, stiffness, length, damping } => {
                let places = self.spring_ends(first, second);
                let stiffness = self.entry(stiffness, Dimension::STIFFNESS, Use::COEFFICIENT, "stiffness");
                let length = self.entry(length, Dimension::LENGTH, Use::COEFFICIENT, "length");
                let damping = self.optional(damping.as_ref(), Dimension::DAMPING, "damping");
                let (first, second) = places?;
                LoadKind::Spring { first, second, stiffness: stiffness?, length: length?, damping: damping? }
            }
            LoadTerm::Damper { first, second, damping } => {
                let places = self.spring_ends(first, second);
                let damping = self.entry(damping, Dimension::DAMPING, Use::COEFFICIENT, "damping");
                let (first, second) = places?;
                let none = Expr::Number(0.0);
                LoadKind::Spring { first, second, stiffness: none.clone(), length: none, damping: damping? }
            }
            LoadTerm::TorsionSpring { on, stiffness, angle, damping } => {
                let on = self.rotor(on);
                let stiffness = self.entry(stiffness, Dimension::TORQUE, Use::COEFFICIENT, "stiffness");
                let rest = self.optional(angle.as_ref(), Dimension::ANGLE, "angle");
                let damping = self.optional(damping.as_ref(), Dimension::ANGULAR_DAMPING, "damping");
                LoadKind::TorsionSpring { on: on?, stiffness: stiffness?, rest: rest?, damping: damping? }
            }
        };
        Some(Load { name: name(&load.name), kind })
    }

    /// Zero where it was not given.
    fn optional(&mut self, entry: Option<&'d Entry>, dimension: Dimension, what: &str) -> Option<Expr> {
        match entry {
            Some(entry) => self.entry(entry, dimension, Use::COEFFICIENT, what),
            None => Some(Expr::Number(0.0)),
        }
    }

    fn spring_ends(&mut self, first: &'d PlaceTerm, second: &'d PlaceTerm) -> Option<(Place, Place)> {
        let region = first.region().to(second.region());
        let (first, second) = (self.place(first), self.place(second));
        let (first, second) = (first?, second?);
        if first.frame == second.frame {
            self.diagnostics.error(region, messages::spring_in_one_body(&first.text, &second.text));
            return None;
        }
        Some((first, second))
    }

    /// Components of any one dimension, of which only the ratios matter; not all zero.
    pub fn direction(&mut self, tuple: &'d Tuple, what: &str) -> Option<Vector> {
        let direction = match &tuple.unit {
            Some(unit) => self.vector(tuple, unit.unit.dimension, Use::DIRECTION, what)?,
            None => {
                let values: Vec<_> =
                    tuple.values.iter().map(|value| self.value(value, Use::DIRECTION)).collect();
                let values: Option<Vec<_>> = values.into_iter().collect();
                let values = values?;
                for value in &values[1..] {
                    self.same(&values[0], value, &format!("the components of the {what}"))?;
                }
                let components = values.into_iter().map(|value| self.in_range(value.expr, value.region));
                padded(components.collect::<Option<_>>()?)
            }
        };
        if direction.iter().all(|component| matches!(component, Expr::Number(0.0))) {
            self.diagnostics.error(tuple.region, messages::zero_direction(what, self.definition.space));
            return None;
        }
        Some(direction)
    }
}

/// x/|x|.
fn normalised(vector: Vector) -> Vector {
    if let [Expr::Number(x), Expr::Number(y), Expr::Number(z)] = &vector {
        let length = libm::hypot(libm::hypot(*x, *y), *z);
        return [x, y, z].map(|component| Expr::Number(component / length));
    }
    let square = |value: &Expr| fold::binary(Function2::Mul, value.clone(), value.clone());
    let sum = |a, b| fold::binary(Function2::Add, a, b);
    let length = sum(sum(square(&vector[0]), square(&vector[1])), square(&vector[2]));
    let length = fold::unary(Function1::Sqrt, length);
    vector.map(|component| fold::binary(Function2::Div, component, length.clone()))
}
