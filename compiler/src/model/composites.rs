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
    rounded(clamp(share, Expr::Number(0.0), Expr::Number(1.0)))
}

/// s² (3 − 2s), whose slope is zero at 0 and at 1.
fn rounded(s: Expr) -> Expr {
    let rest =
        binary(Function2::Sub, Expr::Number(3.0), binary(Function2::Mul, Expr::Number(2.0), s.clone()));
    binary(Function2::Mul, power(s, 2.0), rest)
}

/// Of a smoothstep the operations that clamp its share: corners by themselves, and none of the whole.
pub(super) fn clamps_of_smoothstep(value: &Expr) -> Option<[&Expr; 4]> {
    let Expr::Binary(Function2::Mul, square, rest) = value else { return None };
    let (Expr::Power(s, _), Expr::Binary(Function2::Sub, _, twice)) = (&**square, &**rest) else {
        return None;
    };
    let Expr::Binary(Function2::Mul, _, again) = &**twice else { return None };
    (*value == rounded((**s).clone())).then_some([s, within(s)?, again, within(again)?])
}

/// What is kept below 1 in what is clamped from 0 to 1.
fn within(clamped: &Expr) -> Option<&Expr> {
    let Expr::Binary(Function2::Max, least, within) = clamped else { return None };
    let Expr::Binary(Function2::Min, _, most) = &**within else { return None };
    (**least == Expr::Number(0.0) && **most == Expr::Number(1.0)).then_some(within)
}

/// 1 where x is positive, else 0.
pub(super) fn step(x: Expr) -> Expr {
    if let Expr::Number(value) = x {
        return Expr::Number(if value > 0.0 { 1.0 } else { 0.0 });
    }
    let positive = Condition::Compare(Comparison::Greater, x, Expr::Number(0.0));
    Expr::If(Box::new(positive), Box::new(Expr::Number(1.0)), Box::new(Expr::Number(0.0)))
}

/// Whether a choice is what `step` makes of something.
pub(super) fn is_step(value: &Expr) -> bool {
    let Expr::If(condition, _, _) = value else { return false };
    let Condition::Compare(Comparison::Greater, x, _) = &**condition else { return false };
    *value == step(x.clone())
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
