//! Sums in another order, so that each product in them is absorbed, and what is computed latest is added last.
//!
//! ```text
//! (a·b + c·d) + x:    a product, a fused multiply-add, a sum
//! (x + a·b) + c·d:    two fused multiply-adds
//! ```
//! A sum of n terms takes n − 1 operations where it begins with a term that is no product, and n where there is none. What is
//! added last waits for nothing but itself. The equations say nothing of either: their sums are in the order in which they were set
//! up, and sums of sums as they came.

use super::program::{Instruction, Operand, Program};
use super::select::Selected;
use crate::symbolic::{Known, Node, mix};

/// A sum of more products than these keeps its order where its one other term comes latest: begun with it, it would be that much later.
const MANY: usize = 4;

/// Stands for the instruction before, in a sum.
const BEFORE: u32 = u32::MAX;

/// A term of a sum.
#[derive(Clone, Copy)]
struct Term {
    minus: bool,
    of: Of,
    /// How many operations it waits for, one after the other, and the newest node that it needs: what is equally late in all of a row of
    /// alike parts is in the same order in all of them.
    late: (usize, usize),
}

#[derive(Clone, Copy)]
enum Of {
    Value(Operand),
    Product(Operand, Operand),
}

impl Term {
    fn is_product(&self) -> bool {
        matches!(self.of, Of::Product(..))
    }
}

/// Puts the sums of a program in order. `rows`: instructions that repeat one another; sums in a row are in one order, that of the one in its middle.
pub fn regroup(selected: &mut Selected, rows: &[&[u32]]) {
    let mut sums = Sums::new(selected);
    let mut models: Vec<u32> = (0..selected.program.instructions.len() as u32).collect();
    let mut instead = sums.in_order(&models);
    if !rows.is_empty() {
        for row in rows {
            row.iter().for_each(|member| models[*member as usize] = row[row.len() / 2]);
        }
        instead = sums.in_order(&models);
    }
    let gone = unneeded(&selected.program, &instead);
    if gone.contains(&true) {
        replace(selected, &gone, &instead);
        let order = operands_first(&selected.program);
        *selected = std::mem::take(selected).in_order(&order);
    }
}

/// The instructions of a sum, one after the other.
type Sum = Vec<Instruction>;

/// Whether nothing needs an instruction once these sums stand in place of their last.
fn unneeded(program: &Program, instead: &[Option<Sum>]) -> Vec<bool> {
    let mut gone = vec![true; program.instructions.len()];
    let need = |gone: &mut Vec<bool>, operand: Operand| match operand {
        Operand::Value(value) if value != BEFORE => gone[value as usize] = false,
        _ => {}
    };
    program.outputs.iter().for_each(|output| need(&mut gone, *output));
    for (index, instruction) in program.instructions.iter().enumerate().rev() {
        if !gone[index] {
            let own = instead[index].as_deref().unwrap_or(std::slice::from_ref(instruction));
            own.iter().flat_map(Instruction::operands).for_each(|operand| need(&mut gone, operand));
        }
    }
    gone
}

/// Each instruction behind those that it needs and no others, so that few values are alive at once.
fn operands_first(program: &Program) -> Vec<usize> {
    let mut done = vec![false; program.instructions.len()];
    let mut order = Vec::with_capacity(done.len());
    let value = |operand: Operand| match operand {
        Operand::Value(value) => Some(value as usize),
        _ => None,
    };
    for output in program.outputs.iter().filter_map(|output| value(*output)) {
        let mut pending = vec![(output, false)];
        while let Some((index, ready)) = pending.pop() {
            if done[index] {
                continue;
            }
            if ready {
                done[index] = true;
                order.push(index);
                continue;
            }
            pending.push((index, true));
            // Of a product in a sum the sum so far comes first.
            let operands = program.instructions[index].operands().filter_map(value);
            pending.extend(operands.map(|operand| (operand, false)));
        }
    }
    order
}

/// What the sums of a program consist of.
struct Sums<'a> {
    program: &'a Program,
    nodes: &'a [Node],
    /// Whether an instruction is needed by nothing but sums that it is a part of: by one to which it is added, or by several if it costs none of
    /// them an operation.
    goes_on: Vec<bool>,
    /// How many operations, one after the other, each takes, as far as that is known.
    depth: Vec<usize>,
}

fn is_sum(instruction: &Instruction) -> bool {
    matches!(
        instruction,
        Instruction::Neg(_) | Instruction::Add(..) | Instruction::Sub(..) | Instruction::MulAdd(..)
    )
}

/// What an instruction adds.
fn added(instruction: &Instruction) -> impl Iterator<Item = Operand> {
    let (one, other) = match *instruction {
        Instruction::Neg(a) | Instruction::MulAdd(_, _, a, ..) => (Some(a), None),
        Instruction::Add(a, b) | Instruction::Sub(a, b) => (Some(a), Some(b)),
        _ => (None, None),
    };
    one.into_iter().chain(other)
}

impl<'a> Sums<'a> {
    fn new(selected: &'a Selected) -> Self {
        let program = &selected.program;
        let mut uses = vec![0_u32; program.instructions.len()];
        let operands = program.instructions.iter().flat_map(Instruction::operands);
        for operand in operands.chain(program.outputs.iter().copied()) {
            if let Operand::Value(value) = operand {
                uses[value as usize] += 1;
            }
        }
        let mut goes_on = vec![false; program.instructions.len()];
        for operand in program.instructions.iter().flat_map(added) {
            if let Operand::Value(value) = operand {
                goes_on[value as usize] = uses[value as usize] == 1;
            }
        }
        let depth = vec![0; program.instructions.len()];
        let mut sums = Sums { program, nodes: &selected.nodes, goes_on, depth };
        sums.spread_constants(&uses);
        sums
    }

    /// Of a constant and one term, k + a·b, a sum with a constant of its own takes the term alone in as many operations. Where all that need it are
    /// such sums, none needs it any more.
    fn spread_constants(&mut self, uses: &[u32]) {
        let instructions = &self.program.instructions;
        let is_constant = |operand: &Operand| matches!(operand, Operand::Constant(_));
        let goes_on =
            |operand: &Operand| matches!(operand, Operand::Value(value) if self.goes_on[*value as usize]);
        let of_two = |instruction: &Instruction| {
            let (constants, parts) =
                (added(instruction).filter(is_constant), added(instruction).filter(goes_on));
            !matches!(instruction, Instruction::Neg(_)) && constants.count() == 1 && parts.count() == 0
        };
        // The last instruction of the sum that each belongs to, and whether a constant is added there.
        let mut last: Vec<usize> = (0..instructions.len()).collect();
        let mut has_constant = vec![false; instructions.len()];
        for (index, instruction) in instructions.iter().enumerate().rev() {
            let own = last[index];
            for operand in added(instruction) {
                match operand {
                    Operand::Value(value) if self.goes_on[value as usize] => last[value as usize] = own,
                    Operand::Constant(_) => has_constant[own] = true,
                    _ => {}
                }
            }
        }
        let mut taken = vec![0; instructions.len()];
        let with_constants = (0..instructions.len()).filter(|index| has_constant[last[*index]]);
        for operand in with_constants.flat_map(|index| added(&instructions[index])) {
            if let Operand::Value(value) = operand {
                taken[value as usize] += 1;
            }
        }
        let spreads = |index: &usize| {
            !self.goes_on[*index]
                && uses[*index] > 1
                && taken[*index] == uses[*index]
                && of_two(&instructions[*index])
        };
        let spread: Vec<usize> = (0..instructions.len()).filter(spreads).collect();
        spread.into_iter().for_each(|index| self.goes_on[index] = true);
    }

    /// The sums of the program, by their last instructions, each in the order of its model if that is alike.
    fn in_order(&mut self, models: &[u32]) -> Vec<Option<Sum>> {
        let mut sums = Vec::with_capacity(self.program.instructions.len());
        for (root, instruction) in self.program.instructions.iter().enumerate() {
            let mut sum = None;
            if is_sum(instruction) && !self.goes_on[root] {
                let (mut terms, inner) = self.terms(root as u32);
                let model = (models[root] != root as u32).then(|| self.terms(models[root]).0);
                let order = order(model.as_deref().filter(|model| alike(model, &terms)).unwrap_or(&terms));
                terms = order.into_iter().map(|at| terms[at]).collect();
                sum = added_up(terms, inner + 1);
            }
            self.depth[root] = match &sum {
                Some(sum) => sum.iter().fold(0, |before, own| self.depth_of(own, before)),
                None => self.depth_of(instruction, 0),
            };
            sums.push(sum);
        }
        sums
    }

    /// The terms of a sum, and how many other instructions compute parts of it.
    fn terms(&self, root: u32) -> (Vec<Term>, usize) {
        let (mut terms, mut inner) = (Vec::new(), 0);
        let mut pending = vec![(Operand::Value(root), false)];
        while let Some((operand, minus)) = pending.pop() {
            let part = match operand {
                Operand::Value(value) if value == root || self.goes_on[value as usize] => Some(value),
                _ => None,
            };
            match part.map(|part| self.program.instructions[part as usize]) {
                Some(Instruction::Neg(a)) => pending.push((a, !minus)),
                Some(Instruction::Add(a, b)) => pending.extend([(b, minus), (a, minus)]),
                Some(Instruction::Sub(a, b)) => pending.extend([(b, !minus), (a, minus)]),
                Some(Instruction::Mul(a, b)) => terms.push(self.term(Of::Product(a, b), minus)),
                Some(Instruction::MulAdd(a, b, c, minus_product, minus_addend)) => {
                    terms.push(self.term(Of::Product(a, b), minus != minus_product));
                    pending.push((c, minus != minus_addend));
                }
                _ => {
                    terms.push(self.term(Of::Value(operand), minus));
                    continue;
                }
            }
            inner += usize::from(part != Some(root));
        }
        (constants_added(terms), inner)
    }

    fn term(&self, of: Of, minus: bool) -> Term {
        let late = |operand: Operand| match operand {
            Operand::Value(value) => (self.depth[value as usize], self.nodes[value as usize].index()),
            _ => (0, 0),
        };
        let late = match of {
            Of::Value(value) => late(value),
            Of::Product(a, b) => late(a).max(late(b)),
        };
        Term { minus, of, late }
    }

    /// The depth of an instruction, given that of the one before it in a sum.
    fn depth_of(&self, instruction: &Instruction, before: usize) -> usize {
        let depth = |operand: Operand| match operand {
            Operand::Value(BEFORE) => before,
            Operand::Value(value) => self.depth[value as usize],
            _ => 0,
        };
        1 + instruction.operands().map(depth).max().unwrap_or(0)
    }
}

/// The terms with their constants in one, in the place of the first.
fn constants_added(mut terms: Vec<Term>) -> Vec<Term> {
    let constant = |term: &Term| match term.of {
        Of::Value(Operand::Constant(value)) => Some(if term.minus { -value } else { value }),
        _ => None,
    };
    if terms.iter().filter_map(constant).count() > 1 {
        let sum: f64 = terms.iter().filter_map(constant).sum();
        let mut of = Some(Of::Value(Operand::Constant(sum.abs()))).filter(|_| sum != 0.0);
        terms.retain_mut(|term| match constant(term) {
            Some(_) => of.take().map(|of| (term.of, term.minus) = (of, sum < 0.0)).is_some(),
            None => true,
        });
    }
    terms
}

/// Whether two sums have terms of one form.
fn alike(one: &[Term], other: &[Term]) -> bool {
    let form = |term: &Term| (term.minus, term.is_product());
    one.iter().map(form).eq(other.iter().map(form))
}

/// Which of the terms comes first, second …
fn order(terms: &[Term]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..terms.len()).collect();
    order.sort_by_key(|at| terms[*at].late);
    order
}

/// The sum of these, one instruction after the other; `None` if that takes more than at present, or as much and no term is a product.
fn added_up(mut terms: Vec<Term>, present: usize) -> Option<Sum> {
    let products = terms.iter().filter(|term| term.is_product()).count();
    let fewest = if products == terms.len() { products } else { terms.len() - 1 };
    if terms.len() < 2 || fewest > present || (products == 0 && fewest == present) {
        return None;
    }
    let first = terms.iter().position(|term| !term.is_product());
    if products == terms.len() - 1 && products > MANY && first == Some(products) {
        return None;
    }
    let first = terms.remove(first.unwrap_or(0));
    // With a minus it is taken from a term that has none, or by a product, which takes any.
    if first.minus {
        let next = terms.iter().position(|term| term.is_product() || !term.minus)?;
        let next = terms.remove(next);
        terms.insert(0, next);
    }
    let mut sum = Vec::with_capacity(fewest);
    let mut so_far = match first.of {
        Of::Value(value) => value,
        Of::Product(a, b) => {
            sum.push(Instruction::Mul(a, b));
            Operand::Value(BEFORE)
        }
    };
    let mut negative = first.minus;
    for term in terms {
        sum.push(match (term.of, term.minus) {
            (Of::Product(a, b), minus) => Instruction::MulAdd(a, b, so_far, minus, negative),
            (Of::Value(value), false) if negative => Instruction::Sub(value, so_far),
            (Of::Value(value), false) => Instruction::Add(so_far, value),
            (Of::Value(value), true) => Instruction::Sub(so_far, value),
        });
        negative = false;
        so_far = Operand::Value(BEFORE);
    }
    Some(sum)
}

/// The program without what is gone, and with these sums in place of their last instructions; what two of them compute alike is
/// computed once.
fn replace(selected: &mut Selected, gone: &[bool], instead: &[Option<Sum>]) {
    let Selected { program, nodes } = selected;
    let mut position = vec![0_u32; gone.len()];
    let mut made = Made::default();
    let mut of = Vec::with_capacity(gone.len());
    for (index, instruction) in program.instructions.iter().enumerate().filter(|(index, _)| !gone[*index]) {
        let own = instead[index].as_deref();
        let mut before = 0;
        for instruction in own.unwrap_or(std::slice::from_ref(instruction)) {
            let moved = |operand: Operand| match operand {
                Operand::Value(BEFORE) => Operand::Value(before),
                Operand::Value(value) => Operand::Value(position[value as usize]),
                other => other,
            };
            before = made.once(instruction.map(moved));
            if before as usize == of.len() {
                of.push(nodes[index]);
            }
        }
        position[index] = before;
    }
    for output in &mut program.outputs {
        if let Operand::Value(value) = output {
            *value = position[*value as usize];
        }
    }
    (program.instructions, *nodes) = (made.instructions, of);
}

/// Instructions, each there once.
#[derive(Default)]
struct Made {
    instructions: Vec<Instruction>,
    known: Known,
}

impl Made {
    /// The index of an instruction, which is added unless it is there.
    fn once(&mut self, instruction: Instruction) -> u32 {
        let hash = hash(&instruction);
        let is_same = |index: u32| self.instructions[index as usize] == instruction;
        self.known.get(hash, is_same).unwrap_or_else(|| {
            self.instructions.push(instruction);
            self.known.add(hash)
        })
    }
}

/// Of its operands; instructions of different kinds that have the same are few.
fn hash(instruction: &Instruction) -> u64 {
    let word = |operand: Operand| match operand {
        Operand::Constant(value) => value.to_bits(),
        Operand::Source(source) => (source.argument as u64) << 33 | u64::from(source.index) << 1 | 1,
        Operand::Value(value) => u64::from(value) << 1,
    };
    instruction.operands().fold(0, |hash, operand| mix(hash, word(operand)))
}

#[cfg(test)]
mod tests {
    use crate::functions::Argument;
    use crate::optimize;
    use crate::schedule::evaluate::{Inputs, run_straight};
    use crate::schedule::{Program, Source, count, select};
    use crate::symbolic::{Class, Graph, Node, Unary, evaluate};

    const SYMBOLS: usize = 6;

    /// A graph with symbols for positions, which are the entries of q.
    fn graph() -> (Graph, Vec<Node>) {
        let mut graph = Graph::default();
        let symbols = (0..SYMBOLS).map(|at| graph.symbol(format!("x{at}"), Class::Position)).collect();
        (graph, symbols)
    }

    fn program(graph: &Graph, outputs: &[Node]) -> Program {
        let (fused, hoisted) = optimize::alone(graph, outputs);
        let source = |index: usize| Source { argument: Argument::Q, index: index as u32 };
        let sources: Vec<Source> = (0..SYMBOLS).map(source).collect();
        let mut selected = select::select(graph, &sources, &hoisted, &fused);
        super::regroup(&mut selected, &[]);
        selected.program
    }

    fn operations(make: impl Fn(&mut Graph, &[Node]) -> Node) -> (usize, usize) {
        let (mut graph, x) = graph();
        let node = make(&mut graph, &x);
        let counts = count(&program(&graph, &[node]));
        (counts.total(), counts.depth)
    }

    #[test]
    fn products_are_absorbed() {
        let products = |g: &mut Graph, x: &[Node]| [g.mul(x[0], x[1]), g.mul(x[2], x[3])];
        let sum = |g: &mut Graph, x: &[Node]| {
            let [a, b] = products(g, x);
            let both = g.add(a, b);
            g.add(both, x[4])
        };
        assert_eq!(operations(sum), (2, 2));
        let difference = |g: &mut Graph, x: &[Node]| {
            let [a, b] = products(g, x);
            let both = g.sub(a, b);
            g.sub(x[4], both)
        };
        assert_eq!(operations(difference), (2, 2));
        // −x − (a b + c d): the first product takes the sign of x.
        let negative = |g: &mut Graph, x: &[Node]| {
            let [a, b] = products(g, x);
            let both = g.add(a, b);
            let minus = g.neg(x[4]);
            g.sub(minus, both)
        };
        assert_eq!(operations(negative), (2, 2));
        // Without another term one product stays.
        let alone = |g: &mut Graph, x: &[Node]| {
            let [a, b] = products(g, x);
            g.add(a, b)
        };
        assert_eq!(operations(alone), (2, 2));
    }

    /// a·b + c·d is in both, though neither sum says so.
    #[test]
    fn what_sums_begin_with_alike_is_computed_once() {
        let (mut g, x) = graph();
        let [a, b] = [g.mul(x[0], x[1]), g.mul(x[2], x[3])];
        let sums = [4, 5].map(|at| {
            let other = g.mul(x[at], x[at]);
            let both = g.add(a, other);
            g.add(both, b)
        });
        assert_eq!(count(&program(&g, &sums)).total(), 4);
    }

    #[test]
    fn what_is_late_is_added_last() {
        let sum = |late_first: bool| {
            move |g: &mut Graph, x: &[Node]| {
                let late = (1..SYMBOLS).fold(x[0], |late, at| {
                    let quotient = g.div(late, x[at]);
                    g.mul(quotient, x[0])
                });
                let late = g.mul(late, x[5]);
                let [a, b] = [g.mul(x[0], x[1]), g.mul(x[2], x[3])];
                let (first, last) = if late_first { (late, b) } else { (b, late) };
                let both = g.add(first, a);
                g.add(both, last)
            }
        };
        let (operations, depth) = self::operations(sum(false));
        assert_eq!(self::operations(sum(true)), (operations, depth));
        assert_eq!(depth, 2 * (SYMBOLS - 1) + 1, "one operation behind the late one");
    }

    #[test]
    fn constants_are_one_term() {
        // (1 + x₀) + (2 − x₁·x₂), and (1 + x₀) − (1 + x₁·x₂) where nothing is left.
        let both = |constant: f64| {
            operations(move |g, x| {
                let [one, other] = [1.0, constant].map(|value| g.constant(value));
                let (product, first) = (g.mul(x[1], x[2]), g.add(one, x[0]));
                let second = g.sub(other, product);
                g.add(first, second)
            })
        };
        assert_eq!(both(2.0).0, 2);
        assert_eq!(both(-1.0).0, 1);
        let without_products = operations(|g, x| {
            let [one, two] = [1.0, 2.0].map(|value| g.constant(value));
            let [first, second] =
                [g.mul(x[0], x[0]), g.mul(x[1], x[1])].map(|square| g.unary(Unary::Abs, square));
            let [first, second] = [g.add(one, first), g.add(two, second)];
            g.add(first, second)
        });
        assert_eq!(without_products.0, 4 + 2);
    }

    #[test]
    fn a_constant_and_a_term_go_into_sums_with_constants() {
        // k = 2 + x₀·x₁ in 1 + x₂ + k and 3 + x₃ − k; in x₃ − k and x₄ − k it stays.
        let operations = |last: f64| {
            let (mut g, x) = graph();
            let [one, two, last] = [1.0, 2.0, last].map(|value| g.constant(value));
            let product = g.mul(x[0], x[1]);
            let k = g.add(two, product);
            let [first, second, third] = [(one, x[2]), (last, x[3]), (last, x[4])].map(|(k, x)| g.add(k, x));
            let outputs = [g.add(first, k), g.sub(second, k), g.sub(third, k)];
            count(&program(&g, &outputs)).total()
        };
        assert_eq!(operations(3.0), 6);
        assert_eq!(operations(0.0), 5);
    }

    /// Numbers below a bound (Knuth, The Art of Computer Programming 2, 3.3.4, line 26 of table 1).
    struct Numbers(u64);

    impl Numbers {
        fn below(&mut self, bound: usize) -> usize {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (self.0 >> 33) as usize % bound
        }
    }

    #[test]
    fn sums_keep_their_values() {
        let mut numbers = Numbers(7);
        let at: Vec<f64> = (0..SYMBOLS).map(|at| 0.3 + 0.41 * at as f64).collect();
        let mut shorter = 0;
        for case in 0..400 {
            let (mut graph, mut nodes) = graph();
            for _ in 0..6 + numbers.below(30) {
                let [a, b] = [0; 2].map(|_| nodes[numbers.below(nodes.len())]);
                let node = match numbers.below(9) {
                    0 => graph.neg(a),
                    8 => {
                        let constant = graph.constant(numbers.below(5) as f64 - 2.0);
                        graph.sub(constant, a)
                    }
                    1..=3 => graph.add(a, b),
                    4 => graph.sub(a, b),
                    _ => graph.mul(a, b),
                };
                nodes.push(node);
            }
            let outputs = [0; 3].map(|_| nodes[numbers.below(nodes.len())]);
            let program = program(&graph, &outputs);
            let (fused, _) = optimize::alone(&graph, &outputs);
            let own = graph.reachable_until(outputs, |node| fused.is_leaf(node));
            let absorbed = fused.absorbs.iter().flatten().collect::<std::collections::BTreeSet<_>>().len();
            let plain = own.into_iter().filter(|node| !fused.is_leaf(*node)).count() - absorbed;
            assert!(count(&program).total() <= plain, "case {case}: {} and {plain}", count(&program).total());
            shorter += usize::from(count(&program).total() < plain);
            let values = evaluate(&graph, &at);
            let found = run_straight(&program, &Inputs { q: at.clone(), ..Inputs::default() });
            for (node, found) in outputs.iter().zip(found) {
                let expected = values[node.index()];
                let size = nodes.iter().map(|node| values[node.index()].abs()).fold(1.0, f64::max);
                assert!((found - expected).abs() <= 1e-13 * size, "case {case}: {found} and {expected}");
            }
        }
        assert!(shorter > 20, "{shorter} of 400 are shorter");
    }
}
