//! Function bodies: a program as Rust text, one `let` per instruction.
//!
//! ```text
//! let [crank_cos, crank_sin, …] = *q;
//! let a0 = crank_cos * coupler_cos;
//! let a1 = crank_sin.mul_add(coupler_sin, a0);
//! *mass = [f(1.3333333333333333), a1, …];
//! ```
//! Text that is parsed once is ten times faster to produce than token streams.

use super::names::Names;
use crate::schedule::{Instruction, Operand, Program, Source};
use crate::symbolic::Unary;
use std::collections::BTreeSet;
use std::fmt::Write;

/// Longest stretch of instructions in one function: compilers are superlinear in the size of a function.
const STRETCH: usize = 1000;

/// The body of a function and the helper functions it was cut into.
pub struct Body {
    /// Loads, instructions; the outputs' expressions are given apart.
    pub statements: String,
    pub outputs: Vec<String>,
    /// Items to be placed beside the function.
    pub helpers: String,
}

/// Writes a program. `helper` is the prefix of the names of helper functions.
pub fn body(program: &Program, names: &Names, helper: &str) -> Body {
    if program.instructions.len() <= STRETCH {
        let mut statements = String::new();
        loads(&mut statements, program.instructions.iter(), &program.outputs, names);
        for (index, instruction) in program.instructions.iter().enumerate() {
            statement(&mut statements, index, instruction, names);
        }
        let outputs = program.outputs.iter().map(|output| operand(*output, names)).collect();
        return Body { statements, outputs, helpers: String::new() };
    }
    cut(program, names, helper)
}

/// Cuts a long program where few values are live. Values that live on travel in an array.
fn cut(program: &Program, names: &Names, helper: &str) -> Body {
    let count = program.instructions.len();
    let mut last_use = vec![0usize; count];
    for (index, instruction) in program.instructions.iter().enumerate() {
        for operand in instruction.operands() {
            if let Operand::Value(value) = operand {
                last_use[value as usize] = index;
            }
        }
    }
    for output in &program.outputs {
        if let Operand::Value(value) = output {
            last_use[*value as usize] = count;
        }
    }
    let mut difference = vec![0isize; count + 2];
    for (value, last) in last_use.iter().enumerate() {
        difference[value + 1] += 1;
        difference[last + 1] -= 1;
    }
    let mut live = vec![0isize; count + 1];
    let mut running = 0;
    for (cut, live) in live.iter_mut().enumerate() {
        running += difference[cut];
        *live = running;
    }

    let mut cuts = vec![0];
    let parts = count.div_ceil(STRETCH);
    for part in 1..parts {
        let (middle, reach) = (part * count / parts, count / parts / 3);
        let best = (middle - reach..=middle + reach).min_by_key(|cut| (live[*cut], *cut));
        cuts.extend(best);
    }
    cuts.push(count);

    write_parts(program, names, helper, &cuts, &last_use)
}

fn write_parts(program: &Program, names: &Names, helper: &str, cuts: &[usize], last_use: &[usize]) -> Body {
    // A value that leaves its stretch gets a slot, and keeps it until its last use.
    let count = program.instructions.len();
    let mut slot_of: Vec<Option<usize>> = vec![None; count];
    let mut free: BTreeSet<usize> = BTreeSet::new();
    let mut size = 0;
    let mut parts = Vec::new();
    let mut kept: BTreeSet<usize> = BTreeSet::new();
    for window in cuts.windows(2) {
        let (start, end) = (window[0], window[1]);
        let mut used = BTreeSet::new();
        for instruction in &program.instructions[start..end] {
            for operand in instruction.operands() {
                if let Operand::Value(value) = operand
                    && (value as usize) < start
                {
                    used.insert(value as usize);
                }
            }
        }
        let taken: Vec<(usize, usize)> =
            used.iter().filter_map(|value| slot_of[*value].map(|slot| (*value, slot))).collect();
        let dead: Vec<usize> = kept.iter().copied().filter(|value| last_use[*value] < end).collect();
        for value in dead {
            kept.remove(&value);
            free.extend(slot_of[value].take());
        }
        let mut given = Vec::new();
        for value in start..end {
            if last_use[value] >= end {
                let slot = free.pop_first().unwrap_or_else(|| {
                    size += 1;
                    size - 1
                });
                slot_of[value] = Some(slot);
                kept.insert(value);
                given.push((value, slot));
            }
        }
        parts.push((start, end, taken, given));
    }

    let mut helpers = String::new();
    let mut statements = format!("let mut w = [R::ZERO; {size}];\n");
    let signature = names.signature();
    for (part, (start, end, taken, given)) in parts.iter().enumerate() {
        let _ = writeln!(statements, "{helper}_{part}({}, &mut w);", names.arguments());
        let _ = writeln!(
            helpers,
            "#[inline(never)] fn {helper}_{part}<R: Real>({signature}, w: &mut [R; {size}]) {{"
        );
        let stretch = &program.instructions[*start..*end];
        loads(&mut helpers, stretch.iter(), &[], names);
        for (value, slot) in taken {
            let _ = writeln!(helpers, "let {} = w[{slot}];", names.value(*value as u32));
        }
        for (offset, instruction) in stretch.iter().enumerate() {
            statement(&mut helpers, start + offset, instruction, names);
        }
        for (value, slot) in given {
            let _ = writeln!(helpers, "w[{slot}] = {};", names.value(*value as u32));
        }
        helpers.push_str("}\n");
    }
    loads(&mut statements, [].iter(), &program.outputs, names);
    let outputs = program
        .outputs
        .iter()
        .map(|output| match output {
            Operand::Value(value) => match slot_of[*value as usize] {
                Some(slot) => format!("w[{slot}]"),
                None => operand(*output, names),
            },
            _ => operand(*output, names),
        })
        .collect();
    Body { statements, outputs, helpers }
}

/// `let` for every source that the instructions or outputs name.
fn loads<'a>(
    text: &mut String,
    instructions: impl Iterator<Item = &'a Instruction>,
    outputs: &[Operand],
    names: &Names,
) {
    let mut used: BTreeSet<Source> = BTreeSet::new();
    let operands = instructions.flat_map(|instruction| instruction.operands());
    for operand in operands.chain(outputs.iter().copied()) {
        if let Operand::Source(source) = operand {
            used.insert(source);
        }
    }
    for source in used {
        if let Some(place) = names.place(source) {
            let _ = writeln!(text, "let {} = {place};", names.name(source));
        }
    }
}

fn statement(text: &mut String, index: usize, instruction: &Instruction, names: &Names) {
    text.push_str("let ");
    text.push_str(&names.value(index as u32));
    text.push_str(" = ");
    expression(text, instruction, names);
    text.push_str(";\n");
}

fn operand(operand: Operand, names: &Names) -> String {
    match operand {
        Operand::Constant(value) => constant(value),
        Operand::Source(source) => names.name(source).to_string(),
        Operand::Value(index) => names.value(index),
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
    let get = |o: Operand| operand(o, names);
    let minus = |o: Operand| match o {
        Operand::Constant(value) => constant(-value),
        _ => format!("(-{})", operand(o, names)),
    };
    let mut write = |parts: &[&str]| parts.iter().for_each(|part| text.push_str(part));
    match *instruction {
        Instruction::Neg(a) => write(&["-", &get(a)]),
        Instruction::Add(a, b) => write(&[&get(a), " + ", &get(b)]),
        Instruction::Sub(a, b) => write(&[&get(a), " - ", &get(b)]),
        Instruction::Mul(a, b) => write(&[&get(a), " * ", &get(b)]),
        Instruction::MulAdd(a, b, c, minus_product, minus_addend) => {
            // The sign goes to a constant where there is one.
            let (a, b) = if matches!(b, Operand::Constant(_)) { (b, a) } else { (a, b) };
            let factor = if minus_product { minus(a) } else { get(a) };
            let addend = if minus_addend { minus(c) } else { get(c) };
            write(&[&factor, ".mul_add(", &get(b), ", ", &addend, ")"]);
        }
        Instruction::Div(a, b) => write(&[&get(a), " / ", &get(b)]),
        Instruction::Unary(Unary::Reciprocal, a) => write(&["R::ONE / ", &get(a)]),
        Instruction::Unary(function, a) => write(&[&get(a), ".", function.method(), "()"]),
        Instruction::Min(a, b) => write(&[&get(a), ".min(", &get(b), ")"]),
        Instruction::Max(a, b) => write(&[&get(a), ".max(", &get(b), ")"]),
        Instruction::Atan2(a, b) => write(&[&get(a), ".atan2(", &get(b), ")"]),
        Instruction::Compare(comparison, a, b) => {
            write(&[&get(a), ".", comparison.method(), "(", &get(b), ")"]);
        }
        Instruction::And(a, b) => write(&[&get(a), " & ", &get(b)]),
        Instruction::Or(a, b) => write(&[&get(a), " | ", &get(b)]),
        Instruction::Not(a) => write(&["!", &get(a)]),
        Instruction::Select(m, a, b) => write(&["R::select(", &get(m), ", ", &get(a), ", ", &get(b), ")"]),
    }
}
