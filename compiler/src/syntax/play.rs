//! What has play is a contact: short forms, read as what they stand for.

use super::definition::{
    Contact, ContactLawTerm, ContactTerm, Entry, Label, Load, Operator, Path, RangeTerm, SubjectTerm,
    TermKind,
};
use super::expression::number;
use super::parser::{Failed, Parsed, Parser};
use crate::diagnostics::Lint;
use crate::messages;

/// The law that a torsion spring has at either end of its play.
const LAW: &str = "kelvin_voigt";

impl Parser<'_> {
    /// A torsion spring that turns freely within `play`, the whole gap about its angle at rest, is a `limit`: beyond it the spring and its damper
    /// push, and never pull, as a Kelvin–Voigt contact does.
    pub(super) fn spring_with_play(&mut self, load: Load, play: Entry) -> Parsed<()> {
        let Load { name, mut named, on, .. } = load;
        let Some(SubjectTerm::Name(on)) = on.into_iter().next() else { return Err(Failed) };
        let region = play.value.region;
        let nothing = match &play.value.kind {
            TermKind::Number { text, .. } => text.parse() == Ok(0.0),
            TermKind::Operation(Operator::Negate, _) => true,
            _ => false,
        };
        if nothing {
            return self.fail(region, messages::play_of_nothing(&name.text));
        }
        // A spring that is bent at the start is meant.
        self.definition.allowed.add(Lint::Penetration, name.region);
        let half = || play.clone().term().over(number(region, "2"));
        let at = named.entries.iter().position(|(label, _)| label.text == "angle");
        let middle = at.map(|at| named.entries.remove(at).1.term());
        let end = |half| match &middle {
            Some(middle) => middle.clone().plus(half),
            None => half,
        };
        let range = RangeTerm { unit: None, from: end(half().negated()), to: end(half()) };
        let quantity = Path::joined(vec![on.clone(), Label { text: "angle".to_string(), region: on.region }]);
        let law = self.vocabulary.contact_laws.iter().find(|law| law.call.word == LAW).ok_or(Failed)?;
        let law = ContactLawTerm::Named(law, named, name.region.to(region));
        let form = self.vocabulary.contact;
        self.definition.contacts.push(Contact { name, form, on: ContactTerm::Limit(quantity, range), law });
        Ok(())
    }
}
