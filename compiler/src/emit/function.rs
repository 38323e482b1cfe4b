//! How one function is written, by its signature: head, loads, instructions, results.
//!
//! ```text
//! fn acceleration(&self, time: R, q: &Q<R>, v: &V<R>, u: &Inputs<R>, a_out: &mut V<R>, lambda_out: &mut Lambda<R>) -> R {
//! let constants = &self.constants;
//! …
//! *a_out = […];
//! *lambda_out = […];
//! smallest_pivot
//! }
//! ```

use super::names::field;
use super::{Emitter, array};
use crate::functions::{Argument, Function, Group, Interface, Kind, Shape, Signature, Way};
use std::fmt::Write;

/// One function of the model, or of a trait; helper functions go to `helpers`.
pub fn function(text: &mut String, helpers: &mut String, emitter: &Emitter, function: Function) {
    let signature = function.signature();
    if signature.interface == Interface::Model {
        for line in signature.doc.lines() {
            let _ = writeln!(text, "/// {line}");
        }
        text.push_str("pub ");
    }
    let body = emitter.body(function, helpers);
    let _ = writeln!(text, "{} {{", emitter.head(signature));
    if body.reads_constants {
        text.push_str("let constants = &self.constants;\n");
    }
    text.push_str(&body.statements);
    let _ = writeln!(text, "{}\n}}", results(signature, emitter, &body.outputs));
}

/// `fn gamma(&self, time: R, q: &Q<R>, v: &V<R>, out: &mut Lambda<R>)`, with types and lengths of shapes.
pub fn head(
    signature: &Signature,
    type_of: impl Fn(Shape) -> String,
    length_of: impl Fn(Shape) -> String,
) -> String {
    let given = signature.arguments.iter().filter(|argument| **argument != Argument::Constants);
    let given = given.map(|argument| declaration(*argument, &type_of));
    let written = signature.results.iter().filter(|group| group.way == Way::Written);
    let written = written.map(|group| format!("{}: &mut {}", group.name, type_of(group.shape)));
    let arguments: Vec<String> = ["&self".to_string()].into_iter().chain(given).chain(written).collect();
    let values: Vec<&Group> = signature.results.iter().filter(|group| group.way == Way::Value).collect();
    let value = match values.as_slice() {
        [] => String::new(),
        [one] => format!(" -> {}", type_of(one.shape)),
        [first, ..] => format!(" -> [[R; {}]; {}]", values.len(), length_of(first.shape)),
    };
    format!("fn {}({}){value}", signature.name, arguments.join(", "))
}

/// `q: &Q<R>`.
pub fn declaration(argument: Argument, type_of: impl Fn(Shape) -> String) -> String {
    let given = argument.given();
    let reference = if matches!(given.shape, Shape::Scalar) { "" } else { "&" };
    format!("{}: {reference}{}", given.name, type_of(given.shape))
}

impl Emitter<'_> {
    /// The head of a function, by the aliases that stand beside it.
    pub fn head(&self, signature: &Signature) -> String {
        head(signature, |shape| self.type_of(shape), |shape| self.entries(shape).to_string())
    }

    /// A shape by the aliases that stand beside the functions.
    pub fn type_of(&self, shape: Shape) -> String {
        let mechanism = self.mechanism;
        let alias = match shape {
            Shape::Scalar => return "R".to_string(),
            // A type alias may not leave its scalar unused, so `()` stands for itself where nothing is given.
            Shape::Inputs if mechanism.inputs.is_empty() => return "()".to_string(),
            Shape::Outputs if mechanism.outputs.is_empty() => return "()".to_string(),
            Shape::Bodies(record) | Shape::Joints(record) => {
                let count = self.entries(shape);
                return format!("[{}<R>; {count}]", record.of(mechanism.space).name);
            }
            Shape::Loads | Shape::Drivers | Shape::Masses => return format!("[R; {}]", self.entries(shape)),
            Shape::State => return "State<Q<R>, V<R>>".to_string(),
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

    /// How many entries lists of this shape have.
    pub fn entries(&self, shape: Shape) -> usize {
        let (mechanism, compiled) = (self.mechanism, self.compiled);
        let (equations, solved) = (&compiled.equations, &compiled.solved);
        match shape {
            Shape::Scalar => 1,
            Shape::Positions => equations.layout.positions(),
            Shape::Velocities => equations.layout.velocities(),
            Shape::State => equations.layout.positions() + equations.layout.velocities(),
            Shape::Rows => equations.rows.len(),
            Shape::Matrix(matrix) => matrix.places(equations).count(),
            Shape::Conditions => equations.conditions.len(),
            Shape::Store => solved.stored.as_ref().map_or(0, |stored| stored.kept.len()),
            Shape::Lu => solved.null_space.as_ref().map_or(0, |written| written.kept.len()),
            Shape::Constants => compiled.programs.prepared,
            Shape::Phases => equations.symbols.phases.len(),
            Shape::Parameters => mechanism.parameters.len(),
            Shape::Inputs => mechanism.inputs.len(),
            Shape::Outputs => mechanism.outputs.len(),
            Shape::Bodies(_) => mechanism.bodies.len(),
            Shape::Joints(_) => mechanism.joints.len(),
            Shape::Loads => mechanism.loads.len(),
            Shape::Drivers => mechanism.drivers.len(),
            Shape::Masses => equations.masses.len(),
        }
    }
}

/// Results to where they go, the value last.
fn results(signature: &Signature, emitter: &Emitter, outputs: &[String]) -> String {
    let compiled = emitter.compiled;
    let groups = signature.groups(&compiled.equations, &compiled.solved, outputs);
    let mut lines = Vec::new();
    let mut values = Vec::new();
    for (group, own) in signature.results.iter().zip(groups) {
        match group.way {
            Way::Written => lines.push(format!("*{} = {};", group.name, list(own))),
            Way::Value => values.push((group.shape, own)),
        }
    }
    match values.as_slice() {
        [] => {}
        [(shape, own)] => lines.push(value(*shape, emitter, own)),
        [(_, first), ..] => {
            let entry = |index: usize| array(values.iter().map(|(_, own)| own[index].clone()));
            lines.push(array((0..first.len()).map(entry)));
        }
    }
    lines.join("\n")
}

fn value(shape: Shape, emitter: &Emitter, own: &[String]) -> String {
    let mechanism = emitter.mechanism;
    match shape {
        Shape::Scalar => own.concat(),
        Shape::Outputs if own.is_empty() => String::new(),
        Shape::Outputs => {
            let names = shape.names(mechanism, &emitter.compiled.equations);
            let values = names.iter().zip(own).map(|(name, value)| format!("{}: {value}", field(name)));
            format!("{}Outputs {{ {} }}", emitter.name, values.collect::<Vec<_>>().join(", "))
        }
        Shape::Bodies(record) | Shape::Joints(record) => {
            let kind = record.of(mechanism.space);
            array(own.chunks(kind.length()).map(|entry| literal_of(kind, entry)))
        }
        _ => list(own),
    }
}

/// `Reaction { force: [x, y], torque: z }`.
fn literal_of(kind: &Kind, mut entry: &[String]) -> String {
    let fields = kind.fields.iter().map(|field| {
        let (own, rest) = entry.split_at(field.length());
        entry = rest;
        format!("{}: {}", field.name, nested(field.extents, own))
    });
    format!("{} {{ {} }}", kind.name, fields.collect::<Vec<_>>().join(", "))
}

/// Arrays of arrays of these extents, the outermost first.
fn nested(extents: &[usize], own: &[String]) -> String {
    match extents {
        [] => own.concat(),
        [_] => list(own),
        [first, inner @ ..] => array(own.chunks(own.len() / first).map(|part| nested(inner, part))),
    }
}

/// `[a, b, c]` of texts.
pub fn list(texts: &[String]) -> String {
    array(texts.iter().cloned())
}
