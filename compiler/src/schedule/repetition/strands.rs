//! Strands: instructions of one form that follow one another along the numbers of [`Places`].
//!
//! Candidates have the same operations down to a few levels and the same families of arguments, at the same distances. What
//! they take then has to be the same from one to the next: a constant, an entry, the next of a family, or the member of
//! a strand at the same distance. Where a strand takes members of another, or of itself, beyond the ends of that one,
//! it may take anything instead: that is how a chain begins.

use super::FEWEST_ROUNDS;
use super::places::{Place, Places};
use crate::schedule::{Instruction, Operand, Program};
use crate::symbolic::{FastHash, Known, mix};
use std::collections::HashMap;
use std::hash::{BuildHasher, Hash, Hasher};
use std::rc::Rc;

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
    operations: Rc<[Operation]>,
    pub strands: Vec<Strand>,
    pub of: Vec<Member>,
    /// How many alike parts alternate.
    period: u32,
    /// Whether the numbers of new ones may be any.
    any_numbers: bool,
}

/// How many alike parts may alternate, as signs do along some chains.
const PERIODS: u32 = 2;

/// To how many levels what alternates is compared with what does not.
const FIRST_LEVELS: usize = 2;

/// The strands of a program.
pub fn find(program: &Program, places: &Places) -> Strands {
    let operations = Operation::all(program, places);
    let with = |period: u32| {
        let strands = Strands::none(&operations, period);
        let alike = strands.alike(FIRST_LEVELS);
        // The shortest text: what is in no strand, and each strand once.
        let text = strands.of.len() - members(&alike) + alike.len();
        (text, strands)
    };
    let of_periods = (1..=PERIODS).map(with).min_by_key(|(text, _)| *text);
    let Some((_, mut strands)) = of_periods else { return Strands::default() };
    strands.find_all();
    strands
}

fn members(strands: &[Strand]) -> usize {
    strands.iter().map(|strand| strand.members.len()).sum()
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

/// What an operand says of the form of an instruction, found once.
#[derive(Clone, Copy, Debug)]
enum Taken {
    /// The same wherever it is taken.
    Fixed(u64),
    Number(u64),
    /// The entry of a family at a number.
    Family(Place),
    Value(u32),
}

/// What an instruction does, and to what, as it is compared.
#[derive(Clone, Copy, Debug)]
struct Operation {
    kind: u64,
    operands: [Option<Operand>; 3],
    taken: [Option<Taken>; 3],
}

impl Operation {
    /// Those of a program.
    fn all(program: &Program, places: &Places) -> Vec<Operation> {
        program.instructions.iter().map(|instruction| Operation::of(instruction, places)).collect()
    }

    /// The same where only every so manieth place is alike.
    fn every(&mut self, period: u32) {
        let mut index = 0;
        while index < 3 {
            if let Some(Taken::Family(place)) = &mut self.taken[index] {
                *place = place.every(period);
            }
            index += 1;
        }
    }

    fn of(instruction: &Instruction, places: &Places) -> Operation {
        let mut operation = Operation { kind: kind(instruction), operands: [None; 3], taken: [None; 3] };
        for (index, operand) in instruction.operands().enumerate() {
            operation.operands[index] = Some(operand);
            operation.taken[index] = Some(match operand {
                Operand::Constant(value) => Taken::Number(value.to_bits()),
                Operand::Source(source) => match places.get(source) {
                    Some(place) => Taken::Family(place),
                    None => Taken::Fixed(u64::from(source.index) << 32 | source.argument as u64),
                },
                Operand::Value(value) => Taken::Value(value),
            });
        }
        operation
    }

    /// The form by the forms of what is taken.
    fn form(&self, forms: &[Form], any_numbers: bool) -> Form {
        // Loops over indices: this is most of the work, and compilers of user crates run it unoptimised.
        let mut found = [(0, 0, None); 3];
        let mut least: Option<i64> = None;
        let mut count = 0;
        while count < 3 {
            let Some(taken) = self.taken[count] else { break };
            let of: (u64, u64, Option<i64>) = match taken {
                Taken::Number(_) if any_numbers => (1, 0, None),
                Taken::Number(bits) => (1, bits, None),
                Taken::Fixed(of) => (2, of, None),
                Taken::Family(place) => (3, u64::from(place.family), Some(place.at)),
                Taken::Value(value) => {
                    let (form, at) = forms[value as usize];
                    (4, form, at)
                }
            };
            if let Some(at) = of.2
                && !matches!(least, Some(least) if least <= at)
            {
                least = Some(at);
            }
            found[count] = of;
            count += 1;
        }
        let mut form = self.kind;
        let mut index = 0;
        while index < count {
            let (what, of, at) = found[index];
            // Of what has no number the distance is none of those that there are.
            let distance = match (at, least) {
                (Some(at), Some(least)) => (at - least) as u64,
                _ => u64::MAX,
            };
            form = mix(mix(mix(form, what), of), distance);
            index += 1;
        }
        (form, least)
    }
}

/// Those that are alike and in no strand, where they follow one another.
fn alike(forms: &[Form], free: &[u32], any_numbers: bool) -> Vec<Strand> {
    let mut strands = Vec::new();
    for mut group in groups(forms, free) {
        // Most come in order; loops over indices as in `form`.
        let mut index = 1;
        while index < group.len() && group[index].0 > group[index - 1].0 {
            index += 1;
        }
        if index < group.len() {
            group.sort_unstable();
            group.dedup_by_key(|(at, _)| *at);
        }
        let mut start = 0;
        index = 1;
        while index <= group.len() {
            if index == group.len() || group[index].0 != group[index - 1].0 + 1 {
                let run = &group[start..index];
                if run.len() >= FEWEST_ROUNDS {
                    let members = run.iter().map(|(_, member)| *member).collect();
                    strands.push(Strand { first: run[0].0, members, any_numbers });
                }
                start = index;
            }
            index += 1;
        }
    }
    strands
}

/// Those of one form that have numbers, with these, where there are enough of them; the groups in the order of their first members.
fn groups(forms: &[Form], free: &[u32]) -> Vec<Vec<(i64, u32)>> {
    const NONE: usize = usize::MAX;
    let (mut known, mut of, mut counts) = (Known::default(), Vec::new(), Vec::new());
    let mut class = Vec::with_capacity(free.len());
    // Loops over indices, as in `form`.
    let mut index = 0;
    while index < free.len() {
        let (form, at) = forms[free[index] as usize];
        index += 1;
        if at.is_none() {
            class.push(NONE);
            continue;
        }
        let own = known.get(form, |number| of[number as usize] == form).unwrap_or_else(|| {
            of.push(form);
            counts.push(0_usize);
            known.add(form)
        }) as usize;
        counts[own] += 1;
        class.push(own);
    }
    let is_long = |count: &usize| *count >= FEWEST_ROUNDS;
    let room = |count: &usize| Vec::with_capacity(if is_long(count) { *count } else { 0 });
    let mut groups: Vec<Vec<(i64, u32)>> = counts.iter().map(room).collect();
    index = 0;
    while index < free.len() {
        let own = class[index];
        if own != NONE && is_long(&counts[own]) {
            groups[own].push((forms[free[index] as usize].1.unwrap_or(0), free[index]));
        }
        index += 1;
    }
    groups.retain(|group| !group.is_empty());
    groups
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
    fn none(operations: &[Operation], period: u32) -> Strands {
        let of = vec![None; operations.len()];
        let mut operations = operations.to_vec();
        operations.iter_mut().filter(|_| period > 1).for_each(|operation| operation.every(period));
        Strands { operations: operations.into(), of, period, ..Strands::default() }
    }

    /// Those of another program, with as many parts that alternate.
    pub fn anew(&self, program: &Program, places: &Places) -> Strands {
        let mut strands = Strands::none(&Operation::all(program, places), self.period);
        strands.find_all();
        strands
    }

    /// What is found tells apart what was not.
    fn find_all(&mut self) {
        while self.grow(self.alike(LEVELS)) {}
        self.any_numbers = true;
        while self.grow(self.alike(LEVELS)) {}
    }

    /// The members of each.
    pub fn rows(&self) -> Vec<&[u32]> {
        self.strands.iter().map(|strand| strand.members.as_slice()).collect()
    }

    /// How many instructions are in strands.
    pub fn covered(&self) -> usize {
        self.of.iter().flatten().count()
    }

    /// What is alike to some levels, at those levels at which most is. Fewer do not tell apart what differs, and of chains they leave what is
    /// farther from arguments; more of them lose the ends.
    fn alike(&self, levels: usize) -> Vec<Strand> {
        let free: Vec<u32> = (0..self.of.len() as u32).filter(|at| self.of[*at as usize].is_none()).collect();
        let start = |(operation, member): (&Operation, &Member)| match member {
            Some((strand, at)) => (u64::from(*strand), Some(*at)),
            None => (operation.kind, None),
        };
        let mut forms: Vec<Form> = self.operations.iter().zip(&self.of).map(start).collect();
        let (mut best, mut most) = (Vec::new(), 0);
        for _ in 0..levels {
            let next = |at: &u32| self.operations[*at as usize].form(&forms, self.any_numbers);
            let next: Vec<Form> = free.iter().map(next).collect();
            free.iter().zip(next).for_each(|(at, form)| forms[*at as usize] = form);
            let strands = alike(&forms, &free, self.any_numbers);
            let covered = members(&strands);
            // It grows, then falls.
            if most > 0 && covered <= most {
                break;
            }
            (best, most) = (strands, covered);
            if covered == free.len() {
                break;
            }
        }
        best
    }

    /// Adds strands and cuts all until they hold; whether more is in strands than before.
    fn grow(&mut self, alike: Vec<Strand>) -> bool {
        if alike.is_empty() {
            return false;
        }
        let before = self.covered();
        let old = self.clone();
        alike.into_iter().for_each(|strand| self.add(strand));
        self.settle();
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
    pub fn settle(&mut self) {
        while self.refine() {}
    }

    /// Cuts strands where what they take changes; whether there were such places.
    fn refine(&mut self) -> bool {
        let mut beyond = Beyond::default();
        let mut changed = false;
        // Numbers of strands stay what they were while keys are compared.
        let old = std::mem::take(self);
        let view = View { old: &old };
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
        *self = Strands { strands: new.strands, of: new.of, ..old };
        changed
    }
}

/// The strands while they are compared.
struct View<'a> {
    old: &'a Strands,
}

impl View<'_> {
    fn operation(&self, member: u32) -> &Operation {
        &self.old.operations[member as usize]
    }

    /// The keys of the member at an index of its strand.
    fn keys(&self, strand: &Strand, index: usize) -> [Option<Key>; 3] {
        let at = strand.first + index as i64;
        let neighbour = strand.members[if index == 0 { 1 } else { index - 1 }];
        let other = strand.members.get(index + 1).copied().unwrap_or(neighbour);
        let mut keys = [None; 3];
        let [own, one, two] = [strand.members[index], neighbour, other].map(|member| self.operation(member));
        let mut at_operand = 0;
        while at_operand < 3 {
            let Some(operand) = own.operands[at_operand] else { break };
            keys[at_operand] = Some(match operand {
                Operand::Constant(_) if strand.any_numbers => Key::Number,
                _ if own.operands[at_operand] == one.operands[at_operand] => Key::Same(operand),
                _ if own.operands[at_operand] == two.operands[at_operand] => Key::Same(operand),
                _ => self.key(operand, own.taken[at_operand], at),
            });
            at_operand += 1;
        }
        keys
    }

    fn key(&self, operand: Operand, taken: Option<Taken>, at: i64) -> Key {
        match taken {
            Some(Taken::Family(place)) => Key::Family(place.family, place.at - at),
            Some(Taken::Value(value)) => match self.old.of[value as usize] {
                Some((strand, there)) => Key::Strand(strand, there - at),
                None => Key::Same(operand),
            },
            _ => Key::Same(operand),
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
        let operands = self.operation(strand.members[index]).operands.iter().flatten();
        for ((own, key), operand) in own.iter().zip(&keys[index]).zip(operands) {
            if own == key {
                continue;
            }
            let Some(Key::Strand(other, distance)) = *own else { return false };
            let there = at + distance;
            if self.old.strands[other as usize].has(there) {
                return false;
            }
            match beyond.get(&(other, there)) {
                Some(known) if known != operand => return false,
                Some(_) => {}
                None => new.push(((other, there), *operand)),
            }
        }
        beyond.extend(new);
        true
    }
}
