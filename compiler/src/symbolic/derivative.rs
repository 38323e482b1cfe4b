//! Exact derivatives of nodes, forward through the graph.
//!
//! What the derivatives are taken along is said by a seed: of each symbol its derivatives, themselves nodes, by direction. So
//! directions need not be symbols; a pair (c, s) that turns by δ has ∂c = −s and ∂s = c. Derivatives are nodes of the same
//! graph: what they have in common with each other and with the functions themselves is computed once.

use super::{Compare, Node, Op, Orders, Scalar, Sheet, Unary};
use std::collections::BTreeMap;

/// The derivatives of a node by direction; what is not there is zero.
pub type Gradient = BTreeMap<usize, Node>;

impl<'g> Sheet<'g> {
    /// ∂root/∂direction of each root, given those of the symbols; symbols without a seed are held.
    ///
    /// The row of a table has none either: pieces are differentiated where they are. min, max, |x|, sign and select have the derivative of the branch taken; where min and max meet that of the one they
    /// return. Masks have none.
    pub fn differentiate(self, roots: &[Node], seed: &BTreeMap<Node, Gradient>) -> Vec<Gradient> {
        let mut gradients: BTreeMap<Node, Gradient> = BTreeMap::new();
        let reachable = self.graph().reachable(roots.iter().copied());
        for node in reachable {
            let op = self.graph().op(node);
            let own = match op {
                Op::Symbol(_) => seed.get(&node).cloned(),
                // Operands are older than their users: theirs are known.
                _ if op.operands().any(|operand| gradients.contains_key(&operand)) => {
                    Some(self.chain(node, op, &gradients))
                }
                _ => None,
            };
            if let Some(mut own) = own {
                own.retain(|_, derivative| !self.is_zero(*derivative));
                if !own.is_empty() {
                    gradients.insert(node, own);
                }
            }
        }
        roots.iter().map(|root| gradients.get(root).cloned().unwrap_or_default()).collect()
    }

    /// The gradient of one operation from those of its operands.
    fn chain(self, node: Node, op: Op, gradients: &BTreeMap<Node, Gradient>) -> Gradient {
        let none = Gradient::new();
        let of = |operand: Node| gradients.get(&operand).unwrap_or(&none);
        match op {
            Op::Constant(_) | Op::Symbol(_) => Gradient::new(),
            Op::Compare(..) | Op::And(..) | Op::Or(..) | Op::Not(_) => Gradient::new(),
            Op::Neg(a) => self.each(of(a), &none, |da, _| -da),
            Op::Add(a, b) => self.each(of(a), of(b), |da, db| da + db),
            Op::Sub(a, b) => self.each(of(a), of(b), |da, db| da - db),
            Op::Mul(a, b) => self.each(of(a), of(b), |da, db| da * b + a * db),
            // (a/b)′ = (a′ − (a/b) b′)/b
            Op::Div(a, b) => {
                let inverse = self.on(b).reciprocal();
                self.each(of(a), of(b), |da, db| (da - node * db) * inverse)
            }
            Op::Unary(Unary::Sign, _) => Gradient::new(),
            Op::Unary(function, a) => {
                let (first, _) = function.derivatives(self.on(a), self.on(node));
                self.each(of(a), &none, |da, _| first * da)
            }
            // As their values: the first where it is strictly the smaller or larger, else the second.
            Op::Min(a, b) => self.of_chosen([a, b], [of(a), of(b)]),
            Op::Max(a, b) => self.of_chosen([b, a], [of(a), of(b)]),
            // atan2(y, x)′ = (x y′ − y x′)/(x² + y²)
            Op::Atan2(y, x) => {
                let square = self.on(x) * x + self.on(y) * y;
                let inverse = square.reciprocal();
                self.each(of(y), of(x), |dy, dx| (x * dy - y * dx) * inverse)
            }
            Op::Select(mask, a, b) => self.each(of(a), of(b), |da, db| self.on(mask).select(da, db)),
            Op::Cell(..) => Gradient::new(),
            Op::Piece(table, orders, cell, x) => {
                let steeper = Orders::new(orders.first() + 1, 0);
                let first = self.graph().piece(table, steeper, cell, x);
                self.each(of(x), &none, |dx, _| first * dx)
            }
            Op::Patch(table, orders, cell, x, y) => {
                let (first, second) = (orders.first(), orders.second());
                let by_x = self.graph().patch(table, Orders::new(first + 1, second), cell, x, y);
                let by_y = self.graph().patch(table, Orders::new(first, second + 1), cell, x, y);
                self.each(of(x), of(y), |dx, dy| by_x * dx + by_y * dy)
            }
        }
    }

    /// The first of two gradients where the one node is smaller than the other, else the second. What is zero is the second by its mask, so that
    /// those of choices within choices go together.
    fn of_chosen(self, [smaller, larger]: [Node; 2], [first, second]: [&Gradient; 2]) -> Gradient {
        let (smaller, larger) = (self.on(smaller), self.on(larger));
        let mask = smaller.compare(Compare::Less, larger);
        let other = larger.compare(Compare::LessEqual, smaller);
        self.each(first, second, |first, second| match self.is_zero(first.bare) {
            true => other.select(second, first),
            false => mask.select(first, second),
        })
    }

    /// A function of two operands' derivatives, in each direction that either has.
    fn each(
        self,
        a: &Gradient,
        b: &Gradient,
        combine: impl Fn(Scalar<'g>, Scalar<'g>) -> Scalar<'g>,
    ) -> Gradient {
        let zero = self.zero().bare;
        let mut combined = Gradient::new();
        for direction in a.keys().chain(b.keys().filter(|direction| !a.contains_key(direction))) {
            let of = |gradient: &Gradient| self.on(gradient.get(direction).copied().unwrap_or(zero));
            combined.insert(*direction, combine(of(a), of(b)).bare);
        }
        combined
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbolic::{Class, Growing, evaluate};

    /// Two symbols with the directions 0 and 1.
    fn unknowns<'g>(g: Sheet<'g>) -> ([Scalar<'g>; 2], BTreeMap<Node, Gradient>) {
        let one = g.one().bare;
        let symbols = ["x", "y"].map(|name| g.symbol(name, Class::Position));
        let seed = symbols.iter().enumerate().map(|(k, symbol)| (symbol.bare, Gradient::from([(k, one)])));
        (symbols, seed.collect())
    }

    /// Compares both derivatives of a function of x and y with central differences, extrapolated.
    fn check(function: impl for<'g> Fn(Scalar<'g>, Scalar<'g>) -> Scalar<'g>, points: &[[f64; 2]]) {
        let graph = Growing::default();
        let g = graph.sheet();
        let ([x, y], seed) = unknowns(g);
        let root = function(x, y).bare;
        let gradient = g.differentiate(&[root], &seed).remove(0);
        let graph = graph.read();
        let value = |at: [f64; 2]| evaluate(&graph, &at)[root.index()];
        for at in points {
            for k in 0..2 {
                let slope = |h: f64| {
                    let (mut ahead, mut behind) = (*at, *at);
                    ahead[k] += h;
                    behind[k] -= h;
                    (value(ahead) - value(behind)) / (2.0 * h)
                };
                let expected = (4.0 * slope(5e-4) - slope(1e-3)) / 3.0;
                let found = gradient.get(&k).map_or(0.0, |node| evaluate(&graph, at)[node.index()]);
                let close = (found - expected).abs() <= 1e-9 * (1.0 + expected.abs());
                assert!(close, "{:?} at {at:?}, direction {k}: {found} {expected}", graph.op(root));
            }
        }
    }

    #[test]
    fn arithmetic_by_differences() {
        let points = [[0.7, 0.3], [-1.2, 0.8], [0.4, -1.5]];
        check(|x, y| x + y, &points);
        check(|x, y| x - y, &points);
        check(|x, y| x * y, &points);
        check(|x, y| x / y, &points);
        check(|x, y| y.atan2(x), &points);
        check(|x, _| -x, &points);
        // Something of everything, with common terms.
        check(|x, y| ((x * y + x / y).sin() - x * y) * (x * y + x / y), &points);
    }

    #[test]
    fn functions_by_differences() {
        for function in Unary::ALL {
            let points = [[0.3, 1.0], [0.85, -2.0]];
            check(|x, _| x.unary(function), &points);
            check(|x, y| (0.2 * (x * y).square()).unary(function), &points);
        }
        let everywhere = Unary::ALL.into_iter().filter(|function| function.value(-0.6).is_finite());
        for function in everywhere {
            check(|x, _| x.unary(function), &[[-0.6, 0.0]]);
        }
    }

    #[test]
    fn branches_have_the_derivative_of_the_one_taken() {
        let points = [[0.7, 0.3], [-1.2, 0.8]];
        check(|x, y| x.square().min(y.square()), &points);
        check(|x, y| y.square().max(x.square()), &points);
        for comparison in [Compare::Less, Compare::LessEqual] {
            check(
                |x, y| {
                    let mask = x.compare(comparison, x.g.zero());
                    (mask & (mask | !mask)).select(x.square(), y.square())
                },
                &points,
            );
        }
    }

    /// beyond = x − min(max(x, 0), y): its derivative by x is one outside and none within, by one choice.
    #[test]
    fn what_is_left_beyond_the_ends_of_a_range_has_one_choice() {
        let points = [[-0.4, 2.0], [0.7, 2.0], [2.6, 2.0]];
        check(|x, y| x - x.max(x.g.zero()).min(y), &points);
        check(|x, y| (-x).max(x.g.zero()).min(y) + x, &points);
        let graph = Growing::default();
        let g = graph.sheet();
        let ([x, y], seed) = unknowns(g);
        let gradient = g.differentiate(&[(x - x.max(g.zero()).min(y)).bare], &seed).remove(0);
        let [zero, one] = [g.zero(), g.one()].map(|it| it.bare);
        let by_x = graph.read().op(gradient[&0]);
        assert!(
            matches!(by_x, Op::Select(_, inside, outside) if inside == zero && outside == one),
            "{by_x:?}"
        );
    }

    #[test]
    fn min_and_max_have_at_a_tie_the_derivative_of_what_they_return() {
        let graph = Growing::default();
        let g = graph.sheet();
        let ([x, y], seed) = unknowns(g);
        let gradients = g.differentiate(&[x.min(y).bare, x.max(y).bare], &seed);
        let graph = graph.read();
        for gradient in gradients {
            let values = evaluate(&graph, &[2.0, 2.0]);
            assert_eq!([0, 1].map(|k| values[gradient[&k].index()]), [0.0, 1.0]);
        }
    }

    #[test]
    fn directions_may_be_any_nodes() {
        let graph = Growing::default();
        let g = graph.sheet();
        let [c, s, held] = ["c", "s", "held"].map(|name| g.symbol(name, Class::Position));
        let minus = (-s).bare;
        let seed = [(c.bare, Gradient::from([(7, minus)])), (s.bare, Gradient::from([(7, c.bare)]))];
        let angle = s.atan2(c);
        let moved = held * angle;
        let roots = [angle, moved, held, c].map(|root| root.bare);
        let gradients = g.differentiate(&roots, &BTreeMap::from(seed));
        // The angle of a pair that turns turns alike: x·(1/x) = 1 is found without numbers.
        assert_eq!(gradients[0], Gradient::from([(7, g.one().bare)]));
        assert_eq!(gradients[1], Gradient::from([(7, held.bare)]));
        assert!(gradients[2].is_empty());
        assert_eq!(gradients[3], Gradient::from([(7, minus)]));
    }

    #[test]
    fn what_vanishes_has_no_entry() {
        let graph = Growing::default();
        let g = graph.sheet();
        let ([x, y], seed) = unknowns(g);
        let (back, sign) = (x + y - y, y.unary(Unary::Sign));
        let gradients = g.differentiate(&[back.bare, sign.bare], &seed);
        assert_eq!(gradients[0].keys().copied().collect::<Vec<_>>(), [0]);
        assert!(gradients[1].is_empty());
    }
}
