//! C as the [`Dialect`] of exported code.
//!
//! ```text
//! const double crank_cos = q[0];
//! const double a0 = crank_cos * crank_cos;
//! ```

use super::names::{Prefix, WORDS, field, plain};
use crate::emit::{Dialect, Spelling};
use crate::functions::{Argument, FUNCTIONS, Shape};
use crate::scalar::Scalar;
use crate::schedule::Instruction;
use crate::symbolic::{BICUBIC, Compare, Table, Unary};
use std::collections::BTreeSet;
use std::fmt::Write;
use std::sync::Arc;

/// The C of one mechanism over one scalar.
pub struct C {
    prefix: Prefix,
    scalar: Scalar,
    keywords: Vec<&'static str>,
}

impl C {
    /// All results are written to arguments or returned, so that arguments for results have names, too.
    pub fn new(prefix: &Prefix, scalar: Scalar) -> C {
        let results = FUNCTIONS.iter().flat_map(|signature| signature.results).map(|group| group.name);
        C { prefix: prefix.clone(), scalar, keywords: WORDS.into_iter().chain(results).collect() }
    }

    /// An argument in a head; of some mechanisms it has no entries and is none.
    pub fn declaration(&self, argument: Argument) -> String {
        let (real, prefix, given) = (self.scalar.c(), &self.prefix.lower, argument.given());
        match given.shape {
            Shape::Scalar => format!("{real} {}", given.name),
            Shape::State => format!("const {prefix}_state_t *{}", given.name),
            Shape::Inputs => format!("const {prefix}_inputs_t *{}", given.name),
            Shape::Parameters => format!("const {prefix}_parameters_t *{}", given.name),
            _ => format!("const {real} {}[]", given.name),
        }
    }
}

/// Of these arguments those that are read, a whole where a part of it is.
pub fn read<'r>(
    arguments: &'r [Argument],
    reads: &'r BTreeSet<Argument>,
) -> impl Iterator<Item = Argument> + 'r {
    let is_read = |argument: &Argument| {
        reads.contains(argument) || argument.parts().iter().any(|part| reads.contains(part))
    };
    arguments.iter().copied().filter(is_read)
}

impl Dialect for C {
    fn keywords(&self) -> &[&'static str] {
        &self.keywords
    }

    fn identifier(&self, name: String) -> String {
        plain(&name)
    }

    fn constant(&self, text: &mut String, value: f64) {
        text.push_str(&self.scalar.operand(value));
    }

    fn operation(&self, instruction: &Instruction) -> Spelling {
        let double = self.scalar == Scalar::F64;
        let of = |double_: &'static str, single: &'static str| {
            [if double { double_ } else { single }, ")", "", ""]
        };
        match instruction {
            Instruction::Neg(_) => ["-", "", "", ""],
            Instruction::Add(..) => ["", " + ", "", ""],
            Instruction::Sub(..) => ["", " - ", "", ""],
            Instruction::Mul(..) => ["", " * ", "", ""],
            Instruction::Div(..) => ["", " / ", "", ""],
            Instruction::MulAdd(_, _, _, false, false) => ["(", " * ", ") + ", ""],
            Instruction::MulAdd(_, _, _, false, true) => ["(", " * ", ") - ", ""],
            Instruction::MulAdd(_, _, _, true, false) => ["-(", " * ", ") + ", ""],
            Instruction::MulAdd(_, _, _, true, true) => ["-(", " * ", ") - ", ""],
            Instruction::Unary(function, _) => match function {
                Unary::Reciprocal if double => ["1.0 / ", "", "", ""],
                Unary::Reciprocal => ["1.0F / ", "", "", ""],
                Unary::Sqrt => of("sqrt(", "sqrtf("),
                Unary::Abs => of("fabs(", "fabsf("),
                Unary::Floor => of("floor(", "floorf("),
                Unary::Sign => ["lw_sign(", ")", "", ""],
                Unary::Sin => of("lw_sin(", "lw_sinf("),
                Unary::Cos => of("lw_cos(", "lw_cosf("),
                Unary::Tan => of("lw_tan(", "lw_tanf("),
                Unary::Asin => of("lw_asin(", "lw_asinf("),
                Unary::Acos => of("lw_acos(", "lw_acosf("),
                Unary::Exp => of("lw_exp(", "lw_expf("),
                Unary::Ln => of("lw_log(", "lw_logf("),
                Unary::Log10 => of("lw_log10(", "lw_log10f("),
                Unary::Sinh => of("lw_sinh(", "lw_sinhf("),
                Unary::Cosh => of("lw_cosh(", "lw_coshf("),
                Unary::Tanh => of("lw_tanh(", "lw_tanhf("),
            },
            Instruction::Min(..) => ["lw_least(", ", ", ")", ""],
            Instruction::Max(..) => ["lw_most(", ", ", ")", ""],
            Instruction::Atan2(..) => [if double { "lw_atan2(" } else { "lw_atan2f(" }, ", ", ")", ""],
            Instruction::Compare(Compare::Less, ..) => ["", " < ", "", ""],
            Instruction::Compare(Compare::LessEqual, ..) => ["", " <= ", "", ""],
            Instruction::Compare(Compare::Equal, ..) => ["lw_equal(", ", ", ")", ""],
            Instruction::And(..) => ["", " && ", "", ""],
            Instruction::Or(..) => ["", " || ", "", ""],
            Instruction::Not(_) => ["!", "", "", ""],
            Instruction::Select(..) => ["", " ? ", " : ", ""],
            Instruction::Cell(..) => ["", ")", "", ""],
            Instruction::Piece(..) => ["", ", ", ")", ""],
            Instruction::Patch(..) => ["", ", ", ", ", ")"],
        }
    }

    fn look_up(&self, text: &mut String, tables: &[Arc<Table>], instruction: &Instruction) {
        let number = instruction.table().unwrap_or(0);
        let (table, name) = (&tables[usize::from(number)], format!("{}_table_{number}", self.prefix.lower));
        let _ = match instruction {
            Instruction::Piece(_, orders, ..) => write!(text, "lw_piece_{}({name}, ", orders.first()),
            Instruction::Patch(_, orders, ..) if table.width() == BICUBIC => {
                write!(text, "lw_bicubic({name}, {}, {}, ", orders.first(), orders.second())
            }
            Instruction::Patch(_, orders, ..) => {
                write!(text, "lw_patch_{}{}({name}, ", orders.first(), orders.second())
            }
            _ => {
                let bits = table.rows().len().next_power_of_two().trailing_zeros();
                write!(text, "lw_cell({name}_bases, {bits}, ")
            }
        };
    }

    fn declaration(&self, mask: bool) -> [&'static str; 3] {
        match self.scalar {
            _ if mask => ["const bool ", " = ", ";\n"],
            Scalar::F64 => ["const double ", " = ", ";\n"],
            Scalar::F32 => ["const float ", " = ", ";\n"],
        }
    }

    fn comment(&self, text: &mut String, line: &str) {
        let _ = writeln!(text, "/* {} */", line.replace("*/", "* /"));
    }

    fn entry(&self, text: &mut String, within: Option<Argument>, argument: Argument, at: &str) {
        let given = argument.given();
        if let Some(whole) = within {
            let _ = write!(text, "{}->", whole.name());
        }
        let _ = match given.shape {
            Shape::Parameters | Shape::Inputs => write!(text, "{}->{}", given.name, field(at)),
            _ => write!(text, "{}[{at}]", given.name),
        };
    }

    fn table(&self, text: &mut String, table: usize, numbers: &[f64]) {
        let list = numbers.iter().map(|number| self.scalar.literal(*number)).collect::<Vec<_>>().join(", ");
        let _ =
            writeln!(text, "static const {} n{table}[{}] = {{ {list} }};", self.scalar.c(), numbers.len());
    }

    fn number(&self, text: &mut String, table: usize, at: &str) {
        let _ = write!(text, "n{table}[{at}]");
    }

    fn array(&self, text: &mut String, name: &str, length: usize) {
        let _ = writeln!(text, "{} {name}[{length}];", self.scalar.c());
    }

    fn variable(&self, text: &mut String, name: &str) {
        let _ = write!(text, "{} {name} = ", self.scalar.c());
    }

    fn rounds(&self, text: &mut String, rounds: usize) {
        let _ = writeln!(text, "for (int i = 0; i < {rounds}; ++i)\n{{");
    }

    fn slots(&self, text: &mut String, size: usize) {
        let _ = writeln!(text, "{} w[{size}];", self.scalar.c());
    }

    fn slot(&self, text: &mut String, slot: usize) {
        let _ = write!(text, "w[{slot}]");
    }

    fn given(&self, mask: bool) -> [&'static str; 2] {
        match self.scalar {
            _ if !mask => [" = ", ";\n"],
            Scalar::F64 => [" = ", " ? 1.0 : 0.0;\n"],
            Scalar::F32 => [" = ", " ? 1.0F : 0.0F;\n"],
        }
    }

    fn taken(&self, mask: bool) -> [&'static str; 2] {
        match self.scalar {
            _ if !mask => ["", ""],
            Scalar::F64 => ["", " > 0.5"],
            Scalar::F32 => ["", " > 0.5F"],
        }
    }

    fn helper(
        &self,
        text: &mut String,
        name: &str,
        arguments: &[Argument],
        reads: &BTreeSet<Argument>,
        _: usize,
    ) {
        let mut declared: Vec<String> =
            read(arguments, reads).map(|argument| self.declaration(argument)).collect();
        declared.push(format!("{} w[]", self.scalar.c()));
        let _ = writeln!(text, "static void {}_{name}({})\n{{", self.prefix.lower, declared.join(", "));
    }

    fn end(&self, text: &mut String) {
        text.push_str("}\n\n");
    }

    fn call(&self, text: &mut String, name: &str, arguments: &[Argument], reads: &BTreeSet<Argument>) {
        let mut names: Vec<&str> = read(arguments, reads).map(Argument::name).collect();
        names.push("w");
        let _ = writeln!(text, "{}_{name}({});", self.prefix.lower, names.join(", "));
    }
}
