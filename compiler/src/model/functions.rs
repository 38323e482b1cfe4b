//! Functions and conditions in expressions.

use super::composites;
use super::fold;
use super::lower::{Lowering, Use};
use super::values::Typed;
use super::{Comparison, Condition, Expr, Function1, Function2};
use crate::diagnostics::Region;
use crate::messages;
use crate::syntax::{Label, Operator, Term, TermKind};
use crate::units::Dimension;

/// All functions, and how many arguments each may have.
pub(super) const FUNCTIONS: [(&str, &[usize]); 30] = [
    ("sqrt", &[1]),
    ("abs", &[1]),
    ("sign", &[1]),
    ("sin", &[1]),
    ("cos", &[1]),
    ("tan", &[1]),
    ("asin", &[1]),
    ("acos", &[1]),
    ("atan", &[1]),
    ("exp", &[1]),
    ("ln", &[1]),
    ("log10", &[1]),
    ("sinh", &[1]),
    ("cosh", &[1]),
    ("tanh", &[1]),
    ("step", &[1]),
    ("power", &[1]),
    ("wrap", &[1, 2]),
    ("min", &[2]),
    ("max", &[2]),
    ("atan2", &[2]),
    ("hypot", &[2]),
    ("deadband", &[2]),
    ("distance", &[2]),
    ("if", &[3]),
    ("clamp", &[3]),
    ("smoothstep", &[3]),
    ("norm", &[1]),
    ("dot", &[2]),
    ("cross", &[2]),
];

/// Whether a word is a function of the language.
pub(super) fn is_function(word: &str) -> bool {
    FUNCTIONS.iter().any(|(known, _)| *known == word)
}

impl Lowering<'_> {
    /// A call of a function, with as many arguments as it takes.
    pub fn call(
        &mut self,
        function: &Label,
        arguments: &[Term],
        region: Region,
        usage: Use,
    ) -> Option<Typed> {
        let name = function.text.as_str();
        if let Some(table) = self.table_of_call(name) {
            return self.call_of_table(function, table, arguments, region, usage);
        }
        let Some((_, counts)) = FUNCTIONS.iter().find(|(known, _)| *known == name) else {
            let tables = self.definition.tables.iter().map(|table| table.name.text.as_str());
            let known = FUNCTIONS.iter().map(|(known, _)| *known).chain(tables);
            self.diagnostics.error(function.region, messages::unknown_function(name, known));
            return None;
        };
        if !counts.contains(&arguments.len()) {
            self.diagnostics.error(region, messages::arguments(name, counts, arguments.len()));
            return None;
        }
        match name {
            "power" => self.power_of_load(&arguments[0], region, usage),
            "dot" | "cross" | "norm" => self.of_vectors(name, arguments, region, usage),
            "distance" => self.distance(arguments, region, usage),
            "if" => self.choice(arguments, region, usage),
            "min" => self.function_of_two(Function2::Min, name, arguments, region, usage),
            "max" => self.function_of_two(Function2::Max, name, arguments, region, usage),
            "atan2" => self.function_of_two(Function2::Atan2, name, arguments, region, usage),
            "hypot" | "clamp" | "deadband" | "smoothstep" | "step" | "wrap" => {
                self.composite(name, arguments, region, usage)
            }
            _ => self.function_of_one(name, &arguments[0], region, usage),
        }
    }

    fn function_of_one(&mut self, name: &str, argument: &Term, region: Region, usage: Use) -> Option<Typed> {
        let x = self.value(argument, usage)?;
        if matches!(name, "sin" | "cos" | "tan")
            && let TermKind::Number { text, unit: None } = &argument.kind
            && !x.zero
        {
            // 30 is as likely to be degrees.
            self.diagnostics.error(argument.region, messages::angle_without_unit(name, text));
            return None;
        }
        let (function, dimension) = match name {
            "sqrt" => (Function1::Sqrt, x.dimension.power(0.5)),
            "abs" => (Function1::Abs, Some(x.dimension)),
            "sign" => (Function1::Sign, Some(Dimension::ONE)),
            "sin" => (Function1::Sin, self.angular(name, &x)),
            "cos" => (Function1::Cos, self.angular(name, &x)),
            "tan" => (Function1::Tan, self.angular(name, &x)),
            "asin" => (Function1::Asin, self.plain(name, &x).map(|()| Dimension::ANGLE)),
            "acos" => (Function1::Acos, self.plain(name, &x).map(|()| Dimension::ANGLE)),
            "atan" => {
                self.plain(name, &x)?;
                let expr = fold::binary(Function2::Atan2, x.expr, Expr::Number(1.0));
                return Some(Typed { expr, dimension: Dimension::ANGLE, zero: false, region });
            }
            "exp" => (Function1::Exp, self.plain(name, &x).map(|()| Dimension::ONE)),
            "log10" => (Function1::Log10, self.plain(name, &x).map(|()| Dimension::ONE)),
            "sinh" => (Function1::Sinh, self.plain(name, &x).map(|()| Dimension::ONE)),
            "cosh" => (Function1::Cosh, self.plain(name, &x).map(|()| Dimension::ONE)),
            "tanh" => (Function1::Tanh, self.plain(name, &x).map(|()| Dimension::ONE)),
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
            let message =
                messages::wrong_dimension(&argument_of(function), Dimension::ANGLE, x.dimension, x.number());
            self.diagnostics.error(x.region, message);
        }
        fits.then_some(Dimension::ONE)
    }

    fn plain(&mut self, function: &str, x: &Typed) -> Option<()> {
        let fits = x.dimension.is_one();
        if !fits {
            let message =
                messages::wrong_dimension(&argument_of(function), Dimension::ONE, x.dimension, x.number());
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

    /// Functions that are made of others: see `composites`.
    fn composite(&mut self, name: &str, arguments: &[Term], region: Region, usage: Use) -> Option<Typed> {
        let values: Vec<Option<Typed>> = arguments.iter().map(|term| self.value(term, usage)).collect();
        let values: Vec<Typed> = values.into_iter().collect::<Option<_>>()?;
        let mut common = values[0].clone();
        for value in &values[1..] {
            common.dimension = self.same(&common, value, &format!("the arguments of `{name}`"))?;
            common.zero &= value.zero;
        }
        let numbers: Vec<Option<f64>> = values.iter().map(|value| fold::evaluate(&value.expr, &[])).collect();
        if let Some(message) = messages::impossible_arguments(name, &numbers) {
            self.diagnostics.error(region, message);
            return None;
        }
        let mut values = values.into_iter().map(|value| value.expr);
        let mut next = || values.next().unwrap_or(Expr::Number(0.0));
        let (expr, dimension) = match name {
            "hypot" => (composites::hypot(next(), next()), common.dimension),
            "clamp" => (composites::clamp(next(), next(), next()), common.dimension),
            "deadband" => (composites::deadband(next(), next()), common.dimension),
            "smoothstep" => (composites::smoothstep(next(), next(), next()), Dimension::ONE),
            "step" => (composites::step(next()), Dimension::ONE),
            _ if arguments.len() == 2 => (composites::wrap(next(), next()), common.dimension),
            _ => {
                self.angular(name, &common)?;
                (composites::wrap_angle(next()), Dimension::ANGLE)
            }
        };
        let expr = self.finite(expr, region)?;
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
