//! Motions that the constraints admit: the whole from that of the coordinates of [`Tangent::states`].

use super::unit;
use crate::assembly::system::{System, rank_deficient};
use crate::error::LinearisationError;
use crate::real::Real;
use crate::tangent::Tangent;
use crate::vector::Vector;

/// The rows D and B at one position, factored: \[D; B\] is square up to rows that repeat others.
pub(super) struct Admissible<'m, R: Real, M: Tangent<R>> {
    system: System<'m, R, M>,
}

impl<'m, R: Real, M: Tangent<R>> Admissible<'m, R, M> {
    pub(super) fn at(model: &'m M, time: R, q: &M::Q) -> Result<Self, LinearisationError> {
        let needed =
            model.velocity_count() - (model.row_count() - model.idle().len()).min(model.velocity_count());
        if model.states().len() != needed {
            return Err(LinearisationError::Incomplete { needed, given: model.states().len() });
        }
        let mut system = System::new(model, model.states()).map_err(LinearisationError::Assembly)?;
        system.evaluate(time, q, None);
        let pivot = system.factor_unit();
        if !R::any(pivot.value.greater_equal(R::BREAKDOWN)) {
            return Err(LinearisationError::Assembly(rank_deficient(model, pivot)));
        }
        Ok(Admissible { system })
    }

    /// δ with D δ = `rows` and B δ = `states`, f numbers. The squares that the factorisation is made of cost half of the digits
    /// of the condition; a correction with D and B themselves restores them.
    pub(super) fn motion(&self, rows: &M::Lambda, states: &[R]) -> M::V {
        let model = self.system.model;
        let mut conditions = model.zero_conditions();
        for (&condition, &value) in model.states().iter().zip(states) {
            conditions.as_mut_slice()[condition as usize] = value;
        }
        let none = model.zero_v();
        let first = self.system.least(&none, rows, &conditions);
        let (rows, conditions) = self.system.remaining(rows, &conditions, &first);
        first.plus(R::ONE, &self.system.least(&none, &rows, &conditions))
    }

    /// The motion of the whole with that of coordinate `state` alone: D δ = 0, B δ = e.
    pub(super) fn basis(&self, state: usize) -> M::V {
        let model = self.system.model;
        let unit = unit(model.zero_conditions(), state);
        self.motion(&model.zero_lambda(), &unit.as_slice()[..model.states().len()])
    }
}
