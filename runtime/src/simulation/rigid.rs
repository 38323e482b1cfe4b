//! Rigid contacts: impulses where they touch, forces where they rest, by one complementarity problem each.
//!
//! ```text
//! W = K⁻¹ [Jᵀ; 0],  G = J W        J the gradients of the gaps that touch, K = [M, Dᵀ; D, 0]
//! impulse   v⁺ = v⁻ + W P,    0 ≤ P ⟂ G P + (1 + e) ġ⁻ ≥ 0                                    (Newton)
//!           P = (1 + e) P_c + X,    0 ≤ P_c ⟂ G P_c + ġ⁻ ≥ 0,    0 ≤ X ⟂ G P + ġ⁻ ≥ 0        (Poisson)
//! rest      v̇ = v̇₀ + W λ,    0 ≤ λ ⟂ G λ + J v̇₀ + J̇ v ≥ 0
//! ```
//! v̇₀ is what the formulation finds without them. e is Newton's restitution, 0 where the flight after it would take less than [`FLIGHT`] of
//! the step: contacts that touch ever more often so come to rest. The force of one that rests is its gate; it opens where that would
//! pull. Both problems are solved by trying which contacts push (Pfeiffer and Glocker, Multibody Dynamics with Unilateral Contacts, 1996).
//! Where steps are parted is `held.rs`.

use super::complementarity::{Few, RIGID_TOUCHING, complementary_of, newton, poisson, solved};
use super::{MechanismDynamics, Simulation};
use crate::error::SimulationError;
use crate::formulation::Formulation;
use crate::input::InputSource;
use crate::integrator::Method;
use crate::mechanism::{Assemble, Mechanism};
use crate::real::Real;
use crate::state::{State, StateOf};
use crate::vector::{Vector, at, dot, put};

/// How often rigid contacts may touch or part in one step; more is [`Chatter`](SimulationError::Chatter). What comes to rest with restitution e
/// touches ln(10⁷)/ln(1/e) times in its last step: 73 times with 0.8, 1604 times with 0.99.
pub const IMPACTS_PER_STEP: u32 = 16384;

/// Gaps that are closed, m or rad; but at least a thousand roundings.
const NEAR: f64 = 1e-9;

/// Depths at which a step or a start is refused, m or rad; but at least the root of a rounding.
const INSIDE: f64 = 1e-6;

/// The shortest flight between two touches, as a part of the step; but at least what the rounding of a gap leaves of one.
const FLIGHT: f64 = 1e-7;

/// What impulses did.
#[derive(Clone, Copy)]
pub(super) struct Blow<R> {
    /// Contacts that opened or closed.
    pub changed: u32,
    pub impacts: u32,
    pub rested: u32,
    /// J.
    pub lost: R,
}

/// The contacts that touch, and how they depend on one another.
struct Touching<R, V> {
    which: [usize; RIGID_TOUCHING],
    count: usize,
    /// W, a column for each.
    ways: [V; RIGID_TOUCHING],
    /// G.
    matrix: [Few<R>; RIGID_TOUCHING],
}

pub(super) fn near<R: Real>() -> R {
    R::from_f64(NEAR).max(R::from_f64(1000.0) * R::EPSILON)
}

/// What of a speed is rounding.
pub(super) fn still<R: Real>(v: &[R]) -> R {
    let largest = v.iter().fold(R::ONE, |largest, v| largest.max(v.abs()));
    R::from_f64(64.0) * R::EPSILON * largest
}

/// The forces of the contacts that are closed at a state, and the acceleration with them; those of others are zero. `a` and `lambda` are what
/// `solve` finds without any force of them.
pub(super) fn press<R, M>(
    model: &M,
    time: R,
    state: &StateOf<M, R>,
    a: &mut M::V,
    lambda: &mut M::Lambda,
    mut solve: impl FnMut(&M::Gates, &mut M::V, &mut M::Lambda),
) -> M::Gates
where
    R: Real,
    M: Mechanism<R>,
{
    let zeros = || M::Gates::zeros(model.gate_names().len());
    let mut forces = zeros();
    let mut which = [0; RIGID_TOUCHING];
    let mut count = 0;
    for (i, gate) in state.gates.as_slice().iter().enumerate() {
        if R::any(gate.greater(R::ZERO)) && count < RIGID_TOUCHING {
            if let Some(place) = which.get_mut(count) {
                *place = i;
            }
            count += 1;
        }
    }
    if count == 0 {
        return forces;
    }
    let along = |x: &M::V| {
        let (mut rates, mut biases, mut shares) = (zeros(), zeros(), zeros());
        model.strikes(time, &state.q, x, &mut rates, &mut biases, &mut shares);
        rates
    };
    let (drifts, mut biases) = (along(&model.zero_v()), zeros());
    model.strikes(time, &state.q, &state.v, &mut zeros(), &mut biases, &mut zeros());
    let free = along(a);
    let mut ways: [(M::V, M::Lambda); RIGID_TOUCHING] =
        core::array::from_fn(|_| (model.zero_v(), model.zero_lambda()));
    let (mut matrix, mut right) = ([[R::ZERO; RIGID_TOUCHING]; RIGID_TOUCHING], [R::ZERO; RIGID_TOUCHING]);
    let closed = which.iter().take(count);
    for (column, (&i, (way, reaction))) in closed.clone().zip(&mut ways).enumerate() {
        // By a force of the size that it has.
        let size = at(state.gates.as_slice(), i);
        let mut one = zeros();
        put(one.as_mut_slice(), i, size);
        solve(&one, way, reaction);
        way.axpy(-R::ONE, a);
        reaction.axpy(-R::ONE, lambda);
        *way = way.scaled(R::ONE / size);
        *reaction = reaction.scaled(R::ONE / size);
        let moved = along(way);
        for (row, &j) in matrix.iter_mut().zip(closed.clone()) {
            put(row, column, at(moved.as_slice(), j) - at(drifts.as_slice(), j));
        }
        let value = at(free.as_slice(), i) - at(drifts.as_slice(), i) + at(biases.as_slice(), i);
        put(&mut right, column, value);
    }
    let all = (1 << count) - 1;
    let pressed = solved(&matrix, &right, count, all).unwrap_or([R::ZERO; RIGID_TOUCHING]);
    for ((&i, force), (way, reaction)) in closed.zip(pressed).zip(&ways) {
        put(forces.as_mut_slice(), i, force);
        a.axpy(force, way);
        lambda.axpy(force, reaction);
    }
    forces
}

impl<'m, M: Mechanism<R>, R: Real, F: Formulation<R, M>, S> MechanismDynamics<'m, M, R, F, S> {
    /// The same evaluation with the forces of the contacts that are closed.
    pub(super) fn pressed(
        &self,
        time: R,
        state: &StateOf<M, R>,
        inputs: &M::Inputs,
        a: &mut M::V,
        lambda: &mut M::Lambda,
    ) -> M::Gates {
        press(self.model, time, state, a, lambda, |gates, a, lambda| {
            (*a, *lambda, _) = self.free(time, &State { gates: gates.clone(), ..state.clone() }, inputs);
        })
    }

    /// The forces of the contacts that are closed at a state, zero of the others.
    pub(super) fn forces_at_rest(&self, time: R, state: &StateOf<M, R>, inputs: &M::Inputs) -> M::Gates {
        let (mut a, mut lambda, _) = self.free(time, &self.opened(state), inputs);
        self.pressed(time, state, inputs, &mut a, &mut lambda)
    }

    /// The state with all contacts open.
    pub(super) fn opened(&self, state: &StateOf<M, R>) -> StateOf<M, R> {
        State { gates: M::Gates::zeros(self.model.gate_names().len()), ..state.clone() }
    }
}

impl<'m, R, M, F, S, I> Simulation<'m, M, R, F, S, I>
where
    R: Real,
    M: Assemble<R>,
    F: Formulation<R, M>,
    I: Method<R>,
{
    /// For each contact: where it is open its gap and the rate of that, where it is closed its force and zero.
    pub(super) fn rigid_guards(&mut self) -> [M::Gates; 2]
    where
        S: InputSource<R, M>,
    {
        let (model, time, state) = (self.model(), self.time(), self.run.state.clone());
        let zeros = || M::Gates::zeros(model.gate_names().len());
        let (mut gaps, mut rates) = (zeros(), zeros());
        model.guards(time, &state, &mut gaps, &mut zeros());
        model.strikes(time, &state.q, &state.v, &mut rates, &mut zeros(), &mut zeros());
        if state.gates.as_slice().iter().any(|gate| R::any(gate.greater(R::ZERO))) {
            let inputs = self.dynamics.inputs_within(time, &state);
            let forces = self.dynamics.forces_at_rest(time, &state, &inputs);
            let closed = state.gates.as_slice().iter().zip(forces.as_slice());
            let both = gaps.as_mut_slice().iter_mut().zip(rates.as_mut_slice());
            for ((&gate, &force), (gap, rate)) in closed.zip(both) {
                if R::any(gate.greater(R::ZERO)) {
                    (*gap, *rate) = (force, R::ZERO);
                }
            }
        }
        [gaps, rates]
    }

    /// The first contact that has touched, or whose force pulls.
    pub(super) fn rigid_left(&self, [gaps, rates]: &[M::Gates; 2]) -> Option<usize> {
        let (still, near) = (still(self.run.state.v.as_slice()), near::<R>());
        let gates = self.run.state.gates.as_slice();
        let mut each = gates.iter().zip(gaps.as_slice().iter().zip(rates.as_slice()));
        each.position(|(&gate, (&gap, &rate))| {
            let closed = gate > R::ZERO;
            gap < R::ZERO && (closed || rate < -still || gap < -near)
        })
    }

    /// Impulses of what touches and closes, then the forces of what stays closed.
    pub(super) fn strike(&mut self) -> Result<Blow<R>, SimulationError>
    where
        S: InputSource<R, M>,
    {
        let mut blow = Blow { changed: 0, impacts: 0, rested: 0, lost: R::ZERO };
        let (model, time) = (self.model(), self.time());
        let zeros = || M::Gates::zeros(model.gate_names().len());
        let mut gaps = zeros();
        model.guards(time, &self.run.state, &mut gaps, &mut zeros());
        let before = self.run.state.gates.clone();
        let near = near::<R>();
        if !gaps.as_slice().iter().any(|gap| *gap <= near) {
            self.take_gates(&before, zeros(), &mut blow);
            return Ok(blow);
        }
        let inputs = self.dynamics.present_inputs(time, &self.run.state.clone());
        let touching = self.touching(&gaps, &inputs)?;
        let (mut rates, mut right, mut rests) = self.approach(&touching, &inputs);
        let closed = |i: usize| at(before.as_slice(), i) > R::ZERO;
        let resting = touching.each().filter(|(_, i)| closed(*i)).fold(0, |set, (place, _)| set | 1 << place);
        if let Some(back) = solved(&touching.matrix, &rates, touching.count, resting) {
            // What rests does not move on: what a method leaves of that is taken back, along the way of an impulse.
            for (along, way) in back.iter().zip(&touching.ways) {
                self.run.state.v.axpy(*along, way);
            }
            for (rate, row) in rates.iter_mut().zip(&touching.matrix) {
                *rate = *rate + dot(row, &back);
            }
        }
        let still = still(self.run.state.v.as_slice());
        let mut shares = zeros();
        let v = self.run.state.v.clone();
        model.strikes(time, &self.run.state.q, &v, &mut zeros(), &mut zeros(), &mut shares);
        let strikes = touching
            .each()
            .any(|(place, i)| at(&rates, place) < -still && at(gaps.as_slice(), i) <= R::ZERO && !closed(i));
        if strikes {
            let mut bounces = [R::ZERO; RIGID_TOUCHING];
            for (place, i) in touching.each() {
                // What rests has no speed to part with; by Poisson's law it has an impulse.
                let bounces_off = model.parts_by_impulses() || !closed(i);
                put(&mut bounces, place, if bounces_off { at(shares.as_slice(), i) } else { R::ZERO });
            }
            let law = if model.parts_by_impulses() { poisson } else { newton };
            let Some(impulses) = law(&touching.matrix, touching.count, &rates, &bounces, &rests) else {
                return Err(self.no_impact(&touching));
            };
            for ((place, _), way) in touching.each().zip(&touching.ways) {
                self.run.state.v.axpy(at(&impulses, place), way);
                blow.impacts += u32::from(at(&impulses, place) > R::ZERO && !closed(touching.at(place)));
            }
            let half = R::from_f64(0.5);
            for place in 0..touching.count {
                let change = touching.matrix.get(place).map_or(R::ZERO, |row| dot(row, &impulses));
                let twice = at(&rates, place) + at(&rates, place) + change;
                blow.lost = blow.lost - half * at(&impulses, place) * twice;
            }
            (rates, right, rests) = self.approach(&touching, &inputs);
        }
        let mut gates = zeros();
        // What flies no higher than from the slowest bounce.
        let two = R::from_f64(2.0);
        let still_near = touching.each().filter(|&(place, i)| {
            let (rate, rest) = (at(&rates, place), at(&rests, place));
            let above = if closed(i) { R::ZERO } else { at(gaps.as_slice(), i).max(R::ZERO) };
            rate * rate + two * (-at(&right, place)).max(R::ZERO) * above <= rest * rest
        });
        let near = still_near.fold(0, |set, (place, _)| set | 1 << place);
        let Some(forces) = complementary_of(&touching.matrix, &right, touching.count, near) else {
            return Err(self.no_impact(&touching));
        };
        let (mut held, mut pushed) = (0_usize, 0_usize);
        let (mut off, mut fast) = ([R::ZERO; RIGID_TOUCHING], [R::ZERO; RIGID_TOUCHING]);
        for (place, i) in touching.each() {
            let rests = at(&forces, place) > R::ZERO;
            let gap = at(gaps.as_slice(), i);
            put(gates.as_mut_slice(), i, at(&forces, place));
            held |= usize::from(rests) << place;
            pushed |= usize::from(rests || gap < R::ZERO) << place;
            blow.rested += u32::from(rests && !closed(i));
            put(&mut off, place, gap);
            put(&mut fast, place, at(&rates, place));
        }
        // What is rigid is never inside.
        if let Some(back) = solved(&touching.matrix, &fast, touching.count, held) {
            for (along, way) in back.iter().zip(&touching.ways) {
                self.run.state.v.axpy(*along, way);
            }
        }
        if let Some(back) = solved(&touching.matrix, &off, touching.count, pushed) {
            let mut moved = model.zero_v();
            for (along, way) in back.iter().zip(&touching.ways) {
                moved.axpy(*along, way);
            }
            let State { v, z, .. } = self.run.state.clone();
            self.run.state = self.run.state.moved(model.layout(), &moved, v, z);
        }
        self.take_gates(&before, gates, &mut blow);
        if blow.impacts > 0 && !S::HELD {
            self.dynamics.inputs = None;
        }
        Ok(blow)
    }

    /// The contacts whose gap is closed, and W and G of them.
    fn touching(&self, gaps: &M::Gates, inputs: &M::Inputs) -> Result<Touching<R, M::V>, SimulationError> {
        let (model, time, near) = (self.model(), self.time(), near::<R>());
        let (mut which, mut count) = ([0; RIGID_TOUCHING], 0);
        let inside = R::from_f64(INSIDE).max(R::EPSILON.sqrt());
        for (i, &gap) in gaps.as_slice().iter().enumerate() {
            if gap > near {
                continue;
            }
            if gap < -inside {
                let (contact, depth) = (self.contact(i), -gap.to_f64());
                return Err(SimulationError::Inside { contact, time: time.to_f64(), depth });
            }
            match which.get_mut(count) {
                Some(place) => *place = i,
                None => {
                    let (contact, most) = (self.contact(i), RIGID_TOUCHING as u32);
                    return Err(SimulationError::Crowded { contact, time: time.to_f64(), most });
                }
            }
            count += 1;
        }
        let state = self.dynamics.opened(&self.run.state);
        let mut store = model.store();
        model.factor(time, &state.q, R::ZERO, &mut store);
        let drifts = self.rates_at(&model.zero_v());
        let ways: [M::V; RIGID_TOUCHING] = core::array::from_fn(|place| {
            let mut way = model.zero_v();
            if place < count {
                self.way(at_index(&which, place), &store, inputs, &mut way);
            }
            way
        });
        let mut matrix = [[R::ZERO; RIGID_TOUCHING]; RIGID_TOUCHING];
        for (column, way) in ways.iter().enumerate().take(count) {
            let moved = self.rates_at(way);
            for (row, &j) in matrix.iter_mut().zip(&which).take(count) {
                put(row, column, at(moved.as_slice(), j) - at(drifts.as_slice(), j));
            }
        }
        Ok(Touching { which, count, ways, matrix })
    }

    /// The column of W of one contact.
    fn way(&self, contact: usize, store: &M::Store, inputs: &M::Inputs, way: &mut M::V) {
        let (model, time) = (self.model(), self.time());
        let mut state = self.dynamics.opened(&State { v: model.zero_v(), ..self.run.state.clone() });
        // Forces are linear in the gate.
        let (mut none, mut some) = (model.zero_v(), model.zero_v());
        model.forces(time, &state, inputs, &mut none);
        let size = none.max_abs().max(R::ONE);
        put(state.gates.as_mut_slice(), contact, size);
        model.forces(time, &state, inputs, &mut some);
        some.axpy(-R::ONE, &none);
        model.solve(store, &some.scaled(R::ONE / size), &model.zero_lambda(), way, &mut model.zero_lambda());
    }

    /// The rates of all gaps with these velocities.
    fn rates_at(&self, v: &M::V) -> M::Gates {
        let model = self.model();
        let zeros = || M::Gates::zeros(model.gate_names().len());
        let mut rates = zeros();
        model.strikes(self.time(), &self.run.state.q, v, &mut rates, &mut zeros(), &mut zeros());
        rates
    }

    /// Of all that touch: ġ, g̈ with all of them open, and the speed below which they do not bounce.
    fn approach(&self, touching: &Touching<R, M::V>, inputs: &M::Inputs) -> (Few<R>, Few<R>, Few<R>) {
        let (model, time) = (self.model(), self.time());
        let zeros = || M::Gates::zeros(model.gate_names().len());
        let state = self.dynamics.opened(&self.run.state);
        let (a, _, _) = self.dynamics.free(time, &state, inputs);
        let (mut rates, mut biases, mut shares) = (zeros(), zeros(), zeros());
        model.strikes(time, &state.q, &state.v, &mut rates, &mut biases, &mut shares);
        let (drifts, free) = (self.rates_at(&model.zero_v()), self.rates_at(&a));
        let still = still(state.v.as_slice());
        let rounding = R::from_f64(4.0) * R::EPSILON * state.q.max_abs();
        let half = R::from_f64(0.5 * FLIGHT) * self.run.step.unwrap_or(R::ONE);
        let mut all = ([R::ZERO; RIGID_TOUCHING], [R::ZERO; RIGID_TOUCHING], [R::ZERO; RIGID_TOUCHING]);
        for (place, i) in touching.each() {
            let bend = at(free.as_slice(), i) - at(drifts.as_slice(), i) + at(biases.as_slice(), i);
            put(&mut all.0, place, at(rates.as_slice(), i));
            put(&mut all.1, place, bend);
            let share = at(shares.as_slice(), i);
            let bounces = R::ONE - share * share;
            let rest = if bounces > R::ZERO {
                let fall = (-bend).max(R::ZERO);
                // Or the one that gaps as they are rounded let it have over and over: between two of them it gains √(2 g̈ ε), and keeps that.
                (half * fall).max((R::from_f64(8.0) * fall * rounding / bounces).sqrt())
            } else {
                R::ZERO
            };
            put(&mut all.2, place, still.max(rest));
        }
        all
    }

    fn take_gates(&mut self, before: &M::Gates, gates: M::Gates, blow: &mut Blow<R>) {
        let both = before.as_slice().iter().zip(gates.as_slice());
        blow.changed = both.filter(|(a, b)| (**a > R::ZERO) != (**b > R::ZERO)).count() as u32;
        self.run.state.gates = gates;
        if blow.changed > 0 || blow.impacts > 0 {
            // What a method carries from step to step is of the motion before.
            self.memory = self.integrator.memory();
        }
    }

    fn no_impact(&self, touching: &Touching<R, M::V>) -> SimulationError {
        SimulationError::NoImpact { contact: self.contact(touching.at(0)), time: self.time().to_f64() }
    }

    pub(super) fn contact(&self, index: usize) -> &'static str {
        self.model().gate_names().get(index).copied().unwrap_or(self.model().name())
    }
}

impl<R, V> Touching<R, V> {
    /// Their places here, and which contacts they are.
    fn each(&self) -> impl Iterator<Item = (usize, usize)> {
        self.which.iter().copied().enumerate().take(self.count)
    }

    fn at(&self, place: usize) -> usize {
        at_index(&self.which, place)
    }
}

fn at_index(which: &[usize; RIGID_TOUCHING], place: usize) -> usize {
    which.get(place).copied().unwrap_or(0)
}
