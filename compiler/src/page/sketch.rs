//! What a drawing shows, as numbers: where bodies, joints and loads stand at the start, in world axes. How they look is
//! left to `figure`.

use crate::Compiled;
use crate::equations::{Laws, space};
use crate::model::{
    Axes, Body, ConstraintKind, Frame, Joint, JointKind, JointWord, Load, LoadKind, Place, Rotor, Shape,
    Space, Vector,
};
use crate::symbolic::{Graph, Node, Op, evaluate_reachable};

/// World coordinates, m; z is 0 in the plane.
pub type Point = [f64; 3];

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

    /// Two long parts slide in each other somewhere between their ends; a distance is between its places.
    fn settle(&mut self, parts: &[Part]) {
        if self.kind == JointWord::Distance {
            self.at = sum(self.first, self.second).map(|x| x / 2.0);
        }
        let slides = matches!(self.kind, JointWord::Prismatic | JointWord::Cylindrical | JointWord::Screw);
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
            hinge.settle(&parts);
        }
        let efforts = mechanism.loads.iter().filter_map(|load| stand.effort(load, &hinges)).collect();
        let wheels = stand.wheels(&hinges);
        Sketch { space: mechanism.space, up: stand.up(), parts, hinges, efforts, wheels }
    }
}

impl Part {
    /// Something acts on it there.
    fn touch(&mut self, at: Point) {
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

/// The mechanism at its start: default parameters, time 0, all inputs 1, so that loads have a direction.
struct Stand<'a> {
    compiled: &'a Compiled,
    /// The equations' graph, to which what is asked is added.
    graph: Graph,
    symbols: Vec<f64>,
    values: Vec<f64>,
    /// Centre and axes of each body.
    poses: Vec<(Point, [Point; 3])>,
}

impl<'a> Stand<'a> {
    fn of(compiled: &'a Compiled) -> Self {
        let (equations, assembly) = (&compiled.equations, &compiled.assembly);
        let graph = equations.graph.clone();
        let mut symbols = vec![0.0; graph.symbol_count()];
        let mut set = |nodes: &[Node], values: &mut dyn Iterator<Item = f64>| {
            for (node, value) in nodes.iter().zip(values) {
                if let Op::Symbol(symbol) = graph.op(*node) {
                    symbols[symbol as usize] = value;
                }
            }
        };
        let known = &equations.symbols;
        set(&known.parameters, &mut compiled.mechanism.parameters.iter().map(|it| it.default));
        set(&known.phases, &mut assembly.phases.iter().copied());
        set(&known.q, &mut assembly.q.iter().copied());
        set(&known.v, &mut assembly.v.iter().copied());
        set(&known.inputs, &mut std::iter::repeat(1.0));
        let mut stand = Stand { compiled, graph, symbols, values: Vec::new(), poses: Vec::new() };
        for motion in &equations.motions {
            let center = pad(&stand.numbers(&motion.position));
            let turned = stand.numbers(&motion.orientation);
            let axes = match turned[..] {
                [c, s] => [[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]],
                _ => [0, 1, 2].map(|column| [0, 1, 2].map(|row| turned[3 * row + column])),
            };
            stand.poses.push((center, axes));
        }
        stand
    }

    fn numbers(&mut self, nodes: &[Node]) -> Vec<f64> {
        let order = self.graph.reachable(nodes.iter().copied());
        evaluate_reachable(&self.graph, &order, &self.symbols, &mut self.values);
        nodes.iter().map(|node| self.values[node.index()]).collect()
    }

    /// Values of what is built on the graph.
    fn built(&mut self, build: impl FnOnce(&mut Graph, &Laws) -> Vec<Node>) -> Vec<f64> {
        let equations = &self.compiled.equations;
        let mechanism = &self.compiled.mechanism;
        let laws = Laws::moving(mechanism, &equations.symbols, &equations.layout, &equations.kinematics);
        let nodes = build(&mut self.graph, &laws);
        self.numbers(&nodes)
    }

    fn vector(&mut self, vector: &Vector) -> Point {
        pad(&self.built(|g, laws| laws.vector(g, vector).to_vec()))
    }

    fn up(&mut self) -> Point {
        if self.compiled.mechanism.space == Space::Planar {
            return [0.0, 1.0, 0.0];
        }
        let gravity = match &self.compiled.mechanism.gravity {
            Some(gravity) => self.vector(gravity),
            None => [0.0; 3],
        };
        // The axis that is nearest to it.
        let nearest = (0..3).fold(2, |best, k| if gravity[k].abs() > gravity[best].abs() { k } else { best });
        let mut up = [0.0; 3];
        up[nearest] = if gravity[nearest] > 0.0 { -1.0 } else { 1.0 };
        up
    }

    /// A vector in the axes of what a place belongs to, in world axes.
    fn turned(&self, frame: Frame, vector: Point) -> Point {
        match frame {
            Frame::Ground => vector,
            Frame::Body(body) => apply(&self.poses[body.0].1, vector),
        }
    }

    fn place(&mut self, place: &Place) -> Point {
        let at = self.vector(&place.at);
        let Frame::Body(body) = place.frame else { return at };
        let definition = &self.compiled.mechanism.bodies[body.0];
        let center = self.vector(&definition.center);
        sum(self.poses[body.0].0, self.turned(place.frame, difference(at, center)))
    }

    /// A direction in the axes of a place.
    fn direction(&mut self, place: &Place, vector: &Vector) -> Point {
        let own = self.vector(vector);
        let own = match &place.axes {
            Axes::Parallel => own,
            axes => {
                let matrix = self.built(|g, laws| space::place_axes(g, laws, axes).concat());
                [0, 1, 2].map(|row| (0..3).map(|column| matrix[3 * row + column] * own[column]).sum())
            }
        };
        self.turned(place.frame, own)
    }

    fn hinge(&mut self, joint: &Joint) -> Hinge {
        let z = [0.0, 0.0, 1.0];
        let axis = match &joint.kind {
            JointKind::Revolute { .. } if self.compiled.mechanism.space == Space::Planar => z,
            JointKind::Revolute { axis }
            | JointKind::Prismatic { axis, .. }
            | JointKind::Cylindrical { axis }
            | JointKind::Screw { axis, .. }
            | JointKind::Universal { axis, .. }
            | JointKind::Planar { axis }
            | JointKind::ConstantVelocity { axis }
            | JointKind::PointOnPlane { axis } => unit(self.direction(&joint.first, axis)),
            JointKind::PointOnLine { direction } => self.direction(&joint.first, direction),
            JointKind::Fixed { .. } | JointKind::Spherical | JointKind::Distance { .. } => z,
        };
        let second_axis = match &joint.kind {
            JointKind::Universal { second_axis, .. } => unit(self.direction(&joint.second, second_axis)),
            _ => axis,
        };
        let second = self.place(&joint.second);
        Hinge {
            name: joint.name.text.clone(),
            kind: joint.kind.word(),
            first: self.place(&joint.first),
            second,
            at: second,
            first_on: joint.first.frame,
            second_on: joint.second.frame,
            axis,
            second_axis,
        }
    }

    fn part(&mut self, index: usize, body: &Body) -> Part {
        let (center, axes) = self.poses[index];
        let own = self.vector(&body.center);
        let lengths = self.built(|g, laws| body.dimensions.iter().map(|(_, it)| laws.value(g, it)).collect());
        let mut part = Part {
            name: body.name.text.clone(),
            shape: body.shape,
            center,
            axes,
            lengths,
            spots: Vec::new(),
            joints: 0,
            is_block: false,
        };
        for point in &body.points {
            let at = self.vector(&point.at);
            part.touch(sum(center, apply(&axes, difference(at, own))));
        }
        part
    }

    fn effort(&mut self, load: &Load, hinges: &[Hinge]) -> Option<Effort> {
        let kind = match &load.kind {
            LoadKind::Force { place, components } => {
                let along = self.vector(components);
                EffortKind::Force { at: self.place(place), along }
            }
            LoadKind::Push { joint, force } => {
                let sign = self.built(|g, laws| vec![laws.value(g, force)])[0];
                let hinge = &hinges[joint.0];
                EffortKind::Force { at: hinge.second, along: hinge.axis.map(|x| sign * x) }
            }
            LoadKind::Torque { on, torque } => {
                let sign = self.built(|g, laws| vec![laws.value(g, torque)])[0];
                let (at, about) = self.rotor(*on, hinges);
                EffortKind::Torque { at, about: about.map(|x| sign * x) }
            }
            LoadKind::BodyTorque { body, components } => {
                EffortKind::Torque { at: self.poses[body.0].0, about: self.vector(components) }
            }
            LoadKind::Spring { first, second, stiffness, damping, .. } => {
                let [k, c] = self.built(|g, laws| vec![laws.value(g, stiffness), laws.value(g, damping)])[..]
                else {
                    return None;
                };
                let ends = [first, second]
                    .map(|place| End { at: self.place(place), is_grounded: place.frame == Frame::Ground });
                EffortKind::Spring { ends, is_elastic: k != 0.0, is_damped: c != 0.0 }
            }
            LoadKind::TorsionSpring { on, .. } => {
                let (at, about) = self.rotor(*on, hinges);
                EffortKind::TorsionSpring { at, about }
            }
        };
        // What is zero at the start, or nothing yet, has no direction to be drawn in.
        let kind = match kind {
            EffortKind::Force { at, along } => {
                EffortKind::Force { at, along: Some(unit(along)).filter(|it| *it != [0.0; 3])? }
            }
            EffortKind::Torque { at, about } => {
                EffortKind::Torque { at, about: Some(unit(about)).filter(|it| *it != [0.0; 3])? }
            }
            other => other,
        };
        Some(Effort { name: load.name.text.clone(), kind })
    }

    /// Centre and axis of what turns.
    fn rotor(&self, rotor: Rotor, hinges: &[Hinge]) -> (Point, Point) {
        match rotor {
            Rotor::Joint(joint, which) => {
                let hinge = &hinges[joint.0];
                (hinge.second, if which == 0 { hinge.axis } else { hinge.second_axis })
            }
            Rotor::Body(body) => (self.poses[body.0].0, [0.0, 0.0, 1.0]),
        }
    }

    /// Pitch circles that follow from ratio and distance of the axes, or from a pinion's radius.
    fn wheels(&mut self, hinges: &[Hinge]) -> Vec<Wheel> {
        let (mut wheels, mut inner): (Vec<Wheel>, Vec<[Wheel; 2]>) = (Vec::new(), Vec::new());
        for constraint in &self.compiled.mechanism.constraints {
            let of = &constraint.name.text;
            match &constraint.kind {
                ConstraintKind::Gear { first, second, ratio, .. } => {
                    let ratio = self.built(|g, laws| vec![laws.value(g, ratio)])[0];
                    let rotors = [first, second].map(|it| self.rotor(*it, hinges));
                    match mesh(of, rotors, ratio) {
                        Some(pair) if ratio < 0.0 => wheels.extend(pair),
                        Some(pair) => inner.push(pair),
                        None => {}
                    }
                }
                ConstraintKind::Rack { pinion, radius, .. } => {
                    let radius = self.built(|g, laws| vec![laws.value(g, radius)])[0].abs();
                    let (center, about) = self.rotor(*pinion, hinges);
                    wheels.push(Wheel { of: of.clone(), center, about, radius });
                }
                ConstraintKind::Equation { .. } => {}
            }
        }
        // A positive ratio may be a ring gear's or a belt's: a ring's where it agrees with a wheel that is known.
        for pair in inner {
            let known = |own: &Wheel| wheels.iter().any(|wheel| wheel.is(own));
            if pair.iter().any(known) {
                wheels.extend(pair);
            }
        }
        wheels.retain(|wheel| wheel.radius.is_finite() && wheel.radius > 0.0);
        wheels
    }
}

impl Wheel {
    fn is(&self, other: &Wheel) -> bool {
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-6 * b.abs();
        length(difference(self.center, other.center)) <= 1e-6 * other.radius
            && near(self.radius, other.radius)
    }
}

/// The circles of two wheels on parallel axes that turn as ω_a = ratio ω_b: r_b = |ratio| r_a, and r_a + r_b, of a ring
/// gear their difference, is the distance of the axes.
fn mesh(of: &str, [(a, about), (b, other)]: [(Point, Point); 2], ratio: f64) -> Option<[Wheel; 2]> {
    let between = difference(b, a);
    let is_beside = length(cross(about, other)) < 1e-6 && dot(between, about).abs() < 1e-9;
    let radius = length(between) / (1.0 - ratio).abs();
    let wheel = |center, radius| Wheel { of: of.to_string(), center, about, radius };
    (is_beside && radius > 0.0 && radius.is_finite())
        .then(|| [wheel(a, radius), wheel(b, ratio.abs() * radius)])
}

fn pad(values: &[f64]) -> Point {
    let mut point = [0.0; 3];
    point.iter_mut().zip(values).for_each(|(own, value)| *own = if value.is_finite() { *value } else { 0.0 });
    point
}

fn apply(axes: &[Point; 3], x: Point) -> Point {
    [0, 1, 2].map(|k| axes[0][k] * x[0] + axes[1][k] * x[1] + axes[2][k] * x[2])
}

pub fn sum(a: Point, b: Point) -> Point {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub fn difference(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// a + k b.
pub fn along(a: Point, k: f64, b: Point) -> Point {
    [a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]]
}

pub fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: Point, b: Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub fn length(a: Point) -> f64 {
    dot(a, a).sqrt()
}

/// Of length one; zero stays zero.
pub fn unit(a: Point) -> Point {
    let size = length(a);
    if size > 0.0 { a.map(|x| x / size) } else { [0.0; 3] }
}
