//! Positions from which assembly is tried: what `start` and the drivers state or guess, the rest at zero first and later varied.

mod plane;
mod space;

use super::point::{Ancestry, Point};
use crate::equations::{Equations, Linear};
use crate::model::{Coordinate, Frame, JointId, Mechanism, Rotor, Space};
use std::collections::BTreeMap;

/// Turns by multiples of the golden angle never repeat.
const GOLDEN: f64 = 2.399963229728653;
/// Positions of a search until guesses are varied over the whole circle.
const FAR: f64 = 16.0;

/// How far a position lies from `start` as written.
#[derive(Clone, Copy, Debug)]
pub enum Variation {
    /// One of a few: coordinates that are not stated are turned by the golden angle, each by a different multiple.
    Few(usize),
    /// One of many that fill the space of coordinates evenly, first near the guesses and later anywhere.
    Many {
        number: usize,
        /// The dimensions of the space.
        dimensions: usize,
        /// For travels and places, m.
        length: f64,
        /// Coordinates that `start` states are varied too.
        stated: bool,
    },
}

/// Gives the variation of one coordinate after the other.
struct Offsets {
    variation: Variation,
    free: usize,
    ratio: f64,
}

impl Offsets {
    fn new(variation: Variation) -> Self {
        let mut ratio = 1.5_f64;
        if let Variation::Many { dimensions, .. } = variation {
            // The root of x^(d + 1) = x + 1, which is the golden ratio for one dimension.
            for _ in 0..40 {
                ratio = libm::pow(1.0 + ratio, 1.0 / (dimensions as f64 + 1.0));
            }
        }
        Offsets { variation, free: 0, ratio }
    }

    /// Whether coordinates are varied of which `start` says something.
    fn varies(&self, exact: bool) -> bool {
        match self.variation {
            Variation::Few(number) => number > 0 && !exact,
            Variation::Many { stated, .. } => stated || !exact,
        }
    }

    /// A sample of an angle, by Kronecker's sequence n φ^(−j), whose points are spread evenly in any number of
    /// dimensions (Roberts, The unreasonable effectiveness of quasirandom sequences, 2018).
    fn turn(&mut self, guessed: bool) -> f64 {
        match self.variation {
            Variation::Few(number) => {
                self.free += 1;
                GOLDEN * (number * self.free) as f64
            }
            Variation::Many { number, .. } => {
                let spread = if guessed { ((number + 1) as f64 / FAR).min(1.0) } else { 1.0 };
                spread * std::f64::consts::PI * self.even(number)
            }
        }
    }

    /// A sample of a travel or a place.
    fn shift(&mut self) -> f64 {
        match self.variation {
            Variation::Few(_) => 0.0,
            Variation::Many { number, length, .. } => length * self.even(number),
        }
    }

    /// In (−1, 1), zero for the first position.
    fn even(&mut self, number: usize) -> f64 {
        self.free += 1;
        let part = 0.5 + number as f64 * libm::pow(self.ratio, -(self.free as f64));
        2.0 * (part - part.floor()) - 1.0
    }
}

/// Values that `start` and the drivers give to coordinates.
pub struct Stated {
    angles: BTreeMap<(JointId, usize), f64>,
    bodies: BTreeMap<usize, f64>,
    travels: BTreeMap<(JointId, usize), f64>,
    centers: BTreeMap<(usize, usize), f64>,
    /// Modes of beams.
    modes: BTreeMap<(usize, usize), f64>,
}

impl Stated {
    pub fn of(equations: &Equations, point: &mut Point) -> Self {
        let mut stated = Stated {
            angles: BTreeMap::new(),
            bodies: BTreeMap::new(),
            travels: BTreeMap::new(),
            centers: BTreeMap::new(),
            modes: BTreeMap::new(),
        };
        let exact = equations.conditions.with_start();
        let exact = exact.filter_map(|(condition, start)| Some((condition, start.position?)));
        let guessed = equations.guesses.iter().chain(&equations.driven);
        let guessed = guessed.map(|(condition, node)| (condition, *node));
        for (condition, node) in guessed.chain(exact) {
            point.evaluate(&Ancestry::of(equations, [node]));
            let value = point.get(node);
            match &condition.coordinate {
                Coordinate::Angle(Rotor::Joint(joint, which)) => {
                    stated.angles.insert((*joint, *which), value);
                }
                Coordinate::Angle(Rotor::Body(body)) => {
                    stated.bodies.insert(body.0, value);
                }
                Coordinate::Travel(joint, which) => {
                    stated.travels.insert((*joint, *which), value);
                }
                Coordinate::Position(place, axis) => {
                    if let Frame::Body(body) = place.frame {
                        stated.centers.insert((body.0, *axis), value);
                    }
                }
                Coordinate::Mode(body, mode, _) => {
                    stated.modes.insert((body.0, usize::from(*mode)), value);
                }
                Coordinate::Distance(..)
                | Coordinate::Way(..)
                | Coordinate::Square(..)
                | Coordinate::Direction(..)
                | Coordinate::Turn(..)
                | Coordinate::Closing(..)
                | Coordinate::Deviation(..) => {}
            }
        }
        stated
    }

    /// Tree coordinates as `start` has them, varied.
    pub fn initial(&self, mechanism: &Mechanism, point: &mut Point, variation: Variation) -> Vec<f64> {
        let offsets = Offsets::new(variation);
        match mechanism.space {
            Space::Planar => plane::initial(self, mechanism, point.equations, offsets),
            Space::Spatial => space::initial(self, mechanism, point, offsets),
        }
    }

    /// Travels, and the centres of free bodies.
    fn lengths(&self, equations: &Equations, offsets: &mut Offsets) -> Vec<f64> {
        let length = |linear: &Linear| {
            let given = match linear {
                // A beam is not bent at random.
                Linear::Mode(body, mode) => return self.modes.get(&(body.0, *mode)).copied().unwrap_or(0.0),
                Linear::Center(body, axis) => self.centers.get(&(body.0, *axis)),
                Linear::Travel(joint, which) => self.travels.get(&(*joint, *which)),
            };
            let exact = is_exact(equations, |coordinate| match (coordinate, linear) {
                (Coordinate::Travel(joint, which), Linear::Travel(own, own_which)) => {
                    joint == own && which == own_which
                }
                _ => false,
            });
            let shift = if offsets.varies(exact) { offsets.shift() } else { 0.0 };
            given.copied().unwrap_or(0.0) + shift
        };
        equations.layout.linear.iter().map(length).collect()
    }
}

/// Whether `start` states such a coordinate, and does not only guess it.
fn is_exact(equations: &Equations, is: impl Fn(&Coordinate) -> bool) -> bool {
    let exact = equations.conditions.with_start();
    exact.filter(|(_, start)| start.position.is_some()).any(|(condition, _)| is(&condition.coordinate))
}
