//! Where everything is in space, and the quantities of joints.
//!
//! With E₁, E₂ the axes of a joint's places, turned so that z lies along the joint's axis, and Δ from the first place to
//! the second: the angle is that from x₁ to x₂ about z₁, a travel is a component of Δ along E₁. Where a joint carries a
//! body these are coordinates; elsewhere they follow from the links. The rate of an angle is z₂·ω₂ − z₁·ω₁, each in its
//! body's axes, so that in absolute coordinates it is a sum of velocities with constant weights.

use super::axes;
use super::coordinates::rotation_matrix;
use super::joints::{self, Elementary};
use super::links::{GROUND, Link, LinkId, Placement};
use super::vector::{self, Mat3, Vec3};
use super::vector_jet::{Kind, VectorJet};
use crate::equations::{Jet, Laws};
use crate::model::{BodyId, Frame, Joint, JointId, Place, Rotor, Vector};
use crate::symbolic::{Graph, Node, Unary};
use std::collections::BTreeMap;

/// Everything that moves, in one set of velocities.
#[derive(Clone, Debug)]
pub struct Kinematics {
    /// Parents before children; the first is the ground.
    pub links: Vec<Link>,
    /// v.
    pub velocities: Vec<Node>,
    /// One per body.
    pub bodies: Vec<Placement>,
    /// Angles that are coordinates: (cos, sin) and the index of the rate.
    pub angles: BTreeMap<(JointId, usize), ([Node; 2], usize)>,
    /// Travels that are coordinates: value, and index and factor of the rate.
    pub travels: BTreeMap<(JointId, usize), (Node, usize, Node)>,
    /// Axes of the carrying and of the carried place of each ball, in their bodies.
    pub balls: BTreeMap<JointId, [Mat3; 2]>,
}

/// A place on its link.
pub struct Spot {
    pub link: LinkId,
    pub at: VectorJet,
    /// Link ← axes of the place.
    pub axes: Mat3,
}

impl Kinematics {
    /// The link and the constant placement of what a place belongs to.
    fn placement(&self, g: &mut Graph, frame: Frame) -> Placement {
        match frame {
            Frame::Ground => Placement { link: GROUND, at: vector::zero(g), axes: vector::identity(g) },
            Frame::Body(body) => self.bodies[body.0].clone(),
        }
    }

    pub fn spot(&self, g: &mut Graph, laws: &Laws, place: &Place) -> Spot {
        let placement = self.placement(g, place.frame);
        let axes = axes::matrix(g, laws, &place.axes);
        let axes = vector::product(g, &placement.axes, &axes);
        let at = match place.frame {
            Frame::Ground => {
                let at = laws.ground(g, &place.at);
                VectorJet::of_time(&at)
            }
            Frame::Body(_) => {
                let at = laws.vector(g, &place.at);
                let at = vector::apply(g, &placement.axes, at);
                let at = vector::add(g, placement.at, at);
                VectorJet::fixed(g, at)
            }
        };
        Spot { link: placement.link, at, axes }
    }

    /// World coordinates of a place.
    pub fn place_in_world(&self, g: &mut Graph, laws: &Laws, place: &Place) -> [Jet; 3] {
        let spot = self.spot(g, laws, place);
        let seen = self.carry(g, spot.at, spot.link, GROUND, Kind::Point);
        seen.components(g)
    }

    /// From one place to another, as seen from where their ways to the ground meet.
    pub fn between(&self, g: &mut Graph, laws: &Laws, first: &Place, second: &Place) -> [Jet; 3] {
        let (first, second) = (self.spot(g, laws, first), self.spot(g, laws, second));
        let meeting = self.meeting(first.link, second.link);
        let a = self.carry(g, first.at, first.link, meeting, Kind::Point);
        let b = self.carry(g, second.at, second.link, meeting, Kind::Point);
        let delta = b.sub(g, &a);
        delta.components(g)
    }

    /// From the first place to the second, as seen from the link of the first.
    pub fn delta(&self, g: &mut Graph, first: &Spot, second: &Spot) -> VectorJet {
        let seen = self.carry(g, second.at.clone(), second.link, first.link, Kind::Point);
        seen.sub(g, &first.at)
    }

    /// A direction of the second place, given in the axes of its link, as seen from the link of the first.
    pub fn direction(&self, g: &mut Graph, first: &Spot, second: &Spot, u: Vec3) -> VectorJet {
        let fixed = VectorJet::fixed(g, u);
        self.carry(g, fixed, second.link, first.link, Kind::Direction)
    }

    /// ω of a link in its own axes: columns and bias (α at v̇ = 0).
    pub fn link_omega(&self, g: &mut Graph, link: LinkId) -> VectorJet {
        let zero = vector::zero(g);
        let mut jet = VectorJet::fixed(g, zero);
        for at in self.ancestors(link).into_iter().rev().skip(1) {
            let link = &self.links[at];
            let relative = link.omega(g, &self.velocities);
            let back = |g: &mut Graph, x: Vec3| link.down(g, x);
            let columns = jet.columns.iter().map(|(k, column)| (*k, back(g, *column))).collect();
            let (rate, bias) = (back(g, jet.rate), back(g, jet.bias));
            // α = Rᵀ α_parent + (Rᵀ ω_parent) × ω_relative
            let gyration = vector::cross(g, rate, relative);
            jet = VectorJet {
                value: zero,
                columns,
                rate: vector::add(g, rate, relative),
                drift: zero,
                bias: vector::add(g, bias, gyration),
            };
            for (velocity, axis) in link.turning(g) {
                let own = jet.columns.get(&velocity).copied().unwrap_or(zero);
                jet.columns.insert(velocity, vector::add(g, own, axis));
            }
        }
        jet
    }

    /// ω of a body about one of its own axes.
    pub fn omega(&self, g: &mut Graph, body: BodyId, axis: usize) -> Jet {
        let placement = &self.bodies[body.0];
        let omega = self.link_omega(g, placement.link);
        let axis = vector::column(&placement.axes, axis);
        omega.project(g, axis)
    }

    /// ω of a body about the axes of the world.
    pub fn turning_in_world(&self, g: &mut Graph, body: BodyId) -> [Jet; 3] {
        let link = self.bodies[body.0].link;
        let omega = self.link_omega(g, link);
        let world = self.world_axes(g, link);
        [0, 1, 2].map(|axis| omega.project(g, world[axis]))
    }

    /// Σ ½ A₀ e_j × A e_j with A₀ of a quaternion of any length.
    pub fn deviation(&self, g: &mut Graph, body: BodyId, quaternion: [Node; 4]) -> [Jet; 3] {
        let squares: Vec<Node> = quaternion.iter().map(|part| g.mul(*part, *part)).collect();
        let square = g.sum(squares);
        let length = g.unary(Unary::Sqrt, square);
        let quaternion = quaternion.map(|part| g.div(part, length));
        let wanted = rotation_matrix(g, quaternion);
        let placement = &self.bodies[body.0];
        let axes: Vec<VectorJet> = (0..3)
            .map(|j| {
                let axis = VectorJet::fixed(g, vector::column(&placement.axes, j));
                self.carry(g, axis, placement.link, GROUND, Kind::Direction)
            })
            .collect();
        let half = g.constant(0.5);
        [0, 1, 2].map(|k| {
            let along = vector::unit(g, k);
            let zero = g.constant(0.0);
            let mut sum = Jet::constant(g, zero);
            for (j, axis) in axes.iter().enumerate() {
                // e_k·(a₀ × a) = (e_k × a₀)·a
                let lever = vector::cross(g, along, vector::column(&wanted, j));
                let lever = vector::scale(g, half, lever);
                let part = axis.project(g, lever);
                sum = sum.add(g, &part);
            }
            sum
        })
    }

    /// World ← link.
    pub fn world_axes(&self, g: &mut Graph, link: LinkId) -> Mat3 {
        let mut matrix = vector::identity(g);
        for at in self.ancestors(link).into_iter().rev().skip(1) {
            let link = &self.links[at];
            // Rows of the product are those of the matrix, turned back.
            matrix = matrix.map(|row| link.down(g, row));
        }
        matrix
    }

    fn joint_spots(&self, g: &mut Graph, laws: &Laws, joint: &Joint) -> [Spot; 2] {
        [self.spot(g, laws, &joint.first), self.spot(g, laws, &joint.second)]
    }

    /// (cos, sin) of the angle of a joint.
    pub fn rotor_pair(&self, g: &mut Graph, laws: &Laws, rotor: Rotor) -> [Node; 2] {
        let one = [g.constant(1.0), g.constant(0.0)];
        let Rotor::Joint(id, which) = rotor else { return one };
        if let Some((pair, _)) = self.angles.get(&(id, which)) {
            return *pair;
        }
        let joint = &laws.mechanism.joints[id.0];
        let [first, second] = self.joint_spots(g, laws, joint);
        if let [axis, second_axis] = &joint.directions[..] {
            // The second's axis, seen from the first, has turned about the first's by the first angle; the other way round
            // for the second angle.
            let (own, other, about, towards) = if which == 0 {
                (first, second, axis, second_axis)
            } else {
                (second, first, second_axis, axis)
            };
            let (about, towards) = (laws.vector(g, about), laws.vector(g, towards));
            let (about, towards) = (axes::normalized(g, about), axes::normalized(g, towards));
            let far = vector::apply(g, &other.axes, towards);
            let seen = self.direction(g, &own, &other, far);
            let across = vector::cross(g, about, towards);
            let (near, across) = (vector::apply(g, &own.axes, towards), vector::apply(g, &own.axes, across));
            let (cos, sin) = (vector::dot(g, near, seen.value), vector::dot(g, across, seen.value));
            return [cos, if which == 0 { sin } else { g.neg(sin) }];
        }
        let Some(axis) = joint.common_axis() else { return one };
        let frame = axes::joint_frame(g, laws, axis);
        let (e1, e2) = (vector::product(g, &first.axes, &frame), vector::product(g, &second.axes, &frame));
        let seen = self.direction(g, &first, &second, vector::column(&e2, 0));
        [
            vector::dot(g, vector::column(&e1, 0), seen.value),
            vector::dot(g, vector::column(&e1, 1), seen.value),
        ]
    }

    /// The angle of a joint without its value.
    pub fn rotor_rate(&self, g: &mut Graph, laws: &Laws, rotor: Rotor) -> Jet {
        let (zero, one) = (g.constant(0.0), g.constant(1.0));
        let Rotor::Joint(id, which) = rotor else { return Jet::constant(g, zero) };
        if let Some((_, rate)) = self.angles.get(&(id, which)) {
            let mut jet = Jet::constant(g, zero);
            jet.columns.insert(*rate, one);
            return jet;
        }
        let joint = &laws.mechanism.joints[id.0];
        let [first, second] = self.joint_spots(g, laws, joint);
        let (first_omega, second_omega) = (self.link_omega(g, first.link), self.link_omega(g, second.link));
        if let [axis, second_axis] = &joint.directions[..] {
            // a₁·(ω₂ − ω₁), or b₂·(ω₂ − ω₁): as a product of what moves.
            let (own, own_omega, other, other_omega, axis) = if which == 0 {
                (&first, &first_omega, &second, &second_omega, axis)
            } else {
                (&second, &second_omega, &first, &first_omega, second_axis)
            };
            let axis = laws.vector(g, axis);
            let axis = axes::normalized(g, axis);
            let axis = vector::apply(g, &own.axes, axis);
            let fixed = VectorJet::fixed(g, axis);
            let seen = self.carry(g, fixed, own.link, other.link, Kind::Direction);
            let theirs = moving_projection(g, &seen, other_omega);
            let ours = own_omega.project(g, axis);
            let rate = theirs.sub(g, &ours);
            return if which == 0 { rate } else { rate.neg(g) };
        }
        let Some(axis) = joint.common_axis() else { return Jet::constant(g, zero) };
        let z = joint_axis(g, laws, axis);
        let (z1, z2) = (vector::apply(g, &first.axes, z), vector::apply(g, &second.axes, z));
        let (own, other) = (second_omega.project(g, z2), first_omega.project(g, z1));
        own.sub(g, &other)
    }

    /// Travel of a joint.
    pub fn travel(&self, g: &mut Graph, laws: &Laws, id: JointId, which: usize) -> Jet {
        if let Some((travel, rate, factor)) = self.travels.get(&(id, which)) {
            let mut jet = Jet::constant(g, *travel);
            jet.columns.insert(*rate, *factor);
            return jet;
        }
        let joint = &laws.mechanism.joints[id.0];
        let slides = joints::motions(joint).iter().find_map(|motion| match motion {
            Elementary::Slide { axis, which: own } => (*own == which).then_some(*axis),
            Elementary::Wind => Some(2),
            Elementary::Turn { .. } | Elementary::Ball => None,
        });
        let Some(along) = slides else {
            let zero = g.constant(0.0);
            return Jet::constant(g, zero);
        };
        let [first, second] = self.joint_spots(g, laws, joint);
        let frame = joints::frames(g, laws, joint)[0];
        let frame = vector::product(g, &first.axes, &frame);
        let delta = self.delta(g, &first, &second);
        delta.project(g, vector::column(&frame, along))
    }
}

fn joint_axis(g: &mut Graph, laws: &Laws, axis: &Vector) -> Vec3 {
    let axis = laws.vector(g, axis);
    axes::normalized(g, axis)
}

/// A quantity whose rate is u·ω, both moving.
fn moving_projection(g: &mut Graph, u: &VectorJet, omega: &VectorJet) -> Jet {
    let mut jet = omega.project(g, u.value);
    let extra = vector::dot(g, u.rate, omega.rate);
    jet.bias = g.add(jet.bias, extra);
    jet
}
