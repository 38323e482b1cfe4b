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

    /// Operations that these take beyond it; a product that is needed once, by a sum, is one with that.
    pub fn cost(&mut self, graph: &Graph, nodes: &[Node]) -> usize {
        let beyond: Vec<Node> = self.beyond(graph, nodes);
        let own: Vec<Node> =
            beyond.into_iter().filter(|node| graph.class(*node) > Class::Parameter).collect();
        let mut uses = BTreeMap::<Node, usize>::new();
        let operands = own.iter().flat_map(|node| graph.op(*node).operands());
        operands.chain(nodes.iter().copied()).for_each(|node| *uses.entry(node).or_default() += 1);
        let is_absorbed = |node: Node| {
            matches!(graph.op(node), Op::Mul(..)) && uses.get(&node) == Some(&1) && !self.has(node)
        };
        let operations = own.iter().map(|node| match graph.op(*node) {
            Op::Constant(_) | Op::Symbol(_) => 0,
            Op::Add(a, b) | Op::Sub(a, b) => usize::from(!(is_absorbed(a) || is_absorbed(b))),
            _ => 1,
        });
        operations.sum()
    }
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
