//! Operation counts of programs.

use super::program::{Instruction, Operand, Program};
use crate::symbolic::{BICUBIC, Counts, Unary};

pub fn count(program: &Program) -> Counts {
    let mut counts = Counts::default();
    let mut depth: Vec<usize> = Vec::with_capacity(program.instructions.len());
    for instruction in &program.instructions {
        let mut weight = 1;
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
            Instruction::Cell(table, _) => {
                weight = steps(program, *table) + 2;
                &mut counts.choices
            }
            Instruction::Piece(_, orders, ..) | Instruction::Patch(_, orders, ..) => {
                // s = x − base, t = y − base.
                counts.additions += 1;
                let of_cubic = |order: u8| 3 - usize::from(order.min(2));
                weight = of_cubic(orders.first().max(orders.second()));
                if let Instruction::Patch(table, ..) = instruction {
                    counts.additions += 1;
                    if width(program, *table) == BICUBIC {
                        let along = 4 - usize::from(orders.first().min(3));
                        weight = along * of_cubic(orders.second()) + of_cubic(orders.first());
                    }
                }
                &mut counts.fused_multiply_adds
            }
        };
        *kind += weight;
        let longest = instruction.operands().filter_map(|operand| value(operand, &depth)).max().unwrap_or(0);
        let own = if let Instruction::Cell(table, _) = instruction { steps(program, *table) } else { 1 };
        depth.push(longest + own);
    }
    counts.depth = program.outputs.iter().filter_map(|output| value(*output, &depth)).max().unwrap_or(0);
    counts
}

/// Comparisons, one after the other, that find a row.
fn steps(program: &Program, table: u16) -> usize {
    program.tables.get(usize::from(table)).map_or(1, |table| table.steps())
}

/// Numbers of a row.
fn width(program: &Program, table: u16) -> usize {
    program.tables.get(usize::from(table)).map_or(0, |table| table.width())
}

fn value(operand: Operand, depth: &[usize]) -> Option<usize> {
    match operand {
        Operand::Value(index) => Some(depth[index as usize]),
        _ => None,
    }
}
