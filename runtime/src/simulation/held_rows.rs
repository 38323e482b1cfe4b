//! Rigid contacts that are closed, and joints that stick, as rows beside those of constraints, for what changes the forces that they answer.
//!
//! ```text
//! F    the forces of a unit of each: Jᵀ of a gap, less what slides in it with it; Jᵀ of what holds or sticks
//! W = K⁻¹ [Jᵀ; 0],   G = Wᵀ F,   δλ = −G⁻¹ Wᵀ δQ          K = [M, Dᵀ; D, 0]
//! ```
//! δλ is the change of their forces that goes with a change δQ of the others, by what v̇ is with both; how J, K and γ change is left out, so that
//! iterations which use it end at the same place, and a little later.

use super::along_several::{alone, is_first};
use super::complementarity::{Few, ROWS, complete, solved};
use super::rigid::{Held, going, grips, pressed_by, stands};
use super::sticking::sticks;
use super::ties::Ties;
use crate::mechanism::{Assemble, Mechanism};
use crate::real::Real;
use crate::state::{State, StateOf};
use crate::trigger::contacts;
use crate::vector::{Vector, at, put};

pub(super) struct HeldRows<R, V> {
    pub count: usize,
    /// F and W, a column for each.
    pub forces: [V; ROWS],
    ways: [V; ROWS],
    matrix: [Few<R>; ROWS],
    gaps: usize,
    /// Those whose forces are found, as bits: what others hold has no motion of its own.
    firm: usize,
}

impl<R: Real, V: Vector<R>> HeldRows<R, V> {
    pub fn of<M>(model: &M, time: R, state: &StateOf<M, R>, inputs: &M::Inputs, held: &Held<M::Gates>) -> Self
    where
        M: Assemble<R> + Mechanism<R, V = V>,
    {
        let closed = |i: usize| R::any(at(state.gates.as_slice(), i).greater(R::ZERO));
        let all = || 0..contacts(model);
        let in_joints = model.sticks();
        let gaps = all().filter(|i| !in_joints && pressed_by(model, *i).is_none() && closed(*i));
        let holds = |i: &usize| match in_joints {
            true => sticks::<R, _>(held, *i),
            false => pressed_by(model, *i).is_some_and(closed) && stands(model, &held.ways, *i),
        };
        let (mut which, mut count) = ([0; ROWS], 0);
        for (place, i) in which.iter_mut().zip(gaps.chain(all().filter(holds))) {
            (*place, count) = (i, count + 1);
        }
        let rows = || which.iter().copied().enumerate().take(count);
        let gaps = rows().filter(|(_, i)| !in_joints && pressed_by(model, *i).is_none()).count();
        let mut store = model.store();
        model.factor(time, &state.q, R::ZERO, &mut store);
        let (goes, [_, sliding]) = (going(model, time, state, held), grips(model));
        let (mut forces, mut ways) =
            (core::array::from_fn(|_| model.zero_v()), core::array::from_fn(|_| model.zero_v()));
        for ((_, i), (force, way)) in rows().zip(forces.iter_mut().zip(&mut ways)) {
            *force = along(model, time, state, inputs, i);
            model.solve(&store, force, &model.zero_lambda(), way, &mut model.zero_lambda());
            for slides in all().filter(|slides| pressed_by(model, *slides) == Some(i)) {
                let share = -at(goes.as_slice(), slides) * at(sliding.as_slice(), slides);
                if R::any(share.equal(R::ZERO)) {
                    continue;
                }
                force.axpy(share, &along(model, time, state, inputs, slides));
            }
        }
        let mut matrix = [[R::ZERO; ROWS]; ROWS];
        for (row, way) in matrix.iter_mut().zip(&ways).take(count) {
            for (column, force) in forces.iter().enumerate().take(count) {
                put(row, column, product(way, |i| at(force.as_slice(), i)));
            }
        }
        let in_space = |i: usize| pressed_by(model, i).is_some() && is_first(model, i) && !alone(model, i);
        for (row, _) in rows().filter(|(_, i)| in_space(*i)) {
            complete(&mut matrix, row);
        }
        let all = (1 << count) - 1;
        let firm = if in_joints { Ties::of(&matrix, all).firm } else { all };
        HeldRows { count, forces, ways, matrix, gaps, firm }
    }

    /// δλ of a change of r = −Q, by its entries; nothing where it is not defined.
    pub fn forces_against(&self, change: impl Fn(usize) -> R) -> Few<R> {
        let mut right = [R::ZERO; ROWS];
        for (right, way) in right.iter_mut().zip(&self.ways).take(self.count) {
            *right = product(way, &change);
        }
        solved(&self.matrix, &right, self.gaps, self.count, self.firm).unwrap_or([R::ZERO; ROWS])
    }
}

fn product<R: Real, V: Vector<R>>(of: &V, with: impl Fn(usize) -> R) -> R {
    of.as_slice().iter().enumerate().fold(R::ZERO, |sum, (i, x)| x.mul_add(with(i), sum))
}

/// What a unit of one gate adds to Q, which is linear in it.
pub(super) fn along<R: Real, M: Mechanism<R>>(
    model: &M,
    time: R,
    state: &StateOf<M, R>,
    inputs: &M::Inputs,
    gate: usize,
) -> M::V {
    let mut gates = state.gates.clone();
    for i in 0..contacts(model) {
        put(gates.as_mut_slice(), i, R::ZERO);
    }
    let mut state = State { gates, v: model.zero_v(), ..state.clone() };
    let (mut none, mut some) = (model.zero_v(), model.zero_v());
    model.forces(time, &state, inputs, &mut none);
    let size = none.max_abs().max(R::ONE);
    put(state.gates.as_mut_slice(), gate, size);
    model.forces(time, &state, inputs, &mut some);
    some.axpy(-R::ONE, &none);
    some.scaled(R::ONE / size)
}
