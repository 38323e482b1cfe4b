//! Where a function of what moves has no slope, or breaks off: what joints on curves refuse.

use super::composites::{clamps_of_smoothstep, is_step};
use super::{Expr, Function1, Function2};

/// What is wrong with a function, and by which word of it.
pub(super) enum Kink {
    /// Its slope or its value jumps.
    Corner(&'static str),
    /// It is one of two, which need not meet.
    Choice(&'static str),
}

/// The first of them. What does not move is a number, and has none.
pub(super) fn first(value: &Expr) -> Option<Kink> {
    let mut found = None;
    let mut smooth: Vec<&Expr> = Vec::new();
    value.visit(&mut |part| {
        // Parts come after what they are parts of. Where a smoothstep is clamped its slope is zero on both sides.
        smooth.extend(clamps_of_smoothstep(part).into_iter().flatten());
        let is_smooth = smooth.iter().any(|known| std::ptr::eq(*known, part));
        if found.is_none() && !is_smooth && part.moves() {
            found = own(part);
        }
    });
    found
}

fn own(part: &Expr) -> Option<Kink> {
    match part {
        Expr::Unary(Function1::Abs, _) => Some(Kink::Corner("abs")),
        Expr::Unary(Function1::Sign, _) => Some(Kink::Corner("sign")),
        Expr::Unary(Function1::Floor, _) => Some(Kink::Corner("wrap")),
        Expr::Binary(Function2::Min, ..) => Some(Kink::Corner("min")),
        Expr::Binary(Function2::Max, ..) => Some(Kink::Corner("max")),
        Expr::If(..) if is_step(part) => Some(Kink::Choice("step")),
        Expr::If(condition, ..) if condition.moves() => Some(Kink::Choice("if")),
        _ => None,
    }
}
