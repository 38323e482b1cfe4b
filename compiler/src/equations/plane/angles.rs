//! Angles and travels in the plane: of bodies, and of joints as the difference of two bodies.

use super::joints;
use super::kinematics::{GROUND, Kinematics, LocalVector, Position, compose, inverse, rotate};
use crate::equations::jet::Jet;
use crate::equations::laws::Laws;
use crate::model::{BodyKind, Frame, JointId, Place, Rotor, Vector};
use crate::symbolic::{Graph, Node};
use std::collections::BTreeMap;

impl Kinematics {
    /// A place of a body, or of the ground, which may move with time.
    pub fn place(&self, g: &mut Graph, laws: &Laws, place: &Place) -> Position {
        match place.frame {
            Frame::Ground => ground(g, laws, &place.at),
            Frame::Body(body) => {
                let at = laws.pair_of(g, &place.at);
                self.point(g, body.0, at)
            }
        }
    }

    pub fn place_in_world(&self, g: &mut Graph, laws: &Laws, place: &Place) -> [Jet; 2] {
        let position = self.place(g, laws, place);
        self.world(g, &position)
    }

    /// Second less first; what is fixed in one frame cancels before it is turned.
    pub fn difference_in_world(&self, g: &mut Graph, laws: &Laws, first: &Place, second: &Place) -> [Jet; 2] {
        let (first, second) = (self.place(g, laws, first), self.place(g, laws, second));
        let delta = second.sub(g, &first);
        self.world(g, &delta)
    }

    /// Index of the rate of a body's orientation.
    fn turning(&self, laws: &Laws, frame: Frame) -> Option<usize> {
        match frame {
            Frame::Ground => None,
            Frame::Body(body) if laws.mechanism.bodies[body.0].kind == BodyKind::Particle => None,
            Frame::Body(body) => self.frames[self.bodies[body.0].frame].rate,
        }
    }

    /// (cos, sin) of θ₂ − θ₁ − angle.
    fn difference(&self, g: &mut Graph, first: Frame, second: Frame, angle: [Node; 2]) -> [Node; 2] {
        let orientation = |g: &mut Graph, frame: Frame| match frame {
            Frame::Ground => [g.constant(1.0), g.constant(0.0)],
            Frame::Body(body) => self.orientation(g, body.0),
        };
        let (a, b) = (orientation(g, first), orientation(g, second));
        let a = compose(g, a, angle);
        let a = inverse(g, a);
        compose(g, b, a)
    }

    /// θ₂ − θ₁ with a value that the caller knows.
    fn turn(&self, g: &mut Graph, laws: &Laws, first: Frame, second: Frame, value: Node) -> Jet {
        let (minus, plus) = (self.turning(laws, first), self.turning(laws, second));
        let mut columns = BTreeMap::new();
        if minus != plus {
            let (one, minus_one) = (g.constant(1.0), g.constant(-1.0));
            columns.extend(minus.map(|index| (index, minus_one)));
            columns.extend(plus.map(|index| (index, one)));
        }
        let zero = g.constant(0.0);
        Jet { value, columns, drift: zero, bias: zero, known_rate: None }
    }

    /// sin(θ₂ − θ₁ − angle) as a jet, and its cosine. With ṡ = c Δω:  s̈ = c Δα − s Δω².
    pub fn sine_jet(
        &self,
        g: &mut Graph,
        laws: &Laws,
        first: Frame,
        second: Frame,
        angle: [Node; 2],
    ) -> (Jet, Node) {
        let [cosine, sine] = self.difference(g, first, second, angle);
        let angle = self.turn(g, laws, first, second, sine);
        let minus_sine = g.neg(sine);
        (angle.chain(g, sine, cosine, minus_sine, &self.velocities), cosine)
    }

    /// (cos, sin) of a rotor's angle.
    pub fn rotor_pair(&self, g: &mut Graph, laws: &Laws, rotor: Rotor) -> [Node; 2] {
        let (first, second) = ends(laws, rotor);
        let none = [g.constant(1.0), g.constant(0.0)];
        self.difference(g, first, second, none)
    }

    pub fn rotor_rate(&self, g: &mut Graph, laws: &Laws, rotor: Rotor) -> Jet {
        let (first, second) = ends(laws, rotor);
        let zero = g.constant(0.0);
        self.turn(g, laws, first, second, zero)
    }

    /// Travel of a joint: â·(p₂ − p₁).
    pub fn travel(&self, g: &mut Graph, laws: &Laws, joint: JointId) -> Jet {
        let joint = &laws.mechanism.joints[joint.0];
        let Some(axis) = joint.directions.first() else {
            let zero = g.constant(0.0);
            return Jet::constant(g, zero);
        };
        let along = laws.pair_of(g, axis);
        let along = joints::normalized(g, along);
        let (frame, along) = match joint.first.frame {
            Frame::Ground => (GROUND, along),
            Frame::Body(body) => {
                let placement = &self.bodies[body.0];
                (placement.frame, rotate(g, placement.offset, along))
            }
        };
        let (first, second) = (self.place(g, laws, &joint.first), self.place(g, laws, &joint.second));
        let delta = second.sub(g, &first);
        self.project(g, frame, along, &delta)
    }
}

/// A place of the ground, which may move with time.
pub fn ground(g: &mut Graph, laws: &Laws, at: &Vector) -> Position {
    let [x, y, _] = laws.ground(g, at);
    let vector = LocalVector {
        at: [x.value, y.value],
        slides: BTreeMap::new(),
        drift: [x.drift, y.drift],
        drift_rate: [x.bias, y.bias],
    };
    Position::of(GROUND, vector)
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
