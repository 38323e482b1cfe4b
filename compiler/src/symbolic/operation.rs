//! The closed tables of unary functions and comparisons: value, derivative, spelling in emitted code.

use super::{Graph, Node};

/// Functions of one argument. Negation is an operation of its own, because most of the algebra is about signs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Unary {
    /// 1/x.
    Reciprocal,
    Sqrt,
    Abs,
    /// −1, 0 or 1.
    Sign,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Exp,
    Ln,
}

impl Unary {
    /// Every function, for tests that must cover the table.
    pub const ALL: [Unary; 11] = [
        Unary::Reciprocal,
        Unary::Sqrt,
        Unary::Abs,
        Unary::Sign,
        Unary::Sin,
        Unary::Cos,
        Unary::Tan,
        Unary::Asin,
        Unary::Acos,
        Unary::Exp,
        Unary::Ln,
    ];

    /// Value at `x`. Transcendental functions come from `libm`, as in the runtime, so that a constant folded at
    /// expansion has the bits that the target would have computed.
    pub fn value(self, x: f64) -> f64 {
        match self {
            Unary::Reciprocal => 1.0 / x,
            Unary::Sqrt => x.sqrt(),
            Unary::Abs => x.abs(),
            Unary::Sign if x > 0.0 => 1.0,
            Unary::Sign if x < 0.0 => -1.0,
            Unary::Sign => x,
            Unary::Sin => libm::sin(x),
            Unary::Cos => libm::cos(x),
            Unary::Tan => libm::tan(x),
            Unary::Asin => libm::asin(x),
            Unary::Acos => libm::acos(x),
            Unary::Exp => libm::exp(x),
            Unary::Ln => libm::log(x),
        }
    }

    /// Method of the runtime's scalar trait.
    pub fn method(self) -> &'static str {
        match self {
            Unary::Reciprocal => "recip",
            Unary::Sqrt => "sqrt",
            Unary::Abs => "abs",
            Unary::Sign => "sign",
            Unary::Sin => "sin",
            Unary::Cos => "cos",
            Unary::Tan => "tan",
            Unary::Asin => "asin",
            Unary::Acos => "acos",
            Unary::Exp => "exp",
            Unary::Ln => "ln",
        }
    }

    /// First and second derivative at `x`, given `f` = the function's own node at `x`. At the kinks of |x| and
    /// sign(x) these are the derivatives of the branch that `sign` selects.
    pub fn derivatives(self, g: &mut Graph, x: Node, f: Node) -> (Node, Node) {
        let (zero, one, two) = (g.constant(0.0), g.constant(1.0), g.constant(2.0));
        match self {
            Unary::Reciprocal => {
                let square = g.mul(f, f);
                let cube = g.mul(square, f);
                (g.neg(square), g.mul(two, cube))
            }
            Unary::Sqrt => {
                let half = g.constant(0.5);
                let r = g.unary(Unary::Reciprocal, f);
                let first = g.mul(half, r);
                let rr = g.mul(r, r);
                let second = g.mul(first, rr);
                let second = g.mul(half, second);
                (first, g.neg(second))
            }
            Unary::Abs => (g.unary(Unary::Sign, x), zero),
            Unary::Sign => (zero, zero),
            Unary::Sin => (g.unary(Unary::Cos, x), g.neg(f)),
            Unary::Cos => {
                let s = g.unary(Unary::Sin, x);
                (g.neg(s), g.neg(f))
            }
            Unary::Tan => {
                // 1 + f², 2 f (1 + f²)
                let square = g.mul(f, f);
                let first = g.add(one, square);
                let second = g.mul(f, first);
                (first, g.mul(two, second))
            }
            Unary::Asin | Unary::Acos => {
                // ±(1 − x²)^(−1/2), ±x (1 − x²)^(−3/2)
                let square = g.mul(x, x);
                let rest = g.sub(one, square);
                let root = g.unary(Unary::Sqrt, rest);
                let first = g.unary(Unary::Reciprocal, root);
                let cube = g.mul(first, first);
                let cube = g.mul(cube, first);
                let second = g.mul(x, cube);
                if self == Unary::Asin { (first, second) } else { (g.neg(first), g.neg(second)) }
            }
            Unary::Exp => (f, f),
            Unary::Ln => {
                let r = g.unary(Unary::Reciprocal, x);
                let rr = g.mul(r, r);
                (r, g.neg(rr))
            }
        }
    }
}

/// The smaller of two, the second where either is NaN, as in the runtime.
pub fn min(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// The larger of two, the second where either is NaN, as in the runtime.
pub fn max(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// Comparisons of two scalars, giving a mask.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Compare {
    Less,
    LessEqual,
    Equal,
}

impl Compare {
    pub fn value(self, a: f64, b: f64) -> bool {
        match self {
            Compare::Less => a < b,
            Compare::LessEqual => a <= b,
            Compare::Equal => a == b,
        }
    }

    /// Method of the runtime's scalar trait.
    pub fn method(self) -> &'static str {
        match self {
            Compare::Less => "less",
            Compare::LessEqual => "less_equal",
            Compare::Equal => "equal",
        }
    }
}
