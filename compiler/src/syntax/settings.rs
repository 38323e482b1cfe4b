//! The blocks `start`, `options` and `expect`.

use super::definition::{
    Budget, Budgeted, EMITTED, ExpectEntry, Label, Operator, OptionEntry, OrientationEntry, Path, RangeTerm,
    Side, StartEntry, Term, TermKind, WrittenUnit,
};
use super::parser::{Parsed, Parser};
use super::token::{Cursor, Kind};
use crate::diagnostics::Region;
use crate::messages;
use proc_macro2::{Delimiter, TokenStream};

impl Parser<'_> {
    /// `{ quantity [unit] = value; quantity [unit] ~ guess; steady = (state, …); coupler = static; }`
    pub fn start(&mut self, c: &mut Cursor) -> Parsed<()> {
        self.block(c, |parser, c| {
            if c.at_word("repeat") {
                return parser.fail(c.region(), messages::repeat_in_block());
            }
            let mut ahead = c.clone();
            ahead.advance();
            if c.at_word("steady") && ahead.at_punct('=') {
                c.advance();
                c.advance();
                let states = parser.list(c, |p, c| p.path(c, "an internal state"))?;
                parser.definition.steady.extend(states);
                return parser.semicolon(c);
            }
            let (quantity, unit) = parser.start_quantity(c)?;
            let exact = match (c.eat_punct('='), c.eat_punct('~')) {
                (true, false) => true,
                (false, true) => false,
                _ => return parser.expected(c, "`=` (a condition) or `~` (a guess)"),
            };
            if exact && unit.is_none() && c.eat_word("static") {
                parser.definition.deflected.push(quantity);
                return parser.semicolon(c);
            }
            if quantity.parts.last().is_some_and(|last| last.text == "orientation") {
                let value = parser.tuple(c, unit, 4, "a quaternion `(w, x, y, z)`")?;
                parser.semicolon(c)?;
                parser.definition.orientations.push(OrientationEntry { quantity, exact, value });
                return Ok(());
            }
            let value = parser.expression(c)?;
            parser.semicolon(c)?;
            let entry = super::definition::Entry { unit, value };
            parser.definition.start.push(StartEntry { quantity, exact, entry });
            Ok(())
        })
    }

    /// `guide_pin.angle [rad]`: the last bracket is the unit, those before it are indices.
    fn start_quantity(&mut self, c: &mut Cursor) -> Parsed<(Path, Option<WrittenUnit>)> {
        let first = self.declared(c, "a quantity such as `crank_pin.angle`")?;
        let mut parts = vec![first];
        let mut unit = None;
        while unit.is_none() && c.eat_punct('.') {
            let part: Label;
            (part, unit) = if is_inner(c) {
                (self.declared(c, "a name")?, None)
            } else {
                self.declared_with_unit(c, "a name")?
            };
            parts.push(part);
        }
        Ok((self.resolved(Path::joined(parts))?, unit))
    }

    /// `{ coordinates = auto; cut = (joint, …); … }`
    pub fn options(&mut self, c: &mut Cursor) -> Parsed<()> {
        const KNOWN: [&str; 13] = [
            "coordinates",
            "solution",
            "redundant",
            "inertia",
            "cut",
            "independent",
            "emit",
            "self_check",
            "friction_passes",
            "contact",
            "impact",
            "export_c",
            "crate",
        ];
        self.block(c, |parser, c| {
            let option = parser.word(c, "an option")?;
            if !KNOWN.contains(&option.text.as_str()) {
                return parser.fail(option.region, messages::unknown_option(&option.text, &KNOWN));
            }
            parser.punct(c, '=')?;
            let entry = match option.text.as_str() {
                "coordinates" => OptionEntry::Coordinates(parser.choice(c, &["absolute", "tree", "auto"])?),
                "solution" => {
                    OptionEntry::Solution(parser.choice(c, &["multipliers", "independent", "auto"])?)
                }
                "redundant" => OptionEntry::Redundant(parser.choice(c, &["refuse", "drop", "keep"])?),
                "inertia" => OptionEntry::Inertia(parser.choice(c, &["check", "accept"])?),
                "cut" => OptionEntry::Cut(parser.list(c, |p, c| p.label(c, "the name of a joint"))?),
                "independent" => OptionEntry::Independent(parser.list(c, |p, c| p.path(c, "a quantity"))?),
                "emit" => OptionEntry::Emit(parser.list(c, |p, c| p.choice(c, &EMITTED))?),
                "self_check" => OptionEntry::SelfCheck(parser.choice(c, &["on", "off"])?),
                "friction_passes" => parser.friction_passes(c)?,
                "contact" => OptionEntry::Contact(parser.choice(c, &["live", "held"])?),
                "impact" => OptionEntry::Impact(parser.choice(c, &["newton", "poisson"])?),
                "export_c" => OptionEntry::ExportC(parser.choice(c, &["f64", "f32"])?),
                _ => OptionEntry::Crate(parser.crate_path(c)?),
            };
            parser.semicolon(c)?;
            parser.definition.options.push(entry);
            Ok(())
        })
    }

    /// A path, as received.
    fn crate_path(&mut self, c: &mut Cursor) -> Parsed<TokenStream> {
        let path = c.until_semicolon();
        if path.is_path() {
            return Ok(path.originals());
        }
        self.fail(path.whole(), messages::crate_path(&path.joined()))
    }

    /// One of a few words.
    fn choice(&mut self, c: &mut Cursor, words: &[&str]) -> Parsed<Label> {
        let label = self.word(c, &messages::one_of(words))?;
        if words.contains(&label.text.as_str()) {
            return Ok(label);
        }
        self.fail(label.region, messages::expected(&messages::one_of(words), &format!("`{}`", label.text)))
    }

    /// One element, or several in parentheses.
    fn list<T>(
        &mut self,
        c: &mut Cursor,
        element: impl Fn(&mut Self, &mut Cursor) -> Parsed<T>,
    ) -> Parsed<Vec<T>> {
        let Some(mut inside) = c.enter(Delimiter::Parenthesis) else {
            let only = element(self, c)?;
            if c.at_punct(',') {
                return self.advised(c, "`;`", messages::list_in_parentheses());
            }
            return Ok(vec![only]);
        };
        let mut elements = Vec::new();
        while !inside.is_done() {
            elements.push(element(self, &mut inside)?);
            if !inside.is_done() && !inside.eat_punct(',') {
                return self.expected(&inside, "`,` or `)`");
            }
        }
        Ok(elements)
    }

    /// `{ degrees_of_freedom = 1; operations <= 400; live_values(mass_matrix) <= 40; rotates = crank_pin; no_singularity;
    /// knee.angle in 10..170 [deg]; follow.force > 0; }`
    pub fn expect(&mut self, c: &mut Cursor) -> Parsed<()> {
        const KNOWN: [&str; 9] = [
            "degrees_of_freedom",
            "operations",
            "live_values",
            "rotates",
            "no_singularity",
            "contact_time",
            "friction_time",
            "frequency",
            "deflection",
        ];
        self.block(c, |parser, c| {
            if is_dotted(c) {
                let entry = parser.along_the_motion(c)?;
                parser.semicolon(c)?;
                parser.definition.expect.push(entry);
                return Ok(());
            }
            let known = "`degrees_of_freedom`, `operations`, `live_values`, `rotates`, `no_singularity`, `contact_time`, `friction_time`, `frequency` or `deflection`";
            let fact = parser.word(c, known)?;
            if let Some(of) = Budgeted::ALL.into_iter().find(|of| of.word() == fact.text) {
                let budget = parser.budget(c, of, fact.region)?;
                parser.semicolon(c)?;
                parser.definition.expect.push(ExpectEntry::Budget(budget));
                return Ok(());
            }
            let entry = match fact.text.as_str() {
                "rotates" => {
                    parser.punct(c, '=')?;
                    ExpectEntry::Rotates(parser.list(c, |p, c| p.label(c, "the name of a joint or body"))?)
                }
                "no_singularity" => ExpectEntry::NoSingularity(fact.region),
                "degrees_of_freedom" => {
                    parser.punct(c, '=')?;
                    let (count, end) = parser.count(c)?;
                    ExpectEntry::DegreesOfFreedom(count, fact.region.to(end))
                }
                "contact_time" => {
                    let (contact, time) = parser.time_of(c, "contact_time", "contact")?;
                    ExpectEntry::ContactTime(contact, time)
                }
                "friction_time" => {
                    let (friction, time) = parser.time_of(c, "friction_time", "friction")?;
                    ExpectEntry::FrictionTime(friction, time)
                }
                "frequency" => parser.frequency(c)?,
                "deflection" => parser.deflection(c)?,
                word => return parser.fail(fact.region, messages::unknown_expectation(word, &KNOWN)),
            };
            parser.semicolon(c)?;
            parser.definition.expect.push(entry);
            Ok(())
        })
    }

    /// `knee.angle in 10..170 [deg]`, or `knee.angle [deg] in 10..170`; `follow.force > 0`.
    fn along_the_motion(&mut self, c: &mut Cursor) -> Parsed<ExpectEntry> {
        let (quantity, beside) = self.start_quantity(c)?;
        let side = match (c.at_punct('>'), c.at_punct('<')) {
            (true, _) => Side::Above,
            (_, true) => Side::Below,
            _ => {
                const SUCH: &str = "`in` and a range such as `10..170 [deg]`, or `>` or `<` and a force";
                return Ok(ExpectEntry::Within(quantity, self.range(c, beside, SUCH)?));
            }
        };
        c.advance();
        // A bound is a bound: what is just at it is on neither side.
        c.eat_punct('=');
        Ok(ExpectEntry::Effort(quantity, beside, side, self.expression(c)?))
    }

    /// `strut.travel [mm] in -80..60`.
    pub(super) fn quantity_in_range(&mut self, c: &mut Cursor) -> Parsed<(Path, RangeTerm)> {
        let (quantity, beside) = self.start_quantity(c)?;
        Ok((quantity, self.range(c, beside, "`in` and a range such as `10..170 [deg]`")?))
    }

    /// `in 10..170 [deg]`.
    fn range(&mut self, c: &mut Cursor, beside: Option<WrittenUnit>, such: &str) -> Parsed<RangeTerm> {
        if !c.eat_word("in") {
            return self.expected(c, such);
        }
        let from = self.expression(c)?;
        if !c.at_puncts('.', '.') {
            return self.expected(c, "`..`");
        }
        c.advance();
        c.advance();
        let mut to = self.expression(c)?;
        let unit = beside.or_else(|| take_unit(&mut to));
        Ok(RangeTerm { unit, from, to })
    }

    /// `(mass_matrix) <= 40` behind the word.
    fn budget(&mut self, c: &mut Cursor, of: Budgeted, start: Region) -> Parsed<Budget> {
        let mut function = None;
        if let Some(mut inside) = c.enter(Delimiter::Parenthesis) {
            function = Some(self.word(&mut inside, "the name of a function")?);
            self.end(&inside, "`)`")?;
        }
        if !c.at_puncts('<', '=') {
            return self.expected(c, "`<=`");
        }
        c.advance();
        c.advance();
        let (limit, end) = self.count(c)?;
        Ok(Budget { of, function, limit, region: start.to(end) })
    }

    /// A whole number, or an expression of constants.
    fn count(&mut self, c: &mut Cursor) -> Parsed<(usize, Region)> {
        let term = self.expression(c)?;
        let value = self.integer(&term)?;
        match usize::try_from(value) {
            Ok(count) => Ok((count, term.region)),
            Err(_) => self.fail(term.region, messages::negative_index(value)),
        }
    }

    /// The lines of a block; after an error on to the next.
    fn block(
        &mut self,
        c: &mut Cursor,
        mut line: impl FnMut(&mut Self, &mut Cursor) -> Parsed<()>,
    ) -> Parsed<()> {
        let mut inside = self.group(c, Delimiter::Brace)?;
        while !inside.is_done() {
            let before = inside.clone();
            if line(self, &mut inside).is_err() {
                inside = before;
                inside.skip_statement();
            }
        }
        Ok(())
    }
}

/// The unit of a number, taken off it.
fn take_unit(term: &mut Term) -> Option<WrittenUnit> {
    match &mut term.kind {
        TermKind::Number { unit, .. } => unit.take(),
        TermKind::Operation(Operator::Negate, operands) => take_unit(operands.first_mut()?),
        // Stays where it is: only what names nothing takes the unit of both ends.
        TermKind::Measured(_, unit) => Some(unit.clone()),
        _ => None,
    }
}

/// Whether a name joined to another by a dot comes next.
pub(super) fn is_dotted(c: &Cursor) -> bool {
    c.word().is_some() && is_inner(c)
}

/// Whether a name with its brackets is followed by a dot: the brackets are then all indices.
fn is_inner(c: &Cursor) -> bool {
    let mut ahead = c.clone();
    ahead.advance();
    while ahead.enter(Delimiter::Bracket).is_some() {}
    ahead.at_punct('.')
}

impl Cursor<'_> {
    /// How many statements a block has: its `;` and braces at this level.
    pub fn count_statements(&self) -> usize {
        let mut ahead = self.clone();
        let mut count = 0;
        while let Some(token) = ahead.advance() {
            count += usize::from(matches!(token.kind, Kind::Punct(';') | Kind::Group(Delimiter::Brace, ..)));
        }
        count
    }
}
