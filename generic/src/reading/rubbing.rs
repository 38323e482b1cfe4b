//! Where contacts touch, and how their surfaces slide there.

use super::contacts::two;
use super::laws::{LawReader, May};
use super::pairs::Between;
use super::{Read, Reader};
use crate::error::DefinitionError;
use crate::expression::{Expression, Operator};
use crate::json::{name, optional};
use crate::kinematics::Place;
use crate::law::{Law, Rate};
use crate::rubbing::{At, Meets, Slides, Sliding, Spot};

impl Reader<'_> {
    /// Where a contact may touch, how it slides there, and what presses.
    pub(super) fn spots(&self, own: &str) -> Read<Vec<Spot>> {
        let touching = self.touching(own)?.into_iter().enumerate();
        let spot = |(which, meeting)| {
            let node = self.contact_named(own)?.ok_or_else(|| DefinitionError::unknown(own, own))?;
            // What pulls presses nothing.
            let force = self.reading(own, May::Motion, |law| {
                Ok(two(Operator::Max, law.force(node, own, which)?, Expression::Number(0.0)))
            })?;
            Ok(Spot { meeting, force })
        };
        touching.map(spot).collect()
    }

    /// Where a contact may touch, and how it slides there.
    fn touching(&self, own: &str) -> Read<Vec<Meets>> {
        let node = self.contact_named(own)?.ok_or_else(|| DefinitionError::unknown(own, own))?;
        let own = name(node, own)?;
        let slip = match optional(node, "slip") {
            Some(entry) => Some(self.reading(own, May::Positions, |law| law.entry(entry))?),
            None => None,
        };
        let mut touching = Vec::new();
        for which in 0..self.count(node, own)? {
            let mut between = None;
            let gap = self.reading(own, May::Positions, |law| {
                let own = law.meetings(node, own)?.swap_remove(which);
                between = own.between;
                Ok(own.gap)
            })?;
            let slides = match (&slip, between) {
                (Some(slip), _) => Slides::Along(slip.clone()),
                (None, None) => return Err(DefinitionError::value(own, "nothing slides in it")),
                (None, Some(Between { first, second, radius, reversed })) => {
                    let at = match radius {
                        Some(radius) => At::Under(radius),
                        None => {
                            let mut point = [0, 1, 2].map(|_| Law::constant(0.0));
                            for (k, own_point) in point.iter_mut().enumerate() {
                                *own_point = self.reading(own, May::Positions, |law| {
                                    let meeting = law.meetings(node, own)?.swap_remove(which);
                                    let none = || DefinitionError::value(own, "it touches at no place");
                                    Ok(meeting.point.ok_or_else(none)?[k].clone())
                                })?;
                            }
                            At::World(Box::new(point))
                        }
                    };
                    let is_particle =
                        |place: &Place| place.body.is_some_and(|body| self.bodies[body].particle);
                    let particles = [is_particle(&first), is_particle(&second)];
                    Slides::Surfaces { first, second, at, particles, reversed }
                }
            };
            touching.push(Meets { gap, slides });
        }
        Ok(touching)
    }
}

impl LawReader<'_, '_> {
    /// At each of its gaps: along an axis of the world, or its only component.
    pub(super) fn sliding(&mut self, own: &str, axis: Option<usize>) -> Read<Vec<Expression>> {
        if self.may < May::Motion {
            return Err(DefinitionError::unknown(self.part, own));
        }
        let touching = self.reader.touching(own)?.into_iter();
        let along = touching.map(|meets| {
            self.law.rates.push(Rate::Sliding(Box::new(Sliding { meets, axis })));
            Expression::Rate(self.law.rates.len() - 1)
        });
        Ok(along.collect())
    }
}
