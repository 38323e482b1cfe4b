//! Names in emitted code: the user's where there are any, and never two alike.

use crate::equations::Equations;
use crate::schedule::{Operand, Source};
use crate::symbolic::{Node, Op};
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// Names of all sources, and which arguments the function being written has.
pub struct Names {
    names: Rc<BTreeMap<Source, String>>,
    /// Fields of the parameters, whose values may have other names in functions.
    parameter_fields: Rc<Vec<String>>,
    input_fields: Vec<String>,
    arguments: Vec<Argument>,
    taken: Rc<BTreeSet<String>>,
    /// Names of instructions that are results, by index.
    results: Vec<Option<String>>,
}

/// An argument of an emitted function and its type.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Argument {
    Constants,
    Parameters,
    Phases,
    Time,
    Q,
    V,
    Inputs,
    TwoAlpha,
    BetaSquared,
    Acceleration,
    Lambda,
    Target,
    Compliance,
    GivenForces,
    GivenRows,
    Store,
    Lu,
}

impl Names {
    pub fn new(equations: &Equations, hoisted: &[Node]) -> Self {
        let symbols = &equations.symbols;
        let mut names = BTreeMap::new();
        let mut taken: BTreeSet<String> = RESERVED.iter().map(|word| word.to_string()).collect();
        let mut claim = |nodes: &[Node], source: fn(u32) -> Source| {
            for (index, node) in nodes.iter().enumerate() {
                let Op::Symbol(symbol) = equations.graph.read().op(*node) else { continue };
                let mut name = readable(equations.graph.read().symbol_name(symbol));
                while !taken.insert(name.clone()) {
                    name.push('_');
                }
                names.insert(source(index as u32), name);
            }
        };
        claim(&symbols.q, Source::Q);
        claim(&symbols.v, Source::V);
        claim(&symbols.inputs, Source::Input);
        claim(&symbols.acceleration, Source::Acceleration);
        claim(&symbols.lambda, Source::Lambda);
        claim(&symbols.targets, Source::Target);
        claim(&symbols.given_forces, Source::GivenForce);
        claim(&symbols.given_rows, Source::GivenRow);
        claim(&symbols.kept, Source::Kept);
        claim(&symbols.lu, Source::Lu);
        claim(&symbols.parameters, Source::Parameter);
        claim(&symbols.phases, Source::Phase);
        // A constant of the prepared model that is a parameter as it stands keeps the parameter's name.
        let same = |node: &Node| symbols.parameters.iter().position(|parameter| parameter == node);
        let kept: Vec<(u32, u32)> = hoisted
            .iter()
            .enumerate()
            .filter_map(|(index, node)| Some((index as u32, same(node)? as u32)))
            .collect();
        for (index, parameter) in kept {
            if let Some(name) = names.get(&Source::Parameter(parameter)).cloned() {
                names.insert(Source::Prepared(index), name);
            }
        }
        let fields = symbols.parameters.iter().map(|node| match equations.graph.read().op(*node) {
            Op::Symbol(symbol) => field(equations.graph.read().symbol_name(symbol)),
            _ => String::new(),
        });
        Names {
            names: Rc::new(names),
            parameter_fields: Rc::new(fields.collect()),
            input_fields: Vec::new(),
            arguments: Vec::new(),
            taken: Rc::new(taken),
            results: Vec::new(),
        }
    }

    /// The same names within a function of these arguments, whose inputs have these field names.
    pub fn within(&self, arguments: &[Argument], input_fields: &[String]) -> Names {
        Names {
            names: Rc::clone(&self.names),
            parameter_fields: Rc::clone(&self.parameter_fields),
            input_fields: input_fields.to_vec(),
            arguments: arguments.to_vec(),
            taken: Rc::clone(&self.taken),
            results: Vec::new(),
        }
    }

    /// The same names, with results called by what they are; `labels` in the order of the outputs.
    pub fn with_results(mut self, outputs: &[Operand], labels: &[String]) -> Names {
        let mut used = BTreeSet::new();
        for (output, label) in outputs.iter().zip(labels) {
            let Operand::Value(index) = output else { continue };
            let mut name = readable(label);
            while self.taken.contains(&name) || used.contains(&name) {
                name.push('_');
            }
            used.insert(name.clone());
            let index = *index as usize;
            self.results.resize(self.results.len().max(index + 1), None);
            self.results[index].get_or_insert(name);
        }
        self
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
        match (source, self.names.get(&source)) {
            (_, Some(name)) => text.push_str(name),
            (Source::Time, _) => text.push_str("time"),
            (Source::TwoAlpha, _) => text.push_str("two_alpha"),
            (Source::BetaSquared, _) => text.push_str("beta_squared"),
            (Source::Compliance, _) => text.push_str("compliance"),
            (Source::Prepared(index), _) => push_numbered(text, 'k', index),
            (_, None) => {}
        }
    }

    /// Where a source is read from; `None` if it is an argument itself.
    pub fn place(&self, source: Source) -> Option<String> {
        Some(match source {
            Source::Time | Source::TwoAlpha | Source::BetaSquared | Source::Compliance => return None,
            Source::Parameter(index) => format!("parameters.{}", self.parameter_fields[index as usize]),
            Source::Phase(index) => format!("phases[{index}]"),
            Source::Q(index) => format!("q[{index}]"),
            Source::V(index) => format!("v[{index}]"),
            Source::Input(index) => format!("u.{}", self.input_fields[index as usize]),
            Source::Acceleration(index) => format!("a[{index}]"),
            Source::Lambda(index) => format!("lambda[{index}]"),
            Source::Target(index) => format!("target[{index}]"),
            Source::GivenForce(index) => format!("forces[{index}]"),
            Source::GivenRow(index) => format!("rows[{index}]"),
            Source::Kept(index) => format!("store[{index}]"),
            Source::Lu(index) => format!("lu[{index}]"),
            Source::Prepared(index) => format!("constants[{index}]"),
        })
    }

    /// Parameters of a helper function, with its types to be found by inference of the caller's aliases.
    pub fn signature(&self) -> String {
        self.arguments.iter().map(|argument| argument.declaration()).collect::<Vec<_>>().join(", ")
    }

    /// The same arguments as they are passed on.
    pub fn arguments(&self) -> String {
        self.arguments.iter().map(|argument| argument.name()).collect::<Vec<_>>().join(", ")
    }
}

impl Argument {
    pub fn name(self) -> &'static str {
        match self {
            Argument::Constants => "constants",
            Argument::Parameters => "parameters",
            Argument::Phases => "phases",
            Argument::Time => "time",
            Argument::Q => "q",
            Argument::V => "v",
            Argument::Inputs => "u",
            Argument::TwoAlpha => "two_alpha",
            Argument::BetaSquared => "beta_squared",
            Argument::Acceleration => "a",
            Argument::Lambda => "lambda",
            Argument::Target => "target",
            Argument::Compliance => "compliance",
            Argument::GivenForces => "forces",
            Argument::GivenRows => "rows",
            Argument::Store => "store",
            Argument::Lu => "lu",
        }
    }

    /// `q: &Q<R>`, by the type aliases that stand beside the functions.
    fn declaration(self) -> String {
        let kind = match self {
            Argument::Constants => "&Constants<R>",
            Argument::Parameters => "&Parameters<R>",
            Argument::Phases => "&Phases<R>",
            Argument::Time | Argument::TwoAlpha | Argument::BetaSquared | Argument::Compliance => "R",
            Argument::Q => "&Q<R>",
            Argument::V | Argument::Acceleration | Argument::GivenForces => "&V<R>",
            Argument::Inputs => "&Inputs<R>",
            Argument::Lambda | Argument::GivenRows => "&Lambda<R>",
            Argument::Store => "&Store<R>",
            Argument::Lu => "&Lu<R>",
            Argument::Target => "&Conditions<R>",
        };
        format!("{}: {kind}", self.name())
    }
}

/// Words that emitted functions use themselves.
const RESERVED: [&str; 21] = [
    "time",
    "q",
    "v",
    "u",
    "a",
    "lambda",
    "target",
    "constants",
    "parameters",
    "phases",
    "two_alpha",
    "beta_squared",
    "compliance",
    "forces",
    "rows",
    "store",
    "lu",
    "w",
    "out",
    "stiffness_out",
    "damping_out",
];

fn push_numbered(text: &mut String, letter: char, index: u32) {
    text.push(letter);
    text.push_str(&index.to_string());
}

/// A name as an identifier that is no keyword and no name of an intermediate value.
fn readable(name: &str) -> String {
    let name = name.replace(['.', '[', '(', ' ', ','], "_").replace([']', ')'], "");
    let numbered = |prefix: char| {
        name.strip_prefix(prefix)
            .is_some_and(|rest| !rest.is_empty() && rest.chars().all(|c| c.is_ascii_digit()))
    };
    if numbered('a') || numbered('k') || KEYWORDS.contains(&name.as_str()) { name + "_" } else { name }
}

const KEYWORDS: [&str; 51] = [
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
const IN_SCOPE: [&str; 98] = [
    "Constants",
    "Phases",
    "Q",
    "V",
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
    "AssembleExt",
    "BodyMotion",
    "Reaction",
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
    "SpatialMotion",
    "SpatialReaction",
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
];
