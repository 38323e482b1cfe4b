//! The closed tables of unary functions and comparisons: value and derivative.

use super::Scalar;

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
    Log10,
    Sinh,
    Cosh,
    Tanh,
    /// The largest whole number that is not above x.
    Floor,
}

impl Unary {
    /// Every function, for tests that must cover the table.
    pub const ALL: [Unary; 16] = [
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
        Unary::Log10,
        Unary::Sinh,
        Unary::Cosh,
        Unary::Tanh,
        Unary::Floor,
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
            Unary::Log10 => libm::log10(x),
            Unary::Sinh => libm::sinh(x),
            Unary::Cosh => libm::cosh(x),
            Unary::Tanh => libm::tanh(x),
            Unary::Floor => libm::floor(x),
        }
    }

    /// Its name in formulas.
    pub fn name(self) -> &'static str {
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
            Unary::Log10 => "log10",
            Unary::Sinh => "sinh",
            Unary::Cosh => "cosh",
            Unary::Tanh => "tanh",
            Unary::Floor => "floor",
        }
    }

    /// First and second derivative at `x`, given `f`, the function's value there. At the kinks of |x| and
    /// sign(x) these are the derivatives of the branch that `sign` selects; where a value jumps, those beside it.
    pub fn derivatives<'g>(self, x: Scalar<'g>, f: Scalar<'g>) -> (Scalar<'g>, Scalar<'g>) {
        let zero = x.g.zero();
        match self {
            Unary::Reciprocal => {
                let square = f * f;
                let cube = square * f;
                (-square, 2.0 * cube)
            }
            Unary::Sqrt => {
                let r = f.reciprocal();
                let first = 0.5 * r;
                (first, -(0.5 * (first * (r * r))))
            }
            Unary::Abs => (x.unary(Unary::Sign), zero),
            Unary::Sign => (zero, zero),
            Unary::Sin => (x.cos(), -f),
            Unary::Cos => (-x.sin(), -f),
            Unary::Tan => {
                let first = 1.0 + f * f;
                (first, 2.0 * (f * first))
            }
            Unary::Asin | Unary::Acos => {
                // ±(1 − x²)^(−1/2), ±x (1 − x²)^(−3/2)
                let first = (1.0 - x * x).sqrt().reciprocal();
                let second = x * (first * first * first);
                if self == Unary::Asin { (first, second) } else { (-first, -second) }
            }
            Unary::Exp => (f, f),
            Unary::Ln => {
                let r = x.reciprocal();
                (r, -(r * r))
            }
            Unary::Log10 => {
                let r = x.reciprocal();
                let first = std::f64::consts::LOG10_E * r;
                (first, -(first * r))
            }
            Unary::Sinh => (x.unary(Unary::Cosh), f),
            Unary::Cosh => (x.unary(Unary::Sinh), f),
            Unary::Tanh => {
                let first = 1.0 - f * f;
                (first, -(2.0 * (f * first)))
            }
            Unary::Floor => (zero, zero),
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
}
