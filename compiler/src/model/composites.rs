//! Functions of expressions that are made of others: limits, bands, steps, and values that repeat.

use super::fold::{binary, power, unary};
use super::{Comparison, Condition, Expr, Function1, Function2};

/// √(x² + y²).
pub(super) fn hypot(x: Expr, y: Expr) -> Expr {
    unary(Function1::Sqrt, binary(Function2::Add, power(x, 2.0), power(y, 2.0)))
}

/// x, but at least `least` and at most `most`.
pub(super) fn clamp(x: Expr, least: Expr, most: Expr) -> Expr {
    binary(Function2::Max, least, binary(Function2::Min, x, most))
}

/// What of x is beyond the band from −`half` to `half`: zero within it.
pub(super) fn deadband(x: Expr, half: Expr) -> Expr {
    let within = clamp(x.clone(), unary(Function1::Neg, half.clone()), half);
    binary(Function2::Sub, x, within)
}

/// 0 up to `from`, 1 beyond `to`, s² (3 − 2s) between with s = (x − from)/(to − from): with continuous slope.
pub(super) fn smoothstep(x: Expr, from: Expr, to: Expr) -> Expr {
    let width = binary(Function2::Sub, to, from.clone());
    let share = binary(Function2::Div, binary(Function2::Sub, x, from), width);
    let s = clamp(share, Expr::Number(0.0), Expr::Number(1.0));
    let rest =
        binary(Function2::Sub, Expr::Number(3.0), binary(Function2::Mul, Expr::Number(2.0), s.clone()));
    binary(Function2::Mul, power(s, 2.0), rest)
}

/// 1 where x is positive, else 0.
pub(super) fn step(x: Expr) -> Expr {
    if let Expr::Number(value) = x {
        return Expr::Number(if value > 0.0 { 1.0 } else { 0.0 });
    }
    let positive = Condition::Compare(Comparison::Greater, x, Expr::Number(0.0));
    Expr::If(Box::new(positive), Box::new(Expr::Number(1.0)), Box::new(Expr::Number(0.0)))
}

/// x less whole periods, from 0 on: x − p ⌊x/p⌋.
pub(super) fn wrap(x: Expr, period: Expr) -> Expr {
    let periods = unary(Function1::Floor, binary(Function2::Div, x.clone(), period.clone()));
    binary(Function2::Sub, x, binary(Function2::Mul, period, periods))
}

/// An angle less whole turns, in [−π, π).
pub(super) fn wrap_angle(x: Expr) -> Expr {
    let turn = std::f64::consts::TAU;
    let turned =
        binary(Function2::Add, binary(Function2::Div, x.clone(), Expr::Number(turn)), Expr::Number(0.5));
    binary(Function2::Sub, x, binary(Function2::Mul, Expr::Number(turn), unary(Function1::Floor, turned)))
}
