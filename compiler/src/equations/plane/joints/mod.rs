//! The joints, one file each with the same functions in the same order:
//! `rows` (the constraint as jets), `attach` (where the joint carries a body), `reaction` (from multipliers).
//!
//! p₁, p₂ are the first and second place, θ₁, θ₂ the orientations of their bodies, Δ = p₂ − p₁. Kinds that need space do
//! not arrive here: the language has no words for them in the plane.

mod distance;
mod fixed;
mod point_on_line;
mod prismatic;
mod revolute;

use super::angles::ground;
use super::kinematics::{FrameId, GROUND, LocalVector, Placement, Position, inverse, rotate};
use crate::drawing::plane::Symbol;
use crate::equations::JointRow;
use crate::equations::jet::Jet;
use crate::equations::laws::Laws;
use crate::forms::JointForm;
use crate::model::{BodyId, BodyKind, Frame, Joint, JointId};
use crate::symbolic::{Graph, Node, Unary};

/// What a joint exerts on the second place's body: force (world axes) at the second place, and torque about it.
pub type Wrench = [Node; 3];

/// A kind of joint of the plane.
pub struct PlanarJoint {
    pub form: JointForm,
    /// Constraint rows where it carries nothing.
    pub rows: fn(&mut Graph, &Laws, &Ends) -> Vec<JointRow>,
    /// Places the body that it carries; `None`: it carries none.
    pub attach: Option<fn(&mut Graph, &Laws, Carried) -> Placement>,
    /// What it exerts, from the multipliers of its rows.
    pub reaction: fn(&mut Graph, &Laws, &Ends, &[Node]) -> Wrench,
    pub symbol: fn(&mut Symbol),
}

/// The joints of the plane.
pub static JOINTS: &[&PlanarJoint] =
    &[&fixed::JOINT, &revolute::JOINT, &prismatic::JOINT, &point_on_line::JOINT, &distance::JOINT];

/// The joint with a form, which is one of the list's own.
pub fn of(form: &'static JointForm) -> &'static PlanarJoint {
    let own = JOINTS.iter().find(|joint| std::ptr::eq(&joint.form, form));
    own.copied().expect("forms come from the list")
}

/// Constraint rows of a joint that carries nothing.
pub fn rows(g: &mut Graph, laws: &Laws, joint: &Joint) -> Vec<JointRow> {
    let ends = Ends::of(g, laws, joint);
    (of(joint.form).rows)(g, laws, &ends)
}

/// What the joint exerts, from the multipliers of its rows.
pub fn reaction(g: &mut Graph, laws: &Laws, joint: &Joint, lambda: &[Node]) -> Wrench {
    let ends = Ends::of(g, laws, joint);
    (of(joint.form).reaction)(g, laws, &ends, lambda)
}

/// Places `child` where the joint carries it. `travel` is the joint's coordinate and the index of its rate.
pub fn attach(
    g: &mut Graph,
    laws: &Laws,
    joint: JointId,
    child: BodyId,
    parent: Placement,
    frame: FrameId,
    travel: Option<(Node, usize)>,
) -> Placement {
    let joint = &laws.mechanism.joints[joint.0];
    let child_is_second = joint.second.frame == Frame::Body(child);
    let (near, far) =
        if child_is_second { (&joint.first, &joint.second) } else { (&joint.second, &joint.first) };
    let pivot = match near.frame {
        Frame::Ground => ground(g, laws, &near.at),
        Frame::Body(_) => {
            let at = laws.pair_of(g, &near.at);
            let local = rotate(g, parent.offset, at);
            let arm = Position::fixed(g, parent.frame, local);
            parent.origin.add(g, &arm)
        }
    };
    let carried = Carried {
        joint,
        parent,
        pivot,
        at: laws.pair_of(g, &far.at),
        frame,
        travel,
        child_is_second,
        rigid: laws.mechanism.bodies[child.0].kind == BodyKind::Rigid,
    };
    let attach = of(joint.form).attach.expect("the tree hangs bodies on joints that carry");
    attach(g, laws, carried)
}

/// The two ends of a joint in motion.
pub struct Ends<'a> {
    joint: &'a Joint,
    first: Frame,
    second: Frame,
    /// Δ = p₂ − p₁.
    delta: Position,
}

impl<'a> Ends<'a> {
    fn of(g: &mut Graph, laws: &Laws, joint: &'a Joint) -> Self {
        let (first, second) =
            (laws.plane().place(g, laws, &joint.first), laws.plane().place(g, laws, &joint.second));
        Ends { joint, first: joint.first.frame, second: joint.second.frame, delta: second.sub(g, &first) }
    }

    /// A direction given in the first body's axes, as its frame and the components there.
    fn direction(&self, g: &mut Graph, laws: &Laws, u: [Node; 2]) -> (FrameId, [Node; 2]) {
        match self.first {
            Frame::Ground => (GROUND, u),
            Frame::Body(body) => {
                let placement = &laws.plane().bodies[body.0];
                (placement.frame, rotate(g, placement.offset, u))
            }
        }
    }
}

/// A body about to be placed at the far end of a joint.
pub struct Carried<'a> {
    joint: &'a Joint,
    parent: Placement,
    /// The near place.
    pivot: Position,
    /// The far place in the body's own axes.
    at: [Node; 2],
    /// The frame the body turns with.
    frame: FrameId,
    travel: Option<(Node, usize)>,
    child_is_second: bool,
    rigid: bool,
}

impl Carried<'_> {
    /// The placement that puts the far place at `p`, the body's orientation being `offset` within its frame.
    fn at(self, g: &mut Graph, p: &Position, offset: [Node; 2]) -> Placement {
        if !self.rigid {
            return Placement { origin: p.clone(), frame: GROUND, offset };
        }
        let local = rotate(g, offset, self.at);
        let arm = Position::fixed(g, self.frame, local);
        Placement { origin: p.sub(g, &arm), frame: self.frame, offset }
    }

    /// `axis`·travel in the axes of `frame`, from the first place to the second, seen from the near place.
    fn slide(&self, g: &mut Graph, frame: FrameId, axis: [Node; 2]) -> Position {
        let axis = if self.child_is_second { axis } else { [g.neg(axis[0]), g.neg(axis[1])] };
        let Some((travel, rate)) = self.travel else { return Position::default() };
        let at = [g.mul(axis[0], travel), g.mul(axis[1], travel)];
        let mut vector = LocalVector::fixed(g, at);
        vector.slides.insert(rate, axis);
        Position::of(frame, vector)
    }

    /// Orientation within the frame of a body that keeps the angle `pair` (second relative to first) to its parent.
    fn kept(&self, g: &mut Graph, pair: [Node; 2]) -> [Node; 2] {
        let turn = if self.child_is_second { pair } else { inverse(g, pair) };
        rotate(g, turn, self.parent.offset)
    }
}

/// A vector of length one.
pub(super) fn normalized(g: &mut Graph, u: [Node; 2]) -> [Node; 2] {
    let (xx, yy) = (g.mul(u[0], u[0]), g.mul(u[1], u[1]));
    let square = g.add(xx, yy);
    let length = g.unary(Unary::Sqrt, square);
    [g.div(u[0], length), g.div(u[1], length)]
}

/// A vector turned by a right angle, counter-clockwise.
fn perpendicular(g: &mut Graph, u: [Node; 2]) -> [Node; 2] {
    [g.neg(u[1]), u[0]]
}
