//! Bodies: mass, inertia, and the places that the equations name. What follows from shapes is `shapes`, what places
//! are is `places`.

use super::lower::{Lowering, Use, name};
use super::names::Part;
use super::places::has_ends;
use super::{Axes, Body, BodyKind, Expr, Inertia, NamedLine, NamedPoint, Vector, ZERO};
use crate::diagnostics::Region;
use crate::messages;
use crate::syntax::{self, Line, Shape, Space};
use crate::units::Dimension;

/// Lengths of shapes, in the order in which they are checked.
const LENGTHS: [&str; 4] = ["length", "radius", "width", "height"];
const SIZES: [&str; 3] = ["size along x", "size along y", "size along z"];

impl<'d> Lowering<'d> {
    pub(super) fn missing(&mut self, body: &'d syntax::Body, property: &str) {
        let message =
            messages::missing_property(body.shape.text(), &body.name.text, property, self.definition.space);
        self.diagnostics.error(body.name.region, message);
    }

    /// A body with its mass, inertia and places.
    pub fn body(&mut self, body: &'d syntax::Body) -> Option<Body> {
        let mass = self.mass(body);
        let shape = self.shape_inertia(body, mass.as_ref().map(|(mass, _)| mass));
        let written = match self.definition.space {
            Space::Planar => self.planar_inertia(body),
            Space::Spatial => self.spatial_inertia(body),
        };
        let inertia = match written {
            Some(written) => written,
            None if body.shape == Shape::Body => {
                self.missing(body, "inertia");
                None
            }
            None => shape
                .map(|moments| (Inertia { moments, products: ZERO, axes: Axes::Parallel }, body.name.region)),
        };
        let index = match self.names.part(&body.name.text)? {
            Part::Body(index) => index,
            _ => return None,
        };
        let ((mass, mass_span), (inertia, inertia_span)) = (mass?, inertia?);
        let (points, lines) = (self.named_points(index, body)?, self.named_lines(index, body)?);
        let mut dimensions = Vec::new();
        for property in LENGTHS.into_iter().filter(|it| body.property(it).is_some()) {
            dimensions.push((property, self.shape_length(body, property, false)?));
        }
        if body.vector("size").is_some() {
            dimensions.extend(SIZES.into_iter().zip(self.size(body, false)?));
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

    /// As written, or by the density of the shape.
    fn mass(&mut self, body: &'d syntax::Body) -> Option<(Expr, Region)> {
        match (body.property("mass"), body.property("density")) {
            (Some((label, entry)), None) => {
                let mass = self.entry(entry, Dimension::MASS, Use::PROPERTY, "mass")?;
                Some((mass, label.region.to(entry.value.region)))
            }
            (None, Some((label, entry))) => {
                let density = self.entry(entry, Dimension::DENSITY, Use::PROPERTY, "density");
                let volume = self.volume(body);
                let mass = super::fold::binary(super::Function2::Mul, density?, volume?);
                Some((mass, label.region.to(entry.value.region)))
            }
            (Some(_), Some((label, _))) => {
                self.diagnostics.error(label.region, messages::mass_and_density(&body.name.text));
                None
            }
            (None, None) => {
                self.missing(body, "mass");
                None
            }
        }
    }

    /// The moment as written; `Some(None)` after an error, `None` if there is none.
    fn planar_inertia(&mut self, body: &'d syntax::Body) -> Option<Option<(Inertia, Region)>> {
        let (label, entry) = body.property("inertia")?;
        let region = label.region.to(entry.value.region);
        let value = self.entry(entry, Dimension::INERTIA, Use::PROPERTY, "inertia");
        let moments = |value| [Expr::Number(0.0), Expr::Number(0.0), value];
        Some(
            value.map(|value| {
                (Inertia { moments: moments(value), products: ZERO, axes: Axes::Parallel }, region)
            }),
        )
    }

    /// The tensor as written; `Some(None)` after an error, `None` if there is none.
    fn spatial_inertia(&mut self, body: &'d syntax::Body) -> Option<Option<(Inertia, Region)>> {
        let Some((label, tuple)) = body.vector("inertia") else {
            let beside = body.vector("products").map(|(label, _)| label).or(body.inertia_axes.as_ref())?;
            let message = messages::products_without_inertia(&body.name.text);
            self.diagnostics.error(beside.region, message);
            return Some(None);
        };
        let region = label.region.to(tuple.region);
        let moments = self.vector(tuple, Dimension::INERTIA, Use::PROPERTY, "inertia");
        let products = match body.vector("products") {
            Some((_, tuple)) => self.vector(tuple, Dimension::INERTIA, Use::PROPERTY, "products"),
            None => Some(ZERO),
        };
        let axes = match &body.inertia_axes {
            Some(marker) => self.axes_of_marker(body, marker),
            None => Some(Axes::Parallel),
        };
        let inertia = moments.zip(products).zip(axes);
        Some(inertia.map(|((moments, products), axes)| (Inertia { moments, products, axes }, region)))
    }

    /// Points in the order written, those of the shape first.
    fn named_points(&self, index: usize, body: &'d syntax::Body) -> Option<Vec<NamedPoint>> {
        let own = if has_ends(body.shape) { ["start", "end"].as_slice() } else { &[] };
        let span = body.name.region;
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
            let [from, to]: [Vector; 2] = self.bodies[index].lines.get(line.name.text.as_str())?.clone()?;
            Some(NamedLine { name: name(&line.name), from, to })
        };
        body.lines.iter().map(line).collect()
    }
}
