//! Long programs in the order in which a wide processor would want them.
//!
//! Selection goes depth first, which keeps values in registers but puts independent chains, such as the elimination of
//! a ladder from both ends, one behind the other, farther apart than any processor looks ahead. List scheduling
//! by the longest path to an output (Muchnick, Advanced Compiler Design and Implementation, section 17.1) interleaves
//! them. Short programs fit into the look-ahead as they are.

use super::program::{Instruction, Operand};
use super::select::Selected;
use std::cmp::Reverse;
use std::collections::{BinaryHeap, VecDeque};

/// Programs shorter than this stay as they are.
const LONG: usize = 250;
/// Instructions started at once.
const WIDTH: usize = 2;

/// Cycles from operands to result, in round numbers.
const FAST: usize = 4;
const SLOW: usize = 13;

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

fn latency(instruction: &Instruction) -> usize {
    if is_slow(instruction) { SLOW } else { FAST }
}

/// The program with its instructions in the order of execution, those before `start` before all others.
pub fn interleave(selected: Selected, start: usize) -> Selected {
    let instructions = &selected.program.instructions;
    if instructions.len() < LONG || selected.program.rolled.is_some() {
        return selected;
    }
    let mut order = order(&instructions[..start], 0);
    order.extend(self::order(&instructions[start..], start));
    selected.in_order(&order)
}

/// Instructions of a program from `start` on, in the order of execution.
fn order(instructions: &[Instruction], start: usize) -> Vec<usize> {
    let count = instructions.len();
    let operands = |index: usize| {
        instructions[index].operands().filter_map(|operand| match operand {
            Operand::Value(value) => (value as usize).checked_sub(start),
            _ => None,
        })
    };
    let mut height = vec![0usize; count];
    let mut waiting = vec![0usize; count];
    let mut users: Vec<Vec<usize>> = vec![Vec::new(); count];
    for index in (0..count).rev() {
        let below = height[index] + latency(&instructions[index]);
        for operand in operands(index) {
            height[operand] = height[operand].max(below);
            users[operand].push(index);
            waiting[index] += 1;
        }
    }
    let mut ready: BinaryHeap<(usize, Reverse<usize>)> = (0..count)
        .filter(|index| waiting[*index] == 0)
        .map(|index| (height[index], Reverse(index)))
        .collect();
    // Results to come, by the cycle in which they are there; of one latency, in that order.
    let (mut fast, mut slow) = (VecDeque::new(), VecDeque::new());
    let mut order = Vec::with_capacity(count);
    let mut cycle = 0;
    while order.len() < count {
        for under_way in [&mut fast, &mut slow] {
            while let Some((done, index)) = under_way.front().copied()
                && done <= cycle
            {
                under_way.pop_front();
                ready.push((height[index], Reverse(index)));
            }
        }
        for _ in 0..WIDTH {
            let Some((_, Reverse(index))) = ready.pop() else { break };
            order.push(start + index);
            let done = cycle + latency(&instructions[index]);
            let under_way = if is_slow(&instructions[index]) { &mut slow } else { &mut fast };
            for user in &users[index] {
                waiting[*user] -= 1;
                if waiting[*user] == 0 {
                    under_way.push_back((done, *user));
                }
            }
        }
        cycle += 1;
    }
    order
}
