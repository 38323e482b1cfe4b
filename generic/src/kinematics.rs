//! Where every body is and how it moves, and the same of places fixed to bodies or given on the ground.
//!
//! Plane and space share it: a planar body is one whose z stays 0 and that turns about z alone. What is different is
//! how many coordinates it has, in `coordinates`.

use crate::expression::{Expression, Scope};
use crate::number::Taylor;
use crate::vector::*;

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
}

pub(crate) const GROUND: Frame =
    Frame { position: ZERO, axes: IDENTITY, velocity: ZERO, spin: ZERO, angle: 0.0 };

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
}

/// The motion of all bodies at one time.
#[derive(Clone, Debug, Default)]
pub(crate) struct Kinematics {
    pub time: f64,
    pub frames: Vec<Frame>,
    /// Angles of spatial joints over several turns, rad.
    pub counted: Vec<f64>,
    /// Internal states, in SI.
    pub internal: Vec<f64>,
    /// λ, which rates of internal states may name; as many as there are rows.
    pub multipliers: Vec<f64>,
}

impl Kinematics {
    pub fn frame(&self, body: Option<usize>) -> &Frame {
        body.map_or(&GROUND, |body| &self.frames[body])
    }

    /// p = r + A d, ṗ = ṙ + ω × A d, p̈ = r̈ + ω̇ × A d + ω × (ω × A d).
    pub fn point(&self, place: &Place) -> Point {
        let Some(body) = place.body else { return self.ground(place) };
        let frame = &self.frames[body];
        let arm = turned(&frame.axes, place.local);
        let swept = cross(frame.spin, arm);
        Point {
            body: Some(body),
            arm,
            position: plus(frame.position, arm),
            velocity: plus(frame.velocity, swept),
            bias: cross(frame.spin, swept),
        }
    }

    fn ground(&self, place: &Place) -> Point {
        let mut point = Point { body: None, arm: ZERO, position: place.local, velocity: ZERO, bias: ZERO };
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
