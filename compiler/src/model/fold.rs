//! Building expressions with what holds numbers only computed at once, and evaluating those of parameters.
//!
//! Transcendental functions come from `libm`, so that the same definition folds to the same bits everywhere.

use super::tables::LookUp;
use super::{Expr, Function1, Function2, Vector};

/// A function of one argument, computed if that is a number.
pub(crate) fn unary(function: Function1, x: Expr) -> Expr {
    match x {
        Expr::Number(value) => Expr::Number(compute_unary(function, value)),
        Expr::Unary(Function1::Neg, inner) if function == Function1::Neg => *inner,
        _ => Expr::Unary(function, Box::new(x)),
    }
}

/// A function of two arguments, computed if both are numbers; a zero or one that changes nothing is left out.
pub(crate) fn binary(function: Function2, x: Expr, y: Expr) -> Expr {
    match (function, &x, &y) {
        (_, Expr::Number(a), Expr::Number(b)) => Expr::Number(compute_binary(function, *a, *b)),
        (Function2::Add, Expr::Number(0.0), _) => y,
        (Function2::Add | Function2::Sub, _, Expr::Number(0.0)) => x,
        (Function2::Sub, Expr::Number(0.0), _) => unary(Function1::Neg, y),
        (Function2::Mul, Expr::Number(0.0), _) | (Function2::Mul, _, Expr::Number(0.0)) => Expr::Number(0.0),
        (Function2::Mul, Expr::Number(1.0), _) => y,
        (Function2::Mul | Function2::Div, _, Expr::Number(1.0)) => x,
        _ => Expr::Binary(function, Box::new(x), Box::new(y)),
    }
}

/// From one point to another. What varies and both have in common is not in it.
pub(crate) fn between(from: &Vector, to: &Vector) -> Vector {
    [0, 1, 2].map(|axis| {
        let [from, to] = [from, to].map(|point| &point[axis]);
        if !(from.varies() && to.varies()) {
            return binary(Function2::Sub, to.clone(), from.clone());
        }
        let mut left = addends(to, false);
        for (part, is_negative) in addends(from, true) {
            match left.iter().position(|(other, sign)| *other == part && *sign != is_negative) {
                Some(common) => drop(left.swap_remove(common)),
                None => left.push((part, is_negative)),
            }
        }
        left.into_iter().fold(Expr::Number(0.0), |sum, (part, is_negative)| {
            binary(if is_negative { Function2::Sub } else { Function2::Add }, sum, part.clone())
        })
    })
}

/// What a sum is of, each with whether it is taken away.
fn addends(sum: &Expr, is_negative: bool) -> Vec<(&Expr, bool)> {
    match sum {
        Expr::Unary(Function1::Neg, x) => addends(x, !is_negative),
        Expr::Binary(function @ (Function2::Add | Function2::Sub), x, y) => {
            let mut found = addends(x, is_negative);
            found.extend(addends(y, is_negative != (*function == Function2::Sub)));
            found
        }
        _ => vec![(sum, is_negative)],
    }
}

/// A constant power.
pub(crate) fn power(base: Expr, exponent: f64) -> Expr {
    match base {
        Expr::Number(value) => Expr::Number(libm::pow(value, exponent)),
        _ if exponent == 1.0 => base,
        _ => Expr::Power(Box::new(base), exponent),
    }
}

/// A table, looked up in if the arguments are numbers.
pub(crate) fn table(look_up: LookUp) -> Expr {
    let number = |expr: &Expr| if let Expr::Number(value) = expr { Some(*value) } else { None };
    match look_up.arguments.iter().map(number).collect::<Option<Vec<f64>>>() {
        Some(numbers) => Expr::Number(look_up.curve.at(look_up.orders, &numbers)),
        None => Expr::Table(Box::new(look_up)),
    }
}

/// The value of an expression of parameters, given theirs; `None` if it depends on anything else.
pub(crate) fn evaluate(expr: &Expr, parameters: &[f64]) -> Option<f64> {
    evaluate_at(expr, parameters, None)
}

/// The same of an expression that may name the time, s.
pub(crate) fn evaluate_at(expr: &Expr, parameters: &[f64], time: Option<f64>) -> Option<f64> {
    let value = |expr: &Expr| evaluate_at(expr, parameters, time);
    match expr {
        Expr::Number(value) => Some(*value),
        Expr::Parameter(id) => parameters.get(id.0).copied(),
        Expr::Time => time,
        Expr::Unary(function, x) => Some(compute_unary(*function, value(x)?)),
        Expr::Binary(function, x, y) => Some(compute_binary(*function, value(x)?, value(y)?)),
        Expr::Power(base, exponent) => Some(libm::pow(value(base)?, *exponent)),
        Expr::Table(look_up) => {
            let numbers: Vec<f64> = look_up.arguments.iter().map(value).collect::<Option<_>>()?;
            Some(look_up.curve.at(look_up.orders, &numbers))
        }
        Expr::Input(_)
        | Expr::State(_)
        | Expr::Memory(_)
        | Expr::Gate(..)
        | Expr::Quantity(_)
        | Expr::If(..)
        | Expr::Rate(_) => None,
    }
}

fn compute_unary(function: Function1, x: f64) -> f64 {
    match function {
        Function1::Neg => -x,
        Function1::Sqrt => libm::sqrt(x),
        Function1::Abs => x.abs(),
        Function1::Sign if x > 0.0 => 1.0,
        Function1::Sign if x < 0.0 => -1.0,
        Function1::Sign => x * 0.0,
        Function1::Sin => libm::sin(x),
        Function1::Cos => libm::cos(x),
        Function1::Tan => libm::tan(x),
        Function1::Asin => libm::asin(x),
        Function1::Acos => libm::acos(x),
        Function1::Exp => libm::exp(x),
        Function1::Ln => libm::log(x),
        Function1::Log10 => libm::log10(x),
        Function1::Sinh => libm::sinh(x),
        Function1::Cosh => libm::cosh(x),
        Function1::Tanh => libm::tanh(x),
        Function1::Floor => libm::floor(x),
    }
}

fn compute_binary(function: Function2, x: f64, y: f64) -> f64 {
    match function {
        Function2::Add => x + y,
        Function2::Sub => x - y,
        Function2::Mul => x * y,
        Function2::Div => x / y,
        Function2::Min => x.min(y),
        Function2::Max => x.max(y),
        Function2::Atan2 => libm::atan2(x, y),
    }
}
