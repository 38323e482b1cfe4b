//! The functions of the equations in C: heads, bodies, and what becomes of results.

use super::Writer;
use super::dialect::read;
use super::names::field;
use crate::compiled::Compiled;
use crate::functions::{Argument, FUNCTIONS, Function, Group, Interface, Kind, Shape, Signature, Way};
use std::fmt::Write;

/// Of the functions that the interface does not have, those that steps call.
const INNER: [Function; 6] = [
    Function::Prepare,
    Function::RowScales,
    Function::Factor,
    Function::Solve,
    Function::StartTargets,
    Function::StartInternal,
];

/// How a function of the equations is called: with what has entries of these arguments, and with where results go.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Call {
    pub function: Function,
    /// `four_bar_gamma`.
    pub name: String,
    /// The model in the place of its constants.
    pub given: Vec<Argument>,
    pub written: Vec<Written>,
    /// Whether it returns a number, its last result.
    pub value: bool,
}

/// An argument for results.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Written {
    /// The type of what is written, or of its entries.
    pub kind: String,
    pub name: &'static str,
    /// The number of entries of a list.
    pub extent: Option<usize>,
}

impl Writer<'_> {
    /// The functions that users call.
    pub fn public(&self) -> impl Iterator<Item = &'static Signature> {
        let is_public = |signature: &&Signature| {
            matches!(signature.interface, Interface::Mechanism | Interface::Model | Interface::Tangent)
        };
        FUNCTIONS.iter().filter(is_public).filter(|signature| self.computes(signature))
    }

    /// The functions that only steps call, as far as they do.
    pub fn inner(&self) -> impl Iterator<Item = &'static Signature> {
        let needed = |function: &Function| match function {
            Function::Prepare => self.compiled.entries(Shape::Constants) > 0,
            Function::StartInternal => self.compiled.entries(Shape::Internal) > 0,
            Function::StartTargets => !self.stated_angles().is_empty(),
            _ => self.corrects(),
        };
        INNER.into_iter().filter(needed).map(Function::signature)
    }

    /// Whether steps can be corrected: there are constraints, and their projection is written out.
    pub fn corrects(&self) -> bool {
        self.compiled.entries(Shape::Rows) > 0 && self.compiled.complete.further.stored.is_some()
    }

    /// Whether the mechanism has something that the function computes.
    fn computes(&self, signature: &Signature) -> bool {
        let complete = &self.compiled.complete;
        let rows = self.compiled.entries(Shape::Rows) > 0;
        let stabilised = signature.function == Function::AccelerationBaumgarte;
        (signature.emitted)(complete)
            && (rows || !stabilised)
            && signature.results.iter().any(|group| self.length(group) > 0)
    }

    fn length(&self, group: &Group) -> usize {
        (group.nodes)(&self.compiled.complete).len()
    }

    /// `void four_bar_gamma(const four_bar_model_t *model, double time, const double q[], …)`.
    pub fn head(&self, signature: &'static Signature) -> String {
        let (prefix, name) = (&self.prefix.lower, signature.name);
        let dialect = &self.printer.dialect;
        let given = self.given(signature).map(|argument| match argument {
            Argument::Constants => format!("const {prefix}_model_t *model"),
            argument => dialect.declaration(argument),
        });
        let results = self.written(signature).map(|group| {
            let Written { kind, name, extent, .. } = self.result(group);
            if extent.is_some() { format!("{kind} {name}[]") } else { format!("{kind} *{name}") }
        });
        let value = if self.value(signature).is_some() { self.scalar.c() } else { "void" };
        format!("{value} {prefix}_{name}({})", given.chain(results).collect::<Vec<_>>().join(", "))
    }

    /// How the function is called.
    pub fn call(&self, signature: &'static Signature) -> Call {
        Call {
            function: signature.function,
            name: format!("{}_{}", self.prefix.lower, signature.name),
            given: self.given(signature).collect(),
            written: self.written(signature).map(|group| self.result(group)).collect(),
            value: self.value(signature).is_some(),
        }
    }

    /// The arguments that have entries; constants stand for the model.
    fn given(&self, signature: &'static Signature) -> impl Iterator<Item = Argument> {
        let arguments = signature.arguments.iter().copied();
        arguments.filter(|argument| {
            *argument == Argument::Constants || self.compiled.entries(argument.given().shape) > 0
        })
    }

    /// What it returns, if that is one number.
    fn value(&self, signature: &'static Signature) -> Option<&'static Group> {
        signature.results.iter().find(|group| is_value(group))
    }

    /// What it writes to arguments.
    fn written(&self, signature: &'static Signature) -> impl Iterator<Item = &'static Group> {
        let has_length = |group: &&Group| self.length(group) > 0 || matches!(group.shape, Shape::Constants);
        signature.results.iter().filter(|group| !is_value(group)).filter(has_length)
    }

    fn result(&self, group: &'static Group) -> Written {
        let (prefix, real) = (&self.prefix.lower, self.scalar.c().to_string());
        let entries = self.compiled.entries(group.shape);
        let (kind, extent) = match group.shape {
            Shape::Outputs => (format!("{prefix}_outputs_t"), None),
            Shape::Bodies(_) => (format!("{prefix}_motion_t"), Some(entries)),
            Shape::Joints(_) => (format!("{prefix}_reaction_t"), Some(entries)),
            _ => (real, Some(entries)),
        };
        Written { kind, name: group.name, extent }
    }

    /// The function, behind those that it was cut into.
    pub fn function(&self, signature: &'static Signature, is_static: bool) -> String {
        let body = self.printer.body(signature.function);
        let mut text = indented(&body.helpers);
        if is_static {
            text.push_str("static ");
        }
        let _ = writeln!(text, "{}\n{{", self.head(signature));
        let mut statements = String::new();
        let is_read: Vec<Argument> = read(signature.arguments, &body.reads).collect();
        for argument in self.given(signature) {
            match argument {
                Argument::Constants if is_read.contains(&argument) => {
                    let _ = writeln!(
                        statements,
                        "const {} *const constants = model->constants;",
                        self.scalar.c()
                    );
                }
                Argument::Constants => statements.push_str("(void)model;\n"),
                argument if is_read.contains(&argument) => {}
                argument => {
                    let _ = writeln!(statements, "(void){};", argument.name());
                }
            }
        }
        statements.push_str(&body.statements);
        let groups = signature.groups(&self.compiled.complete, &body.outputs);
        for (group, own) in signature.results.iter().zip(groups) {
            match (group.way, group.shape) {
                (Way::Value, Shape::Scalar) => {
                    let _ = writeln!(statements, "return {};", own.concat());
                }
                (_, shape) if body.placed && shape.is_list() => {}
                _ => self.assign(&mut statements, group, own),
            }
        }
        text.push_str(&indented(&statements));
        text.push_str("}\n");
        text
    }

    fn assign(&self, text: &mut String, group: &Group, own: &[String]) {
        let Compiled { mechanism, complete, .. } = self.compiled;
        let name = group.name;
        let mut line = |place: &str, value: &String| {
            let _ = writeln!(text, "{name}{place} = {value};");
        };
        match group.shape {
            Shape::Outputs => {
                let names = group.shape.names(mechanism, &complete.equations);
                names.iter().zip(own).for_each(|(name, value)| line(&format!("->{}", field(name)), value));
            }
            Shape::Bodies(record) | Shape::Joints(record) => {
                let kind = record.of(mechanism.space);
                for (index, entry) in own.chunks(kind.length().max(1)).enumerate() {
                    let places = kind.places();
                    places
                        .iter()
                        .zip(entry)
                        .for_each(|(place, value)| line(&format!("[{index}]{place}"), value));
                }
            }
            Shape::Scalar => own.iter().for_each(|value| {
                let _ = writeln!(text, "*{name} = {value};");
            }),
            _ => own.iter().enumerate().for_each(|(index, value)| line(&format!("[{index}]"), value)),
        }
    }

    /// The struct of an entry with fields.
    pub fn record(&self, name: &str, kind: &Kind) -> String {
        let (prefix, real) = (&self.prefix.lower, self.scalar.c());
        let mut text = format!("typedef struct {prefix}_{name}_t {{\n");
        for field in kind.fields {
            let extents: String = field.extents.iter().map(|extent| format!("[{extent}]")).collect();
            let _ = writeln!(text, "    {real} {}{extents};", field.name);
        }
        let _ = writeln!(text, "}} {prefix}_{name}_t;");
        text
    }
}

/// Whether a function returns it.
fn is_value(group: &Group) -> bool {
    group.way == Way::Value && matches!(group.shape, Shape::Scalar)
}

/// Statements moved in; what begins or ends a function stands at the margin.
fn indented(text: &str) -> String {
    let mut moved = String::new();
    for line in text.lines() {
        let margin = line.is_empty() || line == "{" || line == "}" || line.starts_with("static ");
        moved.push_str(if margin { "" } else { "    " });
        moved.push_str(line);
        moved.push('\n');
    }
    moved
}
