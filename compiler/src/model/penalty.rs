//! Joints that yield: which load acts in place of their rows, and whether it says what these rows need and nothing that they have no use for.

use super::lower::Lowering;
use super::{Expr, LoadId, Subject};
use crate::messages;
use crate::syntax;

impl<'d> Lowering<'d> {
    /// The load in place of a joint's rows: these loads stand behind those that are declared and contacts, in the order of their joints.
    pub(super) fn load_of_joint(&self, joint: &'d syntax::Joint) -> Option<LoadId> {
        joint.penalty.as_ref()?;
        let definition = self.definition;
        let before = definition.joints.iter().take_while(|other| !std::ptr::eq(*other, joint));
        let before = before.filter(|other| other.penalty.is_some()).count();
        Some(LoadId(definition.loads.len() + definition.contacts.len() + before))
    }

    /// What a penalty is for is written, and no more.
    pub(super) fn yields(
        &mut self,
        load: &'d syntax::Load,
        on: &[Subject],
        values: &mut [Vec<Expr>],
    ) -> Option<()> {
        let [Subject::Joint(id)] = on else { return Some(()) };
        let (joint, space) = (&self.definition.joints[id.0], self.definition.space);
        let (form, name) = (joint.form, joint.name.text.as_str());
        let (kind, at) = (form.call.word, joint.name.region);
        let errors = self.diagnostics.iter().count();
        if let Some(instead) = messages::load_instead_of_penalty(name, form) {
            self.diagnostics.error(at, instead);
            return None;
        }
        let written = |argument: &str| load.named.labels().find(|label| label.text == argument);
        for (holds, what, stiffness, damping) in [
            (form.holds_shifts(space), "shifts", "stiffness", "damping"),
            (form.holds_turns(), "turns", "torsional_stiffness", "torsional_damping"),
        ] {
            if !holds {
                for label in [stiffness, damping].iter().filter_map(|argument| written(argument)) {
                    self.diagnostics
                        .error(label.region, messages::penalty_without_use(&label.text, name, kind, what));
                }
            } else if written(stiffness).is_none() {
                self.diagnostics.error(at, messages::penalty_missing(stiffness, name, kind, what));
            }
        }
        let line = load.named.entry("damping_along");
        if let Some(entry) = line {
            self.word_of(entry, &["line"])?;
            if !form.keeps_place {
                self.diagnostics.error(entry.value.region, messages::penalty_has_no_line(name, kind));
            } else if written("damping").is_none() {
                self.diagnostics.error(entry.value.region, messages::penalty_line_of_nothing(name));
            } else if written("smallest").is_none() {
                self.diagnostics.error(entry.value.region, messages::penalty_without_smallest(name));
            }
        }
        if let (None, Some(label)) = (line, written("smallest")) {
            self.diagnostics.error(label.region, messages::penalty_smallest_of_nothing(name));
        }
        // What is not written has no value that could be judged.
        for (argument, value) in load.form.call.named.iter().zip(values) {
            if written(argument.name).is_none() {
                value.clear();
            }
        }
        (self.diagnostics.iter().count() == errors).then_some(())
    }
}
