//! Gates of contacts that are held within a step, and the touches and releases at which it is parted.
//!
//! ```text
//! gate = 1 where g < 0 and F > 0, else 0            g the gap, F the force of the law without the gate
//! ```
//! at the beginning of a piece of a step, and the same until its end. Where g and F say something else at the end, the first time at which
//! they do is searched by repeating the piece (`locate.rs`), the piece ends there, the gates become what they are, and the rest of the step
//! follows. Stages of a method thus see one law each, which is smooth, and the method keeps its order where the force of a law jumps.

use super::course::Course;
use super::locate::{Search, StandingOf, TRIALS};
use super::occur::happens;
use super::sticking::TURNING;
use super::strike::{Blow, IMPACTS_PER_STEP};
use super::{MechanismDynamics, Simulation, Step};
use crate::clock::Clock;
use crate::error::SimulationError;
use crate::formulation::Formulation;
use crate::input::InputSource;
use crate::integrator::{Integrator, Method, Rejections};
use crate::mechanism::{Assemble, Mechanism};
use crate::real::Real;
use crate::state::Variables;
use crate::trigger::{Places, contacts};
use crate::vector::Vector;
use core::ops::Range;

/// How often gates of contacts may open or close in one step; more is [`Chatter`](SimulationError::Chatter). Those that do so at one time count
/// once.
pub const EVENTS_PER_STEP: u32 = 32;

/// The same where dry friction resists sliding along several directions: there steps are parted too while it comes to rest and leaves it.
const PIECES_PER_STEP: u32 = 2 * TURNING;

/// How far behind the time of a touch or release a piece may end, as a part of it; but at least four roundings.
const LATE: f64 = 1e-12;

/// A part of a step that is no piece of its own, at its beginning and at its end.
const SLIVER: f64 = 1e-9;

/// Gaps and forces of all gates.
type Guards<M, R> = [<M as Variables<R>>::Gates; 2];

impl<'m, R, M, F, S, I> Simulation<'m, M, R, F, S, I>
where
    R: Real,
    M: Assemble<R>,
    F: Formulation<R, M>,
    S: InputSource<R, M>,
    I: Method<R>,
{
    /// Takes the gates as they are at the present state, after the impulses of rigid contacts or the events that occur here; what happened.
    pub(super) fn hold(&mut self) -> Result<Blow<R>, SimulationError> {
        if !M::HOLDS {
            return Ok(Blow::none());
        }
        self.occur()
    }

    fn guards(&mut self) -> Guards<M, R> {
        let model = self.model();
        if model.is_rigid() {
            return self.rigid_guards();
        }
        let zeros = || M::Gates::zeros(model.gate_names().len());
        let (mut gaps, mut forces) = (zeros(), zeros());
        model.guards(self.time(), &self.run.state, &mut gaps, &mut forces);
        [gaps, forces]
    }

    /// Whether the gates are no longer what they are held at or an event occurs, and the first of those.
    fn left(&mut self) -> Option<usize> {
        let (model, mut from) = (self.model(), 0);
        if model.is_rigid() {
            let guards = self.rigid_guards();
            let touches = self.rigid_left(&guards);
            from = contacts(model);
            if touches.is_some() || model.triggers().is_empty() {
                return touches;
            }
        }
        let live = model.live_gates(self.time(), &self.run.state);
        let both = live.as_slice().iter().zip(self.run.state.gates.as_slice()).enumerate();
        let mut happening =
            both.skip(from).filter(|(place, (live, held))| happens(model, *place, **held, **live));
        happening.next().map(|(place, _)| place)
    }
}

impl<'m, R, M, F, S, I> Simulation<'m, M, R, F, S, I>
where
    R: Real,
    M: Assemble<R>,
    F: Formulation<R, M>,
    S: InputSource<R, M>,
    I: Integrator<R, MechanismDynamics<'m, M, R, F, S>>,
{
    /// One step of size `h` in as many pieces as it has touches and releases, and one more.
    #[inline(never)]
    pub(super) fn advance_held(&mut self, h: R, end: Clock<R>) -> Result<Step<R>, SimulationError> {
        let begin = self.standing();
        let taken = self.in_pieces(h, end);
        if taken.is_err() {
            self.stand(begin);
        }
        taken
    }

    fn in_pieces(&mut self, h: R, end: Clock<R>) -> Result<Step<R>, SimulationError> {
        let (mut whole, mut events, mut left) = (None, 0, h);
        loop {
            let (piece, parted) = self.piece(left, end, &mut events)?;
            let blow = self.hold()?;
            let step = with(&piece, &blow);
            let sum = whole.map_or(step, |before| together(&before, &step));
            if !self.run.clock.is_before(&end) {
                return Ok(Step { size: h, ..sum });
            }
            if !parted {
                // A method that chooses its steps took less.
                return Ok(sum);
            }
            whole = Some(sum);
            left = self.run.clock.until(&end);
        }
    }

    /// A step of the run, or what of it is before the next touch or release; what the method remembers is of this piece.
    pub(super) fn advance_piece(
        &mut self,
        course: &mut Course<R>,
        events: &mut u32,
    ) -> Result<(), SimulationError> {
        let begin = self.standing();
        let (h, end) = self.next_along(course)?;
        match self.piece(h, end, events) {
            Ok((_, parted)) => {
                *events = if parted { *events } else { 0 };
                Ok(())
            }
            Err(error) => {
                self.stand(begin);
                Err(error)
            }
        }
    }

    /// The way to `end`, or to the first touch, release or event before it, with the gates as they are here; and whether there was one. It is
    /// left to the next piece to change gates.
    fn piece(&mut self, h: R, end: Clock<R>, events: &mut u32) -> Result<(Step<R>, bool), SimulationError> {
        let blow = self.hold()?;
        let whole = end;
        let (h, next) = self.until_tick(h, end);
        let (h, end) = self.until_turned(h, next, *events);
        let turns = end.is_before(&next);
        let begin = self.standing();
        let inputs = self.dynamics.present_inputs(self.time(), &self.run.state.clone());
        let mut step = self.step_by(h, end)?;
        let parted = match self.left() {
            None => {
                let parted = !self.run.clock.is_before(&end) && self.run.clock.is_before(&whole);
                *events += u32::from(parted && turns);
                parted
            }
            Some(first) => {
                step = self.part(begin, step)?;
                *events += 1;
                self.check_count(*events, first)?;
                true
            }
        };
        step = with(&step, &blow);
        if S::HELD && parted && self.run.clock.is_before(&whole) {
            // They are held over the whole step.
            self.dynamics.inputs = Some(inputs);
        }
        Ok((step, parted))
    }

    /// An error if touches and releases, or events, are too many for one step.
    fn check_count(&mut self, events: u32, first: usize) -> Result<(), SimulationError> {
        let strikes = self.model().is_rigid() && !self.model().sticks();
        let most = match self.model().slide_as_one().is_empty() {
            _ if strikes => IMPACTS_PER_STEP,
            true => EVENTS_PER_STEP,
            false => PIECES_PER_STEP,
        };
        if events <= most {
            return Ok(());
        }
        let first = self.left().unwrap_or(first);
        if first >= Places::of(self.model()).contacts {
            return Err(self.without_end(first));
        }
        let (contact, time) = (self.contact(first), self.time().to_f64());
        Err(SimulationError::Chatter { contact, time, most })
    }

    /// Goes back to the first time between `begin` and here at which a gate changes.
    #[cold]
    fn part(
        &mut self,
        begin: StandingOf<M, R, F, M::Inputs, I>,
        whole: Step<R>,
    ) -> Result<Step<R>, SimulationError> {
        let size = whole.size;
        let held = self.straight();
        let four = R::from_f64(4.0) * R::EPSILON;
        let tolerance = R::from_f64(LATE).max(four) * size;
        let sliver = R::from_f64(SLIVER).max(four) * size;
        let (ahead, mut step) = (self.guards(), whole);
        let mut found = self.standing();
        self.stand(begin.clone());
        let (mut low, mut high) = ((R::ZERO, self.guards()), (size, ahead));
        let mut base = (R::ZERO, low.1.clone(), begin.clone());
        let mut search = Search::new(size, tolerance);
        let mut trials = 0;
        while high.0 - low.0 > tolerance && high.0 > sliver && size - low.0 > sliver {
            if trials == TRIALS {
                self.stand(begin);
                let (time, width) = (self.time().to_f64(), (high.0 - low.0).to_f64());
                return Err(SimulationError::EventNotLocated { time, width, trials });
            }
            trials += 1;
            let part = expected(self.model(), &held, &low.1, &high.1, high.0 - low.0);
            let at = search.next(low.0, high.0, part);
            self.stand(base.2.clone());
            let asked = at - base.0;
            let taken = self.step_by(asked, self.run.clock.after(asked))?;
            // A method that chooses its steps may have stopped before.
            let stopped = taken.size != asked;
            let reached = (if stopped { base.0 + taken.size } else { at }, self.guards());
            if reached.0 <= low.0 {
                low = (base.0, base.1.clone());
            }
            if self.left().is_some() {
                high = reached;
                step = Step { size: high.0, ..taken };
                found = self.standing();
            } else {
                if stopped {
                    base = (reached.0, reached.1.clone(), self.standing());
                }
                low = reached;
            }
        }
        self.stand(found);
        Ok(step)
    }
}

/// The part of the time between two guards at which the first gate is to be expected to change or event to occur, from 0 to 1.
fn expected<R: Real, M: Mechanism<R>>(
    model: &M,
    held: &M::Gates,
    before: &Guards<M, R>,
    after: &Guards<M, R>,
    time: R,
) -> R {
    let places = Places::of(model);
    if !model.is_rigid() {
        return expected_gate(model, held, before, after, 0..places.passing);
    }
    let touch = expected_touch(held, before, after, time, places.contacts);
    touch.min(expected_gate(model, held, before, after, places.contacts..places.passing))
}

/// The same of gates and events at some places.
fn expected_gate<R: Real, M: Mechanism<R>>(
    model: &M,
    held: &M::Gates,
    before: &Guards<M, R>,
    after: &Guards<M, R>,
    at: Range<usize>,
) -> R {
    let [gaps, forces] = before;
    let each = held.as_slice().iter().take(at.end).zip(gaps.as_slice().iter().zip(forces.as_slice()));
    let [gaps, forces] = after;
    let each = each.zip(gaps.as_slice().iter().zip(forces.as_slice()));
    let part = |a: R, b: R| a / (a - b);
    let half = R::from_f64(0.5);
    let first =
        each.enumerate().skip(at.start).filter_map(|(place, ((&held, (&gap, &force)), (&then, &forced)))| {
            let (deep, pressed) = (then < R::ZERO, forced > R::ZERO);
            let live = if deep && pressed { R::ONE } else { R::ZERO };
            if !happens(model, place, held, live) {
                return None;
            }
            if held > half {
                // It opens with the first of both.
                let out = (!deep).then(|| part(gap, then));
                let off = (!pressed).then(|| part(force, forced));
                match (out, off) {
                    (Some(out), Some(off)) => Some(out.min(off)),
                    (one, other) => one.or(other),
                }
            } else if deep && pressed {
                // It closes with the last.
                let into = if gap < R::ZERO { R::ZERO } else { part(gap, then) };
                let on = if force > R::ZERO { R::ZERO } else { part(force, forced) };
                Some(into.max(on))
            } else {
                None
            }
        });
    let first = first.fold(R::ONE, |first, part| part.min(first));
    // Written so that a NaN is the middle.
    if first >= R::ZERO && first <= R::ONE { first } else { half }
}

/// The part of the time between two guards at which the first rigid contact is to be expected to touch, by the parabola through the gaps with
/// the rate at the beginning, or to pull, by the line through its forces.
fn expected_touch<R: Real, G: Vector<R>>(
    held: &G,
    before: &[G; 2],
    after: &[G; 2],
    time: R,
    contacts: usize,
) -> R {
    let [gaps, rates] = before;
    let each = held.as_slice().iter().take(contacts).zip(gaps.as_slice().iter().zip(rates.as_slice()));
    let [ahead, _] = after;
    let each = each.zip(ahead.as_slice());
    let (half, four) = (R::from_f64(0.5), R::from_f64(4.0));
    let first = each.filter_map(|((&held, (&gap, &rate)), &then)| {
        if then >= R::ZERO {
            return None;
        }
        if held > R::ZERO {
            return Some(gap / (gap - then));
        }
        let gap = gap.max(R::ZERO);
        let rise = rate * time;
        let bend = then - gap - rise;
        let root = (rise * rise - four * bend * gap).max(R::ZERO).sqrt();
        Some(if rise > R::ZERO { -half * (rise + root) / bend } else { (gap + gap) / (root - rise) })
    });
    let first = first.fold(R::ONE, |first, part| part.min(first));
    // Written so that a NaN is the middle.
    if first >= R::ZERO && first <= R::ONE { first } else { half }
}

/// A step with what its impulses did.
fn with<R: Real>(step: &Step<R>, blow: &Blow<R>) -> Step<R> {
    Step {
        gates_changed: step.gates_changed + blow.changed,
        events: step.events + blow.events,
        impacts: step.impacts + blow.impacts,
        rested: step.rested + blow.rested,
        lost: step.lost + blow.lost,
        gained: step.gained + blow.gained,
        ..*step
    }
}

/// What happened in two steps that follow each other.
fn together<R: Real>(before: &Step<R>, after: &Step<R>) -> Step<R> {
    let nearer = match (before.near_singular, after.near_singular) {
        (Some(a), Some(b)) if a.reciprocal_condition < b.reciprocal_condition => Some(a),
        (before, after) => after.or(before),
    };
    let (a, b) = (before.rejections, after.rejections);
    Step {
        time: after.time,
        size: before.size + after.size,
        reciprocal_condition: before.reciprocal_condition.min(after.reciprocal_condition),
        near_singular: nearer,
        iterations: before.iterations + after.iterations,
        residual: before.residual.max(after.residual),
        moved: before.moved.max(after.moved),
        rejections: Rejections {
            error: a.error + b.error,
            convergence: a.convergence + b.convergence,
            breakdown: a.breakdown + b.breakdown,
        },
        friction_residual: before.friction_residual.max(after.friction_residual),
        stepped_over: before.stepped_over + after.stepped_over,
        gates_changed: before.gates_changed + after.gates_changed,
        events: before.events + after.events,
        impacts: before.impacts + after.impacts,
        rested: before.rested + after.rested,
        lost: before.lost + after.lost,
        gained: before.gained + after.gained,
    }
}
