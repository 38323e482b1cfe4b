//! Repetition recognised: instructions of one form under a shift of a number become loops.
//!
//! A chain of alike parts has alike equations. What belongs to `link[3]` is computed from `q[6]` and `v[3]` as what belongs to `link[4]`
//! is from `q[8]` and `v[4]`, and its elimination from what came of `link[2]` as that of `link[4]` from what came of
//! `link[3]`. `places` finds from names which numbers the arguments have; `strands` finds instructions that repeat along
//! them; `order` puts strands side by side, as rounds of loops, and keeps straight what repeats nothing. What comes of it
//! is the same instructions in another order, with stretches of it marked as loops, so that all that reads programs need not know;
//! `rolled` says what stands in such a loop, for those who write it, and proves it entry by entry.

mod order;
mod places;
mod results;
mod reuse;
mod rolled;
mod strands;

pub use places::Places;
pub use results::{Copies, List, Result};
pub use rolled::{Carried, Rolled, RolledLoop, Term};
pub use strands::Strands;

use super::Program;
use super::select::Selected;

/// Programs of fewer instructions stay as they are: loops of few rounds are slower than what they stand for.
const LONG: usize = 2000;
/// What repeats less often is no loop.
const FEWEST_ROUNDS: usize = 8;

/// Rounds of alike instructions: instruction k of round r is `start + r length + k` of the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Loop {
    pub start: usize,
    /// Instructions of one round.
    pub length: usize,
    pub rounds: usize,
    /// Whether no round takes anything from another, so that they can be computed at once.
    pub independent: bool,
}

impl Loop {
    pub fn end(&self) -> usize {
        self.start + self.length * self.rounds
    }
}

fn is_long(program: &Program) -> bool {
    program.instructions.len() + program.outputs.len() >= LONG
}

/// What repeats in a program, if it is long.
pub fn strands(program: &Program, places: &Places) -> Option<Strands> {
    is_long(program).then(|| strands::find(program, places))
}

/// Puts the repetitions of a program together and marks them as loops, where that makes its text half as long.
pub fn roll(selected: &mut Selected, strands: Strands, lists: &[List]) {
    if !is_long(&selected.program) {
        return;
    }
    selected.program.alike = strands.covered();
    let Some((order, loops)) = order::order(&selected.program, strands) else { return };
    let program = selected.program.in_order(&order);
    if let Some(rolled) = Rolled::of(&program, &loops, lists)
        && 2 * rolled.statements(&program) <= program.instructions.len() + program.outputs.len()
    {
        *selected = std::mem::take(selected).in_order(&order);
        selected.program.rolled = Some(rolled);
        selected.program.alike = 0;
    }
}
