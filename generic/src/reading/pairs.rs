//! Surfaces, and the gaps between two of them.
//!
//! A gap is positive apart. Distances are √max(s, ε²), which has a slope where two places meet.

use super::contacts::{minus_of, over_of, plus_of, scaled, times_of, two};
use super::laws::LawReader;
use crate::expression::{Expression, Function, Operator};
use crate::kinematics::{Place, Section};
use crate::quantity::Quantity;
use crate::table::{Look, Table};
use crate::vector::*;
use std::sync::Arc;

/// m².
const TINY: f64 = 1e-24;

/// sin² of the angle between two bars below which they count as parallel.
const PARALLEL: f64 = 1e-8;

/// A surface in SI.
pub(super) enum Shape {
    Round(Place, f64),
    Hollow(Place, f64),
    /// A place and the way out, in the axes of its body.
    Flat(Place, V3),
    Bar([Place; 2], f64),
    Polygon(Vec<Place>),
    Cylinder {
        place: Place,
        axis: V3,
        radius: f64,
        length: Option<f64>,
        bore: bool,
    },
    Rim(Place, V3, f64),
    /// A closed curve about a place, with its base.
    Profile(Place, Arc<Table>),
}

/// Where two surfaces may touch.
pub(super) struct Meeting {
    pub gap: Expression,
    pub point: Option<[Expression; 3]>,
    /// Of both curvatures.
    pub radius: Option<f64>,
    /// R₁ + R₂, or R₁ − R₂ of a hole.
    pub radii: Option<f64>,
    pub between: Option<Between>,
}

/// What meets.
pub(super) struct Between {
    pub first: Place,
    pub second: Place,
    /// Of a first that is round.
    pub radius: Option<f64>,
    /// Whether the two are written the other way round.
    pub reversed: bool,
}

impl LawReader<'_, '_> {
    pub(super) fn pair(&mut self, one: &Shape, other: &Shape) -> Option<Vec<Meeting>> {
        Some(match (one, other) {
            (Shape::Round(p, r), Shape::Flat(foot, normal)) => vec![self.flat(p, *r, foot, *normal)],
            (Shape::Bar(ends, r), Shape::Flat(foot, normal)) => {
                ends.iter().map(|end| self.flat(end, *r, foot, *normal)).collect()
            }
            (Shape::Polygon(corners), Shape::Flat(foot, normal)) => {
                corners.iter().map(|corner| self.flat(corner, 0.0, foot, *normal)).collect()
            }
            (Shape::Round(p, r), Shape::Round(q, s)) => {
                let way = self.span(q, p);
                let far = root(square(&way));
                let gap = plus_of(far.clone(), Expression::Number(-r - s));
                let out = over_of(halfway(*s, &gap), far);
                let at = self.from(q, &way, &out);
                vec![Meeting {
                    gap,
                    point: Some(at),
                    radius: Some(r * s / (r + s)),
                    radii: Some(r + s),
                    between: round(p, q, *r),
                }]
            }
            (Shape::Round(p, r), Shape::Hollow(q, s)) => {
                let way = self.span(q, p);
                let far = root(square(&way));
                let gap = plus_of(Expression::Number(s - r), minus_of(far.clone()));
                let out = over_of(plus_of(Expression::Number(*s), scaled(-0.5, gap.clone())), far);
                let at = self.from(q, &way, &out);
                vec![Meeting {
                    gap,
                    point: Some(at),
                    radius: Some(r * s / (s - r)),
                    radii: Some(s - r),
                    between: round(p, q, *r),
                }]
            }
            (Shape::Bar(ends, r), Shape::Bar(others, own)) => vec![self.bars(ends, *r, others, *own)],
            (Shape::Round(p, r), Shape::Bar(ends, own)) => vec![self.bar(p, *r, ends, *own)],
            (Shape::Round(p, r), Shape::Profile(place, table)) => {
                let axes = [0, 1].map(|axis| turned(&place.axes, unit_axis(axis)));
                let along = |axis| Quantity::Along { axis, first: place.clone(), second: p.clone() };
                let look = Look { table: table.clone(), slope: false };
                let far = Expression::Table(look, Box::new(axes.map(|axis| self.leaf(along(axis)))));
                let gap = plus_of(far, Expression::Number(-r));
                vec![Meeting { gap, point: None, radius: None, radii: None, between: round(p, place, *r) }]
            }
            (Shape::Round(p, r), Shape::Polygon(corners)) => vec![self.polygon(p, *r, corners)],
            (Shape::Round(p, r), Shape::Cylinder { place, axis, radius, length, bore }) => {
                vec![self.cylinder(p, *r, place, *axis, [*radius, length.unwrap_or(f64::INFINITY)], *bore)]
            }
            (Shape::Rim(p, axis, r), Shape::Flat(foot, normal)) => {
                vec![self.rim(p, *axis, *r, foot, *normal)]
            }
            _ => return None,
        })
    }

    fn flat(&mut self, p: &Place, r: f64, foot: &Place, normal: V3) -> Meeting {
        let along = Quantity::Along { axis: normal, first: foot.clone(), second: p.clone() };
        let gap = plus_of(self.leaf(along), Expression::Number(-r));
        let down = halfway(r, &gap);
        let at = [0, 1, 2].map(|k| {
            let out = times_of(self.world(foot, normal, k), down.clone());
            plus_of(self.coordinate(p, k), minus_of(out))
        });
        Meeting { gap, point: Some(at), radius: Some(r), radii: None, between: round(p, foot, r) }
    }

    fn bar(&mut self, p: &Place, r: f64, [from, to]: &[Place; 2], own: f64) -> Meeting {
        let span = minus(to.local, from.local);
        let long = norm(span);
        let along = Quantity::Along { axis: times(1.0 / long, span), first: from.clone(), second: p.clone() };
        let s = self.leaf(along);
        let s = two(Operator::Min, two(Operator::Max, s, Expression::Number(0.0)), Expression::Number(long));
        let share = scaled(1.0 / long, s);
        let (whole, way) = (self.span(from, to), self.span(from, p));
        let across =
            [0, 1, 2].map(|k| plus_of(way[k].clone(), minus_of(times_of(share.clone(), whole[k].clone()))));
        let far = root(square(&across));
        let gap = plus_of(far.clone(), Expression::Number(-r - own));
        let out = over_of(halfway(own, &gap), far);
        let at = [0, 1, 2].map(|k| {
            let foot = plus_of(self.coordinate(from, k), times_of(share.clone(), whole[k].clone()));
            plus_of(foot, times_of(out.clone(), across[k].clone()))
        });
        Meeting { gap, point: Some(at), radius: None, radii: None, between: round(p, from, r) }
    }

    /// The points of two bars that are nearest to each other: s of the first for t of the second and the other way round, each kept on its bar.
    fn bars(&mut self, first: &[Place; 2], r: f64, second: &[Place; 2], own: f64) -> Meeting {
        let spans = [first, second].map(|[from, to]| minus(to.local, from.local));
        let longs = spans.map(norm);
        let ways = [0, 1].map(|k| times(1.0 / longs[k], spans[k]));
        let [from, to] = [&first[0], &second[0]];
        let ahead = self.leaf(Quantity::Along { axis: ways[0], first: from.clone(), second: to.clone() });
        let back = self.leaf(Quantity::Along { axis: ways[1], first: to.clone(), second: from.clone() });
        let c = self.leaf(Quantity::Dot {
            first: Section::whole(from.body),
            a: ways[0],
            second: Section::whole(to.body),
            b: ways[1],
        });
        let on = |x, long| {
            let least = two(Operator::Max, x, Expression::Number(0.0));
            two(Operator::Min, least, Expression::Number(long))
        };
        let sine = plus_of(Expression::Number(1.0), minus_of(times_of(c.clone(), c.clone())));
        let sine = two(Operator::Max, sine, Expression::Number(PARALLEL));
        let free = over_of(plus_of(ahead.clone(), times_of(c.clone(), back.clone())), sine);
        let t = on(plus_of(back, times_of(c.clone(), on(free, longs[0]))), longs[1]);
        let s = on(plus_of(ahead, times_of(c, t.clone())), longs[0]);
        let shares = [scaled(1.0 / longs[0], s), scaled(1.0 / longs[1], t)];
        let [whole, other] = [first, second].map(|[from, to]| self.span(from, to));
        let between = self.span(to, from);
        let across = [0, 1, 2].map(|k| {
            let on_first = plus_of(between[k].clone(), times_of(shares[0].clone(), whole[k].clone()));
            plus_of(on_first, minus_of(times_of(shares[1].clone(), other[k].clone())))
        });
        let far = root(square(&across));
        let gap = plus_of(far.clone(), Expression::Number(-r - own));
        let out = over_of(halfway(own, &gap), far);
        let at = [0, 1, 2].map(|k| {
            let foot = plus_of(self.coordinate(to, k), times_of(shares[1].clone(), other[k].clone()));
            plus_of(foot, times_of(out.clone(), across[k].clone()))
        });
        let between = Between { first: from.clone(), second: to.clone(), radius: None, reversed: false };
        Meeting { gap, point: Some(at), radius: None, radii: None, between: Some(between) }
    }

    fn polygon(&mut self, p: &Place, r: f64, corners: &[Place]) -> Meeting {
        let (mut inside, mut outside): (Option<Expression>, Option<Expression>) = (None, None);
        for (k, from) in corners.iter().enumerate() {
            let to = &corners[(k + 1) % corners.len()];
            let span = minus(to.local, from.local);
            let [x, y, _] = times(1.0 / norm(span), span);
            let own = |axis| Quantity::Along { axis, first: from.clone(), second: p.clone() };
            let out = self.leaf(own([y, -x, 0.0]));
            let ends = self.bar(p, 0.0, &[from.clone(), to.clone()], 0.0).gap;
            inside = Some(inside.map_or(out.clone(), |known| two(Operator::Max, known, out)));
            outside = Some(outside.map_or(ends.clone(), |known| two(Operator::Min, known, ends)));
        }
        let none = || Expression::Number(0.0);
        let (inside, outside) = (inside.unwrap_or_else(none), outside.unwrap_or_else(none));
        let beyond = two(Operator::Greater, inside.clone(), none());
        let gap = plus_of(Expression::If(Box::new([beyond, outside, inside])), Expression::Number(-r));
        Meeting { gap, point: None, radius: None, radii: None, between: round(p, &corners[0], r) }
    }

    /// In the axes of the cylinder's body.
    fn cylinder(
        &mut self,
        p: &Place,
        r: f64,
        place: &Place,
        axis: V3,
        [own, long]: [f64; 2],
        bore: bool,
    ) -> Meeting {
        let mut along =
            |axis: V3| self.leaf(Quantity::Along { axis, first: place.clone(), second: p.clone() });
        let (d, z) = ([0, 1, 2].map(|k| along(unit_axis(k))), along(axis));
        let across = [0, 1, 2].map(|k| plus_of(d[k].clone(), scaled(-axis[k], z.clone())));
        let (rho, height) = (root(square(&across)), Expression::unary(Function::Abs, z));
        let none = || Expression::Number(0.0);
        let gap = if bore {
            let gap = plus_of(Expression::Number(own - r), minus_of(rho));
            let open = Expression::unary(Function::Abs, gap.clone());
            let within = two(Operator::LessOrEqual, height, Expression::Number(0.5 * long));
            if long.is_finite() { Expression::If(Box::new([within, gap, open])) } else { gap }
        } else {
            let side = plus_of(rho, Expression::Number(-own));
            let whole = if long.is_finite() {
                let end = plus_of(height, Expression::Number(-0.5 * long));
                let most = two(Operator::Max, side.clone(), end.clone());
                let [beside, beyond] = [side, end].map(|way| two(Operator::Max, way, none()));
                let far = root(square(&[beside, beyond, none()]));
                Expression::If(Box::new([two(Operator::Greater, most.clone(), none()), far, most]))
            } else {
                side
            };
            plus_of(whole, Expression::Number(-r))
        };
        Meeting { gap, point: None, radius: None, radii: None, between: round(p, place, r) }
    }

    fn rim(&mut self, p: &Place, axis: V3, r: f64, foot: &Place, normal: V3) -> Meeting {
        let c = self.leaf(Quantity::Dot {
            first: Section::whole(foot.body),
            a: normal,
            second: Section::whole(p.body),
            b: axis,
        });
        let sine = root(plus_of(Expression::Number(1.0), minus_of(times_of(c.clone(), c.clone()))));
        let along = self.leaf(Quantity::Along { axis: normal, first: foot.clone(), second: p.clone() });
        let gap = plus_of(along, scaled(-r, sine.clone()));
        let at = [0, 1, 2].map(|k| {
            let (a, own) = (self.world(foot, normal, k), self.world(p, axis, k));
            let across = plus_of(a.clone(), minus_of(times_of(c.clone(), own)));
            let down =
                plus_of(scaled(r, over_of(across, sine.clone())), scaled(0.5, times_of(a, gap.clone())));
            plus_of(self.coordinate(p, k), minus_of(down))
        });
        let between = Between { first: p.clone(), second: foot.clone(), radius: None, reversed: false };
        Meeting { gap, point: Some(at), radius: None, radii: None, between: Some(between) }
    }

    /// World components of one place less another.
    fn span(&mut self, from: &Place, to: &Place) -> [Expression; 3] {
        [0, 1, 2].map(|axis| self.leaf(Quantity::Gap { first: to.clone(), second: from.clone(), axis }))
    }

    /// A share of a way from a place.
    fn from(&mut self, place: &Place, way: &[Expression; 3], share: &Expression) -> [Expression; 3] {
        [0, 1, 2].map(|k| plus_of(self.coordinate(place, k), times_of(share.clone(), way[k].clone())))
    }

    fn coordinate(&mut self, place: &Place, axis: usize) -> Expression {
        self.leaf(Quantity::Coordinate { place: place.clone(), axis })
    }

    fn world(&mut self, place: &Place, direction: V3, axis: usize) -> Expression {
        self.leaf(Quantity::Dot {
            first: Section::whole(place.body),
            a: direction,
            second: Section::whole(None),
            b: unit_axis(axis),
        })
    }
}

/// What is round with what it touches.
fn round(p: &Place, other: &Place, radius: f64) -> Option<Between> {
    Some(Between { first: p.clone(), second: other.clone(), radius: Some(radius), reversed: false })
}

fn halfway(radius: f64, gap: &Expression) -> Expression {
    plus_of(Expression::Number(radius), scaled(0.5, gap.clone()))
}

fn square(way: &[Expression; 3]) -> Expression {
    let [x, y, z] = [0, 1, 2].map(|k| times_of(way[k].clone(), way[k].clone()));
    plus_of(plus_of(x, y), z)
}

fn root(square: Expression) -> Expression {
    Expression::unary(Function::Sqrt, two(Operator::Max, square, Expression::Number(TINY)))
}
