//! Named places: points, markers and lines of bodies and of the ground, and their use.

use super::fold;
use super::lower::{BodyFrame, Lowering, Use};
use super::names::Part;
use super::unused::Scope;
use super::{Axes, BodyId, Expr, Frame, Function2, Place, Vector, ZERO};
use crate::diagnostics::Region;
use crate::messages;
use crate::syntax::{self, Ground, Line, Marker, MarkerAxes, Path, PlaceTerm};
use crate::units::Dimension;
use std::collections::HashMap;

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
            Some((_, tuple)) => self.vector(tuple, Dimension::LENGTH, Use::PROPERTY, "center"),
            None => Some(ZERO),
        };
        let mut points: HashMap<&str, Option<Vector>> = HashMap::new();
        for (label, tuple) in &body.points {
            let at = self.vector(tuple, Dimension::LENGTH, Use::PROPERTY, &messages::quoted(&label.text));
            points.insert(&label.text, at);
        }
        let slender = self.slender(body);
        if body.form.is_beam() {
            self.points_of_beam(body, slender.as_deref(), &mut points);
        } else if body.form.has_ends {
            let half = self.shape_length(body, "length", false).map(|length| halved(length, 0.5));
            for (end, sign) in [("start", -1.0), ("end", 1.0)] {
                let at = half.clone().map(|half| [halved(half, sign), Expr::Number(0.0), Expr::Number(0.0)]);
                if points.insert(end, at).is_some() {
                    self.shape_point_again(body, end);
                }
            }
        }
        let markers = body.markers.iter().map(|marker| (marker.name.text.as_str(), self.marker(marker)));
        let markers = markers.collect();
        BodyFrame { center, points, markers, lines: HashMap::new(), slender }
    }

    /// A rod's `start` and `end` are its own.
    pub(super) fn shape_point_again(&mut self, body: &'d syntax::Body, end: &str) {
        let written = body.points.iter().find(|(label, _)| label.text == end);
        if let Some((label, _)) = written {
            self.diagnostics.error(label.region, messages::shape_has_point(body.form.word, end));
        }
    }

    /// Markers of the ground, before anything names them.
    pub fn ground_markers(&mut self) {
        for marker in &self.definition.markers {
            let lowered = self.marker(marker);
            self.markers.insert(&marker.name.text, lowered);
        }
    }

    fn marker(&mut self, marker: &'d Marker) -> Option<(Vector, Axes)> {
        let what = messages::quoted(&marker.name.text);
        let at = self.vector(&marker.at, Dimension::LENGTH, Use::PROPERTY, &what);
        let (mut axis, mut reference, mut turns) = (None, None, Vec::new());
        for (label, given) in &marker.axes {
            match given {
                MarkerAxes::Direction(tuple) => {
                    let direction = Some(self.direction(tuple, &label.text)?);
                    if label.text == "axis" { axis = direction } else { reference = direction }
                }
                MarkerAxes::Angle(entry) => {
                    let angle = self.entry(entry, Dimension::ANGLE, Use::PROPERTY, &label.text)?;
                    let about =
                        ["about_x", "about_y", "about_z"].iter().position(|word| *word == label.text)?;
                    turns.push((about, angle));
                }
            }
        }
        if let (Some(axis), Some(reference)) = (&axis, &reference)
            && let Some(degrees) = self.degrees_between(axis, reference)
            && !(1e-6..180.0 - 1e-6).contains(&degrees)
        {
            let given = marker.axes.iter().find(|(label, _)| label.text == "reference");
            let region = given.map_or(marker.name.region, |(label, _)| label.region);
            self.diagnostics.error(region, messages::reference_along_axis());
            return None;
        }
        let axes = match axis {
            Some(axis) => Axes::Directed { axis, reference },
            // Without turns these are the axes of the body, but those of a marker, which a joint may take.
            None => Axes::Turned(turns),
        };
        Some((at?, axes))
    }

    /// Remembers that a place or line of a body has been named.
    fn use_of_body(&mut self, index: usize, text: &str) {
        let BodyFrame { points, markers, lines, .. } = &self.bodies[index];
        let key = points.get_key_value(text).map(|(key, _)| *key);
        let key = key.or_else(|| markers.get_key_value(text).map(|(key, _)| *key));
        if let Some(key) = key.or_else(|| lines.get_key_value(text).map(|(key, _)| *key)) {
            self.used.insert((Scope::Body(index), key));
        }
    }

    /// The line of a body with this name.
    pub fn body_line_named(&mut self, index: usize, text: &str) -> Option<Option<[Vector; 2]>> {
        self.use_of_body(index, text);
        self.bodies[index].lines.get(text).cloned()
    }

    /// The axes of a marker of this body.
    pub fn axes_of_marker(&mut self, body: &'d syntax::Body, label: &'d syntax::Label) -> Option<Axes> {
        let Some(Part::Body(index)) = self.names.part(&body.name.text) else { return None };
        self.use_of_body(index, &label.text);
        if let Some(marker) = self.bodies[index].markers.get(label.text.as_str()) {
            return marker.clone().map(|(_, axes)| axes);
        }
        let mut known: Vec<&str> = self.bodies[index].markers.keys().copied().collect();
        known.sort_unstable();
        let message = messages::unknown_marker(&body.name.text, &label.text, &known);
        self.diagnostics.error(label.region, message);
        None
    }

    /// Both ends of a line of a body, which must be places of that body.
    fn body_line(&mut self, body: BodyId, line: &'d Line) -> Option<[Vector; 2]> {
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

    /// Both ends of a line and what they belong to. Directions are constant, so that those of the ground may move together only.
    pub fn line_ends(&mut self, from: &PlaceTerm, to: &PlaceTerm) -> Option<(Frame, [Vector; 2])> {
        let (first, second) = (self.place(from), self.place(to));
        let (first, second) = (first?, second?);
        if fold::between(&first.at, &second.at).iter().any(Expr::varies) {
            // What they depend on is what the message names.
            let (first, second) = (self.place_of(from, Use::DIRECTION), self.place_of(to, Use::DIRECTION));
            first.and(second)?;
        }
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
        let at = self.values(&ground.at, ground.unit.as_ref(), Dimension::LENGTH, usage, "the place")?;
        let at = super::values::padded(at);
        Some(Place {
            frame: Frame::Ground,
            at,
            axes: Axes::Parallel,
            of_mean: false,
            text: ground.text.clone(),
            span: ground.region,
        })
    }

    fn place_of_body(&mut self, path: &Path) -> Option<Place> {
        let head = &path.parts[0];
        if path.parts.len() == 1
            && let Some((name, marker)) = self.markers.get_key_value(path.text.as_str())
        {
            self.used.insert((Scope::Ground, name));
            let (at, axes) = marker.clone()?;
            let (text, span) = (path.text.clone(), path.region);
            return Some(Place { frame: Frame::Ground, at, axes, of_mean: false, text, span });
        }
        let Some(Part::Body(index)) = self.names.part(&head.text) else {
            let message = match self.names.part(&head.text) {
                Some(part) => messages::no_places(&head.text, part.kind()),
                None if self.diagnostics.is_full() => return None,
                None if path.parts.len() == 1
                    && let Some(body) = self.body_with(&head.text) =>
                {
                    messages::point_without_body(body, &head.text)
                }
                None if let Some((first, last)) = self.names.indices_beside(&head.text) => {
                    messages::unknown_index(&head.text, &first, &last)
                }
                None => {
                    let similar = self.names.similar_part(&head.text, |part| matches!(part, Part::Body(_)));
                    self.names.unknown("body", &head.text, similar)
                }
            };
            self.diagnostics.error(head.region, message);
            return None;
        };
        if self.bodies.get(index).is_none() {
            self.diagnostics.error(path.region, messages::place_not_known_yet(&path.text));
            return None;
        }
        if let [_, point] = path.parts.as_slice() {
            self.use_of_body(index, &point.text);
        }
        let mean_frame = self.has_mean_frame(BodyId(index));
        let body = &self.bodies[index];
        let with_axes = |at: Vector, axes: Axes| {
            let frame = Frame::Body(BodyId(index));
            let of_mean = matches!(path.parts.last(), Some(point) if point.text == "origin") && mean_frame;
            Some(Place { frame, at, axes, of_mean, text: path.text.clone(), span: path.region })
        };
        let place = |at: Vector| with_axes(at, Axes::Parallel);
        match path.parts.as_slice() {
            [_, point] if point.text == "origin" => place(ZERO),
            [_, point]
                if point.text == "center"
                    && !body.points.contains_key("center")
                    && !self.definition.bodies[index].form.is_modal() =>
            {
                place(body.center.clone()?)
            }
            [_, point] => match body.points.get(point.text.as_str()) {
                Some(at) => place(at.clone()?),
                None if body.markers.contains_key(point.text.as_str()) => {
                    let (at, axes) = body.markers[point.text.as_str()].clone()?;
                    with_axes(at, axes)
                }
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

    /// A body with a place of this name.
    fn body_with(&self, place: &str) -> Option<&'d str> {
        let has = |frame: &BodyFrame| frame.points.contains_key(place) || frame.markers.contains_key(place);
        let index = self.bodies.iter().position(has)?;
        Some(&self.definition.bodies[index].name.text)
    }

    fn no_such_point(&mut self, index: usize, body: &str, point: &str, region: Region) {
        let frame = &self.bodies[index];
        // The centre of mass of what has the modes of a file is no node.
        let own: &[&str] = if self.definition.bodies[index].form.is_modal() { &[] } else { &["center"] };
        let mut known: Vec<&str> = frame.points.keys().chain(frame.markers.keys()).copied().collect();
        known.extend(own.iter().chain(&["origin"]));
        known.sort_unstable();
        known.dedup();
        let message = if self.definition.bodies[index].form.turns {
            messages::unknown_point(body, point, &known)
        } else {
            messages::particle_with_places(body)
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
