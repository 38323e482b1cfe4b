//! Bodies, their shapes and named places; places of bodies and of the ground.
//!
//! Moments of inertia about the centre of mass: rod m L²/12, disk m r²/2, box m (w² + h²)/12, particle 0.

use super::fold;
use super::lower::{BodyFrame, Lowering, Use, name};
use super::names::Part;
use super::{Body, BodyId, BodyKind, Expr, Frame, Function2, NamedLine, NamedPoint, Place};
use crate::diagnostics::Region;
use crate::messages;
use crate::syntax::{self, Ground, Line, Path, PlaceTerm, Shape};
use crate::units::Dimension;
use proc_macro2::Span;
use std::collections::HashMap;

const ORIGIN: [Expr; 2] = [Expr::Number(0.0), Expr::Number(0.0)];

impl<'d> Lowering<'d> {
    /// The named places of all bodies, first of all that needs places.
    pub fn body_frames(&mut self) {
        for body in &self.definition.bodies {
            let frame = self.body_frame(body);
            self.bodies.push(frame);
        }
        // Lines name points of their body, so all points come first.
        for (index, body) in self.definition.bodies.iter().enumerate() {
            for line in &body.lines {
                let ends = self.body_line(BodyId(index), line);
                self.bodies[index].lines.insert(&line.name.text, ends);
            }
        }
    }

    fn body_frame(&mut self, body: &'d syntax::Body) -> BodyFrame<'d> {
        let center = match &body.center {
            Some((_, pair)) => self.pair(pair, Dimension::LENGTH, Use::PROPERTY, "center"),
            None => Some(ORIGIN),
        };
        let mut points: HashMap<&str, Option<[Expr; 2]>> = HashMap::new();
        for (label, pair) in &body.points {
            let at = self.pair(pair, Dimension::LENGTH, Use::PROPERTY, &messages::quoted(&label.text));
            points.insert(&label.text, at);
        }
        if body.shape == Shape::Rod {
            let half = self.shape_length(body, "length", false).map(|length| halved(length, 0.5));
            for (end, sign) in [("start", -1.0), ("end", 1.0)] {
                let at = half.clone().map(|half| [halved(half, sign), Expr::Number(0.0)]);
                if points.insert(end, at).is_some() {
                    self.shape_point_again(body, end);
                }
            }
        }
        BodyFrame { center, points, lines: HashMap::new() }
    }

    /// A rod's `start` and `end` are its own.
    fn shape_point_again(&mut self, body: &'d syntax::Body, end: &str) {
        let written = body.points.iter().find(|(label, _)| label.text == end);
        if let Some((label, _)) = written {
            self.diagnostics.error(label.region, messages::rod_has_end(end));
        }
    }

    /// A length of a shape; what is missing is said only once, when the body itself is lowered.
    fn shape_length(&mut self, body: &'d syntax::Body, property: &str, report: bool) -> Option<Expr> {
        let Some((label, entry)) = body.property(property) else {
            if report {
                self.missing(body, property);
            }
            return None;
        };
        let length = self.entry(entry, Dimension::LENGTH, Use::PROPERTY, property)?;
        if let (true, Expr::Number(value)) = (report, &length)
            && *value <= 0.0
        {
            let message = messages::not_positive(property, &body.name.text, *value);
            self.diagnostics.error(label.region.to(entry.value.region), message);
            return None;
        }
        Some(length)
    }

    fn missing(&mut self, body: &'d syntax::Body, property: &str) {
        let message = messages::missing_property(body.shape.text(), &body.name.text, property);
        self.diagnostics.error(body.name.region, message);
    }

    /// A body with its mass, inertia and places.
    pub fn body(&mut self, body: &'d syntax::Body) -> Option<Body> {
        let mass = self.mass(body);
        let shape = self.shape_inertia(body, mass.as_ref().map(|(mass, _)| mass));
        let inertia = match body.property("inertia") {
            Some((label, entry)) => {
                let region = label.region.to(entry.value.region);
                let value = self.entry(entry, Dimension::INERTIA, Use::PROPERTY, "inertia");
                value.map(|value| (value, region.span()))
            }
            None if body.shape == Shape::Body => {
                self.missing(body, "inertia");
                None
            }
            None => shape.map(|value| (value, body.name.region.span())),
        };
        let index = match self.names.part(&body.name.text)? {
            Part::Body(index) => index,
            _ => return None,
        };
        let ((mass, mass_span), (inertia, inertia_span)) = (mass?, inertia?);
        let (points, lines) = (self.named_points(index, body)?, self.named_lines(index, body)?);
        let written =
            ["length", "radius", "width", "height"].into_iter().filter(|it| body.property(it).is_some());
        let written: Vec<&'static str> = written.collect();
        let mut dimensions = Vec::new();
        for property in written {
            dimensions.push((property, self.shape_length(body, property, false)?));
        }
        Some(Body {
            dimensions,
            name: name(&body.name),
            kind: if body.shape == Shape::Particle { BodyKind::Particle } else { BodyKind::Rigid },
            mass,
            mass_span,
            inertia,
            inertia_span,
            center: self.bodies[index].center.clone()?,
            points,
            lines,
        })
    }

    fn mass(&mut self, body: &'d syntax::Body) -> Option<(Expr, Span)> {
        let Some((label, entry)) = body.property("mass") else {
            self.missing(body, "mass");
            return None;
        };
        let mass = self.entry(entry, Dimension::MASS, Use::PROPERTY, "mass")?;
        Some((mass, label.region.to(entry.value.region).span()))
    }

    /// The inertia that follows from the shape; its lengths are checked whether it is needed or not.
    fn shape_inertia(&mut self, body: &'d syntax::Body, mass: Option<&Expr>) -> Option<Expr> {
        let square = |length: Expr| fold::binary(Function2::Mul, length.clone(), length);
        let (squares, divisor) = match body.shape {
            Shape::Body => return None,
            Shape::Particle => return Some(Expr::Number(0.0)),
            Shape::Rod => (square(self.shape_length(body, "length", true)?), 12.0),
            Shape::Disk => (square(self.shape_length(body, "radius", true)?), 2.0),
            Shape::Box => {
                let (width, height) =
                    (self.shape_length(body, "width", true), self.shape_length(body, "height", true));
                (fold::binary(Function2::Add, square(width?), square(height?)), 12.0)
            }
        };
        let product = fold::binary(Function2::Mul, mass?.clone(), squares);
        Some(fold::binary(Function2::Div, product, Expr::Number(divisor)))
    }

    /// Points in the order written, those of the shape first.
    fn named_points(&self, index: usize, body: &'d syntax::Body) -> Option<Vec<NamedPoint>> {
        let own = if body.shape == Shape::Rod { ["start", "end"].as_slice() } else { &[] };
        let span = body.name.region.span();
        let own = own.iter().map(|text| super::Name { text: (*text).to_string(), span });
        let written = body.points.iter().map(|(label, _)| name(label));
        own.chain(written)
            .map(|name| {
                let at = self.bodies[index].points.get(name.text.as_str())?.clone()?;
                Some(NamedPoint { name, at })
            })
            .collect()
    }

    fn named_lines(&self, index: usize, body: &'d syntax::Body) -> Option<Vec<NamedLine>> {
        let line = |line: &'d Line| {
            let [from, to] = self.bodies[index].lines.get(line.name.text.as_str())?.clone()?;
            Some(NamedLine { name: name(&line.name), from, to })
        };
        body.lines.iter().map(line).collect()
    }

    /// Both ends of a line of a body, which must be places of that body.
    fn body_line(&mut self, body: BodyId, line: &'d Line) -> Option<[[Expr; 2]; 2]> {
        let own = &self.definition.bodies[body.0].name.text;
        let mut ends = [None, None];
        for (end, term) in ends.iter_mut().zip([&line.from, &line.to]) {
            if let PlaceTerm::Named(path) = term
                && path.parts.len() == 1
                && self.bodies[body.0].points.contains_key(path.text.as_str())
            {
                self.diagnostics.error(path.region, messages::point_without_body(own, &path.text));
                return None;
            }
            let place = self.place(term)?;
            if place.frame != Frame::Body(body) {
                self.diagnostics.error(term.region(), messages::line_leaves_body(&place.text, own));
                return None;
            }
            *end = Some(place.at);
        }
        let [from, to] = ends;
        Some([from?, to?])
    }

    /// Lines of the ground.
    pub fn ground_lines(&mut self) {
        for line in &self.definition.lines {
            let ends = self.line_ends(&line.from, &line.to);
            let ends = ends.and_then(|(frame, ends)| {
                if frame != Frame::Ground {
                    self.diagnostics.error(line.from.region(), messages::line_outside_body());
                    return None;
                }
                Some(ends)
            });
            self.lines.push(ends);
        }
    }

    /// Both ends of a line and what they belong to. Directions are constant, so the ground's must not move.
    pub fn line_ends(&mut self, from: &PlaceTerm, to: &PlaceTerm) -> Option<(Frame, [[Expr; 2]; 2])> {
        let (first, second) = (self.place_of(from, Use::DIRECTION), self.place_of(to, Use::DIRECTION));
        let (first, second) = (first?, second?);
        if first.frame != second.frame {
            let region = from.region().to(to.region());
            self.diagnostics.error(region, messages::line_between_bodies(&first.text, &second.text));
            return None;
        }
        if self.is_particle(first.frame) {
            self.diagnostics.error(from.region(), messages::particle_turns(&first.text));
            return None;
        }
        Some((first.frame, [first.at, second.at]))
    }

    /// A point of a body or of the ground.
    pub fn place(&mut self, place: &PlaceTerm) -> Option<Place> {
        self.place_of(place, Use::GROUND)
    }

    fn place_of(&mut self, place: &PlaceTerm, ground: Use) -> Option<Place> {
        match place {
            PlaceTerm::Named(path) => self.place_of_body(path),
            PlaceTerm::Ground(term) => self.place_of_ground(term, ground),
        }
    }

    fn place_of_ground(&mut self, ground: &Ground, usage: Use) -> Option<Place> {
        let at = self.two(&ground.at, ground.unit.as_ref(), Dimension::LENGTH, usage, "the place")?;
        Some(Place { frame: Frame::Ground, at, text: ground.text.clone(), span: ground.region.span() })
    }

    fn place_of_body(&mut self, path: &Path) -> Option<Place> {
        let head = &path.parts[0];
        let Some(Part::Body(index)) = self.names.part(&head.text) else {
            let message = match self.names.part(&head.text) {
                Some(part) => messages::no_places(&head.text, part.kind()),
                None if self.diagnostics.is_full() => return None,
                None => {
                    let similar = self.names.similar_part(&head.text, |part| matches!(part, Part::Body(_)));
                    messages::unknown("body", &head.text, similar)
                }
            };
            self.diagnostics.error(head.region, message);
            return None;
        };
        let place = |at: [Expr; 2]| {
            let frame = Frame::Body(BodyId(index));
            Some(Place { frame, at, text: path.text.clone(), span: path.region.span() })
        };
        match path.parts.as_slice() {
            [_, point] if point.text == "origin" => place(ORIGIN),
            [_, point] if point.text == "center" => place(self.bodies[index].center.clone()?),
            [_, point] => match self.bodies[index].points.get(point.text.as_str()) {
                Some(at) => place(at.clone()?),
                None => {
                    self.no_such_point(index, &head.text, &point.text, point.region);
                    None
                }
            },
            [_] => {
                self.diagnostics.error(path.region, messages::body_as_place(&path.text));
                None
            }
            _ => {
                self.diagnostics.error(path.region, messages::not_a_place_name(&path.text));
                None
            }
        }
    }

    fn no_such_point(&mut self, index: usize, body: &str, point: &str, region: Region) {
        let mut known: Vec<&str> = self.bodies[index].points.keys().copied().collect();
        known.extend(["center", "origin"]);
        known.sort_unstable();
        let particle = self.definition.bodies[index].shape == Shape::Particle;
        let message = if particle {
            messages::particle_with_places(body)
        } else {
            messages::unknown_point(body, point, &known)
        };
        self.diagnostics.error(region, message);
    }
}

/// A length times a number.
fn halved(length: Expr, factor: f64) -> Expr {
    if factor == -1.0 {
        return fold::unary(super::Function1::Neg, length);
    }
    fold::binary(Function2::Mul, length, Expr::Number(factor))
}
