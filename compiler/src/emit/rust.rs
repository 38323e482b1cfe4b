//! Rust as the [`Dialect`] of emitted code: statements over the runtime's scalar `Real`.

use super::dialect::{Dialect, Spelling};
use super::function::{self, declaration};
use super::look_up;
use super::names::{KEYWORDS, field};
use crate::compiled::Compiled;
use crate::functions::{Argument, Shape, Signature, Way};
use crate::schedule::Instruction;
use crate::symbolic::{BICUBIC, Compare, Table, Unary};
use std::collections::BTreeSet;
use std::fmt::Write;
use std::sync::Arc;

/// The list that is a function's value, where its entries are written one by one.
pub const OUT: &str = "out";

/// The Rust of one mechanism, whose types have short names beside the functions.
pub struct Rust<'a>(pub &'a Compiled);

impl Dialect for Rust<'_> {
    fn keywords(&self) -> &[&'static str] {
        &KEYWORDS
    }

    fn constant(&self, text: &mut String, value: f64) {
        text.push_str(&constant(value));
    }

    fn operation(&self, instruction: &Instruction) -> Spelling {
        match instruction {
            Instruction::Add(..) => ["", " + ", "", ""],
            Instruction::Sub(..) => ["", " - ", "", ""],
            Instruction::Mul(..) => ["", " * ", "", ""],
            Instruction::Div(..) => ["", " / ", "", ""],
            Instruction::MulAdd(_, _, _, minus_product, minus_addend) => {
                match (minus_product, minus_addend) {
                    (false, false) => ["", ".mul_add(", ", ", ")"],
                    (false, true) => ["", ".mul_add(", ", -", ")"],
                    (true, false) => ["(-", ").mul_add(", ", ", ")"],
                    (true, true) => ["(-", ").mul_add(", ", -", ")"],
                }
            }
            Instruction::Neg(_) => ["-", "", "", ""],
            Instruction::Unary(function, _) => match function {
                Unary::Reciprocal => ["R::ONE / ", "", "", ""],
                Unary::Sqrt => ["", ".sqrt()", "", ""],
                Unary::Abs => ["", ".abs()", "", ""],
                Unary::Sign => ["", ".sign()", "", ""],
                Unary::Sin => ["", ".sin()", "", ""],
                Unary::Cos => ["", ".cos()", "", ""],
                Unary::Tan => ["", ".tan()", "", ""],
                Unary::Asin => ["", ".asin()", "", ""],
                Unary::Acos => ["", ".acos()", "", ""],
                Unary::Exp => ["", ".exp()", "", ""],
                Unary::Ln => ["", ".ln()", "", ""],
                Unary::Log10 => ["", ".log10()", "", ""],
                Unary::Sinh => ["", ".sinh()", "", ""],
                Unary::Cosh => ["", ".cosh()", "", ""],
                Unary::Tanh => ["", ".tanh()", "", ""],
                Unary::Floor => ["", ".floor()", "", ""],
            },
            Instruction::Min(..) => ["", ".min(", ")", ""],
            Instruction::Max(..) => ["", ".max(", ")", ""],
            Instruction::Atan2(..) => ["", ".atan2(", ")", ""],
            Instruction::Compare(Compare::Less, ..) => ["", ".less(", ")", ""],
            Instruction::Compare(Compare::LessEqual, ..) => ["", ".less_equal(", ")", ""],
            Instruction::Compare(Compare::Equal, ..) => ["", ".equal(", ")", ""],
            Instruction::And(..) => ["", " & ", "", ""],
            Instruction::Or(..) => ["", " | ", "", ""],
            Instruction::Not(_) => ["!", "", "", ""],
            Instruction::Select(..) => ["R::select(", ", ", ", ", ")"],
            Instruction::Cell(..) => ["", ")", "", ""],
            Instruction::Piece(..) => ["", ", ", ")", ""],
            Instruction::Patch(..) => ["", ", ", ", ", ")"],
        }
    }

    fn look_up(&self, text: &mut String, tables: &[Arc<Table>], instruction: &Instruction) {
        let number = instruction.table().map_or(0, usize::from);
        let width = tables[number].width();
        let function = match instruction {
            Instruction::Piece(_, orders, ..) => {
                ["value", "slope", "second", "third"][usize::from(orders.first())]
            }
            Instruction::Patch(_, orders, ..) if width == BICUBIC => {
                let (first, second) = (orders.first(), orders.second());
                let _ = write!(
                    text,
                    "table::bicubic(&tables::{}, {first}, {second}, ",
                    look_up::name(tables, number)
                );
                return;
            }
            Instruction::Patch(_, orders, ..) => match (orders.first(), orders.second()) {
                (0, 0) => "patch",
                (_, 0) => "patch_x",
                (0, _) => "patch_y",
                _ => "patch_xy",
            },
            _ => "cell",
        };
        let _ = write!(text, "table::{function}(&tables::{}, ", look_up::name(tables, number));
    }

    fn declaration(&self, _: bool) -> [&'static str; 3] {
        ["let ", " = ", ";\n"]
    }

    fn comment(&self, text: &mut String, line: &str) {
        let _ = writeln!(text, "// {line}");
    }

    fn entry(&self, text: &mut String, within: Option<Argument>, argument: Argument, at: &str) {
        let given = argument.given();
        if let Some(whole) = within {
            text.push_str(whole.name());
            text.push('.');
        }
        text.push_str(given.name);
        match given.shape {
            Shape::Parameters | Shape::Inputs => {
                text.push('.');
                text.push_str(&field(at));
            }
            _ => {
                text.push('[');
                text.push_str(at);
                text.push(']');
            }
        }
    }

    fn table(&self, text: &mut String, table: usize, numbers: &[f64]) {
        let list = numbers.iter().map(|number| literal(*number)).collect::<Vec<_>>().join(", ");
        let _ = writeln!(text, "const N{table}: [::core::primitive::f64; {}] = [{list}];", numbers.len());
    }

    fn number(&self, text: &mut String, table: usize, at: &str) {
        let _ = write!(text, "R::from_f64(N{table}[{at}])");
    }

    fn results(&self, text: &mut String, signature: &Signature) {
        if let Some(zeros) = function::zeros(self.0, signature) {
            let _ = writeln!(text, "let mut {OUT} = {zeros};");
        }
    }

    fn result(&self, text: &mut String, signature: &Signature, group: usize, at: &str, place: &str) {
        let group = &signature.results[group];
        if group.way == Way::Written {
            let _ = write!(text, "{}[{at}]{place}", group.name);
            return;
        }
        let _ = write!(text, "{OUT}[{at}]{place}");
        // Several lists are paired.
        let mut values = signature.results.iter().filter(|known| known.way == Way::Value);
        if let Some(which) = values.clone().position(|known| known.name == group.name)
            && values.nth(1).is_some()
        {
            let _ = write!(text, "[{which}]");
        }
    }

    fn array(&self, text: &mut String, name: &str, length: usize) {
        let _ = writeln!(text, "let mut {name} = [R::ZERO; {length}];");
    }

    fn variable(&self, text: &mut String, name: &str) {
        let _ = write!(text, "let mut {name} = ");
    }

    fn rounds(&self, text: &mut String, rounds: usize) {
        let _ = writeln!(text, "for i in 0..{rounds} {{");
    }

    fn slots(&self, text: &mut String, size: usize) {
        let _ = writeln!(text, "let mut w = [R::ZERO; {size}];");
    }

    fn slot(&self, text: &mut String, slot: usize) {
        let _ = write!(text, "w[{slot}]");
    }

    fn given(&self, mask: bool) -> [&'static str; 2] {
        if mask { [" = R::select(", ", R::ONE, R::ZERO);\n"] } else { [" = ", ";\n"] }
    }

    fn taken(&self, mask: bool) -> [&'static str; 2] {
        if mask { ["", ".equal(R::ONE)"] } else { ["", ""] }
    }

    fn helper(
        &self,
        text: &mut String,
        name: &str,
        arguments: &[Argument],
        _: &BTreeSet<Argument>,
        slots: usize,
    ) {
        let declared =
            arguments.iter().map(|argument| declaration(*argument, |shape| type_of(self.0, shape)));
        let declared = declared.collect::<Vec<_>>().join(", ");
        let _ = writeln!(text, "#[inline(never)] fn {name}<R: Real>({declared}, w: &mut [R; {slots}]) {{");
    }

    fn end(&self, text: &mut String) {
        text.push_str("}\n");
    }

    fn call(&self, text: &mut String, name: &str, arguments: &[Argument], _: &BTreeSet<Argument>) {
        let names = arguments.iter().map(|argument| argument.name()).collect::<Vec<_>>().join(", ");
        let _ = writeln!(text, "{name}({names}, &mut w);");
    }
}

/// A shape by the aliases that stand beside the functions.
pub fn type_of(compiled: &Compiled, shape: Shape) -> String {
    let mechanism = &compiled.mechanism;
    let alias = match shape {
        Shape::Scalar => return "R".to_string(),
        // A type alias may not leave its scalar unused, so `()` stands for itself where nothing is given.
        Shape::Inputs if mechanism.inputs.is_empty() => return "()".to_string(),
        Shape::Outputs if mechanism.outputs.is_empty() => return "()".to_string(),
        Shape::Bodies(record) | Shape::Joints(record) => {
            return format!("[{}<R>; {}]", record.of(mechanism.space).name, compiled.entries(shape));
        }
        Shape::Loads | Shape::Drivers | Shape::Masses => return format!("[R; {}]", compiled.entries(shape)),
        Shape::State if mechanism.holds() => {
            let internal = if mechanism.states.is_empty() { "()" } else { "Z<R>" };
            return format!("State<Q<R>, V<R>, {internal}, Gates<R>>");
        }
        Shape::State if mechanism.states.is_empty() => return "State<Q<R>, V<R>>".to_string(),
        Shape::State => return "State<Q<R>, V<R>, Z<R>>".to_string(),
        Shape::Internal => "Z",
        Shape::Gates => "Gates",
        Shape::Positions => "Q",
        Shape::Velocities => "V",
        Shape::Rows => "Lambda",
        Shape::Matrix(matrix) => matrix.name,
        Shape::Conditions => "Conditions",
        Shape::Store => "Store",
        Shape::Lu => "Lu",
        Shape::Constants => "Constants",
        Shape::Phases => "Phases",
        Shape::Parameters => "Parameters",
        Shape::Inputs => "Inputs",
        Shape::Outputs => "Outputs",
    };
    format!("{alias}<R>")
}

/// A number of the scalar's type.
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
