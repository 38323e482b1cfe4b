//! Gaps between surfaces: positive apart, negative by how deep one is inside of the other, along the unit normal there, which stands in
//! `spots`.
//!
//! p: the place of a point, circle or sphere of radius r. Distances are √max(s, ε²), so that their direction has a value where two
//! places meet, as in the middle of a hole, which is out of contact.

use super::rubbing::Slides;
use super::spots::Pair;
use super::surfaces::{Shape, Surface};
use super::{Geometry, difference, least, most, product, quotient, sum};
use crate::messages;
use crate::model::lower::Lowering;
use crate::model::{
    Comparison, Condition, Coordinate, Curve, Expr, Function1, Function2, LookUp, Place, Quantity, Space,
    Vector, fold,
};
use crate::symbolic::Orders;
use crate::syntax::Path;
use crate::units::Dimension;
use std::rc::Rc;
use std::sync::Arc;

/// ε², m².
const TINY: f64 = 1e-24;
/// sin² of the angle between two bars below which they count as parallel.
const PARALLEL: f64 = 1e-8;
/// Of a distance from a curve that is periodic, whose second derivative has no jumps.
const SMOOTH: usize = 2;

/// One place where two things may touch.
#[derive(Clone, Debug)]
pub struct Meeting {
    pub gap: Expr,
    /// Of the curvatures of both, for Hertz' law.
    pub radius: Option<Expr>,
    /// R₁ + R₂, or R₁ − R₂ of what is in a hole.
    pub radii: Option<Expr>,
}

impl Meeting {
    pub fn of(gap: Expr) -> Self {
        Meeting { gap, radius: None, radii: None }
    }
}

impl Lowering<'_> {
    pub(super) fn between(&mut self, first: &Path, second: &Path) -> Option<Geometry> {
        let (a, b) = (self.surface(first), self.surface(second));
        let (a, b) = (a?, b?);
        let region = first.region.to(second.region);
        if a.shape.place().frame == b.shape.place().frame {
            self.diagnostics.error(region, messages::surfaces_of_one_body(&a.text, &b.text));
            return None;
        }
        let thin = |shape: &Shape| match shape {
            Shape::Round { radius, .. } | Shape::Bar { radius, .. } => !is_positive(radius),
            _ => false,
        };
        if thin(&a.shape) && thin(&b.shape) {
            self.diagnostics.error(region, messages::never_touches(&a.text, &b.text));
            return None;
        }
        self.fits(&a, &b)?;
        let space = self.definition.space;
        let (meetings, reversed) = match meetings(&a.shape, &b.shape, space) {
            Some(meetings) => (meetings, false),
            None => match meetings(&b.shape, &a.shape, space) {
                Some(meetings) => (meetings, true),
                None => {
                    let message = messages::no_such_pair(a.shape.kind(), b.shape.kind(), space);
                    self.diagnostics.error(region, message);
                    return None;
                }
            },
        };
        let shapes = if reversed { [b.shape, a.shape] } else { [a.shape, b.shape] };
        let slides = Slides::Surfaces(Rc::new(Pair { shapes, reversed }));
        Some(Geometry { meetings, dimension: Dimension::LENGTH, slides })
    }

    /// A hole is larger than what is in it, and a roller smaller than the hollows of what it rolls on.
    fn fits(&mut self, a: &Surface, b: &Surface) -> Option<()> {
        for (inner, outer) in [(a, b), (b, a)] {
            if let (Shape::Round { radius, .. }, Shape::Profile { curve, base, .. }) =
                (&inner.shape, &outer.shape)
            {
                let at = |value| fold::evaluate(value, self.defaults());
                if let (Some(roller), Some(base)) = (at(radius), at(base))
                    && let Some((angle, hollow)) = curve.hollow(base).filter(|(_, hollow)| *hollow <= roller)
                {
                    let message = messages::roller_too_large(&inner.text, roller, &outer.text, angle, hollow);
                    self.diagnostics.error(inner.region, message);
                    return None;
                }
                continue;
            }
            let (
                Shape::Round { radius, .. },
                Shape::Hollow { radius: hole, .. } | Shape::Bore { radius: hole, .. },
            ) = (&inner.shape, &outer.shape)
            else {
                continue;
            };
            let at = |radius| fold::evaluate(radius, self.defaults());
            if let (Some(inside), Some(outside)) = (at(radius), at(hole))
                && outside <= inside
            {
                let message = messages::hole_too_small(&outer.text, outside, &inner.text, inside);
                self.diagnostics.error(outer.region, message);
                return None;
            }
        }
        Some(())
    }
}

/// Of a pair in this order; nothing if there is no closed form.
fn meetings(first: &Shape, second: &Shape, space: Space) -> Option<Vec<Meeting>> {
    let axes = space.dimensions();
    let one = |meeting| Some(vec![meeting]);
    match (first, second) {
        (Shape::Round { place, radius }, Shape::Flat { place: foot, normal }) => {
            one(flat(place, radius, foot, normal))
        }
        // Both ends.
        (Shape::Bar { ends, radius }, Shape::Flat { place: foot, normal }) => {
            Some(ends.iter().map(|end| flat(end, radius, foot, normal)).collect())
        }
        (Shape::Polygon(corners), Shape::Flat { place: foot, normal }) => {
            let none = Expr::Number(0.0);
            Some(corners.iter().map(|corner| flat(corner, &none, foot, normal)).collect())
        }
        // g = |Δ| − r₁ − r₂
        (Shape::Round { place, radius }, Shape::Round { place: other, radius: r }) => {
            let distance = root(square(other, place));
            let radii = sum(radius.clone(), r.clone());
            let gap = difference(distance, radii.clone());
            let curved = is_positive(radius) && is_positive(r);
            let both = curved.then(|| quotient(product(radius.clone(), r.clone()), radii.clone()));
            // A point has no curvature; on a ball it is a needle.
            one(Meeting { gap, radius: both, radii: curved.then_some(radii) })
        }
        // g = R − r − |Δ|
        (Shape::Round { place, radius }, Shape::Hollow { place: middle, radius: hole }) => {
            let distance = root(square(middle, place));
            let clearance = difference(hole.clone(), radius.clone());
            let gap = difference(clearance.clone(), distance);
            let both = quotient(product(radius.clone(), hole.clone()), clearance.clone());
            let [both, radii] = [both, clearance].map(|value| is_positive(radius).then_some(value));
            one(Meeting { gap, radius: both, radii })
        }
        (Shape::Round { place, radius }, Shape::Bar { ends, radius: own }) => {
            one(bar(place, radius, ends, own, axes))
        }
        (Shape::Bar { ends, radius }, Shape::Bar { ends: others, radius: r }) if space == Space::Spatial => {
            let gap = difference(Nearest::of(ends, others).distance, sum(radius.clone(), r.clone()));
            one(Meeting::of(gap))
        }
        (Shape::Round { place, radius }, Shape::Polygon(corners)) => one(polygon(place, radius, corners)),
        // g = d − r
        (Shape::Round { place, radius }, Shape::Profile { place: middle, curve, base }) => {
            let far = profile(place, middle, curve, base, [0, 0]);
            one(Meeting::of(difference(far, radius.clone())))
        }
        (Shape::Round { place, radius }, Shape::Cylinder { place: middle, axis, radius: own, length }) => {
            one(cylinder(place, radius, middle, axis, own, length.as_ref()))
        }
        (Shape::Round { place, radius }, Shape::Bore { place: middle, axis, radius: hole, length }) => {
            one(bore(place, radius, middle, axis, hole, length.as_ref()))
        }
        (Shape::Rim { place, axis, radius }, Shape::Flat { place: foot, normal }) => {
            one(rim(place, axis, radius, foot, normal))
        }
        _ => None,
    }
}

/// How far a place is out of a curve, or a derivative of that by its coordinates along the axes of the curve.
pub(super) fn profile(
    place: &Place,
    middle: &Place,
    curve: &Arc<Curve>,
    base: &Expr,
    [x, y]: [u8; 2],
) -> Expr {
    let mut arguments = components(middle, place, 2);
    arguments.push(base.clone());
    fold::table(LookUp { curve: curve.clone(), orders: Orders::new(x, y), smoothness: SMOOTH, arguments })
}

/// g = n·(p − p₀) − r.
fn flat(place: &Place, radius: &Expr, foot: &Place, normal: &Vector) -> Meeting {
    let gap = difference(way(foot, normal.clone(), place), radius.clone());
    Meeting { gap, radius: is_positive(radius).then(|| radius.clone()), radii: None }
}

/// The nearest point of a bar by clamping: with t the bar's direction, L its length, s = clamp(t·(p − A), 0, L):
/// g = |p − A − s t| − r − ρ.
fn bar(place: &Place, radius: &Expr, ends: &[Place; 2], own: &Expr, axes: usize) -> Meeting {
    let gap = difference(Beside::of(place, ends, axes).distance, sum(radius.clone(), own.clone()));
    Meeting::of(gap)
}

/// A place beside a bar.
pub(super) struct Beside {
    /// s.
    pub along: Expr,
    /// L.
    pub length: Expr,
    /// |p − A − s t|.
    pub distance: Expr,
}

impl Beside {
    pub fn of(place: &Place, ends: &[Place; 2], axes: usize) -> Self {
        let [from, to] = ends;
        let span = fold::between(&from.at, &to.at);
        let length = norm(&span);
        let tangent = span.map(|part| quotient(part, length.clone()));
        let ways = components(from, place, axes);
        let s = dot(&ways, &tangent);
        let s = least(most(s, Expr::Number(0.0)), length.clone());
        let across: Vec<Expr> = ways
            .into_iter()
            .zip(&tangent)
            .map(|(way, t)| difference(way, product(s.clone(), t.clone())))
            .collect();
        Beside { along: s, length, distance: root(squares(&across)) }
    }
}

/// Of two bars in space the points that are nearest to each other, by clamping (Ericson, Real-Time Collision Detection, 2005, 5.1.9). With their
/// directions t₁ and t₂, their lengths L₁ and L₂, r = A₁ − A₂, b = t₁·t₂, c = t₁·r and f = t₂·r,
///   s₀ = clamp((b f − c)/(1 − b²), 0, L₁),  s₂ = clamp(b s₀ + f, 0, L₂),  s₁ = clamp(b s₂ − c, 0, L₁).
/// Where they are parallel, all s₀ are as near; 1 − b² is kept from zero there.
pub(super) struct Nearest {
    /// On the second bar, along the axes of the world.
    pub foot: [Expr; 3],
    /// From there to the first bar.
    pub way: [Expr; 3],
    pub distance: Expr,
}

impl Nearest {
    pub fn of(first: &[Place; 2], second: &[Place; 2]) -> Self {
        let span = |ends: &[Place; 2]| fold::between(&ends[0].at, &ends[1].at);
        let lengths = [first, second].map(|ends| norm(&span(ends)));
        let along = |ends: &[Place; 2], length: &Expr| span(ends).map(|part| quotient(part, length.clone()));
        let tangents = [along(first, &lengths[0]), along(second, &lengths[1])];
        let worlds = |ends: &[Place; 2], t: &Vector| [0, 1, 2].map(|axis| direction(&ends[0], t, axis));
        let [t1, t2] = [worlds(first, &tangents[0]), worlds(second, &tangents[1])];
        let [b, mc] = [dot(&t1, &t2), way(&first[0], tangents[0].clone(), &second[0])];
        let f = way(&second[0], tangents[1].clone(), &first[0]);
        let clamp = |x: Expr, length: &Expr| least(most(x, Expr::Number(0.0)), length.clone());
        let apart = difference(Expr::Number(1.0), product(b.clone(), b.clone()));
        let apart = most(apart, Expr::Number(PARALLEL));
        let s0 = quotient(sum(product(b.clone(), f.clone()), mc.clone()), apart);
        let s2 = clamp(sum(product(b.clone(), clamp(s0, &lengths[0])), f), &lengths[1]);
        let s1 = clamp(sum(product(b, s2.clone()), mc), &lengths[0]);
        let at = |place: &Place, t: &Expr, s: &Expr, axis| {
            sum(
                coordinate(Coordinate::Position(Box::new(place.clone()), axis)),
                product(s.clone(), t.clone()),
            )
        };
        let foot = [0, 1, 2].map(|axis| at(&second[0], &t2[axis], &s2, axis));
        let way = [0, 1, 2].map(|axis| difference(at(&first[0], &t1[axis], &s1, axis), foot[axis].clone()));
        let distance = root(squares(&way));
        Nearest { foot, way, distance }
    }
}

/// Inside the largest of the ways to the edges, outside the distance to the nearest edge, of which corners are ends.
fn polygon(place: &Place, radius: &Expr, corners: &[Place]) -> Meeting {
    let (mut inside, mut outside): (Option<Expr>, Option<Expr>) = (None, None);
    for Edge { across, square, .. } in edges(place, corners) {
        inside = Some(inside.map_or(across.clone(), |known| most(known, across)));
        outside = Some(outside.map_or(square.clone(), |known| least(known, square)));
    }
    let (inside, outside) = (inside.unwrap_or(Expr::Number(0.0)), outside.unwrap_or(Expr::Number(0.0)));
    let is_outside = Condition::Compare(Comparison::Less, Expr::Number(0.0), inside.clone());
    let gap = Expr::If(Box::new(is_outside), Box::new(root(outside)), Box::new(inside));
    Meeting::of(difference(gap, radius.clone()))
}

/// A place beside an edge of a polygon, along the axes of the first corner.
pub(super) struct Edge {
    /// Of unit length, along the edge and outwards.
    pub tangent: [Expr; 2],
    pub normal: [Expr; 2],
    /// From the edge's line outwards.
    pub across: Expr,
    /// What is left of the way along the edge beyond its ends.
    pub beyond: Expr,
    /// across² + beyond².
    pub square: Expr,
}

pub(super) fn edges(place: &Place, corners: &[Place]) -> Vec<Edge> {
    let ways = components(&corners[0], place, 2);
    let edge = |(k, from): (usize, &Place)| {
        let to = &corners[(k + 1) % corners.len()];
        let span = fold::between(&from.at, &to.at);
        let length = norm(&span);
        let [x, y, _] = span.map(|part| quotient(part, length.clone()));
        let base = fold::between(&corners[0].at, &from.at);
        let own: Vec<Expr> = ways.iter().zip(base).map(|(way, base)| difference(way.clone(), base)).collect();
        let normal = [y.clone(), fold::unary(Function1::Neg, x.clone())];
        let across = dot(&own, &normal);
        let tangent = [x, y];
        let s = dot(&own, &tangent);
        let beyond = difference(s.clone(), least(most(s, Expr::Number(0.0)), length));
        let square = squares(&[across.clone(), beyond.clone()]);
        Edge { tangent, normal, across, beyond, square }
    };
    corners.iter().enumerate().map(edge).collect()
}

/// With ρ = |a × Δ|, z = a·Δ: g = ρ − R − r of one without ends; else, h half its length,
/// g = min(max(ρ − R, |z| − h), 0) + |(max(ρ − R, 0), max(|z| − h, 0))| − r.
fn cylinder(
    place: &Place,
    radius: &Expr,
    middle: &Place,
    axis: &Vector,
    own: &Expr,
    length: Option<&Expr>,
) -> Meeting {
    let (across, z) = about(middle, axis, place);
    let side = difference(across, own.clone());
    let Some(length) = length else { return Meeting::of(difference(side, radius.clone())) };
    let end = difference(fold::unary(Function1::Abs, z), product(Expr::Number(0.5), length.clone()));
    let zero = || Expr::Number(0.0);
    let inside = least(most(side.clone(), end.clone()), zero());
    let outside = root(squares(&[most(side, zero()), most(end, zero())]));
    // √ε² is nothing to the gap.
    Meeting::of(difference(sum(inside, outside), radius.clone()))
}

/// g = R − r − |a × Δ|, and open beyond the ends.
fn bore(
    place: &Place,
    radius: &Expr,
    middle: &Place,
    axis: &Vector,
    hole: &Expr,
    length: Option<&Expr>,
) -> Meeting {
    let (across, z) = about(middle, axis, place);
    let clearance = difference(hole.clone(), radius.clone());
    let gap = difference(clearance, across);
    let Some(length) = length else { return Meeting::of(gap) };
    let half = product(Expr::Number(0.5), length.clone());
    let within = Condition::Compare(Comparison::LessEqual, fold::unary(Function1::Abs, z), half);
    let open = fold::unary(Function1::Abs, gap.clone());
    Meeting::of(Expr::If(Box::new(within), Box::new(gap), Box::new(open)))
}

/// The lowest point of the rim: with c = a·k, k the disk's axis, g = a·(p − p₀) − R √(1 − c²).
fn rim(place: &Place, axis: &Vector, radius: &Expr, foot: &Place, normal: &Vector) -> Meeting {
    let Tilt { sine, .. } = Tilt::of(place, axis, foot, normal);
    Meeting::of(difference(way(foot, normal.clone(), place), product(radius.clone(), sine)))
}

/// A disk over a plane, along the axes of the world.
pub(super) struct Tilt {
    /// a.
    pub normal: [Expr; 3],
    /// k.
    pub axis: [Expr; 3],
    /// c.
    pub cosine: Expr,
    /// √(1 − c²).
    pub sine: Expr,
}

impl Tilt {
    pub fn of(place: &Place, axis: &Vector, foot: &Place, normal: &Vector) -> Self {
        let worlds = |at: &Place, of: &Vector| [0, 1, 2].map(|k| direction(at, of, k));
        let (normal, axis) = (worlds(foot, normal), worlds(place, axis));
        let cosine = dot(&normal, &axis);
        let sine = root(difference(Expr::Number(1.0), product(cosine.clone(), cosine.clone())));
        Tilt { normal, axis, cosine, sine }
    }
}

/// (|a × Δ|, a·Δ) from the middle of a cylinder.
pub(super) fn about(middle: &Place, axis: &Vector, place: &Place) -> (Expr, Expr) {
    let d = components(middle, place, 3);
    let minor = |i: usize, j: usize| {
        difference(product(axis[i].clone(), d[j].clone()), product(axis[j].clone(), d[i].clone()))
    };
    (root(squares(&[minor(1, 2), minor(2, 0), minor(0, 1)])), dot(&d, axis))
}

pub(super) fn coordinate(coordinate: Coordinate) -> Expr {
    Expr::Quantity(Quantity::Coordinate(coordinate))
}

/// u·(p₂ − p₁), u of the first place.
fn way(from: &Place, direction: Vector, to: &Place) -> Expr {
    coordinate(Coordinate::Way(Box::new([from.clone(), to.clone()]), Box::new(direction)))
}

pub(super) fn direction(place: &Place, direction: &Vector, axis: usize) -> Expr {
    coordinate(Coordinate::Direction(Box::new((place.clone(), direction.clone())), axis))
}

pub(super) fn square(from: &Place, to: &Place) -> Expr {
    coordinate(Coordinate::Square(Box::new(from.clone()), Box::new(to.clone())))
}

/// Along the axes of the first place.
pub(super) fn components(from: &Place, to: &Place, axes: usize) -> Vec<Expr> {
    (0..axes).map(|axis| way(from, unit(axis), to)).collect()
}

pub(super) fn unit(axis: usize) -> Vector {
    [0, 1, 2].map(|k| Expr::Number(if k == axis { 1.0 } else { 0.0 }))
}

pub(super) fn dot(a: &[Expr], b: &[Expr]) -> Expr {
    let products = a.iter().zip(b).map(|(a, b)| product(a.clone(), b.clone()));
    products.reduce(sum).unwrap_or(Expr::Number(0.0))
}

pub(super) fn squares(parts: &[Expr]) -> Expr {
    dot(parts, parts)
}

/// √max(x, ε²).
pub(super) fn root(square: Expr) -> Expr {
    fold::unary(Function1::Sqrt, fold::binary(Function2::Max, square, Expr::Number(TINY)))
}

/// Of what does not move.
fn norm(vector: &Vector) -> Expr {
    fold::unary(Function1::Sqrt, squares(vector))
}

fn is_positive(radius: &Expr) -> bool {
    !matches!(radius, Expr::Number(0.0))
}
