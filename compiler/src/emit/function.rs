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
use super::rust::{OUT, type_of};
use super::{Emitter, array};
use crate::compiled::Compiled;
use crate::functions::{Argument, FUNCTIONS, Function, Group, Interface, Kind, Shape, Signature, Way};
use std::fmt::Write;

/// Solutions of up to so many operations stand where they are called, once for each stage of a step: a call would cost a fifth.
const INLINED: usize = 100;

/// All functions of the model, or of a trait; helper functions go to `helpers`.
pub fn functions(text: &mut String, helpers: &mut String, emitter: &Emitter, interface: Interface) {
    let complete = &emitter.compiled.complete;
    let own = FUNCTIONS.iter().filter(|signature| signature.interface == interface);
    for signature in own.filter(|signature| (signature.emitted)(complete)) {
        if signature.function == Function::AccelerationBaumgarte && complete.equations.rows.is_empty() {
            // Nothing to stabilise.
            let _ = writeln!(
                text,
                "{} {{\n<Self as Mechanism<R>>::acceleration(self, time, state, u, a_out, lambda_out)\n}}",
                emitter.head(signature)
            );
        } else {
            function(text, helpers, emitter, signature);
        }
    }
}

fn function(text: &mut String, helpers: &mut String, emitter: &Emitter, signature: &Signature) {
    if signature.interface == Interface::Model {
        for line in signature.doc.lines() {
            let _ = writeln!(text, "/// {line}");
        }
        text.push_str("pub ");
    }
    let body = emitter.printer.body(signature.function);
    let leads = emitter.compiled.complete.further.leads;
    // The others are asked where these do not serve.
    let is_asked_first = signature.function.pair() == Some(usize::from(leads));
    if is_asked_first && body.operations <= INLINED {
        text.push_str("#[inline(always)] ");
    }
    helpers.push_str(&body.helpers);
    let _ = writeln!(text, "{} {{", emitter.head(signature));
    if body.reads_constants {
        text.push_str("let constants = &self.constants;\n");
    }
    text.push_str(&body.statements);
    let results = if body.placed {
        placed(signature, emitter, &body.outputs)
    } else {
        results(signature, emitter, &body.outputs)
    };
    let _ = writeln!(text, "{results}\n}}");
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
        head(signature, |shape| self.type_of(shape), |shape| self.compiled.entries(shape).to_string())
    }

    pub fn type_of(&self, shape: Shape) -> String {
        type_of(self.compiled, shape)
    }
}

/// Results to where they go, the value last.
fn results(signature: &Signature, emitter: &Emitter, outputs: &[String]) -> String {
    let compiled = emitter.compiled;
    let groups = signature.groups(&compiled.complete, outputs);
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

/// The value where the entries of lists are written.
fn placed(signature: &Signature, emitter: &Emitter, outputs: &[String]) -> String {
    let groups = signature.groups(&emitter.compiled.complete, outputs);
    let mut values = signature.results.iter().zip(groups).filter(|(group, _)| group.way == Way::Value);
    match values.next() {
        None => String::new(),
        Some((group, own)) if !group.shape.is_list() => value(group.shape, emitter, own),
        Some(_) => OUT.to_string(),
    }
}

/// The list that is a function's value, all zeros; nothing where its value is none.
pub fn zeros(compiled: &Compiled, signature: &Signature) -> Option<String> {
    let values: Vec<&Group> = signature.results.iter().filter(|group| group.way == Way::Value).collect();
    let [first, others @ ..] = values.as_slice() else { return None };
    let zero = |many: usize| vec!["R::ZERO".to_string(); many];
    let entry = match (first.shape, others) {
        (Shape::Scalar | Shape::Outputs, _) => return None,
        (Shape::Bodies(record) | Shape::Joints(record), _) => {
            let kind = record.of(compiled.mechanism.space);
            literal_of(kind, &zero(kind.length()))
        }
        (_, []) => "R::ZERO".to_string(),
        (_, others) => list(&zero(1 + others.len())),
    };
    Some(format!("[{entry}; {}]", compiled.entries(first.shape)))
}

fn value(shape: Shape, emitter: &Emitter, own: &[String]) -> String {
    let mechanism = emitter.mechanism;
    match shape {
        Shape::Scalar => own.concat(),
        Shape::Outputs if own.is_empty() => String::new(),
        Shape::Outputs => {
            let names = shape.names(mechanism, &emitter.compiled.complete.equations);
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
