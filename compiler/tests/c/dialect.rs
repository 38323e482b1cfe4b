//! C as a dialect, and functions with their heads: what a second language takes, and no more.
//!
//! ```text
//! static void FourBar_gamma(const double *constants, double time, const double *q, const double *v, double *out) {
//! const double crank_cos = q[0];
//! const double a0 = crank_cos * crank_cos;
//! out[0] = a0;
//! }
//! ```

use linkwright_compiler::Compiled;
use linkwright_compiler::emit::{Dialect, Printer, Spelling};
use linkwright_compiler::functions::{Argument, FUNCTIONS, Shape, Signature};
use linkwright_compiler::schedule::{Instruction, Source};
use linkwright_compiler::symbolic::{BICUBIC, Compare, Table, Unary};
use std::fmt::Write;
use std::sync::Arc;

/// What the functions are written over.
pub const PRELUDE: &str = "#include <math.h>
static double sign(double x) { return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : x; }
static double least(double a, double b) { return a < b ? a : b; }
static double most(double a, double b) { return a > b ? a : b; }
static double cell(const double *bases, int rows, int width, double x) {
  int row = 0;
  while (row + 1 < rows && bases[(row + 1) * width] <= x) row++;
  return row;
}
static double piece0(const double (*t)[5], double cell, double x) {
  const double *r = t[(int)cell];
  const double s = x - r[0];
  return ((r[4] * s + r[3]) * s + r[2]) * s + r[1];
}
static double piece1(const double (*t)[5], double cell, double x) {
  const double *r = t[(int)cell];
  const double s = x - r[0];
  return (3.0 * r[4] * s + 2.0 * r[3]) * s + r[2];
}
static double piece2(const double (*t)[5], double cell, double x) {
  const double *r = t[(int)cell];
  const double s = x - r[0];
  return 6.0 * r[4] * s + 2.0 * r[3];
}
static double piece3(const double (*t)[5], double cell, double x) {
  const double *r = t[(int)cell];
  return 0.0 * (x - r[0]) + 6.0 * r[4];
}
static double cubic(int order, double a, double b, double c, double d, double s) {
  return order == 0 ? ((d * s + c) * s + b) * s + a
       : order == 1 ? (3.0 * d * s + 2.0 * c) * s + b
       : order == 2 ? 6.0 * d * s + 2.0 * c
       : 0.0 * s + 6.0 * d;
}
static double bicubic(const double (*t)[18], int by_x, int by_y, double cell, double x, double y) {
  const double *r = t[(int)cell];
  const double q = y - r[1];
  double f[4];
  for (int k = 0; k < 4; ++k) {
    const double *g = r + 2 + 4 * k;
    f[k] = cubic(by_y, g[0], g[1], g[2], g[3], q);
  }
  return cubic(by_x, f[0], f[1], f[2], f[3], x - r[0]);
}
static double patch00(const double (*t)[6], double cell, double x, double y) {
  const double *r = t[(int)cell];
  const double s = x - r[0], q = y - r[1];
  return (r[5] * q + r[3]) * s + (r[4] * q + r[2]);
}
static double patch10(const double (*t)[6], double cell, double x, double y) {
  const double *r = t[(int)cell];
  return 0.0 * (x - r[0]) + (r[5] * (y - r[1]) + r[3]);
}
static double patch01(const double (*t)[6], double cell, double x, double y) {
  const double *r = t[(int)cell];
  return 0.0 * (y - r[1]) + (r[5] * (x - r[0]) + r[4]);
}
static double patch11(const double (*t)[6], double cell, double x, double y) {
  const double *r = t[(int)cell];
  return 0.0 * (x - r[0]) + (0.0 * (y - r[1]) + r[5]);
}
";

const WORDS: [&str; 74] = [
    "auto", "break", "case", "char", "const", "continue", "default", "do", "double", "else", "enum",
    "extern", "float", "for", "goto", "if", "inline", "int", "long", "register", "restrict", "return",
    "short", "signed", "sizeof", "static", "struct", "switch", "typedef", "union", "unsigned", "void",
    "volatile", "while", "sqrt", "fabs", "sign", "sin", "cos", "tan", "asin", "acos", "atan2", "exp", "log",
    "log10", "sinh", "cosh", "tanh", "floor", "least", "most", "main", "errno", "stdin", "stdout", "stderr",
    "isnan", "isinf", "signbit", "INFINITY", "NAN", "HUGE_VAL", "cell", "piece0", "piece1", "piece2",
    "piece3", "patch00", "patch10", "patch01", "patch11", "cubic", "bicubic",
];

pub struct C {
    keywords: Vec<&'static str>,
}

impl C {
    /// All results are written to arguments, so that values of functions have names, too.
    pub fn new() -> C {
        let results = FUNCTIONS.iter().flat_map(|signature| signature.results).map(|group| group.name);
        C { keywords: WORDS.into_iter().chain(results).collect() }
    }
}

impl Dialect for C {
    fn keywords(&self) -> &[&'static str] {
        &self.keywords
    }

    fn constant(&self, text: &mut String, value: f64) {
        let _ = match value {
            _ if value.is_nan() => write!(text, "NAN"),
            _ if value.is_infinite() => write!(text, "({}INFINITY)", if value < 0.0 { "-" } else { "" }),
            _ if value.is_sign_negative() => write!(text, "({value:?})"),
            _ => write!(text, "{value:?}"),
        };
    }

    fn operation(&self, instruction: &Instruction) -> Spelling {
        match instruction {
            Instruction::Neg(_) => ["-", "", "", ""],
            Instruction::Add(..) => ["", " + ", "", ""],
            Instruction::Sub(..) => ["", " - ", "", ""],
            Instruction::Mul(..) => ["", " * ", "", ""],
            Instruction::Div(..) => ["", " / ", "", ""],
            Instruction::MulAdd(_, _, _, false, false) => ["", " * ", " + ", ""],
            Instruction::MulAdd(_, _, _, false, true) => ["", " * ", " - ", ""],
            Instruction::MulAdd(_, _, _, true, false) => ["-(", " * ", ") + ", ""],
            Instruction::MulAdd(_, _, _, true, true) => ["-(", " * ", ") - ", ""],
            Instruction::Unary(function, _) => match function {
                Unary::Reciprocal => ["1.0 / ", "", "", ""],
                Unary::Sqrt => ["sqrt(", ")", "", ""],
                Unary::Abs => ["fabs(", ")", "", ""],
                Unary::Sign => ["sign(", ")", "", ""],
                Unary::Sin => ["sin(", ")", "", ""],
                Unary::Cos => ["cos(", ")", "", ""],
                Unary::Tan => ["tan(", ")", "", ""],
                Unary::Asin => ["asin(", ")", "", ""],
                Unary::Acos => ["acos(", ")", "", ""],
                Unary::Exp => ["exp(", ")", "", ""],
                Unary::Ln => ["log(", ")", "", ""],
                Unary::Log10 => ["log10(", ")", "", ""],
                Unary::Sinh => ["sinh(", ")", "", ""],
                Unary::Cosh => ["cosh(", ")", "", ""],
                Unary::Tanh => ["tanh(", ")", "", ""],
                Unary::Floor => ["floor(", ")", "", ""],
            },
            Instruction::Min(..) => ["least(", ", ", ")", ""],
            Instruction::Max(..) => ["most(", ", ", ")", ""],
            Instruction::Atan2(..) => ["atan2(", ", ", ")", ""],
            Instruction::Compare(Compare::Less, ..) => ["", " < ", "", ""],
            Instruction::Compare(Compare::LessEqual, ..) => ["", " <= ", "", ""],
            Instruction::Compare(Compare::Equal, ..) => ["", " == ", "", ""],
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
        let table = &tables[usize::from(number)];
        let _ = match instruction {
            Instruction::Piece(_, orders, ..) => write!(text, "piece{}(table_{number}, ", orders.first()),
            Instruction::Patch(_, orders, ..) if table.width() == BICUBIC => {
                write!(text, "bicubic(table_{number}, {}, {}, ", orders.first(), orders.second())
            }
            Instruction::Patch(_, orders, ..) => {
                write!(text, "patch{}{}(table_{number}, ", orders.first(), orders.second())
            }
            _ => write!(text, "cell(table_{number}[0], {}, {}, ", table.rows().len(), table.width()),
        };
    }

    fn declaration(&self, mask: bool) -> [&'static str; 3] {
        if mask { ["const int ", " = ", ";\n"] } else { ["const double ", " = ", ";\n"] }
    }

    fn comment(&self, text: &mut String, line: &str) {
        let _ = writeln!(text, "/* {line} */");
    }

    fn entry(&self, text: &mut String, _: Option<Argument>, source: Source, _: &str) {
        let _ = write!(text, "{}[{}]", source.argument.name(), source.index);
    }

    fn slots(&self, text: &mut String, size: usize) {
        let _ = writeln!(text, "double w[{size}];");
    }

    fn slot(&self, text: &mut String, slot: usize) {
        let _ = write!(text, "w[{slot}]");
    }

    fn given(&self, _: bool) -> [&'static str; 2] {
        [" = ", ";\n"]
    }

    fn taken(&self, mask: bool) -> [&'static str; 2] {
        if mask { ["", " != 0.0"] } else { ["", ""] }
    }

    fn helper(&self, text: &mut String, name: &str, arguments: &[Argument], _: usize) {
        let declared: Vec<String> = apart(arguments).map(declaration).collect();
        let _ = writeln!(text, "static void {name}({}, double *w) {{", declared.join(", "));
    }

    fn end(&self, text: &mut String) {
        text.push_str("}\n");
    }

    fn call(&self, text: &mut String, name: &str, arguments: &[Argument]) {
        let names: Vec<&str> = apart(arguments).map(Argument::name).collect();
        let _ = writeln!(text, "{name}({}, w);", names.join(", "));
    }
}

/// Arguments with the parts of a whole in its place: q and v for the state.
pub fn apart(arguments: &[Argument]) -> impl Iterator<Item = Argument> {
    arguments
        .iter()
        .flat_map(|argument| match argument.parts() {
            [] => std::slice::from_ref(argument),
            parts => parts,
        })
        .copied()
}

fn declaration(argument: Argument) -> String {
    let given = argument.given();
    let kind = if matches!(given.shape, Shape::Scalar) { "double " } else { "const double *" };
    format!("{kind}{}", given.name)
}

/// `FourBar_gamma`: C has no types that functions belong to.
pub fn name_of(compiled: &Compiled, signature: &Signature) -> String {
    format!("{}_{}", compiled.mechanism.name.text, signature.name)
}

/// A function with what it was cut into, results one behind the other in `out` of the caller by their groups.
pub fn function(printer: &Printer<C>, signature: &Signature) -> String {
    let compiled = printer.compiled;
    let body = printer.body(signature.function);
    let given = apart(signature.arguments).map(declaration);
    let results = signature.results.iter().map(|group| format!("double *{}", group.name));
    let arguments: Vec<String> = given.chain(results).collect();
    let mut text = body.helpers;
    let _ = writeln!(text, "/* {} */", signature.doc.replace('\n', " "));
    let _ = writeln!(text, "static void {}({}) {{", name_of(compiled, signature), arguments.join(", "));
    text.push_str(&body.statements);
    let groups = signature.groups(&compiled.complete, &body.outputs);
    for (group, own) in signature.results.iter().zip(groups) {
        for (index, value) in own.iter().enumerate() {
            let _ = writeln!(text, "{}[{index}] = {value};", group.name);
        }
    }
    text.push_str("}\n");
    text
}

/// The tables that the functions look up in, as arrays of rows.
pub fn tables(printer: &Printer<C>) -> String {
    let graph = printer.compiled.complete.equations.graph.read();
    let mut text = String::new();
    for (number, table) in graph.tables().iter().enumerate() {
        let row = |row: &[f64]| {
            let entries: Vec<String> = row.iter().map(|entry| format!("{entry:?}")).collect();
            format!("{{{}}}", entries.join(", "))
        };
        let rows: Vec<String> = table.rows().map(row).collect();
        let (width, rows) = (table.width(), rows.join(", "));
        let _ = writeln!(text, "static const double table_{number}[][{width}] = {{{rows}}};");
    }
    text
}
