//! A value that depends on nothing but parameters is taken out of every function and computed once.

use crate::symbolic::{Class, Graph, Node, Op};
use std::collections::BTreeMap;

/// The nodes hoisted, in the order in which functions asked for them.
#[derive(Clone, Debug, Default)]
pub struct Hoisted {
    pub nodes: Vec<Node>,
    index: BTreeMap<Node, u32>,
}

impl Hoisted {
    pub fn len(&self) -> usize {
        self.nodes.len()
    }
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }
    /// Which constant of the prepared model a node is.
    pub fn get(&self, node: Node) -> Option<u32> {
        self.index.get(&node).copied()
    }

    /// Hoists what `outputs` need: of each expression of parameters the outermost node.
    pub(super) fn hoist(&mut self, graph: &Graph, outputs: &[Node]) {
        let hoistable = |node: Node| is_hoistable(graph, node);
        let reached = graph.reachable_until(outputs.iter().copied(), hoistable);
        for node in reached.into_iter().filter(|node| hoistable(*node)) {
            if !self.index.contains_key(&node) {
                self.index.insert(node, self.nodes.len() as u32);
                self.nodes.push(node);
            }
        }
    }
}

/// A number, not itself a constant, that depends on parameters only. Masks are no numbers; each function compares
/// again.
pub(super) fn is_hoistable(graph: &Graph, node: Node) -> bool {
    let op = graph.op(node);
    let excluded = matches!(op, Op::Constant(_) | Op::Compare(..) | Op::And(..) | Op::Or(..) | Op::Not(_));
    graph.class(node) <= Class::Parameter && !excluded
}
