//! Toothings: which angles a pair couples by numbers of teeth, and with which constant ("Teeth" of NOTATION.md).

use super::joints::Joint;
use super::touching::beside;
use super::{Read, Reader};
use crate::error::DefinitionError;
use crate::json::{field, list, name, optional, text};
use crate::kinematics::Place;
use crate::kinematics::Section;
use crate::mesh::Touch;
use crate::quantity::Quantity;
use crate::vector::*;
use serde_json::Value;
use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

/// A toothing of a body.
#[derive(Clone, Debug)]
pub(super) struct Toothing {
    pub body: usize,
    pub kind: Kind,
    pub internal: bool,
    /// Of a worm its starts, of a rack none.
    pub teeth: f64,
    pub module: f64,
    pub angle: f64,
    pub helix: f64,
    pub first: f64,
    pub shift: f64,
    pub addendum: f64,
    pub dedendum: f64,
    pub width: Option<f64>,
    pub bore: Option<f64>,
    /// Of a rack the first point of its line.
    pub center: Place,
    pub cone: f64,
    /// The direction of a rack's line.
    pub along: V3,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Cylinder,
    Rack,
    Bevel,
    Worm,
}

impl Toothing {
    /// α_t.
    pub fn transverse(&self) -> f64 {
        (self.angle.tan() / self.helix.cos()).atan()
    }

    /// m_t z/2.
    pub fn pitch(&self) -> f64 {
        0.5 * self.module / self.helix.cos() * self.teeth
    }

    pub fn base(&self) -> f64 {
        self.pitch() * self.transverse().cos()
    }

    pub fn tip(&self) -> f64 {
        let height = if self.internal { -self.addendum } else { self.addendum };
        self.pitch() + self.module * (self.shift + height)
    }

    pub fn root(&self) -> f64 {
        let depth = if self.internal { self.dedendum } else { -self.dedendum };
        self.pitch() + self.module * (self.shift + depth)
    }
}

/// A pair of toothings.
#[derive(Clone, Debug)]
pub(super) struct Pair {
    pub wheels: [Toothing; 2],
    /// What turns, with factors, in pitches.
    pub terms: Vec<(f64, Turning)>,
    /// The sum of the terms where teeth face spaces, but for whole pitches.
    pub constant: f64,
    /// The distance of the centres, and the direction from the first to the second, of a ring that to the wheel.
    pub distance: f64,
    pub direction: f64,
    /// What holds both.
    pub carrier: Body,
    /// By which of the wheels phases are counted: the first that is no ring, rack or worm; by what it turns against what holds it, and what of it is fixed.
    pub counted: usize,
    pub turns: Vec<(f64, Turning)>,
    pub still: f64,
    /// The middle of its tooth about its axle, and ±1 as its turn counts in the terms.
    pub first: f64,
    pub side: f64,
    /// A radian of a pitch along the line of action; where pitch surfaces touch of all but cylinders in the plane.
    pub radius: f64,
    pub touch: Option<Touch>,
    /// Whether those before it fix it.
    pub follows: bool,
}

impl Pair {
    /// What the row is divided by.
    pub fn scale(&self) -> f64 {
        let [first, second] = &self.wheels;
        if first.kind == Kind::Rack { second.teeth } else { first.teeth }
    }
}

/// A body in the plane, or a joint in space; the travel of a rack's rail.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Turning {
    Body(usize),
    Joint(usize),
    Travel(usize),
}

pub(super) type Body = Option<usize>;
/// Joints with signs, and their axis where anything turns.
type Turn = (Vec<(usize, f64)>, Option<V3>);

impl Reader<'_> {
    /// The pairs of constraints, then those of loads, by name.
    pub(super) fn pairs(&self) -> Read<Vec<(String, Pair)>> {
        let of = |part: &str, kind: &'static str| -> Read<Vec<&Value>> {
            let nodes = list(self.tree, part, part)?;
            Ok(nodes.iter().filter(|node| node.get("kind").and_then(Value::as_str) == Some(kind)).collect())
        };
        let (mut found, mut rows) = (Vec::new(), Vec::new());
        for node in of("constraints", "teeth")?.into_iter().chain(of("loads", "mesh")?) {
            let own = name(node, "teeth")?;
            let axes = optional(node, "axes").and_then(|axes| axes.get("value")?.get("name")?.as_str());
            if axes == Some("moving") {
                return Err(DefinitionError::not_there_yet(own, "a mesh on axes that move"));
            }
            let wheels = [self.toothing(node, "first", own)?, self.toothing(node, "second", own)?];
            let mut pair = self.pair(wheels, own)?;
            rows.push(self.independent(&pair));
            pair.follows = rank(&rows) < rows.len();
            if pair.follows {
                rows.pop();
            }
            found.push((own.to_string(), pair));
        }
        Ok(found)
    }

    /// The angle of what turns.
    pub(super) fn turning(&self, what: Turning, own: &str) -> Read<Quantity> {
        match what {
            Turning::Body(body) => {
                Ok(Quantity::PlaneAngle { first: Section::whole(None), second: Section::whole(Some(body)) })
            }
            Turning::Joint(joint) => {
                self.of_joint(joint, "angle").ok_or_else(|| DefinitionError::unknown(own, "an angle"))
            }
            Turning::Travel(joint) => {
                self.of_joint(joint, "travel").ok_or_else(|| DefinitionError::unknown(own, "a travel"))
            }
        }
    }

    fn toothing(&self, node: &Value, key: &str, own: &str) -> Read<Toothing> {
        let path = text(field(node, key, own)?, "place", own)?;
        let unknown = || DefinitionError::unknown(own, path);
        let (body, rim) = path.rsplit_once('.').ok_or_else(unknown)?;
        let bodies = list(self.tree, "bodies", own)?;
        let of_body = bodies.iter().find(|node| name(node, own) == Ok(body)).ok_or_else(unknown)?;
        let toothings = list(of_body, "toothings", own)?;
        let node = toothings.iter().find(|node| name(node, own) == Ok(rim)).ok_or_else(unknown)?;
        let value = |key: &str, default: f64| Ok(self.entry_of(node, key, own)?.unwrap_or(default));
        let word = text(node, "kind", own)?;
        let kind = match word {
            "external" | "internal" => Kind::Cylinder,
            "rack" => Kind::Rack,
            "bevel" => Kind::Bevel,
            "worm" => Kind::Worm,
            kind => return Err(DefinitionError::kind(own, kind)),
        };
        let (center, along) = match optional(node, "at").and_then(Value::as_str) {
            _ if kind == Kind::Rack => self.line(node, own)?,
            Some(at) => (self.named_place(at).ok_or_else(unknown)?, unit_axis(2)),
            None => (self.named_place(&format!("{body}.center")).ok_or_else(unknown)?, unit_axis(2)),
        };
        let teeth = match kind {
            Kind::Rack => 0.0,
            Kind::Worm => self.needed(node, "starts", own)?,
            Kind::Cylinder | Kind::Bevel => self.needed(node, "teeth", own)?,
        };
        Ok(Toothing {
            body: *self.body_by_name.get(body).ok_or_else(unknown)?,
            kind,
            internal: word == "internal",
            teeth,
            module: self.needed(node, "module", own)?,
            angle: value("pressure_angle", 20.0_f64.to_radians())?,
            helix: value("helix", 0.0)?,
            first: value("first", 0.0)?,
            shift: value("shift", 0.0)?,
            addendum: value("addendum", 1.0)?,
            dedendum: value("dedendum", 1.25)?,
            width: self.entry_of(node, "face_width", own)?,
            bore: self.entry_of(node, "bore", own)?,
            center,
            cone: value("cone", 0.0)?,
            along,
        })
    }

    fn pair(&self, wheels: [Toothing; 2], own: &str) -> Read<Pair> {
        let unheld = || DefinitionError::value(own, "nothing holds its wheels to each other");
        if let Some(rack) = wheels.iter().position(|wheel| wheel.kind == Kind::Rack) {
            return self.rolling(wheels.clone(), rack, own)?.ok_or_else(unheld);
        }
        if wheels.iter().any(|wheel| wheel.kind != Kind::Cylinder) {
            return self.crossing(wheels.clone()).ok_or_else(unheld);
        }
        let [first, second] = &wheels;
        let sense = if first.internal || second.internal { -1.0 } else { 1.0 };
        let (carrier, across) = self.carrier(&wheels).ok_or_else(unheld)?;
        let mut terms: BTreeMap<Turning, f64> = BTreeMap::new();
        let (mut fixed, mut between) = (0.0, [across[0], across[1]]);
        let counted = usize::from(first.internal);
        let (mut turns, mut still) = (Vec::new(), 0.0);
        let (mut middles, mut space) = ([first.first, second.first], None);
        if self.spatial {
            let mut axis: Option<V3> = None;
            for (which, (wheel, teeth)) in
                [(first, first.teeth), (second, sense * second.teeth)].into_iter().enumerate()
            {
                let (own, about) = self.turn(Some(wheel.body), carrier).ok_or_else(unheld)?;
                let side = match (axis, about) {
                    (Some(a), Some(b)) => dot(a, b).signum(),
                    _ => 1.0,
                };
                axis = axis.or(about);
                // Seen along an axle that points back, a tooth is as far the other way.
                middles[which] *= side;
                for (joint, sign) in own {
                    *terms.entry(Turning::Joint(joint)).or_default() += teeth * side * sign;
                    if which == counted {
                        turns.push((side * sign, Turning::Joint(joint)));
                    }
                }
            }
            let axis = axis.ok_or_else(unheld)?;
            let joint = self.joints.iter().find(|joint| dot(column(&joint.frame, 2), axis) > 1.0 - 1e-12);
            let frame = joint.ok_or_else(unheld)?.frame;
            between = [dot(column(&frame, 0), across), dot(column(&frame, 1), across)];
            space = Some((axis, across));
        } else {
            let turning = [
                (first.teeth, Some(first.body)),
                (sense * second.teeth, Some(second.body)),
                (-first.teeth - sense * second.teeth, carrier),
            ];
            for (factor, body) in turning {
                match (body, self.orientation(body, own)?) {
                    (Some(body), (Some(_), _)) => *terms.entry(Turning::Body(body)).or_default() += factor,
                    (_, (_, angle)) => fixed += factor * angle,
                }
            }
        }
        let terms =
            terms.into_iter().filter(|(_, factor)| *factor != 0.0).map(|(what, factor)| (factor, what));
        if !self.spatial {
            for (sign, body) in [(1.0, Some(wheels[counted].body)), (-1.0, carrier)] {
                match (body, self.orientation(body, own)?) {
                    (Some(body), (Some(_), _)) => turns.push((sign, Turning::Body(body))),
                    (_, (_, angle)) => still += sign * angle,
                }
            }
        }
        let [x, y] = if second.internal { between.map(|part| -part) } else { between };
        let (distance, direction) = (x.hypot(y), y.atan2(x));
        let constant = wrapped(facing(&wheels, sense, between, middles) - fixed);
        let terms = terms.collect();
        let touch = space.map(|(axis, across)| beside(&wheels, sense, carrier, axis, across));
        let (radius, first, side) =
            (first.base() / first.teeth, middles[counted], if counted == 0 { 1.0 } else { sense });
        let follows = false;
        Ok(Pair {
            terms,
            constant,
            distance,
            direction,
            carrier,
            counted,
            turns,
            still,
            first,
            side,
            radius,
            touch,
            follows,
            wheels,
        })
    }

    /// What both centres are pinned to, and the way between them there.
    pub(super) fn carrier(&self, wheels: &[Toothing; 2]) -> Option<(Body, V3)> {
        let [first, second] = [0, 1].map(|which| self.pinned(&wheels[which].center));
        let own = [Some(wheels[0].body), Some(wheels[1].body)];
        let mut both: Vec<(Body, V3)> = Vec::new();
        for (body, at) in &first {
            if let (Some((_, other)), false) =
                (second.iter().find(|(other, _)| other == body), own.contains(body))
            {
                both.push((*body, minus(*other, *at)));
            }
        }
        both.into_iter().min_by_key(|(body, _)| *body)
    }

    pub(super) fn pinned(&self, place: &Place) -> Vec<(Body, V3)> {
        let mut found = vec![(place.body, place.local)];
        let mut next = 0;
        while let Some((body, at)) = found.get(next).copied() {
            next += 1;
            for joint in self.joints.iter().filter(|joint| keeps_place(joint)) {
                for (near, far) in [(&joint.first, &joint.second), (&joint.second, &joint.first)] {
                    let still = near.moving.is_none() && far.moving.is_none();
                    let size = norm(at).max(norm(near.local)).max(1e-12);
                    let here = near.body == body && norm(minus(near.local, at)) <= 1e-9 * size;
                    if still && here && found.iter().all(|(known, _)| *known != far.body) {
                        found.push((far.body, far.local));
                    }
                }
            }
        }
        found
    }

    /// What a body's orientation is fixed against, the ground before bodies, and the angle.
    pub(super) fn orientation(&self, body: Body, own: &str) -> Read<(Body, f64)> {
        let mut of: BTreeMap<Body, (Body, f64)> = BTreeMap::from([(None, (None, 0.0))]);
        of.extend((0..self.bodies.len()).map(|index| (Some(index), (Some(index), 0.0))));
        for node in list(self.tree, "joints", own)? {
            let joint = &self.joints[self.joint_by_name[name(node, own)?]];
            if !matches!(joint.kind.as_str(), "fixed" | "prismatic" | "parallel") {
                continue;
            }
            let angle = self.entry_of(node, "angle", own)?.unwrap_or(0.0);
            let ((a, of_a), (b, of_b)) = (of[&joint.first.body], of[&joint.second.body]);
            let turn = of_a + angle - of_b;
            let (keep, lose, turn) = if a <= b { (a, b, turn) } else { (b, a, -turn) };
            for entry in of.values_mut().filter(|(root, _)| *root == lose && keep != lose) {
                *entry = (keep, entry.1 + turn);
            }
        }
        Ok(of[&body])
    }

    /// By which joints of space a body turns against another, with signs, and about which axis.
    pub(super) fn turn(&self, body: Body, carrier: Body) -> Option<Turn> {
        let all = [carrier, None].into_iter().chain((0..self.bodies.len()).map(Some));
        all.into_iter().find_map(|third| {
            let (mut one, about) = self.against(body, third)?;
            let (other, about_too) = self.against(carrier, third)?;
            let side = match (about, about_too) {
                (Some(a), Some(b)) if dot(a, b).abs() < 1.0 - 1e-9 => return None,
                (Some(a), Some(b)) => dot(a, b).signum(),
                _ => 1.0,
            };
            one.extend(other.into_iter().map(|(joint, sign)| (joint, -side * sign)));
            Some((one, about.or(about_too)))
        })
    }

    fn against(&self, body: Body, other: Body) -> Option<Turn> {
        if self.orientation(body, "").ok()?.0 == self.orientation(other, "").ok()?.0 {
            return Some((Vec::new(), None));
        }
        self.joints.iter().enumerate().find_map(|(index, joint)| {
            if !matches!(joint.kind.as_str(), "revolute" | "cylindrical") {
                return None;
            }
            let sign = match (joint.first.body, joint.second.body) {
                (a, b) if a == other && b == body => 1.0,
                (a, b) if a == body && b == other => -1.0,
                _ => return None,
            };
            Some((vec![(index, sign)], Some(column(&joint.frame, 2))))
        })
    }

    /// The factors of a pair, what is fixed together being one.
    fn independent(&self, pair: &Pair) -> BTreeMap<Turning, f64> {
        let mut row = BTreeMap::new();
        for (factor, what) in &pair.terms {
            let key = match what {
                Turning::Body(body) => match self.orientation(Some(*body), "") {
                    Ok((Some(root), _)) => Turning::Body(root),
                    _ => *what,
                },
                Turning::Joint(_) | Turning::Travel(_) => *what,
            };
            *row.entry(key).or_default() += factor;
        }
        row
    }
}

fn keeps_place(joint: &Joint) -> bool {
    matches!(joint.kind.as_str(), "revolute" | "fixed" | "spherical" | "universal" | "constant_velocity")
}

/// z₁(θ₁ − ψ) + z₂(θ₂ − ψ − π) = π, of a ring z₁(θ₁ − ψ) − z₂(θ₂ − ψ) = π, for the angles of the bodies.
fn facing([first, second]: &[Toothing; 2], sense: f64, [x, y]: [f64; 2], middles: [f64; 2]) -> f64 {
    let psi = if second.internal { (-y).atan2(-x) } else { y.atan2(x) };
    let own = first.teeth * (psi - middles[0]);
    let at = if sense < 0.0 { psi } else { psi + PI };
    PI + own + sense * second.teeth * (at - middles[1])
}

pub(super) fn wrapped(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

/// Of rows with whole entries.
fn rank(rows: &[BTreeMap<Turning, f64>]) -> usize {
    let mut rows: Vec<BTreeMap<Turning, f64>> = rows.to_vec();
    let mut rank = 0;
    while let Some(row) = rows.pop() {
        let largest = row.iter().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
        let Some((pivot, lead)) =
            largest.map(|(pivot, lead)| (*pivot, *lead)).filter(|(_, lead)| lead.abs() > 1e-9)
        else {
            continue;
        };
        rank += 1;
        for other in &mut rows {
            let factor = other.get(&pivot).copied().unwrap_or(0.0) / lead;
            for (key, value) in &row {
                *other.entry(*key).or_default() -= factor * value;
            }
            other.insert(pivot, 0.0);
        }
    }
    rank
}
