//! Loads: forces, torques, springs. Directions become unit vectors here.

use super::fold;
use super::lower::{Lowering, Use, name};
use super::{Expr, Function1, Function2, Load, LoadKind, Place};
use crate::messages;
use crate::syntax::{self, Entry, LoadTerm, Pair, PlaceTerm};
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
                let [x, y] = direction?;
                let along = |component| fold::binary(Function2::Mul, value.clone(), component);
                LoadKind::Force { place: place?, components: [along(x), along(y)] }
            }
            LoadTerm::Components { place, components } => {
                let place = self.place(place);
                let components =
                    self.pair(components, Dimension::FORCE, Use::LOAD, &messages::quoted(&load.name.text));
                LoadKind::Force { place: place?, components: components? }
            }
            LoadTerm::Torque { on, value } => {
                let on = self.rotor(on);
                let value = self.value(value, Use::LOAD);
                let torque =
                    self.expect_dimension(value?, Dimension::TORQUE, &messages::quoted(&load.name.text));
                LoadKind::Torque { on: on?, torque: torque? }
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

    /// Two components of any one dimension, of which only the ratio matters; not both zero.
    pub fn direction(&mut self, pair: &'d Pair, what: &str) -> Option<[Expr; 2]> {
        let [x, y] = match &pair.unit {
            Some(unit) => self.pair(pair, unit.unit.dimension, Use::DIRECTION, what)?,
            None => {
                let x = self.value(&pair.values[0], Use::DIRECTION);
                let y = self.value(&pair.values[1], Use::DIRECTION);
                let (x, y) = (x?, y?);
                self.same(&x, &y, &format!("the components of the {what}"))?;
                [x.expr, y.expr]
            }
        };
        if let (Expr::Number(x), Expr::Number(y)) = (&x, &y)
            && libm::hypot(*x, *y) == 0.0
        {
            self.diagnostics.error(pair.region, messages::zero_direction(what));
            return None;
        }
        Some([x, y])
    }
}

/// x/√(x² + y²), y/√(x² + y²).
fn normalised([x, y]: [Expr; 2]) -> [Expr; 2] {
    if let (Expr::Number(a), Expr::Number(b)) = (&x, &y) {
        let length = libm::hypot(*a, *b);
        return [Expr::Number(a / length), Expr::Number(b / length)];
    }
    let square = |value: &Expr| fold::binary(Function2::Mul, value.clone(), value.clone());
    let length = fold::unary(Function1::Sqrt, fold::binary(Function2::Add, square(&x), square(&y)));
    [fold::binary(Function2::Div, x, length.clone()), fold::binary(Function2::Div, y, length)]
}
