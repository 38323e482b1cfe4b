//! Places of bodies and of the ground, lines through two of them.

use super::laws::May;
use super::values::factor;
use super::{Read, Reader};
use crate::error::DefinitionError;
use crate::expression::Expression;
use crate::json::{field, list, name, optional, text};
use crate::kinematics::Place;
use crate::vector::*;
use serde_json::Value;

/// At which ends of a line that move are compared, s.
const TIMES: [f64; 4] = [0.1, 0.37, 1.3, 17.0];

impl<'t> Reader<'t> {
    /// `{"place": NAME}` or `{"ground": [EXPR, …], "unit": …}`.
    pub fn place(&self, node: &Value, part: &str) -> Read<Place> {
        if optional(node, "ground").is_some() {
            return self.ground(node, part);
        }
        let path = text(node, "place", part)?;
        self.named_place(path).ok_or_else(|| DefinitionError::unknown(part, path))
    }

    /// A point or marker of a body, `body.name`; in space without a dot a marker of the ground.
    pub fn named_place(&self, path: &str) -> Option<Place> {
        let Some((body, point)) = path.rsplit_once('.') else { return self.ground_marker(path) };
        let Some(index) = self.body_by_name.get(body) else { return self.ground_marker(path) };
        let body = &self.bodies[*index];
        let local = minus(*body.points.get(point)?, body.center);
        let axes = body.markers.get(point).copied().unwrap_or(IDENTITY);
        let of_mean = point == "origin" && body.beam.as_ref().is_some_and(|beam| beam.is_free());
        Some(Place { body: Some(*index), local, axes, moving: None, of_mean })
    }

    fn ground_marker(&self, path: &str) -> Option<Place> {
        let markers = list(self.tree, "markers", path).ok()?;
        let marker = markers.iter().find(|marker| name(marker, path) == Ok(path))?;
        let local = self.tuple(marker, "value", path).ok()?;
        Some(Place {
            body: None,
            local,
            axes: self.marker_axes(marker, path).ok()?,
            moving: None,
            of_mean: false,
        })
    }

    fn ground(&self, node: &Value, part: &str) -> Read<Place> {
        let components = self.ground_components(node, part)?;
        let mut place = Place { body: None, local: ZERO, axes: IDENTITY, moving: None, of_mean: false };
        let known = [0, 1, 2].map(|k| components[k].constant());
        match known {
            [Some(x), Some(y), Some(z)] => place.local = [x, y, z],
            _ => place.moving = Some(Box::new(components)),
        }
        if place.local.iter().all(|x| x.is_finite()) {
            return Ok(place);
        }
        Err(DefinitionError::value(part, "a place of the ground is not finite"))
    }

    /// In SI, of time.
    pub fn ground_components(&self, node: &Value, part: &str) -> Read<[Expression; 3]> {
        let values =
            field(node, "ground", part)?.as_array().filter(|values| values.len() == self.dimension());
        let values = values.ok_or_else(|| DefinitionError::malformed(part, "a place of this dimension"))?;
        let unit = node.get("unit").and_then(Value::as_str);
        factor(unit, part)?;
        let mut components = [const { Expression::Number(0.0) }; 3];
        for (component, value) in components.iter_mut().zip(values) {
            *component = self.law_in_unit(value, unit, part, May::Time)?.expression;
        }
        Ok(components)
    }

    /// A line's first place and its direction in the axes of that place's body.
    pub fn line(&self, node: &Value, part: &str) -> Read<(Place, V3)> {
        let node = match optional(node, "line") {
            Some(_) => self.named_line(text(node, "line", part)?, part)?,
            None => node,
        };
        let (from, to) =
            (self.place(field(node, "from", part)?, part)?, self.place(field(node, "to", part)?, part)?);
        if from.body != to.body {
            return Err(DefinitionError::value(part, "a line joins places of two bodies"));
        }
        let ends_at = |time: f64| minus(to.at(time), from.at(time));
        let span = ends_at(0.0);
        // What is no number is no direction that stays.
        let stays = |time: &f64| norm(minus(ends_at(*time), span)) <= 1e-12 * norm(span);
        if !TIMES.iter().all(stays) {
            return Err(DefinitionError::not_there_yet(part, "a line that turns by itself"));
        }
        let along = unit(span);
        let along = along.ok_or_else(|| DefinitionError::value(part, "a line has no direction"))?;
        Ok((Place { axes: IDENTITY, ..from }, along))
    }

    /// `body.line`.
    fn named_line(&self, path: &str, part: &str) -> Read<&'t Value> {
        let unknown = || DefinitionError::unknown(part, path);
        let (body, line) = path.rsplit_once('.').ok_or_else(unknown)?;
        let bodies = list(self.tree, "bodies", part)?;
        let body = bodies.iter().find(|node| name(node, part) == Ok(body)).ok_or_else(unknown)?;
        list(body, "lines", part)?.iter().find(|node| name(node, part) == Ok(line)).ok_or_else(unknown)
    }
}
