//! What lets the events of a definition occur, and where memories stand in a state.
//!
//! ```text
//! state.gates = [gates of contacts | events that pass a level | events with a period | memories]
//!                1 closed, else 0    1 above, else 0            number of the next tick
//! ```
//! When they occur within a step, and what follows, is `simulation/occur.rs`.

use crate::mechanism::Mechanism;
use crate::real::Real;
use crate::state::StateOf;
use crate::vector::{Vector, at, put};
use core::ops::Range;

/// What lets an event of a definition occur.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Trigger {
    /// A value becomes larger than its level.
    Rises,
    /// A value stops being larger than its level.
    Falls,
    /// One of both.
    Crosses,
    /// The time is a multiple of this period, s.
    Every(f64),
}

impl Trigger {
    /// Whether it has a period.
    pub fn is_periodic(&self) -> bool {
        matches!(self, Trigger::Every(_))
    }
}

/// Where gates of contacts, events that pass a level, events with a period, and memories stand.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Places {
    pub contacts: usize,
    /// Behind the events that pass a level.
    pub passing: usize,
    /// Behind those with a period.
    pub events: usize,
}

impl Places {
    #[inline(always)]
    pub fn of<R: Real, M: Mechanism<R> + ?Sized>(model: &M) -> Self {
        let triggers = model.triggers();
        let events = model.gate_names().len().saturating_sub(model.memory_names().len());
        let contacts = events.saturating_sub(triggers.len());
        let passing = contacts + triggers.iter().filter(|trigger| !trigger.is_periodic()).count();
        Places { contacts, passing, events }
    }

    pub fn ticks(&self) -> Range<usize> {
        self.passing..self.events
    }
}

/// How many gates are those of contacts, or of dry friction in joints.
pub(crate) fn contacts<R: Real, M: Mechanism<R> + ?Sized>(model: &M) -> usize {
    Places::of(model).contacts
}

/// Gates with what is held of events and memories as it is in others.
pub(crate) fn with_memories<R: Real, M: Mechanism<R> + ?Sized>(
    model: &M,
    mut gates: M::Gates,
    held: &M::Gates,
) -> M::Gates {
    for place in contacts(model)..model.gate_names().len() {
        put(gates.as_mut_slice(), place, at(held.as_slice(), place));
    }
    gates
}

/// The period of the event at this place.
pub(crate) fn period<R: Real, M: Mechanism<R> + ?Sized>(model: &M, place: usize) -> R {
    let first = Places::of(model).contacts;
    match place.checked_sub(first).and_then(|index| model.triggers().get(index)) {
        Some(Trigger::Every(period)) => R::from_f64(*period),
        _ => R::ONE,
    }
}

/// How far before its time a tick may be, s: a billionth of the period, what times are rounded by, and at most a hundredth of the period.
pub(crate) fn early<R: Real>(period: R, time: R) -> R {
    let rounded = R::from_f64(8.0) * R::EPSILON * time.abs();
    (R::from_f64(1e-9) * period).max(rounded).min(R::from_f64(0.01) * period)
}

/// Lets the next tick of each event with a period be the first that is not before this time.
pub(crate) fn align<R: Real, M: Mechanism<R> + ?Sized>(model: &M, time: R, state: &mut StateOf<M, R>) {
    for place in Places::of(model).ticks() {
        let period = period(model, place);
        let from = (time - early(period, time)) / period;
        put(state.gates.as_mut_slice(), place, -(-from).floor());
    }
}
