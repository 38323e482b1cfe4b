//! Expressions of the tree to [`Law`]s: what a name means, by what may stand where it stands.

use super::joints::of_play;
use super::values::{factor, is_bare};
use super::{Read, Reader};
use crate::energy::Energy;
use crate::error::DefinitionError;
use crate::expression::{Expression, Function, Operator};
use crate::json::{field, list, name as json_name, text};
use crate::kinematics::Section;
use crate::law::{Law, Rate};
use crate::quantity::Quantity;
use crate::table::{Look, Table};
use serde_json::Value;
use std::f64::consts::PI;

/// What an expression may name; each adds to the one before it.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub(crate) enum May {
    /// Constants and parameters.
    Constant,
    Time,
    Positions,
    /// Velocities, inputs and internal states.
    Motion,
    /// Powers and resistances of loads, efforts, energies.
    Results,
}

/// Deeper trees, signals within them unfolded, are no definition that was compiled.
const DEEPEST: usize = 256;

/// Signals and constants within one expression are unfolded to at most so many terms.
const LARGEST: usize = 1 << 17;

/// An expression on its way, with what it has named so far.
pub(super) struct LawReader<'r, 't> {
    pub reader: &'r Reader<'t>,
    pub part: &'r str,
    pub may: May,
    pub law: Law,
    /// The contact whose law is read, and of which of its gaps.
    pub own: Option<(&'r str, usize)>,
    depth: usize,
    terms: usize,
}

impl<'t> Reader<'t> {
    /// A value whose literals have their own units.
    pub fn law(&self, node: &Value, part: &str, may: May) -> Read<Law> {
        self.reading(part, may, |law| law.expression(node))
    }

    pub fn law_in_unit(&self, node: &Value, unit: Option<&str>, part: &str, may: May) -> Read<Law> {
        self.reading(part, may, |law| law.in_unit(node, unit))
    }

    /// The law of `{"unit": …, "value": EXPR}`.
    pub fn entry_law(&self, node: &Value, part: &str, may: May) -> Read<Law> {
        self.reading(part, may, |law| law.entry(node))
    }

    /// An expression made by `read`, with what it names.
    pub(super) fn reading(
        &self,
        part: &str,
        may: May,
        read: impl FnOnce(&mut LawReader<'_, 't>) -> Read<Expression>,
    ) -> Read<Law> {
        let mut law =
            LawReader { reader: self, part, may, law: Law::constant(0.0), own: None, depth: 0, terms: 0 };
        law.law.expression = read(&mut law)?;
        Ok(law.law)
    }
}

impl LawReader<'_, '_> {
    pub fn entry(&mut self, node: &Value) -> Read<Expression> {
        self.in_unit(field(node, "value", self.part)?, node.get("unit").and_then(Value::as_str))
    }

    pub fn in_unit(&mut self, node: &Value, unit: Option<&str>) -> Read<Expression> {
        let value = self.expression(node)?;
        let factor = factor(unit, self.part)?;
        if factor == 1.0 || !is_bare(node) {
            return Ok(value);
        }
        Ok(Expression::binary(Operator::Times, value, Expression::Number(factor)))
    }

    pub fn expression(&mut self, node: &Value) -> Read<Expression> {
        self.terms += 1;
        if self.depth == DEEPEST || self.terms > LARGEST {
            let what = "an expression is too deep or too large, or a name stands for itself";
            return Err(DefinitionError::value(self.part, what));
        }
        self.depth += 1;
        let expression = self.shallow(node);
        self.depth -= 1;
        expression
    }

    fn shallow(&mut self, node: &Value) -> Read<Expression> {
        if node.get("number").is_some() {
            let digits = text(node, "number", self.part)?.replace('_', "");
            let number: f64 =
                digits.parse().map_err(|_| DefinitionError::malformed(self.part, "a number"))?;
            let factor = factor(node.get("unit").and_then(Value::as_str), self.part)?;
            return Ok(Expression::Number(number * factor));
        }
        if node.get("name").is_some() {
            return self.name(text(node, "name", self.part)?);
        }
        if node.get("op").is_some() {
            return self.operation(text(node, "op", self.part)?, list(node, "args", self.part)?);
        }
        if node.get("call").is_some() {
            return self.call(text(node, "call", self.part)?, list(node, "args", self.part)?);
        }
        if node.get("value").is_some() {
            return self.entry(node);
        }
        Err(DefinitionError::malformed(self.part, "an expression"))
    }

    fn operation(&mut self, operator: &str, arguments: &[Value]) -> Read<Expression> {
        let operator = match (operator, arguments) {
            ("+", [one]) => return self.expression(one),
            ("-" | "neg", [one]) => return Ok(Expression::unary(Function::Negative, self.expression(one)?)),
            ("not", [one]) => return Ok(Expression::unary(Function::Not, self.expression(one)?)),
            ("^", [base, exponent]) => {
                let exponent = self.expression(exponent)?.constant().ok_or_else(|| {
                    DefinitionError::value(self.part, "an exponent is no number that is known")
                })?;
                return Ok(Expression::unary(Function::Power(exponent), self.expression(base)?));
            }
            ("+", _) => Operator::Plus,
            ("-", _) => Operator::Minus,
            ("*", _) => Operator::Times,
            ("/", _) => Operator::Over,
            ("<", _) => Operator::Less,
            ("<=", _) => Operator::LessOrEqual,
            (">", _) => Operator::Greater,
            (">=", _) => Operator::GreaterOrEqual,
            ("==", _) => Operator::Equal,
            ("!=", _) => Operator::NotEqual,
            ("and", _) => Operator::And,
            ("or", _) => Operator::Or,
            _ => return Err(DefinitionError::kind(self.part, operator)),
        };
        self.binary(operator, arguments)
    }

    fn binary(&mut self, operator: Operator, arguments: &[Value]) -> Read<Expression> {
        let [a, b] = arguments else {
            return Err(DefinitionError::malformed(self.part, "two operands"));
        };
        Ok(Expression::binary(operator, self.expression(a)?, self.expression(b)?))
    }

    fn call(&mut self, function: &str, arguments: &[Value]) -> Read<Expression> {
        match (unary(function), binary(function), arguments) {
            (Some(function), _, [one]) => return Ok(Expression::unary(function, self.expression(one)?)),
            (_, Some(operator), [_, _]) => return self.binary(operator, arguments),
            _ => {}
        }
        match (function, arguments) {
            ("if", [condition, then, otherwise]) => {
                let [condition, then, otherwise] =
                    [self.expression(condition)?, self.expression(then)?, self.expression(otherwise)?];
                Ok(Expression::If(Box::new([condition, then, otherwise])))
            }
            ("hypot", [x, y]) => {
                let squares =
                    [x, y].map(|x| Ok(Expression::unary(Function::Power(2.0), self.expression(x)?)));
                let [x, y] = squares;
                Ok(Expression::unary(Function::Sqrt, Expression::binary(Operator::Plus, x?, y?)))
            }
            ("clamp", [x, least, most]) => {
                let low = Expression::binary(Operator::Max, self.expression(x)?, self.expression(least)?);
                Ok(Expression::binary(Operator::Min, low, self.expression(most)?))
            }
            ("smoothstep", [x, from, to]) => {
                let [x, from, to] = [self.expression(x)?, self.expression(from)?, self.expression(to)?];
                let width = Expression::binary(Operator::Minus, to, from.clone());
                let passed = Expression::binary(Operator::Minus, x, from);
                let share = Expression::binary(Operator::Over, passed, width);
                Ok(Expression::unary(Function::Smoothstep, share))
            }
            ("distance", [a, b]) => self.distance(a, b),
            ("norm", [a]) => self.norm(a),
            ("dot", [a, b]) => self.dot(a, b),
            ("cross", [a, b]) => self.plane_cross(a, b),
            ("power", [load]) => self.power(text(load, "name", self.part)?),
            _ => self.look(function, arguments),
        }
    }

    /// A table's value, or its slope.
    fn look(&mut self, function: &str, arguments: &[Value]) -> Read<Expression> {
        let own = function.strip_suffix(".slope").unwrap_or(function);
        let Some(table) = self.reader.tables.get(own) else {
            return Err(DefinitionError::kind(self.part, function));
        };
        let slope = own != function;
        let expected = if matches!(**table, Table::Curve(_)) { 1 } else { 2 };
        if arguments.len() != expected || slope && expected == 2 {
            return Err(DefinitionError::malformed(self.part, &format!("a call of `{function}`")));
        }
        let first = self.expression(&arguments[0])?;
        let second = arguments.get(1).map(|argument| self.expression(argument)).transpose()?;
        let arguments = Box::new([first, second.unwrap_or(Expression::Number(0.0))]);
        Ok(Expression::Table(Look { table: table.clone(), slope }, arguments))
    }

    fn name(&mut self, name: &str) -> Read<Expression> {
        let reader = self.reader;
        if name == "pi" {
            return Ok(Expression::Number(PI));
        }
        if name == "time" && self.may >= May::Time {
            return Ok(Expression::Time);
        }
        if let Some(value) = reader.parameters.get(name) {
            return Ok(Expression::Number(*value));
        }
        if let Some(constant) = reader.constants.get(name) {
            return self.entry(constant);
        }
        if let Some(signal) = reader.signals.get(name) {
            return self.entry(signal);
        }
        match reader.inputs.get(name) {
            Some(input) if self.may >= May::Motion => return Ok(Expression::Input(*input)),
            _ => {}
        }
        match reader.states.get(name) {
            Some(state) if self.may >= May::Motion => return Ok(Expression::State(*state)),
            _ => {}
        }
        if matches!(name, "energy" | "kinetic_energy" | "potential_energy") {
            return self.energy(name);
        }
        if self.may >= May::Positions
            && let Some(quantity) = self.quantity(name)?
        {
            return Ok(quantity);
        }
        Err(DefinitionError::unknown(self.part, name))
    }

    /// A quantity of a joint, a body or a place, or the rate of one.
    fn quantity(&mut self, name: &str) -> Read<Option<Expression>> {
        let reader = self.reader;
        let Some((owner, what)) = name.rsplit_once('.') else { return Ok(None) };
        let (touching, part) = match owner.rsplit_once('.') {
            Some((touching, part @ ("point" | "sliding" | "offset"))) => (touching, Some(part)),
            _ => (owner, None),
        };
        let joint = reader.joint_by_name.get(touching).map(|joint| &reader.joints[*joint]);
        if let Some(quantity) = joint.and_then(|joint| of_play(joint, part, what)) {
            return Ok(Some(self.leaf(quantity)));
        }
        let asks_contact =
            |what: &str| ["gap", "depth", "closing", "force", "point", "sliding"].contains(&what);
        if let Some(contact) = reader.contact_named(touching)?
            && (joint.is_none() || asks_contact(part.unwrap_or(what)))
        {
            return self.of_contact(contact, touching, what, part).map(Some);
        }
        if let ("effort", May::Results, Some(row)) = (what, self.may, reader.efforts.get(owner)) {
            self.law.rates.push(Rate::Effort(*row));
            return Ok(Some(Expression::Rate(self.law.rates.len() - 1)));
        }
        if what == "resistance" && self.may == May::Results {
            let loads = list(reader.tree, "loads", self.part)?;
            let load = loads.iter().find(|load| json_name(load, self.part) == Ok(owner));
            let load = load.ok_or_else(|| DefinitionError::unknown(self.part, name))?;
            return self.resistance(load, owner).map(Some);
        }
        if owner.ends_with(".reaction") || owner.ends_with(".reaction.torque") {
            return Err(self.result(name));
        }
        for (of, is_rate) in [(name, false), (owner, what == "rate")] {
            let mode = of.rsplit_once('.').and_then(|(body, mode)| {
                let body = *reader.body_by_name.get(body)?;
                Some((body, reader.bodies[body].beam.as_ref()?.mode(mode)?))
            });
            if let (Some((body, mode)), true) = (mode, is_rate || of == name) {
                let leaf = self.leaf(Quantity::Mode { body, mode });
                return if is_rate { self.rate(leaf).map(Some) } else { Ok(Some(leaf)) };
            }
        }
        if let Some(joint) = reader.joint_by_name.get(owner) {
            let (position, is_rate) = match what.split_once('_').map_or((what, None), |(a, b)| (a, Some(b))) {
                ("rate", number) => (with_number("angle", number), true),
                ("speed", number) => (with_number("travel", number), true),
                ("parameter", Some("rate")) => ("parameter".to_string(), true),
                _ => (what.to_string(), false),
            };
            if let Some(quantity) = reader.of_joint(*joint, &position) {
                let leaf = self.leaf(quantity);
                return if is_rate { self.rate(leaf).map(Some) } else { Ok(Some(leaf)) };
            }
        }
        if let Some(body) = reader.body_by_name.get(owner)
            && !reader.spatial
            && !reader.bodies[*body].particle
            && matches!(what, "angle" | "rate")
        {
            let leaf = self.leaf(Quantity::PlaneAngle {
                first: Section::whole(None),
                second: Section::whole(Some(*body)),
            });
            return if what == "rate" { self.rate(leaf).map(Some) } else { Ok(Some(leaf)) };
        }
        if let (Some(signal), "rate") = (reader.signals.get(owner), what) {
            let may = std::mem::replace(&mut self.may, May::Positions);
            let expression = self.entry(signal);
            self.may = may;
            return self.rate(expression?).map(Some);
        }
        let Some(axis) = ["x", "y", "z"].iter().take(reader.dimension()).position(|axis| *axis == what)
        else {
            let there =
                matches!(what, "effort" | "power" | "tension" | "resistance" | "size" | "normal" | "torque");
            return if there { Err(self.result(name)) } else { Ok(None) };
        };
        if let Some(body) = owner.strip_suffix(".rate").and_then(|body| reader.body_by_name.get(body)) {
            self.needs_motion()?;
            self.law.rates.push(Rate::Spin { body: *body, axis });
            return Ok(Some(Expression::Rate(self.law.rates.len() - 1)));
        }
        let (place, is_rate) = match owner.strip_suffix(".velocity") {
            Some(place) => (place, true),
            None => (owner, false),
        };
        let Some(place) = reader.named_place(place) else { return Ok(None) };
        let leaf = self.leaf(Quantity::Coordinate { place, axis });
        if is_rate { self.rate(leaf).map(Some) } else { Ok(Some(leaf)) }
    }

    pub fn leaf(&mut self, quantity: Quantity) -> Expression {
        self.law.quantities.push(quantity);
        Expression::Quantity(self.law.quantities.len() - 1)
    }

    pub fn rate(&mut self, of: Expression) -> Read<Expression> {
        self.needs_motion()?;
        self.law.rates.push(Rate::Of(of));
        Ok(Expression::Rate(self.law.rates.len() - 1))
    }

    fn power(&mut self, name: &str) -> Read<Expression> {
        if self.may < May::Results {
            return Err(DefinitionError::value(self.part, "a power stands in a law of motion"));
        }
        let load = self.reader.loads.get(name).ok_or_else(|| DefinitionError::unknown(self.part, name))?;
        self.law.rates.push(Rate::Power(Box::new(load.clone())));
        Ok(Expression::Rate(self.law.rates.len() - 1))
    }

    /// What follows from accelerations or multipliers.
    fn result(&self, name: &str) -> DefinitionError {
        DefinitionError::not_there_yet(self.part, &format!("`{name}`, a result, in an expression"))
    }

    fn energy(&mut self, name: &str) -> Read<Expression> {
        let which = match name {
            "kinetic_energy" => Energy::Kinetic,
            "potential_energy" => Energy::Potential,
            _ => Energy::Both,
        };
        let Some(energies) = self.reader.energies.as_ref().filter(|_| self.may == May::Results) else {
            return Err(DefinitionError::value(self.part, "an energy stands in a law of motion"));
        };
        self.law.rates.push(Rate::Energy(energies.clone(), which));
        Ok(Expression::Rate(self.law.rates.len() - 1))
    }

    fn needs_motion(&self) -> Read<()> {
        if self.may >= May::Motion {
            return Ok(());
        }
        Err(DefinitionError::value(self.part, "a velocity stands where only positions may"))
    }
}

fn with_number(word: &str, number: Option<&str>) -> String {
    number.map_or(word.to_string(), |number| format!("{word}_{number}"))
}

fn unary(function: &str) -> Option<Function> {
    Some(match function {
        "sqrt" => Function::Sqrt,
        "abs" => Function::Abs,
        "sign" => Function::Sign,
        "sin" => Function::Sin,
        "cos" => Function::Cos,
        "tan" => Function::Tan,
        "asin" => Function::Asin,
        "acos" => Function::Acos,
        "atan" => Function::Atan,
        "exp" => Function::Exp,
        "ln" => Function::Ln,
        "log10" => Function::Log10,
        "sinh" => Function::Sinh,
        "cosh" => Function::Cosh,
        "tanh" => Function::Tanh,
        "step" => Function::Step,
        "wrap" => Function::WrapAngle,
        _ => return None,
    })
}

fn binary(function: &str) -> Option<Operator> {
    Some(match function {
        "min" => Operator::Min,
        "max" => Operator::Max,
        "atan2" => Operator::Atan2,
        "deadband" => Operator::Deadband,
        "wrap" => Operator::Wrap,
        _ => return None,
    })
}

/// Of numbers, as against places and loads.
pub(super) fn is_function(name: &str) -> bool {
    unary(name).is_some() || binary(name).is_some() || matches!(name, "if" | "hypot" | "clamp" | "smoothstep")
}
