//! What sums consist of: their terms, through all sums that are needed nowhere else.

use super::super::program::{Instruction, Operand, Program};
use super::super::select::Selected;
use super::written::{OWN, Sum, added_up, order};
use crate::symbolic::Node;

/// A term of a sum.
#[derive(Clone)]
pub(super) struct Term {
    pub(super) minus: bool,
    pub(super) of: Of,
    /// How many operations it waits for, one after the other, and the newest node that it needs: what is equally late in all of a row of
    /// alike parts is in the same order in all of them.
    pub(super) late: (usize, usize),
}

#[derive(Clone)]
pub(super) enum Of {
    Value(Operand),
    Product(Operand, Operand),
    /// A product with a sum that nothing else needs.
    ProductOfSum(Operand, Vec<Term>),
}

impl Term {
    pub(super) fn is_product(&self) -> bool {
        !matches!(self.of, Of::Value(_))
    }
}

/// What the sums of a program consist of.
pub(super) struct Sums<'a> {
    pub(super) program: &'a Program,
    nodes: &'a [Node],
    /// Whether an instruction is needed by nothing but sums that it is a part of: by one to which it is added, or by several if it costs none of
    /// them an operation.
    goes_on: Vec<bool>,
    /// How many operands and outputs each is.
    pub(super) uses: Vec<u32>,
    /// Whether common factors are taken out of sums.
    factors: bool,
    /// How many operations, one after the other, each takes, as far as that is known.
    depth: Vec<usize>,
}

pub(super) fn is_sum(instruction: &Instruction) -> bool {
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
    pub(super) fn new(selected: &'a Selected, factors: bool) -> Self {
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
        let mut sums = Sums { program, nodes: &selected.nodes, goes_on, uses, factors, depth };
        sums.spread_constants();
        sums
    }

    /// Of a constant and one term, k + a·b, a sum with a constant of its own takes the term alone in as many operations. Where all that need it are
    /// such sums, none needs it any more.
    fn spread_constants(&mut self) {
        let uses = &self.uses;
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
    pub(super) fn in_order(&mut self, models: &[u32]) -> Vec<Option<Sum>> {
        let mut sums = Vec::with_capacity(self.program.instructions.len());
        for (root, instruction) in self.program.instructions.iter().enumerate() {
            let mut sum = None;
            if is_sum(instruction) && !self.goes_on[root] {
                let (terms, inner) = self.terms(root as u32);
                let model = (models[root] != root as u32).then(|| self.terms(models[root]).0);
                let model = model.as_deref().filter(|model| alike(model, &terms)).unwrap_or(&terms);
                let factored = self.factors.then(|| self.factored(&terms)).flatten();
                let factored = factored.and_then(|(terms, beyond)| added_up(terms, inner + beyond + 1));
                let in_order = || order(model).into_iter().map(|at| terms[at].clone()).collect();
                sum = factored.or_else(|| added_up(in_order(), inner + 1));
            }
            self.depth[root] = self.depth_of(sum.as_deref().unwrap_or(std::slice::from_ref(instruction)));
            sums.push(sum);
        }
        sums
    }

    /// The terms of a sum, and how many other instructions compute parts of it.
    pub(super) fn terms(&self, root: u32) -> (Vec<Term>, usize) {
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

    /// A term with this, which is as late as the latest of it.
    pub(super) fn term(&self, of: Of, minus: bool) -> Term {
        let late = |operand: Operand| match operand {
            Operand::Value(value) => (self.depth[value as usize], self.nodes[value as usize].index()),
            _ => (0, 0),
        };
        let late = match &of {
            Of::Value(value) => late(*value),
            Of::Product(a, b) => late(*a).max(late(*b)),
            Of::ProductOfSum(a, terms) => {
                let (depth, node) = terms.iter().map(|term| term.late).max().unwrap_or_default();
                late(*a).max((depth + terms.len(), node))
            }
        };
        Term { minus, of, late }
    }

    /// The depth of the last of these instructions of a sum.
    fn depth_of(&self, sum: &[Instruction]) -> usize {
        let mut own: Vec<usize> = Vec::with_capacity(sum.len());
        for instruction in sum {
            let depth = |operand: Operand| match operand {
                Operand::Value(value) if value >= OWN => own[(value - OWN) as usize],
                Operand::Value(value) => self.depth[value as usize],
                _ => 0,
            };
            let depth = 1 + instruction.operands().map(depth).max().unwrap_or(0);
            own.push(depth);
        }
        own.last().copied().unwrap_or(0)
    }
}

/// The terms with their constants in one, in the place of the first.
pub(super) fn constants_added(mut terms: Vec<Term>) -> Vec<Term> {
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
