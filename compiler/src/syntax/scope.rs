//! What names mean where they stand. A part sees what it is given and what it declares, and nothing else: within the use `left`
//! the name `foot` is `left.foot`, a port is what it was given, and built-in names are what they are everywhere.

use super::definition::{Ground, Label, Path};
use super::parser::{Parsed, Parser};
use super::shelf::Inner;
use crate::messages;
use std::collections::HashMap;

/// Names with a meaning of their own.
pub(crate) const BUILT_IN: [&str; 27] = [
    "time",
    "pi",
    "energy",
    "kinetic_energy",
    "potential_energy",
    "power",
    "distance",
    "ground",
    "if",
    "and",
    "or",
    "not",
    "sqrt",
    "abs",
    "sign",
    "min",
    "max",
    "sin",
    "cos",
    "tan",
    "asin",
    "acos",
    "atan2",
    "exp",
    "ln",
    "true",
    "false",
];

/// The mechanism itself, or a use of a part that is being read.
#[derive(Clone, Default)]
pub(super) struct Scope {
    /// The name of the use; nothing of the mechanism itself.
    pub name: Option<String>,
    /// The file that its part is declared in.
    pub file: Option<usize>,
    /// The parts that are being read, outermost first, each with its file.
    pub within: Vec<(Option<usize>, String)>,
    pub ports: HashMap<String, Port>,
    pub inner: Inner,
}

/// What a port was given.
#[derive(Clone)]
pub(super) enum Port {
    /// Something with a name, in the words of the mechanism.
    Named(Path),
    Ground(Box<Ground>),
    /// A signal of the port's name.
    Value,
}

impl Parser<'_> {
    /// The name of something that is declared here.
    pub fn own(&self, label: Label) -> Label {
        match &self.scope.name {
            Some(name) => Label { text: format!("{name}.{}", label.text), region: label.region },
            None => label,
        }
    }

    /// A place of the ground that a port was given.
    pub fn ground_of_port(&self, word: &str) -> Option<&Ground> {
        match self.scope.ports.get(word) {
            Some(Port::Ground(ground)) => Some(ground),
            _ => None,
        }
    }

    /// The name before parentheses: that of a function, of a table of this part, or of one it was given.
    pub fn called(&self, label: Label) -> Label {
        match self.scope.ports.get(&label.text) {
            Some(Port::Named(path)) => Label { text: path.text.clone(), region: label.region },
            _ if self.scope.inner.tables.contains(base(&label.text)) => self.own(label),
            _ => label,
        }
    }

    /// Names joined by dots in the words of the mechanism: `foot.x` of the use `left` as `left.foot` and `x`.
    pub fn resolved(&mut self, path: Path) -> Parsed<Path> {
        let head = &path.parts[0];
        let parts = match self.scope.ports.get(&head.text) {
            Some(Port::Named(given)) => {
                let given = given.parts.iter().map(|part| Label { region: head.region, ..part.clone() });
                given.chain(path.parts[1..].iter().cloned()).collect()
            }
            Some(Port::Ground(_)) => {
                let message = messages::ground_of_port(&head.text);
                return self.fail(path.region, message);
            }
            _ if self.scope.name.is_some() && BUILT_IN.contains(&head.text.as_str()) => path.parts,
            _ => {
                let mut parts = self.joined(path.parts);
                let first = self.own(parts.remove(0));
                parts.insert(0, first);
                parts
            }
        };
        Ok(Path { region: path.region, ..Path::joined(parts) })
    }

    /// Whether these names, as written here, are those of a use of a part and nothing within it.
    pub fn is_use(&self, parts: &[Label]) -> bool {
        self.uses_ahead(parts) == parts.len()
    }

    /// The names of uses with what they are followed by, as one name.
    fn joined(&self, mut parts: Vec<Label>) -> Vec<Label> {
        let uses = self.uses_ahead(&parts).min(parts.len() - 1);
        let rest = parts.split_off(uses + 1);
        let texts: Vec<&str> = parts.iter().map(|part| part.text.as_str()).collect();
        let region = parts[0].region.to(parts[uses].region);
        let first = Label { text: texts.join("."), region };
        std::iter::once(first).chain(rest).collect()
    }

    /// How many of these names are uses of parts, each within the one before it.
    fn uses_ahead(&self, parts: &[Label]) -> usize {
        let (mut inner, mut file, mut count) = (Some(&self.scope.inner), self.scope.file, 0);
        for part in parts {
            let Some(of) = inner.and_then(|inner| inner.uses.get(base(&part.text))) else { break };
            let declared = self.declarations.get(file, of);
            inner = declared.map(|declared| &declared.inner);
            file = declared.and_then(|declared| declared.file);
            count += 1;
        }
        count
    }
}

/// A name without its indices.
fn base(text: &str) -> &str {
    text.split('[').next().unwrap_or_default()
}
