//! Products into sums: a·b + c is one operation where the target has a fused multiply-add.

use crate::symbolic::{Graph, Node, Op};
use std::collections::{BTreeMap, BTreeSet};

/// One function's part of the graph, with its fusions.
#[derive(Clone, Debug)]
pub struct Fused {
    pub outputs: Vec<Node>,
    /// How often each node is used, up to the newest that the function needs; so of all lists.
    pub uses: Vec<u32>,
    /// Nodes taken as given: constants, symbols and what is hoisted.
    pub leaves: Vec<bool>,
    /// The product that a sum absorbs.
    pub absorbs: Vec<Option<Node>>,
}

/// Decides which sums absorb which products. A sum absorbs one; a product is no operation of its own only if all its
/// uses absorb it, so a product with several uses is fused into all of them or into none.
pub fn fuse(graph: &Graph, outputs: &[Node], is_given: impl Fn(Node) -> bool) -> Fused {
    let is_leaf = |node: Node| matches!(graph.op(node), Op::Constant(_) | Op::Symbol(_)) || is_given(node);
    let order = graph.reachable_until(outputs.iter().copied(), is_leaf);
    // Most functions need the older part of the graph alone: what follows is the elimination.
    let n = order.last().map_or(0, |newest| newest.index() + 1);
    let mut fused =
        Fused { outputs: outputs.to_vec(), uses: vec![0; n], leaves: vec![false; n], absorbs: vec![None; n] };
    for output in outputs {
        fused.uses[output.index()] += 1;
    }
    for node in &order {
        let leaf = is_leaf(*node);
        fused.leaves[node.index()] = leaf;
        if !leaf {
            graph.op(*node).operands().for_each(|operand| fused.uses[operand.index()] += 1);
        }
    }

    let mut sums_of: BTreeMap<Node, Vec<Node>> = BTreeMap::new();
    for node in order {
        if fused.leaves[node.index()] {
            continue;
        }
        let (Op::Add(a, b) | Op::Sub(a, b)) = graph.op(node) else { continue };
        let single = [b, a].into_iter().find(|x| fused.is_product(graph, *x) && fused.uses[x.index()] == 1);
        match single {
            Some(product) => fused.absorbs[node.index()] = Some(product),
            None => {
                for product in [a, b].into_iter().filter(|x| fused.is_product(graph, *x)) {
                    sums_of.entry(product).or_default().push(node);
                }
            }
        }
    }
    let rows = in_rows(graph, &sums_of);
    for (product, sums) in &sums_of {
        let free = sums.iter().all(|sum| fused.absorbs[sum.index()].is_none());
        if free && sums.len() == fused.uses[product.index()] as usize && !rows.contains(product) {
            for sum in sums {
                fused.absorbs[sum.index()] = Some(*product);
            }
        }
    }
    fused
}

/// Of two products in a sum that are needed elsewhere too, the older is absorbed. In a row of sums that have one in common with the next that is
/// every second, and parts that are alike differ, so that neither compilers compute them side by side nor loops hold them all: of so many
/// products in a row none is absorbed.
const ROW: usize = 6;

/// The products in such rows, given the sums of each.
fn in_rows(graph: &Graph, sums_of: &BTreeMap<Node, Vec<Node>>) -> BTreeSet<Node> {
    let (mut seen, mut in_rows) = (BTreeSet::new(), BTreeSet::new());
    for product in sums_of.keys() {
        let mut row = Vec::new();
        let mut pending = vec![*product];
        while let Some(product) = pending.pop() {
            if !seen.insert(product) {
                continue;
            }
            row.push(product);
            let others = sums_of[&product].iter().flat_map(|sum| graph.op(*sum).operands());
            pending.extend(others.filter(|other| sums_of.contains_key(other)));
        }
        if row.len() >= ROW {
            in_rows.extend(row);
        }
    }
    in_rows
}

impl Fused {
    pub fn is_leaf(&self, node: Node) -> bool {
        self.leaves[node.index()]
    }
    fn is_product(&self, graph: &Graph, node: Node) -> bool {
        matches!(graph.op(node), Op::Mul(..)) && !self.is_leaf(node)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbolic::Class;

    /// How many products of a row of them are absorbed by the sums of neighbours: each is needed by two.
    fn absorbed(count: usize) -> usize {
        let mut g = Graph::default();
        let x: Vec<Node> = (0..=count).map(|at| g.symbol(format!("x{at}"), Class::Position)).collect();
        let products: Vec<Node> = x.windows(2).map(|pair| g.mul(pair[0], pair[1])).collect();
        let first = g.add(x[count], products[0]);
        let last = g.add(x[count], products[count - 1]);
        let mut sums: Vec<Node> = products.windows(2).map(|pair| g.add(pair[0], pair[1])).collect();
        sums.extend([first, last]);
        let fused = fuse(&g, &sums, |_| false);
        fused.absorbs.iter().flatten().copied().collect::<BTreeSet<_>>().len()
    }

    #[test]
    fn of_products_in_a_row_every_second_or_none() {
        assert_eq!([2, 3, 4, 5].map(absorbed), [1, 2, 2, 3]);
        assert_eq!([6, 10, 30].map(absorbed), [0, 0, 0]);
    }
}
