//! Which operations have a part in the results at a state, and how far off that is for the others: what touches, rubs or follows a table is
//! one function on one side of a kink and another on the other, and what is beyond is not seen.
//!
//! Distances are those of search-based testing: of comparisons the difference of both sides, the largest where all must change and the least where
//! one may (McMinn, Search-based software test data generation: a survey, Software Testing, Verification and Reliability 14 (2004), 2.2).

use linkwright_compiler::symbolic::{Graph, Node, Op, Unary};

/// Above what a difference of zero would be.
const JUST: f64 = 1e-9;

/// No farther off is what rounding alone decides: of a corner, which of both edges that end there is nearer.
pub const TIE: f64 = 2.0 * JUST;

/// Where 1 − tanh x and exp(−x) are small beside what is noticed.
const SATURATED: f64 = 8.0;
const FADED: f64 = 16.0;

/// How far a state is off for each node, and all its terms where it is a sum, to have a part in these results: 0 where they have. By the values
/// of all nodes, which come after their operands.
pub fn distances(graph: &Graph, nodes: &[Node], results: &[Node], values: &[f64]) -> Vec<f64> {
    let changes = Changes::new(graph, nodes, values);
    let mut distances = vec![f64::INFINITY; values.len()];
    results.iter().for_each(|result| distances[result.index()] = 0.0);
    for node in nodes.iter().rev() {
        let own = distances[node.index()];
        let mut passed = |operand: Node, further: f64| {
            let known = &mut distances[operand.index()];
            *known = known.min(own.max(further));
        };
        let apart = |a: Node, b: Node| (values[a.index()] - values[b.index()]).abs() + JUST;
        match graph.op(*node) {
            Op::Select(mask, then, otherwise) => {
                let [to_false, to_true] = changes.masks[mask.index()];
                // What only decides is seen where it decides otherwise.
                passed(mask, f64::INFINITY);
                passed(then, to_true);
                passed(otherwise, to_false);
            }
            Op::Min(a, b) | Op::Max(a, b) => {
                let first = values[node.index()] == values[a.index()];
                passed(a, if first { 0.0 } else { apart(a, b) });
                passed(b, if first { apart(a, b) } else { 0.0 });
            }
            Op::Mul(a, b) => {
                passed(a, changes.vanishing[b.index()]);
                passed(b, changes.vanishing[a.index()]);
            }
            Op::Div(a, b) => {
                passed(a, 0.0);
                passed(b, changes.vanishing[a.index()]);
            }
            // Where it is saturated nothing of its argument is left.
            Op::Unary(Unary::Tanh, a) => passed(a, (values[a.index()].abs() - SATURATED).max(0.0)),
            Op::Unary(Unary::Exp, a) => passed(a, (-values[a.index()] - FADED).max(0.0)),
            op => op.operands().for_each(|operand| passed(operand, 0.0)),
        }
    }
    for node in nodes {
        if let Op::Add(a, b) | Op::Sub(a, b) = graph.op(*node) {
            let terms = changes.vanishing[a.index()].max(changes.vanishing[b.index()]);
            distances[node.index()] = distances[node.index()].max(terms);
        }
    }
    distances
}

/// How far a state is off for something to be otherwise.
struct Changes {
    /// For a mask to be false, and true.
    masks: Vec<[f64; 2]>,
    /// For a number not to vanish.
    vanishing: Vec<f64>,
    /// For a number to be another function.
    functions: Vec<f64>,
}

impl Changes {
    fn new(graph: &Graph, nodes: &[Node], values: &[f64]) -> Self {
        let mut masks = vec![[f64::INFINITY; 2]; values.len()];
        let mut vanishing = vec![0.0_f64; values.len()];
        let mut functions = vec![f64::INFINITY; values.len()];
        let value = |node: Node| values[node.index()];
        for node in nodes {
            let mask = |node: Node| masks[node.index()];
            let zero = |node: Node| vanishing[node.index()];
            let other = |node: Node| functions[node.index()];
            let apart = |a: Node, b: Node| (value(a) - value(b)).abs() + JUST;
            let op = graph.op(*node);
            let found = match op {
                Op::Compare(_, a, b) if value(*node) == 0.0 => [0.0, apart(a, b)],
                Op::Compare(_, a, b) => [apart(a, b), 0.0],
                Op::And(a, b) => [mask(a)[0].min(mask(b)[0]), mask(a)[1].max(mask(b)[1])],
                Op::Or(a, b) => [mask(a)[0].max(mask(b)[0]), mask(a)[1].min(mask(b)[1])],
                Op::Not(a) => [mask(a)[1], mask(a)[0]],
                _ => [f64::INFINITY; 2],
            };
            let chosen = match op {
                Op::Min(a, b) | Op::Max(a, b) => apart(a, b),
                Op::Select(condition, ..) => mask(condition)[0].max(mask(condition)[1]),
                _ => f64::INFINITY,
            };
            let function = op.operands().map(other).fold(chosen, f64::min);
            let size = match op {
                _ if value(*node) != 0.0 => 0.0,
                Op::Constant(_) => f64::INFINITY,
                Op::Min(a, b) | Op::Max(a, b) => {
                    let within = |it: Node| zero(it).max(if value(it) == 0.0 { 0.0 } else { apart(a, b) });
                    within(a).min(within(b))
                }
                Op::Select(condition, then, otherwise) => {
                    let [to_false, to_true] = mask(condition);
                    to_true.max(zero(then)).min(to_false.max(zero(otherwise)))
                }
                Op::Mul(a, b) => zero(a).max(zero(b)),
                Op::Div(a, _) | Op::Neg(a) | Op::Unary(Unary::Abs | Unary::Sign | Unary::Sqrt, a) => zero(a),
                // What cancels does so on this side of a kink.
                Op::Add(a, b) | Op::Sub(a, b) if value(a) != 0.0 && value(b) != 0.0 => {
                    JUST.max(other(a).min(other(b)))
                }
                Op::Add(a, b) | Op::Sub(a, b) => zero(a).min(zero(b)),
                _ => 1.0,
            };
            masks[node.index()] = found;
            vanishing[node.index()] = size;
            functions[node.index()] = function;
        }
        Changes { masks, vanishing, functions }
    }
}
