//! Arrays that are needed one after the other are one: what is small stays in the nearest cache, and has less to be set to zero.

use super::rolled::{Rolled, Term};
use crate::schedule::{Operand, Program};

/// From when to when an array is needed: straight instructions before loop k are at 2 k, the loop itself is at 2 k + 1, results come last.
#[derive(Clone, Copy)]
struct Span {
    first: usize,
    last: usize,
}

/// Gives arrays whose spans do not meet one number.
pub fn reuse(rolled: &mut Rolled, program: &Program) {
    let spans = spans(rolled, program);
    let mut order: Vec<usize> = (0..spans.len()).collect();
    order.sort_by_key(|array| spans[*array].map(|span| span.first));
    // Of each array that is made: when it was last needed, and its length.
    let mut made: Vec<(usize, usize)> = Vec::new();
    let mut number = vec![0; spans.len()];
    for array in order {
        let Some(span) = spans[array] else { continue };
        let length = rolled.arrays[array];
        let free = (0..made.len()).filter(|known| made[*known].0 < span.first);
        number[array] = match free.min_by_key(|known| made[*known].1.abs_diff(length)) {
            Some(known) => {
                made[known] = (span.last, made[known].1.max(length));
                known
            }
            None => {
                made.push((span.last, length));
                made.len() - 1
            }
        };
    }
    rolled.arrays = made.into_iter().map(|(_, length)| length).collect();
    for known in &mut rolled.loops {
        known.before.iter_mut().for_each(|(array, ..)| *array = number[*array]);
        known.kept.iter_mut().flatten().for_each(|(array, _)| *array = number[*array]);
    }
    let in_loops = rolled.loops.iter_mut().flat_map(|known| known.terms.iter_mut().flatten());
    let copied = rolled.copies.iter_mut().flat_map(|copies| copies.results.iter_mut().map(|(_, term)| term));
    for term in in_loops.chain(copied) {
        if let Term::Kept { array, .. } = term {
            *array = number[*array];
        }
    }
}

/// When each array is needed; `None` of those that nothing takes.
fn spans(rolled: &Rolled, program: &Program) -> Vec<Option<Span>> {
    let mut spans: Vec<Option<Span>> = vec![None; rolled.arrays.len()];
    let mut needed = |array: usize, at: usize| {
        let span = spans[array].get_or_insert(Span { first: at, last: at });
        (span.first, span.last) = (span.first.min(at), span.last.max(at));
    };
    let of = |operand: Operand| match operand {
        Operand::Value(value) => rolled.place(value).map(|(array, _)| array),
        _ => None,
    };
    let of_term = |term: &Term| match term {
        Term::Kept { array, .. } => Some(*array),
        Term::Same(operand) => of(*operand),
        _ => None,
    };
    let straight = |from: usize, to: usize| {
        program.instructions[from..to].iter().flat_map(|instruction| instruction.operands()).filter_map(of)
    };
    let mut from = 0;
    for (at, known) in rolled.loops.iter().enumerate() {
        straight(from, known.of.start).for_each(|array| needed(array, 2 * at));
        let given = known.before.iter().map(|(_, _, operand)| *operand);
        let given = given.chain(known.carried.iter().flat_map(|carried| carried.early.iter().copied()));
        given.filter_map(of).for_each(|array| needed(array, 2 * at));
        known.before.iter().for_each(|(array, ..)| needed(*array, 2 * at));
        known.terms.iter().flatten().filter_map(of_term).for_each(|array| needed(array, 2 * at + 1));
        known.kept.iter().flatten().for_each(|(array, _)| needed(*array, 2 * at + 1));
        from = known.of.end();
    }
    let end = 2 * rolled.loops.len();
    straight(from, program.instructions.len()).for_each(|array| needed(array, end));
    let copied = rolled.copies.iter().flat_map(|copies| copies.results.iter().map(|(_, term)| term));
    copied.filter_map(of_term).for_each(|array| needed(array, end + 1));
    let left = rolled.unwritten(program).into_iter().map(|result| program.outputs[result]);
    left.filter_map(of).for_each(|array| needed(array, end + 1));
    spans
}
