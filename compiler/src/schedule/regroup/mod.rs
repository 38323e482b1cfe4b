//! Sums in another order, so that each product in them is absorbed, and what is computed latest is added last.
//!
//! ```text
//! (a·b + c·d) + x:    a product, a fused multiply-add, a sum
//! (x + a·b) + c·d:    two fused multiply-adds
//! ```
//! A sum of n terms takes n − 1 operations where it begins with a term that is no product, and n where there is none. What is
//! added last waits for nothing but itself. The equations say nothing of either: their sums are in the order in which they were set
//! up, and sums of sums as they came. A factor that two terms have in common is taken out where that spares a product (`factors.rs`).

mod factors;
mod terms;
mod written;

use super::program::{Instruction, Operand, Program};
use super::select::Selected;
use crate::symbolic::{Known, mix};
use terms::Sums;
use written::{OWN, Sum};

/// Puts the sums of a program in order. `rows`: instructions that repeat one another; sums in a row are in one order, that of the one in its middle.
pub fn regroup(selected: &mut Selected, rows: &[&[u32]]) {
    let mut sums = Sums::new(selected, rows.is_empty());
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

/// Whether nothing needs an instruction once these sums stand in place of their last.
fn unneeded(program: &Program, instead: &[Option<Sum>]) -> Vec<bool> {
    let mut gone = vec![true; program.instructions.len()];
    let need = |gone: &mut Vec<bool>, operand: Operand| match operand {
        Operand::Value(value) if value < OWN => gone[value as usize] = false,
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

/// The program without what is gone, and with these sums in place of their last instructions; what two of them compute alike is
/// computed once.
fn replace(selected: &mut Selected, gone: &[bool], instead: &[Option<Sum>]) {
    let Selected { program, nodes } = selected;
    let mut position = vec![0_u32; gone.len()];
    let mut made = Made::default();
    let mut of = Vec::with_capacity(gone.len());
    for (index, instruction) in program.instructions.iter().enumerate().filter(|(index, _)| !gone[*index]) {
        let own = instead[index].as_deref();
        let (mut before, mut own_positions) = (0, Vec::new());
        for instruction in own.unwrap_or(std::slice::from_ref(instruction)) {
            let moved = |operand: Operand| match operand {
                Operand::Value(value) if value >= OWN => {
                    Operand::Value(own_positions[(value - OWN) as usize])
                }
                Operand::Value(value) => Operand::Value(position[value as usize]),
                other => other,
            };
            before = made.once(instruction.map(moved));
            own_positions.push(before);
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
mod tests;
