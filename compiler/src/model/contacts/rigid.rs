//! Rigid contacts: nothing is in another, and what keeps it out is an impulse at a touch and a force at rest.
//!
//! Their force is the number that a gate otherwise is, along the gap: zero where they are open. What it is follows in the run from all
//! that touches (`simulation/rigid.rs` of the runtime).

use super::{Forces, Geometry, closing, product};
use crate::forms::ContactLaw;
use crate::messages;
use crate::model::lower::{Lowering, Use};
use crate::model::{Comparison, Condition, Expr, fold};
use crate::syntax::{self, ContactLawTerm, Entry, OptionEntry};
use crate::units::Dimension;

/// Whether `rigid(…)` is its law.
pub(super) fn is_rigid(contact: &syntax::Contact) -> bool {
    matches!(&contact.law, ContactLawTerm::Named(form, ..) if form.kind == ContactLaw::Rigid)
}

impl<'d> Lowering<'d> {
    /// What a rigid contact exerts along each of its gaps, and its restitution, within 0 to 1; none where it would part more slowly than `rest`.
    pub(super) fn rigid(&mut self, index: usize, geometry: &Geometry) -> Option<Forces> {
        let definition = self.definition;
        let contact = &definition.contacts[index];
        let ContactLawTerm::Named(_, named, region) = &contact.law else { return None };
        let Some(entry) = named.entry("restitution") else {
            self.diagnostics.error(*region, messages::rigid_without_restitution());
            return None;
        };
        let restitution = self.entry(entry, Dimension::ONE, Use::COEFFICIENT, "restitution")?;
        if let Some(e) = fold::evaluate(&restitution, self.defaults()).filter(|e| !(0.0..=1.0).contains(e)) {
            self.diagnostics.error(entry.value.region, messages::restitution_out_of_range(e));
            return None;
        }
        let rest = match named.entry("rest") {
            None => None,
            Some(entry) => Some(self.rest(entry, geometry.dimension.over(Dimension::TIME))?),
        };
        let of = |gap: &Expr| match &rest {
            None => restitution.clone(),
            Some(rest) => {
                let parts = product(restitution.clone(), closing(gap));
                let rests = Condition::Compare(Comparison::Less, parts, rest.clone());
                Expr::If(Box::new(rests), Box::new(Expr::Number(0.0)), Box::new(restitution.clone()))
            }
        };
        let restitutions = geometry.meetings.iter().map(|meeting| of(&meeting.gap)).collect();
        let load = self.load_of_contact(index);
        let gaps = 0..geometry.meetings.len();
        Some(Forces {
            along: gaps.clone().map(|which| Expr::Gate(load, which)).collect(),
            ungated: gaps.map(|_| Expr::Number(0.0)).collect(),
            adheres: false,
            elastic: None,
            restitutions,
        })
    }

    /// The speed of parting below which there is none.
    fn rest(&mut self, entry: &'d Entry, speed: Dimension) -> Option<Expr> {
        let rest = self.entry(entry, speed, Use::COEFFICIENT, "rest")?;
        if let Some(found) = fold::evaluate(&rest, self.defaults()).filter(|found| *found <= 0.0) {
            self.diagnostics.error(entry.value.region, messages::rest_not_positive(found));
            return None;
        }
        Some(rest)
    }

    pub(in crate::model) fn is_rigid_contact(&self, index: usize) -> bool {
        is_rigid(&self.definition.contacts[index])
    }

    /// What rigid contacts cannot be together with yet.
    pub(in crate::model) fn beside_rigid(&mut self) {
        let definition = self.definition;
        let Some(rigid) = definition.contacts.iter().find(|it| is_rigid(it)) else { return };
        let yielding = definition.contacts.iter().find(|it| !is_rigid(it)).map(|it| &it.name.text);
        for entry in &definition.options {
            match entry {
                OptionEntry::Contact(word) if word.text == "live" => {
                    self.diagnostics.error(word.region, messages::rigid_and_live(&rigid.name.text));
                }
                OptionEntry::Contact(word) => {
                    if let Some(other) = yielding {
                        self.diagnostics
                            .error(word.region, messages::rigid_and_held(&rigid.name.text, other));
                    }
                }
                OptionEntry::ExportC(scalar) => {
                    self.diagnostics.error(scalar.region, messages::rigid_in_c(&rigid.name.text));
                }
                _ => {}
            }
        }
    }
}
