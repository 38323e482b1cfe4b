//! Results in loops: written in the round that computes them, or copied in rounds where they are something else.

use super::{FEWEST_ROUNDS, Rolled, Term};
use crate::complete::Complete;
use crate::functions::{Group, Signature};
use crate::schedule::{Operand, Program, Source};

/// Results that are the entries of one list: from where to where among all, and how many belong to one entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct List {
    pub start: usize,
    pub end: usize,
    pub width: usize,
}

/// Result `first + step i`, in round i.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Result {
    pub first: usize,
    pub step: i64,
}

impl Result {
    /// Which result it is in a round.
    pub fn in_round(&self, round: usize) -> usize {
        (self.first as i64 + self.step * round as i64) as usize
    }
}

/// Rounds in which results become what is elsewhere.
#[derive(Clone, Debug)]
pub struct Copies {
    pub rounds: usize,
    pub results: Vec<(Result, Term)>,
}

/// How many entries apart results may be that are copied in rounds.
const FARTHEST: usize = 24;

impl List {
    /// The groups of results of a function.
    pub fn groups(signature: &Signature, complete: &Complete, outputs: &[Operand]) -> Vec<List> {
        let space = complete.equations.kinematics.space();
        let mut end = 0;
        let list = |(group, own): (&Group, &[Operand])| {
            let start = end;
            end += own.len();
            List { start, end, width: group.shape.record().map_or(1, |record| record.of(space).length()) }
        };
        signature.results.iter().zip(signature.groups(complete, outputs)).map(list).collect()
    }

    /// Those whose entries are counted.
    pub fn all(signature: &Signature, complete: &Complete, outputs: &[Operand]) -> Vec<List> {
        let groups = signature.results.iter().zip(List::groups(signature, complete, outputs));
        let counted = groups.filter(|(group, _)| group.shape.is_list());
        counted.map(|(_, list)| list).collect()
    }

    /// The list that a result is in.
    pub fn of(lists: &[List], result: usize) -> Option<&List> {
        let at = lists.partition_point(|list| list.end <= result);
        lists.get(at).filter(|list| list.start <= result)
    }
}

/// The results of one instruction of a round, as (round, result): those that a loop can write, and whether these are all.
pub fn written(lists: &[List], rounds: usize, mut found: Vec<(usize, usize)>) -> Option<Vec<Result>> {
    found.sort_unstable();
    let many = found.len() / rounds;
    if many == 0 || found.len() != many * rounds {
        return None;
    }
    let result = |which: usize| {
        let (first, next) = (found[which].1, found[many + which].1);
        let step = next as i64 - first as i64;
        let holds = |round: usize| {
            let expected = first as i64 + step * round as i64;
            found[round * many + which] == (round, usize::try_from(expected).unwrap_or(usize::MAX))
        };
        let list = List::of(lists, first)?;
        let last = List::of(lists, found[(rounds - 1) * many + which].1);
        let whole = last == Some(list) && step % list.width as i64 == 0;
        (whole && (0..rounds).all(holds)).then_some(Result { first, step })
    };
    (0..many).map(result).collect()
}

/// What is copied of these results: rounds, and what is copied alone.
pub fn copies(
    program: &Program,
    lists: &[List],
    rolled: &Rolled,
    mut left: Vec<bool>,
) -> (Vec<Copies>, Vec<usize>) {
    let term = |result: usize| match program.outputs[result] {
        Operand::Value(value) => match rolled.place(value) {
            Some((array, first)) => Term::Kept { array, first, step: 0 },
            None => Term::Same(Operand::Value(value)),
        },
        operand => Term::Same(operand),
    };
    let mut copies: Vec<Copies> = Vec::new();
    let mut alone = Vec::new();
    for list in lists {
        for result in list.start..list.end {
            if !left[result] {
                continue;
            }
            let run = |apart: usize| {
                let mut rounds = (result..list.end).step_by(apart).take_while(|at| left[*at]).map(term);
                let (first, next) = (rounds.next()?, rounds.next()?);
                let common = common(first, next)?;
                let follows = |(round, own): &(usize, Term)| in_round(common, *round + 2) == Some(*own);
                let many = 2 + rounds.enumerate().take_while(follows).count();
                Some((many, Result { first: result, step: apart as i64 }, common))
            };
            let runs = (1..=FARTHEST).map(|apart| apart * list.width).filter_map(run);
            // Of the longest that with the nearest entries.
            match runs.rev().max_by_key(|(many, ..)| *many).filter(|(many, ..)| *many >= FEWEST_ROUNDS) {
                Some((many, own, common)) => {
                    (result..list.end).step_by(own.step as usize).take(many).for_each(|at| left[at] = false);
                    match copies.iter_mut().find(|known| known.rounds == many) {
                        Some(known) => known.results.push((own, common)),
                        None => copies.push(Copies { rounds: many, results: vec![(own, common)] }),
                    }
                }
                None => alone.push(result),
            }
        }
    }
    (copies, alone)
}

/// What is `first` in the first round and `next` in the second.
fn common(first: Term, next: Term) -> Option<Term> {
    match (first, next) {
        (Term::Kept { array, first, .. }, Term::Kept { array: other, first: next, .. }) if array == other => {
            Some(Term::Kept { array, first, step: next as i64 - first as i64 })
        }
        (Term::Same(one), Term::Same(other)) if one == other => Some(first),
        (Term::Same(Operand::Source(one)), Term::Same(Operand::Source(other)))
            if one.argument == other.argument =>
        {
            let step = i64::from(other.index) - i64::from(one.index);
            Some(Term::Entry { argument: one.argument, first: one.index as usize, step })
        }
        _ => None,
    }
}

/// What that is in a round, as a term by itself.
fn in_round(term: Term, round: usize) -> Option<Term> {
    let counted = |first: usize, step: i64| usize::try_from(first as i64 + step * round as i64).ok();
    match term {
        Term::Kept { array, first, step } => {
            Some(Term::Kept { array, first: counted(first, step)?, step: 0 })
        }
        Term::Entry { argument, first, step } => {
            let index = u32::try_from(counted(first, step)?).ok()?;
            Some(Term::Same(Operand::Source(Source { argument, index })))
        }
        term => Some(term),
    }
}
