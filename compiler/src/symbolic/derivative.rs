//! Exact derivatives of nodes, forward through the graph.
//!
//! What the derivatives are taken along is said by a seed: of each symbol its derivatives, themselves nodes, by direction. So
//! directions need not be symbols; a pair (c, s) that turns by δ has ∂c = −s and ∂s = c. Derivatives are nodes of the same
//! graph: what they have in common with each other and with the functions themselves is computed once.

use super::{Compare, Graph, Node, Op, Unary};
use std::collections::BTreeMap;

/// The derivatives of a node by direction; what is not there is zero.
pub type Gradient = BTreeMap<usize, Node>;

impl Graph {
    /// ∂root/∂direction of each root, given those of the symbols; symbols without a seed are held.
    ///
    /// min, max, |x|, sign and select have the derivative of the branch taken; where min and max meet that of the one they
    /// return. Masks have none.
    pub fn differentiate(&mut self, roots: &[Node], seed: &BTreeMap<Node, Gradient>) -> Vec<Gradient> {
        let mut gradients: BTreeMap<Node, Gradient> = BTreeMap::new();
        for node in self.reachable(roots.iter().copied()) {
            let op = self.op(node);
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
    fn chain(&mut self, node: Node, op: Op, gradients: &BTreeMap<Node, Gradient>) -> Gradient {
        let none = Gradient::new();
        let of = |operand: Node| gradients.get(&operand).unwrap_or(&none);
        match op {
            Op::Constant(_) | Op::Symbol(_) => Gradient::new(),
            Op::Compare(..) | Op::And(..) | Op::Or(..) | Op::Not(_) => Gradient::new(),
            Op::Neg(a) => self.each(of(a), &none, |g, a, _| g.neg(a)),
            Op::Add(a, b) => self.each(of(a), of(b), Graph::add),
            Op::Sub(a, b) => self.each(of(a), of(b), Graph::sub),
            Op::Mul(a, b) => self.each(of(a), of(b), |g, da, db| {
                let (left, right) = (g.mul(da, b), g.mul(a, db));
                g.add(left, right)
            }),
            // (a/b)′ = (a′ − (a/b) b′)/b
            Op::Div(a, b) => {
                let inverse = self.unary(Unary::Reciprocal, b);
                self.each(of(a), of(b), |g, da, db| {
                    let taken = g.mul(node, db);
                    let rest = g.sub(da, taken);
                    g.mul(rest, inverse)
                })
            }
            Op::Unary(Unary::Sign, _) => Gradient::new(),
            Op::Unary(function, a) => {
                let (first, _) = function.derivatives(self, a, node);
                self.each(of(a), &none, |g, da, _| g.mul(first, da))
            }
            // As their values: the first where it is strictly the smaller or larger, else the second.
            Op::Min(a, b) => {
                let mask = self.compare(Compare::Less, a, b);
                self.each(of(a), of(b), |g, da, db| g.select(mask, da, db))
            }
            Op::Max(a, b) => {
                let mask = self.compare(Compare::Less, b, a);
                self.each(of(a), of(b), |g, da, db| g.select(mask, da, db))
            }
            // atan2(y, x)′ = (x y′ − y x′)/(x² + y²)
            Op::Atan2(y, x) => {
                let (xx, yy) = (self.mul(x, x), self.mul(y, y));
                let square = self.add(xx, yy);
                let inverse = self.unary(Unary::Reciprocal, square);
                self.each(of(y), of(x), |g, dy, dx| {
                    let (left, right) = (g.mul(x, dy), g.mul(y, dx));
                    let turned = g.sub(left, right);
                    g.mul(turned, inverse)
                })
            }
            Op::Select(mask, a, b) => self.each(of(a), of(b), |g, da, db| g.select(mask, da, db)),
        }
    }

    /// A function of two operands' derivatives, in each direction that either has.
    fn each(
        &mut self,
        a: &Gradient,
        b: &Gradient,
        mut combine: impl FnMut(&mut Graph, Node, Node) -> Node,
    ) -> Gradient {
        let zero = self.constant(0.0);
        let mut combined = Gradient::new();
        for direction in a.keys().chain(b.keys().filter(|direction| !a.contains_key(direction))) {
            let of = |gradient: &Gradient| gradient.get(direction).copied().unwrap_or(zero);
            combined.insert(*direction, combine(self, of(a), of(b)));
        }
        combined
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbolic::{Class, evaluate};

    /// Two symbols with the directions 0 and 1.
    fn unknowns(g: &mut Graph) -> ([Node; 2], BTreeMap<Node, Gradient>) {
        let one = g.constant(1.0);
        let symbols = ["x", "y"].map(|name| g.symbol(name, Class::Position));
        let seed = symbols.iter().enumerate().map(|(k, symbol)| (*symbol, Gradient::from([(k, one)])));
        (symbols, seed.collect())
    }

    /// Compares both derivatives of what `build` makes of x and y with central differences, extrapolated.
    fn check(build: impl Fn(&mut Graph, Node, Node) -> Node, points: &[[f64; 2]]) {
        let mut g = Graph::new();
        let ([x, y], seed) = unknowns(&mut g);
        let root = build(&mut g, x, y);
        let gradient = g.differentiate(&[root], &seed).remove(0);
        let value = |at: [f64; 2]| evaluate(&g, &at)[root.index()];
        for at in points {
            for k in 0..2 {
                let slope = |h: f64| {
                    let (mut ahead, mut behind) = (*at, *at);
                    ahead[k] += h;
                    behind[k] -= h;
                    (value(ahead) - value(behind)) / (2.0 * h)
                };
                let expected = (4.0 * slope(5e-4) - slope(1e-3)) / 3.0;
                let found = gradient.get(&k).map_or(0.0, |node| evaluate(&g, at)[node.index()]);
                let close = (found - expected).abs() <= 1e-9 * (1.0 + expected.abs());
                assert!(close, "{:?} at {at:?}, direction {k}: {found} {expected}", g.op(root));
            }
        }
    }

    #[test]
    fn arithmetic_by_differences() {
        let points = [[0.7, 0.3], [-1.2, 0.8], [0.4, -1.5]];
        check(Graph::add, &points);
        check(Graph::sub, &points);
        check(Graph::mul, &points);
        check(Graph::div, &points);
        check(|g, x, y| g.atan2(y, x), &points);
        check(|g, x, _| g.neg(x), &points);
        // Something of everything, with common terms.
        check(
            |g, x, y| {
                let (product, quotient) = (g.mul(x, y), g.div(x, y));
                let sum = g.add(product, quotient);
                let sine = g.unary(Unary::Sin, sum);
                let difference = g.sub(sine, product);
                g.mul(difference, sum)
            },
            &points,
        );
    }

    #[test]
    fn functions_by_differences() {
        for function in Unary::ALL {
            let points = [[0.3, 1.0], [0.85, -2.0]];
            check(|g, x, _| g.unary(function, x), &points);
            check(
                |g, x, y| {
                    let product = g.mul(x, y);
                    let square = g.mul(product, product);
                    let fifth = g.constant(0.2);
                    let argument = g.mul(fifth, square);
                    g.unary(function, argument)
                },
                &points,
            );
        }
        let odd =
            [Unary::Abs, Unary::Sign, Unary::Sin, Unary::Cos, Unary::Tan, Unary::Exp, Unary::Reciprocal];
        for function in odd {
            check(|g, x, _| g.unary(function, x), &[[-0.6, 0.0]]);
        }
    }

    #[test]
    fn branches_have_the_derivative_of_the_one_taken() {
        let points = [[0.7, 0.3], [-1.2, 0.8]];
        let squares = |g: &mut Graph, x: Node, y: Node| (g.mul(x, x), g.mul(y, y));
        check(
            |g, x, y| {
                let (a, b) = squares(g, x, y);
                g.min(a, b)
            },
            &points,
        );
        check(
            |g, x, y| {
                let (a, b) = squares(g, x, y);
                g.max(b, a)
            },
            &points,
        );
        for comparison in [Compare::Less, Compare::LessEqual] {
            check(
                |g, x, y| {
                    let zero = g.constant(0.0);
                    let (a, b) = squares(g, x, y);
                    let mask = g.compare(comparison, x, zero);
                    let not = g.not(mask);
                    let both = g.or(mask, not);
                    let mask = g.and(mask, both);
                    g.select(mask, a, b)
                },
                &points,
            );
        }
    }

    #[test]
    fn min_and_max_have_at_a_tie_the_derivative_of_what_they_return() {
        let mut g = Graph::new();
        let ([x, y], seed) = unknowns(&mut g);
        let (least, most) = (g.min(x, y), g.max(x, y));
        for gradient in g.differentiate(&[least, most], &seed) {
            let values = evaluate(&g, &[2.0, 2.0]);
            assert_eq!([0, 1].map(|k| values[gradient[&k].index()]), [0.0, 1.0]);
        }
    }

    #[test]
    fn directions_may_be_any_nodes() {
        let mut g = Graph::new();
        let [c, s, held] = ["c", "s", "held"].map(|name| g.symbol(name, Class::Position));
        let minus = g.neg(s);
        let seed = BTreeMap::from([(c, Gradient::from([(7, minus)])), (s, Gradient::from([(7, c)]))]);
        let angle = g.atan2(s, c);
        let moved = g.mul(held, angle);
        let gradients = g.differentiate(&[angle, moved, held, c], &seed);
        // The angle of a pair that turns turns alike: x·(1/x) = 1 is found without numbers.
        let one = g.constant(1.0);
        assert_eq!(gradients[0], Gradient::from([(7, one)]));
        assert_eq!(gradients[1], Gradient::from([(7, held)]));
        assert!(gradients[2].is_empty());
        assert_eq!(gradients[3], Gradient::from([(7, minus)]));
    }

    #[test]
    fn what_vanishes_has_no_entry() {
        let mut g = Graph::new();
        let ([x, y], seed) = unknowns(&mut g);
        let sum = g.add(x, y);
        let back = g.sub(sum, y);
        let sign = g.unary(Unary::Sign, y);
        let gradients = g.differentiate(&[back, sign], &seed);
        assert_eq!(gradients[0].keys().copied().collect::<Vec<_>>(), [0]);
        assert!(gradients[1].is_empty());
    }
}
