//! Names in emitted code: the user's where there are any, and never two alike.

use super::dialect::Dialect;
use crate::complete::Complete;
use crate::functions::{ARGUMENTS, Argument, FUNCTIONS, Given, Shape, Signature, Way};
use crate::schedule::{Operand, Source};
use crate::symbolic::{Node, Op};
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// Names of all sources, and of the results of the function being written.
#[derive(Clone)]
pub struct Names {
    names: Rc<BTreeMap<Source, String>>,
    /// The arguments that have an entry of this name.
    given: Rc<BTreeMap<String, Vec<Argument>>>,
    /// What the definition calls parameters and inputs, whose values may have other names in functions.
    fields: Rc<BTreeMap<Source, String>>,
    /// Words that functions use themselves.
    reserved: Rc<BTreeSet<&'static str>>,
    /// Names of instructions that are results, by index.
    results: Vec<Option<String>>,
}

impl Names {
    /// The names of a mechanism in the language that is written.
    pub fn new(complete: &Complete, hoisted: &[Node], dialect: &impl Dialect) -> Self {
        let equations = &complete.equations;
        let mut fields = BTreeMap::new();
        let mut names = BTreeMap::new();
        let reserved = reserved();
        let mut taken: BTreeSet<String> = BTreeSet::new();
        for Given { argument, shape, symbols: of, .. } in &ARGUMENTS {
            for (index, node) in of(complete).iter().enumerate() {
                let Op::Symbol(symbol) = equations.graph.read().op(*node) else { continue };
                if matches!(shape, Shape::Scalar) {
                    // Numbers are called as the argument is.
                    continue;
                }
                let source = Source { argument: *argument, index: index as u32 };
                let graph = equations.graph.read();
                let symbol = graph.symbol_name(symbol);
                if matches!(shape, Shape::Parameters | Shape::Inputs) {
                    fields.insert(source, symbol.to_string());
                }
                let mut name = readable(symbol, dialect);
                while reserved.contains(name.as_str()) || taken.contains(&name) {
                    name.push('_');
                }
                taken.insert(name.clone());
                names.insert(source, name);
            }
        }
        // A constant of the prepared model that is a parameter as it stands keeps the parameter's name.
        let parameters = &equations.symbols.parameters;
        let same = |node: &Node| parameters.iter().position(|parameter| parameter == node);
        let kept: Vec<(u32, u32)> = hoisted
            .iter()
            .enumerate()
            .filter_map(|(index, node)| Some((index as u32, same(node)? as u32)))
            .collect();
        for (index, parameter) in kept {
            let parameter = Source { argument: Argument::Parameters, index: parameter };
            if let Some(name) = names.get(&parameter).cloned() {
                names.insert(Source { argument: Argument::Constants, index }, name);
            }
        }
        let mut given: BTreeMap<String, Vec<Argument>> = BTreeMap::new();
        for (source, name) in &names {
            given.entry(name.clone()).or_default().push(source.argument);
        }
        Names {
            names: Rc::new(names),
            given: Rc::new(given),
            fields: Rc::new(fields),
            reserved: Rc::new(reserved),
            results: Vec::new(),
        }
    }

    /// The same names, with results called by what they are; `labels` in the order of the outputs. They differ from those of the arguments.
    pub fn with_results(
        &self,
        signature: &Signature,
        outputs: &[Operand],
        labels: &[Option<String>],
        dialect: &impl Dialect,
    ) -> Names {
        let is_given = |argument: Argument| {
            signature.arguments.contains(&argument) || signature.within(argument).is_some()
        };
        let is_used = |name: &String| {
            self.given.get(name).is_some_and(|arguments| arguments.iter().any(|argument| is_given(*argument)))
        };
        let mut others = BTreeSet::new();
        let mut results = Vec::new();
        for (output, label) in outputs.iter().zip(labels) {
            let (Operand::Value(index), Some(label)) = (output, label) else { continue };
            let mut name = readable(label, dialect);
            while self.reserved.contains(name.as_str()) || is_used(&name) || others.contains(&name) {
                name.push('_');
            }
            others.insert(name.clone());
            let index = *index as usize;
            results.resize(results.len().max(index + 1), None);
            results[index].get_or_insert(name);
        }
        Names { results, ..self.clone() }
    }

    /// What the definition calls a parameter or an input; nothing of other sources.
    pub fn identifier(&self, source: Source) -> &str {
        self.fields.get(&source).map_or("", String::as_str)
    }

    /// Appends the name of an instruction's value.
    pub fn push_value(&self, text: &mut String, index: u32) {
        match self.results.get(index as usize) {
            Some(Some(name)) => text.push_str(name),
            _ => push_numbered(text, 'a', index),
        }
    }

    /// Appends the name of a source.
    pub fn push_source(&self, text: &mut String, source: Source) {
        match self.names.get(&source) {
            Some(name) => text.push_str(name),
            None if source.argument == Argument::Constants => push_numbered(text, 'k', source.index),
            None => text.push_str(source.argument.name()),
        }
    }
}

/// Words that emitted functions use themselves: arguments, what results are written to, and values between helper functions.
fn reserved() -> BTreeSet<&'static str> {
    let results = FUNCTIONS.iter().flat_map(|signature| signature.results);
    let written = results.filter(|group| group.way == Way::Written).map(|group| group.name);
    ARGUMENTS.iter().map(|given| given.name).chain(written).chain(["w", "i"]).collect()
}

pub(super) fn push_numbered(text: &mut String, letter: char, index: u32) {
    text.push(letter);
    text.push_str(&index.to_string());
}

/// A name as an identifier that is no keyword and no name of an intermediate value.
fn readable(name: &str, dialect: &impl Dialect) -> String {
    let name = name.replace(['.', '[', '(', ' ', ','], "_").replace([']', ')'], "");
    let is_number = |text: &str| !text.is_empty() && text.chars().all(|c| c.is_ascii_digit());
    let numbered = |prefix: char| name.strip_prefix(prefix).is_some_and(is_number);
    // What goes from round to round.
    let carried =
        |rest: &str| rest.split_once('_').is_some_and(|(one, two)| is_number(one) && is_number(two));
    let is_taken = ['a', 'b', 'k', 'n', 's'].into_iter().any(numbered)
        || name.strip_prefix('c').is_some_and(carried)
        || dialect.keywords().contains(&name.as_str());
    dialect.identifier(if is_taken { name + "_" } else { name })
}

/// Rust's own words.
pub const KEYWORDS: [&str; 51] = [
    "as", "async", "await", "break", "const", "continue", "crate", "dyn", "else", "enum", "extern", "false",
    "fn", "for", "gen", "if", "impl", "in", "let", "loop", "match", "mod", "move", "mut", "pub", "ref",
    "return", "self", "Self", "static", "struct", "super", "trait", "true", "type", "unsafe", "use", "where",
    "while", "abstract", "become", "box", "do", "final", "macro", "override", "priv", "try", "typeof",
    "unsized", "virtual",
];

/// Whether a word is Rust's own.
pub fn is_keyword(name: &str) -> bool {
    KEYWORDS.contains(&name) || name == "_"
}

/// A field of an emitted struct: the user's name, raw if it is a keyword.
pub fn field(name: &str) -> String {
    match name {
        "self" | "Self" | "super" | "crate" => format!("{name}_"),
        _ if KEYWORDS.contains(&name) => format!("r#{name}"),
        _ => name.to_string(),
    }
}

/// The name of a mechanism where emitted code has names of its own in scope: another one if it is among them.
pub fn inner(name: &str) -> String {
    if IN_SCOPE.contains(&name) { format!("{name}OfTheUser") } else { name.to_string() }
}

/// Types, traits and variants that implementations have in scope: short names of arrays, what the runtime exports to
/// emitted code, the prelude.
const IN_SCOPE: [&str; 124] = [
    "Constants",
    "Phases",
    "Q",
    "V",
    "Z",
    "Gates",
    "Trigger",
    "Lambda",
    "Mass",
    "Jacobian",
    "Conditions",
    "ConditionJacobian",
    "Factor",
    "System",
    "Store",
    "Lu",
    "Dense",
    "Basis",
    "Reduced",
    "Stiffness",
    "Damping",
    "RowStiffness",
    "RowDamping",
    "RateTangent",
    "InputTangent",
    "InternalTangent",
    "FrictionTangent",
    "InternalRateTangent",
    "ParameterTangent",
    "OutputTangent",
    "CoordinateTangent",
    "StateMatrix",
    "InputMatrix",
    "OutputMatrix",
    "Feedthrough",
    "Unknowns",
    "Bordered",
    "Parameters",
    "Inputs",
    "Outputs",
    "R",
    "Angle",
    "AssembleExt",
    "BodyMotion",
    "Reaction",
    "Report",
    "AssemblyError",
    "SettingError",
    "SimulationError",
    "Fields",
    "Layout",
    "MultiTurn",
    "Assemble",
    "Condition",
    "ConditionKind",
    "Elimination",
    "Flips",
    "Mechanism",
    "Row",
    "Tangent",
    "Variables",
    "SpatialMotion",
    "SpatialReaction",
    "Turns",
    "Real",
    "Kinematics",
    "Motion",
    "State",
    "Vector",
    "Option",
    "Some",
    "None",
    "Result",
    "Ok",
    "Err",
    "Default",
    "Clone",
    "Copy",
    "Send",
    "Sync",
    "Sized",
    "Drop",
    "Fn",
    "FnMut",
    "FnOnce",
    "AsyncFn",
    "AsyncFnMut",
    "AsyncFnOnce",
    "Iterator",
    "IntoIterator",
    "Extend",
    "DoubleEndedIterator",
    "ExactSizeIterator",
    "FromIterator",
    "AsRef",
    "AsMut",
    "From",
    "Into",
    "TryFrom",
    "TryInto",
    "Eq",
    "PartialEq",
    "Ord",
    "PartialOrd",
    "Future",
    "IntoFuture",
    "Unpin",
    "Debug",
    "Parametric",
    "InScalars",
    "Unknown",
    "Corrected",
    "LagrangeIndex1",
    "Rk4",
    "SemiImplicitEuler",
    "Tick",
    "A",
    "B",
    "C",
    "S",
    "table",
    "tabled",
    "c_interface",
    "tables",
];
