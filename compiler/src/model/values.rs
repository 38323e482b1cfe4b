//! Expressions: dimension check, conversion to SI, folding.

use super::fold;
use super::lower::{Lowering, Use, declared};
use super::names::Value;
use super::{Comparison, Condition, Expr, Function1, Function2, InputId, ParameterId};
use crate::diagnostics::Region;
use crate::messages;
use crate::syntax::{Entry, Label, Operator, Pair, Path, Term, TermKind, WrittenUnit};
use crate::units::Dimension;

/// A checked expression.
pub(super) struct Typed {
    pub expr: Expr,
    pub dimension: Dimension,
    /// The literal 0, which fits any dimension.
    pub zero: bool,
    pub region: Region,
}

impl Lowering<'_> {
    /// The SI values of the constants, each after those it names.
    pub fn constants(&mut self) {
        self.constants = vec![None; self.definition.constants.len()];
        for index in self.order_of_constants() {
            let constant = &self.definition.constants[index];
            let dimension = declared(constant.entry.unit.as_ref());
            self.constants[index] = self.number(&constant.entry, dimension, &constant.name.text);
        }
    }

    /// Depth first along the names, with a stack of its own: chains may be long.
    fn order_of_constants(&mut self) -> Vec<usize> {
        #[derive(Clone, Copy, PartialEq)]
        enum Mark {
            New,
            Open,
            Done,
        }
        let constants = &self.definition.constants;
        let mut marks = vec![Mark::New; constants.len()];
        let mut order = Vec::with_capacity(constants.len());
        let mut stack: Vec<(usize, Vec<usize>)> = Vec::new();
        for root in 0..constants.len() {
            if marks[root] != Mark::New {
                continue;
            }
            marks[root] = Mark::Open;
            stack.push((root, self.constants_in(&constants[root].entry.value)));
            while let Some((index, pending)) = stack.last_mut() {
                let index = *index;
                match pending.pop() {
                    None => {
                        if marks[index] == Mark::Open {
                            marks[index] = Mark::Done;
                            order.push(index);
                        }
                        stack.pop();
                    }
                    Some(next) if marks[next] == Mark::New => {
                        marks[next] = Mark::Open;
                        stack.push((next, self.constants_in(&constants[next].entry.value)));
                    }
                    Some(next) if marks[next] == Mark::Open => {
                        // Left out of the order, so that nothing is said about the value.
                        marks[index] = Mark::Done;
                        let (one, other) = (&constants[index].name, &constants[next].name);
                        self.diagnostics.error(one.region, messages::cyclic_constant(&one.text, &other.text));
                    }
                    Some(_) => {}
                }
            }
        }
        order
    }

    fn constants_in(&self, term: &Term) -> Vec<usize> {
        let mut found = Vec::new();
        visit_names(term, &mut |path| {
            if let Some(Value::Constant(index)) = self.names.value(&path.text) {
                found.push(index);
            }
        });
        found
    }

    /// An entry that must be a number at expansion.
    pub fn number(&mut self, entry: &Entry, expected: Dimension, what: &str) -> Option<f64> {
        match self.entry(entry, expected, Use::CONSTANT, what)? {
            Expr::Number(value) => Some(value),
            // `if` is the only thing that does not fold.
            _ => {
                self.diagnostics.error(entry.value.region, messages::not_constant(what));
                None
            }
        }
    }

    /// A value with the unit of its name, or without one.
    pub fn entry(&mut self, entry: &Entry, expected: Dimension, usage: Use, what: &str) -> Option<Expr> {
        self.with_unit(&entry.value, entry.unit.as_ref(), expected, usage, what)
    }

    /// Two values with one unit.
    pub fn pair(&mut self, pair: &Pair, expected: Dimension, usage: Use, what: &str) -> Option<[Expr; 2]> {
        self.two(&pair.values, pair.unit.as_ref(), expected, usage, what)
    }

    /// Two values with one unit.
    pub fn two(
        &mut self,
        values: &[Term; 2],
        unit: Option<&WrittenUnit>,
        expected: Dimension,
        usage: Use,
        what: &str,
    ) -> Option<[Expr; 2]> {
        let x = self.with_unit(&values[0], unit, expected, usage, what);
        if x.is_none() && unit.is_some_and(|written| !written.unit.dimension.fits(expected)) {
            return None;
        }
        let y = self.with_unit(&values[1], unit, expected, usage, what);
        Some([x?, y?])
    }

    /// Bare numbers take the unit only where the whole value names nothing and has no unit of its own.
    fn with_unit(
        &mut self,
        term: &Term,
        unit: Option<&WrittenUnit>,
        expected: Dimension,
        usage: Use,
        what: &str,
    ) -> Option<Expr> {
        if let Some(written) = unit {
            let found = written.unit.dimension;
            if !found.fits(expected) {
                self.diagnostics.error(written.region, messages::wrong_unit(what, expected, found));
                return None;
            }
        }
        let typed = self.value(term, usage)?;
        match unit {
            Some(written) if is_bare(term) => self.scaled(typed, written),
            _ => self.expect_dimension(typed, expected, what),
        }
    }

    /// A bare number times a unit.
    fn scaled(&mut self, typed: Typed, written: &WrittenUnit) -> Option<Expr> {
        let unit = &written.unit;
        if !typed.dimension.is_one() {
            // `angle [rad] = acos(0.5)` is what it says; in degrees it would be converted twice.
            if unit.scale == 1.0 && typed.dimension.fits(unit.dimension) {
                return Some(typed.expr);
            }
            self.diagnostics.error(typed.region, messages::not_bare(typed.dimension, &unit.text));
            return None;
        }
        let scaled = fold::binary(Function2::Mul, typed.expr, Expr::Number(unit.scale));
        self.finite(scaled, typed.region)
    }

    /// A value of a known dimension.
    pub fn expect_dimension(&mut self, typed: Typed, expected: Dimension, what: &str) -> Option<Expr> {
        if typed.zero || typed.dimension.fits(expected) {
            return Some(typed.expr);
        }
        let message = messages::wrong_dimension(what, expected, typed.dimension);
        self.diagnostics.error(typed.region, message);
        None
    }

    /// Two values that are added or compared: what both of them measure.
    pub fn same(&mut self, left: &Typed, right: &Typed, what: &str) -> Option<Dimension> {
        if left.zero {
            return Some(right.dimension);
        }
        if right.zero || left.dimension.fits(right.dimension) {
            return Some(if right.zero { left.dimension } else { left.dimension.merged(right.dimension) });
        }
        // The number that lacks a unit is the one to point at.
        let region = match (left.dimension == Dimension::ONE, right.dimension == Dimension::ONE) {
            (true, false) => left.region,
            (false, true) => right.region,
            _ => left.region.to(right.region),
        };
        self.diagnostics.error(region, messages::different_dimensions(what, left.dimension, right.dimension));
        None
    }

    /// An expression with its dimension.
    pub fn value(&mut self, term: &Term, usage: Use) -> Option<Typed> {
        let region = term.region;
        match &term.kind {
            TermKind::Number { text, unit } => self.literal(text, unit.as_ref(), region),
            TermKind::Name(path) => self.named(path, usage),
            TermKind::Operation(operator, operands) => self.operation(*operator, operands, region, usage),
            TermKind::Call(function, arguments) => self.call(function, arguments, region, usage),
            TermKind::Measured(inner, unit) => self.measured(inner, unit, region, usage),
            TermKind::Ground(_) => {
                self.diagnostics.error(region, messages::place_as_value());
                None
            }
        }
    }

    fn literal(&mut self, text: &str, unit: Option<&WrittenUnit>, region: Region) -> Option<Typed> {
        let digits: f64 = text.parse().ok()?;
        let scale = unit.map_or(1.0, |written| written.unit.scale);
        let expr = self.finite(Expr::Number(digits * scale), region)?;
        Some(Typed { expr, dimension: declared(unit), zero: digits == 0.0 && unit.is_none(), region })
    }

    fn measured(&mut self, inner: &Term, unit: &WrittenUnit, region: Region, usage: Use) -> Option<Typed> {
        let dimension = unit.unit.dimension;
        let typed = self.value(inner, usage)?;
        let expr = if is_bare(inner) {
            self.scaled(typed, unit)?
        } else {
            self.expect_dimension(typed, dimension, "the value in parentheses")?
        };
        Some(Typed { expr, dimension, zero: false, region })
    }

    fn named(&mut self, path: &Path, usage: Use) -> Option<Typed> {
        let typed = |expr, dimension| Some(Typed { expr, dimension, zero: false, region: path.region });
        if path.parts.len() == 1 {
            match self.names.value(&path.text) {
                Some(Value::Constant(index)) => {
                    let dimension = declared(self.definition.constants[index].entry.unit.as_ref());
                    return typed(Expr::Number(self.constants[index]?), dimension);
                }
                Some(Value::Parameter(index)) => {
                    self.permit(usage.parameters, path, "a parameter", usage)?;
                    let dimension = declared(self.definition.parameters[index].entry.unit.as_ref());
                    return typed(Expr::Parameter(ParameterId(index)), dimension);
                }
                Some(Value::Input(index)) => {
                    self.permit(usage.inputs, path, "an input", usage)?;
                    let dimension = declared(self.definition.inputs[index].unit.as_ref());
                    return typed(Expr::Input(InputId(index)), dimension);
                }
                None if path.text == "pi" => {
                    return typed(Expr::Number(core::f64::consts::PI), Dimension::ONE);
                }
                None if path.text == "time" => {
                    self.permit(usage.time, path, "the time", usage)?;
                    return typed(Expr::Time, Dimension::TIME);
                }
                None => {}
            }
        }
        let (quantity, dimension) = self.permitted_quantity(path, usage)?;
        typed(Expr::Quantity(quantity), dimension)
    }

    /// An error if this kind of thing may not stand here.
    pub fn permit(&mut self, permitted: bool, path: &Path, kind: &str, usage: Use) -> Option<()> {
        if !permitted {
            self.diagnostics.error(path.region, messages::not_permitted(&path.text, kind, &usage));
        }
        permitted.then_some(())
    }

    fn operation(
        &mut self,
        operator: Operator,
        operands: &[Term],
        region: Region,
        usage: Use,
    ) -> Option<Typed> {
        match (operator, operands) {
            (Operator::Negate, [operand]) => {
                let typed = self.value(operand, usage)?;
                Some(Typed { expr: fold::unary(Function1::Neg, typed.expr), region, ..typed })
            }
            (Operator::Power, [base, exponent]) => self.power(base, exponent, region, usage),
            (Operator::Add, [a, b]) => self.sum(Function2::Add, a, b, region, usage),
            (Operator::Subtract, [a, b]) => self.sum(Function2::Sub, a, b, region, usage),
            (Operator::Multiply, [a, b]) => self.product(a, b, region, usage),
            (Operator::Divide, [a, b]) => self.quotient(a, b, region, usage),
            _ => {
                self.diagnostics.error(region, messages::condition_as_value());
                None
            }
        }
    }

    fn sum(&mut self, function: Function2, a: &Term, b: &Term, region: Region, usage: Use) -> Option<Typed> {
        let (a, b) = (self.value(a, usage), self.value(b, usage));
        let (a, b) = (a?, b?);
        let what = if function == Function2::Add { "the summands" } else { "the two sides of `-`" };
        let dimension = self.same(&a, &b, what)?;
        let zero = a.zero && b.zero;
        let expr = self.finite(fold::binary(function, a.expr, b.expr), region)?;
        Some(Typed { expr, dimension, zero, region })
    }

    fn product(&mut self, a: &Term, b: &Term, region: Region, usage: Use) -> Option<Typed> {
        let (a, b) = (self.value(a, usage), self.value(b, usage));
        let (a, b) = (a?, b?);
        let expr = self.finite(fold::binary(Function2::Mul, a.expr, b.expr), region)?;
        Some(Typed { expr, dimension: a.dimension.times(b.dimension), zero: false, region })
    }

    fn quotient(&mut self, a: &Term, b: &Term, region: Region, usage: Use) -> Option<Typed> {
        let (a, b) = (self.value(a, usage), self.value(b, usage));
        let (a, b) = (a?, b?);
        if matches!(b.expr, Expr::Number(0.0)) {
            self.diagnostics.error(region, messages::division_by_zero());
            return None;
        }
        let expr = self.finite(fold::binary(Function2::Div, a.expr, b.expr), region)?;
        Some(Typed { expr, dimension: a.dimension.over(b.dimension), zero: false, region })
    }

    fn power(&mut self, base: &Term, exponent: &Term, region: Region, usage: Use) -> Option<Typed> {
        let (base, power) = (self.value(base, usage), self.value(exponent, usage));
        let (base, power) = (base?, power?);
        let (Expr::Number(number), true) = (&power.expr, power.dimension.is_one()) else {
            self.diagnostics.error(exponent.region, messages::exponent());
            return None;
        };
        let Some(dimension) = base.dimension.power(*number) else {
            self.diagnostics.error(region, messages::power_of_dimension(base.dimension, *number));
            return None;
        };
        let expr = self.finite(fold::power(base.expr, *number), region)?;
        Some(Typed { expr, dimension, zero: false, region })
    }

    /// A folded number must be one.
    pub fn finite(&mut self, expr: Expr, region: Region) -> Option<Expr> {
        match expr {
            Expr::Number(value) if !value.is_finite() => {
                self.diagnostics.error(region, messages::not_finite(value));
                None
            }
            _ => Some(expr),
        }
    }

    fn call(&mut self, function: &Label, arguments: &[Term], region: Region, usage: Use) -> Option<Typed> {
        const FUNCTIONS: [(&str, usize); 16] = [
            ("sqrt", 1),
            ("abs", 1),
            ("sign", 1),
            ("sin", 1),
            ("cos", 1),
            ("tan", 1),
            ("asin", 1),
            ("acos", 1),
            ("exp", 1),
            ("ln", 1),
            ("power", 1),
            ("min", 2),
            ("max", 2),
            ("atan2", 2),
            ("distance", 2),
            ("if", 3),
        ];
        let name = function.text.as_str();
        let Some((_, count)) = FUNCTIONS.iter().find(|(known, _)| *known == name) else {
            let known = FUNCTIONS.iter().map(|(known, _)| *known);
            self.diagnostics.error(function.region, messages::unknown_function(name, known));
            return None;
        };
        if arguments.len() != *count {
            self.diagnostics.error(region, messages::arguments(name, *count, arguments.len()));
            return None;
        }
        match name {
            "power" => self.power_of_load(&arguments[0], region, usage),
            "distance" => self.distance(arguments, region, usage),
            "if" => self.choice(arguments, region, usage),
            "min" => self.function_of_two(Function2::Min, name, arguments, region, usage),
            "max" => self.function_of_two(Function2::Max, name, arguments, region, usage),
            "atan2" => self.function_of_two(Function2::Atan2, name, arguments, region, usage),
            _ => self.function_of_one(name, &arguments[0], region, usage),
        }
    }

    fn function_of_one(&mut self, name: &str, argument: &Term, region: Region, usage: Use) -> Option<Typed> {
        let x = self.value(argument, usage)?;
        let (function, dimension) = match name {
            "sqrt" => (Function1::Sqrt, x.dimension.power(0.5)),
            "abs" => (Function1::Abs, Some(x.dimension)),
            "sign" => (Function1::Sign, Some(Dimension::ONE)),
            "sin" => (Function1::Sin, self.angular(name, &x)),
            "cos" => (Function1::Cos, self.angular(name, &x)),
            "tan" => (Function1::Tan, self.angular(name, &x)),
            "asin" => (Function1::Asin, self.plain(name, &x).map(|()| Dimension::ANGLE)),
            "acos" => (Function1::Acos, self.plain(name, &x).map(|()| Dimension::ANGLE)),
            "exp" => (Function1::Exp, self.plain(name, &x).map(|()| Dimension::ONE)),
            _ => (Function1::Ln, self.plain(name, &x).map(|()| Dimension::ONE)),
        };
        let dimension = dimension?;
        let expr = self.finite(fold::unary(function, x.expr), region)?;
        Some(Typed { expr, dimension, zero: false, region })
    }

    /// The argument of sin, cos and tan: an angle or a number.
    fn angular(&mut self, function: &str, x: &Typed) -> Option<Dimension> {
        let fits = x.dimension.fits(Dimension::ANGLE) || x.dimension.is_one();
        if !fits {
            let message = messages::wrong_dimension(&argument_of(function), Dimension::ANGLE, x.dimension);
            self.diagnostics.error(x.region, message);
        }
        fits.then_some(Dimension::ONE)
    }

    fn plain(&mut self, function: &str, x: &Typed) -> Option<()> {
        let fits = x.dimension.is_one();
        if !fits {
            let message = messages::wrong_dimension(&argument_of(function), Dimension::ONE, x.dimension);
            self.diagnostics.error(x.region, message);
        }
        fits.then_some(())
    }

    fn function_of_two(
        &mut self,
        function: Function2,
        name: &str,
        arguments: &[Term],
        region: Region,
        usage: Use,
    ) -> Option<Typed> {
        let (x, y) = (self.value(&arguments[0], usage), self.value(&arguments[1], usage));
        let (x, y) = (x?, y?);
        let common = self.same(&x, &y, &format!("the arguments of `{name}`"))?;
        let dimension = if function == Function2::Atan2 { Dimension::ANGLE } else { common };
        let expr = self.finite(fold::binary(function, x.expr, y.expr), region)?;
        Some(Typed { expr, dimension, zero: false, region })
    }

    /// `if(condition, then, otherwise)`.
    fn choice(&mut self, arguments: &[Term], region: Region, usage: Use) -> Option<Typed> {
        let condition = self.condition(&arguments[0], usage);
        let (then, otherwise) = (self.value(&arguments[1], usage), self.value(&arguments[2], usage));
        let (condition, then, otherwise) = (condition?, then?, otherwise?);
        let dimension = self.same(&then, &otherwise, "the two values of `if`")?;
        let expr = match known(&condition) {
            Some(true) => then.expr,
            Some(false) => otherwise.expr,
            None => Expr::If(Box::new(condition), Box::new(then.expr), Box::new(otherwise.expr)),
        };
        Some(Typed { expr, dimension, zero: then.zero && otherwise.zero, region })
    }

    fn condition(&mut self, term: &Term, usage: Use) -> Option<Condition> {
        let TermKind::Operation(operator, operands) = &term.kind else { return self.no_condition(term) };
        let comparison = match (operator, operands.as_slice()) {
            (Operator::And, [a, b]) => {
                let (a, b) = (self.condition(a, usage), self.condition(b, usage));
                return Some(Condition::And(Box::new(a?), Box::new(b?)));
            }
            (Operator::Or, [a, b]) => {
                let (a, b) = (self.condition(a, usage), self.condition(b, usage));
                return Some(Condition::Or(Box::new(a?), Box::new(b?)));
            }
            (Operator::Not, [a]) => return Some(Condition::Not(Box::new(self.condition(a, usage)?))),
            (Operator::Less, _) => Comparison::Less,
            (Operator::LessEqual, _) => Comparison::LessEqual,
            (Operator::Greater, _) => Comparison::Greater,
            (Operator::GreaterEqual, _) => Comparison::GreaterEqual,
            (Operator::Equal, _) => Comparison::Equal,
            (Operator::NotEqual, _) => Comparison::NotEqual,
            _ => return self.no_condition(term),
        };
        let (a, b) = (self.value(&operands[0], usage), self.value(&operands[1], usage));
        let (a, b) = (a?, b?);
        self.same(&a, &b, "the two sides of the comparison")?;
        Some(Condition::Compare(comparison, a.expr, b.expr))
    }

    fn no_condition(&mut self, term: &Term) -> Option<Condition> {
        self.diagnostics.error(term.region, messages::value_as_condition());
        None
    }
}

fn argument_of(function: &str) -> String {
    format!("the argument of `{function}`")
}

/// The value of a condition between numbers.
fn known(condition: &Condition) -> Option<bool> {
    match condition {
        Condition::Compare(comparison, Expr::Number(a), Expr::Number(b)) => Some(match comparison {
            Comparison::Less => a < b,
            Comparison::LessEqual => a <= b,
            Comparison::Greater => a > b,
            Comparison::GreaterEqual => a >= b,
            Comparison::Equal => a == b,
            Comparison::NotEqual => a != b,
        }),
        Condition::Compare(..) => None,
        Condition::And(a, b) => Some(known(a)? && known(b)?),
        Condition::Or(a, b) => Some(known(a)? || known(b)?),
        Condition::Not(a) => known(a).map(|value| !value),
    }
}

/// Whether a value names nothing and carries no unit.
fn is_bare(term: &Term) -> bool {
    match &term.kind {
        TermKind::Number { unit, .. } => unit.is_none(),
        TermKind::Name(path) => path.text == "pi",
        TermKind::Operation(_, terms) | TermKind::Call(_, terms) => terms.iter().all(is_bare),
        TermKind::Ground(_) | TermKind::Measured(..) => false,
    }
}

/// Calls `visit` with every name in an expression.
fn visit_names(term: &Term, visit: &mut impl FnMut(&Path)) {
    match &term.kind {
        TermKind::Name(path) => visit(path),
        TermKind::Operation(_, terms) | TermKind::Call(_, terms) => {
            terms.iter().for_each(|term| visit_names(term, visit));
        }
        TermKind::Measured(inner, _) => visit_names(inner, visit),
        TermKind::Ground(ground) => ground.at.iter().for_each(|term| visit_names(term, visit)),
        TermKind::Number { .. } => {}
    }
}
