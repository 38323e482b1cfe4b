//! Instructions in an order in which few values are alive at once.
//!
//! Next comes what adds fewest values to those that are alive, of these what most has to wait for, and of equals what depth first comes
//! first: list scheduling for registers (Goodman, Hsu, *Code scheduling and register allocation in large basic blocks*, ICS
//! 1988, 442–452, their CSR).

use super::stretch::Stretch;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Cycles of three operations. Paths in one stage of so many are of one length.
const STAGE: usize = 12;

/// An instruction ends at most three values.
const ENDED: usize = 3;

/// The instructions of a stretch in the order of execution.
pub fn order(stretch: &Stretch) -> Vec<usize> {
    let Stretch { start, end, users, height, .. } = stretch;
    let mut left = stretch.uses();
    let mut waiting = stretch.waiting();
    let mut done = vec![false; end - start];
    // By the number of values that it adds, ENDED more. That only falls, so that of several entries of an instruction
    // the first one comes first.
    let mut ready: [BinaryHeap<(usize, Reverse<usize>)>; ENDED + 2] = Default::default();
    let added = |left: &[usize], index: usize| {
        let ended = stretch.taken(index).iter().filter(|value| left[**value] == 1).count();
        ENDED + usize::from(left[index] > 0) - ended
    };
    let entry = |index: usize| (height[index - start] / STAGE, Reverse(index));
    for index in (*start..*end).filter(|index| waiting[index - start] == 0) {
        ready[added(&left, index)].push(entry(index));
    }
    let mut order = Vec::with_capacity(end - start);
    while let Some(least) = ready.iter_mut().find(|entries| !entries.is_empty()) {
        let Some((_, Reverse(index))) = least.pop() else { break };
        if std::mem::replace(&mut done[index - start], true) {
            continue;
        }
        order.push(index);
        for value in stretch.taken(index) {
            left[*value] -= 1;
            if left[*value] == 1 {
                // The last to take it now ends it.
                let last = users[*value].iter().find(|user| !done[**user - start]);
                if let Some(last) = last.filter(|last| waiting[**last - start] == 0) {
                    ready[added(&left, *last)].push(entry(*last));
                }
            }
        }
        for user in &users[index] {
            waiting[user - start] -= 1;
            if waiting[user - start] == 0 {
                ready[added(&left, *user)].push(entry(*user));
            }
        }
    }
    order
}
