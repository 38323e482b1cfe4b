//! Numbers that carry derivatives through the same expressions: plain, along the motion to second order, and along one quantity.

/// What an expression can be evaluated in.
pub(crate) trait Number: Copy {
    fn constant(value: f64) -> Self;
    fn value(self) -> f64;
    /// f(x) from f, f′ and f″ at the value of x.
    fn chain(self, f: f64, first: f64, second: f64) -> Self;
    fn plus(self, other: Self) -> Self;
    fn times(self, other: Self) -> Self;

    fn minus(self, other: Self) -> Self {
        self.plus(other.scaled(-1.0))
    }
    fn scaled(self, factor: f64) -> Self {
        self.times(Self::constant(factor))
    }
    fn over(self, other: Self) -> Self {
        let inverse = 1.0 / other.value();
        let square = inverse * inverse;
        self.times(other.chain(inverse, -square, 2.0 * square * inverse))
    }
}

/// −1, 0 or 1; what is no number stays none.
pub(crate) fn sign(x: f64) -> f64 {
    if x > 0.0 {
        1.0
    } else if x < 0.0 {
        -1.0
    } else {
        x
    }
}

impl Number for f64 {
    fn constant(value: f64) -> Self {
        value
    }
    fn value(self) -> f64 {
        self
    }
    fn chain(self, f: f64, _: f64, _: f64) -> Self {
        f
    }
    fn plus(self, other: Self) -> Self {
        self + other
    }
    fn times(self, other: Self) -> Self {
        self * other
    }
}

/// A quantity along the motion with v̇ = 0: f, ḟ and f̈.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Taylor {
    pub value: f64,
    pub rate: f64,
    /// What f̈ is where no velocity changes; the whole f̈ has the gradient times v̇ beside it.
    pub bias: f64,
}

impl Number for Taylor {
    fn constant(value: f64) -> Self {
        Taylor { value, rate: 0.0, bias: 0.0 }
    }
    fn value(self) -> f64 {
        self.value
    }
    fn chain(self, f: f64, first: f64, second: f64) -> Self {
        Taylor { value: f, rate: first * self.rate, bias: first * self.bias + second * self.rate * self.rate }
    }
    fn plus(self, other: Self) -> Self {
        Taylor { value: self.value + other.value, rate: self.rate + other.rate, bias: self.bias + other.bias }
    }
    fn times(self, other: Self) -> Self {
        Taylor {
            value: self.value * other.value,
            rate: self.rate * other.value + self.value * other.rate,
            bias: self.bias * other.value + 2.0 * self.rate * other.rate + self.value * other.bias,
        }
    }
}

/// A value and its derivative by one quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Slope {
    pub value: f64,
    pub slope: f64,
}

impl Number for Slope {
    fn constant(value: f64) -> Self {
        Slope { value, slope: 0.0 }
    }
    fn value(self) -> f64 {
        self.value
    }
    fn chain(self, f: f64, first: f64, _: f64) -> Self {
        Slope { value: f, slope: first * self.slope }
    }
    fn plus(self, other: Self) -> Self {
        Slope { value: self.value + other.value, slope: self.slope + other.slope }
    }
    fn times(self, other: Self) -> Self {
        Slope { value: self.value * other.value, slope: self.slope * other.value + self.value * other.slope }
    }
}
