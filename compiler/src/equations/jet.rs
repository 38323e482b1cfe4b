//! A scalar function of the motion, up to its second time derivative.
//!
//! For f(q, t) along a motion with velocities v:  ḟ = J v + drift,  f̈ = J v̇ + bias.
//! Constraints are written once, as jets; Φ, D, ν = −drift and γ = −bias all come from that one expression, so that
//! they cannot disagree.

use crate::symbolic::{Compare, Graph, Node, Unary};
use std::collections::BTreeMap;

/// See the module's documentation.
#[derive(Clone, Debug)]
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

impl Jet {
    pub fn constant(g: &mut Graph, value: Node) -> Self {
        let zero = g.constant(0.0);
        Jet { value, columns: BTreeMap::new(), drift: zero, bias: zero, known_rate: None }
    }

    /// Time itself.
    pub fn time(g: &mut Graph, time: Node) -> Self {
        let (zero, one) = (g.constant(0.0), g.constant(1.0));
        Jet { value: time, columns: BTreeMap::new(), drift: one, bias: zero, known_rate: None }
    }

    /// ḟ = J v + drift.
    pub fn rate(&self, g: &mut Graph, velocities: &[Node]) -> Node {
        if let Some(known) = self.known_rate {
            return known;
        }
        let terms: Vec<Node> =
            self.columns.iter().map(|(index, column)| g.mul(*column, velocities[*index])).collect();
        let sum = g.sum(terms);
        g.add(sum, self.drift)
    }

    /// f̈ = J v̇ + bias.
    pub fn acceleration(&self, g: &mut Graph, accelerations: &[Node]) -> Node {
        let terms: Vec<Node> =
            self.columns.iter().map(|(index, column)| g.mul(*column, accelerations[*index])).collect();
        let sum = g.sum(terms);
        g.add(sum, self.bias)
    }

    pub fn add(&self, g: &mut Graph, other: &Jet) -> Jet {
        self.combine(g, other, Graph::add, |_, node| node)
    }

    pub fn sub(&self, g: &mut Graph, other: &Jet) -> Jet {
        self.combine(g, other, Graph::sub, Graph::neg)
    }

    pub fn neg(&self, g: &mut Graph) -> Jet {
        self.map(g, Graph::neg)
    }

    /// k·f for k that does not move.
    pub fn scale(&self, g: &mut Graph, factor: Node) -> Jet {
        self.map(g, |g, node| g.mul(factor, node))
    }

    /// f·h: (f h)¨ = f̈ h + f ḧ + 2 ḟ ḣ.
    pub fn mul(&self, g: &mut Graph, other: &Jet, velocities: &[Node]) -> Jet {
        let (a, b) = (self.value, other.value);
        let left = self.map(g, |g, node| g.mul(b, node));
        let right = other.map(g, |g, node| g.mul(a, node));
        let mut product = left.add(g, &right);
        product.value = g.mul(a, b);
        let rate = self.rate(g, velocities);
        let other_rate = if self.value == other.value { rate } else { other.rate(g, velocities) };
        let cross = g.mul(rate, other_rate);
        // Either factor may have been known in few operations; the sum of both is then known in few.
        product.known_rate = (self.known_rate.is_some() || other.known_rate.is_some()).then(|| {
            let (left, right) = (g.mul(rate, b), g.mul(a, other_rate));
            g.add(left, right)
        });
        let two = g.constant(2.0);
        let cross = g.mul(two, cross);
        product.bias = g.add(product.bias, cross);
        product
    }

    /// h(f): ḣ = h′ ḟ, ḧ = h′ f̈ + h″ ḟ².
    pub fn unary(&self, g: &mut Graph, function: Unary, velocities: &[Node]) -> Jet {
        let value = g.unary(function, self.value);
        let (first, second) = function.derivatives(g, self.value, value);
        self.chain(g, value, first, second, velocities)
    }

    /// The jet of a function of `self` whose value and derivatives are known.
    pub fn chain(&self, g: &mut Graph, value: Node, first: Node, second: Node, velocities: &[Node]) -> Jet {
        let mut result = self.map(g, |g, node| g.mul(first, node));
        result.value = value;
        if !g.is_zero(second) {
            let rate = self.rate(g, velocities);
            let square = g.mul(rate, rate);
            let curvature = g.mul(second, square);
            result.bias = g.add(result.bias, curvature);
        }
        result
    }

    pub fn div(&self, g: &mut Graph, other: &Jet, velocities: &[Node]) -> Jet {
        let reciprocal = other.unary(g, Unary::Reciprocal, velocities);
        self.mul(g, &reciprocal, velocities)
    }

    /// atan2(f, h), by x² + y² : d atan2 = (x dy − y dx)/(x² + y²).
    pub fn atan2(&self, g: &mut Graph, x: &Jet, velocities: &[Node]) -> Jet {
        let (yy, xx) = (g.mul(self.value, self.value), g.mul(x.value, x.value));
        let square = g.add(xx, yy);
        let inverse = g.unary(Unary::Reciprocal, square);
        let numerator = {
            let left = self.map(g, |g, node| g.mul(x.value, node));
            let right = x.map(g, |g, node| g.mul(self.value, node));
            left.sub(g, &right)
        };
        // φ̈ = (x ÿ − y ẍ)/r² − 2 φ̇ (x ẋ + y ẏ)/r²
        let mut angle = numerator.map(g, |g, node| g.mul(inverse, node));
        angle.value = g.atan2(self.value, x.value);
        let rate = angle.rate(g, velocities);
        let (x_rate, y_rate) = (x.rate(g, velocities), self.rate(g, velocities));
        let (px, py) = (g.mul(x.value, x_rate), g.mul(self.value, y_rate));
        let radial = g.add(px, py);
        let radial = g.mul(radial, inverse);
        let two = g.constant(2.0);
        let twice = g.mul(two, rate);
        let coriolis = g.mul(twice, radial);
        angle.bias = g.sub(angle.bias, coriolis);
        angle
    }

    /// The jet that `mask` selects.
    pub fn select(g: &mut Graph, mask: Node, then: &Jet, otherwise: &Jet) -> Jet {
        let zero = g.constant(0.0);
        let keys: Vec<usize> = then.columns.keys().chain(otherwise.columns.keys()).copied().collect();
        let mut columns = BTreeMap::new();
        for key in keys {
            let a = then.columns.get(&key).copied().unwrap_or(zero);
            let b = otherwise.columns.get(&key).copied().unwrap_or(zero);
            columns.insert(key, g.select(mask, a, b));
        }
        Jet {
            value: g.select(mask, then.value, otherwise.value),
            columns,
            drift: g.select(mask, then.drift, otherwise.drift),
            bias: g.select(mask, then.bias, otherwise.bias),
            known_rate: None,
        }
    }

    pub fn minimum(&self, g: &mut Graph, other: &Jet) -> Jet {
        let mask = g.compare(Compare::LessEqual, self.value, other.value);
        Jet::select(g, mask, self, other)
    }

    pub fn maximum(&self, g: &mut Graph, other: &Jet) -> Jet {
        let mask = g.compare(Compare::LessEqual, self.value, other.value);
        Jet::select(g, mask, other, self)
    }

    fn map(&self, g: &mut Graph, mut f: impl FnMut(&mut Graph, Node) -> Node) -> Jet {
        let mut columns = BTreeMap::new();
        for (index, column) in &self.columns {
            let column = f(g, *column);
            if !g.is_zero(column) {
                columns.insert(*index, column);
            }
        }
        let known_rate = self.known_rate.map(|rate| f(g, rate));
        Jet { value: f(g, self.value), columns, drift: f(g, self.drift), bias: f(g, self.bias), known_rate }
    }

    fn combine(
        &self,
        g: &mut Graph,
        other: &Jet,
        both: fn(&mut Graph, Node, Node) -> Node,
        right_only: fn(&mut Graph, Node) -> Node,
    ) -> Jet {
        let mut columns = self.columns.clone();
        for (index, column) in &other.columns {
            let sum = match columns.get(index) {
                Some(own) => both(g, *own, *column),
                None => right_only(g, *column),
            };
            if g.is_zero(sum) {
                columns.remove(index);
            } else {
                columns.insert(*index, sum);
            }
        }
        Jet {
            value: both(g, self.value, other.value),
            columns,
            drift: both(g, self.drift, other.drift),
            bias: both(g, self.bias, other.bias),
            known_rate: self.known_rate.zip(other.known_rate).map(|(a, b)| both(g, a, b)),
        }
    }
}
