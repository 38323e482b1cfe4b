//! Friction where surfaces touch: N p(v) + o(v) against each component of the sliding v, N being the force of the contact.
//!
//! The normal is what the gap pushes the first body by, so that it follows from the gap's derivatives. v is the velocity of the material of
//! both bodies at the point where they touch, without its part along the normal.

use crate::bristles::{Bristles, FORGETTING};
use crate::friction;
use crate::kinematics::{Kinematics, Place, Section};
use crate::law::{Law, Scratch};
use crate::quantity::Pull;
use crate::vector::*;

#[derive(Clone, Debug)]
pub(crate) struct Rubbing {
    pub law: friction::Sliding,
    pub spots: Vec<Spot>,
}

/// Where two things may touch, and what presses them there.
#[derive(Clone, Debug)]
pub(crate) struct Spot {
    pub meeting: Meets,
    pub force: Law,
}

/// Where two things may touch, and how they slide there.
#[derive(Clone, Debug)]
pub(crate) struct Meets {
    pub gap: Law,
    pub slides: Slides,
}

/// How two things slide: along an axis of the world, or their only component.
#[derive(Clone, Debug)]
pub(crate) struct Sliding {
    pub meets: Meets,
    pub axis: Option<usize>,
}

#[derive(Clone, Debug)]
pub(crate) enum Slides {
    /// An expression of positions, m.
    Along(Law),
    Surfaces {
        first: Place,
        second: Place,
        at: At,
        /// Bodies that do not turn.
        particles: [bool; 2],
        /// Whether the two are written the other way round.
        reversed: bool,
    },
}

#[derive(Clone, Debug)]
pub(crate) enum At {
    World(Box<[Law; 3]>),
    /// Under the first place by this radius and half of the gap.
    Under(f64),
}

impl Rubbing {
    pub fn evaluate(
        &self,
        at: &Kinematics,
        inputs: &[f64],
        scratch: &mut Scratch,
        mut add: impl FnMut(Pull),
    ) {
        for (which, spot) in self.spots.iter().enumerate() {
            spot.rub(&self.law, which, at, inputs, scratch, &mut add);
        }
    }

    /// ż of the deflections of a law that remembers, of open places back to zero.
    pub fn bending(&self, at: &Kinematics, inputs: &[f64], scratch: &mut Scratch) -> Vec<f64> {
        let friction::Sliding::Remembers(bristles) = &self.law else { return Vec::new() };
        let mut rates = Vec::new();
        for (which, spot) in self.spots.iter().enumerate() {
            let z = bristles.deflections(at, which * bristles.components, bristles.components);
            if spot.meeting.gap.value(at, &[], scratch) >= 0.0 {
                rates.extend(z.iter().map(|z| -z / FORGETTING));
                continue;
            }
            let v = spot.meeting.components(bristles, at, scratch).0;
            rates.extend(bristles.bending(&v, z, at, inputs, scratch));
        }
        rates
    }

    pub fn power(&self, at: &Kinematics, inputs: &[f64], scratch: &mut Scratch) -> f64 {
        let spots = self.spots.iter().enumerate();
        spots.map(|(which, spot)| spot.rub(&self.law, which, at, inputs, scratch, &mut |_| ())).sum()
    }
}

impl Spot {
    /// Its power.
    fn rub(
        &self,
        law: &friction::Sliding,
        which: usize,
        at: &Kinematics,
        inputs: &[f64],
        scratch: &mut Scratch,
        add: &mut impl FnMut(Pull),
    ) -> f64 {
        if self.meeting.gap.value(at, &[], scratch) >= 0.0 {
            return 0.0;
        }
        let pressed = self.force.value(at, inputs, scratch);
        if let Slides::Along(slip) = &self.meeting.slides {
            let rate = slip.course(at, scratch).rate;
            let z = match law {
                friction::Sliding::Remembers(bristles) => bristles.deflections(at, which, 1),
                _ => &[],
            };
            let effort = -resisted(law, &[rate], z, pressed, at, inputs, scratch)[0];
            slip.jet(at, scratch, |pull| add(pull.scaled(effort)));
            return effort * rate;
        }
        let Shift { v, material: [here, there], .. } = self.meeting.shift(at, scratch);
        let force = match law {
            friction::Sliding::Remembers(bristles) => {
                let (v, ways) = self.meeting.components(bristles, at, scratch);
                let z = bristles.deflections(at, which * bristles.components, bristles.components);
                let resisted = resisted(law, &v, z, pressed, at, inputs, scratch);
                let parts = resisted.iter().zip(ways).map(|(resisted, way)| times(-resisted, way));
                parts.fold(ZERO, plus)
            }
            _ => {
                let resisted = resisted(law, &v, &[], pressed, at, inputs, scratch);
                [-resisted[0], -resisted[1], -resisted[2]]
            }
        };
        add(here.pulled(force));
        add(there.pulled(times(-1.0, force)));
        dot(force, v)
    }
}

/// How surfaces slide at one state.
struct Shift {
    /// Of the first against the second, without its part along the normal.
    v: V3,
    /// Of unit length, by which the gap pushes the first.
    normal: V3,
    /// Of each body, where they touch.
    material: [Material; 2],
}

/// What is just there, of a body or of the section of a beam.
#[derive(Clone, Copy)]
struct Material {
    section: Section,
    velocity: V3,
    /// From the body's centre.
    arm: V3,
    /// From the place of the section.
    lever: V3,
}

impl Material {
    fn of(of: &Place, particle: bool, place: V3, at: &Kinematics) -> Self {
        let (frame, point, section) = (at.frame(of.body), at.point(of), at.section(of));
        if of.body.is_none() || particle {
            return Material { section, velocity: point.velocity, arm: ZERO, lever: ZERO };
        }
        let lever = minus(place, point.position);
        let velocity = plus(point.velocity, cross(at.spin(section), lever));
        Material { section, velocity, arm: minus(place, frame.position), lever }
    }

    /// Along the velocity of it.
    fn pulled(&self, force: V3) -> Pull {
        let whole = Pull::on(self.section.body, force, cross(self.arm, force));
        Pull { on_axis: self.section.x, section: cross(self.lever, force), ..whole }
    }
}

impl Meets {
    /// v along the ways that deflections are measured along: one in the plane, in space the axes of the world, turned round with the order.
    fn components(&self, bristles: &Bristles, at: &Kinematics, scratch: &mut Scratch) -> (Vec<f64>, Vec<V3>) {
        let reversed = match &self.slides {
            Slides::Along(slip) => return (vec![slip.course(at, scratch).rate], Vec::new()),
            Slides::Surfaces { reversed, .. } => *reversed,
        };
        let Shift { v, normal: n, .. } = self.shift(at, scratch);
        let ways = if bristles.components == 1 {
            vec![[n[1], -n[0], 0.0]]
        } else {
            let sign = if reversed { -1.0 } else { 1.0 };
            (0..3).map(|axis| times(sign, unit_axis(axis))).collect()
        };
        (ways.iter().map(|way| dot(*way, v)).collect(), ways)
    }

    fn shift(&self, at: &Kinematics, scratch: &mut Scratch) -> Shift {
        let Slides::Surfaces { first, second, at: place, particles, .. } = &self.slides else {
            let still = Material { section: Section::whole(None), velocity: ZERO, arm: ZERO, lever: ZERO };
            return Shift { v: ZERO, normal: ZERO, material: [still; 2] };
        };
        let gap = self.gap.value(at, &[], scratch);
        let mut normal = ZERO;
        let (of, sign) = if first.body.is_some() { (first.body, 1.0) } else { (second.body, -1.0) };
        self.gap.jet(at, scratch, |pull| {
            if pull.body == of {
                normal = plus(normal, times(sign, pull.linear));
            }
        });
        let place = match place {
            At::World(point) => [0, 1, 2].map(|k| point[k].value(at, &[], scratch)),
            At::Under(radius) => minus(at.point(first).position, times(radius + 0.5 * gap, normal)),
        };
        let material = [(first, particles[0]), (second, particles[1])];
        let material = material.map(|(of, particle)| Material::of(of, particle, place, at));
        let v = minus(material[0].velocity, material[1].velocity);
        Shift { v: minus(v, times(dot(normal, v), normal)), normal, material }
    }
}

impl Sliding {
    pub fn rate(&self, at: &Kinematics, scratch: &mut Scratch) -> f64 {
        let reversed = match &self.meets.slides {
            Slides::Along(slip) => return slip.course(at, scratch).rate,
            Slides::Surfaces { reversed, .. } => *reversed,
        };
        let Shift { v, normal: n, .. } = self.meets.shift(at, scratch);
        match self.axis {
            Some(axis) if reversed => -v[axis],
            Some(axis) => v[axis],
            // Both turn with the order.
            None => n[1] * v[0] - n[0] * v[1],
        }
    }
}

fn resisted(
    law: &friction::Sliding,
    v: &[f64],
    z: &[f64],
    pressed: f64,
    at: &Kinematics,
    inputs: &[f64],
    scratch: &mut Scratch,
) -> Vec<f64> {
    law.resisted(v, z, at, inputs, scratch).into_iter().map(|[p, o]| pressed * p + o).collect()
}
