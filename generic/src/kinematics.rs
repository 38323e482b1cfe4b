//! Where every body is and how it moves, and the same of places fixed to bodies or given on the ground.
//!
//! Plane and space share it: a planar body is one whose z stays 0 and that turns about z alone. What is different is
//! how many coordinates it has, in `coordinates`.

use crate::beam::Beam;
use crate::coordinates::Bent;
use crate::expression::{Expression, Scope};
use crate::number::Taylor;
use crate::vector::*;
use std::sync::Arc;

/// The motion of a body's axes; of the ground, rest.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    /// Of the centre of mass, m, world.
    pub position: V3,
    /// World ← body.
    pub axes: M3,
    /// m/s, world.
    pub velocity: V3,
    /// ω, rad/s, world.
    pub spin: V3,
    /// θ of a planar body, over several turns, rad.
    pub angle: f64,
    /// Where its modes begin among those of all beams.
    pub modes: usize,
}

pub(crate) const GROUND: Frame =
    Frame { position: ZERO, axes: IDENTITY, velocity: ZERO, spin: ZERO, angle: 0.0, modes: 0 };

/// A place of a body, or of the ground where there is none.
#[derive(Clone, Debug)]
pub(crate) struct Place {
    pub body: Option<usize>,
    /// From the body's centre of mass in its axes, or in the world, m.
    pub local: V3,
    /// Of its marker, body ← marker.
    pub axes: M3,
    /// Where it is on the ground at any time, instead of `local`.
    pub moving: Option<Box<[Expression; 3]>>,
    /// The origin of a free beam's frame, which is no point of its axis.
    pub of_mean: bool,
}

impl Place {
    /// In the axes of its body, or in the world at a time, m.
    pub fn at(&self, time: f64) -> V3 {
        let still = Scope { time, inputs: &[], states: &[], quantities: &[], rates: &[] };
        match &self.moving {
            Some(components) => [0, 1, 2].map(|k| components[k].evaluate(&still)),
            None => self.local,
        }
    }
}

/// What a place does where no velocity changes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Point {
    pub body: Option<usize>,
    /// From the body's centre of mass, world axes, m.
    pub arm: V3,
    pub position: V3,
    pub velocity: V3,
    /// ω × (ω × arm), or the acceleration of a place that moves by itself, m/s².
    pub bias: V3,
    /// Where it is on the axis of a beam.
    pub on_axis: Option<f64>,
}

/// The orientation of a body, or of the section of a beam at x.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Section {
    pub body: Option<usize>,
    pub x: Option<f64>,
}

impl Section {
    /// Of a body, or of the ground.
    pub fn whole(body: Option<usize>) -> Self {
        Section { body, x: None }
    }
}

/// How a body, or a section of a beam in space, is turned and turns.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turned {
    /// World ← it.
    pub axes: M3,
    /// ω, world.
    pub spin: V3,
    /// ω̇ at v̇ = 0, world: none of a body.
    pub faster: V3,
}

/// The motion of all bodies at one time.
#[derive(Clone, Debug, Default)]
pub(crate) struct Kinematics {
    pub time: f64,
    pub frames: Vec<Frame>,
    /// Of each body, if it is one.
    pub beams: Vec<Option<Arc<Beam>>>,
    /// Coordinates of modes with their rates, beam by beam.
    pub modal: Vec<[f64; 2]>,
    /// Angles of spatial joints over several turns, rad.
    pub counted: Vec<f64>,
    /// Internal states, in SI.
    pub internal: Vec<f64>,
    /// λ, which rates of internal states may name; as many as there are rows.
    pub multipliers: Vec<f64>,
    /// Σ |R| of each friction by reactions where that is given, N, in place of what the multipliers make of it.
    pub sizes: Vec<f64>,
}

impl Kinematics {
    pub fn frame(&self, body: Option<usize>) -> &Frame {
        body.map_or(&GROUND, |body| &self.frames[body])
    }

    /// p = r + A d, ṗ = ṙ + ω × A d, p̈ = r̈ + ω̇ × A d + ω × (ω × A d).
    pub fn point(&self, place: &Place) -> Point {
        let Some(body) = place.body else { return self.ground(place) };
        let frame = &self.frames[body];
        if let Some(beam) = self.beam(body).filter(|_| !place.of_mean) {
            return self.on_axis(body, beam, place.local[0]);
        }
        let arm = turned(&frame.axes, place.local);
        let swept = cross(frame.spin, arm);
        Point {
            body: Some(body),
            arm,
            position: plus(frame.position, arm),
            velocity: plus(frame.velocity, swept),
            bias: cross(frame.spin, swept),
            on_axis: None,
        }
    }

    pub fn beam(&self, body: usize) -> Option<&Beam> {
        self.beams.get(body)?.as_deref()
    }

    /// A beam with its modes.
    pub fn bent(&self, body: usize) -> Option<Bent<'_>> {
        self.beam(body).map(|beam| (beam, self.modes(body, beam)))
    }

    /// The coordinates and rates of a beam's modes.
    pub fn modes(&self, body: usize, beam: &Beam) -> &[[f64; 2]] {
        let first = self.frames[body].modes;
        &self.modal[first..first + beam.count()]
    }

    /// p = r + A d(p), ṗ = ṙ + ω × A d + A ḋ, with ω × (ω × A d) + 2 ω × A ḋ, and A d̈ of what bending draws in.
    fn on_axis(&self, body: usize, beam: &Beam, x: f64) -> Point {
        let frame = &self.frames[body];
        let (mut local, mut rate) = ([x, 0.0, 0.0], ZERO);
        for (mode, [p, p_rate]) in self.modes(body, beam).iter().enumerate() {
            let value = beam.value(mode, x);
            local[beam.axis(mode)] += value * p;
            rate[beam.axis(mode)] += value * p_rate;
        }
        let ([drawn, drawn_rate, faster], _) = beam.drawn_in(&beam.gammas(x), self.modes(body, beam));
        local[0] += drawn;
        rate[0] += drawn_rate;
        let faster = turned(&frame.axes, [faster, 0.0, 0.0]);
        let (arm, moved) = (turned(&frame.axes, local), turned(&frame.axes, rate));
        let swept = cross(frame.spin, arm);
        Point {
            body: Some(body),
            arm,
            position: plus(frame.position, arm),
            velocity: plus(frame.velocity, plus(swept, moved)),
            bias: plus(faster, plus(cross(frame.spin, swept), times(2.0, cross(frame.spin, moved)))),
            on_axis: Some(x),
        }
    }

    /// What turns at a place: the section of a beam there, else the body.
    pub fn section(&self, place: &Place) -> Section {
        let on_axis = place.body.is_some_and(|body| self.beam(body).is_some()) && !place.of_mean;
        Section { body: place.body, x: on_axis.then_some(place.local[0]) }
    }

    /// Of a body, or in space of a section: A R and ω + A R ω′ with the turn R and its rate ω′ against the body.
    pub fn turned(&self, section: Section) -> Turned {
        let frame = self.frame(section.body);
        let whole = Turned { axes: frame.axes, spin: frame.spin, faster: ZERO };
        let (Some(body), Some(x)) = (section.body, section.x) else { return whole };
        let Some(beam) = self.beam(body).filter(|beam| beam.spatial) else { return whole };
        let turning = beam.turning(x, self.modes(body, beam));
        let own = turned(&frame.axes, turning.rate);
        Turned {
            axes: product(&frame.axes, &turning.matrix),
            spin: plus(frame.spin, own),
            faster: plus(turned(&frame.axes, turning.faster), cross(frame.spin, own)),
        }
    }

    /// ω of a body or a section, world.
    pub fn spin(&self, section: Section) -> V3 {
        match section.body.and_then(|body| self.beam(body)) {
            Some(beam) if !beam.spatial => {
                plus(self.frame(section.body).spin, [0.0, 0.0, self.slope(section)[1]])
            }
            _ => self.turned(section).spin,
        }
    }

    /// By how much a section is turned against its body, to first order, and how fast.
    pub fn slope(&self, section: Section) -> [f64; 2] {
        let (Some(body), Some(x)) = (section.body, section.x) else { return [0.0; 2] };
        let Some(beam) = self.beam(body) else { return [0.0; 2] };
        let modes = self.modes(body, beam).iter().enumerate();
        modes.fold([0.0; 2], |[sum, rate], (mode, [p, p_rate])| {
            let slope = beam.slope(mode, x);
            [sum + slope * p, rate + slope * p_rate]
        })
    }

    fn ground(&self, place: &Place) -> Point {
        let mut point =
            Point { body: None, arm: ZERO, position: place.local, velocity: ZERO, bias: ZERO, on_axis: None };
        if let Some(components) = &place.moving {
            for (k, component) in components.iter().enumerate() {
                let moved = component.evaluate(&Scope {
                    time: self.now(),
                    inputs: &[],
                    states: &[],
                    quantities: &[],
                    rates: &[],
                });
                point.position[k] = moved.value;
                point.velocity[k] = moved.rate;
                point.bias[k] = moved.bias;
            }
        }
        point
    }

    pub fn now(&self) -> Taylor {
        Taylor { value: self.time, rate: 1.0, bias: 0.0 }
    }
}
