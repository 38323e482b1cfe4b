//! The statements of a mechanism, except those that look like calls (`calls`), bodies (`body`) and the blocks of
//! conditions and options (`settings`). `repeat` reads its braces again for every round.

use super::attributes::Bearer;
use super::definition::{
    Constant, Driver, Input, InternalState, Line, Output, Parameter, Signal, Space, StateRate,
};
use super::parser::{Failed, Parsed, Parser};
use super::token::Cursor;
use crate::messages;
use proc_macro2::{Delimiter, TokenStream};

/// Words that begin a statement, but those of bodies, loads and couplings.
const STATEMENTS: [&str; 26] = [
    "const",
    "param",
    "input",
    "signal",
    "state",
    "rate",
    "memory",
    "event",
    "table",
    "gravity",
    "marker",
    "line",
    "joint",
    "constraint",
    "drive",
    "friction",
    "start",
    "options",
    "expect",
    "output",
    "repeat",
    "part",
    "surface",
    "material",
    "contact",
    "limit",
];

impl Parser<'_> {
    /// All statements of a block; after an error on to the next one.
    pub fn statements(&mut self, mut c: Cursor) {
        while !c.is_done() {
            let before = c.clone();
            if self.statement(&mut c).is_err() {
                c = before;
                self.unread(c.clone());
                c.skip_statement();
            }
        }
    }

    fn statement(&mut self, c: &mut Cursor) -> Parsed<()> {
        let start = c.region();
        let bearer = if c.clone().declares_field() { Bearer::Field } else { Bearer::Part };
        let attributes = self.attributes(c, bearer)?;
        let read = self.statement_after(c, attributes.handed_through);
        self.allow(&attributes.allowed, start.to(c.behind()));
        read
    }

    fn statement_after(&mut self, c: &mut Cursor, docs: TokenStream) -> Parsed<()> {
        let at = c.region();
        let Some(word) = c.word() else { return self.expected(c, "a statement") };
        if word == "const" && self.indices.is_empty() {
            // Read before all others.
            c.skip_statement();
            return Ok(());
        }
        c.advance();
        match word {
            "const" => self.fail(at, messages::constant_in_repeat()),
            "param" => self.parameter(c, docs),
            "input" => self.input(c, docs),
            "signal" => self.signal(c),
            "state" => self.state(c, docs),
            "rate" => self.rate(c),
            "memory" => self.memory(c, docs),
            "event" => self.event(c),
            "table" => self.table(c),
            "gravity" | "options" | "expect" if self.scope.name.is_some() => {
                self.fail(at, messages::not_in_a_part(word))
            }
            "gravity" => self.gravity(c),
            "marker" => {
                let mut marker = self.marker(c)?;
                marker.name = self.own(marker.name);
                self.definition.markers.push(marker);
                Ok(())
            }
            "line" => {
                let mut line = self.line(c)?;
                line.name = self.own(line.name);
                self.definition.lines.push(line);
                Ok(())
            }
            "joint" => self.joint(c),
            "constraint" => self.constraint(c),
            "drive" => self.driver(c),
            "friction" => self.friction(c),
            "output" => self.output(c, docs),
            "start" => self.start(c),
            "options" => self.options(c),
            "expect" => self.expect(c),
            "repeat" => self.repeat(c),
            "part" => self.part(c),
            "surface" => {
                let surface = self.surface(c, None)?;
                self.definition.surfaces.push(surface);
                Ok(())
            }
            "material" => self.material(c),
            "contact" => self.contact(c),
            "limit" => self.limit(c),
            word if let Some(form) = self.vocabulary.bodies.iter().find(|form| form.word == word) => {
                match form.solid(self.definition.space) {
                    Some(_) => self.body(c, form),
                    None => self.fail(at, messages::only_in_space(word)),
                }
            }
            word if self.words_of_couplings().contains(&word) => self.coupling(c, word),
            word if self.words_of_loads().contains(&word) => self.load(c, word),
            word if self.laws_of_friction().any(|law| law.call.word == word) => {
                self.fail(at, messages::law_of_friction_alone(word))
            }
            word if (self.vocabulary.joints)(Space::Spatial).iter().any(|joint| joint.call.word == word) => {
                self.fail(at, messages::joint_by_its_kind(word))
            }
            _ => self.fail(at, messages::unknown_statement(word, self.statement_words().into_iter())),
        }
    }

    /// Words that begin a statement, for messages.
    pub fn statement_words(&self) -> Vec<&'static str> {
        let bodies = self.vocabulary.bodies.iter().map(|form| form.word);
        STATEMENTS
            .into_iter()
            .chain(bodies)
            .chain(self.words_of_loads())
            .chain(self.words_of_couplings())
            .collect()
    }

    /// `NAME [unit] = value;`
    pub fn constant(&mut self, c: &mut Cursor) -> Parsed<Constant> {
        let (name, unit) = self.declared_with_unit(c, "the name of the constant")?;
        let name = self.own(name);
        let entry = self.entry(c, unit)?;
        self.semicolon(c)?;
        Ok(Constant { name, entry })
    }

    /// `name [unit] = value in minimum..maximum;`
    fn parameter(&mut self, c: &mut Cursor, docs: TokenStream) -> Parsed<()> {
        let (name, unit) = self.declared_with_unit(c, "the name of the parameter")?;
        let name = self.own(name);
        if c.is_done() || c.at_punct(';') {
            return self.fail(name.region, messages::parameter_without_default(&name.text));
        }
        let entry = self.entry(c, unit)?;
        let mut bounds = None;
        if c.eat_word("in") {
            if c.inside(Delimiter::Parenthesis).is_some_and(|inside| inside.has_comma()) {
                return self.advised(c, "the bounds", messages::bounds_as_range());
            }
            let minimum = self.expression(c)?;
            self.dots(c, messages::bounds_are_inclusive())?;
            bounds = Some((minimum, self.expression(c)?));
        }
        self.semicolon(c)?;
        self.definition.parameters.push(Parameter { name, docs, entry, bounds });
        Ok(())
    }

    /// `..`
    fn dots(&mut self, c: &mut Cursor, with_equals: &str) -> Parsed<()> {
        if !c.at_puncts('.', '.') {
            return self.expected(c, "`..`");
        }
        c.advance();
        c.advance();
        if c.at_punct('=') {
            return self.advised(c, "a value", with_equals);
        }
        Ok(())
    }

    /// `name [unit];`
    fn input(&mut self, c: &mut Cursor, docs: TokenStream) -> Parsed<()> {
        let (name, unit) = self.declared_with_unit(c, "the name of the input")?;
        let name = self.own(name);
        if c.at_punct('=') {
            return self.fail(c.region(), messages::input_with_value(&name.text));
        }
        self.semicolon(c)?;
        self.definition.inputs.push(Input { name, docs, unit });
        Ok(())
    }

    /// `name [unit] = value;`
    fn signal(&mut self, c: &mut Cursor) -> Parsed<()> {
        let (name, unit) = self.declared_with_unit(c, "the name of the signal")?;
        let name = self.own(name);
        let entry = self.entry(c, unit)?;
        self.semicolon(c)?;
        self.definition.signals.push(Signal { name, entry });
        Ok(())
    }

    /// `name [unit] = start, scale = value;`
    fn state(&mut self, c: &mut Cursor, docs: TokenStream) -> Parsed<()> {
        let (name, unit) = self.declared_with_unit(c, "the name of the state")?;
        let name = self.own(name);
        if c.is_done() || c.at_punct(';') {
            return self.fail(name.region, messages::state_without_start(&name.text));
        }
        let entry = self.entry(c, unit)?;
        let mut scale = None;
        if c.at_punct(',') {
            c.advance();
            if !c.eat_word("scale") {
                return self.expected(c, "`scale = …`");
            }
            self.punct(c, '=')?;
            scale = Some(self.expression(c)?);
        }
        self.semicolon(c)?;
        self.definition.states.push(InternalState { name, docs, entry, scale });
        Ok(())
    }

    /// `name = value;`
    fn rate(&mut self, c: &mut Cursor) -> Parsed<()> {
        let (name, unit) = self.declared_with_unit(c, "the name of the state")?;
        let name = self.own(name);
        if let Some(unit) = unit {
            return self.fail(unit.region, messages::rate_with_unit(&name.text));
        }
        self.punct(c, '=')?;
        let value = self.expression(c)?;
        self.semicolon(c)?;
        self.definition.rates.push(StateRate { name, value });
        Ok(())
    }

    /// `[unit] = (x, y);`
    fn gravity(&mut self, c: &mut Cursor) -> Parsed<()> {
        let word = c.previous();
        let unit = self.unit(c)?;
        self.punct(c, '=')?;
        let pair = self.vector(c, unit)?;
        self.semicolon(c)?;
        if let Some(first) = &self.definition.gravity {
            let (first, note) = (first.region, messages::first_here("gravity"));
            self.diagnostics.conflict(word, messages::gravity_twice(), first, note);
            return Err(Failed);
        }
        self.definition.gravity = Some(pair);
        Ok(())
    }

    /// `name = (place, place);`
    pub fn line(&mut self, c: &mut Cursor) -> Parsed<Line> {
        let name = self.declared(c, "the name of the line")?;
        self.punct(c, '=')?;
        let mut inside = self.group(c, Delimiter::Parenthesis)?;
        let from = self.place(&mut inside)?;
        self.punct(&mut inside, ',')?;
        let to = self.place(&mut inside)?;
        inside.eat_punct(',');
        self.end(&inside, "`)` after two places")?;
        self.semicolon(c)?;
        Ok(Line { name, from, to })
    }

    /// `name: quantity = law;`
    fn driver(&mut self, c: &mut Cursor) -> Parsed<()> {
        let name = self.declared(c, "the name of the driver")?;
        let name = self.own(name);
        self.punct(c, ':')?;
        let call = c.at_word("distance").then(|| c.region());
        let quantity = self.path(c, "the quantity that is driven, such as `crank_pin.angle`")?;
        if let (Some(at), true) = (call, c.inside(Delimiter::Parenthesis).is_some()) {
            return self.fail(at.to(c.region()), messages::driven_distance(&name.text));
        }
        self.punct(c, '=')?;
        let law = self.expression(c)?;
        self.semicolon(c)?;
        self.definition.drivers.push(Driver { name, quantity, law });
        Ok(())
    }

    /// `name [unit] = value;`
    fn output(&mut self, c: &mut Cursor, docs: TokenStream) -> Parsed<()> {
        let (name, unit) = self.declared_with_unit(c, "the name of the output")?;
        let name = self.own(name);
        if c.at_punct('.') {
            return self.advised(c, "`=`", messages::output_without_name());
        }
        let entry = self.entry(c, unit)?;
        self.semicolon(c)?;
        self.definition.outputs.push(Output { name, docs, entry });
        Ok(())
    }

    /// `i in first..behind_last { … }`; as many rounds as there are numbers, which may be none: `0..N` of a chain without links.
    fn repeat(&mut self, c: &mut Cursor) -> Parsed<()> {
        let variable = self.word(c, "the variable of `repeat`")?;
        if self.indices.iter().any(|(name, _)| *name == variable.text) {
            return self.fail(variable.region, messages::index_shadowed(&variable.text));
        }
        if !c.eat_word("in") {
            return self.expected(c, "`in`");
        }
        let start = c.region();
        let first = self.expression(c)?;
        let first = self.integer(&first)?;
        self.dots(c, messages::rounds_stop_before())?;
        let behind = self.expression(c)?;
        let region = start.to(behind.region);
        let behind = self.integer(&behind)?;
        // Of pairs, `repeat j in i + 1..N`, the last round of `i` may have none; but some round has.
        let backwards = self.backwards.entry(region.serials());
        if behind < first {
            let message = messages::repeat_backwards(first, behind, &variable.text);
            backwards.or_insert(Some((region, message)));
        } else {
            backwards.and_modify(|error| *error = None).or_insert(None);
        }
        let inside = self.group(c, Delimiter::Brace)?;
        let rounds = behind.saturating_sub(first).max(0) as usize;
        let statements = rounds.saturating_mul(1 + inside.count_statements());
        if statements > self.budget {
            // The outer rounds are spared the same message.
            self.budget = 0;
            return self.fail(region, messages::too_many_rounds(rounds, super::MOST_STATEMENTS));
        }
        self.budget -= statements;
        for value in first..behind {
            let errors = self.diagnostics.iter().count();
            self.indices.push((variable.text.clone(), value));
            self.statements(inside.clone());
            self.indices.pop();
            // A mistake of one round is a mistake of all.
            if !self.patient && (self.diagnostics.iter().count() > errors || self.diagnostics.is_full()) {
                break;
            }
        }
        Ok(())
    }
}
