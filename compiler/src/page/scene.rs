//! What is drawn of a mechanism in motion: shapes, joints and loads in the axes of the bodies that they move with. Where the bodies are
//! at a time is told by `motions`; how it looks is left to those who draw.

use super::sketch::{Part, Sketch};
use super::stand::Pose;
use crate::compiled::Compiled;
use crate::drawing::vector::{Point, difference, dot};
use crate::forms::{Outline, Spans};
use crate::model::{Frame, Load, Rotor, Space, Subject};

/// A point of the ground, or of a body from its centre of mass, in its axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// Index of the body; the ground if none.
    pub body: Option<usize>,
    pub at: Point,
}

/// A mechanism, to be drawn at any time.
#[derive(Clone, Debug)]
pub struct Scene {
    pub is_planar: bool,
    /// Against gravity.
    pub up: Point,
    pub bodies: Vec<Shape>,
    pub joints: Vec<Joint>,
    pub loads: Vec<Line>,
    pub wheels: Vec<Wheel>,
}

/// A body.
#[derive(Clone, Debug)]
pub struct Shape {
    pub name: String,
    /// `disk`, `ball`, `box`, or `bar` for all that is what lies between its spots.
    pub outline: &'static str,
    /// Radius, or edges.
    pub lengths: Vec<f64>,
    /// Where something acts on it, from its centre of mass, in its axes.
    pub spots: Vec<Point>,
    pub turns: bool,
}

/// A joint.
#[derive(Clone, Debug)]
pub struct Joint {
    pub name: String,
    pub kind: &'static str,
    pub first: Spot,
    pub second: Spot,
    /// Along its axis, or its line, in the axes of the first place.
    pub axis: Point,
    /// Whether something slides along the axis.
    pub slides: bool,
}

/// A load, between places or at one.
#[derive(Clone, Debug)]
pub struct Line {
    pub name: String,
    pub kind: &'static str,
    pub ends: Vec<Spot>,
}

/// The pitch circle of a gear wheel, about an axis of the world at the start.
#[derive(Clone, Debug)]
pub struct Wheel {
    pub of: String,
    pub center: Spot,
    pub about: Point,
    pub radius: f64,
}

/// The scene with the parameters of a pose.
pub fn scene(compiled: &Compiled, pose: &Pose) -> Scene {
    let sketch = Sketch::of(compiled, pose);
    let parts = &sketch.parts;
    let bodies = parts.iter().map(shape).collect();
    let joints = compiled.mechanism.joints.iter().zip(&sketch.hinges).map(|(joint, hinge)| Joint {
        name: hinge.name.clone(),
        kind: joint.form.call.word,
        first: spot(parts, hinge.first_on, hinge.first),
        second: spot(parts, hinge.second_on, hinge.second),
        axis: way(parts, hinge.first_on, hinge.axis),
        slides: matches!(hinge.form.spans, Spans::Rail | Spans::Line),
    });
    let loads = compiled.mechanism.loads.iter().zip(&sketch.efforts).map(|(load, (_, effort))| {
        let ends = frames(compiled, load).zip(&effort.ends).map(|(frame, end)| spot(parts, frame, end.at));
        Line { name: effort.name.clone(), kind: load.form.call.word, ends: ends.collect() }
    });
    let wheels = sketch.wheels.iter().map(|wheel| Wheel {
        of: wheel.of.clone(),
        center: spot(parts, wheel.on, wheel.center),
        about: way(parts, wheel.on, wheel.about),
        radius: wheel.radius,
    });
    Scene {
        is_planar: sketch.space == Space::Planar,
        up: sketch.up,
        joints: joints.collect(),
        loads: loads.collect(),
        wheels: wheels.collect(),
        bodies,
    }
}

fn shape(part: &Part) -> Shape {
    let outline = match (part.form.outline, part.lengths.len()) {
        (Outline::Disk, 1..) => "disk",
        (Outline::Ball, 1..) => "ball",
        (Outline::Box, 2..) => "box",
        _ => "bar",
    };
    let local = |at: &Point| part.axes.map(|axis| dot(axis, difference(*at, part.center)));
    Shape {
        name: part.name.clone(),
        outline,
        lengths: part.lengths.clone(),
        spots: part.spots.iter().map(local).collect(),
        turns: part.form.turns,
    }
}

fn spot(parts: &[Part], frame: Frame, at: Point) -> Spot {
    match frame {
        Frame::Ground => Spot { body: None, at },
        Frame::Body(body) => {
            let part = &parts[body.0];
            let at = part.axes.map(|axis| dot(axis, difference(at, part.center)));
            Spot { body: Some(body.0), at }
        }
    }
}

fn way(parts: &[Part], frame: Frame, along: Point) -> Point {
    match frame {
        Frame::Ground => along,
        Frame::Body(body) => parts[body.0].axes.map(|axis| dot(axis, along)),
    }
}

/// What the ends of a load move with.
fn frames(compiled: &Compiled, load: &Load) -> impl Iterator<Item = Frame> {
    load.on.iter().filter_map(|subject| match subject {
        Subject::Expression(..) | Subject::Touches(_) => None,
        Subject::Place(place) => Some(place.frame),
        Subject::Rotor(Rotor::Joint(joint, _)) | Subject::Travel(joint) | Subject::Bearing(joint, _) => {
            Some(compiled.mechanism.joints[joint.0].second.frame)
        }
        Subject::Rotor(Rotor::Body(body)) | Subject::Body(body) => Some(Frame::Body(*body)),
        Subject::Toothing(id) => Some(Frame::Body(id.body)),
    })
}
