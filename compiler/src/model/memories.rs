//! Memories, which are constant between events, and the events that set them.
//!
//! ```text
//! passing   the value rises, falls or crosses as value − level becomes positive, stops being so, or either
//! every     the time is k T, k = 0, 1, 2, …
//! ```
//! What an event sets memories to is of the values before it; of events at one time the one that is written last decides.

use super::lower::{Lowering, Use, declared, declared_unit, name};
use super::names::Value;
use super::{DeclaredUnit, Expr, Function2, Mechanism, MemoryId, Name, fold};
use crate::messages;
use crate::syntax::{self, OptionEntry, Way};
use crate::units::Dimension;

/// The shortest period, s: steps end at every tick.
const SHORTEST: f64 = 1e-9;

/// A number that is kept between events.
#[derive(Clone, Debug)]
pub struct Memory {
    pub name: Name,
    pub unit: DeclaredUnit,
    pub docs: String,
    /// SI.
    pub start: f64,
}

/// What sets memories.
#[derive(Clone, Debug)]
pub struct Event {
    pub name: Name,
    pub occasion: Occasion,
    /// At least one; each memory once.
    pub sets: Vec<(MemoryId, Expr)>,
}

/// When an event occurs.
#[derive(Clone, Debug, PartialEq)]
pub enum Occasion {
    /// An expression passes zero.
    Passing(Expr, Way),
    /// At the multiples of a period, s.
    Every(f64),
}

impl Occasion {
    /// Whether whatever is at the one is at the other too, by what is written of them.
    fn includes(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Passing(a, way), Self::Passing(b, other)) => {
                a == b && (way == other || [way, other].contains(&&Way::Crosses))
            }
            _ => self == other,
        }
    }

    /// When that is, in words.
    pub fn said(&self) -> String {
        match self {
            Self::Passing(_, way) => format!("as a value {} through its level", way.word()),
            Self::Every(period) => format!("every {} s", crate::numbers::significant(*period, 5)),
        }
    }
}

impl Mechanism {
    /// Whether states hold something between events: gates of contacts or memories.
    pub fn holds(&self) -> bool {
        self.options.held || !self.memories.is_empty() || self.sticks()
    }

    /// The events in the order of their places behind the gates of contacts: what passes a level, then what has a period.
    pub fn events_in_places(&self) -> Vec<(usize, &Event)> {
        let (passing, every): (Vec<_>, Vec<_>) = self
            .events
            .iter()
            .enumerate()
            .partition(|(_, event)| matches!(event.occasion, Occasion::Passing(..)));
        passing.into_iter().chain(every).collect()
    }

    /// The names of all that is held: the contact of each gate, events, memories.
    pub fn held_names(&self) -> Vec<&Name> {
        let gates = self.gates().map(|(load, _)| &self.loads[load.0].name);
        let events = self.events_in_places().into_iter().map(|(_, event)| &event.name);
        gates.chain(events).chain(self.memories.iter().map(|memory| &memory.name)).collect()
    }

    /// The place of a memory among what is held.
    pub fn place_of_memory(&self, memory: MemoryId) -> usize {
        self.gates().count() + self.events.len() + memory.0
    }
}

impl<'d> Lowering<'d> {
    pub fn memory(&mut self, memory: &'d syntax::Memory) -> Option<Memory> {
        Some(Memory {
            name: name(&memory.name),
            unit: declared_unit(memory.entry.unit.as_ref()),
            docs: memory.docs.to_string(),
            start: self.declared_number("memory", &memory.name.text, &memory.entry)?,
        })
    }

    /// All events. What they name is known.
    pub fn events(&mut self) -> Vec<Event> {
        let definition = self.definition;
        let events = self.each(&definition.events, Lowering::event);
        self.events_differ(&events);
        self.beside_memories();
        events
    }

    fn event(&mut self, event: &'d syntax::Event) -> Option<Event> {
        let occasion = self.occasion(event);
        let sets: Vec<_> = event.sets.iter().map(|set| self.assignment(set)).collect();
        for (at, (memory, _)) in event.sets.iter().enumerate() {
            if let Some((first, _)) = event.sets[..at].iter().find(|(known, _)| known.text == memory.text) {
                let message = messages::set_twice(&memory.text, &event.name.text);
                let note = messages::first_here(&memory.text);
                self.diagnostics.conflict(memory.region, message, first.region, note);
            }
        }
        Some(Event {
            name: name(&event.name),
            occasion: occasion?,
            sets: sets.into_iter().collect::<Option<_>>()?,
        })
    }

    fn occasion(&mut self, event: &'d syntax::Event) -> Option<Occasion> {
        match &event.occasion {
            syntax::Occasion::Passing { value, way, level } => {
                let region = value.region.to(level.region);
                let (value, level) = (self.value(value, Use::EVENT), self.value(level, Use::EVENT));
                let (value, level) = (value?, level?);
                self.same(&value, &level, &messages::sides_of_an_event(way.word()))?;
                let past = match level.expr {
                    Expr::Number(0.0) => value.expr,
                    level => fold::binary(Function2::Sub, value.expr, level),
                };
                if !past.varies() {
                    self.diagnostics.error(region, messages::never_passes(&event.name.text, way.word()));
                    return None;
                }
                Some(Occasion::Passing(past, *way))
            }
            syntax::Occasion::Every(period) => {
                let region = period.region;
                let typed = self.value(period, Use::PERIOD)?;
                let what = messages::period_of(&event.name.text);
                match self.expect_dimension(typed, Dimension::TIME, &what)? {
                    Expr::Number(period) if period >= SHORTEST => Some(Occasion::Every(period)),
                    Expr::Number(period) => {
                        self.diagnostics.error(region, messages::period_too_short(&event.name.text, period));
                        None
                    }
                    _ => {
                        self.diagnostics.error(region, messages::not_constant(&what));
                        None
                    }
                }
            }
        }
    }

    fn assignment(&mut self, (memory, value): &'d (syntax::Label, syntax::Term)) -> Option<(MemoryId, Expr)> {
        let typed = self.value(value, Use::ASSIGNED);
        let Some(Value::Memory(index)) = self.names.value(&memory.text) else {
            let message = match self.names.value(&memory.text) {
                Some(_) => messages::sets_no_memory(&memory.text),
                None => {
                    let known = self.definition.memories.iter().map(|memory| memory.name.text.as_str());
                    messages::unknown_memory(&memory.text, known)
                }
            };
            self.diagnostics.error(memory.region, message);
            return None;
        };
        let dimension = declared(self.definition.memories[index].entry.unit.as_ref());
        let value = self.expect_dimension(typed?, dimension, &messages::quoted(&memory.text))?;
        Some((MemoryId(index), value))
    }

    /// Two events that always occur together set different memories.
    fn events_differ(&mut self, events: &[Event]) {
        for (at, event) in events.iter().enumerate() {
            for earlier in &events[..at] {
                let both =
                    event.sets.iter().find(|(set, _)| earlier.sets.iter().any(|(known, _)| known == set));
                let Some((memory, _)) = both.filter(|_| event.occasion.includes(&earlier.occasion)) else {
                    continue;
                };
                let memory = &self.definition.memories[memory.0].name.text;
                let message = messages::set_by_two(memory, &event.name.text, &earlier.name.text);
                let note = messages::set_here_too(memory);
                self.diagnostics.conflict(event.name.span, message, earlier.name.span, note);
            }
        }
    }

    /// What memories cannot be together with yet.
    fn beside_memories(&mut self) {
        let definition = self.definition;
        let Some(memory) = definition.memories.first() else {
            return;
        };
        let rigid = (0..definition.contacts.len()).find(|index| self.is_rigid_contact(*index));
        if let Some(rigid) = rigid.map(|index| &definition.contacts[index].name) {
            let message = messages::memory_beside_rigid(&memory.name.text, &rigid.text);
            self.diagnostics.conflict(
                memory.name.region,
                message,
                rigid.region,
                messages::rigid_here(&rigid.text),
            );
        }
        for entry in &definition.options {
            if let OptionEntry::ExportC(scalar) = entry {
                self.diagnostics.error(scalar.region, messages::memories_in_c(&memory.name.text));
            }
        }
    }
}
