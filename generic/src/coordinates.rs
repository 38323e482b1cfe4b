//! What q and v are: absolute coordinates, body by body, and how motion, gradients and forces read in them.
//!
//! | body | q | v |
//! |---|---|---|
//! | planar | x, y of the centre of mass, θ over several turns | ẋ, ẏ, ω |
//! | planar particle | x, y | ẋ, ẏ |
//! | beam | x, y of the origin of its frame, θ, modes | ẋ, ẏ, ω, rates of modes |
//! | spatial | x, y, z, Euler parameters (w, x, y, z) | ẋ, ẏ, ż, ω in body axes |
//! | beam in space | as spatial, of the origin of its frame, then modes | as spatial, then rates of modes |
//! | spatial particle | x, y, z | ẋ, ẏ, ż |
//!
//! Behind the bodies of space q has the angles of joints over several turns, which choose whole turns and nothing else, and behind
//! these the internal states.

use crate::beam::Beam;
use crate::definition::Definition;
use crate::error::Error;
use crate::kinematics::{Frame, Kinematics};
use crate::quantity::Pull;
use crate::vector::*;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Kind {
    Plane,
    PlaneParticle,
    Space,
    SpaceParticle,
}

/// A beam and the coordinates and rates of its modes.
pub(crate) type Bent<'a> = (&'a Beam, &'a [[f64; 2]]);

/// Where a body's coordinates begin.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slot {
    pub q: usize,
    pub v: usize,
    pub kind: Kind,
    /// Modes of a beam, behind its pose.
    pub modes: usize,
}

impl Slot {
    /// Velocities of the body.
    pub fn width(&self) -> usize {
        self.pose() + self.modes
    }

    /// Those of its pose.
    fn pose(&self) -> usize {
        match self.kind {
            Kind::Plane | Kind::SpaceParticle => 3,
            Kind::PlaneParticle => 2,
            Kind::Space => 6,
        }
    }

    /// Entries in q that move as their velocities do.
    fn linear(&self) -> usize {
        if self.kind == Kind::Space { 3 } else { self.width() }
    }

    fn positions(&self) -> usize {
        if self.kind == Kind::Space { 7 + self.modes } else { self.width() }
    }

    /// Where the modes of a beam begin in q and in v.
    pub fn modal(&self) -> [usize; 2] {
        let pose = self.pose();
        [self.q + if self.kind == Kind::Space { pose + 1 } else { pose }, self.v + pose]
    }

    /// Adds a gradient, or a force and torque, to the entries of the body's velocities; of a beam with its modes.
    pub fn add(&self, frame: &Frame, bent: Option<Bent>, pull: &Pull, entries: &mut [f64]) {
        let first = self.pose();
        if let Some((mode, along)) = pull.mode {
            entries[first + mode] += along;
        }
        if let (Some((beam, modal)), Some(x)) = (bent, pull.on_axis) {
            let along = turned_back(&frame.axes, pull.linear);
            let about = turned_back(&frame.axes, pull.section);
            let (_, drawn) = beam.drawn_in(&beam.gammas(x), modal);
            let turning = (self.kind == Kind::Space).then(|| beam.turning(x, modal));
            for (mode, drawn) in drawn.into_iter().enumerate().take(self.modes) {
                let moved = beam.value(mode, x) * along[beam.axis(mode)] + drawn * along[0];
                let turned = match &turning {
                    Some(turning) => dot(turning.columns[mode], about),
                    None => beam.slope(mode, x) * about[2],
                };
                entries[first + mode] += moved + turned;
            }
        }
        let [x, y, z] = pull.linear;
        entries[0] += x;
        entries[1] += y;
        match self.kind {
            Kind::Plane => entries[2] += pull.angular[2],
            Kind::PlaneParticle => {}
            Kind::SpaceParticle => entries[2] += z,
            Kind::Space => {
                entries[2] += z;
                let own = turned_back(&frame.axes, pull.angular);
                entries[3..6].iter_mut().zip(own).for_each(|(entry, part)| *entry += part);
            }
        }
    }
}

#[derive(Clone, Debug)]
pub(crate) struct Coordinates {
    pub slots: Vec<Slot>,
    /// n_q, counted angles and internal states included.
    pub positions: usize,
    /// n_v.
    pub velocities: usize,
    /// Where the counted angles begin in q.
    pub counted: usize,
    /// Where the internal states begin in q.
    pub internal: usize,
}

impl Coordinates {
    pub fn new(definition: &Definition) -> Self {
        let mut coordinates =
            Coordinates { slots: Vec::new(), positions: 0, velocities: 0, counted: 0, internal: 0 };
        for body in &definition.bodies {
            let kind = match (definition.spatial, body.particle) {
                (false, false) => Kind::Plane,
                (false, true) => Kind::PlaneParticle,
                (true, false) => Kind::Space,
                (true, true) => Kind::SpaceParticle,
            };
            let modes = body.beam.as_ref().map_or(0, |beam| beam.count());
            let slot = Slot { q: coordinates.positions, v: coordinates.velocities, kind, modes };
            coordinates.positions += slot.positions();
            coordinates.velocities += slot.width();
            coordinates.slots.push(slot);
        }
        coordinates.counted = coordinates.positions;
        coordinates.internal = coordinates.counted + definition.counted.len();
        coordinates.positions = coordinates.internal + definition.states.len();
        coordinates
    }

    /// All bodies at the origin with their axes the world's, internal states at their starts.
    pub fn origin(&self, definition: &Definition) -> Vec<f64> {
        let mut q = vec![0.0; self.internal];
        q.extend(definition.states.iter().map(|state| state.start));
        for slot in self.slots.iter().filter(|slot| slot.kind == Kind::Space) {
            q[slot.q + 3] = 1.0;
        }
        q
    }

    /// The motion of all bodies at a state; Euler parameters count at length one.
    pub fn kinematics(&self, time: f64, q: &[f64], v: &[f64], at: &mut Kinematics) -> Result<(), Error> {
        let given = [("positions", q, self.positions), ("velocities", v, self.velocities)];
        for (what, values, expected) in given {
            if values.len() != expected {
                return Err(Error::Length { what, expected, given: values.len() });
            }
        }
        check_finite("the time", &[time])?;
        check_finite("a position", q)?;
        check_finite("a velocity", v)?;
        at.time = time;
        at.frames.clear();
        at.modal.clear();
        for slot in &self.slots {
            let frame = slot.frame(&q[slot.q..], &v[slot.v..])?;
            at.frames.push(Frame { modes: at.modal.len(), ..frame });
            let [first_q, first_v] = slot.modal();
            at.modal.extend((0..slot.modes).map(|mode| [q[first_q + mode], v[first_v + mode]]));
        }
        at.counted.clear();
        at.counted.extend_from_slice(&q[self.counted..self.internal]);
        at.internal.clear();
        at.internal.extend_from_slice(&q[self.internal..]);
        Ok(())
    }

    /// q̇ = N(q) v: of Euler parameters ½ p ⊗ (0, ω); counted angles stay, internal states are left to others.
    pub fn rates(&self, q: &[f64], v: &[f64], rates: &mut [f64]) {
        rates.fill(0.0);
        for slot in &self.slots {
            let (linear, positions) = (slot.linear(), &q[slot.q..]);
            rates[slot.q..slot.q + linear].copy_from_slice(&v[slot.v..slot.v + linear]);
            if slot.kind == Kind::Space {
                let omega = [0.0, v[slot.v + 3], v[slot.v + 4], v[slot.v + 5]];
                let rate = quaternion_product(parameters(positions), omega);
                rates[slot.q + 3..slot.q + 7].iter_mut().zip(rate).for_each(|(to, x)| *to = 0.5 * x);
                let [to, from] = slot.modal();
                rates[to..to + slot.modes].copy_from_slice(&v[from..from + slot.modes]);
            }
        }
    }

    /// q ⊕ δ: positions moved by an increment of the velocities' kind.
    pub fn retract(&self, q: &mut [f64], delta: &[f64]) {
        for slot in &self.slots {
            let linear = slot.linear();
            for k in 0..linear {
                q[slot.q + k] += delta[slot.v + k];
            }
            if slot.kind == Kind::Space {
                let turn = [3, 4, 5].map(|k| delta[slot.v + k]);
                let p = quaternion_product(parameters(&q[slot.q..]), quaternion_of_turn(turn));
                q[slot.q + 3..slot.q + 7].copy_from_slice(&p);
                let [to, from] = slot.modal();
                (0..slot.modes).for_each(|mode| q[to + mode] += delta[from + mode]);
            }
        }
        self.normalise(q);
    }

    /// Brings Euler parameters to length one.
    pub fn normalise(&self, q: &mut [f64]) {
        for slot in self.slots.iter().filter(|slot| slot.kind == Kind::Space) {
            if let Some(p) = unit_quaternion(parameters(&q[slot.q..])) {
                q[slot.q + 3..slot.q + 7].copy_from_slice(&p);
            }
        }
    }
}

fn parameters(positions: &[f64]) -> [f64; 4] {
    [positions[3], positions[4], positions[5], positions[6]]
}

pub(crate) fn check_finite(what: &'static str, values: &[f64]) -> Result<(), Error> {
    match values.iter().find(|value| !value.is_finite()) {
        Some(value) => Err(Error::Value { what, value: *value }),
        None => Ok(()),
    }
}

impl Slot {
    fn frame(&self, q: &[f64], v: &[f64]) -> Result<Frame, Error> {
        let mut frame = Frame {
            position: [q[0], q[1], 0.0],
            axes: IDENTITY,
            velocity: [v[0], v[1], 0.0],
            spin: ZERO,
            angle: 0.0,
            modes: 0,
        };
        match self.kind {
            Kind::PlaneParticle => {}
            Kind::Plane => {
                let (s, c) = q[2].sin_cos();
                frame.angle = q[2];
                frame.axes = [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]];
                frame.spin = [0.0, 0.0, v[2]];
            }
            Kind::Space | Kind::SpaceParticle => {
                frame.position[2] = q[2];
                frame.velocity[2] = v[2];
            }
        }
        if self.kind == Kind::Space {
            let p = unit_quaternion(parameters(q));
            let p = p.ok_or(Error::Value { what: "the length of Euler parameters", value: 0.0 })?;
            frame.axes = rotation(p);
            frame.spin = turned(&frame.axes, [v[3], v[4], v[5]]);
        }
        Ok(frame)
    }
}
