//! Toothings in the braces of a part: a name, a kind and its numbers.

use super::definition::{Body, LineTerm, Named, Toothing};
use super::expression::is_call;
use super::parser::{Failed, Parsed, Parser};
use super::token::Cursor;
use crate::forms::{INVOLUTE, Rim};
use crate::messages;
use proc_macro2::Delimiter;

impl Parser<'_> {
    /// `rim: external(teeth = 20, module [mm] = 2);` after the word `toothing`.
    pub fn toothing(&mut self, c: &mut Cursor, body: &Body) -> Parsed<Toothing> {
        let word = c.previous();
        let name = self.declared(c, "the name of the toothing")?;
        if !body.form.turns {
            return self.fail(word, messages::toothing_of_particle(&body.name.text));
        }
        if !c.eat_punct(':') {
            return self.expected(c, "`:` and what the toothing is, such as `external(…);`");
        }
        let kind = self.word(c, "the kind of the toothing, such as `external`")?;
        let known = self.vocabulary.toothings;
        let Some(form) = known.iter().copied().find(|form| form.call.word == kind.text) else {
            let forms: Vec<_> = known.iter().map(|form| &form.call).collect();
            return self.fail(kind.region, messages::unknown_kind("toothing", &kind.text, &forms));
        };
        let mut inside = self.group(c, Delimiter::Parenthesis)?;
        let region = kind.region.to(c.previous());
        let is_rack = form.rim == Rim::Rack;
        let by_path = if is_rack { "line" } else { "at" };
        let (mut named, mut path) = (Named::default(), None);
        while !inside.is_done() {
            let label = self.word(&mut inside, "a named argument, such as `teeth = 20`")?;
            if let Some(first) = named.labels().find(|first| first.text == label.text) {
                let message = messages::property_twice(&label.text, &name.text);
                let note = messages::first_here(&label.text);
                self.diagnostics.conflict(label.region, message, first.region, note);
                return Err(Failed);
            }
            if label.text == by_path {
                if path.is_some() {
                    return self.fail(label.region, messages::property_twice(&label.text, &name.text));
                }
                self.punct(&mut inside, '=')?;
                let example = if is_rack {
                    "a line of the part, such as `bar.pitch`"
                } else {
                    "a point of the part, such as `shaft.seat`"
                };
                path = Some(self.path(&mut inside, example)?);
            } else if form.call.named.iter().any(|argument| argument.name == label.text) {
                let unit = self.unit(&mut inside)?;
                let entry = self.entry(&mut inside, unit)?;
                named.entries.push((label, entry));
            } else {
                let names: Vec<&str> =
                    form.call.named.iter().map(|argument| argument.name).chain([by_path]).collect();
                let message = messages::unknown_argument(form.call.word, &label.text, &names);
                return self.fail(label.region, message);
            }
            if !inside.is_done() && !inside.eat_punct(',') {
                return self.expected(&inside, "`,` or `)`");
            }
        }
        for argument in form.call.named.iter().filter(|argument| argument.is_required()) {
            if named.entry(argument.name).is_none() {
                let message = messages::missing_of_toothing(form.call.word, argument.name);
                return self.fail(region, message);
            }
        }
        if is_rack && path.is_none() {
            return self.fail(region, messages::rack_without_line(&body.name.text));
        }
        self.semicolon(c)?;
        let (at, line) = if is_rack { (None, path.map(LineTerm::Named)) } else { (path, None) };
        Ok(Toothing { name, form, named, at, line })
    }

    /// `= involute(…)`.
    pub fn at_involute(&self, c: &Cursor) -> bool {
        let mut ahead = c.clone();
        ahead.eat_punct('=') && ahead.at_word("involute") && is_call(&ahead)
    }

    /// `= involute(young [GPa] = 210, poisson = 0.3, tooth = profile, harmonics = 5, entry = 0.05)`.
    pub fn involute(&mut self, c: &mut Cursor) -> Parsed<Named> {
        self.punct(c, '=')?;
        let word = self.word(c, "`involute`")?;
        let mut inside = self.group(c, Delimiter::Parenthesis)?;
        let mut named = Named::default();
        while !inside.is_done() {
            let label = self.word(&mut inside, "a named argument, such as `young [GPa] = 210`")?;
            if !INVOLUTE.contains(&label.text.as_str()) {
                return self
                    .fail(label.region, messages::unknown_argument("involute", &label.text, &INVOLUTE));
            }
            if let Some(first) = named.labels().find(|first| first.text == label.text) {
                let message = messages::property_twice(&label.text, "involute");
                let note = messages::first_here(&label.text);
                self.diagnostics.conflict(label.region, message, first.region, note);
                return Err(Failed);
            }
            let unit = self.unit(&mut inside)?;
            let entry = self.entry(&mut inside, unit)?;
            named.entries.push((label, entry));
            if !inside.is_done() && !inside.eat_punct(',') {
                return self.expected(&inside, "`,` or `)`");
            }
        }
        if named.entry("young").is_none() {
            return self.fail(word.region, messages::involute_without_young());
        }
        Ok(named)
    }
}
