//! Loads between teeth: deflection, stiffness, force, and what acts on the wheels.

use crate::kinematics::{Kinematics, Place};
use crate::law::{Law, Scratch};
use crate::quantity::{Pull, Quantity};
use crate::vector::{V3, cross, minus, norm, plus, times, turned};
use std::f64::consts::TAU;

/// Two wheels that touch by their teeth.
#[derive(Clone, Debug)]
pub(crate) struct Mesh {
    /// In pitches, of which one is so many radians along the line of action; with a place of its centre and the radius of its base circle of each wheel.
    pub radius: f64,
    pub terms: Vec<(f64, Quantity)>,
    pub centers: [Place; 2],
    pub bases: [f64; 2],
    /// +1 of two wheels, −1 of a wheel in a ring; whether the ring is the second.
    pub sense: f64,
    pub ring_is_second: bool,
    pub working: f64,
    /// Of all but cylinders in the plane.
    pub touch: Option<Touch>,
    /// What the sum of the terms is where the teeth meet, and which of its pitches: the nearest, where none was kept.
    pub constant: f64,
    pub pitches: Option<f64>,
    pub stiffness: Stiffness,
    pub damping: f64,
    pub always: bool,
    pub backlash: f64,
    pub error: Law,
    pub error_rate: Option<Law>,
    pub elastic: bool,
}

/// Where pitch surfaces touch, in the axes of what holds the wheels: there N along `push` and |N| along `part` act on the second body.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Touch {
    pub carrier: Option<usize>,
    /// From the centre of one of both.
    pub from: usize,
    pub at: V3,
    pub push: V3,
    pub part: V3,
}

#[derive(Clone, Debug)]
pub(crate) enum Stiffness {
    Law(Law),
    /// Mean and waves over τ = start + Σ factor · angle/2π.
    Series {
        mean: f64,
        waves: Vec<[f64; 2]>,
        start: f64,
        turns: Vec<(f64, Quantity)>,
    },
}

impl Mesh {
    fn sum(&self, at: &Kinematics) -> [f64; 2] {
        let terms = self.terms.iter().map(|(factor, quantity)| (factor, quantity.jet(at).along));
        terms.fold([0.0; 2], |[value, rate], (factor, along)| {
            [value + factor * along.value, rate + factor * along.rate]
        })
    }

    fn nearest(&self, at: &Kinematics) -> f64 {
        ((self.sum(at)[0] - self.constant) / TAU).round()
    }

    /// Keeps the pitch that is nearest to where the wheels stand.
    pub fn settle(&mut self, at: &Kinematics) {
        self.pitches = Some(self.nearest(at));
    }

    fn deflection(&self, at: &Kinematics, inputs: &[f64], scratch: &mut Scratch) -> f64 {
        let phase = self.constant + TAU * self.pitches.unwrap_or_else(|| self.nearest(at));
        self.radius * (self.sum(at)[0] - phase) - self.error.value(at, inputs, scratch)
    }

    fn stiffness(&self, at: &Kinematics, inputs: &[f64], scratch: &mut Scratch) -> f64 {
        match &self.stiffness {
            Stiffness::Law(law) => law.value(at, inputs, scratch),
            Stiffness::Series { mean, waves, start, turns } => {
                let turned: f64 =
                    turns.iter().map(|(factor, quantity)| factor * quantity.jet(at).along.value).sum();
                let waves = waves.iter().enumerate().map(|(h, [a, b])| {
                    let angle = (h + 1) as f64 * (TAU * start + turned);
                    a * angle.cos() + b * angle.sin()
                });
                mean + waves.sum::<f64>()
            }
        }
    }

    /// N.
    fn force(&self, at: &Kinematics, inputs: &[f64], scratch: &mut Scratch) -> f64 {
        let (k, u) = (self.stiffness(at, inputs, scratch), self.deflection(at, inputs, scratch));
        let error = match &self.error_rate {
            Some(rate) => rate.value(at, inputs, scratch),
            None => self.error.course(at, scratch).rate,
        };
        let resisted = self.damping * (self.radius * self.sum(at)[1] - error);
        let half = 0.5 * self.backlash;
        if half == 0.0 {
            return k * u + resisted;
        }
        let spring = if u > half {
            u - half
        } else if u < -half {
            u + half
        } else {
            0.0
        };
        if self.always {
            k * spring + resisted
        } else if spring > 0.0 {
            (k * spring + resisted).max(0.0)
        } else if spring < 0.0 {
            (k * spring + resisted).min(0.0)
        } else {
            0.0
        }
    }

    pub fn evaluate(
        &self,
        at: &Kinematics,
        inputs: &[f64],
        scratch: &mut Scratch,
        mut add: impl FnMut(Pull),
    ) {
        let force = self.force(at, inputs, scratch);
        let [first, second] = [0, 1].map(|which| at.point(&self.centers[which]));
        if let Some(touch) = &self.touch {
            let axes = &at.frame(touch.carrier).axes;
            let [near, push, part] = [touch.at, touch.push, touch.part].map(|vector| turned(axes, vector));
            let there = plus([first.position, second.position][touch.from], near);
            let pushed = plus(times(force, push), times(force.abs(), part));
            for (point, side) in [(first, -1.0), (second, 1.0)] {
                let arm = plus(minus(there, point.position), point.arm);
                let linear = times(side, pushed);
                add(Pull::on(point.body, linear, cross(arm, linear)));
            }
            return;
        }
        let between = minus(second.position, first.position);
        let along: V3 = times(1.0 / norm(between), between);
        let across = cross([0.0, 0.0, 1.0], along);
        let tangential = self.working.cos() * force * if self.ring_is_second { -1.0 } else { 1.0 };
        let radial = self.sense * self.working.sin() * force.abs();
        let pushed = plus(times(tangential, across), times(radial, along));
        let torques = [-self.bases[0] * force, -self.sense * self.bases[1] * force];
        for ((point, torque), side) in [first, second].into_iter().zip(torques).zip([-1.0, 1.0]) {
            let linear = times(side, pushed);
            let angular = plus(cross(point.arm, linear), [0.0, 0.0, torque]);
            add(Pull::on(point.body, linear, angular));
        }
    }

    /// ½ k f², where that is an energy.
    pub fn energy(&self, at: &Kinematics) -> f64 {
        if !self.elastic {
            return 0.0;
        }
        let mut scratch = Scratch::default();
        let (k, u) = (self.stiffness(at, &[], &mut scratch), self.deflection(at, &[], &mut scratch));
        0.5 * k * (u.abs() - 0.5 * self.backlash).max(0.0).powi(2)
    }
}
