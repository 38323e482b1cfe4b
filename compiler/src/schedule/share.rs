//! Instructions that two programs have in common are put in front of both.
//!
//! The accelerations with and without Baumgarte's terms differ in one right-hand side: the equations are set up and
//! factored alike. With that part in front, instruction for instruction, its text and its machine code are
//! needed once.

use super::liveness::needed_after;
use super::program::{Instruction, Operand, Program};
use super::select::Selected;
use crate::symbolic::Node;
use std::collections::BTreeMap;

/// Programs of more instructions are cut into several functions, and begin with what they share: compilers are superlinear
/// in the size of a function. Shorter ones stay in one piece, which is faster than two.
pub const LONG: usize = 2000;

/// Puts what they have in common in front of both programs; says of each instruction there whether either program needs its result
/// further on.
pub fn share(one: &mut Selected, other: &mut Selected) -> Vec<bool> {
    let stays = |program: &Program| program.instructions.len() <= LONG || program.rolled.is_some();
    if stays(&one.program) || stays(&other.program) {
        return Vec::new();
    }
    // For each instruction of `other` the same of `one`: same operation, operands in common.
    let mut of_node: BTreeMap<Node, Vec<u32>> = BTreeMap::new();
    for (index, node) in one.nodes.iter().enumerate() {
        of_node.entry(*node).or_default().push(index as u32);
    }
    let mut same: Vec<Option<u32>> = Vec::with_capacity(other.nodes.len());
    for (instruction, node) in other.program.instructions.iter().zip(&other.nodes) {
        let known = in_common(instruction, &same).and_then(|moved| {
            let mut candidates = of_node.get(node)?.iter().copied();
            candidates.find(|known| one.program.instructions[*known as usize] == moved)
        });
        same.push(known);
    }
    let shared: Vec<(usize, usize)> =
        same.iter().enumerate().filter_map(|(b, a)| Some(((*a)? as usize, b))).collect();
    let in_front = |count: usize, front: Vec<usize>| -> Vec<usize> {
        let mut rest = vec![true; count];
        front.iter().for_each(|index| rest[*index] = false);
        let rest = (0..count).filter(|index| rest[*index]);
        front.into_iter().chain(rest).collect()
    };
    let first = in_front(one.nodes.len(), shared.iter().map(|(a, _)| *a).collect());
    let second = in_front(other.nodes.len(), shared.iter().map(|(_, b)| *b).collect());
    *one = std::mem::take(one).in_order(&first);
    *other = std::mem::take(other).in_order(&second);
    let needed = [one, other].map(|selected| needed_after(&selected.program, shared.len()));
    needed[0].iter().zip(&needed[1]).map(|(one, other)| *one || *other).collect()
}

/// The instruction on the operands of the other program; `None` if it has not got them.
fn in_common(instruction: &Instruction, same: &[Option<u32>]) -> Option<Instruction> {
    let known = |operand: Operand| match operand {
        Operand::Value(value) => same[value as usize].is_some(),
        _ => true,
    };
    instruction.operands().all(known).then(|| {
        instruction.map(|operand| match operand {
            Operand::Value(value) => Operand::Value(same[value as usize].unwrap_or(value)),
            other => other,
        })
    })
}
