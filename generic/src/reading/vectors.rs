//! Vectors within expressions: places, their velocities, sums, differences and multiples of them, along the world's axes.

use super::Read;
use super::laws::LawReader;
use crate::error::DefinitionError;
use crate::expression::{Expression, Function, Operator};
use crate::json::{list, optional, text};
use crate::quantity::Quantity;
use serde_json::Value;

type Vector = [Expression; 3];

impl LawReader<'_, '_> {
    pub fn distance(&mut self, a: &Value, b: &Value) -> Read<Expression> {
        let (a, b) = (self.needed_vector(a)?, self.needed_vector(b)?);
        Ok(length(together(Operator::Minus, a, b)))
    }

    pub fn norm(&mut self, a: &Value) -> Read<Expression> {
        Ok(length(self.needed_vector(a)?))
    }

    pub fn dot(&mut self, a: &Value, b: &Value) -> Read<Expression> {
        let (a, b) = (self.needed_vector(a)?, self.needed_vector(b)?);
        Ok(sum(together(Operator::Times, a, b)))
    }

    /// a_x b_y − a_y b_x.
    pub fn plane_cross(&mut self, a: &Value, b: &Value) -> Read<Expression> {
        let (a, b) = (self.needed_vector(a)?, self.needed_vector(b)?);
        let [_, _, z] = crossed(a, b);
        Ok(z)
    }

    fn needed_vector(&mut self, node: &Value) -> Read<Vector> {
        self.vector(node)?.ok_or_else(|| DefinitionError::value(self.part, "what should be a vector is none"))
    }

    /// `None` where it is a number.
    fn vector(&mut self, node: &Value) -> Read<Option<Vector>> {
        if optional(node, "ground").is_some() {
            let components = self.reader.ground_components(node, self.part)?;
            return Ok(Some(components));
        }
        if optional(node, "name").is_some() {
            return self.named_vector(text(node, "name", self.part)?);
        }
        let arguments = list(node, "args", self.part)?;
        if let (Some("cross"), [a, b]) = (node.get("call").and_then(Value::as_str), arguments) {
            return Ok(match (self.vector(a)?, self.vector(b)?) {
                (Some(a), Some(b)) => Some(crossed(a, b)),
                _ => None,
            });
        }
        let Some(operator) = node.get("op").and_then(Value::as_str) else { return Ok(None) };
        match (operator, arguments) {
            ("neg" | "-", [one]) => Ok(self
                .vector(one)?
                .map(|one| one.map(|component| Expression::unary(Function::Negative, component)))),
            ("+" | "-", [a, b]) => {
                let operator = if operator == "+" { Operator::Plus } else { Operator::Minus };
                let both = (self.vector(a)?, self.vector(b)?);
                Ok(if let (Some(a), Some(b)) = both { Some(together(operator, a, b)) } else { None })
            }
            ("*" | "/", [a, b]) => {
                let operator = if operator == "*" { Operator::Times } else { Operator::Over };
                if let Some(vector) = self.vector(a)? {
                    let factor = self.expression(b)?;
                    return Ok(Some(vector.map(|x| Expression::binary(operator, x, factor.clone()))));
                }
                let Some(vector) = self.vector(b)? else { return Ok(None) };
                let factor = self.expression(a)?;
                Ok(Some(vector.map(|x| Expression::binary(operator, factor.clone(), x))))
            }
            _ => Ok(None),
        }
    }

    fn named_vector(&mut self, name: &str) -> Read<Option<Vector>> {
        let (place, is_rate) = match name.strip_suffix(".velocity") {
            Some(place) => (place, true),
            None => (name, false),
        };
        let Some(place) = self.reader.named_place(place) else { return Ok(None) };
        let mut components = [const { Expression::Number(0.0) }; 3];
        for (axis, component) in components.iter_mut().enumerate().take(self.reader.dimension()) {
            let leaf = self.leaf(Quantity::Coordinate { place: place.clone(), axis });
            *component = if is_rate { self.rate(leaf)? } else { leaf };
        }
        Ok(Some(components))
    }
}

fn together(operator: Operator, [a, b, c]: Vector, [d, e, f]: Vector) -> Vector {
    [
        Expression::binary(operator, a, d),
        Expression::binary(operator, b, e),
        Expression::binary(operator, c, f),
    ]
}

fn sum([a, b, c]: Vector) -> Expression {
    Expression::binary(Operator::Plus, Expression::binary(Operator::Plus, a, b), c)
}

fn length(vector: Vector) -> Expression {
    Expression::unary(Function::Sqrt, sum(vector.map(|x| Expression::unary(Function::Power(2.0), x))))
}

fn crossed(a: Vector, b: Vector) -> Vector {
    let component = |i: usize, j: usize| {
        let product = |i: usize, j: usize| Expression::binary(Operator::Times, a[i].clone(), b[j].clone());
        Expression::binary(Operator::Minus, product(i, j), product(j, i))
    };
    [component(1, 2), component(2, 0), component(0, 1)]
}
