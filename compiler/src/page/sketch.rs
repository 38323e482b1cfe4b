//! What a drawing shows, as numbers: where bodies, joints and loads stand in a pose, in world axes. How they look is
//! left to `figure`.

use super::figure::extent;
use super::stand::{Pose, Stand};
use super::surfaces::{Bounds, Skin};
use crate::compiled::Compiled;
use crate::drawing::Hinge;
pub use crate::drawing::load::Effort;
use crate::drawing::vector::{Point, difference, length, sum};
use crate::equations::loads::{self, LoadKind};
use crate::forms::BodyForm;
use crate::forms::Spans;
use crate::model::{Frame, Space};

/// A mechanism in a pose.
pub struct Sketch {
    pub space: Space,
    /// Against gravity, or the usual way up.
    pub up: Point,
    pub parts: Vec<Part>,
    pub hinges: Vec<Hinge>,
    pub efforts: Vec<(&'static LoadKind, Effort)>,
    pub wheels: Vec<Wheel>,
    pub links: Vec<Link>,
    pub skins: Vec<Skin>,
    pub drives: Vec<Drive>,
    /// How many times as large deflections are shown.
    pub times: f64,
}

/// What a constraint holds to one another: of each a place and, where it turns or travels, its axis.
#[derive(Clone, Debug)]
pub struct Link {
    pub name: String,
    pub ends: Vec<Point>,
    /// Whether toothings, which are drawn themselves, are what it holds.
    pub is_of_teeth: bool,
}

/// What a driver moves.
#[derive(Clone, Debug)]
pub struct Drive {
    pub name: String,
    pub what: Driven,
}

/// A motion that a driver prescribes.
#[derive(Clone, Copy, Debug)]
pub enum Driven {
    /// About an axis through a place.
    Turn(Point, Point),
    /// Along an axis.
    Way(Point, Point),
    Between(Point, Point),
}

/// A body.
#[derive(Clone, Debug)]
pub struct Part {
    pub name: String,
    pub form: &'static BodyForm,
    pub center: Point,
    /// Its x, y and z.
    pub axes: [Point; 3],
    /// Lengths of its shape, in the order of the model.
    pub lengths: Vec<f64>,
    /// Where something acts on it, and its named points; no two the same.
    pub spots: Vec<Point>,
    /// Of what deforms: its lines as they are bent, and their ends in its frame where that differs from it.
    pub lines: Vec<Vec<Point>>,
    pub straight: Option<Vec<[Point; 2]>>,
    /// How many joints it has, and whether one of them draws a block in its place.
    pub joints: usize,
    pub is_block: bool,
}

/// A circle of a gear wheel or pinion.
#[derive(Clone, Debug)]
pub struct Wheel {
    pub of: String,
    /// What turns.
    pub on: Frame,
    /// Which of its circles.
    pub circle: &'static str,
    pub center: Point,
    pub about: Point,
    pub radius: f64,
}

/// In space two long parts slide in each other somewhere between their ends; a rod is between its places.
fn settle(hinge: &mut Hinge, parts: &[Part], space: Space) {
    let middle = sum(hinge.first, hinge.second).map(|x| x / 2.0);
    if hinge.form.spans == Spans::Rod {
        hinge.at = middle;
    }
    let slides = hinge.form.spans == Spans::Rail && space == Space::Spatial;
    if let (true, Frame::Body(_), Frame::Body(second)) = (slides, hinge.first_on, hinge.second_on)
        && parts[second.0].spots.len() > 1
    {
        hinge.at = middle;
    }
}

impl Sketch {
    pub fn of(compiled: &Compiled, pose: &Pose) -> Sketch {
        Sketch::reaching(compiled, pose, std::iter::empty())
    }

    /// With surfaces that reach as far as these points too.
    pub fn reaching(compiled: &Compiled, pose: &Pose, points: impl Iterator<Item = Point>) -> Sketch {
        let mut stand = Stand::of(compiled, pose);
        let mechanism = &compiled.mechanism;
        let mut hinges: Vec<Hinge> = mechanism.joints.iter().map(|joint| stand.hinge(joint)).collect();
        let mut parts: Vec<Part> =
            mechanism.bodies.iter().enumerate().map(|(index, body)| stand.part(index, body)).collect();
        for hinge in &hinges {
            for frame in [hinge.first_on, hinge.second_on] {
                if let Frame::Body(body) = frame {
                    parts[body.0].joints += 1;
                    parts[body.0].is_block |= hinge.form.is_block() && frame == hinge.second_on;
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
            let is_on_line = hinge.form.spans == Spans::Line;
            let carried_elsewhere = hinge.form.is_block() || is_on_line;
            if is_on_line {
                touch(hinge.first_on, sum(hinge.first, hinge.axis));
            }
            if !carried_elsewhere || hinge.second_on != Frame::Ground {
                touch(hinge.second_on, hinge.second);
            }
        }
        for load in &mechanism.loads {
            for place in load.places() {
                touch(place.frame, stand.place(place));
            }
        }
        for hinge in &mut hinges {
            settle(hinge, &parts, mechanism.space);
        }
        let efforts =
            mechanism.loads.iter().map(|load| (loads::of(load.form), stand.effort(load, &hinges))).collect();
        let wheels = stand.wheels(&hinges);
        let (links, drives) = (stand.links(&hinges), stand.drives(&hinges));
        let (space, up, times) = (mechanism.space, stand.up(), stand.times);
        let mut sketch =
            Sketch { space, up, parts, hinges, efforts, wheels, links, skins: Vec::new(), drives, times };
        sketch.skins = stand.skins(&Bounds::of(extent(&sketch).into_iter().chain(points)));
        sketch
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
