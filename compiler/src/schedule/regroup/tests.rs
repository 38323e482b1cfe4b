use crate::functions::Argument;
use crate::optimize;
use crate::schedule::evaluate::{Inputs, run_straight};
use crate::schedule::{Program, Source, count, select};
use crate::symbolic::{Class, Graph, Node, Unary, evaluate};

const SYMBOLS: usize = 6;

/// A graph with symbols for positions, which are the entries of q.
fn graph() -> (Graph, Vec<Node>) {
    let mut graph = Graph::default();
    let symbols = (0..SYMBOLS).map(|at| graph.symbol(format!("x{at}"), Class::Position)).collect();
    (graph, symbols)
}

fn program(graph: &Graph, outputs: &[Node]) -> Program {
    let (fused, hoisted) = optimize::alone(graph, outputs);
    let source = |index: usize| Source { argument: Argument::Q, index: index as u32 };
    let sources: Vec<Source> = (0..SYMBOLS).map(source).collect();
    let mut selected = select::select(graph, &sources, &hoisted, &fused);
    super::regroup(&mut selected, &[]);
    selected.program
}

fn operations(make: impl Fn(&mut Graph, &[Node]) -> Node) -> (usize, usize) {
    let (mut graph, x) = graph();
    let node = make(&mut graph, &x);
    let counts = count(&program(&graph, &[node]));
    (counts.total(), counts.depth)
}

#[test]
fn products_are_absorbed() {
    let products = |g: &mut Graph, x: &[Node]| [g.mul(x[0], x[1]), g.mul(x[2], x[3])];
    let sum = |g: &mut Graph, x: &[Node]| {
        let [a, b] = products(g, x);
        let both = g.add(a, b);
        g.add(both, x[4])
    };
    assert_eq!(operations(sum), (2, 2));
    let difference = |g: &mut Graph, x: &[Node]| {
        let [a, b] = products(g, x);
        let both = g.sub(a, b);
        g.sub(x[4], both)
    };
    assert_eq!(operations(difference), (2, 2));
    // −x − (a b + c d): the first product takes the sign of x.
    let negative = |g: &mut Graph, x: &[Node]| {
        let [a, b] = products(g, x);
        let both = g.add(a, b);
        let minus = g.neg(x[4]);
        g.sub(minus, both)
    };
    assert_eq!(operations(negative), (2, 2));
    // Without another term one product stays.
    let alone = |g: &mut Graph, x: &[Node]| {
        let [a, b] = products(g, x);
        g.add(a, b)
    };
    assert_eq!(operations(alone), (2, 2));
}

/// a·b + c·d is in both, though neither sum says so.
#[test]
fn what_sums_begin_with_alike_is_computed_once() {
    let (mut g, x) = graph();
    let [a, b] = [g.mul(x[0], x[1]), g.mul(x[2], x[3])];
    let sums = [4, 5].map(|at| {
        let other = g.mul(x[at], x[at]);
        let both = g.add(a, other);
        g.add(both, b)
    });
    assert_eq!(count(&program(&g, &sums)).total(), 4);
}

#[test]
fn what_is_late_is_added_last() {
    let sum = |late_first: bool| {
        move |g: &mut Graph, x: &[Node]| {
            let late = (1..SYMBOLS).fold(x[0], |late, at| {
                let quotient = g.div(late, x[at]);
                g.mul(quotient, x[0])
            });
            let late = g.mul(late, x[5]);
            let [a, b] = [g.mul(x[0], x[1]), g.mul(x[2], x[3])];
            let (first, last) = if late_first { (late, b) } else { (b, late) };
            let both = g.add(first, a);
            g.add(both, last)
        }
    };
    let (operations, depth) = self::operations(sum(false));
    assert_eq!(self::operations(sum(true)), (operations, depth));
    assert_eq!(depth, 2 * (SYMBOLS - 1) + 1, "one operation behind the late one");
}

#[test]
fn constants_are_one_term() {
    // (1 + x₀) + (2 − x₁·x₂), and (1 + x₀) − (1 + x₁·x₂) where nothing is left.
    let both = |constant: f64| {
        operations(move |g, x| {
            let [one, other] = [1.0, constant].map(|value| g.constant(value));
            let (product, first) = (g.mul(x[1], x[2]), g.add(one, x[0]));
            let second = g.sub(other, product);
            g.add(first, second)
        })
    };
    assert_eq!(both(2.0).0, 2);
    assert_eq!(both(-1.0).0, 1);
    let without_products = operations(|g, x| {
        let [one, two] = [1.0, 2.0].map(|value| g.constant(value));
        let [first, second] =
            [g.mul(x[0], x[0]), g.mul(x[1], x[1])].map(|square| g.unary(Unary::Abs, square));
        let [first, second] = [g.add(one, first), g.add(two, second)];
        g.add(first, second)
    });
    assert_eq!(without_products.0, 4 + 2);
}

#[test]
fn a_constant_and_a_term_go_into_sums_with_constants() {
    // k = 2 + x₀·x₁ in 1 + x₂ + k and 3 + x₃ − k; in x₃ − k and x₄ − k it stays.
    let operations = |last: f64| {
        let (mut g, x) = graph();
        let [one, two, last] = [1.0, 2.0, last].map(|value| g.constant(value));
        let product = g.mul(x[0], x[1]);
        let k = g.add(two, product);
        let [first, second, third] = [(one, x[2]), (last, x[3]), (last, x[4])].map(|(k, x)| g.add(k, x));
        let outputs = [g.add(first, k), g.sub(second, k), g.sub(third, k)];
        count(&program(&g, &outputs)).total()
    };
    assert_eq!(operations(3.0), 6);
    assert_eq!(operations(0.0), 5);
}

#[test]
fn common_factors_are_taken_out() {
    // x₀·(x₁·x₂) + x₀·x₃ + x₄ = x₀·(x₁·x₂ + x₃) + x₄; without the last term nothing else is added.
    let common = |last: bool| {
        operations(move |g, x| {
            let inner = g.mul(x[1], x[2]);
            let [first, second] = [g.mul(x[0], inner), g.mul(x[3], x[0])];
            let both = g.sub(second, first);
            if last { g.sub(both, x[4]) } else { both }
        })
    };
    assert_eq!([common(true).0, common(false).0], [2, 2]);
    // A polynomial, by Horner's scheme.
    let polynomial = operations(|g, x| {
        let square = g.mul(x[0], x[0]);
        let [first, second] = [g.mul(square, x[1]), g.mul(x[0], x[2])];
        let both = g.add(first, second);
        g.add(both, x[3])
    });
    assert_eq!(polynomial.0, 2);
    // All terms have the factor, and all are taken away: −x₀·(x₁·x₂) − x₀·(x₃·x₄).
    let taken_away = operations(|g, x| {
        let [one, other] = [g.mul(x[1], x[2]), g.mul(x[3], x[4])];
        let [one, other] = [g.mul(x[0], one), g.mul(x[0], other)];
        let one = g.neg(one);
        g.sub(one, other)
    });
    assert_eq!(taken_away.0, 3);
    // A factor that spares nothing stays: x₀·x₁ + x₀·x₂ + x₃.
    let stays = |g: &mut Graph, x: &[Node]| {
        let [one, other] = [g.mul(x[0], x[1]), g.mul(x[0], x[2])];
        let both = g.add(one, other);
        g.add(both, x[3])
    };
    assert_eq!(operations(stays), (2, 2));
}

#[test]
fn constants_go_into_sums_that_are_needed_once() {
    // 2·(x₀·(0.5·x₁ + 1.5)) + x₂ = x₀·(x₁ + 3) + x₂.
    let scaled = operations(|g, x| {
        let [half, much, two] = [0.5, 1.5, 2.0].map(|value| g.constant(value));
        let half = g.mul(half, x[1]);
        let sum = g.add(half, much);
        let product = g.mul(x[0], sum);
        let doubled = g.mul(two, product);
        g.add(doubled, x[2])
    });
    assert_eq!(scaled.0, 2);
}

/// Numbers below a bound (Knuth, The Art of Computer Programming 2, 3.3.4, line 26 of table 1).
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (self.0 >> 33) as usize % bound
    }
}

#[test]
fn sums_keep_their_values() {
    let mut numbers = Numbers(7);
    let at: Vec<f64> = (0..SYMBOLS).map(|at| 0.3 + 0.41 * at as f64).collect();
    let mut shorter = 0;
    for case in 0..400 {
        let (mut graph, mut nodes) = graph();
        for _ in 0..6 + numbers.below(30) {
            let [a, b] = [0; 2].map(|_| nodes[numbers.below(nodes.len())]);
            let node = match numbers.below(10) {
                0 => graph.neg(a),
                9 => {
                    let constant = graph.constant(0.5 * numbers.below(5) as f64 - 1.0);
                    graph.mul(constant, a)
                }
                8 => {
                    let constant = graph.constant(numbers.below(5) as f64 - 2.0);
                    graph.sub(constant, a)
                }
                1..=3 => graph.add(a, b),
                4 => graph.sub(a, b),
                _ => graph.mul(a, b),
            };
            nodes.push(node);
        }
        let outputs = [0; 3].map(|_| nodes[numbers.below(nodes.len())]);
        let program = program(&graph, &outputs);
        let (fused, _) = optimize::alone(&graph, &outputs);
        let own = graph.reachable_until(outputs, |node| fused.is_leaf(node));
        let absorbed = fused.absorbs.iter().flatten().collect::<std::collections::BTreeSet<_>>().len();
        let plain = own.into_iter().filter(|node| !fused.is_leaf(*node)).count() - absorbed;
        assert!(count(&program).total() <= plain, "case {case}: {} and {plain}", count(&program).total());
        shorter += usize::from(count(&program).total() < plain);
        let values = evaluate(&graph, &at);
        let found = run_straight(&program, &Inputs { q: at.clone(), ..Inputs::default() });
        for (node, found) in outputs.iter().zip(found) {
            let expected = values[node.index()];
            let size = nodes.iter().map(|node| values[node.index()].abs()).fold(1.0, f64::max);
            assert!((found - expected).abs() <= 1e-13 * size, "case {case}: {found} and {expected}");
        }
    }
    assert!(shorter > 20, "{shorter} of 400 are shorter");
}
