//! Programs with loops as text: what stands once for many rounds, and what stands straight between.
//!
//! ```text
//! const N0: [f64; 38] = [0.5, 0.75, …];
//! let mut s0 = [R::ZERO; 39];
//! s0[0] = a12;
//! let mut c0_1 = a12;
//! for i in 0..38 {
//!     let b0 = q[2 * i + 3] * q[2 * i + 80];
//!     let b1 = R::from_f64(N0[i]).mul_add(c0_1, b0);
//!     s0[i + 1] = b1;
//!     a_out[3 * i + 4] = b1;
//!     c0_1 = b1;
//! }
//! for i in 0..40 {
//!     lambda_out[2 * i] = R::ZERO;
//! }
//! a_out[0] = a14;
//! ```

use super::dialect::Dialect;
use super::names::push_numbered;
use super::printer::Writer;
use crate::functions::Argument;
use crate::schedule::{Carried, List, Operand, Result, Rolled, RolledLoop, Term};
use std::collections::BTreeSet;
use std::fmt::Write;

/// A program with loops while it is written.
struct Loops<'a, D> {
    writer: &'a Writer<'a, D>,
    rolled: &'a Rolled,
    /// The results by groups.
    groups: Vec<List>,
}

impl<D: Dialect> Writer<'_, D> {
    /// Everything, lists of results included; what it reads, and the results that are in no list as expressions.
    pub(super) fn rolled(&self, text: &mut String, rolled: &Rolled) -> (BTreeSet<Argument>, Vec<String>) {
        let complete = &self.printer.compiled.complete;
        let groups = List::groups(self.signature, complete, &self.program.outputs);
        let loops = Loops { writer: self, rolled, groups };
        let reads = loops.declarations(text);
        let mut from = 0;
        for known in &rolled.loops {
            loops.straight(text, from, known.of.start);
            loops.rounds(text, known);
            from = known.of.end();
        }
        loops.straight(text, from, self.program.instructions.len());
        loops.copies(text);
        (reads, loops.values())
    }
}

impl<D: Dialect> Loops<'_, D> {
    fn dialect(&self) -> &D {
        &self.writer.printer.dialect
    }

    /// The results that are in no list.
    fn numbers(&self) -> impl Iterator<Item = usize> {
        let results = self.writer.signature.results.iter().zip(&self.groups);
        results.filter(|(group, _)| !group.shape.is_list()).flat_map(|(_, own)| own.start..own.end)
    }

    /// Arguments, tables, arrays and lists of results; what is read.
    fn declarations(&self, text: &mut String) -> BTreeSet<Argument> {
        let Loops { writer, rolled, .. } = self;
        let program = writer.program;
        let mut used: Vec<Operand> = Vec::new();
        let mut from = 0;
        let ends = rolled.loops.iter().map(|known| (known.of.start, known.of.end()));
        for (start, end) in ends.chain([(program.instructions.len(), 0)]) {
            used.extend(
                program.instructions[from..start].iter().flat_map(|instruction| instruction.operands()),
            );
            from = end;
        }
        let terms = rolled.loops.iter().flat_map(|known| known.terms.iter().flatten());
        let copied = rolled.copies.iter().flat_map(|copies| copies.results.iter().map(|(_, term)| term));
        let mut reads = BTreeSet::new();
        for term in terms.chain(copied) {
            match term {
                Term::Same(operand) => used.push(*operand),
                // These are read where they are taken.
                Term::Entry { argument, .. } => {
                    reads.insert(*argument);
                }
                _ => {}
            }
        }
        for known in &rolled.loops {
            used.extend(known.before.iter().map(|(_, _, operand)| *operand));
            used.extend(known.carried.iter().flat_map(|carried| &carried.early).copied());
        }
        used.extend(rolled.alone.iter().copied().chain(self.numbers()).map(|result| program.outputs[result]));
        let loaded = writer.loads(text, used.into_iter(), &writer.names);
        reads.extend(loaded.iter().map(|source| source.argument));
        for (number, table) in rolled.tables.iter().enumerate() {
            self.dialect().table(text, number, table);
        }
        for (array, length) in rolled.arrays.iter().enumerate() {
            self.dialect().array(text, &format!("s{array}"), *length);
        }
        self.dialect().results(text, writer.signature);
        reads
    }

    fn straight(&self, text: &mut String, from: usize, to: usize) {
        for (index, instruction) in self.writer.program.instructions[from..to].iter().enumerate() {
            let [before, between, behind] = self.dialect().declaration(instruction.is_mask());
            text.push_str(before);
            self.writer.names.push_value(text, (from + index) as u32);
            text.push_str(between);
            self.writer.spelled(text, instruction, instruction.operands(), |text, operand| {
                self.operand(text, operand)
            });
            text.push_str(behind);
        }
    }

    fn rounds(&self, text: &mut String, known: &RolledLoop) {
        for (array, entry, operand) in &known.before {
            let _ = write!(text, "s{array}[{entry}] = ");
            self.operand(text, *operand);
            text.push_str(";\n");
        }
        for Carried { number, early, .. } in &known.carried {
            for (rounds, operand) in early.iter().enumerate() {
                self.dialect().variable(text, &carried(*number, rounds + 1));
                self.operand(text, *operand);
                text.push_str(";\n");
            }
        }
        self.dialect().rounds(text, known.of.rounds);
        for (index, (terms, kept)) in known.terms.iter().zip(&known.kept).enumerate() {
            let instruction = &self.writer.program.instructions[known.of.start + index];
            let [before, between, behind] = self.dialect().declaration(instruction.is_mask());
            text.push_str(before);
            push_numbered(text, 'b', index as u32);
            text.push_str(between);
            self.writer.spelled(text, instruction, terms.iter(), |text, term| {
                self.term(text, *term, &known.carried)
            });
            text.push_str(behind);
            if let Some((array, first)) = kept {
                let _ = writeln!(text, "s{array}[{}] = b{index};", counted(*first, 1));
            }
            for result in &known.results[index] {
                self.result(text, *result);
                let _ = writeln!(text, " = b{index};");
            }
        }
        for Carried { index, number, early } in &known.carried {
            for rounds in (2..=early.len()).rev() {
                let _ = writeln!(text, "{} = {};", carried(*number, rounds), carried(*number, rounds - 1));
            }
            let _ = writeln!(text, "{} = b{index};", carried(*number, 1));
        }
        self.dialect().end_of_rounds(text);
    }

    /// The results that no loop has written.
    fn copies(&self, text: &mut String) {
        for copies in &self.rolled.copies {
            self.dialect().rounds(text, copies.rounds);
            for (result, term) in &copies.results {
                self.result(text, *result);
                text.push_str(" = ");
                self.term(text, *term, &[]);
                text.push_str(";\n");
            }
            self.dialect().end_of_rounds(text);
        }
        for result in &self.rolled.alone {
            self.result(text, Result { first: *result, step: 0 });
            text.push_str(" = ");
            self.operand(text, self.writer.program.outputs[*result]);
            text.push_str(";\n");
        }
    }

    /// The results that are in no list, as expressions, in the places of all.
    fn values(&self) -> Vec<String> {
        let outputs = &self.writer.program.outputs;
        let mut values = vec![String::new(); outputs.len()];
        for result in self.numbers() {
            self.operand(&mut values[result], outputs[result]);
        }
        values
    }

    /// Where a result stands.
    fn result(&self, text: &mut String, Result { first, step }: Result) {
        let group = self.groups.partition_point(|group| group.end <= first);
        let Some(List { start, width, .. }) = self.groups.get(group) else { return };
        let (entry, place) = ((first - start) / width, (first - start) % width);
        let shape = self.writer.signature.results[group].shape;
        let space = self.writer.printer.compiled.mechanism.space;
        let places = shape.record().map(|record| record.of(space).places());
        let place = places.map_or(String::new(), |places| places[place].clone());
        let at = counted(entry, step / *width as i64);
        self.dialect().result(text, self.writer.signature, group, &at, &place);
    }

    fn term(&self, text: &mut String, term: Term, of_loop: &[Carried]) {
        match term {
            Term::Same(operand) => self.operand(text, operand),
            Term::Number(table) => self.dialect().number(text, table, "i"),
            Term::Own(index) => push_numbered(text, 'b', index as u32),
            Term::Before { index, rounds } => {
                let number =
                    of_loop.iter().find(|known| known.index == index).map_or(0, |known| known.number);
                text.push_str(&carried(number, rounds));
            }
            Term::Entry { argument, first, step } => {
                let within = self.writer.signature.within(argument);
                self.dialect().entry(text, within, argument, &counted(first, step));
            }
            Term::Kept { array, first, step } => {
                let _ = write!(text, "s{array}[{}]", counted(first, step));
            }
        }
    }

    /// An operand where it stands straight, or is the same in all rounds.
    fn operand(&self, text: &mut String, operand: Operand) {
        match operand {
            Operand::Value(value) if let Some((array, entry)) = self.rolled.place(value) => {
                let _ = write!(text, "s{array}[{entry}]");
            }
            Operand::Value(value) if let Some(number) = self.rolled.carried(value) => {
                text.push_str(&carried(number, 1));
            }
            operand => self.writer.operand(text, operand, &self.writer.names),
        }
    }
}

/// What goes from round to round, so many rounds before.
fn carried(number: usize, rounds: usize) -> String {
    format!("c{number}_{rounds}")
}

/// `first + step i`.
fn counted(first: usize, step: i64) -> String {
    let rounds = match step.unsigned_abs() {
        0 => return first.to_string(),
        1 => "i".to_string(),
        many => format!("{many} * i"),
    };
    match (first, step) {
        (first, ..0) => format!("{first} - {rounds}"),
        (0, _) => rounds,
        (first, _) => format!("{rounds} + {first}"),
    }
}
