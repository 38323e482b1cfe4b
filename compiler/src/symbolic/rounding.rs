//! What rounding made of constants: folding leaves a number and forgets how it came about, and 1 + 1e-6 − 1 is one millionth to
//! ten digits only. The graph keeps the bound beside the number, for those who must tell a mistake from a rounding.
//!
//! Running error analysis to first order (Higham, Accuracy and Stability of Numerical Algorithms, section 3.3), where a constant that
//! folding did not make is taken as a few units off: nobody knows how its number was computed.

use super::graph::{Graph, Node};
use super::hash::FastHash;
use super::{Orders, Table, Unary};
use std::collections::HashMap;

/// A constant that was not folded, in parts of itself.
const GIVEN: f64 = 16.0 * f64::EPSILON;

/// Roundings of each term of a piece: of its coefficient, and one for each operation.
const TERMS: f64 = 8.0;

/// Bounds by the bits of the magnitude: signs round nothing. A number keeps the bound that it came with, though others may
/// arrive at the same bits in worse ways: 1 is 1 wherever a quotient of two masses happens to be 1, and bounds that went
/// round such circles would grow without end.
#[derive(Clone, Debug, Default)]
pub(super) struct Roundings(HashMap<u64, f64, FastHash>);

impl Roundings {
    fn of(&self, value: f64) -> f64 {
        let given = GIVEN * value.abs();
        self.0.get(&value.abs().to_bits()).map_or(given, |known| known.max(given))
    }

    fn keep(&mut self, value: f64, error: f64) {
        let error = if error.is_nan() { f64::INFINITY } else { error };
        self.0.entry(value.abs().to_bits()).or_insert(error);
    }
}

impl Graph {
    /// The bound of the rounding of a constant of this graph.
    pub fn rounding(&self, constant: f64) -> f64 {
        self.roundings.of(constant)
    }

    /// The constant x + y.
    pub(super) fn folded_sum(&mut self, x: f64, y: f64) -> Node {
        self.folded(settled(x, y), |g| g.rounding(x) + g.rounding(y))
    }

    pub(super) fn folded_product(&mut self, x: f64, y: f64) -> Node {
        self.folded(x * y, |g| g.rounding(x) * y.abs() + g.rounding(y) * x.abs())
    }

    pub(super) fn folded_quotient(&mut self, x: f64, y: f64) -> Node {
        let quotient = x / y;
        self.folded(quotient, |g| of_quotient(g.rounding(x), quotient, y, g.rounding(y)))
    }

    pub(super) fn folded_unary(&mut self, function: Unary, x: f64) -> Node {
        self.folded(function.value(x), |g| passed_on(function, x, g.rounding(x)))
    }

    pub(super) fn folded_piece(&mut self, table: u16, orders: Orders, cell: f64, x: f64) -> Node {
        let value = self.table(table).piece(orders.first(), cell, x);
        self.folded(value, |g| {
            let (slope, of_terms) = of_piece(g.table(table), orders, cell, x);
            slope * g.rounding(x) + of_terms
        })
    }

    pub(super) fn folded_patch(&mut self, table: u16, orders: Orders, cell: f64, at: [f64; 2]) -> Node {
        let value = self.table(table).patch(orders, cell, at[0], at[1]);
        self.folded(value, |g| {
            let (slopes, of_terms) = of_patch(g.table(table), orders, cell, at);
            slopes[0] * g.rounding(at[0]) + slopes[1] * g.rounding(at[1]) + of_terms
        })
    }

    /// The constant `value`, made of such as have made it `passed_on` wrong: asked for only where the constant is new.
    fn folded(&mut self, value: f64, passed_on: impl FnOnce(&Graph) -> f64) -> Node {
        // All zeros are one, and what cancels is taken to cancel.
        if value == 0.0 {
            return self.constant(value);
        }
        if let Some(known) = self.known_constant(value) {
            return known;
        }
        let error = passed_on(self) + f64::EPSILON * value.abs();
        self.roundings.keep(value, error);
        self.constant(value)
    }
}

/// What errors of x and y make of x/y; no bound where y may be zero.
pub fn of_quotient(of_x: f64, quotient: f64, y: f64, of_y: f64) -> f64 {
    let least = y.abs() - of_y;
    if least > 0.0 { (of_x + quotient.abs() * of_y) / least } else { f64::INFINITY }
}

/// How steep a piece is, and what its terms are rounded by.
pub fn of_piece(table: &Table, orders: Orders, cell: f64, x: f64) -> (f64, f64) {
    let order = orders.first();
    let slope = if order < 3 { table.piece(order + 1, cell, x).abs() } else { 0.0 };
    (slope, TERMS * f64::EPSILON * table.magnitude(order, cell, x))
}

/// How steep a patch is by both arguments, and what its terms are rounded by.
pub fn of_patch(table: &Table, orders: Orders, cell: f64, [x, y]: [f64; 2]) -> ([f64; 2], f64) {
    let (first, second) = (orders.first(), orders.second());
    let steep = [Orders::new(first + 1, second), Orders::new(first, second + 1)];
    let slopes = steep.map(|orders| table.patch(orders, cell, x, y).abs());
    (slopes, TERMS * f64::EPSILON * table.patch_magnitude(orders, cell, x, y))
}

/// What an error of x makes of f(x).
pub fn passed_on(function: Unary, x: f64, error: f64) -> f64 {
    let slope = match function {
        _ if error == 0.0 => return 0.0,
        Unary::Reciprocal => return of_quotient(0.0, 1.0 / x, x, error),
        Unary::Sqrt => 0.5 / x.sqrt(),
        Unary::Abs => 1.0,
        // Rounding may turn it only at zero.
        Unary::Sign if x == 0.0 => f64::INFINITY,
        Unary::Sign => 0.0,
        Unary::Sin => libm::cos(x),
        Unary::Cos => libm::sin(x),
        Unary::Tan => 1.0 / (libm::cos(x) * libm::cos(x)),
        Unary::Asin | Unary::Acos => 1.0 / (1.0 - x * x).sqrt(),
        Unary::Exp => libm::exp(x),
        Unary::Ln => 1.0 / x,
        Unary::Log10 => std::f64::consts::LOG10_E / x,
        Unary::Sinh => libm::cosh(x),
        Unary::Cosh => libm::sinh(x),
        Unary::Tanh => 1.0 / (libm::cosh(x) * libm::cosh(x)),
        // Rounding moves it by one where a whole number is near.
        Unary::Floor if libm::floor(x - error) != libm::floor(x + error) => return 1.0,
        Unary::Floor => 0.0,
    };
    slope.abs() * error
}

/// x + y; zero where they cancel but for rounding, which would otherwise go on through the equations as a number.
fn settled(x: f64, y: f64) -> f64 {
    let sum = x + y;
    if sum.abs() <= 4.0 * f64::EPSILON * x.abs().max(y.abs()) { 0.0 } else { sum }
}
