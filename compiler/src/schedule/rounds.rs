//! The interpreter of programs with loops: round by round, with the arrays that the emitted code has.

use super::evaluate::{Inputs, step};
use super::program::{Operand, Program, Source};
use super::repetition::{Rolled, RolledLoop, Term};
use std::collections::VecDeque;

/// What is there of a program with loops.
struct Rounds<'a> {
    program: &'a Program,
    rolled: &'a Rolled,
    inputs: &'a Inputs,
    /// Of straight instructions, by index, and of those that are carried in the last round; of others nothing.
    values: Vec<f64>,
    arrays: Vec<Vec<f64>>,
    results: Vec<f64>,
}

/// Outputs of a program, unfused, by its loops.
pub fn run(program: &Program, rolled: &Rolled, inputs: &Inputs) -> Vec<f64> {
    let mut rounds = Rounds {
        program,
        rolled,
        inputs,
        values: vec![f64::NAN; program.instructions.len()],
        arrays: rolled.arrays.iter().map(|length| vec![f64::NAN; *length]).collect(),
        results: vec![f64::NAN; program.outputs.len()],
    };
    let mut from = 0;
    for known in &rolled.loops {
        rounds.straight(from, known.of.start);
        rounds.rounds(known);
        from = known.of.end();
    }
    rounds.straight(from, program.instructions.len());
    rounds.results();
    rounds.results
}

impl Rounds<'_> {
    fn straight(&mut self, from: usize, to: usize) {
        for index in from..to {
            let instruction = &self.program.instructions[index];
            self.values[index] = step(instruction, &self.program.tables, |operand| self.get(operand));
        }
    }

    fn rounds(&mut self, known: &RolledLoop) {
        for (array, entry, operand) in &known.before {
            self.arrays[*array][*entry] = self.get(*operand);
        }
        let mut carried: Vec<VecDeque<f64>> = known
            .carried
            .iter()
            .map(|known| known.early.iter().map(|operand| self.get(*operand)).collect())
            .collect();
        for round in 0..known.of.rounds {
            let mut own: Vec<f64> = Vec::with_capacity(known.of.length);
            for (index, terms) in known.terms.iter().enumerate() {
                let mut terms = terms.iter();
                let value = |term: &Term| match term {
                    Term::Before { index, rounds } => {
                        let which = known.carried.iter().position(|known| known.index == *index);
                        which.map_or(f64::NAN, |which| carried[which][rounds - 1])
                    }
                    term => self.term(*term, round, &own),
                };
                let operand = |_| Operand::Constant(terms.next().map_or(f64::NAN, value));
                let instruction = self.program.instructions[known.of.start + index].map(operand);
                let value = step(&instruction, &self.program.tables, |operand| self.get(operand));
                own.push(value);
                if let Some((array, first)) = known.kept[index] {
                    self.arrays[array][first + round] = value;
                }
                for result in &known.results[index] {
                    self.results[result.in_round(round)] = value;
                }
            }
            for (values, known) in carried.iter_mut().zip(&known.carried) {
                values.push_front(own[known.index]);
                values.pop_back();
            }
        }
        // Those of the last round can be taken where they are.
        let last = known.of.end() - known.of.length;
        for (values, known) in carried.iter().zip(&known.carried) {
            self.values[last + known.index] = values[0];
        }
    }

    /// The results that no loop has written.
    fn results(&mut self) {
        for copies in &self.rolled.copies {
            for (result, term) in &copies.results {
                for round in 0..copies.rounds {
                    self.results[result.in_round(round)] = self.term(*term, round, &[]);
                }
            }
        }
        for result in self.rolled.unwritten(self.program) {
            self.results[result] = self.get(self.program.outputs[result]);
        }
    }

    fn term(&self, term: Term, round: usize, own: &[f64]) -> f64 {
        match term {
            Term::Same(operand) => self.get(operand),
            Term::Number(table) => self.rolled.tables[table][round],
            Term::Entry { argument, first, step } => {
                self.inputs.get(Source { argument, index: counted(first, step, round) as u32 })
            }
            Term::Own(index) => own[index],
            Term::Before { .. } => f64::NAN,
            Term::Kept { array, first, step } => self.arrays[array][counted(first, step, round)],
        }
    }

    fn get(&self, operand: Operand) -> f64 {
        match operand {
            Operand::Constant(value) => value,
            Operand::Source(source) => self.inputs.get(source),
            Operand::Value(value) => match self.rolled.place(value) {
                Some((array, entry)) => self.arrays[array][entry],
                None => self.values[value as usize],
            },
        }
    }
}

/// `first + step round`.
fn counted(first: usize, step: i64, round: usize) -> usize {
    (first as i64 + step * round as i64) as usize
}
