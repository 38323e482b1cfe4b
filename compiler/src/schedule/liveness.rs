//! How long the results of a program live: what orders and cuts long programs, and what budgets of live values count.
//!
//! A result lives from the instruction that computes it to the last one that uses it; an output lives to the end. An
//! argument of a function, such as q and v, lives with its caller and does not count.

use super::program::{Operand, Program};

/// Where each value is used last; the outputs are used at the end.
pub fn last_uses(program: &Program) -> Vec<usize> {
    let count = program.instructions.len();
    let mut last_use = vec![0; count];
    for (index, instruction) in program.instructions.iter().enumerate() {
        for operand in instruction.operands() {
            if let Operand::Value(value) = operand {
                last_use[value as usize] = index;
            }
        }
    }
    for output in &program.outputs {
        if let Operand::Value(value) = output {
            last_use[*value as usize] = count;
        }
    }
    last_use
}

/// How many values live on across each place between two instructions.
pub fn live(last_use: &[usize]) -> Vec<usize> {
    let mut begun = vec![0usize; last_use.len() + 2];
    let mut ended = begun.clone();
    for (value, last) in last_use.iter().enumerate() {
        begun[value + 1] += 1;
        // A result that nothing uses ends where it begins.
        ended[(*last).max(value) + 1] += 1;
    }
    let mut running = 0;
    let steps = begun.iter().zip(&ended).take(last_use.len() + 1);
    steps
        .map(|(begun, ended)| {
            running = running + begun - ended;
            running
        })
        .collect()
}

/// The largest number of results that are alive at once, in the emitted order.
pub fn live_values(program: &Program) -> usize {
    live(&last_uses(program)).into_iter().max().unwrap_or(0)
}

/// Of each of the first values of a program whether it is needed after them.
pub fn needed_after(program: &Program, front: usize) -> Vec<bool> {
    let mut needed = vec![false; front];
    let later = program.instructions[front..].iter().flat_map(|instruction| instruction.operands());
    for operand in later.chain(program.outputs.iter().copied()) {
        if let Operand::Value(value) = operand
            && (value as usize) < front
        {
            needed[value as usize] = true;
        }
    }
    needed
}
