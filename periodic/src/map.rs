//! The map of a period by itself, for sweeps and for those who look at its derivative.

use crate::coordinates::{difference, numbers, state};
use crate::cycle::Cycle;
use crate::error::PeriodicError;
use crate::flow::{Flow, Switching, flow};
use linkwright::{State, StateOf, Tangent};
use nalgebra::{DMatrix, DVector};

/// What a period makes of a state.
pub struct PeriodMap<M: Tangent<f64>> {
    /// The state after it, as the next cycle begins with it: what goes on has been taken back.
    pub state: StateOf<M>,
    /// x at the cycle's end; nothing has been taken back.
    pub x: DVector<f64>,
    /// ∂x(T)/∂x(0).
    pub derivative: DMatrix<f64>,
    /// Where the law switched.
    pub switchings: Vec<Switching>,
}

impl<M: Tangent<f64>> Cycle<'_, M> {
    /// What becomes of a state at the cycle's beginning in one period.
    ///
    /// # Errors
    /// Whatever the motion meets on its way.
    pub fn map(&self, value: f64, from: &StateOf<M>) -> Result<PeriodMap<M>, PeriodicError> {
        let model = self.model(value)?;
        let Flow { end, x, derivative, switchings, .. } = flow(self, &model, value, from, true)?;
        let state = self.taken_back(&model, from, end, &x)?;
        let derivative = derivative.expect("it was asked for");
        Ok(PeriodMap { state, x, derivative, switchings })
    }

    /// The state after so many periods, without derivatives.
    ///
    /// # Errors
    /// As [`map`](Cycle::map).
    pub fn after(&self, value: f64, from: &StateOf<M>, periods: usize) -> Result<StateOf<M>, PeriodicError> {
        let model = self.model(value)?;
        (0..periods).try_fold(from.clone(), |state, _| {
            let Flow { end, x, .. } = flow(self, &model, value, &state, false)?;
            self.taken_back(&model, &state, end, &x)
        })
    }

    /// A state at the end of a cycle as the next one begins with it: time is zero again, and what drivers hold is where it was.
    fn taken_back(
        &self,
        model: &M,
        begin: &StateOf<M>,
        end: StateOf<M>,
        x: &DVector<f64>,
    ) -> Result<StateOf<M>, PeriodicError> {
        if self.turns.is_empty() {
            return Ok(end);
        }
        let none = DVector::zeros(x.len());
        let back = State { z: end.z, ..begin.clone() };
        state(model, 0.0, &back, &difference(self, model, [x, &none], 1.0))
    }

    /// x of a state at the cycle's beginning: the coordinates of [`Tangent::states`], their rates, the internal states.
    ///
    /// # Errors
    /// The mechanism cannot have this value.
    pub fn numbers(&self, value: f64, of: &StateOf<M>) -> Result<DVector<f64>, PeriodicError> {
        Ok(numbers(&self.model(value)?, 0.0, of))
    }

    /// The state with these x, assembled as `near` is.
    ///
    /// # Errors
    /// [`Assembly`](PeriodicError::Assembly).
    pub fn state(
        &self,
        value: f64,
        near: &StateOf<M>,
        x: &DVector<f64>,
    ) -> Result<StateOf<M>, PeriodicError> {
        state(&self.model(value)?, 0.0, near, x)
    }
}
