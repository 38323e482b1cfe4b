//! Surfaces, contacts and limits: gaps as expressions of positions, forces along them where they are closed.
//!
//! Gaps of two surfaces stand in `pairs`.

use super::laws::{LawReader, May};
use super::pairs::{Meeting, Shape};
use super::{Read, Reader};
use crate::error::DefinitionError;
use crate::expression::{Expression, Function, Operator};
use crate::json::{field, list, name, optional, text};
use crate::kinematics::Place;
use crate::load::{Acts, Load};
use crate::table::Table;
use crate::vector::*;
use serde_json::Value;
use std::f64::consts::PI;
use std::sync::Arc;

/// Beyond it s does not change.
const REPEATED: usize = 40;

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
        let Meeting { gap, radius, radii, .. } = self.meetings(node, own)?.swap_remove(which);
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
            let adheres = optional(law, "adhesion").is_some();
            let pushing = |force| if adheres { force } else { two(Operator::Max, force, zero()) };
            if kind == "kelvin_voigt" {
                let release = reader.entry_of(law, "release", own)?.unwrap_or(1.0);
                let damping = given("damping")?;
                let inwards = two(Operator::Greater, closing.clone(), zero());
                let factor = [inwards, Expression::Number(damping), Expression::Number(release * damping)];
                let resisted = times_of(Expression::If(Box::new(factor)), closing);
                let elastic = scaled(given("stiffness")?, two(Operator::Max, inside, zero()));
                pushing(plus_of(elastic, resisted))
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
                    "hertz_line" => {
                        let radii =
                            radii.ok_or_else(|| DefinitionError::value(own, "surfaces without curvature"))?;
                        let compliance =
                            reader.compliance(law, "first", own)? + reader.compliance(law, "second", own)?;
                        let stiffness = PI * reader.needed(law, "length", own)? / compliance;
                        scaled(stiffness, along_a_line(inside, radii))
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
                times_of(elastic, pushing(factor))
            }
        };
        let touches = two(Operator::Less, gap, zero());
        Ok(Expression::If(Box::new([touches, pushed, zero()])))
    }

    pub(super) fn meetings(&mut self, node: &Value, own: &str) -> Read<Vec<Meeting>> {
        let of = |gap| vec![Meeting { gap, point: None, radius: None, radii: None, between: None }];
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

pub(super) fn two(operator: Operator, a: Expression, b: Expression) -> Expression {
    Expression::binary(operator, a, b)
}

pub(super) fn plus_of(a: Expression, b: Expression) -> Expression {
    two(Operator::Plus, a, b)
}

pub(super) fn times_of(a: Expression, b: Expression) -> Expression {
    two(Operator::Times, a, b)
}

pub(super) fn over_of(a: Expression, b: Expression) -> Expression {
    two(Operator::Over, a, b)
}

pub(super) fn minus_of(a: Expression) -> Expression {
    Expression::unary(Function::Negative, a)
}

pub(super) fn scaled(factor: f64, a: Expression) -> Expression {
    times_of(Expression::Number(factor), a)
}

/// d/s of a line contact, F = π E l d/s (docs/contact-and-friction.md): s − ln s = ln(4 ΔR/d) − 1 by repetition, beyond 4 ΔR e⁻³ straight on.
fn along_a_line(depth: Expression, radii: f64) -> Expression {
    let most = 4.0 * radii * (-3.0_f64).exp();
    let within = two(Operator::Min, two(Operator::Max, depth.clone(), none()), Expression::Number(most));
    let known = two(Operator::Max, within.clone(), Expression::Number(1e-12 * radii));
    let ln = |x| Expression::unary(Function::Ln, x);
    let eta = plus_of(ln(over_of(Expression::Number(4.0 * radii), known)), Expression::Number(-1.0));
    let (mut s, mut steepest) = (eta.clone(), 2.0_f64);
    for _ in 0..REPEATED {
        s = plus_of(eta.clone(), ln(s));
        steepest = 2.0 + steepest.ln();
    }
    let beyond = two(Operator::Max, plus_of(depth, Expression::Number(-most)), none());
    plus_of(over_of(within, s), scaled(1.0 / (steepest - 1.0), beyond))
}

fn none() -> Expression {
    Expression::Number(0.0)
}
