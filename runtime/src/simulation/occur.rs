//! Events of a definition: which of them occur at the present state, and what memories become.
//!
//! ```text
//! m⁺ = what the events that occur set m to, at t, q, v, z, u and m before them
//! ```
//! All that occur at one time are one pass: what they set is of the values before it, and where two set the same memory the one that is
//! written last decides; the speeds that they let jump do so together (`jump.rs`). What follows from the new memories and speeds, the gates of
//! contacts and events that these let occur, is another pass at the same time. Ticks are counted: the next one is at k T, exactly, however
//! many there were. Where steps are parted is `held.rs`.

use super::Simulation;
use super::held::EVENTS_PER_STEP;
use super::rigid::Held;
use super::strike::Blow;
use crate::clock::Clock;
use crate::error::SimulationError;
use crate::formulation::Formulation;
use crate::input::InputSource;
use crate::integrator::Method;
use crate::mechanism::{Assemble, Mechanism};
use crate::real::Real;
use crate::state::StateOf;
use crate::trigger::{Places, Trigger, early, period, with_memories};
use crate::vector::{Vector, at, put};

/// Whether what is held at a place of contacts or of events that pass a level tells that something happened, given what it would be now.
#[inline]
pub(super) fn happens<R: Real, M: Mechanism<R>>(model: &M, place: usize, held: R, live: R) -> bool {
    let first = Places::of(model).contacts;
    match place.checked_sub(first).and_then(|index| model.triggers().get(index)) {
        Some(Trigger::Rises) => live > held,
        Some(Trigger::Falls) => live < held,
        Some(Trigger::Every(_)) => false,
        Some(Trigger::Crosses) | None => live != held,
    }
}

/// The time of the next tick of the event at this place.
fn due<R: Real, M: Mechanism<R>>(model: &M, state: &StateOf<M, R>, place: usize) -> Clock<R> {
    let (period, count): (R, R) = (period(model, place), at(state.gates.as_slice(), place));
    let time = count * period;
    // What the product leaves out.
    Clock::at(time).after(count.mul_add(period, -time))
}

impl<'m, R, M, F, S, I> Simulation<'m, M, R, F, S, I>
where
    R: Real,
    M: Assemble<R>,
    F: Formulation<R, M>,
    S: InputSource<R, M>,
    I: Method<R>,
{
    /// Takes the gates as they are at the present state, after impulses where they are forces, and lets the events occur that do; what a method
    /// carries from step to step is of what was held before.
    pub(super) fn occur(&mut self) -> Result<Blow<R>, SimulationError> {
        let model = self.model();
        let places = Places::of(model);
        let mut blow = Blow::none();
        loop {
            if model.sticks() {
                blow.take(&self.stick()?);
            } else if model.is_rigid() {
                blow.take(&self.strike()?);
            }
            if model.is_rigid() && model.triggers().is_empty() {
                return Ok(blow);
            }
            let mut live = model.live_gates(self.time(), &self.run.state);
            if model.is_rigid() {
                // Their gates are the forces that were found.
                live = with_memories(model, self.run.state.gates.clone(), &live);
            }
            let held = self.run.state.gates.as_slice();
            let both = live.as_slice().iter().zip(held).take(places.contacts);
            let changed = both.filter(|(live, held)| live != held).count() as u32;
            let (occurring, count) = self.occurring(&places, &live);
            if changed > 0 || count > 0 {
                self.memory = self.integrator.memory();
            }
            blow.changed += changed;
            if count == 0 {
                self.run.state.gates = live;
                return Ok(blow);
            }
            blow.events += count;
            let first =
                (places.contacts..places.events).find(|place| at(occurring.as_slice(), *place) > R::ZERO);
            if blow.events > EVENTS_PER_STEP {
                return Err(self.without_end(first.unwrap_or(0)));
            }
            let (mut after, jumped) = self.after(&places, &live, &occurring)?;
            if jumped && model.is_rigid() {
                // What rested or held is met anew, with the speeds that it has now.
                for place in 0..places.contacts {
                    put(after.as_mut_slice(), place, R::ZERO);
                }
                self.dynamics.held = Held::none(model);
            }
            self.run.state.gates = after;
        }
    }

    /// Marks the events that occur, and counts them.
    fn occurring(&self, places: &Places, live: &M::Gates) -> (M::Gates, u32) {
        let (model, state) = (self.model(), &self.run.state);
        let mut occurring = M::Gates::zeros(model.gate_names().len());
        let mut count = 0;
        for place in places.contacts..places.events {
            let occurs = if place < places.passing {
                happens(model, place, at(state.gates.as_slice(), place), at(live.as_slice(), place))
            } else {
                let early = early(period(model, place), self.time());
                self.run.clock.until(&due(model, state, place)) <= early
            };
            if occurs {
                put(occurring.as_mut_slice(), place, R::ONE);
                count += 1;
            }
        }
        (occurring, count)
    }

    /// What is held after the events that occur, and whether a speed jumped.
    fn after(
        &mut self,
        places: &Places,
        live: &M::Gates,
        occurring: &M::Gates,
    ) -> Result<(M::Gates, bool), SimulationError> {
        let (model, time) = (self.model(), self.time());
        let state = self.run.state.clone();
        let inputs = self.dynamics.inputs_within(time, &state);
        let mut marked = state.clone();
        for place in places.contacts..places.events {
            put(marked.gates.as_mut_slice(), place, at(occurring.as_slice(), place));
        }
        let mut after = marked.gates.clone();
        model.assignments(time, &marked, &inputs, &mut after);
        // What a speed would jump to need be no number where it does not.
        for place in
            (places.contacts..places.events).filter(|place| at(occurring.as_slice(), *place) == R::ZERO)
        {
            put(after.as_mut_slice(), place, R::ZERO);
        }
        if let Some(place) = after.first_not_finite() {
            return Err(SimulationError::NonFinite { time: time.to_f64(), what: self.contact(place) });
        }
        let jumped = self.jump(occurring, &after)?;
        for place in 0..places.passing {
            put(after.as_mut_slice(), place, at(live.as_slice(), place));
        }
        for place in places.ticks() {
            let next = at(state.gates.as_slice(), place) + at(occurring.as_slice(), place);
            put(after.as_mut_slice(), place, next);
        }
        Ok((after, jumped))
    }

    /// Where a step to `end` is to stop for a tick, if one is before.
    pub(super) fn until_tick(&self, h: R, end: Clock<R>) -> (R, Clock<R>) {
        let (model, state) = (self.model(), &self.run.state);
        let mut first = (h, end);
        for place in Places::of(model).ticks() {
            let due = due(model, state, place);
            if due.until(&first.1) > early(period(model, place), self.time()) {
                first = (self.run.clock.until(&due), due);
            }
        }
        first
    }

    /// The error of events that occur too often, of which this is one.
    #[cold]
    pub(super) fn without_end(&self, place: usize) -> SimulationError {
        let (event, time) = (self.contact(place), self.time().to_f64());
        SimulationError::EventWithoutEnd { event, time, most: EVENTS_PER_STEP }
    }
}
