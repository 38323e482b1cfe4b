//! Instructions in the order in which a wide processor would want them.
//!
//! Selection goes depth first, which puts independent chains, such as the elimination of
//! a ladder from both ends, one behind the other, farther apart than any processor looks ahead. List scheduling
//! by the longest path to an output (Muchnick, Advanced Compiler Design and Implementation, section 17.1) interleaves
//! them.

use super::stretch::Stretch;
use std::cmp::Reverse;
use std::collections::{BinaryHeap, VecDeque};

/// Instructions started at once.
const WIDTH: usize = 2;

/// The instructions of a stretch in the order of execution.
pub fn order(stretch: &Stretch) -> Vec<usize> {
    let Stretch { start, end, users, height, .. } = stretch;
    let mut waiting = stretch.waiting();
    let mut ready: BinaryHeap<(usize, Reverse<usize>)> = (*start..*end)
        .filter(|index| waiting[index - start] == 0)
        .map(|index| (height[index - start], Reverse(index)))
        .collect();
    // Results to come, by the cycle in which they are there; of one latency, in that order.
    let (mut fast, mut slow) = (VecDeque::new(), VecDeque::new());
    let mut order = Vec::with_capacity(end - start);
    let mut cycle = 0;
    while order.len() < end - start {
        for under_way in [&mut fast, &mut slow] {
            while let Some((done, index)) = under_way.front().copied()
                && done <= cycle
            {
                under_way.pop_front();
                ready.push((height[index - start], Reverse(index)));
            }
        }
        for _ in 0..WIDTH {
            let Some((_, Reverse(index))) = ready.pop() else { break };
            order.push(index);
            let done = cycle + stretch.latency(index);
            let under_way = if stretch.is_slow(index) { &mut slow } else { &mut fast };
            for user in &users[index] {
                waiting[user - start] -= 1;
                if waiting[user - start] == 0 {
                    under_way.push_back((done, *user));
                }
            }
        }
        cycle += 1;
    }
    order
}
