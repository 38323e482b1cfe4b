//! Equations as they are written: values on a graph, with operators.
//!
//! `k * (1.0 - rest / length)` makes the nodes that `div`, `sub` and `mul` of [`Graph`] make, in the order in which Rust evaluates
//! operands: left before right. What is kept of an equation are bare nodes, which know no graph; they may stand on either side
//! of an operator whose other side does.

use super::{Class, Compare, Graph, Node, Orders, Unary};
use std::cell::{Ref, RefCell, RefMut};
use std::ops::{Add, AddAssign, BitAnd, BitOr, Div, Mul, Neg, Not, Sub, SubAssign};

/// The graph that equations are being written on.
#[derive(Clone, Copy)]
pub struct Sheet<'g>(&'g RefCell<Graph>);

/// A node, or an array or struct of nodes, and the graph they are on.
#[derive(Clone, Copy)]
pub struct On<'g, T> {
    pub g: Sheet<'g>,
    /// Without the graph, as it is kept.
    pub bare: T,
}

/// A number of an equation.
pub type Scalar<'g> = On<'g, Node>;

/// A graph that may be written on by all who hold it: what is on it stays as it is, and further equations are added.
#[derive(Clone, Debug, Default)]
pub struct Growing(RefCell<Graph>);

impl From<Graph> for Growing {
    fn from(graph: Graph) -> Self {
        Growing(RefCell::new(graph))
    }
}

impl Growing {
    /// The graph for equations with operators; what they leave behind is bare.
    pub fn sheet(&self) -> Sheet<'_> {
        Sheet(&self.0)
    }
    /// What is on it, for a time in which nothing is added.
    pub fn read(&self) -> Ref<'_, Graph> {
        self.0.borrow()
    }
}

/// Numbers as they are kept.
pub fn all_bare(values: &[Scalar]) -> Vec<Node> {
    values.iter().map(|value| value.bare).collect()
}

impl<'g> Sheet<'g> {
    /// The graph itself, for a statement without operators, which would find it taken.
    #[inline]
    pub fn graph(self) -> RefMut<'g, Graph> {
        self.0.borrow_mut()
    }
    #[inline]
    pub fn on<T>(self, bare: T) -> On<'g, T> {
        On { g: self, bare }
    }
    /// Numbers that were kept.
    pub fn all(self, bare: &[Node]) -> Vec<Scalar<'g>> {
        bare.iter().map(|node| self.on(*node)).collect()
    }
    #[inline]
    pub fn number(self, value: f64) -> Scalar<'g> {
        let node = self.graph().constant(value);
        self.on(node)
    }
    pub fn zero(self) -> Scalar<'g> {
        self.number(0.0)
    }
    pub fn one(self) -> Scalar<'g> {
        self.number(1.0)
    }
    pub fn symbol(self, name: impl Into<String>, class: Class) -> Scalar<'g> {
        let node = self.graph().symbol(name, class);
        self.on(node)
    }
    #[inline]
    pub fn is_zero(self, node: Node) -> bool {
        self.0.borrow().is_zero(node)
    }
    /// Σ terms, left to right, after all of them.
    pub fn sum(self, terms: impl IntoIterator<Item = Scalar<'g>>) -> Scalar<'g> {
        let terms: Vec<Node> = terms.into_iter().map(|term| term.bare).collect();
        let node = self.graph().sum(terms);
        self.on(node)
    }
}

impl<'g> Scalar<'g> {
    #[inline]
    fn made(self, make: impl FnOnce(&mut Graph, Node) -> Node) -> Self {
        let node = make(&mut self.g.graph(), self.bare);
        self.g.on(node)
    }
    /// Its number, if it is a constant.
    pub fn value(self) -> Option<f64> {
        self.g.0.borrow().value(self.bare)
    }
    #[inline]
    pub fn is_zero(self) -> bool {
        self.g.is_zero(self.bare)
    }
    /// The constant k, x and y of k·x and k·y, whichever of them are negative.
    pub fn common_coefficient(self, other: Self) -> Option<(Self, [Self; 2])> {
        let (k, parts) = self.g.graph().common_coefficient(self.bare, other.bare)?;
        Some((self.g.on(k), parts.map(|part| self.g.on(part))))
    }
    pub fn class(self) -> Class {
        self.g.0.borrow().class(self.bare)
    }
    pub fn unary(self, function: Unary) -> Self {
        self.made(|g, x| g.unary(function, x))
    }
    /// 1/x.
    pub fn reciprocal(self) -> Self {
        self.unary(Unary::Reciprocal)
    }
    pub fn sqrt(self) -> Self {
        self.unary(Unary::Sqrt)
    }
    pub fn abs(self) -> Self {
        self.unary(Unary::Abs)
    }
    pub fn sin(self) -> Self {
        self.unary(Unary::Sin)
    }
    pub fn cos(self) -> Self {
        self.unary(Unary::Cos)
    }
    pub fn square(self) -> Self {
        self * self
    }
    /// To an integer power, by repeated squaring.
    pub fn power(self, exponent: i32) -> Self {
        self.made(|g, x| g.power(x, exponent))
    }
    pub fn min(self, other: Self) -> Self {
        self.made(|g, x| g.min(x, other.bare))
    }
    pub fn max(self, other: Self) -> Self {
        self.made(|g, x| g.max(x, other.bare))
    }
    /// The angle of the point (x, self).
    pub fn atan2(self, x: Self) -> Self {
        self.made(|g, y| g.atan2(y, x.bare))
    }
    /// A mask.
    pub fn compare(self, comparison: Compare, other: Self) -> Self {
        self.made(|g, x| g.compare(comparison, x, other.bare))
    }
    /// The row of a table that it is in.
    pub fn cell(self, table: u16) -> Self {
        self.made(|g, x| g.cell(table, x))
    }
    /// A derivative of the piece of a table in that row.
    pub fn piece(self, table: u16, order: u8, cell: Self) -> Self {
        self.made(|g, x| g.piece(table, Orders::new(order, 0), cell.bare, x))
    }
    /// A derivative of the patch of a table in that row.
    pub fn patch(self, table: u16, orders: Orders, cell: Self, other: Self) -> Self {
        self.made(|g, x| g.patch(table, orders, cell.bare, x, other.bare))
    }
    /// What a mask selects.
    pub fn select(self, then: Self, otherwise: Self) -> Self {
        self.made(|g, mask| g.select(mask, then.bare, otherwise.bare))
    }
}

/// An operation of two operands, at least one of which knows the graph.
macro_rules! operators {
    ($($operator:ident $method:ident;)*) => {$(
        impl<'g> $operator for Scalar<'g> {
            type Output = Scalar<'g>;
            #[inline]
            fn $method(self, other: Scalar<'g>) -> Scalar<'g> {
                self.$method(other.bare)
            }
        }
        impl<'g> $operator<Node> for Scalar<'g> {
            type Output = Scalar<'g>;
            #[inline]
            fn $method(self, other: Node) -> Scalar<'g> {
                let node = self.g.graph().$method(self.bare, other);
                self.g.on(node)
            }
        }
        impl<'g> $operator<Scalar<'g>> for Node {
            type Output = Scalar<'g>;
            #[inline]
            fn $method(self, other: Scalar<'g>) -> Scalar<'g> {
                other.g.on(self).$method(other.bare)
            }
        }
        impl<'g> $operator<f64> for Scalar<'g> {
            type Output = Scalar<'g>;
            #[inline]
            fn $method(self, other: f64) -> Scalar<'g> {
                self.$method(self.g.number(other))
            }
        }
        impl<'g> $operator<Scalar<'g>> for f64 {
            type Output = Scalar<'g>;
            #[inline]
            fn $method(self, other: Scalar<'g>) -> Scalar<'g> {
                other.g.number(self).$method(other.bare)
            }
        }
    )*};
}

operators! {
    Add add;
    Sub sub;
    Mul mul;
    Div div;
}

/// Operators of masks.
impl<'g> BitAnd for Scalar<'g> {
    type Output = Scalar<'g>;
    fn bitand(self, other: Scalar<'g>) -> Scalar<'g> {
        self.made(|g, mask| g.and(mask, other.bare))
    }
}

impl<'g> BitOr for Scalar<'g> {
    type Output = Scalar<'g>;
    fn bitor(self, other: Scalar<'g>) -> Scalar<'g> {
        self.made(|g, mask| g.or(mask, other.bare))
    }
}

impl<'g> Not for Scalar<'g> {
    type Output = Scalar<'g>;
    fn not(self) -> Scalar<'g> {
        self.made(|g, mask| g.not(mask))
    }
}

impl<'g> Neg for Scalar<'g> {
    type Output = Scalar<'g>;
    #[inline]
    fn neg(self) -> Scalar<'g> {
        let node = self.g.graph().neg(self.bare);
        self.g.on(node)
    }
}

impl<'g, T> AddAssign<T> for Scalar<'g>
where
    Scalar<'g>: Add<T, Output = Scalar<'g>>,
{
    fn add_assign(&mut self, other: T) {
        *self = *self + other;
    }
}

impl<'g, T> SubAssign<T> for Scalar<'g>
where
    Scalar<'g>: Sub<T, Output = Scalar<'g>>,
{
    fn sub_assign(&mut self, other: T) {
        *self = *self - other;
    }
}

/// What may stand for bare nodes: themselves, or a value on the graph.
pub trait Bare<T> {
    fn bare(self) -> T;
}

impl<T> Bare<T> for T {
    fn bare(self) -> T {
        self
    }
}

impl<T> Bare<T> for On<'_, T> {
    fn bare(self) -> T {
        self.bare
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbolic::{Op, evaluate};

    #[test]
    fn operators_make_what_calls_make_in_the_same_order() {
        let written = Growing::default();
        let g = written.sheet();
        let [k, rest, length] = ["k", "rest", "length"].map(|name| g.symbol(name, Class::Position));
        let mut sum = k * (1.0 - rest / length) + 2.0 * length.sqrt();
        sum += -rest;
        sum -= k.bare;
        sum.compare(Compare::Less, k).select(sum, k.bare * rest);
        let mut called = Graph::new();
        let g = &mut called;
        let [k, rest, length] = ["k", "rest", "length"].map(|name| g.symbol(name, Class::Position));
        let quotient = g.div(rest, length);
        let one = g.constant(1.0);
        let difference = g.sub(one, quotient);
        let product = g.mul(k, difference);
        let root = g.unary(Unary::Sqrt, length);
        let two = g.constant(2.0);
        let doubled = g.mul(two, root);
        let sum = g.add(product, doubled);
        let minus = g.neg(rest);
        let sum = g.add(sum, minus);
        let sum = g.sub(sum, k);
        let mask = g.compare(Compare::Less, sum, k);
        let other = g.mul(k, rest);
        g.select(mask, sum, other);
        assert!(written.read().nodes().eq(called.nodes()));
    }

    #[test]
    fn sums_follow_all_of_their_terms() {
        let graph = Growing::default();
        let g = graph.sheet();
        let symbols = ["a", "b", "c"].map(|name| g.symbol(name, Class::Position));
        let sum = g.sum(symbols.map(|x| x * x)).bare;
        let graph = graph.read();
        let kinds: Vec<bool> = graph.nodes().skip(3).map(|(_, op)| matches!(op, Op::Mul(..))).collect();
        assert_eq!(kinds, [true, true, true, false, false, false]);
        assert_eq!(evaluate(&graph, &[1.0, 2.0, 3.0])[sum.index()], 14.0);
    }
}
