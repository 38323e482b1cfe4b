//! Angles and travels in the plane: of bodies, and of joints as the difference of two bodies.

use super::joints;
use super::kinematics::{FrameId, GROUND, Kinematics, LocalVector, Position};
use super::vector::{self, Pair};
use crate::equations::jet::{Jet, Moving};
use crate::equations::laws::Laws;
use crate::model::{Frame, Joint, JointId, Place, Rotor, Vector};
use crate::symbolic::{On, Scalar};
use std::collections::BTreeMap;

impl<'g> On<'g, &'g Kinematics> {
    /// A place of a body, or of the ground, which may move with time.
    pub fn place(self, laws: &Laws<'g>, place: &Place) -> On<'g, Position> {
        match place.frame {
            Frame::Ground => ground(laws, &place.at),
            Frame::Body(body) if place.of_mean => laws.g.on(self.bare.bodies[body.0].origin.clone()),
            Frame::Body(body) => self.point(body.0, laws.pair_of(&place.at)),
        }
    }

    pub fn place_in_world(self, laws: &Laws<'g>, place: &Place) -> [Moving<'g>; 2] {
        self.world(&self.place(laws, place).bare)
    }

    /// Second less first; what is fixed in one frame cancels before it is turned.
    pub fn difference_in_world(self, laws: &Laws<'g>, first: &Place, second: &Place) -> [Moving<'g>; 2] {
        let (first, second) = (self.place(laws, first), self.place(laws, second));
        self.world(&(second - first).bare)
    }

    /// Index of the rate of a body's orientation.
    fn turning(self, laws: &Laws, frame: Frame) -> Option<usize> {
        match frame {
            Frame::Ground => None,
            Frame::Body(body) if !laws.mechanism.bodies[body.0].form.turns => None,
            Frame::Body(body) => self.bare.frames[self.bare.bodies[body.0].frame].rate,
        }
    }

    /// (cos, sin) of θ₂ − θ₁ − angle.
    fn difference(self, first: Frame, second: Frame, angle: On<'g, Pair>) -> On<'g, Pair> {
        let orientation = |frame: Frame| match frame {
            Frame::Ground => vector::unturned(self.g),
            Frame::Body(body) => self.orientation(body.0),
        };
        let (first, second) = (orientation(first), orientation(second));
        second.turned(first.turned(angle).opposite())
    }

    /// θ₂ − θ₁ with a value that the caller knows.
    fn turn(self, laws: &Laws, first: Frame, second: Frame, value: Scalar<'g>) -> Moving<'g> {
        let (minus, plus) = (self.turning(laws, first), self.turning(laws, second));
        let mut columns = BTreeMap::new();
        if minus != plus {
            let (one, minus_one) = (self.g.one().bare, self.g.number(-1.0).bare);
            columns.extend(minus.map(|index| (index, minus_one)));
            columns.extend(plus.map(|index| (index, one)));
        }
        self.moving(&self.bare.velocities, Jet { columns, ..Jet::constant(value) })
    }

    /// sin(θ₂ − θ₁ − angle) as a jet, and its cosine. With ṡ = c Δω:  s̈ = c Δα − s Δω².
    pub fn sine_jet(
        self,
        laws: &Laws<'g>,
        first: Frame,
        second: Frame,
        angle: On<'g, Pair>,
    ) -> (Moving<'g>, Scalar<'g>) {
        let [cosine, sine] = self.difference(first, second, angle).parts();
        let angle = self.turn(laws, first, second, sine);
        (angle.chain(sine, cosine, -sine), cosine)
    }

    /// cos(θ₂ − θ₁ − angle) as a jet.
    pub fn cosine_jet(self, laws: &Laws<'g>, first: Frame, second: Frame, angle: On<'g, Pair>) -> Moving<'g> {
        let [cosine, sine] = self.difference(first, second, angle).parts();
        let angle = self.turn(laws, first, second, cosine);
        angle.chain(cosine, -sine, -cosine)
    }

    /// (cos, sin) of a rotor's angle; of a joint on beams that between their sections.
    pub fn rotor_pair(self, laws: &Laws<'g>, rotor: Rotor) -> On<'g, Pair> {
        let (first, second) = ends(laws, rotor);
        let pair = self.difference(first, second, vector::unturned(self.g));
        match self.between_sections(laws, rotor) {
            None => pair,
            Some(slope) => pair.turned([slope.value().cos().bare, slope.value().sin().bare]),
        }
    }

    /// What the sections at the places of a joint are turned by beyond their bodies.
    fn between_sections(self, laws: &Laws<'g>, rotor: Rotor) -> Option<Moving<'g>> {
        let Rotor::Joint(joint, _) = rotor else { return None };
        let joint = &laws.mechanism.joints[joint.0];
        match (self.slope(laws, &joint.first), self.slope(laws, &joint.second)) {
            (None, None) => None,
            (Some(first), None) => Some(-first),
            (None, second) => second,
            (Some(first), Some(second)) => Some(second - first),
        }
    }

    /// θ₂ − θ₁ in (−π, π], whether or not the turns of the bodies are counted.
    pub fn angle_between(self, laws: &Laws<'g>, first: Frame, second: Frame) -> Moving<'g> {
        let [cosine, sine] = self.difference(first, second, vector::unturned(self.g)).parts();
        self.turn(laws, first, second, sine.atan2(cosine))
    }

    /// The way from one place to another along the axes of what the first belongs to.
    pub fn difference_in_first(self, laws: &Laws<'g>, first: &Place, second: &Place) -> [Moving<'g>; 2] {
        let delta = self.place(laws, second) - self.place(laws, first);
        let (one, zero) = (self.g.one().bare, self.g.zero().bare);
        [[one, zero], [zero, one]].map(|axis| {
            let (frame, axis) = self.carried_by(first.frame, self.g.on(axis));
            self.project(frame, axis, &delta.bare)
        })
    }

    /// u·(p₂ − p₁), u in the axes of what the first belongs to.
    pub fn way(self, laws: &Laws<'g>, first: &Place, u: &Vector, second: &Place) -> Moving<'g> {
        let delta = self.place(laws, second) - self.place(laws, first);
        let (frame, u) = self.carried_by(first.frame, laws.pair_of(u));
        self.project(frame, u, &delta.bare)
    }

    /// A direction in the axes of what a place belongs to.
    pub fn direction_in_world(self, laws: &Laws<'g>, place: &Place, u: &Vector) -> [Moving<'g>; 2] {
        let (frame, u) = self.carried_by(place.frame, laws.pair_of(u));
        self.world(&u.fixed_in(frame).bare)
    }

    pub fn rotor_rate(self, laws: &Laws<'g>, rotor: Rotor) -> Moving<'g> {
        let (first, second) = ends(laws, rotor);
        let turn = self.turn(laws, first, second, self.g.zero());
        match self.between_sections(laws, rotor) {
            None => turn,
            Some(slope) => turn + slope,
        }
    }

    /// θ̇ of the body that a place is on, and of a beam what the section there turns beyond it.
    pub fn turning_at(self, laws: &Laws<'g>, place: &Place) -> Option<Moving<'g>> {
        let Frame::Body(body) = place.frame else { return None };
        let turn = self.rotor_rate(laws, Rotor::Body(body));
        Some(match self.slope(laws, place) {
            Some(slope) => turn + slope,
            None => turn,
        })
    }

    /// Travel of a joint: â·(p₂ − p₁), â along its axis, or along one of the first place's axes where it has none.
    pub fn travel(self, laws: &Laws<'g>, joint: JointId, which: usize) -> Moving<'g> {
        let known = self.bare.travels.get(&joint);
        let joint = &laws.mechanism.joints[joint.0];
        if let Some(known) = known {
            return joints::travel_of_curve(laws, self, joint, *known);
        }
        let axis = match joint.directions.get(which) {
            Some(axis) => laws.pair_of(axis).normalized(),
            None => vector::axis(self.g, joint.graph().unwrap_or(which)),
        };
        let (frame, along) = self.carried_by(joint.first.frame, axis);
        let (first, second) = (self.place(laws, &joint.first), self.place(laws, &joint.second));
        self.project(frame, along, &(second - first).bare)
    }

    /// The normal of a joint's axis, which the first body carries, in world axes.
    pub fn normal(self, laws: &Laws<'g>, joint: &Joint) -> On<'g, Pair> {
        let axis = match joint.directions.first() {
            Some(axis) => laws.pair_of(axis).normalized(),
            None => vector::axis(self.g, 0),
        };
        let (frame, normal) = self.carried_by(joint.first.frame, axis.perpendicular());
        self.to_world(frame, normal)
    }

    /// A direction given in a body's axes, as its frame and the components there.
    pub fn carried_by(self, body: Frame, u: On<'g, Pair>) -> (FrameId, On<'g, Pair>) {
        match body {
            Frame::Ground => (GROUND, u),
            Frame::Body(body) => {
                let placement = &self.bare.bodies[body.0];
                (placement.frame, u.turned(placement.offset))
            }
        }
    }
}

/// A place of the ground, which may move with time.
pub fn ground<'g>(laws: &Laws<'g>, at: &Vector) -> On<'g, Position> {
    let [x, y, _] = laws.ground(at).map(|component| component.jet);
    let vector = LocalVector {
        at: [x.value, y.value],
        slides: BTreeMap::new(),
        drift: [x.drift, y.drift],
        drift_rate: [x.bias, y.bias],
    };
    laws.g.on(Position::of(GROUND, vector))
}

fn ends(laws: &Laws, rotor: Rotor) -> (Frame, Frame) {
    match rotor {
        Rotor::Body(body) => (Frame::Ground, Frame::Body(body)),
        Rotor::Joint(joint, _) => {
            let joint = &laws.mechanism.joints[joint.0];
            (joint.first.frame, joint.second.frame)
        }
    }
}
