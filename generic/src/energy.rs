//! Energies of a mechanism: what its bodies and its springs have.

use crate::definition::Body;
use crate::kinematics::Kinematics;
use crate::load::{Acts, Load};
use crate::vector::{V3, dot, turned, turned_back};

/// What energies are of; bodies in the order of the frames.
#[derive(Clone, Debug)]
pub(crate) struct Energies {
    pub bodies: Vec<Body>,
    pub loads: Vec<Load>,
    pub gravity: V3,
}

/// Which of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Energy {
    Kinetic,
    Potential,
    Both,
}

/// T = Σ ½ m ṙ² + ½ ωᵀ J ω, J.
pub(crate) fn kinetic(bodies: &[Body], at: &Kinematics) -> f64 {
    let of = bodies.iter().zip(&at.frames).enumerate().map(|(index, (body, frame))| {
        if let Some(beam) = at.beam(index) {
            return 2.0 * beam.kinetic(frame, at.modes(index, beam));
        }
        let omega = turned_back(&frame.axes, frame.spin);
        body.mass * dot(frame.velocity, frame.velocity) + dot(omega, turned(&body.inertia, omega))
    });
    0.5 * of.sum::<f64>()
}

/// V of gravity, springs and bushings, J.
pub(crate) fn potential(bodies: &[Body], loads: &[Load], gravity: V3, at: &Kinematics) -> f64 {
    let weights =
        bodies.iter().zip(&at.frames).enumerate().map(|(index, (body, frame))| match at.beam(index) {
            Some(beam) => beam.potential(frame, at.modes(index, beam), gravity),
            None => -body.mass * dot(gravity, frame.position),
        });
    let stored = loads.iter().map(|load| match &load.acts {
        Acts::Spring { along, stiffness, rest, .. } => {
            0.5 * stiffness * (along.jet(at).along.value - rest).powi(2)
        }
        Acts::Mesh(mesh) => mesh.energy(at),
        Acts::Penalty(penalty) => penalty.energy(at),
        Acts::Bushing(ways) => ways.iter().map(|way| way.energy(at)).sum(),
        _ => 0.0,
    });
    weights.chain(stored).sum()
}

impl Energies {
    pub fn of(&self, which: Energy, at: &Kinematics) -> f64 {
        let potential = || potential(&self.bodies, &self.loads, self.gravity, at);
        match which {
            Energy::Kinetic => kinetic(&self.bodies, at),
            Energy::Potential => potential(),
            Energy::Both => kinetic(&self.bodies, at) + potential(),
        }
    }
}
