//! Strands side by side, as rounds of loops, and what repeats nothing in between.
//!
//! Strands that take nothing from one another, or only at the same number, are one loop whose rounds are independent. Strands that
//! depend on themselves, such as an elimination along a chain, are a loop that runs with the dependence, upwards or
//! downwards, in which each may lag behind another (retiming: Leiserson & Saxe, Retiming Synchronous Circuitry, 1991).
//! Chains from both ends share a loop. Everything else comes as soon as it can, before the next loop.

use super::strands::{Strand, Strands};
use super::{FEWEST_ROUNDS, Loop};
use crate::schedule::{Operand, Program};
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet, BinaryHeap};

/// The order and the loops in it.
pub fn order(program: &Program, strands: Strands) -> Option<(Vec<usize>, Vec<Loop>)> {
    let mut repetition = Repetition { program, strands };
    let chains = repetition.chains();
    Sequence::new(&repetition, chains).run()
}

/// Rounds that wait for one another cost more than rounds that do not: of fewer there is no loop.
const FEWEST_IN_CHAINS: usize = 10;

struct Repetition<'a> {
    program: &'a Program,
    strands: Strands,
}

/// Strands that depend on themselves: what is computed in one round, each at the number of its own.
#[derive(Clone, Debug)]
struct Chain {
    /// Strand, and the index of its member in the first round.
    strands: Vec<(u32, usize)>,
    rounds: usize,
    /// Whether numbers grow from round to round.
    upwards: bool,
}

impl Chain {
    /// The member of one of its strands in a round.
    fn member(&self, strands: &[Strand], (strand, first): (u32, usize), round: usize) -> u32 {
        let index = if self.upwards { first + round } else { first - round };
        strands[strand as usize].members[index]
    }
}

fn values(program: &Program, instruction: usize) -> impl Iterator<Item = usize> {
    program.instructions[instruction].operands().filter_map(|operand| match operand {
        Operand::Value(value) => Some(value as usize),
        _ => None,
    })
}

impl Repetition<'_> {
    /// All chains. Where a circle has instructions of no strand in it, the ends of its strands that lead there or come from there leave
    /// them; strands of which no loop can be made are dissolved.
    fn chains(&mut self) -> Vec<Chain> {
        loop {
            let mut chains = Vec::new();
            let mut without = vec![false; self.program.instructions.len()];
            let mut whole = true;
            for group in self.circles() {
                match self.chain(&group) {
                    Some(chain) => chains.push(chain),
                    None => {
                        whole = false;
                        self.cut(&group, &mut without);
                    }
                }
            }
            if whole {
                chains.iter().for_each(|chain| self.trim(chain));
                return chains;
            }
            self.strands.leave(&without);
            self.strands.settle();
        }
    }

    /// Marks what has to leave the strands of a circle.
    fn cut(&self, group: &[usize], without: &mut [bool]) {
        let count = self.strands.strands.len();
        let (strands, alone): (Vec<usize>, Vec<usize>) = group.iter().partition(|node| **node < count);
        let mut inside = BTreeSet::new();
        for strand in &strands {
            inside.extend(self.strands.strands[*strand].members.iter().map(|member| *member as usize));
        }
        let members = inside.len();
        let alone: Vec<usize> = alone.into_iter().map(|node| node - count).collect();
        inside.extend(&alone);
        let mut users: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for instruction in &inside {
            for value in values(self.program, *instruction).filter(|value| inside.contains(value)) {
                users.entry(value).or_default().push(*instruction);
            }
        }
        let reached = |from: &[usize], next: &dyn Fn(usize) -> Vec<usize>| {
            let (mut found, mut work) = (BTreeSet::new(), from.to_vec());
            while let Some(instruction) = work.pop() {
                let new = next(instruction).into_iter().filter(|next| found.insert(*next));
                work.extend(new.collect::<Vec<_>>());
            }
            found
        };
        let before = |instruction: usize| {
            values(self.program, instruction).filter(|value| inside.contains(value)).collect()
        };
        let behind = |instruction: usize| users.get(&instruction).cloned().unwrap_or_default();
        let mut leaving: BTreeSet<usize> = BTreeSet::new();
        let mut sides = Vec::new();
        for instruction in &alone {
            let (earlier, later) = (reached(&[*instruction], &before), reached(&[*instruction], &behind));
            // A strand that stands on both sides of it.
            for strand in &strands {
                let members = || self.strands.strands[*strand].members.iter().map(|member| *member as usize);
                let of = |side: &BTreeSet<usize>| {
                    members().filter(|member| side.contains(member)).collect::<Vec<_>>()
                };
                let (earlier, later) = (of(&earlier), of(&later));
                leaving.extend(if earlier.len() < later.len() { earlier } else { later });
            }
            sides.extend([earlier, later].into_iter().min_by_key(BTreeSet::len));
        }
        if leaving.is_empty() {
            leaving = sides.into_iter().flatten().collect();
        }
        if alone.is_empty() || 4 * leaving.len() > members {
            leaving = inside;
        }
        leaving.iter().for_each(|instruction| without[*instruction] = true);
    }

    /// A strand, or an instruction of none by its index behind those.
    fn node(&self, instruction: usize) -> usize {
        match self.strands.of[instruction] {
            Some((strand, _)) => strand as usize,
            None => self.strands.strands.len() + instruction,
        }
    }

    /// Strands, and instructions between them, that depend on one another or on themselves (Tarjan 1972).
    fn circles(&self) -> Vec<Vec<usize>> {
        let (strands, instructions) = (self.strands.strands.len(), self.program.instructions.len());
        let count = strands + instructions;
        const NEW: usize = usize::MAX;
        // The node that was last seen to take each.
        let mut taken_by = vec![NEW; count];
        let mut successors: Vec<Vec<usize>> = vec![Vec::new(); count];
        let mut take = |own: usize, instruction: usize| {
            for value in values(self.program, instruction) {
                let other = self.node(value);
                if taken_by[other] != own {
                    taken_by[other] = own;
                    successors[own].push(other);
                }
            }
        };
        for (own, strand) in self.strands.strands.iter().enumerate() {
            strand.members.iter().for_each(|member| take(own, *member as usize));
        }
        for instruction in 0..instructions {
            if self.strands.of[instruction].is_none() {
                take(strands + instruction, instruction);
            }
        }
        let (mut number, mut low) = (vec![NEW; count], vec![0; count]);
        let mut on_stack = vec![false; count];
        let (mut stack, mut found, mut next) = (Vec::new(), Vec::new(), 0);
        for root in 0..count {
            if number[root] != NEW {
                continue;
            }
            let mut work: Vec<(usize, usize)> = vec![(root, 0)];
            while let Some((node, edge)) = work.pop() {
                if edge == 0 {
                    (number[node], low[node]) = (next, next);
                    next += 1;
                    stack.push(node);
                    on_stack[node] = true;
                }
                if edge > 0 {
                    let before = successors[node][edge - 1];
                    if on_stack[before] {
                        low[node] = low[node].min(low[before]);
                    }
                }
                if let Some(to) = successors[node].get(edge).copied() {
                    work.push((node, edge + 1));
                    if number[to] == NEW {
                        work.push((to, 0));
                    }
                    continue;
                }
                if low[node] == number[node] {
                    let from = stack.iter().rposition(|known| *known == node).unwrap_or(0);
                    let group: Vec<usize> = stack.drain(from..).collect();
                    group.iter().for_each(|known| on_stack[*known] = false);
                    if group.len() > 1 || successors[node].contains(&node) {
                        found.push(group);
                    }
                }
            }
        }
        found
    }

    /// The loop of strands that depend on one another; `None` where there is none.
    fn chain(&self, group: &[usize]) -> Option<Chain> {
        let strands = &self.strands.strands;
        if group.iter().any(|node| *node >= strands.len()) {
            return None;
        }
        let index: BTreeMap<usize, usize> = group.iter().enumerate().map(|(at, node)| (*node, at)).collect();
        // (user, used, how much farther on).
        let mut edges: BTreeSet<(usize, usize, i64)> = BTreeSet::new();
        for (at, node) in group.iter().enumerate() {
            let strand = &strands[*node];
            for (offset, member) in strand.members.iter().enumerate() {
                let own = strand.first + offset as i64;
                for value in values(self.program, *member as usize) {
                    if let Some((other, there)) = self.strands.of[value]
                        && let Some(other) = index.get(&(other as usize))
                    {
                        edges.insert((at, *other, there - own));
                    }
                }
            }
        }
        [true, false].into_iter().find_map(|upwards| {
            // How many rounds each is behind: upwards, what it uses is not later.
            let sign = if upwards { 1 } else { -1 };
            let mut lag = vec![0i64; group.len()];
            let mut settled = false;
            for _ in 0..=group.len() {
                settled = true;
                for (user, used, distance) in &edges {
                    let least = lag[*used] + sign * distance;
                    if lag[*user] < least {
                        lag[*user] = least;
                        settled = false;
                    }
                }
                if settled {
                    break;
                }
            }
            if !settled {
                return None;
            }
            // The rounds in which all have a member, counted with the direction.
            let ends = |at: usize| {
                let strand = &strands[group[at]];
                let (first, last) = (strand.first, strand.first + strand.members.len() as i64 - 1);
                let (begin, end) = if upwards { (first, last) } else { (-last, -first) };
                (begin + lag[at], end + lag[at])
            };
            let begin = (0..group.len()).map(|at| ends(at).0).max()?;
            let end = (0..group.len()).map(|at| ends(at).1).min()?;
            let rounds = usize::try_from(end - begin + 1).ok()?;
            let first = |at: usize| {
                let strand = &strands[group[at]];
                let number = sign * (begin - lag[at]);
                Some((group[at] as u32, usize::try_from(number - strand.first).ok()?))
            };
            let strands = (0..group.len()).map(first).collect::<Option<Vec<_>>>()?;
            (rounds >= FEWEST_IN_CHAINS).then_some(Chain { strands, rounds, upwards })
        })
    }

    /// Members in no round of the chain are in no strand.
    fn trim(&mut self, chain: &Chain) {
        for (strand, first) in &chain.strands {
            let last = if chain.upwards { first + chain.rounds - 1 } else { first + 1 - chain.rounds };
            let (low, high) = (*first.min(&last), *first.max(&last));
            for (index, member) in self.strands.strands[*strand as usize].members.iter().enumerate() {
                if index < low || index > high {
                    self.strands.of[*member as usize] = None;
                }
            }
        }
    }
}

/// What an instruction is computed with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Unit {
    Alone(usize),
    Strand(u32),
    Chain(usize),
}

/// The order while it grows.
struct Sequence<'a> {
    program: &'a Program,
    strands: &'a [Strand],
    chains: Vec<Chain>,
    unit: Vec<Unit>,
    users: Vec<Vec<u32>>,
    /// How many values that each unit takes from others are not there, by [`slot`](Sequence::slot).
    missing: Vec<usize>,
    ready: BinaryHeap<Reverse<usize>>,
    ready_strands: BTreeSet<u32>,
    ready_chains: BTreeSet<usize>,
    done: Vec<bool>,
    order: Vec<usize>,
    loops: Vec<Loop>,
}

impl<'a> Sequence<'a> {
    fn new(repetition: &'a Repetition, chains: Vec<Chain>) -> Self {
        let Repetition { program, strands } = repetition;
        let count = program.instructions.len();
        let mut of_chain = BTreeMap::new();
        for (at, chain) in chains.iter().enumerate() {
            of_chain.extend(chain.strands.iter().map(|(strand, _)| (*strand, at)));
        }
        let unit = |instruction: usize| match strands.of[instruction] {
            None => Unit::Alone(instruction),
            Some((strand, _)) => {
                of_chain.get(&strand).map_or(Unit::Strand(strand), |chain| Unit::Chain(*chain))
            }
        };
        let unit: Vec<Unit> = (0..count).map(unit).collect();
        let mut sequence = Sequence {
            program,
            strands: &strands.strands,
            missing: vec![0; count + strands.strands.len() + chains.len()],
            chains,
            users: vec![Vec::new(); count],
            unit,
            ready: BinaryHeap::new(),
            ready_strands: BTreeSet::new(),
            ready_chains: BTreeSet::new(),
            done: vec![false; count],
            order: Vec::with_capacity(count),
            loops: Vec::new(),
        };
        for instruction in 0..count {
            let own = sequence.unit[instruction];
            for value in values(program, instruction) {
                sequence.users[value].push(instruction as u32);
                if sequence.unit[value] != own {
                    let slot = sequence.slot(own);
                    sequence.missing[slot] += 1;
                }
            }
        }
        for instruction in 0..count {
            let own = sequence.unit[instruction];
            if sequence.missing[sequence.slot(own)] == 0 {
                sequence.is_ready(own);
            }
        }
        sequence
    }

    /// Instructions, then strands, then chains.
    fn slot(&self, unit: Unit) -> usize {
        match unit {
            Unit::Alone(instruction) => instruction,
            Unit::Strand(strand) => self.unit.len() + strand as usize,
            Unit::Chain(chain) => self.unit.len() + self.strands.len() + chain,
        }
    }

    fn is_ready(&mut self, unit: Unit) {
        match unit {
            Unit::Alone(instruction) => self.ready.push(Reverse(instruction)),
            Unit::Strand(strand) => {
                self.ready_strands.insert(strand);
            }
            Unit::Chain(chain) => {
                self.ready_chains.insert(chain);
            }
        }
    }

    /// All in order; `None` if something waits for itself.
    fn run(mut self) -> Option<(Vec<usize>, Vec<Loop>)> {
        loop {
            if let Some(Reverse(instruction)) = self.ready.pop() {
                self.order.push(instruction);
                self.finish(&[instruction]);
            } else if !self.ready_strands.is_empty() {
                self.side_by_side();
            } else if !self.ready_chains.is_empty() {
                self.chained();
            } else {
                break;
            }
        }
        (self.order.len() == self.program.instructions.len()).then_some((self.order, self.loops))
    }

    /// These are there: others may be ready.
    fn finish(&mut self, instructions: &[usize]) {
        instructions.iter().for_each(|instruction| self.done[*instruction] = true);
        for instruction in instructions {
            let own = self.unit[*instruction];
            for user in std::mem::take(&mut self.users[*instruction]) {
                let unit = self.unit[user as usize];
                if unit == own || self.done[user as usize] {
                    continue;
                }
                let slot = self.slot(unit);
                self.missing[slot] -= 1;
                if self.missing[slot] == 0 {
                    self.is_ready(unit);
                }
            }
        }
    }

    /// Members that no loop has are computed alone.
    fn set_alone(&mut self, members: &[usize]) {
        for member in members {
            self.unit[*member] = Unit::Alone(*member);
        }
        for member in members {
            let missing = values(self.program, *member).filter(|value| !self.done[*value]).count();
            self.missing[*member] = missing;
            if missing == 0 {
                self.ready.push(Reverse(*member));
            }
        }
    }

    /// A loop of rounds that take nothing from one another: the strands that are ready, and those that need nothing else.
    fn side_by_side(&mut self) {
        let strands = self.strands;
        let ends = |strand: u32| {
            let strand = &strands[strand as usize];
            (strand.first, strand.first + strand.members.len() as i64)
        };
        let longest = |strand: &u32| (ends(*strand).1 - ends(*strand).0, Reverse(*strand));
        let Some(first) = self.ready_strands.iter().copied().max_by_key(longest) else { return };
        let whole = ends(first);
        let mut range = whole;
        // Where most of both is in common.
        let common = |range: (i64, i64), other: (i64, i64)| {
            let both = (range.0.max(other.0), range.1.min(other.1));
            let most = |of: (i64, i64)| 4 * (both.1 - both.0) >= 3 * (of.1 - of.0);
            (most(whole) && most(other) && both.1 - both.0 >= FEWEST_ROUNDS as i64).then_some(both)
        };
        let mut group: BTreeSet<u32> = BTreeSet::new();
        let mut candidates: Vec<u32> = self.ready_strands.iter().copied().collect();
        while let Some(strand) = candidates.pop() {
            if group.contains(&strand) {
                continue;
            }
            let Some(both) = common(range, ends(strand)).filter(|both| self.follows(strand, *both, &group))
            else {
                continue;
            };
            range = both;
            group.insert(strand);
            let users =
                strands[strand as usize].members.iter().flat_map(|member| &self.users[*member as usize]);
            let users = users.filter_map(|user| match self.unit[*user as usize] {
                Unit::Strand(strand) => Some(strand),
                _ => None,
            });
            candidates.extend(users.collect::<BTreeSet<u32>>());
        }
        let member = |strand: u32, at: i64| {
            let strand = &strands[strand as usize];
            strand.members[(at - strand.first) as usize] as usize
        };
        let middle = (range.0 + range.1) / 2;
        let mut body: Vec<u32> = group.iter().copied().collect();
        body.sort_by_key(|strand| member(*strand, middle));
        let rounds = (range.1 - range.0) as usize;
        self.loops.push(Loop { start: self.order.len(), length: body.len(), rounds, independent: true });
        let own: Vec<usize> =
            (range.0..range.1).flat_map(|at| body.iter().map(move |strand| member(*strand, at))).collect();
        let outside = group.iter().flat_map(|strand| {
            let strand = &strands[*strand as usize];
            let numbered = strand.members.iter().zip(strand.first..);
            numbered.filter(|(_, at)| *at < range.0 || *at >= range.1).map(|(member, _)| *member as usize)
        });
        let outside: Vec<usize> = outside.collect();
        group.iter().for_each(|strand| {
            self.ready_strands.remove(strand);
        });
        self.order.extend(&own);
        // What is outside is alone before others are told, and counts what it needs when all of the loop is there.
        outside.iter().for_each(|member| self.unit[*member] = Unit::Alone(*member));
        own.iter().for_each(|member| self.done[*member] = true);
        self.set_alone(&outside);
        let fresh: BTreeSet<usize> = outside.into_iter().collect();
        self.finish_except(&own, &fresh);
    }

    /// As [`finish`](Self::finish); those in `fresh` have counted already.
    fn finish_except(&mut self, instructions: &[usize], fresh: &BTreeSet<usize>) {
        for instruction in instructions {
            self.users[*instruction].retain(|user| !fresh.contains(&(*user as usize)));
        }
        self.finish(instructions);
    }

    /// Whether a strand takes, at these numbers, only what is there or what the group has at the same number.
    fn follows(&self, strand: u32, range: (i64, i64), group: &BTreeSet<u32>) -> bool {
        let own = &self.strands[strand as usize];
        (range.0..range.1).all(|at| {
            let member = own.members[(at - own.first) as usize] as usize;
            values(self.program, member).all(|value| {
                let beside = || match self.unit[value] {
                    Unit::Strand(other) if group.contains(&other) => {
                        let other = &self.strands[other as usize];
                        other
                            .members
                            .get((at - other.first) as usize)
                            .is_some_and(|known| *known as usize == value)
                    }
                    _ => false,
                };
                self.done[value] || beside()
            })
        })
    }

    /// A loop of the chains that are ready and have about as many rounds.
    fn chained(&mut self) {
        let longest = self.ready_chains.iter().map(|chain| self.chains[*chain].rounds).max().unwrap_or(0);
        let alike = |chain: &&usize| 4 * self.chains[**chain].rounds >= 3 * longest;
        let group: Vec<usize> = self.ready_chains.iter().filter(alike).copied().collect();
        let rounds = group.iter().map(|chain| self.chains[*chain].rounds).min().unwrap_or(0);
        let (mut own, mut outside) = (Vec::new(), Vec::new());
        let mut body = Vec::new();
        for chain in &group {
            let chain = &self.chains[*chain];
            let members =
                |strand: &(u32, usize), round: usize| chain.member(self.strands, *strand, round) as usize;
            let mut of_chain: Vec<(u32, usize)> = chain.strands.clone();
            of_chain.sort_by_key(|strand| members(strand, rounds / 2));
            for round in rounds..chain.rounds {
                outside.extend(of_chain.iter().map(|strand| members(strand, round)));
            }
            body.push(of_chain);
        }
        for round in 0..rounds {
            for (chain, strands) in group.iter().zip(&body) {
                let chain = &self.chains[*chain];
                own.extend(strands.iter().map(|strand| chain.member(self.strands, *strand, round) as usize));
            }
        }
        let length = body.iter().map(Vec::len).sum();
        self.loops.push(Loop { start: self.order.len(), length, rounds, independent: false });
        group.iter().for_each(|chain| {
            self.ready_chains.remove(chain);
        });
        self.order.extend(&own);
        outside.iter().for_each(|member| self.unit[*member] = Unit::Alone(*member));
        own.iter().for_each(|member| self.done[*member] = true);
        self.set_alone(&outside);
        let fresh: BTreeSet<usize> = outside.into_iter().collect();
        self.finish_except(&own, &fresh);
    }
}
