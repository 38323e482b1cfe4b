//! The interpreter of programs: the second of the two evaluators. It rounds exactly as the emitted code does where
//! fused multiply-add is off.

use super::program::{Instruction, Operand, Program, Source};
use super::rounds;
use crate::functions::Argument;
use crate::symbolic::{Table, max, min};
use std::slice::from_ref;
use std::sync::Arc;

/// The values of all arguments.
#[derive(Clone, Debug, Default)]
pub struct Inputs {
    pub parameters: Vec<f64>,
    pub phases: Vec<f64>,
    pub time: f64,
    pub q: Vec<f64>,
    pub v: Vec<f64>,
    pub internal: Vec<f64>,
    pub gates: Vec<f64>,
    pub inputs: Vec<f64>,
    pub two_alpha: f64,
    pub beta_squared: f64,
    pub acceleration: Vec<f64>,
    pub lambda: Vec<f64>,
    pub targets: Vec<f64>,
    pub compliance: f64,
    pub given_forces: Vec<f64>,
    pub given_rows: Vec<f64>,
    pub kept: Vec<f64>,
    pub lu: Vec<f64>,
    pub prepared: Vec<f64>,
}

impl Inputs {
    pub fn get(&self, source: Source) -> f64 {
        self.of(source.argument)[source.index as usize]
    }

    /// The values of an argument.
    pub fn of(&self, argument: Argument) -> &[f64] {
        match argument {
            Argument::Time => from_ref(&self.time),
            Argument::Q => &self.q,
            Argument::V => &self.v,
            Argument::Z => &self.internal,
            Argument::Gates => &self.gates,
            Argument::State => &[],
            Argument::Inputs => &self.inputs,
            Argument::TwoAlpha => from_ref(&self.two_alpha),
            Argument::BetaSquared => from_ref(&self.beta_squared),
            Argument::Acceleration => &self.acceleration,
            Argument::Lambda => &self.lambda,
            Argument::Target => &self.targets,
            Argument::Compliance => from_ref(&self.compliance),
            Argument::GivenForces => &self.given_forces,
            Argument::GivenRows => &self.given_rows,
            Argument::Store => &self.kept,
            Argument::Lu => &self.lu,
            Argument::Parameters => &self.parameters,
            Argument::Phases => &self.phases,
            Argument::Constants => &self.prepared,
        }
    }
}

/// Outputs of a program, unfused.
pub fn run(program: &Program, inputs: &Inputs) -> Vec<f64> {
    match &program.rolled {
        Some(rolled) => rounds::run(program, rolled, inputs),
        None => run_straight(program, inputs),
    }
}

/// The same of all instructions in their order, without loops.
pub fn run_straight(program: &Program, inputs: &Inputs) -> Vec<f64> {
    let mut values: Vec<f64> = Vec::with_capacity(program.instructions.len());
    for instruction in &program.instructions {
        let value = step(instruction, &program.tables, |operand| get(operand, inputs, &values));
        values.push(value);
    }
    program.outputs.iter().map(|output| get(*output, inputs, &values)).collect()
}

fn get(operand: Operand, inputs: &Inputs, values: &[f64]) -> f64 {
    match operand {
        Operand::Constant(value) => value,
        Operand::Source(source) => inputs.get(source),
        Operand::Value(index) => values[index as usize],
    }
}

pub(super) fn step(instruction: &Instruction, tables: &[Arc<Table>], get: impl Fn(Operand) -> f64) -> f64 {
    let table = |number: u16| &tables[usize::from(number)];
    let mask = |value: bool| if value { 1.0 } else { 0.0 };
    match *instruction {
        Instruction::Neg(a) => -get(a),
        Instruction::Add(a, b) => get(a) + get(b),
        Instruction::Sub(a, b) => get(a) - get(b),
        Instruction::Mul(a, b) => get(a) * get(b),
        Instruction::MulAdd(a, b, c, minus_product, minus_addend) => {
            let product = get(a) * get(b);
            let product = if minus_product { -product } else { product };
            if minus_addend { product - get(c) } else { product + get(c) }
        }
        Instruction::Div(a, b) => get(a) / get(b),
        Instruction::Unary(function, a) => function.value(get(a)),
        Instruction::Min(a, b) => min(get(a), get(b)),
        Instruction::Max(a, b) => max(get(a), get(b)),
        Instruction::Atan2(a, b) => libm::atan2(get(a), get(b)),
        Instruction::Compare(comparison, a, b) => mask(comparison.value(get(a), get(b))),
        Instruction::And(a, b) => mask(get(a) != 0.0 && get(b) != 0.0),
        Instruction::Or(a, b) => mask(get(a) != 0.0 || get(b) != 0.0),
        Instruction::Not(a) => mask(get(a) == 0.0),
        Instruction::Select(m, a, b) => get(if get(m) != 0.0 { a } else { b }),
        Instruction::Cell(number, x) => table(number).cell(get(x)),
        Instruction::Piece(number, orders, cell, x) => table(number).piece(orders.first(), get(cell), get(x)),
        Instruction::Patch(number, orders, cell, x, y) => {
            table(number).patch(orders, get(cell), get(x), get(y))
        }
    }
}
