//! What follows from the shape of a body: moments of inertia about the centre of mass, and the volume.
//!
//! In the plane: rod m (3 r² + L²)/12, disk m r²/2, box m (w² + h²)/12, particle 0, about z.
//! In space, along body axes: rod and cylinder along x, (m r²/2, m (3 r² + L²)/12, the same); disk across z,
//! (m (3 r² + t²)/12, the same, m r²/2); sphere 2 m r²/5; box m (b² + c²)/12 and so on. A rod without radius has r = 0, a
//! disk without thickness t = 0.

use super::lower::{Lowering, Use};
use super::{Expr, Function2, Vector, ZERO, fold};
use crate::messages;
use crate::syntax::{self, Shape, Space};
use crate::units::Dimension;

impl<'d> Lowering<'d> {
    /// A length of a shape; what is missing is said only once, when the body itself is lowered.
    pub fn shape_length(&mut self, body: &'d syntax::Body, property: &str, report: bool) -> Option<Expr> {
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

    /// The edges of a box in space.
    pub fn size(&mut self, body: &'d syntax::Body, report: bool) -> Option<Vector> {
        let Some((label, tuple)) = body.vector("size") else {
            if report {
                self.missing(body, "size");
            }
            return None;
        };
        let size = self.vector(tuple, Dimension::LENGTH, Use::PROPERTY, "size")?;
        let short = size.iter().find_map(|edge| match edge {
            Expr::Number(value) if *value <= 0.0 => Some(*value),
            _ => None,
        });
        if let (true, Some(value)) = (report, short) {
            let message = messages::not_positive("size", &body.name.text, value);
            self.diagnostics.error(label.region.to(tuple.region), message);
            return None;
        }
        Some(size)
    }

    /// The moments that follow from the shape; its lengths are checked whether they are needed or not.
    pub fn shape_inertia(&mut self, body: &'d syntax::Body, mass: Option<&Expr>) -> Option<Vector> {
        if self.definition.space == Space::Spatial {
            return self.spatial_moments(body, mass);
        }
        let (squares, divisor) = match body.shape {
            Shape::Body | Shape::Sphere | Shape::Cylinder => return None,
            Shape::Particle => return Some(ZERO),
            Shape::Rod => {
                let (length, radius) =
                    (self.shape_length(body, "length", true), self.if_given(body, "radius"));
                (across(length?, radius?), 12.0)
            }
            Shape::Disk => {
                let (radius, thickness) =
                    (self.shape_length(body, "radius", true), self.if_given(body, "thickness"));
                thickness?;
                (square(radius?), 2.0)
            }
            Shape::Box => {
                self.if_given(body, "thickness")?;
                let (width, height) =
                    (self.shape_length(body, "width", true), self.shape_length(body, "height", true));
                (add(square(width?), square(height?)), 12.0)
            }
        };
        Some([Expr::Number(0.0), Expr::Number(0.0), over(times(mass?.clone(), squares), divisor)])
    }

    fn spatial_moments(&mut self, body: &'d syntax::Body, mass: Option<&Expr>) -> Option<Vector> {
        let part = |mass: &Expr, squares: Expr, divisor: f64| over(times(mass.clone(), squares), divisor);
        Some(match body.shape {
            Shape::Body => return None,
            Shape::Particle => ZERO,
            Shape::Rod | Shape::Cylinder => {
                let length = self.shape_length(body, "length", true);
                let radius = match body.shape {
                    Shape::Rod => self.if_given(body, "radius"),
                    _ => self.shape_length(body, "radius", true),
                };
                let (length, radius, mass) = (length?, radius?, mass?);
                let along = part(mass, square(radius.clone()), 2.0);
                let across = part(mass, across(length, radius), 12.0);
                [along, across.clone(), across]
            }
            Shape::Disk => {
                let (radius, thickness) =
                    (self.shape_length(body, "radius", true), self.if_given(body, "thickness"));
                let (radius, thickness, mass) = (radius?, thickness?, mass?);
                let across = match thickness {
                    Expr::Number(0.0) => part(mass, square(radius.clone()), 4.0),
                    thickness => part(mass, across(thickness, radius.clone()), 12.0),
                };
                [across.clone(), across, part(mass, square(radius), 2.0)]
            }
            Shape::Sphere => {
                let radius = square(self.shape_length(body, "radius", true)?);
                let moment = part(mass?, times(Expr::Number(2.0), radius), 5.0);
                [moment.clone(), moment.clone(), moment]
            }
            Shape::Box => {
                let [a, b, c] = self.size(body, true)?.map(square);
                let mass = mass?;
                [
                    part(mass, add(b.clone(), c.clone()), 12.0),
                    part(mass, add(a.clone(), c), 12.0),
                    part(mass, add(a, b), 12.0),
                ]
            }
        })
    }

    /// m³.
    pub fn volume(&mut self, body: &'d syntax::Body) -> Option<Expr> {
        let pi = |factor: f64| Expr::Number(factor * core::f64::consts::PI);
        match body.shape {
            Shape::Rod if body.property("radius").is_none() => self.no_volume(body, "radius"),
            Shape::Disk if body.property("thickness").is_none() => self.no_volume(body, "thickness"),
            Shape::Box if self.definition.space == Space::Planar && body.property("thickness").is_none() => {
                self.no_volume(body, "thickness")
            }
            Shape::Rod | Shape::Cylinder => {
                let (length, radius) =
                    (self.shape_length(body, "length", false)?, self.shape_length(body, "radius", false)?);
                Some(times(times(pi(1.0), square(radius)), length))
            }
            Shape::Sphere => {
                let radius = self.shape_length(body, "radius", false)?;
                Some(times(pi(4.0 / 3.0), times(radius.clone(), square(radius))))
            }
            Shape::Disk => {
                let (radius, thickness) =
                    (self.shape_length(body, "radius", false)?, self.shape_length(body, "thickness", false)?);
                Some(times(times(pi(1.0), square(radius)), thickness))
            }
            Shape::Box if self.definition.space == Space::Planar => {
                let edges = ["width", "height", "thickness"].map(|edge| self.shape_length(body, edge, false));
                let [a, b, c] = edges;
                Some(times(times(a?, b?), c?))
            }
            Shape::Box => {
                let [a, b, c] = self.size(body, false)?;
                Some(times(times(a, b), c))
            }
            Shape::Body | Shape::Particle => None,
        }
    }

    /// What a density alone does not say.
    fn no_volume(&mut self, body: &'d syntax::Body, missing: &str) -> Option<Expr> {
        let message = messages::density_needs(body.shape.text(), &body.name.text, missing);
        self.diagnostics.error(body.name.region, message);
        None
    }

    /// A length that may be left out, and is then zero.
    fn if_given(&mut self, body: &'d syntax::Body, property: &str) -> Option<Expr> {
        match body.property(property) {
            Some(_) => self.shape_length(body, property, true),
            None => Some(Expr::Number(0.0)),
        }
    }
}

/// 3 r² + L², twelve times a cylinder's inertia across its axis for a mass of one.
fn across(length: Expr, radius: Expr) -> Expr {
    add(times(Expr::Number(3.0), square(radius)), square(length))
}

fn square(length: Expr) -> Expr {
    times(length.clone(), length)
}

fn times(a: Expr, b: Expr) -> Expr {
    fold::binary(Function2::Mul, a, b)
}

fn add(a: Expr, b: Expr) -> Expr {
    fold::binary(Function2::Add, a, b)
}

fn over(a: Expr, divisor: f64) -> Expr {
    fold::binary(Function2::Div, a, Expr::Number(divisor))
}
