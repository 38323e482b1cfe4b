//! What is drawn of a mechanism in motion: shapes, joints and loads in the axes of the bodies that they move with. Where the bodies are
//! at a time is told by `motions`, and how those that deform are bent by their modes; how it looks is left to those who draw.

use super::bent::{Bent, Station, known};
use super::sketch::{Part, Sketch};
use super::stand::Pose;
use crate::beams::magnification;
use crate::compiled::Compiled;
use crate::drawing::vector::{Point, difference, dot};
use crate::forms::{Outline, Spans};
use crate::model::{Frame, Load, Place, Rotor, Space, Subject};

/// A point of the ground, or of a body from its centre of mass, in its axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// Index of the body; the ground if none.
    pub body: Option<usize>,
    pub at: Point,
    /// Which station of its body's lines it moves with, where they bend.
    pub station: Option<usize>,
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
    pub surfaces: Vec<Surface>,
    /// Where the modes of bodies stand in q, body after body.
    pub modes: Vec<usize>,
    /// How many times as large deflections are shown.
    pub times: f64,
}

/// The lines of what deforms, of a beam its axis: the mode or two modes of each bending, multiplied, times its factors are added to the stations.
#[derive(Clone, Debug)]
pub struct Lines {
    /// While they are straight, from the centre of mass, in the axes of the body; the first of them are the lines, others places on them.
    pub stations: Vec<Point>,
    /// How many stations each line has.
    pub counts: Vec<usize>,
    pub bendings: Vec<Bending>,
}

/// What one mode, or the product of two, does.
#[derive(Clone, Debug)]
pub struct Bending {
    /// Among those of the scene.
    pub modes: Vec<usize>,
    /// Along x, y or z of the body.
    pub along: usize,
    /// Of each station.
    pub factors: Vec<f64>,
}

impl Lines {
    /// A station with these modes.
    pub fn place(&self, station: usize, modes: &[f64]) -> Point {
        let mut at = self.stations[station];
        for bending in &self.bendings {
            let product: f64 = bending.modes.iter().map(|mode| modes[*mode]).product();
            at[bending.along] += product * bending.factors[station];
        }
        at
    }
}

/// A body.
#[derive(Clone, Debug)]
pub struct Shape {
    pub name: String,
    /// `disk`, `ball`, `box`, `lines`, or `bar` for all that is what lies between its spots.
    pub outline: &'static str,
    /// Radius, or edges.
    pub lengths: Vec<f64>,
    /// Where something acts on it, from its centre of mass, in its axes.
    pub spots: Vec<Point>,
    pub turns: bool,
    /// Of what deforms.
    pub lines: Option<Lines>,
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

/// What may touch, as lines.
#[derive(Clone, Debug)]
pub struct Surface {
    pub name: String,
    pub lines: Vec<Vec<Spot>>,
}

/// The scene with the parameters of a pose, deflections so large that they are seen in one of the positions, and a ground as far as bodies
/// come, by where their centres are.
pub fn scene<'q>(
    compiled: &Compiled,
    pose: &Pose,
    positions: impl Iterator<Item = &'q [f64]>,
    centers: impl Iterator<Item = Point>,
) -> Scene {
    let sketch = Sketch::reaching(compiled, pose, centers);
    let bent = Bent::of_all(compiled, &pose.q);
    let deflection = |q: &[f64]| {
        let beams = bent.iter().flatten().map(|it| it.deflection_at(q));
        beams.fold(0.0, f64::max)
    };
    let times = magnification(positions.map(deflection).fold(0.0, f64::max));
    let mechanism = &compiled.mechanism;
    let mut stage = Stage { parts: &sketch.parts, places: bent.iter().map(Bends::of).collect() };
    let joints = mechanism.joints.iter().zip(&sketch.hinges).map(|(joint, hinge)| Joint {
        name: hinge.name.clone(),
        kind: joint.form.call.word,
        first: stage.spot(hinge.first_on, hinge.first, Some(&joint.first)),
        second: stage.spot(hinge.second_on, hinge.second, Some(&joint.second)),
        axis: way(&sketch.parts, hinge.first_on, hinge.axis),
        slides: matches!(hinge.form.spans, Spans::Rail | Spans::Line),
    });
    let joints = joints.collect();
    let loads = mechanism.loads.iter().zip(&sketch.efforts).map(|(load, (_, effort))| {
        let ends = frames(compiled, load).zip(&effort.ends);
        let ends = ends.map(|((frame, place), end)| stage.spot(frame, end.at, place));
        Line { name: effort.name.clone(), kind: load.form.call.word, ends: ends.collect() }
    });
    let loads = loads.collect();
    let wheels = sketch.wheels.iter().map(|wheel| Wheel {
        of: wheel.of.clone(),
        center: stage.spot(wheel.on, wheel.center, None),
        about: way(&sketch.parts, wheel.on, wheel.about),
        radius: wheel.radius,
    });
    let wheels = wheels.collect();
    let surfaces = sketch.skins.iter().map(|skin| {
        let lines =
            skin.lines.iter().map(|line| line.iter().map(|at| stage.spot(skin.on, *at, None)).collect());
        Surface { name: skin.name.clone(), lines: lines.collect() }
    });
    let surfaces = surfaces.collect();
    let mut modes = Vec::new();
    let mut bodies = Vec::new();
    for (part, bends) in sketch.parts.iter().zip(&stage.places) {
        let lines = bends.as_ref().map(|bends| bends.lines(modes.len(), times));
        modes.extend(bends.iter().flat_map(|bends| &bends.bent.indices));
        bodies.push(shape(part, lines));
    }
    let is_planar = sketch.space == Space::Planar;
    Scene { is_planar, up: sketch.up, bodies, joints, loads, wheels, surfaces, modes, times }
}

/// What places are found on.
struct Stage<'s> {
    parts: &'s [Part],
    places: Vec<Option<Bends<'s>>>,
}

/// What deforms, with its stations.
struct Bends<'s> {
    bent: &'s Bent,
    stations: Vec<Station>,
}

impl<'s> Bends<'s> {
    fn of(bent: &'s Option<Bent>) -> Option<Self> {
        let bent = bent.as_ref()?;
        Some(Bends { bent, stations: bent.stations() })
    }

    fn station(&mut self, at: Point) -> Option<usize> {
        let station = self.bent.station(at)?;
        let index = self.stations.iter().position(|it| *it == station);
        Some(index.unwrap_or_else(|| {
            self.stations.push(station);
            self.stations.len() - 1
        }))
    }

    fn lines(&self, first: usize, times: f64) -> Lines {
        let bent = self.bent;
        let factors: Vec<Vec<f64>> =
            self.stations.iter().map(|station| bent.factors(*station, times)).collect();
        let bendings = bent.terms().into_iter().enumerate().map(|(term, (modes, along))| Bending {
            modes: modes.iter().map(|mode| first + mode).collect(),
            along,
            factors: factors.iter().map(|of_station| of_station[term]).collect(),
        });
        Lines {
            stations: self.stations.iter().map(|station| bent.straight(*station)).collect(),
            counts: bent.lines(),
            bendings: bendings.collect(),
        }
    }
}

impl Stage<'_> {
    /// A point of the world, or the place of what deforms that it is.
    fn spot(&mut self, frame: Frame, at: Point, place: Option<&Place>) -> Spot {
        let Frame::Body(body) = frame else { return Spot { body: None, at, station: None } };
        let station = match (&mut self.places[body.0], place.and_then(known)) {
            (Some(bends), Some(at)) => bends.station(at),
            _ => None,
        };
        let part = &self.parts[body.0];
        let at = part.axes.map(|axis| dot(axis, difference(at, part.center)));
        Spot { body: Some(body.0), at, station }
    }
}

fn shape(part: &Part, lines: Option<Lines>) -> Shape {
    let outline = match (part.form.outline, part.lengths.len()) {
        _ if lines.is_some() => "lines",
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
        spots: if lines.is_some() { Vec::new() } else { part.spots.iter().map(local).collect() },
        turns: part.form.turns,
        lines,
    }
}

fn way(parts: &[Part], frame: Frame, along: Point) -> Point {
    match frame {
        Frame::Ground => along,
        Frame::Body(body) => parts[body.0].axes.map(|axis| dot(axis, along)),
    }
}

/// What the ends of a load move with, and where they are on it if it bends.
fn frames<'c>(
    compiled: &'c Compiled,
    load: &'c Load,
) -> impl Iterator<Item = (Frame, Option<&'c Place>)> + 'c {
    load.on.iter().filter_map(|subject| match subject {
        Subject::Expression(..) | Subject::Touches(_) => None,
        Subject::Place(place) => Some((place.frame, Some(place))),
        Subject::Rotor(Rotor::Joint(joint, _))
        | Subject::Travel(joint)
        | Subject::Bearing(joint, _)
        | Subject::Joint(joint) => {
            let second = &compiled.mechanism.joints[joint.0].second;
            Some((second.frame, Some(second)))
        }
        Subject::Rotor(Rotor::Body(body)) | Subject::Body(body) => Some((Frame::Body(*body), None)),
        Subject::Toothing(id) => Some((Frame::Body(id.body), None)),
    })
}
