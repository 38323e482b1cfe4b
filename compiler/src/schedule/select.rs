//! Instruction selection: one function's part of the graph as a program, with products fused into sums.

use super::program::{Instruction, Operand, Program, Source};
use crate::symbolic::{Class, Graph, Node, Op};
use std::collections::BTreeMap;

/// Constants of the prepared model, shared by all functions of a mechanism: nodes that depend on nothing but
/// parameters, in the order in which functions ask for them.
#[derive(Clone, Debug, Default)]
pub struct Prepared {
    pub nodes: Vec<Node>,
    known: BTreeMap<Node, u32>,
}

impl Prepared {
    fn index(&mut self, node: Node) -> u32 {
        *self.known.entry(node).or_insert_with(|| {
            self.nodes.push(node);
            self.nodes.len() as u32 - 1
        })
    }
}

/// How the uses of a product are served.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Fusion {
    /// Computed on its own.
    None,
    /// Every use is a sum that absorbs it.
    Absorbed,
}

struct Selection<'a> {
    graph: &'a Graph,
    sources: &'a [Source],
    prepared: Option<&'a mut Prepared>,
    needed: Vec<bool>,
    uses: Vec<u32>,
    fusion: Vec<Fusion>,
    /// The product that a sum absorbs.
    absorbs: Vec<Option<Node>>,
    values: Vec<Option<u32>>,
    instructions: Vec<Instruction>,
}

/// Compiles `outputs`. With `prepared`, what depends on parameters only is taken from there; without, computed.
pub fn select(
    graph: &Graph,
    sources: &[Source],
    prepared: Option<&mut Prepared>,
    outputs: &[Node],
) -> Program {
    let n = graph.len();
    let mut selection = Selection {
        graph,
        sources,
        prepared,
        needed: vec![false; n],
        uses: vec![0; n],
        fusion: vec![Fusion::None; n],
        absorbs: vec![None; n],
        values: vec![None; n],
        instructions: Vec::new(),
    };
    selection.mark(outputs);
    selection.fuse();
    for output in outputs {
        selection.compute(*output);
    }
    let outputs = outputs.iter().map(|output| selection.operand(*output)).collect();
    Program { instructions: selection.instructions, outputs }
}

impl Selection<'_> {
    /// Whether the node is a leaf of this function.
    fn is_leaf(&self, node: Node) -> bool {
        matches!(self.graph.op(node), Op::Constant(_) | Op::Symbol(_))
            || (self.prepared.is_some() && self.is_preparable(node))
    }

    /// Whether the prepared model holds the node: a number that depends on parameters only. Masks are no numbers;
    /// each function compares again.
    fn is_preparable(&self, node: Node) -> bool {
        let mask = matches!(self.graph.op(node), Op::Compare(..) | Op::And(..) | Op::Or(..) | Op::Not(_));
        self.graph.class(node) <= Class::Parameter && !mask
    }

    /// Counts uses of what the outputs need.
    fn mark(&mut self, outputs: &[Node]) {
        for output in outputs {
            self.needed[output.index()] = true;
            self.uses[output.index()] += 1;
        }
        for (node, op) in self.graph.nodes().rev() {
            if self.needed[node.index()] && !self.is_leaf(node) {
                for operand in op.operands() {
                    self.needed[operand.index()] = true;
                    self.uses[operand.index()] += 1;
                }
            }
        }
    }

    fn is_product(&self, node: Node) -> bool {
        matches!(self.graph.op(node), Op::Mul(..)) && !self.is_leaf(node)
    }

    /// Which sums absorb which products. A sum absorbs one; a product disappears only if all its uses absorb it.
    fn fuse(&mut self) {
        let mut sums_of: BTreeMap<Node, Vec<Node>> = BTreeMap::new();
        for (node, op) in self.graph.nodes() {
            if !self.needed[node.index()] || self.is_leaf(node) {
                continue;
            }
            if let Op::Add(a, b) | Op::Sub(a, b) = op {
                let single = [b, a].into_iter().find(|x| self.is_product(*x) && self.uses[x.index()] == 1);
                if let Some(product) = single {
                    self.absorbs[node.index()] = Some(product);
                    self.fusion[product.index()] = Fusion::Absorbed;
                } else {
                    for product in [a, b].into_iter().filter(|x| self.is_product(*x)) {
                        sums_of.entry(product).or_default().push(node);
                    }
                }
            }
        }
        for (product, sums) in sums_of {
            let free = sums.iter().all(|sum| self.absorbs[sum.index()].is_none());
            if free && sums.len() == self.uses[product.index()] as usize {
                for sum in sums {
                    self.absorbs[sum.index()] = Some(product);
                }
                self.fusion[product.index()] = Fusion::Absorbed;
            }
        }
    }

    /// Emits what `root` needs, operands first, without recursion.
    fn compute(&mut self, root: Node) {
        let mut stack = vec![(root, false)];
        while let Some((node, ready)) = stack.pop() {
            if self.values[node.index()].is_some() || self.is_leaf(node) {
                continue;
            }
            let (instruction, operands) = self.shape(node);
            if ready {
                self.values[node.index()] = Some(self.instructions.len() as u32);
                let instruction = self.build(node, instruction);
                self.instructions.push(instruction);
            } else {
                stack.push((node, true));
                // Pushed in reverse so that the first operand is computed first.
                stack.extend(operands.into_iter().rev().flatten().map(|operand| (operand, false)));
            }
        }
    }

    /// The operation a node becomes, and the nodes it needs.
    fn shape(&self, node: Node) -> (Shape, [Option<Node>; 3]) {
        let graph = self.graph;
        match graph.op(node) {
            Op::Neg(inner) if self.uses[inner.index()] == 1 && !self.is_leaf(inner) => {
                // −(a·b ± c) and −(k·x) cost no negation.
                if self.absorbs[inner.index()].is_some() {
                    let (Shape::MulAdd { product, addend, minus_product, minus_addend }, operands) =
                        self.shape(inner)
                    else {
                        return (Shape::Plain, [Some(inner), None, None]);
                    };
                    let negated = Shape::MulAdd {
                        product,
                        addend,
                        minus_product: !minus_product,
                        minus_addend: !minus_addend,
                    };
                    return (negated, operands);
                }
                if let Op::Mul(k, x) = graph.op(inner)
                    && graph.value(k).is_some()
                {
                    return (Shape::MinusScaled(k, x), [Some(k), Some(x), None]);
                }
                (Shape::Plain, [Some(inner), None, None])
            }
            Op::Add(a, b) | Op::Sub(a, b) => {
                let subtract = matches!(graph.op(node), Op::Sub(..));
                match self.absorbs[node.index()] {
                    None => (Shape::Plain, [Some(a), Some(b), None]),
                    Some(product) => {
                        let product_is_second = product == b;
                        let addend = if product_is_second { a } else { b };
                        let shape = Shape::MulAdd {
                            product,
                            addend,
                            minus_product: subtract && product_is_second,
                            minus_addend: subtract && !product_is_second,
                        };
                        let mut factors = graph.op(product).operands();
                        (shape, [factors.next(), factors.next(), Some(addend)])
                    }
                }
            }
            op => {
                let mut operands = op.operands();
                (Shape::Plain, [operands.next(), operands.next(), operands.next()])
            }
        }
    }

    fn build(&mut self, node: Node, shape: Shape) -> Instruction {
        match shape {
            Shape::MulAdd { product, addend, minus_product, minus_addend } => {
                let mut factors = self.graph.op(product).operands();
                let (a, b) = (factors.next().unwrap_or(product), factors.next().unwrap_or(product));
                let (a, b, c) = (self.operand(a), self.operand(b), self.operand(addend));
                Instruction::MulAdd(a, b, c, minus_product, minus_addend)
            }
            Shape::MinusScaled(k, x) => {
                let k = -self.graph.value(k).unwrap_or(1.0);
                Instruction::Mul(Operand::Constant(k), self.operand(x))
            }
            Shape::Plain => self.plain(node),
        }
    }

    fn plain(&mut self, node: Node) -> Instruction {
        match self.graph.op(node) {
            // Leaves never get here; a constant or symbol on its own would be its own value.
            Op::Constant(_) | Op::Symbol(_) => Instruction::Neg(Operand::Constant(-0.0)),
            Op::Neg(a) => Instruction::Neg(self.operand(a)),
            Op::Add(a, b) => Instruction::Add(self.operand(a), self.operand(b)),
            Op::Sub(a, b) => Instruction::Sub(self.operand(a), self.operand(b)),
            Op::Mul(a, b) => Instruction::Mul(self.operand(a), self.operand(b)),
            Op::Div(a, b) => Instruction::Div(self.operand(a), self.operand(b)),
            Op::Unary(function, a) => Instruction::Unary(function, self.operand(a)),
            Op::Min(a, b) => Instruction::Min(self.operand(a), self.operand(b)),
            Op::Max(a, b) => Instruction::Max(self.operand(a), self.operand(b)),
            Op::Atan2(a, b) => Instruction::Atan2(self.operand(a), self.operand(b)),
            Op::Compare(comparison, a, b) => {
                Instruction::Compare(comparison, self.operand(a), self.operand(b))
            }
            Op::And(a, b) => Instruction::And(self.operand(a), self.operand(b)),
            Op::Or(a, b) => Instruction::Or(self.operand(a), self.operand(b)),
            Op::Not(a) => Instruction::Not(self.operand(a)),
            Op::Select(m, a, b) => Instruction::Select(self.operand(m), self.operand(a), self.operand(b)),
        }
    }

    fn operand(&mut self, node: Node) -> Operand {
        if let Some(value) = self.graph.value(node) {
            return Operand::Constant(value);
        }
        let preparable = self.is_preparable(node);
        if let (Some(prepared), true) = (&mut self.prepared, preparable) {
            return Operand::Source(Source::Prepared(prepared.index(node)));
        }
        match self.graph.op(node) {
            Op::Symbol(symbol) => Operand::Source(self.sources[symbol as usize]),
            _ => Operand::Value(self.values[node.index()].unwrap_or(0)),
        }
    }
}

enum Shape {
    Plain,
    MulAdd { product: Node, addend: Node, minus_product: bool, minus_addend: bool },
    /// −k·x with a constant k.
    MinusScaled(Node, Node),
}
