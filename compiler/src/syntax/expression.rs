//! Expressions by precedence climbing, places, pairs.
//!
//! ```text
//! or < and < not < (< <= > >= == !=) < (+ -) < (* /) < unary minus < ^
//! primary: number [unit]? | name | function(arguments) [unit]? | (expression) [unit]?
//! ```
//! Rust's own expression grammar gives `^`, `[…]`, `if` and `box` other meanings, so it is of no use here.

use super::definition::{Entry, Ground, Label, Operator, Path, PlaceTerm, Term, TermKind, Tuple};
use super::parser::{Parsed, Parser};
use super::settings::is_dotted;
use super::token::{Cursor, DEEPEST, Kind};
use crate::diagnostics::Region;
use crate::messages;
use proc_macro2::Delimiter;

const COMPARISON: u8 = 4;
const SUM: u8 = 5;
const NEGATION: u8 = 7;
const POWER: u8 = 8;

impl Parser<'_> {
    /// A whole expression.
    pub fn expression(&mut self, c: &mut Cursor) -> Parsed<Term> {
        self.climb(c, 0)
    }

    /// An expression that fills the group.
    fn filling(&mut self, mut inside: Cursor) -> Parsed<Term> {
        let term = self.expression(&mut inside)?;
        if inside.at_punct(',') {
            return self.fail(inside.region(), messages::one_number());
        }
        self.end(&inside, "an operator or `)`")?;
        Ok(term)
    }

    /// An expression of operators that bind at least as tightly as `minimum`.
    fn climb(&mut self, c: &mut Cursor, minimum: u8) -> Parsed<Term> {
        if self.depth >= DEEPEST {
            return self.fail(c.region(), messages::too_deep(DEEPEST));
        }
        self.depth += 1;
        let term = self.climb_operators(c, minimum);
        self.depth -= 1;
        term
    }

    fn climb_operators(&mut self, c: &mut Cursor, minimum: u8) -> Parsed<Term> {
        let mut left = self.prefix(c)?;
        let mut compared = false;
        while let Some((operator, strength, length)) = self.operator(c)? {
            if strength < minimum {
                break;
            }
            let region = c.region();
            for _ in 0..length {
                c.advance();
            }
            if strength == COMPARISON && compared {
                return self.fail(region, messages::chained_comparison());
            }
            compared |= strength == COMPARISON;
            // The power is right-associative, and its exponent may carry a sign: `a^-2`.
            let right = self.climb(c, if operator == Operator::Power { NEGATION } else { strength + 1 })?;
            left = self.node(operator, vec![left, right])?;
        }
        Ok(left)
    }

    /// A primary with its `-`, `+` or `not`.
    fn prefix(&mut self, c: &mut Cursor) -> Parsed<Term> {
        let (operator, strength) = if c.at_punct('-') {
            (Operator::Negate, POWER)
        } else if c.at_word("not") {
            (Operator::Not, COMPARISON)
        } else {
            return self.primary(c);
        };
        let start = c.region();
        c.advance();
        let operand = self.climb(c, strength)?;
        let mut term = self.node(operator, vec![operand])?;
        term.region = start.to(term.region);
        Ok(term)
    }

    /// The binary operator that comes next: itself, its strength and its number of tokens.
    fn operator(&mut self, c: &Cursor) -> Parsed<Option<(Operator, u8, usize)>> {
        let Some(token) = c.peek() else { return Ok(None) };
        let equals = |first| c.at_puncts(first, '=');
        Ok(Some(match &token.kind {
            Kind::Word(word) if word == "or" => (Operator::Or, 1, 1),
            Kind::Word(word) if word == "and" => (Operator::And, 2, 1),
            Kind::Punct('<') if equals('<') => (Operator::LessEqual, COMPARISON, 2),
            Kind::Punct('<') => (Operator::Less, COMPARISON, 1),
            Kind::Punct('>') if equals('>') => (Operator::GreaterEqual, COMPARISON, 2),
            Kind::Punct('>') => (Operator::Greater, COMPARISON, 1),
            Kind::Punct('=') if equals('=') => (Operator::Equal, COMPARISON, 2),
            Kind::Punct('!') if equals('!') => (Operator::NotEqual, COMPARISON, 2),
            Kind::Punct('+') => (Operator::Add, SUM, 1),
            Kind::Punct('-') => (Operator::Subtract, SUM, 1),
            Kind::Punct('*') if c.at_puncts('*', '*') => return self.foreign(c, "**"),
            Kind::Punct('*') => (Operator::Multiply, 6, 1),
            Kind::Punct('/') => (Operator::Divide, 6, 1),
            Kind::Punct('^') => (Operator::Power, POWER, 1),
            Kind::Punct('&') => return self.foreign(c, "&&"),
            Kind::Punct('|') => return self.foreign(c, "||"),
            Kind::Punct('!') => return self.foreign(c, "!"),
            Kind::Punct('%') => return self.foreign(c, "%"),
            _ => return Ok(None),
        }))
    }

    /// An operator of other languages.
    fn foreign<T>(&mut self, c: &Cursor, operator: &str) -> Parsed<T> {
        self.fail(c.region(), messages::foreign_operator(operator))
    }

    /// An operation on terms, with its height bounded.
    fn node(&mut self, operator: Operator, operands: Vec<Term>) -> Parsed<Term> {
        let region = operands[0].region.to(operands[operands.len() - 1].region);
        let height = self.height(&operands, region)?;
        Ok(Term { kind: TermKind::Operation(operator, operands), region, height })
    }

    fn height(&mut self, operands: &[Term], region: Region) -> Parsed<usize> {
        let height = 1 + operands.iter().map(|operand| operand.height).max().unwrap_or(0);
        if height > DEEPEST {
            return self.fail(region, messages::too_long(DEEPEST));
        }
        Ok(height)
    }

    /// A number, a name, a call or a group.
    fn primary(&mut self, c: &mut Cursor) -> Parsed<Term> {
        let Some(token) = c.peek() else { return self.expected(c, "a value") };
        match &token.kind {
            Kind::Number(digits) => self.number(c, digits),
            Kind::Word(_) if is_call(c) => self.call(c),
            Kind::Word(word) if word == "if" => self.expected(c, "a value"),
            Kind::Word(word) => self.name(c, word),
            Kind::Group(Delimiter::Parenthesis | Delimiter::None, ..) => self.parenthesised(c),
            Kind::Punct('+') => self.fail(c.region(), messages::unary_plus()),
            Kind::Punct('!') => self.foreign(c, "!"),
            _ => self.expected(c, "a value"),
        }
    }

    fn number(&mut self, c: &mut Cursor, digits: &str) -> Parsed<Term> {
        let mut region = c.region();
        let (negative, digits) = match digits.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, digits),
        };
        if !is_decimal(digits) {
            return self.fail(region, messages::not_decimal(digits));
        }
        c.advance();
        let unit = self.unit(c)?;
        if unit.is_some() {
            region = region.to(c.previous());
        }
        let term = Term { kind: TermKind::Number { text: digits.to_string(), unit }, region, height: 0 };
        if negative { self.node(Operator::Negate, vec![term]) } else { Ok(term) }
    }

    /// A variable of `repeat` becomes its number; any other name stays.
    fn name(&mut self, c: &mut Cursor, word: &str) -> Parsed<Term> {
        let variable = self.indices.iter().rev().find(|(name, _)| name == word).map(|(_, value)| *value);
        let Some(value) = variable else {
            if let Some(ground) = self.ground_of_port(word).filter(|_| !is_dotted(c)).cloned() {
                let height = 1 + ground.at.iter().map(|term| term.height).max().unwrap_or(0);
                let region = c.region();
                c.advance();
                return Ok(Term { kind: TermKind::Ground(Box::new(ground)), region, height });
            }
            let path = self.path(c, "a value")?;
            let region = path.region;
            if c.inside(Delimiter::Parenthesis).is_some() && is_of_table(&path) {
                return self.arguments(c, Label { text: path.text, region });
            }
            return Ok(Term { kind: TermKind::Name(path), region, height: 0 });
        };
        let region = c.region();
        c.advance();
        let text = value.unsigned_abs().to_string();
        let term = Term { kind: TermKind::Number { text, unit: None }, region, height: 0 };
        if value < 0 { self.node(Operator::Negate, vec![term]) } else { Ok(term) }
    }

    /// `function(arguments)`, or `ground(x, y) [unit]`.
    fn call(&mut self, c: &mut Cursor) -> Parsed<Term> {
        if c.at_word("ground") {
            let ground = self.ground(c)?;
            let (region, height) =
                (ground.region, 1 + ground.at.iter().map(|term| term.height).max().unwrap_or(0));
            return Ok(Term { kind: TermKind::Ground(Box::new(ground)), region, height });
        }
        let function = self.word(c, "a function")?;
        let function = self.called(function);
        self.arguments(c, function)
    }

    /// `(arguments) [unit]` behind the name of a function.
    fn arguments(&mut self, c: &mut Cursor, function: Label) -> Parsed<Term> {
        let mut inside = self.group(c, Delimiter::Parenthesis)?;
        let region = function.region.to(c.previous());
        let mut arguments = Vec::new();
        while !inside.is_done() {
            arguments.push(self.expression(&mut inside)?);
            if !inside.is_done() && !inside.eat_punct(',') {
                return self.expected(&inside, "`,` or `)`");
            }
        }
        let height = self.height(&arguments, region)?;
        self.measured(c, Term { kind: TermKind::Call(function, arguments), region, height })
    }

    fn parenthesised(&mut self, c: &mut Cursor) -> Parsed<Term> {
        let start = c.region();
        let inside = match c.enter(Delimiter::Parenthesis) {
            Some(inside) => inside,
            None => self.group(c, Delimiter::None)?,
        };
        if inside.is_done() {
            return self.fail(start, messages::expected("a value", "`()`"));
        }
        let mut term = self.filling(inside)?;
        term.region = start;
        self.measured(c, term)
    }

    /// The unit after a closing parenthesis, if there is one.
    fn measured(&mut self, c: &mut Cursor, term: Term) -> Parsed<Term> {
        let Some(unit) = self.unit(c)? else { return Ok(term) };
        let region = term.region.to(c.previous());
        let height = term.height + 1;
        Ok(Term { kind: TermKind::Measured(Box::new(term), unit), region, height })
    }

    /// `= value` after a name and its unit.
    pub fn entry(&mut self, c: &mut Cursor, unit: Option<super::definition::WrittenUnit>) -> Parsed<Entry> {
        self.punct(c, '=')?;
        Ok(Entry { unit, value: self.expression(c)? })
    }

    /// A vector `(x, y)` or `(x, y, z)`, with the unit behind it unless one stands beside the name.
    pub fn vector(&mut self, c: &mut Cursor, unit: Option<super::definition::WrittenUnit>) -> Parsed<Tuple> {
        let example = ["`(x, y)`", "`(x, y, z)`"][self.definition.space.dimensions() - 2];
        self.tuple(c, unit, self.definition.space.dimensions(), example)
    }

    /// So many values in parentheses, with the unit behind them unless one stands beside the name.
    pub fn tuple(
        &mut self,
        c: &mut Cursor,
        unit: Option<super::definition::WrittenUnit>,
        count: usize,
        example: &str,
    ) -> Parsed<Tuple> {
        let mut region = c.region();
        let Some(inside) = c.enter(Delimiter::Parenthesis) else {
            return self.expected(c, example);
        };
        let values = self.values(inside, count)?;
        let behind = self.unit(c)?;
        if behind.is_some() {
            region = region.to(c.previous());
        }
        if let (Some(_), Some(second)) = (&unit, &behind) {
            return self.fail(second.region, messages::two_units());
        }
        Ok(Tuple { unit: unit.or(behind), values, region })
    }

    /// So many expressions that fill the group.
    fn values(&mut self, mut inside: Cursor, count: usize) -> Parsed<Vec<Term>> {
        const NEXT: [&str; 3] = ["second", "third", "fourth"];
        const COUNT: [&str; 5] = ["no", "one", "two", "three", "four"];
        let mut values = vec![self.expression(&mut inside)?];
        while values.len() < count {
            if !inside.eat_punct(',') {
                let what = format!("`,` and a {} coordinate", NEXT[values.len() - 1]);
                return self.expected(&inside, &what);
            }
            values.push(self.expression(&mut inside)?);
        }
        inside.eat_punct(',');
        if count == 2 && !inside.is_done() {
            return self.fail(inside.region(), messages::third_coordinate());
        }
        self.end(&inside, &format!("`)` after {} coordinates", COUNT[count]))?;
        Ok(values)
    }

    /// `body.point` or `ground(x, y) [unit]`.
    pub fn place(&mut self, c: &mut Cursor) -> Parsed<PlaceTerm> {
        if c.at_word("ground") && is_call(c) {
            return Ok(PlaceTerm::Ground(Box::new(self.ground(c)?)));
        }
        if c.at_word("ground") {
            return self.fail(c.region(), messages::ground_without_place());
        }
        if let Some(ground) =
            c.word().and_then(|word| self.ground_of_port(word)).filter(|_| !is_dotted(c)).cloned()
        {
            c.advance();
            return Ok(PlaceTerm::Ground(Box::new(ground)));
        }
        let path: Path = self.path(c, "a place such as `crank.tip` or `ground(0, 0)`")?;
        if let Some(unit) = c.inside(Delimiter::Parenthesis) {
            return self.fail(path.region.to(unit.whole()), messages::not_a_place(&path.text));
        }
        Ok(PlaceTerm::Named(path))
    }

    fn ground(&mut self, c: &mut Cursor) -> Parsed<Ground> {
        let start = self.word(c, "`ground`")?.region;
        let inside = self.group(c, Delimiter::Parenthesis)?;
        let mut text = format!("ground({})", inside.joined().replace(',', ", "));
        let at = self.values(inside, self.definition.space.dimensions())?;
        let unit = self.unit(c)?;
        // Without a unit it is in metres.
        if let Some(written) = unit.as_ref().filter(|written| written.unit.text != "m") {
            text = format!("{text} [{}]", written.unit.text);
        }
        Ok(Ground { text, at, unit, region: start.to(c.previous()) })
    }
}

/// What may stand before parentheses beside words: `lift[2]` and `lift.slope`.
fn is_of_table(path: &Path) -> bool {
    match path.parts.as_slice() {
        [name] => name.text.ends_with(']') || name.text.contains('.'),
        [_, slope] => slope.text == "slope",
        _ => false,
    }
}

/// A word directly before parentheses.
pub(super) fn is_call(c: &Cursor) -> bool {
    c.word().is_some() && {
        let mut ahead = c.clone();
        ahead.advance();
        ahead.inside(Delimiter::Parenthesis).is_some()
    }
}

/// Digits, a point, an exponent: no suffix, no other base.
fn is_decimal(digits: &str) -> bool {
    let plain = digits.bytes().all(|b| b.is_ascii_digit() || matches!(b, b'.' | b'e' | b'E' | b'+' | b'-'));
    plain && digits.parse::<f64>().is_ok_and(f64::is_finite)
}

/// Digits as if written at `region`.
pub(super) fn number(region: Region, digits: &str) -> Term {
    Term { kind: TermKind::Number { text: digits.to_string(), unit: None }, region, height: 0 }
}
