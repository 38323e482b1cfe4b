//! Function bodies: a program as Rust text, one `let` per instruction.
//!
//! ```text
//! let [crank_cos, crank_sin, …] = *q;
//! let a0 = crank_cos * coupler_cos;
//! let a1 = crank_sin.mul_add(coupler_sin, a0);
//! *mass = [f(1.3333333333333333), a1, …];
//! ```
//! Text that is parsed once is ten times faster to produce than token streams.

use super::Emitter;
use super::names::Names;
use crate::functions::Argument;
use crate::schedule::{Instruction, LONG, Operand, Program, Source, last_uses, live};
use crate::symbolic::Unary;
use std::collections::BTreeSet;
use std::fmt::Write;

/// About how many instructions of a program that is cut go into one function.
const STRETCH: usize = 500;

/// The body of a function and the helper functions it was cut into.
pub struct Body {
    /// Loads, instructions; the outputs' expressions are given apart.
    pub statements: String,
    pub outputs: Vec<String>,
    /// Whether the statements name the constants of the prepared model.
    pub reads_constants: bool,
    /// Items to be placed beside the function.
    pub helpers: String,
}

/// The beginning that a program has in common with another.
pub struct Front<'a> {
    /// Instructions in common.
    pub length: usize,
    /// Names in the helper functions it is cut into, and the prefix of theirs.
    pub names: &'a Names,
    pub helper: &'a str,
    /// Whether its helper functions are to be written: by one of the two.
    pub write: bool,
}

/// Writes a program. `helper` is the prefix of the names of helper functions.
pub fn body(
    program: &Program,
    cut: &Cut,
    emitter: &Emitter,
    names: &Names,
    helper: &str,
    front: Option<&Front>,
) -> Body {
    let mut statements = String::new();
    let mut helpers = String::new();
    let size = cut.size;
    if cut.parts.len() > 1 {
        let _ = writeln!(statements, "let mut w = [R::ZERO; {size}];");
    }
    let Some((last, before)) = cut.parts.split_last() else {
        return Body { statements, outputs: Vec::new(), reads_constants: false, helpers };
    };
    for (index, part) in before.iter().enumerate() {
        let front = front.filter(|front| part.end <= front.length);
        let (names, helper) = front.map_or((names, helper), |front| (front.names, front.helper));
        let _ = writeln!(statements, "{helper}_{index}({}, &mut w);", names.passed_on());
        if front.is_none_or(|front| front.write) {
            let _ = writeln!(
                helpers,
                "#[inline(never)] fn {helper}_{index}<R: Real>({}, w: &mut [R; {size}]) {{",
                names.declarations(emitter)
            );
            part_of(&mut helpers, program, part, &[], names);
            for (value, slot) in &part.given {
                let _ = write!(helpers, "w[{slot}] = ");
                names.push_value(&mut helpers, *value as u32);
                helpers.push_str(";\n");
            }
            helpers.push_str("}\n");
        }
    }
    let used = part_of(&mut statements, program, last, &program.outputs, names);
    let own = used.iter().any(|source| source.argument == Argument::Constants);
    let outputs = program.outputs.iter().map(|output| match output {
        Operand::Value(value) if (*value as usize) < last.start => {
            format!("w[{}]", cut.slots[*value as usize].unwrap_or(0))
        }
        _ => operand(*output, names),
    });
    let reads_constants = own || !before.is_empty();
    Body { outputs: outputs.collect(), statements, reads_constants, helpers }
}

/// A stretch of a program: instructions and the values that it takes from the array and gives to it, with their slots.
struct Part {
    start: usize,
    end: usize,
    taken: Vec<(usize, usize)>,
    given: Vec<(usize, usize)>,
}

/// A long program, cut where few values are live. Values that live on travel in an array.
pub struct Cut {
    parts: Vec<Part>,
    /// Entries of the array.
    size: usize,
    /// Where the values are after the last part but one.
    slots: Vec<Option<usize>>,
}

impl Cut {
    pub fn of(program: &Program) -> Cut {
        let count = program.instructions.len();
        if count <= LONG {
            let part = Part { start: 0, end: count, taken: Vec::new(), given: Vec::new() };
            return Cut { parts: vec![part], size: 0, slots: Vec::new() };
        }
        allot(program, 0, &last_uses(program))
    }

    /// Two programs whose first instructions are the same, `length` of them: in these both are cut alike.
    pub fn of_pair(programs: [&Program; 2], length: usize) -> [Cut; 2] {
        let [mut one, mut other] = programs.map(last_uses);
        for value in 0..length {
            // What either program needs later leaves the front of both.
            if one[value].max(other[value]) >= length {
                one[value] = one[value].max(length);
                other[value] = other[value].max(length);
            }
        }
        let mut cuts = [allot(programs[0], length, &one), allot(programs[1], length, &other)];
        let size = cuts[0].size.max(cuts[1].size);
        cuts.iter_mut().for_each(|cut| cut.size = size);
        cuts
    }
}

/// Where to cut: near the middles between what is equally long, and after the front.
fn places(count: usize, front: usize, last_use: &[usize]) -> Vec<usize> {
    let live = live(last_use);
    let mut cuts = vec![0];
    for (start, end) in [(0, front), (front, count)] {
        let parts = (end - start).div_ceil(STRETCH);
        for part in 1..parts {
            let (middle, reach) = (start + part * (end - start) / parts, (end - start) / parts / 3);
            let best = (middle - reach..=middle + reach).min_by_key(|cut| (live[*cut], *cut));
            cuts.extend(best);
        }
        if end > start {
            cuts.push(end);
        }
    }
    cuts
}

/// Parts, and where their values are. A value that leaves its part gets a slot, and keeps it until its last use.
fn allot(program: &Program, front: usize, last_use: &[usize]) -> Cut {
    let count = program.instructions.len();
    let cuts = places(count, front, last_use);
    let mut slots: Vec<Option<usize>> = vec![None; count];
    let mut free: BTreeSet<usize> = BTreeSet::new();
    let mut size = 0;
    let mut parts = Vec::new();
    let mut kept: Vec<usize> = Vec::new();
    for window in cuts.windows(2) {
        let (start, end) = (window[0], window[1]);
        let operands = program.instructions[start..end].iter().flat_map(|instruction| instruction.operands());
        let mut used: Vec<usize> = operands
            .filter_map(|operand| match operand {
                Operand::Value(value) if (value as usize) < start => Some(value as usize),
                _ => None,
            })
            .collect();
        used.sort_unstable();
        used.dedup();
        let taken = used.iter().filter_map(|value| Some((*value, slots[*value]?))).collect();
        let mut given = Vec::new();
        if end < count {
            let (living, dead) = kept.into_iter().partition(|value| last_use[*value] >= end);
            kept = living;
            let dead: Vec<usize> = dead;
            free.extend(dead.into_iter().filter_map(|value| slots[value]));
            for value in (start..end).filter(|value| last_use[*value] >= end) {
                let slot = free.pop_first().unwrap_or_else(|| {
                    size += 1;
                    size - 1
                });
                slots[value] = Some(slot);
                kept.push(value);
                given.push((value, slot));
            }
        }
        parts.push(Part { start, end, taken, given });
    }
    Cut { parts, size, slots }
}

/// Loads, values taken from the array, and instructions of one part; what is loaded.
fn part_of(
    text: &mut String,
    program: &Program,
    part: &Part,
    outputs: &[Operand],
    names: &Names,
) -> BTreeSet<Source> {
    let instructions = &program.instructions[part.start..part.end];
    let used = loads(text, instructions.iter(), outputs, names);
    for (value, slot) in &part.taken {
        text.push_str("let ");
        names.push_value(text, *value as u32);
        let _ = writeln!(text, " = w[{slot}];");
    }
    for (offset, instruction) in instructions.iter().enumerate() {
        statement(text, part.start + offset, instruction, names);
    }
    used
}

/// `let` for every source that the instructions or outputs name.
fn loads<'a>(
    text: &mut String,
    instructions: impl Iterator<Item = &'a Instruction>,
    outputs: &[Operand],
    names: &Names,
) -> BTreeSet<Source> {
    let mut used: BTreeSet<Source> = BTreeSet::new();
    let operands = instructions.flat_map(|instruction| instruction.operands());
    for operand in operands.chain(outputs.iter().copied()) {
        if let Operand::Source(source) = operand {
            used.insert(source);
        }
    }
    for source in &used {
        if let Some(place) = names.place(*source) {
            text.push_str("let ");
            names.push_source(text, *source);
            let _ = writeln!(text, " = {place};");
        }
    }
    used
}

fn statement(text: &mut String, index: usize, instruction: &Instruction, names: &Names) {
    text.push_str("let ");
    names.push_value(text, index as u32);
    text.push_str(" = ");
    expression(text, instruction, names);
    text.push_str(";\n");
}

fn operand(operand: Operand, names: &Names) -> String {
    let mut text = String::new();
    push(&mut text, operand, names);
    text
}

/// Appends an operand.
fn push(text: &mut String, operand: Operand, names: &Names) {
    match operand {
        Operand::Constant(value) => text.push_str(&constant(value)),
        Operand::Source(source) => names.push_source(text, source),
        Operand::Value(index) => names.push_value(text, index),
    }
}

/// Appends an operand with the other sign.
fn push_minus(text: &mut String, operand: Operand, names: &Names) {
    match operand {
        Operand::Constant(value) => text.push_str(&constant(-value)),
        _ => {
            text.push_str("(-");
            push(text, operand, names);
            text.push(')');
        }
    }
}

pub fn constant(value: f64) -> String {
    if value == 0.0 {
        "R::ZERO".to_string()
    } else if value == 1.0 {
        "R::ONE".to_string()
    } else {
        format!("R::from_f64({})", literal(value))
    }
}

/// A finite f64 as a literal that reads back to the same bits; infinities and NaN by name.
pub fn literal(value: f64) -> String {
    if value.is_finite() {
        format!("{value:?}")
    } else if value.is_nan() {
        "::core::primitive::f64::NAN".to_string()
    } else if value > 0.0 {
        "::core::primitive::f64::INFINITY".to_string()
    } else {
        "::core::primitive::f64::NEG_INFINITY".to_string()
    }
}

fn expression(text: &mut String, instruction: &Instruction, names: &Names) {
    // Written out piece by piece: this is most of the text of an expansion, and a macro runs unoptimised.
    let push = |text: &mut String, operand: Operand| push(text, operand, names);
    let infix = |text: &mut String, a: Operand, sign: &str, b: Operand| {
        push(text, a);
        text.push_str(sign);
        push(text, b);
    };
    let method = |text: &mut String, a: Operand, name: &str, b: Operand| {
        push(text, a);
        text.push('.');
        text.push_str(name);
        text.push('(');
        push(text, b);
        text.push(')');
    };
    match *instruction {
        Instruction::Add(a, b) => infix(text, a, " + ", b),
        Instruction::Sub(a, b) => infix(text, a, " - ", b),
        Instruction::Mul(a, b) => infix(text, a, " * ", b),
        Instruction::Div(a, b) => infix(text, a, " / ", b),
        Instruction::MulAdd(a, b, c, minus_product, minus_addend) => {
            // The sign goes to a constant where there is one.
            let (a, b) = if matches!(b, Operand::Constant(_)) { (b, a) } else { (a, b) };
            let signed = |text: &mut String, operand: Operand, minus: bool| {
                if minus { push_minus(text, operand, names) } else { push(text, operand) }
            };
            signed(text, a, minus_product);
            text.push_str(".mul_add(");
            push(text, b);
            text.push_str(", ");
            signed(text, c, minus_addend);
            text.push(')');
        }
        Instruction::Neg(a) => {
            text.push('-');
            push(text, a);
        }
        Instruction::Unary(Unary::Reciprocal, a) => {
            text.push_str("R::ONE / ");
            push(text, a);
        }
        Instruction::Unary(function, a) => {
            push(text, a);
            text.push('.');
            text.push_str(function.method());
            text.push_str("()");
        }
        Instruction::Min(a, b) => method(text, a, "min", b),
        Instruction::Max(a, b) => method(text, a, "max", b),
        Instruction::Atan2(a, b) => method(text, a, "atan2", b),
        Instruction::Compare(comparison, a, b) => method(text, a, comparison.method(), b),
        Instruction::And(a, b) => infix(text, a, " & ", b),
        Instruction::Or(a, b) => infix(text, a, " | ", b),
        Instruction::Not(a) => {
            text.push('!');
            push(text, a);
        }
        Instruction::Select(m, a, b) => {
            text.push_str("R::select(");
            push(text, m);
            text.push_str(", ");
            push(text, a);
            text.push_str(", ");
            push(text, b);
            text.push(')');
        }
    }
}
