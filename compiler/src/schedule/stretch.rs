//! Instructions of a program from one on: what an order of them needs to know.

use super::program::{Instruction, Operand};

/// Cycles from operands to result, in round numbers.
const FAST: usize = 4;
const SLOW: usize = 13;

/// Instructions of a program from `start` on. Values have the indices that they have in the program.
pub struct Stretch {
    pub start: usize,
    pub end: usize,
    /// Of each instruction of the stretch: whether its result is late.
    slow: Vec<bool>,
    /// Of each instruction of the stretch: the values that it takes, each once, those from before the stretch among them.
    taken: Vec<Vec<usize>>,
    /// Of each value up to the end: the instructions of the stretch that take it.
    pub users: Vec<Vec<usize>>,
    /// Of each value up to the end whether it is needed after the stretch.
    kept: Vec<bool>,
    /// Of each instruction of the stretch: cycles from its result to the last that waits for it.
    pub height: Vec<usize>,
}

impl Stretch {
    /// `kept`: of each value up to the end whether it is needed after the stretch.
    pub fn new(instructions: &[Instruction], start: usize, kept: Vec<bool>) -> Stretch {
        let end = kept.len();
        let slow: Vec<bool> = instructions[start..end].iter().map(is_slow).collect();
        let mut taken = Vec::with_capacity(end - start);
        let mut users: Vec<Vec<usize>> = vec![Vec::new(); end];
        for (index, instruction) in (start..).zip(&instructions[start..end]) {
            let mut own: Vec<usize> = values(instruction).collect();
            own.sort_unstable();
            own.dedup();
            own.iter().for_each(|value| users[*value].push(index));
            taken.push(own);
        }
        let mut height = vec![0; end - start];
        for index in (start..end).rev() {
            let below = |user: &usize| height[user - start] + latency(slow[user - start]);
            height[index - start] = users[index].iter().map(below).max().unwrap_or(0);
        }
        Stretch { start, end, slow, taken, users, kept, height }
    }

    /// The values that an instruction takes, each once.
    pub fn taken(&self, index: usize) -> &[usize] {
        &self.taken[index - self.start]
    }

    pub fn is_slow(&self, index: usize) -> bool {
        self.slow[index - self.start]
    }

    /// Cycles from its operands to its result.
    pub fn latency(&self, index: usize) -> usize {
        latency(self.is_slow(index))
    }

    /// Of each instruction how many others of the stretch it waits for.
    pub fn waiting(&self) -> Vec<usize> {
        let own = |taken: &Vec<usize>| taken.iter().filter(|value| **value >= self.start).count();
        self.taken.iter().map(own).collect()
    }

    /// Of each value up to the end how often it is still needed: by instructions, and after the stretch.
    pub fn uses(&self) -> Vec<usize> {
        self.users.iter().zip(&self.kept).map(|(users, kept)| users.len() + usize::from(*kept)).collect()
    }

    /// The largest number of values that are alive at once in this order of its instructions.
    pub fn most_alive(&self, order: &[usize]) -> usize {
        let mut left = self.uses();
        let mut alive = left[..self.start].iter().filter(|uses| **uses > 0).count();
        let mut most = alive;
        for index in order {
            for value in self.taken(*index) {
                left[*value] -= 1;
                alive -= usize::from(left[*value] == 0);
            }
            alive += usize::from(left[*index] > 0);
            most = most.max(alive);
        }
        most
    }
}

/// The values that an instruction takes.
fn values(instruction: &Instruction) -> impl Iterator<Item = usize> {
    instruction.operands().filter_map(|operand| match operand {
        Operand::Value(value) => Some(value as usize),
        _ => None,
    })
}

fn latency(slow: bool) -> usize {
    if slow { SLOW } else { FAST }
}

fn is_slow(instruction: &Instruction) -> bool {
    matches!(
        instruction,
        Instruction::Div(..)
            | Instruction::Unary(..)
            | Instruction::Atan2(..)
            | Instruction::Cell(..)
            | Instruction::Piece(..)
            | Instruction::Patch(..)
    )
}
