//! Programs as text, one declaration for each instruction, in any [`Dialect`].
//!
//! ```text
//! let crank_cos = q[0];
//! let a0 = crank_cos * coupler_cos;
//! let mass_crank = crank_sin.mul_add(coupler_sin, a0);
//! ```
//! Written out piece by piece: this is most of the text of an expansion, and a macro runs unoptimised. Text that is parsed
//! once is ten times faster to produce than token streams.

use super::dialect::Dialect;
use super::names::Names;
use crate::compiled::Compiled;
use crate::functions::{Argument, Function, Group, Interface, Shape, Signature};
use crate::schedule::{Cut, Instruction, Operand, Part, Program, Section, Source, count};
use std::collections::BTreeSet;

/// The body of a function and the helper functions it was cut into.
pub struct Body {
    /// Loads and instructions.
    pub statements: String,
    /// The results, as expressions over what was declared.
    pub outputs: Vec<String>,
    /// Whether the statements write the entries of lists among the results, whose expressions are empty then.
    pub placed: bool,
    /// Whether the statements name the constants of the prepared model.
    pub reads_constants: bool,
    /// Functions to be placed beside it.
    pub helpers: String,
    /// What the function and those beside it read.
    pub reads: BTreeSet<Argument>,
    /// How many operations it takes, those of helpers included.
    pub operations: usize,
}

/// Writes the programs of a mechanism.
pub struct Printer<'a, D> {
    pub compiled: &'a Compiled,
    pub dialect: D,
    names: Names,
    /// The cuts of each pair of solutions that has something in common.
    cuts: [Option<[Cut; 2]>; Function::SOLUTIONS.len()],
}

/// The prefixes of the names of the functions that both solutions of a pair call.
const COMMON: [&str; Function::SOLUTIONS.len()] = ["factored", "reduced"];

impl<'a, D: Dialect> Printer<'a, D> {
    pub fn new(compiled: &'a Compiled, dialect: D) -> Self {
        let programs = &compiled.programs;
        let names = Names::new(&compiled.complete, &compiled.hoisted, &dialect);
        let cut = |pair: usize| {
            let (functions, shared) = (Function::SOLUTIONS[pair], programs.shared[pair]);
            (shared > 0).then(|| Cut::of_pair(functions.map(|known| programs.get(known)), shared))
        };
        let cuts = std::array::from_fn(cut);
        Printer { compiled, dialect, names, cuts }
    }

    /// The program of a function.
    pub fn body(&self, function: Function) -> Body {
        let programs = &self.compiled.programs;
        let (program, signature) = (programs.get(function), function.signature());
        let alone;
        let pair = function.pair().filter(|pair| programs.shared[*pair] > 0);
        let of_pair = pair.and_then(|pair| {
            let own = Function::SOLUTIONS[pair].iter().position(|known| *known == function)?;
            Some(&self.cuts[pair].as_ref()?[own])
        });
        let cut = match of_pair {
            Some(cut) => cut,
            None => {
                alone = Cut::of(program);
                &alone
            }
        };
        Writer {
            printer: self,
            program,
            cut,
            names: self.names.with_results(
                signature,
                &program.outputs,
                &self.labels(signature),
                &self.dialect,
            ),
            signature,
            pair,
            shared: pair.map_or(0, |pair| programs.shared[pair]),
        }
        .body()
    }

    /// What the results of a function are called in its body; nothing where they are numbered.
    fn labels(&self, signature: &Signature) -> Vec<Option<String>> {
        let Compiled { mechanism, complete, .. } = self.compiled;
        let of_group = |group: &Group| -> Vec<Option<String>> {
            match group.label {
                Some(label) => {
                    let names = group.shape.names(mechanism, &complete.equations).into_iter();
                    names.map(|name| Some(label.replace("{}", &name))).collect()
                }
                None => vec![None; (group.nodes)(complete).len()],
            }
        };
        signature.results.iter().flat_map(of_group).collect()
    }

    /// Where an entry of an argument is read in a function.
    pub fn entry(&self, text: &mut String, signature: &Signature, source: Source) {
        let within = signature.within(source.argument);
        let index = source.index.to_string();
        let at = match source.argument.given().shape {
            Shape::Parameters | Shape::Inputs => self.names.identifier(source),
            _ => &index,
        };
        self.dialect.entry(text, within, source.argument, at);
    }
}

/// One function while it is written.
pub(super) struct Writer<'a, D> {
    pub(super) printer: &'a Printer<'a, D>,
    pub(super) program: &'a Program,
    cut: &'a Cut,
    pub(super) names: Names,
    pub(super) signature: &'static Signature,
    /// The pair of solutions that it has something in common with.
    pair: Option<usize>,
    /// Instructions in common with the other of its pair, whose parts are written once and without the names of results.
    shared: usize,
}

impl<D: Dialect> Writer<'_, D> {
    fn body(&self) -> Body {
        let dialect = &self.printer.dialect;
        let (mut statements, mut helpers) = (String::new(), String::new());
        let Some((last, before)) = self.cut.parts.split_last() else {
            return Body {
                statements,
                outputs: Vec::new(),
                placed: false,
                reads_constants: false,
                helpers,
                reads: BTreeSet::new(),
                operations: 0,
            };
        };
        // Each instruction is one operation, but for those of tables.
        let operations = match self.program.tables.as_slice() {
            [] => self.program.instructions.len(),
            _ => count(self.program).total(),
        };
        self.header(&mut statements, operations);
        if let Some(rolled) = &self.program.rolled {
            let (reads, outputs) = self.rolled(&mut statements, rolled);
            let reads_constants = reads.contains(&Argument::Constants);
            return Body { statements, outputs, placed: true, reads_constants, helpers, reads, operations };
        }
        if !before.is_empty() {
            dialect.slots(&mut statements, self.cut.size);
        }
        let own = format!("{}_part", self.signature.name);
        for (index, part) in before.iter().enumerate() {
            let common = self.pair.filter(|_| part.end <= self.shared);
            let first = common.map_or(self.signature.function, |pair| Function::SOLUTIONS[pair][0]);
            let prefix = common.map_or(own.as_str(), |pair| COMMON[pair]);
            let arguments = first.signature().arguments;
            let name = format!("{prefix}_{index}");
            let own = self.reads(part);
            dialect.call(&mut statements, &name, arguments, &own);
            if first == self.signature.function {
                dialect.helper(&mut helpers, &name, arguments, &own, self.cut.size);
                let count = before.len() + 1;
                dialect.comment(
                    &mut helpers,
                    &format!("Part {} of {count} of `{}`.", index + 1, self.signature.name),
                );
                let names = if common.is_some() { &self.printer.names } else { &self.names };
                self.part(&mut helpers, part, &[], names);
                self.give(&mut helpers, part, names);
                dialect.end(&mut helpers);
            }
        }
        let used = self.part(&mut statements, last, &self.program.outputs, &self.names);
        let constants = used.iter().any(|source| source.argument == Argument::Constants);
        let output = |output: &Operand| {
            let mut text = String::new();
            match *output {
                Operand::Value(value) if (value as usize) < last.start => {
                    dialect.slot(&mut text, self.cut.slots[value as usize].unwrap_or(0));
                }
                operand => self.operand(&mut text, operand, &self.names),
            }
            text
        };
        let outputs = self.program.outputs.iter().map(output).collect();
        let reads_constants = constants || !before.is_empty();
        let before = before.iter().flat_map(|part| self.reads(part));
        let reads = used.iter().map(|source| source.argument).chain(before).collect();
        Body { outputs, placed: false, statements, reads_constants, helpers, reads, operations }
    }

    /// The arguments that a part reads.
    fn reads(&self, part: &Part) -> BTreeSet<Argument> {
        let instructions = &self.program.instructions[part.start..part.end];
        sources(operands(instructions)).map(|source| source.argument).collect()
    }

    /// What the function computes, where its documentation does not say so, and how many operations that takes.
    fn header(&self, text: &mut String, operations: usize) {
        let dialect = &self.printer.dialect;
        if self.signature.interface != Interface::Model {
            self.signature.doc.lines().for_each(|line| dialect.comment(text, line));
        }
        match operations {
            0 => {}
            1 => dialect.comment(text, "1 operation."),
            many => dialect.comment(text, &format!("{many} operations.")),
        }
    }

    /// Loads, values taken from the array, and instructions of one part; what is loaded.
    fn part(&self, text: &mut String, part: &Part, outputs: &[Operand], names: &Names) -> BTreeSet<Source> {
        let instructions = &self.program.instructions[part.start..part.end];
        let used = self.loads(text, operands(instructions).chain(outputs.iter().copied()), names);
        for (value, slot) in &part.taken {
            let mask = self.is_mask(*value);
            let ([before, between, behind], [open, close]) =
                (self.printer.dialect.declaration(mask), self.printer.dialect.taken(mask));
            text.push_str(before);
            names.push_value(text, *value as u32);
            text.push_str(between);
            text.push_str(open);
            self.printer.dialect.slot(text, *slot);
            text.push_str(close);
            text.push_str(behind);
        }
        let mut sections = self.sections(part).iter().peekable();
        for (offset, instruction) in instructions.iter().enumerate() {
            let index = part.start + offset;
            if let Some(section) = sections.next_if(|section| section.start == index) {
                self.printer.dialect.comment(text, &section.title);
            }
            let [before, between, behind] = self.printer.dialect.declaration(instruction.is_mask());
            text.push_str(before);
            names.push_value(text, index as u32);
            text.push_str(between);
            self.expression(text, instruction, names);
            text.push_str(behind);
        }
        used
    }

    /// What other parts need, into the array.
    fn give(&self, text: &mut String, part: &Part, names: &Names) {
        for (value, slot) in &part.given {
            let [open, close] = self.printer.dialect.given(self.is_mask(*value));
            self.printer.dialect.slot(text, *slot);
            text.push_str(open);
            names.push_value(text, *value as u32);
            text.push_str(close);
        }
    }

    /// The sections that begin in a part, where the program has several.
    fn sections(&self, part: &Part) -> &[Section] {
        let sections = &self.program.sections;
        if sections.len() < 2 {
            return &[];
        }
        let before = |end: usize| sections.partition_point(|section| section.start < end);
        &sections[before(part.start)..before(part.end)]
    }

    fn is_mask(&self, value: usize) -> bool {
        self.program.instructions[value].is_mask()
    }

    /// A declaration for every source among the operands.
    pub(super) fn loads(
        &self,
        text: &mut String,
        operands: impl Iterator<Item = Operand>,
        names: &Names,
    ) -> BTreeSet<Source> {
        let used: BTreeSet<Source> = sources(operands).collect();
        for source in &used {
            // A number is an argument itself.
            if matches!(source.argument.given().shape, Shape::Scalar) {
                continue;
            }
            let [before, between, behind] = self.printer.dialect.declaration(false);
            text.push_str(before);
            names.push_source(text, *source);
            text.push_str(between);
            self.printer.entry(text, self.signature, *source);
            text.push_str(behind);
        }
        used
    }

    pub(super) fn operand(&self, text: &mut String, operand: Operand, names: &Names) {
        match operand {
            Operand::Constant(value) => self.printer.dialect.constant(text, value),
            Operand::Source(source) => names.push_source(text, source),
            Operand::Value(index) => names.push_value(text, index),
        }
    }

    fn expression(&self, text: &mut String, instruction: &Instruction, names: &Names) {
        let instruction = with_signs_in_constants(*instruction);
        self.spelled(text, &instruction, instruction.operands(), |text, operand| {
            self.operand(text, operand, names)
        });
    }

    /// An operation on what stands for its operands.
    pub(super) fn spelled<T>(
        &self,
        text: &mut String,
        instruction: &Instruction,
        operands: impl Iterator<Item = T>,
        write: impl Fn(&mut String, T),
    ) {
        if instruction.table().is_some() {
            self.printer.dialect.look_up(text, &self.program.tables, instruction);
        }
        let spelling = self.printer.dialect.operation(instruction);
        let mut texts = spelling.iter();
        let mut between = |text: &mut String| text.push_str(texts.next().unwrap_or(&""));
        for operand in operands {
            between(text);
            write(text, operand);
        }
        between(text);
    }
}

fn operands(instructions: &[Instruction]) -> impl Iterator<Item = Operand> {
    instructions.iter().flat_map(|instruction| instruction.operands())
}

/// What these name that no instruction computes.
fn sources(operands: impl Iterator<Item = Operand>) -> impl Iterator<Item = Source> {
    operands.filter_map(|operand| match operand {
        Operand::Source(source) => Some(source),
        _ => None,
    })
}

/// The same with the sign of a product or of an addend in a constant, where there is one.
fn with_signs_in_constants(instruction: Instruction) -> Instruction {
    let Instruction::MulAdd(a, b, c, minus_product, minus_addend) = instruction else { return instruction };
    let (a, b) = if matches!(b, Operand::Constant(_)) { (b, a) } else { (a, b) };
    let signed = |operand: Operand, minus: bool| match operand {
        Operand::Constant(value) if minus => (Operand::Constant(-value), false),
        operand => (operand, minus),
    };
    let ((a, minus_product), (c, minus_addend)) = (signed(a, minus_product), signed(c, minus_addend));
    Instruction::MulAdd(a, b, c, minus_product, minus_addend)
}
