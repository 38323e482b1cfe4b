//! What is declared and named by nothing: constants, parameters, inputs, states, memories, signals, tables, parts, points, markers and lines.
//!
//! While names are resolved those that are named are kept; what is left over here is warned of in `check`. The rounds
//! of a `repeat` declare one thing each at the same place of the source: it is used where one of them is.

use super::Name;
use super::lower::name;
use crate::syntax::{Definition, Label};
use std::collections::{HashMap, HashSet};

/// Whose name it is; within one scope names differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Scope {
    Value,
    Table,
    Part,
    Body(usize),
    Ground,
    Surface,
    Material,
}

/// What was declared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Declared {
    Constant,
    Parameter,
    Input,
    State,
    Memory,
    Signal,
    Table,
    Point,
    Marker,
    Line,
    Toothing,
    Part,
    Surface,
    Material,
}

/// Something that is declared and named by nothing.
#[derive(Clone, Debug)]
pub struct Unused {
    pub kind: Declared,
    pub name: Name,
    /// The body that it is of.
    pub body: Option<String>,
}

/// All declarations that nothing names, in the order of their kinds. A name with `_` in front is not meant to be used.
pub(super) fn unused(definition: &Definition, used: &HashSet<(Scope, &str)>) -> Vec<Unused> {
    let mut found: Vec<(Unused, bool)> = Vec::new();
    let mut known: HashMap<(u32, u32), usize> = HashMap::new();
    for (scope, kind, label) in declarations(definition) {
        let named = used.contains(&(scope, label.text.as_str()))
            || label.text.starts_with('_')
            || (matches!(kind, Declared::Constant | Declared::Signal)
                && definition.counted.contains(&label.text))
            || (kind == Declared::Part && definition.uses.iter().any(|used| used.part == label.text));
        let body = match scope {
            Scope::Body(index) => Some(definition.bodies[index].name.text.clone()),
            Scope::Value | Scope::Table | Scope::Part | Scope::Ground | Scope::Surface | Scope::Material => {
                None
            }
        };
        match known.get(&label.region.serials()) {
            Some(first) => found[*first].1 |= named,
            None => {
                known.insert(label.region.serials(), found.len());
                found.push((Unused { kind, name: name(label), body }, named));
            }
        }
    }
    found.into_iter().filter(|(_, named)| !named).map(|(unused, _)| unused).collect()
}

fn declarations(definition: &Definition) -> impl Iterator<Item = (Scope, Declared, &Label)> {
    let value = |kind| move |label| (Scope::Value, kind, label);
    let constants = definition.constants.iter().map(|it| &it.name).map(value(Declared::Constant));
    let parameters = definition.parameters.iter().map(|it| &it.name).map(value(Declared::Parameter));
    let inputs = definition.inputs.iter().map(|it| &it.name).map(value(Declared::Input));
    let states = definition.states.iter().map(|it| &it.name).map(value(Declared::State));
    let memories = definition.memories.iter().map(|it| &it.name).map(value(Declared::Memory));
    let signals = definition.signals.iter().map(|it| &it.name).map(value(Declared::Signal));
    let tables = definition.tables.iter().map(|it| (Scope::Table, Declared::Table, &it.name));
    let parts = definition.parts.iter().map(|name| (Scope::Part, Declared::Part, name));
    let of_bodies = definition.bodies.iter().enumerate().flat_map(|(index, body)| {
        let of_body = move |kind| move |label| (Scope::Body(index), kind, label);
        let points = body.points.iter().map(|(label, _)| label).map(of_body(Declared::Point));
        let markers = body.markers.iter().map(|it| &it.name).map(of_body(Declared::Marker));
        let toothings = body.toothings.iter().map(|it| &it.name).map(of_body(Declared::Toothing));
        let lines = body.lines.iter().map(|it| &it.name).map(of_body(Declared::Line));
        points.chain(markers).chain(lines).chain(toothings)
    });
    let of_ground = |kind| move |label| (Scope::Ground, kind, label);
    let markers = definition.markers.iter().map(|it| &it.name).map(of_ground(Declared::Marker));
    let lines = definition.lines.iter().map(|it| &it.name).map(of_ground(Declared::Line));
    let surfaces = definition.surfaces.iter().map(|it| (Scope::Surface, Declared::Surface, &it.name));
    let materials = definition.materials.iter().map(|it| (Scope::Material, Declared::Material, &it.name));
    let values = constants
        .chain(parameters)
        .chain(inputs)
        .chain(states)
        .chain(memories)
        .chain(signals)
        .chain(tables)
        .chain(parts);
    values.chain(of_bodies).chain(markers).chain(lines).chain(surfaces).chain(materials)
}
