//! Bodies: mass, inertia, and the places that the equations name. What follows from shapes is `shapes`, what places
//! are is `places`.

use super::deforms::{self, Deforms};
use super::lower::{Lowering, Use, name};
use super::names::Part;
use super::{Axes, Body, Expr, Inertia, NamedLine, NamedPoint, Vector, ZERO};
use crate::diagnostics::Region;
use crate::messages;
use crate::syntax::{self, Line, Space};
use crate::units::Dimension;

impl<'d> Lowering<'d> {
    pub(super) fn missing(&mut self, body: &'d syntax::Body, property: &str) {
        let message =
            messages::missing_property(body.form.word, &body.name.text, property, self.definition.space);
        self.diagnostics.error(body.name.region, message);
    }

    /// A body with its mass, inertia and places.
    pub fn body(&mut self, body: &'d syntax::Body) -> Option<Body> {
        let mass = if body.form.is_modal() { self.mass_of_modal(body) } else { self.mass(body) };
        let shape = self.shape_inertia(body, mass.as_ref().map(|(mass, _)| mass));
        let written = match self.definition.space {
            Space::Planar => self.planar_inertia(body),
            Space::Spatial => self.spatial_inertia(body),
        };
        let inertia = match written {
            Some(written) => written,
            None if body.form.is_modal() => {
                body.reduced().map(|reduced| (deforms::inertia(reduced), body.name.region))
            }
            None if body.form.states_inertia(self.definition.space) => {
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
        let slender = self.bodies[index].slender.clone();
        let deforms = match body.form.deforms {
            crate::forms::Deforms::Not => None,
            crate::forms::Deforms::Beam => Some(Deforms::Beam(Box::new(self.beam(body, slender)?))),
            crate::forms::Deforms::Modal => Some(Deforms::Modal(self.modal(body)?)),
        };
        let ((mass, mass_span), (inertia, inertia_span)) = (mass?, inertia?);
        let (points, lines) = (self.named_points(index, body)?, self.named_lines(index, body)?);
        let dimensions = self.dimensions(body)?;
        let toothings = self.toothings(index, body)?;
        let mut lowered = Body {
            dimensions,
            name: name(&body.name),
            form: body.form,
            mass,
            mass_span,
            inertia,
            inertia_span,
            center: self.bodies[index].center.clone()?,
            points,
            markers: self.named_markers(index, body)?,
            lines,
            toothings,
            deforms,
            file: body.modal.as_ref().and_then(|modal| Some(modal.read.as_ref()?.on_disk.clone())),
        };
        lowered.spin_of_beam();
        Some(lowered)
    }

    /// As written, or by the density of the shape.
    fn mass(&mut self, body: &'d syntax::Body) -> Option<(Expr, Region)> {
        match (body.property("mass"), body.property("density")) {
            (Some((_, entry)), None) => {
                let mass = self.entry(entry, Dimension::MASS, Use::PROPERTY, "mass")?;
                Some((mass, entry.value.region))
            }
            (None, Some((_, entry))) => {
                let density = self.entry(entry, Dimension::DENSITY, Use::PROPERTY, "density");
                let volume = self.volume(body);
                let mass = super::fold::binary(super::Function2::Mul, density?, volume?);
                Some((mass, entry.value.region))
            }
            (Some((mass, _)), Some((density, _))) => {
                let (message, note) =
                    (messages::mass_and_density(&body.name.text), messages::property_here("mass"));
                self.diagnostics.conflict(density.region, message, mass.region, note);
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
        let (_, entry) = body.property("inertia")?;
        let region = entry.value.region;
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
        let Some((_, tuple)) = body.vector("inertia") else {
            let beside = body.vector("products").map(|(label, _)| label).or(body.inertia_axes.as_ref())?;
            let message = messages::products_without_inertia(&body.name.text);
            self.diagnostics.error(beside.region, message);
            return Some(None);
        };
        let region = tuple.region;
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
        let own: &[&str] = match body.form {
            form if form.is_beam() => &["start", "center", "end"],
            form if form.has_ends => &["start", "end"],
            _ => &[],
        };
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

    fn named_markers(&mut self, index: usize, body: &'d syntax::Body) -> Option<Vec<NamedPoint>> {
        let markers = body.markers.iter().map(|marker| {
            let (at, _) = self.bodies[index].markers.get(marker.name.text.as_str())?.clone()?;
            Some(NamedPoint { name: name(&marker.name), at })
        });
        markers.collect()
    }

    fn named_lines(&self, index: usize, body: &'d syntax::Body) -> Option<Vec<NamedLine>> {
        let line = |line: &'d Line| {
            let [from, to]: [Vector; 2] = self.bodies[index].lines.get(line.name.text.as_str())?.clone()?;
            Some(NamedLine { name: name(&line.name), from, to })
        };
        body.lines.iter().map(line).collect()
    }
}
