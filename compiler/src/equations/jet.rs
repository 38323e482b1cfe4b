//! A scalar function of the motion, up to its second time derivative.
//!
//! For f(q, t) along a motion with velocities v:  ḟ = J v + drift,  f̈ = J v̇ + bias.
//! Constraints are written once, as jets; Φ, D, ν = −drift and γ = −bias all come from that one expression, so that
//! they cannot disagree.

use crate::symbolic::{Compare, Node, On, Scalar, Sheet, Unary};
use std::borrow::Borrow;
use std::collections::BTreeMap;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// See the module's documentation.
#[derive(Clone, Debug, PartialEq)]
pub struct Jet {
    pub value: Node,
    /// Non-zero entries of J = ∂ḟ/∂v by index of velocity.
    pub columns: BTreeMap<usize, Node>,
    /// ḟ at v = 0: explicit dependence on time.
    pub drift: Node,
    /// f̈ at v̇ = 0.
    pub bias: Node,
    /// ḟ, where it has been found in fewer operations than J v + drift.
    pub known_rate: Option<Node>,
}

/// A jet on the graph, and the velocities along which it moves.
#[derive(Clone)]
pub struct Moving<'g, T = Jet> {
    pub g: Sheet<'g>,
    /// v.
    pub velocities: &'g [Node],
    pub jet: T,
}

impl Jet {
    /// What does not move.
    pub fn constant(value: Scalar) -> Self {
        let zero = value.g.zero().bare;
        Jet { value: value.bare, columns: BTreeMap::new(), drift: zero, bias: zero, known_rate: None }
    }

    /// Time itself.
    pub fn time(time: Scalar) -> Self {
        Jet { drift: time.g.one().bare, ..Jet::constant(time) }
    }

    /// ḟ = J v + drift.
    pub fn rate<'g>(&self, g: Sheet<'g>, velocities: &[Node]) -> Scalar<'g> {
        match self.known_rate {
            Some(known) => g.on(known),
            None => self.along(g, velocities) + self.drift,
        }
    }

    /// f̈ = J v̇ + bias.
    pub fn acceleration<'g>(&self, g: Sheet<'g>, accelerations: &[Node]) -> Scalar<'g> {
        self.along(g, accelerations) + self.bias
    }

    /// J x.
    fn along<'g>(&self, g: Sheet<'g>, x: &[Node]) -> Scalar<'g> {
        g.sum(self.columns.iter().map(|(index, column)| g.on(*column) * x[*index]))
    }
}

impl<'g> Moving<'g> {
    pub fn value(&self) -> Scalar<'g> {
        self.g.on(self.jet.value)
    }
    pub fn bias(&self) -> Scalar<'g> {
        self.g.on(self.jet.bias)
    }
    pub fn rate(&self) -> Scalar<'g> {
        self.jet.rate(self.g, self.velocities)
    }
    pub fn acceleration(&self, accelerations: &[Node]) -> Scalar<'g> {
        self.jet.acceleration(self.g, accelerations)
    }

    fn of(&self, jet: Jet) -> Self {
        Moving { g: self.g, velocities: self.velocities, jet }
    }

    /// h(f): ḣ = h′ ḟ, ḧ = h′ f̈ + h″ ḟ².
    pub fn unary(&self, function: Unary) -> Self {
        let value = self.value().unary(function);
        let (first, second) = function.derivatives(self.value(), value);
        self.chain(value, first, second)
    }
    pub fn sqrt(&self) -> Self {
        self.unary(Unary::Sqrt)
    }

    /// A function of this one whose value and derivatives are known.
    pub fn chain(&self, value: Scalar<'g>, first: Scalar<'g>, second: Scalar<'g>) -> Self {
        let mut result = first * self;
        result.jet.value = value.bare;
        if !second.is_zero() {
            let curvature = second * self.rate().square();
            result.jet.bias = (result.bias() + curvature).bare;
        }
        result
    }

    /// atan2(f, h), by x² + y² : d atan2 = (x dy − y dx)/(x² + y²).
    pub fn atan2(&self, x: &Self) -> Self {
        let (y_value, x_value) = (self.value(), x.value());
        let inverse = (x_value.square() + y_value.square()).reciprocal();
        let mut angle = inverse * (x_value * self - y_value * x);
        angle.jet.value = y_value.atan2(x_value).bare;
        // φ̈ = (x ÿ − y ẍ)/r² − 2 φ̇ (x ẋ + y ẏ)/r²
        let radial = (x_value * x.rate() + y_value * self.rate()) * inverse;
        angle.jet.bias = (angle.bias() - 2.0 * angle.rate() * radial).bare;
        angle
    }

    /// What `mask` selects.
    pub fn select(mask: Scalar<'g>, then: &Self, otherwise: &Self) -> Self {
        let g = mask.g;
        let zero = g.zero().bare;
        let select = |a: Node, b: Node| mask.select(g.on(a), g.on(b)).bare;
        let (a, b) = (&then.jet, &otherwise.jet);
        let keys: Vec<usize> = a.columns.keys().chain(b.columns.keys()).copied().collect();
        let mut columns = BTreeMap::new();
        for key in keys {
            let of = |jet: &Jet| jet.columns.get(&key).copied().unwrap_or(zero);
            columns.insert(key, select(of(a), of(b)));
        }
        then.of(Jet {
            value: select(a.value, b.value),
            columns,
            drift: select(a.drift, b.drift),
            bias: select(a.bias, b.bias),
            known_rate: None,
        })
    }

    /// What stands still is on the side where the mask is false, so that masks of choices within choices go together.
    pub fn min(&self, other: &Self) -> Self {
        if self.jet.columns.is_empty() {
            return Moving::select(other.value().compare(Compare::Less, self.value()), other, self);
        }
        Moving::select(self.value().compare(Compare::LessEqual, other.value()), self, other)
    }

    pub fn max(&self, other: &Self) -> Self {
        if other.jet.columns.is_empty() {
            return Moving::select(other.value().compare(Compare::Less, self.value()), self, other);
        }
        Moving::select(self.value().compare(Compare::LessEqual, other.value()), other, self)
    }

    fn map(&self, f: impl Fn(Scalar<'g>) -> Scalar<'g>) -> Self {
        let f = |node: Node| f(self.g.on(node)).bare;
        let mut columns = BTreeMap::new();
        for (index, column) in &self.jet.columns {
            let column = f(*column);
            if !self.g.is_zero(column) {
                columns.insert(*index, column);
            }
        }
        let known_rate = self.jet.known_rate.map(f);
        let Jet { value, drift, bias, .. } = self.jet;
        self.of(Jet { value: f(value), columns, drift: f(drift), bias: f(bias), known_rate })
    }

    fn combine(
        &self,
        other: &Self,
        both: fn(Scalar<'g>, Node) -> Scalar<'g>,
        right_only: fn(Scalar<'g>) -> Scalar<'g>,
    ) -> Self {
        let g = self.g;
        let both = |a: Node, b: Node| both(g.on(a), b).bare;
        let (a, b) = (&self.jet, &other.jet);
        let mut columns = a.columns.clone();
        for (index, column) in &b.columns {
            let sum = match columns.get(index) {
                Some(own) => both(*own, *column),
                None => right_only(g.on(*column)).bare,
            };
            if g.is_zero(sum) {
                columns.remove(index);
            } else {
                columns.insert(*index, sum);
            }
        }
        self.of(Jet {
            value: both(a.value, b.value),
            columns,
            drift: both(a.drift, b.drift),
            bias: both(a.bias, b.bias),
            known_rate: a.known_rate.zip(b.known_rate).map(|(a, b)| both(a, b)),
        })
    }

    /// (f h)¨ = f̈ h + f ḧ + 2 ḟ ḣ.
    fn times(&self, other: &Self) -> Self {
        let (a, b) = (self.value(), other.value());
        let mut product = b * self + a * other;
        product.jet.value = (a * b).bare;
        let rate = self.rate();
        let other_rate = if a.bare == b.bare { rate } else { other.rate() };
        let cross = rate * other_rate;
        // Either factor may have been known in few operations; the sum of both is then known in few.
        let known = self.jet.known_rate.is_some() || other.jet.known_rate.is_some();
        product.jet.known_rate = known.then(|| (rate * b + a * other_rate).bare);
        product.jet.bias = (product.bias() + 2.0 * cross).bare;
        product
    }
}

/// Jets may be used up or lent.
macro_rules! operators {
    ($($of:ty),*) => {$(
        impl<'g, B: Borrow<Moving<'g>>> Add<B> for $of {
            type Output = Moving<'g>;
            fn add(self, other: B) -> Moving<'g> {
                self.combine(other.borrow(), |a, b| a + b, |b| b)
            }
        }
        impl<'g, B: Borrow<Moving<'g>>> Sub<B> for $of {
            type Output = Moving<'g>;
            fn sub(self, other: B) -> Moving<'g> {
                self.combine(other.borrow(), |a, b| a - b, |b| -b)
            }
        }
        impl<'g, B: Borrow<Moving<'g>>> Mul<B> for $of {
            type Output = Moving<'g>;
            fn mul(self, other: B) -> Moving<'g> {
                self.times(other.borrow())
            }
        }
        impl<'g, B: Borrow<Moving<'g>>> Div<B> for $of {
            type Output = Moving<'g>;
            fn div(self, other: B) -> Moving<'g> {
                self.times(&other.borrow().unary(Unary::Reciprocal))
            }
        }
        impl<'g> Neg for $of {
            type Output = Moving<'g>;
            fn neg(self) -> Moving<'g> {
                self.map(|node| -node)
            }
        }
        /// k·f for k that does not move.
        impl<'g> Mul<$of> for Scalar<'g> {
            type Output = Moving<'g>;
            fn mul(self, jet: $of) -> Moving<'g> {
                jet.map(|node| self * node)
            }
        }
        impl<'g> Mul<$of> for f64 {
            type Output = Moving<'g>;
            fn mul(self, jet: $of) -> Moving<'g> {
                jet.g.number(self) * jet
            }
        }
    )*};
}

operators!(Moving<'g>, &Moving<'g>);

impl<'g, T> On<'g, T> {
    /// A jet on the same graph.
    pub fn moving<J>(&self, velocities: &'g [Node], jet: J) -> Moving<'g, J> {
        Moving { g: self.g, velocities, jet }
    }
}
