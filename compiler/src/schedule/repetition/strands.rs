//! Strands: instructions of one form that follow one another along the numbers of [`Places`].
//!
//! Candidates have the same operations down to a few levels and the same families of arguments, at the same distances. What
//! they take then has to be the same from one to the next: a constant, an entry, the next of a family, or the member of
//! a strand at the same distance. Where a strand takes members of another, or of itself, beyond the ends of that one,
//! it may take anything instead: that is how a chain begins.

use super::FEWEST_ROUNDS;
use super::places::{Place, Places};
use crate::schedule::{Instruction, Operand, Program};
use crate::symbolic::FastHash;
use std::collections::HashMap;
use std::hash::{BuildHasher, Hash, Hasher};

/// To how many levels the operations are compared at most, before what they take is.
const LEVELS: usize = 10;

/// Instructions at the numbers from `first` on.
#[derive(Clone, Debug)]
pub struct Strand {
    pub first: i64,
    pub members: Vec<u32>,
    /// Whether their numbers may be any.
    pub any_numbers: bool,
}

impl Strand {
    /// Whether it has a member at this number.
    fn has(&self, at: i64) -> bool {
        at >= self.first && at < self.first + self.members.len() as i64
    }
}

/// Which strand an instruction is in, and at which number.
pub type Member = Option<(u32, i64)>;

#[derive(Clone, Debug, Default)]
pub struct Strands {
    /// The numbers that they follow.
    places: Places,
    pub strands: Vec<Strand>,
    pub of: Vec<Member>,
    /// Whether the numbers of new ones may be any.
    any_numbers: bool,
}

/// How many alike parts may alternate, as signs do along some chains.
const PERIODS: u32 = 2;

/// The strands of a program.
pub fn find(program: &Program, places: &Places) -> Strands {
    let with = |period: u32| {
        let of = vec![None; program.instructions.len()];
        let mut strands = Strands { places: places.every(period), of, ..Strands::default() };
        // What is found tells apart what was not.
        while strands.grow(program) {}
        strands.any_numbers = true;
        while strands.grow(program) {}
        strands
    };
    (1..=PERIODS).rev().map(with).max_by_key(Strands::covered).unwrap_or_default()
}

/// What an instruction does, whatever it does it to.
fn kind(instruction: &Instruction) -> u64 {
    let mut hasher = FastHash::default().build_hasher();
    std::mem::discriminant(instruction).hash(&mut hasher);
    match instruction {
        Instruction::MulAdd(_, _, _, product, addend) => (product, addend).hash(&mut hasher),
        Instruction::Unary(function, _) => function.hash(&mut hasher),
        Instruction::Compare(comparison, ..) => comparison.hash(&mut hasher),
        Instruction::Cell(table, _) => table.hash(&mut hasher),
        Instruction::Piece(table, orders, ..) | Instruction::Patch(table, orders, ..) => {
            (table, orders).hash(&mut hasher);
        }
        _ => {}
    }
    hasher.finish()
}

/// What an instruction is as far as it was compared, and the least number of what it depends on.
type Form = (u64, Option<i64>);

/// The form of an instruction by the forms of what it takes.
fn form(kind: u64, instruction: &Instruction, forms: &[Form], strands: &Strands) -> Form {
    let of = |operand: Operand| match operand {
        Operand::Constant(_) if strands.any_numbers => (0, None),
        Operand::Constant(value) => (value.to_bits(), None),
        Operand::Source(source) => match strands.places.get(source) {
            Some(Place { family, at }) => (u64::from(family), Some(at)),
            None => (u64::from(source.index) << 32 | source.argument as u64, None),
        },
        Operand::Value(value) => forms[value as usize],
    };
    let least = instruction.operands().filter_map(|operand| of(operand).1).min();
    let mut hasher = FastHash::default().build_hasher();
    kind.hash(&mut hasher);
    for operand in instruction.operands() {
        let (form, at) = of(operand);
        std::mem::discriminant(&operand).hash(&mut hasher);
        (form, at.map(|at| at - least.unwrap_or(at))).hash(&mut hasher);
    }
    (hasher.finish(), least)
}

/// Those that are alike and in no strand, where they follow one another.
fn alike(forms: &[Form], of: &[Member], any_numbers: bool) -> Vec<Strand> {
    let mut groups: HashMap<u64, Vec<(i64, u32)>, FastHash> = HashMap::default();
    for (index, (form, at)) in forms.iter().enumerate() {
        if let Some(at) = at
            && of[index].is_none()
        {
            groups.entry(*form).or_default().push((*at, index as u32));
        }
    }
    let mut groups: Vec<Vec<(i64, u32)>> =
        groups.into_values().filter(|group| group.len() >= FEWEST_ROUNDS).collect();
    // The order of a hash table is not that of anything.
    groups.sort_unstable_by_key(|group| group[0].1);
    let mut strands = Vec::new();
    for mut group in groups {
        group.sort_unstable();
        group.dedup_by_key(|(at, _)| *at);
        let runs = group.chunk_by(|one, next| next.0 == one.0 + 1).filter(|run| run.len() >= FEWEST_ROUNDS);
        let members = |run: &[(i64, u32)]| run.iter().map(|(_, index)| *index).collect();
        strands.extend(runs.map(|run| Strand { first: run[0].0, members: members(run), any_numbers }));
    }
    strands
}

/// What an operand is, as far as it has to be the same for all members of a strand.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Key {
    /// A number, an entry or a value that are the same for the neighbour.
    Same(Operand),
    /// The entry of a family so far on.
    Family(u32, i64),
    /// The member of a strand so far on.
    Strand(u32, i64),
    /// Any number.
    Number,
}

/// What strands take at numbers at which the other strand has no member.
type Beyond = HashMap<(u32, i64), Operand, FastHash>;

impl Strands {
    /// How many instructions are in strands.
    pub fn covered(&self) -> usize {
        self.of.iter().flatten().count()
    }

    /// Adds what is alike to some levels: to those levels at which most is. Fewer do not tell apart what differs, and of chains they leave
    /// what is farther from arguments; more of them lose the ends. Whether there was something that stays.
    fn grow(&mut self, program: &Program) -> bool {
        let instructions = &program.instructions;
        let kinds: Vec<u64> = instructions.iter().map(kind).collect();
        let start = |(kind, member): (&u64, &Member)| match member {
            Some((strand, at)) => (u64::from(*strand), Some(*at)),
            None => (*kind, None),
        };
        let mut forms: Vec<Form> = kinds.iter().zip(&self.of).map(start).collect();
        let (mut best, mut most) = (Vec::new(), 0);
        for _ in 0..LEVELS {
            let next = |index: usize| match self.of[index] {
                Some(_) => forms[index],
                None => form(kinds[index], &instructions[index], &forms, self),
            };
            forms = (0..instructions.len()).map(next).collect();
            let strands = alike(&forms, &self.of, self.any_numbers);
            let covered = strands.iter().map(|strand| strand.members.len()).sum();
            if covered > most {
                (best, most) = (strands, covered);
            }
        }
        let before = self.covered();
        let old = self.clone();
        best.into_iter().for_each(|strand| self.add(strand));
        self.settle(program);
        let grown = self.covered() > before;
        if !grown {
            *self = old;
        }
        grown
    }

    /// A new strand, if it is long enough to be one.
    fn add(&mut self, strand: Strand) {
        let number = self.strands.len() as u32;
        let long = strand.members.len() >= FEWEST_ROUNDS;
        for (at, member) in strand.members.iter().enumerate() {
            self.of[*member as usize] = long.then_some((number, strand.first + at as i64));
        }
        if long {
            self.strands.push(strand);
        }
    }

    /// Without these members.
    pub fn leave(&mut self, leaving: &[bool]) {
        let old = std::mem::take(&mut self.strands);
        for strand in old {
            let numbered: Vec<(i64, u32)> = (strand.first..).zip(strand.members).collect();
            let runs =
                numbered.chunk_by(|(_, one), (_, next)| leaving[*one as usize] == leaving[*next as usize]);
            for run in runs {
                let members: Vec<u32> = run.iter().map(|(_, member)| *member).collect();
                if leaving[members[0] as usize] {
                    members.iter().for_each(|member| self.of[*member as usize] = None);
                } else {
                    self.add(Strand { first: run[0].0, members, any_numbers: strand.any_numbers });
                }
            }
        }
    }

    /// Cuts strands until all members of each take the same.
    pub fn settle(&mut self, program: &Program) {
        while self.refine(program) {}
    }

    /// Cuts strands where what they take changes; whether there were such places.
    fn refine(&mut self, program: &Program) -> bool {
        let mut beyond = Beyond::default();
        let mut changed = false;
        // Numbers of strands stay what they were while keys are compared.
        let old = std::mem::take(self);
        let view = View { old: &old, program };
        let mut new = Strands { of: vec![None; old.of.len()], ..Strands::default() };
        for strand in &old.strands {
            let pieces = view.pieces(strand, &mut beyond);
            changed |= pieces != [(0, strand.members.len())];
            for (start, end) in pieces {
                let members = strand.members[start..end].to_vec();
                new.add(Strand {
                    first: strand.first + start as i64,
                    members,
                    any_numbers: strand.any_numbers,
                });
            }
        }
        *self = Strands { places: old.places, any_numbers: old.any_numbers, ..new };
        changed
    }
}

/// The strands while they are compared.
struct View<'a> {
    old: &'a Strands,
    program: &'a Program,
}

impl View<'_> {
    fn operands(&self, member: u32) -> impl Iterator<Item = Operand> {
        self.program.instructions[member as usize].operands()
    }

    /// The keys of the member at an index of its strand.
    fn keys(&self, strand: &Strand, index: usize) -> [Option<Key>; 3] {
        let at = strand.first + index as i64;
        let neighbour = strand.members[if index == 0 { 1 } else { index - 1 }];
        let other = strand.members.get(index + 1).copied().unwrap_or(neighbour);
        let mut keys = [None; 3];
        let operands = self.operands(strand.members[index]);
        let operands = operands.zip(self.operands(neighbour)).zip(self.operands(other));
        for (key, ((operand, one), two)) in keys.iter_mut().zip(operands) {
            *key = Some(match operand {
                Operand::Constant(_) if strand.any_numbers => Key::Number,
                operand if operand == one || operand == two => Key::Same(operand),
                operand => self.key(operand, at),
            });
        }
        keys
    }

    fn key(&self, operand: Operand, at: i64) -> Key {
        match operand {
            Operand::Source(source) => match self.old.places.get(source) {
                Some(place) => Key::Family(place.family, place.at - at),
                None => Key::Same(operand),
            },
            Operand::Value(value) => match self.old.of[value as usize] {
                Some((strand, there)) => Key::Strand(strand, there - at),
                None => Key::Same(operand),
            },
            Operand::Constant(_) => Key::Same(operand),
        }
    }

    /// Where the keys stay the same, as ranges of indices; what begins or ends a chain belongs to its range.
    fn pieces(&self, strand: &Strand, beyond: &mut Beyond) -> Vec<(usize, usize)> {
        let count = strand.members.len();
        let keys: Vec<[Option<Key>; 3]> = (0..count).map(|index| self.keys(strand, index)).collect();
        let mut runs: Vec<(usize, usize)> = Vec::new();
        let mut start = 0;
        for index in 1..=count {
            if index == count || keys[index] != keys[start] {
                runs.push((start, index));
                start = index;
            }
        }
        // The long ones first: they say what is taken at the ends.
        let mut by_length: Vec<usize> = (0..runs.len()).collect();
        by_length.sort_by_key(|run| std::cmp::Reverse(runs[*run].1 - runs[*run].0));
        let mut taken = vec![false; count];
        // What is long enough to be a strand remains one by itself.
        let mut short = vec![false; count];
        for (start, end) in &runs {
            short[*start..*end].fill(end - start < FEWEST_ROUNDS);
        }
        let joins = |index: usize, taken: &[bool]| short[index] && !taken[index];
        let mut pieces = Vec::new();
        for run in by_length {
            let (mut start, mut end) = runs[run];
            if taken[start] || end - start < 2 {
                continue;
            }
            let own = keys[start];
            while start > 0 && joins(start - 1, &taken) && self.passes(strand, start - 1, &own, &keys, beyond)
            {
                start -= 1;
            }
            while end < count && joins(end, &taken) && self.passes(strand, end, &own, &keys, beyond) {
                end += 1;
            }
            taken[start..end].iter_mut().for_each(|taken| *taken = true);
            pieces.push((start, end));
        }
        pieces.sort_unstable();
        pieces
    }

    /// Whether what the member takes differs only where the other strand has no member, and from nothing that others take there.
    fn passes(
        &self,
        strand: &Strand,
        index: usize,
        own: &[Option<Key>; 3],
        keys: &[[Option<Key>; 3]],
        beyond: &mut Beyond,
    ) -> bool {
        let at = strand.first + index as i64;
        let mut new = Vec::new();
        for ((own, key), operand) in own.iter().zip(&keys[index]).zip(self.operands(strand.members[index])) {
            if own == key {
                continue;
            }
            let Some(Key::Strand(other, distance)) = *own else { return false };
            let there = at + distance;
            if self.old.strands[other as usize].has(there) {
                return false;
            }
            match beyond.get(&(other, there)) {
                Some(known) if *known != operand => return false,
                Some(_) => {}
                None => new.push(((other, there), operand)),
            }
        }
        beyond.extend(new);
        true
    }
}
