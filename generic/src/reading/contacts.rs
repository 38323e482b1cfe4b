//! Surfaces, contacts and limits: gaps as expressions of positions, forces along them where they are closed.
//!
//! A gap is positive apart. Distances are √max(s, ε²), which has a slope where two places meet.

use super::laws::{LawReader, May};
use super::{Read, Reader};
use crate::error::DefinitionError;
use crate::expression::{Expression, Function, Operator};
use crate::json::{field, list, name, optional, text};
use crate::kinematics::{Place, Section};
use crate::load::{Acts, Load};
use crate::quantity::Quantity;
use crate::table::{Look, Table};
use crate::vector::*;
use serde_json::Value;
use std::sync::Arc;

/// m².
const TINY: f64 = 1e-24;

/// A surface in SI.
enum Shape {
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
    radius: Option<f64>,
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

impl<'t> Reader<'t> {
    pub(super) fn read_contacts(&self) -> Read<Vec<Load>> {
        let mut loads = Vec::new();
        for node in list(self.tree, "contacts", "contacts")? {
            let own = name(node, "contacts")?;
            let mut meetings = Vec::new();
            let count = self.count(node, own)?;
            for which in 0..count {
                let gap = self.reading(own, May::Positions, |law| {
                    Ok(law.meetings(node, own)?.swap_remove(which).gap)
                })?;
                let force = self.reading(own, May::Motion, |law| law.force(node, own, which))?;
                meetings.push([gap, force]);
            }
            loads.push(Load { name: own.to_string(), acts: Acts::Contact(meetings) });
        }
        Ok(loads)
    }

    pub(super) fn contact_named(&self, wanted: &str) -> Read<Option<&'t Value>> {
        let contacts = list(self.tree, "contacts", wanted)?;
        Ok(contacts.iter().find(|node| name(node, wanted) == Ok(wanted)))
    }

    pub(super) fn count(&self, node: &Value, own: &str) -> Read<usize> {
        let mut count = 0;
        self.reading(own, May::Positions, |law| {
            count = law.meetings(node, own)?.len();
            Ok(Expression::Number(0.0))
        })?;
        Ok(count)
    }

    fn shape(&self, wanted: &str, own: &str) -> Read<Shape> {
        let surfaces = list(self.tree, "surfaces", own)?;
        let Some(node) = surfaces.iter().find(|node| name(node, own) == Ok(wanted)) else {
            return self.surface_of_body(wanted, own);
        };
        let places = list(node, "places", own)?.iter().map(|place| self.place(place, own));
        let places: Vec<Place> = places.collect::<Read<_>>()?;
        let first = || places.first().cloned().ok_or_else(|| DefinitionError::malformed(wanted, "places"));
        let size = |key: &str| self.entry_of(node, key, own);
        let axis = |place: &Place| -> Read<V3> {
            let axis = match optional(node, "axis") {
                Some(axis) => unit(self.tuple(axis, "value", own)?),
                None => Some([0.0, 0.0, 1.0]),
            };
            let axis = axis.ok_or_else(|| DefinitionError::value(wanted, "an axis has no direction"))?;
            Ok(turned(&place.axes, axis))
        };
        let radius = || Ok(size("radius")?.unwrap_or(0.0));
        Ok(match text(node, "kind", wanted)? {
            "point" | "circle" | "sphere" => Shape::Round(first()?, radius()?),
            "hole" | "ball_socket" => Shape::Hollow(first()?, radius()?),
            "plane" => {
                let place = first()?;
                let normal = axis(&place)?;
                Shape::Flat(place, normal)
            }
            "half_plane" => {
                let (place, along) = self.line(field(node, "line", own)?, own)?;
                let side = optional(node, "side").and_then(|side| side.get("value")?.get("name")?.as_str());
                let right = side.is_some_and(|side| side.rsplit('.').next() == Some("right"));
                let left = [-along[1], along[0], 0.0];
                Shape::Flat(place, if right { times(-1.0, left) } else { left })
            }
            "segment" | "capsule" => {
                let [from, to] = <[Place; 2]>::try_from(places.clone())
                    .map_err(|_| DefinitionError::malformed(wanted, "two places"))?;
                if from.moving.is_some() || to.moving.is_some() {
                    return Err(DefinitionError::not_there_yet(wanted, "a bar that moves by itself"));
                }
                Shape::Bar([from, to], radius()?)
            }
            "polygon" => Shape::Polygon(places),
            "profile" => {
                let table = text(field(field(node, "radius", own)?, "value", own)?, "name", own)?;
                let table = self.tables.get(table).ok_or_else(|| DefinitionError::unknown(wanted, table))?;
                let Table::Curve(curve) = &**table else {
                    return Err(DefinitionError::malformed(wanted, "radius"));
                };
                let (curve, base) = (curve.clone(), size("base")?.unwrap_or(0.0));
                Shape::Profile(first()?, Arc::new(Table::Profile { curve, base }))
            }
            kind @ ("cylinder" | "bore") => {
                let place = first()?;
                let axis = axis(&place)?;
                Shape::Cylinder {
                    place,
                    axis,
                    radius: radius()?,
                    length: size("length")?,
                    bore: kind == "bore",
                }
            }
            "disk_rim" => {
                let place = first()?;
                let axis = axis(&place)?;
                Shape::Rim(place, axis, radius()?)
            }
            kind => return Err(DefinitionError::kind(wanted, kind)),
        })
    }

    /// `ball.surface`.
    fn surface_of_body(&self, wanted: &str, own: &str) -> Read<Shape> {
        let unknown = || DefinitionError::unknown(own, wanted);
        let body = wanted.strip_suffix(".surface").ok_or_else(unknown)?;
        let bodies = list(self.tree, "bodies", own)?;
        let node = bodies.iter().find(|node| name(node, own) == Ok(body)).ok_or_else(unknown)?;
        let radius = self.needed(field(node, "properties", own)?, "radius", own)?;
        let center = self.named_place(&format!("{body}.center")).ok_or_else(unknown)?;
        Ok(Shape::Round(center, radius))
    }

    /// (1 − ν²)/E.
    fn compliance(&self, law: &Value, which: &str, own: &str) -> Read<f64> {
        let written = field(field(law, which, own)?, "value", own)?;
        let wanted = text(written, "name", own)?;
        let materials = list(self.tree, "materials", own)?;
        let material = materials.iter().find(|node| name(node, own) == Ok(wanted));
        let material = material.ok_or_else(|| DefinitionError::unknown(own, wanted))?;
        let poisson = self.needed(material, "poisson", own)?;
        Ok((1.0 - poisson * poisson) / self.needed(material, "modulus", own)?)
    }
}

impl LawReader<'_, '_> {
    /// A quantity of a contact.
    pub(super) fn of_contact(
        &mut self,
        node: &Value,
        own: &str,
        what: &str,
        part: Option<&str>,
    ) -> Read<Expression> {
        let meetings = self.meetings(node, own)?;
        let which = self.own.filter(|(name, _)| *name == own).map(|(_, which)| which);
        let gaps = meetings.iter().map(|meeting| meeting.gap.clone()).enumerate();
        let gaps = gaps.filter(|(index, _)| which.is_none_or(|own| own == *index)).map(|(_, gap)| gap);
        let least = gaps.reduce(|a, b| two(Operator::Min, a, b));
        let least = least.ok_or_else(|| DefinitionError::malformed(own, "a gap"))?;
        match what {
            "gap" => Ok(least),
            "depth" => Ok(two(Operator::Max, minus_of(least), Expression::Number(0.0))),
            "closing" => Ok(minus_of(self.rate(least)?)),
            "force" => {
                let mut sum = Expression::Number(0.0);
                for which in 0..meetings.len() {
                    sum = plus_of(sum, self.force(node, own, which)?);
                }
                Ok(sum)
            }
            _ => {
                let axis = ["x", "y", "z"].iter().position(|axis| *axis == what).filter(|_| part.is_some());
                let unknown = || DefinitionError::unknown(own, what);
                let along: Vec<Expression> = if what == "sliding" || part == Some("sliding") {
                    self.sliding(own, axis)?
                } else {
                    let axis = axis.ok_or_else(unknown)?;
                    let place = |meeting: &Meeting| Some(meeting.point.as_ref()?[axis].clone());
                    meetings.iter().map(|meeting| place(meeting).ok_or_else(unknown)).collect::<Read<_>>()?
                };
                let mut deepest: Option<(Expression, Expression)> = None;
                for (index, (Meeting { gap, .. }, along)) in meetings.into_iter().zip(along).enumerate() {
                    if which.is_some_and(|own| own != index) {
                        continue;
                    }
                    deepest = Some(match deepest {
                        None => (gap, along),
                        Some((least, at)) => {
                            let deeper = two(Operator::Less, gap.clone(), least.clone());
                            let at = Expression::If(Box::new([deeper, along, at]));
                            (two(Operator::Min, least, gap), at)
                        }
                    });
                }
                Ok(deepest.map_or(Expression::Number(0.0), |(_, at)| at))
            }
        }
    }

    pub(super) fn force(&mut self, node: &Value, own: &str, which: usize) -> Read<Expression> {
        let Meeting { gap, radius, .. } = self.meetings(node, own)?.swap_remove(which);
        let law = field(node, "law", own)?;
        let kind = text(law, "kind", own)?;
        if kind == "rigid" {
            return Err(DefinitionError::not_there_yet(own, "impulses of rigid contacts"));
        }
        let reader = self.reader;
        let given = |key: &str| Ok(reader.entry_of(law, key, own)?.unwrap_or(0.0));
        let zero = || Expression::Number(0.0);
        let inside = minus_of(gap.clone());
        let pushed = if kind == "expression" {
            let outer = self.own;
            // The name lives as long as the tree does.
            let known = reader.contact_named(own)?.ok_or_else(|| DefinitionError::unknown(own, own))?;
            self.own = Some((name(known, own)?, which));
            let value = self.expression(field(law, "value", own)?)?;
            self.own = outer;
            two(Operator::Max, value, zero())
        } else {
            let closing = minus_of(self.rate(gap.clone())?);
            if kind == "kelvin_voigt" {
                let release = reader.entry_of(law, "release", own)?.unwrap_or(1.0);
                let damping = given("damping")?;
                let inwards = two(Operator::Greater, closing.clone(), zero());
                let factor = [inwards, Expression::Number(damping), Expression::Number(release * damping)];
                let resisted = times_of(Expression::If(Box::new(factor)), closing);
                let elastic = scaled(given("stiffness")?, two(Operator::Max, inside, zero()));
                two(Operator::Max, plus_of(elastic, resisted), zero())
            } else {
                let elastic = match kind {
                    "hunt_crossley" => {
                        let exponent = reader.entry_of(law, "exponent", own)?.unwrap_or(1.5);
                        scaled(given("force")?, powered(scaled(1.0 / given("depth")?, inside), exponent))
                    }
                    "hertz" => {
                        let radius = radius
                            .ok_or_else(|| DefinitionError::value(own, "surfaces without curvature"))?;
                        let compliance =
                            reader.compliance(law, "first", own)? + reader.compliance(law, "second", own)?;
                        scaled(4.0 * radius.sqrt() / (3.0 * compliance), powered(inside, 1.5))
                    }
                    kind => return Err(DefinitionError::kind(own, kind)),
                };
                let mut loss = given("dissipation")?;
                if let Some(e) = reader.entry_of(law, "restitution", own)? {
                    let word =
                        optional(law, "damping").and_then(|word| word.get("value")?.get("name")?.as_str());
                    let word = word.and_then(|word| word.rsplit('.').next()).unwrap_or("exact");
                    loss = dissipation(e, word) / given("speed")?;
                }
                let factor = plus_of(Expression::Number(1.0), scaled(loss, closing));
                times_of(elastic, two(Operator::Max, factor, zero()))
            }
        };
        let touches = two(Operator::Less, gap, zero());
        Ok(Expression::If(Box::new([touches, pushed, zero()])))
    }

    pub(super) fn meetings(&mut self, node: &Value, own: &str) -> Read<Vec<Meeting>> {
        let of = |gap| vec![Meeting { gap, point: None, radius: None, between: None }];
        match text(node, "kind", own)? {
            "gap" => Ok(of(self.expression(field(node, "expression", own)?)?)),
            "limit" => {
                let unit = node.get("unit").and_then(Value::as_str);
                let [from, to] =
                    ["from", "to"].map(|end| self.reader.in_unit(field(node, end, own)?, unit, own));
                let x = self.expression(field(node, "quantity", own)?)?;
                let above = plus_of(x.clone(), Expression::Number(-from?));
                let below = plus_of(Expression::Number(to?), minus_of(x));
                Ok(of(two(Operator::Min, above, below)))
            }
            _ => {
                let one = self.reader.shape(text(node, "first", own)?, own)?;
                let other = self.reader.shape(text(node, "second", own)?, own)?;
                if let Some(found) = self.pair(&one, &other) {
                    return Ok(found);
                }
                let found = self.pair(&other, &one);
                let mut found = found.ok_or_else(|| DefinitionError::kind(own, "pair of surfaces"))?;
                for between in found.iter_mut().filter_map(|meeting| meeting.between.as_mut()) {
                    between.reversed = true;
                }
                Ok(found)
            }
        }
    }

    fn pair(&mut self, one: &Shape, other: &Shape) -> Option<Vec<Meeting>> {
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
                    between: round(p, q, *r),
                }]
            }
            (Shape::Round(p, r), Shape::Bar(ends, own)) => vec![self.bar(p, *r, ends, *own)],
            (Shape::Round(p, r), Shape::Profile(place, table)) => {
                let axes = [0, 1].map(|axis| turned(&place.axes, unit_axis(axis)));
                let along = |axis| Quantity::Along { axis, first: place.clone(), second: p.clone() };
                let look = Look { table: table.clone(), slope: false };
                let far = Expression::Table(look, Box::new(axes.map(|axis| self.leaf(along(axis)))));
                let gap = plus_of(far, Expression::Number(-r));
                vec![Meeting { gap, point: None, radius: None, between: round(p, place, *r) }]
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
        Meeting { gap, point: Some(at), radius: Some(r), between: round(p, foot, r) }
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
        Meeting { gap, point: Some(at), radius: None, between: round(p, from, r) }
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
        Meeting { gap, point: None, radius: None, between: round(p, &corners[0], r) }
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
        Meeting { gap, point: None, radius: None, between: round(p, place, r) }
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
        Meeting { gap, point: Some(at), radius: None, between: Some(between) }
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

/// b v of a restitution (docs/contact-and-friction.md), by bisection of x − ln(1 + x) + e x + ln(1 − e x).
fn dissipation(e: f64, word: &str) -> f64 {
    match word {
        "lankarani_nikravesh" => return 0.75 * (1.0 - e * e),
        "hunt_crossley" => return 1.5 * (1.0 - e),
        "flores" => return 8.0 * (1.0 - e) / (5.0 * e),
        _ => {}
    }
    if e >= 1.0 {
        return 0.0;
    }
    let (mut low, mut high) = (0.0, 1.0 / e);
    for _ in 0..200 {
        let x = 0.5 * (low + high);
        if x - x.ln_1p() + e * x + (-e * x).ln_1p() > 0.0 {
            low = x;
        } else {
            high = x;
        }
    }
    0.5 * (low + high)
}

/// max(x, 0)^n, and where n is no whole number at least at 1e-12.
fn powered(x: Expression, exponent: f64) -> Expression {
    let least = if exponent.fract() == 0.0 { 0.0 } else { 1e-12 };
    Expression::unary(Function::Power(exponent), two(Operator::Max, x, Expression::Number(least)))
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

fn two(operator: Operator, a: Expression, b: Expression) -> Expression {
    Expression::binary(operator, a, b)
}

fn plus_of(a: Expression, b: Expression) -> Expression {
    two(Operator::Plus, a, b)
}

fn times_of(a: Expression, b: Expression) -> Expression {
    two(Operator::Times, a, b)
}

fn over_of(a: Expression, b: Expression) -> Expression {
    two(Operator::Over, a, b)
}

fn minus_of(a: Expression) -> Expression {
    Expression::unary(Function::Negative, a)
}

fn scaled(factor: f64, a: Expression) -> Expression {
    times_of(Expression::Number(factor), a)
}
