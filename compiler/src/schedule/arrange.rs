//! The order of the instructions of long programs.
//!
//! Two are tried: that of the longest paths (`interleave.rs`), which a wide processor would want, and that in which few values are
//! alive (`fewest_alive.rs`). Where more values are alive than fit into registers, compilers order the instructions once more, and do
//! worse the more there are. So the second is taken where it saves much, and where a program is cut, since what is alive at a
//! cut goes through memory. Short programs fit into a processor's look-ahead as they are.

use super::liveness::needed_after;
use super::select::Selected;
use super::share;
use super::stretch::Stretch;
use super::{fewest_alive, interleave};

/// Programs shorter than this stay as they are.
const LONG: usize = 250;

/// The order of few values is taken if it keeps at most so many hundredths of them alive: Bricard's linkage, in 304 operations, at 81 took 0.93 of the time, the Panda
/// arm at 84 takes 1.06 times as long.
const FEW: usize = 82;

/// The program with its instructions in the order of execution, those of the front, if it has one, before all others.
/// `front`: of each value there whether a program that begins with it needs it further on.
pub fn arrange(selected: Selected, front: &[bool]) -> Selected {
    let instructions = &selected.program.instructions;
    if instructions.len() < LONG || selected.program.rolled.is_some() {
        return selected;
    }
    let order = if instructions.len() > share::LONG { fewest_alive::order } else { order };
    let at_end = needed_after(&selected.program, instructions.len());
    let mut arranged = order(&Stretch::new(instructions, 0, front.to_vec()));
    arranged.extend(order(&Stretch::new(instructions, front.len(), at_end)));
    selected.in_order(&arranged)
}

fn order(stretch: &Stretch) -> Vec<usize> {
    let [quick, few] = [interleave::order(stretch), fewest_alive::order(stretch)];
    if 100 * stretch.most_alive(&few) <= FEW * stretch.most_alive(&quick) { few } else { quick }
}

#[cfg(test)]
mod tests;
