//! Expressions of laws and constraints as small trees, evaluated at run time in any [`Number`]. They name quantities of the motion by
//! index; `law` says what these are, `reading` makes the trees.

use crate::number::{Number, sign};
use crate::table::Look;
use std::f64::consts::PI;

/// A tree. Truth is 1, falsehood 0.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Expression {
    Number(f64),
    Time,
    Input(usize),
    State(usize),
    /// One of the law's quantities of positions.
    Quantity(usize),
    /// One of the law's rates; never in a law of positions.
    Rate(usize),
    Unary(Function, Box<Expression>),
    Binary(Operator, Box<[Expression; 2]>),
    /// Condition, then, else.
    If(Box<[Expression; 3]>),
    /// Of two arguments, the second of which counts for tables of two.
    Table(Look, Box<[Expression; 2]>),
}

/// Functions of one argument.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Function {
    Negative,
    Not,
    Sqrt,
    Abs,
    Sign,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Exp,
    Ln,
    Log10,
    Sinh,
    Cosh,
    Tanh,
    Step,
    /// x^n, n known.
    Power(f64),
    /// 3s² − 2s³ within 0..1, and its ends beyond.
    Smoothstep,
    /// Into [−π, π).
    WrapAngle,
}

/// Of two arguments.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Operator {
    Plus,
    Minus,
    Times,
    Over,
    Min,
    Max,
    /// y, x.
    Atan2,
    Deadband,
    /// Into [0, period).
    Wrap,
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
    Equal,
    NotEqual,
    And,
    Or,
}

/// What the leaves of an expression stand for.
pub(crate) struct Scope<'a, N> {
    pub time: N,
    pub inputs: &'a [f64],
    pub states: &'a [f64],
    pub quantities: &'a [N],
    pub rates: &'a [f64],
}

impl Expression {
    pub fn unary(function: Function, argument: Expression) -> Self {
        Expression::Unary(function, Box::new(argument))
    }

    pub fn binary(operator: Operator, a: Expression, b: Expression) -> Self {
        Expression::Binary(operator, Box::new([a, b]))
    }

    /// Its value, if it names nothing.
    pub fn constant(&self) -> Option<f64> {
        match self {
            Expression::Number(value) => return Some(*value),
            Expression::Time
            | Expression::Input(_)
            | Expression::State(_)
            | Expression::Quantity(_)
            | Expression::Rate(_) => return None,
            Expression::Unary(_, argument) => argument.constant().map(|_| ())?,
            Expression::Binary(_, arguments) => all_constant(&arguments[..])?,
            Expression::If(arguments) => all_constant(&arguments[..])?,
            Expression::Table(_, arguments) => all_constant(&arguments[..])?,
        }
        Some(self.evaluate(&Scope { time: 0.0, inputs: &[], states: &[], quantities: &[], rates: &[] }))
    }

    pub fn evaluate<N: Number>(&self, scope: &Scope<'_, N>) -> N {
        match self {
            Expression::Number(value) => N::constant(*value),
            Expression::Time => scope.time,
            Expression::Input(at) => N::constant(scope.inputs[*at]),
            Expression::State(at) => N::constant(scope.states[*at]),
            Expression::Quantity(at) => scope.quantities[*at],
            Expression::Rate(at) => N::constant(scope.rates[*at]),
            Expression::Unary(function, argument) => function.of(argument.evaluate(scope)),
            Expression::Binary(operator, arguments) => {
                let [a, b] = &**arguments;
                operator.of(a.evaluate(scope), b.evaluate(scope))
            }
            Expression::If(arguments) => {
                let [condition, then, otherwise] = &**arguments;
                let holds = condition.evaluate(scope).value() != 0.0;
                if holds { then } else { otherwise }.evaluate(scope)
            }
            Expression::Table(look, arguments) => {
                let [x, y] = &**arguments;
                look.of(x.evaluate(scope), y.evaluate(scope))
            }
        }
    }
}

fn all_constant(arguments: &[Expression]) -> Option<()> {
    arguments.iter().all(|argument| argument.constant().is_some()).then_some(())
}

impl Function {
    /// Each with its value and its first two derivatives.
    fn of<N: Number>(self, argument: N) -> N {
        let x = argument.value();
        let truth = |holds: bool| N::constant(f64::from(u8::from(holds)));
        match self {
            Function::Negative => argument.scaled(-1.0),
            Function::Not => truth(x == 0.0),
            Function::Sqrt => {
                let root = x.sqrt();
                argument.chain(root, 0.5 / root, -0.25 / (x * root))
            }
            Function::Abs => argument.scaled(sign(x)),
            Function::Sign => N::constant(sign(x)),
            Function::Sin => argument.chain(x.sin(), x.cos(), -x.sin()),
            Function::Cos => argument.chain(x.cos(), -x.sin(), -x.cos()),
            Function::Tan => {
                let (t, slope) = (x.tan(), 1.0 + x.tan() * x.tan());
                argument.chain(t, slope, 2.0 * t * slope)
            }
            Function::Asin => {
                let slope = 1.0 / (1.0 - x * x).sqrt();
                argument.chain(x.asin(), slope, x * slope * slope * slope)
            }
            Function::Acos => {
                let slope = -1.0 / (1.0 - x * x).sqrt();
                argument.chain(x.acos(), slope, x * slope * slope * slope)
            }
            Function::Atan => {
                let slope = 1.0 / (1.0 + x * x);
                argument.chain(x.atan(), slope, -2.0 * x * slope * slope)
            }
            Function::Exp => argument.chain(x.exp(), x.exp(), x.exp()),
            Function::Ln => argument.chain(x.ln(), 1.0 / x, -1.0 / (x * x)),
            Function::Log10 => {
                let ten = std::f64::consts::LN_10;
                argument.chain(x.log10(), 1.0 / (x * ten), -1.0 / (x * x * ten))
            }
            Function::Sinh => argument.chain(x.sinh(), x.cosh(), x.sinh()),
            Function::Cosh => argument.chain(x.cosh(), x.sinh(), x.cosh()),
            Function::Tanh => {
                let (t, slope) = (x.tanh(), 1.0 - x.tanh() * x.tanh());
                argument.chain(t, slope, -2.0 * t * slope)
            }
            Function::Step => truth(x > 0.0),
            Function::Power(n) => power(argument, n),
            Function::Smoothstep if x <= 0.0 => N::constant(0.0),
            Function::Smoothstep if x >= 1.0 => N::constant(1.0),
            Function::Smoothstep => {
                argument.chain(x * x * (3.0 - 2.0 * x), 6.0 * x * (1.0 - x), 6.0 - 12.0 * x)
            }
            Function::WrapAngle => argument.minus(N::constant(2.0 * PI * ((x + PI) / (2.0 * PI)).floor())),
        }
    }
}

/// x^n; derivatives of x^0, x^1 at zero have no quotient.
fn power<N: Number>(argument: N, n: f64) -> N {
    let x = argument.value();
    let raised = |n: f64| match n {
        0.0 => 1.0,
        n if n == n.trunc() && n.abs() <= 64.0 => x.powi(n as i32),
        n => x.powf(n),
    };
    let first = if n == 0.0 { 0.0 } else { n * raised(n - 1.0) };
    let second = if n == 0.0 || n == 1.0 { 0.0 } else { n * (n - 1.0) * raised(n - 2.0) };
    argument.chain(raised(n), first, second)
}

impl Operator {
    fn of<N: Number>(self, a: N, b: N) -> N {
        let (x, y) = (a.value(), b.value());
        let truth = |holds: bool| N::constant(f64::from(u8::from(holds)));
        match self {
            Operator::Plus => a.plus(b),
            Operator::Minus => a.minus(b),
            Operator::Times => a.times(b),
            Operator::Over => a.over(b),
            // What is no number stays none.
            Operator::Min => {
                if y < x || y.is_nan() {
                    b
                } else {
                    a
                }
            }
            Operator::Max => {
                if y > x || y.is_nan() {
                    b
                } else {
                    a
                }
            }
            Operator::Atan2 => atan2(a, b),
            Operator::Deadband if x > y => a.minus(b),
            Operator::Deadband if x < -y => a.plus(b),
            Operator::Deadband => a.scaled(0.0),
            Operator::Wrap => a.minus(b.scaled((x / y).floor())),
            Operator::Less => truth(x < y),
            Operator::LessOrEqual => truth(x <= y),
            Operator::Greater => truth(x > y),
            Operator::GreaterOrEqual => truth(x >= y),
            Operator::Equal => truth(x == y),
            Operator::NotEqual => truth(x != y),
            Operator::And => truth(x != 0.0 && y != 0.0),
            Operator::Or => truth(x != 0.0 || y != 0.0),
        }
    }
}

/// The angle of (x, y). About its value φ it is φ + atan of the tangent of what it turns by, which has all derivatives there.
fn atan2<N: Number>(y: N, x: N) -> N {
    let (sine, cosine) = (y.value(), x.value());
    let across = y.scaled(cosine).minus(x.scaled(sine));
    let along = x.scaled(cosine).plus(y.scaled(sine));
    Function::Atan.of(across.over(along)).plus(N::constant(sine.atan2(cosine)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Slope, Taylor};

    const FUNCTIONS: [Function; 19] = [
        Function::Negative,
        Function::Sqrt,
        Function::Abs,
        Function::Sin,
        Function::Cos,
        Function::Tan,
        Function::Asin,
        Function::Acos,
        Function::Atan,
        Function::Exp,
        Function::Ln,
        Function::Log10,
        Function::Sinh,
        Function::Cosh,
        Function::Tanh,
        Function::Smoothstep,
        Function::Power(2.5),
        Function::Power(-2.0),
        Function::WrapAngle,
    ];

    /// Of (t, 0.3 + t²) at 0.4: value, first and second derivative by t.
    fn taylor(expression: &Expression) -> Taylor {
        let time = Taylor { value: 0.4, rate: 1.0, bias: 0.0 };
        let square = Taylor { value: 0.46, rate: 0.8, bias: 2.0 };
        expression.evaluate(&Scope { time, inputs: &[], states: &[], quantities: &[square], rates: &[] })
    }

    fn value(expression: &Expression, t: f64) -> f64 {
        expression.evaluate(&Scope {
            time: t,
            inputs: &[],
            states: &[],
            quantities: &[0.3 + t * t],
            rates: &[],
        })
    }

    fn is_differentiated(expression: &Expression) {
        let (found, h) = (taylor(expression), 1e-4);
        let [before, at, behind] = [0.4 - h, 0.4, 0.4 + h].map(|t| value(expression, t));
        let rate = (behind - before) / (2.0 * h);
        let bias = (behind - 2.0 * at + before) / (h * h);
        assert_eq!(found.value, at, "{expression:?}");
        assert!((found.rate - rate).abs() < 1e-5 * (1.0 + rate.abs()), "{expression:?}: {found:?} {rate}");
        assert!((found.bias - bias).abs() < 1e-4 * (1.0 + bias.abs()), "{expression:?}: {found:?} {bias}");
        let slope = expression.evaluate(&Scope {
            time: Slope { value: 0.4, slope: 1.0 },
            inputs: &[],
            states: &[],
            quantities: &[Slope { value: 0.46, slope: 0.8 }],
            rates: &[],
        });
        assert!((slope.slope - found.rate).abs() < 1e-14 * (1.0 + rate.abs()));
    }

    #[test]
    fn derivatives_are_those_of_differences() {
        for function in FUNCTIONS {
            is_differentiated(&Expression::unary(function, Expression::Quantity(0)));
        }
        use Operator::*;
        for operator in [Plus, Minus, Times, Over, Min, Max, Atan2, Deadband, Wrap] {
            is_differentiated(&Expression::binary(operator, Expression::Quantity(0), Expression::Time));
            is_differentiated(&Expression::binary(operator, Expression::Time, Expression::Quantity(0)));
        }
    }

    #[test]
    fn an_expression_without_names_is_a_constant() {
        let sum = Expression::binary(Operator::Plus, Expression::Number(1.0), Expression::Number(2.0));
        assert_eq!(sum.constant(), Some(3.0));
        assert_eq!(Expression::binary(Operator::Plus, sum, Expression::Time).constant(), None);
    }
}
