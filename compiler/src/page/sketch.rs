//! What a drawing shows, as numbers: where bodies, joints and loads stand at the start, in world axes. How they look is
//! left to `figure`.

use super::stand::Stand;
use super::vector::{Point, difference, length, sum};
use crate::Compiled;
use crate::model::{Frame, JointWord, LoadKind, Place, Shape, Space};

/// A mechanism at its start.
#[derive(Clone, Debug)]
pub struct Sketch {
    pub space: Space,
    /// Against gravity, or the usual way up.
    pub up: Point,
    pub parts: Vec<Part>,
    pub hinges: Vec<Hinge>,
    pub efforts: Vec<Effort>,
    pub wheels: Vec<Wheel>,
}

/// A body.
#[derive(Clone, Debug)]
pub struct Part {
    pub name: String,
    pub shape: Shape,
    pub center: Point,
    /// Its x, y and z.
    pub axes: [Point; 3],
    /// Lengths of its shape, in the order of the model.
    pub lengths: Vec<f64>,
    /// Where something acts on it, and its named points; no two the same.
    pub spots: Vec<Point>,
    /// How many joints it has, and whether one of them draws a block in its place.
    pub joints: usize,
    pub is_block: bool,
}

/// A joint.
#[derive(Clone, Debug)]
pub struct Hinge {
    pub name: String,
    pub kind: JointWord,
    pub first: Point,
    pub second: Point,
    pub first_on: Frame,
    pub second_on: Frame,
    /// Along the joint's axis, of length one; along the line of `point_on_line`, as long as that.
    pub axis: Point,
    /// Of a universal joint.
    pub second_axis: Point,
    /// Where its symbol stands.
    pub at: Point,
}

/// A load.
#[derive(Clone, Debug)]
pub struct Effort {
    pub name: String,
    pub kind: EffortKind,
}

#[derive(Clone, Debug)]
pub enum EffortKind {
    /// Along a unit vector.
    Force {
        at: Point,
        along: Point,
    },
    Torque {
        at: Point,
        about: Point,
    },
    Spring {
        ends: [End; 2],
        is_elastic: bool,
        is_damped: bool,
    },
    TorsionSpring {
        at: Point,
        about: Point,
    },
}

/// An end of a spring.
#[derive(Clone, Copy, Debug)]
pub struct End {
    pub at: Point,
    pub is_grounded: bool,
}

/// The pitch circle of a gear wheel or pinion.
#[derive(Clone, Debug)]
pub struct Wheel {
    pub of: String,
    pub center: Point,
    pub about: Point,
    pub radius: f64,
}

impl Hinge {
    pub fn is_grounded(&self) -> bool {
        self.first_on == Frame::Ground || self.second_on == Frame::Ground
    }

    /// In space two long parts slide in each other somewhere between their ends; a distance is between its places.
    fn settle(&mut self, parts: &[Part], space: Space) {
        if self.kind == JointWord::Distance {
            self.at = sum(self.first, self.second).map(|x| x / 2.0);
        }
        let slides = matches!(self.kind, JointWord::Prismatic | JointWord::Cylindrical | JointWord::Screw)
            && space == Space::Spatial;
        if let (true, Frame::Body(_), Frame::Body(second)) = (slides, self.first_on, self.second_on)
            && parts[second.0].spots.len() > 1
        {
            self.at = sum(self.first, self.second).map(|x| x / 2.0);
        }
    }
}

impl Sketch {
    pub fn of(compiled: &Compiled) -> Sketch {
        let mut stand = Stand::of(compiled);
        let mechanism = &compiled.mechanism;
        let mut hinges: Vec<Hinge> = mechanism.joints.iter().map(|joint| stand.hinge(joint)).collect();
        let mut parts: Vec<Part> =
            mechanism.bodies.iter().enumerate().map(|(index, body)| stand.part(index, body)).collect();
        for hinge in &hinges {
            for frame in [hinge.first_on, hinge.second_on] {
                if let Frame::Body(body) = frame {
                    parts[body.0].joints += 1;
                    parts[body.0].is_block |= hinge.kind == JointWord::Prismatic && frame == hinge.second_on;
                }
            }
        }
        let mut touch = |frame: Frame, at: Point| {
            if let Frame::Body(body) = frame {
                parts[body.0].touch(at);
            }
        };
        for hinge in &hinges {
            touch(hinge.first_on, hinge.first);
            let carried_elsewhere = matches!(hinge.kind, JointWord::Prismatic | JointWord::PointOnLine);
            if hinge.kind == JointWord::PointOnLine {
                touch(hinge.first_on, sum(hinge.first, hinge.axis));
            }
            if !carried_elsewhere || hinge.second_on != Frame::Ground {
                touch(hinge.second_on, hinge.second);
            }
        }
        for load in &mechanism.loads {
            for place in places(&load.kind) {
                touch(place.frame, stand.place(place));
            }
        }
        for hinge in &mut hinges {
            hinge.settle(&parts, mechanism.space);
        }
        let efforts = mechanism.loads.iter().filter_map(|load| stand.effort(load, &hinges)).collect();
        let wheels = stand.wheels(&hinges);
        Sketch { space: mechanism.space, up: stand.up(), parts, hinges, efforts, wheels }
    }
}

impl Part {
    /// Something acts on it there.
    pub fn touch(&mut self, at: Point) {
        let near = |spot: &Point| length(difference(*spot, at)) <= 1e-9 * (1.0 + length(at));
        if !self.spots.iter().any(near) {
            self.spots.push(at);
        }
    }
}

fn places(kind: &LoadKind) -> Vec<&Place> {
    match kind {
        LoadKind::Force { place, .. } => vec![place],
        LoadKind::Spring { first, second, .. } => vec![first, second],
        LoadKind::Push { .. }
        | LoadKind::Torque { .. }
        | LoadKind::BodyTorque { .. }
        | LoadKind::TorsionSpring { .. } => Vec::new(),
    }
}
