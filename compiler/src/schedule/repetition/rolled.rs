//! What stands in the loops of a program: of each instruction of a round, what it takes in all rounds at once.
//!
//! ```text
//! for i in 0..38 {
//!     let b0 = q[2 * i + 3] * q[2 * i + 80];     two entries
//!     let b1 = k[0].mul_add(s0[i], b0);          what the round before left, and this one's b0
//!     s0[i + 1] = b1;                            kept for the next
//! }
//! ```
//! Values that leave their round are kept in arrays, one for each instruction of a round, longer than the rounds where a chain
//! takes from beyond its ends. Every operand of every round is compared with what the loop says; where one differs, there are no
//! loops, so that they cannot mean anything else.

use super::Loop;
use super::results::{self, Copies, List, Result};
use super::reuse::reuse;
use crate::functions::Argument;
use crate::schedule::{Operand, Program, Source};
use std::collections::{BTreeMap, BTreeSet};

/// What an instruction takes, in round i.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Term {
    /// A number, an entry or a value that is the same in all rounds.
    Same(Operand),
    /// Entry i of a table of numbers.
    Number(usize),
    /// Entry `first + step i` of an argument.
    Entry { argument: Argument, first: usize, step: i64 },
    /// The result of that instruction of the same round.
    Own(usize),
    /// That of an instruction so many rounds before; before the first of them what is said beside the loop.
    Before { index: usize, rounds: usize },
    /// Entry `first + step i` of an array.
    Kept { array: usize, first: usize, step: i64 },
}

/// A loop with its terms.
#[derive(Clone, Debug)]
pub struct RolledLoop {
    pub of: Loop,
    /// For each instruction of a round.
    pub terms: Vec<Vec<Term>>,
    /// Where each is kept, if it is: the array, and the entry of the first round.
    pub kept: Vec<Option<(usize, usize)>>,
    /// What is put into arrays before the loop: array, entry, value.
    pub before: Vec<(usize, usize, Operand)>,
    /// For each instruction of a round, the results that it is.
    pub results: Vec<Vec<Result>>,
    /// The instructions that later rounds take.
    pub carried: Vec<Carried>,
}

/// An instruction that later rounds take.
#[derive(Clone, Debug)]
pub struct Carried {
    pub index: usize,
    /// Which it is of all in the program.
    pub number: usize,
    /// What is taken while there is none: of one round before the first, of two …
    pub early: Vec<Operand>,
}

/// All loops of a program.
#[derive(Clone, Debug)]
pub struct Rolled {
    pub loops: Vec<RolledLoop>,
    /// The lengths of the arrays.
    pub arrays: Vec<usize>,
    /// Numbers that differ from round to round.
    pub tables: Vec<Vec<f64>>,
    /// Results that no loop writes, in rounds, and alone.
    pub copies: Vec<Copies>,
    pub alone: Vec<usize>,
}

/// Values of so many rounds before are carried from round to round, others are kept in arrays.
const FARTHEST: usize = 3;

/// An instruction of a round, by loop and index.
type Slot = (usize, usize);

/// Entries of an array, counted from the first round: from where to where, and what those are that no round writes.
#[derive(Default)]
struct Extent {
    low: i64,
    high: i64,
    beyond: BTreeMap<i64, (Operand, usize)>,
}

/// A term while arrays have no numbers.
enum Draft {
    Done(Term),
    Kept {
        slot: Slot,
        first: i64,
        step: i64,
    },
    /// Of so many rounds before.
    Before {
        index: usize,
        rounds: usize,
    },
    /// Entry i of an array of its own, into which these are put before.
    Gathered(Vec<Operand>),
}

impl Rolled {
    /// The loops of a program; `None` where one is not what it should be.
    pub fn of(program: &Program, loops: &[Loop], lists: &[List]) -> Option<Rolled> {
        let left = vec![true; program.outputs.len()];
        let mut drafting = Drafting {
            program,
            loops,
            extents: BTreeMap::new(),
            tables: Vec::new(),
            results: BTreeMap::new(),
            carried: BTreeMap::new(),
            left,
        };
        let drafts = (0..loops.len()).map(|at| drafting.terms(at)).collect::<Option<Vec<_>>>()?;
        drafting.write_results(lists);
        drafting.keep_what_others_take(&drafts);
        let left = drafting.left.clone();
        let mut rolled = drafting.finish(drafts)?;
        (rolled.copies, rolled.alone) = results::copies(program, lists, &rolled, left);
        reuse(&mut rolled, program);
        Some(rolled)
    }

    /// The results that neither loops nor copies write.
    pub fn unwritten(&self, program: &Program) -> Vec<usize> {
        let mut is_left = vec![true; program.outputs.len()];
        let in_loops = self
            .loops
            .iter()
            .flat_map(|known| known.results.iter().flatten().map(|result| (known.of.rounds, *result)));
        let copied = self
            .copies
            .iter()
            .flat_map(|copies| copies.results.iter().map(|(result, _)| (copies.rounds, *result)));
        for (rounds, result) in in_loops.chain(copied) {
            (0..rounds).for_each(|round| is_left[result.in_round(round)] = false);
        }
        (0..is_left.len()).filter(|result| is_left[*result]).collect()
    }

    /// Which value that later rounds take this is, if it is that of the last round and in no array.
    pub fn carried(&self, value: u32) -> Option<usize> {
        let known = self.loop_of(value)?;
        let offset = value as usize - known.of.start;
        let (round, index) = (offset / known.of.length, offset % known.of.length);
        let alone = round + 1 == known.of.rounds && known.kept[index].is_none();
        let carried = known.carried.iter().filter(|_| alone).find(|carried| carried.index == index);
        carried.map(|carried| carried.number)
    }

    /// The loop that a value is computed in.
    fn loop_of(&self, value: u32) -> Option<&RolledLoop> {
        let known = self.loops.partition_point(|known| known.of.end() <= value as usize);
        self.loops.get(known).filter(|known| known.of.start <= value as usize)
    }

    /// How many instructions are in loops.
    pub fn alike(&self) -> usize {
        self.loops.iter().map(|known| known.of.length * known.of.rounds).sum()
    }

    /// How many statements its text has.
    pub fn statements(&self, program: &Program) -> usize {
        let bodies: usize = self.loops.iter().map(|known| known.of.length).sum();
        let copies: usize = self.copies.iter().map(|copies| copies.results.len()).sum();
        let before: usize = self.loops.iter().map(|known| known.before.len()).sum();
        program.instructions.len() - self.alike() + bodies + before + copies + self.alone.len()
    }

    /// The array and its entry that a value is in; `None` of values outside loops.
    pub fn place(&self, value: u32) -> Option<(usize, usize)> {
        let known = self.loop_of(value)?;
        let offset = value as usize - known.of.start;
        let (array, first) = known.kept[offset % known.of.length]?;
        Some((array, first + offset / known.of.length))
    }
}

/// The row that most of these are in: the slot, the round of the first, and how far on each is.
fn row(positions: &[Option<(Slot, i64)>]) -> Option<(Slot, i64, i64)> {
    let mut found: BTreeMap<(Slot, i64, i64), usize> = BTreeMap::new();
    for (round, pair) in positions.windows(2).enumerate() {
        if let [Some((slot, here)), Some((other, there))] = pair
            && slot == other
        {
            let step = there - here;
            *found.entry((*slot, here - step * round as i64, step)).or_default() += 1;
        }
    }
    found.into_iter().max_by_key(|(_, many)| *many).map(|(row, _)| row)
}

struct Drafting<'a> {
    program: &'a Program,
    loops: &'a [Loop],
    extents: BTreeMap<Slot, Extent>,
    tables: Vec<Vec<f64>>,
    results: BTreeMap<Slot, Vec<Result>>,
    /// What later rounds take while there is none.
    carried: BTreeMap<Slot, Vec<Operand>>,
    /// The results that no loop writes.
    left: Vec<bool>,
}

impl Drafting<'_> {
    /// The slot and the round of a value in a loop.
    fn position(&self, value: u32) -> Option<(Slot, i64)> {
        let value = value as usize;
        let at = self.loops.partition_point(|known| known.end() <= value);
        let known = self.loops.get(at).filter(|known| known.start <= value)?;
        let offset = value - known.start;
        Some(((at, offset % known.length), (offset / known.length) as i64))
    }

    /// The value of a slot in a round, where it has one.
    fn value(&self, (at, index): Slot, round: i64) -> Option<Operand> {
        let known = &self.loops[at];
        let round = usize::try_from(round).ok().filter(|round| *round < known.rounds)?;
        Some(Operand::Value((known.start + round * known.length + index) as u32))
    }

    /// The terms of a loop.
    fn terms(&mut self, at: usize) -> Option<Vec<Vec<Draft>>> {
        let known = self.loops[at];
        let mut terms = Vec::with_capacity(known.length);
        for index in 0..known.length {
            let kind = self.program.instructions[known.start + index];
            let blank = |_: Operand| Operand::Constant(0.0);
            let mut operands: [Vec<Operand>; 3] = Default::default();
            for round in 0..known.rounds {
                let instruction = self.program.instructions[known.start + round * known.length + index];
                if instruction.map(blank) != kind.map(blank) {
                    return None;
                }
                operands.iter_mut().zip(instruction.operands()).for_each(|(all, own)| all.push(own));
            }
            let own = operands.iter().filter(|all| !all.is_empty());
            terms.push(own.map(|all| self.term(at, all)).collect::<Option<Vec<_>>>()?);
        }
        Some(terms)
    }

    /// What these are, an operand of one instruction in all rounds.
    fn term(&mut self, at: usize, operands: &[Operand]) -> Option<Draft> {
        let first = operands[0];
        if operands.iter().all(|operand| *operand == first) {
            return Some(Draft::Done(Term::Same(first)));
        }
        if let Operand::Constant(_) = first {
            let number = |operand: &Operand| match operand {
                Operand::Constant(value) => Some(*value),
                _ => None,
            };
            return Some(Draft::Done(self.table(operands.iter().map(number).collect::<Option<Vec<f64>>>()?)));
        }
        if let (Operand::Source(one), Operand::Source(next)) = (first, operands[1]) {
            let step = i64::from(next.index) - i64::from(one.index);
            let entry = |round: usize| {
                let index = u32::try_from(i64::from(one.index) + step * round as i64).ok()?;
                Some(Operand::Source(Source { argument: one.argument, index }))
            };
            let holds = operands.iter().enumerate().all(|(round, operand)| entry(round) == Some(*operand));
            let term = Term::Entry { argument: one.argument, first: one.index as usize, step };
            return holds.then_some(Draft::Done(term));
        }
        // Both ends may be from elsewhere, most are of one row.
        let position = |operand: &Operand| match operand {
            Operand::Value(value) => self.position(*value),
            _ => None,
        };
        let positions: Vec<Option<(Slot, i64)>> = operands.iter().map(position).collect();
        let row = row(&positions).and_then(|row| self.in_row(at, operands, row));
        let all_before = || operands.iter().all(|operand| self.is_before(at, *operand));
        row.or_else(|| all_before().then(|| Draft::Gathered(operands.to_vec())))
    }

    /// Whether it is a number that is there before a loop begins.
    fn is_before(&self, at: usize, operand: Operand) -> bool {
        match operand {
            Operand::Value(value) => {
                let is_own = self.position(value).is_some_and(|(slot, _)| slot.0 == at);
                !is_own && !self.program.instructions[value as usize].is_mask()
            }
            _ => true,
        }
    }

    /// What these are where most of them are in that row.
    fn in_row(
        &mut self,
        at: usize,
        operands: &[Operand],
        (slot, start, step): (Slot, i64, i64),
    ) -> Option<Draft> {
        if slot.0 == at && start == 0 && step == 1 {
            let own = |(round, operand): (usize, &Operand)| self.value(slot, round as i64) == Some(*operand);
            return operands.iter().enumerate().all(own).then_some(Draft::Done(Term::Own(slot.1)));
        }
        if slot.0 == at
            && step == 1
            && let Ok(rounds @ 1..=FARTHEST) = usize::try_from(-start)
        {
            return self.carry(slot, operands, rounds).then_some(Draft::Before { index: slot.1, rounds });
        }
        let known = self.extents.get(&slot);
        let mut beyond = Vec::new();
        for (round, operand) in operands.iter().enumerate() {
            let taken = start + step * round as i64;
            let there = known.and_then(|extent| extent.beyond.get(&taken)).map(|(operand, _)| *operand);
            match self.value(slot, taken).or(there) {
                Some(value) if value != *operand => return None,
                Some(_) => {}
                None if self.is_before(at, *operand) => beyond.push((taken, (*operand, at))),
                None => return None,
            }
        }
        let rounds = self.loops[slot.0].rounds as i64;
        let extent = self.extents.entry(slot).or_insert_with(|| Extent { high: rounds, ..Extent::default() });
        for (taken, _) in &beyond {
            extent.low = extent.low.min(*taken);
            extent.high = extent.high.max(taken + 1);
        }
        extent.beyond.extend(beyond);
        Some(Draft::Kept { slot, first: start, step })
    }

    /// Whether these are what the slot was so many rounds before; what is taken while there is none is kept beside.
    fn carry(&mut self, slot: Slot, operands: &[Operand], rounds: usize) -> bool {
        let (early, late) = operands.split_at(rounds);
        let follows = |(round, operand): (usize, &Operand)| self.value(slot, round as i64) == Some(*operand);
        let is_mask = self.program.instructions[self.loops[slot.0].start + slot.1].is_mask();
        let there = !is_mask && early.iter().all(|operand| self.is_before(slot.0, *operand));
        if !there || !late.iter().enumerate().all(follows) {
            return false;
        }
        // The last of them is what stands one round before the first.
        let own: Vec<Operand> = early.iter().rev().copied().collect();
        let known = self.carried.entry(slot).or_default();
        let common = known.len().min(own.len());
        if known[..common] != own[..common] {
            return false;
        }
        if own.len() > common {
            *known = own;
        }
        true
    }

    /// These numbers, one for each round.
    fn table(&mut self, numbers: Vec<f64>) -> Term {
        let same =
            |known: &Vec<f64>| known.iter().map(|x| x.to_bits()).eq(numbers.iter().map(|x| x.to_bits()));
        let at = self.tables.iter().position(same).unwrap_or(self.tables.len());
        if at == self.tables.len() {
            self.tables.push(numbers);
        }
        Term::Number(at)
    }

    /// Results that follow their rounds are written there.
    fn write_results(&mut self, lists: &[List]) {
        let mut found: BTreeMap<Slot, Vec<(usize, usize)>> = BTreeMap::new();
        for list in lists {
            for (result, operand) in self.program.outputs.iter().enumerate().take(list.end).skip(list.start) {
                if let Operand::Value(value) = operand
                    && let Some((slot, round)) = self.position(*value)
                {
                    found.entry(slot).or_default().push((round as usize, result));
                }
            }
        }
        for (slot, found) in found {
            let own: Vec<usize> = found.iter().map(|(_, result)| *result).collect();
            if let Some(results) = results::written(lists, self.loops[slot.0].rounds, found) {
                own.iter().for_each(|result| self.left[*result] = false);
                self.results.insert(slot, results);
            }
        }
    }

    /// Values that straight instructions, all rounds of a loop, arrays or results take are kept, but for those of the last round that are
    /// carried anyway.
    fn keep_what_others_take(&mut self, drafts: &[Vec<Vec<Draft>>]) {
        let mut taken: BTreeSet<Slot> = BTreeSet::new();
        let mut straight = vec![true; self.program.instructions.len()];
        self.loops.iter().for_each(|known| straight[known.start..known.end()].fill(false));
        let outside = straight.iter().zip(&self.program.instructions).filter(|(straight, _)| **straight);
        let operands = outside.flat_map(|(_, instruction)| instruction.operands());
        // In loops: what is the same in all rounds is that of the first two.
        let inside = self.loops.iter().flat_map(|known| {
            let round = |from: usize| &self.program.instructions[from..from + known.length];
            let pairs = round(known.start).iter().zip(round(known.start + known.length));
            pairs.flat_map(|(one, two)| {
                one.operands().zip(two.operands()).filter(|(one, two)| one == two).map(|(one, _)| one)
            })
        });
        let beyond =
            self.extents.values().flat_map(|extent| extent.beyond.values().map(|(operand, _)| *operand));
        let results = self
            .program
            .outputs
            .iter()
            .zip(&self.left)
            .filter(|(_, left)| **left)
            .map(|(operand, _)| *operand);
        let gathered = drafts.iter().flatten().flatten().flat_map(|draft| match draft {
            Draft::Gathered(operands) => operands.as_slice(),
            _ => &[],
        });
        let carried = self.carried.values().flatten().copied();
        for operand in
            operands.chain(inside).chain(beyond).chain(results).chain(gathered.copied()).chain(carried)
        {
            if let Operand::Value(value) = operand
                && let Some((slot, round)) = self.position(value)
                && !(round + 1 == self.loops[slot.0].rounds as i64 && self.carried.contains_key(&slot))
            {
                taken.insert(slot);
            }
        }
        for slot in taken {
            let rounds = self.loops[slot.0].rounds as i64;
            self.extents.entry(slot).or_insert_with(|| Extent { high: rounds, ..Extent::default() });
        }
    }

    /// Numbers for the arrays. Truth values are in none.
    fn finish(self, drafts: Vec<Vec<Vec<Draft>>>) -> Option<Rolled> {
        let mut arrays = Vec::new();
        let mut numbers: BTreeMap<Slot, (usize, i64)> = BTreeMap::new();
        for (slot, extent) in &self.extents {
            if self.program.instructions[self.loops[slot.0].start + slot.1].is_mask() {
                return None;
            }
            numbers.insert(*slot, (arrays.len(), -extent.low));
            arrays.push((extent.high - extent.low) as usize);
        }
        let number = |slot: &Slot| numbers.get(slot).map(|(array, first)| (*array, *first as usize));
        let loops = self.loops.iter().zip(drafts).enumerate().map(|(at, (known, drafts))| {
            let mut before = Vec::new();
            let mut term = |draft: &Draft| match draft {
                Draft::Done(term) => Some(*term),
                Draft::Before { index, rounds } => Some(Term::Before { index: *index, rounds: *rounds }),
                Draft::Gathered(operands) => {
                    let array = arrays.len();
                    arrays.push(operands.len());
                    before
                        .extend(operands.iter().enumerate().map(|(round, operand)| (array, round, *operand)));
                    Some(Term::Kept { array, first: 0, step: 1 })
                }
                Draft::Kept { slot, first, step } => {
                    let (array, zero) = numbers.get(slot)?;
                    let first = usize::try_from(first + zero).ok()?;
                    Some(Term::Kept { array: *array, first, step: *step })
                }
            };
            let terms = drafts.iter().map(|own| own.iter().map(&mut term).collect::<Option<Vec<_>>>());
            let terms = terms.collect::<Option<Vec<_>>>()?;
            let kept = (0..known.length).map(|index| number(&(at, index))).collect();
            for (slot, extent) in &self.extents {
                let (array, zero) = numbers.get(slot)?;
                for (taken, (operand, reader)) in &extent.beyond {
                    if *reader == at {
                        before.push((*array, (taken + zero) as usize, *operand));
                    }
                }
            }
            let results = |index: usize| self.results.get(&(at, index)).cloned().unwrap_or_default();
            let results = (0..known.length).map(results).collect();
            let carried = self.carried.iter().enumerate().filter(|(_, (slot, _))| slot.0 == at);
            let carried = carried.map(|(number, ((_, index), early))| Carried {
                index: *index,
                number,
                early: early.clone(),
            });
            Some(RolledLoop { of: *known, terms, kept, before, results, carried: carried.collect() })
        });
        let loops = loops.collect::<Option<Vec<_>>>()?;
        Some(Rolled { loops, arrays, tables: self.tables, copies: Vec::new(), alone: Vec::new() })
    }
}
