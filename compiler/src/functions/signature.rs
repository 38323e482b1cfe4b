//! What a function is called, takes and gives; results by groups.

use super::{Argument, Function, Shape};
use crate::complete::Complete;
use crate::symbolic::Node;

/// What a function is called, takes and gives.
#[derive(Clone, Copy)]
pub struct Signature {
    pub function: Function,
    pub name: &'static str,
    /// The equation, with units; a line for each line of the emitted comment.
    pub doc: &'static str,
    pub interface: Interface,
    /// Which mechanisms have it.
    pub emitted: fn(&Complete) -> bool,
    pub arguments: &'static [Argument],
    /// In the order of the program's outputs.
    pub results: &'static [Group],
}

/// What an emitted function is part of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interface {
    /// No function that a user calls: it is part of how a model is prepared.
    Preparation,
    /// A function of the model itself.
    Model,
    /// Functions of the runtime's traits.
    Mechanism,
    Assemble,
    Tangent,
}

/// Results that belong together.
#[derive(Clone, Copy)]
pub struct Group {
    /// Name of the argument it is written to, or of the value.
    pub name: &'static str,
    pub shape: Shape,
    pub way: Way,
    /// What its entries are called inside of the function, `{}` being the entry's own name; nothing where they are numbered.
    pub label: Option<&'static str>,
    /// Its entries as expressions.
    pub nodes: fn(&Complete) -> Vec<Node>,
}

/// How results come out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Written to an argument.
    Written,
    /// The value of the function. Of several lists of one length the entries are paired.
    Value,
}

impl Signature {
    /// The argument that brings another along; none if that is an argument by itself.
    pub fn within(&self, part: Argument) -> Option<Argument> {
        self.arguments.iter().copied().find(|argument| argument.parts().contains(&part))
    }

    /// What the function computes, in the order of its outputs; nothing where the mechanism does not have it.
    pub fn outputs(&self, complete: &Complete) -> Vec<Node> {
        if !(self.emitted)(complete) {
            return Vec::new();
        }
        self.results.iter().flat_map(|group| (group.nodes)(complete)).collect()
    }

    /// Its results by groups.
    pub fn groups<'v, T>(&self, complete: &Complete, results: &'v [T]) -> Vec<&'v [T]> {
        let mut rest = results;
        let part = |(index, group): (usize, &Group)| {
            // The last has what is left: how many constants a model is prepared with is found by its program.
            let last = index + 1 == self.results.len();
            let length = if last { rest.len() } else { (group.nodes)(complete).len().min(rest.len()) };
            let (own, others) = rest.split_at(length);
            rest = others;
            own
        };
        self.results.iter().enumerate().map(part).collect()
    }

    /// The same where the number of groups is known.
    pub fn split<'v, T, const N: usize>(&self, complete: &Complete, results: &'v [T]) -> [&'v [T]; N] {
        debug_assert_eq!(N, self.results.len(), "groups of {}", self.name);
        let groups = self.groups(complete, results);
        std::array::from_fn(|index| groups.get(index).copied().unwrap_or_default())
    }
}

/// A function that every mechanism has whose options ask for its interface.
pub(super) const fn signature(
    function: Function,
    name: &'static str,
    interface: Interface,
    doc: &'static str,
    arguments: &'static [Argument],
    results: &'static [Group],
) -> Signature {
    let emitted: fn(&Complete) -> bool = match interface {
        Interface::Tangent => |complete| complete.tangents.is_some(),
        Interface::Preparation | Interface::Model | Interface::Mechanism | Interface::Assemble => |_| true,
    };
    Signature { function, name, doc, interface, emitted, arguments, results }
}

impl Signature {
    /// For some mechanisms only.
    pub(super) const fn only(self, emitted: fn(&Complete) -> bool) -> Signature {
        Signature { emitted, ..self }
    }
}

type Nodes = fn(&Complete) -> Vec<Node>;

/// Results that are written to an argument of this name.
pub(super) const fn written(name: &'static str, shape: Shape, nodes: Nodes) -> Group {
    Group { name, shape, way: Way::Written, label: None, nodes }
}

/// Results that are the function's value.
pub(super) const fn value(name: &'static str, shape: Shape, nodes: Nodes) -> Group {
    Group { name, shape, way: Way::Value, label: None, nodes }
}

impl Group {
    /// With names for its entries inside of the function.
    pub(super) const fn called(self, label: &'static str) -> Group {
        Group { label: Some(label), ..self }
    }
}
