//! Speeds that jump where events of a definition let them.
//!
//! ```text
//! v⁺ = v + K⁻¹ [Jᵀ P; 0],    J v⁺ + b = w          K = [M, Dᵀ; D, 0]; w what the speeds J v + b jump to
//! ```
//! That is how impulses P along them move a mechanism that has no other load at that time, with the impulses of its joints (Pfeiffer and
//! Glocker, *Multibody Dynamics with Unilateral Contacts*, 1996, 8): what is not held by them keeps its momentum. All that jump at one time
//! do so together. J are the derivatives of the speeds by the velocities, in which they are affine.

use super::Simulation;
use super::complementarity::{ROWS, solved};
use super::rigid::{Strikes, strikes};
use crate::error::SimulationError;
use crate::formulation::Formulation;
use crate::input::InputSource;
use crate::integrator::Method;
use crate::mechanism::Assemble;
use crate::real::Real;
use crate::state::State;
use crate::vector::{Vector, at, dot, put};

/// How much a speed gives way to an impulse along it, as a part of the least it would without joints: less is held.
const HELD: f64 = 1e-9;

impl<'m, R, M, F, S, I> Simulation<'m, M, R, F, S, I>
where
    R: Real,
    M: Assemble<R>,
    F: Formulation<R, M>,
    I: Method<R>,
{
    /// Lets the speeds of those events jump to `wanted` that occur and have one; whether there are such.
    pub(super) fn jump(&mut self, occurring: &M::Gates, wanted: &M::Gates) -> Result<bool, SimulationError>
    where
        S: InputSource<R, M>,
    {
        let (model, time) = (self.model(), self.time());
        let State { q, v, .. } = &self.run.state;
        let Strikes { rates, shares: jumps, .. } = strikes(model, time, q, v);
        let occurs = |i: &usize| {
            R::any(at(occurring.as_slice(), *i).greater(R::ZERO) & at(jumps.as_slice(), *i).greater(R::ZERO))
        };
        let (mut which, mut count) = ([0; ROWS], 0);
        for (place, i) in which.iter_mut().zip((0..model.gate_names().len()).filter(occurs)) {
            (*place, count) = (i, count + 1);
        }
        let which = which.iter().copied().take(count);
        let Some(first) = which.clone().next() else {
            return Ok(false);
        };
        let mut gradients: [M::V; ROWS] = core::array::from_fn(|_| model.zero_v());
        let drifts = strikes(model, time, q, &model.zero_v()).rates;
        for column in 0..model.velocity_count() {
            let mut alone = model.zero_v();
            put(alone.as_mut_slice(), column, R::ONE);
            let moved = strikes(model, time, q, &alone).rates.plus(-R::ONE, &drifts);
            for (gradient, i) in gradients.iter_mut().zip(which.clone()) {
                put(gradient.as_mut_slice(), column, at(moved.as_slice(), i));
            }
        }
        let mut store = model.store();
        model.factor(time, q, R::ZERO, &mut store);
        let (mut ways, mut matrix): ([M::V; ROWS], _) = (gradients.clone(), [[R::ZERO; ROWS]; ROWS]);
        let mut right = [R::ZERO; ROWS];
        for (column, ((way, gradient), i)) in ways.iter_mut().zip(&gradients).zip(which.clone()).enumerate() {
            model.solve(&store, gradient, &model.zero_lambda(), way, &mut model.zero_lambda());
            for (row, along) in matrix.iter_mut().zip(&gradients).take(count) {
                put(row, column, dot(along.as_slice(), way.as_slice()));
            }
            put(&mut right, column, at(rates.as_slice(), i) - at(wanted.as_slice(), i));
            let size = dot(gradient.as_slice(), gradient.as_slice());
            let free = size * size / self.twice_the_energy(gradient);
            let gives = matrix.get(column).map_or(R::ZERO, |row| at(row, column));
            // Written so that a NaN is held.
            if !R::any(gives.greater(R::from_f64(HELD).max(R::EPSILON) * free)) {
                return Err(self.no_jump(i));
            }
        }
        let Some(impulses) = solved(&matrix, &right, count, count, (1 << count) - 1) else {
            return Err(self.no_jump(first));
        };
        for (impulse, way) in impulses.into_iter().zip(&ways).take(count) {
            self.run.state.v.axpy(impulse, way);
        }
        if !S::HELD {
            self.dynamics.inputs = None;
        }
        Ok(true)
    }

    /// vᵀ M v, without what moves by itself.
    fn twice_the_energy(&self, v: &M::V) -> R {
        let (model, q) = (self.model(), &self.run.state.q);
        let of = |v: &M::V| model.kinetic_energy(self.time(), q, v);
        let rest = of(&model.zero_v());
        of(v) + of(&v.scaled(-R::ONE)) - rest - rest
    }

    #[cold]
    fn no_jump(&self, event: usize) -> SimulationError {
        SimulationError::NoJump { event: self.contact(event), time: self.time().to_f64() }
    }
}
