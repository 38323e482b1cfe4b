//! `friction name: on(joint) = coulomb(…);`: a load whose law is a word with arguments.

use super::definition::{LawTerm, Load, OptionEntry, SubjectTerm};
use super::expression::is_call;
use super::parser::{Parsed, Parser};
use super::token::Cursor;
use crate::forms::{Form, LoadForm};
use crate::messages;
use proc_macro2::Delimiter;

/// Each pass doubles the digits that are right.
const MOST_PASSES: usize = 8;

impl Parser<'_> {
    /// After the word `friction`.
    pub fn friction(&mut self, c: &mut Cursor) -> Parsed<()> {
        let name = self.declared(c, "the name of the friction")?;
        let name = self.own(name);
        self.punct(c, ':')?;
        if !(c.at_word("on") && is_call(c)) {
            return self.advised(c, "`on(joint)`", &messages::friction_without_joint());
        }
        c.advance();
        let mut inside = self.group(c, Delimiter::Parenthesis)?;
        if inside.is_done() {
            return self.advised(&inside, "the name of a joint", &messages::friction_without_joint());
        }
        let on = self.label(&mut inside, "the name of a joint")?;
        if inside.at_punct('.') {
            return self.advised(&inside, "`)`", messages::names_without_point());
        }
        self.end(&inside, "`)` after the name of a joint")?;
        self.punct(c, '=')?;
        let laws: Vec<&LoadForm> = self.laws_of_friction().collect();
        let calls: Vec<&Form> = laws.iter().map(|law| &law.call).collect();
        let (which, arguments) = self.call_of(c, &calls, "law of friction")?;
        self.semicolon(c)?;
        self.definition.loads.push(Load {
            name,
            form: laws[which],
            on: vec![SubjectTerm::Name(on)],
            named: arguments.named,
            law: LawTerm::None,
        });
        Ok(())
    }

    /// A whole number from one on.
    pub fn friction_passes(&mut self, c: &mut Cursor) -> Parsed<OptionEntry> {
        let written = self.expression(c)?;
        let passes = self.integer(&written)?;
        match usize::try_from(passes) {
            Ok(passes) if (1..=MOST_PASSES).contains(&passes) => {
                Ok(OptionEntry::FrictionPasses(passes, written.region))
            }
            _ => self.fail(written.region, messages::passes_of_friction(passes, MOST_PASSES)),
        }
    }

    /// The laws that friction follows.
    pub fn laws_of_friction(&self) -> impl Iterator<Item = &'static LoadForm> + use<> {
        (self.vocabulary.loads)(self.definition.space).into_iter().filter(|load| load.rubs)
    }
}
