//! Who is called what: one table for values (constants, parameters, inputs, states, memories, signals) and one for parts (bodies, joints,
//! constraints, drivers, loads, lines and markers of the ground). Names that are free twice are refused, both places shown.

use super::functions::FUNCTIONS;
use crate::diagnostics::Diagnostics;
use crate::messages;
use crate::syntax::{BUILT_IN, Definition, KEYWORDS, Label};
use std::collections::HashMap;

/// A value by name; indices into the definition.
#[derive(Clone, Copy, Debug)]
pub(super) enum Value {
    Constant(usize),
    Parameter(usize),
    Input(usize),
    State(usize),
    Memory(usize),
    Signal(usize),
}

impl Value {
    /// For messages.
    pub fn kind(self) -> &'static str {
        match self {
            Self::Constant(_) => "a constant",
            Self::Parameter(_) => "a parameter",
            Self::Input(_) => "an input",
            Self::State(_) => "a state",
            Self::Memory(_) => "a memory",
            Self::Signal(_) => "a signal",
        }
    }
}

/// A part by name; indices into the definition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    Body(usize),
    Joint(usize),
    Constraint(usize),
    Driver(usize),
    Load(usize),
    /// Or a limit.
    Contact(usize),
    Line(usize),
    /// Of the ground.
    Marker(usize),
    /// A use of a part.
    Use(usize),
}

impl Part {
    /// For messages.
    pub fn kind(self) -> &'static str {
        match self {
            Self::Body(_) => "a body",
            Self::Joint(_) => "a joint",
            Self::Constraint(_) => "a constraint",
            Self::Driver(_) => "a driver",
            Self::Load(_) => "a load",
            Self::Contact(_) => "a contact",
            Self::Line(_) => "a line",
            Self::Marker(_) => "a marker of the ground",
            Self::Use(_) => "a part",
        }
    }
}

/// Words before parentheses that no table may have: functions, and what else is called.
pub(super) const CALLED: [&str; FUNCTIONS.len() + 4] = {
    let mut words = ["ground"; FUNCTIONS.len() + 4];
    let mut at = 0;
    while at < FUNCTIONS.len() {
        words[at] = FUNCTIONS[at].0;
        at += 1;
    }
    (words[at], words[at + 1], words[at + 2]) = ("and", "or", "not");
    words
};

/// Points and quantities that every body has.
const OF_BODIES: [&str; 5] = ["center", "origin", "angle", "rate", "velocity"];

/// The tables of a definition.
pub(super) struct Names<'d> {
    values: HashMap<&'d str, Value>,
    parts: HashMap<&'d str, Part>,
    /// Known by the parentheses behind them.
    tables: HashMap<&'d str, usize>,
    surfaces: HashMap<&'d str, usize>,
    materials: HashMap<&'d str, usize>,
}

impl<'d> Names<'d> {
    /// Enters all names; the first of two equal ones keeps it.
    pub fn new(definition: &'d Definition, diagnostics: &mut Diagnostics) -> Self {
        let mut values = Table::new(&BUILT_IN);
        enter(&mut values, &definition.constants, |c| &c.name, Value::Constant, diagnostics);
        enter(&mut values, &definition.parameters, |p| &p.name, Value::Parameter, diagnostics);
        enter(&mut values, &definition.inputs, |i| &i.name, Value::Input, diagnostics);
        enter(&mut values, &definition.states, |s| &s.name, Value::State, diagnostics);
        enter(&mut values, &definition.memories, |m| &m.name, Value::Memory, diagnostics);
        enter(&mut values, &definition.signals, |s| &s.name, Value::Signal, diagnostics);
        allowed(&definition.name, &[], diagnostics);
        let mut parts = Table::new(&BUILT_IN);
        enter(&mut parts, &definition.bodies, |b| &b.name, Part::Body, diagnostics);
        enter(&mut parts, &definition.lines, |l| &l.name, Part::Line, diagnostics);
        enter(&mut parts, &definition.markers, |m| &m.name, Part::Marker, diagnostics);
        enter(&mut parts, &definition.joints, |j| &j.name, Part::Joint, diagnostics);
        enter(&mut parts, &definition.constraints, |c| &c.name, Part::Constraint, diagnostics);
        enter(&mut parts, &definition.drivers, |d| &d.name, Part::Driver, diagnostics);
        enter(&mut parts, &definition.loads, |l| &l.name, Part::Load, diagnostics);
        // Those of joints with play have their names.
        let contacts = definition.contacts.iter().enumerate().filter(|(_, contact)| !contact.of_joint);
        for (index, contact) in contacts {
            let own = std::slice::from_ref(contact);
            enter(&mut parts, own, |c| &c.name, |_| Part::Contact(index), diagnostics);
        }
        enter(&mut parts, &definition.uses, |u| &u.name, Part::Use, diagnostics);
        let mut surfaces = Table::new(&BUILT_IN);
        enter(&mut surfaces, &definition.surfaces, |s| &s.name, |index| index, diagnostics);
        let mut materials = Table::new(&BUILT_IN);
        enter(&mut materials, &definition.materials, |m| &m.name, |index| index, diagnostics);
        let mut tables = Table::new(&CALLED);
        enter(&mut tables, &definition.tables, |t| &t.name, |index| index, diagnostics);
        let mut events = Table::new(&[]);
        enter(&mut events, &definition.events, |e| &e.name, |index| index, diagnostics);
        let mut outputs = Table::new(&[]);
        enter(&mut outputs, &definition.outputs, |o| &o.name, |index| index, diagnostics);
        for body in &definition.bodies {
            let mut points = Table::new(&OF_BODIES);
            enter(&mut points, &body.points, |(label, _)| label, |index| index, diagnostics);
            enter(&mut points, &body.lines, |line| &line.name, |index| index, diagnostics);
            enter(&mut points, &body.markers, |marker| &marker.name, |index| index, diagnostics);
            enter(&mut points, &body.toothings, |toothing| &toothing.name, |index| index, diagnostics);
        }
        Self {
            values: values.found,
            parts: parts.found,
            tables: tables.found,
            surfaces: surfaces.found,
            materials: materials.found,
        }
    }

    pub fn value(&self, name: &str) -> Option<Value> {
        self.values.get(name).copied()
    }

    pub fn table(&self, name: &str) -> Option<usize> {
        self.tables.get(name).copied()
    }

    pub fn surface(&self, name: &str) -> Option<usize> {
        self.surfaces.get(name).copied()
    }

    pub fn material(&self, name: &str) -> Option<usize> {
        self.materials.get(name).copied()
    }

    /// Why a name is not that of a surface.
    /// `round` says whether a body is one, which has a surface by itself.
    pub fn no_such_surface(&self, name: &str, round: impl Fn(usize) -> bool) -> String {
        let known = sorted(self.surfaces.keys().copied());
        if let (Some(part), false) = (self.part(name), name.contains('.')) {
            let message = messages::other_kind(name, part.kind(), "surface");
            let first = known.iter().find(|known| known.starts_with(&format!("{name}.")));
            let own = match part {
                Part::Body(index) if round(index) => Some(format!("{name}.surface")),
                _ => first.map(|first| (*first).to_string()),
            };
            return own.map_or(message.clone(), |own| messages::such_as(&message, &own));
        }
        self.unknown("surface", name, messages::closest(name, known.into_iter()))
    }

    pub fn part(&self, name: &str) -> Option<Part> {
        self.parts.get(name).copied()
    }

    /// The nearest of the values and built-in names.
    pub fn similar_value(&self, name: &str) -> Option<&str> {
        messages::closest(name, sorted(self.values.keys().copied().chain(BUILT_IN)).into_iter())
    }

    /// The first and the last of the parts that differ from this name in the last index only.
    pub fn indices_beside(&self, name: &str) -> Option<(String, String)> {
        let (base, _) = name.strip_suffix(']')?.rsplit_once('[')?;
        let index = |part: &str| -> Option<usize> {
            part.strip_prefix(base)?.strip_prefix('[')?.strip_suffix(']')?.parse().ok()
        };
        let indices: Vec<usize> = self.parts.keys().filter_map(|part| index(part)).collect();
        let with = |index: &usize| format!("{base}[{index}]");
        Some((with(indices.iter().min()?), with(indices.iter().max()?)))
    }

    /// Why a name is not that of a part that `fits` accepts, called `what`: it is another kind of part, or none.
    pub fn not_found(&self, what: &str, name: &str, fits: impl Fn(Part) -> bool) -> String {
        match self.part(name) {
            Some(part) => messages::other_kind(name, part.kind(), what),
            None => self.unknown(what, name, self.similar_part(name, fits)),
        }
    }

    /// Nothing has this name. Within a part that may be because it stands outside of it.
    pub fn unknown(&self, what: &str, name: &str, similar: Option<&str>) -> String {
        let outside = name.rsplit_once('.').filter(|(used, own)| {
            let known = self.parts.contains_key(own) || self.values.contains_key(own);
            matches!(self.part(used), Some(Part::Use(_))) && known
        });
        match (outside, similar) {
            (Some((used, own)), None) => messages::outside_of_part(what, own, used),
            _ => messages::unknown(what, name, similar),
        }
    }

    /// The nearest of the tables.
    pub fn similar_table(&self, name: &str) -> Option<&str> {
        messages::closest(name, sorted(self.tables.keys().copied()).into_iter())
    }

    /// The nearest of the parts that `fits` accepts.
    pub fn similar_part(&self, name: &str, fits: impl Fn(Part) -> bool) -> Option<&str> {
        let fitting = self.parts.iter().filter(|(_, part)| fits(**part)).map(|(name, _)| *name);
        messages::closest(name, sorted(fitting).into_iter())
    }
}

/// In a fixed order, so that equally near names give the same message every time.
fn sorted<'a>(names: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut names: Vec<&str> = names.collect();
    names.sort_unstable();
    names
}

/// Names of one kind and what they must differ in.
struct Table<'d, T> {
    found: HashMap<&'d str, T>,
    /// By identifier in the generated code: `upright[3]` and `upright_3` are the same.
    identifiers: HashMap<String, &'d Label>,
    reserved: &'static [&'static str],
}

impl<T> Table<'_, T> {
    fn new(reserved: &'static [&'static str]) -> Self {
        Self { found: HashMap::new(), identifiers: HashMap::new(), reserved }
    }
}

fn enter<'d, E, T>(
    table: &mut Table<'d, T>,
    elements: &'d [E],
    label: impl Fn(&'d E) -> &'d Label,
    entry: impl Fn(usize) -> T,
    diagnostics: &mut Diagnostics,
) {
    for (index, element) in elements.iter().enumerate() {
        let label = label(element);
        if !allowed(label, table.reserved, diagnostics) {
            continue;
        }
        let identifier = label.identifier();
        match table.identifiers.get(&identifier) {
            Some(first) if first.region.serials() == label.region.serials() && first.text == label.text => {
                diagnostics.error(label.region, messages::declared_by_rounds(&label.text));
            }
            Some(first) => {
                let message = messages::duplicate(&label.text, &first.text);
                diagnostics.conflict(label.region, message, first.region, messages::first_here(&first.text));
            }
            None => {
                table.identifiers.insert(identifier, label);
                table.found.insert(&label.text, entry(index));
            }
        }
    }
}

fn allowed(label: &Label, reserved: &[&str], diagnostics: &mut Diagnostics) -> bool {
    // The last of those joined by points: the others are uses of parts.
    let own = label.text.rsplit('.').next().unwrap_or_default();
    let word = own.split('[').next().unwrap_or_default();
    let message = if KEYWORDS.contains(&word) || word.starts_with("r#") || word == "_" {
        messages::keyword(word)
    } else if reserved.contains(&word) {
        messages::reserved(word)
    } else {
        return true;
    };
    diagnostics.error(label.region, message);
    false
}
