//! Tables on the graph: the row that the argument is in, which value and derivatives share, and the polynomial of that row.

mod profile;

use super::jet::Moving;
use crate::model::{Curve, LookUp};
use crate::symbolic::{Node, Op, Orders, Scalar, Sheet, Unary};
use profile::Foot;
use std::f64::consts::TAU;

/// Derivatives of a table at one place.
struct Found<'g> {
    /// What the polynomial is of: less whole periods of what repeats itself.
    arguments: Vec<Scalar<'g>>,
    cell: Scalar<'g>,
    table: u16,
    /// Those that the expression asks for.
    orders: Orders,
}

impl<'g> Found<'g> {
    fn of(look_up: &LookUp, arguments: &[Scalar<'g>], turns: &[Node], g: Sheet<'g>) -> Option<Self> {
        let orders = look_up.orders;
        match (&*look_up.curve, arguments) {
            (Curve::Line { pieces, period }, [x]) => {
                let table = g.graph().enter(pieces);
                let x = match period {
                    // x − P ⌊(x − x₀)/P⌋
                    Some([start, length]) => {
                        let x = if divides_a_turn(*length) { less_turns(*x, turns) } else { *x };
                        x - *length * floor((x - *start) / *length)
                    }
                    None => *x,
                };
                Some(Found { arguments: vec![x], cell: x.cell(table), table, orders })
            }
            (Curve::Grid { axes, patches }, [x, y]) => {
                let [rows, columns] = [0, 1].map(|k| g.graph().enter(&axes[k]));
                let table = g.graph().enter(patches);
                let width = axes[1].rows().len() as f64;
                let cell = width * x.cell(rows) + y.cell(columns);
                Some(Found { arguments: vec![*x, *y], cell, table, orders })
            }
            _ => None,
        }
    }

    /// Differentiated so often more.
    fn derivative(&self, first: u8, second: u8) -> Scalar<'g> {
        let orders = Orders::new(self.orders.first() + first, self.orders.second() + second);
        match self.arguments[..] {
            [x, y] => x.patch(self.table, orders, self.cell, y),
            _ => self.arguments[0].piece(self.table, orders.first(), self.cell),
        }
    }
}

/// Whether whole turns are whole periods.
fn divides_a_turn(period: f64) -> bool {
    let periods = TAU / period;
    periods >= 0.5 && (periods - periods.round()).abs() <= 1e-12
}

/// A sum without the whole turns 2π n that stand in it, which a table with such a period does not see: a counted angle then has no more
/// rounding after many turns than after one.
fn less_turns<'g>(x: Scalar<'g>, turns: &[Node]) -> Scalar<'g> {
    let g = x.g;
    let op = g.graph().op(x.bare);
    match op {
        Op::Mul(factor, n) if turns.contains(&n) && g.on(factor).value() == Some(TAU) => g.zero(),
        Op::Add(a, b) => less_turns(g.on(a), turns) + less_turns(g.on(b), turns),
        Op::Sub(a, b) => less_turns(g.on(a), turns) - less_turns(g.on(b), turns),
        Op::Neg(a) => -less_turns(g.on(a), turns),
        _ => x,
    }
}

fn floor(x: Scalar) -> Scalar {
    x.unary(Unary::Floor)
}

/// The value of a table in an expression; `turns`: the symbols that count whole turns of angles.
pub fn value<'g>(look_up: &LookUp, arguments: &[Scalar<'g>], turns: &[Node], g: Sheet<'g>) -> Scalar<'g> {
    if let Some(foot) = Foot::of(look_up, arguments) {
        return foot.derivative(look_up.orders);
    }
    Found::of(look_up, arguments, turns, g).map_or_else(|| g.zero(), |found| found.derivative(0, 0))
}

/// f(x): ḟ = f′ ẋ, f̈ = f′ ẍ + f″ ẋ²; of two arguments by the chain rule of both.
pub fn jet<'g>(look_up: &LookUp, arguments: &[Moving<'g>], turns: &[Node]) -> Option<Moving<'g>> {
    let g = arguments.first()?.g;
    let values: Vec<Scalar> = arguments.iter().map(|it| it.value()).collect();
    if let (Some(foot), [x, y, _]) = (Foot::of(look_up, &values), arguments) {
        let orders = look_up.orders;
        let of =
            |first, second| foot.derivative(Orders::new(orders.first() + first, orders.second() + second));
        return Some(of_two([x, y], of));
    }
    let found = Found::of(look_up, &values, turns, g)?;
    let of = |first, second| found.derivative(first, second);
    match arguments {
        [x] => Some(x.chain(of(0, 0), of(1, 0), of(2, 0))),
        [x, y] => Some(of_two([x, y], of)),
        _ => None,
    }
}

/// By the derivatives of a function of two.
fn of_two<'g>([x, y]: [&Moving<'g>; 2], of: impl Fn(u8, u8) -> Scalar<'g>) -> Moving<'g> {
    let mut result = of(1, 0) * x + of(0, 1) * y;
    let (u, v) = (x.rate(), y.rate());
    let curved = of(2, 0) * u.square() + 2.0 * (of(1, 1) * (u * v)) + of(0, 2) * v.square();
    result.jet.value = of(0, 0).bare;
    result.jet.bias = (result.bias() + curved).bare;
    result
}
