//! Gaps between surfaces: positive apart, negative by how deep one is inside of the other, along the unit normal there.
//!
//! p: the place of a point, circle or sphere of radius r. Distances are √max(s, ε²), so that their direction has a value where two
//! places meet, as in the middle of a hole, which is out of contact.

use super::surfaces::{Shape, Surface};
use super::{Geometry, difference, least, most, product, quotient, sum};
use crate::messages;
use crate::model::lower::Lowering;
use crate::model::{
    Comparison, Condition, Coordinate, Expr, Function1, Function2, Place, Quantity, Space, Vector, fold,
};
use crate::syntax::Path;
use crate::units::Dimension;

/// ε², m².
const TINY: f64 = 1e-24;

/// One place where two things may touch.
#[derive(Clone, Debug)]
pub struct Meeting {
    pub gap: Expr,
    /// World, halfway between the two surfaces.
    pub point: Option<Vec<Expr>>,
    /// Of the curvatures of both, for Hertz' law.
    pub radius: Option<Expr>,
}

impl Meeting {
    pub fn of(gap: Expr) -> Self {
        Meeting { gap, point: None, radius: None }
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
        let meetings = match meetings(&a.shape, &b.shape, self.definition.space) {
            Some(meetings) => meetings,
            None => meetings(&b.shape, &a.shape, self.definition.space).or_else(|| {
                let message = messages::no_such_pair(a.shape.kind(), b.shape.kind(), self.definition.space);
                self.diagnostics.error(region, message);
                None
            })?,
        };
        Some(Geometry { meetings, dimension: Dimension::LENGTH })
    }

    /// A hole is larger than what is in it.
    fn fits(&mut self, a: &Surface, b: &Surface) -> Option<()> {
        for (inner, outer) in [(a, b), (b, a)] {
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
            one(flat(place, radius, foot, normal, axes))
        }
        // Both ends.
        (Shape::Bar { ends, radius }, Shape::Flat { place: foot, normal }) => {
            Some(ends.iter().map(|end| flat(end, radius, foot, normal, axes)).collect())
        }
        (Shape::Polygon(corners), Shape::Flat { place: foot, normal }) => {
            let none = Expr::Number(0.0);
            Some(corners.iter().map(|corner| flat(corner, &none, foot, normal, axes)).collect())
        }
        // g = |Δ| − r₁ − r₂
        (Shape::Round { place, radius }, Shape::Round { place: other, radius: r }) => {
            let distance = root(square(other, place));
            let gap = difference(distance.clone(), sum(radius.clone(), r.clone()));
            let point = along(other, place, &distance, halfway(r, &gap), axes);
            let curved = is_positive(radius) && is_positive(r);
            let both =
                curved.then(|| quotient(product(radius.clone(), r.clone()), sum(radius.clone(), r.clone())));
            // A point has no curvature; on a ball it is a needle.
            one(Meeting { gap, point: Some(point), radius: both })
        }
        // g = R − r − |Δ|
        (Shape::Round { place, radius }, Shape::Hollow { place: middle, radius: hole }) => {
            let distance = root(square(middle, place));
            let clearance = difference(hole.clone(), radius.clone());
            let gap = difference(clearance.clone(), distance.clone());
            let out = difference(hole.clone(), product(Expr::Number(0.5), gap.clone()));
            let point = along(middle, place, &distance, out, axes);
            let both =
                is_positive(radius).then(|| quotient(product(radius.clone(), hole.clone()), clearance));
            one(Meeting { gap, point: Some(point), radius: both })
        }
        (Shape::Round { place, radius }, Shape::Bar { ends, radius: own }) => {
            one(bar(place, radius, ends, own, axes))
        }
        (Shape::Round { place, radius }, Shape::Polygon(corners)) => one(polygon(place, radius, corners)),
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

/// g = n·(p − p₀) − r.
fn flat(place: &Place, radius: &Expr, foot: &Place, normal: &Vector, axes: usize) -> Meeting {
    let gap = difference(way(foot, normal.clone(), place), radius.clone());
    let inward = halfway(radius, &gap);
    let point = (0..axes).map(|axis| {
        difference(position(place, axis), product(direction(foot, normal, axis), inward.clone()))
    });
    let point = Some(point.collect());
    Meeting { gap, point, radius: is_positive(radius).then(|| radius.clone()) }
}

/// The nearest point of a bar by clamping: with t the bar's direction, L its length, s = clamp(t·(p − A), 0, L):
/// g = |p − A − s t| − r − ρ.
fn bar(place: &Place, radius: &Expr, ends: &[Place; 2], own: &Expr, axes: usize) -> Meeting {
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
    let distance = root(squares(&across));
    let gap = difference(distance.clone(), sum(radius.clone(), own.clone()));
    let out = quotient(halfway(own, &gap), distance);
    let share = quotient(s, length);
    let point = (0..axes).map(|axis| {
        let (a, b) = (position(from, axis), position(to, axis));
        let foot = sum(a.clone(), product(share.clone(), difference(b, a)));
        sum(foot.clone(), product(out.clone(), difference(position(place, axis), foot)))
    });
    Meeting { gap, point: Some(point.collect()), radius: None }
}

/// Inside the largest of the ways to the edges, outside the distance to the nearest edge, of which corners are ends.
fn polygon(place: &Place, radius: &Expr, corners: &[Place]) -> Meeting {
    let ways = components(&corners[0], place, 2);
    let (mut inside, mut outside): (Option<Expr>, Option<Expr>) = (None, None);
    for (k, from) in corners.iter().enumerate() {
        let to = &corners[(k + 1) % corners.len()];
        let span = fold::between(&from.at, &to.at);
        let length = norm(&span);
        let [x, y, _] = span.map(|part| quotient(part, length.clone()));
        let base = fold::between(&corners[0].at, &from.at);
        let own: Vec<Expr> = ways.iter().zip(base).map(|(way, base)| difference(way.clone(), base)).collect();
        let normal = [y.clone(), fold::unary(Function1::Neg, x.clone())];
        let across = dot(&own, &normal);
        let s = dot(&own, &[x, y]);
        // What is left of s beyond the ends.
        let beyond = difference(s.clone(), least(most(s, Expr::Number(0.0)), length));
        let square = squares(&[across.clone(), beyond]);
        inside = Some(inside.map_or(across.clone(), |known| most(known, across)));
        outside = Some(outside.map_or(square.clone(), |known| least(known, square)));
    }
    let (inside, outside) = (inside.unwrap_or(Expr::Number(0.0)), outside.unwrap_or(Expr::Number(0.0)));
    let is_outside = Condition::Compare(Comparison::Less, Expr::Number(0.0), inside.clone());
    let gap = Expr::If(Box::new(is_outside), Box::new(root(outside)), Box::new(inside));
    Meeting::of(difference(gap, radius.clone()))
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
    let worlds = |at: &Place, of: &Vector| [0, 1, 2].map(|k| direction(at, of, k));
    let (a, k) = (worlds(foot, normal), worlds(place, axis));
    let c = dot(&a, &k);
    let sine = root(difference(Expr::Number(1.0), product(c.clone(), c.clone())));
    let gap = difference(way(foot, normal.clone(), place), product(radius.clone(), sine.clone()));
    let lowest = (0..3).map(|axis| {
        let across = difference(a[axis].clone(), product(c.clone(), k[axis].clone()));
        let down = product(radius.clone(), quotient(across, sine.clone()));
        let half = product(a[axis].clone(), product(Expr::Number(0.5), gap.clone()));
        difference(difference(position(place, axis), down), half)
    });
    Meeting { point: Some(lowest.collect()), radius: None, gap }
}

/// (|a × Δ|, a·Δ) from the middle of a cylinder.
fn about(middle: &Place, axis: &Vector, place: &Place) -> (Expr, Expr) {
    let d = components(middle, place, 3);
    let minor = |i: usize, j: usize| {
        difference(product(axis[i].clone(), d[j].clone()), product(axis[j].clone(), d[i].clone()))
    };
    (root(squares(&[minor(1, 2), minor(2, 0), minor(0, 1)])), dot(&d, axis))
}

/// From a surface of radius r outwards by half of the gap.
fn halfway(radius: &Expr, gap: &Expr) -> Expr {
    sum(radius.clone(), product(Expr::Number(0.5), gap.clone()))
}

/// From one place so far towards another.
fn along(from: &Place, to: &Place, distance: &Expr, far: Expr, axes: usize) -> Vec<Expr> {
    let share = quotient(far, distance.clone());
    let towards = |axis| {
        let (a, b) = (position(from, axis), position(to, axis));
        sum(a.clone(), product(share.clone(), difference(b, a)))
    };
    (0..axes).map(towards).collect()
}

fn coordinate(coordinate: Coordinate) -> Expr {
    Expr::Quantity(Quantity::Coordinate(coordinate))
}

fn position(place: &Place, axis: usize) -> Expr {
    coordinate(Coordinate::Position(Box::new(place.clone()), axis))
}

/// u·(p₂ − p₁), u of the first place.
fn way(from: &Place, direction: Vector, to: &Place) -> Expr {
    coordinate(Coordinate::Way(Box::new([from.clone(), to.clone()]), Box::new(direction)))
}

fn direction(place: &Place, direction: &Vector, axis: usize) -> Expr {
    coordinate(Coordinate::Direction(Box::new((place.clone(), direction.clone())), axis))
}

fn square(from: &Place, to: &Place) -> Expr {
    coordinate(Coordinate::Square(Box::new(from.clone()), Box::new(to.clone())))
}

/// Along the axes of the first place.
fn components(from: &Place, to: &Place, axes: usize) -> Vec<Expr> {
    let unit = |axis: usize| [0, 1, 2].map(|k| Expr::Number(if k == axis { 1.0 } else { 0.0 }));
    (0..axes).map(|axis| way(from, unit(axis), to)).collect()
}

fn dot(a: &[Expr], b: &[Expr]) -> Expr {
    let products = a.iter().zip(b).map(|(a, b)| product(a.clone(), b.clone()));
    products.reduce(sum).unwrap_or(Expr::Number(0.0))
}

fn squares(parts: &[Expr]) -> Expr {
    dot(parts, parts)
}

/// √max(x, ε²).
fn root(square: Expr) -> Expr {
    fold::unary(Function1::Sqrt, fold::binary(Function2::Max, square, Expr::Number(TINY)))
}

/// Of what does not move.
fn norm(vector: &Vector) -> Expr {
    fold::unary(Function1::Sqrt, squares(vector))
}

fn is_positive(radius: &Expr) -> bool {
    !matches!(radius, Expr::Number(0.0))
}
