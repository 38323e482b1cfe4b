//! The interpreter of programs with a bound of the rounding beside each value: what tells a mistake from a rounding.
//!
//! Running error analysis to first order (Higham, Accuracy and Stability of Numerical Algorithms, section 3.3): each operation
//! adds half a unit of its result, and passes on the errors of its operands times its derivatives. A choice that rounding could
//! turn has no bound.

use super::evaluate::{Inputs, step};
use super::program::{Instruction, Operand, Program, Source};
use crate::functions::Argument;
use crate::symbolic::{Graph, Table, of_patch, of_piece, of_quotient, passed_on as unary_passed_on};
use std::sync::Arc;

/// A value, and what rounding may have made of it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bounded {
    pub value: f64,
    pub error: f64,
}

/// The errors of inputs that programs computed; nothing written, none.
#[derive(Clone, Debug, Default)]
pub struct Errors {
    pub prepared: Vec<f64>,
    pub kept: Vec<f64>,
    pub lu: Vec<f64>,
}

impl Errors {
    fn of(&self, source: Source) -> f64 {
        let errors = match source.argument {
            Argument::Constants => &self.prepared,
            Argument::Store => &self.kept,
            Argument::Lu => &self.lu,
            _ => return 0.0,
        };
        errors.get(source.index as usize).copied().unwrap_or(0.0)
    }
}

/// Outputs of a program, unfused. `graph` is the one it was written from, which knows how constants were rounded.
pub fn run_bounded(program: &Program, graph: &Graph, inputs: &Inputs, errors: &Errors) -> Vec<Bounded> {
    let mut values: Vec<Bounded> = Vec::with_capacity(program.instructions.len());
    for instruction in &program.instructions {
        let get = |operand: Operand| get(operand, graph, inputs, errors, &values);
        let value = step(instruction, &program.tables, |operand| get(operand).value);
        let error = f64::EPSILON * value.abs() + passed_on(instruction, &program.tables, value, get);
        values.push(Bounded { value, error: if error.is_nan() { f64::INFINITY } else { error } });
    }
    program.outputs.iter().map(|output| get(*output, graph, inputs, errors, &values)).collect()
}

fn get(operand: Operand, graph: &Graph, inputs: &Inputs, errors: &Errors, values: &[Bounded]) -> Bounded {
    match operand {
        Operand::Constant(value) => Bounded { value, error: graph.rounding(value) },
        Operand::Source(source) => Bounded { value: inputs.get(source), error: errors.of(source) },
        Operand::Value(index) => values[index as usize],
    }
}

/// The error of a result that follows from those of its operands.
fn passed_on(
    instruction: &Instruction,
    tables: &[Arc<Table>],
    result: f64,
    get: impl Fn(Operand) -> Bounded,
) -> f64 {
    let table = |number: u16| &tables[usize::from(number)];
    let certain = |clear: bool| if clear { 0.0 } else { f64::INFINITY };
    match *instruction {
        Instruction::Neg(a) => get(a).error,
        Instruction::Add(a, b) | Instruction::Sub(a, b) => get(a).error + get(b).error,
        Instruction::Mul(a, b) => of_product(get(a), get(b)),
        Instruction::MulAdd(a, b, c, ..) => {
            let (a, b) = (get(a), get(b));
            // The product is rounded for itself, too.
            of_product(a, b) + f64::EPSILON * (a.value * b.value).abs() + get(c).error
        }
        Instruction::Div(a, b) => {
            let (a, b) = (get(a), get(b));
            of_quotient(a.error, result, b.value, b.error)
        }
        Instruction::Unary(function, a) => {
            let a = get(a);
            unary_passed_on(function, a.value, a.error)
        }
        Instruction::Min(a, b) | Instruction::Max(a, b) => get(a).error.max(get(b).error),
        Instruction::Atan2(a, b) => {
            let (y, x) = (get(a), get(b));
            // At the cut a whole turn is at stake.
            let turned = certain(x.value > 0.0 || y.value.abs() > y.error);
            (y.error * x.value.abs() + x.error * y.value.abs()) / (x.value * x.value + y.value * y.value)
                + turned
        }
        Instruction::Compare(_, a, b) => {
            let (a, b) = (get(a), get(b));
            let exact = a.error == 0.0 && b.error == 0.0;
            certain(exact || (a.value - b.value).abs() > 4.0 * (a.error + b.error))
        }
        Instruction::And(a, b) | Instruction::Or(a, b) => get(a).error + get(b).error,
        Instruction::Not(a) => get(a).error,
        Instruction::Select(mask, a, b) => {
            let mask = get(mask);
            mask.error + get(if mask.value != 0.0 { a } else { b }).error
        }
        Instruction::Cell(number, x) => {
            let x = get(x);
            let clear = |end: f64| (x.value - end).abs() > 4.0 * x.error;
            certain(x.error == 0.0 || table(number).ends(result).into_iter().all(clear))
        }
        Instruction::Piece(number, orders, cell, x) => {
            let (cell, x) = (get(cell), get(x));
            let (slope, of_terms) = of_piece(table(number), orders, cell.value, x.value);
            cell.error + of_terms + part(x.error, slope)
        }
        Instruction::Patch(number, orders, cell, x, y) => {
            let (cell, x, y) = (get(cell), get(x), get(y));
            let (slopes, of_terms) = of_patch(table(number), orders, cell.value, [x.value, y.value]);
            cell.error + of_terms + part(x.error, slopes[0]) + part(y.error, slopes[1])
        }
    }
}

fn of_product(a: Bounded, b: Bounded) -> f64 {
    part(a.error, b.value) + part(b.error, a.value)
}

/// Without ∞ · 0.
fn part(error: f64, factor: f64) -> f64 {
    if factor == 0.0 { 0.0 } else { error * factor.abs() }
}
