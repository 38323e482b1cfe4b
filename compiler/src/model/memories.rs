//! Memories, which are constant between events, and the events that set them.
//!
//! ```text
//! passing   the value rises, falls or crosses as value − level becomes positive, stops being so, or either
//! every     the time is k T, k = 0, 1, 2, …
//! ```
//! What an event sets memories to is of the values before it; of events at one time the one that is written last decides. Speeds that jump do
//! so together, as by impulses along them.

use super::lower::{Lowering, Use, declared, declared_unit, name};
use super::names::Value;
use super::{
    Coordinate, DeclaredUnit, Driver, Expr, Function2, LoadId, Mechanism, MemoryId, Name, Quantity, fold,
};
use crate::messages;
use crate::syntax::{self, OptionEntry, TermKind, Way};
use crate::units::Dimension;

/// How many speeds may jump.
pub const MOST_JUMPS: usize = 8;

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
    /// The contact whose speed at each touch it is.
    pub touch_of: Option<LoadId>,
}

/// What sets memories.
#[derive(Clone, Debug)]
pub struct Event {
    pub name: Name,
    pub occasion: Occasion,
    /// Each memory once.
    pub sets: Vec<(MemoryId, Expr)>,
    pub jump: Option<Jump>,
}

/// A speed that jumps, as by an impulse along it.
#[derive(Clone, Debug)]
pub struct Jump {
    /// That of which the speed is.
    pub of: Coordinate,
    /// The speed as written.
    pub name: String,
    pub to: Expr,
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
        self.options.held || !self.memories.is_empty() || !self.events.is_empty() || self.sticks()
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
        let (unit, touch_of) = match self.touched(memory) {
            None => (declared_unit(memory.entry.unit.as_ref()), None),
            Some(contact) => {
                let si = self.speed_of_contact(contact)?.to_string();
                (DeclaredUnit { text: si.clone(), scale: 1.0, si }, Some(self.load_of_contact(contact)))
            }
        };
        Some(Memory {
            name: name(&memory.name),
            unit,
            docs: memory.docs.to_string(),
            start: self.declared_number("memory", &memory.name.text, &memory.entry)?,
            touch_of,
        })
    }

    /// The contact whose speed at each touch it is.
    fn touched(&self, memory: &'d syntax::Memory) -> Option<usize> {
        self.contact_named(&memory.touch_of.as_ref()?.text)
    }

    pub(super) fn dimension_of_memory(&mut self, index: usize) -> Option<Dimension> {
        let memory = &self.definition.memories[index];
        match self.touched(memory) {
            Some(contact) => self.speed_of_contact(contact),
            None => Some(declared(memory.entry.unit.as_ref())),
        }
    }

    /// All events. What they name is known.
    pub fn events(&mut self, drivers: &[Driver]) -> Vec<Event> {
        let definition = self.definition;
        let events = self.each(&definition.events, Lowering::event);
        self.events_differ(&events);
        self.jumps_are_free(&events, drivers);
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
        let jump = event.jump.as_ref().map(|jump| self.jump(jump));
        Some(Event {
            name: name(&event.name),
            occasion: occasion?,
            sets: sets.into_iter().collect::<Option<_>>()?,
            jump: if let Some(jump) = jump { Some(jump?) } else { None },
        })
    }

    fn jump(&mut self, syntax::Jump { speed, to }: &'d syntax::Jump) -> Option<Jump> {
        let found = self.permitted_quantity(speed, Use::ASSIGNED);
        let typed = self.value(to, Use::ASSIGNED);
        let Some((Quantity::Rate(of), dimension)) = found else {
            if found.is_some() {
                self.diagnostics.error(speed.region, messages::jump_of_no_speed(&speed.text));
            }
            return None;
        };
        let to = self.expect_dimension(typed?, dimension, &messages::what_jumps(&speed.text))?;
        Some(Jump { of, name: speed.text.clone(), to })
    }

    fn occasion(&mut self, event: &'d syntax::Event) -> Option<Occasion> {
        match &event.occasion {
            syntax::Occasion::Passing { value, way, level } => {
                let (term, region) = (value, value.region.to(level.region));
                let (value, level) = (self.value(value, Use::EVENT), self.value(level, Use::EVENT));
                let (value, level) = (value?, level?);
                self.same(&value, &level, &messages::sides_of_an_event(way.word()))?;
                if let Some((contact, what)) = self.inside_what_is_rigid(term, &level.expr) {
                    self.diagnostics.error(region, messages::never_inside(contact, what));
                    return None;
                }
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

    /// The rigid contact whose gap or depth this is, where that cannot pass the level: nothing is inside.
    fn inside_what_is_rigid(&self, value: &'d syntax::Term, level: &Expr) -> Option<(&'d str, &'d str)> {
        let (TermKind::Name(path), Expr::Number(level)) = (&value.kind, level) else { return None };
        let contact = self.contact_of(path).filter(|contact| self.is_rigid_contact(*contact))?;
        let is_inside = match path.parts.get(1)?.text.as_str() {
            "gap" => *level <= 0.0,
            "depth" => *level >= 0.0,
            _ => false,
        };
        is_inside.then(|| (self.definition.contacts[contact].name.text.as_str(), path.text.as_str()))
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
        let dimension = self.dimension_of_memory(index)?;
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

    /// No speed jumps that a driver gives, and not too many do.
    fn jumps_are_free(&mut self, events: &[Event], drivers: &[Driver]) {
        let written = self.definition.events.iter().filter_map(|event| event.jump.as_ref());
        let jumps = events.iter().filter_map(|event| event.jump.as_ref());
        for jump in jumps {
            let Some(driver) = drivers.iter().find(|driver| driver.coordinate == jump.of) else { continue };
            let message = messages::jump_of_what_is_driven(&jump.name, &driver.name.text);
            let note = messages::driven_here(&driver.name.text);
            for at in written.clone().filter(|written| written.speed.text == jump.name) {
                self.diagnostics.conflict(at.speed.region, message.clone(), driver.name.span, note.clone());
            }
        }
        if let Some(jump) = written.clone().nth(MOST_JUMPS) {
            let message = messages::too_many_jumps(written.count(), MOST_JUMPS);
            self.diagnostics.error(jump.speed.region, message);
        }
    }

    /// What memories and events cannot be together with yet.
    fn beside_memories(&mut self) {
        let definition = self.definition;
        let Some(name) = definition.memory_or_event() else {
            return;
        };
        for entry in &definition.options {
            if let OptionEntry::ExportC(scalar) = entry {
                self.diagnostics.error(scalar.region, messages::memories_in_c(&name.text));
            }
        }
    }
}
