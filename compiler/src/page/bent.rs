//! What bends of the bodies in a picture: how their lines are shown, and their modes in a pose.

use super::net::{Gripped, Net};
use crate::beams::{Bow, Held};
use crate::compiled::Compiled;
use crate::drawing::vector::Point;
use crate::equations::Linear;
use crate::model::{BodyId, Deforms, Frame, Joint, Place, fold};

/// What is seen of a bent line, of the length, against one that is straight.
const SEEN: f64 = 2e-3;

/// A body that deforms.
#[derive(Clone, Debug)]
pub struct Bent {
    lines: Lines,
    /// Where its modes stand in q, and what they are.
    pub indices: Vec<usize>,
    pub modes: Vec<f64>,
}

/// What is drawn of it.
#[derive(Clone, Debug)]
enum Lines {
    /// The axis of a beam.
    Axis(Bow),
    /// Lines between the nodes of a file.
    Between(Net),
}

/// A place of what is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Station {
    /// x of a beam's axis, from the origin of the frame, m.
    X(f64),
    /// Of a net.
    Of(usize),
}

impl Bent {
    /// Of each body.
    pub fn of_all(compiled: &Compiled, q: &[f64]) -> Vec<Option<Self>> {
        let bodies = compiled.mechanism.bodies.iter().enumerate();
        bodies.map(|(index, body)| Self::new(compiled, index, body.deforms.as_ref()?, q)).collect()
    }

    fn new(compiled: &Compiled, body: usize, deforms: &Deforms, q: &[f64]) -> Option<Self> {
        let held = compiled.mechanism.joints.iter().flat_map(|joint| holds(joint, body));
        let lines = match deforms {
            Deforms::Beam(beam) => {
                let held = held.filter_map(|(at, turns_with)| Some(Held { x: at?[0], turns_with }));
                Lines::Axis(Bow::new(beam.slender.clone(), &held.collect::<Vec<_>>()))
            }
            Deforms::Modal(modal) => {
                let gripped = held.filter_map(|(at, turns_with)| {
                    Some(Gripped { node: modal.reduced.node_at(at?)?, turns_with })
                });
                Lines::Between(Net::new(&modal.reduced, &gripped.collect::<Vec<_>>())?)
            }
        };
        // Linear coordinates stand first in q, in the order of v.
        let linear = &compiled.complete.equations.layout.linear;
        let index = |mode: usize| linear.iter().position(|it| *it == Linear::Mode(BodyId(body), mode));
        let indices: Vec<usize> = (0..deforms.modes()).filter_map(index).collect();
        let modes = indices.iter().map(|index| q[*index]).collect();
        Some(Bent { lines, indices, modes })
    }

    /// All places of its lines, line after line.
    pub fn stations(&self) -> Vec<Station> {
        match &self.lines {
            Lines::Axis(bow) => bow.places().map(Station::X).collect(),
            Lines::Between(net) => (0..net.count()).map(Station::Of).collect(),
        }
    }

    /// How many stations each of its lines has.
    pub fn lines(&self) -> Vec<usize> {
        match &self.lines {
            Lines::Axis(bow) => vec![bow.places().count()],
            Lines::Between(net) => net.lines.clone(),
        }
    }

    /// Where something may stand, if that is drawn.
    pub fn station(&self, at: Point) -> Option<Station> {
        match &self.lines {
            Lines::Axis(_) => Some(Station::X(at[0])),
            Lines::Between(net) => net.station(at).map(Station::Of),
        }
    }

    /// Where a station is while nothing deforms, in the axes of the frame, from its origin.
    pub fn straight(&self, station: Station) -> Point {
        match (&self.lines, station) {
            (_, Station::X(x)) => [x, 0.0, 0.0],
            (Lines::Between(net), Station::Of(index)) => net.place(index),
            (Lines::Axis(_), Station::Of(_)) => [0.0; 3],
        }
    }

    /// Which modes are multiplied, and along which axis of the frame that moves places.
    pub fn terms(&self) -> Vec<(Vec<usize>, usize)> {
        match &self.lines {
            Lines::Axis(bow) => bow.terms().map(|(modes, along)| (modes.to_vec(), along)).collect(),
            Lines::Between(_) => {
                let modes = 0..self.modes.len();
                modes.flat_map(|mode| [0, 1, 2].map(|along| (vec![mode], along))).collect()
            }
        }
    }

    /// How far each term moves what is shown of a station, with what is beyond the joints so many times as large.
    pub fn factors(&self, station: Station, times: f64) -> Vec<f64> {
        match (&self.lines, station) {
            (Lines::Axis(bow), station) => bow.factors(self.straight(station)[0], times),
            (Lines::Between(net), Station::Of(index)) => net.factors(index, times).concat(),
            (Lines::Between(_), Station::X(_)) => vec![0.0; 3 * self.modes.len()],
        }
    }

    /// What is shown of a station, in the axes of the frame, from its origin.
    pub fn shown(&self, station: Station, times: f64) -> Point {
        let mut at = self.straight(station);
        for ((modes, along), factor) in self.terms().iter().zip(self.factors(station, times)) {
            at[*along] += factor * modes.iter().map(|mode| self.modes[*mode]).product::<f64>();
        }
        at
    }

    /// The largest deflection that is magnified, of the length.
    pub fn deflection(&self) -> f64 {
        self.deflection_with(&self.modes)
    }

    /// The same in other positions.
    pub fn deflection_at(&self, q: &[f64]) -> f64 {
        self.deflection_with(&self.indices.iter().map(|index| q[*index]).collect::<Vec<_>>())
    }

    fn deflection_with(&self, modes: &[f64]) -> f64 {
        match &self.lines {
            Lines::Axis(bow) => bow.deflection(modes),
            Lines::Between(net) => net.deflection(modes),
        }
    }

    /// Whether it looks bent.
    pub fn is_seen(&self, times: f64) -> bool {
        times * self.deflection() > SEEN
    }
}

/// Where a joint holds a body, if that is known, and whether it holds its direction there.
fn holds(joint: &Joint, body: usize) -> impl Iterator<Item = (Option<Point>, bool)> + '_ {
    let turns_with = joint.form.keeps_orientation;
    let is_on = move |place: &&Place| place.frame == Frame::Body(BodyId(body));
    [&joint.first, &joint.second].into_iter().filter(is_on).map(move |place| (known(place), turns_with))
}

/// Where a place is on its body, if no parameter says it.
pub fn known(place: &Place) -> Option<Point> {
    let [x, y, z] = place.at.each_ref().map(|component| fold::evaluate(component, &[]));
    Some([x?, y?, z?])
}
