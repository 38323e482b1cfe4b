//! Positions and velocities by name, whatever the coordinates are.
//!
//! ```text
//! pub struct FourBarPositions<R = f64> { pub crank_angle: Angle<R>, … }
//! pub struct FourBarVelocities<R = f64> { pub crank_rate: R, … }
//! impl<R: Real> From<Q<R>> for FourBarPositions<R> { … } // and back
//! // A mechanism with internal states has `FourBarInternal`, with a field for each.
//! impl<R: Real> FourBar<R> { pub fn positions(q: &Q<R>) -> FourBarPositions<R> { … } … }
//! ```

use super::names::field;
use super::{Emitter, array, declared, quoted};
use crate::equations::Layout;
use crate::model::{InternalState, Mechanism, identifier};
use std::collections::BTreeSet;
use std::fmt::Write;

/// How many entries of the array a coordinate takes, and as what.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Number,
    /// (cos, sin).
    Angle,
    /// (turns, remainder).
    Turns,
    /// An array of this length.
    Array(usize),
}

struct Named {
    name: String,
    doc: String,
    /// What the user wrote above it.
    docs: String,
    kind: Kind,
}

/// One of the structs.
struct Struct {
    suffix: &'static str,
    /// The function of the model that makes it, and the alias of the array of a state.
    function: &'static str,
    alias: &'static str,
    fields: Vec<Named>,
}

/// Those that have fields.
fn structs(emitter: &Emitter) -> impl Iterator<Item = Struct> {
    let (mechanism, layout) = (emitter.mechanism, &emitter.compiled.complete.equations.layout);
    let positions = Struct {
        suffix: "Positions",
        function: "positions",
        alias: "Q",
        fields: positions(layout, mechanism),
    };
    let velocities = Struct {
        suffix: "Velocities",
        function: "velocities",
        alias: "V",
        fields: velocities(layout, mechanism),
    };
    let internal = Struct {
        suffix: "Internal",
        function: "internal",
        alias: "Z",
        fields: mechanism.states.iter().map(|state| internal(&mechanism.name.text, state)).collect(),
    };
    [positions, velocities, internal].into_iter().filter(|known| !known.fields.is_empty())
}

/// The structs.
pub fn items(text: &mut String, emitter: &Emitter) {
    let Emitter { name, visibility, path, .. } = emitter;
    let (derives, f64) = (super::items::DERIVES, super::items::F64);
    for Struct { suffix, fields, .. } in structs(emitter) {
        let what = if suffix == "Internal" { "Internal states" } else { suffix };
        let _ = writeln!(
            text,
            "#[doc = \"{what} of [`{name}`] by name; [`From`] and [`Into`] the array of a state.\"] \
             #[allow(dead_code)] {derives} {visibility} struct {name}{suffix}<R = {f64}> {{"
        );
        for Named { name, doc, docs, kind } in &fields {
            let _ = writeln!(text, "{docs} #[doc = {}] pub {name}: {},", quoted(doc), kind.type_of(path));
        }
        text.push_str("}\n");
    }
}

/// Their conversions, where the short names are in scope.
pub fn conversions(text: &mut String, emitter: &Emitter) {
    let name = &emitter.name;
    for Struct { suffix, alias, fields, .. } in structs(emitter) {
        let (mut values, mut entries, mut at) = (String::new(), String::new(), 0);
        for Named { name, kind, .. } in &fields {
            let _ = write!(values, "{name}: {}, ", kind.value(at));
            let _ = write!(entries, "{}, ", kind.entries(&format!("named.{name}")));
            at += kind.length();
        }
        let _ = write!(
            text,
            "impl<R: Real> From<{alias}<R>> for {name}{suffix}<R> {{\n\
             fn from(entries: {alias}<R>) -> Self {{ Self {{ {values}}} }}\n}}\n\
             impl<R: Real> From<{name}{suffix}<R>> for {alias}<R> {{\n\
             fn from(named: {name}{suffix}<R>) -> Self {{ [{entries}] }}\n}}\n"
        );
    }
}

/// The model's functions that make them.
pub fn functions(text: &mut String, emitter: &Emitter) {
    let name = &emitter.name;
    for Struct { suffix, function, alias, .. } in structs(emitter) {
        let what = if function == "internal" { "internal states" } else { function };
        let _ = writeln!(
            text,
            "/// The {what} of a state by name.\n\
             pub fn {function}(entries: &{alias}<R>) -> {name}{suffix}<R> {{ (*entries).into() }}"
        );
    }
}

fn named(name: String, doc: &str, kind: Kind) -> Named {
    Named { name, doc: doc.to_string(), docs: String::new(), kind }
}

fn number(name: &str, doc: &str) -> Named {
    named(name.to_string(), doc, Kind::Number)
}

fn internal(mechanism: &str, state: &InternalState) -> Named {
    let doc = declared::doc(&state.unit, &format!("{mechanism}Internal"), &state.name.identifier(), None);
    Named { docs: state.docs.clone(), ..number(&field(&state.name.identifier()), &doc) }
}

fn positions(layout: &Layout, mechanism: &Mechanism) -> Vec<Named> {
    let names = layout.position_names(mechanism);
    let lengths = names
        .iter()
        .zip(&layout.linear)
        .map(|(name, linear)| number(name, if linear.is_length(mechanism) { "m." } else { "rad." }));
    let angles = (0..layout.rotations.len()).map(|rotation| {
        let name = names[layout.pair(rotation)].trim_end_matches(".cos");
        let name = if name.contains(".angle") { name.to_string() } else { format!("{name}.angle") };
        named(name, "rad, by its cosine and sine.", Kind::Angle)
    });
    let quaternions = layout.quaternions.iter().map(|ball| {
        let name = format!("{}.orientation", ball.name(mechanism));
        named(name, "A unit quaternion (w, x, y, z).", Kind::Array(4))
    });
    let turns = (0..layout.angles.len())
        .map(|angle| named(names[layout.turns(angle)].clone(), "rad, over several turns.", Kind::Turns));
    unique(lengths.chain(angles).chain(quaternions).chain(turns).collect())
}

fn velocities(layout: &Layout, mechanism: &Mechanism) -> Vec<Named> {
    let names = layout.velocity_names(mechanism);
    let (linear, angular) = names.split_at(layout.linear.len());
    let speeds = linear
        .iter()
        .zip(&layout.linear)
        .map(|(name, linear)| number(name, if linear.is_length(mechanism) { "m/s." } else { "rad/s." }));
    let rates = angular.iter().take(layout.rotations.len()).map(|name| number(name, "rad/s."));
    let vectors = layout.quaternions.iter().map(|ball| {
        named(format!("{}.rate", ball.name(mechanism)), "ω along the turned axes, rad/s.", Kind::Array(3))
    });
    unique(speeds.chain(rates).chain(vectors).collect())
}

/// The same as identifiers, no two alike.
fn unique(mut all: Vec<Named>) -> Vec<Named> {
    let mut taken = BTreeSet::new();
    for named in &mut all {
        let mut name = identifier(&named.name);
        while !taken.insert(name.clone()) {
            name.push('_');
        }
        named.name = field(&name);
    }
    all
}

impl Kind {
    fn length(self) -> usize {
        match self {
            Kind::Number => 1,
            Kind::Angle | Kind::Turns => 2,
            Kind::Array(length) => length,
        }
    }

    fn type_of(self, path: &str) -> String {
        match self {
            Kind::Number => "R".to_string(),
            Kind::Angle => format!("{path}::Angle<R>"),
            Kind::Turns => format!("{path}::Turns<R>"),
            Kind::Array(length) => format!("[R; {length}]"),
        }
    }

    /// Its value, from the entries of the array from `at` on.
    fn value(self, at: usize) -> String {
        match self {
            Kind::Number => format!("entries[{at}]"),
            Kind::Angle => format!("Angle {{ cos: entries[{at}], sin: entries[{}] }}", at + 1),
            Kind::Turns => format!("Turns {{ turns: entries[{at}], remainder: entries[{}] }}", at + 1),
            Kind::Array(length) => array((at..at + length).map(|entry| format!("entries[{entry}]"))),
        }
    }

    /// The entries of the array, from the field.
    fn entries(self, field: &str) -> String {
        match self {
            Kind::Number => field.to_string(),
            Kind::Angle => format!("{field}.cos, {field}.sin"),
            Kind::Turns => format!("{field}.turns, {field}.remainder"),
            Kind::Array(length) => {
                (0..length).map(|entry| format!("{field}[{entry}]")).collect::<Vec<_>>().join(", ")
            }
        }
    }
}
