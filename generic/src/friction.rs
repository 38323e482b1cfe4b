//! Friction in joints by the reaction that the multipliers make: N p(v) + o(v) against each component of the sliding v.
//!
//! N is found with the accelerations by solving again and again with the friction of the multipliers before (`evaluation`); this is
//! another way than that of the compiler, and it converges where the friction is small beside what presses.

use crate::bristles::Bristles;
use crate::kinematics::{Kinematics, Place};
use crate::law::{Law, Scratch};
use crate::quantity::{Pull, Quantity};
use crate::row::Row;
use crate::vector::*;

/// ε of √(R·R + ε²) is this part of the weight.
pub(crate) const SMALLEST: f64 = 1e-9;

/// m/s², where no gravity is written.
pub(crate) const STANDARD_GRAVITY: f64 = 9.80665;

#[derive(Clone, Debug)]
pub(crate) struct Friction {
    pub kind: Kind,
    pub first: Place,
    pub second: Place,
    /// The axis of the joint, in the axes of the first body.
    pub axis: V3,
    /// Its rows, and where their multipliers are.
    pub rows: Vec<(usize, Row)>,
    /// Components of v that go together: quantities and the factors of their rates.
    pub slips: Vec<Vec<(Slip, f64)>>,
    pub radius: f64,
    pub length: f64,
    pub shoulder: f64,
    pub preload: f64,
    /// ε, N.
    pub smallest: f64,
    pub law: Sliding,
    /// Which of the frictions it is.
    pub index: usize,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Kind {
    Pin,
    /// What presses is the whole force.
    Any,
    /// What presses is the whole force, and what the radius makes of the torque.
    Knuckle,
    Rail,
    /// What presses is the force along the axis.
    Face,
    /// What presses is the force along the axis, by this factor, and that across it.
    Thread(f64),
}

#[derive(Clone, Debug)]
pub(crate) enum Slip {
    Of(Box<Quantity>),
    /// ω of the second body less that of the first, along an axis of the world.
    Turn {
        first: Option<usize>,
        second: Option<usize>,
        axis: usize,
    },
    /// Quantities that go together, each by a factor.
    Sum(Vec<(Quantity, f64)>),
}

#[derive(Clone, Debug)]
pub(crate) enum Sliding {
    Coulomb { coefficient: Law, speed: f64, own: f64 },
    Stribeck { most: Law, least: Law, transition: f64, speed: f64, viscous: f64 },
    Remembers(Bristles),
}

impl Slip {
    fn rate(&self, at: &Kinematics) -> f64 {
        match self {
            Slip::Of(quantity) => quantity.jet(at).along.rate,
            Slip::Turn { first, second, axis } => {
                at.frame(*second).spin[*axis] - at.frame(*first).spin[*axis]
            }
            Slip::Sum(parts) => parts.iter().map(|(part, by)| by * part.jet(at).along.rate).sum(),
        }
    }

    fn pulls(&self, at: &Kinematics) -> Vec<Pull> {
        match self {
            Slip::Of(quantity) => quantity.jet(at).pulls.into(),
            Slip::Sum(parts) => {
                let of = |(part, by): &(Quantity, f64)| part.jet(at).pulls.map(|pull| pull.scaled(*by));
                parts.iter().flat_map(of).collect()
            }
            Slip::Turn { first, second, axis } => {
                let pull = |body, sign| Pull::on(body, ZERO, times(sign, unit_axis(*axis)));
                vec![pull(*first, -1.0), pull(*second, 1.0)]
            }
        }
    }
}

impl Sliding {
    /// p and o of each component, of which z are the deflections of a law that remembers.
    pub fn resisted(
        &self,
        v: &[f64],
        z: &[f64],
        at: &Kinematics,
        inputs: &[f64],
        scratch: &mut Scratch,
    ) -> Vec<[f64; 2]> {
        let square: f64 = v.iter().map(|v| v * v).sum();
        match self {
            Sliding::Coulomb { coefficient, speed, own } => {
                let coefficient = coefficient.value(at, inputs, scratch);
                let size = square.sqrt().hypot(*speed);
                v.iter().map(|v| [coefficient * v / size, own * v / size]).collect()
            }
            Sliding::Stribeck { most, least, transition, speed, viscous } => {
                let (most, least) = (most.value(at, inputs, scratch), least.value(at, inputs, scratch));
                let coefficient = least + (most - least) * (-square / (transition * transition)).exp();
                let size = square.sqrt().hypot(*speed);
                v.iter().map(|v| [coefficient * v / size, viscous * v]).collect()
            }
            Sliding::Remembers(bristles) => bristles.resisted(v, z, at, inputs, scratch),
        }
    }
}

impl Friction {
    /// N of the multipliers, with the preload; of this alone where there are none yet.
    fn pressed(&self, at: &Kinematics, scratch: &mut Scratch) -> f64 {
        if let Some(size) = at.sizes.get(self.index) {
            return self.preload + size;
        }
        if at.multipliers.is_empty() {
            return self.preload;
        }
        let size = |vector: V3| dot(vector, vector).sqrt().hypot(self.smallest);
        self.preload + self.pressing(at, scratch).into_iter().map(size).sum::<f64>()
    }

    /// The forces of the multipliers whose sizes together press.
    pub fn pressing(&self, at: &Kinematics, scratch: &mut Scratch) -> Vec<V3> {
        // −Dᵀ λ on the body of the second place, or with the other sign on that of the first.
        let (body, sign) = match self.second.body {
            Some(body) => (body, -1.0),
            None => (self.first.body.expect("a joint has a body"), 1.0),
        };
        let (mut force, mut moment) = (ZERO, ZERO);
        for (index, row) in &self.rows {
            let lambda = sign * at.multipliers[*index];
            row.evaluate(at, scratch, |pull| {
                if pull.body == Some(body) {
                    force = plus(force, times(lambda, pull.linear));
                    moment = plus(moment, times(lambda, pull.angular));
                }
            });
        }
        let to_second = minus(at.point(&self.second).position, at.frame(Some(body)).position);
        let torque = minus(moment, cross(to_second, force));
        let axis = turned(&at.frame(self.first.body).axes, self.axis);
        let across = |vector: V3| minus(vector, times(dot(axis, vector), axis));
        match self.kind {
            Kind::Any => vec![force],
            Kind::Knuckle => vec![force, times(1.0 / self.radius, torque)],
            Kind::Face => vec![times(dot(axis, force), axis)],
            Kind::Thread(by) => vec![times(by * dot(axis, force), axis), across(force)],
            Kind::Pin => {
                let mut pressing = vec![across(force)];
                if self.shoulder != 0.0 {
                    pressing.push(times(self.shoulder / self.radius, times(dot(axis, force), axis)));
                }
                if self.length != 0.0 {
                    pressing.push(times(2.0 / self.length, across(torque)));
                }
                pressing
            }
            Kind::Rail => {
                let force = across(force);
                if self.length == 0.0 {
                    return vec![force];
                }
                let couple = times(1.0 / self.length, cross(torque, axis));
                let half = times(0.5, force);
                vec![plus(half, couple), minus(half, couple)]
            }
        }
    }

    /// What it exerts along each quantity that slides.
    fn efforts<'f>(&'f self, at: &Kinematics, inputs: &[f64], scratch: &mut Scratch) -> Vec<(&'f Slip, f64)> {
        let pressed = self.pressed(at, scratch);
        let (mut found, mut from) = (Vec::new(), 0);
        for group in &self.slips {
            let v: Vec<f64> = group.iter().map(|(slip, factor)| factor * slip.rate(at)).collect();
            let z = match &self.law {
                Sliding::Remembers(bristles) => bristles.deflections(at, from, v.len()),
                _ => &[],
            };
            from += v.len();
            let resisted = self.law.resisted(&v, z, at, inputs, scratch);
            for ((slip, factor), [p, o]) in group.iter().zip(resisted) {
                found.push((slip, -factor * (pressed * self.radius * p + o)));
            }
        }
        found
    }

    pub fn bending(&self, at: &Kinematics, inputs: &[f64], scratch: &mut Scratch) -> Vec<f64> {
        let Sliding::Remembers(bristles) = &self.law else { return Vec::new() };
        let mut rates = Vec::new();
        for group in &self.slips {
            let v: Vec<f64> = group.iter().map(|(slip, factor)| factor * slip.rate(at)).collect();
            let z = bristles.deflections(at, rates.len(), v.len());
            rates.extend(bristles.bending(&v, z, at, inputs, scratch));
        }
        rates
    }

    pub fn evaluate(
        &self,
        at: &Kinematics,
        inputs: &[f64],
        scratch: &mut Scratch,
        mut add: impl FnMut(Pull),
    ) {
        for (slip, effort) in self.efforts(at, inputs, scratch) {
            for pull in slip.pulls(at) {
                add(pull.scaled(effort));
            }
        }
    }

    pub fn power(&self, at: &Kinematics, inputs: &[f64], scratch: &mut Scratch) -> f64 {
        self.efforts(at, inputs, scratch).into_iter().map(|(slip, effort)| effort * slip.rate(at)).sum()
    }
}
