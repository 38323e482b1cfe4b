//! Loads that remember where the motion has turned: Masing's backbones, and the law of Bouc and Wen. Both are laws with internal states,
//! deflections of springs in a row with sliders, and become expressions here like any other.

use super::laws::{LawReader, May};
use super::{Read, Reader};
use crate::definition::InternalState;
use crate::error::DefinitionError;
use crate::expression::{Expression, Function, Operator};
use crate::json::{field, list, name, text};
use crate::load::Acts;
use serde_json::{Value, json};

/// An element of a backbone that yields (Iwan 1966): m or rad, and its stiffness.
#[derive(Clone, Copy, Debug)]
struct Element {
    knot: f64,
    stiffness: f64,
}

/// An element less stiff than this share of the first slope is left out.
const LEAST: f64 = 1e-9;

pub(super) fn is_hysteresis(kind: &str) -> bool {
    matches!(kind, "masing" | "bouc_wen")
}

impl Reader<'_> {
    /// Names of the states of all such loads, in their order.
    pub(super) fn states_of_loads(&self) -> Read<Vec<String>> {
        let mut names = Vec::new();
        for node in list(self.tree, "loads", "loads")? {
            let own = name(node, "loads")?;
            match text(node, "kind", own)? {
                "bouc_wen" => names.push(format!("{own}.deflection")),
                "masing" => {
                    let (elements, _) = self.backbone(node, own)?;
                    names.extend((0..elements.len()).map(|k| format!("{own}.element[{k}]")));
                }
                _ => names.extend(self.bristles_of(node, own)?),
            }
        }
        Ok(names)
    }

    /// The resistance acts against the way.
    pub(super) fn hysteresis(&self, node: &Value, own: &str) -> Read<Acts> {
        let expression = self.reading(own, May::Positions, |law| law.way(node))?;
        let value = self.reading(own, May::Motion, |law| {
            Ok(Expression::unary(Function::Negative, law.resistance(node, own)?))
        })?;
        Ok(Acts::Along { expression, value })
    }

    /// The rates of the states of all such loads, in their order.
    pub(super) fn hysteresis_states(&self) -> Read<Vec<InternalState>> {
        let mut states = Vec::new();
        for node in list(self.tree, "loads", "loads")? {
            let own = name(node, "loads")?;
            let mut add = |name: String, rate| states.push(InternalState { name, start: 0.0, rate });
            match text(node, "kind", own)? {
                "bouc_wen" => {
                    add(
                        format!("{own}.deflection"),
                        self.reading(own, May::Motion, |law| law.bouc_wen_rate(node, own))?,
                    );
                }
                "masing" => {
                    for (k, element) in self.backbone(node, own)?.0.into_iter().enumerate() {
                        let name = format!("{own}.element[{k}]");
                        let rate =
                            self.reading(own, May::Motion, |law| law.element_rate(node, &name, element))?;
                        add(name, rate);
                    }
                }
                _ => states.extend(self.bristle_states(node, own)?),
            }
        }
        Ok(states)
    }

    /// The elements that yield, and the stiffness that is left behind the last knot. An element is as stiff as the slope that is lost at
    /// its knot.
    fn backbone(&self, node: &Value, own: &str) -> Read<(Vec<Element>, f64)> {
        let backbone = text(field(field(node, "backbone", own)?, "value", own)?, "name", own)?;
        let tables = list(self.tree, "tables", own)?;
        let table = tables.iter().find(|table| name(table, own) == Ok(backbone));
        let table = table.ok_or_else(|| DefinitionError::unknown(own, backbone))?;
        let unit = |node: &'_ Value| node.get("unit").and_then(Value::as_str).map(str::to_string);
        let argument = list(table, "arguments", own)?.first().and_then(unit);
        let (mut knots, mut slopes, mut last) = (Vec::new(), Vec::new(), [0.0; 2]);
        for point in list(table, "points", own)? {
            let [x, y] = point.as_array().map_or(&[][..], Vec::as_slice) else {
                return Err(DefinitionError::malformed(own, "a point of two numbers"));
            };
            let x = self.in_unit(x, argument.as_deref(), own)?;
            let y = self.in_unit(y, unit(table).as_deref(), own)?;
            if x > last[0] {
                knots.push(x);
                slopes.push((y - last[1]) / (x - last[0]));
                last = [x, y];
            }
        }
        let Some(first) = slopes.first().copied() else {
            return Err(DefinitionError::value(own, "its backbone has no points beyond the origin"));
        };
        let lasting = if text(table, "outside", own)? == "hold" { 0.0 } else { slopes[slopes.len() - 1] };
        slopes.push(lasting);
        let lost = knots.into_iter().zip(slopes.windows(2).map(|pair| pair[0] - pair[1]));
        let elements = lost.map(|(knot, stiffness)| Element { knot, stiffness });
        Ok((elements.filter(|element| element.stiffness > LEAST * first).collect(), lasting))
    }
}

fn times(a: Expression, b: Expression) -> Expression {
    Expression::binary(Operator::Times, a, b)
}

fn scaled(factor: f64, a: Expression) -> Expression {
    times(Expression::Number(factor), a)
}

fn plus(a: Expression, b: Expression) -> Expression {
    Expression::binary(Operator::Plus, a, b)
}

impl LawReader<'_, '_> {
    /// An expression of positions, or what a joint or body with one angle or travel moves along.
    fn way(&mut self, node: &Value) -> Read<Expression> {
        let expression = field(node, "expression", self.part)?;
        let named = expression.get("name").and_then(Value::as_str);
        match named.and_then(|name| self.reader.coordinate_of(name)) {
            Some(coordinate) => self.expression(&json!({ "name": coordinate })),
            None => self.expression(expression),
        }
    }

    fn way_rate(&mut self, node: &Value) -> Read<Expression> {
        let way = self.way(node)?;
        self.rate(way)
    }

    fn state(&self, name: &str) -> Read<Expression> {
        let at = self.reader.states.get(name).ok_or_else(|| DefinitionError::unknown(self.part, name))?;
        Ok(Expression::State(*at))
    }

    /// Masing: Σ k e of the elements, each at most at its knot, and k x of what never yields. Bouc and Wen: α k x + (1 − α) k z.
    pub(super) fn resistance(&mut self, node: &Value, own: &str) -> Read<Expression> {
        let way = self.way(node)?;
        if text(node, "kind", own)? == "bouc_wen" {
            let stiffness = self.reader.needed(node, "stiffness", own)?;
            let share = self.reader.entry_of(node, "share", own)?.unwrap_or(0.0);
            let deflection = self.state(&format!("{own}.deflection"))?;
            return Ok(plus(scaled(share * stiffness, way), scaled((1.0 - share) * stiffness, deflection)));
        }
        let (elements, lasting) = self.reader.backbone(node, own)?;
        let mut resistance = scaled(lasting, way);
        for (k, Element { knot, stiffness }) in elements.into_iter().enumerate() {
            let deflection = self.state(&format!("{own}.element[{k}]"))?;
            let low = Expression::binary(Operator::Max, deflection, Expression::Number(-knot));
            let held = Expression::binary(Operator::Min, low, Expression::Number(knot));
            resistance = plus(resistance, scaled(stiffness, held));
        }
        Ok(resistance)
    }

    /// ż = ẋ (1 − (β sgn(ẋ z) + γ) |z/z₀|ⁿ) (Wen 1976).
    fn bouc_wen_rate(&mut self, node: &Value, own: &str) -> Read<Expression> {
        let given = |key: &str| Ok(self.reader.entry_of(node, key, own)?.unwrap_or(0.0));
        let (beta, gamma, depth) = (given("beta")?, given("gamma")?, self.reader.needed(node, "depth", own)?);
        let exponent = self.reader.needed(node, "exponent", own)?;
        let (rate, deflection) = (self.way_rate(node)?, self.state(&format!("{own}.deflection"))?);
        let size = Expression::unary(Function::Abs, scaled(1.0 / depth, deflection.clone()));
        let direction = Expression::unary(Function::Sign, times(rate.clone(), deflection));
        let bent = plus(scaled(beta, direction), Expression::Number(gamma));
        let passed = times(bent, Expression::unary(Function::Power(exponent), size));
        Ok(times(rate, Expression::binary(Operator::Minus, Expression::Number(1.0), passed)))
    }

    /// ė = ẋ, but 0 where |e| is at the knot and goes on.
    fn element_rate(&mut self, node: &Value, state: &str, element: Element) -> Read<Expression> {
        let (rate, deflection) = (self.way_rate(node)?, self.state(state)?);
        let compared =
            |operator, a: &Expression, b: f64| Expression::binary(operator, a.clone(), Expression::Number(b));
        let both = |a, b| Expression::binary(Operator::And, a, b);
        let up = both(
            compared(Operator::GreaterOrEqual, &deflection, element.knot),
            compared(Operator::Greater, &rate, 0.0),
        );
        let down = both(
            compared(Operator::LessOrEqual, &deflection, -element.knot),
            compared(Operator::Less, &rate, 0.0),
        );
        let yields = Expression::binary(Operator::Or, up, down);
        Ok(Expression::If(Box::new([yields, Expression::Number(0.0), rate])))
    }
}
