//! Names in emitted code: the user's where there are any, and never two alike.

use super::Emitter;
use super::function::declaration;
use crate::equations::Equations;
use crate::functions::{ARGUMENTS, Argument, FUNCTIONS, Given, Shape, Way};
use crate::schedule::{Operand, Source};
use crate::symbolic::{Node, Op};
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// Names of all sources, and which arguments the function being written has.
pub struct Names {
    names: Rc<BTreeMap<Source, String>>,
    /// Fields of the parameters and inputs, whose values may have other names in functions.
    parameter_fields: Rc<Vec<String>>,
    input_fields: Rc<Vec<String>>,
    arguments: &'static [Argument],
    taken: Rc<BTreeSet<String>>,
    /// Names of instructions that are results, by index.
    results: Vec<Option<String>>,
}

impl Names {
    pub fn new(equations: &Equations, hoisted: &[Node]) -> Self {
        let symbols = &equations.symbols;
        let mut names = BTreeMap::new();
        let mut taken = reserved();
        for Given { argument, shape, symbols: of, .. } in &ARGUMENTS {
            for (index, node) in of(symbols).iter().enumerate() {
                let Op::Symbol(symbol) = equations.graph.op(*node) else { continue };
                if matches!(shape, Shape::Scalar) {
                    // Numbers are called as the argument is.
                    continue;
                }
                let mut name = readable(equations.graph.symbol_name(symbol));
                while !taken.insert(name.clone()) {
                    name.push('_');
                }
                names.insert(Source { argument: *argument, index: index as u32 }, name);
            }
        }
        // A constant of the prepared model that is a parameter as it stands keeps the parameter's name.
        let same = |node: &Node| symbols.parameters.iter().position(|parameter| parameter == node);
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
        let fields = |nodes: &[Node]| {
            let of = |node: &Node| match equations.graph.op(*node) {
                Op::Symbol(symbol) => field(equations.graph.symbol_name(symbol)),
                _ => String::new(),
            };
            Rc::new(nodes.iter().map(of).collect())
        };
        Names {
            names: Rc::new(names),
            parameter_fields: fields(&symbols.parameters),
            input_fields: fields(&symbols.inputs),
            arguments: &[],
            taken: Rc::new(taken),
            results: Vec::new(),
        }
    }

    /// The same names within a function of these arguments.
    pub fn within(&self, arguments: &'static [Argument]) -> Names {
        Names {
            names: Rc::clone(&self.names),
            parameter_fields: Rc::clone(&self.parameter_fields),
            input_fields: Rc::clone(&self.input_fields),
            arguments,
            taken: Rc::clone(&self.taken),
            results: Vec::new(),
        }
    }

    /// The same names, with results called by what they are; `labels` in the order of the outputs.
    pub fn with_results(mut self, outputs: &[Operand], labels: &[Option<String>]) -> Names {
        let mut used = BTreeSet::new();
        for (output, label) in outputs.iter().zip(labels) {
            let (Operand::Value(index), Some(label)) = (output, label) else { continue };
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
        match self.names.get(&source) {
            Some(name) => text.push_str(name),
            None if source.argument == Argument::Constants => push_numbered(text, 'k', source.index),
            None => text.push_str(source.argument.name()),
        }
    }

    /// Where a source is read from; `None` if it is an argument itself.
    pub fn place(&self, Source { argument, index }: Source) -> Option<String> {
        let given = argument.given();
        Some(match given.shape {
            Shape::Scalar => return None,
            Shape::Parameters => format!("{}.{}", given.name, self.parameter_fields[index as usize]),
            Shape::Inputs => format!("{}.{}", given.name, self.input_fields[index as usize]),
            Shape::Positions | Shape::Velocities if self.is_of_state(argument) => {
                format!("{}.{}[{index}]", Argument::State.name(), given.name)
            }
            _ => format!("{}[{index}]", given.name),
        })
    }

    /// Whether q or v come as parts of the state.
    fn is_of_state(&self, argument: Argument) -> bool {
        matches!(argument, Argument::Q | Argument::V) && self.arguments.contains(&Argument::State)
    }

    /// The arguments of a helper function.
    pub fn declarations(&self, emitter: &Emitter) -> String {
        let declared =
            self.arguments.iter().map(|argument| declaration(*argument, |shape| emitter.type_of(shape)));
        declared.collect::<Vec<_>>().join(", ")
    }

    /// The same arguments as they are passed on.
    pub fn passed_on(&self) -> String {
        self.arguments.iter().map(|argument| argument.name()).collect::<Vec<_>>().join(", ")
    }
}

/// Words that emitted functions use themselves: arguments, what results are written to, and values between helper functions.
fn reserved() -> BTreeSet<String> {
    let results = FUNCTIONS.iter().flat_map(|signature| signature.results);
    let written = results.filter(|group| group.way == Way::Written).map(|group| group.name);
    ARGUMENTS.iter().map(|given| given.name).chain(written).chain(["w"]).map(str::to_string).collect()
}

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
    "Mechanism",
    "Row",
    "Tangent",
    "Variables",
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
