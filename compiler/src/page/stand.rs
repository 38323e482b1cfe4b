//! Numbers of the mechanism as it stands in a pose, such as its start, from which the sketch is made.

use super::bent::{Bent, Station};
use super::sketch::{Effort, Part, Wheel};
use crate::beams::magnification;
use crate::check::assemble::live;
use crate::compiled::Compiled;
use crate::complete::Complete;
use crate::drawing::Hinge;
use crate::drawing::load::End;
use crate::drawing::vector::{Point, apply, cross, difference, dot, length, pad, sum, unit};
use crate::equations::{Equations, Laws, space};
use crate::forms::Spans;
use crate::model::gears::ToothingId;
use crate::model::{
    Axes, Body, ConstraintKind, Coupled, Expr, Frame, Joint, Load, Place, Rotor, Space, Subject, Vector,
};
use crate::symbolic::{Growing, Node, Op, evaluate_reachable};

/// Where wheels without slip would roll on each other.
const PITCH: &str = "pitch circle";

/// Where a mechanism stands.
#[derive(Clone, Debug)]
pub struct Pose {
    pub parameters: Vec<f64>,
    pub phases: Vec<f64>,
    pub time: f64,
    pub q: Vec<f64>,
    pub v: Vec<f64>,
    pub internal: Vec<f64>,
}

impl Pose {
    /// At its start: default parameters, time 0.
    pub fn start(compiled: &Compiled) -> Pose {
        let Compiled { mechanism, assembly, .. } = compiled;
        Pose {
            parameters: mechanism.defaults(),
            phases: assembly.phases.clone(),
            time: 0.0,
            q: assembly.q.clone(),
            v: assembly.v.clone(),
            internal: mechanism.internal_starts(),
        }
    }
}

/// The mechanism in a pose, all inputs 1, so that loads have a direction.
pub struct Stand<'a> {
    pub(super) compiled: &'a Compiled,
    /// The equations' graph, to which what is asked is added.
    graph: Growing,
    symbols: Vec<f64>,
    values: Vec<f64>,
    /// Centre and axes of each body.
    pub(super) poses: Vec<(Point, [Point; 3])>,
    /// The origin of each body.
    origins: Vec<Point>,
    /// What bends of each body.
    pub(super) bent: Vec<Option<Bent>>,
    /// How many times as large deflections are shown.
    pub times: f64,
}

impl<'a> Stand<'a> {
    pub fn of(compiled: &'a Compiled, pose: &Pose) -> Self {
        let equations = &compiled.complete.equations;
        let graph = equations.graph.clone();
        let mut symbols = vec![0.0; graph.read().symbol_count()];
        let mut set = |nodes: &[Node], values: &mut dyn Iterator<Item = f64>| {
            for (node, value) in nodes.iter().zip(values) {
                if let Op::Symbol(symbol) = graph.read().op(*node) {
                    symbols[symbol as usize] = value;
                }
            }
        };
        let known = &equations.symbols;
        set(&known.parameters, &mut pose.parameters.iter().copied());
        set(&known.phases, &mut pose.phases.iter().copied());
        set(std::slice::from_ref(&known.time), &mut std::iter::once(pose.time));
        set(&known.q, &mut pose.q.iter().copied());
        set(&known.v, &mut pose.v.iter().copied());
        set(&known.inputs, &mut std::iter::repeat(1.0));
        set(&known.internal, &mut pose.internal.iter().copied());
        let guards: Vec<Node> = equations.guards.iter().flatten().copied().collect();
        let bent = Bent::of_all(compiled, &pose.q);
        let deflections = bent.iter().flatten().map(Bent::deflection);
        let times = magnification(deflections.fold(0.0, f64::max));
        let mut stand = Stand {
            compiled,
            graph,
            symbols,
            values: Vec::new(),
            poses: Vec::new(),
            origins: Vec::new(),
            bent,
            times,
        };
        stand.hold(&guards);
        for motion in &equations.motions {
            let center = pad(&stand.numbers(&motion.position));
            let turned = stand.numbers(&motion.orientation);
            let axes = match turned[..] {
                [c, s] => [[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]],
                _ => [0, 1, 2].map(|column| [0, 1, 2].map(|row| turned[3 * row + column])),
            };
            stand.poses.push((center, axes));
        }
        for (index, body) in compiled.mechanism.bodies.iter().enumerate() {
            let own = stand.vector(&body.center);
            let (center, axes) = &stand.poses[index];
            stand.origins.push(difference(*center, apply(axes, own)));
        }
        stand
    }

    /// Takes the gates that are held as they are in this pose.
    fn hold(&mut self, guards: &[Node]) {
        let values = self.numbers(guards);
        let compiled = self.compiled;
        let memories = &compiled.mechanism.memories;
        let guarded = values.len() / 2 - memories.len();
        let gates = values.chunks_exact(2).map(|guard| live([guard[0], guard[1]])).take(guarded);
        let gates = gates.chain(memories.iter().map(|memory| memory.start));
        for (node, gate) in self.compiled.complete.equations.symbols.gates.iter().zip(gates) {
            if let Op::Symbol(symbol) = self.graph.read().op(*node) {
                self.symbols[symbol as usize] = gate;
            }
        }
    }

    fn numbers(&mut self, nodes: &[Node]) -> Vec<f64> {
        let graph = self.graph.read();
        let order = graph.reachable(nodes.iter().copied());
        evaluate_reachable(&graph, &order, &self.symbols, &mut self.values);
        nodes.iter().map(|node| self.values[node.index()]).collect()
    }

    /// Values of what is built on the graph.
    pub(super) fn built(&mut self, build: impl FnOnce(&Laws) -> Vec<Node>) -> Vec<f64> {
        let Compiled { mechanism, complete: Complete { equations, .. }, .. } = self.compiled;
        let Equations { symbols, layout, kinematics, .. } = equations;
        let nodes = build(&Laws::moving(self.graph.sheet(), mechanism, symbols, layout, kinematics));
        self.numbers(&nodes)
    }

    pub(super) fn vector(&mut self, vector: &Vector) -> Point {
        pad(&self.built(|laws| laws.vector(vector).bare.to_vec()))
    }

    pub fn up(&mut self) -> Point {
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

    pub fn place(&mut self, place: &Place) -> Point {
        let at = self.vector(&place.at);
        let Frame::Body(body) = place.frame else { return at };
        self.on(body.0, at)
    }

    /// Where a place of a body is shown, which may be bent.
    fn on(&self, body: usize, at: Point) -> Point {
        let bent = self.bent[body].as_ref();
        let shown = bent.and_then(|bent| Some(bent.shown(bent.station(at)?, self.times)));
        self.in_world(body, shown.unwrap_or(at))
    }

    /// A place in the axes of a body, from its origin.
    fn in_world(&self, body: usize, at: Point) -> Point {
        sum(self.origins[body], apply(&self.poses[body].1, at))
    }

    /// A direction in the axes of a place.
    pub(super) fn direction(&mut self, place: &Place, vector: &Vector) -> Point {
        let own = self.vector(vector);
        let own = match &place.axes {
            Axes::Parallel => own,
            axes => {
                let matrix = self.built(|laws| space::place_axes(laws, axes).bare.concat());
                [0, 1, 2].map(|row| (0..3).map(|column| matrix[3 * row + column] * own[column]).sum())
            }
        };
        self.turned(place.frame, own)
    }

    pub fn hinge(&mut self, joint: &Joint) -> Hinge {
        let z = [0.0, 0.0, 1.0];
        let mut directions = joint.directions.iter();
        let axis = match directions.next() {
            // As long as the line.
            Some(along) if joint.form.spans == Spans::Line => self.direction(&joint.first, along),
            Some(axis) => unit(self.direction(&joint.first, axis)),
            None => z,
        };
        let second_axis = directions.next().map(|axis| unit(self.direction(&joint.second, axis)));
        let second = self.place(&joint.second);
        Hinge {
            name: joint.name.text.clone(),
            form: joint.form,
            first: self.place(&joint.first),
            second,
            at: second,
            first_on: joint.first.frame,
            second_on: joint.second.frame,
            axis,
            second_axis: second_axis.unwrap_or(axis),
        }
    }

    pub fn part(&mut self, index: usize, body: &Body) -> Part {
        let (center, axes) = self.poses[index];
        let lengths = self.built(|laws| body.dimensions.iter().map(|(_, it)| laws.value(it).bare).collect());
        let mut part = Part {
            name: body.name.text.clone(),
            form: body.form,
            center,
            axes,
            lengths,
            spots: Vec::new(),
            lines: Vec::new(),
            straight: None,
            joints: 0,
            is_block: false,
        };
        if let Some(bent) = &self.bent[index] {
            let mut stations = bent.stations().into_iter();
            let mut straight = Vec::new();
            for count in bent.lines() {
                let line: Vec<Station> = stations.by_ref().take(count).collect();
                let ends =
                    [line.first(), line.last()].map(|end| end.map_or([0.0; 3], |end| bent.straight(*end)));
                straight.push(ends.map(|end| self.in_world(index, end)));
                let shown = line.iter().map(|station| bent.shown(*station, self.times));
                part.lines.push(shown.map(|at| self.in_world(index, at)).collect());
            }
            part.straight = bent.is_seen(self.times).then_some(straight);
            part.spots = part.lines.concat();
        }
        for point in &body.points {
            let at = self.vector(&point.at);
            part.touch(self.on(index, at));
        }
        part
    }

    pub fn effort(&mut self, load: &Load, hinges: &[Hinge]) -> Effort {
        let end = |(at, axis): (Point, Point)| End { at, axis, is_grounded: false };
        let mut ends = Vec::new();
        for subject in &load.on {
            ends.push(match subject {
                // It stands at no place.
                Subject::Expression(..) => continue,
                Subject::Toothing(id) => end((self.poses[id.body.0].0, [0.0, 0.0, 1.0])),
                // It stands where its joint or contact is drawn.
                Subject::Bearing(..) | Subject::Joint(_) | Subject::Touches(_) => continue,
                Subject::Place(place) => {
                    let is_grounded = place.frame == Frame::Ground;
                    End { at: self.place(place), axis: [0.0; 3], is_grounded }
                }
                Subject::Rotor(rotor) => end(self.rotor(*rotor, hinges)),
                Subject::Travel(joint) => end((hinges[joint.0].second, hinges[joint.0].axis)),
                Subject::Body(body) => end((self.poses[body.0].0, [0.0; 3])),
            });
        }
        let mut numbers =
            |exprs: &[Expr]| pad(&self.built(|laws| exprs.iter().map(|it| laws.value(it).bare).collect()));
        let values = load.values.iter().map(|value| numbers(value)).collect();
        Effort { name: load.name.text.clone(), ends, values, law: numbers(&load.law) }
    }

    /// Centre and axis of what turns.
    pub(super) fn rotor(&self, rotor: Rotor, hinges: &[Hinge]) -> (Point, Point) {
        match rotor {
            Rotor::Joint(joint, which) => {
                let hinge = &hinges[joint.0];
                (hinge.second, if which == 0 { hinge.axis } else { hinge.second_axis })
            }
            Rotor::Body(body) => (self.poses[body.0].0, [0.0, 0.0, 1.0]),
        }
    }

    /// The body that a rotor turns.
    fn turning(&self, rotor: Rotor) -> Frame {
        match rotor {
            Rotor::Joint(joint, _) => self.compiled.mechanism.joints[joint.0].second.frame,
            Rotor::Body(body) => Frame::Body(body),
        }
    }

    /// Pitch circles that follow from ratio and distance of the axes, or from a pinion's radius.
    pub fn wheels(&mut self, hinges: &[Hinge]) -> Vec<Wheel> {
        let (mut wheels, mut inner): (Vec<Wheel>, Vec<[Wheel; 2]>) = (Vec::new(), Vec::new());
        for constraint in &self.compiled.mechanism.constraints {
            let of = &constraint.name.text;
            let ConstraintKind::Coupling(coupling) = &constraint.kind else { continue };
            let factor = self.built(|laws| vec![laws.value(&coupling.factor).bare])[0];
            match [coupling.driven(), coupling.other()] {
                [Coupled::Angle(first), Coupled::Angle(second)] => {
                    let rotors = [first, second].map(|it| (self.turning(it), self.rotor(it, hinges)));
                    match mesh(of, rotors, factor) {
                        Some(pair) if factor < 0.0 => wheels.extend(pair),
                        Some(pair) => inner.push(pair),
                        None => {}
                    }
                }
                [Coupled::Travel(_), Coupled::Angle(pinion)]
                | [Coupled::Angle(pinion), Coupled::Travel(_)] => {
                    let (center, about) = self.rotor(pinion, hinges);
                    let on = self.turning(pinion);
                    wheels.push(Wheel {
                        of: of.clone(),
                        on,
                        circle: PITCH,
                        center,
                        about,
                        radius: factor.abs(),
                    });
                }
                [Coupled::Travel(_), Coupled::Travel(_)] => {}
            }
        }
        // A positive ratio may be a ring gear's or a belt's: a ring's where it agrees with a wheel that is known.
        for pair in inner {
            let known = |own: &Wheel| wheels.iter().any(|wheel| wheel.is(own));
            if pair.iter().any(known) {
                wheels.extend(pair);
            }
        }
        wheels.extend(self.rims(hinges));
        wheels.retain(|wheel| wheel.radius.is_finite() && wheel.radius > 0.0);
        wheels
    }
}

/// Base, pitch and tip circles of the toothings that mesh, each once.
impl Stand<'_> {
    fn rims(&mut self, hinges: &[Hinge]) -> Vec<Wheel> {
        let compiled = self.compiled;
        let mechanism = &compiled.mechanism;
        let mut known = Vec::new();
        let mut rims = Vec::new();
        for id in mechanism.pairs.iter().flat_map(|pair| pair.on) {
            if known.contains(&id) {
                continue;
            }
            known.push(id);
            let toothing = mechanism.toothing(id);
            let (center, about) = (self.place(&toothing.center), self.axle(id, hinges));
            rims.extend(toothing.circles().into_iter().map(|(circle, radius)| Wheel {
                of: toothing.text.clone(),
                on: Frame::Body(id.body),
                circle,
                center,
                about,
                radius,
            }));
        }
        rims
    }

    /// The axis of a wheel: that of the joint that it turns by, in the world.
    fn axle(&self, id: ToothingId, hinges: &[Hinge]) -> Point {
        let mechanism = &self.compiled.mechanism;
        let of_body = mechanism.joints.iter().position(|joint| {
            let ends = [joint.first.frame, joint.second.frame];
            ends.contains(&Frame::Body(id.body)) && joint.form.angles.len() == 1
        });
        match (mechanism.space, of_body) {
            (Space::Spatial, Some(joint)) => hinges[joint].axis,
            _ => [0.0, 0.0, 1.0],
        }
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
fn mesh(
    of: &str,
    [(first, (a, about)), (second, (b, other))]: [(Frame, (Point, Point)); 2],
    ratio: f64,
) -> Option<[Wheel; 2]> {
    let between = difference(b, a);
    let is_beside = length(cross(about, other)) < 1e-6 && dot(between, about).abs() < 1e-9;
    let radius = length(between) / (1.0 - ratio).abs();
    let wheel = |on, center, radius| Wheel { of: of.to_string(), on, circle: PITCH, center, about, radius };
    (is_beside && radius > 0.0 && radius.is_finite())
        .then(|| [wheel(first, a, radius), wheel(second, b, ratio.abs() * radius)])
}
