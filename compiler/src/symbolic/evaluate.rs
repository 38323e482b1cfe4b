//! The interpreter of the graph: the first of the two evaluators.

use super::{Graph, Node, Op, Table};
use std::sync::Arc;

/// Values of all nodes, given those of the symbols in the order of their creation. Masks are 0 or 1.
pub fn evaluate(graph: &Graph, symbols: &[f64]) -> Vec<f64> {
    let mut values = vec![0.0; graph.len()];
    for (node, op) in graph.nodes() {
        values[node.index()] = step(op, symbols, &values, graph.tables());
    }
    values
}

/// As [`evaluate`], computing only what `outputs` need; the rest is left at zero. `order` is their common
/// ancestry, operands first, from [`Graph::reachable`].
pub fn evaluate_reachable(graph: &Graph, order: &[Node], symbols: &[f64], values: &mut Vec<f64>) {
    values.resize(graph.len(), 0.0);
    for node in order {
        values[node.index()] = step(graph.op(*node), symbols, values, graph.tables());
    }
}

/// Values of the nodes in `order`, one of them computed by another operation: for tests that must notice.
pub fn evaluate_with(graph: &Graph, order: &[Node], symbols: &[f64], change: Option<(Node, Op)>) -> Vec<f64> {
    let mut values = vec![0.0; graph.len()];
    for node in order {
        let op = match change {
            Some((changed, op)) if changed == *node => op,
            _ => graph.op(*node),
        };
        values[node.index()] = step(op, symbols, &values, graph.tables());
    }
    values
}

fn step(op: Op, symbols: &[f64], values: &[f64], tables: &[Arc<Table>]) -> f64 {
    let table = |number: u16| &tables[usize::from(number)];
    let get = |node: Node| values[node.index()];
    let mask = |value: bool| if value { 1.0 } else { 0.0 };
    match op {
        Op::Constant(bits) => f64::from_bits(bits),
        Op::Symbol(symbol) => symbols[symbol as usize],
        Op::Neg(a) => -get(a),
        Op::Add(a, b) => get(a) + get(b),
        Op::Sub(a, b) => get(a) - get(b),
        Op::Mul(a, b) => get(a) * get(b),
        Op::Div(a, b) => get(a) / get(b),
        Op::Unary(function, a) => function.value(get(a)),
        Op::Min(a, b) => super::min(get(a), get(b)),
        Op::Max(a, b) => super::max(get(a), get(b)),
        Op::Atan2(a, b) => libm::atan2(get(a), get(b)),
        Op::Compare(comparison, a, b) => mask(comparison.value(get(a), get(b))),
        Op::And(a, b) => mask(get(a) != 0.0 && get(b) != 0.0),
        Op::Or(a, b) => mask(get(a) != 0.0 || get(b) != 0.0),
        Op::Not(a) => mask(get(a) == 0.0),
        Op::Select(m, a, b) => get(if get(m) != 0.0 { a } else { b }),
        Op::Cell(number, x) => table(number).cell(get(x)),
        Op::Piece(number, orders, cell, x) => table(number).piece(orders.first(), get(cell), get(x)),
        Op::Patch(number, orders, cell, x, y) => table(number).patch(orders, get(cell), get(x), get(y)),
    }
}

impl Graph {
    /// Everything that `outputs` depend on, operands before users.
    pub fn reachable(&self, outputs: impl IntoIterator<Item = Node>) -> Vec<Node> {
        self.reachable_until(outputs, |_| false)
    }

    /// The same, but nothing that only a node depends on at which to stop. Work grows with what is reached, not with the
    /// graph: most functions of a large mechanism are small.
    pub fn reachable_until(
        &self,
        outputs: impl IntoIterator<Item = Node>,
        stop: impl Fn(Node) -> bool,
    ) -> Vec<Node> {
        let outputs: Vec<Node> = outputs.into_iter().collect();
        // Operands are older than their users: nothing newer than the newest output is reached.
        let end = outputs.iter().map(|node| node.index() + 1).max().unwrap_or(0);
        let mut seen = vec![false; end];
        let mut waiting: Vec<Node> = Vec::new();
        let mut found = Vec::new();
        let mut reach = |node: Node, waiting: &mut Vec<Node>| {
            if !seen[node.index()] {
                seen[node.index()] = true;
                waiting.push(node);
            }
        };
        outputs.into_iter().for_each(|node| reach(node, &mut waiting));
        while let Some(node) = waiting.pop() {
            found.push(node);
            if !stop(node) {
                self.op(node).operands().for_each(|operand| reach(operand, &mut waiting));
            }
        }
        // Operands are older than their users. Where much is reached, going through all is less work than sorting.
        if found.len() < end / 8 {
            found.sort_unstable();
        } else {
            found.clear();
            for (index, seen) in seen.into_iter().enumerate() {
                if seen {
                    found.push(Node(index as u32));
                }
            }
        }
        found
    }
}
