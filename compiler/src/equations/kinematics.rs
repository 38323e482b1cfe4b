//! Where everything is, in the plane or in space: what laws, loads and conditions ask, whichever it is.

use super::jet::Jet;
use super::laws::Laws;
use super::{plane, space};
use crate::model::{BodyId, JointId, Place, Rotor};
use crate::symbolic::{Graph, Node};

/// The places of all bodies as functions of q, and how they change with v.
#[derive(Clone, Debug)]
pub enum Kinematics {
    Plane(plane::Kinematics),
    Space(space::Kinematics),
}

impl Kinematics {
    /// v.
    pub fn velocities(&self) -> &[Node] {
        match self {
            Kinematics::Plane(plane) => &plane.velocities,
            Kinematics::Space(space) => &space.velocities,
        }
    }

    /// World coordinates of a place.
    pub fn world(&self, g: &mut Graph, laws: &Laws, place: &Place) -> Vec<Jet> {
        match self {
            Kinematics::Plane(plane) => plane.place_in_world(g, laws, place).to_vec(),
            Kinematics::Space(space) => space.place_in_world(g, laws, place).to_vec(),
        }
    }

    /// The way from one place to another, in axes in which it is cheap: those of the world in the plane.
    pub fn between(&self, g: &mut Graph, laws: &Laws, first: &Place, second: &Place) -> Vec<Jet> {
        match self {
            Kinematics::Plane(plane) => plane.difference_in_world(g, laws, first, second).to_vec(),
            Kinematics::Space(space) => space.between(g, laws, first, second).to_vec(),
        }
    }

    /// (cos, sin) of a rotor's angle.
    pub fn rotor_pair(&self, g: &mut Graph, laws: &Laws, rotor: Rotor) -> [Node; 2] {
        match self {
            Kinematics::Plane(plane) => plane.rotor_pair(g, laws, rotor),
            Kinematics::Space(space) => space.rotor_pair(g, laws, rotor),
        }
    }

    /// A rotor's angle without its value, which has several representations.
    pub fn rotor_rate(&self, g: &mut Graph, laws: &Laws, rotor: Rotor) -> Jet {
        match self {
            Kinematics::Plane(plane) => plane.rotor_rate(g, laws, rotor),
            Kinematics::Space(space) => space.rotor_rate(g, laws, rotor),
        }
    }

    /// Travel of a joint; which of its travels.
    pub fn travel(&self, g: &mut Graph, laws: &Laws, joint: JointId, which: usize) -> Jet {
        match self {
            Kinematics::Plane(plane) => plane.travel(g, laws, joint),
            Kinematics::Space(space) => space.travel(g, laws, joint, which),
        }
    }

    /// A quantity whose rate is ω of a body in space about one of its axes; it has no value of its own.
    pub fn omega(&self, g: &mut Graph, body: BodyId, axis: usize) -> Jet {
        match self {
            Kinematics::Plane(_) => {
                let zero = g.constant(0.0);
                Jet::constant(g, zero)
            }
            Kinematics::Space(space) => space.omega(g, body, axis),
        }
    }

    /// How a body in space is turned away from an orientation given as a quaternion, along the axes of the world.
    pub fn deviation(&self, g: &mut Graph, body: BodyId, quaternion: [Node; 4]) -> Vec<Jet> {
        match self {
            Kinematics::Plane(_) => Vec::new(),
            Kinematics::Space(space) => space.deviation(g, body, quaternion).to_vec(),
        }
    }

    /// Quantities whose rates are ω of a body in space about the axes of the world: what a torque acts along.
    pub fn turning(&self, g: &mut Graph, body: BodyId) -> Vec<Jet> {
        match self {
            Kinematics::Plane(_) => Vec::new(),
            Kinematics::Space(space) => space.turning_in_world(g, body).to_vec(),
        }
    }
}
