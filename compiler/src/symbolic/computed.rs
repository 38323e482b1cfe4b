//! What is computed anyway, and what others take beside it: by this, ways of writing the same are compared before they are taken.

use super::{Class, Graph, Node, Op};
use std::collections::BTreeMap;

/// Nodes, with all that they need.
#[derive(Clone, Default)]
pub struct Computed(Vec<bool>);

impl Computed {
    fn has(&self, node: Node) -> bool {
        self.0.get(node.index()).copied().unwrap_or(false)
    }

    pub fn add(&mut self, graph: &Graph, nodes: &[Node]) {
        for node in self.beyond(graph, nodes) {
            self.0[node.index()] = true;
        }
    }

    /// What these need beyond it, each once.
    fn beyond(&mut self, graph: &Graph, nodes: &[Node]) -> Vec<Node> {
        self.0.resize(graph.len(), false);
        let mut found = Vec::new();
        let mut pending = nodes.to_vec();
        while let Some(node) = pending.pop() {
            if !std::mem::replace(&mut self.0[node.index()], true) {
                found.push(node);
                pending.extend(graph.op(node).operands());
            }
        }
        found.iter().for_each(|node| self.0[node.index()] = false);
        found
    }

    /// Operations that these take beyond it: of sums of sums all terms in one, so that each product in them that is needed once is one operation with
    /// its sum.
    pub fn cost(&mut self, graph: &Graph, nodes: &[Node]) -> usize {
        let beyond: Vec<Node> = self.beyond(graph, nodes);
        let moves = |node: &Node| graph.class(*node) > Class::Parameter;
        let own: Vec<Node> = beyond.into_iter().filter(moves).collect();
        let mut uses = BTreeMap::<Node, Uses>::new();
        nodes.iter().for_each(|node| uses.entry(*node).or_default().all += 1);
        for node in &own {
            let adds = is_sum(graph, *node);
            for operand in graph.op(*node).operands() {
                let known = uses.entry(operand).or_default();
                known.all += 1;
                known.in_sums += usize::from(adds);
            }
        }
        let is_part = |node: Node| {
            let is_part = uses.get(&node).is_some_and(|known| known.all == 1 && known.in_sums == 1);
            is_part && moves(&node) && !self.has(node)
        };
        let operations = own.iter().map(|node| match graph.op(*node) {
            Op::Constant(_) | Op::Symbol(_) => 0,
            // Counted with the sum.
            Op::Add(..) | Op::Sub(..) | Op::Neg(_) | Op::Mul(..) if is_part(*node) => 0,
            Op::Add(..) | Op::Sub(..) | Op::Neg(_) => {
                let (mut products, mut others) = (0, 0);
                let mut pending: Vec<Node> = graph.op(*node).operands().collect();
                while let Some(term) = pending.pop() {
                    match graph.op(term) {
                        Op::Mul(..) if is_part(term) => products += 1,
                        Op::Add(..) | Op::Sub(..) | Op::Neg(_) if is_part(term) => {
                            pending.extend(graph.op(term).operands());
                        }
                        _ => others += 1,
                    }
                }
                if others == 0 { products } else { (products + others - 1).max(1) }
            }
            _ => 1,
        });
        operations.sum()
    }
}

/// How many need a node, and how many of these are sums.
#[derive(Default)]
struct Uses {
    all: usize,
    in_sums: usize,
}

fn is_sum(graph: &Graph, node: Node) -> bool {
    matches!(graph.op(node), Op::Add(..) | Op::Sub(..) | Op::Neg(_))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbolic::Growing;

    #[test]
    fn what_is_computed_costs_nothing() {
        let graph = Growing::default();
        let g = graph.sheet();
        let [a, b] = ["a", "b"].map(|name| g.symbol(name, Class::Position));
        let product = a * b;
        let sum = product + a;
        let mut computed = Computed::default();
        // Together one, unless the product is needed elsewhere.
        assert_eq!(computed.cost(&g.graph(), &[sum.bare]), 1);
        assert_eq!(computed.cost(&g.graph(), &[sum.bare, product.bare]), 2);
        computed.add(&g.graph(), &[product.bare]);
        assert_eq!(computed.cost(&g.graph(), &[product.bare]), 0);
        assert_eq!(computed.cost(&g.graph(), &[sum.bare]), 1);
    }
}
