//! Operation counts of programs.

use super::program::{Instruction, Operand, Program};
use crate::symbolic::{Counts, Unary};

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
