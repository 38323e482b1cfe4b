//! Programs of the compiler as code for one register file: what is run at every evaluation.
//!
//! ```text
//! registers   [ arguments | constants | values that are computed, each register used again once its value is not needed any more ]
//! code        batches of operations of one kind:  Mul ×12, MulAdd ×9, …
//! ```
//! Which operation comes next is decided once a batch and not once an operation: among the operations whose operands are known, the kind
//! that most are of is taken, until none of it is left. The order of independent operations changes no bit of the result. The file has
//! 2¹⁶ registers, so that a number of 16 bits needs no check of bounds; the system gives memory only for those that are touched.

use crate::translate::{REGISTERS, Translated, Translator};
use linkwright_compiler::functions::{ARGUMENTS, Argument};
use linkwright_compiler::schedule::{Instruction, Operand, Program, Source};
use linkwright_compiler::symbolic::{Compare, Orders, Table, Unary};
use linkwright_runtime::Real;
use std::collections::HashMap;
use std::sync::{Arc, OnceLock};

/// All registers.
#[derive(Clone)]
pub struct Registers(Box<[f64; REGISTERS]>);

impl Registers {
    /// Zeros, and the constants of these places.
    pub fn new(places: &Places) -> Self {
        let zeros: Box<[f64]> = vec![0.0; REGISTERS].into();
        let mut registers = Registers(zeros.try_into().expect("as many as it has"));
        for (at, value) in places.constants() {
            registers.0[usize::from(at)] = value;
        }
        registers
    }

    /// Writes the entries of an argument.
    #[inline]
    pub fn set(&mut self, at: u16, values: &[f64]) {
        // Many mechanisms have no inputs and no internal states.
        if !values.is_empty() {
            let at = usize::from(at);
            copy(values, &mut self.0[at..at + values.len()]);
        }
    }
}

/// Copies a list, which most often is so short that a call of what copies costs more than the copy.
#[inline(always)]
fn copy(from: &[f64], to: &mut [f64]) {
    match from.len() {
        0 => {}
        1 => both_ends::<1>(from, to),
        2..4 => both_ends::<2>(from, to),
        4..8 => both_ends::<4>(from, to),
        8..=16 => both_ends::<8>(from, to),
        _ => to.copy_from_slice(from),
    }
}

/// Copies the first and the last N entries of a list of N to 2N, whose middle is in both.
#[inline(always)]
fn both_ends<const N: usize>(from: &[f64], to: &mut [f64]) {
    if let (Some(from), Some(to)) = (from.first_chunk::<N>(), to.first_chunk_mut()) {
        *to = *from;
    }
    if let (Some(from), Some(to)) = (from.last_chunk::<N>(), to.last_chunk_mut()) {
        *to = *from;
    }
}

/// A mechanism needs more registers than there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooLarge {
    pub registers: usize,
}

/// Where arguments and constants stand, the same for all functions of a mechanism.
pub struct Places {
    /// In the order of [`ARGUMENTS`].
    arguments: [u16; ARGUMENTS.len()],
    constants: HashMap<u64, u16>,
    /// The first register that is for values.
    free: usize,
}

impl Places {
    /// Of arguments of these lengths and of the constants of these programs.
    pub fn new<'p>(
        length: impl Fn(Argument) -> usize,
        programs: impl Iterator<Item = &'p Program>,
    ) -> Result<Places, TooLarge> {
        let mut places = Places { arguments: [0; ARGUMENTS.len()], constants: HashMap::new(), free: 0 };
        for (at, given) in places.arguments.iter_mut().zip(&ARGUMENTS) {
            *at = register(places.free)?;
            places.free += length(given.argument);
        }
        for program in programs {
            let operands = program.instructions.iter().flat_map(Instruction::operands);
            for operand in operands.chain(program.outputs.iter().copied()) {
                if let Operand::Constant(value) = operand
                    && !places.constants.contains_key(&value.to_bits())
                {
                    places.constants.insert(value.to_bits(), register(places.free)?);
                    places.free += 1;
                }
            }
        }
        Ok(places)
    }

    /// The first register of an argument.
    pub fn of(&self, argument: Argument) -> u16 {
        self.arguments[argument as usize]
    }

    /// The register of an entry of an argument.
    pub fn register(&self, source: Source) -> u16 {
        self.of(source.argument) + source.index as u16
    }

    fn constants(&self) -> impl Iterator<Item = (u16, f64)> {
        self.constants.iter().map(|(bits, at)| (*at, f64::from_bits(*bits)))
    }
}

fn register(index: usize) -> Result<u16, TooLarge> {
    u16::try_from(index).map_err(|_| TooLarge { registers: index })
}

/// What a batch does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Neg,
    Add,
    Sub,
    Mul,
    /// Product negated, addend negated.
    MulAdd(bool, bool),
    Div,
    Unary(Unary),
    Min,
    Max,
    Atan2,
    Compare(Compare),
    And,
    Or,
    Not,
    Select,
    Cell(u16),
    Piece(u16, Orders),
    Patch(u16, Orders),
}

impl Kind {
    fn of(instruction: &Instruction) -> Kind {
        match *instruction {
            Instruction::Neg(_) => Kind::Neg,
            Instruction::Add(..) => Kind::Add,
            Instruction::Sub(..) => Kind::Sub,
            Instruction::Mul(..) => Kind::Mul,
            Instruction::MulAdd(_, _, _, product, addend) => Kind::MulAdd(product, addend),
            Instruction::Div(..) => Kind::Div,
            Instruction::Unary(function, _) => Kind::Unary(function),
            Instruction::Min(..) => Kind::Min,
            Instruction::Max(..) => Kind::Max,
            Instruction::Atan2(..) => Kind::Atan2,
            Instruction::Compare(comparison, ..) => Kind::Compare(comparison),
            Instruction::And(..) => Kind::And,
            Instruction::Or(..) => Kind::Or,
            Instruction::Not(_) => Kind::Not,
            Instruction::Select(..) => Kind::Select,
            Instruction::Cell(table, _) => Kind::Cell(table),
            Instruction::Piece(table, orders, ..) => Kind::Piece(table, orders),
            Instruction::Patch(table, orders, ..) => Kind::Patch(table, orders),
        }
    }
}

/// One operation of a batch: the register of the result, those of its operands.
#[derive(Clone, Copy, Debug, Default)]
struct Operation {
    to: u16,
    a: u16,
    b: u16,
    c: u16,
}

#[derive(Clone, Debug)]
struct Batch {
    kind: Kind,
    operations: Box<[Operation]>,
}

/// A function.
#[derive(Default)]
pub struct Code {
    batches: Vec<Batch>,
    outputs: Vec<u16>,
    tables: Vec<Arc<Table>>,
    machine: Option<Machine>,
}

/// A function as it is run by the processor itself, once it is called.
struct Machine {
    program: Program,
    translator: Arc<dyn Translator>,
    /// Nothing if the translator cannot: the function is interpreted.
    made: OnceLock<Option<Box<dyn Translated>>>,
    /// The first of its results, which stand one after another behind arguments and constants.
    results: u16,
}

/// In which registers results are.
pub enum Results<'c> {
    At(&'c [u16]),
    /// One after another.
    From(u16),
}

impl Results<'_> {
    /// Writes `count` of them to these lists, one after another, and zeros behind them; returns the one behind the lists, zero if there is
    /// none.
    #[inline]
    pub fn write(&self, registers: &Registers, count: usize, out: &mut [&mut [f64]]) -> f64 {
        match *self {
            Results::At(registers_of) => {
                let mut results = registers_of.iter().map(|at| registers.0[usize::from(*at)]);
                let entries = out.iter_mut().flat_map(|list| list.iter_mut());
                entries.for_each(|entry| *entry = results.next().unwrap_or(0.0));
                results.next().unwrap_or(0.0)
            }
            Results::From(first) => {
                let first = usize::from(first);
                // One by one: they have just been stored so, and a load of several of them at once would wait for the stores.
                let mut results = registers.0[first..first + count].iter();
                for list in out {
                    for entry in list.iter_mut() {
                        *entry = results.next().copied().unwrap_or(0.0);
                    }
                }
                results.next().copied().unwrap_or(0.0)
            }
        }
    }
}

impl Code {
    /// The code of a program.
    pub fn new(program: &Program, places: &Places) -> Result<Code, TooLarge> {
        let order = in_batches(program);
        let mut uses = vec![0u32; program.instructions.len()];
        let values = |operand: Operand| match operand {
            Operand::Value(value) => Some(value as usize),
            _ => None,
        };
        let operands = program.instructions.iter().flat_map(Instruction::operands);
        // What is given out is needed until the end: one use that nothing ends.
        operands.chain(program.outputs.iter().copied()).filter_map(values).for_each(|value| uses[value] += 1);
        let mut kept: Vec<u16> = vec![0; program.instructions.len()];
        let mut unused: Vec<u16> = Vec::new();
        let mut next = places.free;
        let mut batches = Vec::with_capacity(order.len());
        for (kind, members) in order {
            let mut operations = Vec::with_capacity(members.len());
            for member in members {
                let mut operands = [0u16; 3];
                for (place, operand) in operands.iter_mut().zip(program.instructions[member].operands()) {
                    *place = at(operand, places, &kept);
                    if let Some(value) = values(operand) {
                        uses[value] -= 1;
                        if uses[value] == 0 {
                            unused.push(*place);
                        }
                    }
                }
                let to = match unused.pop() {
                    Some(to) => to,
                    None => {
                        next += 1;
                        register(next - 1)?
                    }
                };
                kept[member] = to;
                if uses[member] == 0 {
                    unused.push(to);
                }
                let [a, b, c] = operands;
                operations.push(Operation { to, a, b, c });
            }
            batches.push(Batch { kind, operations: operations.into() });
        }
        let outputs = program.outputs.iter().map(|output| at(*output, places, &kept)).collect();
        Ok(Code { batches, outputs, tables: program.tables.clone(), machine: None })
    }

    /// The same function, translated when it is first called.
    pub fn translated_by(
        self,
        translator: &Arc<dyn Translator>,
        program: &Program,
        places: &Places,
    ) -> Result<Code, TooLarge> {
        register(places.free + program.outputs.len())?;
        let results = register(places.free)?;
        let (program, translator) = (program.clone(), translator.clone());
        let machine = Some(Machine { program, translator, made: OnceLock::new(), results });
        Ok(Code { machine, ..self })
    }

    /// How many results it has.
    pub fn outputs(&self) -> usize {
        self.outputs.len()
    }

    /// Computes the results from the arguments in the registers.
    #[inline]
    pub fn run(&self, registers: &mut Registers, places: &Places) -> Results<'_> {
        if let Some(machine) = &self.machine
            && let Some(translated) = machine.translated(places)
        {
            translated.run(&mut registers.0);
            return Results::From(machine.results);
        }
        self.interpret(registers);
        Results::At(&self.outputs)
    }

    #[inline(never)]
    fn interpret(&self, registers: &mut Registers) {
        let r: &mut [f64; REGISTERS] = &mut registers.0;
        for Batch { kind, operations } in &self.batches {
            /// The same of every operation, in a loop of its own.
            macro_rules! each {
                (|$a:ident| $value:expr) => {
                    for &Operation { to, a, .. } in operations {
                        let $a = r[usize::from(a)];
                        r[usize::from(to)] = $value;
                    }
                };
                (|$a:ident, $b:ident| $value:expr) => {
                    for &Operation { to, a, b, .. } in operations {
                        let ($a, $b) = (r[usize::from(a)], r[usize::from(b)]);
                        r[usize::from(to)] = $value;
                    }
                };
                (|$a:ident, $b:ident, $c:ident| $value:expr) => {
                    for &Operation { to, a, b, c } in operations {
                        let ($a, $b, $c) = (r[usize::from(a)], r[usize::from(b)], r[usize::from(c)]);
                        r[usize::from(to)] = $value;
                    }
                };
            }
            let mask = |holds: bool| if holds { 1.0 } else { 0.0 };
            let table = |number: u16| &self.tables[usize::from(number)];
            match *kind {
                Kind::Neg => each!(|a| -a),
                Kind::Add => each!(|a, b| a + b),
                Kind::Sub => each!(|a, b| a - b),
                Kind::Mul => each!(|a, b| a * b),
                Kind::MulAdd(false, false) => each!(|a, b, c| Real::mul_add(a, b, c)),
                Kind::MulAdd(false, true) => each!(|a, b, c| Real::mul_add(a, b, -c)),
                Kind::MulAdd(true, false) => each!(|a, b, c| Real::mul_add(-a, b, c)),
                Kind::MulAdd(true, true) => each!(|a, b, c| Real::mul_add(-a, b, -c)),
                Kind::Div => each!(|a, b| a / b),
                Kind::Unary(Unary::Reciprocal) => each!(|a| 1.0 / a),
                Kind::Unary(Unary::Sqrt) => each!(|a| a.sqrt()),
                Kind::Unary(Unary::Abs) => each!(|a| a.abs()),
                Kind::Unary(function) => each!(|a| function.value(a)),
                Kind::Min => each!(|a, b| Real::min(a, b)),
                Kind::Max => each!(|a, b| Real::max(a, b)),
                Kind::Atan2 => each!(|a, b| Real::atan2(a, b)),
                Kind::Compare(comparison) => each!(|a, b| mask(comparison.value(a, b))),
                Kind::And => each!(|a, b| mask(a != 0.0 && b != 0.0)),
                Kind::Or => each!(|a, b| mask(a != 0.0 || b != 0.0)),
                Kind::Not => each!(|a| mask(a == 0.0)),
                Kind::Select => each!(|m, a, b| if m != 0.0 { a } else { b }),
                Kind::Cell(number) => each!(|x| table(number).cell(x)),
                Kind::Piece(number, orders) => {
                    each!(|cell, x| table(number).piece(orders.first(), cell, x));
                }
                Kind::Patch(number, orders) => each!(|cell, x, y| table(number).patch(orders, cell, x, y)),
            }
        }
    }
}

impl Machine {
    fn translated(&self, places: &Places) -> Option<&dyn Translated> {
        let register = |operand| match operand {
            Operand::Source(source) => Some(places.register(source)),
            Operand::Constant(value) => places.constants.get(&value.to_bits()).copied(),
            Operand::Value(_) => None,
        };
        let make = || self.translator.translate(&self.program, &register, self.results);
        self.made.get_or_init(make).as_deref()
    }
}

fn at(operand: Operand, places: &Places, kept: &[u16]) -> u16 {
    match operand {
        Operand::Constant(value) => places.constants[&value.to_bits()],
        Operand::Source(source) => places.register(source),
        Operand::Value(value) => kept[value as usize],
    }
}

/// The instructions by batches, each after those whose results it needs.
fn in_batches(program: &Program) -> Vec<(Kind, Vec<usize>)> {
    let count = program.instructions.len();
    let mut users: Vec<Vec<usize>> = vec![Vec::new(); count];
    let mut missing = vec![0u32; count];
    for (user, instruction) in program.instructions.iter().enumerate() {
        for operand in instruction.operands() {
            if let Operand::Value(value) = operand {
                users[value as usize].push(user);
                missing[user] += 1;
            }
        }
    }
    let kinds: Vec<Kind> = program.instructions.iter().map(Kind::of).collect();
    // There are few kinds; in the order in which they are met, so that the code of a program is always the same.
    let mut ready: Vec<(Kind, Vec<usize>)> = Vec::new();
    let add = |ready: &mut Vec<(Kind, Vec<usize>)>, member: usize| match ready
        .iter_mut()
        .find(|(kind, _)| *kind == kinds[member])
    {
        Some((_, members)) => members.push(member),
        None => ready.push((kinds[member], vec![member])),
    };
    (0..count).filter(|member| missing[*member] == 0).for_each(|member| add(&mut ready, member));
    let mut batches = Vec::new();
    while let Some((kind, members)) =
        ready.iter_mut().max_by_key(|(_, members)| members.len()).filter(|(_, members)| !members.is_empty())
    {
        let (kind, mut batch) = (*kind, std::mem::take(members));
        let mut index = 0;
        // What becomes possible by an operation of the batch, and is of its kind, joins it.
        while index < batch.len() {
            for &user in &users[batch[index]] {
                missing[user] -= 1;
                match missing[user] {
                    0 if kinds[user] == kind => batch.push(user),
                    0 => add(&mut ready, user),
                    _ => {}
                }
            }
            index += 1;
        }
        batches.push((kind, batch));
    }
    batches
}

#[cfg(test)]
mod tests {
    use super::*;
    use linkwright_compiler::schedule::{Inputs, run_straight};

    /// A program of 300 operations that need one another gives the bits of the compiler's interpreter, in fewer registers than values.
    #[test]
    fn registers_are_used_again() {
        let mut instructions = vec![Instruction::Mul(source(0), source(1))];
        for index in 1..300u32 {
            let (before, other) = (Operand::Value(index - 1), Operand::Value(index / 2));
            instructions.push(match index % 5 {
                0 => Instruction::Add(before, other),
                1 => Instruction::Unary(Unary::Sin, before),
                2 => Instruction::MulAdd(before, Operand::Constant(0.5), source(1), true, false),
                3 => Instruction::Sub(other, before),
                _ => Instruction::Unary(Unary::Cos, other),
            });
        }
        let outputs = vec![Operand::Value(299), Operand::Constant(3.0), source(0), Operand::Value(150)];
        let program = Program { instructions, outputs, ..Program::default() };
        let inputs = Inputs { q: vec![0.3, -1.7], ..Inputs::default() };
        let length = |argument| if argument == Argument::Q { 2 } else { 0 };
        let places = Places::new(length, [&program].into_iter()).expect("few");
        let code = Code::new(&program, &places).expect("few");
        let mut registers = Registers::new(&places);
        registers.set(places.of(Argument::Q), &inputs.q);
        let mut found = vec![0.0; code.outputs()];
        code.run(&mut registers, &places).write(&registers, found.len(), &mut [&mut found]);
        assert_eq!(found, run_straight(&program, &inputs));
        let operations = code.batches.iter().flat_map(|batch| batch.operations.iter());
        let most = operations.map(|operation| usize::from(operation.to)).max().expect("some");
        assert!(most < 200, "{most}");
    }

    fn source(index: u32) -> Operand {
        Operand::Source(Source { argument: Argument::Q, index })
    }

    /// More values at once than there are registers are refused.
    #[test]
    fn too_many_values() {
        let many = 70_000;
        let mut instructions: Vec<Instruction> =
            (0..many).map(|_| Instruction::Unary(Unary::Sin, source(0))).collect();
        let sum = |index: u32| {
            let before = if index == 0 { Operand::Value(0) } else { Operand::Value(many + index - 1) };
            Instruction::Add(before, Operand::Value(index))
        };
        instructions.extend((0..many).map(sum));
        let program =
            Program { instructions, outputs: vec![Operand::Value(2 * many - 1)], ..Program::default() };
        let places = Places::new(|_| 1, [&program].into_iter()).expect("few");
        assert_eq!(Code::new(&program, &places).err(), Some(TooLarge { registers: 1 << 16 }));
    }
}
