//! Reactions of joints as quantities: `pin.reaction.x`, `rail.reaction.normal`, `pin.reaction.torque`.

use super::lower::Lowering;
use super::{JointId, ReactionPart};
use crate::forms::JointAxes;
use crate::messages;
use crate::syntax::{Path, Space};

impl Lowering<'_> {
    /// The part of a reaction that a path names.
    pub fn reaction(&mut self, joint: JointId, path: &Path) -> Option<ReactionPart> {
        let parts = self.parts_of_reaction(joint);
        let asked: Vec<&str> = path.parts[2..].iter().map(|part| part.text.as_str()).collect();
        let asked = asked.join(".");
        match parts.iter().find(|(name, _)| *name == asked) {
            Some((_, part)) => Some(*part),
            None => {
                let names: Vec<&str> = parts.iter().map(|(name, _)| *name).collect();
                let message = messages::parts_of_reaction(&path.parts[0].text, &names);
                self.diagnostics.error(path.region, message);
                None
            }
        }
    }

    /// What the reaction of a joint has, by name.
    fn parts_of_reaction(&self, joint: JointId) -> Vec<(&'static str, ReactionPart)> {
        let form = self.definition.joints[joint.0].form;
        let mut parts = vec![("x", ReactionPart::Force(0)), ("y", ReactionPart::Force(1))];
        match self.definition.space {
            Space::Planar => {
                if form.axes == JointAxes::OfFirst && form.travels.len() == 1 {
                    parts.push(("normal", ReactionPart::Normal));
                }
                parts.push(("torque", ReactionPart::Torque(2)));
            }
            Space::Spatial => parts.extend([
                ("z", ReactionPart::Force(2)),
                ("torque.x", ReactionPart::Torque(0)),
                ("torque.y", ReactionPart::Torque(1)),
                ("torque.z", ReactionPart::Torque(2)),
            ]),
        }
        parts.push(("size", ReactionPart::Size));
        parts
    }
}
