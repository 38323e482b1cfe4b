//! Which joints carry the bodies of a spatial mechanism, and which only close loops.
//!
//! A loop is cut where that costs the fewest rows: at the joint that leaves the most freedoms. Velocities of the tree are
//! then few as well.

use super::joints;
use crate::equations::couplings;
use crate::equations::spanning_tree::{Attachment, SpanningTree};
use crate::model::{BodyId, Frame, JointId, Mechanism, Rotor};
use crate::order::{Pattern, Strategy, order};
use std::collections::BTreeSet;

/// Whether the joint counts nothing, its freedoms, the depth it is reached at, its number.
type Key = (bool, usize, usize, usize);

/// From the ground, by Prim's algorithm: the joint that leaves the fewest freedoms next; of equals the one nearest to the
/// ground, then the one declared first. Joints whose angle is counted over its turns carry a body wherever they can.
/// `options { cut = … }` is obeyed.
pub fn fewest_freedoms(mechanism: &Mechanism) -> SpanningTree {
    let cut: BTreeSet<JointId> = mechanism.options.cut.iter().map(|(joint, _)| *joint).collect();
    let counted = counted(mechanism);
    let mut depth: Vec<Option<usize>> = vec![None; mechanism.bodies.len()];
    let mut attachments = Vec::new();
    let depth_of = |depth: &[Option<usize>], frame: Frame| match frame {
        Frame::Ground => Some(0),
        Frame::Body(body) => depth[body.0],
    };
    let is_particle = |frame: Frame| match frame {
        Frame::Ground => false,
        Frame::Body(body) => !mechanism.bodies[body.0].form.turns,
    };
    loop {
        let mut best: Option<(Key, JointId, BodyId, Frame)> = None;
        for (index, joint) in mechanism.joints.iter().enumerate() {
            let id = JointId(index);
            if cut.contains(&id) || !joint.holds() || joints::of(joint.form).motions.is_none() {
                continue;
            }
            for (near, far) in
                [(joint.first.frame, joint.second.frame), (joint.second.frame, joint.first.frame)]
            {
                let (Some(from), Frame::Body(child)) = (depth_of(&depth, near), far) else { continue };
                if depth[child.0].is_some() || is_particle(near) {
                    continue;
                }
                let key = (!counted.contains(&id), joint.form.freedoms, from, index);
                if best.as_ref().is_none_or(|(known, ..)| key < *known) {
                    best = Some((key, id, child, near));
                }
            }
        }
        match best {
            Some(((.., from, _), joint, body, parent)) => {
                depth[body.0] = Some(from + 1);
                attachments.push(Attachment { body, joint: Some((joint, parent)) });
            }
            // What no joint reaches: its first body is free, the rest hangs on it.
            None => {
                let Some(free) = depth.iter().position(Option::is_none) else {
                    return SpanningTree { attachments };
                };
                depth[free] = Some(0);
                attachments.push(Attachment { body: BodyId(free), joint: None });
            }
        }
    }
}

fn counted(mechanism: &Mechanism) -> BTreeSet<JointId> {
    let rotors = couplings::multi_turn_rotors(mechanism).into_iter();
    let joints = rotors.filter_map(|rotor| match rotor {
        Rotor::Joint(joint, _) => Some(joint),
        Rotor::Body(_) => None,
    });
    joints.collect()
}

/// Operations of the elimination in absolute coordinates, by the structure of M and D alone: without deriving them it is
/// known which velocities a row of a joint has.
pub fn absolute_operations(mechanism: &Mechanism) -> usize {
    const BODY: usize = 6;
    let n = BODY * mechanism.bodies.len();
    let mut entries = Vec::new();
    let mut rows = 0;
    for joint in mechanism.joints.iter().filter(|joint| joint.holds()) {
        // Components of a distance move with one linear velocity of each body and all angular ones; the rest is turned.
        let components = if joint.form.keeps_place { 3 } else { 0 };
        for row in 0..6 - joint.form.freedoms {
            for frame in [joint.first.frame, joint.second.frame] {
                let Frame::Body(body) = frame else { continue };
                let linear = if row < components { row..row + 1 } else { 0..3 };
                let columns = linear.chain(3..BODY).map(|k| (n + rows, BODY * body.0 + k));
                entries.extend(columns);
            }
            rows += 1;
        }
    }
    order(&Pattern::new(n, rows, entries), Strategy::MinimumDegree).operations
}
