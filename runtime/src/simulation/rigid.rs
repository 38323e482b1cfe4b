//! Rigid contacts: impulses where they touch, forces where they rest, by one complementarity problem each.
//!
//! ```text
//! W = K⁻¹ [Jᵀ; 0],  G = J W        J the gradients of the gaps that touch, K = [M, Dᵀ; D, 0]
//! impulse   v⁺ = v⁻ + W P,    0 ≤ P ⟂ G P + (1 + e) ġ⁻ ≥ 0                                    (Newton)
//!           P = (1 + e) P_c + X,    0 ≤ P_c ⟂ G P_c + ġ⁻ ≥ 0,    0 ≤ X ⟂ G P + ġ⁻ ≥ 0        (Poisson)
//! rest      v̇ = v̇₀ + W λ,    0 ≤ λ ⟂ G λ + J v̇₀ + J̇ v ≥ 0
//! ```
//! v̇₀ is what the formulation finds without them. Where friction in joints follows reactions, v̇ is no linear function of λ: W is then a slope, and λ is
//! found by iteration; in impulses such friction has no share. e is Newton's restitution, 0 where the flight after it would be a sliver of
//! the step: contacts that touch ever more often so come to rest. The force of one that rests is its gate; it opens where that would
//! pull. Dry friction is another row of J, along what slides, in space three: it holds with up to μ_s λ, or slides one way with μ_k λ against
//! it, until it has no speed; which of both is held from touch to touch. The problems themselves are solved in `complementarity.rs`, impulses and what follows
//! them are `strike.rs` and `resting.rs`, where steps are parted is `held.rs`.

use super::along_several::{alone, along_rates, is_first, size, together};
use super::complementarity::{Few, ROWS, complete, solved};
use super::sticking::SLOWER;
use super::strike::SLOW;
use super::{MechanismDynamics, Simulation};
use crate::formulation::Formulation;
use crate::input::InputSource;
use crate::integrator::Method;
use crate::mechanism::{Assemble, Mechanism};
use crate::real::Real;
use crate::state::{State, StateOf, Variables};
use crate::trigger::{contacts, with_memories};
use crate::vector::{Vector, at, put};

/// Gaps that are closed, m or rad; but at least a thousand roundings.
const NEAR: f64 = 1e-9;

pub(super) fn near<R: Real>() -> R {
    R::from_f64(NEAR).max(R::from_f64(1000.0) * R::EPSILON)
}

/// The least force by which the effect of one is found, N or N m.
pub(super) const LEAST: f64 = 1e-6;

/// What a force that holds may be above what it can, as a part of that.
pub(super) fn sharp<R: Real>() -> R {
    R::from_f64(1e-12).max(R::from_f64(64.0) * R::EPSILON)
}

/// The most passes that forces take beside friction by reactions, and a last change of them as a part of them.
pub(super) const PASSES: u32 = 24;

pub(super) fn settled_within<R: Real>() -> R {
    R::from_f64(1e-13).max(R::from_f64(16.0) * R::EPSILON)
}

/// The largest in size.
pub(super) fn largest<R: Real>(of: &Few<R>) -> R {
    of.iter().fold(R::ZERO, |largest, x| largest.max(x.abs()))
}

/// What of a speed is rounding.
pub(super) fn still<R: Real>(v: &[R]) -> R {
    let largest = v.iter().fold(R::ONE, |largest, v| largest.max(v.abs()));
    R::from_f64(64.0) * R::EPSILON * largest
}

/// The gap that presses where a gate is the dry friction of a contact.
pub(super) fn pressed_by<R: Real, M: Mechanism<R>>(model: &M, gate: usize) -> Option<usize> {
    model.pressed_by().get(gate).copied().flatten()
}

/// μ_s and μ_k of each gate that is a dry friction.
pub(super) fn grips<R: Real, M: Mechanism<R>>(model: &M) -> [M::Gates; 2] {
    let zeros = || M::Gates::zeros(model.gate_names().len());
    let (mut holding, mut sliding) = (zeros(), zeros());
    model.grips(&mut holding, &mut sliding);
    [holding, sliding]
}

/// Whether what slides by this gate, and those that slide as one with it, holds where it is pressed.
pub(super) fn stands<R: Real, M: Mechanism<R>>(model: &M, ways: &M::Gates, gate: usize) -> bool {
    R::any(size(model, ways, gate).equal(R::ZERO))
}

/// Of each gate: how fast its gap opens or it slides with some velocities, the derivative of that without accelerations, and the restitution.
pub(super) struct Strikes<G> {
    pub rates: G,
    pub biases: G,
    pub shares: G,
}

pub(super) fn strikes<R: Real, M: Mechanism<R>>(model: &M, time: R, q: &M::Q, v: &M::V) -> Strikes<M::Gates> {
    let zeros = || M::Gates::zeros(model.gate_names().len());
    let (mut rates, mut biases, mut shares) = (zeros(), zeros(), zeros());
    model.strikes(time, q, v, &mut rates, &mut biases, &mut shares);
    Strikes { rates, biases, shares }
}

/// What is held of rigid contacts from one touch to the next, beside what is closed.
#[derive(Clone)]
pub(super) struct Held<G> {
    /// Which way what rubs slides: 1 or −1 with and against the rate that `strikes` gives, 0 where it holds.
    pub ways: G,
    /// Which contacts know of each other: those of one group, counted from 0. Of joints that slide 1 where others hold them, so that they rest.
    pub groups: G,
    /// 1 of what rubs in a joint and holds; where it has no way either, neither is known yet.
    pub stuck: G,
    /// How fast what slides along several directions did so when the piece of the step began, and in what time its way may change by as much.
    pub speeds: G,
    pub times: G,
}

impl<G> Held<G> {
    pub fn none<R: Real, M: Variables<R, Gates = G> + Mechanism<R>>(model: &M) -> Self
    where
        G: Vector<R>,
    {
        let zeros = || G::zeros(model.gate_names().len());
        Held { ways: zeros(), groups: zeros(), stuck: zeros(), speeds: zeros(), times: zeros() }
    }
}

/// Which way what slides goes; what does so along several directions as it moves at this state.
pub(super) fn going<R: Real, M: Mechanism<R>>(
    model: &M,
    time: R,
    state: &StateOf<M, R>,
    held: &Held<M::Gates>,
) -> M::Gates {
    let mut goes = held.ways.clone();
    if !model.slide_as_one().is_empty() {
        let rates = strikes(model, time, &state.q, &state.v).rates;
        along_rates(model, &rates, R::from_f64(SLOW) * still(state.v.as_slice()), &mut goes);
    }
    goes
}

/// The forces of the contacts that are closed at a state, and the acceleration with them; those of others are zero. What is closed and has no
/// way holds, what has one slides along it. `a` and `lambda` are what `solve` finds without any force of them.
pub(super) fn press<R, M>(
    model: &M,
    time: R,
    state: &StateOf<M, R>,
    held: &Held<M::Gates>,
    a: &mut M::V,
    lambda: &mut M::Lambda,
    mut solve: impl FnMut(&M::Gates, &mut M::V, &mut M::Lambda),
) -> M::Gates
where
    R: Real,
    M: Mechanism<R>,
{
    let zeros = || M::Gates::zeros(model.gate_names().len());
    let (all, mut forces) = (0..contacts(model), with_memories(model, zeros(), &state.gates));
    let closed = |i: usize| R::any(at(state.gates.as_slice(), i).greater(R::ZERO));
    let gaps = all.clone().filter(|i| pressed_by(model, *i).is_none() && closed(*i));
    if gaps.clone().next().is_none() {
        return forces;
    }
    let along = |x: &M::V| strikes(model, time, &state.q, x).rates;
    let (drifts, biases) = (along(&model.zero_v()), strikes(model, time, &state.q, &state.v).biases);
    let (free, open) = (along(a), (a.clone(), lambda.clone()));
    let [_, sliding] = grips(model);
    let holds = |i: usize| stands(model, &held.ways, i);
    let goes = going(model, time, state, held);
    let group_of = |i: usize| at(held.groups.as_slice(), i);
    let rubs = !model.pressed_by().is_empty();
    for first in gaps.clone() {
        let own = |i: &usize| R::any(group_of(*i).equal(group_of(first)));
        if gaps.clone().any(|i| i < first && own(&i)) {
            continue;
        }
        let rubbing = all
            .clone()
            .filter(|i| pressed_by(model, *i).is_some_and(|gap| closed(gap) && own(&gap)) && holds(*i));
        let (mut which, mut count) = ([0; ROWS], 0);
        for (place, i) in which.iter_mut().zip(gaps.clone().filter(own).chain(rubbing)) {
            (*place, count) = (i, count + 1);
        }
        let gaps = which.iter().take(count).filter(|i| pressed_by(model, **i).is_none()).count();
        let mut ways: [(M::V, M::Lambda, M::Gates); ROWS] =
            core::array::from_fn(|_| (model.zero_v(), model.zero_lambda(), zeros()));
        let (mut matrix, mut right) = ([[R::ZERO; ROWS]; ROWS], [R::ZERO; ROWS]);
        let rows = which.iter().take(count);
        for (column, (&i, (way, reaction, one))) in rows.clone().zip(&mut ways).enumerate() {
            // By a force of the size that it has, or that presses it; one that ends would be lost in rounding.
            let size = at(state.gates.as_slice(), pressed_by(model, i).unwrap_or(i)).max(R::from_f64(LEAST));
            put(one.as_mut_slice(), i, size);
            for slides in all.clone().filter(|slides| pressed_by(model, *slides) == Some(i)) {
                let share = -at(goes.as_slice(), slides) * at(sliding.as_slice(), slides);
                put(one.as_mut_slice(), slides, share * size);
            }
            solve(one, way, reaction);
            way.axpy(-R::ONE, &open.0);
            reaction.axpy(-R::ONE, &open.1);
            let by = R::ONE / size;
            (*way, *reaction, *one) = (way.scaled(by), reaction.scaled(by), one.scaled(by));
            let moved = along(way);
            for (row, &j) in matrix.iter_mut().zip(rows.clone()) {
                put(row, column, at(moved.as_slice(), j) - at(drifts.as_slice(), j));
            }
            let value = at(free.as_slice(), i) - at(drifts.as_slice(), i) + at(biases.as_slice(), i);
            put(&mut right, column, value);
        }
        let in_space = |i: usize| pressed_by(model, i).is_some() && is_first(model, i) && !alone(model, i);
        for (row, _) in rows.enumerate().filter(|(_, i)| in_space(**i)) {
            complete(&mut matrix, row);
        }
        // Where what rubs has no solution nothing is known, and the step says so; what only pushes does not where it cannot.
        let without = if rubs { R::from_f64(f64::NAN) } else { R::ZERO };
        let all = (1 << count) - 1;
        let mut pressed = solved(&matrix, &right, gaps, count, all).unwrap_or([without; ROWS]);
        if model.rubs() {
            // Friction by reactions makes the accelerations no linear function of the forces: by Newton's method, with the slopes that there are.
            let with = |pressed: &Few<R>, gates: &mut M::Gates| {
                pressed.iter().zip(&ways).take(count).for_each(|(force, (.., one))| gates.axpy(*force, one));
            };
            let (mut moved, mut answered) = open.clone();
            for pass in 0..=PASSES {
                let mut own = zeros();
                with(&pressed, &mut own);
                solve(&own, &mut moved, &mut answered);
                let rates = along(&moved);
                for (right, (_, &i)) in right.iter_mut().zip(which.iter().enumerate().take(count)) {
                    *right = at(rates.as_slice(), i) - at(drifts.as_slice(), i) + at(biases.as_slice(), i);
                }
                let Some(more) = solved(&matrix, &right, gaps, count, all).filter(|_| pass < PASSES) else {
                    break;
                };
                // Written so that a NaN ends it.
                if !R::any(largest(&more).greater(settled_within::<R>() * largest(&pressed))) {
                    break;
                }
                pressed.iter_mut().zip(more).for_each(|(force, more)| *force = *force + more);
            }
            with(&pressed, &mut forces);
            moved.axpy(-R::ONE, &open.0);
            answered.axpy(-R::ONE, &open.1);
            a.axpy(R::ONE, &moved);
            lambda.axpy(R::ONE, &answered);
            continue;
        }
        for (force, (way, reaction, one)) in pressed.into_iter().zip(&ways).take(count) {
            forces.axpy(force, one);
            a.axpy(force, way);
            lambda.axpy(force, reaction);
        }
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
        if !M::HOLDS {
            return state.gates.clone();
        }
        if self.model.sticks() {
            return self.rubbed(time, state, inputs, a, lambda);
        }
        press(self.model, time, state, &self.held, a, lambda, |gates, a, lambda| {
            let gates = with_memories(self.model, gates.clone(), &state.gates);
            (*a, *lambda, _) = self.free(time, &State { gates, ..state.clone() }, inputs);
        })
    }

    /// The forces of the contacts that are closed at a state, zero of the others; events and memories as they are.
    pub(super) fn forces_at_rest(&self, time: R, state: &StateOf<M, R>, inputs: &M::Inputs) -> M::Gates {
        let (mut a, mut lambda, _) = self.free(time, &self.opened(state), inputs);
        self.pressed(time, state, inputs, &mut a, &mut lambda)
    }

    /// The state with all contacts open.
    pub(super) fn opened(&self, state: &StateOf<M, R>) -> StateOf<M, R> {
        let none = M::Gates::zeros(self.model.gate_names().len());
        State { gates: with_memories(self.model, none, &state.gates), ..state.clone() }
    }
}

impl<'m, R, M, F, S, I> Simulation<'m, M, R, F, S, I>
where
    R: Real,
    M: Assemble<R>,
    F: Formulation<R, M>,
    I: Method<R>,
{
    /// For each contact: where it is open its gap and the rate of that, where it is closed its force and zero. For the dry friction of one that
    /// is closed, and zero: where it holds how much more it could, where it slides how fast it does. Of events what passes their level.
    pub(super) fn rigid_guards(&mut self) -> [M::Gates; 2]
    where
        S: InputSource<R, M>,
    {
        let (model, time, state) = (self.model(), self.time(), self.run.state.clone());
        let zeros = || M::Gates::zeros(model.gate_names().len());
        let (mut gaps, mut forces) = (zeros(), zeros());
        model.guards(time, &state, &mut gaps, &mut forces);
        if model.sticks() {
            let [guards, rates] = self.sticking_guards();
            return [with_memories(model, guards, &gaps), with_memories(model, rates, &forces)];
        }
        let rates = strikes(model, time, &state.q, &state.v).rates;
        let mut rates = with_memories(model, rates, &forces);
        let closed = |i: usize| at(state.gates.as_slice(), i) > R::ZERO;
        let gates = 0..contacts(model);
        let force_of = |i: usize| pressed_by(model, i).is_none() && closed(i);
        if gates.clone().any(force_of) {
            let inputs = self.dynamics.inputs_within(time, &state);
            let forces = self.dynamics.forces_at_rest(time, &state, &inputs);
            let [holding, _] = grips(model);
            let Held { ways, speeds, .. } = &self.dynamics.held;
            let sliding = rates.clone();
            let along = |i: usize| at(ways.as_slice(), i) * at(sliding.as_slice(), i);
            for i in gates.clone() {
                let guard = match pressed_by(model, i) {
                    None if closed(i) => at(forces.as_slice(), i),
                    // Those that slide as one are watched as one.
                    Some(gap) if closed(gap) && !is_first(model, i) => R::ONE,
                    Some(gap) if closed(gap) && stands(model, ways, i) => {
                        let most = at(holding.as_slice(), i) * at(forces.as_slice(), gap);
                        // What holds as much as it can holds still.
                        (R::ONE + sharp()) * most - size(model, &forces, i)
                    }
                    Some(gap) if closed(gap) => {
                        let slower = R::from_f64(SLOWER) * at(speeds.as_slice(), i);
                        together(model, i).fold(-slower, |sum, j| sum + along(j))
                    }
                    _ => continue,
                };
                put(gaps.as_mut_slice(), i, guard);
                put(rates.as_mut_slice(), i, R::ZERO);
            }
        }
        for i in gates.filter(|i| pressed_by(model, *i).is_some_and(|gap| !closed(gap))) {
            put(gaps.as_mut_slice(), i, R::ZERO);
        }
        [gaps, rates]
    }

    /// Of each gate whether what is watched of it goes on a line and not on a parabola: what closed contacts exert, hold and slide by.
    pub(super) fn straight(&self) -> M::Gates {
        let model = self.model();
        let mut straight = self.run.state.gates.clone();
        for i in (0..contacts(model)).filter(|i| model.sticks() || pressed_by(model, *i).is_some()) {
            put(straight.as_mut_slice(), i, R::ONE);
        }
        straight
    }

    /// The first contact that has touched, or whose force pulls.
    pub(super) fn rigid_left(&self, [gaps, rates]: &[M::Gates; 2]) -> Option<usize> {
        let (still, near) = (still(self.run.state.v.as_slice()), near::<R>());
        let gates = self.run.state.gates.as_slice();
        let each = gates.iter().zip(gaps.as_slice().iter().zip(rates.as_slice())).enumerate();
        let mut each = each.take(contacts(self.model()));
        let found = each.find(|(i, (gate, (gap, rate)))| {
            let (closed, gap) = (**gate > R::ZERO, **gap);
            match pressed_by(self.model(), *i) {
                // What holds is near its most by the same part of nothing, N, as what slides is near its end, m/s.
                Some(_) => gap < -still,
                None if self.model().sticks() => gap < -still,
                None => gap < R::ZERO && (closed || **rate < -still || gap < -near),
            }
        });
        found.map(|(i, _)| i)
    }

    pub(super) fn contact(&self, index: usize) -> &'static str {
        self.model().gate_names().get(index).copied().unwrap_or(self.model().name())
    }
}
