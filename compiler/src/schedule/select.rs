//! Instruction selection: one function's part of the graph as a program.

use super::program::{Instruction, Operand, Program, Source};
use crate::functions::Argument;
use crate::optimize::{Fused, Hoisted};
use crate::symbolic::{Graph, Node, Op};

struct Selection<'a> {
    graph: &'a Graph,
    sources: &'a [Source],
    hoisted: &'a Hoisted,
    fused: &'a Fused,
    values: Vec<Option<u32>>,
    instructions: Vec<Instruction>,
    nodes: Vec<Node>,
}

/// A program, and what its instructions compute.
#[derive(Default)]
pub struct Selected {
    pub program: Program,
    /// Node of each instruction; of all that compute a sum that of the sum.
    pub nodes: Vec<Node>,
}

impl Selected {
    /// The same with its instructions in another order, given by their present indices.
    pub fn in_order(self, order: &[usize]) -> Selected {
        Selected {
            program: self.program.in_order(order),
            nodes: order.iter().map(|old| self.nodes[*old]).collect(),
        }
    }
}

/// The function as instructions, operands first.
pub fn select(graph: &Graph, sources: &[Source], hoisted: &Hoisted, fused: &Fused) -> Selected {
    let values = vec![None; fused.leaves.len()];
    let (instructions, nodes) = (Vec::new(), Vec::new());
    let mut selection = Selection { graph, sources, hoisted, fused, values, instructions, nodes };
    for output in &fused.outputs {
        selection.compute(*output);
    }
    let outputs = fused.outputs.iter().map(|output| selection.operand(*output)).collect();
    let (sections, tables) = (Vec::new(), graph.tables().to_vec());
    let program =
        Program { instructions: selection.instructions, outputs, sections, tables, ..Program::default() };
    Selected { program, nodes: selection.nodes }
}

impl Selection<'_> {
    /// Emits what `root` needs, operands first, without recursion.
    fn compute(&mut self, root: Node) {
        let mut stack = vec![(root, false)];
        while let Some((node, ready)) = stack.pop() {
            if self.values[node.index()].is_some() || self.fused.is_leaf(node) {
                continue;
            }
            let (instruction, operands) = self.shape(node);
            if ready {
                self.values[node.index()] = Some(self.instructions.len() as u32);
                let instruction = self.build(node, instruction);
                self.instructions.push(instruction);
                self.nodes.push(node);
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
            Op::Neg(inner) if self.fused.uses[inner.index()] == 1 && !self.fused.is_leaf(inner) => {
                // −(a·b ± c) and −(k·x) cost no negation.
                if self.fused.absorbs[inner.index()].is_some() {
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
                match self.fused.absorbs[node.index()] {
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
            Op::Cell(table, x) => Instruction::Cell(table, self.operand(x)),
            Op::Piece(table, orders, cell, x) => {
                Instruction::Piece(table, orders, self.operand(cell), self.operand(x))
            }
            Op::Patch(table, orders, cell, x, y) => {
                let (x, y) = (self.operand(x), self.operand(y));
                Instruction::Patch(table, orders, self.operand(cell), x, y)
            }
        }
    }

    fn operand(&self, node: Node) -> Operand {
        if let Some(value) = self.graph.value(node) {
            return Operand::Constant(value);
        }
        match (self.graph.op(node), self.fused.is_leaf(node), self.hoisted.get(node)) {
            (Op::Symbol(symbol), _, None) => Operand::Source(self.sources[symbol as usize]),
            (_, true, Some(index)) => Operand::Source(Source { argument: Argument::Constants, index }),
            (Op::Symbol(symbol), ..) => Operand::Source(self.sources[symbol as usize]),
            _ => Operand::Value(self.values[node.index()].unwrap_or(0)),
        }
    }
}

enum Shape {
    Plain,
    MulAdd {
        product: Node,
        addend: Node,
        minus_product: bool,
        minus_addend: bool,
    },
    /// −k·x with a constant k.
    MinusScaled(Node, Node),
}
