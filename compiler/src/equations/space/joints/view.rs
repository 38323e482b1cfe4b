//! Along whose axes the distance of two places is taken: of the body, or the ground, where their ways along the tree meet, or of
//! one of their own bodies, where that promises clearly fewer operations.
//!
//! Only the tree decides, so that all derivations of a row agree on it. Counted are the turns of value, rate and
//! acceleration, and of each velocity's column, which begins in the axes of the body that the velocity moves, or of the ground
//! if it is that of the centre of a free body.

use super::{Elementary, motions};
use crate::equations::SpanningTree;
use crate::model::{BodyId, Frame, Joint, Mechanism};

pub fn seen_from(mechanism: &Mechanism, tree: &SpanningTree, joint: &Joint) -> Frame {
    let ends = [joint.first.frame, joint.second.frame];
    let axes_of = |frame: Frame| match frame {
        // A particle has no axes.
        Frame::Body(body) if !mechanism.bodies[body.0].form.turns => Frame::Ground,
        frame => frame,
    };
    let ways = Ways { mechanism, tree };
    let meeting = axes_of(ways.meeting(ends[0], ends[1]));
    // Where the ways meet, several joints share what they need.
    let limit = 4 * ways.turns_of_gap(ends, meeting);
    let others = ends.map(axes_of).into_iter().filter(|frame| 5 * ways.turns_of_gap(ends, *frame) <= limit);
    others.min_by_key(|frame| ways.turns_of_gap(ends, *frame)).unwrap_or(meeting)
}

struct Ways<'a> {
    mechanism: &'a Mechanism,
    tree: &'a SpanningTree,
}

impl Ways<'_> {
    fn meeting(&self, a: Frame, b: Frame) -> Frame {
        let above = self.tree.path(a);
        self.tree.path(b).into_iter().find(|frame| above.contains(frame)).unwrap_or(Frame::Ground)
    }

    /// The bodies from an end to where it meets the way of another.
    fn way(&self, from: Frame, other: Frame) -> Vec<BodyId> {
        let meeting = self.meeting(from, other);
        let way = self.tree.path(from).into_iter().take_while(|frame| *frame != meeting);
        way.filter_map(|frame| match frame {
            Frame::Body(body) => Some(body),
            Frame::Ground => None,
        })
        .collect()
    }

    /// The joint by which a body hangs on the next.
    fn joint(&self, body: BodyId) -> Option<&Joint> {
        let attachment = self.tree.attachments.iter().find(|attachment| attachment.body == body)?;
        attachment.joint.map(|(joint, _)| &self.mechanism.joints[joint.0])
    }

    /// Operations of turning a vector of a body into the axes of the next.
    fn step(&self, body: BodyId) -> usize {
        let turns = |motion: &Elementary| match motion {
            Elementary::Turn { .. } => TURN,
            Elementary::Ball => BALL,
            Elementary::Slide { .. } | Elementary::Wind => 0,
        };
        self.joint(body).map_or(BALL, |joint| motions(joint).iter().map(turns).sum())
    }

    /// Turns of the columns of a body's velocities.
    fn columns(&self, body: BodyId, seen_from: Frame) -> usize {
        let own = self.turns_between(Frame::Body(body), seen_from);
        match self.joint(body) {
            Some(joint) => joint.form.freedoms * own,
            None => 3 * own + 3 * self.turns_between(Frame::Ground, seen_from),
        }
    }

    fn turns_between(&self, a: Frame, b: Frame) -> usize {
        let bodies = self.way(a, b).into_iter().chain(self.way(b, a));
        bodies.map(|body| self.step(body)).sum()
    }

    fn turns_of_gap(&self, ends: [Frame; 2], seen_from: Frame) -> usize {
        let vectors = ends.map(|end| 3 * self.turns_between(end, seen_from));
        let moving = self.way(ends[0], ends[1]).into_iter().chain(self.way(ends[1], ends[0]));
        vectors.into_iter().chain(moving.map(|body| self.columns(body, seen_from))).sum()
    }
}

/// Operations of turning a vector, fused ones counted once: about an axis, and by a matrix.
const TURN: usize = 4;
const BALL: usize = 9;
