//! Surfaces that may touch, as lines: in the plane their outlines, in space a frame of wires. What has no end is drawn as far as the
//! rest of the picture reaches, with strokes on its solid side in the plane and a normal to its free side in space.

use super::stand::Stand;
use crate::drawing::shapes::across;
use crate::drawing::vector::{Point, along, cross, difference, dot, length, sum, unit};
use crate::equations::plane;
use crate::model::{Coordinate, Expr, Frame, JointId, Place, Shape, Space, Surface, Vector};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Corners of a whole circle.
const CORNERS: u32 = 48;
/// Strokes along a line of the ground.
const STROKES: u32 = 36;
const UP: Point = [0.0, 0.0, 1.0];

/// A surface in a pose, in the world.
#[derive(Clone, Debug)]
pub struct Skin {
    pub name: String,
    pub on: Frame,
    pub lines: Vec<Vec<Point>>,
}

/// The smallest box along the axes of the world around all that a picture shows.
#[derive(Clone, Copy, Debug)]
pub struct Bounds {
    least: Point,
    most: Point,
}

impl Bounds {
    pub fn of(points: impl IntoIterator<Item = Point>) -> Self {
        let mut bounds = Bounds { least: [f64::INFINITY; 3], most: [f64::NEG_INFINITY; 3] };
        for point in points {
            for (k, x) in point.into_iter().enumerate() {
                bounds.least[k] = bounds.least[k].min(x);
                bounds.most[k] = bounds.most[k].max(x);
            }
        }
        if bounds.least.iter().chain(&bounds.most).all(|x| x.is_finite()) {
            bounds
        } else {
            Bounds { least: [0.0; 3], most: [0.0; 3] }
        }
    }

    fn middle(&self) -> Point {
        sum(self.least, self.most).map(|x| x / 2.0)
    }

    /// How far it reaches from a place along directions; of what lies far beside that place, in proportion to how far.
    fn reach(&self, from: Point, ways: &[Point]) -> f64 {
        let corner =
            |bits: usize| [0, 1, 2].map(|k| if bits >> k & 1 == 0 { self.least[k] } else { self.most[k] });
        let away = (0..8)
            .flat_map(|bits| ways.iter().map(move |way| dot(difference(corner(bits), from), *way).abs()));
        let beside = 0.3 * length(difference(self.middle(), from));
        let reach = 1.05 * away.fold(beside, f64::max);
        if reach > 0.0 { reach } else { 1.0 }
    }
}

impl Stand<'_> {
    /// All that have names.
    pub fn skins(&mut self, bounds: &Bounds) -> Vec<Skin> {
        let compiled = self.compiled;
        let skin = |Surface { shape, text, .. }: &Surface| {
            let lines = self.lines(shape, bounds);
            Skin { name: text.clone(), on: shape.place().frame, lines }
        };
        let mut skins: Vec<Skin> = compiled.mechanism.surfaces.iter().map(skin).collect();
        skins.extend((0..compiled.mechanism.joints.len()).flat_map(|joint| self.rolling(joint, bounds)));
        skins.retain(|skin| !skin.lines.is_empty());
        skins
    }

    /// The curve of a joint and what rolls on it.
    fn rolling(&mut self, index: usize, bounds: &Bounds) -> Vec<Skin> {
        let joint = &self.compiled.mechanism.joints[index];
        if joint.functions().is_some() {
            let (name, on) = (joint.name.text.clone(), joint.first.frame);
            return vec![Skin { name, on, lines: self.curve(JointId(index), bounds) }];
        }
        let (Some(curve), [base, radius]) = (&joint.curve, &joint.scalars[..]) else { return Vec::new() };
        let (curve, base) = (curve.clone(), base.clone());
        let shapes = [
            Shape::Profile { place: joint.first.clone(), curve, base },
            Shape::Round { place: joint.second.clone(), radius: radius.clone() },
        ];
        let skin = |shape: &Shape| {
            let (name, on) = (joint.name.text.clone(), shape.place().frame);
            Skin { name, on, lines: self.lines(shape, bounds) }
        };
        shapes.iter().map(skin).collect()
    }

    /// Of a joint on a curve, as far as the rest of the picture reaches or until it is closed, from where its point is.
    fn curve(&mut self, joint: JointId, bounds: &Bounds) -> Vec<Vec<Point>> {
        let place = &self.compiled.mechanism.joints[joint.0].first;
        let (at, here) = (self.place(place), self.parameter(joint));
        let reach = bounds.reach(at, &[UP, [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
        let step = reach / f64::from(CORNERS);
        let ways = [-1.0, 1.0].map(|way| {
            let parameters: Vec<f64> = (0..=2 * CORNERS).map(|k| here + way * f64::from(k) * step).collect();
            let points = self
                .on_curve(joint, &parameters)
                .into_iter()
                .map(|[x, y]| sum(at, self.direction(place, &[x, y, 0.0].map(Expr::Number))));
            let points: Vec<Point> = points.take_while(|point| point.iter().all(|x| x.is_finite())).collect();
            let home = points[..1].to_vec();
            let inside = points.into_iter().take_while(|point| length(difference(*point, at)) <= 1.5 * reach);
            home.into_iter().chain(inside.skip(1)).collect::<Vec<Point>>()
        });
        let [back, on] = ways;
        vec![back.into_iter().rev().chain(on.into_iter().skip(1)).collect()]
    }

    /// The parameter of a joint on a curve.
    fn parameter(&mut self, joint: JointId) -> f64 {
        self.built(|laws| vec![laws.coordinate(&Coordinate::Travel(joint, 0)).jet.value])[0]
    }

    /// Points of a curve, in the axes of its body.
    fn on_curve(&mut self, joint: JointId, parameters: &[f64]) -> Vec<[f64; 2]> {
        let numbers = self.built(|laws| {
            let point = |u: &f64| plane::joints::point_of_curve(laws, joint, *u);
            parameters.iter().flat_map(point).collect()
        });
        numbers.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect()
    }

    fn size(&mut self, expr: &Expr) -> f64 {
        self.vector(&[expr.clone(), Expr::Number(0.0), Expr::Number(0.0)])[0]
    }

    fn axis(&mut self, place: &Place, axis: &Vector) -> Point {
        unit(self.direction(place, axis))
    }

    fn lines(&mut self, shape: &Shape, bounds: &Bounds) -> Vec<Vec<Point>> {
        let is_planar = self.compiled.mechanism.space == Space::Planar;
        let at = self.place(shape.place());
        match shape {
            Shape::Round { radius, .. } | Shape::Hollow { radius, .. } => {
                let radius = self.size(radius);
                if radius == 0.0 {
                    // A point, which its body shows.
                    return Vec::new();
                }
                let axes: &[Point] = if is_planar { &[UP] } else { &[UP, [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]] };
                axes.iter().map(|axis| circle(at, *axis, radius)).collect()
            }
            Shape::Flat { place, normal } => {
                let normal = self.axis(place, normal);
                if is_planar { half_plane(at, normal, bounds) } else { plane(at, normal, bounds) }
            }
            Shape::Bar { ends, radius } => {
                let (end, radius) = (self.place(&ends[1]), self.size(radius));
                bar([at, end], radius, is_planar)
            }
            Shape::Polygon(places) => {
                let corners = places.iter().chain(&places[..1]);
                vec![corners.map(|place| self.place(place)).collect()]
            }
            Shape::Profile { place, curve, base } => {
                let base = self.size(base);
                let corners: Vec<(f64, f64)> = curve.around(base).step_by(8).collect();
                let corner = |(angle, radius): &(f64, f64)| {
                    let way = [radius * libm::cos(*angle), radius * libm::sin(*angle), 0.0];
                    sum(at, self.direction(place, &way.map(Expr::Number)))
                };
                vec![corners.iter().chain(&corners[..1]).map(corner).collect()]
            }
            Shape::Cylinder { place, axis, radius, length } | Shape::Bore { place, axis, radius, length } => {
                let (axis, radius) = (self.axis(place, axis), self.size(radius));
                let (middle, half) = match length {
                    Some(length) => (at, self.size(length) / 2.0),
                    None => {
                        let foot = along(at, dot(difference(bounds.middle(), at), axis), axis);
                        (foot, bounds.reach(foot, &[axis]))
                    }
                };
                tube([along(middle, -half, axis), along(middle, half, axis)], axis, radius)
            }
            Shape::Rim { place, axis, radius } => vec![circle(at, self.axis(place, axis), self.size(radius))],
        }
    }
}

/// A part of a circle about an axis, from one direction across it towards another.
fn arc(center: Point, radius: f64, [u, v]: [Point; 2], from: f64, to: f64) -> Vec<Point> {
    let count = ((to - from) / TAU * f64::from(CORNERS)).round().max(1.0) as u32;
    let at = |k: u32| {
        let angle = from + (to - from) * f64::from(k) / f64::from(count);
        along(along(center, radius * libm::cos(angle), u), radius * libm::sin(angle), v)
    };
    (0..=count).map(at).collect()
}

fn circle(center: Point, axis: Point, radius: f64) -> Vec<Point> {
    arc(center, radius, across(axis), 0.0, TAU)
}

/// A line, and strokes on its solid side.
fn half_plane(at: Point, normal: Point, bounds: &Bounds) -> Vec<Vec<Point>> {
    let way = cross(UP, normal);
    let foot = along(at, dot(difference(bounds.middle(), at), way), way);
    let half = bounds.reach(foot, &[way]);
    let step = 2.0 * half / f64::from(STROKES);
    let mut lines = vec![vec![along(foot, -half, way), along(foot, half, way)]];
    lines.extend((0..STROKES).map(|k| {
        let top = along(foot, step * (f64::from(k) + 0.8) - half, way);
        vec![top, along(along(top, -0.8 * step, normal), -0.6 * step, way)]
    }));
    lines
}

/// A square of it, and its normal.
fn plane(at: Point, normal: Point, bounds: &Bounds) -> Vec<Vec<Point>> {
    let [u, v] = across(normal);
    let middle = bounds.middle();
    let foot = along(middle, -dot(difference(middle, at), normal), normal);
    let half = bounds.reach(foot, &[u, v]);
    let corner = |[a, b]: [f64; 2]| along(along(foot, a * half, u), b * half, v);
    let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0]].map(corner);
    let edge = corner([-1.0, -1.0]);
    vec![square.to_vec(), vec![edge, along(edge, 0.2 * half, normal)]]
}

/// What is within a radius of a stretch.
fn bar(ends: [Point; 2], radius: f64, is_planar: bool) -> Vec<Vec<Point>> {
    let way = unit(difference(ends[1], ends[0]));
    if radius == 0.0 {
        return vec![ends.to_vec()];
    }
    let outline = |aside: Point| {
        let mut line = arc(ends[1], radius, [way, aside], -FRAC_PI_2, FRAC_PI_2);
        line.extend(arc(ends[0], radius, [way, aside], FRAC_PI_2, FRAC_PI_2 + PI));
        line.push(line[0]);
        line
    };
    if is_planar {
        return vec![outline(cross(UP, way))];
    }
    let asides = across(way);
    let rounds = ends.map(|end| circle(end, way, radius));
    asides.map(outline).into_iter().chain(rounds).collect()
}

/// Both ends of a round tube, and four lines between them.
fn tube(ends: [Point; 2], axis: Point, radius: f64) -> Vec<Vec<Point>> {
    let [u, v] = across(axis);
    let sides = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];
    let side = |[a, b]: [f64; 2]| ends.map(|end| along(along(end, a * radius, u), b * radius, v)).to_vec();
    ends.map(|end| circle(end, axis, radius)).into_iter().chain(sides.map(side)).collect()
}
