//! Straight-line programs: what `emit` spells out, `count` counts and `evaluate` runs.

use super::repetition::Rolled;
use super::sections::Section;
use crate::functions::Argument;
use crate::symbolic::{Compare, Few, Orders, Table, Unary};
use std::sync::Arc;

/// Where a value that a program does not compute comes from: an entry of an argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Source {
    pub argument: Argument,
    /// 0 of a number.
    pub index: u32,
}

/// An operand of an instruction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Operand {
    Constant(f64),
    Source(Source),
    /// Result of the instruction of that index.
    Value(u32),
}

/// One operation of the target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Instruction {
    Neg(Operand),
    Add(Operand, Operand),
    Sub(Operand, Operand),
    Mul(Operand, Operand),
    /// ±(a·b) ± c: a, b, c, product negated, addend negated.
    MulAdd(Operand, Operand, Operand, bool, bool),
    Div(Operand, Operand),
    Unary(Unary, Operand),
    Min(Operand, Operand),
    Max(Operand, Operand),
    Atan2(Operand, Operand),
    Compare(Compare, Operand, Operand),
    And(Operand, Operand),
    Or(Operand, Operand),
    Not(Operand),
    Select(Operand, Operand, Operand),
    /// Table, argument: the row that it is in.
    Cell(u16, Operand),
    /// Table, orders, row, argument.
    Piece(u16, Orders, Operand, Operand),
    /// Table, orders, row, both arguments.
    Patch(u16, Orders, Operand, Operand, Operand),
}

impl Instruction {
    /// Operands in order.
    pub fn operands(&self) -> Few<Operand> {
        match *self {
            Instruction::Neg(a)
            | Instruction::Unary(_, a)
            | Instruction::Not(a)
            | Instruction::Cell(_, a) => Few::new([a; 3], 1),
            Instruction::Add(a, b)
            | Instruction::Sub(a, b)
            | Instruction::Mul(a, b)
            | Instruction::Div(a, b)
            | Instruction::Min(a, b)
            | Instruction::Max(a, b)
            | Instruction::Atan2(a, b)
            | Instruction::Compare(_, a, b)
            | Instruction::And(a, b)
            | Instruction::Or(a, b)
            | Instruction::Piece(_, _, a, b) => Few::new([a, b, b], 2),
            Instruction::MulAdd(a, b, c, ..)
            | Instruction::Select(a, b, c)
            | Instruction::Patch(_, _, a, b, c) => Few::new([a, b, c], 3),
        }
    }

    /// The same operation on other operands.
    pub fn map(&self, mut f: impl FnMut(Operand) -> Operand) -> Instruction {
        match *self {
            Instruction::Neg(a) => Instruction::Neg(f(a)),
            Instruction::Add(a, b) => Instruction::Add(f(a), f(b)),
            Instruction::Sub(a, b) => Instruction::Sub(f(a), f(b)),
            Instruction::Mul(a, b) => Instruction::Mul(f(a), f(b)),
            Instruction::MulAdd(a, b, c, product, addend) => {
                Instruction::MulAdd(f(a), f(b), f(c), product, addend)
            }
            Instruction::Div(a, b) => Instruction::Div(f(a), f(b)),
            Instruction::Unary(function, a) => Instruction::Unary(function, f(a)),
            Instruction::Min(a, b) => Instruction::Min(f(a), f(b)),
            Instruction::Max(a, b) => Instruction::Max(f(a), f(b)),
            Instruction::Atan2(a, b) => Instruction::Atan2(f(a), f(b)),
            Instruction::Compare(comparison, a, b) => Instruction::Compare(comparison, f(a), f(b)),
            Instruction::And(a, b) => Instruction::And(f(a), f(b)),
            Instruction::Or(a, b) => Instruction::Or(f(a), f(b)),
            Instruction::Not(a) => Instruction::Not(f(a)),
            Instruction::Select(m, a, b) => Instruction::Select(f(m), f(a), f(b)),
            Instruction::Cell(table, a) => Instruction::Cell(table, f(a)),
            Instruction::Piece(table, orders, a, b) => Instruction::Piece(table, orders, f(a), f(b)),
            Instruction::Patch(table, orders, a, b, c) => Instruction::Patch(table, orders, f(a), f(b), f(c)),
        }
    }

    /// The table that it looks up in.
    pub fn table(&self) -> Option<u16> {
        match self {
            Instruction::Cell(table, ..) | Instruction::Piece(table, ..) | Instruction::Patch(table, ..) => {
                Some(*table)
            }
            _ => None,
        }
    }

    /// Whether the result is a mask.
    pub fn is_mask(&self) -> bool {
        matches!(
            self,
            Instruction::Compare(..) | Instruction::And(..) | Instruction::Or(..) | Instruction::Not(_)
        )
    }
}

/// Instructions in order, and what they are for.
#[derive(Clone, Debug, Default)]
pub struct Program {
    pub instructions: Vec<Instruction>,
    pub outputs: Vec<Operand>,
    /// What stretches of the instructions are for, where that is known.
    pub sections: Vec<Section>,
    /// What instructions look up in, by number.
    pub tables: Vec<Arc<Table>>,
    /// Stretches of instructions that repeat one another.
    pub rolled: Option<Rolled>,
    /// How many instructions repeat others where there are no loops all the same.
    pub alike: usize,
}

impl Program {
    /// The same program with its instructions in another order, given by their present indices; without sections and loops.
    pub fn in_order(&self, order: &[usize]) -> Program {
        let mut position = vec![0u32; order.len()];
        for (new, old) in order.iter().enumerate() {
            position[*old] = new as u32;
        }
        let moved = |operand: Operand| match operand {
            Operand::Value(value) => Operand::Value(position[value as usize]),
            other => other,
        };
        let instructions = order.iter().map(|old| self.instructions[*old].map(moved)).collect();
        Program {
            instructions,
            outputs: self.outputs.iter().map(|output| moved(*output)).collect(),
            sections: Vec::new(),
            tables: self.tables.clone(),
            rolled: None,
            alike: self.alike,
        }
    }
}
