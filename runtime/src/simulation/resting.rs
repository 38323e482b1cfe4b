//! What rests of the rigid contacts that are near: which push, hold or slide, and with which forces.

use super::Simulation;
use super::complementarity::{Few, Found, Problem, RIGID_TOUCHING, ROWS, Rub, Trial, Way};
use super::rigid::{PASSES, largest, near, settled_within, strikes};
use super::strike::Touching;
use crate::formulation::Formulation;
use crate::integrator::Method;
use crate::mechanism::Assemble;
use crate::real::Real;
use crate::state::State;
use crate::trigger::with_memories;
use crate::vector::{Vector, at, dot, put};

/// How far something may slide on that is taken to stand, as a part of what counts as no gap.
const FURTHER: f64 = 1e-6;

impl<'m, R, M, F, S, I> Simulation<'m, M, R, F, S, I>
where
    R: Real,
    M: Assemble<R>,
    F: Formulation<R, M>,
    I: Method<R>,
{
    /// What rests, by how gaps bend without forces. Where friction follows reactions they bend otherwise with forces than by the sum of these: what is
    /// beyond that is taken for more of what bends them, until nothing changes.
    pub(super) fn settled(
        &self,
        touching: &mut Touching<R, M::V>,
        inputs: &M::Inputs,
        rates: &Few<R>,
        mut bends: Few<R>,
        near: usize,
    ) -> Option<Settled<R>> {
        let model = self.model();
        let likely = self.as_before(touching);
        let problem = touching.problem.clone();
        let (mut found, mut stopped) = settled(&mut touching.problem, rates, &bends, near, likely)?;
        for _ in 0..if model.rubs() { PASSES } else { 0 } {
            let mut gates = M::Gates::zeros(model.gate_names().len());
            for (place, i) in touching.each() {
                put(gates.as_mut_slice(), i, at(&found.forces, place));
            }
            let bent = self.bends(touching, inputs, gates);
            let mut more = [R::ZERO; ROWS];
            for (place, _) in touching.each() {
                put(
                    &mut more,
                    place,
                    at(&bent, place) - problem.row(place, &found.forces) - at(&bends, place),
                );
            }
            // Written so that a NaN ends it.
            if !R::any(largest(&more).greater(settled_within::<R>() * largest(&bends))) {
                break;
            }
            bends.iter_mut().zip(more).for_each(|(bend, more)| *bend = *bend + more);
            touching.problem = problem.clone();
            (found, stopped) = settled(&mut touching.problem, rates, &bends, near, likely)?;
        }
        Some(Settled { found, stopped, bends })
    }

    /// The second derivatives of gaps, and the derivatives of what slides, with these forces.
    pub(super) fn bends(&self, touching: &Touching<R, M::V>, inputs: &M::Inputs, forces: M::Gates) -> Few<R> {
        let (model, time, state) = (self.model(), self.time(), &self.run.state);
        let state = State { gates: with_memories(model, forces, &state.gates), ..state.clone() };
        let (a, _, _) = self.dynamics.free(time, &state, inputs);
        let biases = strikes(model, time, &state.q, &state.v).biases;
        let (drifts, moved) = (self.rates_at(&model.zero_v()), self.rates_at(&a));
        let mut bends = [R::ZERO; ROWS];
        for (place, i) in touching.each() {
            let bend = at(moved.as_slice(), i) - at(drifts.as_slice(), i) + at(biases.as_slice(), i);
            put(&mut bends, place, bend);
        }
        bends
    }

    /// The same gaps that push, and the same that holds as before, where something slides along several directions: then there is much to try.
    pub(super) fn as_before(&self, touching: &Touching<R, M::V>) -> Option<Trial<R>> {
        let (gates, ways) = (self.run.state.gates.as_slice(), self.dynamics.held.ways.as_slice());
        let mut trial = Trial { set: 0, ways: [Way::Open; RIGID_TOUCHING], begins: 0 };
        if touching.problem.rubbing().all(|rub| rub.axes == 1) {
            return None;
        }
        for (place, i) in touching.gaps() {
            trial.set |= usize::from(at(gates, i) > R::ZERO) << place;
        }
        for (place, (rub, way)) in touching.problem.rubbing().zip(&mut trial.ways).enumerate() {
            let before = core::array::from_fn(|axis| match axis < rub.axes {
                true => at(ways, touching.at(rub.row + axis)),
                false => R::ZERO,
            });
            if trial.set >> rub.pressed & 1 == 0 {
                continue;
            }
            if rub.way != Way::Open {
                *way = rub.way;
            } else if dot(&before, &before) > R::ZERO {
                *way = Way::Along(before);
                trial.begins |= usize::from(rub.axes > 1) << place;
            }
        }
        (trial.set != 0).then_some(trial)
    }
}

/// What rests: its forces and ways, what comes to rest, and how gaps bend without them.
pub(super) struct Settled<R> {
    pub found: Found<R>,
    pub stopped: usize,
    pub bends: Few<R>,
}

/// The forces and ways of what rests, and of what slides with these rates; what comes to rest and is as good as there may go any way, and its
/// rows are marked.
fn settled<R: Real>(
    problem: &mut Problem<R>,
    rates: &Few<R>,
    bends: &Few<R>,
    near: usize,
    likely: Option<Trial<R>>,
) -> Option<(Found<R>, usize)> {
    let likely = likely.filter(|trial| trial.set & !near == 0);
    let found = problem.complementary(bends, &[R::ZERO; ROWS], near, likely)?;
    let mut stopped = 0_usize;
    for place in 0..RIGID_TOUCHING {
        let Some(Some(rub)) = problem.rubs.get(place).copied() else { continue };
        let slides = rub.axes > 1 && rub.way != Way::Open;
        let slows = dot(&rub.own(rates), &problem.rates(&rub, &found.forces, bends)) < R::ZERO;
        let speed = rub.size(rates);
        if slides && slows && R::any(speed.less_equal(stop(problem, &rub, &found.forces, bends))) {
            if let Some(Some(rub)) = problem.rubs.get_mut(place) {
                rub.way = Way::Open;
            }
            stopped = rub.rows().fold(stopped, |rows, row| rows | 1 << row);
        }
    }
    if stopped == 0 {
        return Some((found, 0));
    }
    problem.complementary(bends, &[R::ZERO; ROWS], near, None).map(|found| (found, stopped))
}

/// The speed √(a d) of what slides along several directions with which it gets no further than d before it stands, if friction stops it
/// with a: there is no way of its own in that, which methods could follow.
pub(super) fn stop<R: Real>(problem: &Problem<R>, rub: &Rub<R>, forces: &Few<R>, bends: &Few<R>) -> R {
    let bent = problem.rates(rub, forces, bends);
    (R::from_f64(FURTHER) * near::<R>() * dot(&bent, &bent).sqrt()).sqrt()
}
