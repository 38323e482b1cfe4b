//! Numbers with the margin inside which they may differ from what is right: rounding, and the error of differences.

use crate::schedule::Bounded;
use std::ops::{Add, Mul, Neg, Sub};

/// A value and its margin.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Quantity {
    pub value: f64,
    pub margin: f64,
}

/// How often the first-order bound of rounding is taken.
const SAFETY: f64 = 8.0;
/// Beside it a part of each term, for the rounding that happened before there was a program: what was folded, regrouped and
/// left out by the compiler.
const PART: f64 = 1e-11;

impl Quantity {
    pub fn exact(value: f64) -> Self {
        Quantity { value, margin: 0.0 }
    }

    /// Whether two ways to one number contradict each other. Nothing is claimed of what is not a number.
    pub fn contradicts(self, other: Quantity) -> bool {
        (self.value - other.value).abs() > self.margin + other.margin
    }
}

impl From<Bounded> for Quantity {
    fn from(bounded: Bounded) -> Self {
        let Bounded { value, error } = bounded;
        Quantity { value, margin: SAFETY * error + PART * value.abs() }
    }
}

impl Add for Quantity {
    type Output = Quantity;
    fn add(self, other: Quantity) -> Quantity {
        Quantity { value: self.value + other.value, margin: self.margin + other.margin }
    }
}

impl Neg for Quantity {
    type Output = Quantity;
    fn neg(self) -> Quantity {
        Quantity { value: -self.value, ..self }
    }
}

impl Sub for Quantity {
    type Output = Quantity;
    fn sub(self, other: Quantity) -> Quantity {
        self + -other
    }
}

impl Mul for Quantity {
    type Output = Quantity;
    fn mul(self, other: Quantity) -> Quantity {
        let margin = self.margin * other.value.abs() + self.value.abs() * other.margin;
        Quantity { value: self.value * other.value, margin }
    }
}

impl Mul<f64> for Quantity {
    type Output = Quantity;
    fn mul(self, factor: f64) -> Quantity {
        Quantity { value: self.value * factor, margin: self.margin * factor.abs() }
    }
}

/// Σ aᵢ bᵢ.
pub fn dot(a: &[Quantity], b: &[f64]) -> Quantity {
    a.iter().zip(b).fold(Quantity::default(), |sum, (a, b)| sum + *a * *b)
}

/// Values of functions of one variable at −h, −h/2, 0, h/2 and h.
pub struct Along {
    pub step: f64,
    pub at: [Vec<Quantity>; 5],
}

impl Along {
    pub fn of(step: f64, f: impl Fn(f64) -> Vec<Quantity>) -> Along {
        Along { step, at: [-1.0, -0.5, 0.0, 0.5, 1.0].map(|part| f(part * step)) }
    }

    /// The derivatives at zero by central differences, extrapolated to the fourth order (Richardson).
    ///
    /// The second-order differences of a smooth function over h and h/2 differ by far more than the result is off. At a kink, such
    /// as that of an `if` in a law, these may agree; then the second differences do not vanish as h² does. Both
    /// enter the margin, which is thus large wherever there is no derivative.
    pub fn derivatives(&self) -> Vec<Quantity> {
        let [far_behind, behind, here, ahead, far_ahead] = &self.at;
        let h = self.step;
        (0..here.len())
            .map(|k| {
                let coarse = (far_ahead[k] - far_behind[k]) * (0.5 / h);
                let fine = (ahead[k] - behind[k]) * (1.0 / h);
                let bend = |a: Quantity, b: Quantity, h: f64| (a.value - 2.0 * here[k].value + b.value) / h;
                let kink = 2.0 * bend(ahead[k], behind[k], 0.5 * h) - bend(far_ahead[k], far_behind[k], h);
                let best = fine * (4.0 / 3.0) - coarse * (1.0 / 3.0);
                let doubt = 2.0 * (coarse.value - fine.value).abs() + 2.0 * kink.abs();
                Quantity { value: best.value, margin: best.margin + doubt }
            })
            .collect()
    }
}
