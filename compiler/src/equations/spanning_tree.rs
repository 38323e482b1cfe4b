//! Which joints carry the bodies, and which only close loops.
//!
//! In absolute coordinates no joint carries anything: every body is free, and every joint gives constraint rows. In
//! tree coordinates each body hangs on one joint of a spanning tree, and the other joints, cut, give the rows.

use super::{plane, space};
use crate::model::{BodyId, Frame, JointId, Mechanism, Space};
use std::collections::{BTreeMap, BTreeSet};

/// How one body is carried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Attachment {
    pub body: BodyId,
    /// The joint it hangs on and the body (or ground) at its other end; `None`: free.
    pub joint: Option<(JointId, Frame)>,
}

/// A forest over all bodies, parents before children.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SpanningTree {
    pub attachments: Vec<Attachment>,
}

impl SpanningTree {
    /// Every body free.
    pub fn absolute(mechanism: &Mechanism) -> Self {
        let free = |index| Attachment { body: BodyId(index), joint: None };
        SpanningTree { attachments: (0..mechanism.bodies.len()).map(free).collect() }
    }

    /// Breadth first from the ground, so that paths are short; of the joints that reach a body at the same depth,
    /// the one that leaves the fewest freedoms, then the one declared first. `options { cut = … }` is obeyed. What has to carry a body
    /// does so as soon as one of its ends is reached, so that no other joint is there first.
    pub fn spanning(mechanism: &Mechanism) -> Self {
        if mechanism.space == Space::Spatial {
            return space::fewest_freedoms(mechanism);
        }
        let cut: BTreeSet<JointId> = mechanism.options.cut.iter().map(|(joint, _)| *joint).collect();
        let usable = |id: &JointId| !cut.contains(id);
        let mut at: BTreeMap<Frame, Vec<JointId>> = BTreeMap::new();
        for (index, joint) in mechanism.joints.iter().enumerate() {
            let id = JointId(index);
            // What keeps a direction that bends is a row.
            let straight = !joint.form.keeps_orientation
                || [&joint.first, &joint.second].iter().all(|place| mechanism.keeps_direction(place));
            if usable(&id) && joint.holds() && straight && plane::joints::of(joint.form).attach.is_some() {
                at.entry(joint.first.frame).or_default().push(id);
                at.entry(joint.second.frame).or_default().push(id);
            }
        }
        let reached = vec![false; mechanism.bodies.len()];
        let mut growth = Growth { mechanism, at: &at, reached, attachments: Vec::new(), next: Vec::new() };
        growth.carry(Frame::Ground);
        let mut frontier = vec![Frame::Ground];
        frontier.append(&mut growth.next);
        loop {
            for attachment in next_layer(mechanism, &at, &frontier, &growth.reached) {
                growth.reach(attachment);
            }
            frontier = std::mem::take(&mut growth.next);
            if frontier.is_empty() {
                // What the ground does not reach: its first body is free, the rest hangs on it.
                match growth.reached.iter().position(|reached| !reached) {
                    None => return SpanningTree { attachments: growth.attachments },
                    Some(free) => {
                        growth.reach(Attachment { body: BodyId(free), joint: None });
                        frontier = std::mem::take(&mut growth.next);
                    }
                }
            }
        }
    }

    /// A body, the one it hangs on, and so on to the ground (which ends every path, also that of a free body).
    pub fn path(&self, frame: Frame) -> Vec<Frame> {
        let mut path = vec![frame];
        let mut at = frame;
        while let Frame::Body(body) = at {
            let attachment = self.attachments.iter().find(|own| own.body == body);
            at = attachment.and_then(|own| own.joint).map_or(Frame::Ground, |(_, parent)| parent);
            path.push(at);
        }
        path
    }

    /// The joints of the loop that a cut joint closes, itself first.
    pub fn around(&self, mechanism: &Mechanism, cut: JointId) -> Vec<JointId> {
        let joint = &mechanism.joints[cut.0];
        let (one, other) = (self.path(joint.first.frame), self.path(joint.second.frame));
        let mut around = vec![cut];
        let own = one.iter().filter(|frame| !other.contains(frame));
        for frame in own.chain(other.iter().filter(|frame| !one.contains(frame))) {
            let own = self.attachments.iter().find(|own| Frame::Body(own.body) == *frame);
            around.extend(own.and_then(|own| own.joint).map(|(joint, _)| joint));
        }
        around
    }

    /// True for the joints that carry a body.
    pub fn carrying(&self, mechanism: &Mechanism) -> Vec<bool> {
        let mut carrying = vec![false; mechanism.joints.len()];
        for (joint, _) in self.attachments.iter().filter_map(|attachment| attachment.joint) {
            carrying[joint.0] = true;
        }
        carrying
    }
}

/// A tree that grows.
struct Growth<'a> {
    mechanism: &'a Mechanism,
    at: &'a BTreeMap<Frame, Vec<JointId>>,
    reached: Vec<bool>,
    attachments: Vec<Attachment>,
    /// What was reached since the last layer.
    next: Vec<Frame>,
}

impl Growth<'_> {
    /// A body, if it is not reached, and what it has to carry.
    fn reach(&mut self, attachment: Attachment) {
        let Attachment { body, .. } = attachment;
        if std::mem::replace(&mut self.reached[body.0], true) {
            return;
        }
        self.attachments.push(attachment);
        self.next.push(Frame::Body(body));
        if self.mechanism.bodies[body.0].form.turns {
            self.carry(Frame::Body(body));
        }
    }

    fn carry(&mut self, frame: Frame) {
        for id in self.at.get(&frame).into_iter().flatten() {
            let joint = &self.mechanism.joints[id.0];
            if let Frame::Body(body) = joint.other(frame)
                && joint.must_carry()
            {
                self.reach(Attachment { body, joint: Some((*id, frame)) });
            }
        }
    }
}

/// The bodies that joints reach from others.
fn next_layer(
    mechanism: &Mechanism,
    at: &BTreeMap<Frame, Vec<JointId>>,
    frontier: &[Frame],
    reached: &[bool],
) -> Vec<Attachment> {
    let mut best: BTreeMap<BodyId, (usize, JointId, Frame)> = BTreeMap::new();
    for frame in frontier {
        // A particle has no orientation: nothing that needs one can hang on it.
        if let Frame::Body(body) = frame
            && !mechanism.bodies[body.0].form.turns
        {
            continue;
        }
        for id in at.get(frame).into_iter().flatten() {
            let joint = &mechanism.joints[id.0];
            let Frame::Body(child) = joint.other(*frame) else { continue };
            let key = (joint.form.freedoms, *id, *frame);
            if !reached[child.0] && best.get(&child).is_none_or(|known| key < *known) {
                best.insert(child, key);
            }
        }
    }
    let attachment = |(body, (_, joint, parent)): (&BodyId, &(usize, JointId, Frame))| Attachment {
        body: *body,
        joint: Some((*joint, *parent)),
    };
    best.iter().map(attachment).collect()
}
