//! Joints, constraints and loads: a name, a colon, a kind with places and named arguments.
//!
//! A table says which arguments each kind takes; what the places are is left to `model`.

use super::definition::{
    Constraint, ConstraintTerm, Entry, FirstTerm, Joint, Label, LawTerm, LineTerm, Load, Named, Operator,
    PlaceTerm, Space, SubjectTerm, Term, TermKind, Tuple,
};
use super::expression::{is_call, number};
use super::parser::{Failed, Parsed, Parser};
use super::play::has_play;
use super::token::Cursor;
use crate::diagnostics::Region;
use crate::forms::{
    Acts, Argument, CouplingForm, Factor, Form, Law, LoadForm, Means, Positional, Value, Written,
};
use crate::messages::{self, Habit};
use proc_macro2::Delimiter;

/// The arguments of one call.
#[derive(Default)]
pub(super) struct Arguments {
    pub places: Vec<PlaceTerm>,
    pub lines: Vec<LineTerm>,
    rotors: Vec<Label>,
    expressions: Vec<Term>,
    pub named: Named,
}

impl Arguments {
    pub(super) fn place(&mut self) -> Parsed<PlaceTerm> {
        if self.places.is_empty() { Err(Failed) } else { Ok(self.places.remove(0)) }
    }

    fn rotor(&mut self) -> Parsed<Label> {
        if self.rotors.is_empty() { Err(Failed) } else { Ok(self.rotors.remove(0)) }
    }

    fn expression(&mut self) -> Parsed<Term> {
        if self.expressions.is_empty() { Err(Failed) } else { Ok(self.expressions.remove(0)) }
    }

    fn entry(&mut self, name: &str) -> Option<Entry> {
        let index = self.named.entries.iter().position(|(label, _)| label.text == name)?;
        Some(self.named.entries.remove(index).1)
    }

    pub(super) fn required(&mut self, name: &str) -> Parsed<Entry> {
        self.entry(name).ok_or(Failed)
    }

    /// The unnamed arguments, in the order of the form.
    fn subjects(&mut self, form: &Form) -> Parsed<Vec<SubjectTerm>> {
        let mut subjects = Vec::new();
        for positional in form.positional {
            match positional {
                Positional::Place | Positional::Toothing => {
                    subjects.push(SubjectTerm::Place(self.place()?));
                }
                Positional::Places => subjects.extend(self.places.drain(..).map(SubjectTerm::Place)),
                Positional::Rotor => subjects.push(SubjectTerm::Name(self.rotor()?)),
                Positional::Expression => subjects.push(SubjectTerm::Expression(self.expression()?)),
                Positional::Line => return Err(Failed),
            }
        }
        Ok(subjects)
    }

    /// The factor of a proportion; what is made of arguments is as if written at `region`.
    fn factor(&mut self, factor: Factor, region: Region) -> Parsed<Entry> {
        Ok(match factor {
            Factor::Argument(name) => self.required(name)?,
            Factor::Quotient { of, to } => {
                let (of, to) = (self.required(of)?, self.required(to)?);
                Entry::bare(of.term().over(to.term()))
            }
            Factor::PerTurn(name) => {
                let turn = number(region, "2").times(Term::name(region, "pi"));
                Entry::bare(self.required(name)?.term().over(turn))
            }
        })
    }

    fn has_tuple(&self, name: &str) -> bool {
        self.named.tuple(name).is_some()
    }
}

/// The angle of what is named.
fn angle_of(subject: &SubjectTerm) -> Parsed<Term> {
    let label = name_of(subject).ok_or(Failed)?;
    Ok(Term::name(label.region, &format!("{}.angle", label.text)))
}

/// A name without a point, where that is written.
fn name_of(subject: &SubjectTerm) -> Option<&Label> {
    match subject {
        SubjectTerm::Name(label) => Some(label),
        SubjectTerm::Place(PlaceTerm::Named(path)) => path.parts.first().filter(|_| path.parts.len() == 1),
        SubjectTerm::Place(PlaceTerm::Ground(_)) | SubjectTerm::Expression(_) => None,
    }
}

impl Parser<'_> {
    /// `name: kind(…);` after the word `joint`.
    pub fn joint(&mut self, c: &mut Cursor) -> Parsed<()> {
        let name = self.declared(c, "the name of the joint")?;
        let name = self.own(name);
        if !c.eat_punct(':') {
            return self.expected(c, "`:` and what the joint is, such as `revolute(…);`");
        }
        if has_play(c) {
            return self.loose_joint(c, name);
        }
        let joints = (self.vocabulary.joints)(self.definition.space);
        let forms: Vec<&Form> = joints.iter().map(|joint| &joint.call).collect();
        let (which, mut arguments) = self.call_of(c, &forms, "joint")?;
        let penalty = self.penalty(c, &name)?;
        self.semicolon(c)?;
        let first = match arguments.lines.pop() {
            Some(line) => FirstTerm::Line(line),
            None => FirstTerm::Place(arguments.place()?),
        };
        let second = arguments.place()?;
        self.definition.joints.push(Joint {
            name,
            form: joints[which],
            first,
            second,
            named: arguments.named,
            penalty,
            loose: false,
        });
        Ok(())
    }

    /// `= penalty(…)` behind a joint, if it is there.
    fn penalty(&mut self, c: &mut Cursor, joint: &Label) -> Parsed<Option<Load>> {
        if !c.eat_punct('=') {
            return Ok(None);
        }
        let form = self.vocabulary.penalty;
        if !c.at_word(form.call.word) {
            return self.fail(c.region(), messages::law_of_joint());
        }
        let (_, arguments) = self.call_of(c, &[&form.call], "law of a joint")?;
        let (name, on) = (joint.clone(), vec![SubjectTerm::Name(joint.clone())]);
        Ok(Some(Load { name, form, on, named: arguments.named, law: LawTerm::None }))
    }

    /// `name: gear(…);`, `name: rack(…);` or `name: left = right;` after the word `constraint`.
    pub fn constraint(&mut self, c: &mut Cursor) -> Parsed<()> {
        let name = self.declared(c, "the name of the constraint")?;
        let name = self.own(name);
        self.punct(c, ':')?;
        if c.word().is_some_and(|word| self.words_of_couplings().contains(&word)) && is_call(c) {
            return self.coupling_call(c, name);
        }
        let left = self.expression(c)?;
        if !c.eat_punct('=') {
            let what = "`=` between the two sides of the constraint";
            return match left.kind {
                TermKind::Operation(Operator::Equal, _) => {
                    self.advised(c, what, &Habit::EqualsTwice.advice())
                }
                _ => self.expected(c, what),
            };
        }
        let right = self.expression(c)?;
        self.semicolon(c)?;
        self.definition.constraints.push(Constraint { name, kind: ConstraintTerm::Equation { left, right } });
        Ok(())
    }

    /// `name: gear(…);` after the word of the coupling.
    pub fn coupling(&mut self, c: &mut Cursor, word: &str) -> Parsed<()> {
        let name = self.declared(c, "the name of the constraint")?;
        let name = self.own(name);
        self.punct(c, ':')?;
        if !c.at_word(word) {
            return self.expected(c, &format!("`{word}(…)`"));
        }
        self.coupling_call(c, name)
    }

    fn coupling_call(&mut self, c: &mut Cursor, name: Label) -> Parsed<()> {
        let toothed = names_toothing(c);
        let couplings = self.vocabulary.couplings;
        let is_of_teeth = |coupling: &&&CouplingForm| matches!(coupling.means, Means::Teeth { .. });
        let only = |coupling: &&&CouplingForm| {
            couplings.iter().filter(|other| other.call.word == coupling.call.word).count() == 1
        };
        let couplings: Vec<&CouplingForm> =
            couplings.iter().filter(|it| is_of_teeth(it) == toothed || only(it)).copied().collect();
        let forms: Vec<&Form> = couplings.iter().map(|coupling| &coupling.call).collect();
        let (which, mut arguments) = self.call_of(c, &forms, "constraint")?;
        let form = couplings[which];
        let region = name.region.to(c.previous());
        self.semicolon(c)?;
        let on = arguments.subjects(&form.call)?;
        let kind = match form.means {
            Means::Proportion { kind, factor } => {
                let factor = arguments.factor(factor, region)?;
                ConstraintTerm::Coupling { form, kind, on, factor, phase: arguments.entry("phase") }
            }
            Means::Sum { of: [one, other], times, by } => {
                let (by, one, other) = (angle_of(&on[by])?, angle_of(&on[one])?, angle_of(&on[other])?);
                ConstraintTerm::Equation { left: one.plus(other), right: number(region, times).times(by) }
            }
            Means::Teeth { .. } => ConstraintTerm::Teeth { form, on },
        };
        self.definition.constraints.push(Constraint { name, kind });
        Ok(())
    }

    /// The words of couplings, each of which begins a statement.
    pub fn words_of_couplings(&self) -> Vec<&'static str> {
        let mut words: Vec<&str> =
            self.vocabulary.couplings.iter().map(|coupling| coupling.call.word).collect();
        words.dedup();
        words
    }

    /// How loads are written, each word once.
    fn calls_of_loads(&self) -> Vec<&'static Form> {
        let mut calls: Vec<&Form> = Vec::new();
        for load in (self.vocabulary.loads)(self.definition.space).into_iter().filter(|load| !load.rubs) {
            if calls.iter().all(|call| call.word != load.call.word) {
                calls.push(&load.call);
            }
        }
        calls
    }

    /// The words of loads, each of which begins a statement.
    pub fn words_of_loads(&self) -> Vec<&'static str> {
        self.calls_of_loads().into_iter().map(|call| call.word).collect()
    }

    /// `name: kind(…) = law;` after `force` or the load's own word.
    pub fn load(&mut self, c: &mut Cursor, word: &str) -> Parsed<()> {
        let name = self.declared(c, "the name of the load")?;
        let name = self.own(name);
        self.punct(c, ':')?;
        let at = c.region();
        let loads = (self.vocabulary.loads)(self.definition.space);
        let forms = self.calls_of_loads();
        let (which, mut arguments) = self.call_of(c, &forms, "load")?;
        let call = forms[which];
        // What it acts along may be an angle.
        let along =
            |load: &&LoadForm| load.acts().take(1).any(|acts| matches!(acts, Acts::Way | Acts::Expression));
        let turns = loads.iter().filter(|load| load.call.word == call.word).any(along);
        if word != "force" && word != call.word && !(word == "torque" && turns) {
            return self.fail(at, messages::other_load(word, call.word));
        }
        let mut of_word = loads.into_iter().filter(|load| load.call.word == call.word);
        let has_law = of_word.clone().any(|load| load.law != Law::None);
        if has_law && !c.eat_punct('=') {
            return self.expected(c, &format!("`=` and the law of the {}", call.word));
        }
        if !has_law && c.at_punct('=') {
            return self.fail(c.region(), messages::load_without_law(call.word));
        }
        let mut on = arguments.subjects(call)?;
        let written = Written {
            is_name: on.first().is_some_and(|subject| name_of(subject).is_some()),
            is_directed: call.named.iter().any(|it| it.is_direction() && arguments.has_tuple(it.name)),
            has_components: c.inside(Delimiter::Parenthesis).is_some_and(|inside| inside.has_comma()),
        };
        let meant = of_word.clone().find(|load| load.meant.is_some_and(|meant| meant(&written)));
        let Some(form) = meant.or_else(|| of_word.find(|load| load.meant.is_none())) else {
            return Err(Failed);
        };
        for (subject, acts) in on.iter_mut().zip(form.acts()) {
            if let (false, Some(name)) = (acts == Acts::Place, name_of(subject).cloned()) {
                *subject = SubjectTerm::Name(name);
            }
        }
        let law = match form.law {
            Law::None => LawTerm::None,
            Law::Value(_) | Law::Conjugate => LawTerm::Value(self.expression(c)?),
            Law::Components(_) if written.is_directed && written.has_components => {
                return self.fail(c.region(), messages::direction_and_components());
            }
            Law::Components(_) if written.is_directed => LawTerm::Value(self.expression(c)?),
            Law::Components(_) => LawTerm::Components(self.components(c)?),
        };
        self.semicolon(c)?;
        let play = arguments.entry("play");
        let load = Load { name, form, on, named: arguments.named, law };
        if let Some(play) = play {
            return self.spring_with_play(load, play);
        }
        self.definition.loads.push(load);
        Ok(())
    }

    /// `(fx, fy)`, the law of a force without a direction.
    fn components(&mut self, c: &mut Cursor) -> Parsed<Tuple> {
        match c.inside(Delimiter::Parenthesis) {
            Some(inside) if inside.has_comma() => self.vector(c, None),
            _ => self.fail(c.region(), messages::force_without_direction(self.definition.space)),
        }
    }

    /// Which of `forms`, and its arguments, complete.
    pub(super) fn call_of(
        &mut self,
        c: &mut Cursor,
        forms: &[&Form],
        what: &str,
    ) -> Parsed<(usize, Arguments)> {
        let words: Vec<&str> = forms.iter().map(|form| form.word).collect();
        let kind = self.word(c, &format!("the kind of the {what} ({})", words.join(", ")))?;
        let Some(which) = forms.iter().position(|form| form.word == kind.text) else {
            let message = if what == "joint" {
                let there = match self.definition.space {
                    Space::Planar => (self.vocabulary.joints)(Space::Spatial),
                    Space::Spatial => (self.vocabulary.joints)(Space::Planar),
                };
                let there: Vec<&Form> = there.iter().map(|joint| &joint.call).collect();
                messages::unknown_joint(&kind.text, forms, &there, self.definition.space)
            } else {
                messages::unknown_kind(what, &kind.text, forms)
            };
            return self.fail(kind.region, message);
        };
        let form = forms[which];
        let mut inside = self.group(c, Delimiter::Parenthesis)?;
        let region = kind.region.to(c.previous());
        let mut arguments = Arguments::default();
        for (index, positional) in form.positional.iter().enumerate() {
            self.positional(&mut inside, form, index, *positional, region, &mut arguments)?;
        }
        while !inside.is_done() {
            self.named(&mut inside, form, &mut arguments)?;
        }
        for Argument { name, .. } in form.named.iter().filter(|argument| argument.is_required()) {
            if arguments.named.labels().all(|label| label.text != *name) {
                return self.fail(region, messages::missing_argument(form.word, name, self.definition.space));
            }
        }
        Ok((which, arguments))
    }

    fn positional(
        &mut self,
        c: &mut Cursor,
        form: &Form,
        index: usize,
        kind: Positional,
        region: Region,
        arguments: &mut Arguments,
    ) -> Parsed<()> {
        let is_named = |c: &Cursor| {
            let mut ahead = c.clone();
            ahead.advance();
            while ahead.enter(Delimiter::Bracket).is_some() {}
            ahead.at_punct('=')
        };
        if kind == Positional::Places {
            while !c.is_done() && !is_named(c) {
                arguments.places.push(self.place(c)?);
                self.argument_end(c)?;
            }
            return Ok(());
        }
        // An expression may be a comparison, which `model` refuses.
        if c.is_done() || kind != Positional::Expression && is_named(c) {
            let count = form.positional.iter().filter(|it| **it != Positional::Places).count();
            let is_place = kind == Positional::Place;
            let loads = (self.vocabulary.loads)(self.definition.space);
            let load = loads.into_iter().find(|load| std::ptr::eq(&load.call, form));
            let instead = load.and_then(|load| load.instead);
            return self.fail(region, messages::missing_place(form.word, count, index, is_place, instead));
        }
        match kind {
            Positional::Place => arguments.places.push(self.place(c)?),
            // Read above.
            Positional::Places => {}
            Positional::Toothing => {
                let path = self.path(c, "a toothing, such as `sun.rim`")?;
                arguments.places.push(PlaceTerm::Named(path));
            }
            Positional::Line => arguments.lines.push(self.line_argument(c)?),
            Positional::Expression => arguments.expressions.push(self.expression(c)?),
            Positional::Rotor => {
                arguments.rotors.push(self.label(c, "the name of a joint or body")?);
                if c.at_punct('.') {
                    let mut couplings = self.vocabulary.couplings.iter();
                    let of_teeth = |it: &&CouplingForm| matches!(it.means, Means::Teeth { .. });
                    let advice = match couplings.any(|it| it.call.word == form.word && of_teeth(it)) {
                        true => messages::names_without_point_or_ratio(),
                        false => messages::names_without_point(),
                    };
                    return self.advised(c, "`,` or `)`", advice);
                }
            }
        }
        if c.is_done() { Ok(()) } else { self.argument_end(c) }
    }

    /// `,` between arguments.
    fn argument_end(&mut self, c: &mut Cursor) -> Parsed<()> {
        if c.is_done() || c.eat_punct(',') { Ok(()) } else { self.expected(c, "`,` or `)`") }
    }

    /// `guide.slot` or `line(from, to)`.
    fn line_argument(&mut self, c: &mut Cursor) -> Parsed<LineTerm> {
        if c.at_word("ground") && is_call(c) {
            return self.fail(c.region(), messages::place_for_line());
        }
        if !(c.at_word("line") && is_call(c)) {
            return Ok(LineTerm::Named(self.path(c, "a line")?));
        }
        let start = c.region();
        c.advance();
        let mut inside = self.group(c, Delimiter::Parenthesis)?;
        let region = start.to(c.previous());
        let from = self.place(&mut inside)?;
        self.punct(&mut inside, ',')?;
        let to = self.place(&mut inside)?;
        inside.eat_punct(',');
        self.end(&inside, "`)` after two places")?;
        Ok(LineTerm::Inline { from, to, region })
    }

    /// `name [unit] = value`.
    fn named(&mut self, c: &mut Cursor, form: &Form, arguments: &mut Arguments) -> Parsed<()> {
        if c.word().is_none() {
            let names: Vec<&str> = form.named.iter().map(|argument| argument.name).collect();
            return self.advised(c, "a named argument", &messages::named_arguments(&names));
        }
        let label = self.word(c, "a named argument")?;
        let Some(argument) = form.named.iter().find(|argument| argument.name == label.text) else {
            let names: Vec<&str> = form.named.iter().map(|argument| argument.name).collect();
            let message = if c.at_punct('=') || c.inside(Delimiter::Bracket).is_some() {
                messages::unknown_argument(form.word, &label.text, &names)
            } else {
                messages::too_many_places(form.word, form.positional.len())
            };
            return self.fail(label.region, message);
        };
        if let Some(first) = arguments.named.labels().find(|first| first.text == label.text) {
            let message = messages::property_twice(&label.text, form.word);
            let note = messages::first_here(&label.text);
            self.diagnostics.conflict(label.region, message, first.region, note);
            return Err(Failed);
        }
        let unit = self.unit(c)?;
        match argument.value {
            Value::Direction => {
                self.punct(c, '=')?;
                let tuple = self.vector(c, unit)?;
                arguments.named.tuples.push((label, tuple));
            }
            Value::TeethStiffness if self.at_involute(c) => {
                if let Some(unit) = unit {
                    return self.fail(unit.region, messages::involute_with_unit());
                }
                let call = self.involute(c)?;
                arguments.named.calls.push((label, Box::new(call)));
            }
            Value::Scalar(_)
            | Value::Moving(_)
            | Value::Varying(_)
            | Value::RateOf { .. }
            | Value::Way
            | Value::Law(_)
            | Value::Along { .. }
            | Value::Stiffness
            | Value::Exponent
            | Value::Backbone
            | Value::Outline
            | Value::OfParameter(_)
            | Value::OfGap
            | Value::Word
            | Value::TeethStiffness
            | Value::TeethDamping => {
                let entry = self.entry(c, unit)?;
                arguments.named.entries.push((label, entry));
            }
            Value::Diagonal(_) => {
                self.punct(c, '=')?;
                if c.inside(Delimiter::Parenthesis).is_some_and(|inside| inside.has_comma()) {
                    let tuple = self.vector(c, unit)?;
                    arguments.named.tuples.push((label, tuple));
                } else {
                    let value = self.expression(c)?;
                    arguments.named.entries.push((label, Entry { unit, value }));
                }
            }
        }
        self.argument_end(c)
    }
}

/// Whether the first argument of a call is a name with a point, as toothings have, and no ratio is written, which these bring.
fn names_toothing(c: &Cursor) -> bool {
    let mut ahead = c.clone();
    ahead.advance();
    let Some(mut inside) = ahead.inside(Delimiter::Parenthesis) else { return false };
    let mut whole = inside.clone();
    while !whole.is_done() {
        if whole.at_word("ratio") {
            return false;
        }
        whole.advance();
    }
    inside.advance();
    while inside.enter(Delimiter::Bracket).is_some() {}
    inside.at_punct('.')
}
