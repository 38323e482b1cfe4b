//! The mechanism as the integrator of a stepper sees it: the stages of one step, with the inputs held.

use crate::formulation::{Formulation, past_breakdown};
use crate::integrator::Dynamics;
use crate::mechanism::Mechanism;
use crate::real::Real;
use crate::state::{Derivative, DerivativeOf, StateOf};
use crate::vector::Vector;

/// Positions that are tried past a breakdown: to a hundred steps further, which slow passages take in single precision, where
/// constraints seem dependent within some milliradians.
const OVER: u32 = 7;

pub(super) struct Stages<'s, M: Mechanism<R>, R: Real, F: Formulation<R, M>> {
    pub model: &'s M,
    pub formulation: F,
    pub memory: &'s mut F::Memory,
    pub inputs: &'s M::Inputs,
    /// The size of the step, s.
    pub h: R,
    /// The smallest pivot so far.
    pub pivot: R,
    /// Stages that broke down and were stepped over.
    pub stepped_over: u32,
    /// Whether one broke down that could not be.
    pub broke_down: bool,
}

impl<M: Mechanism<R>, R: Real, F: Formulation<R, M> + Clone> Dynamics<R> for Stages<'_, M, R, F> {
    type Variables = M;

    #[inline(always)]
    fn variables(&self) -> &M {
        self.model
    }

    #[inline(always)]
    fn derivative(&mut self, time: R, state: &mut StateOf<M, R>) -> DerivativeOf<M, R> {
        let model = self.model;
        let (mut a, mut lambda) = (model.zero_v(), model.zero_lambda());
        let found =
            self.formulation.acceleration(self.memory, model, time, state, self.inputs, &mut a, &mut lambda);
        // Written so that a NaN is seen.
        if R::any(found.pivot.greater_equal(R::BREAKDOWN)) {
            self.pivot = found.pivot.min(self.pivot);
        } else {
            let (at, formulation) = ((time, self.h, OVER), self.formulation.clone());
            let is_past =
                step_over(formulation, self.memory, model, at, state, self.inputs, &mut a, &mut lambda);
            self.pivot = R::ZERO;
            self.stepped_over += u32::from(is_past);
            self.broke_down |= !is_past;
        }
        let mut z = M::Z::zeros(state.z.as_slice().len());
        model.internal_rates(time, state, self.inputs, &a, &lambda, &mut z);
        Derivative { v: state.v.clone(), a, z }
    }

    #[inline(always)]
    fn broke_down(&self) -> bool {
        self.broke_down
    }
}

/// Whether accelerations were found past a breakdown. It takes the stages apart, so that they need not stand in memory for it.
#[cold]
#[inline(never)]
#[allow(clippy::too_many_arguments)]
fn step_over<R: Real, M: Mechanism<R>, F: Formulation<R, M>>(
    formulation: F,
    memory: &mut F::Memory,
    model: &M,
    at: (R, R, u32),
    state: &StateOf<M, R>,
    inputs: &M::Inputs,
    a: &mut M::V,
    lambda: &mut M::Lambda,
) -> bool {
    past_breakdown(&formulation, memory, model, at, state, inputs, a, lambda).is_some()
}
