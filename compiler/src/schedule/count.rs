//! Operation counts of programs.

use super::program::{Instruction, Operand, Program};
use crate::symbolic::Unary;

/// Operations by kind; a fused multiply-add is one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Additions, subtractions and negations.
    pub additions: usize,
    pub multiplications: usize,
    pub fused_multiply_adds: usize,
    /// Divisions and reciprocals.
    pub divisions: usize,
    pub square_roots: usize,
    /// min, max, abs, sign, comparisons, logic and selections.
    pub choices: usize,
    /// sin, cos, exp and the like, of the user's laws.
    pub transcendentals: usize,
    /// Longest chain of dependent operations.
    pub depth: usize,
}

impl Counts {
    /// All operations, each counted once.
    pub fn total(&self) -> usize {
        self.additions
            + self.multiplications
            + self.fused_multiply_adds
            + self.divisions
            + self.square_roots
            + self.choices
            + self.transcendentals
    }

    /// The score that choices between formulations minimise: work, and a share for the depth that keeps a wide processor waiting.
    pub fn score(&self) -> usize {
        4 * self.total() + self.depth
    }
}

pub fn count(program: &Program) -> Counts {
    let mut counts = Counts::default();
    let mut depth: Vec<usize> = Vec::with_capacity(program.instructions.len());
    for instruction in &program.instructions {
        let kind = match instruction {
            Instruction::Neg(_) | Instruction::Add(..) | Instruction::Sub(..) => &mut counts.additions,
            Instruction::Mul(..) => &mut counts.multiplications,
            Instruction::MulAdd(..) => &mut counts.fused_multiply_adds,
            Instruction::Div(..) | Instruction::Unary(Unary::Reciprocal, _) => &mut counts.divisions,
            Instruction::Unary(Unary::Sqrt, _) => &mut counts.square_roots,
            Instruction::Unary(Unary::Abs | Unary::Sign, _)
            | Instruction::Min(..)
            | Instruction::Max(..)
            | Instruction::Compare(..)
            | Instruction::And(..)
            | Instruction::Or(..)
            | Instruction::Not(_)
            | Instruction::Select(..) => &mut counts.choices,
            Instruction::Unary(..) | Instruction::Atan2(..) => &mut counts.transcendentals,
        };
        *kind += 1;
        let longest = instruction.operands().filter_map(|operand| value(operand, &depth)).max().unwrap_or(0);
        depth.push(longest + 1);
    }
    counts.depth = program.outputs.iter().filter_map(|output| value(*output, &depth)).max().unwrap_or(0);
    counts
}

fn value(operand: Operand, depth: &[usize]) -> Option<usize> {
    match operand {
        Operand::Value(index) => Some(depth[index as usize]),
        _ => None,
    }
}
