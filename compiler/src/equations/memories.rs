//! Memories and what sets them, on the graph.
//!
//! ```text
//! guard of an event that passes a level    (−x, 1)     its place in the gates is 1 where x > 0, else 0
//! guard of any other, and of a memory      (0, 0)
//! m⁺ = value of the last event written that sets m and occurs, else m
//! ```
//! While m⁺ is asked for, the place of an event in the gates says whether it occurs; what comes out there is what its speed jumps to.

use super::laws::Laws;
use crate::model::Occasion;
use crate::symbolic::{Compare, Node};

/// Of each event and memory, in the order of their places, what the guards of contacts are of these.
pub fn guards(laws: &Laws) -> Vec<[Node; 2]> {
    let (zero, one) = (laws.g.zero().bare, laws.g.one().bare);
    let events = laws.mechanism.events_in_places();
    let events = events.into_iter().map(|(_, event)| match &event.occasion {
        Occasion::Passing(past, _) => [(-laws.value(past)).bare, one],
        Occasion::Every(_) => [zero, zero],
    });
    events.chain(laws.mechanism.memories.iter().map(|_| [zero, zero])).collect()
}

/// What gates of contacts have three numbers of, followed by those of each event and memory: the speed that jumps, nothing, and 1; zeros of
/// what lets none jump. Nothing where neither has any.
pub fn with_jumps(laws: &Laws, contacts: Vec<[Node; 3]>) -> Vec<[Node; 3]> {
    let (zero, one) = (laws.g.zero().bare, laws.g.one().bare);
    let none = [zero, zero, zero];
    let mechanism = laws.mechanism;
    if contacts.is_empty() && mechanism.events.iter().all(|event| event.jump.is_none()) {
        return Vec::new();
    }
    let gates = match contacts.is_empty() {
        true => mechanism.gates().map(|_| none).collect(),
        false => contacts,
    };
    let events = mechanism.events_in_places().into_iter().map(|(_, event)| match &event.jump {
        Some(jump) => [laws.coordinate(&jump.of).rate().bare, zero, one],
        None => none,
    });
    gates.into_iter().chain(events).chain(mechanism.memories.iter().map(|_| none)).collect()
}

/// What gates of contacts have two numbers of, followed by zeros of each event and memory. Nothing where they have none.
pub fn with_none(laws: &Laws, contacts: Vec<[Node; 2]>) -> Vec<[Node; 2]> {
    let none = [laws.g.zero().bare; 2];
    let mechanism = laws.mechanism;
    let behind = if contacts.is_empty() { 0 } else { mechanism.events.len() + mechanism.memories.len() };
    contacts.into_iter().chain(vec![none; behind]).collect()
}

/// All that is held after the events that occur: memories as these set them, what speeds jump to at the places of events, the rest as it is.
/// Nothing without events.
pub fn assignments(laws: &Laws) -> Vec<Node> {
    let mechanism = laws.mechanism;
    if mechanism.events.is_empty() {
        return Vec::new();
    }
    let (half, gates) = (laws.g.number(0.5), &laws.symbols.gates);
    let first = mechanism.gates().count();
    let places = mechanism.events_in_places();
    let place = |event: usize| first + places.iter().position(|(index, _)| *index == event).unwrap_or(0);
    let mut after = gates.clone();
    for (index, event) in mechanism.events.iter().enumerate() {
        let occurs = half.compare(Compare::Less, laws.g.on(gates[place(index)]));
        for (memory, value) in &event.sets {
            let at = mechanism.place_of_memory(*memory);
            after[at] = occurs.select(laws.value(value), laws.g.on(after[at])).bare;
        }
        if let Some(jump) = &event.jump {
            after[place(index)] = laws.value(&jump.to).bare;
        }
    }
    after
}
