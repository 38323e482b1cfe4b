//! Joints, constraints and loads: a name, a colon, a kind with places and named arguments.
//!
//! A table says which arguments each kind takes; what the places are is left to `model`.

use super::definition::{
    Constraint, ConstraintTerm, Entry, FirstTerm, Joint, Label, LawTerm, LineTerm, Load, Named, Operator,
    PlaceTerm, Space, SubjectTerm, Term, TermKind, Tuple,
};
use super::expression::is_call;
use super::parser::{Failed, Parsed, Parser};
use super::token::Cursor;
use crate::diagnostics::Region;
use crate::forms::{Acts, Argument, Form, Law, Need, Positional, Value, Written};
use crate::messages::{self, Habit};
use crate::units::Dimension;
use proc_macro2::Delimiter;

const ROTORS: &[Positional] = &[Positional::Rotor, Positional::Rotor];

/// Bevel and worm gears are gears, whatever the axes; a belt is a gear by its radii, a screw a rack by its pitch, and a
/// differential an equation.
const COUPLINGS: [Form; 7] = [
    Form {
        word: "gear",
        elsewhere: &[],
        positional: ROTORS,
        named: &[
            Argument::scalar("ratio", Need::Always, Dimension::ONE),
            Argument::scalar("phase", Need::Never, Dimension::ANGLE),
        ],
    },
    Form {
        word: "bevel",
        elsewhere: &[],
        positional: ROTORS,
        named: &[
            Argument::scalar("ratio", Need::Always, Dimension::ONE),
            Argument::scalar("phase", Need::Never, Dimension::ANGLE),
        ],
    },
    Form {
        word: "worm",
        elsewhere: &[],
        positional: ROTORS,
        named: &[
            Argument::scalar("ratio", Need::Always, Dimension::ONE),
            Argument::scalar("phase", Need::Never, Dimension::ANGLE),
        ],
    },
    Form {
        word: "belt",
        elsewhere: &[],
        positional: ROTORS,
        named: &[
            Argument::scalar("radius", Need::Always, Dimension::LENGTH),
            Argument::scalar("second_radius", Need::Always, Dimension::LENGTH),
            Argument::scalar("phase", Need::Never, Dimension::ANGLE),
        ],
    },
    Form {
        word: "rack",
        elsewhere: &[],
        positional: ROTORS,
        named: &[
            Argument::scalar("radius", Need::Always, Dimension::LENGTH),
            Argument::scalar("phase", Need::Never, Dimension::LENGTH),
        ],
    },
    Form {
        word: "screw",
        elsewhere: &[],
        positional: ROTORS,
        named: &[
            Argument::scalar("pitch", Need::Always, Dimension::LENGTH),
            Argument::scalar("phase", Need::Never, Dimension::LENGTH),
        ],
    },
    Form {
        word: "differential",
        elsewhere: &[],
        positional: &[Positional::Rotor, Positional::Rotor, Positional::Rotor],
        named: &[],
    },
];

/// The arguments of one call.
#[derive(Default)]
struct Arguments {
    places: Vec<PlaceTerm>,
    lines: Vec<LineTerm>,
    rotors: Vec<Label>,
    named: Named,
}

impl Arguments {
    fn place(&mut self) -> Parsed<PlaceTerm> {
        if self.places.is_empty() { Err(Failed) } else { Ok(self.places.remove(0)) }
    }

    fn rotor(&mut self) -> Parsed<Label> {
        if self.rotors.is_empty() { Err(Failed) } else { Ok(self.rotors.remove(0)) }
    }

    fn entry(&mut self, name: &str) -> Option<Entry> {
        let index = self.named.entries.iter().position(|(label, _)| label.text == name)?;
        Some(self.named.entries.remove(index).1)
    }

    fn required(&mut self, name: &str) -> Parsed<Entry> {
        self.entry(name).ok_or(Failed)
    }

    /// The unnamed arguments, in the order of the form.
    fn subjects(&mut self, form: &Form) -> Parsed<Vec<SubjectTerm>> {
        let subject = |positional: &Positional| match positional {
            Positional::Place => self.place().map(SubjectTerm::Place),
            Positional::Rotor => self.rotor().map(SubjectTerm::Name),
            Positional::Line => Err(Failed),
        };
        form.positional.iter().map(subject).collect()
    }

    fn has_tuple(&self, name: &str) -> bool {
        self.named.tuple(name).is_some()
    }
}

/// A name without a point, where that is written.
fn name_of(subject: &SubjectTerm) -> Option<&Label> {
    match subject {
        SubjectTerm::Name(label) => Some(label),
        SubjectTerm::Place(PlaceTerm::Named(path)) => path.parts.first().filter(|_| path.parts.len() == 1),
        SubjectTerm::Place(PlaceTerm::Ground(_)) => None,
    }
}

impl Parser {
    /// `name: kind(…);` after the word `joint`.
    pub fn joint(&mut self, c: &mut Cursor) -> Parsed<()> {
        let name = self.declared(c, "the name of the joint")?;
        if !c.eat_punct(':') {
            return self.expected(c, "`:` and what the joint is, such as `revolute(…);`");
        }
        let joints = (self.vocabulary.joints)(self.definition.space);
        let forms: Vec<&Form> = joints.iter().map(|joint| &joint.call).collect();
        let (which, mut arguments) = self.call_of(c, &forms, "joint")?;
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
        });
        Ok(())
    }

    /// `name: gear(…);`, `name: rack(…);` or `name: left = right;` after the word `constraint`.
    pub fn constraint(&mut self, c: &mut Cursor) -> Parsed<()> {
        let name = self.declared(c, "the name of the constraint")?;
        self.punct(c, ':')?;
        if c.word().is_some_and(|word| COUPLINGS.iter().any(|form| form.word == word)) && is_call(c) {
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
        self.punct(c, ':')?;
        if !c.at_word(word) {
            return self.expected(c, &format!("`{word}(…)`"));
        }
        self.coupling_call(c, name)
    }

    fn coupling_call(&mut self, c: &mut Cursor, name: Label) -> Parsed<()> {
        let forms: Vec<&Form> = COUPLINGS.iter().collect();
        let (which, mut arguments) = self.call_of(c, &forms, "constraint")?;
        let form = forms[which];
        let region = name.region.to(c.previous());
        self.semicolon(c)?;
        let (first, second) = (arguments.rotor()?, arguments.rotor()?);
        let phase = arguments.entry("phase");
        let kind = match form.word {
            "rack" => ConstraintTerm::Rack {
                pinion: first,
                rail: second,
                radius: arguments.required("radius")?,
                phase,
            },
            "screw" => {
                // travel = pitch/(2π) · angle
                let turn = number(region, "2").times(Term::name(region, "pi"));
                let radius = arguments.required("pitch")?.term().over(turn);
                ConstraintTerm::Rack { pinion: first, rail: second, radius: Entry::bare(radius), phase }
            }
            "belt" => {
                // r₁ θ₁ = r₂ θ₂
                let (own, other) = (arguments.required("radius")?, arguments.required("second_radius")?);
                let ratio = Entry::bare(other.term().over(own.term()));
                ConstraintTerm::Gear { first, second, ratio, phase }
            }
            "differential" => {
                // The carrier turns by the mean of both wheels.
                let angle = |label: &Label| Term::name(label.region, &format!("{}.angle", label.text));
                let (carrier, a, b) = (angle(&first), angle(&second), angle(&arguments.rotor()?));
                ConstraintTerm::Equation { left: a.plus(b), right: number(region, "2").times(carrier) }
            }
            _ => ConstraintTerm::Gear { first, second, ratio: arguments.required("ratio")?, phase },
        };
        self.definition.constraints.push(Constraint { name, kind });
        Ok(())
    }

    /// How loads are written, each word once.
    fn calls_of_loads(&self) -> Vec<&'static Form> {
        let mut calls: Vec<&Form> = Vec::new();
        for load in (self.vocabulary.loads)(self.definition.space) {
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
        self.punct(c, ':')?;
        let at = c.region();
        let loads = (self.vocabulary.loads)(self.definition.space);
        let forms = self.calls_of_loads();
        let (which, mut arguments) = self.call_of(c, &forms, "load")?;
        let call = forms[which];
        if word != "force" && word != call.word {
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
        for (subject, acts) in on.iter_mut().zip(form.on) {
            if let (false, Some(name)) = (*acts == Acts::Place, name_of(subject).cloned()) {
                *subject = SubjectTerm::Name(name);
            }
        }
        let law = match form.law {
            Law::None => LawTerm::None,
            Law::Value(_) => LawTerm::Value(self.expression(c)?),
            Law::Components(_) if written.is_directed && written.has_components => {
                return self.fail(c.region(), messages::direction_and_components());
            }
            Law::Components(_) if written.is_directed => LawTerm::Value(self.expression(c)?),
            Law::Components(_) => LawTerm::Components(self.components(c)?),
        };
        self.semicolon(c)?;
        self.definition.loads.push(Load { name, form, on, named: arguments.named, law });
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
    fn call_of(&mut self, c: &mut Cursor, forms: &[&Form], what: &str) -> Parsed<(usize, Arguments)> {
        let words: Vec<&str> = forms.iter().map(|form| form.word).collect();
        let kind = self.word(c, &format!("the kind of the {what} ({})", words.join(", ")))?;
        let Some(which) = forms.iter().position(|form| form.word == kind.text) else {
            let message = if what == "joint" {
                let in_space = (self.vocabulary.joints)(Space::Spatial);
                let in_space: Vec<&Form> = in_space.iter().map(|joint| &joint.call).collect();
                messages::unknown_joint(&kind.text, forms, &in_space, self.definition.space)
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
        let mut ahead = c.clone();
        ahead.advance();
        while ahead.enter(Delimiter::Bracket).is_some() {}
        if c.is_done() || ahead.at_punct('=') {
            let message =
                messages::missing_place(form.word, form.positional.len(), index, kind == Positional::Place);
            return self.fail(region, message);
        }
        match kind {
            Positional::Place => arguments.places.push(self.place(c)?),
            Positional::Line => arguments.lines.push(self.line_argument(c)?),
            Positional::Rotor => {
                arguments.rotors.push(self.label(c, "the name of a joint or body")?);
                if c.at_punct('.') {
                    return self.advised(c, "`,` or `)`", messages::names_without_point());
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
            Value::Scalar(_) | Value::Moving(_) => {
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

/// Digits as if written at `region`.
fn number(region: Region, digits: &str) -> Term {
    Term { kind: TermKind::Number { text: digits.to_string(), unit: None }, region, height: 0 }
}
