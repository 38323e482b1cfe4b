//! What has play is a contact: short forms, read as what they stand for.

use super::definition::{
    Contact, ContactLawTerm, ContactTerm, Entry, FirstTerm, Joint, Label, Load, Named, Operator, Path,
    RangeTerm, SubjectTerm, Surface, TermKind,
};
use super::expression::number;
use super::parser::{Failed, Parsed, Parser};
use super::token::Cursor;
use crate::diagnostics::Lint;
use crate::forms::LOOSE;
use crate::messages;
use proc_macro2::Delimiter;

/// The law that a torsion spring has at either end of its play.
const LAW: &str = "kelvin_voigt";

impl Parser<'_> {
    /// A joint with play: what its places have about them, one in the other, and a contact of the joint's name between both.
    pub(super) fn loose_joint(&mut self, c: &mut Cursor, name: Label) -> Parsed<()> {
        let (space, kind) = (self.definition.space, c.word().unwrap_or_default().to_string());
        let joint = (self.vocabulary.joints)(space).into_iter().find(|it| it.call.word == kind);
        let form = LOOSE.iter().find(|it| it.space == space && it.call.word == kind);
        let (Some(joint), Some(form)) = (joint, form) else {
            return self.fail(c.region(), messages::play_of_joint(&kind, space));
        };
        let (_, mut arguments) = self.call_of(c, &[&form.call], "joint")?;
        let (play, radius) = (arguments.required("play")?, arguments.required("radius")?);
        let (first, second) = (arguments.place()?, arguments.place()?);
        let within = Entry::bare(radius.clone().term().plus(play.term().negated()));
        let names = ["hole", "pin"].map(|own| format!("{}.{own}", name.text));
        let each = form.surfaces.into_iter().zip([(&first, radius), (&second, within)]);
        for ((word, (place, radius)), text) in each.zip(&names) {
            let form = self.vocabulary.surfaces.iter().find(|it| it.call.word == word).ok_or(Failed)?;
            let label = |text: &str| Label { text: text.to_string(), region: name.region };
            let named = Named { entries: vec![(label("radius"), radius)], ..Named::default() };
            let places = vec![place.clone()];
            self.definition.surfaces.push(Surface { name: label(text), form, places, line: None, named });
        }
        let [hole, pin] = names.map(|text| {
            let parts = vec![Label { text: text.clone(), region: name.region }];
            Path { text, parts, region: name.region }
        });
        self.contact_law(c, name.clone(), ContactTerm::Between(pin, hole))?;
        let contact = self.definition.contacts.last_mut().ok_or(Failed)?;
        contact.of_joint = true;
        let (first, named) = (FirstTerm::Place(first), Named::default());
        self.definition.joints.push(Joint {
            name,
            form: joint,
            first,
            second,
            named,
            penalty: None,
            loose: true,
        });
        Ok(())
    }

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
        let on = ContactTerm::Limit(quantity, range);
        self.definition.contacts.push(Contact { name, form, on, law, of_joint: false });
        Ok(())
    }
}

/// Whether a joint's arguments have play.
pub(super) fn has_play(c: &Cursor) -> bool {
    let mut ahead = c.clone();
    ahead.advance();
    let Some(mut inside) = ahead.inside(Delimiter::Parenthesis) else { return false };
    while !inside.is_done() {
        // Behind a comma, so that it is no part of a place's name.
        if inside.eat_punct(',') && inside.at_word("play") {
            return true;
        }
        inside.advance();
    }
    false
}
