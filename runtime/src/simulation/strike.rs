//! What happens where rigid contacts touch: impulses, and the forces and ways with which they go on. Its equations stand in `rigid.rs`.
//!
//! ```text
//! Δv = W P,    ΔT = ½ P·(ξ⁺ + ξ⁻),    ξ = J v + drift, of gaps and of what slides in them
//! ```
//! Newton's law of restitution beside friction may give energy (Kane and Levinson, Dynamics, 1985, 5.8): [`Blow::gained`] says so.

use super::Simulation;
use super::along_several::{alone, is_first, together};
use super::complementarity::{Few, Problem, RIGID_TOUCHING, ROWS, Rub, Way};
use super::held_rows::along;
use super::resting::{Settled, stop};
use super::rigid::{Held, Strikes, grips, near, pressed_by, stands, still, strikes};
use crate::error::{SettingError, SimulationError};
use crate::formulation::Formulation;
use crate::input::InputSource;
use crate::integrator::Method;
use crate::mechanism::Assemble;
use crate::real::Real;
use crate::state::State;
use crate::trigger::{contacts, with_memories};
use crate::vector::{Vector, at, dot, put};

/// How often rigid contacts may touch or part in one step; more is [`Chatter`](SimulationError::Chatter). What comes to rest with restitution e
/// touches ln(10⁷)/ln(1/e) times in its last step: 73 times with 0.8, 1604 times with 0.99.
pub const IMPACTS_PER_STEP: u32 = 16384;

/// Depths at which a step or a start is refused, m or rad; but at least the root of a rounding.
const INSIDE: f64 = 1e-6;

/// The shortest flight between two touches, as a part of the step; but at least what the rounding of a gap leaves of one.
const FLIGHT: f64 = 1e-7;

/// What impulses did.
#[derive(Clone, Copy)]
pub(super) struct Blow<R> {
    /// Contacts that opened or closed.
    pub changed: u32,
    /// Events of the definition that occurred.
    pub events: u32,
    pub impacts: u32,
    pub rested: u32,
    /// What all took, and what some gave, J.
    pub lost: R,
    pub gained: R,
}

/// What of a speed counts for no sliding, in roundings of speeds: from it, friction may hold.
pub(super) const SLOW: f64 = 1000.0;

/// What is left of ẇ where others hold what slides, as a part of what friction makes of it.
const TIED: f64 = 1e-9;

/// Contacts that know of each other.
struct Group {
    which: [usize; RIGID_TOUCHING],
    count: usize,
}

/// The contacts that touch, and how they depend on one another.
pub(super) struct Touching<R, V> {
    /// Gates: of the gaps, then of what slides in them.
    pub which: [usize; ROWS],
    /// W, a column for each.
    ways: [V; ROWS],
    pub problem: Problem<R>,
}

/// How contacts that touch approach: of each row its rate, and the derivative of that with all contacts open; of each gap how it falls, with those
/// closed that were, and the speed below which it does not bounce.
struct Approach<R> {
    rates: Few<R>,
    bends: Few<R>,
    falls: Few<R>,
    slowest: Few<R>,
}

impl<'m, R, M, F, S, I> Simulation<'m, M, R, F, S, I>
where
    R: Real,
    M: Assemble<R>,
    F: Formulation<R, M>,
    I: Method<R>,
{
    /// Impulses of what touches and closes, then the forces of what stays closed.
    pub(super) fn strike(&mut self) -> Result<Blow<R>, SimulationError>
    where
        S: InputSource<R, M>,
    {
        let mut blow = Blow::none();
        let (model, time) = (self.model(), self.time());
        let zeros = || M::Gates::zeros(model.gate_names().len());
        let mut gaps = zeros();
        model.guards(time, &self.run.state, &mut gaps, &mut zeros());
        let before = self.run.state.gates.clone();
        let (mut gates, mut held) = (zeros(), Held::none(model));
        let mut left = self.near(&gaps)?;
        if left.as_slice().iter().any(|it| *it > R::ZERO) {
            let inputs = self.dynamics.present_inputs(time, &self.run.state.clone());
            let mut store = model.store();
            model.factor(time, &self.run.state.q, R::ZERO, &mut store);
            let mut group = R::ZERO;
            while let Some(members) = self.group(&mut left, &store, &inputs)? {
                for &i in members.each() {
                    put(held.groups.as_mut_slice(), i, group);
                }
                group = group + R::ONE;
                let touching = self.touching(&members, &store, &inputs);
                self.strike_group(touching, &gaps, &inputs, &mut gates, &mut held, &mut blow)?;
            }
        }
        self.take_gates(&before, gates, held, &mut blow);
        if blow.impacts > 0 && !S::HELD {
            self.dynamics.inputs = None;
        }
        Ok(blow)
    }

    /// The same of contacts that know of each other.
    fn strike_group(
        &mut self,
        mut touching: Touching<R, M::V>,
        gaps: &M::Gates,
        inputs: &M::Inputs,
        gates: &mut M::Gates,
        now: &mut Held<M::Gates>,
        blow: &mut Blow<R>,
    ) -> Result<(), SimulationError> {
        let (model, time) = (self.model(), self.time());
        // Parameters may say anything.
        let is_share = |share: R| R::any(share.greater_equal(R::ZERO));
        if let Some(rub) =
            touching.problem.rubbing().find(|rub| !is_share(rub.holding) || !is_share(rub.sliding))
        {
            let (what, value) = (self.contact(touching.at(rub.row)), rub.holding.min(rub.sliding).to_f64());
            return Err(
                SettingError { what, value, must_be: "a coefficient of friction of at least 0" }.into()
            );
        }
        let (before, ways_before) = (self.run.state.gates.clone(), self.dynamics.held.ways.clone());
        let closed = |i: usize| at(before.as_slice(), i) > R::ZERO;
        let rests = |i: usize| match pressed_by(model, i) {
            None => closed(i),
            Some(gap) => closed(gap) && stands(model, &ways_before, i),
        };
        let mut approach = self.approach(&mut touching, inputs, closed, rests);
        let resting = touching.each().filter(|(_, i)| rests(*i)).fold(0, |set, (place, _)| set | 1 << place);
        if let Some(back) = touching.problem.against(&approach.rates, resting) {
            // What rests does not move on: what a method leaves of that is taken back, along the way of an impulse.
            for (along, way) in back.iter().zip(&touching.ways) {
                self.run.state.v.axpy(*along, way);
            }
            for (place, rate) in approach.rates.iter_mut().enumerate() {
                *rate = *rate + touching.problem.row(place, &back);
            }
        }
        let still = still(self.run.state.v.as_slice());
        let State { q, v, .. } = &self.run.state;
        let shares = strikes(model, time, q, v).shares;
        let closes = touching.gaps().any(|(place, i)| {
            at(&approach.rates, place) < -still && at(gaps.as_slice(), i) <= R::ZERO && !closed(i)
        });
        if closes {
            let shares = shares.as_slice();
            // Parameters may say anything.
            let is_share = |share: R| R::any(share.greater_equal(R::ZERO) & share.less_equal(R::ONE));
            if let Some((_, i)) = touching.gaps().find(|(_, i)| !is_share(at(shares, *i))) {
                let (what, value) = (self.contact(i), at(shares, i).to_f64());
                return Err(SettingError { what, value, must_be: "a restitution from 0 to 1" }.into());
            }
            // What rests has no speed to part with; by Poisson's law it has an impulse.
            let bounces = |i: usize| model.parts_by_impulses() || !closed(i);
            let share = |i: usize| if bounces(i) { at(shares, i) } else { R::ZERO };
            self.take_impulses(&touching, &approach, share, closed, blow)?;
            approach = self.approach(&mut touching, inputs, closed, |_| false);
        }
        let Approach { rates, bends, falls, slowest } = approach;
        // What flies no higher than from the slowest bounce.
        let two = R::from_f64(2.0);
        let still_near = touching.gaps().filter(|&(place, i)| {
            let (rate, rest) = (at(&rates, place), at(&slowest, place));
            let above = if closed(i) { R::ZERO } else { at(gaps.as_slice(), i).max(R::ZERO) };
            rate * rate + two * at(&falls, place) * above <= rest * rest
        });
        let near = still_near.fold(0, |set, (place, _)| set | 1 << place);
        let Some(Settled { found, stopped, bends }) =
            self.settled(&mut touching, inputs, &rates, bends, near)
        else {
            return Err(self.no_impact(&touching));
        };
        let slow = R::from_f64(SLOW) * still;
        let (mut held, mut pushed) = (0_usize, 0_usize);
        let mut off = [R::ZERO; ROWS];
        for (place, i) in touching.gaps() {
            let (force, gap) = (at(&found.forces, place), at(gaps.as_slice(), i));
            let rests = force > R::ZERO;
            put(gates.as_mut_slice(), i, force);
            held |= usize::from(rests) << place;
            pushed |= usize::from(rests || gap < R::ZERO) << place;
            blow.rested += u32::from(rests && !closed(i));
            put(&mut off, place, gap);
        }
        for (rub, way) in touching.problem.rubbing().zip(&found.ways) {
            let presses = held >> rub.pressed & 1 == 1;
            let stands = *way == Way::Open || stopped >> rub.row & 1 == 1;
            for (axis, place) in rub.rows().enumerate() {
                let i = touching.at(place);
                put(gates.as_mut_slice(), i, at(&found.forces, place));
                put(now.ways.as_mut_slice(), i, way.along(axis));
                held |= usize::from(presses && stands) << place;
            }
            if rub.axes > 1 && *way != Way::Open {
                let first = touching.at(rub.row);
                let speed = if stands { R::ZERO } else { rub.size(&rates) };
                put(now.speeds.as_mut_slice(), first, speed);
                let bent = touching.problem.rates(&rub, &found.forces, &bends);
                let braked = rub.size(&found.forces) * touching.problem.trace(&rub);
                // What others hold has no way of its own.
                if speed > slow || dot(&bent, &bent).sqrt() > R::from_f64(TIED) * braked {
                    // In what time its way may change by as much as its speed does.
                    let slowest = speed.max(stop(&touching.problem, &rub, &found.forces, &bends));
                    put(now.times.as_mut_slice(), first, slowest / braked);
                }
            }
        }
        // What is rigid is never inside.
        if let Some(back) = touching.problem.against(&rates, held) {
            for (along, way) in back.iter().zip(&touching.ways) {
                self.run.state.v.axpy(*along, way);
            }
        }
        if let Some(back) = touching.problem.against(&off, pushed) {
            let mut moved = model.zero_v();
            for (along, way) in back.iter().zip(&touching.ways) {
                moved.axpy(*along, way);
            }
            let State { v, z, .. } = self.run.state.clone();
            self.run.state = self.run.state.moved(model.layout(), &moved, v, z);
        }
        Ok(())
    }

    /// v⁺ = v⁻ + W P, by the shares with which gaps part.
    fn take_impulses(
        &mut self,
        touching: &Touching<R, M::V>,
        Approach { rates, slowest, .. }: &Approach<R>,
        share: impl Fn(usize) -> R,
        closed: impl Fn(usize) -> bool,
        blow: &mut Blow<R>,
    ) -> Result<(), SimulationError> {
        let mut bounces = [R::ZERO; ROWS];
        for (place, i) in touching.gaps() {
            put(&mut bounces, place, share(i));
        }
        let problem = &touching.problem;
        let impulses = match self.model().parts_by_impulses() {
            true => problem.poisson(rates, &bounces, slowest),
            false => problem.newton(rates, &bounces, slowest),
        };
        let Some(impulses) = impulses else {
            return Err(self.no_impact(touching));
        };
        for (place, i) in touching.gaps() {
            blow.impacts += u32::from(at(&impulses, place) > R::ZERO && !closed(i));
        }
        let (half, mut taken) = (R::from_f64(0.5), R::ZERO);
        for ((place, _), way) in touching.each().zip(&touching.ways) {
            self.run.state.v.axpy(at(&impulses, place), way);
            let twice = at(rates, place) + at(rates, place) + problem.row(place, &impulses);
            taken = taken - half * at(&impulses, place) * twice;
        }
        blow.lost = blow.lost + taken.max(R::ZERO);
        blow.gained = blow.gained + (-taken).max(R::ZERO);
        Ok(())
    }

    /// 1 for each gap that is closed; how far off a method leaves one that rests is taken back.
    fn near(&self, gaps: &M::Gates) -> Result<M::Gates, SimulationError> {
        let model = self.model();
        let (inside, near) = (R::from_f64(INSIDE).max(R::EPSILON.sqrt()), near::<R>());
        let mut left = M::Gates::zeros(model.gate_names().len());
        for (i, &gap) in gaps.as_slice().iter().enumerate().take(contacts(model)) {
            let rests = at(self.run.state.gates.as_slice(), i) > R::ZERO;
            if gap > near && !rests || pressed_by(model, i).is_some() {
                continue;
            }
            if gap < -inside && !rests {
                let (contact, time, depth) = (self.contact(i), self.time().to_f64(), -gap.to_f64());
                return Err(SimulationError::Inside { contact, time, depth });
            }
            put(left.as_mut_slice(), i, R::ONE);
        }
        Ok(left)
    }

    /// The next contacts of those that are left which know of each other, and takes them out: all where they are few.
    fn group(
        &self,
        left: &mut M::Gates,
        store: &M::Store,
        inputs: &M::Inputs,
    ) -> Result<Option<Group>, SimulationError> {
        let model = self.model();
        let is_left = |left: &M::Gates, i: usize| at(left.as_slice(), i) > R::ZERO;
        let all = 0..contacts(model);
        let mut group = Group::none();
        let few = all.clone().filter(|i| is_left(left, *i)).count() <= RIGID_TOUCHING;
        for i in all.clone().filter(|i| is_left(left, *i)).take(if few { RIGID_TOUCHING } else { 1 }) {
            group.take(i);
        }
        for i in group.each() {
            put(left.as_mut_slice(), *i, R::ZERO);
        }
        let (drifts, mut next) = (self.rates_at(&model.zero_v()), 0);
        // Who is moved by one of them belongs to them, and who is moved by these.
        loop {
            let Some(gap) = group.each().nth(next).copied().filter(|_| !few) else { break };
            next += 1;
            for gate in all.clone().filter(|gate| *gate == gap || pressed_by(model, *gate) == Some(gap)) {
                let mut way = model.zero_v();
                self.way(gate, store, inputs, &mut way);
                let moved = self.rates_at(&way);
                let moves = |i: usize| at(moved.as_slice(), i) != at(drifts.as_slice(), i);
                for other in all.clone().filter(|i| moves(*i)) {
                    let other = pressed_by(model, other).unwrap_or(other);
                    if !is_left(left, other) {
                        continue;
                    }
                    if !group.take(other) {
                        let (contact, time) = (self.contact(other), self.time().to_f64());
                        return Err(SimulationError::Crowded { contact, time, most: RIGID_TOUCHING as u32 });
                    }
                    put(left.as_mut_slice(), other, R::ZERO);
                }
            }
        }
        Ok((group.count > 0).then_some(group))
    }

    /// W and G of contacts, and of what slides in them.
    fn touching(&self, members: &Group, store: &M::Store, inputs: &M::Inputs) -> Touching<R, M::V> {
        let model = self.model();
        let (mut which, mut count) = ([0; ROWS], members.count);
        for (place, i) in which.iter_mut().zip(members.each()) {
            *place = *i;
        }
        let (gaps, mut rubs) = (count, [None; RIGID_TOUCHING]);
        let [holding, sliding] = grips(model);
        for i in 0..contacts(model) {
            let Some(gap) = pressed_by(model, i) else { continue };
            let Some(pressed) = which.iter().take(gaps).position(|gate| *gate == gap) else { continue };
            let Some(rub) = rubs.iter_mut().find(|rub| rub.is_none()).filter(|_| is_first(model, i)) else {
                continue;
            };
            let row = count;
            for (place, i) in which.iter_mut().skip(row).zip(together(model, i)) {
                *place = i;
                count += 1;
            }
            let (holding, sliding) = (at(holding.as_slice(), i), at(sliding.as_slice(), i));
            *rub = Some(Rub { pressed, row, axes: count - row, holding, sliding, way: Way::Open });
        }
        let drifts = self.rates_at(&model.zero_v());
        let ways: [M::V; ROWS] = core::array::from_fn(|place| {
            let mut way = model.zero_v();
            if place < count {
                self.way(at_index(&which, place), store, inputs, &mut way);
            }
            way
        });
        let mut matrix = [[R::ZERO; ROWS]; ROWS];
        for (column, way) in ways.iter().enumerate().take(count) {
            let moved = self.rates_at(way);
            for (row, &j) in matrix.iter_mut().zip(&which).take(count) {
                put(row, column, at(moved.as_slice(), j) - at(drifts.as_slice(), j));
            }
        }
        Touching { which, ways, problem: Problem { matrix, gaps, rubs }.completed() }
    }

    /// The column of W of one contact.
    fn way(&self, contact: usize, store: &M::Store, inputs: &M::Inputs, way: &mut M::V) {
        let (model, time) = (self.model(), self.time());
        let force = along(model, time, &self.run.state, inputs, contact);
        model.solve(store, &force, &model.zero_lambda(), way, &mut model.zero_lambda());
    }

    /// The rates of all gaps with these velocities.
    pub(super) fn rates_at(&self, v: &M::V) -> M::Gates {
        strikes(self.model(), self.time(), &self.run.state.q, v).rates
    }

    /// How all that touches approaches, and which way it slides, but for what `holds`.
    fn approach(
        &self,
        touching: &mut Touching<R, M::V>,
        inputs: &M::Inputs,
        closed: impl Fn(usize) -> bool,
        holds: impl Fn(usize) -> bool,
    ) -> Approach<R> {
        let (model, time) = (self.model(), self.time());
        let state = self.dynamics.opened(&self.run.state);
        let bends = self.bends(touching, inputs, M::Gates::zeros(model.gate_names().len()));
        let Strikes { rates: own, shares, .. } = strikes(model, time, &state.q, &state.v);
        let mut rates = [R::ZERO; ROWS];
        for (place, i) in touching.each() {
            put(&mut rates, place, at(own.as_slice(), i));
        }
        let still = still(state.v.as_slice());
        let slow = R::from_f64(SLOW) * still;
        for rub in touching.problem.rubs.iter_mut().flatten() {
            let speed = rub.size(&rates);
            let slides = !holds(at_index(&touching.which, rub.row)) && R::any(speed.greater(slow));
            rub.way = if slides { Way::Along(rub.own(&rates).map(|rate| rate / speed)) } else { Way::Open };
        }
        // What lies on something falls on another by what both do together.
        let resting = touching.gaps().filter(|(_, i)| closed(*i)).fold(0, |set, (place, _)| set | 1 << place);
        let likely = self.as_before(touching);
        let held = match resting {
            0 => None,
            resting => touching.problem.complementary(&bends, &[R::ZERO; ROWS], resting, likely),
        };
        let rounding = R::from_f64(4.0) * R::EPSILON * state.q.max_abs();
        let half = R::from_f64(0.5 * FLIGHT) * self.run.step.unwrap_or(R::ONE);
        let (mut falls, mut slowest) = ([R::ZERO; ROWS], [still; ROWS]);
        for (place, i) in touching.gaps() {
            let pushed = match &held {
                Some(held) if !closed(i) => touching.problem.row(place, &held.forces),
                _ => R::ZERO,
            };
            let fall = (-(at(&bends, place) + pushed)).max(R::ZERO);
            put(&mut falls, place, fall);
            let share = at(shares.as_slice(), i);
            let bounces = R::ONE - share * share;
            if bounces > R::ZERO {
                // Or the one that gaps as they are rounded let it have over and over: between two of them it gains √(2 g̈ ε), and keeps that.
                let rest = (half * fall).max((R::from_f64(8.0) * fall * rounding / bounces).sqrt());
                put(&mut slowest, place, still.max(rest));
            }
        }
        Approach { rates, bends, falls, slowest }
    }

    fn take_gates(&mut self, before: &M::Gates, gates: M::Gates, held: Held<M::Gates>, blow: &mut Blow<R>) {
        let opened = |i: usize| (at(before.as_slice(), i) > R::ZERO) != (at(gates.as_slice(), i) > R::ZERO);
        let (model, ways) = (self.model(), [&self.dynamics.held.ways, &held.ways]);
        let turned = |i: usize| match alone(model, i) {
            true => at(ways[0].as_slice(), i) != at(ways[1].as_slice(), i),
            false => is_first(model, i) && stands(model, ways[0], i) != stands(model, ways[1], i),
        };
        let changed = (0..contacts(model)).filter(|i| match pressed_by(model, *i) {
            None => opened(*i),
            Some(_) => turned(*i),
        });
        blow.changed = changed.count() as u32;
        self.run.state.gates = with_memories(model, gates, before);
        self.dynamics.held = held;
        if blow.changed > 0 || blow.impacts > 0 {
            // What a method carries from step to step is of the motion before.
            self.memory = self.integrator.memory();
        }
    }

    fn no_impact(&self, touching: &Touching<R, M::V>) -> SimulationError {
        SimulationError::NoImpact { contact: self.contact(touching.at(0)), time: self.time().to_f64() }
    }
}

impl Group {
    fn none() -> Self {
        Group { which: [0; RIGID_TOUCHING], count: 0 }
    }

    fn each(&self) -> impl Iterator<Item = &usize> {
        self.which.iter().take(self.count)
    }

    /// Whether there was room for it.
    fn take(&mut self, contact: usize) -> bool {
        let Some(place) = self.which.get_mut(self.count) else { return false };
        *place = contact;
        self.count += 1;
        true
    }
}

impl<R: Real> Blow<R> {
    pub fn none() -> Self {
        Blow { changed: 0, events: 0, impacts: 0, rested: 0, lost: R::ZERO, gained: R::ZERO }
    }

    /// Takes up what happened after it.
    pub fn take(&mut self, after: &Self) {
        self.changed += after.changed;
        self.events += after.events;
        self.impacts += after.impacts;
        self.rested += after.rested;
        self.lost = self.lost + after.lost;
        self.gained = self.gained + after.gained;
    }
}

impl<R: Real, V> Touching<R, V> {
    /// Their rows, and which gates they are.
    pub fn each(&self) -> impl Iterator<Item = (usize, usize)> {
        self.which.iter().copied().enumerate().take(self.problem.count())
    }

    /// Those of gaps.
    pub fn gaps(&self) -> impl Iterator<Item = (usize, usize)> {
        self.each().take(self.problem.gaps)
    }

    pub fn at(&self, place: usize) -> usize {
        at_index(&self.which, place)
    }
}

fn at_index(which: &[usize; ROWS], place: usize) -> usize {
    which.get(place).copied().unwrap_or(0)
}
