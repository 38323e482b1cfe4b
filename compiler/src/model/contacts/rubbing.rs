//! What slides in a contact, as far as it is known, and what friction asks of it.

use super::spots::Pair;
use crate::messages;
use crate::model::lower::{Lowering, Use};
use crate::model::{Expr, Load, LoadId, Sliding, Space, Subject};
use crate::syntax::{ContactTerm, Entry, Label};
use crate::units::Dimension;
use std::rc::Rc;

/// What slides in a contact.
#[derive(Clone)]
pub(super) enum Slides {
    /// Nothing that is known.
    Nowhere,
    Surfaces(Rc<Pair>),
    /// An expression of positions, m.
    Along(Expr),
}

impl<'d> Lowering<'d> {
    /// `slip = expression` of a gap.
    pub(super) fn slip(&mut self, slip: Option<&'d Entry>, gap: Dimension) -> Option<Slides> {
        let Some(entry) = slip else { return Some(Slides::Nowhere) };
        if !gap.fits(Dimension::LENGTH) {
            self.diagnostics.error(entry.value.region, messages::slip_of_no_length());
            return None;
        }
        let along = self.entry(entry, Dimension::LENGTH, Use::ALONG, "slip")?;
        let mut moves = false;
        along.quantities(&mut |_| moves = true);
        if !moves {
            self.diagnostics.error(entry.value.region, messages::slip_that_stands());
            return None;
        }
        Some(Slides::Along(along))
    }

    /// Whether its sliding has components.
    pub(in crate::model) fn slides_in_space(&self, index: usize) -> bool {
        let surfaces = matches!(self.definition.contacts[index].on, ContactTerm::Between(..));
        surfaces && self.definition.space == Space::Spatial
    }

    /// A contact whose surfaces slide on each other.
    pub(in crate::model) fn touching(&mut self, index: usize, label: &Label) -> Option<Subject> {
        self.geometry(index)?;
        let limits = matches!(self.definition.contacts[index].on, ContactTerm::Limit(..));
        if self.sliding(index).is_none() {
            self.diagnostics.error(label.region, messages::friction_without_slip(&label.text, limits));
            return None;
        }
        Some(Subject::Touches(self.load_of_contact(index)))
    }

    /// Where its gaps close, and what slides there, if that is known.
    pub(super) fn sliding(&mut self, index: usize) -> Option<&[Sliding]> {
        if self.contacts.slides[index].is_none() {
            let geometry = self.geometry(index)?;
            let slides = match geometry.slides {
                Slides::Nowhere => None,
                Slides::Along(slip) => Some(vec![Sliding::Along(slip)]),
                Slides::Surfaces(pair) => {
                    let spots = pair.spots(&geometry.meetings, self.definition.space)?;
                    Some(spots.into_iter().map(|spot| Sliding::Surfaces(Box::new(spot))).collect())
                }
            };
            self.contacts.slides[index] = slides;
        }
        self.contacts.slides[index].as_deref()
    }

    /// Contacts come behind the other loads.
    pub(in crate::model) fn load_of_contact(&self, index: usize) -> LoadId {
        LoadId(self.definition.loads.len() + index)
    }

    /// Gives contacts what slides in them, where something asked for it.
    pub(in crate::model) fn slides(&mut self, loads: &mut [Load]) {
        let contacts = loads.iter_mut().filter(|load| load.is_contact());
        for (load, slides) in contacts.zip(std::mem::take(&mut self.contacts.slides)) {
            load.slides = slides.unwrap_or_default();
        }
    }
}
