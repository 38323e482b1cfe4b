//! Integer arithmetic at expansion: indices (`upright[i+1]`) and the bounds of `repeat`.

use super::definition::{Operator, Term, TermKind};
use super::parser::{Parsed, Parser};
use super::token::Cursor;
use crate::messages;
use crate::units;

/// Constants may refer to one another this deep.
const DEEPEST_CONSTANT: usize = 32;

impl Parser<'_> {
    /// The value of an index; `/` divides integers here.
    pub fn index(&mut self, mut inside: Cursor) -> Parsed<i64> {
        let whole = inside.whole();
        if inside.is_done() {
            return self.fail(whole, messages::empty_index());
        }
        let term = self.expression(&mut inside)?;
        self.end(&inside, "an operator or `]`")?;
        let value = self.evaluate(&term, true, &mut Vec::new())?;
        if value < 0 {
            return self.fail(term.region, messages::negative_index(value));
        }
        Ok(value)
    }

    /// The value of an expression of integers, constants and variables of `repeat`.
    pub fn integer(&mut self, term: &Term) -> Parsed<i64> {
        self.evaluate(term, false, &mut Vec::new())
    }

    /// `within`: the constants that are being evaluated, each named by the one before.
    fn evaluate(&mut self, term: &Term, in_brackets: bool, within: &mut Vec<String>) -> Parsed<i64> {
        let region = term.region;
        let value = match &term.kind {
            TermKind::Number { text, unit: None } => whole_number(text),
            TermKind::Name(path) => {
                let Some(mut constant) = self.constants.get(&path.text).cloned() else {
                    let is_unit = in_brackets && units::parse(&path.text).is_ok();
                    return self.fail(region, messages::not_an_index(&path.text, is_unit));
                };
                self.definition.counted.insert(path.text.clone());
                if let Some(value) = self.integers.get(&path.text) {
                    return Ok(*value);
                }
                if let Some(first) = within.iter().position(|name| *name == path.text) {
                    let cycle: Vec<&str> = within[first..].iter().map(String::as_str).collect();
                    return self.fail(region, messages::cyclic_constants(&cycle));
                }
                if within.len() > DEEPEST_CONSTANT {
                    return self.fail(region, messages::index_too_deep(&path.text));
                }
                // An error inside the constant is shown where it is used.
                constant.region = region;
                within.push(path.text.clone());
                let value = self.evaluate(&constant, in_brackets, within)?;
                within.pop();
                self.integers.insert(path.text.clone(), value);
                Some(value)
            }
            TermKind::Operation(operator, operands) => {
                let mut values = Vec::with_capacity(2);
                for operand in operands {
                    values.push(self.evaluate(operand, in_brackets, within)?);
                }
                if *operator == Operator::Divide && values[1] == 0 {
                    return self.fail(region, messages::division_by_zero());
                }
                compute(*operator, &values)
            }
            _ => None,
        };
        match value {
            Some(value) => Ok(value),
            None => self.fail(region, messages::not_an_integer()),
        }
    }
}

/// `3`, and `3.0` too.
fn whole_number(text: &str) -> Option<i64> {
    if let Ok(value) = text.parse() {
        return Some(value);
    }
    let value: f64 = text.parse().ok()?;
    (libm::floor(value) == value && value.abs() < 1e15).then_some(value as i64)
}

fn compute(operator: Operator, values: &[i64]) -> Option<i64> {
    match (operator, values) {
        (Operator::Add, [a, b]) => a.checked_add(*b),
        (Operator::Subtract, [a, b]) => a.checked_sub(*b),
        (Operator::Multiply, [a, b]) => a.checked_mul(*b),
        (Operator::Divide, [a, b]) => a.checked_div_euclid(*b),
        (Operator::Power, [a, b]) => a.checked_pow(u32::try_from(*b).ok()?),
        (Operator::Negate, [a]) => a.checked_neg(),
        _ => None,
    }
}
