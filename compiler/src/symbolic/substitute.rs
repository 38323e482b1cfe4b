//! Replacing nodes by others in everything that depends on them.

use super::{Graph, Node, Op};
use std::collections::BTreeMap;

impl Graph {
    /// `roots` with every node that is a key replaced by its value.
    pub fn substitute(&mut self, roots: &[Node], replacements: &BTreeMap<Node, Node>) -> Vec<Node> {
        let mut replaced: BTreeMap<Node, Node> = replacements.clone();
        for node in self.reachable(roots.iter().copied()) {
            if replaced.contains_key(&node) {
                continue;
            }
            let op = self.op(node);
            if op.operands().any(|operand| replaced.contains_key(&operand)) {
                let fresh = self.rebuild(op, |operand| replaced.get(&operand).copied().unwrap_or(operand));
                replaced.insert(node, fresh);
            }
        }
        roots.iter().map(|root| replaced.get(root).copied().unwrap_or(*root)).collect()
    }

    fn rebuild(&mut self, op: Op, get: impl Fn(Node) -> Node) -> Node {
        match op {
            Op::Constant(bits) => self.constant(f64::from_bits(bits)),
            // Symbols have no operands: what is left of them stands as it is.
            Op::Symbol(symbol) => self.symbol_node(symbol),
            Op::Neg(a) => self.neg(get(a)),
            Op::Add(a, b) => self.add(get(a), get(b)),
            Op::Sub(a, b) => self.sub(get(a), get(b)),
            Op::Mul(a, b) => self.mul(get(a), get(b)),
            Op::Div(a, b) => self.div(get(a), get(b)),
            Op::Unary(function, a) => self.unary(function, get(a)),
            Op::Min(a, b) => self.min(get(a), get(b)),
            Op::Max(a, b) => self.max(get(a), get(b)),
            Op::Atan2(a, b) => self.atan2(get(a), get(b)),
            Op::Compare(comparison, a, b) => self.compare(comparison, get(a), get(b)),
            Op::And(a, b) => self.and(get(a), get(b)),
            Op::Or(a, b) => self.or(get(a), get(b)),
            Op::Not(a) => self.not(get(a)),
            Op::Select(m, a, b) => self.select(get(m), get(a), get(b)),
            Op::Cell(table, x) => self.cell(table, get(x)),
            Op::Piece(table, orders, cell, x) => self.piece(table, orders, get(cell), get(x)),
            Op::Patch(table, orders, cell, x, y) => self.patch(table, orders, get(cell), get(x), get(y)),
        }
    }
}
