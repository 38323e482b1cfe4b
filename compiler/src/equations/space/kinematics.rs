//! Where everything is in space, and the quantities of joints.
//!
//! With E₁, E₂ the axes of a joint's places, turned so that z lies along the joint's axis, and Δ from the first place to
//! the second: the angle is that from x₁ to x₂ about z₁, a travel is a component of Δ along E₁. Where a joint carries a
//! body these are coordinates; elsewhere they follow from the links. The rate of an angle is z₂·ω₂ − z₁·ω₁, each in its
//! body's axes, so that in absolute coordinates it is a sum of velocities with constant weights.

use super::axes;
use super::coordinates::rotation_matrix;
use super::flexible::Flexible;
use super::joints::{self, Elementary};
use super::links::{GROUND, Link, LinkId, Placement};
use super::shapes::{Slice, Station};
use super::vector::{self, Mat3, Vec3};
use super::vector_jet::{Kind, VectorJet};
use crate::equations::Laws;
use crate::equations::jet::{Jet, Moving};
use crate::model::{BodyId, Frame, Joint, JointId, Place, Rotor, Vector};
use crate::symbolic::{Node, On};
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
    /// Sections of beams and nodes, by body and place: links whose origin and axes are those of what is there.
    pub sections: BTreeMap<(usize, Station), LinkId>,
}

/// A place on its link.
#[derive(Clone)]
pub struct Spot<'g> {
    pub link: LinkId,
    pub at: VectorJet,
    /// Link ← axes of the place.
    pub axes: On<'g, Mat3>,
}

impl<'g> On<'g, &'g Kinematics> {
    pub fn spot(self, laws: &Laws<'g>, place: &Place) -> Spot<'g> {
        let g = self.g;
        if let Some(link) = self.section(laws, place) {
            return Spot {
                link,
                at: VectorJet::fixed(vector::zero(g)),
                axes: axes::matrix(laws, &place.axes),
            };
        }
        // The link and the constant placement of what the place belongs to.
        let placement = match place.frame {
            Frame::Ground => Placement::of_ground(g),
            Frame::Body(body) => self.bare.bodies[body.0].clone(),
        };
        let axes = g.on(placement.axes) * axes::matrix(laws, &place.axes);
        let at = match place.frame {
            Frame::Ground => VectorJet::of_time(&laws.ground(&place.at)),
            Frame::Body(_) if place.of_mean => {
                VectorJet::fixed(g.on(&placement).point(laws.vector(&place.at)))
            }
            Frame::Body(_) => self.point(&placement, laws.vector(&place.at)),
        };
        Spot { link: placement.link, at, axes }
    }

    /// The link of a section or node, if the place is one that has been made.
    pub fn section(self, laws: &Laws<'g>, place: &Place) -> Option<LinkId> {
        let Frame::Body(body) = place.frame else { return None };
        // The origin of a frame in the mean is no section.
        if place.of_mean {
            return None;
        }
        let shapes = &self.bare.bodies.get(body.0)?.flexible.as_ref()?.shapes;
        let at = laws.vector(&place.at);
        let station = shapes.station([0, 1, 2].map(|k| at.at(k).value()))?;
        self.bare.sections.get(&(body.0, station)).copied()
    }

    /// A point of a body, on its link, where it moves with what bends.
    fn point(self, placement: &Placement, at: On<'g, Vec3>) -> VectorJet {
        let fixed = VectorJet::fixed(self.g.on(placement).point(at));
        let station = |flexible: &Flexible| flexible.shapes.station([0, 1, 2].map(|k| at.at(k).value()));
        match placement.flexible.as_ref().and_then(|it| Some((it, station(it)?))) {
            Some((flexible, at)) => flexible.moved(self, placement, &flexible.shapes.rows(at), fixed),
            None => fixed,
        }
    }

    /// A part of the mass of a body in world axes.
    pub fn slice_in_world(self, placement: &Placement, slice: &Slice) -> Moving<'g, VectorJet> {
        let at = vector::vector(|k| self.g.number(slice.at[k]));
        let fixed = VectorJet::fixed(self.g.on(placement).point(at));
        let moved = match &placement.flexible {
            Some(flexible) => flexible.moved(self, placement, &slice.rows, fixed),
            None => fixed,
        };
        self.carry(moved, placement.link, GROUND, Kind::Point)
    }

    fn direction_of(self, link: LinkId, u: On<'g, Vec3>, seen_from: LinkId) -> Moving<'g, VectorJet> {
        self.carry(VectorJet::fixed(u), link, seen_from, Kind::Direction)
    }

    /// World coordinates of a place.
    pub fn place_in_world(self, laws: &Laws<'g>, place: &Place) -> [Moving<'g>; 3] {
        let spot = self.spot(laws, place);
        self.carry(spot.at, spot.link, GROUND, Kind::Point).components()
    }

    /// From one place to another, as seen from where their ways to the ground meet.
    pub fn between(self, laws: &Laws<'g>, first: &Place, second: &Place) -> [Moving<'g>; 3] {
        let (first, second) = (self.spot(laws, first), self.spot(laws, second));
        let meeting = self.bare.meeting(first.link, second.link);
        let a = self.carry(first.at, first.link, meeting, Kind::Point);
        let b = self.carry(second.at, second.link, meeting, Kind::Point);
        (b - a).components()
    }

    /// From the first place to the second, as seen from the link of the first.
    pub fn delta(self, first: &Spot<'g>, second: &Spot<'g>) -> Moving<'g, VectorJet> {
        let seen = self.carry(second.at.clone(), second.link, first.link, Kind::Point);
        seen - self.moving(&self.bare.velocities, first.at.clone())
    }

    /// u·Δ, u in the axes of the first place.
    pub fn way(self, laws: &Laws<'g>, first: &Place, u: &Vector, second: &Place) -> Moving<'g> {
        let (first, second) = (self.spot(laws, first), self.spot(laws, second));
        let u = first.axes * laws.vector(u);
        self.delta(&first, &second).project(u)
    }

    /// A direction in the axes of a place.
    pub fn direction_in_world(self, laws: &Laws<'g>, place: &Place, u: &Vector) -> [Moving<'g>; 3] {
        let spot = self.spot(laws, place);
        self.direction_of(spot.link, spot.axes * laws.vector(u), GROUND).components()
    }

    /// A direction of the second place, given in the axes of its link, as seen from the link of the first.
    pub fn direction(self, first: &Spot<'g>, second: &Spot<'g>, u: On<'g, Vec3>) -> Moving<'g, VectorJet> {
        self.direction_of(second.link, u, first.link)
    }

    /// ω of a link in its own axes: columns and bias (α at v̇ = 0).
    pub fn link_omega(self, link: LinkId) -> Moving<'g, VectorJet> {
        let g = self.g;
        let zero = vector::zero(g);
        let mut omega = self.moving(&self.bare.velocities, VectorJet::fixed(zero));
        for at in self.bare.ancestors(link).into_iter().rev().skip(1) {
            let link = g.on(&self.bare.links[at]);
            let relative = link.omega(&self.bare.velocities);
            let columns =
                omega.jet.columns.iter().map(|(k, column)| (*k, link.down(g.on(*column)).bare)).collect();
            let (rate, bias) = (link.down(omega.rate()), link.down(omega.bias()));
            // α = Rᵀ α_parent + (Rᵀ ω_parent) × ω_relative
            let gyration = rate.cross(relative) + link.turning_bias();
            omega.jet = VectorJet {
                columns,
                rate: (rate + relative).bare,
                bias: (bias + gyration).bare,
                ..VectorJet::fixed(zero)
            };
            for (velocity, axis) in link.turning() {
                let column = omega.column(velocity) + axis;
                omega.jet.columns.insert(velocity, column.bare);
            }
        }
        omega
    }

    /// ω of a body about one of its own axes.
    pub fn omega(self, body: BodyId, axis: usize) -> Moving<'g> {
        let placement = &self.bare.bodies[body.0];
        self.link_omega(placement.link).project(vector::column(&placement.axes, axis))
    }

    /// ω of a body about the axes of the world.
    pub fn turning_in_world(self, body: BodyId) -> [Moving<'g>; 3] {
        self.link_turning_in_world(self.bare.bodies[body.0].link)
    }

    /// ω of a link about the axes of the world.
    pub fn link_turning_in_world(self, link: LinkId) -> [Moving<'g>; 3] {
        let omega = self.link_omega(link);
        self.world_axes(link).bare.map(|axis| omega.project(axis))
    }

    /// Σ ½ A₀ e_j × A e_j with A₀ of a quaternion of any length.
    pub fn deviation(self, body: BodyId, quaternion: On<'g, [Node; 4]>) -> [Moving<'g>; 3] {
        let g = self.g;
        let quaternion = quaternion.bare.map(|part| g.on(part));
        let length = g.sum(quaternion.map(|part| part.square())).sqrt();
        let wanted = rotation_matrix(quaternion.map(|part| part / length));
        let placement = &self.bare.bodies[body.0];
        let axes = g.on(placement.axes);
        let axes = [0, 1, 2].map(|j| self.direction_of(placement.link, axes.column(j), GROUND));
        [0, 1, 2].map(|k| {
            let along = vector::unit(g, k);
            let mut sum = self.moving(&self.bare.velocities, Jet::constant(g.zero()));
            for (j, axis) in axes.iter().enumerate() {
                // e_k·(a₀ × a) = (e_k × a₀)·a
                sum = sum + axis.project(0.5 * along.cross(wanted.column(j)));
            }
            sum
        })
    }

    /// World ← link.
    pub fn world_axes(self, link: LinkId) -> On<'g, Mat3> {
        let ancestors = self.bare.ancestors(link).into_iter().rev().skip(1);
        ancestors.fold(vector::identity(self.g), |matrix, at| {
            let link = self.g.on(&self.bare.links[at]);
            // Rows of the product are those of the matrix, turned back.
            matrix.map_rows(|row| link.down(row))
        })
    }

    fn joint_spots(self, laws: &Laws<'g>, joint: &Joint) -> [Spot<'g>; 2] {
        [self.spot(laws, &joint.first), self.spot(laws, &joint.second)]
    }

    /// (cos, sin) of the angle of a joint.
    pub fn rotor_pair(self, laws: &Laws<'g>, rotor: Rotor) -> On<'g, [Node; 2]> {
        let g = self.g;
        let one = g.on([g.one().bare, g.zero().bare]);
        let Rotor::Joint(id, which) = rotor else { return one };
        if let Some((pair, _)) = self.bare.angles.get(&(id, which)) {
            return g.on(*pair);
        }
        let joint = &laws.mechanism.joints[id.0];
        let [first, second] = self.joint_spots(laws, joint);
        if let [axis, second_axis] = &joint.directions[..] {
            // The second's axis, seen from the first, has turned about the first's by the first angle; the other way round
            // for the second angle.
            let (own, other, about, towards) = if which == 0 {
                (first, second, axis, second_axis)
            } else {
                (second, first, second_axis, axis)
            };
            let (about, towards) = (laws.vector(about), laws.vector(towards));
            let (about, towards) = (about.normalized(), towards.normalized());
            let seen = self.direction(&own, &other, other.axes * towards).value();
            let across = about.cross(towards);
            let (near, across) = (own.axes * towards, own.axes * across);
            let (cos, sin) = (near.dot(seen), across.dot(seen));
            return g.on([cos.bare, if which == 0 { sin.bare } else { (-sin).bare }]);
        }
        let Some(axis) = joint.common_axis() else { return one };
        let frame = axes::joint_frame(laws, axis);
        let (e1, e2) = (first.axes * frame, second.axes * frame);
        let seen = self.direction(&first, &second, e2.column(0)).value();
        g.on([e1.column(0).dot(seen).bare, e1.column(1).dot(seen).bare])
    }

    /// The angle of a joint without its value.
    pub fn rotor_rate(self, laws: &Laws<'g>, rotor: Rotor) -> Moving<'g> {
        let (still, one) = (laws.still(self.g.zero()), self.g.one());
        let Rotor::Joint(id, which) = rotor else { return still };
        if let Some((_, rate)) = self.bare.angles.get(&(id, which)) {
            let mut angle = still;
            angle.jet.columns.insert(*rate, one.bare);
            return angle;
        }
        let joint = &laws.mechanism.joints[id.0];
        let [first, second] = self.joint_spots(laws, joint);
        let (first_omega, second_omega) = (self.link_omega(first.link), self.link_omega(second.link));
        if let [axis, second_axis] = &joint.directions[..] {
            // a₁·(ω₂ − ω₁), or b₂·(ω₂ − ω₁): as a product of what moves.
            let (own, own_omega, other, other_omega, axis) = if which == 0 {
                (first, first_omega, second, second_omega, axis)
            } else {
                (second, second_omega, first, first_omega, second_axis)
            };
            let axis = own.axes * laws.vector(axis).normalized();
            let seen = self.direction_of(own.link, axis, other.link);
            let rate = moving_projection(&seen, &other_omega) - own_omega.project(axis);
            return if which == 0 { rate } else { -rate };
        }
        let Some(axis) = joint.common_axis() else { return still };
        let z = laws.vector(axis).normalized();
        let (z1, z2) = (first.axes * z, second.axes * z);
        second_omega.project(z2) - first_omega.project(z1)
    }

    /// Travel of a joint.
    pub fn travel(self, laws: &Laws<'g>, id: JointId, which: usize) -> Moving<'g> {
        if let Some((travel, rate, factor)) = self.bare.travels.get(&(id, which)) {
            let mut travel = laws.still(self.g.on(*travel));
            travel.jet.columns.insert(*rate, *factor);
            return travel;
        }
        let joint = &laws.mechanism.joints[id.0];
        let slides = joints::motions(joint).iter().find_map(|motion| match motion {
            Elementary::Slide { axis, which: own } => (*own == which).then_some(*axis),
            Elementary::Wind => Some(2),
            Elementary::Turn { .. } | Elementary::Ball => None,
        });
        slides.map_or_else(|| laws.still(self.g.zero()), |axis| self.shift(laws, id, axis))
    }

    /// How far the second place of a joint is from the first along an axis of the joint on that.
    pub fn shift(self, laws: &Laws<'g>, id: JointId, axis: usize) -> Moving<'g> {
        let joint = &laws.mechanism.joints[id.0];
        let [first, second] = self.joint_spots(laws, joint);
        let frame = first.axes * joints::frames(laws, joint)[0];
        self.delta(&first, &second).project(frame.column(axis))
    }
}

impl<'g> On<'g, &Placement> {
    /// A point of the body, on its link.
    pub fn point(self, at: On<'g, Vec3>) -> On<'g, Vec3> {
        self.g.on(self.bare.at) + self.bare.axes * at
    }
}

/// A quantity whose rate is u·ω, both moving.
fn moving_projection<'g>(u: &Moving<'g, VectorJet>, omega: &Moving<'g, VectorJet>) -> Moving<'g> {
    let mut projection = omega.project(u.value());
    projection.jet.bias = (projection.bias() + u.rate().dot(omega.rate())).bare;
    projection
}
