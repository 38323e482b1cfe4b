//! Where everything is, in the plane or in space: what laws, loads and conditions ask, whichever it is.

use super::jet::{Jet, Moving};
use super::laws::Laws;
use super::{plane, space};
use crate::model::{BodyId, JointId, Place, Rotor, Space, Vector};
use crate::symbolic::{Node, On};

/// The places of all bodies as functions of q, and how they change with v.
#[derive(Clone, Debug)]
pub enum Kinematics {
    Plane(plane::Kinematics),
    Space(space::Kinematics),
}

impl Kinematics {
    pub fn space(&self) -> Space {
        match self {
            Kinematics::Plane(_) => Space::Planar,
            Kinematics::Space(_) => Space::Spatial,
        }
    }

    /// v.
    pub fn velocities(&self) -> &[Node] {
        match self {
            Kinematics::Plane(plane) => &plane.velocities,
            Kinematics::Space(space) => &space.velocities,
        }
    }
}

impl<'g> On<'g, &'g Kinematics> {
    /// World coordinates of a place.
    pub fn world(self, laws: &Laws<'g>, place: &Place) -> Vec<Moving<'g>> {
        match self.bare {
            Kinematics::Plane(plane) => self.g.on(plane).place_in_world(laws, place).to_vec(),
            Kinematics::Space(space) => self.g.on(space).place_in_world(laws, place).to_vec(),
        }
    }

    /// The way from one place to another, in axes in which it is cheap: those of the world in the plane.
    pub fn between(self, laws: &Laws<'g>, first: &Place, second: &Place) -> Vec<Moving<'g>> {
        match self.bare {
            Kinematics::Plane(plane) => self.g.on(plane).difference_in_world(laws, first, second).to_vec(),
            Kinematics::Space(space) => self.g.on(space).between(laws, first, second).to_vec(),
        }
    }

    /// u·Δ from one place to another, u in the axes of the first.
    pub fn way(self, laws: &Laws<'g>, first: &Place, u: &Vector, second: &Place) -> Moving<'g> {
        match self.bare {
            Kinematics::Plane(plane) => self.g.on(plane).way(laws, first, u, second),
            Kinematics::Space(space) => self.g.on(space).way(laws, first, u, second),
        }
    }

    /// A direction in the axes of a place, along those of the world.
    pub fn direction(self, laws: &Laws<'g>, place: &Place, u: &Vector) -> Vec<Moving<'g>> {
        match self.bare {
            Kinematics::Plane(plane) => self.g.on(plane).direction_in_world(laws, place, u).to_vec(),
            Kinematics::Space(space) => self.g.on(space).direction_in_world(laws, place, u).to_vec(),
        }
    }

    /// (cos, sin) of a rotor's angle.
    pub fn rotor_pair(self, laws: &Laws<'g>, rotor: Rotor) -> On<'g, [Node; 2]> {
        match self.bare {
            Kinematics::Plane(plane) => self.g.on(plane).rotor_pair(laws, rotor),
            Kinematics::Space(space) => self.g.on(space).rotor_pair(laws, rotor),
        }
    }

    /// A rotor's angle without its value, which has several representations.
    pub fn rotor_rate(self, laws: &Laws<'g>, rotor: Rotor) -> Moving<'g> {
        match self.bare {
            Kinematics::Plane(plane) => self.g.on(plane).rotor_rate(laws, rotor),
            Kinematics::Space(space) => self.g.on(space).rotor_rate(laws, rotor),
        }
    }

    /// Travel of a joint; which of its travels.
    pub fn travel(self, laws: &Laws<'g>, joint: JointId, which: usize) -> Moving<'g> {
        match self.bare {
            Kinematics::Plane(plane) => self.g.on(plane).travel(laws, joint, which),
            Kinematics::Space(space) => self.g.on(space).travel(laws, joint, which),
        }
    }

    /// How far the second place of a joint in space is from the first along an axis of the joint on that.
    pub fn shift(self, laws: &Laws<'g>, joint: JointId, axis: usize) -> Moving<'g> {
        match self.bare {
            Kinematics::Plane(_) => laws.still(self.g.zero()),
            Kinematics::Space(space) => self.g.on(space).shift(laws, joint, axis),
        }
    }

    /// The coordinate of a mode of a beam.
    pub fn mode(self, body: usize, mode: usize) -> Option<Moving<'g>> {
        match self.bare {
            Kinematics::Plane(plane) => self.g.on(plane).mode(body, mode),
            Kinematics::Space(space) => self.g.on(space).mode(body, mode),
        }
    }

    /// A quantity whose rate is ω of a body in space about one of its axes; it has no value of its own.
    pub fn omega(self, body: BodyId, axis: usize) -> Moving<'g> {
        match self.bare {
            Kinematics::Plane(plane) => self.moving(&plane.velocities, Jet::constant(self.g.zero())),
            Kinematics::Space(space) => self.g.on(space).omega(body, axis),
        }
    }

    /// How a body in space is turned away from an orientation given as a quaternion, along the axes of the world.
    pub fn deviation(self, body: BodyId, quaternion: On<'g, [Node; 4]>) -> Vec<Moving<'g>> {
        match self.bare {
            Kinematics::Plane(_) => Vec::new(),
            Kinematics::Space(space) => self.g.on(space).deviation(body, quaternion).to_vec(),
        }
    }

    /// Quantities whose rates are ω of a body in space about the axes of the world: what a torque acts along.
    pub fn turning(self, body: BodyId) -> Vec<Moving<'g>> {
        match self.bare {
            Kinematics::Plane(_) => Vec::new(),
            Kinematics::Space(space) => self.g.on(space).turning_in_world(body).to_vec(),
        }
    }

    /// The same of what a place on a body belongs to: of a beam, of the section there. In the plane there is one.
    pub fn turning_at(self, laws: &Laws<'g>, place: &Place) -> Vec<Moving<'g>> {
        match self.bare {
            Kinematics::Plane(plane) => self.g.on(plane).turning_at(laws, place).into_iter().collect(),
            Kinematics::Space(space) => {
                let space = self.g.on(space);
                space.link_turning_in_world(space.spot(laws, place).link).to_vec()
            }
        }
    }
}
