//! Surfaces, materials, contacts and limits. What a surface is and which pairs touch is left to `model`.

use super::definition::{Contact, ContactLawTerm, ContactTerm, Label, Material, Path, Surface, Term};
use super::expression::is_call;
use super::pairs::eat_each;
use super::parser::{Failed, Parsed, Parser};
use super::token::Cursor;
use crate::forms::Form;
use crate::messages;
use proc_macro2::Delimiter;

/// What a material says.
const PROPERTIES: [&str; 2] = ["modulus", "poisson"];

impl Parser<'_> {
    /// `name: kind(…);` after the word `surface`; within a body its name stands in front.
    pub fn surface(&mut self, c: &mut Cursor, body: Option<&Label>) -> Parsed<Surface> {
        let name = self.declared(c, "the name of the surface")?;
        let name = match body {
            Some(body) => Label { text: format!("{}.{}", body.text, name.text), region: name.region },
            None => self.own(name),
        };
        self.punct(c, ':')?;
        let (space, known) = (self.definition.space, self.vocabulary.surfaces);
        let here: Vec<_> = known.iter().filter(|it| it.only.is_none_or(|only| only == space)).collect();
        if let Some(word) = c.word()
            && let Some(other) =
                known.iter().find(|it| it.call.word == word && it.only.is_some_and(|it| it != space))
        {
            let words: Vec<&str> = here.iter().map(|it| it.call.word).collect();
            return self.fail(c.region(), messages::surface_of_other_space(other.call.word, space, &words));
        }
        let forms: Vec<&Form> = here.iter().map(|it| &it.call).collect();
        let (which, mut arguments) = self.call_of(c, &forms, "surface")?;
        self.semicolon(c)?;
        let (line, form) = (arguments.lines.pop(), here[which]);
        Ok(Surface { name, form, places: arguments.places, line, named: arguments.named })
    }

    /// `name { modulus [Pa] = 207e9; poisson = 0.3; }`
    pub fn material(&mut self, c: &mut Cursor) -> Parsed<()> {
        let name = self.declared(c, "the name of the material")?;
        let name = self.own(name);
        let mut inside = self.group(c, Delimiter::Brace)?;
        let mut entries: Vec<(Label, _)> = Vec::new();
        while !inside.is_done() {
            let label = self.word(&mut inside, "`modulus` or `poisson`")?;
            if !PROPERTIES.contains(&label.text.as_str()) {
                return self
                    .fail(label.region, messages::unknown_argument("material", &label.text, &PROPERTIES));
            }
            if let Some((first, _)) = entries.iter().find(|(known, _)| known.text == label.text) {
                let message = messages::property_twice(&label.text, &name.text);
                let note = messages::first_here(&label.text);
                self.diagnostics.conflict(label.region, message, first.region, note);
                return Err(Failed);
            }
            let unit = self.unit(&mut inside)?;
            let entry = self.entry(&mut inside, unit)?;
            self.semicolon(&mut inside)?;
            entries.push((label, entry));
        }
        for property in PROPERTIES {
            if entries.iter().all(|(label, _)| label.text != property) {
                return self.fail(name.region, messages::material_without(&name.text, property));
            }
        }
        self.definition.materials.push(Material { name, entries });
        Ok(())
    }

    /// `between(surface, surface) = law;` or `gap(expression, slip = expression) = law;`
    pub(super) fn contact_of(&mut self, c: &mut Cursor, name: Label) -> Parsed<()> {
        let what = "`between(surface, surface)` or `gap(expression)`";
        let kind = self.word(c, what)?;
        if !matches!(kind.text.as_str(), "between" | "gap") {
            return self.fail(kind.region, messages::unknown_contact(&kind.text));
        }
        let mut inside = self.group(c, Delimiter::Parenthesis)?;
        let on = if kind.text == "between" {
            eat_each(&mut inside);
            let first = self.path(&mut inside, "the name of a surface")?;
            self.punct(&mut inside, ',')?;
            eat_each(&mut inside);
            ContactTerm::Between(first, self.path(&mut inside, "the name of another surface")?)
        } else {
            let gap = self.expression(&mut inside)?;
            let mut slip = None;
            if inside.eat_punct(',') && !inside.is_done() {
                let label = self.word(&mut inside, "`slip = expression`")?;
                if label.text != "slip" {
                    return self
                        .fail(label.region, messages::unknown_argument("gap", &label.text, &["slip"]));
                }
                let unit = self.unit(&mut inside)?;
                slip = Some(self.entry(&mut inside, unit)?);
            }
            ContactTerm::Gap(gap, slip)
        };
        inside.eat_punct(',');
        self.end(&inside, "`)`")?;
        self.contact_law(c, name, on)
    }

    /// `name: quantity [unit] in from..to = law;` after the word `limit`.
    pub fn limit(&mut self, c: &mut Cursor) -> Parsed<()> {
        let name = self.declared(c, "the name of the limit")?;
        let name = self.own(name);
        self.punct(c, ':')?;
        let (quantity, range) = self.quantity_in_range(c)?;
        self.contact_law(c, name, ContactTerm::Limit(quantity, range))
    }

    /// `(touch) >= 1e-3 [s]` after the word `contact_time` or `friction_time`.
    pub fn time_of(&mut self, c: &mut Cursor, word: &str, of: &str) -> Parsed<(Path, Term)> {
        let mut inside = self.group(c, Delimiter::Parenthesis)?;
        let load = self.path(&mut inside, &format!("the name of a {of}"))?;
        self.end(&inside, "`)`")?;
        if !c.at_puncts('>', '=') {
            return self
                .expected(c, &format!("`>=` and a time, such as `{word}({}) >= 1e-3 [s]`", load.text));
        }
        c.advance();
        c.advance();
        Ok((load, self.expression(c)?))
    }

    pub(super) fn contact_law(&mut self, c: &mut Cursor, name: Label, on: ContactTerm) -> Parsed<()> {
        if !c.eat_punct('=') {
            return self.expected(c, "`=` and the law of the contact, such as `kelvin_voigt(…)`");
        }
        let laws = self.vocabulary.contact_laws;
        let known = c.word().is_some_and(|word| laws.iter().any(|law| law.call.word == word)) && is_call(c);
        let law = if known {
            let forms: Vec<&Form> = laws.iter().map(|law| &law.call).collect();
            let start = c.region();
            let (which, mut arguments) = self.call_of(c, &forms, "law")?;
            self.remember_touches(&name, &mut arguments.named);
            ContactLawTerm::Named(&laws[which], arguments.named, start.to(c.previous()))
        } else if is_call_by_names(c) {
            let word = c.word().unwrap_or_default();
            let forms: Vec<&Form> = laws.iter().map(|law| &law.call).collect();
            let message = match word == self.vocabulary.penalty.call.word {
                true => messages::contact_by_penalty(&name.text, &forms),
                false => messages::unknown_kind("law of a contact", word, &forms),
            };
            return self.fail(c.region(), message);
        } else {
            ContactLawTerm::Expression(self.expression(c)?)
        };
        self.semicolon(c)?;
        let form = self.vocabulary.contact;
        self.definition.contacts.push(Contact { name, form, on, law, of_joint: false });
        Ok(())
    }
}

/// Whether a call gives its first argument by a name, as laws do and functions do not.
fn is_call_by_names(c: &Cursor) -> bool {
    let mut ahead = c.clone();
    ahead.advance();
    let Some(mut inside) = ahead.inside(Delimiter::Parenthesis).filter(|_| is_call(c)) else { return false };
    inside.word().is_some() && {
        inside.advance();
        while inside.enter(Delimiter::Bracket).is_some() {}
        inside.at_punct('=') && !inside.at_puncts('=', '=')
    }
}
