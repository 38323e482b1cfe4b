//! Mutants of derived equations: what is changed in a graph, one place at a time, for a judge to notice.

use linkwright_compiler::symbolic::{Graph, Node, Op};

/// A node, what it is in place of itself, and what that changes.
pub type Mutant = (Node, Op, &'static str);

/// Flipped signs and dropped terms of every sum, difference and negation among these nodes.
pub fn mutants(graph: &Graph, nodes: &[Node], zero: Node) -> Vec<Mutant> {
    let mut found = Vec::new();
    for node in nodes {
        match graph.op(*node) {
            Op::Add(a, b) => found.extend([
                (*node, Op::Sub(a, b), "second sign flipped"),
                (*node, Op::Sub(b, a), "first sign flipped"),
                (*node, Op::Add(a, zero), "second term dropped"),
                (*node, Op::Add(b, zero), "first term dropped"),
            ]),
            Op::Sub(a, b) => found.extend([
                (*node, Op::Add(a, b), "second sign flipped"),
                (*node, Op::Sub(b, a), "both signs flipped"),
                (*node, Op::Add(a, zero), "second term dropped"),
                (*node, Op::Sub(zero, b), "first term dropped"),
            ]),
            Op::Neg(a) => found.push((*node, Op::Add(a, zero), "negation dropped")),
            _ => {}
        }
    }
    found
}

/// Whether a change turns the sign of the whole.
pub fn negates(graph: &Graph, node: Node, change: Op) -> bool {
    match (graph.op(node), change) {
        (Op::Sub(a, b), Op::Sub(c, d)) => a == d && b == c,
        (Op::Neg(_), Op::Add(..)) => true,
        _ => false,
    }
}

/// The operation of a node, and of its operands.
pub fn describe(graph: &Graph, node: Node) -> String {
    let name = |node: Node| match graph.op(node) {
        Op::Symbol(symbol) => graph.symbol_name(symbol).to_string(),
        Op::Constant(bits) => format!("{}", f64::from_bits(bits)),
        other => format!("{other:?}"),
    };
    let operands: Vec<String> = graph.op(node).operands().map(name).collect();
    format!("{:?} of ({})", graph.op(node), operands.join("; "))
}
