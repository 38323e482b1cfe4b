//! Loads between teeth as they are written; the stiffness that follows from the shape of teeth.
//!
//! Cantilevers of the thickness where they are touched, or bending, shear and compression along the flank (Cornell 1981) with the body below
//! (Sainsot, Velex & Duverger 2004) and the contact (Yang & Sun 1985), at 256 places of a pitch.

use super::gears::{Kind, Pair, Toothing};
use super::laws::May;
use super::{Read, Reader};
use crate::error::DefinitionError;
use crate::json::{field, optional, text};
use crate::law::Law;
use crate::load::Acts;
use crate::mesh::{Mesh, Stiffness};
use crate::vector::{dot, norm, turned, unit_axis};
use serde_json::Value;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const POSITIONS: usize = 256;
/// Strips of a tooth, by Simpson's rule.
const STRIPS: usize = 400;

impl Reader<'_> {
    pub(super) fn mesh(&self, node: &Value, own: &str) -> Read<Acts> {
        let pairs = self.pairs()?;
        let pair = pairs.iter().find(|(name, _)| name == own).map(|(_, pair)| pair);
        let pair = pair.ok_or_else(|| DefinitionError::unknown(own, "a pair of toothings"))?;
        let [first, second] = &pair.wheels;
        let sense = if first.internal || second.internal { -1.0 } else { 1.0 };
        let bases = [first.base(), second.base()];
        let shape = Shape::of(pair);
        let written = field(node, "stiffness", own)?;
        let (stiffness, mean) = match optional(written, "involute") {
            Some(involute) => {
                let (mean, waves) = self.series(&shape, involute, own)?;
                let signed = pair.side * self.entry_of(node, "sense", own)?.unwrap_or(1.0).signum();
                let teeth = pair.wheels[pair.counted].teeth;
                let still = pair.still + pair.first - pair.direction;
                let start = shape.start() + signed * teeth * still / TAU;
                let turns = pair
                    .turns
                    .iter()
                    .map(|(factor, what)| Ok((signed * teeth * factor, self.turning(*what, own)?)));
                let turns = turns.collect::<Read<_>>()?;
                (Stiffness::Series { mean, waves, start, turns }, mean)
            }
            None => {
                let law = self.law_of(written, own)?;
                let mean = law.expression.constant().unwrap_or(f64::NAN);
                (Stiffness::Law(law), mean)
            }
        };
        let (mut damping, mut always) = (0.0, false);
        if let Some(entry) = optional(node, "damping") {
            let value = field(entry, "value", own)?;
            let unit = entry.get("unit").and_then(Value::as_str);
            always = value.get("call").and_then(Value::as_str) == Some("always");
            damping =
                if always { self.in_unit(&value["args"][0], unit, own)? } else { self.entry(entry, own)? };
        }
        if let Some(ratio) = self.entry_of(node, "damping_ratio", own)? {
            let mass = self.reduced_mass(pair, own)?;
            damping = 2.0 * ratio * (mean * mass).sqrt();
        }
        let backlash = self.entry_of(node, "backlash", own)?.unwrap_or(0.0);
        let error = match optional(node, "error") {
            Some(entry) => self.law_of(entry, own)?,
            None => Law::constant(0.0),
        };
        let error_rate = optional(node, "error_rate").map(|entry| self.law_of(entry, own)).transpose()?;
        let elastic = matches!(&stiffness, Stiffness::Law(law) if law.expression.constant().is_some())
            && optional(node, "error").is_none()
            && (always || backlash == 0.0 || damping == 0.0);
        let terms = pair.terms.iter().map(|(factor, what)| Ok((*factor, self.turning(*what, own)?)));
        Ok(Acts::Mesh(Box::new(Mesh {
            terms: terms.collect::<Read<_>>()?,
            centers: [first.center.clone(), second.center.clone()],
            bases,
            sense,
            ring_is_second: second.internal,
            radius: pair.radius,
            working: shape.working,
            touch: pair.touch,
            constant: pair.constant,
            pitches: None,
            stiffness,
            damping,
            always,
            backlash,
            error,
            error_rate,
            elastic,
        })))
    }

    fn law_of(&self, entry: &Value, own: &str) -> Read<Law> {
        self.reading(own, May::Motion, |law| law.entry(entry))
    }

    /// 1/Σ (∂u/∂θ)²/I, I of all that turns with a wheel; of a rack its mass along the line of action.
    fn reduced_mass(&self, pair: &Pair, own: &str) -> Read<f64> {
        let mut inverse = 0.0;
        for wheel in &pair.wheels {
            let (root, _) = self.orientation(Some(wheel.body), own)?;
            if root.is_none() {
                continue;
            }
            let along = match self.spatial && wheel.kind != Kind::Rack {
                true => self.turn(Some(wheel.body), pair.carrier).and_then(|(_, axis)| axis),
                false => None,
            };
            let axis = along.unwrap_or(unit_axis(2));
            let fixed = match wheel.kind {
                Kind::Rack => self.fixed_to(wheel, own)?.into_iter().map(|(body, ..)| body).collect(),
                _ => Vec::new(),
            };
            let mut inertia = 0.0;
            for body in 0..self.bodies.len() {
                let moves_with = match wheel.kind {
                    Kind::Rack => fixed.contains(&Some(body)),
                    _ => self.orientation(Some(body), own)?.0 == root,
                };
                if moves_with {
                    let body = &self.bodies[body];
                    inertia += match wheel.kind {
                        Kind::Rack => body.mass,
                        _ => dot(axis, turned(&body.inertia, axis)),
                    };
                }
            }
            let lever = match (wheel.kind, &pair.touch) {
                (Kind::Rack, Some(touch)) => norm(touch.push),
                _ => pair.radius * wheel.teeth,
            };
            inverse += lever * lever / inertia;
        }
        Ok(1.0 / inverse)
    }

    /// Mean and waves over a pitch.
    fn series(&self, shape: &Shape, node: &Value, own: &str) -> Read<(f64, Vec<[f64; 2]>)> {
        let number = |key: &str, default: f64| Ok(self.entry_of(node, key, own)?.unwrap_or(default));
        let material = Material {
            young: self.needed(node, "young", own)?,
            poisson: number("poisson", 0.3)?,
            section: match optional(node, "tooth") {
                Some(tooth) => text(field(tooth, "value", own)?, "name", own)? == "section",
                None => false,
            },
            width: [&shape.wheel, &shape.other]
                .iter()
                .filter_map(|it| it.width)
                .fold(f64::INFINITY, f64::min),
        };
        let (harmonics, over) = (number("harmonics", 5.0)? as usize, number("entry", 0.0)?);
        let [begin, end] = shape.path();
        let ratio = (end - begin) / shape.pitch;
        let mut curve = [0.0; POSITIONS];
        for (index, k) in curve.iter_mut().enumerate() {
            let mut at = index as f64 / POSITIONS as f64;
            while at < ratio {
                let s = if over == 0.0 { 1.0 } else { (at.min(ratio - at) / over).clamp(0.0, 1.0) };
                *k += s * s * (3.0 - 2.0 * s) * shape.of_one(&material, begin + at * shape.pitch);
                at += 1.0;
            }
        }
        let mean = curve.iter().sum::<f64>() / POSITIONS as f64;
        let wave = |h: usize| {
            let mut sums = [0.0; 2];
            for (index, k) in curve.iter().enumerate() {
                let angle = TAU * (h * index) as f64 / POSITIONS as f64;
                sums[0] += 2.0 * k * angle.cos() / POSITIONS as f64;
                sums[1] += 2.0 * k * angle.sin() / POSITIONS as f64;
            }
            sums
        };
        // Slanted teeth: the mean over the face, from one end to the other of which they come later by so many pitches.
        let overlap = material.width * shape.helix.abs().sin() / (PI * shape.wheel.module);
        let over_the_face = |h: usize| {
            let angle = PI * h as f64 * overlap;
            let part = if angle == 0.0 { 1.0 } else { angle.sin() / angle };
            wave(h).map(|wave| part * wave)
        };
        Ok((mean, (1..=harmonics).map(over_the_face).collect()))
    }
}

struct Material {
    young: f64,
    poisson: f64,
    section: bool,
    width: f64,
}

/// The teeth of a pair in the section in which they mesh, the wheel before its partner.
struct Shape {
    wheel: Toothing,
    other: Toothing,
    distance: f64,
    working: f64,
    pitch: f64,
    helix: f64,
}

fn inv(angle: f64) -> f64 {
    angle.tan() - angle
}

impl Shape {
    fn of(pair: &Pair) -> Self {
        let (wheel, other) = (&pair.wheels[pair.counted], &pair.wheels[1 - pair.counted]);
        let (mut wheel, mut other, mut distance) = (wheel.clone(), other.clone(), pair.distance);
        if wheel.kind == Kind::Bevel {
            // Tredgold's spur gears, in the middle of the face.
            let long = wheel.pitch() / wheel.cone.sin();
            let face = [&wheel, &other].iter().filter_map(|it| it.width).fold(f64::INFINITY, f64::min);
            let part = if face.is_finite() { 1.0 - 0.5 * face / long } else { 1.0 };
            for spur in [&mut wheel, &mut other] {
                spur.teeth /= spur.cone.cos();
                spur.module *= part;
            }
            distance = wheel.pitch() + other.pitch();
        }
        let working = match other.kind {
            Kind::Cylinder => {
                let sense = if other.internal { -1.0 } else { 1.0 };
                ((other.base() + sense * wheel.base()).abs() / distance).acos()
            }
            Kind::Rack | Kind::Bevel | Kind::Worm => wheel.transverse(),
        };
        let (pitch, helix) = (TAU * wheel.base() / wheel.teeth, wheel.helix);
        Shape { wheel, other, distance, working, pitch, helix }
    }

    fn tangent(&self) -> f64 {
        self.distance * self.working.sin()
    }

    fn path(&self) -> [f64; 2] {
        let reach = |wheel: &Toothing| (wheel.tip().powi(2) - wheel.base().powi(2)).max(0.0).sqrt();
        let Shape { wheel, other, .. } = self;
        if other.internal {
            [(reach(other) - self.tangent()).max(0.0), reach(wheel)]
        } else if matches!(other.kind, Kind::Rack | Kind::Worm) {
            let above = other.module * other.addendum - wheel.module * wheel.shift;
            let begin = wheel.pitch() * self.working.sin() - above / self.working.sin();
            [begin.max(0.0), reach(wheel)]
        } else {
            [(self.tangent() - reach(other)).max(0.0), reach(wheel).min(self.tangent())]
        }
    }

    /// τ where a tooth of the wheel stands on the line of centres.
    fn start(&self) -> f64 {
        let wheel = &self.wheel;
        let half = (FRAC_PI_2 + 2.0 * wheel.shift * wheel.angle.tan()) / wheel.teeth
            + inv(wheel.transverse())
            - inv(self.working);
        (wheel.base() * (self.working.tan() + half) - self.path()[0]) / self.pitch
    }

    fn of_one(&self, material: &Material, along: f64) -> f64 {
        let Shape { wheel, other, .. } = self;
        let across = match other.kind {
            Kind::Rack => self.distance - wheel.base() * self.working.cos() - along * self.working.sin(),
            _ if other.internal => self.tangent() + along,
            _ => self.tangent() - along,
        };
        let give = [(wheel, along), (other, across)].map(|(toothing, along)| {
            if toothing.kind == Kind::Rack {
                straight(toothing, material, along)
            } else if material.section {
                section(toothing, material, along)
            } else {
                profile(toothing, material, along)
            }
        });
        let contact = 4.0 * (1.0 - material.poisson.powi(2)) / (PI * material.young * material.width);
        1.0 / (give[0] + give[1] + if material.section { 0.0 } else { contact })
    }
}

/// Half the angle of a tooth where the pressure angle is this.
fn half(toothing: &Toothing, angle: f64) -> f64 {
    let side = if toothing.internal { -1.0 } else { 1.0 };
    (FRAC_PI_2 + side * 2.0 * toothing.shift * toothing.angle.tan()) / toothing.teeth
        + side * (inv(toothing.transverse()) - inv(angle))
}

/// A rack's tooth, touched so far above its line: a trapezium.
fn straight(rack: &Toothing, material: &Material, height: f64) -> f64 {
    let Material { young, poisson, width, section } = *material;
    let foot = -rack.dedendum * rack.module;
    let thick = |y: f64| FRAC_PI_2 * rack.module - 2.0 * y * rack.angle.tan();
    if section {
        return 4.0 * (height - foot).powi(3) / (young * width * thick(height).powi(3));
    }
    let plate = if width > 5.0 * thick(0.0) { young / (1.0 - poisson * poisson) } else { young };
    let (sine, cosine) = rack.angle.sin_cos();
    simpson(foot, height, |y| {
        let bent = (height - y) * cosine - 0.5 * thick(height) * sine;
        12.0 * bent * bent / (plate * width * thick(y).powi(3))
            + 2.4 * (1.0 + poisson) * cosine * cosine / (young * width * thick(y))
            + sine * sine / (plate * width * thick(y))
    })
}

fn section(toothing: &Toothing, material: &Material, along: f64) -> f64 {
    let (radius, angle) = (toothing.base().hypot(along), along.atan2(toothing.base()));
    let half = half(toothing, angle);
    let inertia = material.width * (2.0 * radius * half.sin()).powi(3) / 12.0;
    (radius * half.cos() - toothing.root()).abs().powi(3) / (3.0 * material.young * inertia)
}

fn profile(toothing: &Toothing, material: &Material, along: f64) -> f64 {
    let Material { young, poisson, width, .. } = *material;
    let (base, root) = (toothing.base(), toothing.root());
    let side = if toothing.internal { -1.0 } else { 1.0 };
    let (radius, angle) = (base.hypot(along), along.atan2(base));
    let of_contact = half(toothing, angle);
    let load = angle - side * of_contact;
    let (height, across) = (side * radius * of_contact.cos(), radius * of_contact.sin());
    let pitch = 0.5 * toothing.module / toothing.helix.cos() * toothing.teeth;
    let is_wide = width > 10.0 * pitch * half(toothing, toothing.transverse());
    let plate = if is_wide { young / (1.0 - poisson * poisson) } else { young };
    let shear = young / (2.0 * (1.0 + poisson));
    let give = |y: f64, x: f64| {
        let moment = (height - y) * load.cos() - across * load.sin();
        moment.powi(2) / (plate * 2.0 / 3.0 * width * x.powi(3))
            + (1.2 * load.cos().powi(2) / shear + load.sin().powi(2) / plate) / (2.0 * width * x)
    };
    let whole = half(toothing, 0.0);
    let foot = if root > base { (base / root).acos() } else { 0.0 };
    let mut sum = 0.0;
    if !toothing.internal && root < base {
        sum += simpson(root * whole.cos(), base * whole.cos(), |y| give(y, y * whole.tan()));
    }
    sum += simpson(foot, angle, |angle| {
        let (half, radius) = (half(toothing, angle), base / angle.cos());
        let growth = radius * angle.tan() * (half.cos() + side * half.sin() * angle.tan());
        give(side * radius * half.cos(), radius * half.sin()) * side * growth
    });
    if toothing.internal {
        return sum;
    }
    let theta = half(toothing, foot);
    let ratio = 2.0 * root / toothing.bore.unwrap_or(root);
    let of = |c: [f64; 6]| {
        c[0] / theta.powi(2)
            + c[1] * ratio.powi(2)
            + c[2] * ratio / theta
            + c[3] / theta
            + c[4] * ratio
            + c[5]
    };
    let l = of([-5.574e-5, -1.9986e-3, -2.3015e-4, 4.7702e-3, 0.0271, 6.8045]);
    let m = of([60.111e-5, 28.100e-3, -83.431e-4, -9.9256e-3, 0.1624, 0.9086]);
    let p = of([-50.952e-5, 185.50e-3, 0.0538e-4, 53.300e-3, 0.2895, 0.9236]);
    let q = of([-6.2042e-5, 9.0889e-3, -4.0964e-4, 7.8297e-3, -0.1472, 0.6904]);
    let part = (height - across * load.tan() - root * theta.cos()) / (2.0 * root * theta);
    let body = l * part.powi(2) + m * part + p * (1.0 + q * load.tan().powi(2));
    sum + load.cos().powi(2) / (width * young) * body
}

fn simpson(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    let step = (to - from) / STRIPS as f64;
    let weight = |index: usize| match index {
        0 | STRIPS => 1.0,
        odd if odd % 2 == 1 => 4.0,
        _ => 2.0,
    };
    (0..=STRIPS).map(|index| weight(index) * f(from + step * index as f64)).sum::<f64>() * step / 3.0
}
