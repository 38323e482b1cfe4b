//! Where long programs are cut into several functions: compilers are superlinear in the size of a function.

use super::liveness::{last_uses, live};
use super::program::{Operand, Program};
use super::share::LONG;
use std::collections::BTreeSet;

/// About how many instructions of a program that is cut go into one function.
const STRETCH: usize = 500;

/// A stretch of a program: instructions and the values that it takes from the array and gives to it, with their slots.
#[derive(Clone, Debug)]
pub struct Part {
    pub start: usize,
    pub end: usize,
    pub taken: Vec<(usize, usize)>,
    pub given: Vec<(usize, usize)>,
}

/// A long program, cut where few values are live. Values that live on travel in an array.
#[derive(Clone, Debug)]
pub struct Cut {
    pub parts: Vec<Part>,
    /// Entries of the array.
    pub size: usize,
    /// Where the values are after the last part but one.
    pub slots: Vec<Option<usize>>,
}

impl Cut {
    pub fn of(program: &Program) -> Cut {
        let count = program.instructions.len();
        if count <= LONG || program.rolled.is_some() {
            let part = Part { start: 0, end: count, taken: Vec::new(), given: Vec::new() };
            return Cut { parts: vec![part], size: 0, slots: Vec::new() };
        }
        allot(program, 0, &last_uses(program))
    }

    /// Two programs whose first instructions are the same, `length` of them: in these both are cut alike.
    pub fn of_pair(programs: [&Program; 2], length: usize) -> [Cut; 2] {
        let [mut one, mut other] = programs.map(last_uses);
        for value in 0..length {
            // What either program needs later leaves the front of both.
            if one[value].max(other[value]) >= length {
                one[value] = one[value].max(length);
                other[value] = other[value].max(length);
            }
        }
        let mut cuts = [allot(programs[0], length, &one), allot(programs[1], length, &other)];
        let size = cuts[0].size.max(cuts[1].size);
        cuts.iter_mut().for_each(|cut| cut.size = size);
        cuts
    }
}

/// Where to cut: near the middles between what is equally long, and after the front.
fn places(count: usize, front: usize, last_use: &[usize]) -> Vec<usize> {
    let live = live(last_use);
    let mut cuts = vec![0];
    for (start, end) in [(0, front), (front, count)] {
        let parts = (end - start).div_ceil(STRETCH);
        for part in 1..parts {
            let (middle, reach) = (start + part * (end - start) / parts, (end - start) / parts / 3);
            let best = (middle - reach..=middle + reach).min_by_key(|cut| (live[*cut], *cut));
            cuts.extend(best);
        }
        if end > start {
            cuts.push(end);
        }
    }
    cuts
}

/// Parts, and where their values are. A value that leaves its part gets a slot, and keeps it until its last use.
fn allot(program: &Program, front: usize, last_use: &[usize]) -> Cut {
    let count = program.instructions.len();
    let cuts = places(count, front, last_use);
    let mut slots: Vec<Option<usize>> = vec![None; count];
    let mut free: BTreeSet<usize> = BTreeSet::new();
    let mut size = 0;
    let mut parts = Vec::new();
    let mut kept: Vec<usize> = Vec::new();
    for window in cuts.windows(2) {
        let (start, end) = (window[0], window[1]);
        let operands = program.instructions[start..end].iter().flat_map(|instruction| instruction.operands());
        let mut used: Vec<usize> = operands
            .filter_map(|operand| match operand {
                Operand::Value(value) if (value as usize) < start => Some(value as usize),
                _ => None,
            })
            .collect();
        used.sort_unstable();
        used.dedup();
        let taken = used.iter().filter_map(|value| Some((*value, slots[*value]?))).collect();
        let mut given = Vec::new();
        if end < count {
            let (living, dead) = kept.into_iter().partition(|value| last_use[*value] >= end);
            kept = living;
            let dead: Vec<usize> = dead;
            free.extend(dead.into_iter().filter_map(|value| slots[value]));
            for value in (start..end).filter(|value| last_use[*value] >= end) {
                let slot = free.pop_first().unwrap_or_else(|| {
                    size += 1;
                    size - 1
                });
                slots[value] = Some(slot);
                kept.push(value);
                given.push((value, slot));
            }
        }
        parts.push(Part { start, end, taken, given });
    }
    Cut { parts, size, slots }
}
