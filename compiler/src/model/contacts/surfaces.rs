//! Surfaces in SI: places and lengths, directions of unit length in the axes of their places.

use super::Found;
use crate::diagnostics::Region;
use crate::forms::SurfaceKind;
use crate::messages;
use crate::model::joints::LowerLine;
use crate::model::lower::{Lowering, Use};
use crate::model::names::Part;
use crate::model::unused::Scope;
use crate::model::{Axes, BodyId, Curve, Expr, Frame, Function1, Place, Vector, fold, loads::normalised};
use crate::syntax::{self, Path, PlaceTerm, TermKind};
use crate::units::Dimension;
use std::sync::Arc;

/// Passes for the foot on a profile, and the most of them.
const REFINED: usize = 3;
const MOST_REFINED: f64 = 8.0;

/// What may touch another.
#[derive(Clone, Debug)]
pub struct Surface {
    pub shape: Shape,
    pub text: String,
    pub region: Region,
}

#[derive(Clone, Debug)]
#[expect(clippy::large_enum_variant, reason = "there are few of them, and each lives by itself")]
pub enum Shape {
    /// A point, circle or sphere, which is solid inside of its radius.
    Round {
        place: Place,
        radius: Expr,
    },
    /// A hole or socket, which is free there.
    Hollow {
        place: Place,
        radius: Expr,
    },
    /// Free where the normal points to.
    Flat {
        place: Place,
        normal: Vector,
    },
    Bar {
        ends: [Place; 2],
        radius: Expr,
    },
    Polygon(Vec<Place>),
    /// Solid within a closed curve in polar form about the place, to which a base is added.
    Profile {
        place: Place,
        curve: Arc<Curve>,
        base: Expr,
    },
    Cylinder {
        place: Place,
        axis: Vector,
        radius: Expr,
        length: Option<Expr>,
    },
    Bore {
        place: Place,
        axis: Vector,
        radius: Expr,
        length: Option<Expr>,
    },
    Rim {
        place: Place,
        axis: Vector,
        radius: Expr,
    },
}

impl Shape {
    pub fn place(&self) -> &Place {
        match self {
            Shape::Round { place, .. }
            | Shape::Hollow { place, .. }
            | Shape::Flat { place, .. }
            | Shape::Profile { place, .. }
            | Shape::Cylinder { place, .. }
            | Shape::Bore { place, .. }
            | Shape::Rim { place, .. } => place,
            Shape::Bar { ends: [place, _], .. } => place,
            Shape::Polygon(places) => &places[0],
        }
    }

    /// As users call it, for messages.
    pub fn kind(&self) -> &'static str {
        match self {
            Shape::Round { .. } => "a point, circle or sphere",
            Shape::Hollow { .. } => "a hole or socket",
            Shape::Flat { .. } => "a half-plane or plane",
            Shape::Bar { .. } => "a segment or capsule",
            Shape::Polygon(_) => "a polygon",
            Shape::Profile { .. } => "a profile",
            Shape::Cylinder { .. } => "a cylinder",
            Shape::Bore { .. } => "a bore",
            Shape::Rim { .. } => "the rim of a disk",
        }
    }
}

impl<'d> Lowering<'d> {
    /// A surface by its name, or that of a sphere or disk.
    pub(super) fn surface(&mut self, path: &Path) -> Option<Surface> {
        let definition = self.definition;
        let Some(index) = self.names.surface(&path.text) else { return self.surface_of_body(path) };
        self.used.insert((Scope::Surface, &definition.surfaces[index].name.text));
        match &self.contacts.surfaces[index] {
            Found::Known(surface) => return Some(Surface { region: path.region, ..surface.clone() }),
            Found::Wrong | Found::Open => return None,
            Found::Unread => {}
        }
        let written = &definition.surfaces[index];
        let shape = self.shape(written);
        let surface = shape.map(|shape| Surface { shape, text: path.text.clone(), region: path.region });
        self.contacts.surfaces[index] = surface.clone().map_or(Found::Wrong, Found::Known);
        surface
    }

    fn surface_of_body(&mut self, path: &Path) -> Option<Surface> {
        let definition = self.definition;
        let is_round = |index: usize| matches!(definition.bodies[index].form.word, "sphere" | "disk");
        if let [body, own] = &path.parts[..]
            && own.text == "surface"
            && let Some(Part::Body(index)) = self.names.part(&body.text)
            && is_round(index)
        {
            let written = &definition.bodies[index];
            let (_, entry) = written.property("radius")?;
            let radius = self.entry(entry, Dimension::LENGTH, Use::PROPERTY, "radius")?;
            let at = self.bodies[index].center.clone()?;
            let (text, span) = (format!("{}.center", body.text), path.region);
            let place = Place {
                frame: Frame::Body(BodyId(index)),
                at,
                axes: Axes::Parallel,
                of_mean: false,
                text,
                span,
            };
            let shape = Shape::Round { place, radius };
            return Some(Surface { shape, text: path.text.clone(), region: path.region });
        }
        let message = self.names.no_such_surface(&path.text, is_round);
        self.diagnostics.error(path.region, message);
        None
    }

    fn shape(&mut self, written: &'d syntax::Surface) -> Option<Shape> {
        let place = |this: &mut Self| this.place(written.places.first()?);
        Some(match written.form.kind {
            SurfaceKind::Point => Shape::Round { place: place(self)?, radius: Expr::Number(0.0) },
            SurfaceKind::Round => {
                Shape::Round { place: place(self)?, radius: self.extent(written, "radius")?? }
            }
            SurfaceKind::Hollow => {
                Shape::Hollow { place: place(self)?, radius: self.extent(written, "radius")?? }
            }
            SurfaceKind::Plane => {
                let (place, normal) = self.directed(written)?;
                Shape::Flat { place, normal }
            }
            SurfaceKind::Line => self.half_plane(written)?,
            SurfaceKind::Bar => {
                let [from, to] = [0, 1].map(|which| written.places.get(which));
                let (from, to) = (self.place(from?), self.place(to?));
                let (from, to) = (from?, to?);
                self.of_one_body(written, &[&from, &to])?;
                let radius = self.extent(written, "radius")?.unwrap_or(Expr::Number(0.0));
                Shape::Bar { ends: [from, to], radius }
            }
            SurfaceKind::Polygon => self.polygon(written)?,
            SurfaceKind::Profile => self.profile(written)?,
            SurfaceKind::Cylinder | SurfaceKind::Bore => {
                let (place, axis) = self.directed(written)?;
                let (radius, length) = (self.extent(written, "radius")??, self.extent(written, "length")?);
                if written.form.kind == SurfaceKind::Bore {
                    Shape::Bore { place, axis, radius, length }
                } else {
                    Shape::Cylinder { place, axis, radius, length }
                }
            }
            SurfaceKind::Rim => {
                let (place, axis) = self.directed(written)?;
                Shape::Rim { place, axis, radius: self.extent(written, "radius")?? }
            }
        })
    }

    /// A positive length; `Some(None)` if it was not written.
    #[expect(clippy::option_option, reason = "an error and nothing are two things")]
    fn extent(&mut self, written: &'d syntax::Surface, what: &str) -> Option<Option<Expr>> {
        let Some(entry) = written.named.entry(what) else { return Some(None) };
        let length = self.entry(entry, Dimension::LENGTH, Use::COEFFICIENT, what)?;
        if let Some(found) = fold::evaluate(&length, self.defaults()).filter(|found| *found <= 0.0) {
            let message = messages::size_of_load(what, &written.name.text, found);
            self.diagnostics.error(entry.value.region, message);
            return None;
        }
        Some(Some(length))
    }

    /// A place with an axis, along z of a marker unless another is written.
    fn directed(&mut self, written: &'d syntax::Surface) -> Option<(Place, Vector)> {
        let place = self.place(written.places.first()?)?;
        if self.is_particle(place.frame) {
            self.diagnostics.error(place.span, messages::particle_turns(&place.text));
            return None;
        }
        let marked = self.is_marker(&written.places[0]);
        let axis = match written.named.tuple("axis") {
            Some(tuple) => normalised(self.direction(tuple, "axis")?),
            None if marked => [Expr::Number(0.0), Expr::Number(0.0), Expr::Number(1.0)],
            None => {
                let message =
                    messages::missing_argument(written.form.call.word, "axis", self.definition.space);
                self.diagnostics.error(written.name.region, message);
                return None;
            }
        };
        Some((place, axis))
    }

    /// Free on the left of the line's direction.
    fn half_plane(&mut self, written: &'d syntax::Surface) -> Option<Shape> {
        let right = match written.named.entry("side") {
            None => false,
            Some(entry) => self.word_of(entry, &["left", "right"])? == 1,
        };
        let line = written.line.as_ref()?;
        let (span, LowerLine { frame, ends: [from, to], text }) = (line.region(), self.line(line)?);
        let [x, y, _] = fold::between(&from, &to);
        if matches!((&x, &y), (Expr::Number(0.0), Expr::Number(0.0))) {
            self.diagnostics.error(span, messages::surface_of_no_extent(&written.name.text));
            return None;
        }
        let minus = |x| fold::unary(Function1::Neg, x);
        let normal = if right { [y, minus(x), Expr::Number(0.0)] } else { [minus(y), x, Expr::Number(0.0)] };
        let place = Place { frame, at: from, axes: Axes::Parallel, of_mean: false, text, span };
        self.straight(written, &place)?;
        Some(Shape::Flat { place, normal: normalised(normal) })
    }

    fn polygon(&mut self, written: &'d syntax::Surface) -> Option<Shape> {
        let places: Vec<_> = written.places.iter().map(|place| self.place(place)).collect();
        let places: Vec<Place> = places.into_iter().collect::<Option<_>>()?;
        self.of_one_body(written, &places.iter().collect::<Vec<_>>())?;
        if places.len() > 16 {
            self.diagnostics.error(written.name.region, messages::polygon_too_large(places.len()));
            return None;
        }
        let defaults = self.defaults();
        let corner = |place: &Place| {
            Some([fold::evaluate(&place.at[0], defaults)?, fold::evaluate(&place.at[1], defaults)?])
        };
        if let Some(corners) = places.iter().map(corner).collect::<Option<Vec<_>>>() {
            let count = corners.len();
            for k in 0..count {
                let [a, b, c] = [0, 1, 2].map(|next| corners[(k + next) % count]);
                let cross = (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]);
                if cross <= 0.0 {
                    let at = &places[(k + 1) % count];
                    self.diagnostics.error(at.span, messages::polygon_not_convex(&at.text));
                    return None;
                }
            }
        }
        Some(Shape::Polygon(places))
    }

    /// About a place that turns, by a table that comes round to where it began.
    fn profile(&mut self, written: &'d syntax::Surface) -> Option<Shape> {
        let name = &written.name.text;
        let place = self.place(written.places.first()?)?;
        if self.is_particle(place.frame) {
            self.diagnostics.error(place.span, messages::particle_turns(&place.text));
            return None;
        }
        let entry = written.named.entry("radius")?;
        let base = match written.named.entry("base") {
            Some(entry) => self.entry(entry, Dimension::LENGTH, Use::COEFFICIENT, "base")?,
            None => Expr::Number(0.0),
        };
        let passes = match written.named.entry("refine") {
            None => REFINED,
            Some(entry) => {
                let found = self.number(entry, Dimension::ONE, "refine")?;
                if found.fract() != 0.0 || !(0.0..=MOST_REFINED).contains(&found) {
                    let message = messages::passes_of_profile(found, MOST_REFINED);
                    self.diagnostics.error(entry.value.region, message);
                    return None;
                }
                found as usize
            }
        };
        let curve = self.outline("radius", entry, passes)?;
        if let Some(base) = fold::evaluate(&base, self.defaults())
            && let Some((angle, radius)) = curve.not_around(base)
        {
            let message = messages::profile_about_nothing(name, angle, radius);
            self.diagnostics.error(entry.value.region, message);
            return None;
        }
        Some(Shape::Profile { place, curve, base })
    }

    /// Places of one surface are of one thing, and apart.
    fn of_one_body(&mut self, written: &'d syntax::Surface, places: &[&Place]) -> Option<()> {
        for pair in places.windows(2) {
            let message = if pair[0].frame != pair[1].frame {
                messages::surface_of_two_bodies(&written.name.text, &pair[0].text, &pair[1].text)
            } else if pair[0] == pair[1] {
                messages::surface_of_no_extent(&written.name.text)
            } else if self.is_particle(pair[0].frame) {
                messages::particle_turns(&pair[0].text)
            } else {
                continue;
            };
            self.diagnostics.error(pair[1].span, message);
            return None;
        }
        self.straight(written, places[0])
    }

    /// What stands between several places stays as it is.
    fn straight(&mut self, written: &'d syntax::Surface, place: &Place) -> Option<()> {
        if self.bends(place.frame) {
            let message = messages::surface_along_beam(&written.name.text, &place.text);
            self.diagnostics.error(place.span, message);
            return None;
        }
        Some(())
    }

    /// Which of these words an argument is.
    pub(in crate::model) fn word_of(&mut self, entry: &'d syntax::Entry, known: &[&str]) -> Option<usize> {
        let word = match (&entry.value.kind, &entry.unit) {
            // Within a part names have its own in front.
            (TermKind::Name(path), None) => path.text.rsplit('.').next().unwrap_or_default(),
            _ => "",
        };
        let found = known.iter().position(|one| *one == word);
        if found.is_none() {
            self.diagnostics.error(entry.value.region, messages::one_of_words(known));
        }
        found
    }

    fn is_marker(&self, place: &PlaceTerm) -> bool {
        let PlaceTerm::Named(path) = place else { return false };
        match (&path.parts[..], self.names.part(&path.parts[0].text)) {
            ([_, point], Some(Part::Body(index))) => {
                self.bodies[index].markers.contains_key(point.text.as_str())
            }
            ([_], Some(Part::Marker(_))) => true,
            _ => false,
        }
    }
}
