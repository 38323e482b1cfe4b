//! What constraints hold to one another and what drivers move, as places and axes in a pose.

use super::sketch::{Drive, Driven, Link};
use super::stand::Stand;
use crate::drawing::Hinge;
use crate::model::{Constraint, ConstraintKind, Coordinate, Coupled, Driver, Quantity};

impl Stand<'_> {
    pub fn links(&mut self, hinges: &[Hinge]) -> Vec<Link> {
        let compiled = self.compiled;
        let link = |constraint: &Constraint| {
            let mut ends = Vec::new();
            match &constraint.kind {
                ConstraintKind::Coupling(coupling) => {
                    ends.extend(coupling.on.iter().map(|on| match on {
                        Coupled::Angle(rotor) => self.rotor(*rotor, hinges).0,
                        Coupled::Travel(joint) => hinges[joint.0].second,
                    }));
                }
                ConstraintKind::Teeth { on, .. } => {
                    ends.extend(on.iter().map(|id| self.place(&compiled.mechanism.toothing(*id).center)));
                }
                ConstraintKind::Equation { residual } => residual.quantities(&mut |quantity| {
                    if let Quantity::Coordinate(coordinate) = quantity {
                        match self.driven(coordinate, hinges) {
                            Some(Driven::Turn(at, _) | Driven::Way(at, _)) => ends.push(at),
                            Some(Driven::Between(first, second)) => ends.extend([first, second]),
                            None => {}
                        }
                    }
                }),
            }
            let is_of_teeth = matches!(constraint.kind, ConstraintKind::Teeth { .. });
            Link { name: constraint.name.text.clone(), ends, is_of_teeth }
        };
        compiled.mechanism.constraints.iter().map(link).collect()
    }

    pub fn drives(&mut self, hinges: &[Hinge]) -> Vec<Drive> {
        let drivers = &self.compiled.mechanism.drivers;
        let drive = |driver: &Driver| {
            let what = self.driven(&driver.coordinate, hinges)?;
            Some(Drive { name: driver.name.text.clone(), what })
        };
        drivers.iter().filter_map(drive).collect()
    }

    /// Where a measure of the position is seen; nowhere if it is a mode, or of an orientation alone.
    fn driven(&mut self, coordinate: &Coordinate, hinges: &[Hinge]) -> Option<Driven> {
        Some(match coordinate {
            Coordinate::Angle(rotor) => {
                let (at, about) = self.rotor(*rotor, hinges);
                Driven::Turn(at, about)
            }
            Coordinate::Travel(joint, _) => Driven::Way(hinges[joint.0].second, hinges[joint.0].axis),
            Coordinate::Position(place, axis) => {
                let mut along = [0.0; 3];
                along[*axis] = 1.0;
                Driven::Way(self.place(place), along)
            }
            Coordinate::Distance(first, second) | Coordinate::Square(first, second) => {
                Driven::Between(self.place(first), self.place(second))
            }
            Coordinate::Way(ends, _) => Driven::Between(self.place(&ends[0]), self.place(&ends[1])),
            Coordinate::Turn(body, axis) => {
                let (at, axes) = self.poses[body.0];
                Driven::Turn(at, axes[*axis])
            }
            Coordinate::Direction(..)
            | Coordinate::Deviation(..)
            | Coordinate::Closing(..)
            | Coordinate::Mode(..) => return None,
        })
    }
}
