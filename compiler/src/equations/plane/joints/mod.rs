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
use super::kinematics::{FrameId, GROUND, LocalVector, Placement, Position};
use super::vector::{self, Pair};
use crate::equations::JointRow;
use crate::equations::jet::Moving;
use crate::equations::laws::Laws;
use crate::model::{BodyId, BodyKind, Frame, Joint, JointId, JointKind};
use crate::symbolic::{Node, On, Scalar};

/// What a joint exerts on the second place's body: force (world axes) at the second place, and torque about it.
pub type Wrench<'g> = [Scalar<'g>; 3];

/// Whether a joint lets the carried body turn on its own.
pub fn turns(kind: &JointKind) -> bool {
    matches!(kind, JointKind::Revolute { .. } | JointKind::PointOnLine { .. } | JointKind::Distance { .. })
}

/// Whether a joint has a travel.
pub fn slides(kind: &JointKind) -> bool {
    matches!(kind, JointKind::Prismatic { .. } | JointKind::PointOnLine { .. })
}

/// Constraint rows of a joint that carries nothing.
pub fn rows(laws: &Laws, joint: &Joint) -> Vec<JointRow> {
    let ends = Ends::of(laws, joint);
    match &joint.kind {
        JointKind::Fixed { angle } => fixed::rows(laws, &ends, angle),
        JointKind::Revolute { .. } => revolute::rows(laws, &ends),
        JointKind::Prismatic { axis, angle } => prismatic::rows(laws, &ends, axis, angle),
        JointKind::PointOnLine { direction } => point_on_line::rows(laws, &ends, direction),
        JointKind::Distance { length } => distance::rows(laws, &ends, length),
        _ => Vec::new(),
    }
}

/// What the joint exerts, from the multipliers of its rows.
pub fn reaction<'g>(laws: &Laws<'g>, joint: &Joint, lambda: &[Scalar<'g>]) -> Wrench<'g> {
    let ends = Ends::of(laws, joint);
    match &joint.kind {
        JointKind::Fixed { angle } => fixed::reaction(laws, &ends, angle, lambda),
        JointKind::Revolute { .. } => revolute::reaction(laws, lambda),
        JointKind::Prismatic { axis, angle } => prismatic::reaction(laws, &ends, axis, angle, lambda),
        JointKind::PointOnLine { direction } => point_on_line::reaction(laws, &ends, direction, lambda),
        JointKind::Distance { .. } => distance::reaction(laws, &ends, lambda),
        _ => [laws.g.zero(); 3],
    }
}

/// Places `child` where the joint carries it. `travel` is the joint's coordinate and the index of its rate.
pub fn attach(
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
        Frame::Ground => ground(laws, &near.at),
        Frame::Body(_) => {
            let arm = laws.pair_of(&near.at).in_frame(&parent);
            laws.g.on(parent.origin.clone()) + arm
        }
    };
    let carried = Carried {
        parent,
        pivot,
        at: laws.pair_of(&far.at),
        frame,
        travel,
        child_is_second,
        rigid: laws.mechanism.bodies[child.0].kind == BodyKind::Rigid,
    };
    match &joint.kind {
        JointKind::Fixed { angle } => fixed::attach(laws, carried, angle),
        JointKind::Prismatic { axis, angle } => prismatic::attach(laws, carried, axis, angle),
        JointKind::PointOnLine { direction } => point_on_line::attach(laws, carried, direction),
        _ => revolute::attach(laws, carried),
    }
}

/// The two ends of a joint in motion.
struct Ends<'g> {
    first: Frame,
    second: Frame,
    /// Δ = p₂ − p₁.
    delta: On<'g, Position>,
}

impl<'g> Ends<'g> {
    fn of(laws: &Laws<'g>, joint: &Joint) -> Self {
        let (first, second) =
            (laws.plane().place(laws, &joint.first), laws.plane().place(laws, &joint.second));
        Ends { first: joint.first.frame, second: joint.second.frame, delta: second - first }
    }

    /// Δ in world axes.
    fn in_world(&self, laws: &Laws<'g>) -> [Moving<'g>; 2] {
        laws.plane().world(&self.delta.bare)
    }
}

/// A body about to be placed at the far end of a joint.
struct Carried<'g> {
    parent: Placement,
    /// The near place.
    pivot: On<'g, Position>,
    /// The far place in the body's own axes.
    at: On<'g, Pair>,
    /// The frame the body turns with.
    frame: FrameId,
    travel: Option<(Node, usize)>,
    child_is_second: bool,
    rigid: bool,
}

impl<'g> Carried<'g> {
    /// The placement that puts the far place at `p`, the body's orientation being `offset` within its frame.
    fn at(self, p: On<'g, Position>, offset: On<'g, Pair>) -> Placement {
        let offset_from =
            |origin: On<'g, Position>, frame| Placement { origin: origin.bare, frame, offset: offset.bare };
        if !self.rigid {
            return offset_from(p, GROUND);
        }
        offset_from(p - self.at.turned(offset).fixed_in(self.frame), self.frame)
    }

    /// `axis`·travel in the axes of `frame`, from the first place to the second, seen from the near place.
    fn slide(&self, frame: FrameId, axis: On<'g, Pair>) -> Position {
        let axis = if self.child_is_second { axis } else { -axis };
        let Some((travel, rate)) = self.travel else { return Position::default() };
        let mut vector = LocalVector::fixed(axis.g.on(travel) * axis);
        vector.slides.insert(rate, axis.bare);
        Position::of(frame, vector)
    }

    /// Orientation within the frame of a body that keeps the angle `pair` (second relative to first) to its parent.
    fn kept(&self, pair: On<'g, Pair>) -> On<'g, Pair> {
        let turn = if self.child_is_second { pair } else { pair.opposite() };
        turn.g.on(self.parent.offset).turned(turn)
    }
}
