//! Vectors of the plane as nodes of the graph, and turns as pairs (cos, sin).

use crate::symbolic::{Bare, Node, On, Scalar, Sheet};
use std::ops::{Add, Mul, Neg, Sub};

/// A vector, or the cosine and sine of an angle.
pub type Pair = [Node; 2];

pub fn zero(g: Sheet) -> On<Pair> {
    g.on([g.zero().bare; 2])
}

/// (cos, sin) of no turn.
pub fn unturned(g: Sheet) -> On<Pair> {
    g.on([g.one().bare, g.zero().bare])
}

/// x or y.
pub fn axis(g: Sheet, which: usize) -> On<Pair> {
    let (zero, one) = (g.zero().bare, g.one().bare);
    g.on(if which == 0 { [one, zero] } else { [zero, one] })
}

pub fn pair<'g>(x: Scalar<'g>, y: Scalar<'g>) -> On<'g, Pair> {
    x.g.on([x.bare, y.bare])
}

impl<'g> On<'g, Pair> {
    pub fn parts(self) -> [Scalar<'g>; 2] {
        self.bare.map(|part| self.g.on(part))
    }

    pub fn is_zero(self) -> bool {
        self.bare.iter().all(|part| self.g.is_zero(*part))
    }

    pub fn dot(self, other: impl Bare<Pair>) -> Scalar<'g> {
        let ([a, b], [x, y]) = (self.parts(), other.bare());
        a * x + b * y
    }

    /// The component out of the plane.
    pub fn cross(self, other: impl Bare<Pair>) -> Scalar<'g> {
        let ([a, b], [x, y]) = (self.parts(), other.bare());
        a * y - b * x
    }

    /// Turned by an angle; a pair of its own becomes that of the sum of both angles.
    pub fn turned(self, by: impl Bare<Pair>) -> Self {
        let ([x, y], [cos, sin]) = (self.parts(), by.bare());
        pair(x * cos - y * sin, y * cos + x * sin)
    }

    /// (cos, sin) of the opposite angle.
    pub fn opposite(self) -> Self {
        let [cos, sin] = self.parts();
        pair(cos, -sin)
    }

    /// Turned by a right angle, counter-clockwise.
    pub fn perpendicular(self) -> Self {
        let [x, y] = self.parts();
        pair(-y, x)
    }

    /// Of length one.
    pub fn normalized(self) -> Self {
        let [x, y] = self.parts();
        let length = self.dot(self).sqrt();
        pair(x / length, y / length)
    }
}

impl<'g> Neg for On<'g, Pair> {
    type Output = Self;
    fn neg(self) -> Self {
        let [x, y] = self.parts();
        pair(-x, -y)
    }
}

impl<'g, B: Bare<Pair>> Add<B> for On<'g, Pair> {
    type Output = Self;
    fn add(self, other: B) -> Self {
        let ([a, b], [x, y]) = (self.parts(), other.bare());
        pair(a + x, b + y)
    }
}

impl<'g, B: Bare<Pair>> Sub<B> for On<'g, Pair> {
    type Output = Self;
    fn sub(self, other: B) -> Self {
        let ([a, b], [x, y]) = (self.parts(), other.bare());
        pair(a - x, b - y)
    }
}

impl<'g> Mul<On<'g, Pair>> for Scalar<'g> {
    type Output = On<'g, Pair>;
    fn mul(self, vector: On<'g, Pair>) -> On<'g, Pair> {
        self.g.on(vector.bare.map(|part| (self * part).bare))
    }
}
